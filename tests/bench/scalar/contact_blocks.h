// How the contact index lies in memory: facets in blocks of eight, coordinate by coordinate, under a tree
// with eight children a node. Every vertex and edge that can be touched is owned by one facet that has it, so
// that the leaf test of the facets meets each once.
#pragma once

#include "tests/bench/scalar/contact_index.h"

#include <cstdint>
#include <vector>

namespace facetmill::scalar {

inline constexpr std::size_t block_width = 8;

/// What a facet of a block has to test beside, as bits: vertex k is corner k, edge k runs from corner k to k
/// + 1.
enum FacetDuty : std::uint8_t {
    duty_vertex = 1, ///< << k
    duty_edge = 8,   ///< << k
    duty_plane = 64, ///< its projection along the axis has an area
};

/// Eight facets; corners turned so that edge 0 is the longest seen along the axis. Unused lanes have no duty.
struct alignas(64) FacetBlock {
    double x[3][block_width], y[3][block_width], z[3][block_width];
    Index facet[block_width];
    std::uint8_t duty[block_width];
    std::uint8_t turned[block_width]; ///< corner 0 of the block is this corner of the mesh's facet
};

/// Boxes of eight children, rounded outward. Unused lanes have zhi = -inf.
struct alignas(64) TreeNode {
    static constexpr Index leaf = 0x80000000u; ///< child is a block
    float xlo[block_width], xhi[block_width], ylo[block_width], yhi[block_width], zhi[block_width];
    Index child[block_width];
};

struct ContactIndex::Impl {
    std::vector<FacetBlock> blocks;
    std::vector<TreeNode> nodes;   ///< root first; empty for a mesh without facets
    double largest_coordinate = 0; ///< in x and y, of any corner
};

} // namespace facetmill::scalar
