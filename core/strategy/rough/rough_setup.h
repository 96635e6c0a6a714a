// What a plan of roughing is measured by, chosen before anything is cut: margins, step-over, the stock as it
// stands and the heights of the layers. Millimetres.
#pragma once

#include "core/strategy/rough/rough.h"
#include "core/strategy/rough/rough_layers.h"
#include "core/strategy/surface/stock_field.h"

namespace facetmill {

/// What follows from the tool and the settings alone.
struct RoughMeasures {
    /// Throws Error(out_of_range) for step-over and depth as Rough::plan does.
    RoughMeasures(const RoughSettings& settings, const PlanContext& context);

    CutterProfile profile;
    /// Where the cutter is widest; of a tapered one at its end: above it is wider, and cuts less deep there.
    double diameter;
    double budget;    ///< all that may stay above the allowance
    double allowance; ///< kept from the part, its inner tessellation tolerance included
    double margin;    ///< what tips keep from the exact surface
    double min_work;  ///< height below which there is nothing to take away
    double stepover;
};

/// The stock as it stands before the operation. Throws Error(empty_result) where none stands above the part's
/// lowest place.
StockField rough_stock(const RoughSettings& settings, const PlanContext& context,
                       const RoughMeasures& measures, const Progress& progress);

/// Layers, and how close lines stand on the floors that they leave.
struct RoughHeights {
    /// Throws Error(out_of_range) where no lines of the tool keep to the tolerance.
    RoughHeights(const RoughSettings& settings, const PlanContext& context, const RoughMeasures& measures,
                 const StockField& field, const Progress& progress);

    double low;        ///< height of the lowest tip
    int divisions = 1; ///< lines on floors are so many times closer than others
    Layers layers;
    /// What is expected to stay above the allowance, on the slopes that the part has.
    double expected;
};

} // namespace facetmill
