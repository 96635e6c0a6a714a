#include "core/study/previewed.h"

#include "core/base/tolerances.h"
#include "core/job/axis_view.h"
#include "core/job/project_setup.h"
#include "core/job/work_estimate.h"
#include "core/strategy/preview/coarse_tips.h"
#include "core/strategy/surface/slope_facets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

/// Planning and judging passes as long as the cutter's radius: a guess from finishing one scan, a head of 98
/// mm.
constexpr double seconds_a_radius = 0.01;
/// Ends of passes that are no farther apart than so many step-overs are linked at feed.
constexpr double linked_steps = 3;

double seconds_of_lines(const PassPreview& preview, const OperationCommon& common, const Machine& machine,
                        double top, double radius) {
    const double feed = common.feed / 60, rapid = machine.rapid_mm_per_s.minCoeff();
    const double near =
        linked_steps * (preview.step > 0 ? preview.step : radius) * double(preview.drawn_every);
    double at_feed = preview.length(), in_rapids = 0;
    const Vec3* last = nullptr;
    for (const std::vector<Vec3>& line : preview.lines) {
        if (line.empty()) continue;
        if (last) {
            const double apart = (line.front() - *last).norm();
            if (apart <= near)
                at_feed += apart;
            else
                in_rapids +=
                    apart + 2 * std::max(top + common.clearance - std::min(last->z(), line.front().z()), 0.0);
        }
        last = &line.back();
    }
    return double(preview.drawn_every) * (at_feed / feed + in_rapids / rapid);
}

/// The stock over a ground's cells, lowered by a cutter.
class CoarseStock {
public:
    CoarseStock(const CoarseGround& ground, const CutterProfile& cutter)
        : ground_(ground), low_(ground.grid().size(), -nothing_there) {
        const double cell = ground.grid().cell;
        const int reach = int(std::ceil(cutter.max_radius() / cell));
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x)
                if (const double away = cell * std::hypot(x, y); away <= cutter.max_radius())
                    under_.push_back({x, y, float(cutter.height_at(away))});
    }

    void cut(const std::vector<Vec3>& line) {
        const double cell = ground_.grid().cell;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const Vec3& from = line[i > 0 ? i - 1 : 0];
            const Vec3 step = line[i] - from;
            const int steps = std::max(1, int(std::ceil(step.head<2>().norm() / cell)));
            for (int k = 1; k <= steps; ++k)
                cut(Vec3(from + double(k) / steps * step));
        }
    }

    double uncut_share(double allowed) const {
        const CoarseGrid& grid = ground_.grid();
        std::size_t all = 0, uncut = 0;
        for (std::size_t i = 0; i < grid.size(); ++i) {
            if (!ground_.on_part(i)) continue;
            ++all;
            // Half a cell aside the surface is as much higher or lower.
            uncut += double(low_[i] - ground_.height()[i]) > allowed + grid.cell * (1 + rise(i));
        }
        return all > 0 ? double(uncut) / double(all) : 0;
    }

private:
    void cut(const Vec3& tip) {
        const CoarseGrid& grid = ground_.grid();
        const int x = grid.column(tip.x()), y = grid.row(tip.y());
        for (const Under& u : under_) {
            if (!grid.has(x + u.x, y + u.y)) continue;
            float& low = low_[grid.index(x + u.x, y + u.y)];
            low = std::min(low, float(tip.z()) + u.z);
        }
    }
    /// By how much a cell's neighbours lie higher or lower, over a cell.
    double rise(std::size_t i) const {
        const CoarseGrid& grid = ground_.grid();
        const int x = int(i % std::size_t(grid.columns)), y = int(i / std::size_t(grid.columns));
        const std::vector<float>& height = ground_.height();
        double most = 0;
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
            if (!grid.has(x + dx, y + dy)) continue;
            const float other = height[grid.index(x + dx, y + dy)];
            if (is_there(other)) most = std::max(most, std::abs(double(other - height[i])));
        }
        return most / grid.cell;
    }

    struct Under {
        int x, y;
        float z;
    };
    const CoarseGround& ground_;
    std::vector<Under> under_;
    std::vector<float> low_;
};

