// Axial lift of a cutter over a curve instead of a mesh: how far the cutter may retreat along its axis and
// still hold a point of the curve. The top surface of the configuration space (Lu 3.5.5.2) for curves that
// have to be cleared.
//
// The cutter at lift s holds a point q that is at height z(q) above its tip and at distance rho(q) from its
// axis as long as g(rho) <= z - s <= height of the flutes. So the largest s is the largest z - g(rho), over
// the points within the largest radius: the lift of axial_lift.h, over the edges of a polyline.
#pragma once

#include "core/cutter/cutter.h"
#include "core/setup/tool_pose.h"

#include <memory>
#include <span>

namespace facetmill {

struct SurfaceTable;

/// One cutter. Cheap to make; safe to use from many threads at once. No allocation, no error: points that are
/// not numbers are not met.
class CurveLift {
public:
    /// The segment that was touched last. It makes the answer for a curve much like the last one faster, and
    /// does not change it.
    struct Hint {
        std::uint32_t segment = 0xFFFFFFFFu;
    };

    /// `flutes` (mm): the height above the tip up to which the cutter removes material; where its lower
    /// surface reaches higher, only what is below counts. 0: the cutter's own height. Throws
    /// Error(out_of_range) for a negative one.
    explicit CurveLift(const CutterProfile& cutter, double flutes = 0);

    /// The lift along the axis from the pose (tip in part coordinates, mm; unit axis); -inf when no point of
    /// the polyline is within the largest radius of the axis, or there are no points. One point is a curve;
    /// points may repeat. When the lift is surely above `enough` the answer is any number above it that is no
    /// higher than the lift; where it is not above `least` the answer is `least`, found sooner.
    double lift(const ToolPose& pose, std::span<const Vec3> curve, Hint& hint, double enough = infinity,
                double least = -infinity) const;
    /// Whether the lift is `level` or higher.
    bool reaches(const ToolPose& pose, std::span<const Vec3> curve, Hint& hint, double level) const;
    double lift(const ToolPose& pose, std::span<const Vec3> curve) const;

private:
    std::shared_ptr<const SurfaceTable> surface_;
};

} // namespace facetmill
