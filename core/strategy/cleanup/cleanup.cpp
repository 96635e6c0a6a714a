#include "core/strategy/cleanup/cleanup.h"

#include "core/base/parallel.h"
#include "core/strategy/cleanup/body_clearance.h"
#include "core/strategy/cleanup/cleanup_job.h"
#include "core/strategy/cleanup/foot_contours.h"
#include "core/strategy/cleanup/pass_clearing.h"
#include "core/strategy/cleanup/pass_leads.h"
#include "core/strategy/cleanup/passes_aside.h"
#include "core/strategy/cleanup/strip_search.h"
#include "core/strategy/cleanup/tip_grid.h"
#include "core/strategy/cleanup/touch_up.h"
#include "core/strategy/cleanup/uncut_strips.h"
#include "core/strategy/cleanup/working_passes.h"
#include "core/strategy/finish3/left_stock.h"
#include "core/strategy/plan/pass_order.h"

#include <atomic>
#include <iterator>

namespace facetmill {

namespace {

/// Points of all passes, before those that take nothing away are left out.
constexpr std::size_t max_cleanup_points = 3'000'000;
/// Where shank or holder would come into what stands, passes are moved by so many times the tolerance: the
/// cusps that finishing left on a wall are no higher.
constexpr double aside_share = 2;

const OperationRegistration registration("cleanup", "Clean-up", [] { return std::make_unique<Cleanup>(); });

class CleanupPlanner {
public:
    CleanupPlanner(const CleanupSettings& settings, const PlanContext& context, const Progress& progress)
        : settings_(settings), context_(context), job_(settings, context, progress) {}

    StrategyResult run(const Progress& progress) {
        found_ = find_strips(job_, progress.part(0.02, 0.5));
        if (found_.empty())
            throw NothingToDo(
                settings_.name,
                "tool " + std::to_string(settings_.previous_tool) + " leaves nowhere more than "
                    + job_.text(job_.cusp)
                    + (context_.earlier.empty() ? "" : " that the operations before have not cut")
                    + (settings_.left_points || settings_.rest_material ? ", nor do the operations before"
                                                                        : ""),
                "leave the operation out, or allow a smaller tolerance");
        result_.strips = described(job_, found_);
        cut(progress.part(0.5, 0.9, "Planning passes"));
        clear_body(progress.part(0.9, 0.93));
        if (result_.passes.empty()) nothing_to_cut();
        measure(progress.part(0.93, 1, "Measuring what stays"));
        own_.record = record();
        for (std::size_t i = 0; i < found_.size(); ++i)
            result_.strips[i].band = std::move(found_[i].band.band);
        result_.detail = std::move(own_);
        result_.chord_tolerance = job_.chord;
        add_warnings();
        return std::move(result_);
    }

private:
    void cut(const Progress& progress) {
        StripCutting with = job_.cutting();
        const TipGrid tips(job_.lift, job_.cover, context_.part->box(), bands_to_cut(),
                           progress.part(0, 0.05));
        with.tips = &tips;
        result_.stepover_min = infinity;
        std::vector<StripCut> cuts(found_.size());
        std::vector<BandCut> touched;
        const Progress strips = progress.part(0.05, 0.7), within = progress.part(0, 0);
        if (std::ranges::any_of(found_, [](const FoundStrip& f) { return f.kind == StripKind::foot; }))
            foot_contours_.emplace(job_, progress.part(0.05, 0.05));
        std::atomic<std::size_t> points = 0;
        parallel_for(found_.size(), 1, strips, [&](std::size_t i) {
            const FoundStrip& f = found_[i];
            if (!result_.strips[i].enabled) return;
            cuts[i] = f.left.piece.mesh ? cut_around_places(f, within)
                      : f.curve         ? cut_valley(with, *f.curve, f.band, within)
                                        : cut_hollow(with, f.band, within);
            for (const Pass& pass : cuts[i].passes)
                points += pass.cl.size();
            if (points > max_cleanup_points)
                throw Error(ErrorCode::limit_exceeded, settings_.name,
                            "its " + std::to_string(found_.size()) + " strips would take more than "
                                + std::to_string(max_cleanup_points) + " points of passes",
                            "allow a larger tolerance, use a tool with a larger corner radius, or switch "
                            "strips off");
        });
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (!result_.strips[i].enabled) continue;
            StripCut& c = cuts[i];
            result_.stepover_min = std::min(result_.stepover_min, c.stepover_min);
            result_.stepover_max = std::max(result_.stepover_max, c.stepover_max);
            blocked_ += c.blocked;
            if (!found_[i].left.piece.mesh) touched.push_back({&found_[i].band, &c});
        }
        if (result_.stepover_min == infinity) result_.stepover_min = result_.stepover_max;
        for (const BandCut& b : touched)
            planned_ += b.cut->passes.size();
        keep_working(with, touched, progress.part(0.7, 0.8));
        touch_up(with, touched, progress.part(0.8, 1));
        for (StripCut& c : cuts)
            std::move(c.passes.begin(), c.passes.end(), std::back_inserter(result_.passes));
        // Whatever made a pass, and however it was joined or shortened: no move is left unchecked.
        clear_passes(with, result_.passes, progress.part(1, 1));
    }

