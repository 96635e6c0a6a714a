// Areas of a plane, with holes in them, cut into triangles. Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <optional>
#include <vector>

namespace facetmill::detail {

/// `rings` are closed curves through `points`, by number: counter-clockwise round an area, clockwise round a
/// hole in one. No vertex is added, so that what lies beside the rings fits; triangles are counter-clockwise.
/// None where the curves cross themselves or a hole lies in no area.
std::optional<std::vector<Facet>> triangulate_rings(const std::vector<Vec2>& points,
                                                    const std::vector<std::vector<Index>>& rings,
                                                    const Progress& progress);

double ring_area(const std::vector<Vec2>& points, const std::vector<Index>& ring);

} // namespace facetmill::detail
