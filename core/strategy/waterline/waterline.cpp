#include "core/strategy/waterline/waterline.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/finish3/finish_warnings.h"
#include "core/strategy/finish3/uncut.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/plan/shared_parameters.h"
#include "core/strategy/plan/stock_bottom.h"
#include "core/strategy/surface/slope_facets.h"
#include "core/strategy/waterline/contour_passes.h"
#include "core/strategy/waterline/level_order.h"
#include "core/strategy/waterline/level_sweep.h"

#include <cmath>
#include <optional>

namespace facetmill {

namespace {

const OperationRegistration waterline_registration("waterline", "Waterline",
                                                   [] { return std::make_unique<Waterline>(); });

/// Places of the grid, and levels, at most: more come from a part in another unit.
constexpr double max_grid_places = 16e6;
constexpr std::size_t max_levels = 20000;
/// On a larger part the grid is coarser, but never more than so many radii.
constexpr double coarsest_grid = 0.25;
/// Slopes at the limits are cut with what rounding of normals may be.
constexpr double slope_slack = 1e-6;

class WaterlinePlanner {
public:
    WaterlinePlanner(const WaterlineSettings& settings, const PlanContext& context, const Progress& progress);
    /// `judged`: with what stays uncut, and all that is said of it.
    PlannedPasses run(bool judged);

private:
    double grid_spacing() const;
    bool has_slopes(const Progress& progress) const;
    [[noreturn]] void refuse_slopes() const;
    void find_levels(const Progress& progress);
    void make_passes(const Progress& progress);
    void keep_links_within();
    void check_uncut(const Progress& progress);
    void add_warnings();
    ContactAt contact_at() const {
        return [this](const Vec3& tip) { return passes_->contact(tip, Vec2::Zero()); };
    }

    const WaterlineSettings& settings_;
    const PlanContext& context_;
    const Progress& progress_;
    PlanText text_;
    double cusp_allowed_, allowance_, chord_;
    CutterProfile profile_;
    CutterCover cover_;
    AxialLift lift_;
    TouchTeller tell_;
    Interval slopes_;
    LineTolerance fine_;
    std::optional<SlopeSteps> steps_;
    std::optional<LevelChoice> choice_;
    std::optional<LevelField> field_;
    std::optional<ContourPasses> passes_;
    std::vector<Level> levels_;
    PassFilter filter_;
    StrategyResult result_;
    UncutReport uncut_;
    SlopePiece steep_;
    double lowest_ = -infinity;
};

WaterlinePlanner::WaterlinePlanner(const WaterlineSettings& settings, const PlanContext& context,
                                   const Progress& progress)
    : settings_(settings), context_(context), progress_(progress), text_{context.unit, context.to_setup},
      cusp_allowed_(cusp_budget(settings, context)),
      allowance_(settings.allowance + context.tessellation_tolerance[1]),
      chord_(chord_budget(settings.chord_tolerance, cusp_allowed_)), profile_(context.tool.cutter()),
      cover_(profile_, cusp_detail(cusp_allowed_)), lift_(context.contact, profile_, allowance_),
      tell_(context.contact, cover_, facets_of_part(context), allowance_),
      slopes_{settings.slope_limits[0] - slope_slack, settings.slope_limits[1] + slope_slack},
      filter_(settings, context, profile_,
              {cusp_allowed_, allowance_, chord_, settings.holder_clearance, settings.tilt_limit,
               settings.rest_only},
              contact_at()) {
    // Between free places the cutter may come too near by half of the chord tolerance, by leaving places out
    // by the other half; what stays beside a contour is as much, and the steps leave room for both.
    fine_.below = 0.5 * chord_;
    fine_.above = 0.5 * chord_;
    fine_.spacing = safe_spacing(profile_, fine_.below);
}

double WaterlinePlanner::grid_spacing() const {
    const double radius = cover_.radius();
    const Vec3 size = context_.part_box.size();
    const double area = (size.x() + 4 * radius) * (size.y() + 4 * radius);
    const double spacing = std::max(settings_.grid_share * radius, std::sqrt(area / max_grid_places));
    if (spacing > coarsest_grid * radius)
        throw Error(ErrorCode::limit_exceeded, settings_.name,
                    "a part of " + text_(size.x()) + " by " + text_(size.y())
                        + " asks for too many places of this tool",
                    "check the part's units, or take a larger tool");
    return spacing;
}

bool WaterlinePlanner::has_slopes(const Progress& progress) const {
    const Mesh& mesh = *context_.part;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % 8192 == 0) progress.check();
        const Vec3 n = mesh.facet_normal(f);
        const double slope = std::acos(std::min(std::abs(n.z()), 1.0));
        if (n != Vec3::Zero() && slope >= slopes_.lo && slope <= slopes_.hi) return true;
    }
    return false;
}

