#include "core/base/tolerances.h"
#include "core/link/later_cuts.h"
#include "core/link/link.h"
#include "core/link/straight_up.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/rough/rough_entry.h"
#include "core/strategy/surface/holder_reach.h"
#include "core/strategy/surface/lift_line.h"
#include "core/strategy/surface/stock_before.h"

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

/// What stands at each moment, where the operation knows its stock: down to the clearance over it a tool goes
/// in a rapid.
class DescentOver {
public:
    /// `lowest`: of the tips that are fed.
    DescentOver(const PlanContext& context, const LinkOptions& options, double lowest,
                const Progress& progress)
        : profile_(context.tool.cutter()), cutter_(profile_), bodies_(context.tool, profile_, 0),
          clearance_(std::min(options.clearance, near_share * profile_.max_radius())), up_(context.tool),
          reach_(2 * profile_.max_radius()) {
        if (context.stock.box.empty() && context.earlier.empty()) return;
        for (const HolderSection& s : context.tool.holder)
            reach_ = std::max(reach_, 0.5 * s.diameter + profile_.max_radius());
        reach_ = std::max(reach_, 0.5 * context.tool.shank_diameter + profile_.max_radius());
        stock_.emplace(stock_before(context, cell_share * profile_.max_radius(), progress), profile_, lowest);
    }

    /// Where a rapid straight down to a tip ends: at `top` where nothing is known of the stock.
    double down_to(const Vec3& tip, double top) {
        if (!stock_) return top;
        const Vec2 p = tip.head<2>();
        const StockField& field = stock_->about(p, reach_);
        const double stands =
            std::max({field.clear_height(cutter_, p, p), bodies_.clear_height(field, p, p), tip.z()});
        return std::min(top, stands + clearance_);
    }
    /// Where a rapid straight up from a tip begins. What stands higher than the cutter beside a slimmer
    /// shank, or beside the neck of an undercut cutter, is cut on the way up: at feed.
    double up_from(const Vec3& tip, double top) {
        if (!stock_ || up_.is_undercut()) return top;
        // Shank and holder may have been brought into stock that nobody roughed.
        const Vec2 p = tip.head<2>();
        const StockField& field = stock_->about(p, reach_);
        if (!up_.is_free(field, tip) || bodies_.clear_height(field, p, p) > tip.z()) return down_to(tip, top);
        return std::min(top, tip.z() + clearance_);
    }
    /// Where a rapid down that does not end over a tip ends beside it: cells that a wall crosses are as high
    /// as the wall for ever, so that along a wall nothing is known to be gone. None where that is no shorter
    /// than `slow`, the way down at feed.
    std::optional<Vec3> beside(const Vec3& tip, double slow, const LiftField& part, double spacing) {
        std::optional<Vec3> best;
        if (!stock_) return best;
        double least = worth_share * slow;
        for (const double away : {0.25, 0.5})
            for (int k = 0; k < directions; ++k) {
                const double angle = 2 * pi * k / directions, r = away * profile_.max_radius();
                Vec3 place = tip + Vec3(r * std::cos(angle), r * std::sin(angle), 0);
                place.z() = down_to(place, infinity);
                const double length = (place - tip).norm();
                if (!(length < least) || !is_clear(place, tip, part, spacing)) continue;
                least = length;
                best = place;
            }
        return best;
    }
    /// Whether neither shank nor holder meets what stands on a level way at z.
    bool is_level_free(const Vec2& a, const Vec2& b, double z) {
        if (!stock_) return false;
        const StockField& field = stock_->about(0.5 * (a + b), 0.5 * (b - a).norm() + reach_);
        return bodies_.clear_height(field, a, b) <= z && !up_.stands_above(field, a, b, z);
    }
    /// What a rapid keeps from what stands, mm.
    double clearance() const { return clearance_; }
    void feed(const Vec3& from, const Vec3& to) {
        if (stock_) stock_->feed(from, to);
    }

private:
    /// Straight down to a tip from beside it: cutter, shank and holder keep out of the part, the latter two
    /// of the stock, too.
    bool is_clear(const Vec3& place, const Vec3& tip, const LiftField& part, double spacing) {
        const Vec2 from = place.head<2>(), to = tip.head<2>();
        const StockField& field = stock_->about(to, reach_);
        if (bodies_.clear_height(field, from, to) > tip.z()) return false;
        // A shank as wide as the cutter comes down in what that has cut, but not sideways.
        if (up_.stands_above(field, from, to, tip.z())) return false;
        const double parts = std::floor((place - tip).norm() / spacing) + 1;
        LiftHint hint;
        for (double i = 0; i < parts; ++i) {
            const Vec3 at = place + i / parts * (tip - place);
            if (part.tip_z(at.head<2>(), hint) > at.z()) return false;
        }
        return true;
    }

