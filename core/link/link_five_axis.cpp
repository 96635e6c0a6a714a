#include "core/base/tolerances.h"
#include "core/link/envelope.h"
#include "core/link/link.h"
#include "core/strategy/five_axis/posture_path.h"

#include <cmath>

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
/// How far a tool comes off before it turns over, in the distance by which it has to be clear then.
constexpr double off_share = 2;

/// Finds a route between two locations that keeps clear of the part to within the chord tolerance, lifted
/// along the tool axis where it has to be.
class SurfaceLink {
public:
    SurfaceLink(const ToolLift& lift, double chord, const Progress& progress)
        : lift_(lift), step_(looking_step(lift.cutter().max_radius(), chord)), chord_(chord),
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
        const bool far =
            (b.tip - a.tip).norm() > longest_steps * step_ || a.axis.dot(b.axis) < std::cos(limits.turn);
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
          radius_(lift_.cutter().max_radius()), chord_(options.motion_share * options.chord_tolerance),
          max_lift_(max_lift_share * 2 * radius_), apart_(looking_step(radius_, chord_)),
          on_surface_(lift_, chord_, progress),
          clear_lift_(context.contact, context.tool,
                      {clearance.cutter + apart_, clearance.shank + apart_, clearance.holder + apart_}),
          over_surface_(clear_lift_, chord_, progress),
          envelope_(kept_clear_of(path, context, radius_, options, clearance)) {}

    ToolMotions link(const StrategyResult& path) {
        result_.clearance_z = envelope_.level();
        const Pass* before = nullptr;
        for (std::size_t i = 0; i < path.passes.size(); ++i) {
            progress_.set(double(i) / double(path.passes.size()));
            const Pass& pass = path.passes[i];
            if (pass.cl.empty()) continue;
            go_to(pass, Index(i), before);
            for (std::size_t k = 1; k < pass.cl.size(); ++k)
                result_.motions.push_back({MotionKind::cut, pass.cl[k], Index(i), Index(k)});
            before = &pass;
        }
        if (before) {
            const CutterLocation& last = before->cl.back();
            come_out(last, envelope_.out(last));
        }
        progress_.set(1);
        return std::move(result_);
    }

private:
    using Route = std::vector<CutterLocation>;

    static EnvelopeInput kept_clear_of(const StrategyResult& path, const PlanContext& context, double radius,
                                       const LinkOptions& options, const ToolClearance& clearance) {
        EnvelopeInput in;
        in.part = context.part_box;
        in.stock = context.stock_box;
        in.tool = &context.tool;
        in.cutter_radius = radius;
        in.clearance = options.clearance + clearance.cutter;
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl) {
                in.highest_tip = std::max(in.highest_tip, c.tip.z());
                in.lowest_axis_z = std::min(in.lowest_axis_z, c.axis.z());
                if (!(c.axis.z() >= tolerance::lowest_axis_z * (1 - tolerance::level_angle)))
                    throw Error(ErrorCode::internal, "link", "a tool axis lies down", "report this");
            }
        return in;
    }

    /// Out along the axis: at feed until the tool may move fast.
    void come_out(const CutterLocation& at, const CutterLocation& out) {
        const CutterLocation clear = envelope_.off_part(at);
        const double far = (out.tip - at.tip).norm(), slow = (clear.tip - at.tip).norm();
        if (slow > 0) between_passes(MotionKind::retract, slow < far ? clear : out);
        if (slow < far) between_passes(MotionKind::rapid, out);
    }
    /// In along the axis: fast until the tool comes to the stock, then at feed.
    void go_in(const CutterLocation& out, const CutterLocation& start, Index pass_index) {
        const CutterLocation clear = envelope_.out_of_stock(start);
        if ((clear.tip - start.tip).norm() < (out.tip - start.tip).norm())
            between_passes(MotionKind::rapid, clear);
        result_.motions.push_back({MotionKind::approach, start, pass_index, 0});
    }

    /// The place beside a pass's end where the tool may turn over.
    CutterLocation off(const CutterLocation& c) const {
        return {c.tip + off_share * apart_ * c.axis, c.axis};
    }

    void between_passes(MotionKind kind, const CutterLocation& to) {
        result_.motions.push_back({kind, to, no_index, no_index});
    }

    /// To the start of a pass, from the end of the pass before, if there is one.
    void go_to(const Pass& pass, Index pass_index, const Pass* before) {
        const CutterLocation& start = pass.cl.front();
        Route route;
        if (before && find_link(*before, pass, route)) {
            for (const CutterLocation& c : route)
                between_passes(MotionKind::link, c);
            result_.motions.push_back({MotionKind::link, start, pass_index, 0});
            return;
        }
        if (!before) {
            const CutterLocation out = envelope_.out(start);
            between_passes(MotionKind::rapid, out);
            go_in(out, start, pass_index);
            return;
        }
        const CutterLocation& last = before->cl.back();
        const Route round = envelope_.route(last, start);
        come_out(last, round.front());
        for (std::size_t k = 1; k < round.size(); ++k)
            between_passes(MotionKind::rapid, round[k]);
        go_in(round.back(), start, pass_index);
    }

    /// The places between two passes, on the way that suits how far they are from each other; false where
    /// only the clearance is left.
    bool find_link(const Pass& from, const Pass& to, Route& route) {
        const CutterLocation &last = from.cl.back(), &start = to.cl.front();
        const bool near = (start.tip - last.tip).norm() <= options_.link_distance;
        if (near ? on_surface_.between(last, start, {max_lift_, turn_at_once}, route)
                 : turn_over(from, to, route))
            return true;
        return go_over(last, start, route);
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

    /// Farther apart, where that is less than up to the clearance and down again, which is at feed, too. What
    /// stands there of the stock it cuts as passes do.
    bool go_over(const CutterLocation& from, const CutterLocation& to, Route& route) {
        const double detour = (envelope_.out_of_stock(from).tip - from.tip).norm()
                              + (envelope_.out_of_stock(to).tip - to.tip).norm();
        if (!((to.tip - from.tip).norm() < detour) || from.axis.dot(to.axis) < std::cos(max_turn))
            return false;
        if (!clear_route(from, to, {0.5 * detour, turn_at_once}, route)) return false;
        double length = 0;
        const CutterLocation* at = &from;
        for (const CutterLocation& c : route) {
            length += (c.tip - at->tip).norm();
            at = &c;
        }
        return length + (to.tip - at->tip).norm() < detour;
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
    double radius_, chord_, max_lift_;
    double apart_; ///< The places of a route at which the part is looked at are no farther from each other.
    SurfaceLink on_surface_;
    /// Keeps clear by `apart_` more: the rim of an inclined tool sweeps over borders of the part.
    ToolLift clear_lift_;
    SurfaceLink over_surface_;
    Envelope envelope_;
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
