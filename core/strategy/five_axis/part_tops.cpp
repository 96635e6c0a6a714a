#include "core/strategy/five_axis/part_tops.h"

#include "core/base/tolerances.h"
#include "core/strategy/five_axis/ring_map.h"
#include "core/strategy/surface/up_side.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Vertex normals are those of the whole part where all facets of a piece lie this near to them: elsewhere
/// the part has an edge, and the piece ends at it.
const double smooth_cos = std::cos(radians(25));
/// Smaller pieces are planned together, in squares of the cutter's radius.
constexpr double small_piece = 16;

} // namespace

PartPiece side_piece(const Mesh& mesh, std::span<const Index> facets, const std::vector<Vec3>& normals,
                     const std::vector<VertexCurvature>& curvatures, const Progress& progress) {
    PartOfMesh part = part_of(mesh, facets);
    auto geometry = std::make_shared<MeshGeometry>(*compute_geometry(part.mesh, progress));
    auto own = std::make_shared<std::vector<VertexCurvature>>();
    std::vector<double> nearest(part.vertex_of.size(), 1);
    for (std::size_t f = 0; f < part.mesh.facet_count(); ++f)
        for (const Index v : part.mesh.facets[f])
            nearest[v] = std::min(nearest[v], geometry->facet_normals[f].dot(normals[part.vertex_of[v]]));
    for (std::size_t v = 0; v < nearest.size(); ++v) {
        if (nearest[v] >= smooth_cos) geometry->vertex_normals[v] = normals[part.vertex_of[v]];
        own->push_back(curvatures[part.vertex_of[v]]);
    }
    return {std::make_shared<Mesh>(std::move(part.mesh)), std::move(geometry), std::move(own)};
}

PartSides find_tops(const PlanContext& context, const Finish5Settings& settings, const Progress& progress) {
    const Mesh& mesh = *context.part;
    const UpSide up(mesh, progress.part(0, 0.1));
    std::vector<Index> facing;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        if (up.towards_tool(mesh.facet_normal(f)).z() > tolerance::vertical_normal_z)
            facing.push_back(Index(f));
    const std::vector<Vec3> normals =
        context.geometry ? context.geometry->vertex_normals
                         : vertex_normals(mesh, NormalWeight::angle, progress.part(0.1, 0.3));
    const std::vector<VertexCurvature> curvatures =
        context.curvatures ? *context.curvatures : vertex_curvatures(mesh, normals, progress.part(0.3, 0.8));
    std::size_t count = 0;
    const std::vector<std::size_t> piece = connected_pieces(mesh, facing, count);
    std::vector<std::vector<Index>> pieces(count);
    std::vector<double> area(count, 0);
    for (std::size_t i = 0; i < facing.size(); ++i) {
        pieces[piece[i]].push_back(facing[i]);
        area[piece[i]] += 0.5 * mesh.facet_cross(facing[i]).norm();
    }
    PartSides found;
    const bool asks_round = settings.passes == Finish5Settings::Passes::around;
    const auto add = [&](const std::vector<Index>& facets, double own, bool round) {
        SidePiece made;
        made.piece = side_piece(mesh, facets, normals, curvatures, progress.part(0.9, 0.9));
        made.area = own;
        made.lead_limits = settings.lead_limits;
        made.passes = round && goes_round(*made.piece.mesh, progress.part(0.9, 0.9))
                          ? Finish5Settings::Passes::around
                          : passes_but_round(settings.passes);
        found.pieces.push_back(std::move(made));
        found.whole_area += own;
    };
    const double radius = CutterProfile(context.tool.cutter()).max_radius();
    std::vector<Index> small;
    double small_area = 0;
    for (std::size_t k = 0; k < count; ++k) {
        if (area[k] >= small_piece * radius * radius) {
            add(pieces[k], area[k], asks_round);
            continue;
        }
        small.insert(small.end(), pieces[k].begin(), pieces[k].end());
        small_area += area[k];
    }
    std::sort(small.begin(), small.end());
    if (small_area > 0) add(small, small_area, false);
    return found;
}

} // namespace facetmill
