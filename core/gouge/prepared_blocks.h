// Blocks of facets as a packet of places asks them, in single precision: prepared once for a cutter with a
// vertical axis and kept, since neighbouring packets ask the same blocks again. Plain data (see
// contact_blocks.h).
#pragma once

#include "core/gouge/contact_blocks.h"

namespace facetmill {

/// The eight facets of a block. Positions are from the block's own origin, heights from that of the index.
/// `plane`: no lift over the facet's plane is higher, and where it touches inside, the lift is that; linear
/// in the place.
struct alignas(64) PreparedBlock {
    /// Edges from corner k.
    struct Edges {
        float ux[block_width], uy[block_width], run[block_width], slope[block_width];
        /// Where the plane touches: twice the area with the edge, positive inside; linear in the place.
        float side[block_width], side_x[block_width], side_y[block_width];
        float doubt[block_width]; ///< `side` is wrong by less
    };
    float x[3][block_width], y[3][block_width], z[3][block_width];
    float lo_x[block_width], hi_x[block_width], lo_y[block_width], hi_y[block_width], top[block_width];
    float turn[block_width]; ///< -1: its other side is up
    float contact_x[block_width], contact_y[block_width], contact_doubt[block_width];
    float slope_x[block_width], slope_y[block_width];
    float plane[block_width], plane_x[block_width], plane_y[block_width];
    float noise_in[block_width],
        noise_out[block_width]; ///< `plane` is wrong by less: touched inside, anywhere
    float noise_tangent[block_width];
    float loss[block_width];   ///< how much lower a lift a little inside of the rim is
    float corner[block_width]; ///< a side of more than this is inside
    float position[block_width], height_noise[block_width];
    Edges edge[3]; ///< when has_edges
    double origin[2];
    std::uint8_t duty[block_width];
    bool has_edges;
    bool is_fine; ///< its facets are small beside the cutter
};

/// The last blocks that were asked for; a block has one place where it can be.
struct PreparedBlocks {
    static constexpr std::uint32_t room = 256, nothing = 0xFFFFFFFFu;
    std::uint32_t block[room];
    PreparedBlock prepared[room];

    void clear() {
        for (std::uint32_t& b : block)
            b = nothing;
    }
};

} // namespace facetmill
