#include "core/strategy/cleanup/between_passes.h"

#include "core/base/tolerances.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/cleanup/ridge.h"
#include "core/strategy/cleanup/standing.h"

namespace facetmill {

namespace {

/// What stays is looked for on the part by so many halvings of the stretch from one touched point to the
/// other.
constexpr int between_halvings = 5;
/// The least that the cutter leaves is looked for in steps down to this share of what may be left.
constexpr double finest_share = 0.1;
/// Sine of the angle: by less the part does not turn between two passes.
constexpr double same_plane = 0.02;

} // namespace

double BetweenPasses::left(const ValleySpot& a, const ValleySpot& b, const Vec3& travel) const {
    double most = ridge(with_.cover->profile(), b.tip - a.tip, travel);
    if (most > with_.cusp || a.normal.cross(b.normal).norm() < same_plane
        || (b.normal - a.normal).dot(b.touch - a.touch) >= 0)
        return most;
    // Most stays where both leave the same: halving goes on towards the side of the one that leaves more.
    LiftHint hint;
    Standing::Hint near;
    double lo = 0, hi = 1;
    for (int n = 0; n < between_halvings; ++n) {
        const double share = 0.5 * (lo + hi), beyond = hi;
        hi = share; // where there is no place to ask at
        const auto at = between(a, b, share);
        if (!at) continue;
        const double by_a = with_.cover->distance(at->point - a.tip),
                     by_b = with_.cover->distance(at->point - b.tip);
        if (by_a < by_b) {
            lo = share;
            hi = beyond;
        }
        const double rest = std::min(by_a, by_b);
        if (rest <= std::max(most, with_.cusp)) continue;
        // Beside its band a pass runs over what is cut.
        if (with_.standing && !with_.standing->stands(at->point, rest, with_.cusp, near)) continue;
        most = std::max(most, rest - min_left(*at, rest, most, hint));
    }
    return most;
}

std::optional<BetweenPasses::Between> BetweenPasses::between(const ValleySpot& a, const ValleySpot& b,
                                                             double share) const {
    const Vec3 across = b.touch - a.touch;
    const Vec3 out = (1 - share) * a.normal + share * b.normal;
    if (out.norm() < same_plane) return std::nullopt;
    const Vec3 normal = out.normalized();
    const double back = std::min(across.norm(), radius_);
    const auto hit =
        with_.grid->first_hit(a.touch + share * across + back * normal, -normal, 2 * back + radius_);
    if (!hit) return std::nullopt;
    const Vec3 facet = with_.side->towards_tool(with_.mesh->facet_normal(hit->facet));
    if (!(facet.dot(normal) > 0) || facet.z() < -tolerance::vertical_normal_z) return std::nullopt;
    return Between{a.touch + share * across + (back - hit->distance) * normal + with_.allowance * facet,
                   facet, normal};
}

/// The least that the cutter can leave there where that is less than `rest` by more than `known`; no better
/// place is looked for than one that leaves two cusps less.
double BetweenPasses::min_left(const Between& at, double rest, double known, LiftHint& hint) const {
    RestSample least = nearest_touch(reach_, at.point, at.facet, hint);
    if (at.normal.z() >= 0)
        if (const RestSample other = nearest_touch(reach_, at.point, at.normal, hint); other.gap < least.gap)
            least = other;
    return nearest_about(reach_, least, rest - 2 * with_.cusp, finest_share * with_.cusp, hint, rest - known)
        .gap;
}

} // namespace facetmill
