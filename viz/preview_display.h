// The preview of passes (core/strategy/preview) made ready to be drawn.
#pragma once

#include "core/strategy/preview/pass_preview.h"
#include "viz/path_display.h"

#include <memory>

namespace facetmill {

struct PreviewDisplay {
    Vec3 center = Vec3::Zero();
    Polylines dashes;
};
using PreviewDisplayPtr = std::shared_ptr<const PreviewDisplay>;

PreviewDisplayPtr prepare_preview_display(const PassPreview& preview, const Progress& progress);

} // namespace facetmill
