#include "core/job/preview_job.h"

#include "core/job/axis_view.h"
#include "core/job/bounds.h"
#include "core/strategy/preview/coarse_tips.h"
#include "core/strategy/preview/preview_levels.h"
#include "core/strategy/preview/preview_turning.h"
#include "core/strategy/surface/travel_direction.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Axes whose views are kept.
constexpr std::size_t max_views = 2;

/// Which of a ground's cells a curve goes round.
std::vector<char> cells_in_curve(const Boundary& boundary, const Mat3& turn, const CoarseGrid& grid,
                                 const Progress& progress) {
    std::vector<PlanEdge> edges;
    const std::vector<Vec2> at = curve_seen(boundary, turn).points;
    for (std::size_t i = 0; i < at.size(); ++i)
        edges.push_back({at[i], at[(i + 1) % at.size()]});
    const PlanRegion region(std::move(edges), progress);
    std::vector<char> cells(grid.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i % 1024 == 0) progress.check();
        cells[i] = region.depth(grid.middle(i)) >= -boundary.offset;
    }
    return cells;
}

/// Where a tool that has been everywhere leaves more than so much.
std::vector<char> cells_left_by(const CutterProfile& cutter, double more_than,
                                const std::shared_ptr<const CoarseGround>& ground, const Progress& progress) {
    const CoarseTips tips(ground, cutter, 0, progress.part(0, 0.5));
    const std::vector<float> left = tips.left_heights(progress.part(0.5, 1));
    std::vector<char> cells(left.size());
    const CoarseGround& own = tips.ground();
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = own.on_part(i) && double(left[i] - own.height()[i]) > more_than;
    return cells_on(cells, own.grid(), ground->grid());
}

/// Cells no farther than `by` from some, or no nearer than that to the others.
std::vector<char> grown_cells(std::vector<char> cells, double by, const CoarseGrid& grid) {
    if (by == 0) return cells;
    if (by < 0)
        for (char& c : cells)
            c = !c;
    const std::vector<float> distance = distance_from(cells, grid);
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = by > 0 ? double(distance[i]) <= by : double(distance[i]) > -by;
    return cells;
}

bool has_travel(const Operation& operation) {
    return operation.has("direction") && !operation.turning();
}

} // namespace

PassPreviewer::View& PassPreviewer::view(const PreparedPart& part, const Mat3& turn,
                                         const Progress& progress) {
    const auto known = std::ranges::find_if(
        views_, [&](const View& v) { return v.kept_off == part.kept_off && v.turn == turn; });
    if (known != views_.end()) {
        std::rotate(views_.begin(), known, known + 1);
        return views_.front();
    }
    std::erase_if(views_, [&](const View& v) { return v.kept_off != part.kept_off; });
    View made;
    made.kept_off = part.kept_off;
    made.turn = turn;
    made.part = turn == Mat3::Identity() ? part.mesh : turned_mesh(part.mesh, turn);
    made.ground = std::make_shared<const CoarseGround>(*part.kept_off, part.mesh->facet_count(), turn,
                                                       preview_cells, progress);
    views_.insert(views_.begin(), std::move(made));
    if (views_.size() > max_views) views_.pop_back();
    return views_.front();
}

std::shared_ptr<const TurnedGround> PassPreviewer::turned(const MeshPtr& part, const LatheCommon& settings,
                                                          const PlanContext& context,
                                                          const Progress& progress) {
    const TurningAxis axis = LatheFrame(settings, context).axis();
    if (part != turned_part_ || !turned_ || axis.point != axis_.point || axis.direction != axis_.direction) {
        turned_ = std::make_shared<const TurnedGround>(settings, context, preview_cells, progress);
        turned_part_ = part;
        axis_ = axis;
    }
    return turned_;
}

