// What finishing with an upright tool leaves out of its passes, whatever course they take, and passes that
// are a part of an operation's. Millimetres, part coordinates.
#pragma once

#include "core/strategy/finish3/left_out.h"
#include "core/strategy/finish3/left_stock.h"
#include "core/strategy/tilt/tilted_passes.h"

#include <vector>

namespace facetmill {

class PassFilter {
public:
    struct Options {
        double cusp = 0;      ///< that may stay
        double allowance = 0; ///< stock left on the part, what its tessellation lacks included
        double chord = 0;     ///< of the path
        double holder_clearance = 0;
        double tilt_limit = 0; ///< above 0 the tool will be inclined where shank or holder would touch
        bool rest_only = false;
    };
    /// What is given has to live as long as this.
    PassFilter(const OperationCommon& settings, const PlanContext& context, const CutterProfile& profile,
               const Options& options, ContactAt contact)
        : settings_(settings), context_(context), profile_(profile), options_(options),
          contact_(std::move(contact)) {}

    // Each throws Error(empty_result) where nothing is left.

    /// Where shank or holder would come into the part, however the tool may be inclined.
    void leave_out_held_up(std::vector<Pass>& passes, const Progress& progress);
    /// What passes the raw material by; where only rest is asked for, what takes away less than the cusp of
    /// what stands.
    void leave_out_air(std::vector<Pass>& passes, const Progress& progress) const;
    /// Where shank or holder of an upright tool would come into what stands above the flutes. Follows the
    /// passes in the order in which they are cut. True where something was left out; it is `held().left` as
    /// well then.
    bool leave_out_beside_stock(std::vector<Pass>& passes, const Progress& progress);

    const HeldOut& held() const { return held_; } ///< `kept` is empty
    const ClearOfStock& beside_stock() const { return beside_stock_; }

private:
    bool all_over_raw(const std::vector<Pass>& passes) const;

    const OperationCommon& settings_;
    const PlanContext& context_;
    const CutterProfile& profile_;
    Options options_;
    ContactAt contact_;
    HeldOut held_;
    ClearOfStock beside_stock_;
};

/// Passes of an operation, or of a part of one, before it is asked what they leave.
struct PlannedPasses {
    StrategyResult path;
    HeldOut held;
    ClearOfStock beside_stock;
    double lowest_tip = -infinity;  ///< lower ones were not allowed
    int unsatisfied = 0, lines = 0; ///< lines beside places that no step serves; all of them
};

} // namespace facetmill
