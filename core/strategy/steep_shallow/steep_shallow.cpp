#include "core/strategy/steep_shallow/steep_shallow.h"

#include "core/strategy/finish3/finish_warnings.h"
#include "core/strategy/finish3/uncut.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/plan/shared_parameters.h"
#include "core/strategy/scallop/scallop_steps.h"
#include "core/strategy/surface/slope_facets.h"
#include "core/strategy/waterline/level_sweep.h"

#include <cmath>
#include <optional>

namespace facetmill {

namespace {

const OperationRegistration steep_shallow_registration("steep_shallow", "Steep and shallow",
                                                       [] { return std::make_unique<SteepShallow>(); });

WaterlineSettings steep_settings(const SteepShallowSettings& s) {
    WaterlineSettings w;
    static_cast<OperationCommon&>(w) = s;
    w.slope_limits = {s.steep().lo, s.steep().hi};
    w.stepdown = s.stepdown;
    w.max_stepdown = s.max_stepdown;
    w.pattern = s.pattern == Finish3Settings::Pattern::zigzag ? WaterlineSettings::Pattern::zigzag
                                                              : WaterlineSettings::Pattern::oneway;
    w.chord_tolerance = s.chord_tolerance;
    w.holder_clearance = s.holder_clearance;
    w.tilt_limit = s.tilt_limit;
    w.rest_only = s.rest_only;
    return w;
}

Finish3Settings shallow_settings(const SteepShallowSettings& s) {
    Finish3Settings f;
    static_cast<OperationCommon&>(f) = s;
    f.stepover = s.stepover;
    f.pattern = s.pattern;
    f.chord_tolerance = s.chord_tolerance;
    f.normal_limit = s.normal_limit;
    f.holder_clearance = s.holder_clearance;
    f.tilt_limit = s.tilt_limit;
    f.rest_only = s.rest_only;
    return f;
}

} // namespace

ScallopSettings shallow_scallop(const SteepShallowSettings& s) {
    ScallopSettings c;
    static_cast<OperationCommon&>(c) = s;
    c.stepover = s.stepover;
    c.slope_limit = std::min(s.shallow().hi, ScallopSteps::steepest);
    c.pattern = s.pattern == Finish3Settings::Pattern::zigzag ? ScallopSettings::Pattern::zigzag
                                                              : ScallopSettings::Pattern::oneway;
    c.chord_tolerance = s.chord_tolerance;
    c.holder_clearance = s.holder_clearance;
    c.tilt_limit = s.tilt_limit;
    c.rest_only = s.rest_only;
    return c;
}

namespace {

/// What passes cut, for those that come after them.
std::shared_ptr<const EarlierCuts> cuts_of_passes(const PlannedPasses& planned, const AptCutter& cutter,
                                                  double allowance) {
    auto cuts = std::make_shared<EarlierCuts>();
    cuts->cutter = cutter;
    cuts->no_nearer = std::max(0.0, allowance - planned.path.chord_tolerance);
    for (const Pass& pass : planned.path.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            cuts->motions.push_back({pass.cl[i - 1].tip, pass.cl[i].tip});
    return cuts;
}

HeldOut together(HeldOut a, const HeldOut& b) {
    a.left.insert(a.left.end(), b.left.begin(), b.left.end());
    a.length += b.length;
    a.left_length += b.left_length;
    a.lack.shank = std::max(a.lack.shank, b.lack.shank);
    a.lack.holder = std::max(a.lack.holder, b.lack.holder);
    a.tilt_limit = std::max(a.tilt_limit, b.tilt_limit);
    a.has_ball = a.has_ball || b.has_ball;
    return a;
}

ClearOfStock together(ClearOfStock a, const ClearOfStock& b) {
    a.left.insert(a.left.end(), b.left.begin(), b.left.end());
    a.left_length += b.left_length;
    a.lack = std::max(a.lack, b.lack);
    return a;
}

/// Step-overs of those that have a neighbour.
void take_steps(StrategyResult& to, const StrategyResult& from) {
    if (!(from.stepover_max > 0)) return;
    to.stepover_min = to.stepover_max > 0 ? std::min(to.stepover_min, from.stepover_min) : from.stepover_min;
    to.stepover_max = std::max(to.stepover_max, from.stepover_max);
}

class DividedPlan {
public:
    DividedPlan(const SteepShallowSettings& settings, const PlanContext& context)
        : settings_(settings), context_(context), text_{context.unit, context.to_setup},
          cusp_allowed_(cusp_budget(settings, context)) {}

    StrategyResult run(const Progress& progress) {
        progress.part(0, 1, "Cutting steep surface by levels").set(0);
        plan_steep(progress.part(0, 0.45));
        plan_shallow(progress.part(0.45, 0.9, "Passes over shallow surface"));
        if (!steep_ && !shallow_) refuse();
        StrategyResult result = joined_passes();
        check_uncut(result, progress.part(0.9, 1, "Looking for what stays uncut"));
        add_warnings(result);
        progress.set(1);
        return result;
    }

private:
    void plan_steep(const Progress& progress) {
        try {
            steep_ = waterline_passes(steep_settings(settings_), context_, progress);
        } catch (const Error& e) {
            if (e.code() != ErrorCode::empty_result) throw;
            no_steep_ = e.message();
        }
    }
    void plan_shallow(const Progress& progress) {
        const SlopePiece piece = piece_between(context_, settings_.shallow(), progress.part(0, 0.02));
        if (!piece.mesh) return;
        PlanContext own = context_;
        if (steep_)
            own.earlier.push_back(cuts_of_passes(*steep_, context_.tool.cutter(), settings_.allowance));
        try {
            if (settings_.shallow_by == SteepShallowSettings::Shallow::scallop) {
                shallow_ = scallop_passes(shallow_scallop(settings_), own, progress.part(0.05, 1));
                return;
            }
            own.part = piece.mesh;
            own.is_piece = true;
            own.geometry = compute_geometry(*piece.mesh, progress.part(0.02, 0.05));
            shallow_ = finish3_passes(shallow_settings(settings_), own, progress.part(0.05, 1));
        } catch (const Error& e) {
            if (e.code() != ErrorCode::empty_result) throw;
            no_shallow_ = e.message();
        }
    }
    [[noreturn]] void refuse() const {
        throw Error(ErrorCode::empty_result, settings_.name, no_shallow_.empty() ? no_steep_ : no_shallow_,
                    "check part, tool and divide");
    }

    StrategyResult joined_passes() const {
        if (!steep_) return shallow_->path;
        StrategyResult all = steep_->path;
        if (!shallow_) return all;
        const StrategyResult& own = shallow_->path;
        int first = 0;
        for (const Pass& pass : all.passes)
            first = std::max(first, pass.drive + 1);
        for (Pass pass : own.passes) {
            pass.drive += first;
            all.passes.push_back(std::move(pass));
        }
        // From one course to the other the tool goes over what it has just cut.
        all.passes[steep_->path.passes.size()].from_above = true;
        all.drive_planes += own.drive_planes;
        take_steps(all, own);
        all.direction = own.direction;
        all.direction_reason = own.direction_reason;
        all.cusp_max = std::max(all.cusp_max, own.cusp_max);
        all.chord_tolerance = std::max(all.chord_tolerance, own.chord_tolerance);
        return all;
    }

    void check_uncut(const StrategyResult& result, const Progress& progress) {
        const SlopePiece up = piece_between(context_, {0, pi}, progress.part(0, 0.02));
        held_ = together(steep_ ? steep_->held : HeldOut(), shallow_ ? shallow_->held : HeldOut());
        if (!up.mesh) return;
        const CutterProfile profile(context_.tool.cutter());
        const CutterCover cover(profile, cusp_detail(cusp_allowed_));
        const double allowance = settings_.allowance + context_.tessellation_tolerance[1];
        const AxialLift lift(context_.contact, profile, allowance);
        UncutInput input;
        input.mesh = up.mesh.get();
        input.lift = &lift;
        input.cover = &cover;
        input.allowance = allowance;
        if (steep_) input.lowest_tip = steep_->lowest_tip;
        uncut_ = uncut_by_levels(input, context_, {result.passes, held_.left}, profile, cusp_allowed_,
                                 progress.part(0.02, 1));
    }

    void add_warnings(StrategyResult& result) const {
        const double levels = steep_ ? steep_->path.cusp_max : 0;
        if (settings_.stepdown.is_number() && levels > cusp_allowed_)
            result.warnings.push_back("the step-down of " + text_(settings_.stepdown.number)
                                      + " leaves cusps of " + text_(levels) + "; the tolerance allows "
                                      + text_(cusp_allowed_));
        if (uncut_.below > 0) result.warnings.push_back(below_warning(uncut_.below, uncut_.area));
        if (!steep_ && !no_steep_.empty())
            result.warnings.push_back("all is cut by passes side by side: " + no_steep_);
        if (!shallow_)
            result.warnings.push_back(
                "all is cut by levels: "
                + (no_shallow_.empty() ? "nothing is less steep than the divide" : no_shallow_));
        const ClearOfStock beside = together(steep_ ? steep_->beside_stock : ClearOfStock(),
                                             shallow_ ? shallow_->beside_stock : ClearOfStock());
        const Finish3Settings passes = shallow_settings(settings_);
        const FinishWarnings warnings{passes,
                                      context_,
                                      uncut_,
                                      held_,
                                      beside,
                                      cusp_allowed_,
                                      shallow_ ? shallow_->unsatisfied : 0,
                                      shallow_ ? shallow_->lines : 0};
        add_finish_warnings(warnings, result);
    }

    const SteepShallowSettings& settings_;
    const PlanContext& context_;
    PlanText text_;
    double cusp_allowed_;
    std::optional<PlannedPasses> steep_, shallow_;
    std::string no_steep_, no_shallow_; ///< why not
    HeldOut held_;
    UncutReport uncut_;
};

} // namespace

const ParameterTable<SteepShallowSettings>& steep_shallow_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = SteepShallowSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        add_tool_axis_parameter(t);
        t.add(&S::divide, {.key = "divide",
                           .label = "Divide",
                           .help = "Slope from level at which the part is divided: what is steeper is cut by "
                                   "levels, what is less steep by passes side by side.",
                           .kind = K::number,
                           .quantity = Quantity::angle,
                           .minimum = radians(10),
                           .maximum = 0.5 * pi});
        t.add(&S::overlap, {.key = "overlap",
                            .label = "Overlap",
                            .help = "Slopes that are so near to the divide are cut both ways.",
                            .kind = K::number,
                            .quantity = Quantity::angle,
                            .minimum = 0,
                            .maximum = 0.25 * pi});
        t.add_choice(&S::shallow_by,
                     {.key = "shallow",
                      .label = "Shallow by",
                      .help = "Passes over what is less steep: parallel keeps to drive planes; "
                              "scallop follows the border, with cusps of one height.",
                      .words = {"parallel", "scallop"}});
        t.add(&S::stepdown, stepdown_parameter());
        t.add(&S::stepover, stepover_parameter());
        t.add(&S::max_stepdown, max_stepdown_parameter());
        t.add_choice(&S::pattern,
                     pattern_parameter("zigzag cuts to and fro, and open levels whichever way is nearer; "
                                       "oneway always in the same direction, levels with the part on the "
                                       "right of the travel (climb milling)."));
        t.add(&S::chord_tolerance,
              chord_tolerance_parameter(
                  "How far straight moves may run beside the exact path, to either side"));
        t.add(&S::normal_limit, normal_limit_parameter("; more points are put in where it turns more"));
        t.add(&S::holder_clearance, holder_clearance_parameter());
        t.add(&S::tilt_limit, tilt_limit_parameter());
        t.add(&S::rest_only, rest_only_parameter());
        return t;
    }();
    return table;
}

StrategyResult SteepShallow::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    return with_tilt(settings_, context, progress,
                     [&](const Progress& upright) { return DividedPlan(settings_, context).run(upright); });
}

} // namespace facetmill
