// Curves over a field: lines along what of them may be cut, and distances that begin there. Millimetres.
#pragma once

#include "core/strategy/plan/operation.h"
#include "core/strategy/scallop/field_contours.h"
#include "core/strategy/scallop/scallop_field.h"

#include <span>

namespace facetmill {

struct CurveFront {
    std::vector<FieldContour> lines; ///< of value 0
    std::vector<ScallopField::Seed> seeds;
};

/// `open`: no curve goes on from its last place to the first.
CurveFront curve_front(const ScallopField& field, std::span<const PlanCurve> curves, bool open,
                       const Progress& progress);

} // namespace facetmill
