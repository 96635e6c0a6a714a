#include "core/job/placed_mesh.h"

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/base/tolerances.h"
#include "core/job/cache_key.h"
#include "core/job/project.h"
#include "core/mesh/mesh_io.h"

#include <cmath>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t vertices_per_block = 20000;

} // namespace

MeshPtr placed(const MeshPtr& mesh, const MeshPlace& place, const Progress& progress) {
    const Placement& at = place.placement;
    if (place.scale == 1 && at == Placement()) return mesh;
    Vec3 factors = Vec3::Constant(place.scale);
    if (at.mirror != Mirror::none) factors[int(at.mirror) - int(Mirror::x)] *= -1;
    const Mat3 turn = rotation_of(at.rotate);
    const Vec3 move(at.translate[0], at.translate[1], at.translate[2]);
    auto copy = std::make_shared<Mesh>();
    copy->facets = mesh->facets;
    if (at.mirror != Mirror::none)
        for (auto& facet : copy->facets)
            std::swap(facet[1], facet[2]); // counter-clockwise seen from outside again
    copy->vertices.resize(mesh->vertices.size());
    parallel_for(mesh->vertices.size(), vertices_per_block, progress, [&](std::size_t i) {
        copy->vertices[i] = turn * factors.cwiseProduct(mesh->vertices[i]) + move;
    });
    return copy;
}

std::string mesh_key(const fs::path& path, const MeshPlace& place) {
    return Key()
        .add(std::string_view(file_stamp(path)))
        .add(unit_name(place.unit))
        .add(place.scale)
        .add(std::to_string(int(place.placement.mirror)))
        .add(place.placement.rotate)
        .add(place.placement.translate)
        .text();
}

void check_coordinates(const Box3& box, const std::string& what) {
    if (box.lo.cwiseAbs().cwiseMax(box.hi.cwiseAbs()).maxCoeff() <= tolerance::largest_coordinate) return;
    throw Error(ErrorCode::coordinate_range, what,
                "a coordinate is too large once the " + what + " is in its place",
                "check the " + what + "'s units and translate");
}

MeshPtr load_solid(const fs::path& path, const MeshPlace& place, const std::string& what,
                   const Progress& progress) {
    const LoadedMesh loaded = load_mesh(path, place.unit, progress.part(0.0, 0.9, "Reading the " + what));
    const MeshReport& r = loaded.report;
    const std::string file = printable(path.string(), 400);
    // Only a closed mesh says what is inside.
    if (!r.watertight)
        throw Error(ErrorCode::out_of_range, file,
                    "the " + what + "'s mesh is not closed: " + std::to_string(r.open_edges) + " open edges, "
                        + std::to_string(r.non_manifold_edges) + " of more than two facets, "
                        + std::to_string(r.inconsistent_edges) + " between facets that face apart",
                    "close it, or use a box or cylinder");
    if (std::abs(r.file_volume) <= tolerance::flat_volume * r.file_area * r.file_box.diagonal())
        throw Error(ErrorCode::out_of_range, file, "the " + what + "'s mesh encloses nothing",
                    "give a solid, or use a box or cylinder");
    const MeshPtr mesh = placed(loaded.mesh, place, progress.part(0.9, 1.0));
    check_coordinates(mesh->box(), what);
    return mesh;
}

} // namespace facetmill
