// Whether the tool comes to a place of the surface by some axis of an operation, and if by none, what is in
// the way.
#pragma once

#include "core/gouge/tool_lift.h"
#include "core/setup/kinematics.h"
#include "core/strategy/five_axis/finish5.h"

#include <vector>

namespace facetmill {

/// What keeps the tool from a place, the nearest to being mended first.
enum class ReachBlock {
    none,
    machine, ///< part and tool have room, the machine does not hold the axis or go there
    holder,  ///< the cutter has room, a section of the holder has not
    shank,
    cutter, ///< the part is in the cutter's way
    below,  ///< no axis that may be taken leans so far from the normal
};

class AxisReach {
public:
    AxisReach(const PlanContext& context, const Finish5Settings& settings);

    struct Found {
        bool reached = false;
        bool far = false; ///< by leads above the upper limit only, up to `reach_lead`
        ReachBlock block = ReachBlock::none;
    };
    /// Whether the tool touches a place of the part somewhere within the lead limits or up to `reach_lead`,
    /// turned any way, where the machine holds it and nothing is cut deeper than the cusp that may stay.
    Found at(const Vec3& place, const Vec3& normal, ToolLift::Hint& hint) const;

    double widest_lead() const; ///< radians
    /// Whether a surface of this normal faces down too steeply for any axis.
    bool too_low(const Vec3& normal) const;

private:
    ReachBlock block(const ToolPose& pose) const;

    const Finish5Settings& settings_;
    double allowance_, cusp_;
    ToolLift lift_, cutter_alone_;
    Kinematics kinematics_;
    std::vector<double> within_, beyond_; ///< leads that are tried
};

} // namespace facetmill
