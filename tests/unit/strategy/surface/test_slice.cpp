// Drive planes and slices of meshes: nothing missed, nothing doubled.
#include "core/strategy/surface/contact_domain.h"
#include "core/strategy/surface/slice.h"
#include "core/strategy/surface/travel_direction.h"
#include "tests/property/shapes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/unit/strategy/surface/slice_length.h"

#include <QTest>

#include <random>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::vector<SliceChain> sliced(const Mesh& mesh, double offset, double angle = 0) {
    const auto geometry = compute_geometry(mesh, Progress());
    return MeshSlicer(mesh, *geometry, DriveFrame(angle), Progress()).slice(offset);
}

double length_of(const std::vector<SliceChain>& chains) {
    double sum = 0;
    for (const SliceChain& c : chains) {
        for (std::size_t i = 0; i + 1 < c.points.size(); ++i)
            sum += (c.points[i + 1].point - c.points[i].point).norm();
        if (c.closed) sum += (c.points.front().point - c.points.back().point).norm();
    }
    return sum;
}

void verify_sound(const std::vector<SliceChain>& chains, double offset, const DriveFrame& frame) {
    for (const SliceChain& c : chains) {
        QVERIFY(c.points.size() >= 2);
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            QVERIFY(std::abs(frame.v(c.points[i].point) - offset) < 1e-9);
            QVERIFY(std::abs(c.points[i].normal.norm() - 1) < 1e-9);
            if (i > 0) QVERIFY(c.points[i].point != c.points[i - 1].point);
        }
        if (c.closed) QVERIFY(c.points.front().point != c.points.back().point);
    }
}

} // namespace

class TestSlice : public QObject {
    Q_OBJECT
private slots:
    /// Beside the edge of a blade, where its faces meet in a point, normals are those of the face that is
    /// cut.
    void normals_beside_a_sharp_edge_are_those_of_the_facets() {
        Mesh blade;
        for (const double y : {0.0, 20.0})
            for (const Vec2& p : {Vec2(0, 0), Vec2(10, -2), Vec2(0, -4)})
                blade.vertices.emplace_back(p.x(), y, p.y());
        blade.facets = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
        const Vec3 up = blade.facet_normal(0);
        QVERIFY(up.z() > 0.9);
        std::size_t asked = 0;
        for (const SliceChain& chain : sliced(blade, 11, radians(15)))
            for (const SlicePoint& p : chain.points) {
                if (p.point.z() < -2 + 1e-9) continue; // below, and the edge itself
                ++asked;
                QVERIFY2((p.normal - up).norm() < 1e-9, qPrintable(QString::number(p.normal.x())));
            }
        QVERIFY(asked >= 2);
    }

    void right_angles_are_exact() {
        for (int k = -4; k <= 4; ++k) {
            const DriveFrame f(k * 0.5 * pi);
            QVERIFY(std::abs(f.along.x()) + std::abs(f.along.y()) == 1);
            QCOMPARE(f.along.dot(f.across), 0.0);
            QCOMPARE(f.along.x() * f.across.y() - f.along.y() * f.across.x(), 1.0);
        }
        const DriveFrame f(0.7);
        const Vec3 p(3, -2, 5);
        QVERIFY((f.point(f.u(p), f.v(p), p.z()) - p).norm() < 1e-12);
    }

    void intervals_are_found_as_by_a_scan() {
        std::mt19937_64 rng(7);
        std::uniform_real_distribution<double> at(-50, 50), width(0, 1);
        std::vector<std::pair<double, double>> items;
        for (int i = 0; i < 3000; ++i) {
            const double lo = at(rng), w = i % 100 == 0 ? 60 : std::pow(width(rng), 4);
            items.emplace_back(lo, i % 50 == 7 ? lo - 1 : lo + w); // some are empty
        }
        const IntervalIndex index(
            items.size(), [&](std::size_t i) { return items[i]; }, Progress());
        for (int q = 0; q < 500; ++q) {
            const double lo = at(rng), hi = lo + (q % 2) * width(rng);
            std::multiset<std::size_t> found, expected;
            index.visit(lo, hi, [&](std::size_t i) { found.insert(i); });
            for (std::size_t i = 0; i < items.size(); ++i)
                if (items[i].first <= items[i].second && items[i].second >= lo && items[i].first <= hi)
                    expected.insert(i);
            for (const std::size_t i : expected)
                QVERIFY(found.count(i) == 1);
            // Beyond the expected only what rounding to float lets in.
            for (const std::size_t i : found) {
                QVERIFY(found.count(i) == 1);
                QVERIFY(items[i].second >= lo - 1e-4 && items[i].first <= hi + 1e-4);
            }
        }
        const IntervalIndex none(
            0, [](std::size_t) { return std::pair(0.0, 1.0); }, Progress());
        none.visit(-1, 1, [](std::size_t) { QFAIL("an empty index holds nothing"); });
    }

