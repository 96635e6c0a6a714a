// A tool of a list, with a shank as wide as its cutter.
#pragma once

#include "core/setup/tool.h"

#include <string>

namespace facetmill::test {

inline Tool listed_tool(long number, double diameter, double corner) {
    Tool t;
    t.number = number;
    t.name = "T" + std::to_string(number);
    t.diameter = t.shank_diameter = diameter;
    t.corner_radius = corner;
    return t;
}

} // namespace facetmill::test
