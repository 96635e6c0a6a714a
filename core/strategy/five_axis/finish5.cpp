#include "core/strategy/five_axis/finish5.h"

#include "core/base/tolerances.h"
#include "core/strategy/five_axis/five_axis_parameters.h"
#include "core/strategy/five_axis/part_tops.h"
#include "core/strategy/five_axis/partial_passes.h"
#include "core/strategy/five_axis/pass_cutter.h"
#include "core/strategy/five_axis/pass_placement.h"
#include "core/strategy/five_axis/tilted_stepover.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/plan/plan_text.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

const OperationRegistration registration("finish5", "Finish, 5-axis",
                                         [] { return std::make_unique<Finish5>(); });

/// Drive planes of a plan, at most: more come from a part in another unit.
constexpr std::size_t max_drive_planes = 100000;
/// Contact points of a plan, roughly: a day's work.
constexpr double max_contacts = 2e7;
/// The step that the search starts with, in diameters.
constexpr double first_step_share = 0.4;
/// The share of its travel that partial passes have to save on a whole part: they begin and end on the
/// surface, and what they cut there they cut twice.
constexpr double min_partial_gain = 0.1;

/// What is said about a path, beside what it knows itself.
struct Told {
    const Finish5Settings& settings;
    PlanText text;
    int unsatisfied = 0;    ///< drive planes
    std::size_t points = 0; ///< contact points
    double cusp = 0;        ///< what may stay, mm
};

void warn(const Told& t, const UnfreePoints& unfree, const KeptPostures& kept, StrategyResult& result) {
    auto& told = result.warnings;
    if (t.unsatisfied > 0 && t.settings.passes == Finish5Settings::Passes::parallel)
        told.push_back(std::to_string(t.unsatisfied) + " of " + std::to_string(result.drive_planes)
                       + " drive planes cross places where no step-over meets the tolerance");
    else if (t.unsatisfied > 0)
        told.push_back(std::to_string(t.unsatisfied) + " of " + std::to_string(result.drive_planes)
                       + " passes cross places where no step-over meets the tolerance");
    if (unfree.count() > 0)
        told.push_back(std::to_string(unfree.count()) + " of " + std::to_string(t.points)
                       + " contact points have no free posture and are left to clean-up; mostly "
                       + unfree.main_cause(t.settings.posture));
    if (unfree.narrowed() > 0)
        told.push_back("beside " + std::to_string(unfree.narrowed()) + " of " + std::to_string(t.points)
                       + " contact points no posture clears the whole strip: it is cut under the pass, and "
                         "left to clean-up beside it");
    if (const std::size_t said = unfree.count() + unfree.narrowed(); result.cleanup_points > said)
        told.push_back(result.cleanup_points - said == 1
                           ? "one place is left to clean-up because the tool cannot come there from "
                             "its neighbours without gouging or turning too far"
                           : std::to_string(result.cleanup_points - said)
                                 + " places are left to clean-up because the tool cannot come there from "
                                   "its neighbours without gouging or turning too far");
    for (std::string& warning : kept.warnings())
        told.push_back(std::move(warning));
    if (t.settings.stepover.is_number() && result.cusp_max > t.cusp)
        told.push_back("the step-over of " + t.text(t.settings.stepover.number) + " leaves cusps of "
                       + t.text(result.cusp_max) + "; the tolerance allows " + t.text(t.cusp));
}

class Planner5 {
public:
    Planner5(const Finish5Settings& settings, const PlanContext& context, const Progress& progress,
             bool is_piece = false, double leave = 0, const Mat3& view = Mat3::Identity())
        : settings_(settings), text_{context.unit}, progress_(progress), is_piece_(is_piece),
          field_(context, settings, progress.part(0, 0.05), false, view), stepover_(field_, leave),
          partial_(stepover_, settings.pattern == Finish5Settings::Pattern::zigzag,
                   is_piece ? 0 : min_partial_gain),
          cutter_(field_) {}

    StrategyResult run() {
        const auto& lines = field_.lines();
        if (!(lines.lo() <= lines.hi()) && is_piece_) return {};
        if (!(lines.lo() <= lines.hi()))
            throw Error(ErrorCode::empty_result, settings_.name, "no drive plane meets the part",
                        "check part and direction");
        check_size();
        result_.direction = field_.drive().angle;
        progress_.part(0.05, 1, "Finishing with five axes").set(0);
        if (settings_.stepover.is_number())
            plan_constant(settings_.stepover.number);
        else
            plan_adaptive();
        cutter_.finish(progress_.part(1, 1));
        finish();
        return std::move(result_);
    }

