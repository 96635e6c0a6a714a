#include "core/strategy/preview/preview_scallop.h"

#include "core/base/parallel.h"
#include "core/strategy/scallop/field_contours.h"
#include "core/strategy/scallop/field_distances.h"
#include "core/strategy/surface/boundary_region.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// More passes are not told apart in a view; more than the other no plan has.
constexpr double max_drawn_scallops = 200, max_scallops = 20'000;
/// Steps from the border, from a place and from a curve, which is a pass itself, to the first pass.
constexpr double from_border = 0.3, from_place = 0.5, from_curve = 1;
/// Distances are known to that, in steps.
constexpr double settled_steps = 0.02;

/// How far a displacement is, in steps, by the slope of each tip.
class ScallopGrid {
public:
    ScallopGrid(const PreviewField& field, double rounding, const PreviewStep& step) : field_(field) {
        const CoarseGrid& grid = field.grid();
        cut_.resize(grid.size());
        metric_.resize(grid.size());
        for (std::size_t i = 0; i < cut_.size(); ++i) {
            cut_[i] = field.kept(i) ? char(1) : char(0);
            if (!cut_[i]) continue;
            const Vec2 rise = field.tips().rise(i);
            const double r = rise.norm();
            const Vec2 fall = r > 1e-9 ? Vec2(rise / r) : Vec2(1, 0), level(-fall.y(), fall.x());
            double down = step.on_slope(r), along = step.level;
            if (step.fixed) {
                down = step.level / std::sqrt(1 + r * r);
            } else if (r > 0) {
                // A disc that is tilted bends as a larger circle across the slope.
                const double disc = field.tips().radius() - rounding, sine = r / std::sqrt(1 + r * r);
                along = std::min(along, 2 * std::sqrt(2 * step.cusp * (rounding + disc / sine)));
            }
            const double a = 1 / (down * down), b = 1 / (along * along);
            metric_[i] = {a * fall.x() * fall.x() + b * level.x() * level.x(),
                          a * fall.x() * fall.y() + b * level.x() * level.y(),
                          a * fall.y() * fall.y() + b * level.y() * level.y()};
        }
    }
    MetricGrid grid() const {
        const CoarseGrid& grid = field_.grid();
        return {grid.origin, grid.cell, grid.columns, grid.rows, cut_, metric_};
    }
    std::vector<std::size_t> border() const {
        const MetricGrid all = grid();
        std::vector<std::size_t> found;
        const auto in = [&](int c, int r) { return all.has(c, r) && cut_[all.number(c, r)] != 0; };
        for (int r = 0; r < all.rows; ++r)
            for (int c = 0; c < all.columns; ++c)
                if (in(c, r) && !(in(c - 1, r) && in(c + 1, r) && in(c, r - 1) && in(c, r + 1)))
                    found.push_back(all.number(c, r));
        return found;
    }
    /// The cells round a place, as far from it as they are.
    void seed(const Vec2& p, std::vector<MetricGrid::Seed>& seeds) const {
        const MetricGrid all = grid();
        const Vec2 at = (p - all.lo) / all.spacing;
        const auto column = int(std::floor(at.x())), row = int(std::floor(at.y()));
        for (const int r : {row, row + 1})
            for (const int c : {column, column + 1}) {
                if (!all.has(c, r) || !cut_[all.number(c, r)]) continue;
                const std::size_t i = all.number(c, r);
                const Vec2 d = all.place(i) - p;
                const auto& [xx, xy, yy] = metric_[i];
                seeds.push_back(
                    {i, std::sqrt(xx * d.x() * d.x() + 2 * xy * d.x() * d.y() + yy * d.y() * d.y())});
            }
    }
    std::size_t nearest(const Vec2& p) const {
        std::size_t best = 0;
        double best2 = infinity;
        for (std::size_t i = 0; i < cut_.size(); ++i)
            if (const double d2 = cut_[i] ? (field_.grid().middle(i) - p).squaredNorm() : infinity;
                d2 < best2) {
                best = i;
                best2 = d2;
            }
        return best;
    }

private:
    const PreviewField& field_;
    std::vector<char> cut_;
    std::vector<MetricGrid::Metric> metric_;
};

