#include "core/strategy/finish3/finish3.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/finish3/finish_warnings.h"
#include "core/strategy/finish3/overlooked_lines.h"
#include "core/strategy/finish3/partial_lines.h"
#include "core/strategy/finish3/pass_filter.h"
#include "core/strategy/finish3/pass_maker.h"
#include "core/strategy/finish3/stepover.h"
#include "core/strategy/finish3/travel_choice.h"
#include "core/strategy/finish3/uncut.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/plan/shared_parameters.h"
#include "core/strategy/surface/slice.h"
#include "core/strategy/surface/travel_direction.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <optional>

namespace facetmill {

namespace {

const OperationRegistration registration("finish3", "Finish, 3-axis",
                                         [] { return std::make_unique<Finish3>(); });

/// Drive planes of a plan, at most: more come from a part in another unit.
constexpr std::size_t max_drive_planes = 100000;
/// Places of the tip that a plan looks at, roughly: some hours' work.
constexpr double max_places = 2e9;

/// Where more than this share of the surface is passed by, lines are laid through it, so often at most; they
/// are kept if they leave less than this share of that.
constexpr double max_overlooked = 0.0005, worth_lines = 0.5;
constexpr int overlooked_rounds = 3;
/// Tips beside such a place cut it no farther away than this share of the step on a level plane, seen along
/// the surface: what a line leaves grows with the square.
constexpr double overlooked_share = 0.5;
/// The other direction is planned too where it is expected to travel less than this share.
constexpr double less_expected = 0.9;

/// Everything one plan needs, worked out once.
class Planner {
public:
    Planner(const Finish3Settings& settings, const PlanContext& context, const Progress& progress);
    /// The direction asked for; for "auto" by the change of normals.
    double direction() { return travel_direction(settings_.direction, context_, still(0)); }
    /// What the passes of another direction would be; none where nothing faces up in it.
    std::optional<TravelEstimate> estimate(double direction);
    /// `judged`: with what stays uncut, and all that is said of it.
    PlannedPasses run(double direction, bool judged);
    double travel(const StrategyResult& plan) const { return travel_length(plan.passes, cover_.radius()); }
    /// Share of the surface that stays uncut where the cutter could go: passes do not, or shank or holder
    /// keep them from it, which along a wall is often less than across.
    double left() const {
        return uncut_.area > 0 ? (uncut_.passed_by.area + uncut_.held.area) / uncut_.area : 0;
    }

private:
    StepOverInput input_for(double direction, ContactDomain& domain) const;
    /// A drive plane, and what it and the next one leave to partial lines.
    struct Placed {
        DriveLine line;
        std::vector<Interval> left;
    };
    /// Lines as far apart as the tolerance allows.
    bool is_adaptive() const { return !settings_.stepover.is_number(); }
    void plan_parallel();
    void plan_constant(double step);
    void plan_adaptive();
    std::vector<Placed> place_planes(const Progress& progress);
    std::vector<PlannedLine> with_partial_lines(std::vector<Placed> planes, const Progress& progress);
    void add_passes(const std::vector<PlannedLine>& lines, const Progress& progress);
    void check_size(const StepOver& stepover) const;
    void check_planes(std::size_t planes) const;
    void check_uncut(const Progress& progress);
    void add_overlooked(std::vector<Pass> planned, const Progress& progress);
    std::vector<PlannedLine> overlooked() const;
    void order_passes(const Progress& progress);
    ContactAt contact_at() const {
        return [this](const Vec3& tip) { return maker_->contact(tip); };
    }
    Progress still(double fraction) const { return progress_.part(fraction, fraction); }
    /// Share of the whole plan that is done when this share of the passes is made.
    static double placed(double share) { return 0.02 + 0.9 * share; }
    Progress placing(double from, double to) const { return progress_.part(placed(from), placed(to)); }

