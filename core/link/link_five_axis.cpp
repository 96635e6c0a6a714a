#include "core/base/tolerances.h"
#include "core/link/link.h"
#include "core/strategy/five_axis/posture_path.h"

#include <cmath>

namespace facetmill {

namespace {

/// A link on the surface is halved this often at most before it is given up for a clearance move.
constexpr int max_divisions = 9;
/// ... with those of ways too long or turning too far to be looked at in one piece.
constexpr int max_depth = 16;
/// Of the cutter's diameter: a link on the surface is lifted by no more.
constexpr double max_lift_share = 1.5;
/// Of the chord tolerance, as for passes.
constexpr double chord_share = 0.6;
/// Where the axis turns by more, a tool goes up between places that are no neighbours: rotary axes take their
/// time, and near their pole they swing.
const double max_turn = radians(45);
/// ... and on the way turns by no more than this with a motion.
const double turn_at_once = radians(5);
/// A straight piece of a link is no longer than so many steps at which it is looked at.
constexpr double longest_steps = 200;
/// How far a tool comes off that turns over, in what it has to be clear by.
constexpr double off_share = 2;

/// A way between two locations that keeps clear of the part to within the chord tolerance, lifted along the
/// tool axis where it has to be.
class SurfaceLink {
public:
    SurfaceLink(const ToolLift& lift, double chord, const Progress& progress)
        : lift_(lift), step_(looking_step(lift.cutter().max_radius(), chord)), chord_(chord),
          progress_(progress) {}

