#include "core/strategy/five_axis/finish5.h"

#include "core/base/tolerances.h"
#include "core/cspace/choose.h"
#include "core/strategy/five_axis/five_axis_parameters.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/five_axis/posture_study.h"
#include "core/strategy/five_axis/run_out.h"
#include "core/strategy/five_axis/tilted_stepover.h"
#include "core/strategy/plan/pass_order.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <span>

namespace facetmill {

namespace {

const OperationRegistration registration("finish5", "Finish, 5-axis",
                                         [] { return std::make_unique<Finish5>(); });

constexpr std::size_t max_drive_planes = 100000;
/// Contact points of a plan, roughly: a day's work.
constexpr double max_contacts = 2e7;
/// The step that the search starts with, in diameters.
constexpr double first_step_share = 0.4;
/// How far, in the cutter's radius, a pass goes on beyond the part's border at most.
constexpr double max_extension_share = 2;

class Planner5 {
public:
    Planner5(const Finish5Settings& settings, const PlanContext& context, const Progress& progress,
             bool is_piece = false, double leave = 0)
        : settings_(settings), progress_(progress), is_piece_(is_piece),
          field_(context, settings, progress.part(0, 0.05)), stepover_(field_, leave),
          record_(std::make_shared<FiveAxisRecord>()), met_(settings.manual_postures.size(), false) {
        record_->context = field_.context();
        record_->settings = settings;
    }

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
        if (pending_) cut(*pending_, {}, progress_.part(1, 1));
        finish();
        return std::move(result_);
    }

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
        const Vec3 size = field_.context().part_box.size();
        const double step =
            settings_.stepover.is_number() ? settings_.stepover.number : 0.5 * field_.radius();
        if (size.x() * size.y() <= max_contacts * step * 0.4 * field_.radius()) return;
        throw Error(ErrorCode::limit_exceeded, settings_.name,
                    "a part of " + text(size.x()) + " by " + text(size.y()) + " asks for more than "
                        + format_number(max_contacts) + " contact points of this tool",
                    "check the part's units, or take a larger tool or step-over");
    }

    template <class Make>
    auto timed(Make&& make) {
        const auto start = Clock::now();
        auto made = make();
        result_.stage_seconds[0] += std::chrono::duration<double>(Clock::now() - start).count();
        return made;
    }

    void plan_adaptive() {
        const auto& lines = field_.lines();
        double usual = first_step_share * 2 * field_.radius();
        std::optional<EstimatedPass> last;
        std::vector<double> border_lo;
        result_.stepover_min = infinity;
        while (true) {
            const Progress here = at(last ? last->v : lines.lo());
            if (last && is_piece_) break;
            if (last && timed([&] { return stepover_.reaches_border(*last); })) break;
            if (result_.drive_planes >= int(max_drive_planes))
                refuse_planes("tolerance", "the tolerance asks for");
            // Nothing more to meet: the border is a line no plane cuts.
            if (last && lines.beyond(lines.hi(), lines.lo()) - last->plane <= 1) break;
            auto step = timed([&] {
                return stepover_.next(last ? &*last : nullptr, travel(result_.drive_planes + (last ? 1 : 0)),
                                      last ? usual : 0.5 * usual, here);
            });
            if (!step.satisfied) ++unsatisfied_;
            if (last) {
                const double width = step.pass.v - last->v;
                usual = width;
                result_.stepover_min = std::min(result_.stepover_min, width);
                result_.stepover_max = std::max(result_.stepover_max, width);
                const auto border = stepover_.borders(*last, step.pass);
                finish_pass(*last, border_lo, border, here);
                border_lo = border;
            }
            last = std::move(step.pass);
        }
        if (last && is_piece_)
            plan_with_partial(std::move(*last), usual);
        else if (last)
            finish_pass(*last, border_lo, {}, at(last->v));
        if (result_.stepover_max == 0) result_.stepover_min = 0;
    }