    const PassCutter& cutter() const { return cutter_; }
    int unsatisfied() const { return unsatisfied_; } ///< drive planes

private:
    using Clock = std::chrono::steady_clock;

    Progress at(double v) const {
        const double lo = field_.lines().lo(), hi = field_.lines().hi();
        const double share = hi > lo ? (v - lo) / (hi - lo) : 1.0;
        const double f = 0.05 + 0.95 * std::clamp(share, 0.0, 1.0);
        return progress_.part(f, f);
    }

    int travel(int drive) const {
        return settings_.pattern == Finish5Settings::Pattern::zigzag && drive % 2 == 1 ? -1 : 1;
    }

    /// What would take days is most likely a part in another unit.
    void check_size() const {
        const Vec3 size = field_.seen_box().size();
        const double step =
            settings_.stepover.is_number() ? settings_.stepover.number : 0.5 * field_.radius();
        if (size.x() * size.y() <= max_contacts * step * 0.4 * field_.radius()) return;
        throw Error(ErrorCode::limit_exceeded, settings_.name,
                    "a part of " + text_(size.x()) + " by " + text_(size.y()) + " asks for more than "
                        + format_number(max_contacts) + " contact points of this tool",
                    "check the part's units, or take a larger tool or step-over");
    }

    template <class Make>
    auto timed(Make&& make) {
        const auto start = Clock::now();
        auto made = make();
        tilted_.stage_seconds[0] += std::chrono::duration<double>(Clock::now() - start).count();
        return made;
    }

    void plan_adaptive() {
        const double usual = first_step_share * 2 * field_.radius();
        result_.stepover_min = infinity;
        auto first =
            timed([&] { return stepover_.next(nullptr, travel(0), 0.5 * usual, at(field_.lines().lo())); });
        if (!first.satisfied) ++unsatisfied_;
        plan_after(std::move(first.pass), usual);
        if (result_.stepover_max == 0) result_.stepover_min = 0;
    }

    /// The passes from the first one on. Were all of them as long as the part, they would be as close
    /// together as the narrowest of their strips asks for.
    void plan_after(EstimatedPass last, double usual) {
        const auto& lines = field_.lines();
        std::vector<double> border_lo;
        while (true) {
            const Progress here = at(last.v);
            if (result_.drive_planes >= int(max_drive_planes))
                refuse_planes("tolerance", "the tolerance asks for");
            const bool at_end = lines.beyond(lines.hi(), lines.lo()) - last.plane <= 1;
            PassGap gap;
            if (!at_end && !timed([&] { return stepover_.reaches_border(last); }))
                gap = timed([&] { return partial_.next(last, usual, here); });
            if (!gap.satisfied) ++unsatisfied_;
            if (gap.next) {
                usual = gap.next->v - last.v;
                result_.stepover_min = std::min(result_.stepover_min, usual);
                result_.stepover_max = std::max(result_.stepover_max, usual);
            }
            const bool is_last = !gap.next && gap.partial.empty();
            finish_pass(last, border_lo, is_last ? std::vector<double>() : gap.border_lo, here);
            for (const PartialPass& p : gap.partial)
                finish_pass(p.pass, p.border_lo, p.border_hi, here);
            if (!gap.next) break;
            border_lo = std::move(gap.border_hi);
            last = std::move(*gap.next);
        }
    }

    void plan_constant(double step) {
        const auto& lines = field_.lines();
        step *= field_.fineness(); // where passes come together they are closer than that
        const double planes =
            std::max(1.0, std::ceil((lines.hi() - lines.lo()) / step - tolerance::level_angle));
        if (planes > double(max_drive_planes))
            refuse_planes("stepover", "a step-over of " + text_(step) + " makes");
        const double first = 0.5 * (lines.lo() + lines.hi()) - 0.5 * (planes - 1) * step;
        for (std::size_t i = 0; i < std::size_t(planes); ++i) {
            const double v = first + double(i) * step;
            const Progress here = at(v);
            const long plane = std::lround((v - lines.lo()) / lines.spacing());
            const EstimatedPass pass = timed([&] { return stepover_.estimate(plane, travel(int(i)), here); });
            std::vector<double> lo(stepover_.bins().count(), pass.v - 0.5 * step), hi = lo;
            std::fill(hi.begin(), hi.end(), pass.v + 0.5 * step);
            finish_pass(pass, lo, hi, here);
        }
        result_.stepover_min = result_.stepover_max = planes > 1 ? settings_.stepover.number : 0;
    }

