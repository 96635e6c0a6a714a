// The ridge between two cutters beside each other. Millimetres.
#pragma once

#include "core/cutter/cutter.h"

namespace facetmill {

/// Height of what stays between two cutters whose tips are `apart`, that both touch a plane and are moved
/// along it, along the unit vector `travel`.
double ridge(const CutterProfile& profile, const Vec3& apart, const Vec3& travel);

} // namespace facetmill
