#include "viz/repair_display.h"

#include "core/base/parallel.h"
#include "core/mesh/unused_vertices.h"
#include "core/repair/deviation.h"
#include "viz/deviation_display.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t queries_per_block = 1024;
/// Share of the part's size: nearer than this a facet lies on a surface.
constexpr double on_surface_share = 1e-6;

Vec3 middle_of(const Mesh& mesh, std::size_t f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

MeshPtr facets_that(const MeshPtr& mesh, const std::vector<char>& are, bool wanted,
                    const Progress& progress) {
    const auto n = std::size_t(std::count(are.begin(), are.end(), char(1)));
    if (are.empty() || n == 0) return wanted ? nullptr : mesh;
    if (n == are.size()) return wanted ? mesh : nullptr;
    auto some = std::make_shared<Mesh>();
    some->vertices = mesh->vertices;
    for (std::size_t f = 0; f < mesh->facet_count(); ++f)
        if ((are[f] != 0) == wanted) some->facets.push_back(mesh->facets[f]);
    drop_unused_vertices(*some, progress);
    return some;
}

/// Of the facets of `before` those that went, and not because the surface moved by `moved`.
std::vector<char> removed_facets(const RepairedSurfaces& s, const Progress& progress) {
    std::vector<char> gone(s.before->facet_count(), 0);
    const std::vector<char> same = facets_in_both(*s.before, *s.after, progress.part(0, 0.2));
    if (std::find(same.begin(), same.end(), char(0)) == same.end()) return gone;
    const DeviationIndex after(*s.after, progress.part(0.2, 0.5));
    const double slack = s.moved + on_surface_share * s.before->box().diagonal();
    parallel_for(gone.size(), queries_per_block, progress.part(0.5, 1), [&](std::size_t f) {
        gone[f] = !same[f] && after.place(middle_of(*s.before, f)).distance > slack;
    });
    return gone;
}

/// Of the vertices of `kept` how far they lie from `before`, outward positive.
std::vector<float> displacements(const Mesh& kept, const Mesh& before, const Progress& progress) {
    std::vector<float> moved(kept.vertices.size(), 0);
    const std::vector<char> same = facets_in_both(kept, before, progress.part(0, 0.2));
    std::vector<char> asked(moved.size(), 0);
    for (std::size_t f = 0; f < kept.facet_count(); ++f)
        for (const Index v : kept.facets[f])
            asked[v] = char(asked[v] || !same[f]);
    if (std::find(asked.begin(), asked.end(), char(1)) == asked.end()) return moved;
    std::vector<Vec3> outward(moved.size(), Vec3::Zero());
    for (std::size_t f = 0; f < kept.facet_count(); ++f)
        for (const Index v : kept.facets[f])
            outward[v] += kept.facet_cross(f);
    const DeviationIndex index(before, progress.part(0.2, 0.5));
    parallel_for(moved.size(), queries_per_block, progress.part(0.5, 1), [&](std::size_t v) {
        if (!asked[v]) return;
        const DeviationIndex::Place place = index.place(kept.vertices[v]);
        const double side = (place.at - place.nearest).dot(outward[v]);
        moved[v] = float(side < 0 ? -place.distance : place.distance);
    });
    return moved;
}

/// Ends at a round number of the unit.
DeviationScale scale_of(double largest, LengthUnit unit) {
    const double per = mm_per(unit);
    double end = round_down(std::max(largest, 1e-6) / per);
    while (end * per < largest * (1 - 1e-9))
        end = round_down(2.6 * end);
    DeviationScale scale;
    scale.high = end * per;
    scale.low = -scale.high;
    return scale;
}

void color_repair(RepairDisplay& display, const std::vector<float>& moved, LengthUnit unit) {
    const PartDisplay& kept = *display.kept;
    const Mesh& mesh = *kept.mesh;
    display.displacement.assign(kept.points.size() / 3, 0);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            display.displacement[std::size_t(kept.triangles[3 * f + k])] = moved[mesh.facets[f][k]];
    for (const float d : display.displacement)
        display.largest = std::max(display.largest, std::abs(double(d)));
    display.scale = scale_of(display.largest, unit);
    display.colors = deviation_colors(display.displacement, {}, display.scale);
    const std::size_t m = kept.preview.points.size() / 3;
    if (kept.preview.triangles.empty() || m == 0) return;
    std::vector<double> sum(m, 0), count(m, 0);
    for (std::size_t i = 0; i < display.displacement.size(); ++i) {
        const auto at = std::size_t(kept.preview.merged[i]);
        sum[at] += double(display.displacement[i]);
        count[at] += 1;
    }
    std::vector<float> mean(m);
    for (std::size_t i = 0; i < m; ++i)
        mean[i] = float(sum[i] / std::max(count[i], 1.0));
    display.preview_colors = deviation_colors(mean, {}, display.scale);
}

} // namespace

std::vector<char> new_surface(const Mesh& then, const std::vector<char>& added, const Mesh& now,
                              bool makes_surface, const Progress& progress) {
    std::vector<char> fresh(now.facet_count(), 0);
    const bool any = std::find(added.begin(), added.end(), char(1)) != added.end();
    if (!any && !makes_surface) return fresh;
    const std::vector<char> same = facets_in_both(now, then, progress.part(0, 0.2));
    if (!any && std::find(same.begin(), same.end(), char(0)) == same.end()) return fresh;
    const DeviationIndex index(then, progress.part(0.2, 0.5));
    const double slack = on_surface_share * then.box().diagonal();
    parallel_for(fresh.size(), queries_per_block, progress.part(0.5, 1), [&](std::size_t f) {
        if (same[f] && !any) return;
        const DeviationIndex::Place place = index.place(middle_of(now, f));
        fresh[f] = (any && added[place.facet]) || (makes_surface && !same[f] && place.distance > slack);
    });
    return fresh;
}

RepairDisplayPtr prepare_repair_display(const RepairedSurfaces& surfaces, const PlaceMesh& place,
                                        LengthUnit unit, const Progress& progress) {
    auto display = std::make_shared<RepairDisplay>();
    const auto shown = [&](const MeshPtr& mesh, const Progress& part) -> PartDisplayPtr {
        if (!mesh) return nullptr;
        return prepare_part_display(place(mesh, part.part(0, 0.2)), part.part(0.2, 1));
    };
    const MeshPtr kept = facets_that(surfaces.after, surfaces.added, false, progress);
    const MeshPtr added = facets_that(surfaces.after, surfaces.added, true, progress);
    const std::vector<char> gone = removed_facets(surfaces, progress.part(0, 0.3));
    display->before = shown(surfaces.before, progress.part(0.3, 0.45));
    display->removed = shown(facets_that(surfaces.before, gone, true, progress), progress.part(0.45, 0.5));
    display->added = shown(added, progress.part(0.5, 0.55));
    display->kept = shown(kept, progress.part(0.55, 0.7));
    if (kept) color_repair(*display, displacements(*kept, *surfaces.before, progress.part(0.7, 1)), unit);
    return display;
}

} // namespace facetmill
