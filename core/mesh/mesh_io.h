// Meshes in and out. Readers of our own for every format of mesh_format.h but those of surfaces; see
// mesh_report.h for what is checked. Units: most files have none; the reading says how to take them, and the
// result is mm. A picture is read as a relief: an open sheet over the rectangle from the origin to (width,
// length), its outside up.
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_reading.h"
#include "core/mesh/mesh_report.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct LoadedMesh {
    /// Welded (exactly equal corners are one vertex, numbered by first occurrence in the file), millimetres.
    /// Degenerate facets are left out, duplicate ones kept; the rest stands in the order of the file with its
    /// winding, also where the report says inside_out: nothing is turned or healed.
    std::shared_ptr<const Mesh> mesh;
    /// Number of the face of the file that each facet of the mesh lies on; null for formats without faces.
    std::shared_ptr<const std::vector<Index>> faces;
    MeshReport report; ///< lengths in the file's own unit numbers where the field says so
};

/// The extension names the format (mesh_format.h); a file with another content is refused. Without a known
/// extension the content decides. A vertex that is not finite or far away, a file that was cut, text that is
/// not quite the format: all are errors (see ErrorCode, "files") whose place names the file and the line,
/// facet or vertex. Nothing is guessed but what a word in the report's warnings tells.
LoadedMesh load_mesh(const std::filesystem::path& path, const MeshReading& reading, const Progress& progress);
/// The same from memory; `name` stands for the path in messages and decides by its extension where content
/// does not.
LoadedMesh read_mesh(std::string_view bytes, const std::string& name, const MeshReading& reading,
                     const Progress& progress);

/// Binary STL (float, little endian, header never starting with "solid"), coordinates divided by
/// mm_per(unit). Throws Error(unwritable, no_facets, non_finite, coordinate_range, too_large); the file
/// appears complete or not at all.
void save_stl(const Mesh& mesh, const std::filesystem::path& path, LengthUnit unit, const Progress& progress);
/// A binary STL as save_stl writes it, facet by facet, for surfaces that are never in memory as a whole. The
/// caller commits the output after `finish`. Throws as save_stl, but takes no facets as well.
class StlStream {
public:
    StlStream(OutputFile& file, LengthUnit unit);
    /// Counter-clockwise seen from outside; mm. A facet without area has the normal 0. `attribute`: the two
    /// bytes behind each facet, which nothing is agreed on for.
    void add(const Vec3& a, const Vec3& b, const Vec3& c, std::uint16_t attribute = 0);
    /// Puts the number of facets in its place.
    void finish();

private:
    void flush();
    OutputFile* file_;
    std::string name_;
    double mm_;
    std::uint64_t count_ = 0;
    std::vector<char> buffer_;
};

/// The same into an output that the caller commits.
void write_stl(const Mesh& mesh, OutputFile& file, LengthUnit unit, const Progress& progress);

} // namespace facetmill
