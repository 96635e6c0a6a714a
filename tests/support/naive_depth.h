// How deep points lie in a tool on its way, by heights and radii alone.
#pragma once

#include "core/output/cl_program.h"
#include "core/setup/tool.h"

#include <vector>

namespace facetmill::test {

/// How deep the deepest of the points comes to lie in cutter, shank or holder (a cylinder), mm; 0: in none.
double deepest(const ClSection& program, const Tool& tool, const std::vector<Vec3>& points);

} // namespace facetmill::test
