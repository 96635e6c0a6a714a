// What a cutter with vertical axis covers: where its tip stands when it touches a plane, and how much it
// leaves standing above a point of the surface. Millimetres; rho is the distance from the axis, z the height
// above the tip.
#pragma once

#include "core/cutter/cutter.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace facetmill {

class CutterCover {
public:
    /// `slack`: a bottom line that stays within this height of a plane counts as lying on it, so that a flat
    /// bottom stands over its contact point, not a radius beside it, on planes that are level but for
    /// rounding.
    CutterCover(const CutterProfile& profile, double slack);

    /// The point (rho, z) of the profile that touches a plane whose unit normal `n` has n.z > 0.
    Vec2 support(const Vec3& n) const;
    /// Tip minus contact point for that plane: the tip stands downhill of the contact.
    Vec3 tip_offset(const Vec3& n) const;

    /// Smallest t for which p + t n lies in the cutter, taken endless upward, with its tip at `tip`;
    /// +infinity when the line passes it by or meets it only beyond `limit`. Negative when the cutter cuts
    /// below p. n is a unit vector, n.z >= 0. This is the height of the material over p, along n, that the
    /// cutter leaves: the cusp (Lu 3.29 measures along the axis of the frame at the contact point, which is
    /// the same direction).
    double ray_entry(const Vec3& p, const Vec3& n, const Vec3& tip, double limit) const {
        const Vec3 d = p - tip;
        double on_ball = infinity;
        if (ball_) { // mostly its lower half is met
            const Vec3 e(d.x(), d.y(), d.z() - radius_);
            const double f = e.dot(n), q = f * f - (e.squaredNorm() - radius_ * radius_);
            if (q >= 0) on_ball = -f - std::sqrt(q);
            if (!(on_ball <= limit)) on_ball = infinity;
            if (on_ball < infinity && e.z() + on_ball * n.z() < 0) return on_ball;
        }
        return ray_entry_above(d, n, limit, on_ball);
    }

    /// True where the cutter, taken endless upward, holds a point, given from the tip.
    bool holds(const Vec3& rel) const;

    /// Distance of a point, given from the tip, to the cutter, taken endless upward; 0 inside.
    double distance(const Vec3& rel) const {
        if (!rounded_disc_) return distance_from_profile(rel);
        // Beside the shaft the axis counts, below it the middle.
        const auto [disc, rounding] = *rounded_disc_;
        const double level = std::sqrt(rel.x() * rel.x() + rel.y() * rel.y()),
                     beside = std::max(level - disc, 0.0), below = std::max(rounding - rel.z(), 0.0);
        return std::max(std::sqrt(beside * beside + below * below) - rounding, 0.0);
    }

    /// Unit normal of the surface that the cutter touches at `rel` (contact minus tip), pointing into the
    /// cutter; nothing at a corner of the profile, where the cutter leaves it open.
    std::optional<Vec3> contact_normal(const Vec3& rel) const;

    /// The outward normal, as long as the radius, at a point on the lower half of a ball, given from the tip;
    /// nothing for another cutter, or higher up.
    std::optional<Vec3> ball_normal(const Vec3& rel) const {
        if (!ball_ || rel.z() >= radius_) return std::nullopt;
        return Vec3(rel.x(), rel.y(), rel.z() - radius_);
    }

    /// A disc about the axis, rounded by a radius: flat ends, bull noses and balls are such.
    struct RoundedDisc {
        double disc, rounding;
    };
    const std::optional<RoundedDisc>& rounded_disc() const { return rounded_disc_; }

    bool has_flat_bottom() const { return flat_radius_ > 0; }
    /// Radius to which the bottom is level within the slack.
    double flat_radius() const { return flat_radius_; }
    double radius() const { return radius_; }
    /// Height of the lowest point at the largest radius.
    double shoulder() const { return shoulder_; }
    const CutterProfile& profile() const { return profile_; }

private:
    double distance_from_profile(const Vec3& rel) const;
    /// The same for a line d + t n, given from the tip, that does not meet the lower half of a ball;
    /// `on_ball`: where it meets the ball, if there is one.
    double ray_entry_above(const Vec3& d, const Vec3& n, double limit, double on_ball) const;

    CutterProfile profile_;
    double slack_, radius_, shoulder_ = 0, flat_radius_ = 0;
    bool ball_ = false;
    std::optional<RoundedDisc> rounded_disc_;
};

} // namespace facetmill
