#include "core/strategy/curves/pencil.h"

#include "core/base/parallel.h"
#include "core/strategy/cleanup/valley.h"
#include "core/strategy/curves/gap_judge.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/shared_parameters.h"

#include <cmath>

namespace facetmill {

namespace {

const OperationRegistration pencil_registration("pencil", "Pencil",
                                                [] { return std::make_unique<Pencil>(); });

/// The smallest step beside a pass is this share of that on a level plane; the largest that fits is found by
/// so many halvings of their ratio.
constexpr double smallest_share = 0.01;
constexpr int step_halvings = 7;
/// So much of the length beside a pass may keep more than is allowed: where flanks end or others come in.
constexpr double may_stay = 0.02;
/// Passes beside one another are matched where they are no farther apart than this many steps.
constexpr double matched_steps = 1.3;

/// Passes along one line of the plane, and its pieces.
struct Beside {
    std::vector<PlanCurve> lines;
    std::vector<Pass> passes;
};

PlanLine line_of(const PlanCurve& curve) {
    PlanLine line = curve.points;
    if (curve.closed) line.push_back(line.front());
    return line;
}

class ValleyCutter {
public:
    ValleyCutter(const PencilSettings& settings, const CurveJob& job)
        : settings_(settings), job_(job), judge_(job) {}

    struct Cut {
        std::vector<Pass> passes;
        double step_min = infinity, step_max = 0;
        int unsatisfied = 0;
        double length = 0; ///< of the first pass, mm
    };

    Cut run(const PlanCurve& valley, const Progress& progress) const {
        Cut cut;
        const Beside middle = beside(valley, 0, progress);
        cut.length = CurveCourse(valley).length();
        take(cut, middle);
        for (const double side : {1.0, -1.0}) {
            Beside last = middle;
            double from = 0;
            for (long k = 0; k < settings_.side_passes && !last.passes.empty(); ++k) {
                const double step = step_from(valley, last, side, from, cut.unsatisfied, progress);
                from += step;
                last = beside(valley, side * from, progress);
                take(cut, last);
                cut.step_min = std::min(cut.step_min, step);
                cut.step_max = std::max(cut.step_max, step);
            }
        }
        return cut;
    }

private:
    Beside beside(const PlanCurve& valley, double left, const Progress& progress) const {
        Beside made;
        made.lines = curves_beside(valley, left, 0.25 * job_.chord + 1e-3 * std::abs(left), progress);
        for (const PlanCurve& line : made.lines)
            for (Pass& p : job_.passes(line_of(line), 0, progress))
                made.passes.push_back(std::move(p));
        return made;
    }
    static void take(Cut& cut, const Beside& from) {
        cut.passes.insert(cut.passes.end(), from.passes.begin(), from.passes.end());
    }

    /// The largest step that leaves no more than is allowed between the last passes and the next.
    double step_from(const PlanCurve& valley, const Beside& last, double side, double from, int& unsatisfied,
                     const Progress& progress) const {
        if (settings_.stepover.is_number()) return settings_.stepover.number;
        const double level = job_.level_step();
        const auto fits = [&](double step) {
            return stays(last, beside(valley, side * (from + step), progress), step, progress) <= may_stay;
        };
        if (fits(level)) return level;
        double lo = smallest_share * level, hi = level;
        if (!fits(lo)) {
            ++unsatisfied;
            return lo;
        }
        for (int k = 0; k < step_halvings; ++k) {
            const double middle = std::sqrt(lo * hi);
            (fits(middle) ? lo : hi) = middle;
        }
        return lo;
    }

    /// The share of the places between two lines beside each other that keep too much.
    double stays(const Beside& a, const Beside& b, double step, const Progress& progress) const {
        std::vector<Pass> both = a.passes;
        both.insert(both.end(), b.passes.begin(), b.passes.end());
        const LevelSweep swept(both, job_.profile, progress);
        std::vector<AcrossGap> gap;
        for (const PlanCurve& own : a.lines) {
            const CurveCourse course(own);
            for (const PlanCurve& other : b.lines) {
                const PlanLine line = line_of(other);
                const LineDistance distance(line, progress);
                for (double s = 0; s <= course.length(); s += judge_.spacing()) {
                    const Vec2 at = course.at(s);
                    const auto near = distance.near(at);
                    if (near.distance > matched_steps * step) continue;
                    gap.push_back(
                        {at, line[near.piece] + near.t * (line[near.piece + 1] - line[near.piece])});
                }
            }
        }
        if (gap.empty()) return 0;
        const std::vector<char> high = judge_.high(gap, swept, progress);
        return double(std::count(high.begin(), high.end(), char(1))) / double(high.size());
    }

