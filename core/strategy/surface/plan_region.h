// A region of the plane as the union of what closed loops go round: covered or not, and how far from the
// border. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/mesh.h"

#include <array>
#include <span>
#include <vector>

namespace facetmill {

/// The third coordinate of the cross product of two vectors in the plane.
inline double plane_cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// From its first place to its second.
using PlanEdge = std::array<Vec2, 2>;

/// The edges that go round facets of a mesh, looked at along Z: counter-clockwise round those that face up,
/// and round those that face down as if they faced up. Upright ones have no area there.
std::vector<PlanEdge> outline_edges(const Mesh& mesh, std::span<const char> facets, const Progress& progress);

class PlanRegion {
public:
    PlanRegion() = default;
    /// The edges make up closed loops; what they go round any number of times but none is covered. Where
    /// loops cross or run over one another, only what has something uncovered beside it is border.
    PlanRegion(std::vector<PlanEdge> edges, const Progress& progress);

    bool empty() const { return edges_.empty(); }
    bool covers(const Vec2& p) const;
    /// Distance from the border, below 0 where p is not covered; -infinity where nothing is.
    double depth(const Vec2& p) const;
    const std::vector<PlanEdge>& border() const { return border_; }

private:
    std::vector<PlanEdge> edges_, border_;
    std::vector<char> left_covered_; ///< which side of each piece of the border is
    double same_ = 0;                ///< places nearer to each other are the same
    BoxTree edge_tree_, border_tree_;
};

} // namespace facetmill
