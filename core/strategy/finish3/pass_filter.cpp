#include "core/strategy/finish3/pass_filter.h"

#include "core/strategy/surface/stock_before.h"

namespace facetmill {

namespace {

/// The size of the cells of the stock, in radii of the cutter: what stands only between the centres of cells
/// is not seen, so they are small beside it. The second where only the raw material is asked.
constexpr double rest_cell_share = 0.04, raw_cell_share = 0.1;

} // namespace

void PassFilter::leave_out_held_up(std::vector<Pass>& passes, const Progress& progress) {
    const HolderReach bodies(context_.contact, context_.tool, options_.allowance + options_.holder_clearance,
                             options_.chord);
    if (bodies.empty()) return;
    const double shortest = shortest_piece * profile_.max_radius();
    held_ = options_.tilt_limit > 0
                ? leave_out_untilted(passes,
                                     PassTilter(context_, {options_.tilt_limit, options_.allowance,
                                                           options_.holder_clearance, options_.chord}),
                                     bodies, shortest, contact_, progress)
                : leave_out_held(passes, bodies, shortest, contact_, progress);
    held_.tilt_limit = options_.tilt_limit;
    held_.has_ball = ball_radius(profile_) > 0;
    if (held_.kept.empty()) refuse_held(settings_.name, held_, context_);
    passes = std::move(held_.kept);
    held_.kept.clear();
}

/// Where raw material ends at the part's own height nothing is to be cut, but asked for.
bool PassFilter::all_over_raw(const std::vector<Pass>& passes) const {
    if (context_.stock.kind != StockSolid::Kind::box) return false;
    const Box3& box = context_.stock_box;
    Box3 tips;
    for (const Pass& p : passes)
        for (const CutterLocation& c : p.cl)
            tips.add(c.tip);
    const double r = profile_.max_radius();
    return (tips.lo.head<2>().array() >= box.lo.head<2>().array() - r).all()
           && (tips.hi.head<2>().array() <= box.hi.head<2>().array() + r).all()
           && tips.hi.z() <= box.hi.z() + settings_.tolerance;
}

void PassFilter::leave_out_air(std::vector<Pass>& passes, const Progress& progress) const {
    const bool rest = options_.rest_only;
    if (!rest && (context_.stock_box.empty() || all_over_raw(passes))) return;
    PlanContext raw = context_;
    if (!rest) raw.earlier.clear();
    const double cell = (rest ? rest_cell_share : raw_cell_share) * profile_.max_radius();
    const StockField field = stock_before(raw, cell, progress.part(0, 0.5));
    passes = facetmill::leave_out_air(passes, field, StockCutter(profile_),
                                      rest ? options_.cusp : -settings_.tolerance, profile_.max_radius(),
                                      contact_, progress.part(0.5, 1));
    if (!passes.empty()) return;
    if (rest) refuse_without_rest(settings_.name);
    refuse_beside_raw(settings_.name);
}

bool PassFilter::leave_out_beside_stock(std::vector<Pass>& passes, const Progress& progress) {
    if (options_.tilt_limit > 0) return false;
    auto clear = keep_clear_of_left_stock(passes, context_, profile_.max_radius(), settings_.tolerance,
                                          contact_, progress);
    if (!clear) return false;
    beside_stock_ = std::move(*clear);
    if (passes.empty()) refuse_beside_stock(settings_.name, beside_stock_, context_);
    held_.left.insert(held_.left.end(), beside_stock_.left.begin(), beside_stock_.left.end());
    return !beside_stock_.left.empty();
}

} // namespace facetmill
