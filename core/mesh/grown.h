// A mesh that holds all points within a distance of another one: what a tool that keeps the distance must not
// touch. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace facetmill {

/// Facets moved by the distance (> 0) to both sides, and a prism round every edge; the surface of their union
/// is nowhere nearer to the mesh than `by`, and up to a twelfth of it farther, at corners up to three
/// quarters of it. It is no surface of a solid: facets lie within it. About 44 facets for each one of the
/// mesh.
Mesh grown_mesh(const Mesh& mesh, double by, const Progress& progress);

} // namespace facetmill
