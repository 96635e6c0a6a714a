// Body of axial_kernel_*.cpp: the places of a packet (axial_packet_impl.h), and pairs of a place and a facet
// that may be its highest. Edges of pairs wait until they fill the lanes, pairs until the exact test is worth
// while.
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_facet_test.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/axial_prepared_impl.h"

namespace facetmill::simd {

namespace {

/// The places of a packet, and what is known of the lifts over them.
template <SurfaceShape shape>
struct PacketPlaces : PreparedBounds<shape> {
    using Base = PreparedBounds<shape>;
    using Base::index, Base::surface, Base::margin;

    const AxialPacket& packet;
    double* tips; ///< the answers, as far as they are known
    std::uint32_t* touched_slots;

    alignas(64) double place_x[place_lanes], place_y[place_lanes];
    PlaceFloats dx, dy;                               ///< the places from the first
    float lo_dx = 0, hi_dx = 0, lo_dy = 0, hi_dy = 0; ///< their least and largest
    PlaceFloats least;                                ///< no more than the answers, from `zero`
    PlaceFloats floor;                                ///< stands for `least` where nothing is known yet

    /// The places of the packet, from the origin of the block that is asked.
    struct Places {
        PlaceFloats x, y;
    };

    FACETMILL_MEMBER PacketPlaces(const IndexView& i, const SurfaceTable& s, const AxialPacket& p,
                                  const AxialQuery& first, AxialPacketAnswer& answer)
        : PreparedBounds<shape>(i, s, first), packet(p), tips(answer.tips), touched_slots(answer.touched) {
        float x[place_lanes], y[place_lanes];
        for (int k = 0; k < place_lanes; ++k) {
            const int place = k < packet.count ? k : 0;
            place_x[k] = packet.x[place];
            place_y[k] = packet.y[place];
            x[k] = float(place_x[k] - first.place[0]);
            y[k] = float(place_y[k] - first.place[1]);
            tips[k] = no_lift;
            touched_slots[k] = no_slot;
        }
        dx = load_places(x);
        dy = load_places(y);
        for (int k = 0; k < place_lanes; ++k) {
            lo_dx = k == 0 || x[k] < lo_dx ? x[k] : lo_dx;
            hi_dx = k == 0 || x[k] > hi_dx ? x[k] : hi_dx;
            lo_dy = k == 0 || y[k] < lo_dy ? y[k] : lo_dy;
            hi_dy = k == 0 || y[k] > hi_dy ? y[k] : hi_dy;
        }
        // Sums at the other places are larger by the distances to them and to their reach.
        margin += float(tolerance::float_slack * 80 * surface.max_radius);
        // Nothing is higher than what lanes without a place ask for.
        float none[place_lanes];
        for (int k = 0; k < place_lanes; ++k)
            none[k] = k < packet.count ? -__builtin_inff() : __builtin_inff();
        least = load_places(none);
        floor = all_of<PlaceFloats>(float(-2 * (index.half_size[2] + surface.max_radius) - 1));
    }

    FACETMILL_MEMBER void raise(int place, float low) {
        if (low > lane(least, place)) set_lane(least, place, low);
    }

    FACETMILL_MEMBER static std::uint32_t room_of(std::uint32_t which) {
        return which % PreparedBlocks::room;
    }

    /// Asks the memory for what will most likely be opened.
    FACETMILL_MEMBER void fetch(std::uint32_t which) const {
        const auto from = [](const auto& what) __attribute__((always_inline)) {
            for (std::size_t i = 0; i < sizeof what; i += 64)
                __builtin_prefetch(reinterpret_cast<const char*>(&what) + i);
        };
        const std::uint32_t block = which & ~TreeNode::leaf;
        if (!(which & TreeNode::leaf))
            from(index.nodes[which]);
        else if (packet.prepared->block[room_of(block)] != block)
            from(index.blocks[block]);
    }
};

/// Pairs of a place and a facet that may be its highest.
template <SurfaceShape shape>
struct PacketPairs : PacketPlaces<shape> {
    using Base = PacketPlaces<shape>;
    using Base::edge_bounds, Base::rounded_down, Base::raise;
    using Base::index, Base::surface, Base::zero, Base::packet, Base::tips, Base::touched_slots, Base::least;
    using typename Base::Places;
    template <class F>
    using EdgeLanes = typename Base::template EdgeLanes<F>;

    static constexpr int max_pairs = 24 * place_lanes;
    std::uint32_t pair_slot[max_pairs];
    int pair_place[max_pairs];
    float pair_bound[max_pairs];
    int pairs = 0;

    // Edges of pairs that have still to say what they ask for.
    alignas(64) float queued[10][place_lanes] = {}, queued_cap[place_lanes];
    int queued_pair[place_lanes];
    int edges = 0;

    FacetTest tested;
    int tested_place[double_lanes];
    std::uint32_t tested_slot[double_lanes];
    int taken = 0;

    FACETMILL_MEMBER PacketPairs(const IndexView& i, const SurfaceTable& s, const AxialPacket& p,
                                 const AxialQuery& first, AxialPacketAnswer& answer)
        : PacketPlaces<shape>(i, s, p, first, answer) {}

