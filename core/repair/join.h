// Scans that overlap, made one surface. Internal to the room.
#pragma once

#include "core/mesh/mesh.h"
#include "core/repair/deviation.h"
#include "core/repair/repair_step.h"

#include <vector>

namespace facetmill::detail {

/// A mesh that others are laid against, with its borders.
class ScanGround {
public:
    /// The mesh must outlive this.
    ScanGround(const Mesh& mesh, double reach, const Progress& progress);

    /// The place of the mesh that is nearest to p, where that is within reach, not on a border, and its facet
    /// looks the same way as `normal` (any length); else without a facet.
    DeviationIndex::Place place(const Vec3& p, const Vec3& normal) const;
    /// Vertices on borders: the vertex that follows in the hole beyond the border; no_index elsewhere, and
    /// where several borders meet.
    const std::vector<Index>& next() const { return next_; }
    Vec3 normal(Index facet) const { return mesh_.facet_normal(facet); }

private:
    const Mesh& mesh_;
    double reach_;
    DeviationIndex index_;
    std::vector<char> open_sides_; ///< per facet, bit k: no facet beyond the side from its corner k
    std::vector<Index> next_;
};

/// For each vertex of a border the one that follows in the hole beyond; no_index elsewhere and where several
/// borders meet. `open_sides` as in ScanGround; null: not wanted.
std::vector<Index> border_courses(const Mesh& mesh, std::vector<char>* open_sides, const Progress& progress);

/// Moves `scan` as a rigid body to where it lies best on the ground (points to planes: Chen, Medioni 1992),
/// and says how far the farthest vertex went. Vertices that have no place on the ground say nothing.
double lay_on(const ScanGround& ground, Mesh& scan, const Progress& progress);

/// Facets between the border of a scan that was cut, `cut` (for each vertex the next one on the cut, in the
/// hole; no_index elsewhere), and the border of the ground, `border` (likewise). Vertices are those of
/// `mesh`, which holds both. `unjoined` counts stretches of the cut that lie beside no border.
std::vector<Facet> seam_facets(const Mesh& mesh, const std::vector<Index>& cut,
                               const std::vector<Index>& border, double reach, std::size_t& unjoined,
                               const Progress& progress);

/// The mesh stays as it is; of `other` goes what overlaps it, and the seam is closed. `reach`: how far apart
/// two scans of the same surface may lie.
StepResult join_scans(const Mesh& mesh, Mesh other, const RepairStep& step, const Progress& progress);

} // namespace facetmill::detail
