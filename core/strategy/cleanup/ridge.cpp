#include "core/strategy/cleanup/ridge.h"

#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// The outline is the envelope of its tangents at so many angles, up to this one (radians) to either side.
constexpr int outline_angles = 241;
constexpr double steepest_tangent = 1.4;
constexpr int crossing_halvings = 60;

/// Largest d . p over the cutter with its tip at the origin.
double support(const CutterProfile& profile, const Vec3& d) {
    const double out = std::hypot(d.x(), d.y());
    double best = std::max(0.0, d.z() * profile.height());
    for (const ProfilePiece& p : profile.pieces()) {
        best = std::max({best, out * p.from.x() + d.z() * p.from.y(), out * p.to.x() + d.z() * p.to.y()});
        if (p.kind != ProfilePiece::Kind::arc) continue;
        const Vec2 q = p.center + p.radius * Vec2(out, d.z()).normalized();
        if (q.y() >= std::min(p.from.y(), p.to.y()) && q.y() <= std::max(p.from.y(), p.to.y())
            && q.x() >= std::min(p.from.x(), p.to.x()))
            best = std::max(best, out * q.x() + d.z() * q.y());
    }
    return best;
}

/// What a cutter reaches down to, seen along its travel: heights across it, above the tip.
class Outline {
public:
    Outline(const CutterProfile& profile, const Vec3& across, const Vec3& up) {
        for (std::size_t k = 0; k < outline_angles; ++k) {
            const double a = steepest_tangent * (2.0 * double(k) / (outline_angles - 1) - 1);
            tangent_[k] = std::tan(a);
            reach_[k] = support(profile, std::sin(a) * across - std::cos(a) * up) / std::cos(a);
        }
    }

    double low(double at) const {
        double y = -infinity;
        for (std::size_t k = 0; k < outline_angles; ++k)
            y = std::max(y, at * tangent_[k] - reach_[k]);
        return y;
    }

private:
    std::array<double, outline_angles> tangent_{}, reach_{};
};

} // namespace

double ridge(const CutterProfile& profile, const Vec3& apart, const Vec3& travel) {
    const Vec3 across = apart - apart.dot(travel) * travel;
    const double width = across.norm();
    if (width == 0) return 0;
    const AptCutter& c = profile.cutter();
    if (c.r == profile.max_radius()) {
        // A ball touches wherever it is asked to.
        const double half = 0.5 * width;
        return half < c.r ? c.r - std::sqrt(c.r * c.r - half * half) : c.r;
    }
    const Vec3 x = across / width;
    Vec3 up = travel.cross(x);
    if (up.z() < 0) up = -up;
    const Outline outline(profile, x, up);
    // The crossing of both outlines: the near one rises, the other falls.
    double lo = -4 * profile.max_radius(), hi = 4 * profile.max_radius() + width;
    for (int i = 0; i < crossing_halvings; ++i) {
        const double mid = 0.5 * (lo + hi);
        (outline.low(mid) < outline.low(mid - width) ? lo : hi) = mid;
    }
    return std::max(0.0, outline.low(hi) + support(profile, -up));
}

} // namespace facetmill
