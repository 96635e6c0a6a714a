// The convex hull of points, for whatever asks how a part can lie: its faces are those a flat table touches.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace facetmill {

struct ConvexHull {
    /// How many directions the points spread in: 3 for a body, 2 for a flat shape, 1 for a line, 0.
    int dimension = 0;
    /// A body's. Corners are points by number, counter-clockwise seen from outside. Closed.
    std::vector<Facet> facets;
    /// A flat shape's corners by number, counter-clockwise about `normal`.
    std::vector<Index> outline;
    Vec3 normal = Vec3::Zero();
};

/// By quickhull (Barber, Dobkin, Huhdanpaa 1996): about n log n. Points may coincide, lie on lines and in
/// planes; they are finite.
ConvexHull convex_hull(const std::vector<Vec3>& points, const Progress& progress);

/// Corners of the convex outline of points in a plane, by number, counter-clockwise, none on a straight side.
std::vector<Index> convex_outline(const std::vector<Vec2>& points);

} // namespace facetmill