    std::vector<const RestBand*> bands_to_cut() const {
        std::vector<const RestBand*> bands;
        for (std::size_t i = 0; i < found_.size(); ++i)
            if (result_.strips[i].enabled && !found_[i].left.piece.mesh) bands.push_back(&found_[i].band);
        return bands;
    }

    StripCut cut_around_places(const FoundStrip& f, const Progress& progress) const {
        if (f.kind == StripKind::foot)
            if (StripCut foot{.passes = foot_contours_->passes(f.left, progress)}; !foot.passes.empty())
                return foot;
        StrategyResult path = cut_left(
            context_, settings_, settings_.pattern == CleanupSettings::Pattern::oneway, f.left, progress);
        StripCut cut;
        cut.passes = std::move(path.passes);
        if (cut.passes.empty()) cut.blocked = f.band.length;
        cut.stepover_min = path.stepover_max > 0 ? path.stepover_min : infinity;
        cut.stepover_max = path.stepover_max;
        return cut;
    }

    /// Leaves out where shank or holder would touch, or inclines the tool there.
    void clear_body(const Progress& progress) {
        if (settings_.tilt_limit > 0) {
            const StripCutting with = job_.cutting();
            for (Pass& pass : result_.passes)
                if (pass.cl.size() > 1) add_leads(with, pass);
            clear_passes(with, result_.passes, progress.part(0, 0));
        }
        ClearedPasses cleared = with_clear_body(job_, result_.passes, progress);
        held_ = cleared.held;
        held_by_ = cleared.held_by;
        result_.passes = std::move(cleared.passes);
        order(result_.passes, progress);
        if (settings_.tilt_limit == 0)
            lead_between(job_, result_.passes,
                         surface_link_distance(result_.stepover_max, context_.tool.diameter),
                         progress.part(1, 1));
        clear_of_stock(progress.part(1, 1));
        if (settings_.tilt_limit > 0) {
            own_.lead_min = 0;
            own_.lead_max = cleared.largest_tilt;
        }
        for (std::size_t i = 0; i < result_.passes.size(); ++i)
            result_.passes[i].drive = int(i);
        result_.drive_planes = int(result_.passes.size());
    }

    void order(std::vector<Pass>& passes, const Progress& progress) const {
        const double top = std::max(context_.part_box.hi.z(), context_.stock_box.hi.z());
        order_by_travel(passes, settings_.pattern == CleanupSettings::Pattern::zigzag,
                        top + settings_.clearance, progress.part(1, 1));
    }

    /// Beside those that are held up, the nearest to where the tool is first.
    std::vector<Pass> passes_instead(const std::vector<Pass>& held, const std::optional<Vec3>& end,
                                     const Progress& progress) const {
        std::vector<Pass> others;
        if (end) {
            Pass& here = others.emplace_back();
            here.cl.push_back({*end, Vec3::UnitZ()});
            here.cc.push_back({*end, Vec3::UnitZ()});
        }
        for (const Pass& pass : held)
            for (Pass& other : passes_aside(job_, pass, aside_share * job_.cusp, progress))
                others.push_back(std::move(other));
        order(others, progress);
        if (end) others.erase(others.begin());
        return others;
    }

    /// Leaves out where shank or holder would come into what operations before left, in the order in which
    /// the passes are cut. Only for an upright tool: LeftStock knows no other.
    void clear_of_stock(const Progress& progress) {
        if (settings_.tilt_limit > 0) return;
        const ContactAt contact = [&](const Vec3& tip) {
            const Vec3 point = job_.lift.contact(tip.x(), tip.y()).point;
            return CutterContact{point, job_.cover.contact_normal(point - tip).value_or(Vec3::UnitZ())};
        };
        const PassesInstead aside = [&](const std::vector<Pass>& held, const std::optional<Vec3>& end) {
            return passes_instead(held, end, progress);
        };
        auto clear = keep_clear_of_left_stock(result_.passes, context_, job_.radius, job_.cusp, contact,
                                              progress, aside);
        if (!clear) return;
        beside_stock_ = std::move(*clear);
        if (result_.passes.empty() && !beside_stock_.left.empty())
            refuse_beside_stock(settings_.name, beside_stock_, context_);
    }

