// Rework regions and what they are found from: motion directions, offsets, boundary points with known places,
// regions of any shape that contain every uncut place.
#include "core/base/parallel.h"
#include "core/mesh/mesh_area.h"
#include "core/strategy/global_local/find_regions.h"
#include "core/strategy/global_local/tool_advice.h"
#include "tests/property/shapes.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Uncut = std::vector<UncutPlace>;

Mesh plain(double slope = 0.1) {
    return height_field([=](double x, double) { return slope * x; }, Vec2(-20, -15), Vec2(20, 15), 8, 6);
}

RegionInput input_of(const Mesh& mesh, double spacing, double offset) {
    RegionInput in;
    const auto part = std::make_shared<Mesh>(mesh);
    in.part = part;
    in.geometry = compute_geometry(*part, Progress());
    in.curvatures = std::make_shared<std::vector<VertexCurvature>>(
        vertex_curvatures(*part, in.geometry->vertex_normals, Progress()));
    in.spacing = spacing;
    in.offset = offset;
    return in;
}

/// Places of a plain that pass the test, `spacing` apart.
template <class Test>
Uncut places(double spacing, Test&& test, double slope = 0.1) {
    Uncut all;
    const Vec3 normal = Vec3(-slope, 0, 1).normalized();
    for (double y = -15 + 0.5 * spacing; y < 15; y += spacing)
        for (double x = -20; x <= 20; x += spacing)
            if (test(x, y)) all.push_back({Vec3(x, y, slope * x), normal, radians(20)});
    return all;
}

double distance(const Vec3& p, const std::array<Vec3, 3>& t) {
    const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    bool inside = true;
    double border = infinity;
    for (std::size_t k = 0; k < 3; ++k) {
        inside = inside && (t[(k + 1) % 3] - t[k]).cross(p - t[k]).dot(n) >= 0;
        border = std::min(border, distance_to_segment(p, t[k], t[(k + 1) % 3]));
    }
    return inside ? std::abs((p - t[0]).dot(n)) : border;
}

double distance(const Vec3& p, const ReworkRegions& regions) {
    double least = infinity;
    for (const ReworkRegion& r : regions.regions)
        for (const auto& facet : r.strip.band) {
            const double size = std::max((facet[1] - facet[0]).norm(), (facet[2] - facet[0]).norm());
            if ((p - facet[0]).norm() - size < least) least = std::min(least, distance(p, facet));
        }
    return least;
}

double loop_length(const std::vector<Vec3>& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    return sum;
}

/// Largest turn of a loop within `length` of it, where no corner of the part is near.
double sharpest(const std::vector<Vec3>& loop, double length) {
    double most = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto walk = [&](int step) {
            double route = 0;
            std::size_t at = i;
            Vec3 last = loop[i];
            while (route < length) {
                at = (at + loop.size() + std::size_t(step + long(loop.size()))) % loop.size();
                route += (loop[at] - last).norm();
                last = loop[at];
            }
            return last;
        };
        const Vec3 a = loop[i] - walk(-1), b = walk(1) - loop[i];
        most = std::max(most, std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)));
    }
    return most;
}

ReworkRegions found(const RegionInput& in, const Uncut& uncut) {
    return rework_regions(in, uncut, Progress());
}

PlanContext five_axis_context(const Mesh& mesh, const Tool& tool) {
    PlanContext c = context_of(mesh, tool);
    c.machine = find_machine("tarus-tpi-2000");
    return c;
}

} // namespace

