#include "core/base/tolerances.h"
#include "core/link/motion.h"
#include "core/strategy/posture_path.h"

#include <cmath>

namespace facetmill {

namespace {

/// A link on the surface is halved this often at most before it is given up for a clearance move.
constexpr int most_divisions = 9;
/// Of the cutter's diameter: a link on the surface is lifted by no more.
constexpr double most_lift_share = 1.5;
/// Of the chord tolerance, as for passes.
constexpr double chord_share = 0.6;

/// A way between two locations that keeps clear of the part to within the chord tolerance, lifted along the
/// tool axis where it has to be.
class SurfaceLink {
public:
    SurfaceLink(const ToolLift& lift, double chord, double most_lift)
        : lift_(lift), chord_(chord), most_lift_(most_lift) {}

    /// Appends what stands between a and b; false where there is no such way.
    bool between(const CutterLocation& a, const CutterLocation& b, int divisions,
                 std::vector<CutterLocation>& way) {
        if (deepest_between(lift_, a, b, looking_step(lift_.cutter().max_radius(), chord_), hint_) <= chord_)
            return true;
        if (divisions == most_divisions) return false;
        CutterLocation middle = location_on_way(a, b, 0.5);
        const double lift = lift_.lift({middle.tip, middle.axis}, hint_);
        if (lift > most_lift_) return false;
        if (lift > 0) middle.tip += lift * middle.axis;
        std::vector<CutterLocation> second;
        if (!between(a, middle, divisions + 1, way) || !between(middle, b, divisions + 1, second))
            return false;
        way.push_back(middle);
        way.insert(way.end(), second.begin(), second.end());
        return true;
    }

private:
    const ToolLift& lift_;
    double chord_, most_lift_;
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

    SurfaceLink on_surface(lift, chord_share * options.chord_tolerance, most_lift_share * diameter);
    const CutterLocation* last = nullptr;
    for (std::size_t i = 0; i < path.passes.size(); ++i) {
        progress.set(double(i) / double(path.passes.size()));
        const Pass& pass = path.passes[i];
        if (pass.cl.empty()) continue;
        const CutterLocation& start = pass.cl.front();
        const auto pass_index = Index(i);
        bool linked = false;
        if (last && (start.tip - last->tip).norm() <= options.link_distance) {
            std::vector<CutterLocation> way;
            linked = on_surface.between(*last, start, 0, way);
            if (linked) {
                for (const CutterLocation& c : way)
                    result.motions.push_back({MotionKind::link, c, no_index, no_index});
                result.motions.push_back({MotionKind::link, start, pass_index, 0});
            }
        }
        if (!linked) {
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
