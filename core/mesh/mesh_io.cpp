#include "core/mesh/mesh_io.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/exact_area.h"
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/stl_records.h"
#include "core/mesh/unused_vertices.h"
#include "core/mesh/weld.h"

#include <cmath>
#include <limits>
#include <new>
#include <optional>

namespace facetmill {

namespace {

using detail::MeshSource;
using detail::TriangleSoup;

constexpr std::string_view foreign_extensions[] = {
    ".amf", ".off",   ".wrl", ".vrml", ".x3d",    ".dae", ".gltf", ".glb", ".fbx",     ".3ds",
    ".dxf", ".dwg",   ".x_t", ".x_b",  ".sldprt", ".ipt", ".prt",  ".sat", ".jt",      ".brep",
    ".3dm", ".blend", ".vtk", ".vtp",  ".zip",    ".gz",  ".nas",  ".vda", ".catpart",
};

std::string unsupported_remedy() {
    return "export the part as " + mesh_format_names(" or ");
}

TriangleSoup read_soup(const MeshSource& source, const std::string& extension, const Progress& progress) {
    if (const MeshFormat* format = mesh_format_of(extension)) return format->read(source, progress);
    for (const std::string_view foreign : foreign_extensions)
        if (extension == foreign)
            throw Error(ErrorCode::unsupported_format, source.name,
                        extension.substr(1) + " files cannot be read", unsupported_remedy());
    for (const MeshFormat& format : mesh_formats())
        if (format.sniff(source.bytes)) return format.read(source, progress);
    const std::string_view what = detail::foreign_content(source.bytes);
    throw Error(ErrorCode::unsupported_format, source.name,
                what.empty() ? "the format is not known" : "is " + std::string(what), unsupported_remedy());
}

/// Joins equal corners and lets the soup's own points go.
detail::WeldedCorners weld(TriangleSoup& soup, std::size_t facet_count, const Progress& progress) {
    detail::WeldedCorners welded;
    if (soup.records)
        welded = detail::weld_corners(
            3 * facet_count, [&](std::size_t c) { return detail::StlRecord(soup, c / 3).corner(c % 3); },
            progress);
    else if (soup.indexed)
        welded = detail::weld_corners(
            3 * facet_count,
            [&](std::size_t c) -> const Vec3& { return soup.points[soup.facets[c / 3][c % 3]]; }, progress);
    else
        welded = detail::weld_corners(3 * facet_count, detail::PieceCorners(soup.pieces), progress);
    soup.pieces = {};
    soup.points = {};
    soup.facets = {};
    return welded;
}

Box3 box_of(const std::vector<Vec3>& points, const Progress& progress) {
    return parallel_reduce(
        points.size(), 65536, Box3{}, progress,
        [&](std::size_t begin, std::size_t end) {
            Box3 box;
            for (std::size_t v = begin; v < end; ++v)
                box.add(points[v]);
            return box;
        },
        [](Box3 total, const Box3& part) {
            total.add(part);
            return total;
        });
}

/// Gives degenerate facets the first vertex no_index and counts them.
std::size_t mark_degenerate(detail::WeldedCorners& welded, const Progress& progress) {
    return parallel_reduce(
        welded.facets.size(), 32768, std::size_t(0), progress,
        [&](std::size_t begin, std::size_t end) {
            std::size_t degenerate = 0;
            for (std::size_t f = begin; f < end; ++f) {
                Facet& facet = welded.facets[f];
                if (facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0]
                    || detail::exactly_collinear(welded.points[facet[0]], welded.points[facet[1]],
                                                 welded.points[facet[2]])) {
                    facet[0] = no_index;
                    ++degenerate;
                }
            }
            return degenerate;
        },
        [](std::size_t a, std::size_t b) { return a + b; });
}

/// The faces of the facets that are not marked.
std::vector<Index> faces_of_rest(const std::vector<Facet>& facets, std::vector<Index> faces) {
    std::size_t next = 0;
    for (std::size_t f = 0; f < facets.size(); ++f)
        if (facets[f][0] != no_index) faces[next++] = faces[f];
    faces.resize(next);
    return faces;
}

/// Removes the marked facets and the vertices that no other facet has; the order of the rest stays.
void remove_marked(Mesh& mesh, const Progress& progress) {
    progress.check();
    std::erase_if(mesh.facets, [](const Facet& f) { return f[0] == no_index; });
    drop_unused_vertices(mesh, progress);
}

/// True where 32-bit floats at the far end of the part are too far apart, mm.
bool floats_are_coarse(const Box3& box, double mm) {
    const double reach = std::max(box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff()) / mm;
    const double step =
        double(std::nextafter(float(reach), std::numeric_limits<float>::infinity()) - float(reach)) * mm;
    return step > tolerance::coarse_float_step;
}

/// Welds, leaves the degenerate facets out and fills the report.
LoadedMesh finish(TriangleSoup& soup, const std::string& name, const MeshReading& reading,
                  const Progress& progress) {
    const LengthUnit unit = soup.unit.value_or(reading.unit.value_or(LengthUnit::mm));
    const double mm = mm_per(unit);
    const std::size_t facet_count = soup.facet_count();
    if (facet_count >= no_index / 3)
        throw Error(ErrorCode::too_large, name, "the mesh has " + std::to_string(facet_count) + " facets",
                    "at most 1.4 thousand million are possible");
    detail::WeldedCorners welded = weld(soup, facet_count, progress.part(0.0, 0.55));

    LoadedMesh loaded;
    MeshReport& report = loaded.report;
    report.format = soup.format;
    report.name = soup.name;
    report.assumed_unit = unit;
    report.unit_known = soup.unit.has_value();
    report.is_relief = soup.is_relief;
    report.objects = std::move(soup.objects);
    report.surfaces = std::move(soup.surfaces);
    if (soup.unit && reading.unit && *soup.unit != *reading.unit) soup.warnings.insert("unit_differs");
    report.facets = facet_count;
    report.welded_vertices = welded.points.size();
    report.file_box = box_of(welded.points, progress.part(0.55, 0.57));
    report.degenerate = mark_degenerate(welded, progress.part(0.57, 0.62));
    if (report.degenerate == facet_count)
        throw Error(ErrorCode::no_facets, name,
                    "none of the " + std::to_string(facet_count) + " facets has an area",
                    "export the part again");
    auto mesh = std::make_shared<Mesh>();
    mesh->facets = std::move(welded.facets);
    mesh->vertices = std::move(welded.points);
    if (!soup.faces.empty())
        loaded.faces =
            std::make_shared<const std::vector<Index>>(faces_of_rest(mesh->facets, std::move(soup.faces)));
    if (report.degenerate > 0) remove_marked(*mesh, progress);
    const Box3 box = report.box_mm();
    if (box.size().maxCoeff() < tolerance::smallest_extent)
        throw Error(ErrorCode::coordinate_range, name,
                    "the whole part is smaller than " + format_number(tolerance::smallest_extent) + " mm",
                    "the file is damaged or in another unit");
    if (mm != 1.0)
        parallel_for(mesh->vertices.size(), 65536, Progress(),
                     [&](std::size_t v) { mesh->vertices[v] *= mm; });

    analyse_mesh(*mesh, report, progress.part(0.62, 1.0));

    if (soup.end_missing && report.open_edges > 0)
        throw Error(ErrorCode::truncated, name,
                    "the word endsolid is missing and the mesh has " + std::to_string(report.open_edges)
                        + " open edges",
                    "the file was cut: copy or export it again");
    if (soup.single_precision && floats_are_coarse(box, mm)) soup.warnings.insert("coarse_resolution");
    report.warnings.insert(report.warnings.end(), soup.warnings.begin(), soup.warnings.end());
    std::sort(report.warnings.begin(), report.warnings.end());
    loaded.mesh = std::move(mesh);
    return loaded;
}

/// `release` lets the file go as soon as nothing is read from it any more: its pages count as memory.
template <class Release>
LoadedMesh read_and_finish(std::string_view bytes, const std::string& name, const MeshReading& reading,
                           const Progress& progress, const Release& release) {
    const LengthUnit unit = reading.unit.value_or(LengthUnit::mm);
    const MeshSource source{bytes, printable(name, 400), tolerance::largest_coordinate / mm_per(unit),
                            reading};
    if (bytes.empty())
        throw Error(ErrorCode::empty_file, source.name, "the file is empty", "export or copy it again");
    try {
        TriangleSoup soup = read_soup(source, detail::lower_extension(name), progress.part(0.0, 0.4));
        if (!soup.records) release();
        return finish(soup, source.name, reading, progress.part(0.4, 1.0));
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::too_large, source.name, "the mesh does not fit into memory",
                    "export the part with a coarser tolerance");
    }
}

} // namespace

std::string reading_key(const MeshReading& reading) {
    std::string key(reading.unit ? unit_name(*reading.unit) : std::string_view());
    const Relief& relief = reading.relief;
    for (const std::optional<double>& v : {relief.width, relief.length, relief.height})
        key += "|" + (v ? format_number(*v, 17) : std::string());
    key += "|" + format_number(relief.smoothing, 17) + (relief.invert ? "|inverted" : "");
    key += "|" + format_number(reading.chord, 17) + "|" + format_number(reading.chord_angle, 17);
    return key + "|" + reading.objects;
}

LoadedMesh read_mesh(std::string_view bytes, const std::string& name, const MeshReading& reading,
                     const Progress& progress) {
    return read_and_finish(bytes, name, reading, progress, [] {});
}

LoadedMesh load_mesh(const std::filesystem::path& path, const MeshReading& reading,
                     const Progress& progress) {
    std::optional<InputFile> file(path);
    return read_and_finish(file->bytes(), path.string(), reading, progress, [&] { file.reset(); });
}

} // namespace facetmill
