#include "core/strategy/lathe/lathe_probe.h"
#include "core/base/plane_geometry.h"

#include "core/base/tolerances.h"

#include <cmath>

namespace facetmill {

namespace {

/// A cutter that is nearer than this share of what is allowed touches.
constexpr double touching = 0.02;
/// Directions of the search about a place; each round begins with a step of half the one before, the last one
/// is this share of the cutter's radius long.
constexpr int directions = 8, max_moves = 40;
constexpr double last_step_share = 1.0 / 64;
/// Steps to the angle at which the cutter that touches a plane stands.
constexpr int angle_steps = 4;

} // namespace

LathePlace LatheProbe::place_over(const Vec3& p, const Vec3& n) const {
    const Vec3& d = frame_.axis().direction;
    LathePlace place{angle_of(p), 0};
    Vec3 tip = p;
    for (int k = 0; k < angle_steps; ++k) {
        const Vec3 a = frame_.tool_axis(place.angle), x = d.cross(a).normalized(), up = a.cross(x);
        const Vec3 local(n.dot(x), n.dot(up), n.dot(a));
        tip = p;
        if (local.z() >= tolerance::vertical_normal_z) {
            const Vec3 off = field_.cover().tip_offset(local);
            tip += field_.allowance() * n + off.x() * x + off.y() * up + off.z() * a;
        }
        const double rho = frame_.away(tip);
        if (!(rho > std::abs(frame_.offset()))) break;
        // Beside the centre line by the offset.
        place.angle = angle_of(tip) - std::asin(frame_.offset() / rho);
    }
    place.y = frame_.along(tip)
              - std::tan(frame_.tilt()) * (tip - frame_.axis().point).dot(frame_.radial(place.angle));
    return place;
}

LathePlace LatheProbe::straight_over(const Vec3& p) const {
    const double rho = frame_.away(p), offset = frame_.offset();
    const double angle =
        angle_of(p) - (rho > std::abs(offset) ? std::asin(offset / rho) : std::copysign(0.5 * pi, offset));
    const double out = (p - frame_.axis().point).dot(frame_.radial(angle));
    return {angle, frame_.along(p) - std::tan(frame_.tilt()) * out};
}

double LatheProbe::angle_of(const Vec3& p) const {
    const Vec3 v = p - frame_.axis().point;
    return std::atan2(v.dot(frame_.axis().direction.cross(frame_.zero())), v.dot(frame_.zero()));
}

LatheProbe::Stand LatheProbe::stand(LathePlace place, LatheField::Hint& hint) const {
    place.y = std::clamp(place.y, range_.from, range_.to);
    const LathePoint at = field_.point(place, hint);
    const CutterLocation tool = frame_.at(place, at.u);
    const Vec3 x = frame_.axis().direction.cross(tool.axis).normalized();
    return {at, tool.tip, x, tool.axis.cross(x), tool.axis};
}

LatheProbe::Rest LatheProbe::rest(const Stand& tool, const Vec3& p, const Vec3& n) const {
    Rest r;
    const CutterCover& cover = field_.cover();
    r.distance = cover.distance(tool.local(p - tool.tip));
    const Vec3 normal = tool.local(n);
    if (normal.z() >= 0)
        r.height = cover.ray_entry(tool.local(p + field_.allowance() * n - tool.tip), normal, Vec3::Zero(),
                                   2 * cover.radius());
    // A cutter that touches p may be passed by its own tangent. Behind a wall whose normal points the
    // other way, as those of bores do, it has not been at p at all.
    r.height = r.distance <= field_.allowance() + touching * allowed_
                   ? 0
                   : std::max(r.height, r.distance - field_.allowance());
    return r;
}

LatheProbe::Nearest LatheProbe::nearest_from(LathePlace place, double step, const Vec3& p, const Vec3& n,
                                             LatheField::Hint& hint, const Progress& progress) const {
    const auto at = [&](const LathePlace& q) {
        const Stand tool = stand(q, hint);
        return Nearest{rest(tool, p, n), tool.at};
    };
    Nearest best = at(place);
    if (best.height <= allowed_) return best;
    const double away = away_of(p), last = last_step_share * field_.cover().radius();
    double first = 0;
    for (; step > 0.75 * last; step *= 0.5, first += golden_angle) {
        progress.check();
        bool moved = true;
        for (int moves = 0; moved && moves < max_moves; ++moves) {
            moved = false;
            for (int k = 0; k < directions; ++k) {
                const double heading = first + 2 * pi * k / directions;
                const LathePlace next{place.angle + step * std::cos(heading) / away,
                                      place.y + step * std::sin(heading)};
                const Nearest here = at(next);
                if (here.height <= allowed_) return here;
                if (here.distance >= best.distance - tolerance::contact_distance) continue;
                best = here;
                place = next;
                moved = true;
                break;
            }
        }
    }
    return best;
}

} // namespace facetmill
