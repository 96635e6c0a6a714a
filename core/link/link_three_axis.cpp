#include "core/base/tolerances.h"
#include "core/link/link.h"
#include "core/strategy/surface/holder_reach.h"
#include "core/strategy/surface/lift_line.h"

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
    options.link_distance = std::max(4 * path.stepover_max, 0.5 * context.tool.diameter);
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
    const CutterProfile profile(context.tool.cutter());
    const AxialLift lift(context.contact, profile, allowance + context.tessellation_tolerance[1]);
    LineTolerance fine;
    fine.below = fine.above = 0.5 * options.chord_tolerance;
    const HolderReach bodies(context.contact, context.tool,
                             allowance + context.tessellation_tolerance[1] + options.holder_clearance,
                             options.chord_tolerance);
    fine.spacing = std::min(safe_spacing(profile, fine.below), bodies.spacing());

    double top = std::max(context.part_box.hi.z(), context.stock_box.hi.z()) + allowance;
    for (const Pass& pass : path.passes)
        for (const CutterLocation& c : pass.cl)
            top = std::max(top, c.tip.z());
    ToolMotions result;
    result.clearance_z = top + options.clearance;

    const auto at_clearance = [&](CutterLocation location) {
        location.tip.z() = result.clearance_z;
        return location;
    };
    const CutterLocation* last = nullptr;
    for (std::size_t i = 0; i < path.passes.size(); ++i) {
        progress.set(double(i) / double(path.passes.size()));
        const Pass& pass = path.passes[i];
        if (pass.cl.empty()) continue;
        const CutterLocation& start = pass.cl.front();
        const auto pass_index = Index(i);
        if (last && !pass.from_above && (start.tip - last->tip).head<2>().norm() <= options.link_distance) {
            for (const CutterLocation& c : on_surface(*last, start, lift, bodies, fine, progress.part(0, 0)))
                result.motions.push_back({MotionKind::link, c, no_index, no_index});
            result.motions.back().pass = pass_index;
            result.motions.back().point = 0;
        } else {
            if (last)
                result.motions.push_back({MotionKind::retract, at_clearance(*last), no_index, no_index});
            result.motions.push_back({MotionKind::rapid, at_clearance(start), no_index, no_index});
            result.motions.push_back({MotionKind::approach, start, pass_index, 0});
        }
        for (std::size_t k = 1; k < pass.cl.size(); ++k)
            result.motions.push_back({MotionKind::cut, pass.cl[k], pass_index, Index(k)});
        last = &pass.cl.back();
    }
    if (last) result.motions.push_back({MotionKind::retract, at_clearance(*last), no_index, no_index});
    progress.set(1);
    return result;
}

} // namespace facetmill
