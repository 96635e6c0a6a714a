#include "core/strategy/global_local/global_local.h"

#include "core/base/figures.h"
#include "core/base/tolerances.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/five_axis/five_axis_parameters.h"
#include "core/strategy/global_local/coverage.h"
#include "core/strategy/global_local/find_regions.h"
#include "core/strategy/global_local/tool_advice.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/pass_order.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

const OperationRegistration registration("global_local", "Global-local CM²",
                                         [] { return std::make_unique<GlobalLocal>(); });

/// Distance of the places that are looked at after cutting, in radii of the main cutter; no more places than
/// about the number.
constexpr double sample_share = 1.0 / 12, max_samples = 2'000'000;
/// Share of the part's surface that the main path has to have to cut at least.
constexpr double min_main_share = 0.02;
/// What stays is said from this share of the surface on.
constexpr double told_share = 1e-5;
/// Narrow strips are left to the rework tool, but where that is more than this share of the part nothing is:
/// strips are narrow everywhere then, and better than those of the rework tool.
constexpr double max_left_share = 0.1;
std::string minutes_text(double seconds) {
    return format_number(seconds / 60, 3) + " min";
}

std::string region_count(std::size_t n) {
    return std::to_string(n) + (n == 1 ? " region" : " regions");
}

/// The smallest cutter curvature that does nearly everywhere, as advice.
std::string smaller_tool(const RegionSource& source, const GlobalLocalSettings& settings, double diameter,
                         LengthUnit unit) {
    std::vector<double> sines;
    for (const AssumedContact& c : source.assumed.contacts)
        sines.push_back(std::sin(std::min(c.lead, settings.assumed_lead_limit)));
    const auto at = sines.begin() + long(sines.size() / 2);
    std::nth_element(sines.begin(), at, sines.end());
    // (7): the diameter that takes the lead of half the part down to the limit.
    const double fitting = *at > 0 ? diameter * std::sin(settings.lead_limit) / *at : diameter;
    return fitting < diameter
               ? "use a smaller tool: one of " + length_text(fitting, unit) + " does on half of the part"
               : "use a smaller tool";
}

void check_rework_tool(const GlobalLocalSettings& settings, const PlanContext& context) {
    if (settings.rework_tool == 0) return;
    if (context.further_tools.size() != 1)
        throw Error(ErrorCode::internal, "rework_tool", "the rework tool is not known", "report this");
    const Tool& t = context.further_tools.front();
    check_tool(t);
    const bool ball = std::abs(t.corner_radius - 0.5 * t.diameter) <= tolerance::same_shape * t.diameter;
    const bool wants_ball = settings.rework_cutting == GlobalLocalSettings::ReworkCutting::ball;
    if (wants_ball && !ball)
        throw Error(ErrorCode::out_of_range, "rework_tool",
                    "tool " + std::to_string(t.number) + " has no ball end",
                    "choose a ball, or let it match the curvature (CM2)");
    if (!wants_ball && ball)
        throw Error(ErrorCode::out_of_range, "rework_tool",
                    "tool " + std::to_string(t.number) + " is a ball, which matches no curvature by its lead",
                    "choose a flat or bull-nosed tool, or cut the regions as with a ball");
}

const ReworkPlan& rework_of(const StrategyResult& plan) {
    return *std::get<GlobalLocalPath>(plan.detail).rework;
}

/// What main and rework path take at feed, with the travel between passes.
double seconds(const StrategyResult& plan, double feed, double clear_z) {
    double length = 0;
    for (const StrategyResult* path : {&plan, &rework_of(plan).path}) {
        const Pass* last = nullptr;
        for (const Pass& pass : path->passes) {
            if (pass.cl.empty()) continue;
            if (last) length += travel_between(last->cl.back().tip, pass.cl.front().tip, clear_z);
            for (std::size_t i = 1; i < pass.cl.size(); ++i)
                length += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
            last = &pass;
        }
    }
    return length / (feed / 60);
}

