#include "core/strategy/cleanup/nearest_place.h"

#include "core/base/tolerances.h"
#include "core/strategy/cleanup/tip_grid.h"

namespace facetmill {

namespace {

/// The first steps of a search, in radii of the cutter, and the number of directions that it tries.
constexpr double first_step = 0.2;
constexpr int directions = 8;
/// A step may bring the cutter nearer by so many times its length, as on walls that are steep; small ones,
/// less than the tolerance, are asked so many times as long as that matters.
constexpr double steep_gain = 10, small_gain = 2;

/// From the grid's nearest place on; false where none comes near enough.
bool start_on_grid(const ValleyInput& input, RestSample& from, double within, LiftHint& hint) {
    const std::optional<Vec2> at = input.tips->nearest(from.point, std::min(from.gap, within));
    if (!at) return from.gap <= within;
    const Vec3 tip(at->x(), at->y(), input.lift->tip_z(at->x(), at->y(), hint));
    if (const double d = input.cover->distance(from.point - tip); d < from.gap) {
        from.gap = d;
        from.tip = tip;
    }
    return true;
}

/// The cutter with its tip at (x, y) comes nearer to p than `gap` where the tip is below this height;
/// -infinity where it does nowhere, infinity where that is not known.
double nearer_below(const CutterCover& cover, const Vec3& p, const Vec3& at, double gap) {
    if (!cover.rounded_disc()) return infinity;
    const auto [disc, rounding] = *cover.rounded_disc();
    const double beside = std::max((p - at).head<2>().norm() - disc, 0.0), within = gap + rounding;
    if (!(beside < within)) return -infinity;
    return p.z() - rounding + std::sqrt(within * within - beside * beside);
}

/// The tip of a cutter that touches a plane, with nothing else about.
Vec3 tip_touching(const CutterCover& cover, const Vec3& p, const Vec3& n) {
    if (n.z() > tolerance::vertical_normal_z) return p + cover.tip_offset(n);
    // Along an upright wall, a hair beside it: it would be passed over else.
    const double out = cover.radius() * (1 + tolerance::rim_share) / std::hypot(n.x(), n.y());
    return p + Vec3(out * n.x(), out * n.y(), -cover.shoulder());
}

void held_up(RestSample& s, const CutterCover& cover, double height) {
    s.tip.z() = std::max(s.tip.z(), height);
    s.gap = cover.distance(s.point - s.tip);
}

} // namespace

RestSample nearest_touch(const ValleyInput& input, const Vec3& p, const Vec3& n, LiftHint& hint) {
    RestSample s;
    s.point = p;
    s.normal = n;
    s.tip = tip_touching(*input.cover, p, n);
    held_up(s, *input.cover, input.lift->tip_z(s.tip.x(), s.tip.y(), hint));
    return s;
}

void nearest_touches(const ValleyInput& input, std::span<RestSample> samples, const Progress& progress) {
    std::vector<Vec2> at;
    at.reserve(samples.size());
    for (RestSample& s : samples) {
        s.tip = tip_touching(*input.cover, s.point, s.normal);
        at.emplace_back(s.tip.x(), s.tip.y());
    }
    std::vector<double> heights(at.size());
    input.lift->tip_z(at, heights, progress);
    for (std::size_t i = 0; i < samples.size(); ++i)
        held_up(samples[i], *input.cover, heights[i]);
}

RestSample nearest_about(const ValleyInput& input, RestSample from, double enough, double finest,
                         LiftHint& hint, double hopeless) {
    double step = first_step * input.cover->radius();
    if (input.tips && from.gap > enough && input.tips->is_about(from.point)) {
        step = 0.5 * input.tips->spacing();
        if (!start_on_grid(input, from, hopeless + 0.5 * steep_gain * step, hint)) return from;
    }
    while (step > finest && from.gap > enough) {
        bool better = false;
        for (int k = 0; k < directions && from.gap > enough; ++k) {
            const double angle = 2 * pi * k / directions;
            Vec3 tip = from.tip + step * Vec3(std::cos(angle), std::sin(angle), 0);
            // Mostly it is held up higher than where it would come nearer.
            const double below = nearer_below(*input.cover, from.point, tip, from.gap);
            if (below == -infinity
                || (below < infinity && input.lift->is_above(tip.x(), tip.y(), below, hint)))
                continue;
            tip.z() = input.lift->tip_z(tip.x(), tip.y(), hint);
            if (!(tip.z() > -infinity)) continue;
            if (const double d = input.cover->distance(from.point - tip); d < from.gap) {
                from.gap = d;
                from.tip = tip;
                better = true;
            }
        }
        if (better) continue;
        step *= 0.5;
        if (from.gap > hopeless + (step < input.tolerance ? small_gain : steep_gain) * step) break;
    }
    return from;
}

} // namespace facetmill
