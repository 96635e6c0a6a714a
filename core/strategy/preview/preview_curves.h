// Lines in the plane that operations along curves follow: spokes, turns of a spiral, blends of two curves,
// what runs beside a curve. Millimetres, coordinates of the view.
#pragma once

#include "core/strategy/curves/along_curve.h"
#include "core/strategy/curves/morph.h"
#include "core/strategy/curves/radial.h"
#include "core/strategy/preview/preview_lines.h"

namespace facetmill {

/// About a centre: outward ones, and the turns of a spiral, each a line of its own. Throw Error(out_of_range)
/// where the radii have nothing between them.
std::vector<PlanLine> spoke_lines(const RadialCommon& settings, const PreviewRequest& request,
                                  const PreviewField& field, const PreviewStep& step);
std::vector<PlanLine> turn_lines(const RadialCommon& settings, const PreviewRequest& request,
                                 const PreviewField& field, const PreviewStep& step,
                                 const Progress& progress);

/// From one curve to another. Throws Error(missing_reference) where only one is named, Error(out_of_range)
/// where they cross.
std::vector<PlanLine> blend_lines(const MorphSettings& settings, const PreviewRequest& request,
                                  const PreviewField& field, const PreviewStep& step,
                                  const Progress& progress);

/// The tip's course beside the curves, one for each. Throws Error(out_of_range) where they lie off the part,
/// Error(empty_result) where nothing runs so far beside them.
std::vector<PlanLine> beside_lines(const AlongCurveSettings& settings, const PreviewRequest& request,
                                   const CoarseTips& tips, const Progress& progress);
/// The tip all along a line, `rise` higher than the part asks for; beside the part as low as that goes.
void lay_everywhere(const CoarseTips& tips, const PlanLine& line, double rise,
                    std::vector<std::vector<Vec3>>& lines);

} // namespace facetmill
