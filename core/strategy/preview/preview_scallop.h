// Passes of constant scallop over a coarse ground: contours of the distance from where they begin, counted in
// steps. Millimetres, coordinates of the view.
#pragma once

#include "core/strategy/preview/preview_lines.h"
#include "core/strategy/scallop/scallop.h"

namespace facetmill {

/// Adds passes one step apart, on the slopes that the surface has; how it bends is not asked. Throws
/// Error(out_of_range) where the curve that they begin at lies off what is cut, Error(limit_exceeded) for
/// more passes than a plan may have.
void lay_scallops(const PreviewField& field, const ScallopSettings& settings, const PreviewRequest& request,
                  const PreviewStep& step, PassPreview& preview, const Progress& progress);

} // namespace facetmill
