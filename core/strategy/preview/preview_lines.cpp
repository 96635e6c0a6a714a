#include "core/strategy/preview/preview_lines.h"

#include "core/base/parallel.h"
#include "core/strategy/curves/curve_job.h"
#include "core/strategy/plan/budget.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// More lines than this are not told apart in a view.
constexpr std::size_t max_lines = 700;
/// The share of a line that may be steeper than what its neighbour's distance comes from: partial passes lie
/// there.
constexpr double steeper_share = 0.25;
/// No line is nearer to its neighbour than this share of the step on level ground.
constexpr double nearest_share = 0.15;

} // namespace

double share_below(std::vector<double>& values, double share) {
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

double PreviewStep::on_slope(double rise) const {
    if (fixed) return level;
    const double along = 1 / std::sqrt(1 + rise * rise), up = std::abs(rise) * along;
    const double steps = up > 0 ? cusp / up : infinity;
    return std::min(level, std::max({corner * along, steps, nearest_share * level}));
}

double PreviewStep::down(double rise) const {
    const double along = 1 / std::sqrt(1 + rise * rise), up = std::abs(rise) * along;
    return std::max(corner * up, along > 0 ? cusp / along : infinity);
}

PreviewStep preview_step(const OperationCommon& common, const NumberOrWord& asked, const NumberOrWord& chord,
                         const PlanContext& context) {
    const double budget = cusp_budget(common, context);
    PreviewStep step;
    step.cusp = standing_cusp(budget, chord_budget(chord, budget));
    const AptCutter shape = context.tool.cutter();
    const CutterCover cover(CutterProfile(shape), cusp_detail(budget));
    step.level = asked.is_number() ? asked.number : level_step_of(cover, step.cusp);
    step.fixed = asked.is_number();
    step.corner = 2 * std::sqrt(std::max(2 * shape.r * step.cusp - step.cusp * step.cusp, 0.0));
    return step;
}

std::vector<char> cells_on(const std::vector<char>& cells, const CoarseGrid& from, const CoarseGrid& to) {
    if (cells.empty()) return {};
    std::vector<char> on(to.size(), 0);
    for (std::size_t i = 0; i < on.size(); ++i) {
        const Vec2 p = to.middle(i);
        const int x = from.column(p.x()), y = from.row(p.y());
        on[i] = from.has(x, y) ? cells[from.index(x, y)] : char(0);
    }
    return on;
}

PreviewField::PreviewField(const PreviewRequest& request, const OperationCommon& common,
                           const CutterProfile& cutter, double allowance, const Interval& slopes,
                           const Progress& progress)
    : tips_(request.ground, cutter, allowance, progress) {
    const CoarseGrid &base = request.ground->grid(), &ground = tips_.ground().grid();
    const std::vector<char> asked = cells_on(request.asked, base, ground);
    std::vector<float> inside, off;
    if (!asked.empty() && common.contain == Containment::tool) {
        std::vector<char> others(asked.size());
        for (std::size_t i = 0; i < asked.size(); ++i)
            others[i] = asked[i] == 0;
        inside = distance_from(others, ground);
    }
    if (!request.avoided.empty()) off = distance_from(cells_on(request.avoided, base, ground), ground);
    const bool all_slopes = slopes.lo <= 0 && slopes.hi >= 0.5 * pi;
    kept_.assign(grid().size(), 0);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        if (i % 8192 == 0) progress.check();
        if (!tips_.on_surface(i)) continue;
        const int below = tips_.below(i);
        if (!asked.empty()) {
            if (common.contain == Containment::contact && !asked[std::size_t(tips_.holder(i))]) continue;
            if (common.contain != Containment::contact && (below < 0 || !asked[std::size_t(below)])) continue;
            if (!inside.empty() && double(inside[std::size_t(below)]) < tips_.radius()) continue;
        }
        const int near = below >= 0 ? below : tips_.holder(i);
        if (!off.empty() && double(off[std::size_t(near)]) < tips_.radius() + common.avoid_distance) continue;
        if (!all_slopes) {
            const double slope = tips_.slope(i);
            if (slope < slopes.lo || slope > slopes.hi) continue;
        }
        kept_[i] = 1;
        any_ = true;
    }
}

bool PreviewField::kept(const Vec2& p) const {
    const int x = grid().column(p.x()), y = grid().row(p.y());
    return grid().has(x, y) && kept(grid().index(x, y));
}

