#include "core/strategy/cleanup/left_strip.h"

#include "core/mesh/refine.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/surface/point_grid.h"

#include <algorithm>
#include <numeric>

namespace facetmill {

namespace {

/// A piece of a larger one, with what is known of its vertices.
PartPiece piece_of(const PartPiece& whole, std::span<const Index> facets) {
    PartOfMesh part = part_of(*whole.mesh, facets);
    auto geometry = std::make_shared<MeshGeometry>();
    auto curvatures = std::make_shared<std::vector<VertexCurvature>>();
    for (const Index v : part.vertex_of) {
        geometry->vertex_normals.push_back(whole.geometry->vertex_normals[v]);
        curvatures->push_back((*whole.curvatures)[v]);
    }
    for (const Index f : facets)
        geometry->facet_normals.push_back(whole.geometry->facet_normals[f]);
    return {std::make_shared<Mesh>(std::move(part.mesh)), std::move(geometry), std::move(curvatures)};
}

} // namespace

std::vector<LeftStrip> left_strips(const PlanContext& context, const std::vector<LeftPlace>& places,
                                   double spacing, double offset, double smallest, const Progress& progress) {
    std::vector<LeftStrip> strips;
    if (places.empty()) return strips;
    RegionInput input;
    input.part = context.part;
    input.geometry =
        context.geometry ? context.geometry : compute_geometry(*context.part, progress.part(0, 0.1));
    input.curvatures = context.curvatures
                           ? context.curvatures
                           : std::make_shared<std::vector<VertexCurvature>>(vertex_curvatures(
                               *context.part, input.geometry->vertex_normals, progress.part(0.1, 0.2)));
    input.spacing = spacing;
    input.offset = offset;
    std::vector<UncutPlace> uncut;
    for (const LeftPlace& p : places)
        uncut.push_back({p.point, p.normal, 0});
    const PartPiece within = rework_regions(input, uncut, progress.part(0.2, 0.9)).within;
    if (!within.mesh || within.mesh->facets.empty()) return strips;

    std::vector<Index> all(within.mesh->facets.size());
    std::iota(all.begin(), all.end(), Index(0));
    std::size_t count = 0;
    const auto number = connected_pieces(*within.mesh, all, count);
    std::vector<std::vector<Index>> facets(count);
    for (std::size_t f = 0; f < all.size(); ++f)
        facets[number[f]].push_back(Index(f));
    std::vector<Vec3> corners;
    std::vector<std::size_t> strip_of;
    for (std::size_t i = 0; i < count; ++i) {
        progress.check();
        LeftStrip s;
        s.piece = piece_of(within, facets[i]);
        const Mesh& mesh = *s.piece.mesh;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            s.strip.band.push_back({mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)});
            s.strip.area += 0.5 * mesh.facet_cross(f).norm();
        }
        s.strip.boundaries = border_loops(mesh);
        s.strip.length = mesh.box().diagonal();
        for (const Vec3& v : mesh.vertices) {
            corners.push_back(v);
            strip_of.push_back(i);
        }
        strips.push_back(std::move(s));
    }
    const PointGrid grid(std::move(corners), spacing);
    for (const LeftPlace& p : places) {
        std::size_t nearest = count;
        double least = infinity;
        for (double reach = spacing; nearest == count && reach < 64 * spacing; reach *= 2)
            grid.near(p.point, reach, [&](std::size_t k) {
                const double square = (grid.points()[k] - p.point).squaredNorm();
                if (square < least) {
                    least = square;
                    nearest = strip_of[k];
                }
            });
        if (nearest == count) continue;
        ++strips[nearest].places;
        strips[nearest].height = std::max(strips[nearest].height, p.height);
    }
    // The offset alone makes no strip large.
    std::erase_if(
        strips, [&](const LeftStrip& s) { return s.places == 0 || s.strip.length - 2 * offset < smallest; });
    std::stable_sort(strips.begin(), strips.end(),
                     [](const LeftStrip& a, const LeftStrip& b) { return a.strip.area > b.strip.area; });
    return strips;
}

StrategyResult cut_left(const PlanContext& context, const OperationCommon& common, bool one_way,
                        const LeftStrip& strip, const Progress& progress) {
    PlanContext own = context;
    own.part = strip.piece.mesh;
    own.geometry = strip.piece.geometry;
    own.curvatures = strip.piece.curvatures;
    own.further_tools.clear();
    Finish3Settings settings;
    static_cast<OperationCommon&>(settings) = common;
    settings.pattern = one_way ? Finish3Settings::Pattern::oneway : Finish3Settings::Pattern::zigzag;
    try {
        return Finish3(settings).plan(own, progress);
    } catch (const Error& e) {
        if (e.code() != ErrorCode::empty_result) throw;
        return {};
    }
}

} // namespace facetmill
