// Rework regions on the part's surface: what is to be cut again around uncut places (Wang 3.2-3.4). Wang
// draws two major curves per region through boundary points of its trajectories, and leaves ragged regions,
// rings and several regions on a trajectory to future work. Here a region is what lies within a distance of
// uncut places, measured on a finely divided copy of the part, smoothed, and widened again until it contains
// all of them; its pieces on the mesh are the regions, whatever their shape, and the borders of a piece are
// closed curves on the surface. The outward offset goes to all sides, along the trajectories too: it contains
// Wang's P_b.
#pragma once

#include "core/mesh/refine.h"
#include "core/strategy/plan/strip.h"
#include "core/strategy/surface/region_edit.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace facetmill {

/// A place of the surface that is to be cut again.
struct UncutPlace {
    Vec3 point, normal;
    double lead = 0; ///< that it needs, radians; +inf: more than was looked for
};

struct RegionInput {
    std::shared_ptr<const Mesh> part;
    std::shared_ptr<const MeshGeometry> geometry;
    std::shared_ptr<const std::vector<VertexCurvature>> curvatures; ///< at the part's vertices
    double spacing = 1; ///< between trajectories: gaps of uncut places up to this are closed; mm
    double offset = 0;  ///< outward, mm
    std::vector<RegionEdit> edits;
    std::vector<BoundaryDrag> drags;
};

/// A part of the surface as a mesh of its own, with what is known of its vertices.
struct PartPiece {
    MeshPtr mesh;
    std::shared_ptr<const MeshGeometry> geometry;
    std::shared_ptr<const std::vector<VertexCurvature>> curvatures;
};

struct ReworkRegion {
    Strip strip;               ///< its band, boundaries, area, enabled; name by place: "Region 1" ...
    double lead_largest = 0;   ///< that its uncut places need; +inf: more than was looked for
    double grow = 0;           ///< what its edit asks for
    Vec3 place = Vec3::Zero(); ///< an uncut place in it, by which edits name it
    /// Numbers of the edits that are about it, and one uncut place of each region that has grown together in
    /// it: an edit of all of it is one edit for each.
    std::vector<std::size_t> edits;
    std::vector<Vec3> places;
    std::size_t uncut = 0; ///< how many
};

struct ReworkRegions {
    std::vector<ReworkRegion> regions; ///< in the order of their smallest x, then y
    PartPiece within;                  ///< all regions that are enabled, offset included
    PartPiece outside;               ///< the part without the uncut places themselves, and without the offset
    double area = 0, uncut_area = 0; ///< of `within` and of what `outside` lacks, mm^2
    double part_area = 0;
};

/// Throws Error(limit_exceeded) for more than four million facets.
ReworkRegions rework_regions(const RegionInput& input, std::span<const UncutPlace> uncut,
                             const Progress& progress);

} // namespace facetmill
