// How the numbers of a mesh file become a body in its place, in this order: unit, scale, mirror, rotate,
// translate. Part and stock describe it alike.
#pragma once

#include "core/base/parameter.h"

namespace facetmill {

/// One coordinate changes its sign.
enum class Mirror { none, x, y, z };

/// A choice of the unit of a mesh file's numbers.
ParameterInfo mesh_unit_parameter();
/// `what`: "part" or "stock's mesh".
ParameterInfo scale_parameter(const std::string& what);
ParameterInfo mirror_parameter(const std::string& what);
ParameterInfo rotate_parameter(std::string help);
ParameterInfo translate_parameter(std::string help);

} // namespace facetmill
