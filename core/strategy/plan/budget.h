// How an operation's tolerance is shared out (Lu 3.13-3.15, see finish3.h). Millimetres.
#pragma once

#include "core/strategy/plan/operation.h"

#include <algorithm>

namespace facetmill {

/// What the part's tessellation leaves of a machining tolerance: the cusp that may stay. Throws
/// Error(out_of_range) when that is nothing.
double cusp_budget(const OperationCommon& settings, const PlanContext& context);
/// The chord tolerance that is used: as asked for or, for "auto", tolerance::auto_chord_share of the budget
/// and no more than tolerance::largest_auto_chord; at most half of the budget.
double chord_budget(const NumberOrWord& asked, double budget);
/// What of a cusp passes may leave between them: moves may run off the part by the chord tolerance.
inline double standing_cusp(double cusp, double chord) {
    return std::max(cusp - chord, 0.5 * cusp);
}
/// What makes no difference to a cusp of this height: paths that are only judged, not cut, are followed to
/// it, and a bottom that comes this near to a plane lies on it (CutterCover).
inline double cusp_detail(double cusp) {
    return 0.125 * cusp;
}

} // namespace facetmill
