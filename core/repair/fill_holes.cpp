// Holes filled, flat or as the surface around them bends.
#include "core/mesh/index_pair.h"
#include "core/repair/hole_filler.h"
#include "core/repair/repair_step.h"

#include <algorithm>

namespace facetmill::detail {

namespace {

/// Where the surface turns back by more all along a rim, the patch lies on the surface's own back.
constexpr double back_fold = 175 * pi / 180;

} // namespace

HoleFiller::HoleFiller(const Mesh& source, const Progress& progress)
    : source_(source), around_(facets_around_vertices(source, progress)) {}

bool HoleFiller::fill(const Hole& hole, RepairStep::Fill kind, Mesh& mesh, const Progress& progress) {
    const PatchRim rim = rim_of(hole);
    auto patch = flat_patch(rim, progress);
    if (!patch || patch->min_fold > back_fold) return false;
    if (kind == RepairStep::Fill::smooth) fair_patch(*patch, rim, progress);
    const auto first = Index(mesh.vertices.size());
    const std::size_t corners = hole.loop.size();
    mesh.vertices.insert(mesh.vertices.end(), patch->points.begin() + std::ptrdiff_t(corners),
                         patch->points.end());
    const auto number = [&](Index v) { return v < corners ? hole.loop[v] : Index(first + v - corners); };
    for (const Facet& f : patch->facets) {
        mesh.facets.push_back({number(f[0]), number(f[1]), number(f[2])});
        for (std::size_t k = 0; k < 3; ++k)
            if (f[k] < corners && f[(k + 1) % 3] < corners)
                added_.insert(pair_of(number(f[k]), number(f[(k + 1) % 3])));
    }
    return true;
}

bool HoleFiller::has_edge(Index a, Index b) const {
    for (const Index f : around_.around(a))
        for (const Index v : source_.facets[f])
            if (v == b) return true;
    return added_.count(pair_of(a, b)) > 0;
}

PatchRim HoleFiller::rim_of(const Hole& hole) const {
    PatchRim rim;
    const std::size_t n = hole.loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Index v = hole.loop[i], next = hole.loop[(i + 1) % n], last = hole.loop[(i + n - 1) % n];
        rim.points.push_back(source_.vertices[v]);
        Vec3 normal = Vec3::Zero();
        std::vector<Index> beyond;
        double sum = 0;
        std::size_t edges = 0;
        for (const Index f : around_.around(v)) {
            const Facet& facet = source_.facets[f];
            for (std::size_t k = 0; k < 3; ++k) {
                if (facet[k] == next && facet[(k + 1) % 3] == v) normal = source_.facet_normal(f);
                if (facet[k] == v) continue;
                sum += (source_.vertices[facet[k]] - source_.vertices[v]).norm();
                ++edges;
                if (facet[k] != next && facet[k] != last) beyond.push_back(facet[k]);
            }
        }
        std::sort(beyond.begin(), beyond.end());
        beyond.erase(std::unique(beyond.begin(), beyond.end()), beyond.end());
        auto& places = rim.beyond.emplace_back();
        for (const Index u : beyond)
            places.push_back(source_.vertices[u]);
        rim.normals.push_back(normal);
        rim.spacing.push_back(sum / double(std::max<std::size_t>(edges, 1)));
    }
    rim.is_taken = [this, &hole](Index a, Index b) {
        return hole.loop[a] == hole.loop[b] || has_edge(hole.loop[a], hole.loop[b]);
    };
    return rim;
}

StepResult fill_holes(const Mesh& source, const RepairStep& step, const std::vector<Vec3>& left,
                      const Progress& progress) {
    const HoleList list = holes_of(source, progress.part(0, 0.5));
    std::vector<char> stays(list.holes.size() + 1, 0); // the last: of places where no hole is
    for (const Vec3& at : left)
        stays[hole_near(list.holes, at)] = 1;
    StepResult result;
    std::size_t filled = 0, larger = 0, unfit = 0, asked = 0;
    auto mesh = std::make_shared<Mesh>(source);
    HoleFiller filler(source, progress.part(0.5, 0.6));
    for (std::size_t i = list.holes.size(); i-- > 0;) { // the smallest first
        const Hole& hole = list.holes[i];
        const double done = 0.6 + 0.4 * (1 - double(i + 1) / double(list.holes.size()));
        if (stays[i])
            ++asked;
        else if (step.size > 0 && hole.diameter > step.size)
            ++larger;
        else
            ++(filler.fill(hole, step.fill, *mesh, progress.part(done, done)) ? filled : unfit);
    }
    result.tell("filled", filled);
    result.tell("facets_added", mesh->facet_count() - source.facet_count());
    result.tell_any("left_larger", larger);
    result.tell_any("left_without_fit", unfit);
    result.tell_any("left_as_asked", asked);
    result.tell_any("sheet_ends", list.sheet_ends);
    result.tell_any("facets_in_no_sheet", list.left_out);
    if (filled > 0) result.mesh = std::move(mesh);
    return result;
}

StepResult fill_hole(const Mesh& source, const RepairStep& step, const Progress& progress) {
    const HoleList list = holes_of(source, progress.part(0, 0.5));
    const std::size_t h = hole_near(list.holes, Vec3(step.at[0], step.at[1], step.at[2]));
    StepResult result;
    if (h == list.holes.size()) {
        result.tell("not_found", 1);
        return result;
    }
    if (step.fill == RepairStep::Fill::left) {
        result.tell("left_as_asked", 1);
        return result;
    }
    auto mesh = std::make_shared<Mesh>(source);
    HoleFiller filler(source, progress.part(0.5, 0.8));
    const bool filled = filler.fill(list.holes[h], step.fill, *mesh, progress.part(0.8, 1));
    result.tell("filled", filled ? 1 : 0);
    result.tell("facets_added", mesh->facet_count() - source.facet_count());
    result.tell_any("left_without_fit", filled ? 0 : 1);
    if (filled) result.mesh = std::move(mesh);
    return result;
}

} // namespace facetmill::detail