    const Finish3Settings& settings_;
    const PlanContext& context_;
    PlanText text_;
    const Progress& progress_;
    double cusp_allowed_, allowance_, chord_;
    CutterProfile profile_;
    CutterCover cover_;
    AxialLift lift_, near_;
    UprightWalls walls_;
    DriveFrame frame_;
    std::optional<ContactDomain> domain_;
    LineTolerance fine_;
    std::optional<StepOver> stepover_;
    std::optional<PassMaker> maker_;
    PassFilter filter_;
    StrategyResult result_;
    UncutReport uncut_;
    int unsatisfied_ = 0, lines_ = 0;
};

Planner::Planner(const Finish3Settings& settings, const PlanContext& context, const Progress& progress)
    : settings_(settings), context_(context), text_{context.unit, context.to_setup}, progress_(progress),
      cusp_allowed_(cusp_budget(settings, context)),
      allowance_(settings.allowance + context.tessellation_tolerance[1]),
      chord_(chord_budget(settings.chord_tolerance, cusp_allowed_)), profile_(context.tool.cutter()),
      cover_(profile_, cusp_detail(cusp_allowed_)), lift_(context.contact, profile_, allowance_),
      near_(context.contact, profile_, allowance_ + cusp_allowed_),
      walls_(*context.part, profile_.max_radius() + allowance_ + cusp_allowed_, progress.part(0, 0)),
      filter_(settings, context, profile_,
              {cusp_allowed_, allowance_, chord_, settings.holder_clearance, settings.tilt_limit,
               settings.rest_only},
              contact_at()) {
    // What the tip path may lack of the lift and exceed it, together, is the chord tolerance: half of each
    // for the points looked at, half for leaving points out.
    fine_.below = fine_.above = 0.5 * chord_;
    fine_.spacing = safe_spacing(profile_, fine_.below);
}

StepOverInput Planner::input_for(double direction, ContactDomain& domain) const {
    StepOverInput input;
    input.mesh = context_.part.get();
    input.contact = context_.contact;
    input.lift = &lift_;
    input.cover = &cover_;
    input.domain = &domain;
    input.frame = DriveFrame(direction);
    input.allowance = allowance_;
    input.floor = domain.lowest_tip();
    input.cusp = standing_cusp(cusp_allowed_, chord_);
    input.merge = fine_.spacing;
    input.look = settings_.look;
    return input;
}

std::optional<TravelEstimate> Planner::estimate(double direction) {
    ContactDomain domain(*context_.part, DriveFrame(direction), cover_, allowance_, still(0));
    if (domain.empty()) return std::nullopt;
    const StepOverInput input = input_for(direction, domain);
    check_size(StepOver(input));
    return estimate_travel(input, still(0));
}

PlannedPasses Planner::run(double direction, bool judged) {
    frame_ = DriveFrame(direction);
    result_.direction = frame_.angle;
    domain_.emplace(*context_.part, frame_, cover_, allowance_, still(placed(0)));
    if (domain_->empty())
        throw Error(ErrorCode::empty_result, settings_.name,
                    std::string("no facet of the part can be cut ") + context_.seen_from() + ": all "
                        + std::to_string(context_.part->facet_count()) + " stand upright or have no area",
                    "rotate the part");
    stepover_.emplace(input_for(direction, *domain_));
    maker_.emplace(*stepover_, LiftField{&lift_, domain_->lowest_tip()}, near_, walls_, cover_, frame_, fine_,
                   settings_.normal_limit);
    check_size(*stepover_);

    progress_.part(placed(0), 1, "Placing drive planes").set(0);
    switch (settings_.topology) {
    case Finish3Settings::Topology::parallel:
        plan_parallel();
    }
    if (result_.passes.empty())
        throw Error(ErrorCode::empty_result, settings_.name, "no drive plane meets the part",
                    "check part and direction");
    // Moves may run above the exact path by the chord tolerance.
    result_.cusp_max += chord_;
    result_.chord_tolerance = chord_;
    std::vector<Pass> planned;
    if (judged && is_adaptive()) planned = result_.passes;
    filter_.leave_out_held_up(result_.passes, still(placed(1)));
    if (judged) {
        check_uncut(progress_.part(placed(1), 1, "Looking for what stays uncut"));
        add_overlooked(std::move(planned), still(1));
    }
    filter_.leave_out_air(result_.passes, still(1));
    order_passes(still(1));
    // With only rest asked for, what is not passed was mostly cut before.
    if (filter_.leave_out_beside_stock(result_.passes, still(1)) && judged && !settings_.rest_only)
        check_uncut(progress_.part(1, 1));
    if (judged) {
        const FinishWarnings warnings{
            settings_,     context_,     uncut_, filter_.held(), filter_.beside_stock(),
            cusp_allowed_, unsatisfied_, lines_};
        add_finish_warnings(warnings, result_);
    }
    return {std::move(result_),    filter_.held(), filter_.beside_stock(),
            domain_->lowest_tip(), unsatisfied_,   lines_};
}

/// What would take days is most likely a part in another unit.
void Planner::check_size(const StepOver& stepover) const {
    const Vec3 size = context_.part_box.size();
    const double step = settings_.stepover.is_number() ? settings_.stepover.number : stepover.largest_step();
    if (size.x() * size.y() <= max_places * step * fine_.spacing) return;
    throw Error(ErrorCode::limit_exceeded, settings_.name,
                "a part of " + text_(size.x()) + " by " + text_(size.y()) + " asks for more than "
                    + format_number(max_places) + " places of this tool",
                "check the part's units, or take a larger tool, tolerance or step-over");
}

void Planner::check_planes(std::size_t planes) const {
    if (planes >= max_drive_planes)
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "the tolerance asks for more than " + std::to_string(max_drive_planes) + " drive planes",
                    "allow a larger tolerance or set a step-over");
}

void Planner::plan_parallel() {
    if (is_adaptive())
        plan_adaptive();
    else
        plan_constant(settings_.stepover.number);
}

void Planner::plan_constant(double step) {
    const double lo = domain_->lo(), hi = domain_->hi();
    // Centred: the same margin at both borders, at most half a step.
    const double planes = std::max(1.0, std::ceil((hi - lo) / step - tolerance::level_angle));
    if (planes > double(max_drive_planes))
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "a step-over of " + text_(step) + " makes more than " + std::to_string(max_drive_planes)
                        + " drive planes",
                    "choose a larger step-over");
    const double first = 0.5 * (lo + hi) - 0.5 * (planes - 1) * step;
    const double reach = StepOver::reach_share * step;
    std::vector<PlannedLine> planned;
    for (double i = 0; i < planes; ++i)
        planned.push_back({first + i * step, reach, reach, {}});
    std::vector<DriveLine> lines(planned.size());
    parallel_for(lines.size(), 1, placing(0, 0.3), [&](std::size_t i) {
        lines[i] = stepover_->line(planned[i].v, reach, reach, nullptr, still(placed(0)));
    });
    // The gap before each line, and the one behind the last.
    std::vector<double> cusps(lines.size() + 1);
    parallel_for(cusps.size(), 1, placing(0.3, 0.6), [&](std::size_t i) {
        const bool begins = i == 0, ends = i == lines.size();
        cusps[i] = stepover_->worst_cusp(begins ? nullptr : &lines[i - 1], ends ? nullptr : &lines[i],
                                         begins ? lo : hi, still(placed(0)));
    });
    result_.cusp_max = *std::max_element(cusps.begin(), cusps.end());
    add_passes(planned, placing(0.6, 1));
    result_.stepover_min = result_.stepover_max = planes > 1 ? step : 0;
}

