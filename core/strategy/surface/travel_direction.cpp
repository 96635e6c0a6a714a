#include "core/strategy/surface/travel_direction.h"

#include "core/base/tolerances.h"
#include "core/strategy/surface/drive_frame.h"
#include "core/strategy/surface/slice.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Drive planes whose normals are compared, in each direction.
constexpr int direction_planes = 7;

double normal_change(const PlanContext& context, const MeshGeometry& geometry, const DriveFrame& frame,
                     const Progress& progress) {
    const MeshSlicer slicer(*context.part, geometry, frame, progress);
    const double shortest = tolerance::vanishing_step * context.part_box.diagonal();
    double sum = 0;
    std::size_t count = 0;
    for (int i = 0; i < direction_planes; ++i) {
        progress.check();
        const double v = slicer.lo() + (slicer.hi() - slicer.lo()) * (i + 0.5) / direction_planes;
        for (const SliceChain& chain : slicer.slice(v))
            add_normal_change(chain, shortest, sum, count);
    }
    return count > 0 ? std::sqrt(sum / double(count)) : 0;
}

} // namespace

double travel_direction(const NumberOrWord& asked, const PlanContext& context, const Progress& progress) {
    if (asked.is_number()) return asked.number;
    if (asked.is("x")) return 0;
    if (asked.is("y")) return 0.5 * pi;
    std::shared_ptr<const MeshGeometry> geometry = context.geometry;
    if (!geometry) geometry = compute_geometry(*context.part, progress.part(0, 0.3));
    const double x = normal_change(context, *geometry, DriveFrame(0), progress.part(0.3, 0.6));
    const double y = normal_change(context, *geometry, DriveFrame(0.5 * pi), progress.part(0.6, 1));
    if (std::abs(x - y) <= tolerance::like_normal_change * std::max(x, y))
        return context.part_box.size().y() > context.part_box.size().x() ? 0.5 * pi : 0;
    return x <= y ? 0 : 0.5 * pi;
}

} // namespace facetmill
