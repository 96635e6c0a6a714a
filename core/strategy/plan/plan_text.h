// Lengths and places as the messages of a plan give them: in the unit of the project.
#pragma once

#include "core/base/units.h"
#include "core/base/vec.h"

namespace facetmill {

struct PlanText {
    LengthUnit unit = LengthUnit::mm;
    Mat3 to_setup = Mat3::Identity(); ///< of places

    /// "1.143 mm".
    std::string operator()(double mm) const;
    /// "(1, 2.5, -3) mm".
    std::string operator()(const Vec3& place) const;
};

/// "12 %": how much of the whole a part is; never 0 of what is there.
std::string share_text(double part, double whole);

} // namespace facetmill
