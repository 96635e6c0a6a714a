#include "core/base/tolerances.h"
#include "core/link/entry_places.h"
#include "core/link/envelope.h"
#include "core/link/joint_run.h"
#include "core/link/link.h"
#include "core/setup/kinematics.h"
#include "core/strategy/five_axis/even_motion.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/surface/stock_before.h"
#include "core/strategy/tilt/tilted_stock.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace facetmill {

namespace {

/// How often a link on the surface is halved before it is given up for a clearance move: pieces are 1/512 of
/// it then, and what is not clear of the part at that fineness will not become so.
constexpr int max_divisions = 9;
/// The halvings in all, those included of pieces that are too long, or turn too far, to be looked at whole.
constexpr int max_depth = 16;
/// How far a link on the surface is lifted at most, in diameters of the cutter: higher up a clearance move is
/// as short.
constexpr double max_lift_share = 1.5;
/// By how much the axis may turn between places that are no neighbours. Beyond it the tool goes up: rotary
/// axes take their time, and near their pole they swing.
const double max_turn = radians(45);
/// By how much the axis may turn in one motion of such a link, so that what the machine does between two
/// locations is near to what was looked at.
const double turn_at_once = radians(5);
/// The length of a piece of a link, in steps at which it is looked at. A longer one is halved first: no check
/// looks at more places than that.
constexpr double longest_steps = 200;
/// The share of the chord tolerance by which the routes of different machines may differ in one motion.
constexpr double even_link_share = 0.25;
/// How far a tool comes off before it turns over, in the distance by which it has to be clear then.
constexpr double off_share = 2;
/// The cells of the stock that rapids keep out of, in radii of the cutter, and what the sides of the tool
/// keep from it there, in the clearance: walls stand beside every pass, and a clearance from them leaves no
/// room.
constexpr double stock_cell_share = 0.25;
constexpr double side_gap_share = 0.1;
/// How near to what stands rapids come along the tool's axis, in radii of the cutter, where the clearance is
/// more: what lies between is feed in the air. As upright tools do.
constexpr double near_stock_share = 0.5;
/// Along its own axis the tool goes in where it goes no farther at feed than so many times that.
constexpr double short_entry = 2;

/// Finds a route between two locations that keeps clear of the part to within the chord tolerance, lifted
/// along the tool axis where it has to be.
class SurfaceLink {
public:
    SurfaceLink(const ToolLift& lift, const EvenMotion& motion, double chord, const Progress& progress)
        : lift_(lift), motion_(motion), step_(looking_step(lift.cutter().max_radius(), chord)), chord_(chord),
          progress_(progress) {}

    struct Limits {
        double lift = 0;  ///< of a place between, at most
        double turn = pi; ///< of the axis in one motion
    };
    /// Appends the places between a and b; false where there is no such route.
    bool between(const CutterLocation& a, const CutterLocation& b, const Limits& limits,
                 std::vector<CutterLocation>& route) {
        return between(a, b, limits, 0, 0, route);
    }

private:
    bool between(const CutterLocation& a, const CutterLocation& b, const Limits& limits, int divisions,
                 int depth, std::vector<CutterLocation>& route) {
        progress_.check();
        // Steps show only so much; and machines move their joints evenly, not the axis in one plane.
        const bool far = (b.tip - a.tip).norm() > longest_steps * step_
                         || a.axis.dot(b.axis) < std::cos(limits.turn) || !motion_.even(a, b);
        if (!far && keeps_clear_between(lift_, a, b, step_, chord_, hint_)) return true;
        if ((!far && divisions == max_divisions) || depth == max_depth) return false;
        CutterLocation middle = location_on_route(a, b, 0.5);
        const double lift = lift_.lift({middle.tip, middle.axis}, hint_);
        if (lift > limits.lift) return false;
        if (lift > 0) middle.tip += lift * middle.axis;
        const int deeper = divisions + (far ? 0 : 1);
        std::vector<CutterLocation> second;
        if (!between(a, middle, limits, deeper, depth + 1, route)
            || !between(middle, b, limits, deeper, depth + 1, second))
            return false;
        route.push_back(middle);
        route.insert(route.end(), second.begin(), second.end());
        return true;
    }

