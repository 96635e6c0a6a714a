#include "core/strategy/plan/budget.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

double cusp_budget(const OperationCommon& settings, const PlanContext& context) {
    const auto [out, in] = context.tessellation_tolerance;
    if (!(out >= 0 && in >= 0 && std::isfinite(out) && std::isfinite(in)))
        throw Error(ErrorCode::out_of_range, "tessellation_tolerance",
                    "the tessellation tolerances are not lengths of 0 or more",
                    "correct them in the part's settings");
    const double budget = settings.tolerance - out - in;
    if (!(budget > 0))
        throw Error(ErrorCode::out_of_range, "tolerance",
                    "the tessellation tolerances (outward " + length_text(out, context.unit) + ", inward "
                        + length_text(in, context.unit) + ") use up the machining tolerance of "
                        + length_text(settings.tolerance, context.unit),
                    "allow a larger tolerance or tessellate the part more finely");
    return budget;
}

double chord_budget(const NumberOrWord& asked, double budget) {
    const double chord = asked.is_number()
                             ? asked.number
                             : std::min(tolerance::auto_chord_share * budget, tolerance::largest_auto_chord);
    return std::max(std::min(chord, 0.5 * budget), tolerance::smallest_chord);
}

} // namespace facetmill
