// The part of a cutter that meets a mesh when it comes down its axis, in the form the kernels want. The
// height g(rho) of the lower surface above the tip is convex and never falls with the distance rho from the
// axis, and it ends at the largest radius. The lift over a point q at distance rho is z(q) - g(rho); over an
// edge or a facet it is the largest of these, and because g is convex it is the maximum of a concave
// function.
#pragma once

#include "core/cutter/cutter.h"
#include "core/gouge/surface_table.h"

namespace facetmill {

/// The lower surface of a cutter, mm. Throws Error(internal) for more than max_surface_pieces.
SurfaceTable lower_surface(const CutterProfile& profile);

} // namespace facetmill
