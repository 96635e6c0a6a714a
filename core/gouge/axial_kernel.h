// The search for the highest lift, compiled once for every instruction set. Plain data in and out.
#pragma once

#include "core/gouge/prepared_blocks.h"
#include "core/gouge/surface_table.h"

namespace facetmill {

/// No facet, where one is named by block and lane.
inline constexpr std::uint32_t no_slot = 0xFFFFFFFFu;

/// One cutter over one place. Millimetres, part coordinates.
struct AxialQuery {
    double place[3] = {0, 0, 0}; ///< origin of the cutter's frame
    double frame[3][3] = {};     ///< rows: across, across, along the axis (upward); not read when upright
    /// What is known already, along the axis from `place`: the lift is wanted only if it is higher.
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

/// Answers one query: one kernel for an axis along Z, one for any axis.
using AxialKernel = void (*)(const IndexView&, const SurfaceTable&, const AxialQuery&, AxialAnswer&);
/// The answers for the places of a packet.
struct AxialPacketAnswer {
    double tips[AxialPacket::max_places];           ///< the same bits as one query for each
    std::uint32_t touched[AxialPacket::max_places]; ///< a facet that each place's cutter touches, or no_slot
};
using PacketKernel = void (*)(const IndexView&, const SurfaceTable&, const AxialPacket&, AxialPacketAnswer&);
/// Gives the highest lift over a polyline of `count` points (x, y, z each), any axis. It reads of the query
/// `place`, `frame`, `least`, `enough` (when a lift is surely higher, any such lift is the answer) and `hint`
/// (number of a segment); the answer's `slot` is the number of a segment, a good hint for the next. `least`
/// where nothing is higher; where no point is under the cutter that is nowhere.
using CurveKernel = void (*)(const SurfaceTable&, const AxialQuery&, const double* points,
                             std::uint32_t count, AxialAnswer&);
/// The kernels of one instruction set.
struct AxialKernels {
    AxialKernel upright, tilted;
    AxialKernel touch; ///< upright, over the facet `hint` alone
    PacketKernel packet;
    CurveKernel curve;
    int packet_places; ///< how many places a packet has room for
    const char* name;
};

/// The kernels for this processor. The environment variable FACETMILL_KERNEL=baseline chooses the slowest.
const AxialKernels& axial_kernels();
/// All kernels that this processor can run, the baseline first; all give the same bits. Returns their number.
int axial_kernel_sets(const AxialKernels* (&sets)[4]);

} // namespace facetmill
