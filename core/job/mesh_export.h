// What a verification found as a mesh, for files that other programs read (core/mesh/mesh_writer.h).
#pragma once

#include "core/mesh/mesh.h"
#include "core/verify/verify.h"

namespace facetmill {

/// The surface that deviations are told on: vertex i is sample i. Millimetres, in the coordinates of the
/// verification.
Mesh deviation_mesh(const DeviationSurface& surface);

} // namespace facetmill
