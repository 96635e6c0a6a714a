// The generalized APT cutter (Lu Fig. 3-14, equations 3.34-3.52, corrected): a convex body of revolution
// about the tool axis. Its profile is a curve in the half-plane (rho, z): rho >= 0 the distance from the
// axis, z the height above the tip, tip at (0, 0). Letters as in APT's CUTTER/d,r,e,f,a,b,h:
//
//   d      diameter: twice the radius at which the bottom line and the side line meet (with no corner
//   rounding) r      corner radius e, f   centre (rho = e, z = f) of the corner circle alpha  bottom angle:
//   from a radial line through the tip up to the bottom line; 0 <= alpha < 90 deg beta   side (taper) angle:
//   from the axis to the side line, positive when the cutter widens upward; -90 < beta < 90 h      height of
//   the cutting part
//
// Millimetres and radians. Lu's beta_1 is alpha, his beta_2 is beta, his L_C is h; his R is the radius at
// height h. We keep APT's d, which does not move when a tool is made longer; for a cylindrical tool d is 2 R.
//
// Corrections to Lu, all rebuilt from tangency: 3.38 first line and 3.42 (the side runs at beta, not at
// alpha), 3.43 (slope tan(beta)), 3.47 (the torus is centred at height f), 3.50-3.52 (the bottom is z = rho
// tan(alpha)).
#pragma once

#include "core/base/vec.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct AptCutter {
    double d = 10, r = 0, e = 5, f = 0, alpha = 0, beta = 0, h = 50;

    /// e and f by tangency from d, r, alpha, beta (a flat end when r = 0, a ball when r = d/2 and alpha =
    /// beta = 0). Throws Error(out_of_range), whose place is the letter, when no convex cutter has these
    /// values.
    static AptCutter from_shape(double d, double r, double alpha, double beta, double h);
    static AptCutter ball(double d, double h) { return from_shape(d, d / 2, 0, 0, h); }
    static AptCutter flat(double d, double h) { return from_shape(d, 0, 0, 0, h); }
    static AptCutter bull(double d, double r, double h) { return from_shape(d, r, 0, 0, h); }
    /// A cone whose side makes `half_angle` with the axis and whose top has diameter d; the height follows.
    static AptCutter cone(double d, double half_angle);
    /// A ball of radius r that continues tangentially into a side at beta; d follows.
    static AptCutter tapered_ball(double r, double beta, double h);

    /// The largest corner radius that fits: with it the corner circle touches the bottom line at the tip.
    /// +inf where bottom and side are one line.
    static double largest_corner_radius(double d, double alpha, double beta);

    bool operator==(const AptCutter&) const = default;
};

/// Height of a cutter that is described without one: longer than any part is deep.
inline constexpr double unlimited_height = 1e5;

/// "ball:D", "flat:D", "bull:D,r", "cone:D,half_angle_deg", "apt:d,r,e,f,alpha_deg,beta_deg,h"; lengths times
/// `mm_per_unit`. Where no height is given it is `unlimited_height`. Throws Error(syntax or out_of_range),
/// also when the values make no convex cutter.
AptCutter parse_cutter(std::string_view text, double mm_per_unit);

/// One smooth piece of the profile: a line or a circular arc, run from the axis outward and upward. Heights
/// never decrease along it; neither do radii, except above the largest radius of the cutter: there (side line
/// of negative taper, arc above its centre) they never increase. No arc crosses the height of its centre.
struct ProfilePiece {
    enum class Kind { line, arc };
    Kind kind = Kind::line;
    Vec2 from, to;              ///< (rho, z)
    Vec2 center = Vec2::Zero(); ///< arc only
    double radius = 0;          ///< arc only

    /// Angle of the tangent from the outward radial direction, 0 to pi, at the two ends.
    double angle_at_start() const;
    double angle_at_end() const;
};

/// The lower-right boundary of a convex body of revolution, from the tip (0, 0) to its highest point. Pieces
/// join; at a joint the slope may jump (always to the steeper side: convex).
///
/// The body is what lies above the bottom line, inside the side line and inside the corner circle where that
/// rounds the corner. e and f need not be tangent, as long as the circle meets both lines: the joints then
/// have a kink. With r = 0 there is no circle, and e and f must be 0 or the corner. A circle that misses a
/// line by no more than tolerance::cutter_tangency (rounding in a CL file) is made tangent. A cutter shorter
/// than its corner ends there.
///
/// Throws Error(out_of_range), whose place is the letter of the value, where the cutter is not convex, has no
/// extent, or a value is not finite.
class CutterProfile {
public:
    explicit CutterProfile(const AptCutter& cutter);

    /// The set of all points within `allowance` >= 0 of this body, again a convex body of revolution: lines
    /// move outward, arcs grow by the allowance, joints with a kink (and the rim at the top, and a pointed
    /// tip) become arcs of that radius. Its tip, again (0, 0), lies `allowance` below the tip of this body.
    /// `cutter()` of the result is that of this profile. Throws Error(out_of_range) for a negative or
    /// non-finite allowance.
    CutterProfile grown(double allowance) const;

    const AptCutter& cutter() const { return cutter_; }
    const std::vector<ProfilePiece>& pieces() const { return pieces_; }
    /// The leading pieces, up to the largest radius: all that meets the part when the cutter comes down its
    /// axis. A vertical side is not among them.
    std::span<const ProfilePiece> lower_pieces() const { return {pieces_.data(), lower_count_}; }
    double max_radius() const { return max_radius_; }
    double height() const { return height_; }
    /// Height of the lower surface at distance rho from the axis; +inf beyond max_radius().
    double height_at(double rho) const;
    /// Largest radius of the cutter at height z: 0 below the tip, that of the top above the height.
    double radius_at(double z) const;

private:
    CutterProfile() = default;
    void finish();

    AptCutter cutter_;
    std::vector<ProfilePiece> pieces_;
    std::size_t lower_count_ = 0;
    double max_radius_ = 0, height_ = 0;
};

} // namespace facetmill
