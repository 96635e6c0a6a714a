// Facets selected by painting, held against brute force and against shapes whose answer is known.
#include "core/mesh/facet_paint.h"
#include "core/mesh/sample.h"
#include "core/mesh/triangle_distance.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

MeshPtr shared(Mesh mesh) {
    return std::make_shared<const Mesh>(std::move(mesh));
}

std::vector<Index> sorted(std::vector<Index> facets) {
    std::sort(facets.begin(), facets.end());
    return facets;
}

bool share_edge(const Facet& a, const Facet& b) {
    int common = 0;
    for (const Index v : a)
        common += std::find(b.begin(), b.end(), v) != b.end();
    return common >= 2;
}

/// Those of `facets` that hang together with `from` across edges, by looking at all pairs.
std::vector<Index> together(const Mesh& mesh, const std::vector<Index>& facets, Index from) {
    std::vector<Index> found{from}, left = facets;
    std::erase(left, from);
    for (std::size_t i = 0; i < found.size(); ++i)
        std::erase_if(left, [&](Index f) {
            const bool beside = share_edge(mesh.facets[found[i]], mesh.facets[f]);
            if (beside) found.push_back(f);
            return beside;
        });
    return sorted(found);
}

double distance_to(const Mesh& mesh, Index f, const Vec3& p) {
    return std::sqrt(squared_distance(p, mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)));
}

Vec3 middle(const Mesh& mesh, Index f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

std::vector<char> marked(const Mesh& mesh, const std::vector<Index>& facets) {
    std::vector<char> marks(mesh.facet_count(), 0);
    for (const Index f : facets)
        marks[f] = 1;
    return marks;
}

/// A level sheet, cells of 1 mm.
Mesh sheet(int nx, int ny) {
    return height_field([](double, double) { return 0.0; }, Vec2(0, 0), Vec2(nx, ny), nx, ny);
}

} // namespace

class TestFacetPaint : public QObject {
    Q_OBJECT
private slots:
    void a_brush_takes_what_its_ball_touches() {
        const MeshPtr mesh = shared(mixed());
        FacetPainter painter(mesh, {});
        std::mt19937 random(7);
        for (int n = 0; n < 60; ++n) {
            const auto f = Index(random() % mesh->facet_count());
            const double radius = 0.2 + double(random() % 100) / 12;
            const Vec3 at = middle(*mesh, f);
            std::vector<Index> touched;
            for (Index g = 0; g < mesh->facet_count(); ++g)
                if (distance_to(*mesh, g, at) <= radius) touched.push_back(g);
            const std::vector<Index> found = painter.brush(f, at, radius);
            QCOMPARE(found.front(), f);
            QCOMPARE(sorted(found), together(*mesh, touched, f));
        }
    }

    /// Of a plate of 1 mm a brush of 3 mm takes one side in the middle, and both at the rim.
    void the_other_side_of_a_thin_wall() {
        Mesh both = sheet(20, 20);
        const Mesh above = both;
        const auto first = Index(both.vertices.size());
        for (const Vec3& v : above.vertices)
            both.vertices.push_back(v - Vec3(0, 0, 1));
        for (const Facet& f : above.facets)
            both.facets.push_back({f[0] + first, f[2] + first, f[1] + first});
        // The rim: between the corners of the borders above and below.
        const auto rim = [&](Index a, Index b) {
            both.facets.push_back({a, a + first, b + first});
            both.facets.push_back({a, b + first, b});
        };
        for (Index i = 0; i < 20; ++i)
            rim(i, i + 1); // along y = 0
        const MeshPtr mesh = shared(both);
        FacetPainter painter(mesh, {});
        const std::size_t one_side = above.facets.size();
        const auto below = [&](const Vec3& at) {
            Index from = 0;
            for (Index f = 0; f < one_side; ++f)
                if (distance_to(*mesh, f, at) < distance_to(*mesh, from, at)) from = f;
            const auto found = painter.brush(from, at, 3);
            return std::count_if(found.begin(), found.end(),
                                 [&](Index f) { return f >= one_side && f < 2 * one_side; });
        };
        QCOMPARE(below(Vec3(10.3, 10.4, 0)), std::ptrdiff_t(0));
        QVERIFY(below(Vec3(10.3, 0.4, 0)) > 4);
    }

    /// Sides of a box, the level bottom of a dome, the whole of a cylinder's round.
    void a_flood_ends_at_sharp_edges() {
        const MeshPtr block = shared(HollowedBlock::mesh());
        FacetPainter of_block(block, {});
        for (Index f = 0; f < block->facet_count(); f += Index(block->facet_count() / 200)) {
            const auto flat = of_block.flood(f, radians(1e-3));
            for (const Index g : flat)
                QVERIFY((block->facet_normal(g) - block->facet_normal(f)).norm() < 1e-4);
        }
        const MeshPtr whole = shared(box(Vec3(0, 0, 0), Vec3(4, 5, 6)));
        FacetPainter of_box(whole, {});
        QCOMPARE(of_box.flood(0, radians(89)).size(), whole->facet_count() / 6);
        QCOMPARE(of_box.flood(0, radians(91)).size(), whole->facet_count());
        const MeshPtr cylinder = make_sample("cylinder", 0.05, Progress());
        std::size_t round = 0;
        Index one = 0;
        for (Index f = 0; f < cylinder->facet_count(); ++f)
            if (std::abs(cylinder->facet_normal(f).x()) < 0.5) {
                ++round;
                one = f;
            }
        FacetPainter of_cylinder(cylinder, {});
        QCOMPARE(of_cylinder.flood(one, radians(45)).size(), round);
    }