class TestReworkRegion : public QObject {
    Q_OBJECT
private slots:
    /// (10) and (11) against the angle itself.
    void motion_is_forward_or_backward() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> in(-1, 1);
        const auto any = [&] { return Vec3(in(random), in(random), in(random)); };
        int forward = 0;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 v = any(), f = any(), m = any();
            const Vec3 a = v.cross(f), b = v.cross(m);
            const double angle = std::acos(a.dot(b) / (a.norm() * b.norm()));
            const bool is_forward = motion_direction(v, f, m) == MotionDirection::forward;
            QCOMPARE(is_forward, angle < 0.5 * pi);
            forward += is_forward;
        }
        QVERIFY(forward > 400 && forward < 600);
    }

    /// The part's own facets stay where no boundary passes: small ones everywhere would be
    /// a hundred thousand.
    void facets_are_small_at_boundaries_only() {
        const double spacing = 0.25, offset = 1;
        const Mesh mesh = plain();
        const ReworkRegions r =
            found(input_of(mesh, spacing, offset), places(spacing, [](double x, double) { return x < 0; }));
        QCOMPARE(r.regions.size(), std::size_t(1));
        QVERIFY(r.within.mesh->facets.size() + r.outside.mesh->facets.size() < 8000);
        // Nothing is lost, doubled or torn where large facets meet small ones.
        QCOMPARE(r.regions[0].strip.boundaries.size(), std::size_t(1));
        QCOMPARE(border_loops(*r.outside.mesh).size(), std::size_t(1));
        const double length = std::hypot(1, 0.1), edge = 0.5 * spacing;
        QVERIFY(std::abs(r.uncut_area + mesh_area(*r.outside.mesh) - r.part_area) < 1e-9 * r.part_area);
        QVERIFY(std::abs(r.part_area - 40 * 30 * length) < 1e-9 * r.part_area);
        // From the edge to the last places, and beyond them what closes gaps, and the offset.
        const double cut = r.uncut_area / 30 - (20 - spacing) * length, wider = (r.area - r.uncut_area) / 30;
        QVERIFY2(cut > 0.5 * spacing && cut < 1.5 * spacing, qPrintable(QString::number(cut)));
        QVERIFY2(std::abs(wider - offset) < edge, qPrintable(QString::number(wider)));
    }

    /// (12)-(14): the polyline's length up to P_b is the offset.
    void the_offset_runs_along_the_trajectory() {
        const std::vector<Vec3> route{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 0, 0), Vec3(3, 4, 0),
                                      Vec3(3, 4, 1)};
        QVERIFY((offset_along(route, 2) - Vec3(2, 0, 0)).norm() < 1e-12);
        QVERIFY((offset_along(route, 5) - Vec3(3, 2, 0)).norm() < 1e-12);
        QVERIFY((offset_along(route, 7.25) - Vec3(3, 4, 0.25)).norm() < 1e-12);
        QVERIFY((offset_along(route, 0) - route.front()).norm() < 1e-12);
        QVERIFY((offset_along(route, 9) - route.back()).norm() < 1e-12);
    }

    /// In a trough of radius 30 a flat end of diameter 6 that travels along it needs asin(3 / 30); Wang (4).
    /// A tool that may be lifted by e needs a little less: its rim, of fourth order too, leaves sqrt(2
    /// sin(lead) e / R^3).
    void the_lead_of_a_trough_is_known() {
        const double r = 30;
        const Mesh part = height_field([r](double x, double) { return -std::sqrt(r * r - x * x); },
                                       Vec2(-12, -8), Vec2(12, 8), 240, 2);
        GlobalLocalSettings s;
        s.tolerance = 0.0002;
        s.direction = {0, "y"};
        const auto source = region_source(five_axis_context(part, flat_tool(6)), s, Progress());
        std::size_t judged = 0;
        for (const AssumedContact& c : source->assumed.contacts) {
            QVERIFY(source->assumed.contacts[c.start].trajectory == c.trajectory);
            QVERIFY(source->assumed.contacts[c.end].trajectory == c.trajectory);
            if (std::abs(c.point.x()) > 7 || std::abs(c.point.y()) > 4) continue;
            ++judged;
            QVERIFY2(std::abs(degrees(c.lead) - 5.74) < 0.25, qPrintable(QString::number(degrees(c.lead))));
            // (9)
            QVERIFY(std::abs(std::acos(std::clamp(c.axis.dot(c.normal), -1.0, 1.0)) - c.lead) < 1e-6);
        }
        QVERIFY(judged > 300);
        // All of the trough is uncut at 5 degrees, nothing at 6.5.
        const Vec3 v(0, 0, 1), f(0, 1, 0);
        const auto at = [&](double limit) {
            return screen(source->assumed, radians(limit), 1, v, f, Progress());
        };
        QVERIFY(double(at(5).uncut.size()) > 0.9 * double(source->assumed.contacts.size()));
        for (const auto& u : at(6.5).uncut)
            QVERIFY(std::abs(u.point.y()) > 4);
    }

    /// A dent whose hollowness is known: what needs more than the limit is in the region, what needs clearly
    /// less is not.
    void the_region_of_a_dent_is_known() {
        const double depth = 6, sigma = 12, d = 3, limit = radians(2);
        const auto f = [=](double x, double y) {
            return -depth * std::exp(-(x * x + y * y) / (2 * sigma * sigma));
        };
        const Mesh part = height_field(f, Vec2(-30, -30), Vec2(30, 30), 200, 200);
        GlobalLocalSettings s;
        s.tolerance = 0.002;
        s.direction = {0, "x"};
        s.lead_limit = limit;
        s.rework_offset = 1.5;
        const auto source = region_source(five_axis_context(part, flat_tool(d)), s, Progress());
        const FoundRegions result = find_regions(*source, s, LengthUnit::mm, {}, Progress());
        QCOMPARE(result.regions.regions.size(), std::size_t(1));
        const ReworkRegion& region = result.regions.regions[0];
        QCOMPARE(region.strip.boundaries.size(), std::size_t(1));
        // Largest hollowness depth / sigma^2, which (4) turns into a lead. The tool may be lifted by half of
        // the tolerance, as in the trough, and the facets use some of that up.
        const double r = d / 2, hollowest = depth / sigma / sigma;
        const double matched = std::sin(region.lead_largest) / r;
        QVERIFY2(matched > 0.8 * hollowest && matched < 1.08 * hollowest,
                 qPrintable(QString::number(matched)));
        // Normal curvature of the graph, across the travel or in any direction.
        const auto hollowness_along = [&](double x, double y, double angle) {
            const double e = -f(x, y), q = sigma * sigma;
            const double fx = e * x / q, fy = e * y / q;
            const double fxx = e * (1 / q - x * x / q / q), fyy = e * (1 / q - y * y / q / q),
                         fxy = -e * x * y / q / q;
            const Vec3 normal = Vec3(-fx, -fy, 1).normalized(), along = Vec3(1, 0, fx).normalized();
            const Vec3 t = std::cos(angle) * along + std::sin(angle) * normal.cross(along);
            const double second = fxx * t.x() * t.x() + 2 * fxy * t.x() * t.y() + fyy * t.y() * t.y();
            return second / std::hypot(1, std::hypot(fx, fy));
        };
        const auto hollowness = [&](double x, double y) { return hollowness_along(x, y, 0.5 * pi); };
        // What a twisted place asks for lies between its two principal curvatures.
        const auto largest = [&](double x, double y) {
            double most = -infinity;
            for (int k = 0; k < 18; ++k)
                most = std::max(most, hollowness_along(x, y, k * pi / 18));
            return most;
        };
        const double least = std::sin(limit) / r;
        const double most = least + std::sqrt(std::sin(limit) * s.tolerance / (r * r * r));
        const double spacing = source->assumed.spacing;
        int in = 0, out = 0;
        std::vector<Vec3> uncut, possible;
        for (double x = -25; x <= 25; x += 2.5)
            for (double y = -25; y <= 25; y += 2.5) {
                if (largest(x, y) > 0.85 * least) possible.push_back({x, y, f(x, y)});
                if (hollowness(x, y) > 1.1 * most) uncut.push_back({x, y, f(x, y)});
            }
        for (const Vec3& p : uncut) {
            ++in;
            QVERIFY2(distance(p, result.regions) < 0.05, qPrintable(QString("%1 %2").arg(p.x()).arg(p.y())));
        }
        for (double x = -25; x <= 25; x += 2.5)
            for (double y = -25; y <= 25; y += 2.5) {
                if (largest(x, y) > 0.85 * least) continue;
                const Vec3 p(x, y, f(x, y));
                double away = infinity;
                for (const Vec3& u : possible)
                    away = std::min(away, (u - p).norm());
                if (away < s.rework_offset + 4 * spacing + 2) continue;
                ++out;
                QVERIFY2(distance(p, result.regions) > 0.1,
                         qPrintable(QString("%1 %2").arg(p.x()).arg(p.y())));
            }
        QVERIFY2(in > 10 && out > 25, qPrintable(QString("%1 %2").arg(in).arg(out)));
        // Boundary points: on the region's edge by its own count, pairs go with their trajectories.
        QVERIFY(result.pairs.size() > 20);
        std::size_t regular = 0, effective = 0;
        for (const BoundaryPair& pair : result.pairs) {
            QCOMPARE(pair.region, std::size_t(0));
            QVERIFY(!pair.in_at_side && !pair.out_at_side);
            regular += pair.regular;
            effective += pair.effective;
            if (pair.out.x() != pair.in.x())
                QCOMPARE(pair.motion == MotionDirection::forward, pair.out.x() > pair.in.x());
            if (regular % 16 != 0) continue; // brute force over all facets of the band
            for (const Vec3& p : {pair.in, pair.out, pair.in_offset, pair.out_offset})
                QVERIFY(distance(p, result.regions) < 0.05);
            QVERIFY(std::abs((pair.in_offset - pair.in).norm() - s.rework_offset) < 0.02);
        }
        QVERIFY(10 * regular >= 9 * result.pairs.size() && 2 * effective > result.pairs.size());
    }

    void regions_contain_every_uncut_place_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("regions");
        QTest::addColumn<int>("loops");
        QTest::newRow("one") << 0 << 1 << 1;
        QTest::newRow("ring") << 1 << 1 << 2;
        QTest::newRow("two") << 2 << 2 << 2;
        QTest::newRow("single place") << 3 << 1 << 1;
        QTest::newRow("ragged") << 4 << 1 << -1;
        QTest::newRow("at the side") << 5 << 1 << 1;
        QTest::newRow("several on a line") << 6 << 4 << 4;
        QTest::newRow("everywhere") << 7 << 1 << 1;
    }
    void regions_contain_every_uncut_place() {
        QFETCH(int, shape);
        QFETCH(int, regions);
        QFETCH(int, loops);
        std::mt19937 random(3);
        const auto test = [&](double x, double y) {
            const double r = std::hypot(x, y);
            switch (shape) {
            case 0:
                return r < 7;
            case 1:
                return r > 8 && r < 10;
            case 2:
                return std::hypot(std::abs(x) - 12, y) < 3;
            case 3:
                return std::abs(x) < 0.5 && std::abs(y - 0.5) < 0.2;
            case 4:
                return r < 9 + 2 * std::sin(9 * std::atan2(y, x)) && random() % 4 != 0;
            case 5:
                return x > 14 && std::abs(y) < 6;
            case 6:
                return std::abs(std::remainder(x + 5, 10)) < 1.1 && std::abs(y) < 2;
            default:
                return true;
            }
        };
        const Uncut uncut = places(1, test);
        QVERIFY(!uncut.empty());
        for (const double offset : {0.0, 1.0}) {
            const RegionInput in = input_of(plain(), 1, offset);
            const ReworkRegions result = found(in, uncut);
            QCOMPARE(int(result.regions.size()), regions);
            std::size_t count = 0, uncuts = 0;
            double area = 0;
            for (const ReworkRegion& r : result.regions) {
                count += r.strip.boundaries.size();
                uncuts += r.uncut;
                area += r.strip.area;
                QVERIFY(r.strip.enabled);
                for (const auto& loop : r.strip.boundaries) {
                    QVERIFY(loop.size() > 8);
                    for (const Vec3& p : loop) // on the surface
                        QVERIFY(std::abs(p.z() - 0.1 * p.x()) < 1e-9);
                }
            }
            if (loops >= 0) QCOMPARE(int(count), loops);
            QCOMPARE(uncuts, uncut.size());
            QVERIFY(std::abs(area - result.area) < 1e-9 * area);
            for (const auto& u : uncut)
                QVERIFY(distance(u.point, result) < 1e-9);
            // And none of it is left to the main path.
            double nearest = infinity;
            for (std::size_t f = 0; f < result.outside.mesh->facets.size(); ++f)
                for (const auto& u : uncut)
                    nearest = std::min(nearest, distance(u.point, {result.outside.mesh->corner(f, 0),
                                                                   result.outside.mesh->corner(f, 1),
                                                                   result.outside.mesh->corner(f, 2)}));
            QVERIFY2(nearest > 0.02, qPrintable(QString::number(nearest)));
            QCOMPARE(result.outside.geometry->vertex_normals.size(), result.outside.mesh->vertices.size());
            QCOMPARE(result.outside.curvatures->size(), result.outside.mesh->vertices.size());
        }
    }

    void boundaries_are_smooth() {
        const ReworkRegions ring = found(input_of(plain(0), 1, 2), places(
                                                                       1,
                                                                       [](double x, double y) {
                                                                           const double r = std::hypot(x, y);
                                                                           return r > 8 && r < 10;
                                                                       },
                                                                       0));
        QCOMPARE(ring.regions.size(), std::size_t(1));
        const auto& loops = ring.regions[0].strip.boundaries;
        QCOMPARE(loops.size(), std::size_t(2));
        for (const auto& loop : loops) {
            // As round as a circle, whose turn over 1.5 mm to either side is 1.5 / r.
            double least = infinity, most = 0;
            for (const Vec3& p : loop) {
                least = std::min(least, p.norm());
                most = std::max(most, p.norm());
            }
            QVERIFY2(most - least < 1.1, qPrintable(QString::number(most - least)));
            QVERIFY2(sharpest(loop, 1.5) < 1.5 / least + 0.45,
                     qPrintable(QString::number(sharpest(loop, 1.5))));
            QVERIFY(std::abs(loop_length(loop) - pi * (least + most)) < 0.05 * loop_length(loop));
        }
    }

    void edits_change_their_region_alone() {
        const Uncut uncut = places(1, [](double x, double y) { return std::hypot(std::abs(x) - 11, y) < 3; });
        RegionInput in = input_of(plain(), 1, 1);
        const ReworkRegions before = found(in, uncut);
        QCOMPARE(before.regions.size(), std::size_t(2));
        const auto area = [](const ReworkRegions& r, std::size_t i) { return r.regions.at(i).strip.area; };
        const Vec3 right(11, 0, 1.1);
        const auto edit = [&](bool enabled, double grow) {
            in.edits = {{{right.x(), right.y(), right.z()}, enabled, grow}};
            return found(in, uncut);
        };
        const ReworkRegions grown = edit(true, 1.5), shrunk = edit(true, -0.8), all_in = edit(true, -50),
                            off = edit(false, 0);
        for (const ReworkRegions* r : {&grown, &shrunk, &all_in, &off}) {
            QCOMPARE(r->regions.size(), std::size_t(2));
            QVERIFY(std::abs(area(*r, 0) - area(before, 0)) < 1e-9);
            for (const auto& u : uncut) // however far it shrinks
                QVERIFY(distance(u.point, *r) < 1e-9);
        }
        const double rim = loop_length(before.regions[1].strip.boundaries[0]);
        QVERIFY(std::abs(area(grown, 1) - area(before, 1) - 1.5 * (rim + 1.5 * pi)) < 0.1 * rim);
        QVERIFY(std::abs(area(shrunk, 1) - area(before, 1) + 0.8 * (rim - 0.8 * pi)) < 0.1 * rim);
        QVERIFY(area(all_in, 1) < area(shrunk, 1));
        QVERIFY(!off.regions[1].strip.enabled && off.regions[0].strip.enabled);
        QVERIFY(std::abs(off.area - area(before, 0)) < 1e-9);

        // A dragged point is on the boundary, and what is far from it stays.
        in.edits.clear();
        const auto nearest_of = [](const ReworkRegions& r, const Vec3& p) {
            double least = infinity;
            Vec3 at = p;
            for (const ReworkRegion& region : r.regions)
                for (const auto& loop : region.strip.boundaries)
                    for (const Vec3& q : loop)
                        if ((q - p).norm() < least) {
                            least = (q - p).norm();
                            at = q;
                        }
            return at;
        };
        const Vec3 from = nearest_of(before, Vec3(11, 6, 1.1));
        for (const double route : {1.5, 0.6, -0.6}) {
            const Vec3 to = from + Vec3(0, route, 0);
            in.drags = {{{from.x(), from.y(), from.z()}, {to.x(), to.y(), to.z()}}};
            const ReworkRegions dragged = found(in, uncut);
            const double missed = (nearest_of(dragged, to) - to).norm();
            QVERIFY2(missed < 0.25, qPrintable(QString("%1 misses %2").arg(route).arg(missed)));
            const Vec3 far = nearest_of(before, Vec3(11, -6, 1.1));
            QVERIFY((nearest_of(dragged, far) - far).norm() < 1e-9);
        }
    }

    void a_solid_has_regions_on_its_outside_alone() {
        const Mesh plate = box(Vec3(-20, -15, -1), Vec3(20, 15, 0));
        Uncut uncut;
        for (double x = -4; x <= 4; x += 1)
            uncut.push_back({Vec3(x, 0, 0), Vec3(0, 0, 1), 1});
        const ReworkRegions r = found(input_of(plate, 1, 2), uncut);
        QCOMPARE(r.regions.size(), std::size_t(1));
        for (const auto& facet : r.regions[0].strip.band)
            for (const Vec3& p : facet)
                QVERIFY(p.z() == 0);
        for (const Vec3& p : r.outside.mesh->vertices)
            QVERIFY(p.z() == 0);
        QVERIFY(std::abs(r.part_area - 1200) < 1e-9);
    }

    void nothing_uncut_is_no_region() {
        const ReworkRegions r = found(input_of(plain(), 1, 2), {});
        QVERIFY(r.regions.empty());
        QVERIFY(std::abs(r.part_area - 1200 * std::hypot(1, 0.1)) < 1e-6);
        QCOMPARE(r.outside.mesh->facets.size(), plain().facets.size());
    }

    void the_same_bits_with_any_number_of_threads() {
        const Uncut uncut = places(0.5, [](double x, double y) { return std::sin(x) * std::sin(y) > 0.5; });
        const RegionInput in = input_of(plain(), 0.5, 0.5);
        set_thread_count(1);
        const ReworkRegions one = found(in, uncut);
        set_thread_count(2);
        const ReworkRegions two = found(in, uncut);
        set_thread_count(0);
        QVERIFY(one.regions.size() > 5);
        QCOMPARE(two.regions.size(), one.regions.size());
        for (std::size_t i = 0; i < one.regions.size(); ++i)
            QVERIFY(one.regions[i].strip.band == two.regions[i].strip.band
                    && one.regions[i].strip.boundaries == two.regions[i].strip.boundaries);
    }

    void cancelling_leaves_nothing() {
        const Mesh part = mixed();
        GlobalLocalSettings s;
        for (const double when : {0.0, 0.3, 0.7}) {
            Job job;
            QVERIFY(cancelled_at(job, when, [&](const Progress& p) {
                region_source(five_axis_context(part, flat_tool(3)), s, p);
            }));
        }
    }

    /// (1), (3), (7) are each other's inverse; (2) is the chord of a circle.
    void tools_are_advised_by_the_papers_formulas() {
        for (const double lead : {1.0, 8.0, 45.0})
            for (const double curvature : {0.001, 0.0341, 0.5}) {
                const double d = largest_diameter(radians(lead), curvature);
                QVERIFY(std::abs(degrees(lead_for(d, curvature)) - lead) < 1e-9);
            }
        QVERIFY(std::isinf(largest_diameter(0.1, 0)) && lead_for(10, 1) == 0.5 * pi && lead_for(10, -1) == 0);
        const double r = 200, h = 0.05;
        QVERIFY(std::abs(widest_strip(r, h) - 2 * std::sqrt(2 * r * h - h * h)) < 1e-2);
    }

    /// More lead or a smaller tool: less to rework. In a trough (1) says from which diameter on all is uncut.
    void estimates_balance_main_path_and_rework() {
        const double r = 30;
        const Mesh part = height_field([r](double x, double) { return -std::sqrt(r * r - x * x); },
                                       Vec2(-12, -8), Vec2(12, 8), 240, 2);
        GlobalLocalSettings s;
        s.tolerance = 0.0002;
        s.direction = {0, "y"};
        s.feed = 600;
        const auto source = region_source(five_axis_context(part, flat_tool(6)), s, Progress());
        const double limit = largest_diameter(radians(5), 1 / r);
        const auto share = [&](double d, double lead) {
            return estimate(*source, 6, d, radians(lead), 2, 0.05, 600).rework_share;
        };
        QVERIFY2(share(0.9 * limit, 5) < 0.2, qPrintable(QString::number(share(0.9 * limit, 5))));
        QVERIFY2(share(1.1 * limit, 5) > 0.9, qPrintable(QString::number(share(1.1 * limit, 5))));
        double last = 1;
        for (const double lead : {1.0, 3.0, 6.0, 10.0, 30.0}) {
            QVERIFY(share(6, lead) <= last);
            last = share(6, lead);
        }
        // One pass along the middle, as wide as the tool: 24 mm by 16 mm at 10 mm/s.
        const StrategyEstimate e = estimate(*source, 6, 6, radians(10), 2, 0.05, 600);
        QVERIFY2(std::abs(e.main_seconds - 24 / (0.97 * 6) * 1.6) < 0.35 * e.main_seconds,
                 qPrintable(QString::number(e.main_seconds)));
        const ToolAdvice advice = tool_advice(*source, 6, s, 2, Progress());
        QVERIFY(std::abs(advice.curvature_half - 1 / r) < 0.05 / r);
        QVERIFY(std::abs(advice.diameter - largest_diameter(s.lead_limit, 1 / r)) < 0.2 * advice.diameter);
        QVERIFY(advice.by_lead.size() > 8 && advice.by_diameter.size() == 9);
        for (const auto* list : {&advice.by_lead, &advice.by_diameter})
            for (const StrategyEstimate& one : *list)
                QVERIFY(one.seconds() > 0 && std::isfinite(one.seconds())
                        && advice.best.seconds() <= one.seconds() + 1e-9);
    }

    void bad_settings_are_errors_data() {
        QTest::addColumn<int>("number");
        for (int i = 0; i < 5; ++i)
            QTest::addRow("%d", i) << i;
    }
    void bad_settings_are_errors() {
        QFETCH(int, number);
        RegionSource source;
        source.part = std::make_shared<Mesh>(plain());
        source.geometry = compute_geometry(*source.part, Progress());
        source.curvatures = std::make_shared<std::vector<VertexCurvature>>(
            vertex_curvatures(*source.part, source.geometry->vertex_normals, Progress()));
        source.assumed.spacing = 1;
        GlobalLocalSettings s;
        std::string about;
        switch (number) {
        case 0:
            s.lead_limit = 0;
            about = "lead_limit";
            break;
        case 1:
            s.lead_limit = radians(50);
            about = "assumed";
            break;
        case 2:
            s.rework_offset = 41;
            about = "larger than the part";
            break;
        case 3:
            s.view_direction = {1, 0, 0};
            s.machining_direction = {0, "x"};
            about = "view_direction";
            break;
        default:
            s.view_direction = {0, 0, 0};
            about = "view_direction";
        }
        std::string said;
        QCOMPARE(code_of([&] { find_regions(source, s, LengthUnit::mm, {}, Progress()); }, &said),
                 std::string("out_of_range"));
        QVERIFY2(said.find(about) != std::string::npos, said.c_str());
    }
};

FACETMILL_TEST(TestReworkRegion)
#include "test_rework_region.moc"