    /// Why there is no pass at all.
    [[noreturn]] void nothing_to_cut() const {
        const auto refuse = [&](const std::string& what, const std::string& remedy) {
            throw Error(ErrorCode::empty_result, settings_.name, what, remedy);
        };
        if (std::none_of(result_.strips.begin(), result_.strips.end(),
                         [](const Strip& s) { return s.enabled; }))
            refuse("all strips are switched off", "switch one on, or leave the operation out");
        if (held_ > 0)
            refuse("the tool's " + std::string(tool_body_name(held_by_))
                       + " would touch the part wherever there is something to cut",
                   settings_.tilt_limit > 0
                       ? "use a longer tool, or allow a larger tilt limit"
                       : "use a longer tool, or allow it to be inclined by a tilt limit");
        if (planned_ > 0)
            throw NothingToDo(settings_.name,
                              "the tool takes away nowhere more than " + job_.text(job_.cusp)
                                  + " of what stands on the " + std::to_string(found_.size()) + " strips",
                              "use a smaller tool, or leave the operation out");
        throw Error(ErrorCode::empty_result, settings_.name,
                    "the tool can stand nowhere along the " + std::to_string(found_.size())
                        + " strips that tool " + std::to_string(settings_.previous_tool) + " left",
                    "use a smaller or longer tool");
    }

    /// What stays of the strips.
    void measure(const Progress& progress) {
        const UncutStrips uncut = measure_uncut(job_, found_, result_.strips, result_.passes, progress);
        result_.cusp_max = uncut.reached;
        auto& warnings = result_.warnings;
        if (uncut.hollow > 0)
            warnings.push_back("the cutter is too large for the innermost of the strips: up to "
                               + job_.text(uncut.hollow) + " stays, most at " + job_.text(uncut.hollow_at)
                               + ": use a smaller tool there");
        if (uncut.missed_area > 0)
            warnings.push_back(
                format_number(std::max(100 * uncut.missed_area / uncut.area, 1e-3), 2)
                + " % of the strips stays uncut"
                + (uncut.missed < infinity ? " by up to " + job_.text(uncut.missed) : std::string())
                + ", as at " + job_.text(uncut.missed_at));
    }

    std::shared_ptr<const CleanupRecord> record() const {
        auto record = std::make_shared<CleanupRecord>();
        record->previous = context_.further_tools.front();
        for (std::size_t i = 0; i < found_.size(); ++i)
            if (found_[i].curve && found_[i].kind == StripKind::valley)
                for (const PencilPoint& p : found_[i].curve->points)
                    record->touches.push_back({i, p.center, p.tip, p.touch, p.gap});
        return record;
    }

    void add_warnings() {
        auto& warnings = result_.warnings;
        if (blocked_ > job_.ripple)
            warnings.push_back("the cutter has no place along " + job_.text(blocked_)
                               + " of its passes: they are left out there");
        if (held_ > 0)
            warnings.push_back(
                "the " + std::string(tool_body_name(held_by_)) + " would touch the part along "
                + job_.text(held_) + " of passes, which are left out: use a longer tool"
                + (settings_.tilt_limit > 0 ? "" : ", or allow it to be inclined by a tilt limit"));
        if (beside_stock_.left_length > 0) warnings.push_back(beside_stock_warning(beside_stock_, context_));
    }

    const CleanupSettings& settings_;
    const PlanContext& context_;
    CleanupJob job_;
    std::vector<FoundStrip> found_;
    std::optional<FootContours> foot_contours_;
    std::size_t planned_ = 0;       ///< passes, before those that take nothing away were left out
    double blocked_ = 0, held_ = 0; ///< lengths of what is left out: no place; shank or holder would touch
    ToolBody held_by_ = ToolBody::none;
    ClearOfStock beside_stock_;
    StrategyResult result_;
    CleanupPath own_;
};

} // namespace

std::span<const CleanupRecord::Touch> CleanupRecord::of(std::size_t strip) const {
    const auto [first, last] =
        std::equal_range(touches.begin(), touches.end(), Touch{.strip = strip},
                         [](const Touch& a, const Touch& b) { return a.strip < b.strip; });
    return {first, last};
}

StrategyResult Cleanup::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    if (context.further_tools.empty())
        throw Error(ErrorCode::missing_reference, "previous_tool", "the tool that cut before is not known",
                    "give the number of the previous tool");
    if (settings_.previous_tool == settings_.tool)
        throw Error(ErrorCode::out_of_range, "previous_tool",
                    "tool " + std::to_string(settings_.tool) + " is to clean up what it left itself",
                    "choose a smaller tool, or the one that cut before");
    return CleanupPlanner(settings_, context, progress.part(0, 0.02)).run(progress);
}

} // namespace facetmill