class GlobalLocalPlanner {
public:
    GlobalLocalPlanner(const GlobalLocalSettings& settings, const PlanContext& context,
                       std::shared_ptr<const RegionSource> source, const Progress& progress)
        : settings_(settings), context_(context), progress_(progress), up_(*context.part, progress) {
        plan_->source = std::move(source);
        if (settings_.rework_tool != 0) plan_->tool = context_.further_tools.front();
        radius_ = CutterProfile(context_.tool.cutter()).max_radius();
    }

    StrategyResult run() {
        find(*plan_->source, {}, progress_.part(0, 0.05, "Finding rework regions"));
        check_main();
        StrategyResult result = main_path(leave(), progress_.part(0.05, 0.65));
        double left = look_at_main(result);
        if (left > max_left_share * plan_->part_area) {
            plan_->left_by_main.clear();
            result = main_path(0, progress_.part(0.65, 0.65));
            look_at_main(result);
        }
        if (!plan_->left_by_main.empty())
            find(*plan_->source, plan_->left_by_main, progress_.part(0.7, 0.72, "Finding rework regions"));
        cut_regions(result);
        look_at_rest(result);
        report(result);
        return result;
    }

    /// No place is taken out of the part for the lead it needs: passes all along it as five-axis finishing
    /// makes them, in the direction that it takes by itself, and regions where they leave something.
    StrategyResult run_whole() {
        // What the assumed path's contacts ask for is asked of the passes themselves.
        RegionSource whole = *plan_->source;
        whole.assumed.contacts.clear();
        find(whole, {}, progress_.part(0, 0));
        Finish5Settings main = settings_;
        main.lead_limits = {0, settings_.lead_limit};
        main.sides = Finish5Settings::Sides::top;
        StrategyResult result =
            Finish5(main).plan(context_, progress_.part(0, 0.65, settings_.name + ": main path"));
        result.warnings.clear(); // what is left is looked for below
        look_at_main(result);
        if (!plan_->left_by_main.empty())
            find(whole, plan_->left_by_main, progress_.part(0.7, 0.72, "Finding rework regions"));
        cut_regions(result);
        look_at_rest(result);
        report(result);
        return result;
    }

private:
    void find(const RegionSource& source, std::span<const UncutPlace> further, const Progress& progress) {
        FoundRegions found = find_regions(source, settings_, context_.unit, further, progress);
        plan_->pairs = std::move(found.pairs);
        if (further.empty()) outside_ = found.regions.outside;
        plan_->regions = std::move(found.regions);
        plan_->part_area = plan_->regions.part_area;
    }

    void check_main() const {
        const ReworkRegions& r = plan_->regions;
        if (r.part_area - r.uncut_area >= min_main_share * r.part_area) return;
        throw Error(ErrorCode::empty_result, settings_.name,
                    "a lead of at most " + angle_text(settings_.lead_limit)
                        + " leaves the whole part uncut with this tool",
                    smaller_tool(*plan_->source, settings_, 2 * radius_, context_.unit)
                        + ", or raise the lead limit");
    }

    PlanContext on(const PartPiece& piece) const {
        PlanContext c = context_;
        c.part = piece.mesh;
        c.geometry = piece.geometry;
        c.curvatures = piece.curvatures;
        return c;
    }

    /// Strips narrower than `leave` are left to the rework tool.
    StrategyResult main_path(double leave, const Progress& progress) {
        Finish5Settings main = settings_;
        main.lead_limits = {0, settings_.lead_limit};
        main.direction = {plan_->source->assumed.direction, ""};
        StrategyResult result =
            finish_piece(main, on(outside_), progress.part(0, 1, settings_.name + ": main path"), leave);
        if (result.passes.empty())
            throw Error(ErrorCode::empty_result, settings_.name,
                        "no contact point has a free posture with a lead of at most "
                            + angle_text(settings_.lead_limit),
                        smaller_tool(*plan_->source, settings_, 2 * radius_, context_.unit)
                            + ", or raise the lead limit");
        order_by_travel(result.passes, false, clear_z(), progress.part(1, 1));
        return result;
    }

