#include "core/strategy/lathe/lathe_route.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/plan/plan_text.h"

#include <cmath>

namespace facetmill {

namespace {

/// Facets that a thread takes at a time.
constexpr std::size_t facets_per_block = 4096;
/// Turns of a route, at most: more come from a part in another unit.
constexpr std::size_t max_turns = 200000;
/// Angles and places along the axis at which the part's lowest place is looked for, where something holds it.
constexpr std::size_t low_angles = 72, low_places = 64;

/// Feet of tips that touch the facets' corners with the facets' own normals.
LatheRange touched(const LatheField& field, const PlanContext& context, const Progress& progress) {
    const Mesh& mesh = *context.part;
    const LatheFrame& frame = field.frame();
    const Vec3& d = frame.axis().direction;
    return parallel_reduce(
        mesh.facet_count(), facets_per_block, LatheRange{infinity, -infinity, 0}, progress,
        [&](std::size_t begin, std::size_t end) {
            LatheRange range{infinity, -infinity, 0};
            for (std::size_t f = begin; f < end; ++f) {
                Vec3 n = mesh.facet_normal(f), out = n - n.dot(d) * d;
                if (!(out.norm() > tolerance::vertical_normal_z)) continue; // faces along the axis
                // Either side of a facet may be out, as the winding of a scan says nothing.
                const Vec3 middle = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
                if (out.dot(middle - frame.axis().point) < 0) {
                    n = -n;
                    out = -out;
                }
                const Vec3 r = out.normalized();
                const Vec3 a = std::cos(frame.tilt()) * r + std::sin(frame.tilt()) * d;
                if (!(n.dot(a) > tolerance::vertical_normal_z)) continue;
                const Vec3 x = d.cross(a).normalized(), up = a.cross(x);
                const Vec3 off = field.cover().tip_offset(Vec3(n.dot(x), n.dot(up), n.dot(a)));
                for (int k = 0; k < 3; ++k) {
                    const Vec3 tip = mesh.corner(f, k) + off.x() * x + off.y() * up + off.z() * a;
                    const Vec3 v = tip - frame.axis().point;
                    const double y = v.dot(d) - std::tan(frame.tilt()) * v.dot(r);
                    range.from = std::min(range.from, y);
                    range.to = std::max(range.to, y);
                }
            }
            return range;
        },
        [](LatheRange x, const LatheRange& y) {
            return LatheRange{std::min(x.from, y.from), std::max(x.to, y.to), 0};
        });
}

/// The place nearest to `held` at which the zone is no higher than `low`; `free` where it is low everywhere.
double edge_of_zone(const LatheField& field, double held, double free, double low) {
    LatheField::Hint hint;
    const auto blocked = [&](double y) { return field.zone_u({0, y}, hint) > low; };
    if (!blocked(held)) return held;
    if (blocked(free)) return free;
    for (int k = 0; k < 60; ++k) {
        const double mid = 0.5 * (held + free);
        (blocked(mid) ? held : free) = mid;
    }
    return free;
}

} // namespace

LatheRange lathe_range(const LatheCommon& s, const LatheField& field, const PlanContext& context,
                       const Progress& progress) {
    LatheRange range = touched(field, context, progress);
    if (!(range.from <= range.to))
        throw Error(ErrorCode::empty_result, s.name, "all facets of the part face along the turning axis",
                    "check the axis");
    if (s.start.is_number()) range.from = s.start.number;
    if (s.stop.is_number()) range.to = s.stop.number;
    const PlanText text{context.unit};
    if (!(range.from < range.to))
        throw Error(ErrorCode::out_of_range, s.stop.is_number() ? "stop" : "start",
                    "the path would run from " + text(range.from) + " to " + text(range.to)
                        + " along the axis",
                    "start before the stop, and where the part is");
    if (!field.has_zones()) return range;
    // Down to the lowest place of the part no zone may hold the tool.
    const double low = parallel_reduce(
        low_places, 1, infinity, progress,
        [&](std::size_t begin, std::size_t end) {
            double least = infinity;
            LatheField::Hint hint;
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t k = 0; k < low_angles; ++k) {
                    const LathePlace place{
                        2 * pi * double(k) / double(low_angles),
                        range.from + (range.to - range.from) * double(i) / double(low_places - 1)};
                    const LathePoint p = field.point(place, hint);
                    if (p.held != LathePoint::HeldBy::zone) least = std::min(least, p.u);
                }
            return least;
        },
        [](double x, double y) { return std::min(x, y); });
    const LatheRange whole = range;
    const double middle = 0.5 * (field.stock_from() + s.chuck[0] + field.stock_to() - s.tailstock[0]);
    range.from = edge_of_zone(field, range.from, std::max(middle, range.from), low);
    range.to = edge_of_zone(field, range.to, std::min(middle, range.to), low);
    if (low == infinity || !(range.from < range.to))
        throw Error(ErrorCode::out_of_range, s.chuck[0] > 0 ? "chuck" : "tailstock",
                    "chuck and tailstock leave no room for the tool between them",
                    "hold less of the stock, or take a smaller tool or clearance");
    range.held_back = (whole.to - whole.from) - (range.to - range.from);
    return range;
}

