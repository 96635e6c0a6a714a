// How the numbers of a mesh file become a body in its place, in this order: unit, scale, mirror, rotate,
// translate. Part and stock describe it alike.
#pragma once

#include "core/base/parameter.h"
#include "core/base/vec.h"

#include <array>

namespace facetmill {

/// One coordinate changes its sign.
enum class Mirror { none, x, y, z };

/// Where a body is, as a project says it: a point p of the file, scaled, comes to rotate * mirror * p +
/// translate.
struct Placement {
    Mirror mirror = Mirror::none;
    std::array<double, 3> rotate{0, 0, 0}; ///< radians about X, then Y, then Z (fixed axes)
    std::array<double, 3> translate{0, 0, 0};
    bool operator==(const Placement&) const = default;
};

/// That of a part or of a stock's mesh.
template <class Spec>
Placement placement_of(const Spec& spec) {
    return {spec.mirror, spec.rotate, spec.translate};
}

Mat3 rotation_of(const std::array<double, 3>& rotate);
/// Angles that `rotation_of` makes this turn of, each written with ten decimals of a degree at most: quarter
/// turns are quarter turns.
std::array<double, 3> angles_of(const Mat3& rotation);

// The body as it stands, moved on. Lengths are rounded to a millionth of a micrometre.
Placement turned(const Placement& placement, const Mat3& turn, const Vec3& about);
Placement moved(const Placement& placement, const Vec3& by);
/// At the plane where coordinate `axis` is `at`.
Placement mirrored(const Placement& placement, int axis, double at);

/// A choice of the unit of a mesh file's numbers.
ParameterInfo mesh_unit_parameter();
/// `what`: "part" or "stock's mesh".
ParameterInfo scale_parameter(const std::string& what);
ParameterInfo mirror_parameter(const std::string& what);
ParameterInfo rotate_parameter(std::string help);
ParameterInfo translate_parameter(std::string help);

} // namespace facetmill