    /// The rework ball's strip on a level place, mm: where those of the main path are narrower, the ball is
    /// faster.
    double leave() const {
        const auto& edits = settings_.region_edits;
        // What is left next to a region that is switched off would stay.
        if (settings_.rework_tool == 0
            || std::any_of(edits.begin(), edits.end(), [](const RegionEdit& e) { return !e.enabled; }))
            return 0;
        return widest_strip(0.5 * plan_->tool.diameter, cusp_budget(settings_, context_));
    }
    double clear_z() const {
        return std::max(context_.part_box.hi.z(), context_.stock_box.hi.z()) + settings_.clearance;
    }
    double sample_spacing() const {
        return std::max(sample_share * radius_, std::sqrt(2 * plan_->part_area / max_samples));
    }
    double raise() const {
        return settings_.allowance + context_.tessellation_tolerance[1] + cusp_budget(settings_, context_);
    }

    /// Notes what the main path leaves of what it was to cut; its area, mm^2.
    double look_at_main(const StrategyResult& main) {
        Coverage coverage(
            surface_samples(*outside_.mesh, outside_.geometry->vertex_normals, up_, sample_spacing()),
            raise());
        coverage.add(main.passes, CutterProfile(context_.tool.cutter()),
                     progress_.part(0.65, 0.7, "Looking at what the main path clears"));
        for (std::size_t i = 0; i < coverage.samples().size(); ++i)
            if (!coverage.cleared(i)) {
                const SurfaceSample& s = coverage.samples()[i];
                plan_->left_by_main.push_back({s.point, s.normal, 0});
            }
        return coverage.area() - coverage.cleared_area();
    }

    void cut_regions(const StrategyResult& main) {
        const PartPiece& within = plan_->regions.within;
        if (settings_.rework_tool == 0 || !within.mesh || within.mesh->facets.empty()) return;
        PlanContext context = on(within);
        context.tool = plan_->tool;
        context.further_tools.clear();
        const Progress progress = progress_.part(0.72, 0.97, settings_.name + ": rework path");
        const NumberOrWord direction{machining_angle(settings_.machining_direction, main.direction), ""};
        if (settings_.rework_cutting == GlobalLocalSettings::ReworkCutting::cm2) {
            Finish5Settings rework = settings_;
            rework.posture = Finish5Settings::PostureChoice::cm2;
            rework.lead_limits = {0, settings_.assumed_lead_limit};
            rework.direction = direction;
            rework.stepover = {0, "adaptive"};
            plan_->three_axis = false;
            plan_->path = finish_piece(rework, context, progress);
            return;
        }
        Finish3Settings rework;
        static_cast<OperationCommon&>(rework) = settings_;
        rework.direction = direction;
        rework.pattern = settings_.pattern == Finish5Settings::Pattern::zigzag
                             ? Finish3Settings::Pattern::zigzag
                             : Finish3Settings::Pattern::oneway;
        rework.chord_tolerance = settings_.chord_tolerance;
        rework.normal_limit = settings_.normal_limit;
        plan_->path = Finish3(rework).plan(context, progress);
        order_by_travel(plan_->path.passes, settings_.pattern == Finish5Settings::Pattern::zigzag, clear_z(),
                        progress.part(1, 1));
        // What it cannot reach is looked for below, on what the main path leaves only.
        plan_->path.warnings.clear();
    }