    [[noreturn]] void refuse_planes(const char* key, const std::string& what) const {
        throw Error(ErrorCode::limit_exceeded, key,
                    what + " more than " + std::to_string(max_drive_planes) + " drive planes",
                    "choose a larger step-over or tolerance");
    }

    void finish_pass(const EstimatedPass& pass, const std::vector<double>& border_lo,
                     const std::vector<double>& border_hi, const Progress& progress) {
        if (pass.lines.empty()) return; // between two pieces of the surface
        const int drive = result_.drive_planes++;
        cutter_.add(place_pass(field_, stepover_.passes(), pass, border_lo, border_hi), drive, pass.v,
                    progress);
        field_.lines().forget(field_.lines().beyond(pass.v, field_.lines().hi())
                              - long(2.5 * field_.radius() / field_.lines().spacing()));
    }

    void take_over(CutPasses&& cut) {
        result_.passes = std::move(cut.passes);
        result_.cleanup = std::move(cut.uncut);
        result_.cleanup_points = result_.cleanup.size();
        result_.cusp_max = cut.cusp_max + field_.chord();
        result_.chord_tolerance = field_.chord();
        tilted_.lead_min = cut.lead_min;
        tilted_.lead_max = cut.lead_max;
        tilted_.stage_seconds[1] = cut.seconds.bottom;
        tilted_.stage_seconds[2] = cut.seconds.top;
        tilted_.stage_seconds[3] = cut.seconds.postures;
        tilted_.record = cutter_.record();
        result_.detail = tilted_;
    }

    void finish() {
        take_over(std::move(cutter_.done()));
        const std::size_t points = cutter_.record()->points.size();
        if (result_.passes.empty() && !is_piece_)
            throw Error(ErrorCode::empty_result, settings_.name,
                        points == 0
                            ? "no place of the part can be come to from above"
                            : "none of " + std::to_string(points) + " contact points has a free posture",
                        points == 0 ? "turn the part" : cutter_.unfree().main_cause(settings_.posture));
        if (is_piece_) return;
        // Where what has no posture breaks passes into pieces, cutting plane by plane would mean going up and
        // down between them.
        const PlanContext& context = field_.context();
        order_by_travel(result_.passes, false,
                        std::max(context.part_box.hi.z(), context.stock_box.hi.z()) + settings_.clearance,
                        progress_.part(1, 1));
        warn({settings_, text_, unsatisfied_, points, field_.cusp()}, cutter_.unfree(), cutter_.kept(),
             result_);
    }

    const Finish5Settings& settings_;
    PlanText text_;
    const Progress& progress_;
    bool is_piece_;
    FiveAxisField field_;
    TiltedStepOver stepover_;
    PartialPasses partial_;
    PassCutter cutter_;
    StrategyResult result_;
    TiltedPath tilted_;
    int unsatisfied_ = 0; ///< drive planes
};

/// What keeps the tool from most of a piece, and what helps.
std::string why_unreached(const UnreachedPiece& piece) {
    const auto most = std::max_element(piece.by_block.begin() + 1, piece.by_block.end());
    switch (ReachBlock(most - piece.by_block.begin())) {
    case ReachBlock::machine:
        return "the tool has room there, and the machine's axes do not take it in; turn the part or take "
               "another machine";
    case ReachBlock::holder:
        return "the cutter has room there, and the holder would hit the part by every axis; use a longer "
               "tool "
               "or a smaller holder";
    case ReachBlock::shank:
        return "the cutter has room there, and the shank would hit the part by every axis; use a longer or "
               "thinner tool";
    case ReachBlock::cutter:
        return "the part is in the cutter's way by every axis; use a smaller or longer tool, or turn the "
               "part";
    case ReachBlock::below:
    case ReachBlock::none:
        break;
    }
    return "it faces down; turn the part over and cut it in another setup";
}

/// Cuts a part side by side: the pieces of part_sides.h one after the other, and their paths as one.
class SidePlanner {
public:
    SidePlanner(const Finish5Settings& settings, const PlanContext& context, const PartSides& sides,
                const Progress& progress)
        : settings_(sides.top_only ? settings : side_settings(settings)), text_{context.unit},
          context_(context), sides_(sides), progress_(progress) {}

