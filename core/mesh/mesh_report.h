// What a mesh file held and what was found in it: the honest account that `info` prints and the workbench shows.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/mesh.h"

#include <string>
#include <vector>

namespace facetmill {

struct MeshReport {
    std::string format; ///< "STL binary", "STL ASCII", "OBJ", "PLY ASCII", "PLY binary"
    std::string name;   ///< the solid's name, printable, at most 200 bytes
    std::size_t facets = 0;          ///< facets in the file, degenerate ones included
    std::size_t welded_vertices = 0; ///< distinct corner positions (exactly equal; -0 is 0) of the non-degenerate facets
    std::size_t degenerate = 0;      ///< facets of zero area (equal or exactly collinear corners); left out of the mesh
    std::size_t duplicate = 0;       ///< facets whose corner set occurred before (either winding); kept
    std::size_t open_edges = 0;      ///< edges of one facet
    std::size_t non_manifold_edges = 0;   ///< edges of more than two facets
    std::size_t inconsistent_edges = 0;   ///< edges of two facets that run along them in the same direction
    std::size_t shells = 0;               ///< groups of facets joined by edges
    std::size_t non_manifold_vertices = 0; ///< vertices whose facets form more than one fan
    bool watertight = false; ///< no open, non-manifold or inconsistent edge
    Box3 file_box;           ///< of all facets, in the file's own numbers
    double file_area = 0.0, file_volume = 0.0; ///< signed by the winding, in the file's own numbers
    LengthUnit assumed_unit = LengthUnit::mm;
    LengthUnit unit_guess = LengthUnit::mm;
    /// Stable snake_case words, sorted: see docs of the readers. Each has a sentence in `explain_warning`.
    std::vector<std::string> warnings;
};

/// One sentence for a warning word: what it means and what was done.
std::string explain_warning(const std::string& word);

/// Shells, edges, volume and the like of any triangle list; fills the topological fields and warnings of `report`.
void analyse_mesh(const Mesh& mesh, MeshReport& report, const Progress& progress);

} // namespace facetmill