    const ToolLift& lift_;
    const EvenMotion& motion_;
    double step_, chord_;
    const Progress& progress_;
    ToolLift::Hint hint_;
};

/// Joins the passes of one path one after the other.
class FiveAxisLinker {
public:
    FiveAxisLinker(const StrategyResult& path, const PlanContext& context, const ToolClearance& clearance,
                   const LinkOptions& options, const Progress& progress)
        : options_(options), progress_(progress), lift_(context.contact, context.tool, clearance),
          kinematics_(context.machine, gauge_length(context.tool),
                      default_part_origin(context.machine, context.part_box)),
          radius_(lift_.cutter().max_radius()), clearance_(options.clearance + clearance.cutter),
          near_(std::min(clearance_, near_stock_share * radius_)),
          chord_(options.motion_share * options.chord_tolerance), max_lift_(max_lift_share * 2 * radius_),
          apart_(looking_step(radius_, chord_)),
          motion_(kinematics_, radius_, even_link_share * options.chord_tolerance),
          on_surface_(lift_, motion_, chord_, progress),
          clear_lift_(context.contact, context.tool,
                      {clearance.cutter + apart_, clearance.shank + apart_, clearance.holder + apart_}),
          over_surface_(clear_lift_, motion_, chord_, progress), envelope_(kept_clear_of(path, context)),
          stock_(stock_before(context, stock_cell_share * radius_, progress.part(0, 0.1)), context.tool,
                 radius_, side_gap_share * clearance_),
          places_(stock_, context.tool, radius_, near_) {}

    ToolMotions link(const StrategyResult& path) {
        result_.clearance_z = envelope_.level();
        const Pass* before = nullptr;
        for (std::size_t i = 0; i < path.passes.size(); ++i) {
            progress_.part(0.1, 1).set(double(i) / double(path.passes.size()));
            const Pass& pass = path.passes[i];
            if (pass.cl.empty()) continue;
            go_to(pass, Index(i), before);
            has_cut(pass.cl.front(), pass.cl.front());
            for (std::size_t k = 1; k < pass.cl.size(); ++k)
                cut(pass, Index(i), k);
            before = &pass;
        }
        if (before) {
            const Reach reach = out_of(before->cl.back());
            come_out(reach, envelope_.out(reach.fast));
        }
        progress_.set(1);
        return std::move(result_);
    }

private:
    using Route = std::vector<CutterLocation>;

    EnvelopeInput kept_clear_of(const StrategyResult& path, const PlanContext& context) const {
        EnvelopeInput in;
        in.part = context.kept_off_box();
        in.stock = context.stock_box;
        in.tool = &context.tool;
        in.cutter_radius = radius_;
        in.clearance = clearance_;
        in.reachable = [this](const CutterLocation& at) { return reaches(at); };
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl) {
                in.highest_tip = std::max(in.highest_tip, c.tip.z());
                in.lowest_axis_z = std::min(in.lowest_axis_z, c.axis.z());
                if (!(c.axis.z() >= tolerance::lowest_axis_z * (1 - tolerance::level_angle)))
                    throw Error(ErrorCode::internal, "link", "a tool axis lies down", "report this");
            }
        return in;
    }

    /// How the tool gets from where it may move fast to a location of a pass, or back.
    struct Reach {
        CutterLocation fast;
        Route between;     ///< from there to the location
        double length = 0; ///< at feed
    };

    /// Along the location's own axis, of which `slow` is at feed, or from a place near it that has been cut,
    /// where that is shorter.
    Reach reach(const CutterLocation& at, double slow) {
        Reach best = along_axis(at, slow);
        if (slow <= short_entry * near_) return best;
        const bool reached = reaches(at);
        const auto serves = [&](const CutterLocation& place) {
            Reach found{place, {}, 0};
            if ((reached && !(reaches(place) && reaches(envelope_.out(place))))
                || !over_part(place, off(at), 0.5 * slow, found.between))
                return false;
            found.between.push_back(off(at));
            found.length = length_of(place, found.between, at);
            if (!(found.length < slow)) return false;
            best = std::move(found);
            return true;
        };
        places_.find(at, slow, serves, progress_);
        return best;
    }
    bool reaches(const CutterLocation& at) const { return kinematics_.reaches({at.tip, at.axis}); }
    /// Clear of the part by more where there is room.
    bool over_part(const CutterLocation& from, const CutterLocation& to, double max_lift, Route& route) {
        const SurfaceLink::Limits limits{max_lift, turn_at_once};
        if (over_surface_.between(from, to, limits, route)) return true;
        route.clear();
        return on_surface_.between(from, to, limits, route);
    }
    /// In to a location, through the stock where some stands on the axis, and on from there over `ahead`.
    Reach in_to(const CutterLocation& at, std::span<const CutterLocation> ahead = {}) {
        const double slow = std::max(near_, stock_.lift(at, near_));
        Reach in = reach(at, slow);
        if (in.between.empty()) return in;
        JointRun run(kinematics_, motion_), own = run;
        run.begin(in.fast);
        own.begin(at);
        in.between.push_back(at);
        const bool serves =
            std::ranges::all_of(in.between, [&](const CutterLocation& c) { return run.go(c); });
        in.between.pop_back();
        return serves && run.reach(ahead) == own.reach(ahead) ? in : along_axis(at, slow);
    }
    /// Out from where it has cut, and where the run of motions has come to.
    Reach out_of(const CutterLocation& at) {
        const double slow = stock_.free_behind(at) ? near_ : std::max(near_, stock_.lift(at, near_));
        Reach out = reach(at, slow);
        Route route(out.between.rbegin(), out.between.rend());
        route.push_back(out.fast);
        return run_.follows(route) ? out : along_axis(at, slow);
    }
    static Reach along_axis(const CutterLocation& at, double slow) {
        return {{at.tip + slow * at.axis, at.axis}, {}, slow};
    }

