// Regions of the part's surface (core/strategy/strip.h) ready to be drawn: translucent bands with their
// boundary curves, a colour each, a label.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/strategy/plan/strip.h"
#include "viz/palette.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace facetmill {

struct StripDisplay {
    struct One {
        std::string name,
            detail; ///< further text of the label: "Region 2 · 310 mm²", "needs a lead of up to 19° · tool 2"
        std::size_t color = 0; ///< see strip_color
        bool enabled = true;
        Vec3 label_at = Vec3::Zero();        ///< on the band, as near to its middle as there is any
        double area = 0;                     ///< mm^2
        std::vector<float> points;           ///< 3 each, relative to `centre`
        std::vector<std::int32_t> triangles; ///< 3 each
        std::vector<float> line_points;
        std::vector<std::int32_t> segments; ///< 2 each: boundaries, then centres
        std::vector<float> handles;         ///< points of the boundaries that can be dragged; 3 each
    };
    std::vector<One> strips;
    Vec3 center = Vec3::Zero();
    Box3 box;
};

using StripDisplayPtr = std::shared_ptr<const StripDisplay>;

/// Makes strips ready to be drawn, in the order of their list.
StripDisplayPtr prepare_strip_display(const std::vector<Strip>& strips, LengthUnit unit,
                                      const Progress& progress);

/// Colours that are told apart from each other, from those of paths and from the part's; they repeat. One
/// that is switched off is grey.
Rgb strip_color(std::size_t number, bool enabled, Palette palette);

} // namespace facetmill
