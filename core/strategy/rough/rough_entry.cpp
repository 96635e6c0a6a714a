#include "core/strategy/rough/rough_entry.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Radii of the cutter: how far outside a route may begin to stand free; the longest and the shortest leg of
/// a ramp, and the shortest where there is room for nothing else; looks along a route.
constexpr double max_outside = 4, longest_leg = 12, usual_leg = 2, shortest_leg = 0.7, look = 0.5;
/// Legs of a ramp and turns of a helix, at most: what needs more is no entry.
constexpr double max_legs = 200;
/// Radii of a helix, in radii of the cutter: the larger the better the chips come out, but a core must not
/// stay in its middle.
constexpr double helix_radii[] = {0.9, 0.7, 0.5, 0.35};
/// Sides of a turn of a helix, and directions in which its middle is looked for.
constexpr int helix_sides = 24, helix_directions = 8;

/// The part of a polyline from its beginning to `arc`.
std::vector<Vec2> head(const std::vector<Vec2>& route, double arc) {
    std::vector<Vec2> part{route.front()};
    for (std::size_t i = 1; i < route.size() && arc > 0; ++i) {
        const double length = (route[i] - route[i - 1]).norm();
        if (length == 0) continue;
        part.push_back(route[i - 1] + std::min(1.0, arc / length) * (route[i] - route[i - 1]));
        arc -= length;
    }
    return part;
}

double length_of(const std::vector<Vec2>& route) {
    double sum = 0;
    for (std::size_t i = 1; i < route.size(); ++i)
        sum += (route[i] - route[i - 1]).norm();
    return sum;
}

} // namespace

UprightBodies::UprightBodies(const Tool& tool, const CutterProfile& profile, double deepest) {
    double base = tool.flute_length;
    // What stands above the flutes the layer above has cut, lower on the cutter by its depth: a ball or a
    // taper is slimmer there.
    const double left = profile.radius_at(std::max(0.0, std::min(base, profile.height()) - deepest));
    const auto within = [](double radius, double limit) {
        return radius <= limit * (1 + tolerance::figure_rounding);
    };
    const auto add = [&](double diameter, double length) {
        if (diameter > 0 && length > 0) {
            const double radius = 0.5 * diameter;
            bodies_.push_back({radius, base, within(radius, profile.max_radius()), within(radius, left)});
            lowest_ = std::min(lowest_, base);
            if (bodies_.back().slides) sliding_ = std::min(sliding_, base);
        }
        base += std::max(length, 0.0);
    };
    add(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& s : tool.holder)
        add(s.diameter, s.length);
}

double UprightBodies::clear_height(const StockField& field, const Vec2& a, const Vec2& b,
                                   double known) const {
    double z = known;
    for (const Body& body : bodies_)
        if (!body.inside && field.no_higher() - body.base > z)
            z = std::max(z, field.highest_near(a, b, body.radius) - body.base);
    return z;
}

double UprightBodies::widest() const {
    double radius = 0;
    for (const Body& body : bodies_)
        radius = std::max(radius, body.radius);
    return radius;
}

bool UprightBodies::clear(const StockField& field, const Vec2& a, const Vec2& b, double z) const {
    for (const Body& body : bodies_) {
        if (field.no_higher() <= z + body.base) continue;
        // A shank as thick as its cutter slides along what the layers above have cut, and cells that the wall
        // crosses stand high: only cells that are wholly under it count.
        const double inset = field.cell() * std::numbers::sqrt2;
        const double radius = body.slides ? body.radius - inset : body.radius;
        if (radius > 0 && field.highest_near(a, b, radius, z + body.base) > z + body.base) return false;
    }
    return true;
}

bool RoughEntry::stands_free(const Vec2& p, double z) const {
    return field_.stand_height(cutter_, p, p) <= z + min_ && bodies_.clear(field_, p, p, z);
}

