// The search for the highest lift, compiled once for every instruction set. Plain data in and out.
#pragma once

#include "core/gouge/prepared_blocks.h"
#include "core/gouge/surface_table.h"

namespace facetmill {

inline constexpr std::uint32_t no_slot = 0xFFFFFFFFu;

/// One cutter over one place.
struct AxialQuery {
    double place[3] = {0, 0, 0}; ///< origin of the cutter's frame
    double frame[3][3] = {};     ///< rows: across, across, along the axis (upward); not read when upright
    /// What is known: the lift is wanted only if it is higher. Along the axis from `place`.
    double least = -__builtin_inf();
    /// The search ends as soon as it is sure that something is higher than this; then the answer's tip is
    /// between this and the lift, its slot that of a facet that reaches higher,
    /// and its other members may say nothing.
    double enough = __builtin_inf();
    /// Where the search starts instead of the root: nodes whose children together are all that matters at
    /// `place`.
    const TreeNode* cut = nullptr;
    int cut_nodes = 0;
    std::uint32_t hint = no_slot; ///< a facet that is likely to be touched; never changes the height
};

struct AxialAnswer {
    double tip;                   ///< along the axis from `place`; query.least when nothing is higher
    std::uint32_t slot = no_slot; ///< block * block_width + lane of the touched facet
    int edge = -1;                ///< touched edge of the block's facet; -1: its inside
    double point[3] = {0, 0, 0};  ///< touched point, in the cutter's frame
};

/// One cutter with its axis along Z over places that lie no farther from each other than its radius.
struct AxialPacket {
    static constexpr int max_places = 16; ///< of any kernel; AxialKernels says how many one takes
    double x[max_places], y[max_places];
    int count = 0;
    const TreeNode* cut = nullptr; ///< as for AxialQuery; wanted
    int cut_nodes = 0;
    PreparedBlocks* prepared = nullptr; ///< of this index and surface only, or cleared; wanted
};

/// Axis along Z, and any axis.
using AxialKernel = void (*)(const IndexView&, const SurfaceTable&, const AxialQuery&, AxialAnswer&);
/// The tips over the places of a packet, the bits that one query each would give.
using PacketKernel = void (*)(const IndexView&, const SurfaceTable&, const AxialPacket&,
                              double (&tips)[AxialPacket::max_places]);
/// The highest lift over a polyline of `count` points (x, y, z each), any axis. Of the query the place and
/// frame are read, `enough` (when a lift is surely higher, any such lift is the answer) and `hint` (number of
/// a segment); the answer's `slot` is that of the segment. -inf and no_slot where no point is under the
/// cutter.
using CurveKernel = void (*)(const SurfaceTable&, const AxialQuery&, const double* points,
                             std::uint32_t count, AxialAnswer&);
struct AxialKernels {
    AxialKernel upright, tilted;
    PacketKernel packet;
    CurveKernel curve;
    int packet_places; ///< a packet has room for
    const char* name;
};

/// Those for this processor. The environment variable FACETMILL_KERNEL=baseline chooses the slowest.
const AxialKernels& axial_kernels();
/// All that this processor can run, the baseline first; all give the same bits.
int axial_kernel_sets(const AxialKernels* (&sets)[4]);

} // namespace facetmill