    struct Limits {
        double lift = 0;  ///< of a place between, at most
        double turn = pi; ///< of the axis in one motion
    };
    /// Appends what stands between a and b; false where there is no such way.
    bool between(const CutterLocation& a, const CutterLocation& b, const Limits& limits,
                 std::vector<CutterLocation>& route) {
        return between(a, b, limits, 0, 0, route);
    }

private:
    bool between(const CutterLocation& a, const CutterLocation& b, const Limits& limits, int divisions,
                 int depth, std::vector<CutterLocation>& route) {
        progress_.check();
        // Only so far one sees by steps; and machines move their joints evenly, not the axis in one plane.
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

/// How far below the tip's level a tilted tool reaches: its lower rims, cutter, shank and holder.
double reach_below(const Tool& tool, double cutter_radius, const Vec3& axis) {
    const double tilt = std::hypot(axis.x(), axis.y());
    double below = std::max(cutter_radius, 0.5 * tool.diameter) * tilt;
    double height = tool.flute_length;
    const auto body = [&](double diameter, double length) {
        below = std::max(below, 0.5 * diameter * tilt - height * axis.z());
        height += length;
    };
    body(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& section : tool.holder)
        body(section.diameter, section.length);
    return below;
}

} // namespace

ToolMotions link_five_axis(const StrategyResult& path, const PlanContext& context,
                           const ToolClearance& clearance, const LinkOptions& options,
                           const Progress& progress) {
    check_link_options(options);
    const ToolLift lift(context.contact, context.tool, clearance);
    const double diameter = 2 * lift.cutter().max_radius();
    // Between two axes an arc of axes is never flatter than the flatter of the two, so at this level the tool
    // may turn from any to any.
    double top = std::max(context.part_box.hi.z(), context.stock_box.hi.z()) + clearance.cutter, below = 0;
    for (const Pass& pass : path.passes)
        for (const CutterLocation& c : pass.cl) {
            top = std::max(top, c.tip.z());
            below = std::max(below, reach_below(context.tool, lift.cutter().max_radius(), c.axis));
            if (!(c.axis.z() >= tolerance::lowest_axis_z * (1 - tolerance::level_angle)))
                throw Error(ErrorCode::internal, "link", "a tool axis lies down", "report this");
        }
    ToolMotions result;
    result.clearance_z = top + below + options.clearance;
    const auto at_clearance = [&](const CutterLocation& c) {
        const double up = (result.clearance_z - c.tip.z()) / c.axis.z();
        CutterLocation above{c.tip + up * c.axis, c.axis};
        above.tip.z() = result.clearance_z; // to the last digit: rapids are level
        return above;
    };

    const double chord = chord_share * options.chord_tolerance, max_lift = max_lift_share * diameter;
    SurfaceLink on_surface(lift, chord, progress);
    // Where a pass turns round, a flat end's tips are a diameter apart, each a radius behind its contact, and
    // the contacts are neighbours. The tool comes off along its axis, turns over clear of the part, and goes
    // in along its axis. The rim sweeps inclined over borders of the part: clear by as much as it is looked
    // at apart.
    const double apart = looking_step(0.5 * diameter, chord);
    const ToolLift clear_lift(context.contact, context.tool,
                              {clearance.cutter + apart, clearance.shank + apart, clearance.holder + apart});
    SurfaceLink over_surface(clear_lift, chord, progress);
    const auto off = [&](const CutterLocation& c) {
        return CutterLocation{c.tip + off_share * apart * c.axis, c.axis};
    };
    const auto turned_over = [&](const Pass& from, const Pass& to, std::vector<CutterLocation>& route) {
        if (from.cc.empty() || to.cc.empty()
            || (to.cc.front().point - from.cc.back().point).norm() > options.link_distance)
            return false;
        const CutterLocation up = off(from.cl.back()), down = off(to.cl.front());
        route.assign(1, up);
        if (!over_surface.between(up, down, {max_lift}, route)) return false;
        route.push_back(down);
        return true;
    };
    // Farther apart, where that is less than up to the clearance and down again, which is at feed, too. What
    // stands there of the stock it cuts as passes do.
    const auto over = [&](const CutterLocation& from, const CutterLocation& to,
                          std::vector<CutterLocation>& route) {
        const double detour =
            (at_clearance(from).tip - from.tip).norm() + (at_clearance(to).tip - to.tip).norm();
        if (!((to.tip - from.tip).norm() < detour) || from.axis.dot(to.axis) < std::cos(max_turn))
            return false;
        const CutterLocation up = off(from), down = off(to);
        route.assign(1, up);
        if (!over_surface.between(up, down, {0.5 * detour, turn_at_once}, route)) return false;
        route.push_back(down);
        double length = 0;
        const CutterLocation* at = &from;
        for (const CutterLocation& c : route) {
            length += (c.tip - at->tip).norm();
            at = &c;
        }
        return length + (to.tip - at->tip).norm() < detour;
    };
    const Pass* last_pass = nullptr;
    const CutterLocation* last = nullptr;
    for (std::size_t i = 0; i < path.passes.size(); ++i) {
        progress.set(double(i) / double(path.passes.size()));
        const Pass& pass = path.passes[i];
        if (pass.cl.empty()) continue;
        const CutterLocation& start = pass.cl.front();
        const auto pass_index = Index(i);
        bool linked = false;
        std::vector<CutterLocation> route;
        if (last && (start.tip - last->tip).norm() <= options.link_distance) {
            linked = on_surface.between(*last, start, {max_lift}, route);
        } else if (last) {
            linked = turned_over(*last_pass, pass, route);
        }
        if (last && !linked) linked = over(*last, start, route);
        if (linked) {
            for (const CutterLocation& c : route)
                result.motions.push_back({MotionKind::link, c, no_index, no_index});
            result.motions.push_back({MotionKind::link, start, pass_index, 0});
        }
        if (!linked) {
            if (last)
                result.motions.push_back({MotionKind::retract, at_clearance(*last), no_index, no_index});
            result.motions.push_back({MotionKind::rapid, at_clearance(start), no_index, no_index});
            result.motions.push_back({MotionKind::approach, start, pass_index, 0});
        }
        for (std::size_t k = 1; k < pass.cl.size(); ++k)
            result.motions.push_back({MotionKind::cut, pass.cl[k], pass_index, Index(k)});
        last_pass = &pass;
        last = &pass.cl.back();
    }
    if (last) result.motions.push_back({MotionKind::retract, at_clearance(*last), no_index, no_index});
    progress.set(1);
    return result;
}

} // namespace facetmill