    /// Places beside a tip that are asked; how much of the way at feed they have to save.
    static constexpr int directions = 8;
    static constexpr double worth_share = 0.5;
    /// The size of the field's cells in radii of the cutter. What it tells is never too low.
    static constexpr double cell_share = 0.1;
    /// How near to what stands rapids come, in radii too, where the clearance is more.
    static constexpr double near_share = 0.5;
    CutterProfile profile_;
    StockCutter cutter_;
    UprightBodies bodies_;
    double clearance_;
    StraightUp up_;
    /// Of what is asked about a tip: half a radius beside it, and there the widest body.
    double reach_;
    std::optional<LaterCuts> stock_;
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
    const CutterProfile profile(context.tool.cutter());
    const AxialLift lift(context.contact, profile, allowance + context.tessellation_tolerance[1]);
    LineTolerance fine;
    fine.below = fine.above = 0.5 * options.chord_tolerance;
    const HolderReach bodies(context.contact, context.tool,
                             allowance + context.tessellation_tolerance[1] + options.holder_clearance,
                             options.chord_tolerance);
    fine.spacing = std::min(safe_spacing(profile, fine.below), bodies.spacing());

    const LiftField part{&lift, -infinity, &bodies};
    double top = std::max(context.kept_off_box().hi.z(), context.stock_box.hi.z()) + allowance;
    double lowest = infinity;
    for (const Pass& pass : path.passes)
        for (const CutterLocation& c : pass.cl) {
            top = std::max(top, c.tip.z());
            lowest = std::min(lowest, c.tip.z());
        }
    ToolMotions result;
    result.clearance_z = top + options.clearance;

    DescentOver stock(context, options, lowest, progress.part(0, 0.1));
    const auto add = [&](MotionKind kind, const CutterLocation& to, Index pass = no_index,
                         Index point = no_index) {
        if (kind != MotionKind::rapid) stock.feed(result.motions.back().to.tip, to.tip);
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
        up(MotionKind::retract, from, stock.up_from(from.tip, result.clearance_z), result.clearance_z);
    };
    // Straight up a wall, of which the flutes have cut all that they reach, most of the way in a rapid.
    const auto rise = [&](const CutterLocation& from, const CutterLocation& to) {
        if (from.tip.head<2>() != to.tip.head<2>()) return;
        const double end = to.tip.z() - stock.clearance(), z = stock.up_from(from.tip, end);
        if (end - z > stock.clearance()) up(MotionKind::cut, from, z, end);
    };
    // Straight up as far as shank and holder ask for, level over the part, and down to a pass's beginning.
    const auto hop = [&](const CutterLocation& from, const CutterLocation& start, double z) {
        const double down = stock.down_to(start.tip, z);
        CutterLocation over = at_height(start, down);
        const auto aside = stock.beside(start.tip, down - start.tip.z(), part, fine.spacing);
        if (aside && aside->z() <= z && stock.is_level_free(from.tip.head<2>(), aside->head<2>(), z))
            over.tip = *aside;
        if (z > from.tip.z()) up(MotionKind::link, from, std::min(z, stock.up_from(from.tip, z)), z);
        for (const CutterLocation& c :
             on_surface(at_height(from, z), at_height(over, z), lift, bodies, fine, progress.part(0, 0)))
            add(MotionKind::link, c);
        if (z - over.tip.z() > stock.clearance()) add(MotionKind::rapid, over);
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
            for (const CutterLocation& c : on_surface(*last, start, lift, bodies, fine, progress.part(0, 0)))
                add(MotionKind::link, c);
            result.motions.back().pass = pass_index;
            result.motions.back().point = 0;
        } else {
            if (last) retract(*last);
            CutterLocation over = at_height(start, stock.down_to(start.tip, result.clearance_z));
            if (const auto aside = stock.beside(start.tip, over.tip.z() - start.tip.z(), part, fine.spacing))
                over.tip = *aside;
            add(MotionKind::rapid, at_height(over, result.clearance_z));
            if (over.tip.z() < result.clearance_z) add(MotionKind::rapid, over);
            add(MotionKind::approach, start, pass_index, 0);
        }
        for (std::size_t k = 1; k < pass.cl.size(); ++k) {
            rise(pass.cl[k - 1], pass.cl[k]);
            add(MotionKind::cut, pass.cl[k], pass_index, Index(k));
        }
        last = &pass.cl.back();
    }
    if (last) retract(*last);
    progress.set(1);
    return result;
}

} // namespace facetmill
