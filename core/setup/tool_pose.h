// Where a tool is and how it stands.
#pragma once

#include "core/base/vec.h"

namespace facetmill {

/// Tip and axis of a tool in part coordinates. The axis is a unit vector from the tip to the holder.
struct ToolPose {
    Vec3 tip = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();
};

} // namespace facetmill
