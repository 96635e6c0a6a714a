#include "core/strategy/lathe/lathe_path.h"

#include "core/base/tolerances.h"
#include "core/setup/kinematics.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/plan_text.h"

#include <cmath>

namespace facetmill {

namespace {

/// What LatheCommon::look_share leaves of the chord tolerance: for leaving points out, and for the arcs of
/// motions that a reader of the program takes for straight.
constexpr double thin_share = 0.4, arc_share = 0.2;
/// An axis farther off the part's middle than this share of its radius is told.
constexpr double off_share = 0.01;

} // namespace

LathePath::LathePath(const LatheCommon& s, const PlanContext& context, double allowance, double cusp,
                     double chord, const Progress& progress) {
    progress.part(0, 0.01, "Looking at the part").set(0);
    field_ = std::make_unique<LatheField>(s, context, allowance, progress.part(0, 0.01));
    const LatheFrame& frame = field_->frame();
    const double part_radius = std::max(field_->part_radius(), tolerance::smallest_extent);
    range_ = lathe_range(s, *field_, context, progress.part(0.01, 0.02));
    const bool across_turns = s.pattern != LatheCommon::Pattern::lengthwise;
    const std::size_t steps = turn_steps(across_turns ? s.points_per_turn : NumberOrWord{0, "auto"},
                                         part_radius, arc_share * chord);

    std::function<double(double)> advance;
    std::optional<SideFeed> feed;
    base_.cusp_max = cusp; // motions take their share of it
    const double standing = standing_cusp(cusp, chord), aimed = s.aimed_share * standing;
    const auto look = [&](const Progress& part) {
        reach_ = lathe_reach(s, *field_, context, range_, standing, {across_turns, advance}, part);
    };
    const bool counted = !across_turns && s.points_per_turn.is_number();
    if (counted || s.side_feed.is_number()) {
        const double constant = counted ? 2 * pi / s.points_per_turn.number
                                : across_turns
                                    ? s.side_feed.number
                                    : 2 * pi / std::ceil(2 * pi * part_radius / s.side_feed.number);
        advance = [constant](double) { return constant; };
        feed.emplace(*field_, across_turns, range_.from, range_.to, aimed,
                     progress.part(0.02, 0.1, "Side feed"));
        const double level = feed->cusp_of(constant, progress.part(0.1, 0.2));
        look(progress.part(0.2, 0.3, "Looking for what stays uncut"));
        base_.cusp_max = std::max(level, reach_.crease_cusp) + chord;
        if (!(base_.cusp_max <= (1 + tolerance::uncut_margin) * (cusp + chord))) {
            base_.warnings.push_back(
                (counted ? format_number(s.points_per_turn.number) + " lines per turn leave "
                         : "the side feed of " + length_text(s.side_feed.number, context.unit) + " leaves ")
                + (base_.cusp_max < infinity ? "cusps of " + length_text(base_.cusp_max, context.unit)
                                             : "places uncut")
                + "; the tolerance allows " + length_text(cusp, context.unit));
        }
        if (base_.cusp_max == infinity) base_.cusp_max = std::max(field_->stock_radius(), part_radius);
    } else {
        feed.emplace(*field_, across_turns, range_.from, range_.to, aimed,
                     progress.part(0.02, 0.1, "Side feed"));
        feed->measure(progress.part(0.1, 0.2));
        if (feed->unsatisfied() > 0)
            base_.warnings.push_back(
                "at " + format_number(std::max(100 * feed->unsatisfied(), 0.01), 2)
                + " % of the places looked at even the smallest side feed leaves more than "
                + length_text(cusp, context.unit)
                + ": walls that face along the passes, or a cutter with a sharp corner");
        advance = [&feed](double at) { return feed->allowed(at); };
        look(progress.part(0.2, 0.3, "Looking for what stays uncut"));
        feed->limit(reach_.limits);
    }

    const LatheRoute route = lathe_route(s.pattern, range_, steps, advance, progress.part(0.3, 0.31));
    LineTolerance fine;
    fine.below = fine.above = s.look_share * chord;
    fine.spacing = safe_lathe_spacing(field_->cover().profile(), part_radius, fine.below);
    points_ = thinned(trace(*field_, route.places, fine, progress.part(0.31, 0.95, "Following the part")),
                      route.places, part_radius, thin_share * chord, thin_share * chord);
    progress.set(0.97);
    // The route's places are all among the points, in their order.
    std::size_t next = 0;
    for (std::size_t i = 0, place = 0; i < points_.size() && next < route.turns.size(); ++i) {
        const auto is = [&](std::size_t k) {
            return points_[i].place.angle == route.places[k].angle && points_[i].place.y == route.places[k].y;
        };
        while (place < route.places.size() && is(place)) {
            if (next < route.turns.size() && route.turns[next] == place) {
                turns_.push_back(i);
                ++next;
            }
            ++place;
        }
    }

    TurnedPath turned;
    turned.axis = frame.axis();
    turned.zero = frame.zero();
    turned.part_radius = field_->part_radius();
    turned.stock_radius = field_->stock_radius();
    turned.from = range_.from;
    turned.to = range_.to;
    turned.surface_area = reach_.area;
    turned.unreached = reach_.regions;
    turned.side_feed_max = route.feed_max;
    for (const LathePoint& p : points_)
        turned.at_core += p.held == LathePoint::HeldBy::core;
    base_.detail = turned;
    base_.drive_planes = int(turns_.size());
    const double length = across_turns ? 1 : part_radius;
    base_.stepover_min = route.feed_min * length;
    base_.stepover_max = route.feed_max * length;
    base_.chord_tolerance = chord;
    add_warnings(s, context);
    progress.set(1);
}

void throw_no_stock_above(const std::string& operation, double allowance, LengthUnit unit) {
    throw Error(ErrorCode::empty_result, operation,
                "nothing of the stock stands above the part and the allowance of "
                    + length_text(allowance, unit),
                "choose a smaller allowance, or a larger stock");
}

void LathePath::add_warnings(const LatheCommon& s, const PlanContext& context) {
    auto& warnings = base_.warnings;
    const LatheFrame& frame = field_->frame();
    const PlanText text{context.unit};
    const double off = frame.away(context.part_box.center());
    if (off > off_share * field_->part_radius())
        warnings.push_back("the part's middle lies " + text(off)
                           + " off the turning axis: it turns unbalanced, and its stock needs a diameter of "
                           + text(2 * field_->part_radius()) + " about the axis");
    if (field_->stock_radius() < field_->part_radius() * (1 - tolerance::same_shape))
        warnings.push_back("the stock does not hold the part as it turns: it reaches "
                           + text(field_->stock_radius()) + " from the axis, the part "
                           + text(field_->part_radius()) + ": take a stock of at least "
                           + text(2 * field_->part_radius()) + " in diameter");
    const std::size_t core = base_.as<TurnedPath>()->at_core;
    if (core == points_.size())
        throw Error(ErrorCode::empty_result, s.name,
                    "nothing of the part holds the tool on its way to the axis",
                    "check the axis, the core radius and where the path starts and stops");
    if (core > 0)
        warnings.push_back(
            "at " + std::to_string(core) + " of " + std::to_string(points_.size())
            + " places the tool meets nothing on its way to the axis and stops at the core radius of "
            + text(s.core_radius) + ": holes through the axis, or ends of the part that are cut down to it");
    if (range_.held_back > 0)
        warnings.push_back("chuck and tailstock keep the tool from " + text(range_.held_back)
                           + " of the part's length, which stays uncut");
    if (!s.direction.is("auto"))
        warnings.emplace_back("direction has no meaning for a part that turns: see pattern");
    if (turning_table(context.machine, frame.axis().direction) < 0)
        warnings.push_back(
            printable(context.machine.label)
            + " has no table that turns the part about this axis: choose a lathe-mill, or turn the part into "
              "its axis");
    const std::vector<std::string> uncut = reach_warnings(reach_, context.unit);
    warnings.insert(warnings.end(), uncut.begin(), uncut.end());
}

} // namespace facetmill