    /// A piece of a part has holes and tongues: passes all along it would be as close together as the
    /// narrowest of its strips asks for.
    void plan_with_partial(EstimatedPass last, double usual) {
        const auto& lines = field_.lines();
        const bool turns = settings_.pattern == Finish5Settings::Pattern::zigzag;
        std::vector<double> border_lo;
        while (true) {
            const Progress here = at(last.v);
            if (result_.drive_planes >= int(max_drive_planes))
                refuse_planes("tolerance", "the tolerance asks for");
            const bool at_end = lines.beyond(lines.hi(), lines.lo()) - last.plane <= 1;
            TiltedStepOver::Gap gap;
            if (!at_end && !timed([&] { return stepover_.reaches_border(last); }))
                gap = timed([&] { return stepover_.next_with_partial(last, turns, usual, here); });
            if (!gap.satisfied) ++unsatisfied_;
            if (gap.next) {
                usual = gap.next->v - last.v;
                result_.stepover_min = std::min(result_.stepover_min, usual);
                result_.stepover_max = std::max(result_.stepover_max, usual);
            }
            // Of all passes in this gap, in the order of their planes: where the strip of each ends, bin by
            // bin. Where a partial one is not wanted it has none.
            std::vector<const TiltedStepOver::PartialPass*> partial;
            for (const TiltedStepOver::PartialPass& p : gap.partial)
                partial.push_back(&p);
            std::stable_sort(partial.begin(), partial.end(),
                             [](const auto* a, const auto* b) { return a->pass.plane < b->pass.plane; });
            const std::size_t bins = stepover_.bin(infinity) + 1;
            std::vector<double> after(bins, lines.hi()), before(bins, lines.hi());
            std::vector<std::array<std::vector<double>, 2>> own;
            for (const auto* p : partial)
                own.push_back({std::vector<double>(bins, p->pass.v), std::vector<double>(bins, p->pass.v)});
            for (std::size_t i = 0; i < bins; ++i) {
                const EstimatedPass* from = &last;
                double* strip_end = &after[i];
                for (std::size_t k = 0; k < partial.size(); ++k) {
                    if (i < partial[k]->bins.first || i > partial[k]->bins.last) continue;
                    *strip_end = own[k][0][i] = stepover_.border(*from, partial[k]->pass, i);
                    from = &partial[k]->pass;
                    strip_end = &own[k][1][i];
                }
                *strip_end = before[i] = gap.next ? stepover_.border(*from, *gap.next, i) : lines.hi();
            }
            const bool is_last = !gap.next && partial.empty();
            finish_pass(last, border_lo, is_last ? std::vector<double>() : after, here);
            for (std::size_t k = 0; k < partial.size(); ++k)
                finish_pass(partial[k]->pass, own[k][0], own[k][1], here);
            if (!gap.next) break;
            border_lo = std::move(before);
            last = std::move(*gap.next);
        }
    }

    void plan_constant(double step) {
        const auto& lines = field_.lines();
        const double planes =
            std::max(1.0, std::ceil((lines.hi() - lines.lo()) / step - tolerance::level_angle));
        if (planes > double(max_drive_planes))
            refuse_planes("stepover", "a step-over of " + text(step) + " makes");
        const double first = 0.5 * (lines.lo() + lines.hi()) - 0.5 * (planes - 1) * step;
        for (std::size_t i = 0; i < std::size_t(planes); ++i) {
            const double v = first + double(i) * step;
            const Progress here = at(v);
            const long plane = std::lround((v - lines.lo()) / lines.spacing());
            const EstimatedPass pass = timed([&] { return stepover_.estimate(plane, travel(int(i)), here); });
            std::vector<double> lo(stepover_.bin(infinity) + 1, pass.v - 0.5 * step), hi = lo;
            std::fill(hi.begin(), hi.end(), pass.v + 0.5 * step);
            finish_pass(pass, lo, hi, here);
        }
        result_.stepover_min = result_.stepover_max = planes > 1 ? step : 0;
    }

