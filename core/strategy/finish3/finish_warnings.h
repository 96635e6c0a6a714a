// What a plan of 3-axis finishing says of what it leaves.
#pragma once

#include "core/strategy/finish3/finish3.h"
#include "core/strategy/finish3/left_stock.h"
#include "core/strategy/finish3/pass_filter.h"
#include "core/strategy/finish3/uncut.h"
#include "core/strategy/plan/plan_text.h"

namespace facetmill {

struct FinishWarnings {
    const Finish3Settings& settings;
    const PlanContext& context;
    const UncutReport& uncut;
    const HeldOut& held;
    const ClearOfStock& beside_stock;
    double cusp_allowed; ///< mm
    int unsatisfied;     ///< lines beside places that no step-over serves
    int lines;           ///< all of them
};

/// "3 % of the surface". `area`: of the surface that the share is taken of, mm^2; so below.
std::string surface_share(const UncutPlaces& uncut, double area);
/// What is said of hollows that the cutter is too large for, and of what lies under the part itself.
std::string hollows_warning(const UncutPlaces& uncut, double area, const PlanText& text);
std::string covered_warning(const UncutPlaces& uncut, double area, const PlanText& text);

/// What is said of surface that only a tip below the lowest level would cut.
std::string below_warning(double below, double area);
/// What is said of passes that shank or holder keep from the part.
std::string held_up_warning(const HeldOut& held, const PlanText& text);
/// Adds what is said of surface that lies under the part itself, and of what shank, holder and what stands
/// keep passes from.
void add_kept_from_warnings(const UncutReport& uncut, double area, const PassFilter& filter,
                            const PlanContext& context, std::vector<std::string>& warnings);

/// Adds the warnings, and sets the largest cusp to what was measured.
void add_finish_warnings(const FinishWarnings& w, StrategyResult& result);

} // namespace facetmill
