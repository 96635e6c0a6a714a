#include "core/strategy/finish3/finish_warnings.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace facetmill {

namespace {

std::string held_warning(const FinishWarnings& w) {
    const PlanText text{w.context.unit, w.context.to_setup};
    const Tool& tool = w.context.tool;
    const double flutes = tool.flute_length, out = tool.flute_length + tool.shank_length;
    const std::string more_flutes = text(flutes + w.held.lack.shank),
                      more_out = text(out + w.held.lack.holder);
    const std::string longer =
        !(w.held.lack.shank > 0) ? "a stick-out of " + more_out + " below the holder instead of " + text(out)
        : w.held.lack.holder > 0
            ? "flutes of " + more_flutes + " instead of " + text(flutes) + " and a stick-out of " + more_out
                  + " below the holder instead of " + text(out)
            : "flutes of " + more_flutes + " instead of " + text(flutes);
    const UncutPlaces& u = w.uncut.held;
    return "the tool is short: shank or holder would come into the part, so "
           + share_text(w.held.left_length, w.held.length) + " of the passes are left out"
           + (u.height > 0
                  ? " and " + share_text(u.area, w.uncut.area) + " of the surface stays uncut by up to "
                        + text(u.height) + ", most at " + text(u.at)
                  : "")
           + ": " + longer + " would reach it" + held_alternative(w.held);
}

} // namespace

std::string surface_share(const UncutPlaces& uncut, double area) {
    return share_text(uncut.area, area) + " of the surface";
}

std::string hollows_warning(const UncutPlaces& uncut, double area, const PlanText& text) {
    return "the cutter is too large for hollows of the part: " + surface_share(uncut, area)
           + " stays uncut by up to " + text(uncut.height) + ", most at " + text(uncut.at)
           + ": use a smaller tool there";
}

std::string covered_warning(const UncutPlaces& uncut, double area, const PlanText& text) {
    return surface_share(uncut, area) + " that faces up lies under the part itself, as at " + text(uncut.at)
           + ", and is not cut: turn the part for another operation";
}

std::string below_warning(double below, double area) {
    return share_text(below, area)
           + " of the surface would only be cut by a tip below the lowest level: allow it by "
             "'Below the bottom', where nothing holds the stock there";
}

std::string held_up_warning(const HeldOut& held, const PlanText& text) {
    return "the tool is short: shank or holder would come into the part, so "
           + share_text(held.left_length, held.length) + " of the passes are left out: a tool that is "
           + text(std::max(held.lack.shank, held.lack.holder)) + " longer would reach it"
           + held_alternative(held);
}

void add_kept_from_warnings(const UncutReport& uncut, double area, const PassFilter& filter,
                            const PlanContext& context, std::vector<std::string>& warnings) {
    const PlanText text{context.unit, context.to_setup};
    if (uncut.covered.height > 0) warnings.push_back(covered_warning(uncut.covered, area, text));
    if (filter.held().left_length > 0) warnings.push_back(held_up_warning(filter.held(), text));
    if (filter.beside_stock().left_length > 0)
        warnings.push_back(beside_stock_warning(filter.beside_stock(), context));
}

void add_finish_warnings(const FinishWarnings& w, StrategyResult& result) {
    const PlanText text{w.context.unit, w.context.to_setup};
    auto& warnings = result.warnings;
    const bool uncut = result.cusp_max == infinity;
    // What was measured where the cutter could have gone is as good as what was expected.
    const double expected = std::max(result.cusp_max, w.cusp_allowed);
    result.cusp_max = std::max(result.cusp_max, w.uncut.passed_by.height);
    // Where a pass misses the part altogether, the stock stays as high as it was.
    if (uncut)
        result.cusp_max = std::max({w.context.stock_box.hi.z() - w.context.part_box.lo.z(),
                                    w.context.part_box.size().z(), w.cusp_allowed});
    if (w.settings.stepover.is_number() && result.cusp_max > w.cusp_allowed)
        warnings.push_back("the step-over of " + text(w.settings.stepover.number) + " leaves "
                           + (uncut ? std::string("places uncut") : "cusps of " + text(result.cusp_max))
                           + "; the tolerance allows " + text(w.cusp_allowed));
    if (w.unsatisfied > 0)
        warnings.push_back(
            std::to_string(w.unsatisfied) + " of " + std::to_string(w.lines)
            + " drive planes cross places so steep that no step-over meets the tolerance: cusps of "
            + text(result.cusp_max) + " stay there, " + text(w.cusp_allowed) + " are allowed");
    if (w.uncut.out_of_reach.height > 0)
        warnings.push_back(hollows_warning(w.uncut.out_of_reach, w.uncut.area, text));
    if (const UncutPlaces& u = w.uncut.passed_by; u.height > (1 + tolerance::uncut_margin) * expected)
        warnings.push_back("the passes leave more than expected: " + surface_share(u, w.uncut.area)
                           + " stays uncut by up to " + text(u.height) + ", most at " + text(u.at)
                           + ": choose a smaller step-over or another direction");
    if (w.uncut.covered.height > 0) warnings.push_back(covered_warning(w.uncut.covered, w.uncut.area, text));

    if (w.held.left_length > 0) warnings.push_back(held_warning(w));
    if (w.beside_stock.left_length > 0) warnings.push_back(beside_stock_warning(w.beside_stock, w.context));
}

} // namespace facetmill
