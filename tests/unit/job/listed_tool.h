// Tools of a list, with a shank as wide as their cutters, and what operations say of them.
#pragma once

#include "core/setup/tool.h"
#include "core/strategy/plan/operation.h"

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

inline double number_of(const Operation& o, const char* key) {
    return std::get<double>(o.get(key));
}

} // namespace facetmill::test