    StrategyResult run() {
        double area = 0, done = 0;
        for (const SidePiece& side : sides_.pieces)
            area += side.area;
        for (const SidePiece& side : sides_.pieces) {
            cut(side, progress_.part(done / area, (done + side.area) / area));
            done += side.area;
        }
        if (pieces_.empty())
            throw Error(ErrorCode::empty_result, settings_.name,
                        told_.points == 0 ? "no place of the part can be come to"
                                          : "none of " + std::to_string(told_.points)
                                                + " contact points has a free posture",
                        told_.points == 0 ? "turn the part" : unfree_.main_cause(settings_.posture));
        if (result_.stepover_max == 0) result_.stepover_min = 0;
        order_pieces();
        if (record_) tilted_.record = record_;
        result_.detail = tilted_;
        warn(told_, unfree_, *kept_, result_);
        if (settings_.passes == Finish5Settings::Passes::around
            && std::none_of(sides_.pieces.begin(), sides_.pieces.end(), [](const SidePiece& side) {
                   return side.passes == Finish5Settings::Passes::around;
               }))
            result_.warnings.push_back("nothing of the part goes round: its passes run from edge to edge");
        tell_unreached();
        return std::move(result_);
    }

private:
    double clear_z() const {
        return std::max(context_.part_box.hi.z(), context_.stock_box.hi.z()) + settings_.clearance;
    }

    void cut(const SidePiece& side, const Progress& progress) {
        PlanContext context = context_;
        context.part = side.piece.mesh;
        context.geometry = side.piece.geometry;
        context.curvatures = side.piece.curvatures;
        Finish5Settings own = settings_;
        own.lead_limits = side.lead_limits;
        own.passes = side.passes;
        // Rings go about facets that face any way, as they are wound; from above those count that face up.
        if (side.passes == Finish5Settings::Passes::around && !sides_.top_only) context.is_piece = true;
        Planner5 planner(own, context, progress, true, 0, side.view);
        StrategyResult one = planner.run();
        order_by_travel(one.passes, false, clear_z(), progress.part(1, 1));
        const PassCutter& cutter = planner.cutter();
        told_.points += cutter.record()->points.size();
        told_.unsatisfied += planner.unsatisfied();
        unfree_.add(cutter.unfree());
        if (kept_)
            kept_->add(cutter.kept());
        else
            kept_.emplace(cutter.kept());
        if (record_)
            record_->append(*cutter.record(), result_.drive_planes);
        else
            record_ = cutter.record();
        add(std::move(one));
    }

    void add(StrategyResult&& one) {
        if (pieces_.empty()) result_.direction = one.direction;
        for (Pass& pass : one.passes)
            pass.drive += result_.drive_planes;
        if (!one.passes.empty()) pieces_.push_back(std::move(one.passes));
        result_.drive_planes += one.drive_planes;
        if (one.stepover_max > 0) {
            result_.stepover_min = result_.stepover_max > 0 ? std::min(result_.stepover_min, one.stepover_min)
                                                            : one.stepover_min;
            result_.stepover_max = std::max(result_.stepover_max, one.stepover_max);
        }
        result_.cusp_max = std::max(result_.cusp_max, one.cusp_max);
        result_.chord_tolerance = one.chord_tolerance;
        told_.cusp = cusp_budget(settings_, context_);
        result_.cleanup_points += one.cleanup_points;
        result_.cleanup.insert(result_.cleanup.end(), one.cleanup.begin(), one.cleanup.end());
        const auto& tilted = std::get<TiltedPath>(one.detail);
        tilted_.lead_min = std::min(tilted_.lead_min, tilted.lead_min);
        tilted_.lead_max = std::max(tilted_.lead_max, tilted.lead_max);
        for (std::size_t k = 0; k < tilted.stage_seconds.size(); ++k)
            tilted_.stage_seconds[k] += tilted.stage_seconds[k];
    }

    /// One piece is followed by the one that begins nearest.
    void order_pieces() {
        while (!pieces_.empty()) {
            auto next = pieces_.begin();
            if (!result_.passes.empty()) {
                const Vec3 at = result_.passes.back().cl.back().tip;
                const auto far = [&](const std::vector<Pass>& piece) {
                    return (piece.front().cl.front().tip - at).norm();
                };
                next = std::min_element(pieces_.begin(), pieces_.end(),
                                        [&](const auto& a, const auto& b) { return far(a) < far(b); });
            }
            std::move(next->begin(), next->end(), std::back_inserter(result_.passes));
            pieces_.erase(next);
        }
    }