bool RoughEntry::begin_free(RoughRoute& route, double z) const {
    if (stands_free(route.points.front(), z)) return true;
    const Vec2 out = route.before - route.points.front();
    const double most = std::min(out.norm(), max_outside * cutter_.radius());
    if (!(most > 0)) return false;
    const double n = std::ceil(most / (look * cutter_.radius()));
    for (double i = 1; i <= n; ++i) {
        const Vec2 p = route.points.front() + (i / n) * most / out.norm() * out;
        if (!stands_free(p, z)) continue;
        RoughReach::Hints hints;
        if (!reach_.is_free(p, route.points.front(), z, hints)
            || !bodies_.clear(field_, p, route.points.front(), z))
            return false;
        route.points.insert(route.points.begin(), p);
        return true;
    }
    return false;
}

bool RoughEntry::enter(RoughRoute& route, double z, std::vector<Vec3>& down) const {
    down.clear();
    if (begin_free(route, z)) return true;
    if (route.reversible) {
        route.turn();
        if (begin_free(route, z)) return true;
        route.turn();
    }
    if (route.closed) {
        // Begun anywhere, also within a straight piece.
        for (std::size_t i = 1; i < route.points.size(); ++i) {
            const Vec2 a = route.points[i - 1], d = route.points[i] - a;
            const double n = std::max(1.0, std::ceil(d.norm() / (look * cutter_.radius())));
            for (double k = 1; k <= n; ++k) {
                const Vec2 p = a + (k / n) * d;
                if (!stands_free(p, z)) continue;
                std::vector<Vec2> turned{p};
                if (k < n) turned.push_back(route.points[i]);
                turned.insert(turned.end(), route.points.begin() + std::ptrdiff_t(i) + 1, route.points.end());
                turned.insert(turned.end(), route.points.begin() + 1,
                              route.points.begin() + std::ptrdiff_t(i));
                turned.push_back(p);
                route.points = std::move(turned);
                return true;
            }
        }
    }
    using Entry = RoughSettings::Entry;
    const double radius = cutter_.radius();
    if (settings_.entry == Entry::plunge) return true;
    if (settings_.entry == Entry::helix && helix(route, z, down)) return true;
    if (ramp(route, z, usual_leg * radius, down)) return true;
    if (settings_.entry == Entry::automatic && helix(route, z, down)) return true;
    return ramp(route, z, shortest_leg * radius, down);
}

bool RoughEntry::ramp(const RoughRoute& route, double z, double shortest, std::vector<Vec3>& down) const {
    const double length = length_of(route.points);
    if (length < shortest) return false;
    std::vector<Vec2> leg = head(route.points, std::min(length, longest_leg * cutter_.radius()));
    double top = z;
    for (std::size_t i = 1; i < leg.size(); ++i)
        top = std::max(top, field_.stand_height(cutter_, leg[i - 1], leg[i]));
    const double run = (top - z) / std::tan(settings_.ramp_angle);
    const double legs = std::ceil(run / length_of(leg));
    if (!(legs <= max_legs)) return false;
    leg = head(leg, run / std::max(legs, 1.0));
    if (length_of(leg) < shortest && legs > 1) return false;
    // Forth and back, so that the last leg ends where the route begins.
    std::vector<Vec2> ground;
    for (double k = legs; k >= 1; --k) {
        const bool back = std::fmod(k, 2) == 1;
        std::vector<Vec2> one = leg;
        if (back) std::reverse(one.begin(), one.end());
        ground.insert(ground.end(), one.begin() + (ground.empty() ? 0 : 1), one.end());
    }
    const double all = length_of(ground);
    double done = 0;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        if (i > 0) done += (ground[i] - ground[i - 1]).norm();
        const double height = i + 1 == ground.size() ? z : top + (z - top) * (all > 0 ? done / all : 1);
        down.emplace_back(ground[i].x(), ground[i].y(), height);
    }
    return true;
}