    void look_at_rest(StrategyResult& main) {
        std::shared_ptr<const MeshGeometry> geometry = plan_->source->geometry;
        Coverage coverage(surface_samples(*context_.part, geometry->vertex_normals, up_, sample_spacing()),
                          raise());
        const Progress progress = progress_.part(0.97, 1, "Looking at what both paths clear");
        coverage.add(main.passes, CutterProfile(context_.tool.cutter()), progress.part(0, 0.4));
        if (!plan_->path.passes.empty())
            coverage.add(plan_->path.passes, CutterProfile(plan_->tool.cutter()), progress.part(0.4, 1));
        plan_->remaining_area = coverage.area() - coverage.cleared_area();
        main.cleanup.clear();
        for (std::size_t i = 0; i < coverage.samples().size(); ++i)
            if (!coverage.cleared(i))
                main.cleanup.push_back({coverage.samples()[i].point, coverage.samples()[i].normal});
        main.cleanup_points = main.cleanup.size();
        total_ = coverage.area();
    }

    void report(StrategyResult& result) {
        std::size_t on = 0;
        for (const ReworkRegion& r : plan_->regions.regions) {
            result.strips.push_back(r.strip);
            on += r.strip.enabled;
        }
        const std::size_t regions = plan_->regions.regions.size();
        auto& told = result.warnings;
        const std::size_t off = regions - on;
        if (regions == 0)
            told.push_back("no place needs a lead above " + angle_text(settings_.lead_limit)
                           + ": the main path cuts all of the part, there is nothing to rework");
        else if (settings_.rework_tool == 0)
            told.push_back(region_count(regions)
                           + " stay uncut: choose a rework tool, or cut them by another operation");
        if (off > 0 && settings_.rework_tool != 0)
            told.push_back(region_count(off) + (off == 1 ? " is" : " are") + " switched off and not cut");
        if (plan_->remaining_area > told_share * total_) {
            std::string where;
            if (!result.cleanup.empty()) {
                const Vec3& p = result.cleanup.front().point;
                where = ", as at " + length_text(p.x(), context_.unit) + ", "
                        + length_text(p.y(), context_.unit) + ", " + length_text(p.z(), context_.unit);
            }
            told.push_back(percent_text(plan_->remaining_area / total_, 2)
                           + " of the surface is cleared by neither path" + where
                           + (settings_.rework_tool != 0 ? ": use a smaller rework tool" : ""));
        }
        result.detail = GlobalLocalPath{std::get<TiltedPath>(std::move(result.detail)), plan_};
    }

    const GlobalLocalSettings& settings_;
    const PlanContext& context_;
    Progress progress_;
    UpSide up_;
    PartPiece outside_; ///< what the main path is planned over
    std::shared_ptr<ReworkPlan> plan_ = std::make_shared<ReworkPlan>();
    double radius_ = 0, total_ = 0;
};

} // namespace

