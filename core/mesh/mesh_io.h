// Meshes in and out. Readers of our own for STL (binary, ASCII), OBJ and PLY (ASCII, both binary orders); see
// mesh_report.h for what is checked. Units: the files have none; `unit` says how to read them and the result is mm.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_report.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace facetmill {

struct LoadedMesh {
    std::shared_ptr<const Mesh> mesh; ///< welded, millimetres; degenerate facets are left out, counted in the report
    MeshReport report;                ///< lengths in the file's own unit numbers where the field says so
};

/// Reads by content, then by extension. Throws Error (see ErrorCode, "files"); the place names file and line, byte or
/// record. Cancellation within 20 ms.
LoadedMesh load_mesh(const std::filesystem::path& path, LengthUnit unit, const Progress& progress);
/// The same from memory; `name` stands for the path in messages and decides by its extension where content does not.
LoadedMesh read_mesh(std::string_view bytes, const std::string& name, LengthUnit unit, const Progress& progress);

/// Binary STL (float, little endian, header never starting with "solid"), coordinates divided by mm_per(unit). Throws
/// Error(unwritable, coordinate_range, too_large).
void save_stl(const Mesh& mesh, const std::filesystem::path& path, LengthUnit unit, const Progress& progress);

} // namespace facetmill
