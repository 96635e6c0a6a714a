#include "core/strategy/lathe/lathe_rough.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/lathe/lathe_path.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/plan_text.h"

#include <cmath>

namespace facetmill {

namespace {

const OperationRegistration rough_registration("lathe_rough", "Rough, turning part",
                                               [] { return std::make_unique<LatheRough>(); });

/// Points that a thread takes at a time.
constexpr std::size_t points_per_block = 256;
/// Passes of a plan, at most: more come from a part in another unit.
constexpr double max_passes = 10000;
/// In diameters of the cutter: gaps with nothing to cut that are shorter are passed at feed.
constexpr double joined_gap = 2;
/// Less than this share of the depth of cut is nothing to cut, nor less than the chord tolerance.
constexpr double min_share = 1e-3;

/// A stretch of points of the path.
struct Run {
    std::size_t first, last;
};

/// One pass after the other over the points of the path.
class Rougher {
public:
    Rougher(const LatheRoughSettings& settings, const PlanContext& context, const LathePath& path)
        : settings_(settings), context_(context), text_{context.unit}, path_(path), result_(path.base()) {}

    StrategyResult run(const Progress& progress) {
        find_stock(progress.part(0, 0.5));
        const auto& points = path_.points();
        const std::size_t n = points.size();
        double top = -infinity, low = infinity;
        for (std::size_t i = 0; i < n; ++i)
            if (stock_[i] > points[i].u) {
                top = std::max(top, stock_[i]);
                low = std::min(low, points[i].u);
            }
        const double least = std::max(min_share * settings_.depth_of_cut, result_.chord_tolerance);
        if (!(top - low > least))
            throw_no_stock_above(settings_.name, settings_.allowance + settings_.finishing_allowance,
                                 context_.unit);
        const double wanted = (top - low) / settings_.depth_of_cut;
        if (wanted > max_passes)
            throw Error(ErrorCode::limit_exceeded, "depth_of_cut",
                        "the depth of cut asks for more than " + format_number(max_passes) + " passes",
                        "choose a larger depth of cut");
        if (settings_.depth_of_cut > top - low)
            result_.warnings.push_back("the depth of cut of " + text_(settings_.depth_of_cut)
                                       + " is more than the " + text_(top - low)
                                       + " that stand above the part: one pass takes all");
        const int passes = std::max(1, int(std::ceil(wanted - tolerance::level_angle)));
        std::vector<double> before = stock_, now(n);
        for (int k = 0; k < passes; ++k) {
            progress.part(0.5, 1).set(double(k) / passes);
            // U_selected; the last one is the deepest place of the part.
            const double selected = k + 1 == passes ? low : top - settings_.depth_of_cut * (k + 1);
            for (std::size_t i = 0; i < n; ++i)
                now[i] = std::max(selected, points[i].u);
            cut_pass(k, selected, before, now, least, progress);
            for (std::size_t i = 0; i < n; ++i)
                before[i] = std::min(before[i], now[i]);
        }
        result_.drive_planes = int(turned().layers.size());
        if (deepest_ > context_.tool.flute_length)
            result_.warnings.push_back("passes are up to " + text_(deepest_)
                                       + " below the stock's outside, the flutes are "
                                       + text_(context_.tool.flute_length) + " long: use a longer tool");
        progress.set(1);
        return std::move(result_);
    }

private:
    TurnedPath& turned() { return std::get<TurnedPath>(result_.detail); }

    /// Where the cutter meets the raw material on its way in.
    void find_stock(const Progress& progress) {
        const LatheStock stock(path_.field().frame(), context_, LatheStock::Of::cutter,
                               progress.part(0, 0.1));
        const auto& points = path_.points();
        stock_.resize(points.size());
        parallel_blocks(points.size(), points_per_block, progress.part(0.1, 1),
                        [&](std::size_t begin, std::size_t end) {
                            LatheStock::Hint hint;
                            for (std::size_t i = begin; i < end; ++i)
                                stock_[i] = stock.u(points[i].place, hint);
                        });
    }

    void cut_pass(int number, double selected, const std::vector<double>& before,
                  const std::vector<double>& now, double least, const Progress& progress) {
        const auto& points = path_.points();
        const double radius = path_.field().part_radius();
        const double gap = joined_gap * 2 * path_.field().cover().radius();
        // Motions that cut: either end is deeper than what was there.
        std::vector<Run> runs;
        double since = 0; // length since the last run
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (i % points_per_block == 0) progress.check();
            const auto cuts = [&](std::size_t k) { return now[k] < before[k] - least; };
            const double length = lathe_distance(points[i - 1].place, points[i].place, radius);
            if (!cuts(i - 1) && !cuts(i)) {
                since += length;
                continue;
            }
            if (!runs.empty() && since <= gap)
                runs.back().last = i;
            else
                runs.push_back({i - 1, i});
            since = 0;
        }
        if (runs.empty()) return;
        for (const Run& run : runs)
            add_run(number, run, selected, before, now);
        turned().layers.push_back(selected);
    }