template <class Height>
void PreviewField::lay_by(const PlanLine& line, const Height& height,
                          std::vector<std::vector<Vec3>>& lines) const {
    std::vector<Vec3> run;
    const auto end_run = [&] {
        if (run.size() > 1) lines.push_back(std::move(run));
        run.clear();
    };
    const auto go = [&](const Vec2& p) {
        const std::optional<double> z = kept(p) ? height(p) : std::nullopt;
        if (!z) return end_run();
        const Vec3 q(p.x(), p.y(), *z);
        // Straight on over level ground: the last point moves on.
        const std::size_t n = run.size();
        if (n > 1) {
            const Vec3 d = q - run[n - 2];
            const Vec3 off = run[n - 1] - run[n - 2];
            if (off.cross(d).norm() <= 0.02 * grid().cell * d.norm() && off.dot(d) > 0) {
                run[n - 1] = q;
                return;
            }
        }
        run.push_back(q);
    };
    along_line(line, grid().cell, go);
    end_run();
}

void PreviewField::lay(const PlanLine& line, double rise, double low,
                       std::vector<std::vector<Vec3>>& lines) const {
    lay_by(
        line,
        [&](const Vec2& p) -> std::optional<double> {
            const auto z = tips_.height(p);
            if (!z) return std::nullopt;
            return std::max(*z + rise, low);
        },
        lines);
}

std::optional<double> PreviewField::step_over(const PlanLine& line, const Vec2& across,
                                              const PreviewStep& step) const {
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2 d = line[i + 1] - line[i];
        const int looks = std::max(1, int(std::ceil(d.norm() / grid().cell)));
        for (int k = 0; k < looks; ++k) {
            const Vec2 p = line[i] + double(k) / looks * d;
            if (!kept(p)) continue;
            const std::size_t tip = grid().index(grid().column(p.x()), grid().row(p.y()));
            steps.push_back(step.on_slope(tips_.rise(tip).dot(across)));
        }
    }
    if (steps.empty()) return std::nullopt;
    return share_below(steps, steeper_share);
}

double PreviewField::step_everywhere(const PreviewStep& step) const {
    std::vector<double> steps;
    for (std::size_t i = 0; i < kept_.size(); ++i)
        // Of what slopes, half slopes across the passes.
        if (kept(i)) steps.push_back(step.on_slope(std::sqrt(0.5) * tips_.rise(i).norm()));
    return steps.empty() ? step.level : share_below(steps, steeper_share);
}

Interval PreviewField::extent(const Vec2& along) const {
    Interval extent{infinity, -infinity};
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        if (!kept(i)) continue;
        const double s = grid().middle(i).dot(along);
        extent.lo = std::min(extent.lo, s);
        extent.hi = std::max(extent.hi, s);
    }
    return extent;
}

void lay_lines(const std::vector<PlanLine>& lines,
               const std::function<void(const PlanLine&, std::vector<std::vector<Vec3>>&)>& lay,
               PassPreview& preview, const Progress& progress) {
    const std::size_t every = std::max<std::size_t>(1, (lines.size() + max_lines - 1) / max_lines);
    std::vector<std::vector<std::vector<Vec3>>> laid((lines.size() + every - 1) / every);
    parallel_for(laid.size(), 1, progress, [&](std::size_t i) { lay(lines[i * every], laid[i]); });
    preview.drawn_every = std::max(preview.drawn_every, every);
    preview.passes += lines.size();
    for (auto& pieces : laid)
        for (auto& piece : pieces)
            preview.lines.push_back(std::move(piece));
}

std::vector<PlanLine> parallel_lines(const PreviewField& field, double direction, const PreviewStep& step,
                                     const Progress& progress) {
    const DriveFrame frame(direction);
    const Interval u = field.extent(frame.along), v = field.extent(frame.across);
    std::vector<PlanLine> lines;
    if (!field.any_kept()) return lines;
    const double half = 0.5 * field.grid().cell;
    constexpr std::size_t too_many = 100'000;
    for (double at = v.lo + std::min(0.5 * step.level, 0.5 * (v.hi - v.lo));;) {
        progress.check();
        PlanLine line{frame.xy(u.lo - half, at), frame.xy(u.hi + half, at)};
        const double advance = field.step_over(line, frame.across, step).value_or(step.level);
        lines.push_back(std::move(line));
        const double rest = v.hi - at;
        // The last one lies at the border, or half a step before it.
        if (rest < 0.5 * advance || lines.size() > too_many) break;
        at = rest < advance ? v.hi : at + advance;
    }
    return lines;
}

} // namespace facetmill