    void tell_unreached() {
        constexpr std::size_t max_told = 5;
        const std::size_t count = sides_.unreached.size();
        for (std::size_t i = 0; i < std::min(count, max_told); ++i) {
            const UnreachedPiece& piece = sides_.unreached[i];
            result_.warnings.push_back("cannot be reached: " + area_text(piece.area, text_.unit)
                                       + " of the surface (" + share_text(piece.area, sides_.whole_area)
                                       + ") around " + text_(piece.place) + ": " + why_unreached(piece));
        }
        if (count > max_told)
            result_.warnings.push_back(
                "cannot be reached: " + std::to_string(count - max_told) + " smaller places; "
                + share_text(sides_.unreached_area, sides_.whole_area) + " of the surface in all");
    }

    Finish5Settings settings_;
    PlanText text_;
    const PlanContext& context_;
    const PartSides& sides_;
    const Progress& progress_;
    StrategyResult result_;
    TiltedPath tilted_;
    std::vector<std::vector<Pass>> pieces_;
    UnfreePoints unfree_;
    std::optional<KeptPostures> kept_;
    std::shared_ptr<FiveAxisRecord> record_;
    Told told_{settings_, text_};
};

} // namespace

const ParameterTable<Finish5Settings>& finish5_parameters() {
    static const auto table = [] {
        ParameterTable<Finish5Settings> t;
        add_common_parameters(t);
        t.set_stage("feed", Stage::strategy); // postures are chosen by time
        add_five_axis_parameters(t);
        t.add_choice(&Finish5Settings::sides,
                     {.key = "sides",
                      .label = "Sides",
                      .help = "auto: where parts of the surface that an axis reaches do not face up (walls, "
                              "undersides, both faces of a blade), the part is cut side by side, each "
                              "connected piece seen from its own side, with the yaw free and a posture grid "
                              "twice as coarse; what no axis reaches is said. top: everything is cut as it "
                              "is seen from above.",
                      .words = {"auto", "top"}});
        t.add_choice(
            &Finish5Settings::passes,
            {.key = "passes",
             .label = "Passes",
             .help =
                 "parallel: in drive planes along the direction. morph: each piece of the surface by itself, "
                 "in passes that go over from its one edge along the direction to the other, as the surface "
                 "flows: blades and shrouds. around: in closed rings about each piece that goes round "
                 "(blades, hubs, bottles), from its one border to the other or to its end; other pieces as "
                 "with morph. A fixed step-over is kept where passes are farthest apart.",
             .words = {"parallel", "morph", "around"}});
        t.add(&Finish5Settings::reach_lead,
              {.key = "reach_lead",
               .label = "Lead to reach",
               .help =
                   "Largest inclination on a part that is cut side by side, for pieces with places that no "
                   "inclination within the lead limits reaches: undersides, faces of blades behind others. "
                   "No larger than the upper lead limit: these are left, and said.",
               .kind = ParameterKind::number,
               .quantity = Quantity::angle,
               .minimum = 0,
               .maximum = radians(89)});
        t.add_records(&Finish5Settings::manual_postures, manual_posture_list,
                      {.label = "Kept postures",
                       .help = "Postures chosen by hand for single contact points, in the configuration "
                               "space of the point; used wherever they are free.",
                       .nouns = {"kept posture", "kept postures"}});
        return t;
    }();
    return table;
}

StrategyResult finish_piece(const Finish5Settings& settings, const PlanContext& context,
                            const Progress& progress, double leave) {
    return Planner5(settings, context, progress, true, leave).run();
}

StrategyResult Finish5::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    PartSides sides;
    if (settings_.sides == Finish5Settings::Sides::automatic) {
        sides = find_sides(context, settings_, progress.part(0, 0.05, "Looking for sides"));
        if (!sides.top_only) return SidePlanner(settings_, context, sides, progress.part(0.05, 1)).run();
    }
    const bool follows = settings_.passes != Finish5Settings::Passes::parallel;
    StrategyResult result =
        follows ? SidePlanner(settings_, context, find_tops(context, settings_, progress.part(0.05, 0.1)),
                              progress.part(0.1, 1))
                      .run()
                : Planner5(settings_, context, progress).run();
    if (sides.far_area > 0) {
        const PlanText text{context.unit};
        result.warnings.push_back(
            area_text(sides.far_area, text.unit) + " of the surface ("
            + share_text(sides.far_area, sides.whole_area) + ") around " + text(sides.far_place)
            + " turns under so far that only leads above the lead limits reach it, and is not cut: turn the "
              "part over and cut it in another setup, or raise the upper lead limit for the whole part");
    }
    return result;
}

} // namespace facetmill
