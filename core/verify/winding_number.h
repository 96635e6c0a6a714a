// How often a mesh winds about a point.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace facetmill {

/// 1 inside of a closed mesh, 0 outside; of an open one a share of it (Jacobson, Kavan, Sorkine-Hornung,
/// "Robust inside-outside segmentation using generalized winding numbers", 2013). Asks every facet.
double winding_number(const Mesh& mesh, const Vec3& p, const Progress& progress);

} // namespace facetmill