    /// A facet that may be the highest at a place: its lift is no more than `bound` or what its edges that
    /// are asked (bits) turn out to allow, and no more than `cap`.
    FACETMILL_CALLED void add(const PreparedBlock& f, std::uint32_t which, int facet, const Places& p,
                              int place, float bound, unsigned edges_asked, float cap) {
        if (!(cap > lane(least, place))) return;
        if (pairs == max_pairs) make_room();
        pair_slot[pairs] = which * std::uint32_t(block_width) + std::uint32_t(facet);
        pair_place[pairs] = place;
        pair_bound[pairs] = bound;
        const int pair = pairs++;
        for (; edges_asked != 0; edges_asked &= edges_asked - 1) {
            const int e = __builtin_ctz(edges_asked);
            const PreparedBlock::Edges& edge = f.edge[e];
            const float member[] = {f.x[e][facet] - lane(p.x, place),
                                    f.y[e][facet] - lane(p.y, place),
                                    f.z[e][facet],
                                    edge.ux[facet],
                                    edge.uy[facet],
                                    edge.run[facet],
                                    edge.slope[facet],
                                    f.position[facet],
                                    f.height_noise[facet],
                                    f.top[facet]};
            for (int i = 0; i < 10; ++i)
                queued[i][edges] = member[i];
            queued_cap[edges] = cap;
            queued_pair[edges] = pair;
            if (++edges == place_lanes) ask_edges();
        }
    }

    /// The edges that are queued, for all their pairs at a time.
    FACETMILL_CALLED void ask_edges() {
        if (edges == 0) return;
        const auto of = [&](int i) __attribute__((always_inline)) {
            return load_places(queued[i]);
        };
        const EdgeLanes<PlaceFloats> lanes{of(0), of(1), of(2), of(3), of(4),
                                           of(5), of(6), of(7), of(8), of(9)};
        PlaceFloats above, below;
        edge_bounds(lanes, above, below);
        for (int i = 0; i < edges; ++i) {
            const int pair = queued_pair[i];
            const float most = lane(above, i), bound = most < queued_cap[i] ? most : queued_cap[i];
            if (bound > pair_bound[pair]) pair_bound[pair] = bound;
            raise(pair_place[pair], lane(below, i));
        }
        edges = 0;
    }

    /// Lets go of pairs that are not as high as others turned out to be.
    FACETMILL_MEMBER void thin_out() {
        ask_edges();
        alignas(64) float low[place_lanes];
        store(least, low);
        int left = 0;
        for (int i = 0; i < pairs; ++i) {
            const int place = pair_place[i];
            const float bound = pair_bound[i];
            pair_slot[left] = pair_slot[i];
            pair_place[left] = place;
            pair_bound[left] = bound;
            left += bound > low[place];
        }
        pairs = left;
    }

    FACETMILL_CALLED void make_room() {
        thin_out();
        if (2 * pairs > max_pairs) flush();
    }

    /// The exact test of what is left, the most promising facet of every place first.
    FACETMILL_CALLED void flush() {
        thin_out();
        int first[place_lanes];
        for (int& i : first)
            i = -1;
        for (int i = 0; i < pairs; ++i) {
            int& best = first[pair_place[i]];
            if (best < 0 || pair_bound[i] > pair_bound[best]) best = i;
        }
        for (const int i : first)
            if (i >= 0) take(i);
        if (taken > 0) test();
        for (int i = 0; i < pairs; ++i)
            if (i != first[pair_place[i]]) take(i);
        if (taken > 0) test();
        pairs = 0;
    }

    /// The least of the answers, after the exact test of what waits for it.
    FACETMILL_CALLED double min_tip() {
        flush();
        double lowest = tips[0];
        for (int k = 1; k < packet.count; ++k)
            lowest = tips[k] < lowest ? tips[k] : lowest;
        return lowest;
    }

    FACETMILL_MEMBER void take(int pair) {
        const int place = pair_place[pair];
        if (!(pair_bound[pair] > lane(least, place))) return;
        const std::uint32_t slot = pair_slot[pair];
        tested.set(index.blocks[slot / block_width], slot % block_width, packet.x[place], packet.y[place],
                   taken);
        tested.max_lift[taken] = double(pair_bound[pair]) + zero;
        tested_slot[taken] = slot;
        tested_place[taken++] = place;
        if (taken == double_lanes) test();
    }

    FACETMILL_CALLED void test() {
        tested.fill(taken);
        double floor4[double_lanes];
        for (int w = 0; w < double_lanes; ++w)
            floor4[w] = w < taken ? tips[tested_place[w]] : __builtin_inf();
        const auto consider = [&](const Lift4& lift, const int*) __attribute__((always_inline)) {
            store(larger(lift.tip, load(floor4)), floor4);
        };
        tested.run(
            surface, [&]() __attribute__((always_inline)) { return load(floor4); }, consider);
        for (int w = 0; w < taken; ++w) {
            const int place = tested_place[w];
            if (!(floor4[w] > tips[place])) continue;
            tips[place] = floor4[w];
            touched_slots[place] = tested_slot[w];
            raise(place, rounded_down(floor4[w]));
        }
        taken = 0;
    }
};

} // namespace

} // namespace facetmill::simd
