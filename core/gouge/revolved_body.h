// A convex body of revolution about the z axis of its own frame, closed at the top: the cutting part of a
// tool with its full height, or a shank or holder section. For lifts along any vector (vector_lift.h), which
// meet the side, the upper half and the top as well as the lower surface.
//
// Its profile is a chain in the half-plane (rho, z) from the lowest point of the axis outward, up and back to
// the axis; along it the outward normal turns from (0, -1) to (0, 1).
#pragma once

#include "core/cutter/cutter.h"

#include <span>
#include <vector>

namespace facetmill {

/// Lengths in mm.
class RevolvedBody {
public:
    /// The body of `profile` raised by `height` along its axis. Throws Error(internal) for more than
    /// max_pieces.
    explicit RevolvedBody(const CutterProfile& profile, double height = 0);

    /// More pieces than any cutter or section has, grown by an allowance: the search has room for them.
    static constexpr std::size_t max_pieces = 12;

    /// A line or an arc of the chain. Unit normals, outward, (rho, z); those of an arc turn by at most 90
    /// degrees from the one at its start to the one at its end.
    struct Piece {
        bool arc = false;
        double rho0 = 0, z0 = 0, rho1 = 0, z1 = 0;
        double e = 0, f = 0, r = 0;                ///< arc only: centre and radius
        double nr0 = 0, nz0 = 0, nr1 = 0, nz1 = 0; ///< normals at the ends; equal on a line
        double g0 = 0, g1 = 0;                     ///< dz/drho of a line that is not upright; unused else
        bool level() const { return !arc && nr0 == 0; }
    };
    /// Where two pieces join, or the chain meets the axis: a circle of the body's surface, rho = 0 for a
    /// point.
    struct Circle {
        double rho = 0, z = 0;
        unsigned piece = 0; ///< the piece below
    };
    /// The pieces as in the profile, then the flat top (when the body has one).
    std::span<const Piece> pieces() const { return pieces_; }
    std::span<const Circle> circles() const { return circles_; }
    double max_radius() const { return max_radius_; }
    double bottom() const { return bottom_; }
    double top() const { return top_; }

    /// A point of the chain farthest in direction (mr >= 0, mz), of any length above 0.
    struct Support {
        double rho = 0, z = 0;
        unsigned piece = 0;
    };
    Support support(double mr, double mz) const;
    /// Support function: the largest m . p over all points p of the body.
    double extent(const Vec3& m) const;

    /// Outward unit normal of a piece at a point of it; on the axis one of its normals there.
    Vec3 normal(unsigned piece, const Vec3& p) const;

    /// Radius at a height from bottom() to top(), and the piece there.
    struct Section {
        double rho = 0;
        unsigned piece = 0;
    };
    Section section(double z) const;
    /// Lowest and highest point at a distance rho <= max_radius() from the axis.
    Support lowest(double rho) const;
    Support highest(double rho) const;

private:
    double on_piece(const Piece& piece, double rho, bool lower) const;

    std::vector<Piece> pieces_;
    std::vector<Circle> circles_;
    double max_radius_ = 0, bottom_ = 0, top_ = 0;
};

} // namespace facetmill
