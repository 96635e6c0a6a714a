// Boundaries on a part, and regions of the plane, against what facets, corners and rays say one by one.
#include "core/mesh/triangle_distance.h"
#include "core/strategy/surface/boundary_region.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::vector<PlanEdge> ring(const Vec2& middle, double radius, int corners, bool clockwise = false) {
    std::vector<PlanEdge> edges;
    const auto at = [&](int k) {
        const double angle = (clockwise ? -2 : 2) * pi * k / corners;
        return Vec2(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
    };
    for (int k = 0; k < corners; ++k)
        edges.push_back({at(k), at((k + 1) % corners)});
    return edges;
}

void add(std::vector<PlanEdge>& all, const std::vector<PlanEdge>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// Whether a place lies in a facet looked at along Z, and how far it is from its sides there.
double in_shadow(const Mesh& mesh, std::size_t f, const Vec2& p) {
    double least = infinity;
    const double up = mesh.facet_cross(f).z() > 0 ? 1 : -1;
    for (int k = 0; k < 3; ++k) {
        const Vec2 a = mesh.corner(f, k).head<2>(), e = mesh.corner(f, (k + 1) % 3).head<2>() - a;
        least = std::min(least, up * (e.x() * (p - a).y() - e.y() * (p - a).x()) / e.norm());
    }
    return least;
}

Boundary of_kind(Boundary::Kind kind) {
    Boundary b;
    b.name = "Here";
    b.kind = kind;
    return b;
}

MeshPtr waves() {
    return std::make_shared<Mesh>(
        height_field([](double x, double y) { return 2 * std::sin(0.4 * x) * std::cos(0.5 * y); },
                     Vec2(-10, -8), Vec2(10, 8), 20, 16));
}

} // namespace

class TestBoundaryRegion : public QObject {
    Q_OBJECT

private slots:
    void rings_have_their_depth() {
        const PlanRegion disc(ring({1, 2}, 3, 4000), {});
        for (const auto& [x, y, depth] : {std::array{1.0, 2.0, 3.0}, {3.0, 2.0, 1.0}, {1.0, 7.0, -2.0}})
            QVERIFY(std::abs(disc.depth({x, y}) - depth) < 1e-5);
        // A hole goes round the other way, and no number of rounds makes a border within.
        std::vector<PlanEdge> edges = ring({0, 0}, 5, 4000);
        add(edges, ring({0, 0}, 2, 4000, true));
        const PlanRegion holed(edges, {});
        QVERIFY(!holed.covers({0, 0}) && std::abs(holed.depth({0, 0}) + 2) < 1e-5);
        add(edges, ring({3.5, 0}, 4, 4000));
        const PlanRegion joined(edges, {});
        // Within both rings, 0.5 from the border of the hole that the other ring covers in part.
        QVERIFY(joined.covers({1.5, 0}) && joined.covers({6, 0}) && !joined.covers({-1, 0}));
        QVERIFY(std::abs(joined.depth({5, 0}) - 2.5) < 0.02);
        QVERIFY(PlanRegion().depth({0, 0}) == -infinity);
    }
    void rings_that_touch_have_no_border_between() {
        // Two squares with a common side, and one of them twice.
        const auto square = [](double x) {
            return std::vector<PlanEdge>{{Vec2(x, 0), Vec2(x + 2, 0)},
                                         {Vec2(x + 2, 0), Vec2(x + 2, 2)},
                                         {Vec2(x + 2, 2), Vec2(x, 2)},
                                         {Vec2(x, 2), Vec2(x, 0)}};
        };
        std::vector<PlanEdge> edges = square(0);
        add(edges, square(2));
        add(edges, square(2));
        const PlanRegion both(edges, {});
        QCOMPARE(both.depth({2, 1}), 1.0);
        QCOMPARE(both.depth({2, 0.5}), 0.5);
        QCOMPARE(both.depth({5, 1}), -1.0);
    }