std::vector<char> PassPreviewer::cells(const Project& project, const std::string& name,
                                       const PreparedPart& part, const View& view,
                                       const Progress& progress) const {
    const CoarseGround& ground = *view.ground;
    const CoarseGrid& grid = ground.grid();
    const Boundary boundary = with_facets_of_faces(project.boundary_of(name), part);
    std::vector<char> cells(grid.size(), 0);
    switch (boundary.kind) {
    case Boundary::Kind::curve:
        cells = cells_in_curve(boundary, view.turn, grid, progress);
        break;
    case Boundary::Kind::silhouette:
        for (std::size_t i = 0; i < cells.size(); ++i)
            cells[i] = ground.on_part(i);
        cells = grown_cells(std::move(cells), boundary.offset, grid);
        break;
    case Boundary::Kind::rest:
        if (const auto cutter = project.cutter_of(boundary))
            cells = cells_left_by(CutterProfile(*cutter), boundary.more_than, view.ground, progress);
        cells = grown_cells(std::move(cells), boundary.offset, grid);
        break;
    default: {
        const std::vector<char> facets = boundary_facets(boundary, *view.part);
        for (std::size_t i = 0; i < cells.size(); ++i)
            cells[i] = ground.on_part(i) && facets[ground.facet()[i]];
        // Those are inverted already.
        return cells;
    }
    }
    if (boundary.invert)
        for (char& c : cells)
            c = !c;
    return cells;
}

PassPreview PassPreviewer::preview(const Project& project, std::size_t i, const PreparedPart& part,
                                   const Progress& progress, std::size_t max_facets) {
    const Operation& operation = *project.operations.at(i);
    if (part.mesh->facet_count() > max_facets)
        throw Error(ErrorCode::limit_exceeded, operation.common().name,
                    "the part has " + std::to_string(part.mesh->facet_count())
                        + " facets: passes are previewed up to " + std::to_string(max_facets),
                    "plan the operation to see its passes");
    PreviewRequest request;
    request.context = preview_context(project, i, part, {});
    request.context.further_tools = project.further_tools_of(operation);
    if (operation.turning()) {
        request.turned = turned(part.mesh, *operation.turning(), request.context, progress.part(0, 0.4));
        return preview_passes(operation, request, progress.part(0.4, 1));
    }

    request.turn = operation.is_indexed() ? turn_upright(operation.tool_axis()) : Mat3::Identity();
    View& view = this->view(part, request.turn, progress.part(0, 0.4));
    request.ground = view.ground;
    PlanContext& context = request.context;
    context.part = view.part;
    if (operation.is_indexed()) {
        context.geometry = nullptr;
        context.part_box = view.part->box();
        context.stock = turned_stock(context.stock, view.turn);
        context.stock_box = context.stock.box;
        context.to_setup = view.turn.transpose();
    }
    const OperationCommon& common = operation.common();
    if (has_travel(operation)) {
        if (common.direction.is("auto")) {
            if (!view.travel)
                view.travel = travel_direction(common.direction, context, progress.part(0.4, 0.5));
            request.travel = *view.travel;
        } else {
            request.travel = travel_direction(common.direction, context, progress);
        }
    }
    if (!common.boundary.empty())
        request.asked = cells(project, common.boundary, part, view, progress.part(0.5, 0.6));
    if (!common.avoid.empty())
        request.avoided = cells(project, common.avoid, part, view, progress.part(0.6, 0.7));
    for (const std::string& name : operation.curve_names()) {
        NamedCurves curves{name, {}};
        const Boundary* boundary = name.empty() ? nullptr : &project.boundary_of(name);
        if (boundary && boundary->kind == Boundary::Kind::curve) {
            curves.all.push_back(curve_seen(*boundary, view.turn));
        } else if (boundary) {
            curves.all = cell_outlines(cells(project, name, part, view, progress), view.ground->grid());
        }
        context.curves.push_back(std::move(curves));
    }
    return preview_passes(operation, request, progress.part(0.7, 1));
}

} // namespace facetmill
