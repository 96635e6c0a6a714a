// The assumed previous path, AP-CM2 (Wang 3.1, 3.2): what curvature-matched machining with a large lead limit
// would do on drive planes over the part, as far as one has to know it to see where a smaller limit alpha_M
// leaves material: per contact point the tool axis, the normal and the lead between them (9).
//
// Lead. Wang takes the lead of the matched curvature, sin(alpha) = kappa D / 2 (4)-(6); (5) is printed
// with absolute curvatures, where Euler's formula wants them signed, and (8) calls the lead by the name of
// the angle theta of (5). Here the lead is the smallest at which the tool itself touches without cutting into
// the part, up to `assumed_lead_limit`. Over a surface that curves alike all around the contact that is
// Wang's value for the hollower direction. Near walls and at the ends of hollows, where no curvature tells,
// it is still right.
//
// Boundary points. P_i is the last contact with a lead within alpha_M before the tool enters an uncut place,
// P_o the first after it (Wang's Fig. 3 swaps the two between caption and text); both are moved to where the
// lead, linear between contacts, passes alpha_M. At the part's side (Fig. 6) the end of the trajectory is
// taken instead.
//
// Motion directions (10), (11): forward where the angle between V x F and V x M is below 90 degrees, M from
// P_i to P_o, or from the trajectory's start to its end. Pairs whose direction is not that of their
// trajectory are irregular and give no points of boundary curves; their material is uncut all the same.
#pragma once

#include "core/strategy/five_axis/five_axis_field.h"
#include "core/strategy/surface/region_field.h"

#include <vector>

namespace facetmill {

/// One contact of the assumed path: an entry of Wang's MyTotalToolPath, whose names stand beside.
struct AssumedContact {
    Vec3 axis, point, normal;       ///< LocalAxis, ContactPoint, ContactNormal
    int trajectory = 0;             ///< ToolPathNb
    std::size_t start = 0, end = 0; ///< numbers of the first and the last contact of the trajectory
    double lead = 0;                ///< (9), radians; +inf where even the limit is not enough
    double hollowness = 0;          ///< the part's, across the travel, 1/mm; below 0 where it is round
    double s = 0;                   ///< length along the trajectory's line, from where the tool starts, mm
};

struct AssumedPath {
    std::vector<AssumedContact> contacts; ///< trajectory by trajectory, in the order of travel
    double spacing = 0;                   ///< between trajectories, and between contacts at most; mm
    double direction = 0;                 ///< travel's angle from X, radians
    Vec3 travel = Vec3::UnitX();          ///< unit, level
};

/// Trajectories `spacing` apart over the whole part of the field, to and fro. The lead limit is the upper one
/// of the field's settings. Throws Error(limit_exceeded) for a part that is far too large for its tools.
AssumedPath assume_path(const FiveAxisField& field, double spacing, const Progress& progress);

enum class MotionDirection : std::uint8_t { forward, backward };

/// (10), (11). `view` and `machining` are of any length above 0 and not parallel.
MotionDirection motion_direction(const Vec3& view, const Vec3& machining, const Vec3& motion);

/// Where one trajectory crosses an uncut place.
struct BoundaryPair {
    int trajectory = 0;
    Vec3 in, out;               ///< P_i and P_o
    Vec3 in_offset, out_offset; ///< P_b (12)-(14); at the part's side as P_i and P_o
    bool in_at_side = false, out_at_side = false;
    MotionDirection motion = MotionDirection::forward; ///< (10)
    bool regular = true;                               ///< its direction is its trajectory's (11)
    bool effective = false;                            ///< gives points of the region's two major curves
    std::size_t region = std::size_t(-1);
};

struct ScreenedPath {
    std::vector<BoundaryPair> pairs; ///< in the order of travel
    std::vector<UncutPlace> uncut;   ///< contacts and boundary points of all pairs, irregular ones too
};

/// Screening by `lead_limit`. `offset`: how far outside the uncut place P_b lies, along the trajectory.
ScreenedPath screen(const AssumedPath& path, double lead_limit, double offset, const Vec3& view,
                    const Vec3& machining, const Progress& progress);

/// (12)-(14): the place at `offset` along the polyline, from its first point on; its end where it is shorter.
Vec3 offset_along(std::span<const Vec3> polyline, double offset);

/// Gives each pair the number of its region, and marks the effective ones: the outermost boundary points of
/// every trajectory in every region.
void assign_pairs(const ReworkRegions& regions, std::vector<BoundaryPair>& pairs, const Progress& progress);

} // namespace facetmill