    /// Random facets of a random part, some of them over others: covered is what any facet's shadow covers,
    /// and no place that is covered otherwise is nearer than the depth.
    void shadows_of_random_facets() {
        Random rng(3);
        for (int trial = 0; trial < 30; ++trial) {
            const Mesh mesh = *soup(40, 10, 30 + std::uint64_t(trial));
            std::vector<char> in(mesh.facet_count());
            for (char& f : in)
                f = whole(rng, 0, 2) > 0;
            const PlanRegion plan(outline_edges(mesh, in, {}), {});
            const auto covered = [&](const Vec2& p, double margin) {
                double most = -infinity;
                for (std::size_t f = 0; f < in.size(); ++f)
                    if (in[f] && mesh.facet_cross(f).z() != 0) most = std::max(most, in_shadow(mesh, f, p));
                return std::pair(most > margin, most < -margin);
            };
            for (int k = 0; k < 200; ++k) {
                const Vec2 p(uniform(rng, -2, 12), uniform(rng, -2, 12));
                const auto [inside, out] = covered(p, 1e-9);
                const double depth = plan.depth(p);
                if (inside) QVERIFY2(depth >= 0, qPrintable(QString("trial %1: %2").arg(trial).arg(depth)));
                if (out) QVERIFY2(depth <= 0, qPrintable(QString("trial %1: %2").arg(trial).arg(depth)));
                for (int a = 0; a < 16; ++a) {
                    const Vec2 way(std::cos(2 * pi * a / 16), std::sin(2 * pi * a / 16));
                    const auto [in_there, out_there] = covered(p + 0.99 * std::abs(depth) * way, 1e-9);
                    QVERIFY(depth > 0 ? !out_there : !in_there);
                }
            }
        }
    }

    void contacts_lie_in_the_nearest_facet() {
        const MeshPtr part = waves();
        Random rng(5);
        Boundary b = of_kind(Boundary::Kind::slope);
        b.slope = {0.2, 0.6};
        for (const bool invert : {false, true}) {
            b.invert = invert;
            const BoundaryRegion region(b, part, {});
            std::size_t within = 0;
            for (std::size_t f = 0; f < part->facet_count(); ++f) {
                const double slope = std::acos(part->facet_normal(f).z());
                QCOMPARE(bool(region.facets()[f]), (slope >= 0.2 && slope <= 0.6) != invert);
                within += region.facets()[f];
            }
            QCOMPARE(region.piece()->facet_count(), within);
            Index hint = no_index;
            for (int k = 0; k < 2000; ++k) {
                const Vec3 p(uniform(rng, -11, 11), uniform(rng, -9, 9), uniform(rng, -3, 3));
                double own = infinity, other = infinity;
                for (std::size_t f = 0; f < part->facet_count(); ++f) {
                    const double d =
                        squared_distance(p, part->corner(f, 0), part->corner(f, 1), part->corner(f, 2));
                    (region.facets()[f] ? own : other) = std::min(region.facets()[f] ? own : other, d);
                }
                if (k % 7 == 0) hint = Index(whole(rng, 0, int(part->facet_count()) - 1));
                if (std::abs(std::sqrt(own) - std::sqrt(other)) > 1e-6)
                    QCOMPARE(region.holds(p, hint), own < other);
            }
        }
    }
    void curves_and_outlines_are_looked_at_along_z() {
        const MeshPtr part = waves();
        Boundary b = of_kind(Boundary::Kind::curve);
        b.curve = {{{-4, -3, 0}}, {{4, -3, 9}}, {{4, 3, 0}}, {{-4, 3, -9}}};
        b.offset = 1;
        const BoundaryRegion region(b, part, {});
        QVERIFY(std::abs(region.depth({0, 0}) - 4) < 1e-12 && std::abs(region.depth({6, 0}) + 1) < 1e-12);
        Index hint = no_index;
        QVERIFY(region.holds({4.9, 0, 50}, hint) && !region.holds({5.1, 0, 0}, hint));
        // Facets are 1 wide: those within the wider rectangle, and none beyond it.
        for (std::size_t f = 0; f < part->facet_count(); ++f) {
            Box3 box;
            for (int k = 0; k < 3; ++k)
                box.add(part->corner(f, k));
            const bool meets = box.lo.x() < 4.9 && box.hi.x() > -4.9 && box.lo.y() < 3.9 && box.hi.y() > -3.9;
            const bool beyond =
                box.lo.x() > 5.1 || box.hi.x() < -5.1 || box.lo.y() > 4.1 || box.hi.y() < -4.1;
            QVERIFY(!(beyond && region.facets()[f]));
            if (meets && box.lo.x() >= -5 && box.hi.x() <= 5) QVERIFY(region.facets()[f]);
        }
        b.invert = true;
        QVERIFY(std::abs(BoundaryRegion(b, part, {}).depth({0, 0}) + 4) < 1e-12);

        Boundary outline = of_kind(Boundary::Kind::silhouette);
        outline.offset = -2;
        const BoundaryRegion drawn_in(outline, part, {});
        QVERIFY(std::abs(drawn_in.depth({0, 0}) - 6) < 1e-9 && std::abs(drawn_in.depth({9, 0}) + 1) < 1e-9);
        // A solid's outline is that of its shadow, whichever sides face up.
        const auto block = std::make_shared<Mesh>(box(Vec3(0, 0, 0), Vec3(10, 6, 4)));
        outline.offset = 0;
        QVERIFY(std::abs(BoundaryRegion(outline, block, {}).depth({5, 3}) - 3) < 1e-9);
    }

