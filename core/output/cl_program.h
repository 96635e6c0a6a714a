// The neutral CL program: what writers and posts read, and what the reader of foreign APT files makes.
#pragma once

#include "core/base/units.h"
#include "core/cutter/cutter.h"
#include "core/setup/motion.h"

#include <string>
#include <vector>

namespace facetmill {

struct ClProgram {
    std::string part_name = "PART", operation_name;
    LengthUnit unit = LengthUnit::mm; ///< unit of the file; the values here are mm
    long tool_number = 1;
    std::string tool_name;
    AptCutter cutter;
    double feed_mm_per_min = 1000, spindle_rpm = 1000;
    bool multi_axis = false;
    double gauge_length = 0; ///< from tip to spindle nose; 0 where it is not known
    Box3 part_box;           ///< of the part that is cut; empty where it is not known
    ToolMotions motions;
};

} // namespace facetmill
