// Which tool and which lead limit suit a part (Wang 2.2, 2.4): formulas (1), (2), (3), (7), and an estimate
// of what main path and rework take, from the contacts of an assumed previous path. Wang leaves the balance
// to the programmer and to future work. The estimate is good for comparing choices; the plan says what they
// really take.
//
// The assumed path tells the least lead of every contact for its own tool; by (4) that stands for a
// curvature, and so for the lead of any other diameter. A strip is as wide as the scallop allows between the
// tool's section across the travel, of curvature 2 sin(lead) / D, and the part's; never wider than the tool.
// Where strips are narrow the main path has partial passes, so each place costs its area over its width.
#pragma once

#include "core/strategy/global_local/global_local.h"

#include <vector>

namespace facetmill {

/// (1), (7): the largest diameter that matches a curvature (1/mm) with this lead; +inf for a plane.
double largest_diameter(double lead, double curvature);
/// (3): the lead at which a diameter matches a curvature; a right angle where none does.
double lead_for(double diameter, double curvature);
/// (2): the widest strip on a round place (radius of curvature across the travel, mm); a larger tool cuts no
/// wider one.
double widest_strip(double radius_of_curvature, double scallop);

struct StrategyEstimate {
    double diameter = 0, lead_limit = 0;
    double main_seconds = 0, rework_seconds = 0;
    std::size_t regions = 0;
    double rework_share = 0; ///< share of the surface that is reworked
    double seconds() const { return main_seconds + rework_seconds; }
};

/// `diameter`: the main tool's, a flat end; the source may be another tool's. `rework_diameter`: a ball's.
/// `feed` mm/min, `scallop` mm. Takes some milliseconds.
StrategyEstimate estimate(const RegionSource& source, double source_diameter, double diameter,
                          double lead_limit, double rework_diameter, double scallop, double feed);

struct ToolAdvice {
    /// Curvatures of the hollow places, weighted by area: the largest, what all but 5 % and half keep within.
    double curvature_largest = 0, curvature_max = 0, curvature_half = 0;
    double diameter = 0;     ///< (1) for the lead limit and all but 5 % of the hollow places; +inf: any
    double strip_convex = 0; ///< (2) at half of the round places; +inf: there are none
    std::vector<StrategyEstimate> by_lead;     ///< for the main tool, ascending lead limits
    std::vector<StrategyEstimate> by_diameter; ///< for the lead limit, ascending
    StrategyEstimate best;                     ///< the pair of the two that takes least time
};

/// Estimates over lead limits from one degree to the assumed limit and diameters around the tool's own.
ToolAdvice tool_advice(const RegionSource& source, double diameter, const GlobalLocalSettings& settings,
                       double rework_diameter, const Progress& progress);

} // namespace facetmill