    /// A facet that is wound the other way is beside its neighbours all the same, one without area is
    /// crossed.
    void a_flood_over_bad_facets() {
        Mesh m = sheet(6, 2);
        std::swap(m.facets[7][0], m.facets[7][1]);
        const std::size_t all = m.facet_count();
        {
            const MeshPtr mesh = shared(m);
            QCOMPARE(FacetPainter(mesh, {}).flood(0, radians(5)).size(), all);
        }
        // Two cells joined by nothing but a facet without area.
        Mesh gap;
        gap.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0.5, 0}, {2, 0, 0}};
        gap.facets = {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}};
        const MeshPtr mesh = shared(gap);
        QCOMPARE(sorted(FacetPainter(mesh, {}).flood(0, radians(5))), (std::vector<Index>{0, 1, 2}));
        // The same, folded: what lies behind it has turned.
        gap.vertices[4] = {1, 0, 1};
        const MeshPtr folded = shared(gap);
        QCOMPARE(sorted(FacetPainter(folded, {}).flood(0, radians(5))), (std::vector<Index>{0, 1}));
    }

    /// Pages of a book on one edge: few are all beside each other; of many, every one is reached.
    void many_facets_on_one_edge() {
        for (const Index pages : {3u, 8u, 9u, 2000u}) {
            Mesh m;
            m.vertices = {{0, 0, 0}, {0, 0, 1}};
            for (Index i = 0; i < pages; ++i) {
                const double angle = 2 * pi * i / pages;
                m.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
                m.facets.push_back({0, 1, i + 2});
            }
            const MeshPtr mesh = shared(m);
            FacetPainter painter(mesh, {});
            QCOMPARE(painter.brush(pages / 2, Vec3(0, 0, 0.5), 0.1).size(), std::size_t(pages));
            const FacetNeighbours neighbours(*mesh, {});
            QVERIFY(neighbours.of(1).size() <= std::size_t(pages <= 8 ? pages - 1 : 2));
        }
    }

    /// One ring is what shares a corner; a distance is that along edges; growing and shrinking end where
    /// there is nothing more.
    void rings() {
        const Mesh mesh = sheet(30, 30);
        const auto middle_cell = [&](Index f) {
            const Vec3 at = middle(mesh, f);
            return at.x() > 14 && at.x() < 16 && at.y() > 14 && at.y() < 16;
        };
        std::vector<Index> seed;
        for (Index f = 0; f < mesh.facet_count(); ++f)
            if (middle_cell(f)) seed.push_back(f);
        QCOMPARE(seed.size(), std::size_t(8));
        std::vector<char> marks = marked(mesh, seed);
        const auto shares_corner = [&](Index f) {
            return std::any_of(seed.begin(), seed.end(), [&](Index s) {
                return std::any_of(mesh.facets[f].begin(), mesh.facets[f].end(), [&](Index v) {
                    return std::find(mesh.facets[s].begin(), mesh.facets[s].end(), v) != mesh.facets[s].end();
                });
            });
        };
        std::vector<Index> ring;
        for (Index f = 0; f < mesh.facet_count(); ++f)
            if (!marks[f] && shares_corner(f)) ring.push_back(f);
        QCOMPARE(ring_round(mesh, marks, true, 0, {}), ring);
        for (const Index f : ring)
            marks[f] = 1;
        // Shrinking takes exactly that ring off again.
        QCOMPARE(ring_round(mesh, marks, false, 0, {}), ring);
        marks = marked(mesh, seed);
        // To a corner 3 mm on there is a straight way along edges.
        const auto within = ring_round(mesh, marks, true, 3.01, {});
        QVERIFY(std::is_sorted(within.begin(), within.end()));
        for (const Index f : within) {
            const Vec3 at = middle(mesh, f);
            QVERIFY(at.x() > 10 && at.x() < 20 && at.y() > 10 && at.y() < 20);
        }
        QVERIFY(std::any_of(within.begin(), within.end(), [&](Index f) { return middle(mesh, f).x() > 19; }));
        QCOMPARE(ring_round(mesh, marks, true, 1000, {}).size(), mesh.facet_count() - seed.size());
        QVERIFY(ring_round(mesh, std::vector<char>(mesh.facet_count(), 0), true, 5, {}).empty());
        QVERIFY(ring_round(mesh, std::vector<char>(mesh.facet_count(), 1), false, 5, {}).empty());
    }
};

FACETMILL_TEST(TestFacetPaint)
#include "test_facet_paint.moc"
