// Axial lift: the lowest tip height at which a cutter with vertical axis over (x, y) does not cut into the mesh (Lu
// 3.5.4; Yau). Exact for every convex APT cutter against vertices, edges and facets: within tolerance::lift_accuracy of
// a brute-force reference. The mesh is a sheet of facets, either side of which may be up.
#pragma once

#include "core/gouge/contact_index.h"

#include <span>
#include <vector>

namespace facetmill {

/// Where the cutter would touch.
struct AxialContact {
    double tip_z = -infinity; ///< -inf: the cutter meets nothing on its way down
    Index facet = no_index;   ///< a facet it touches
    Vec3 point = Vec3::Zero(); ///< the touched point of the mesh
    enum class Feature { none, vertex, edge, facet } feature = Feature::none;
};

/// One cutter over one mesh. Cheap to make; safe to use from many threads at once.
class AxialLift {
public:
    /// `allowance` >= 0 keeps that distance along the cutter's surface normal: the cutter is used grown by it.
    AxialLift(ContactIndexPtr index, const CutterProfile& cutter, double allowance = 0);

    /// Tip height only.
    double tip_z(double x, double y) const;
    AxialContact contact(double x, double y) const;
    /// Tip heights for many points, in parallel; the same bits as `tip_z` one by one.
    void tip_z(std::span<const Vec2> points, std::span<double> heights, const Progress& progress) const;

    const CutterProfile& profile() const { return profile_; }

private:
    ContactIndexPtr index_;
    CutterProfile profile_;
    double allowance_;
};

} // namespace facetmill
