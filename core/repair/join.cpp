#include "core/repair/join.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/geometry_incidence.h"
#include "core/mesh/unused_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill::detail {

namespace {

constexpr std::size_t facets_at_a_time = 2048;
/// Of the mean edge: where nothing is said of how far scans may lie apart.
constexpr double usual_reach = 3;
/// Rounds in which corners where a cut meets itself are widened.
constexpr int max_widenings = 20;
/// To this share of the reach displacements are measured.
constexpr double measured_share_of_reach = 0.01;

double mean_edge(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        sum += (mesh.corner(f, 1) - mesh.corner(f, 0)).norm();
    return sum / double(mesh.facet_count());
}

/// Facets of the scan of which a corner, the middle of a side or the middle has a place on the ground.
std::vector<char> covered_facets(const ScanGround& ground, const Mesh& scan, const Progress& progress) {
    std::vector<char> covered(scan.facet_count(), 0);
    parallel_for(covered.size(), facets_at_a_time, progress, [&](std::size_t f) {
        const Vec3 &a = scan.corner(f, 0), &b = scan.corner(f, 1), &c = scan.corner(f, 2);
        const Vec3 normal = scan.facet_cross(f);
        for (const Vec3& p :
             {a, b, c, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2), Vec3((a + b + c) / 3)})
            if (ground.place(p, normal).facet != no_index) {
                covered[f] = 1;
                return;
            }
    });
    return covered;
}

Mesh part_of(const Mesh& mesh, const std::vector<char>& marked, char mark) {
    Mesh part;
    part.vertices = mesh.vertices; // all, so that their numbers stay
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        if (marked[f] == mark) part.facets.push_back(mesh.facets[f]);
    return part;
}

/// Takes facets out until no vertex of the cut lies on the border of what stays more than once.
void widen_cut(const Mesh& scan, std::vector<char>& taken, const Progress& progress) {
    const VertexFacets around = facets_around_vertices(scan, progress);
    for (int round = 0; round < max_widenings; ++round) {
        progress.check();
        bool any = false;
        for (std::size_t v = 0; v < scan.vertices.size(); ++v) {
            const auto fan = around.around(v);
            if (std::none_of(fan.begin(), fan.end(), [&](Index f) { return taken[f]; })) continue;
            // Sides that run out of the vertex and none that runs into it: borders of what stays.
            std::vector<Index> out, in;
            for (const Index f : fan) {
                if (taken[f]) continue;
                const Facet& c = scan.facets[f];
                const std::size_t k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
                out.push_back(c[(k + 1) % 3]);
                in.push_back(c[(k + 2) % 3]);
            }
            const auto begins = std::count_if(out.begin(), out.end(), [&](Index w) {
                return std::find(in.begin(), in.end(), w) == in.end();
            });
            if (begins < 2) continue;
            for (const Index f : fan)
                taken[f] = 1;
            any = true;
        }
        if (!any) return;
    }
}

/// Of the border of what stays only what a cut made, where it was none before.
std::vector<Index> cut_courses(const Mesh& scan, const Mesh& stays, const Progress& progress) {
    const std::vector<Index> before = border_courses(scan, nullptr, progress);
    std::vector<Index> cut = border_courses(stays, nullptr, progress);
    for (std::size_t v = 0; v < cut.size(); ++v)
        if (cut[v] == before[v]) cut[v] = no_index;
    return cut;
}

std::vector<Index> shifted(std::vector<Index> next, std::size_t before, Index by) {
    for (Index& v : next)
        if (v != no_index) v += by;
    next.insert(next.begin(), before, no_index);
    return next;
}

/// How far a place of some facets is from a surface.
double farthest_of(const Mesh& facets, const Mesh& surface, double reach, const Progress& progress) {
    if (facets.facets.empty()) return 0;
    const DeviationIndex index(surface, progress.part(0, 0.2), reach);
    double farthest = 0;
    facets_beyond(facets, index, infinity, measured_share_of_reach * reach, {}, farthest,
                  progress.part(0.2, 1));
    return farthest;
}

} // namespace

StepResult join_scans(const Mesh& mesh, Mesh other, const RepairStep& step, const Progress& progress) {
    const double reach =
        step.size > 0 ? step.size : usual_reach * std::max(mean_edge(mesh), mean_edge(other));
    StepResult result;
    double moved = 0;
    if (step.bound > 0) {
        const ScanGround wide(mesh, std::max(reach, step.bound), progress.part(0, 0.1));
        moved = lay_on(wide, other, progress.part(0.1, 0.25));
        if (moved > step.bound)
            throw Error(ErrorCode::out_of_range, "bound",
                        "the scan would have to move by " + length_text(moved, LengthUnit::mm) + " to fit",
                        "lay the scans on each other first, or allow more");
    }
    const ScanGround ground(mesh, reach, progress.part(0.25, 0.35));
    std::vector<char> taken = covered_facets(ground, other, progress.part(0.35, 0.5));
    widen_cut(other, taken, progress.part(0.5, 0.55));
    const Mesh stays = part_of(other, taken, 0), goes = part_of(other, taken, 1);

    auto joined = std::make_shared<Mesh>(mesh);
    append_mesh(*joined, stays);
    const std::size_t own = mesh.vertices.size();
    std::vector<Index> border = ground.next();
    border.resize(joined->vertices.size(), no_index);
    std::size_t unjoined = 0;
    Mesh seam;
    seam.vertices = joined->vertices;
    seam.facets =
        seam_facets(*joined, shifted(cut_courses(other, stays, progress.part(0.55, 0.6)), own, Index(own)),
                    border, reach, unjoined, progress.part(0.6, 0.65));
    joined->facets.insert(joined->facets.end(), seam.facets.begin(), seam.facets.end());

    // What went lies near what is there, and what is new near what was.
    Mesh both = mesh;
    append_mesh(both, other);
    result.displacement = moved
                          + std::max(farthest_of(goes, *joined, reach, progress.part(0.65, 0.85)),
                                     farthest_of(seam, both, reach, progress.part(0.85, 0.98)));
    result.tell("facets_joined", stays.facet_count());
    result.tell("facets_overlapping", goes.facet_count());
    result.tell("facets_of_seam", seam.facet_count());
    result.tell_any("seams_left_open", unjoined);
    drop_unused_vertices(*joined, progress.part(0.98, 1));
    result.mesh = std::move(joined);
    return result;
}

} // namespace facetmill::detail
