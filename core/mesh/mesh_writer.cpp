#include "core/mesh/mesh_writer.h"

#include "core/base/error.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/mesh_reader.h"

#include <cmath>
#include <limits>

namespace facetmill {

namespace {

constexpr std::size_t facets_per_report = 16384;

constexpr std::array<MeshFileKind, 3> file_kinds{{{"STL", ".stl"}, {"3MF", ".3mf"}, {"PLY", ".ply", true}}};

/// Five bits each, and one that says that they count.
std::uint16_t stl_color(const MeshWriting& writing, const Facet& facet) {
    std::array<unsigned, 3> mean{};
    for (std::size_t i = 0; i < mean.size(); ++i) {
        unsigned sum = 0;
        for (const Index v : facet)
            sum += writing.colors[v][i];
        mean[i] = (sum / 3) >> 3;
    }
    return std::uint16_t(0x8000u | mean[0] << 10 | mean[1] << 5 | mean[2]);
}

void write_colored_stl(const Mesh& mesh, OutputFile& file, const MeshWriting& writing,
                       const Progress& progress) {
    StlStream stl(file, writing.unit);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % facets_per_report == 0) progress.set(double(f) / double(mesh.facet_count()));
        stl.add(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2), stl_color(writing, mesh.facets[f]));
    }
    stl.finish();
    progress.check();
}

} // namespace

std::span<const MeshFileKind> mesh_file_kinds() {
    return file_kinds;
}

const MeshFileKind& mesh_file_kind(const std::filesystem::path& path) {
    const std::string extension = detail::lower_extension(path.filename().string());
    if (extension.empty()) return file_kinds.front();
    for (const MeshFileKind& kind : file_kinds)
        if (extension == kind.extension) return kind;
    throw Error(ErrorCode::unsupported_format, printable(path.string(), 400),
                "meshes are not written as " + printable(extension.substr(1), 40) + " files",
                "let the name end in .stl, .3mf or .ply");
}

void write_mesh(const Mesh& mesh, OutputFile& file, const MeshWriting& writing, const Progress& progress) {
    const std::string name = printable(file.target().string(), 400);
    const MeshFileKind& kind = mesh_file_kind(file.target());
    if (mesh.facets.empty())
        throw Error(ErrorCode::no_facets, name, "the mesh to write has no facet", "nothing was written");
    for (const std::size_t count : {writing.values.size(), writing.colors.size()})
        if (count > 0 && count != mesh.vertices.size())
            throw Error(ErrorCode::out_of_range, name,
                        std::to_string(count) + " values or colours do not fit "
                            + std::to_string(mesh.vertices.size()) + " vertices",
                        "give one for each vertex, or none");
    if (kind.name == "PLY")
        detail::write_ply(mesh, file, writing, progress);
    else if (kind.name == "3MF")
        detail::write_3mf(mesh, file, writing, progress);
    else if (writing.colors.empty())
        write_stl(mesh, file, writing.unit, progress);
    else
        write_colored_stl(mesh, file, writing, progress);
}

void save_mesh(const Mesh& mesh, const std::filesystem::path& path, const MeshWriting& writing,
               const Progress& progress) {
    mesh_file_kind(path);
    OutputFile file(path);
    write_mesh(mesh, file, writing, progress);
    file.commit();
}

namespace detail {

void check_vertex(const Vec3& vertex, std::size_t number, const OutputFile& file) {
    if (vertex.allFinite() && vertex.cwiseAbs().maxCoeff() <= double(std::numeric_limits<float>::max()))
        return;
    throw Error(vertex.allFinite() ? ErrorCode::coordinate_range : ErrorCode::non_finite,
                printable(file.target().string(), 400) + ", vertex " + std::to_string(number),
                "it cannot be written as a number", "nothing was written");
}

} // namespace detail

} // namespace facetmill