    [[noreturn]] void refuse_planes(const char* key, const std::string& what) const {
        throw Error(ErrorCode::limit_exceeded, key,
                    what + " more than " + std::to_string(max_drive_planes) + " drive planes",
                    "choose a larger step-over or tolerance");
    }

    /// How much farther than its own end the strip of a line reaches, along u; plus, where the pass ends,
    /// what the tool lags behind at the strip's borders. Where it begins that lies outside.
    double extension(const EstimatedPass& pass, const SurfaceLine& line, bool first, double v_lo,
                     double v_hi) const {
        const auto& lines = field_.lines();
        const SlicePoint& end = first ? line.points.front() : line.points.back();
        const double r = field_.radius();
        double farther = 0;
        const long step = std::max(1L, std::lround(r / 16 / lines.spacing()));
        for (long k = lines.beyond(v_lo, v_hi) / step * step; lines.v(k) <= v_hi; k += step)
            for (const SurfaceSlice::End& other : lines.slice(k)->ends())
                if (other.first == first && (other.point - end.point).norm() <= 2 * r)
                    farther = std::max(farther, first ? end.u - other.u : other.u - end.u);
        const bool begins = first == (pass.travel > 0);
        const double aside = begins ? 0 : std::min(std::max(pass.v - v_lo, v_hi - pass.v), r);
        const double lag = r - std::sqrt(r * r - aside * aside);
        return std::min(farther + lag, max_extension_share * r);
    }