void Planner::plan_adaptive() {
    add_passes(with_partial_lines(place_planes(placing(0, 0.4)), placing(0.4, 0.8)), placing(0.8, 1));
}

/// One after the other: every line is as far from the one before as the cusps between them allow.
std::vector<Planner::Placed> Planner::place_planes(const Progress& progress) {
    const double lo = domain_->lo(), hi = domain_->hi();
    const Progress here = progress.part(0, 0);
    std::vector<Placed> planes;
    result_.stepover_min = infinity;
    double guess = stepover_->first_guess();
    for (;;) {
        DriveLine* last = planes.empty() ? nullptr : &planes.back().line;
        if (last) {
            // Enough for the rest up to the border?
            const double rest = hi - last->v;
            double cusp = 0;
            if (rest > 0 && rest <= stepover_->largest_step()) {
                if (last->ahead < rest) *last = stepover_->line(last->v, last->back, rest, nullptr, here);
                cusp = stepover_->worst_cusp(last, nullptr, hi, here);
            }
            if (rest <= 0 || (rest <= stepover_->largest_step() && cusp <= stepover_->allowed_cusp())) {
                result_.cusp_max = std::max(result_.cusp_max, cusp);
                last->ahead = std::max(rest, 0.0);
                break;
            }
        }
        check_planes(planes.size());
        StepOver::Step step = stepover_->next({last, hi, nullptr, guess, true}, here);
        if (!step.satisfied) ++unsatisfied_;
        result_.cusp_max = std::max(result_.cusp_max, step.cusp);
        const double width = step.line.v - (last ? last->v : lo);
        if (last) {
            if (step.satisfied) guess = std::min(width, stepover_->largest_step());
            result_.stepover_min = std::min(result_.stepover_min, width);
            result_.stepover_max = std::max(result_.stepover_max, width);
            const double reach = StepOver::reach_share * width;
            planes.back().left = std::move(step.left);
            // How far a line reaches depends on both of its steps.
            if (!planes.back().left.empty() && last->ahead < reach)
                *last = stepover_->line(last->v, last->back, reach, nullptr, here);
            last->ahead = reach;
        }
        planes.push_back({std::move(step.line), {}});
        progress.set(hi > lo ? (planes.back().line.v - lo) / (hi - lo) : 1);
    }
    if (result_.stepover_max == 0) result_.stepover_min = 0; // a single plane has no neighbour
    return planes;
}