    void add_run(int number, const Run& run, double selected, const std::vector<double>& before,
                 const std::vector<double>& now) {
        const auto& points = path_.points();
        Pass pass;
        pass.drive = number;
        pass.layer = number;
        pass.offset = selected;
        const double drop = before[run.first] - now[run.first];
        if (run.first == 0 && drop > 0) add_ramp(pass, drop, now);
        const auto add = [&](const LathePoint& p, double u) {
            const CutterLocation cl = path_.field().frame().at(p.place, u);
            pass.cl.push_back(cl);
            // Where the pass is above the part, it is the material that is cut.
            pass.cc.push_back(u > p.u ? CutterContact{cl.tip, cl.axis} : p.cc);
            deepest_ = std::max(deepest_, path_.field().stock_radius() - u);
        };
        for (std::size_t i = run.first; i <= run.last; ++i) {
            // Where the part rises through the pass, or falls below it, the tool turns a corner.
            if (i > run.first) {
                const double a = points[i - 1].u - selected, b = points[i].u - selected;
                if ((a > 0) != (b > 0) && a != b) {
                    LathePoint corner = points[a > 0 ? i - 1 : i];
                    const double t = a / (a - b);
                    const LathePlace &p = points[i - 1].place, &q = points[i].place;
                    corner.place = {p.angle + t * (q.angle - p.angle), p.y + t * (q.y - p.y)};
                    corner.u = selected;
                    if (t > 0 && t < 1) add(corner, selected);
                }
            }
            add(points[i], now[i]);
        }
        result_.passes.push_back(std::move(pass));
    }

    /// Down over the first turn in place, which ends where it began; or over the first line there and back.
    void add_ramp(Pass& pass, double drop, const std::vector<double>& now) const {
        const auto& points = path_.points();
        const bool there_and_back = settings_.pattern == LatheCommon::Pattern::lengthwise;
        std::size_t end = 0;
        const auto in_first = [&](std::size_t i) {
            return there_and_back ? points[i].place.angle == points[0].place.angle
                                  : points[i].place.angle <= 2 * pi + tolerance::level_angle
                                        && points[i].place.y == points[0].place.y;
        };
        while (end + 1 < points.size() && in_first(end + 1))
            ++end;
        const double radius = path_.field().part_radius();
        std::vector<double> arc(end + 1, 0);
        for (std::size_t i = 1; i <= end; ++i)
            arc[i] = arc[i - 1] + lathe_distance(points[i - 1].place, points[i].place, radius);
        const double length = there_and_back ? 2 * arc[end] : arc[end];
        if (!(length > 0)) return;
        const auto add = [&](std::size_t i, double done) {
            pass.entry.push_back(path_.location(i, now[i] + drop * (1 - done / length)));
        };
        for (std::size_t i = 0; i <= end; ++i)
            add(i, arc[i]);
        for (std::size_t i = end; there_and_back && i-- > 0;)
            add(i, length - arc[i]);
    }

    const LatheRoughSettings& settings_;
    const PlanContext& context_;
    PlanText text_;
    const LathePath& path_;
    StrategyResult result_;
    std::vector<double> stock_;
    double deepest_ = 0;
};

} // namespace

const ParameterTable<LatheRoughSettings>& lathe_rough_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = LatheRoughSettings;
        ParameterTable<S> t;
        add_common_parameters(t, Workholding::turning);
        t.add(&S::depth_of_cut,
              {.key = "depth_of_cut",
               .label = "Depth of cut",
               .help = "How much deeper each pass goes than the one before, from the stock's "
                       "outside towards the axis.",
               .kind = K::number,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1e5,
               .open_minimum = true});
        t.add(&S::finishing_allowance,
              {.key = "finishing_allowance",
               .label = "Finishing allowance",
               .help = "What roughing leaves on the part for finishing, beside the allowance "
                       "that stays in the end.",
               .kind = K::number,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1000});
        add_lathe_parameters(t);
        return t;
    }();
    return table;
}

StrategyResult LatheRough::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    const double cusp = cusp_budget(settings_, context);
    const double chord = chord_budget(settings_.chord_tolerance, cusp);
    const double kept =
        settings_.allowance + settings_.finishing_allowance + context.tessellation_tolerance[1];
    const LathePath path(settings_, context, kept, cusp, chord, progress.part(0, 0.8));
    return Rougher(settings_, context, path).run(progress.part(0.8, 1));
}

} // namespace facetmill
