// The machine as far as 3-axis planning and timing need it. Machines are named in the project file.
#pragma once

#include "core/base/vec.h"

#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct Machine {
    std::string name;   ///< as the project file says: "tarus-tpi-2000"
    std::string label;  ///< as forms say: "Tarus TPI 2000 (5-axis, head-head)"
    Vec3 rapid_mm_per_s = Vec3(170, 180, 240); ///< largest speed of X, Y, Z
};

const std::vector<Machine>& machines();
/// Throws Error(missing_reference) that lists the known names.
const Machine& find_machine(std::string_view name);

} // namespace facetmill
