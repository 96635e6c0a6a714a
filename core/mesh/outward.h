// Which side of a mesh is outside, whatever its winding says: the one answer that planners and the verifier
// share. Facets that are joined by edges on which their windings agree form a patch, and a patch is turned
// as a whole:
//
//   closed patch   out is where its volume is positive
//   open patch     out is the side that sees the open where the other hardly does (Takayama, Jacobson, Kavan,
//                  Sorkine-Hornung, "A simple method for correcting facet orientations in polygon meshes
//                  based on ray casting", JCGT 3 (4), 2014): rays go from both sides of it in all directions
//   sheet          sees it from both sides: up (+Z) is out, and of an upright one the side that sees more
//   cup            an open patch that is most of the mesh, whose inside hardly sees the open and faces up: a
//                  deep pocket or a vase; what its winding says
//
// A patch that sees the open from neither side is buried: it bounds nothing that a tool could cut.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace facetmill {

struct OutwardSides {
    enum Side : std::uint8_t {
        as_wound, ///< out is where the corners run counter-clockwise
        reversed, ///< out is the other side
        buried,   ///< neither side sees the open
    };
    std::vector<Side> sides; ///< one per facet
    std::size_t turned_facets = 0, buried_facets = 0;
    std::size_t patches = 0;
};

/// Which side of open patches is outside: the one found, or the other one where someone knows better.
enum class OpenSide : std::uint8_t { found, other };

/// Linear in the facets, and for a mesh that is not closed and wound outward some million rays: seconds. The
/// same answer for the same mesh with any number of threads.
OutwardSides outward_sides(const Mesh& mesh, const Progress& progress, OpenSide open = OpenSide::found);

/// The mesh with the facets that `sides` calls reversed wound the other way; the same one where there are
/// none.
MeshPtr wound_outward(const MeshPtr& mesh, const OutwardSides& sides);

} // namespace facetmill