std::size_t turn_steps(const NumberOrWord& asked, double radius, double sagitta) {
    const double least =
        std::max(12.0, std::ceil(pi / std::acos(std::max(1 - sagitta / std::max(radius, sagitta), 0.0))));
    if (!asked.is_number()) return std::size_t(least);
    if (asked.number != std::round(asked.number))
        throw Error(ErrorCode::out_of_range, "points_per_turn",
                    format_number(asked.number) + " is no whole number", "give a whole number of at least 3");
    return std::size_t(asked.number * std::max(1.0, std::ceil(least / asked.number)));
}

LatheRoute lathe_route(LatheCommon::Pattern pattern, const LatheRange& range, std::size_t steps,
                       const std::function<double(double)>& advance, const Progress& progress) {
    using Pattern = LatheCommon::Pattern;
    LatheRoute route;
    route.feed_min = infinity;
    const double n = double(steps);
    const auto counted = [&](double feed) {
        route.feed_min = std::min(route.feed_min, feed);
        route.feed_max = std::max(route.feed_max, feed);
        progress.check();
        if (route.turns.size() > max_turns || double(route.places.size()) > max_lathe_points)
            throw Error(ErrorCode::limit_exceeded, "side_feed",
                        "the side feed asks for more than " + std::to_string(max_turns) + " turns",
                        "choose a larger side feed or tolerance");
        return feed;
    };
    if (pattern == Pattern::lengthwise) {
        double angle = 0;
        for (bool back = false; angle < 2 * pi - tolerance::level_angle; back = !back) {
            route.turns.push_back(route.places.size());
            if (!route.places.empty() && angle > route.places.back().angle) {
                // Round to the next line, in steps as short as any.
                const LathePlace last = route.places.back();
                const double parts = std::ceil((angle - last.angle) * n / (2 * pi));
                for (double k = 1; k < parts; ++k)
                    route.places.push_back({last.angle + (angle - last.angle) * k / parts, last.y});
            }
            route.places.push_back({angle, back ? range.to : range.from});
            route.places.push_back({angle, back ? range.from : range.to});
            angle += counted(advance(angle));
        }
        return route;
    }
    if (pattern == Pattern::rings) {
        double turn = 0;
        for (double y = range.from;;) {
            route.turns.push_back(route.places.size());
            for (std::size_t k = 0; k <= steps; ++k)
                route.places.push_back({2 * pi * (turn + double(k) / n), y});
            ++turn;
            if (!(y < range.to)) break;
            const double next = std::min(y + advance(y), range.to);
            counted(next - y);
            y = next;
        }
        return route;
    }
    // Helix: each turn is the one before, moved by what the feed allows at every step; the first stands
    // still. Feeds that change slowly keep it rising everywhere.
    std::vector<double> before(steps, range.from), now(steps);
    for (std::size_t k = 0; k < steps; ++k)
        route.places.push_back({2 * pi * double(k) / n, range.from});
    route.turns.push_back(0);
    const double first = advance(range.from);
    std::size_t at_end = 0; // steps since the end was reached
    for (std::size_t turn = 1; at_end <= steps; ++turn) {
        route.turns.push_back(route.places.size());
        for (std::size_t k = 0; k < steps && at_end <= steps; ++k) {
            const double feed = turn == 1 ? first * double(k) / n : advance(before[k]);
            now[k] = std::min(before[k] + feed, range.to);
            if (turn > 1 && now[k] < range.to) counted(feed);
            if (at_end > 0 || now[k] >= range.to) ++at_end;
            route.places.push_back({2 * pi * (double(turn) + double(k) / n), now[k]});
        }
        before = now;
    }
    if (route.turns.back() + 1 == route.places.size())
        route.turns.pop_back(); // the point that closes the last one
    if (route.feed_min == infinity) route.feed_min = route.feed_max = first;
    return route;
}

} // namespace facetmill
