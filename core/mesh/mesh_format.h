// The mesh formats that can be read: one table, from which loading, file dialogs, help and messages derive.
// A new format is a file with its reader and its row, declared at the end here and listed in mesh_format.cpp.
#pragma once

#include "core/base/progress.h"

#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

namespace detail {
struct MeshSource;
struct TriangleSoup;
} // namespace detail

struct MeshFormat {
    std::string_view name;                    ///< "STL"
    std::string_view label;                   ///< with its article, for messages: "an STL file"
    std::vector<std::string_view> extensions; ///< lower case, with the dot; the usual one first
    /// Whether content is of this format, when no extension tells. At most one format says so of any content,
    /// but for text files that are damaged.
    bool (*sniff)(std::string_view bytes);
    /// Throws Error as load_mesh says.
    detail::TriangleSoup (*read)(const detail::MeshSource& source, const Progress& progress);
    bool is_picture = false;   ///< read as a relief, which is as large as the job says
    bool has_objects = false;  ///< files state their unit and hold objects, of which the job chooses
    bool has_surfaces = false; ///< states its unit; facets follow its surfaces as closely as MeshReading says

    /// Whether a job has to say the unit of a file's numbers.
    bool needs_unit() const { return !is_picture && !has_objects && !has_surfaces; }
};

/// The commonest first.
const std::vector<MeshFormat>& mesh_formats();
/// The format of an extension (lower case, with the dot), or null.
const MeshFormat* mesh_format_of(std::string_view extension);
/// The same of a file's name, in whichever case its extension is.
const MeshFormat* mesh_format_named(const std::string& file);
/// "STL, OBJ, PLY", or with `last` = " or ": "STL, OBJ or PLY".
std::string mesh_format_names(std::string_view last = ", ");
/// Those that can hold a closed mesh, which a picture does not: of stock and fixtures.
std::string solid_format_names(std::string_view last = ", ");

namespace detail {

// The rows of the table, each in the file of its reader.
MeshFormat stl_format();
MeshFormat obj_format();
MeshFormat ply_format();
MeshFormat threemf_format();
MeshFormat gltf_format();
MeshFormat png_format();
MeshFormat tiff_format();
MeshFormat step_format();
MeshFormat iges_format();

} // namespace detail

} // namespace facetmill