/// Contacts of a tool that leans: it cuts what lies beside them by half a strip.
double uncut_beside(const PassPreview& preview, const CoarseGround& ground) {
    const CoarseGrid& grid = ground.grid();
    std::vector<char> met(grid.size());
    for (const std::vector<Vec3>& line : preview.lines)
        for (const Vec3& p : line)
            if (const int x = grid.column(p.x()), y = grid.row(p.y()); grid.has(x, y))
                met[grid.index(x, y)] = 1;
    const std::vector<float> away = distance_from(met, grid);
    std::size_t all = 0, uncut = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (!ground.on_part(i)) continue;
        ++all;
        uncut += double(away[i]) > double(preview.drawn_every) * preview.step + 2 * preview.spacing;
    }
    return all > 0 ? double(uncut) / double(all) : 0;
}

/// Of the surface that faces a tool turned upright by `turn`, without walls along it, which ask for no pass.
double share_beyond(const Interval& slopes, const Mesh& mesh, const Mat3& turn, const Progress& progress) {
    const std::vector<double> slope = facet_slopes(mesh, false, turn, progress);
    const double upright = std::acos(tolerance::vertical_normal_z);
    double all = 0, beyond = 0;
    for (std::size_t f = 0; f < slope.size(); ++f) {
        if (slope[f] > upright) continue;
        const double area = mesh.facet_cross(f).norm();
        all += area;
        if (slope[f] < slopes.lo || slope[f] > slopes.hi) beyond += area;
    }
    return all > 0 ? beyond / all : 0;
}

} // namespace

PreviewedOperation previewed_operation(PassPreviewer& previewer, const Project& project, std::size_t i,
                                       const PreparedPart& part, const Progress& progress) {
    const Operation& operation = *project.operations.at(i);
    const OperationCommon& common = operation.common();
    const PassPreview preview =
        previewer.preview(project, i, part, progress.part(0, 0.6), std::numeric_limits<std::size_t>::max());
    const CutterProfile cutter(project.tool_of(operation).cutter());
    PreviewedOperation made;
    made.seconds = seconds_of_lines(preview, common, project_machine(project), part.mesh->box().hi.z(),
                                    cutter.max_radius());
    made.planning_seconds = seconds_a_radius * preview.estimated_length() / cutter.max_radius();
    for (const WorkEstimate& work : estimate_plan(project, part, common.name))
        made.planning_seconds = std::max(made.planning_seconds, work.seconds);
    if (operation.turning()) return made;
    const auto ground = previewer.ground(part, progress.part(0.6, 0.7));
    // A ball that may be inclined cuts what it cuts upright.
    if (!operation.keeps_axis() && !operation.has("tilt_limit")) {
        made.uncut_share = uncut_beside(preview, *ground);
        return made;
    }
    // Of the tips' ground, whose cells are as coarse as the cutter lets them be.
    const CoarseTips tips(ground, cutter, common.allowance, progress.part(0.7, 0.8));
    CoarseStock stock(tips.ground(), cutter);
    const Progress cutting = progress.part(0.8, 1);
    for (std::size_t k = 0; k < preview.lines.size(); ++k) {
        cutting.set(double(k) / double(preview.lines.size()));
        stock.cut(preview.lines[k]);
    }
    const double every = double(preview.drawn_every);
    made.uncut_share = stock.uncut_share(common.allowance + every * every * common.tolerance);
    // A grid seen from above has few cells on what is steep, and forgives much there.
    if (const auto slopes = slope_limits_of(operation))
        made.uncut_share =
            std::max(made.uncut_share,
                     share_beyond(*slopes, *part.mesh, turn_upright(operation.tool_axis()), progress));
    return made;
}

} // namespace facetmill
