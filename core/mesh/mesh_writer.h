// Meshes as files of any format that can be written: binary STL, 3MF (core specification 1.3; colours by the
// materials extension 1.2) and binary PLY. What a format has no place for is left out: STL and 3MF hold no
// values, STL no colours between the corners of a facet.
//
//     save_mesh(*part, "part.3mf", {.unit = LengthUnit::inch, .name = "Part"}, progress);
//     save_mesh(surface, "deviation.ply", {.values = deviation, .colors = colors}, progress);
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/mesh.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// Red, green and blue of a vertex.
using VertexColor = std::array<std::uint8_t, 3>;

/// What is written beside the mesh. Spans must outlive the call; each is empty or has one for every vertex of
/// the mesh.
struct MeshWriting {
    LengthUnit unit = LengthUnit::mm;     ///< of the file's numbers; 3MF states it (inches for feet), STL and
                                          ///< PLY say it in a remark
    std::string name;                     ///< of the object (3MF)
    std::string value_name = "deviation"; ///< of the property that holds the values (PLY): letters and '_'
    std::span<const float> values;        ///< mm, written in `unit`; PLY only
    /// PLY and 3MF by vertex; STL by facet, as VisCAM has it: 5 bits each for red, green and blue.
    std::span<const VertexColor> colors;
};

struct MeshFileKind {
    std::string_view name;      ///< "3MF"
    std::string_view extension; ///< ".3mf"
    bool holds_values = false;
};
/// The kinds of files that are written, the commonest first.
std::span<const MeshFileKind> mesh_file_kinds();
/// By the extension of a file's name, in whichever case; STL where it has none. Throws
/// Error(unsupported_format) for any other, before a long job.
const MeshFileKind& mesh_file_kind(const std::filesystem::path& path);

/// Into an output that the caller commits; its name decides the format. Millimetres in. PLY holds 64-bit
/// numbers where 32 bits would lose some, 3MF the shortest text that reads back to the same number. The same
/// mesh gives the same bytes. A 3MF file is built in memory: about 100 bytes a facet. Throws
/// Error(unsupported_format, unwritable, no_facets, non_finite, coordinate_range, too_large), and
/// Error(out_of_range) where values or colours do not fit the mesh.
void write_mesh(const Mesh& mesh, OutputFile& file, const MeshWriting& writing, const Progress& progress);

/// The same as a file that appears complete or not at all.
void save_mesh(const Mesh& mesh, const std::filesystem::path& path, const MeshWriting& writing,
               const Progress& progress);

namespace detail {

void write_ply(const Mesh& mesh, OutputFile& file, const MeshWriting& writing, const Progress& progress);
void write_3mf(const Mesh& mesh, OutputFile& file, const MeshWriting& writing, const Progress& progress);

/// Throws Error(non_finite, coordinate_range) for a vertex that no file takes.
void check_vertex(const Vec3& vertex, std::size_t number, const OutputFile& file);

} // namespace detail

} // namespace facetmill
