#include "core/base/tolerances.h"
#include "core/link/link.h"
#include "core/link/upright_travel.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/surface/lift_line.h"

#include <array>
#include <optional>

namespace facetmill {

namespace {

/// A link goes straight up first where it would be steeper than this, height over width.
constexpr double min_steep = 3;

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

class ThreeAxisLinker {
public:
    ThreeAxisLinker(const StrategyResult& path, const PlanContext& context, double allowance,
                    const LinkOptions& options, const Progress& progress)
        : path_(path), options_(options), progress_(progress), extent_(extent(path, context, allowance)),
          travel_(context, allowance + context.tessellation_tolerance[1], options, extent_[0],
                  extent_[1] + options.clearance, progress.part(0, 0.1)) {
        result_.clearance_z = extent_[1] + options.clearance;
        fine_.below = fine_.above = 0.5 * options.chord_tolerance;
        fine_.spacing = travel_.spacing();
    }

    ToolMotions run() {
        for (std::size_t i = 0; i < path_.passes.size(); ++i) {
            progress_.part(0.1, 1).set(double(i) / double(path_.passes.size()));
            if (!path_.passes[i].cl.empty()) add_pass(path_.passes[i], Index(i));
        }
        if (last_) retract(*last_);
        progress_.set(1);
        return std::move(result_);
    }

private:
    /// The lowest tip, and above what all is free.
    static std::array<double, 2> extent(const StrategyResult& path, const PlanContext& context,
                                        double allowance) {
        double top = std::max(context.kept_off_box().hi.z(), context.stock_box.hi.z()) + allowance;
        double lowest = infinity;
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl) {
                top = std::max(top, c.tip.z());
                lowest = std::min(lowest, c.tip.z());
            }
        return {lowest, top};
    }

    void add_pass(const Pass& pass, Index index) {
        const CutterLocation& start = pass.cl.front();
        const bool near =
            last_ && !pass.from_above && (start.tip - last_->tip).head<2>().norm() <= options_.link_distance;
        if (near && !pass.entry.empty() && pass.entry.front().tip.z() < result_.clearance_z) {
            hop(*last_, start, std::max(pass.entry.front().tip.z(), last_->tip.z()));
            add(MotionKind::approach, start, index, 0);
        } else if (near && pass.entry.empty()) {
            surface(*last_, start);
            result_.motions.back().pass = index;
            result_.motions.back().point = 0;
        } else {
            travel_to(last_, start);
            add(MotionKind::approach, start, index, 0);
        }
        for (std::size_t k = 1; k < pass.cl.size(); ++k) {
            rise(pass.cl[k - 1], pass.cl[k]);
            if (const auto z = travel_.fall_to(pass.cl[k - 1].tip, pass.cl[k].tip))
                add(MotionKind::rapid, at_height(pass.cl[k], *z));
            add(MotionKind::cut, pass.cl[k], index, Index(k));
        }
        last_ = &pass.cl.back();
    }

    void add(MotionKind kind, const CutterLocation& to, Index pass = no_index, Index point = no_index) {
        if (kind != MotionKind::rapid) travel_.feed(result_.motions.back().to.tip, to.tip);
        result_.motions.push_back({kind, to, pass, point});
    }

    static CutterLocation at_height(CutterLocation location, double z) {
        location.tip.z() = z;
        return location;
    }

    void up(MotionKind kind, const CutterLocation& from, double z, double end) {
        add(kind, at_height(from, z));
        if (z < end) add(MotionKind::rapid, at_height(from, end));
    }

    void retract(const CutterLocation& from) {
        up(MotionKind::retract, from, travel_.up_from(from.tip, result_.clearance_z), result_.clearance_z);
    }

    /// Straight up from where the tool is to just below z, most of the way in a rapid: the cutter stood there
    /// below, or its flutes beside. Not where that saves nothing.
    void rise_below(MotionKind kind, const CutterLocation& from, double z) {
        const double end = z - travel_.touch(), out = travel_.up_from(from.tip, end);
        if (end - out > travel_.clearance()) up(kind, from, out, end);
    }

    /// Up a wall, of which the flutes have cut all that they reach. Up one that leans by less than moves may
    /// stay off the part, too: what it cuts less is no thicker.
    void rise(const CutterLocation& from, const CutterLocation& to) {
        if ((to.tip - from.tip).head<2>().norm() <= 0.5 * options_.chord_tolerance)
            rise_below(MotionKind::cut, from, to.tip.z());
    }

    /// Over the surface, up its walls straight from where the tool is.
    void surface(const CutterLocation& from, const CutterLocation& to) {
        CutterLocation at = from;
        for (const CutterLocation& c :
             on_surface(from, to, travel_.lift(), travel_.bodies(), fine_, progress_.part(0, 0))) {
            if (c.tip.z() - at.tip.z() > min_steep * (c.tip - at.tip).head<2>().norm())
                rise_below(MotionKind::link, at, c.tip.z());
            add(MotionKind::link, c);
            at = c;
        }
    }

    /// Straight up as far as shank and holder ask for, level over the part, and down to a pass's beginning.
    void hop(const CutterLocation& from, const CutterLocation& start, double z) {
        const double down = travel_.down_to(start.tip, z);
        CutterLocation over = at_height(start, down);
        const auto aside = travel_.beside(start.tip, down - start.tip.z());
        if (aside && aside->z() <= z && travel_.is_level_free(from.tip.head<2>(), aside->head<2>(), z))
            over.tip = *aside;
        if (z > from.tip.z()) up(MotionKind::link, from, std::min(z, travel_.up_from(from.tip, z)), z);
        surface(at_height(from, z), at_height(over, z));
        if (z - over.tip.z() > travel_.clearance()) add(MotionKind::rapid, over);
    }

    /// In rapids, as low as may be.
    void travel_to(const CutterLocation* from, const CutterLocation& start) {
        const auto route =
            from ? travel_.route(from->tip, start.tip, progress_.part(0, 0))
                 : UprightTravel::Route{start.tip, travel_.over(start.tip), result_.clearance_z};
        // Sideways something may be cut.
        const bool straight = from && route.out.head<2>() == from->tip.head<2>();
        if (from) add(straight ? MotionKind::retract : MotionKind::cut, {route.out, from->axis});
        for (const Vec3& p : route.rapids())
            if (result_.motions.empty() || result_.motions.back().to.tip != p)
                add(MotionKind::rapid, {p, start.axis});
    }

    const StrategyResult& path_;
    LinkOptions options_;
    const Progress& progress_;
    std::array<double, 2> extent_;
    UprightTravel travel_;
    LineTolerance fine_;
    ToolMotions result_;
    const CutterLocation* last_ = nullptr;
};

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
    return ThreeAxisLinker(path, context, allowance, options, progress).run();
}

} // namespace facetmill
