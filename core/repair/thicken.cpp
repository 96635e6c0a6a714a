// A sheet becomes a solid: its back is the sheet moved along its normals, and walls join the borders.
#include "core/mesh/edge_table.h"
#include "core/mesh/geometry.h"
#include "core/mesh/geometry_incidence.h"
#include "core/repair/repair_step.h"

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

/// At bends the back lies farther off the vertex, so that it keeps the thickness off the facets; at sharp
/// ones at most so many times as far.
constexpr double max_miter = 2;

} // namespace

StepResult thicken_sheet(const Mesh& sheet, const RepairStep& step, const Progress& progress) {
    const std::size_t n = sheet.vertices.size();
    const std::vector<Vec3> normals = vertex_normals(sheet, NormalWeight::angle, progress.part(0, 0.4));
    const VertexFacets around = facets_around_vertices(sheet, progress.part(0.4, 0.6));
    auto solid = std::make_shared<Mesh>(sheet);
    StepResult result;
    std::size_t without = 0;
    for (std::size_t v = 0; v < n; ++v) {
        if (v % 65536 == 0) progress.check();
        double along = 0;
        std::size_t facets = 0;
        for (const Index f : around.around(v)) {
            along += normals[v].dot(sheet.facet_normal(f));
            ++facets;
        }
        without += normals[v].isZero(0);
        const double miter =
            along > 0 ? std::min(max_miter, double(std::max<std::size_t>(facets, 1)) / along) : 1.0;
        solid->vertices.push_back(rounded_to_float(sheet.vertices[v] - step.thickness * miter * normals[v]));
    }
    const bool behind = step.thickness > 0;
    const auto moved = Index(n);
    for (const Facet& f : sheet.facets)
        solid->facets.push_back(behind ? Facet{f[0] + moved, f[2] + moved, f[1] + moved}
                                       : Facet{f[0] + moved, f[1] + moved, f[2] + moved});
    if (!behind) // the sheet is the back now
        for (std::size_t f = 0; f < sheet.facet_count(); ++f)
            std::swap(solid->facets[f][1], solid->facets[f][2]);
    const EdgeTable table(sheet, progress.part(0.6, 0.9));
    std::size_t walls = 0;
    for (std::size_t low = 0; low < table.vertex_count(); ++low)
        table.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
            if (sides.size() != 1) return;
            Index a = side_start(sheet, sides[0].side), b = side_end(sheet, sides[0].side);
            if (!behind) std::swap(a, b);
            solid->facets.push_back({b, a, a + moved});
            solid->facets.push_back({b, a + moved, b + moved});
            walls += 2;
        });
    progress.check();
    result.tell("back_facets", sheet.facet_count());
    result.tell("wall_facets", walls);
    result.tell_any("vertices_without_normal", without);
    result.mesh = std::move(solid);
    return result;
}

} // namespace facetmill::detail
