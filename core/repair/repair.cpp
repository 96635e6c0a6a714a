#include "core/repair/repair.h"

#include "core/base/error.h"
#include "core/base/strict_json.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/unused_vertices.h"
#include "core/repair/join.h"
#include "core/repair/repair_step.h"

#include <string>

namespace facetmill {

namespace {

using Kind = RepairStep::Kind;

/// What a step knows beside its mesh.
struct StepContext {
    const MeshReading& reading;
    std::vector<Vec3> left; ///< middles of holes that stay open, in so far as they are there
};
using Step = detail::StepResult (*)(const Mesh&, const RepairStep&, const StepContext&, const Progress&);

/// A step that asks for nothing else.
template <detail::StepResult (*run)(const Mesh&, const RepairStep&, const Progress&)>
detail::StepResult alone(const Mesh& mesh, const RepairStep& step, const StepContext& /*context*/,
                         const Progress& progress) {
    return run(mesh, step, progress);
}

detail::StepResult all_holes(const Mesh& mesh, const RepairStep& step, const StepContext& context,
                             const Progress& progress) {
    return detail::fill_holes(mesh, step, context.left, progress);
}

detail::StepResult join_file(const Mesh& mesh, const RepairStep& step, const StepContext& context,
                             const Progress& progress) {
    const LoadedMesh other = load_mesh(step.file, context.reading, progress.part(0, 0.2));
    return detail::join_scans(mesh, *other.mesh, step, progress.part(0.2, 1));
}

struct KindOfStep {
    Step run;
    const char* label;
};

const KindOfStep& kind_of_step(Kind kind) {
    static constexpr KindOfStep all[] = {{alone<detail::remove_pieces>, "Removing small pieces"},
                                         {alone<detail::turn_facets>, "Turning facets"},
                                         {alone<detail::remove_needles>, "Removing needles"},
                                         {all_holes, "Filling holes"},
                                         {alone<detail::smooth_noise>, "Smoothing"},
                                         {alone<detail::decimate>, "Decimating"},
                                         {alone<detail::cut_by_plane>, "Cutting"},
                                         {alone<detail::thicken_sheet>, "Thickening"},
                                         {alone<detail::remake_crossings>, "Looking for crossings"},
                                         {join_file, "Joining scans"},
                                         {alone<detail::remove_fins>, "Removing fins"},
                                         {alone<detail::fill_hole>, "Filling a hole"}};
    return all[std::size_t(kind)];
}

} // namespace

std::size_t StepReport::count(const std::string& what) const {
    for (const RepairCount& c : counts)
        if (c.what == what) return c.count;
    return 0;
}

Repaired run_recipe(const MeshPtr& mesh, const std::vector<RepairStep>& recipe, const Progress& progress,
                    const MeshReading& reading, std::size_t done_before) {
    check_recipe(recipe, repair_list.key);
    StepContext context{reading, {}};
    Repaired result;
    result.mesh = mesh;
    for (std::size_t i = 0; i < recipe.size(); ++i) {
        const RepairStep& step = recipe[i];
        if (step.off) continue;
        if (step.kind == Kind::hole && step.fill == RepairStep::Fill::left)
            context.left.emplace_back(step.at[0], step.at[1], step.at[2]);
        if (i < done_before) continue;
        const KindOfStep& kind = kind_of_step(step.kind);
        const double n = double(recipe.size());
        detail::StepResult done = kind.run(*result.mesh, step, context,
                                           progress.part(double(i) / n, double(i + 1) / n, kind.label));
        if (done.mesh && done.mesh->facets.empty())
            throw Error(ErrorCode::empty_result, strict::element(repair_list.key, i),
                        "the step " + repair_kind_name(step.kind) + " leaves no facet",
                        "give it a smaller limit");
        if (done.mesh) result.mesh = std::move(done.mesh);
        result.steps.push_back(
            {step.kind, done.displacement, std::move(done.counts), result.mesh->facet_count()});
    }
    return result;
}

namespace detail {

MeshPtr with_facets(const Mesh& mesh, const std::vector<char>& stays, const Progress& progress) {
    auto rest = std::make_shared<Mesh>();
    rest->vertices = mesh.vertices;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        if (stays[f]) rest->facets.push_back(mesh.facets[f]);
    drop_unused_vertices(*rest, progress);
    return rest;
}

} // namespace detail

} // namespace facetmill
