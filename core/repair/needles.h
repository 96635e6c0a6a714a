// Needles: facets whose direction is noise.
#pragma once

#include "core/mesh/mesh.h"

namespace facetmill {

/// A facet whose least height is below this share of its longest side is a needle: an angle of about 1°.
inline constexpr double needle_height_share = 0.02;

bool is_needle(const Vec3& a, const Vec3& b, const Vec3& c);
std::size_t count_needles(const Mesh& mesh);

} // namespace facetmill