void WaterlinePlanner::refuse_slopes() const {
    const auto degrees = [](double slope) { return format_number(slope * 180 / pi, 3); };
    throw Error(ErrorCode::empty_result, settings_.name,
                std::string("nothing of the part that can be cut ") + context_.seen_from()
                    + " has a slope from " + degrees(settings_.slope_limits[0]) + " to "
                    + degrees(settings_.slope_limits[1]) + " degrees",
                "widen the slope limits, or finish it by parallel passes");
}

void WaterlinePlanner::find_levels(const Progress& progress) {
    const double spacing = grid_spacing();
    const double longest =
        settings_.max_stepdown.is_number() ? settings_.max_stepdown.number : 2 * cover_.radius();
    steps_.emplace(cover_, standing_cusp(cusp_allowed_, chord_), longest);
    choice_.emplace(*steps_, slopes_, spacing);
    if (!has_slopes(progress)) refuse_slopes();
    const Box3 box = context_.part->box();
    // Beside the part there is room for the contours of its outer walls.
    const double beyond = cover_.radius() + allowance_ + 2 * spacing;
    const int columns = int(std::ceil((box.size().x() + 2 * beyond) / spacing)) + 1;
    field_.emplace(
        lift_, tell_, box, beyond, spacing,
        [&](int first, std::span<const TipTouch> touches) {
            choice_->look(first, columns, touches, progress.part(0, 0));
        },
        progress);
    if (choice_->empty()) refuse_slopes();
    LevelChoice::Limits limits;
    // Where the cutter is widest it comes down to the part's bottom.
    lowest_ = std::max(lowest_allowed(context_, settings_), context_.part_box.lo.z() - cover_.shoulder());
    limits.lowest = lowest_;
    limits.above_floor = 0.5 * chord_;
    if (settings_.stepdown.is_number()) limits.step = settings_.stepdown.number;
    if (limits.step && choice_->highest() - limits.lowest > double(max_levels) * *limits.step)
        throw Error(ErrorCode::limit_exceeded, "stepdown",
                    "a step-down of " + text_(*limits.step) + " makes more than " + std::to_string(max_levels)
                        + " levels",
                    "choose a larger step-down");
    levels_ = choice_->levels(limits, progress);
    if (levels_.size() > 4 * max_levels)
        throw Error(ErrorCode::limit_exceeded, "stepdown",
                    "the tolerance asks for " + std::to_string(levels_.size()) + " levels",
                    "allow a larger tolerance or set a step-down");
    if (levels_.empty())
        throw Error(ErrorCode::empty_result, settings_.name,
                    "what is as steep as asked for lies below the bottom of the stock",
                    "use a stock that reaches lower, or allow it by 'Below the bottom'");
}

void WaterlinePlanner::make_passes(const Progress& progress) {
    const ContourFinder finder(lift_, *field_, *choice_, fine_);
    std::vector<std::vector<Pass>> made(levels_.size());
    parallel_for(levels_.size(), 1, progress, [&](std::size_t i) {
        const Progress here = progress.part(0, 0);
        for (const Contour& contour : finder.contours(levels_[i], here))
            for (Pass& pass : passes_->passes(contour, levels_[i].z, here))
                made[i].push_back(std::move(pass));
    });
    const double shortest = shortest_piece * cover_.radius();
    double last = infinity;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const bool whole = levels_[i].cells.empty();
        std::size_t kept = 0;
        for (Pass& pass : made[i]) {
            // A piece between two levels that is shorter than that is not worth its links.
            if (!whole && !is_closed(pass) && arc_lengths(pass).back() < shortest) continue;
            pass.drive = pass.layer = int(i);
            // Contours have the part on their left; with it on the right the tool climbs.
            std::reverse(pass.cl.begin(), pass.cl.end());
            std::reverse(pass.cc.begin(), pass.cc.end());
            result_.passes.push_back(std::move(pass));
            ++kept;
        }
        if (!whole || kept == 0) continue;
        ++result_.drive_planes;
        if (last < infinity) {
            const double step = last - levels_[i].z;
            result_.stepover_min = result_.stepover_max > 0 ? std::min(result_.stepover_min, step) : step;
            result_.stepover_max = std::max(result_.stepover_max, step);
        }
        last = levels_[i].z;
    }
    if (result_.drive_planes == 0 && !result_.passes.empty()) result_.drive_planes = 1;
    if (!result_.passes.empty()) return;
    if (!context_.within) refuse_slopes();
    throw Error(ErrorCode::empty_result, boundary_place(context_.within->region->name()),
                "no level lies within it",
                "widen it or the slope limits, or take a tool that reaches what lies in it");
}

void WaterlinePlanner::keep_links_within() {
    for (std::size_t i = 1; i < result_.passes.size(); ++i)
        if (!passes_->may_link(result_.passes[i - 1].cl.back().tip, result_.passes[i].cl.front().tip))
            result_.passes[i].from_above = true;
}

