// Which side of a mesh is outside, on meshes whose answer is known and whose windings are not.
#include "core/mesh/outward.h"
#include "core/mesh/sample.h"
#include "core/mesh/sight.h"
#include "tests/support/part_meshes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

void turn(Mesh& mesh, std::size_t f) {
    std::swap(mesh.facets[f][1], mesh.facets[f][2]);
}

/// Both in one mesh, sharing nothing.
Mesh joined(const Mesh& a, const Mesh& b) {
    Mesh mesh = a;
    const auto first = Index(a.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Facet& f : b.facets)
        mesh.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
    return mesh;
}

Mesh wound_outward(const Mesh& mesh) {
    return *facetmill::wound_outward(std::make_shared<Mesh>(mesh), outward_sides(mesh, Progress()));
}

} // namespace

class TestOutward : public QObject {
    Q_OBJECT
private slots:
    /// Whether few rays are announced, for which facets stay as the file has them, or many.
    void rays_are_free_where_nothing_is_hit() {
        Random rng(1);
        const auto hills = field(
            30, 10, [](double x, double y) { return std::sin(x) * std::cos(y); }, 0.3);
        const auto scattered = soup(500, 10, 2);
        for (const Mesh& mesh : {*hills, *scattered, Mesh{}}) {
            const MeshSight sight(mesh, Progress());
            const OpenSight few(mesh, 1, Progress()), many(mesh, 100'000'000, Progress());
            std::size_t free = 0;
            for (int trial = 0; trial < 300; ++trial) {
                const Vec3 p(uniform(rng, 0, 10), uniform(rng, 0, 10), uniform(rng, -1, 3)),
                    d = Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)).normalized();
                const bool is_free = sight.first_hit(p, d) == infinity;
                QCOMPARE(sight.is_free(p, d), is_free);
                QCOMPARE(few.is_free(p, d), is_free);
                QCOMPARE(many.is_free(p, d), is_free);
                free += is_free;
            }
            QVERIFY(mesh.facets.empty() ? free == 300 : free > 20 && free < 280);
        }
    }

    void what_is_right_stays() {
        for (const Mesh& mesh : {dome(10, 12), box(Vec3(0, 0, 0), Vec3(4, 5, 6)), mixed()}) {
            const OutwardSides sides = outward_sides(mesh, Progress());
            QCOMPARE(sides.turned_facets, std::size_t(0));
            QCOMPARE(sides.buried_facets, std::size_t(0));
            const auto same = std::make_shared<Mesh>(mesh);
            QCOMPARE(facetmill::wound_outward(same, sides), MeshPtr(same));
        }
    }

    void a_body_inside_out() {
        const Mesh right = dome(10, 12);
        Mesh mesh = right;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f)
            turn(mesh, f);
        QCOMPARE(outward_sides(mesh, Progress()).turned_facets, mesh.facet_count());
        QVERIFY(wound_outward(mesh).facets == right.facets);
    }

    void facets_turned_at_random_data() {
        QTest::addColumn<double>("share");
        QTest::newRow("one of fifty") << 0.02;
        QTest::newRow("one of five") << 0.2;
        QTest::newRow("half") << 0.5;
    }
    /// Also where more facets are wrong than right: each patch sees the open from its outer side alone.
    void facets_turned_at_random() {
        QFETCH(double, share);
        const Mesh right = dome(10, 12);
        std::mt19937 random(7);
        std::bernoulli_distribution wrong(share);
        for (int round = 0; round < trials(20); ++round) {
            Mesh mesh = right;
            std::size_t turned_ones = 0;
            for (std::size_t f = 0; f < mesh.facet_count(); ++f)
                if (wrong(random)) {
                    turn(mesh, f);
                    ++turned_ones;
                }
            QCOMPARE(outward_sides(mesh, Progress()).turned_facets, turned_ones);
            QVERIFY(wound_outward(mesh).facets == right.facets);
        }
    }

    /// Facets that share no vertices, as in many an STL file after rounding.
    void loose_facets() {
        const Mesh right = dome(10, 12);
        std::mt19937 random(9);
        Mesh mesh;
        std::size_t turned_ones = 0;
        for (std::size_t f = 0; f < right.facet_count(); ++f) {
            for (int k = 0; k < 3; ++k)
                mesh.vertices.push_back(right.corner(f, k));
            const auto at = Index(3 * f);
            mesh.facets.push_back({at, at + 1, at + 2});
            if (random() % 2 == 0) {
                turn(mesh, f);
                ++turned_ones;
            }
        }
        QCOMPARE(outward_sides(mesh, Progress()).turned_facets, turned_ones);
    }

    void sheets_face_up() {
        Mesh sheet =
            height_field([](double x, double y) { return 0.1 * x * y; }, Vec2(-5, -5), Vec2(5, 5), 8, 8);
        QCOMPARE(outward_sides(sheet, Progress()).turned_facets, std::size_t(0));
        for (std::size_t f = 0; f < sheet.facet_count(); ++f)
            turn(sheet, f);
        QCOMPARE(outward_sides(sheet, Progress()).turned_facets, sheet.facet_count());
        QCOMPARE(outward_sides(sheet, Progress(), OpenSide::other).turned_facets, std::size_t(0));
        const Mesh solid = joined(dome(10, 12), box(Vec3(20, 0, 0), Vec3(22, 1, 1)));
        QCOMPARE(outward_sides(solid, Progress(), OpenSide::other).turned_facets, std::size_t(0));
    }

    /// Seen from below a sheet with a deep valley is convex, and has more of the open about it.
    void valleys_face_up() {
        const Mesh valley = height_field([](double x, double) { return -4 * std::max(0.0, 5 - std::abs(x)); },
                                         Vec2(-16, -10), Vec2(16, 10), 64, 4);
        QCOMPARE(outward_sides(valley, Progress()).turned_facets, std::size_t(0));
    }

    /// A pocket deeper than it is wide, open on top, as a sheet: its inside hardly sees the open.
    void deep_pockets_keep_their_winding() {
        Mesh pocket = box(Vec3(-15, -15, -80), Vec3(15, 15, 0));
        std::erase_if(pocket.facets, [&](const Facet& f) {
            return std::all_of(f.begin(), f.end(), [&](Index v) { return pocket.vertices[v].z() == 0; });
        });
        QCOMPARE(pocket.facet_count(), std::size_t(10));
        for (std::size_t f = 0; f < pocket.facet_count(); ++f)
            turn(pocket, f); // into the cavity
        QCOMPARE(outward_sides(pocket, Progress()).turned_facets, std::size_t(0));
    }

    /// The same facets twice, the second time the other way round: each finds the same outside.
    void doubled_facets() {
        const Mesh right = dome(10, 8);
        Mesh back = right;
        for (std::size_t f = 0; f < back.facet_count(); ++f)
            turn(back, f);
        Mesh mesh = right; // the same vertices
        mesh.facets.insert(mesh.facets.end(), back.facets.begin(), back.facets.end());
        const OutwardSides sides = outward_sides(mesh, Progress());
        const Mesh out = *facetmill::wound_outward(std::make_shared<Mesh>(mesh), sides);
        for (std::size_t f = 0; f < right.facet_count(); ++f) {
            const Vec3 n = right.facet_normal(f);
            QVERIFY(out.facet_normal(f).dot(n) > 0.99);
            QVERIFY(out.facet_normal(right.facet_count() + f).dot(n) > 0.99);
        }
    }

    void what_is_inside_is_buried() {
        const Mesh outer = dome(10, 12);
        const Mesh mesh = joined(outer, box(Vec3(-1, -1, 2), Vec3(1, 1, 4)));
        const OutwardSides sides = outward_sides(mesh, Progress());
        QCOMPARE(sides.buried_facets, std::size_t(12));
        QCOMPARE(sides.turned_facets, std::size_t(0));
        for (std::size_t f = 0; f < mesh.facet_count(); ++f)
            QCOMPARE(sides.sides[f] == OutwardSides::buried, f >= outer.facet_count());
    }

    void nothing() { QCOMPARE(outward_sides(Mesh(), Progress()).patches, std::size_t(0)); }
};

FACETMILL_TEST(TestOutward)
#include "test_outward.moc"
