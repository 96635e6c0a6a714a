#include "core/strategy/rough/rough_passes.h"

#include "core/base/tolerances.h"

#include <cmath>
#include <utility>

namespace facetmill {

namespace {

/// A route that begins no farther than this many diameters along free ways from where the last one ended is
/// cut in one go with it.
constexpr double longest_join = 10;
/// But a way on which nothing is left to cut and which is longer than this many diameters is made in rapids,
/// up and down, where these take less than this share of the time; a rapid takes this share of what the same
/// length takes at feed.
constexpr double longest_idle = 2, worth_share = 0.75, rapid_share = 0.1;
/// How far apart, in diameters, places of such a way are looked at.
constexpr double idle_step = 0.25;
/// Shank and holder are asked of pieces of a route this many diameters long. A piece is asked as a whole:
/// longer ones are as safe, and leave out more.
constexpr double clear_piece = 0.5;
/// Over a floor no more than this many layers may stand.
constexpr double max_floor_layers = 2;

} // namespace

RoughPasses::RoughPasses(const RoughSettings& settings, const RoughMeasures& measures,
                         const RoughReach& reach, const UprightBodies& bodies, const StockCutter& cutter,
                         StockField& field, const Progress& progress)
    : settings_(settings), measures_(measures), bodies_(bodies), cutter_(cutter), field_(field),
      progress_(progress), entry_(settings, reach, field, cutter, bodies, measures.min_work) {}

void RoughPasses::begin_layer(int layer, double z) {
    layer_ = layer;
    z_ = z;
    highest_ = field_.highest();
}

/// The parts of a route on which neither shank nor holder meets the stock.
std::vector<RoughRoute> RoughPasses::clear_parts(RoughRoute route) {
    std::vector<RoughRoute> parts;
    RoughRoute part = route;
    part.points.clear();
    part.closed = false; // a part of a closed route may not begin anywhere: from its end no way leads on
    const auto end = [&] {
        if (part.points.size() < 2) {
            part.points.clear();
            return;
        }
        part.after = part.points.back();
        parts.push_back(part);
        part.points.clear();
    };
    bool whole = true;
    for (std::size_t i = 1; i < route.points.size(); ++i) {
        const Vec2 a = route.points[i - 1], d = route.points[i] - a;
        const double n = std::max(1.0, std::ceil(d.norm() / (clear_piece * measures_.diameter)));
        for (double k = 0; k < n; ++k) {
            const Vec2 from = a + (k / n) * d, to = a + ((k + 1) / n) * d;
            if (bodies_.clear(field_, from, to, z_)) {
                if (part.points.empty()) {
                    part.points.push_back(from);
                    part.before = from;
                }
                part.points.push_back(to);
                continue;
            }
            whole = false;
            if (blocked_.length == 0) blocked_.at = Vec3(from.x(), from.y(), z_);
            blocked_.length += (to - from).norm();
            end();
        }
    }
    if (whole) {
        parts.push_back(std::move(route));
        return parts;
    }
    end();
    for (RoughRoute& p : parts)
        p.points = thinned_route(p.points, tolerance::route_rounding * measures_.diameter);
    return parts;
}

void RoughPasses::add(RoughRoute route, const LayerRoutes& routes, std::span<const FreeContour> contours) {
    progress_.check();
    std::vector<RoughRoute> parts;
    if (highest_ <= z_ + bodies_.lowest_base())
        parts.push_back(std::move(route));
    else
        parts = clear_parts(std::move(route));
    for (RoughRoute& p : parts) {
        if (join(p, routes, contours)) continue;
        std::vector<Vec3> down;
        if (entry_.enter(p, z_, down))
            take(p, down);
        else
            late_.push_back(std::move(p));
    }
}

/// Where the last pass ended nearby on the same layer the tool stays down: what it meets on the way is to be
/// cut on this layer anyway.
bool RoughPasses::join(RoughRoute& route, const LayerRoutes& routes, std::span<const FreeContour> contours) {
    const bool oneway = settings_.pattern == RoughSettings::Pattern::oneway;
    if (oneway || passes_.empty() || passes_.back().layer != layer_) return false;
    Pass& last = passes_.back();
    const Vec2 from = last.cl.back().tip.head<2>();
    if (route.reversible && (route.points.back() - from).norm() < (route.points.front() - from).norm())
        route.turn();
    std::vector<Vec2> points{from};
    if (!routes.connect(from, route.points.front(), contours, z_, longest_join * measures_.diameter, points))
        return false;
    for (std::size_t i = 1; i <= points.size(); ++i)
        if (!bodies_.clear(field_, points[i - 1], i < points.size() ? points[i] : route.points.front(), z_))
            return false;
    if (go_over(points, route)) return false;
    points.insert(points.end(), route.points.begin(), route.points.end());
    std::vector<StockField::Motion> cuts;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 tip(points[i].x(), points[i].y(), z_);
        cuts.push_back({last.cl.back().tip, tip});
        last.cl.push_back({tip, Vec3(0, 0, 1)});
        last.cc.push_back({tip, Vec3(0, 0, 1)});
    }
    field_.cut(cutter_, cuts, progress_.part(0, 0));
    at_ = route.points.back();
    return true;
}

