#include "core/strategy/preview/preview_flow.h"

#include "core/mesh/refine.h"
#include "core/strategy/five_axis/flow_map.h"
#include "core/strategy/surface/slice.h"

#include <cmath>

namespace facetmill {

namespace {

/// Between pieces of the ground, in steps.
constexpr double gap_steps = 2;
constexpr double max_flow_lines = 20'000;
/// Walls are steeper than this: between them the ground is in pieces.
const double min_facing = std::cos(radians(80));

} // namespace

std::vector<PlanLine> flow_lines(const PreviewField& field, const PreviewRequest& request,
                                 const PreviewStep& step, const std::vector<char>& without,
                                 const Progress& progress) {
    const Mesh ground = request.ground->mesh();
    std::vector<Index> cut;
    const CoarseGrid& grid = request.ground->grid();
    const auto is_others = [&](const Vec3& p) {
        const int x = grid.column(p.x()), y = grid.row(p.y());
        if (without.empty() || !grid.has(x, y)) return false;
        const Index facet = request.ground->facet()[grid.index(x, y)];
        return facet < without.size() && without[facet] != 0;
    };
    for (std::size_t f = 0; f < ground.facet_count(); ++f) {
        const Vec3 middle = (ground.corner(f, 0) + ground.corner(f, 1) + ground.corner(f, 2)) / 3;
        if (ground.facet_normal(f).z() >= min_facing && field.kept(Vec2(middle.x(), middle.y()))
            && !is_others(middle))
            cut.push_back(Index(f));
    }
    if (cut.empty()) return {};
    const Mesh mesh = part_of(ground, cut).mesh;
    const DriveFrame frame(request.travel);
    const double apart = field.step_everywhere(step);
    const PassMap map = flow_map(mesh, frame, gap_steps * apart, progress.part(0, 0.9));
    const auto geometry = compute_geometry(mesh, progress.part(0.9, 1));
    const MeshSlicer slicer(mesh, *geometry, frame, progress.part(1, 1), &map);
    const double every = apart * map.flattest_v;
    if ((slicer.hi() - slicer.lo()) / every > max_flow_lines)
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "it asks for more than " + format_number(max_flow_lines) + " passes",
                    "allow a larger tolerance or set a step-over");
    std::vector<PlanLine> lines;
    for (double v = slicer.lo() + 0.5 * every; v < slicer.hi(); v += every) {
        progress.check();
        for (const SliceChain& chain : slicer.slice(v)) {
            PlanLine line;
            for (const SlicePoint& p : chain.points)
                line.emplace_back(p.point.x(), p.point.y());
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

} // namespace facetmill