    void numbers_as_text() {
        QCOMPARE(facet_ranges_text({0, 1, 2, 5, 7, 8}), std::string("0-2, 5, 7-8"));
        QCOMPARE(facet_ranges_text({}), std::string());
        Random rng(8);
        for (int trial = 0; trial < 100; ++trial) {
            std::vector<Index> numbers;
            for (Index n = 0; n < 300; ++n)
                if (whole(rng, 0, 2) > 0) numbers.push_back(n);
            QVERIFY(facet_ranges(facet_ranges_text(numbers), 300) == numbers);
        }
        for (const char* wrong : {"a", "3-", "-3", "5-4", "3, 3", "3, 2", "3 4", "3,,4", "1.5", "0x3"})
            QCOMPARE(code_of([&] { facet_ranges(wrong, 10); }), std::string("syntax"));
        for (const char* beyond : {"10", "3-10", "99999999999", "18446744073709551616"})
            QVERIFY(code_of([&] { facet_ranges(beyond, 10); }) != "none");
        QCOMPARE(code_of([&] { facet_ranges("10", 10); }), std::string("out_of_range"));
    }

    void what_holds_nothing_is_refused() {
        const MeshPtr part = waves();
        std::string message;
        const auto code = [&](const Boundary& b) {
            return code_of([&] { BoundaryRegion(b, part, {}); }, &message);
        };
        Boundary b = of_kind(Boundary::Kind::facets);
        QCOMPARE(code(b), std::string("empty_result"));
        QVERIFY(message.find("boundary 'Here'") != std::string::npos);
        b.facets = "0-9";
        b.of_facets = 12;
        QCOMPARE(code(b), std::string("out_of_range"));
        b.of_facets = long(part->facet_count());
        QCOMPARE(code(b), std::string("none"));
        Boundary away = of_kind(Boundary::Kind::curve);
        away.curve = {{{100, 0, 0}}, {{101, 0, 0}}, {{100, 1, 0}}};
        QCOMPARE(code(away), std::string("empty_result"));
        Boundary drawn_in = of_kind(Boundary::Kind::silhouette);
        drawn_in.offset = -50;
        QCOMPARE(code(drawn_in), std::string("empty_result"));
    }
};

FACETMILL_TEST(TestBoundaryRegion)
#include "test_boundary_region.moc"