    void finish_pass(const EstimatedPass& pass, const std::vector<double>& border_lo,
                     const std::vector<double>& border_hi, const Progress& progress) {
        if (pass.lines.empty()) return; // between two pieces of the surface
        const int drive = result_.drive_planes++;
        const double part_lo = field_.lines().lo(), part_hi = field_.lines().hi();
        std::vector<std::size_t> order(pass.lines.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = pass.travel > 0 ? i : order.size() - 1 - i;
        std::vector<PlacedLine> lines;
        for (const std::size_t l : order) {
            lines.push_back(place_line(pass, l, [&](double u) {
                // Where the tool reaches the strip's borders, beside and behind the contact, each pass takes
                // the farthest, which its widths allow (TiltedStepOver).
                std::array<double, 2> strip{part_lo, part_hi};
                const auto [from, to] = stepover_.cleared(u, pass.travel);
                const std::size_t first = stepover_.bin(from), last = stepover_.bin(to);
                if (!border_lo.empty())
                    strip[0] = *std::min_element(border_lo.begin() + long(first),
                                                 border_lo.begin() + long(last) + 1);
                if (!border_hi.empty())
                    strip[1] = *std::max_element(border_hi.begin() + long(first),
                                                 border_hi.begin() + long(last) + 1);
                return strip;
            }));
        }
        hand_over_kept(lines);
        for (PlacedLine& placed : lines) {
            auto coming = std::make_unique<Pending>();
            coming->drive = drive;
            coming->v = pass.v;
            coming->study = study(placed, progress);
            coming->placed = std::move(placed);
            if (pending_) cut(*pending_, coming->study.points, progress);
            pending_ = std::move(coming);
        }
        field_.lines().forget(field_.lines().beyond(pass.v, part_hi)
                              - long(2.5 * field_.radius() / field_.lines().spacing()));
    }

    template <class Strip>
    PlacedLine place_line(const EstimatedPass& pass, std::size_t l, Strip&& strip) const {
        const SurfaceLine& line = pass.lines[l];
        PlacedLine placed;
        placed.line = line;
        placed.travel = pass.travel;
        placed.cut_short = pass.cut_short[l];
        if (pass.travel < 0) std::swap(placed.cut_short[0], placed.cut_short[1]);
        const auto add = [&](double s) {
            ContactPlace p = field_.place(line, s, pass.v, pass.travel);
            const auto [lo, hi] = strip(p.u);
            p.v_lo = std::min(lo, pass.v);
            p.v_hi = std::max(hi, pass.v);
            placed.places.push_back(p);
        };
        const auto beyond = [&](bool first) {
            if (pass.cut_short[l][first ? 0 : 1]) return 0.0;
            const auto [lo, hi] = strip(first ? line.points.front().u : line.points.back().u);
            return extension(pass, line, first, std::min(lo, pass.v), std::max(hi, pass.v));
        };
        const double front = beyond(true), back = beyond(false);
        const double longest = 0.2 * field_.radius();
        const auto pieces = [&](double length) { return std::size_t(std::ceil(length / longest)); };
        for (std::size_t k = pieces(front); k > 0; --k)
            add(-front * double(k) / double(pieces(front)));
        for (const auto& c : pass.contacts[l]) {
            add(c.place.s);
            if (!c.left) continue;
            // As much as it can do in passing.
            ContactPlace& p = placed.places.back();
            p.v_lo = std::max(p.v_lo, pass.v - c.width_lo);
            p.v_hi = std::min(p.v_hi, pass.v + c.width_hi);
        }
        for (std::size_t k = 1; k <= pieces(back); ++k)
            add(line.length() + back * double(k) / double(pieces(back)));
        if (pass.travel < 0) std::reverse(placed.places.begin(), placed.places.end());
        return placed;
    }

    /// Postures kept by hand, to the contact points of this pass that they are for.
    void hand_over_kept(std::vector<PlacedLine>& lines) {
        for (std::size_t k = 0; k < settings_.manual_postures.size(); ++k) {
            const ManualPosture& kept = settings_.manual_postures[k];
            const Vec3 point(kept.point[0], kept.point[1], kept.point[2]);
            const double v = field_.drive().v(point);
            if (met_[k]) continue;
            ContactPlace* nearest = nullptr;
            double least = field_.radius(); // what is farther away is another place
            for (PlacedLine& line : lines)
                for (ContactPlace& place : line.places) {
                    if (v < place.v_lo - field_.chord() || v > place.v_hi + field_.chord()) continue;
                    const double away = (place.surface - point).norm();
                    if (away >= least) continue;
                    least = away;
                    nearest = &place;
                }
            if (!nearest) continue;
            met_[k] = true;
            if (nearest->kept)
                kept_warnings_.push_back("the posture kept for " + place_text(point)
                                         + " is not used: another one is kept for the same contact point");
            else
                nearest->kept = {kept.lead, kept.yaw};
        }
    }

    std::string place_text(const Vec3& point) const {
        return "the point " + text(point.x()) + ", " + text(point.y()) + ", " + text(point.z());
    }

    /// Says which postures that were kept by hand are not free.
    void check_kept(const PlacedLine& line, const PostureStudy& study) {
        for (std::size_t i = 0; i < line.places.size(); ++i) {
            const ContactPlace& place = line.places[i];
            if (!place.kept || study.points[i].kept) continue;
            const auto [lead, yaw] = *place.kept;
            const PostureBlock block = field_.builder().reason(place.frame, lead, yaw, study.curves[i]).block;
            std::string why;
            switch (block) {
            case PostureBlock::local:
            case PostureBlock::global:
                why = "the cutter would cut into the part";
                break;
            case PostureBlock::shank:
                why = "the shank would hit the part";
                break;
            case PostureBlock::holder:
                why = "the holder would hit the part";
                break;
            case PostureBlock::lift:
                why = "it leaves more than the tolerance";
                break;
            case PostureBlock::machine:
                why = "the machine's axes do not reach, or the tool would lie down";
                break;
            case PostureBlock::free:
                break;
            }
            kept_warnings_.push_back("the posture kept for " + place_text(place.surface)
                                     + " is not free and not used: " + why);
        }
    }

    /// A line whose postures are chosen when the one after it is known.
    struct Pending {
        PlacedLine placed;
        PostureStudy study;
        int drive = 0;
        double v = 0;
    };

    PostureStudy study(const PlacedLine& line, const Progress& progress) {
        const auto start = Clock::now();
        PostureStudy made = study_postures(field_, line.places, progress);
        const double spent = std::chrono::duration<double>(Clock::now() - start).count();
        const double cpu = std::max(made.stages.bottom + made.stages.top, 1e-12);
        result_.stage_seconds[1] += spent * made.stages.bottom / cpu;
        result_.stage_seconds[2] += spent * made.stages.top / cpu;
        check_kept(line, made);
        return made;
    }

    /// Chooses the postures of a line and makes its passes. `next`: points of the line that comes after.
    void cut(Pending& line, std::span<const PassPoint> next, const Progress& progress) {
        const auto start = Clock::now();
        PlacedLine& placed = line.placed;
        placed.choices = choose_postures(field_, line.study, settings_.posture, last_pose(), next, progress);
        FiveAxisRecord::Line recorded{record_->points.size(), 0, line.drive};
        for (std::size_t i = 0; i < placed.places.size(); ++i) {
            record_->points.push_back({placed.places[i], line.study.points[i].cm2_lead, placed.choices[i]});
            if (placed.choices[i].free) continue;
            ++unfree_;
            ++blocked_[std::size_t(decisive_block(line.study.spaces[i]))];
        }
        recorded.end = record_->points.size();
        record_->lines.push_back(recorded);
        add_run_outs(placed);
        JoinedPasses joined = join_postures(field_, placed, progress);
        for (Pass& p : joined.passes) {
            p.drive = line.drive;
            p.offset = line.v;
            result_.passes.push_back(std::move(p));
        }
        result_.cleanup.insert(result_.cleanup.end(), joined.uncut.begin(), joined.uncut.end());
        result_.cusp_max = std::max(result_.cusp_max, joined.cusp);
        result_.lead_min = std::min(result_.lead_min, joined.lead_min);
        result_.lead_max = std::max(result_.lead_max, joined.lead_max);
        result_.stage_seconds[3] += std::chrono::duration<double>(Clock::now() - start).count();
    }

    void add_run_outs(PlacedLine& line) const {
        const ChosenPosture &first = line.choices.front(), &last = line.choices.back();
        if (first.free && !line.cut_short[0])
            line.before = run_out(field_, line.line, line.places.front(), first.posture, line.travel, false);
        if (last.free && !line.cut_short[1])
            line.after = run_out(field_, line.line, line.places.back(), last.posture, line.travel, true);
    }

    std::optional<ToolPose> last_pose() const {
        if (result_.passes.empty()) return std::nullopt;
        const CutterLocation& end = result_.passes.back().cl.back();
        return ToolPose{end.tip, end.axis};
    }

    /// What keeps the postures of a point that come nearest to being free: free but for the machine, then
    /// low enough but for what the tool hits. Nearly every point has postures that leave too much.
    static PostureBlock decisive_block(const CSpace& space) {
        std::array<std::size_t, 8> count{};
        for (const PostureBlock b : space.block)
            ++count[std::size_t(b)];
        const auto any = [&](PostureBlock b) { return count[std::size_t(b)] > 0; };
        if (any(PostureBlock::free)) return PostureBlock::free;
        if (any(PostureBlock::machine)) return PostureBlock::machine;
        PostureBlock most = PostureBlock::lift;
        std::size_t best = 0;
        for (const PostureBlock b :
             {PostureBlock::local, PostureBlock::global, PostureBlock::shank, PostureBlock::holder})
            if (count[std::size_t(b)] > best) {
                best = count[std::size_t(b)];
                most = b;
            }
        return most;
    }

    /// What is decisive at most of the points that have no posture.
    std::string main_cause() const {
        const auto worst = std::max_element(blocked_.begin(), blocked_.end()) - blocked_.begin();
        switch (PostureBlock(worst)) {
        case PostureBlock::free:
            return settings_.posture == Finish5Settings::PostureChoice::global
                       ? "the free postures are too far from those of the neighbours: allow a larger turn "
                         "limit"
                       : "other postures would be free than this way of choosing tries: choose them by "
                         "global";
        case PostureBlock::local:
            return "the part close to the contact point stands in the cutter's way: use a smaller tool there";
        case PostureBlock::global:
            return "the part elsewhere stands in the cutter's way: use a smaller or longer tool there, or "
                   "wider limits";
        case PostureBlock::shank:
            return "the shank would hit the part: use a longer or thinner tool";
        case PostureBlock::holder:
            return "the holder would hit the part: use a longer tool or a smaller holder";
        case PostureBlock::machine:
            return "the machine's axes do not reach: turn the part or take another machine";
        default:
            return "the cutter leaves more than the tolerance: use a smaller step-over or tool";
        }
    }

    void finish() {
        result_.cleanup_points = result_.cleanup.size();
        result_.five_axis = record_;
        if (result_.passes.empty() && !is_piece_)
            throw Error(ErrorCode::empty_result, settings_.name,
                        record_->points.empty() ? "no place of the part can be come to from above"
                                                : "none of " + std::to_string(record_->points.size())
                                                      + " contact points has a free posture",
                        record_->points.empty() ? "turn the part" : main_cause());
        result_.cusp_max += field_.chord();
        result_.chord_tolerance = field_.chord();
        if (is_piece_) return;
        // Where what has no posture breaks passes into pieces, one after the other of every plane would mean
        // going up and down between them.
        const PlanContext& context = field_.context();
        order_by_travel(result_.passes, false,
                        std::max(context.part_box.hi.z(), context.stock_box.hi.z()) + settings_.clearance,
                        progress_.part(1, 1));
        if (unsatisfied_ > 0)
            result_.warnings.push_back(std::to_string(unsatisfied_) + " of "
                                       + std::to_string(result_.drive_planes)
                                       + " drive planes cross places where no step-over meets the tolerance");
        if (unfree_ > 0)
            result_.warnings.push_back(
                std::to_string(unfree_) + " of " + std::to_string(record_->points.size())
                + " contact points have no free posture and are left to clean-up; mostly " + main_cause());
        if (result_.cleanup_points > unfree_)
            result_.warnings.push_back(
                std::to_string(result_.cleanup_points - unfree_)
                + " places are left to clean-up because the tool cannot come there from "
                  "its neighbours without gouging or turning too far");
        for (std::string& warning : kept_warnings_)
            result_.warnings.push_back(std::move(warning));
        for (std::size_t k = 0; k < met_.size(); ++k)
            if (const auto& p = settings_.manual_postures[k].point; !met_[k])
                result_.warnings.push_back("the posture kept for " + place_text({p[0], p[1], p[2]})
                                           + " is not used: no pass comes there");
        if (settings_.stepover.is_number() && result_.cusp_max > field_.cusp())
            result_.warnings.push_back("the step-over of " + text(settings_.stepover.number)
                                       + " leaves cusps of " + text(result_.cusp_max)
                                       + "; the tolerance allows " + text(field_.cusp()));
    }

    std::string text(double mm) const { return length_text(mm, field_.context().unit); }

    const Finish5Settings& settings_;
    const Progress& progress_;
    bool is_piece_;
    FiveAxisField field_;
    TiltedStepOver stepover_;
    std::shared_ptr<FiveAxisRecord> record_;
    std::unique_ptr<Pending> pending_;
    StrategyResult result_;
    std::array<std::size_t, 8> blocked_{};
    std::size_t unfree_ = 0; ///< contact points
    std::vector<bool> met_;  ///< the manual postures that belong to a contact point
    std::vector<std::string> kept_warnings_;
    int unsatisfied_ = 0;
};

} // namespace

const ParameterTable<Finish5Settings>& finish5_parameters() {
    static const auto table = [] {
        ParameterTable<Finish5Settings> t;
        add_common_parameters(t);
        t.set_stage("feed", Stage::strategy); // postures are chosen by time
        add_five_axis_parameters(t);
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
    return Planner5(settings_, context, progress).run();
}

} // namespace facetmill