    const PencilSettings& settings_;
    const CurveJob& job_;
    GapJudge judge_;
};

/// The curves on which the cutter touches twice, seen from above.
std::vector<PlanCurve> valleys_of(const PencilSettings& settings, const CurveJob& job,
                                  const Progress& progress) {
    const Mesh& part = *job.context.part;
    const FacetGrid grid(part, progress.part(0, 0.02));
    const UpSide side(part, progress.part(0.02, 0.04));
    // The cutter grown by what is to stay touches the part itself, at the same places seen from above.
    const CutterProfile grown = job.allowance > 0 ? job.profile.grown(job.allowance) : job.profile;
    const AxialLift lift(job.context.contact, grown);
    const CutterCover cover(grown, cusp_detail(job.cusp_allowed));
    ValleyInput in;
    in.mesh = &part;
    in.grid = &grid;
    in.side = &side;
    in.lift = &lift;
    in.cover = &cover;
    in.tolerance = job.cusp_allowed;
    in.ripple =
        settings.smallest_valley.is_number() ? settings.smallest_valley.number : job.profile.max_radius();
    std::vector<PlanCurve> curves;
    for (const ValleyCurve& valley : find_valleys(in, progress.part(0.04, 1)).curves) {
        PlanCurve curve{{}, valley.closed};
        for (const PencilPoint& p : valley.points)
            if (curve.points.empty() || curve.points.back() != p.tip.head<2>())
                curve.points.emplace_back(p.tip.head<2>());
        if (curve.points.size() > 1) curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace

const ParameterTable<PencilSettings>& pencil_parameters() {
    static const auto table = [] {
        using S = PencilSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        add_tool_axis_parameter(t);
        t.add(&S::side_passes,
              {.key = "side_passes",
               .label = "Side passes",
               .help = "Passes on either side of the one along the valley. 0: that one alone.",
               .kind = ParameterKind::integer,
               .quantity = Quantity::count,
               .minimum = 0,
               .maximum = 100});
        add_stepover_parameter(t);
        t.add(&S::smallest_valley,
              length_or_word_parameter({.key = "smallest_valley",
                                        .label = "Smallest valley",
                                        .help = "Shorter valleys are left out, and shorter gaps in one are "
                                                "passed over. auto is the cutter's radius.",
                                        .words = {"auto"},
                                        .advanced = true}));
        add_curve_parameters(t);
        return t;
    }();
    return table;
}

StrategyResult Pencil::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    const CurveJob job(settings_, context, progress.part(0, 0.02));
    const std::vector<PlanCurve> valleys =
        valleys_of(settings_, job, progress.part(0.02, 0.6, "Looking for valleys"));
    if (valleys.empty())
        throw NothingToDo(settings_.name,
                          "the cutter touches the part nowhere at two places between which it leaves more "
                          "than the tolerance",
                          "take a larger tool, or leave the operation out");
    const ValleyCutter cutter(settings_, job);
    std::vector<ValleyCutter::Cut> cuts(valleys.size());
    parallel_for(valleys.size(), 1, progress.part(0.6, 0.9, "Passes along valleys"),
                 [&](std::size_t i) { cuts[i] = cutter.run(valleys[i], progress.part(0.6, 0.6)); });
    StrategyResult result;
    int unsatisfied = 0;
    for (const ValleyCutter::Cut& cut : cuts) {
        unsatisfied += cut.unsatisfied;
        if (cut.step_max > 0) {
            result.stepover_min =
                result.stepover_max > 0 ? std::min(result.stepover_min, cut.step_min) : cut.step_min;
            result.stepover_max = std::max(result.stepover_max, cut.step_max);
        }
        for (const Pass& pass : cut.passes) {
            result.passes.push_back(pass);
            result.passes.back().drive = result.drive_planes++;
        }
    }
    if (result.passes.empty())
        throw Error(ErrorCode::empty_result, settings_.name, "no valley lies where something is to be cut",
                    "check part and boundary");
    result.cusp_max = job.cusp_allowed;
    CurveFinish(job).run(result, {nullptr, unsatisfied, false}, progress.part(0.9, 1));
    return result;
}

} // namespace facetmill
