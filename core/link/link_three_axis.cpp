#include "core/base/tolerances.h"
#include "core/link/link.h"
#include "core/link/upright_travel.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/surface/lift_line.h"

#include <optional>

namespace facetmill {

namespace {

/// Heights of a move on the surface: the lift over the straight line between two tips, but no lower than the
/// lower of them, so that a link crosses a hole or a border instead of diving into it.
std::vector<CutterLocation> on_surface(const CutterLocation& from, const CutterLocation& to,
                                       const AxialLift& lift, const HolderReach& bodies,
                                       const LineTolerance& tolerance, const Progress& progress) {
    const Vec2 a = from.tip.head<2>(), b = to.tip.head<2>();
    const double length = (b - a).norm();
    std::vector<CutterLocation> route;
    if (length > 0) {
        const LiftField field{&lift, std::min(from.tip.z(), to.tip.z()), &bodies};
        const Vec2 direction = (b - a) / length;
        const auto line = thinned(lift_line(field, a, direction, 0, length, tolerance, progress),
                                  tolerance.below, tolerance.above);
        for (const LinePoint& p : line)
            route.push_back({Vec3(a.x() + p.s * direction.x(), a.y() + p.s * direction.y(), p.z), from.axis});
        // The first point is over `from`: an upright move where the pass ended below it, nothing where they
        // agree.
        if (route.front().tip.z() <= from.tip.z()) route.erase(route.begin());
        if (!route.empty() && route.back().tip.z() <= to.tip.z()) route.pop_back();
    }
    route.push_back(to);
    return route;
}

} // namespace

LinkOptions default_link_options(const StrategyResult& path, const PlanContext& context,
                                 const OperationCommon& common) {
    LinkOptions options;
    options.clearance = common.clearance;
    options.link_distance = surface_link_distance(path.stepover_max, context.tool.diameter);
    // As coarse as the passes and no coarser, or links would cut straight through what they should climb.
    const double chord = path.chord_tolerance > 0 ? path.chord_tolerance : 0.05 * common.tolerance;
    options.chord_tolerance = std::max(chord, tolerance::smallest_chord);
    return options;
}

void check_link_options(const LinkOptions& options) {
    if (!(options.clearance > 0) || !(options.chord_tolerance > 0) || !(options.link_distance >= 0))
        throw Error(ErrorCode::out_of_range, "link",
                    "clearance and chord tolerance must be above 0, the link distance at least 0",
                    "correct the operation's settings");
}

ToolMotions link_three_axis(const StrategyResult& path, const PlanContext& context, double allowance,
                            const LinkOptions& options, const Progress& progress) {
    check_link_options(options);
    double top = std::max(context.kept_off_box().hi.z(), context.stock_box.hi.z()) + allowance;
    double lowest = infinity;
    for (const Pass& pass : path.passes)
        for (const CutterLocation& c : pass.cl) {
            top = std::max(top, c.tip.z());
            lowest = std::min(lowest, c.tip.z());
        }
    ToolMotions result;
    result.clearance_z = top + options.clearance;

    UprightTravel travel(context, allowance + context.tessellation_tolerance[1], options, lowest,
                         result.clearance_z, progress.part(0, 0.1));
    LineTolerance fine;
    fine.below = fine.above = 0.5 * options.chord_tolerance;
    fine.spacing = travel.spacing();
    const auto add = [&](MotionKind kind, const CutterLocation& to, Index pass = no_index,
                         Index point = no_index) {
        if (kind != MotionKind::rapid) travel.feed(result.motions.back().to.tip, to.tip);
        result.motions.push_back({kind, to, pass, point});
    };
    const auto at_height = [](CutterLocation location, double z) {
        location.tip.z() = z;
        return location;
    };
    const auto up = [&](MotionKind kind, const CutterLocation& from, double z, double end) {
        add(kind, at_height(from, z));
        if (z < end) add(MotionKind::rapid, at_height(from, end));
    };
    const auto retract = [&](const CutterLocation& from) {
        up(MotionKind::retract, from, travel.up_from(from.tip, result.clearance_z), result.clearance_z);
    };
    // Straight up a wall, of which the flutes have cut all that they reach, most of the way in a rapid. Up
    // one that leans by less than moves may stay off the part, too: what it cuts less is no thicker.
    const auto rise = [&](const CutterLocation& from, const CutterLocation& to) {
        if (!((to.tip - from.tip).head<2>().norm() <= 0.5 * options.chord_tolerance)) return;
        const double end = to.tip.z() - travel.clearance(), z = travel.up_from(from.tip, end);
        if (end - z > travel.clearance()) up(MotionKind::cut, from, z, end);
    };
    const auto surface = [&](const CutterLocation& from, const CutterLocation& to) {
        for (const CutterLocation& c :
             on_surface(from, to, travel.lift(), travel.bodies(), fine, progress.part(0, 0)))
            add(MotionKind::link, c);
    };
    // Straight up as far as shank and holder ask for, level over the part, and down to a pass's beginning.
    const auto hop = [&](const CutterLocation& from, const CutterLocation& start, double z) {
        const double down = travel.down_to(start.tip, z);
        CutterLocation over = at_height(start, down);
        const auto aside = travel.beside(start.tip, down - start.tip.z());
        if (aside && aside->z() <= z && travel.is_level_free(from.tip.head<2>(), aside->head<2>(), z))
            over.tip = *aside;
        if (z > from.tip.z()) up(MotionKind::link, from, std::min(z, travel.up_from(from.tip, z)), z);
        surface(at_height(from, z), at_height(over, z));
        if (z - over.tip.z() > travel.clearance()) add(MotionKind::rapid, over);
    };
    // In rapids, as low as may be.
    const auto travel_to = [&](const CutterLocation* from, const CutterLocation& start) {
        const auto route = from ? travel.route(from->tip, start.tip, progress.part(0, 0))
                                : UprightTravel::Route{start.tip, travel.over(start.tip), result.clearance_z};
        // Sideways something may be cut.
        const bool straight = from && route.out.head<2>() == from->tip.head<2>();
        if (from) add(straight ? MotionKind::retract : MotionKind::cut, {route.out, from->axis});
        for (const Vec3& p : route.rapids())
            if (result.motions.empty() || result.motions.back().to.tip != p)
                add(MotionKind::rapid, {p, start.axis});
    };
    const CutterLocation* last = nullptr;
    for (std::size_t i = 0; i < path.passes.size(); ++i) {
        progress.part(0.1, 1).set(double(i) / double(path.passes.size()));
        const Pass& pass = path.passes[i];
        if (pass.cl.empty()) continue;
        const CutterLocation& start = pass.cl.front();
        const auto pass_index = Index(i);
        const bool near =
            last && !pass.from_above && (start.tip - last->tip).head<2>().norm() <= options.link_distance;
        if (near && !pass.entry.empty() && pass.entry.front().tip.z() < result.clearance_z) {
            hop(*last, start, std::max(pass.entry.front().tip.z(), last->tip.z()));
            add(MotionKind::approach, start, pass_index, 0);
        } else if (near && pass.entry.empty()) {
            surface(*last, start);
            result.motions.back().pass = pass_index;
            result.motions.back().point = 0;
        } else {
            travel_to(last, start);
            add(MotionKind::approach, start, pass_index, 0);
        }
        for (std::size_t k = 1; k < pass.cl.size(); ++k) {
            rise(pass.cl[k - 1], pass.cl[k]);
            if (const auto z = travel.fall_to(pass.cl[k - 1].tip, pass.cl[k].tip))
                add(MotionKind::rapid, at_height(pass.cl[k], *z));
            add(MotionKind::cut, pass.cl[k], pass_index, Index(k));
        }
        last = &pass.cl.back();
    }
    if (last) retract(*last);
    progress.set(1);
    return result;
}

} // namespace facetmill
