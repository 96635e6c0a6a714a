// The uncut stock as it is drawn: transparent faces and the lines of its edges.
#pragma once

#include "core/base/progress.h"
#include "core/verify/program.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace facetmill {

/// Positions are relative to `centre`, mm.
struct StockShape {
    Box3 box;
    Vec3 center = Vec3::Zero();
    std::vector<float> points;           ///< 3 per vertex
    std::vector<std::int32_t> triangles; ///< 3 per triangle
    std::vector<std::int32_t> segments;  ///< 2 per line
};
using StockShapePtr = std::shared_ptr<const StockShape>;

/// Null where the solid's box is empty. Boxes and cylinders take microseconds; of a mesh, the edges that
/// prepare_part_display finds sharp, cancellation as there.
StockShapePtr make_stock_shape(const StockSolid& solid, const Progress& progress);

} // namespace facetmill
