#include "core/repair/crossings.h"

#include "core/base/parallel.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/exact_side.h"
#include "core/mesh/facet_boxes.h"
#include "core/mesh/geometry_incidence.h"
#include "core/mesh/unused_vertices.h"
#include "core/repair/deviation.h"
#include "core/repair/hole_filler.h"
#include "core/repair/repair_step.h"
#include "core/repair/shells.h"

#include <algorithm>
#include <array>

namespace facetmill {

namespace {

constexpr std::size_t crossings_per_block = 1024;

std::array<Vec3, 3> corners_of(const Mesh& mesh, std::size_t f) {
    return {mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)};
}

std::size_t shared_corners(const Facet& a, const Facet& b) {
    std::size_t n = 0;
    for (const Index v : a)
        n += v == b[0] || v == b[1] || v == b[2];
    return n;
}

} // namespace

std::vector<std::pair<Index, Index>> crossing_facets(const Mesh& mesh, const Progress& progress) {
    const std::vector<Box3> boxes = facet_boxes(mesh);
    const BoxTree tree(boxes, progress.part(0, 0.3));
    using Pairs = std::vector<std::pair<Index, Index>>;
    return parallel_reduce(
        mesh.facet_count(), crossings_per_block, Pairs{}, progress.part(0.3, 1),
        [&](std::size_t begin, std::size_t end) {
            Pairs found;
            for (std::size_t f = begin; f < end; ++f) {
                const Box3& box = boxes[f];
                const std::size_t first = found.size();
                tree.each(
                    [&](const Box3& b) {
                        return (b.lo.array() <= box.hi.array()).all()
                               && (b.hi.array() >= box.lo.array()).all();
                    },
                    [&](std::size_t g) {
                        if (g <= f || shared_corners(mesh.facets[f], mesh.facets[g]) > 1) return;
                        if (triangles_cross(corners_of(mesh, f), corners_of(mesh, g)))
                            found.emplace_back(Index(f), Index(g));
                    });
                std::sort(found.begin() + std::ptrdiff_t(first), found.end());
            }
            return found;
        },
        [](Pairs total, const Pairs& part) {
            total.insert(total.end(), part.begin(), part.end());
            return total;
        });
}

namespace detail {

namespace {

/// The facets that cross and those that touch them, where such a place is no larger than `size`.
std::vector<char> places_to_remake(const Mesh& mesh, const std::vector<std::pair<Index, Index>>& crossings,
                                   double size, std::size_t& larger, const Progress& progress) {
    const VertexFacets around = facets_around_vertices(mesh, progress);
    std::vector<char> marked(mesh.facet_count(), 0);
    for (const auto& [f, g] : crossings)
        for (const Index v : {mesh.facets[f][0], mesh.facets[f][1], mesh.facets[f][2], mesh.facets[g][0],
                              mesh.facets[g][1], mesh.facets[g][2]})
            for (const Index h : around.around(v))
                marked[h] = 1;
    Mesh place;
    place.vertices = mesh.vertices;
    std::vector<Index> facet_of;
    for (std::size_t f = 0; f < marked.size(); ++f)
        if (marked[f]) {
            place.facets.push_back(mesh.facets[f]);
            facet_of.push_back(Index(f));
        }
    const Shells places = shells_of(place, progress);
    for (const Shell& shell : places.all)
        larger += shell.box.diagonal() > size;
    for (std::size_t i = 0; i < facet_of.size(); ++i)
        if (places.all[places.of_facet[i]].box.diagonal() > size) marked[facet_of[i]] = 0;
    return marked;
}

/// Fills the holes that were none before: all their corners are corners of facets taken out.
std::shared_ptr<Mesh> refilled(const Mesh& mesh, const std::vector<char>& taken, RepairStep::Fill fill,
                               const Progress& progress) {
    std::vector<char> stays(taken.size());
    for (std::size_t f = 0; f < taken.size(); ++f)
        stays[f] = !taken[f];
    // With all vertices, so that their numbers stay.
    Mesh rest;
    rest.vertices = mesh.vertices;
    std::vector<char> touched(mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < taken.size(); ++f)
        if (stays[f])
            rest.facets.push_back(mesh.facets[f]);
        else
            for (const Index v : mesh.facets[f])
                touched[v] = 1;
    auto result = std::make_shared<Mesh>(rest);
    const HoleList list = holes_of(rest, progress);
    HoleFiller filler(rest, progress);
    for (const Hole& hole : list.holes)
        if (std::all_of(hole.loop.begin(), hole.loop.end(), [&](Index v) { return touched[v]; }))
            if (!filler.fill(hole, fill, *result, progress)) return nullptr;
    drop_unused_vertices(*result, progress);
    return result;
}

} // namespace

StepResult remake_crossings(const Mesh& mesh, const RepairStep& step, const Progress& progress) {
    StepResult result;
    const auto crossings = crossing_facets(mesh, progress.part(0, 0.3));
    result.tell("crossings_found", crossings.size());
    if (crossings.empty()) return result;
    std::size_t larger = 0;
    const std::vector<char> taken = places_to_remake(mesh, crossings, step.size, larger, progress);
    const auto count = std::size_t(std::count(taken.begin(), taken.end(), 1));
    std::shared_ptr<Mesh> after;
    if (count > 0) after = refilled(mesh, taken, step.fill, progress.part(0.3, 0.5));
    std::size_t left = crossings.size();
    if (after && !after->facets.empty()) {
        const std::size_t now = crossing_facets(*after, progress.part(0.5, 0.7)).size();
        if (now < left) {
            left = now;
            constexpr double measured_share_of_size = 1e-3;
            result.displacement =
                surface_deviation(mesh, *after, measured_share_of_size * step.size, progress.part(0.7, 1))
                    .largest();
            result.tell("facets_remade", count);
            result.mesh = std::move(after);
        }
    }
    result.tell("crossings_left", left);
    result.tell_any("places_left_larger", larger);
    return result;
}

} // namespace detail

} // namespace facetmill