std::vector<PlannedLine> Planner::with_partial_lines(std::vector<Placed> planes, const Progress& progress) {
    std::vector<PartialLines> partial(planes.size(), PartialLines(*stepover_));
    std::atomic<std::size_t> made =
        planes.size(); // too many end the work at once, not after the last of them
    // What takes longest first.
    std::vector<double> length(planes.size(), 0);
    for (std::size_t i = 0; i < planes.size(); ++i)
        for (const Interval& r : planes[i].left)
            length[i] += r.length();
    std::vector<std::size_t> order(planes.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return length[a] > length[b]; });
    parallel_for(order.size(), 1, progress, [&](std::size_t k) {
        const std::size_t i = order[k];
        if (planes[i].left.empty()) return;
        partial[i].fill(planes[i].line, planes[i + 1].line, planes[i].left, progress.part(0, 0));
        const std::size_t more = partial[i].lines();
        check_planes(made.fetch_add(more) + more);
    });
    std::vector<PlannedLine> lines;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const DriveLine& line = planes[i].line;
        lines.push_back({line.v, line.back, line.ahead, {}});
        const std::vector<PlannedLine> between = partial[i].take();
        lines.insert(lines.end(), between.begin(), between.end());
        result_.cusp_max = std::max(result_.cusp_max, partial[i].cusp_max());
        unsatisfied_ += partial[i].unsatisfied();
    }
    return lines;
}

void Planner::add_passes(const std::vector<PlannedLine>& lines, const Progress& progress) {
    std::vector<std::vector<Pass>> passes(lines.size());
    parallel_for(lines.size(), 1, progress,
                 [&](std::size_t i) { passes[i] = maker_->passes(lines[i], progress.part(0, 0)); });
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int drive = lines_++;
        if (!lines[i].within) ++result_.drive_planes;
        const bool back = settings_.pattern == Finish3Settings::Pattern::zigzag && drive % 2 == 1;
        if (back) std::reverse(passes[i].begin(), passes[i].end());
        for (Pass& p : passes[i]) {
            p.drive = drive;
            if (back) {
                std::reverse(p.cc.begin(), p.cc.end());
                std::reverse(p.cl.begin(), p.cl.end());
            }
            result_.passes.push_back(std::move(p));
        }
    }
}

void Planner::check_uncut(const Progress& progress) {
    UncutInput input;
    input.mesh = context_.part.get();
    input.contact = context_.contact;
    input.lift = &lift_;
    input.cover = &cover_;
    input.frame = frame_;
    input.allowance = allowance_;
    input.allowed = (1 + tolerance::uncut_margin) * cusp_allowed_;
    input.top = std::max(context_.stock_box.hi.z(), context_.part_box.hi.z());
    input.passes = result_.passes;
    input.left_out = filter_.held().left;
    input.tell_passed = is_adaptive();
    uncut_ = find_uncut(input, progress);
}

/// Lines through what passes go by though the cutter could reach it. `planned`: the passes before shank and
/// holder kept any of them.
void Planner::add_overlooked(std::vector<Pass> planned, const Progress& progress) {
    const auto is_much = [&] { return uncut_.passed_by.area > max_overlooked * uncut_.area; };
    if (!is_adaptive() || !is_much()) return;
    const UncutReport before = uncut_;
    const std::vector<Pass> without = planned;
    const int lines_before = lines_;
    for (int round = 0; round < overlooked_rounds && is_much(); ++round) {
        const std::vector<PlannedLine> lines = overlooked();
        if (lines.empty()) break;
        check_planes(std::size_t(lines_) + lines.size());
        result_.passes = std::move(planned);
        add_passes(lines, progress);
        planned = result_.passes;
        filter_.leave_out_held_up(result_.passes, progress);
        check_uncut(progress);
    }
    if (uncut_.passed_by.area > worth_lines * before.passed_by.area) {
        lines_ = lines_before;
        result_.passes = without;
        filter_.leave_out_held_up(result_.passes, progress);
        uncut_ = before;
    } else if (uncut_.passed_by.area == 0) {
        unsatisfied_ = 0; // what no step served lines through it did
    }
}