    void boxes_are_found_as_by_a_scan() {
        std::mt19937_64 rng(8);
        std::uniform_real_distribution<double> at(-50, 50), width(0, 1);
        std::vector<FlatBox> boxes(3000);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (i % 50 == 7) continue; // empty
            const double u = at(rng), v = at(rng);
            boxes[i].u.add(u, u + (i % 90 == 0 ? 60 : std::pow(width(rng), 4)));
            boxes[i].v.add(v, v + (i % 100 == 0 ? 60 : std::pow(width(rng), 4)));
        }
        const BoxRows rows(boxes, Progress());
        const auto meets = [](const FloatInterval& i, double lo, double hi) {
            return i.lo <= i.hi && double(i.hi) >= lo && double(i.lo) <= hi;
        };
        for (int q = 0; q < 500; ++q) {
            const double v0 = at(rng), v1 = v0 + (q % 2) * width(rng) * 20;
            const double u0 = q % 3 == 0 ? -infinity : at(rng),
                         u1 = q % 3 == 0 ? infinity : u0 + 5 * width(rng);
            std::multiset<std::size_t> found, expected;
            rows.visit(v0, v1, u0, u1, [&](std::size_t i, const FlatBox&) { found.insert(i); });
            for (std::size_t i = 0; i < boxes.size(); ++i)
                if (meets(boxes[i].u, u0, u1) && meets(boxes[i].v, v0, v1)) expected.insert(i);
            QVERIFY(found == expected);
        }
        BoxRows({}, Progress()).visit(-1, 1, -1, 1, [](std::size_t, const FlatBox&) {
            QFAIL("an empty index holds nothing");
        });
        QVERIFY(BoxRows(std::vector<FlatBox>(3), Progress()).empty());
    }

    void a_window_of_a_strip_is_a_part_of_it() {
        std::mt19937_64 rng(9);
        std::uniform_real_distribution<double> at(0, 60), width(0, 1);
        Mesh mesh = *field(
            30, 60, [](double x, double y) { return 3 * std::sin(0.4 * x) * std::cos(0.3 * y); }, 0.3);
        std::erase_if(mesh.facets, [&](const auto&) { return width(rng) < 0.4; }); // gaps
        const CutterProfile ball(AptCutter::ball(3, 30));
        const CutterCover cover(ball, 1e-3);
        const ContactDomain domain(mesh, DriveFrame(0.4), cover, 0.1, Progress());
        for (int q = 0; q < 300; ++q) {
            const double v0 = domain.lo() + (domain.hi() - domain.lo()) * width(rng), v1 = v0 + width(rng);
            const double merge = 0.3 * width(rng), lo = at(rng);
            const Interval within{lo, lo + 4 * width(rng)};
            const auto cut = [&](std::vector<Interval> all) {
                for (Interval& r : all)
                    r = {std::max(r.lo, within.lo), std::min(r.hi, within.hi)};
                std::erase_if(all, [](const Interval& r) { return !(r.lo <= r.hi); });
                return all;
            };
            const auto whole = cut(domain.strip(v0, v1, merge)),
                       part = cut(domain.strip(v0, v1, merge, &within));
            QCOMPARE(part.size(), whole.size());
            for (std::size_t i = 0; i < part.size(); ++i) {
                QCOMPARE(part[i].lo, whole[i].lo);
                QCOMPARE(part[i].hi, whole[i].hi);
            }
        }
    }

    void a_plane_through_vertices_gives_one_chain() {
        const Mesh m = height_field([](double, double) { return 2.0; }, Vec2(0, 0), Vec2(10, 10), 10, 10);
        for (const double v : {1.0, 5.0, 10.0, 3.3}) { // on rows of vertices, on the last row, between
            const auto chains = sliced(m, v);
            QCOMPARE(chains.size(), std::size_t(1));
            QVERIFY(!chains[0].closed);
            verify_sound(chains, v, DriveFrame(0));
            QVERIFY(std::abs(length_of(chains) - 10) < 1e-12);
            QVERIFY(chains[0].points.front().u < chains[0].points.back().u);
        }
        QVERIFY(sliced(m, -0.1).empty());
        QVERIFY(sliced(m, 10.1).empty());
    }

    void solids_give_closed_chains() {
        const Mesh b = box(Vec3(0, 0, 0), Vec3(10, 6, 4));
        for (const double v : {3.0, 6.0}) { // inside, and in the plane of a face: its outline, once
            const auto chains = sliced(b, v);
            QCOMPARE(chains.size(), std::size_t(1));
            QVERIFY(chains[0].closed);
            verify_sound(chains, v, DriveFrame(0));
            QVERIFY(std::abs(length_of(chains) - 28) < 1e-9);
        }
        const auto half = sliced(dome(10, 60), 0.0);
        QCOMPARE(half.size(), std::size_t(1));
        QVERIFY(half[0].closed);
        QVERIFY(std::abs(length_of(half) - (10 * pi + 20)) < 0.01);
    }

    void a_hole_splits_a_slice() {
        const Mesh m =
            only(height_field([](double, double) { return 0.0; }, Vec2(-10, -10), Vec2(10, 10), 20, 20),
                 [](const Vec3& p) { return p.norm() > 4; });
        const auto chains = sliced(m, 0.25);
        QCOMPARE(chains.size(), std::size_t(2));
        QVERIFY(chains[0].points.back().u < chains[1].points.front().u);
    }

    void odd_meshes_lose_and_double_nothing() {
        std::mt19937_64 rng(3);
        Mesh odd = height_field([](double x, double y) { return std::sin(x) + 0.3 * y; }, Vec2(-6, -6),
                                Vec2(6, 6), 24, 24);
        for (std::size_t f = 0; f < odd.facets.size(); f += 3)
            std::swap(odd.facets[f][0], odd.facets[f][1]); // windings at random
        // A third sheet on inner edges: non-manifold.
        const auto n = Index(odd.vertices.size());
        odd.vertices.emplace_back(0, 0, 9);
        for (Index k = 0; k < 10; ++k)
            odd.facets.push_back({300 + k, 301 + k, n});
        std::uniform_real_distribution<double> offset(-7, 7);
        for (int i = 0; i < 60; ++i) {
            const double angle = 0.3 * (i % 7), v = i % 3 == 0 ? std::round(offset(rng)) * 0.5 : offset(rng);
            const DriveFrame frame(angle);
            const auto chains = sliced(odd, v, angle);
            verify_sound(chains, v, frame);
            QVERIFY(std::abs(length_of(chains) - length_by_facet(odd, v, frame)) < 1e-8);
        }
    }

    void normals_run_along_edges() {
        const double radius = 20;
        const Mesh m = height_field([&](double x, double) { return std::sqrt(radius * radius - x * x); },
                                    Vec2(-15, -5), Vec2(15, 5), 120, 4);
        const auto chains = sliced(m, 0.6);
        QCOMPARE(chains.size(), std::size_t(1));
        double sum = 0;
        std::size_t count = 0;
        for (const SlicePoint& p : chains[0].points)
            if (std::abs(p.point.x()) < 14) {
                const Vec3 exact = Vec3(p.point.x(), 0, p.point.z()).normalized();
                QVERIFY(p.normal.dot(exact) > std::cos(0.01));
            }
        add_normal_change(chains[0], 0.05, sum, count);
        QVERIFY(count > 100);
        // Around a cylinder normals turn by 1/R per length.
        QVERIFY(std::abs(std::sqrt(sum / double(count)) * radius - 1) < 0.05);
    }

    void travel_follows_the_smaller_change_of_normals() {
        const auto direction = [](const Mesh& m, const NumberOrWord& asked) {
            return travel_direction(asked, context_of(m, ball_tool(6)), Progress());
        };
        const Vec2 lo(-20, -10), hi(20, 10);
        const Mesh along_y = height_field([](double x, double) { return std::sin(0.5 * x); }, lo, hi, 80, 10);
        const Mesh along_x = height_field([](double, double y) { return std::sin(0.5 * y); }, lo, hi, 20, 40);
        const Mesh level = height_field([](double, double) { return 0.0; }, lo, hi, 4, 4);
        QCOMPARE(direction(along_y, {0, "auto"}), 0.5 * pi);
        QCOMPARE(direction(along_x, {0, "auto"}), 0.0);
        QCOMPARE(direction(level, {0, "auto"}), 0.0); // alike: along the longer side
        QCOMPARE(direction(turned(level, 0.5 * pi), {0, "auto"}), 0.5 * pi);
        QCOMPARE(direction(along_x, {0, "y"}), 0.5 * pi);
        QCOMPARE(direction(along_x, {0.3, ""}), 0.3);
    }

    void the_domain_is_the_part_moved_by_the_contact() {
        const CutterProfile profile(AptCutter::ball(6, 50));
        const CutterCover cover(profile, 0.005);
        const double slope = 0.6;
        const Mesh m =
            height_field([&](double x, double) { return slope * x; }, Vec2(-10, -5), Vec2(10, 5), 4, 2);
        const ContactDomain domain(m, DriveFrame(0), cover, 0, Progress());
        const auto line = domain.line(0.3, 0);
        QCOMPARE(line.size(), std::size_t(1));
        // A ball of radius 3 touches the slope 3 sin(angle) uphill of its tip, that is towards +x.
        const double move = -3 * slope / std::hypot(1, slope);
        QVERIFY(std::abs(line[0].lo - (-10 + move)) < 1e-5 && std::abs(line[0].hi - (10 + move)) < 1e-5);
        QVERIFY(std::abs(domain.lo() + 5) < 1e-5 && std::abs(domain.hi() - 5) < 1e-5);
        QVERIFY(domain.line(5.1, 0).empty());
        QVERIFY(!domain.strip(4.9, 5.1, 0).empty());
        const double lowest = -10 * slope - 3 * (1 - 1 / std::hypot(1, slope));
        QVERIFY2(std::abs(domain.lowest_tip() - (-10 * slope + 3 / std::hypot(1, slope) - 3)) < 1e-9,
                 qPrintable(QString::number(lowest)));
    }

    /// Against all pairs of places that a facet asks for at its corners, over rough ground with a hole,
    /// turned any way.
    void strips_are_those_of_all_pairs_of_corners() {
        std::mt19937_64 rng(5);
        std::uniform_real_distribution<double> height(0, 1.5), at(-13, 13), width(0, 2), turn(0, pi);
        Mesh m = only(
            height_field([&](double, double) { return height(rng); }, Vec2(-10, -10), Vec2(10, 10), 14, 14),
            [](const Vec3& p) { return p.head<2>().norm() > 3; });
        const CutterCover cover(CutterProfile(AptCutter::bull(6, 1, 50)), 0.005);
        std::size_t met = 0;
        for (int k = 0; k < 60; ++k) {
            const DriveFrame frame(turn(rng));
            const double v0 = at(rng), v1 = k % 4 == 0 ? v0 : v0 + width(rng);
            std::vector<Interval> all;
            for (std::size_t f = 0; f < m.facet_count(); ++f) {
                std::vector<Vec2> corners;
                for (int i = 0; i < 3; ++i)
                    for (std::size_t g = 0; g < m.facet_count(); ++g)
                        if (std::ranges::count(m.facets[g], m.facets[f][std::size_t(i)]) > 0) {
                            const Vec3 p = m.corner(f, i) + cover.tip_offset(m.facet_normal(g));
                            corners.emplace_back(frame.u(p), frame.v(p));
                        }
                Interval r{infinity, -infinity};
                for (const Vec2& a : corners)
                    for (const Vec2& b : corners)
                        for (const double side : {v0, v1, a.y()}) {
                            if (side < v0 || side > v1 || (a.y() < side) == (b.y() < side)) continue;
                            const double u = a.x() + (b.x() - a.x()) * (side - a.y()) / (b.y() - a.y());
                            r = {std::min(r.lo, u), std::max(r.hi, u)};
                        }
                if (r.lo <= r.hi) all.push_back(r);
            }
            const std::vector<Interval> expected = joined(all, 0.1),
                                        found =
                                            ContactDomain(m, frame, cover, 0, Progress()).strip(v0, v1, 0.1);
            QCOMPARE(found.size(), expected.size());
            for (std::size_t i = 0; i < found.size(); ++i)
                QVERIFY2(std::abs(found[i].lo - expected[i].lo) < 1e-5
                             && std::abs(found[i].hi - expected[i].hi) < 1e-5,
                         qPrintable(QString("%1 to %2, not %3 to %4")
                                        .arg(found[i].lo)
                                        .arg(found[i].hi)
                                        .arg(expected[i].lo)
                                        .arg(expected[i].hi)));
            met += found.size();
        }
        QVERIFY(met > 60);
    }

    void walls_ask_for_nothing_and_ridges_are_closed() {
        const CutterCover cover(CutterProfile(AptCutter::ball(6, 50)), 0.005);
        const ContactDomain wall(step(0, 5), DriveFrame(0), cover, 0, Progress());
        QVERIFY(std::abs(wall.lo() + 15) < 1e-5 && std::abs(wall.hi() - 15) < 1e-5);
        // Over a ridge the moved sides part by 2 r sin 45; the edge closes the domain between them.
        const Mesh ridge =
            height_field([](double x, double) { return -std::abs(x); }, Vec2(-10, -5), Vec2(10, 5), 2, 1);
        const auto line = ContactDomain(ridge, DriveFrame(0), cover, 0, Progress()).line(0.1, 0);
        QCOMPARE(line.size(), std::size_t(1));
        QVERIFY(std::abs(line[0].length() - (20 + 6 * std::sqrt(0.5))) < 1e-5);
        const Mesh holed =
            only(height_field([](double, double) { return 0.0; }, Vec2(-10, -10), Vec2(10, 10), 20, 20),
                 [](const Vec3& p) { return p.norm() > 4; });
        const ContactDomain domain(holed, DriveFrame(0), cover, 0, Progress());
        QCOMPARE(domain.line(0.25, 0.1).size(), std::size_t(2));
        QCOMPARE(domain.line(0.25, 20).size(), std::size_t(1));
    }
};

FACETMILL_TEST(TestSlice)
#include "test_slice.moc"