void WaterlinePlanner::check_uncut(const Progress& progress) {
    steep_ = piece_between(context_, slopes_, progress.part(0, 0.05));
    if (!steep_.mesh) return;
    UncutInput input;
    input.mesh = steep_.mesh.get();
    input.lift = &lift_;
    input.cover = &cover_;
    input.allowance = allowance_;
    input.lowest_tip = lowest_;
    uncut_ = uncut_by_levels(input, context_, {result_.passes, filter_.held().left}, profile_, cusp_allowed_,
                             progress.part(0.05, 1));
}

void WaterlinePlanner::add_warnings() {
    auto& warnings = result_.warnings;
    if (settings_.stepdown.is_number() && result_.cusp_max > cusp_allowed_)
        warnings.push_back("the step-down of " + text_(settings_.stepdown.number) + " leaves cusps of "
                           + text_(result_.cusp_max) + "; the tolerance allows " + text_(cusp_allowed_));
    if (steep_.shallower > 0)
        warnings.push_back(
            share_text(steep_.shallower, steep_.all)
            + " of the surface is less steep than the slope limits and is left to other operations");
    if (uncut_.below > 0) warnings.push_back(below_warning(uncut_.below, steep_.all));
    if (uncut_.out_of_reach.height > 0)
        warnings.push_back(hollows_warning(uncut_.out_of_reach, steep_.all, text_));
    if (const UncutPlaces& u = uncut_.passed_by;
        u.height > (1 + tolerance::uncut_margin) * std::max(result_.cusp_max, cusp_allowed_))
        warnings.push_back("the levels leave more than expected: " + surface_share(u, steep_.all)
                           + " stays uncut by up to " + text_(u.height) + ", most at " + text_(u.at)
                           + ": choose a smaller step-down, or wider slope limits");
    add_kept_from_warnings(uncut_, steep_.all, filter_, context_, warnings);
    result_.cusp_max = std::max(result_.cusp_max, uncut_.passed_by.height);
}

PlannedPasses WaterlinePlanner::run(bool judged) {
    progress_.part(0, 1, "Choosing levels").set(0);
    find_levels(progress_.part(0, 0.3));
    ContourPasses::Options options;
    options.slopes = slopes_;
    options.chord = chord_;
    options.radius = cover_.radius();
    options.shoulder = cover_.shoulder();
    options.within = context_.within.get();
    options.facets = facets_of_part(context_);
    passes_.emplace(lift_, tell_, context_.contact->mesh(), options, progress_.part(0.3, 0.32));
    make_passes(progress_.part(0.32, 0.75, "Following levels"));
    result_.chord_tolerance = chord_;
    result_.cusp_max =
        settings_.stepdown.is_number() ? choice_->cusp_at(settings_.stepdown.number) + chord_ : cusp_allowed_;
    filter_.leave_out_held_up(result_.passes, progress_.part(0.75, 0.78));
    filter_.leave_out_air(result_.passes, progress_.part(0.78, 0.82));
    order_by_level(result_.passes, surface_link_distance(result_.stepover_max, context_.tool.diameter),
                   settings_.pattern == WaterlineSettings::Pattern::zigzag, progress_.part(0.82, 0.84));
    filter_.leave_out_beside_stock(result_.passes, progress_.part(0.84, 0.86));
    if (context_.within) keep_links_within();
    if (judged) {
        check_uncut(progress_.part(0.86, 1, "Looking for what stays uncut"));
        add_warnings();
    }
    progress_.set(1);
    return {std::move(result_), filter_.held(), filter_.beside_stock(), lowest_};
}

} // namespace

const ParameterTable<WaterlineSettings>& waterline_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = WaterlineSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        add_tool_axis_parameter(t);
        t.add(&S::stepdown, stepdown_parameter());
        t.add(&S::max_stepdown, max_stepdown_parameter());
        t.add(&S::slope_limits, {.key = "slope_limits",
                                 .label = "Slope limits",
                                 .help = "Slopes that are cut, from level: 0 is a floor, 90 degrees a wall. "
                                         "What is less steep is for parallel passes.",
                                 .kind = K::pair,
                                 .quantity = Quantity::angle,
                                 .minimum = 0,
                                 .maximum = 0.5 * pi});
        t.add_choice(
            &S::pattern,
            pattern_parameter("zigzag cuts open passes whichever way is nearer; oneway always with the "
                              "part on the right of the travel (climb milling)."));
        t.add(&S::chord_tolerance,
              chord_tolerance_parameter(
                  "How far straight moves may run beside the exact path, to either side"));
        t.add(&S::holder_clearance, holder_clearance_parameter());
        t.add(&S::tilt_limit, tilt_limit_parameter());
        t.add(&S::rest_only, rest_only_parameter());
        return t;
    }();
    return table;
}

StrategyResult Waterline::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    return with_tilt(settings_, context, progress, [&](const Progress& upright) {
        return WaterlinePlanner(settings_, context, upright).run(true).path;
    });
}

PlannedPasses waterline_passes(const WaterlineSettings& settings, const PlanContext& context,
                               const Progress& progress) {
    check_plannable(context, settings);
    return WaterlinePlanner(settings, context, progress).run(false);
}

} // namespace facetmill