std::vector<PlannedLine> Planner::overlooked() const {
    const double wide = overlooked_share * stepover_->first_guess(), least = stepover_->smallest_step();
    std::vector<OverlookedTip> tips;
    for (const Vec3& tip : uncut_.passed_tips) {
        // Across the lines, and so seen from above, a steep side is narrow.
        const Vec3 normal = maker_->contact(tip).normal;
        const double across = std::hypot(normal.z(), frame_.v(normal));
        const double width = across > 0 ? wide * normal.z() / across : wide;
        tips.push_back({frame_.u(tip), frame_.v(tip), std::max(width, least)});
    }
    return overlooked_lines(std::move(tips), 2 * cover_.radius());
}

/// Pieces that lie side by side one after another, instead of every plane from border to border.
void Planner::order_passes(const Progress& progress) {
    if (result_.passes.size() == std::size_t(result_.drive_planes)) return;
    double top = std::max(context_.part_box.hi.z(), context_.stock_box.hi.z()) + settings_.allowance;
    order_by_travel(result_.passes, settings_.pattern == Finish3Settings::Pattern::zigzag,
                    top + settings_.clearance, progress);
}

std::string direction_text(double angle) {
    return angle == 0 ? "x" : "y";
}

/// In the direction asked for or, where that is "auto", in the better of two.
PlannedPasses planned_best(const Finish3Settings& settings, const PlanContext& context, bool judged,
                           const Progress& progress) {
    const bool choose = settings.direction.is("auto") && !settings.stepover.is_number();
    // Mostly there is no second time.
    const Progress whole = progress.part(0, choose ? 0.95 : 1), again = progress.part(0.95, 1);
    Planner planner(settings, context, whole);
    const double first = planner.direction();
    PlannedPasses best = planner.run(first, judged);
    if (!choose) return best;
    const double second = first == 0 ? 0.5 * pi : 0;
    Planner turned(settings, context, again);
    const bool leaves_much = planner.left() > much_left;
    const double length = planner.travel(best.path);
    const std::optional<TravelEstimate> expected = turned.estimate(second);
    if (!expected || !(leaves_much || expected->cost() < less_expected * length)) {
        progress.set(1);
        return best;
    }
    PlannedPasses other = turned.run(second, judged);
    const bool better = is_better({turned.travel(other.path), turned.left()}, {length, planner.left()});
    const PlanText text{context.unit, context.to_setup};
    const auto told = [&](double angle, const StrategyResult& plan, const Planner& by) {
        return direction_text(angle) + ": " + text(by.travel(plan)) + " of passes"
               + (by.left() > 0
                      ? ", " + share_text(by.left(), 1) + " of the surface uncut where the cutter could go"
                      : std::string());
    };
    std::string reason = told(first, best.path, planner) + "; " + told(second, other.path, turned);
    if (better) best = std::move(other);
    best.path.direction_reason = std::move(reason);
    return best;
}

} // namespace

const ParameterTable<Finish3Settings>& finish3_parameters() {
    static const auto table = [] {
        using S = Finish3Settings;
        ParameterTable<S> t;
        add_common_parameters(t);
        add_tool_axis_parameter(t);
        t.add(&S::stepover, stepover_parameter());
        t.add_choice(&S::topology, {.key = "topology",
                                    .label = "Topology",
                                    .help = "Course of the passes: parallel drive planes.",
                                    .words = {"parallel"},
                                    .advanced = true});
        t.add_choice(&S::pattern, pattern_parameter("zigzag cuts to and fro; oneway always cuts in the "
                                                    "direction of travel and returns above the part."));
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

StrategyResult Finish3::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    return with_tilt(settings_, context, progress, [&](const Progress& upright) {
        return planned_best(settings_, context, true, upright).path;
    });
}

PlannedPasses finish3_passes(const Finish3Settings& settings, const PlanContext& context,
                             const Progress& progress) {
    check_plannable(context, settings);
    return planned_best(settings, context, false, progress);
}

} // namespace facetmill