    static double length_of(const CutterLocation& from, const Route& route, const CutterLocation& to) {
        double length = 0;
        const CutterLocation* at = &from;
        for (const CutterLocation& c : route) {
            length += (c.tip - at->tip).norm();
            at = &c;
        }
        return length + (to.tip - at->tip).norm();
    }

    /// From a pass's end to the envelope.
    void come_out(const Reach& reach, const CutterLocation& out) {
        for (auto c = reach.between.rbegin(); c != reach.between.rend(); ++c)
            between_passes(MotionKind::retract, *c);
        // Along the axis, which is the same at both.
        const bool fast = (reach.fast.tip - out.tip).dot(out.axis) < 0;
        between_passes(MotionKind::retract, fast ? reach.fast : out);
        if (fast) between_passes(MotionKind::rapid, out);
    }
    /// From the envelope to a pass.
    void go_in(const Reach& reach, const CutterLocation& out, const CutterLocation& start, Index pass_index) {
        if ((reach.fast.tip - out.tip).dot(out.axis) < 0) between_passes(MotionKind::rapid, reach.fast);
        for (const CutterLocation& c : reach.between)
            between_passes(MotionKind::approach, c);
        add({MotionKind::approach, start, pass_index, 0});
    }

    /// To place k of a pass from the one before it. Where a joint comes to its end on the way the tool goes
    /// out there, and comes back to the same place with the joint wound back.
    void cut(const Pass& pass, Index pass_index, std::size_t k) {
        const CutterLocation &from = pass.cl[k - 1], &to = pass.cl[k];
        const std::span<const CutterLocation> ahead(pass.cl.begin() + std::ptrdiff_t(k), pass.cl.end());
        if (JointRun(run_).go(to)) {
            add({MotionKind::cut, to, pass_index, Index(k)});
        } else if (JointRun other = run_; (other.begin(from), other.go(to))) {
            come_back(from, from, ahead);
            add({MotionKind::cut, to, pass_index, Index(k)});
        } else {
            // As far as it goes, and on from the next number.
            const double share = run_.share_to(to);
            const CutterLocation last = location_on_route(from, to, share),
                                 next = location_on_route(from, to, share + tolerance::figure_rounding);
            if (share > 0) between_passes(MotionKind::cut, last);
            other = run_;
            if (!other.go(to)) {
                other.begin(next);
                if (other.go(to)) come_back(last, next, ahead);
            }
            add({MotionKind::cut, to, pass_index, Index(k)});
        }
        has_cut(from, to);
    }
    void has_cut(const CutterLocation& from, const CutterLocation& to) {
        stock_.cut(from, to);
        places_.add(to);
    }
    void come_back(const CutterLocation& last, const CutterLocation& next,
                   std::span<const CutterLocation> ahead) {
        const Reach out = out_of(last), in = in_to(next, ahead);
        go_in(in, go_round(out, in), next, no_index);
    }
    /// In rapids from where the tool comes out to where it goes in; never in none, so that joints that have
    /// come to their end are wound back out there.
    CutterLocation go_round(const Reach& out, const Reach& in) {
        Route round = envelope_.route(out.fast, in.fast);
        if (round.size() == 1) {
            const CutterLocation farther{round[0].tip + clearance_ * round[0].axis, round[0].axis};
            round.push_back(farther);
            round.push_back(round[0]);
        }
        come_out(out, round.front());
        for (std::size_t k = 1; k < round.size(); ++k)
            between_passes(MotionKind::rapid, round[k]);
        return round.back();
    }

    /// The place beside a pass's end where the tool may turn over.
    CutterLocation off(const CutterLocation& c) const {
        return {c.tip + off_share * apart_ * c.axis, c.axis};
    }

    void between_passes(MotionKind kind, const CutterLocation& to) { add({kind, to, no_index, no_index}); }
    void add(const Motion& motion) {
        // Where no motion of a run can help it, another begins.
        if (motion.kind == MotionKind::rapid || !run_.go(motion.to)) run_.begin(motion.to);
        result_.motions.push_back(motion);
    }