/// Whether so much of a way on the layer, with the route at its end, cuts nothing that the tool had better go
/// up and over to where that ends: there the route begins then.
bool RoughPasses::go_over(const std::vector<Vec2>& link, RoughRoute& route) const {
    const double step = idle_step * measures_.diameter;
    double idle = 0;
    Vec2 last = link.front();
    for (std::size_t i = 0; i < link.size(); ++i) {
        const Vec2 to = i + 1 < link.size() ? link[i + 1] : route.points.front(), d = to - link[i];
        const double n = std::max(1.0, std::ceil(d.norm() / step));
        for (double k = 0; k < n; ++k) {
            const Vec2 next = link[i] + ((k + 1) / n) * d;
            if (!field_.has_work(cutter_, Vec3(last.x(), last.y(), z_), Vec3(next.x(), next.y(), z_),
                                 measures_.min_work)) {
                idle += (next - last).norm();
                last = next;
                continue;
            }
            if (!is_quicker_over(idle, (last - link.front()).norm())) return false;
            RoughRoute longer = route;
            longer.points.assign({last});
            longer.points.insert(longer.points.end(), link.begin() + std::ptrdiff_t(i) + 1, link.end());
            longer.points.insert(longer.points.end(), route.points.begin(), route.points.end());
            longer.before = last;
            longer.closed = longer.reversible = false;
            if (!entry_.begin_free(longer, z_)) return false;
            route = std::move(longer);
            return true;
        }
    }
    return is_quicker_over(idle, (last - link.front()).norm()) && entry_.begin_free(route, z_);
}

/// Whether up and over is quicker than a way of this length; `straight`: how far its ends are apart.
bool RoughPasses::is_quicker_over(double length, double straight) const {
    const double up = highest_ - z_ + settings_.clearance;
    // Out of the cut and into it at feed.
    const double over = 0.5 * measures_.diameter + rapid_share * (2 * up + straight);
    return length > longest_idle * measures_.diameter && over < worth_share * length;
}

void RoughPasses::add_late() {
    for (RoughRoute& route : std::exchange(late_, {})) {
        progress_.check();
        double length = 0;
        bool work = false;
        for (std::size_t i = 1; i < route.points.size(); ++i) {
            const Vec2 &a = route.points[i - 1], &b = route.points[i];
            length += (b - a).norm();
            work = work
                   || field_.has_work(cutter_, Vec3(a.x(), a.y(), z_), Vec3(b.x(), b.y(), z_),
                                      measures_.min_work);
        }
        if (!work) continue;
        std::vector<Vec3> down;
        if (entry_.enter(route, z_, down)) {
            take(route, down);
            continue;
        }
        if (closed_.routes++ == 0) closed_.at = Vec3(route.points.front().x(), route.points.front().y(), z_);
        closed_.length += length;
    }
}

void RoughPasses::add_floor(std::vector<Vec3> tips, const Layers& layers) {
    progress_.check();
    for (std::size_t i = 1; i < tips.size(); ++i) {
        const Vec2 a = tips[i - 1].head<2>(), b = tips[i].head<2>();
        const double low = std::min(tips[i - 1].z(), tips[i].z());
        // Where layers were left out, what stands is not for one cut.
        if (field_.stand_height(cutter_, a, b)
                > std::max(tips[i - 1].z(), tips[i].z()) + max_floor_layers * layers.depth_max
            || !bodies_.clear(field_, a, b, low))
            return;
    }
    tips = thinned_route(tips, 0.25 * measures_.margin);
    std::vector<Vec3> turned(tips.rbegin(), tips.rend()), down, other;
    const bool ahead = entry_.descend(tips, down), back = entry_.descend(turned, other);
    if (!ahead && !back) return;
    // In where it stands free, and uphill.
    if (!ahead || (back && other.empty() && (!down.empty() || tips.back().z() < tips.front().z()))) {
        tips.swap(turned);
        down.swap(other);
    }
    double low = infinity;
    for (const Vec3& tip : tips)
        low = std::min(low, tip.z());
    const auto deeper = std::upper_bound(layers.heights.begin(), layers.heights.end(), low, std::greater<>());
    take(tips, down, std::max(0, int(deeper - layers.heights.begin()) - 1));
}

void RoughPasses::take(const RoughRoute& route, const std::vector<Vec3>& down) {
    std::vector<Vec3> tips;
    for (const Vec2& p : route.points)
        tips.emplace_back(p.x(), p.y(), z_);
    take(tips, down, layer_);
    passes_.back().drive = route.line;
    passes_.back().offset = route.offset;
}

void RoughPasses::take(const std::vector<Vec3>& tips, const std::vector<Vec3>& down, int layer) {
    Pass pass;
    pass.drive = -1;
    pass.layer = layer;
    const Vec3 up(0, 0, 1);
    std::vector<StockField::Motion> cuts;
    for (std::size_t i = 0; i < down.size(); ++i) {
        pass.entry.push_back({down[i], up});
        if (i > 0) cuts.push_back({down[i - 1], down[i]});
    }
    for (const Vec3& tip : tips) {
        if (!pass.cl.empty()) cuts.push_back({pass.cl.back().tip, tip});
        pass.cl.push_back({tip, up});
        pass.cc.push_back({tip, up});
    }
    if (pass.cl.size() == 1) cuts.push_back({pass.cl.front().tip, pass.cl.front().tip});
    field_.cut(cutter_, cuts, progress_.part(0, 0));
    at_ = tips.back().head<2>();
    passes_.push_back(std::move(pass));
}

} // namespace facetmill