const ParameterTable<GlobalLocalSettings>& global_local_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = GlobalLocalSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        t.set_stage("feed", Stage::strategy); // postures are chosen by time
        t.set_help("direction", "Direction of travel of the main path: auto follows the assumed path along x "
                                "and y and takes the one with less estimated time of main path and rework; a "
                                "number is an angle from X.");
        t.add(&S::lead_limit,
              {.key = "lead_limit",
               .label = "Lead limit",
               .help = "Largest inclination of the main path's tool axis, alpha_M, where it is not "
                       "raised. Smaller: wider strips and more to rework.",
               .kind = K::number,
               .quantity = Quantity::angle,
               .minimum = 0,
               .maximum = radians(89),
               .open_minimum = true});
        t.add(&S::assumed_lead_limit,
              {.key = "assumed_lead_limit",
               .label = "Assumed lead limit",
               .help = "Largest inclination of the assumed previous path, which tells how much lead every "
                       "place needs; and of the rework path by cm2.",
               .kind = K::number,
               .quantity = Quantity::angle,
               .minimum = 0,
               .maximum = radians(89),
               .open_minimum = true});
        t.add(&S::raise_lead_limit,
              {.key = "raise_lead_limit",
               .label = "Raise lead limit",
               .help =
                   "Where leads up to the assumed limit on passes all over the part take less time than the "
                   "lead limit and rework together, they are used. false: the lead limit is kept. Edited "
                   "regions keep it too.",
               .kind = K::boolean});
        t.add(&S::rework_offset,
              {.key = "rework_offset",
               .label = "Rework offset",
               .help = "How far rework goes beyond the uncut places, so that the two paths overlap.",
               .kind = K::number,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1e4});
        t.add(&S::rework_tool,
              further_tool_parameter({.key = "rework_tool",
                                      .label = "Rework tool",
                                      .help = "Number of the tool that cuts the regions; 0: none, they are "
                                              "shown and left to other operations."},
                                     0));
        t.add_choice(&S::rework_cutting,
                     {.key = "rework_cutting",
                      .label = "Rework cutting",
                      .help =
                          "ball cuts the regions with a ball and a vertical axis; cm2 with a smaller flat "
                          "or bull-nosed tool whose lead matches the curvature.",
                      .words = {"ball", "cm2"}});
        t.add(&S::machining_direction,
              travel_parameter({.key = "machining_direction",
                                .label = "Machining direction",
                                .help = "Direction of travel of the rework path: auto is that of the main "
                                        "path; a number is an angle from X."}));
        t.add(&S::view_direction,
              {.key = "view_direction",
               .label = "View direction",
               .help = "Direction in which the trajectories are looked at to tell forward "
                       "from backward motion.",
               .kind = K::triple,
               .minimum = -1e6,
               .maximum = 1e6,
               .advanced = true});
        add_five_axis_parameters(t);
        t.add_records(&S::region_edits, region_edit_list,
                      {.label = "Region edits",
                       .help = "Rework regions that were switched off, grown or shrunk by hand.",
                       .nouns = {"edited region", "edited regions"}});
        t.add_records(&S::boundary_drags, boundary_drag_list,
                      {.label = "Boundary drags",
                       .help = "Points of the regions' boundaries that were dragged over the surface.",
                       .nouns = {"dragged point", "dragged points"}});
        return t;
    }();
    return table;
}

bool may_raise_lead_limit(const GlobalLocalSettings& s) {
    return s.raise_lead_limit && s.rework_tool != 0 && s.lead_limit < s.assumed_lead_limit
           && s.region_edits.empty() && s.boundary_drags.empty();
}

StrategyResult GlobalLocal::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    check_rework_tool(settings_, context);
    const GlobalLocalSettings& s = settings_;
    const auto source = region_source(context, s, progress.part(0, 0.1, "Following the assumed path"));
    const bool may_raise = may_raise_lead_limit(s);
    StrategyResult capped =
        GlobalLocalPlanner(s, context, source, progress.part(0.1, may_raise ? 0.6 : 1)).run();
    if (!may_raise || rework_of(capped).regions.regions.empty()) return capped;
    GlobalLocalSettings raised = s;
    raised.lead_limit = s.assumed_lead_limit;
    StrategyResult whole;
    try {
        whole = GlobalLocalPlanner(raised, context, source, progress.part(0.6, 1)).run_whole();
    } catch (const Error& e) {
        if (e.code() != ErrorCode::empty_result) throw;
        return capped;
    }
    const double clear_z = std::max(context.part_box.hi.z(), context.stock_box.hi.z()) + s.clearance;
    const double own = seconds(capped, s.feed, clear_z), other = seconds(whole, s.feed, clear_z);
    if (!(other < own)
        || rework_of(whole).remaining_area
               > rework_of(capped).remaining_area + told_share * rework_of(whole).part_area)
        return capped;
    whole.warnings.insert(whole.warnings.begin(),
                          "the lead limit is raised to " + angle_text(raised.lead_limit)
                              + ": that takes about " + minutes_text(other) + ", " + angle_text(s.lead_limit)
                              + " and rework of " + region_count(rework_of(capped).regions.regions.size())
                              + " " + minutes_text(own));
    return whole;
}

} // namespace facetmill