bool RoughEntry::descend(const std::vector<Vec3>& tips, std::vector<Vec3>& down) const {
    down.clear();
    if (settings_.entry == RoughSettings::Entry::plunge
        || stands_free(tips.front().head<2>(), tips.front().z()))
        return true;
    // The leg, and how high what stands on it holds the cutter.
    std::vector<Vec3> leg{tips.front()};
    double length = 0, top = leg[0].z(), low = leg[0].z();
    for (std::size_t i = 1; i < tips.size() && length < longest_leg * cutter_.radius(); ++i) {
        const Vec2 a = tips[i - 1].head<2>(), b = tips[i].head<2>();
        length += (b - a).norm();
        leg.push_back(tips[i]);
        top = std::max({top, tips[i].z(), field_.stand_height(cutter_, a, b)});
        low = std::min(low, tips[i].z());
    }
    if (length < shortest_leg * cutter_.radius()) return false;
    const double fall = std::tan(settings_.ramp_angle);
    const double legs = 2 * std::max(1.0, std::ceil((top - low) / (2 * fall * length)));
    if (!(legs <= max_legs)) return false;
    double done = 0;
    down.emplace_back(leg[0].x(), leg[0].y(), top);
    for (double k = 0; k < legs; ++k) {
        for (std::size_t i = 1; i < leg.size(); ++i) {
            done += (leg[i] - leg[i - 1]).head<2>().norm();
            down.emplace_back(leg[i].x(), leg[i].y(), std::max(leg[i].z(), top - fall * done));
        }
        std::reverse(leg.begin(), leg.end());
    }
    return true;
}

bool RoughEntry::helix(const RoughRoute& route, double z, std::vector<Vec3>& down) const {
    // Where the route begins in a corner there is more room farther along it.
    for (double arc = 0; arc <= max_outside * cutter_.radius(); arc += cutter_.radius()) {
        const std::vector<Vec2> back = head(route.points, arc);
        if (!helix_at(back.back(), z, down)) continue;
        for (std::size_t i = back.size() - 1; i-- > 0;)
            down.emplace_back(back[i].x(), back[i].y(), z);
        return true;
    }
    return false;
}

bool RoughEntry::helix_at(const Vec2& end, double z, std::vector<Vec3>& down) const {
    RoughReach::Hints hints;
    for (const double share : helix_radii) {
        const double r = share * cutter_.radius();
        for (int k = 0; k < helix_directions; ++k) {
            const double turn = 2 * pi * k / helix_directions;
            const Vec2 middle = end + r * Vec2(std::cos(turn), std::sin(turn));
            std::vector<Vec2> round;
            for (int i = 0; i <= helix_sides; ++i) {
                // Counter-clockwise, which with a cutter that turns clockwise mills down; the last is `end`.
                const double a = turn + pi + 2 * pi * i / helix_sides;
                round.push_back(i == helix_sides ? end : Vec2(middle + r * Vec2(std::cos(a), std::sin(a))));
            }
            bool free = true;
            for (std::size_t i = 1; free && i < round.size(); ++i)
                free = reach_.is_free(round[i - 1], round[i], z, hints)
                       && bodies_.clear(field_, round[i - 1], round[i], z);
            if (!free) continue;
            double top = z;
            for (std::size_t i = 1; i < round.size(); ++i)
                top = std::max(top, field_.stand_height(cutter_, round[i - 1], round[i]));
            const double side = (round[1] - round[0]).norm();
            const double sides = std::ceil((top - z) / (side * std::tan(settings_.ramp_angle)));
            if (!(sides <= max_legs * helix_sides)) return false;
            // Down to the level, then once round on it.
            for (double i = sides; i >= 0; --i) {
                const auto at = std::size_t(helix_sides - int(std::fmod(i, helix_sides))) % helix_sides;
                down.emplace_back(round[at].x(), round[at].y(), z + (sides > 0 ? (top - z) * i / sides : 0));
            }
            for (std::size_t i = 1; i < round.size(); ++i)
                down.emplace_back(round[i].x(), round[i].y(), z);
            return true;
        }
    }
    return false;
}

} // namespace facetmill
