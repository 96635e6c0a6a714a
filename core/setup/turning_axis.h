// The axis that a part turns about on a lathe-mill. Millimetres, part coordinates.
#pragma once

#include "core/base/vec.h"

namespace facetmill {

/// How the tool moves from one CL to the next where its axis turns with the part: about this line at a
/// constant rate, along it and towards it in proportion.
struct TurningAxis {
    Vec3 point = Vec3::Zero(), direction = Vec3::UnitX(); ///< unit vector
};

} // namespace facetmill
