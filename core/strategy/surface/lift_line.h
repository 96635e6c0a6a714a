// Tip heights along a straight line seen from above, as a polyline that neither gouges nor leaves more than
// it may.
#pragma once

#include "core/gouge/axial_lift.h"

#include <vector>

namespace facetmill {

class HolderReach;

/// The axial lift, held up by a floor: where the cutter would fall past the part it stays at the floor.
struct LiftField {
    const AxialLift* lift = nullptr;
    double floor = -infinity;
    const HolderReach* bodies = nullptr; ///< may lift the tool farther
    double tip_z(const Vec2& p) const {
        LiftHint hint;
        return tip_z(p, hint);
    }
    double tip_z(const Vec2& p, LiftHint& hint) const;
    /// The same for many places.
    void tip_z(std::span<const Vec2> places, std::span<double> heights, const Progress& progress) const;
};

struct LinePoint {
    double s = 0; ///< along the line
    double z = 0; ///< tip height
};

struct LineTolerance {
    double spacing = 1;  ///< the lift is looked at at least this often along the line
    double below = 0.01; ///< how far the polyline may run below the lift, measured across it (gouge)
    double above = 0.01; ///< how far above
    /// Shorter pieces are not divided; a jump that is left over becomes an upright move on its low side.
    double shortest() const { return 0.25 * std::min(below, above); }
};

/// The spacing at which nothing can be missed: a cutter whose profile curves with radius r where it touches
/// passes any point of the part on a curve with at least that radius, so between two places looked at, a
/// chord of length c lies below the lift by at most c^2 / 8r, whatever is between. With r = 0 it is the
/// roundness of the rim (radius R, seen from above) that gives the bound, sideways; the kinks that are left
/// are found by halving. The side of a tapered cutter is as round as its inner rim. A pointed cone is not
/// round at all: there the spacing is so small that what lies hidden between two places is.
double safe_spacing(const CutterProfile& profile, double below);

/// Points on the line origin + s * direction for s0 <= s <= s1, both ends included, s never falling. All of
/// them are on the lift (but for corners of upright moves, which are above it), close enough that between
/// neighbours the tolerances hold.
std::vector<LinePoint> lift_line(const LiftField& field, const Vec2& origin, const Vec2& direction, double s0,
                                 double s1, const LineTolerance& tolerance, const Progress& progress);

/// Leaves out points that the polyline through the others passes at a height of at most `below` below or
/// `above` above them. Keeps both ends.
std::vector<LinePoint> thinned(const std::vector<LinePoint>& line, double below, double above);

} // namespace facetmill
