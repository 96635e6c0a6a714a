#include "core/strategy/surface/slope_facets.h"

#include "core/base/tolerances.h"
#include "core/mesh/refine.h"
#include "core/strategy/surface/boundary_region.h"
#include "core/strategy/surface/up_side.h"

#include <cmath>

namespace facetmill {

std::optional<Interval> slope_limits_of(const Operation& operation) {
    if (operation.has("slope_limit")) return Interval{0, std::get<double>(operation.get("slope_limit"))};
    if (!operation.has("slope_limits")) return std::nullopt;
    const auto limits = std::get<std::array<double, 2>>(operation.get("slope_limits"));
    return Interval{limits[0], limits[1]};
}

std::vector<double> facet_slopes(const Mesh& mesh, bool as_wound, const Mat3& turn,
                                 const Progress& progress) {
    const UpSide side(mesh, progress);
    std::vector<double> slopes(mesh.facet_count(), infinity);
    for (std::size_t f = 0; f < slopes.size(); ++f) {
        if (f % 8192 == 0) progress.check();
        Vec3 n = turn * mesh.facet_normal(f);
        if (n == Vec3::Zero()) continue;
        if (!as_wound) n = side.towards_tool(n);
        slopes[f] = std::acos(std::clamp(n.z(), -1.0, 1.0));
    }
    return slopes;
}

std::size_t facets_of_part(const PlanContext& context) {
    return context.within ? context.within->region->facets().size() : context.part->facet_count();
}

SlopePiece piece_between(const PlanContext& context, const Interval& slopes, const Progress& progress) {
    const Mesh& mesh = *context.part;
    const std::vector<double> slope =
        facet_slopes(mesh, context.is_piece, Mat3::Identity(), progress.part(0, 0.5));
    const double upright = std::acos(tolerance::vertical_normal_z);
    SlopePiece piece;
    std::vector<Index> facets;
    for (std::size_t f = 0; f < slope.size(); ++f) {
        if (f % 8192 == 0) progress.check();
        const double area = 0.5 * mesh.facet_cross(f).norm();
        if (slope[f] > upright && slope[f] < pi - upright) piece.walls += area;
        if (!(slope[f] <= upright)) continue;
        piece.all += area;
        if (slope[f] < slopes.lo) piece.shallower += area;
        if (slope[f] < slopes.lo || slope[f] > slopes.hi) continue;
        piece.area += area;
        facets.push_back(Index(f));
    }
    if (!facets.empty()) piece.mesh = std::make_shared<Mesh>(part_of(mesh, facets).mesh);
    progress.set(1);
    return piece;
}

} // namespace facetmill
