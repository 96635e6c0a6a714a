// How the contact index lies in memory: facets in blocks of eight, coordinate by coordinate, under a tree
// with eight children a node. Every edge that can be touched is owned by one facet that has it. Plain data
// only: the kernels are compiled for several instruction sets and must share no inline code.
#pragma once

#include <cstddef>
#include <cstdint>

namespace facetmill {

namespace tolerance {
/// The slopes around a contact say where on the cutter it is. They are believed to within `slope_slack` (of a
/// slope) and `contact_slack` (of the cutter's radius): so much more than rounding that what is passed over
/// is lower by more than the last digits. And they are believed only around facets whose height is more than
/// `needle` of their longest edge and `smallest_facet` of the mesh's coordinates.
inline constexpr double slope_slack = 1e-4, contact_slack = 2e-3, needle = 1e-4, smallest_facet = 1e-7;
} // namespace tolerance

/// Facets in a block and children of a node: as many as a register of AVX2 has floats.
inline constexpr std::size_t block_width = 8;

/// What of a facet has to be tested, as bits. Edge k runs from corner k to k + 1, both ends included.
enum FacetDuty : std::uint8_t {
    duty_edge = 1,                             ///< << k: by a cutter that comes down along Z
    duty_edge_anyway = 8,                      ///< << k: by a cutter of any axis
    duty_plane = 64,                           ///< its projection along Z has an area
    duty_upright = 7 * duty_edge + duty_plane, ///< anything for a cutter that comes down along Z
};

/// Eight facets; corners turned so that edge 0 is the longest seen along Z. Unused lanes have no duty.
struct alignas(64) FacetBlock {
    double x[3][block_width], y[3][block_width], z[3][block_width];
    std::uint32_t facet[block_width];
    std::uint8_t duty[block_width];
    std::uint8_t turned[block_width]; ///< corner 0 of the block is this corner of the mesh's facet
};

/// Eight children: boxes, rounded outward, a roof over each and a slab about it. The roof, for a vertical
/// axis: no point of the child's facets is higher than the plane z = roof + slope_x (x - cx) + slope_y
/// (y - cy). The slab, for an axis from anywhere: for all of the facets' points q, and c = (cx, cy, cz),
/// -below <= normal . (q - c) <= above; the normal is a unit vector but for rounding, or zero where there is
/// none. Relative to the index's origin. Unused lanes have hx < 0. The slopes (dz/dx, dz/dy) around the
/// facets' vertices, for a vertical axis: see vertex_slopes.h. `highest`: of the facets' corners, in their
/// own digits, not relative to the origin. The strip, seen along Z: strip_lo <= across . (q - c) <= strip_hi
/// for all points; across lies, roughly, across long facets, and is a unit vector but for rounding.
struct alignas(64) TreeNode {
    static constexpr std::uint32_t leaf = 0x80000000u;       ///< child is a block
    float cx[block_width], cy[block_width], cz[block_width]; ///< middles
    float hx[block_width], hy[block_width], hz[block_width]; ///< half sizes
    float roof[block_width], slope_x[block_width], slope_y[block_width];
    std::uint32_t child[block_width];
    float slope_lo_x[block_width], slope_hi_x[block_width], slope_lo_y[block_width], slope_hi_y[block_width];
    float normal_x[block_width], normal_y[block_width], normal_z[block_width];
    float above[block_width], below[block_width];
    double highest[block_width];
    float across_x[block_width], across_y[block_width], strip_lo[block_width], strip_hi[block_width];
};

/// What the kernels see of an index.
struct IndexView {
    const FacetBlock* blocks = nullptr;
    const TreeNode* nodes = nullptr; ///< root first; null for a mesh without facets
    double origin[3] = {0, 0, 0};
    double half_size[3] = {0, 0, 0}; ///< of the mesh's box about the origin
    bool has_strips = false;         ///< strips say more than boxes: there are needles that lie askew
    bool mostly_needles = false;     ///< hardly anything else: places are best asked one by one
};

} // namespace facetmill
