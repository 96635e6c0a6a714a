// OpenCAMLib as a peer of the bench, where it was found when the benches were configured.
#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace facetmill {

bool opencamlib_is_here();

/// Drops a ball (diameter, mm) along lines in X over the mesh's box and a radius beside it, `step` apart, by
/// AdaptivePathDropCutter with its own sampling: 0.1 mm, and 0.01 mm where the path is bent. How many places
/// it kept; 0 where it is not here. Its own index of the mesh is part of the work.
double parallel_finish_by_opencamlib(const Mesh& mesh, double diameter, double step);

/// The closed loops of a ball (diameter, mm) at heights of its tip, by Waterline with fibres `sampling` mm
/// apart, or, with a `min_sampling` > 0, by AdaptiveWaterline. Empty where it is not here.
std::vector<std::vector<Vec3>> waterline_by_opencamlib(const Mesh& mesh, double diameter,
                                                       const std::vector<double>& heights, double sampling,
                                                       double min_sampling);

} // namespace facetmill