    /// To the start of a pass, from the end of the pass before, if there is one.
    void go_to(const Pass& pass, Index pass_index, const Pass* before) {
        const CutterLocation& start = pass.cl.front();
        const std::span<const CutterLocation> ahead(pass.cl.begin() + 1, pass.cl.end());
        if (!before) {
            const Reach in = in_to(start, ahead);
            const CutterLocation out = envelope_.out(in.fast);
            between_passes(MotionKind::rapid, out);
            go_in(in, out, start, pass_index);
            return;
        }
        const CutterLocation& last = before->cl.back();
        Route route;
        bool linked = link_near(*before, pass, route) && joints_follow(route, pass);
        if (!linked) {
            const Reach out = out_of(last), in = in_to(start, ahead);
            // Rapids take their time as well: as much as from the clearance at feed.
            const double detour = out.length + in.length + 2 * (clearance_ - near_);
            linked = go_over(last, start, detour, route) && joints_follow(route, pass);
            if (!linked) {
                go_in(in, go_round(out, in), start, pass_index);
                return;
            }
        }
        for (const CutterLocation& c : route)
            between_passes(MotionKind::link, c);
        add({MotionKind::link, start, pass_index, 0});
    }

    /// Whether joints that go on over a link come as far in the pass as if they began there.
    bool joints_follow(const Route& route, const Pass& pass) const {
        Route whole = route;
        whole.insert(whole.end(), pass.cl.begin(), pass.cl.end());
        const std::size_t reached = run_.reach(whole);
        if (reached == whole.size()) return true;
        JointRun own(kinematics_, motion_);
        own.begin(pass.cl.front());
        return reached > route.size()
               && reached - route.size() >= 1 + own.reach(std::span(pass.cl).subspan(1));
    }

    /// The places between two passes that are neighbours; false where there is no such route.
    bool link_near(const Pass& from, const Pass& to, Route& route) {
        const CutterLocation &last = from.cl.back(), &start = to.cl.front();
        const bool near = (start.tip - last.tip).norm() <= options_.link_distance;
        return near ? on_surface_.between(last, start, {max_lift_, turn_at_once}, route)
                    : turn_over(from, to, route);
    }

    /// Where a pass turns round, a flat end's tips are a diameter apart, each a radius behind its contact,
    /// and the contacts are neighbours. The tool comes off along its axis, turns over clear of the part, and
    /// goes in along its axis.
    bool turn_over(const Pass& from, const Pass& to, Route& route) {
        if (from.cc.empty() || to.cc.empty()
            || (to.cc.front().point - from.cc.back().point).norm() > options_.link_distance)
            return false;
        return clear_route(from.cl.back(), to.cl.front(), {max_lift_, turn_at_once}, route);
    }

    /// Farther apart, where that is less than the `detour` at feed that rapids take. What stands there of the
    /// stock it cuts as passes do.
    bool go_over(const CutterLocation& from, const CutterLocation& to, double detour, Route& route) {
        if (!((to.tip - from.tip).norm() < detour) || from.axis.dot(to.axis) < std::cos(max_turn))
            return false;
        return clear_route(from, to, {0.5 * detour, turn_at_once}, route)
               && length_of(from, route, to) < detour;
    }

    /// Off the part at one end, over it clear of it, and down to where the other end is entered from.
    bool clear_route(const CutterLocation& from, const CutterLocation& to, const SurfaceLink::Limits& limits,
                     Route& route) {
        const CutterLocation up = off(from), down = off(to);
        route.assign(1, up);
        if (!over_surface_.between(up, down, limits, route)) return false;
        route.push_back(down);
        return true;
    }

    const LinkOptions& options_;
    const Progress& progress_;
    ToolLift lift_;
    Kinematics kinematics_;
    double radius_, clearance_;
    double near_; ///< between what stands, or a location, and where rapids along the axis end
    double chord_, max_lift_;
    double apart_; ///< The places of a route at which the part is looked at are no farther from each other.
    EvenMotion motion_;
    SurfaceLink on_surface_;
    /// Keeps clear by `apart_` more: the rim of an inclined tool sweeps over borders of the part.
    ToolLift clear_lift_;
    SurfaceLink over_surface_;
    Envelope envelope_;
    TiltedStock stock_;
    EntryPlaces places_;
    JointRun run_{kinematics_, motion_};
    ToolMotions result_;
};

} // namespace

ToolMotions link_five_axis(const StrategyResult& path, const PlanContext& context,
                           const ToolClearance& clearance, const LinkOptions& options,
                           const Progress& progress) {
    check_link_options(options);
    return FiveAxisLinker(path, context, clearance, options, progress).link(path);
}

} // namespace facetmill