/// Where passes begin: the first lies at `first`.
struct ScallopStart {
    std::vector<PlanLine> lines; ///< passes themselves
    std::vector<MetricGrid::Seed> seeds;
    double first = from_border;
};

ScallopStart start_of(const ScallopGrid& grid, const PreviewField& field, const ScallopSettings& settings,
                      const PreviewRequest& request) {
    ScallopStart start;
    const auto& curves = request.context.curves;
    if (settings.from == ScallopSettings::From::place) {
        const Vec3 place(settings.place[0], settings.place[1], settings.place[2]);
        start.first = from_place;
        start.seeds.push_back({grid.nearest((request.turn * place).head<2>()), 0});
    } else if (settings.from == ScallopSettings::From::curve && !curves.empty() && !curves[0].all.empty()) {
        start.first = from_curve;
        for (const PlanCurve& curve : ready_to_follow(curves[0].all, settings.open)) {
            PlanLine line = curve.points;
            if (curve.closed) line.push_back(line.front());
            along_line(line, 0.5 * field.grid().cell, [&](const Vec2& p) {
                if (field.kept(p)) grid.seed(p, start.seeds);
            });
            start.lines.push_back(std::move(line));
        }
        if (start.seeds.empty())
            throw Error(ErrorCode::out_of_range, boundary_place(settings.curve),
                        "all of it lies off the part", "move it onto the part");
    } else {
        for (const std::size_t i : grid.border())
            start.seeds.push_back({i, 0});
    }
    return start;
}

} // namespace

void lay_scallops(const PreviewField& field, const ScallopSettings& settings, const PreviewRequest& request,
                  const PreviewStep& step, PassPreview& preview, const Progress& progress) {
    const AptCutter cutter = request.context.tool.cutter();
    const ScallopGrid grid(field, std::min(cutter.r, field.tips().radius()), step);
    ScallopStart start = start_of(grid, field, settings, request);
    std::vector<double> distance =
        field_distances(grid.grid(), start.seeds, progress.part(0, 0.5), settled_steps);
    // Pieces that nothing comes to are cut from their own borders.
    const std::size_t before = start.seeds.size();
    for (const std::size_t i : grid.border())
        if (!(distance[i] < infinity)) start.seeds.push_back({i, start.first - from_border});
    if (start.seeds.size() > before)
        distance = field_distances(grid.grid(), start.seeds, progress.part(0.5, 0.7), settled_steps);
    double most = 0;
    for (const double d : distance)
        if (d < infinity) most = std::max(most, d);
    if (most > max_scallops)
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "it asks for more than " + format_number(max_scallops) + " passes",
                    "allow a larger tolerance or set a step-over");
    const auto passes = std::size_t(std::max(1.0, std::ceil(most - start.first)));
    const auto every = std::size_t(std::ceil(double(passes) / max_drawn_scallops));
    std::vector<double> values;
    for (std::size_t k = 0; k < passes; k += every)
        values.push_back(start.first + double(k));
    // What is smaller than a step gets a pass in its middle.
    if (!(values.front() < most)) values = {0.5 * most};
    auto contours = field_contours(grid.grid(), distance, values, progress.part(0.7, 0.9));
    std::vector<std::vector<std::vector<Vec3>>> laid(contours.size());
    parallel_for(laid.size(), 1, progress.part(0.9, 1), [&](std::size_t k) {
        for (FieldContour& contour : contours[k]) {
            if (contour.closed) contour.places.push_back(contour.places.front());
            field.lay(contour.places, 0, -infinity, laid[k]);
        }
    });
    for (const PlanLine& line : start.lines)
        field.lay(line, 0, -infinity, preview.lines);
    for (auto& lines : laid)
        std::move(lines.begin(), lines.end(), std::back_inserter(preview.lines));
    preview.passes += passes + start.lines.size();
    preview.drawn_every = std::max(preview.drawn_every, every);
}

} // namespace facetmill
