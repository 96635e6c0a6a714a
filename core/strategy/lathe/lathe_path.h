// What roughing and finishing on a turning part share: field, range, side feed, the traced path, and what is
// said about them.
#pragma once

#include "core/strategy/lathe/lathe_reach.h"

#include <memory>
#include <optional>

namespace facetmill {

class LathePath {
public:
    /// `cusp`: what the side feed may leave; `chord`: of motions, to either side. `allowance`: kept from the
    /// part, its inner tessellation tolerance included. Throws what the parts of it throw.
    LathePath(const LatheCommon& settings, const PlanContext& context, double allowance, double cusp,
              double chord, const Progress& progress);

    const LatheField& field() const { return *field_; }
    /// In machining order; motions between them are within the chord tolerance.
    const std::vector<LathePoint>& points() const { return points_; }
    /// Where each turn (ring, line) begins in `points`.
    const std::vector<std::size_t>& turns() const { return turns_; }
    /// Figures and warnings, without passes.
    const StrategyResult& base() const { return base_; }
    /// What the cutter cannot come to; in the figures, but not among the warnings.
    const LatheReach& reach() const { return reach_; }
    CutterLocation location(std::size_t i, double u) const { return field_->frame().at(points_[i].place, u); }

private:
    void add_warnings(const LatheCommon& settings, const PlanContext& context);

    std::unique_ptr<LatheField> field_;
    LatheRange range_;
    LatheReach reach_;
    std::vector<LathePoint> points_;
    std::vector<std::size_t> turns_;
    StrategyResult base_;
};

/// Throws Error(empty_result): the operation's allowance takes all that stands of the stock.
[[noreturn]] void throw_no_stock_above(const std::string& operation, double allowance, LengthUnit unit);

} // namespace facetmill
