// What a mesh file held and what was found in it: the honest account that `info` prints and the workbench
// shows.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/mesh.h"

#include <optional>
#include <string>
#include <vector>

namespace facetmill {

/// One of the objects that a file holds, by which one chooses (MeshReading::objects).
struct MeshObject {
    std::string number; ///< as the file counts it
    std::string name;   ///< printable, at most 200 bytes; often empty
    std::size_t facets = 0;
    bool read = false; ///< it is in the mesh
};

/// What a file of surfaces, STEP or IGES, held, and how its facets follow them.
struct SurfaceReport {
    std::string unit;                  ///< as the file names it
    double chord = 0, chord_angle = 0; ///< that were asked for; mm, radians
    double out = 0, in = 0;            ///< how far surfaces lie outside and inside the facets, at most; mm
    std::size_t faces = 0;             ///< numbers of faces go from 0 to below this
    std::size_t solids = 0;            ///< closed shells among them
    std::size_t loose_faces = 0;       ///< of no solid: sheets
    std::size_t missing_faces = 0;     ///< that could not be tessellated
    std::size_t part_count = 0;        ///< different parts of an assembly
    std::vector<std::string> parts;    ///< their names, printable, at most 1000
};

struct MeshReport {
    /// "STL binary", "STL ASCII", "OBJ", "PLY ASCII", "PLY binary", "3MF", "GLB", "glTF", "PNG", "TIFF",
    /// "STEP", "IGES".
    std::string format;
    std::string name;         ///< the solid's name, printable, at most 200 bytes
    std::size_t facets = 0;   ///< triangles in the file, degenerate ones included
    std::size_t vertices = 0; ///< vertices of the mesh
    std::size_t welded_vertices =
        0; ///< distinct corner positions (exactly equal; -0 is 0) of all facets in the file
    std::size_t degenerate =
        0; ///< facets of zero area (equal or exactly collinear corners); left out of the mesh
    // All below: of the mesh, that is without the degenerate facets.
    std::size_t duplicate = 0;             ///< facets whose corner set occurred before (either winding); kept
    std::size_t open_edges = 0;            ///< edges of one facet
    std::size_t non_manifold_edges = 0;    ///< edges of more than two facets
    std::size_t inconsistent_edges = 0;    ///< edges of two facets that run along them in the same direction
    std::size_t shells = 0;                ///< groups of facets joined by edges (also non-manifold ones)
    std::size_t non_manifold_vertices = 0; ///< vertices whose facets form more than one fan
    bool watertight = false;               ///< no open, non-manifold or inconsistent edge
    Box3 file_box;                         ///< of all facets, in the file's own numbers
    /// In the file's own numbers. The volume is the sum over facets of the signed tetrahedra to the origin:
    /// what a closed mesh encloses, signed by its winding; for an open mesh it depends on where the part
    /// lies.
    double file_area = 0.0, file_volume = 0.0;
    LengthUnit assumed_unit = LengthUnit::mm;
    bool unit_known = false;         ///< the file states that unit
    bool is_relief = false;          ///< a picture: an open sheet, as large as the job says
    std::vector<MeshObject> objects; ///< at most `max_listed_objects`; none for formats without such
    std::optional<SurfaceReport> surfaces;
    /// By the largest extent in the file's own numbers: below `guess_metre_below` metres, below
    /// `guess_inch_below` inch, else mm. A guess to show, never acted on: an STL file has no unit.
    LengthUnit unit_guess = LengthUnit::mm;
    /// Stable snake_case words, sorted; each has a sentence in `explain_warning`.
    std::vector<std::string> warnings;

    Box3 box_mm() const;
    double area_mm2() const { return file_area * mm_per(assumed_unit) * mm_per(assumed_unit); }
    double volume_mm3() const {
        return file_volume * mm_per(assumed_unit) * mm_per(assumed_unit) * mm_per(assumed_unit);
    }
};

inline constexpr std::size_t max_listed_objects = 1000;

/// Parts of 10 mm and less are rarer than parts of 10 inch and less.
inline constexpr double guess_inch_below = 10.0;
/// And below this it is more likely metres than inches.
inline constexpr double guess_metre_below = 0.5;

/// "mm", "in" or "m".
std::string units_guess_name(const MeshReport& report);

/// What a scale other than 1 changes in the warnings of a part whose box, in its place, is `box` (mm): that
/// it is scaled, and whether its unit is suspect.
void add_scale_warnings(MeshReport& report, const Box3& box);

/// One sentence for a warning word: what it means and what was done. Empty for a word no reader uses.
std::string explain_warning(const std::string& word);
/// Every word that `explain_warning` knows, sorted.
std::vector<std::string> warning_words();

/// Shells, edges, volume and the like of any mesh without degenerate facets; fills the fields of `report`
/// from `duplicate` on (and facets, vertices, welded_vertices, file_box where they are still 0), and adds the
/// warnings that follow from the geometry: degenerate_facets, duplicate_facets, open_edges,
/// non_manifold_edges, inconsistent_winding, multiple_shells, inside_out, unit_suspect. Lengths are divided
/// by mm_per(report.assumed_unit).
void analyse_mesh(const Mesh& mesh, MeshReport& report, const Progress& progress);

} // namespace facetmill
