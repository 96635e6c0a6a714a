// Body of axial_kernel_*.cpp. The lift of a cutter over a mesh is the largest lift over its facets. A tree of
// boxes finds the facets that matter, by bounds from the convexity of the cutter (axial_bounds.h); they get
// the exact test (axial_facet_test.h).
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_bounds.h"
#include "core/gouge/axial_facet_test.h"
#include "core/gouge/axial_kernel.h"

namespace facetmill::simd {

namespace {

template <bool tilted, SurfaceShape shape>
struct Search : Bounds<tilted, shape> {
    using Base = Bounds<tilted, shape>;
    using Base::bounds, Base::touched, Base::tangent_plane, Base::rough_height;
    using Base::index, Base::surface, Base::query, Base::at, Base::turn, Base::zero;
    using Base::inner, Base::radius, Base::uncertain;

    AxialAnswer& best;

    const bool flat_bottom;
    float sure;              ///< lower bounds of facets seen so far say that the answer is more, from `zero`
    std::uint32_t sure_slot; ///< the facet that says so
    float least;             ///< no less than best.tip from `zero`, and no more than the answer

    // Facets under test, and those that wait for it.
    FacetTest tested;
    std::uint32_t slot[4];
    // Lists have room for one more vector than they hold.
    static constexpr int max_waiting = 24, max_blocks = 64;
    float waiting_bound[max_waiting + block_width];
    std::uint32_t waiting_slot[max_waiting + block_width];
    int waiting = 0;

    // Nodes and blocks that are still to be opened. With full nodes the tree is no deeper than the digits of
    // the facet count in base 8; seven siblings wait on every level.
    static constexpr int max_nodes = block_width * 16;
    static constexpr int last_few = 2 * block_width;
    float node_room[last_few + max_nodes + block_width]; ///< the first: those of nothing
    float* const node_bound = node_room + last_few;
    std::uint32_t node_child[max_nodes + block_width];
    int nodes = 0;
    float block_room[last_few + max_blocks + block_width];
    float* const block_bound = block_room + last_few;
    std::uint32_t block_child[max_blocks + block_width];
    int blocks = 0;
    std::uint32_t opened; ///< a block that was opened first

    FACETMILL_MEMBER Search(const IndexView& i, const SurfaceTable& s, const AxialQuery& q, AxialAnswer& b)
        : Base(i, s, q), best(b), flat_bottom(has_flat_bottom(s)) {
        best.tip = query.least;
        best.slot = no_slot;
        least = sure = -__builtin_inff();
        raise(best.tip);
        for (int k = 0; k < last_few; ++k)
            node_room[k] = block_room[k] = -__builtin_inff();
    }

    FACETMILL_MEMBER void raise(double tip) {
        const float rounded = this->rounded_down(tip);
        least = rounded > least ? rounded : least;
    }

    FACETMILL_MEMBER Float8 child_bounds(const TreeNode& node) const {
        const Float8 hx = load(node.hx), hy = load(node.hy), hz = load(node.hz);
        if constexpr (!tilted) { // unused lanes reach nowhere: hx < 0
            const Float8 ax = load(node.cx) + at[0] + this->at_low[0],
                         ay = load(node.cy) + at[1] + this->at_low[1], top = load(node.cz) + hz;
            const auto doubt = this->near_doubt(hx, hy);
            if (index.has_strips) {
                const auto strips = this->strips_of(node, ax, ay, doubt.slack);
                return bounds(ax, ay, hx, hy, top, ax, ay, load(node.roof), load(node.slope_x),
                              load(node.slope_y), doubt, &strips);
            }
            return bounds(ax, ay, hx, hy, top, ax, ay, load(node.roof), load(node.slope_x),
                          load(node.slope_y), doubt);
        } else {
            const Float8 ax = load(node.cx) + at[0], ay = load(node.cy) + at[1], az = load(node.cz);
            const auto& m = turn;
            const auto size = [](float v) { return v < 0 ? -v : v; };
            const Float8 bz = az + at[2];
            const Float8 cx = m[0][0] * ax + m[0][1] * ay + m[0][2] * bz;
            const Float8 cy = m[1][0] * ax + m[1][1] * ay + m[1][2] * bz;
            const Float8 cz = m[2][0] * ax + m[2][1] * ay + m[2][2] * bz;
            const Float8 ex = size(m[0][0]) * hx + size(m[0][1]) * hy + size(m[0][2]) * hz;
            const Float8 ey = size(m[1][0]) * hx + size(m[1][1]) * hy + size(m[1][2]) * hz;
            const Float8 ez = size(m[2][0]) * hx + size(m[2][1]) * hy + size(m[2][2]) * hz;
            // The slab's side that faces the tool, in the frame, where it is not too steep for a roof.
            const Float8 px = load(node.normal_x), py = load(node.normal_y), pz = load(node.normal_z);
            const Float8 nx = m[0][0] * px + m[0][1] * py + m[0][2] * pz;
            const Float8 ny = m[1][0] * px + m[1][1] * py + m[1][2] * pz;
            const Float8 nz = m[2][0] * px + m[2][1] * py + m[2][2] * pz;
            const Float8 up = magnitude(nz), zero8 = all(0.0f);
            const Int8 roofed =
                (larger(magnitude(nx), magnitude(ny)) <= float(tolerance::steepest_roof) * up) & (up > 0.0f);
            const Float8 per = 1.0f / select(roofed, up, all(1.0f));
            const Float8 down = select(nz < 0.0f, per, -per);
            const Float8 sx = select(roofed, nx * down, zero8), sy = select(roofed, ny * down, zero8);
            const Float8 thick = select(nz < 0.0f, load(node.below), load(node.above));
            const Float8 top = cz + ez;
            const Float8 b = bounds(cx, cy, ex, ey, top, cx, cy, select(roofed, cz + thick * per, top), sx,
                                    sy, this->template doubt<Float8>());
            return select(hx >= 0.0f, b, all(-__builtin_inff()));
        }
    }

    /// Facets so many times as long as wide are needles.
    static constexpr int worth_a_strip = 16;

    /// Bounds of the lifts over the facets of a block, from above and, by one of their points, from below.
    template <bool both>
    FACETMILL_MEMBER Float8 facet_bounds(const FacetBlock& block, Float8& below) const {
        Float8 px[3], py[3], pz[3];
        for (int k = 0; k < 3; ++k) {
            if constexpr (!tilted) {
                px[k] = narrow(load(block.x[k]) - query.place[0], load(block.x[k] + 4) - query.place[0]);
                py[k] = narrow(load(block.y[k]) - query.place[1], load(block.y[k] + 4) - query.place[1]);
                pz[k] = narrow(load(block.z[k]) - zero, load(block.z[k] + 4) - zero);
            } else {
                const Float8 ax =
                    narrow(load(block.x[k]) - query.place[0], load(block.x[k] + 4) - query.place[0]);
                const Float8 ay =
                    narrow(load(block.y[k]) - query.place[1], load(block.y[k] + 4) - query.place[1]);
                const Float8 az =
                    narrow(load(block.z[k]) - query.place[2], load(block.z[k] + 4) - query.place[2]);
                px[k] = turn[0][0] * ax + turn[0][1] * ay + turn[0][2] * az;
                py[k] = turn[1][0] * ax + turn[1][1] * ay + turn[1][2] * az;
                pz[k] = turn[2][0] * ax + turn[2][1] * ay + turn[2][2] * az;
            }
        }
        const Float8 lo_x = smaller(smaller(px[0], px[1]), px[2]), hi_x = larger(larger(px[0], px[1]), px[2]);
        const Float8 lo_y = smaller(smaller(py[0], py[1]), py[2]), hi_y = larger(larger(py[0], py[1]), py[2]);
        const Float8 near_x = larger(larger(lo_x, -hi_x), all(0.0f)),
                     near_y = larger(larger(lo_y, -hi_y), all(0.0f));
        Int8 reached = near_x * near_x + near_y * near_y <= radius * radius;
        // The tangent plane where the facet's plane touches, if that is about inside.
        const Float8 ux = px[1] - px[0], uy = py[1] - py[0], uz = pz[1] - pz[0];
        const Float8 vx = px[2] - px[0], vy = py[2] - py[0], vz = pz[2] - pz[0];
        const Float8 nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
        const Float8 per = select(nz < 0.0f, all(1.0f), all(-1.0f))
                           * rough_inverse_root(larger(nx * nx + ny * ny + nz * nz, all(__FLT_MIN__)));
        const Float8 up =
            -1.0f / nz; // not finite where there is no plane: then the rim is as steep as may be
        Float8 mx, my;
        touched(nx * per, ny * per, mx, my);
        constexpr auto inward =
            float(1 - 3 * tolerance::rim_share); // for the lower bound a little inside of the rim
        const Float8 ax = mx * inward, ay = my * inward;
        Float8 level, sx, sy, on_longest;
        if (!tilted && index.has_strips) { // edge 0 is the longest
            reached = reached & this->move_into_strip(px, py, mx, my, on_longest);
            tangent_plane(mx, my, nx * up, ny * up, level, sx, sy);
            this->turn_along_needle(ux, uy, uz, (on_longest > 0.0f) & (on_longest < 1.0f), level, sx, sy);
        } else {
            mx = smaller(larger(mx, lo_x), hi_x);
            my = smaller(larger(my, lo_y), hi_y);
            tangent_plane(mx, my, nx * up, ny * up, level, sx, sy);
        }
        Float8 most = pz[0] - sx * px[0] - sy * py[0];
        most = larger(most, pz[1] - sx * px[1] - sy * py[1]);
        most = larger(most, pz[2] - sx * px[2] - sy * py[2]);
        const Float8 size = larger(larger(hi_x, -lo_x), larger(hi_y, -lo_y));
        const Float8 highest_z = larger(larger(magnitude(pz[0]), magnitude(pz[1])), magnitude(pz[2]));
        constexpr auto share = float(tolerance::float_slack);
        const float arc = this->ball ? surface.rough[0].r : 0,
                    of_height = this->ball ? 4 * arc : uncertain * radius;
        const Float8 turned_doubt = share * (highest_z + uncertain * (size + radius));
        if constexpr (both) {
            // The point of the facet with the same barycentric coordinates, those below 0 made 0.
            const auto weight = [&](int i, int j) __attribute__((always_inline)) {
                const Float8 w = (px[i] - ax) * (py[j] - ay) - (px[j] - ax) * (py[i] - ay);
                return larger(select(nz < 0.0f, -w, w), all(0.0f));
            };
            const Float8 w0 = weight(1, 2), w1 = weight(2, 0), w2 = weight(0, 1);
            const Float8 per_sum = 1.0f / (w0 + w1 + w2);
            Float8 qx = per_sum * (w0 * px[0] + w1 * px[1] + w2 * px[2]);
            Float8 qy = per_sum * (w0 * py[0] + w1 * py[1] + w2 * py[2]);
            Float8 qz = per_sum * (w0 * pz[0] + w1 * pz[1] + w2 * pz[2]);
            if (!tilted && index.has_strips) { // or, on a needle, that of its longest edge
                const Int8 slim = ux * ux + uy * uy > float(worth_a_strip) * magnitude(nz);
                qx = select(slim, px[0] + on_longest * ux, qx);
                qy = select(slim, py[0] + on_longest * uy, qy);
                qz = select(slim, pz[0] + on_longest * uz, qz);
            }
            const Float8 q_square = qx * qx + qy * qy;
            // Where the cutter's side is steep, its height at a rounded distance says nothing: stay inside.
            const Float8 q_rho = root(q_square) + float(tolerance::float_slack) * (size + radius);
            const Float8 doubt = tilted ? turned_doubt : share * (2 * highest_z + of_height);
            below = select((q_rho < inner) & (q_square >= 0.0f),
                           qz - (1 + share) * rough_height(q_rho) - doubt, all(-__builtin_inff()));
        }
        if constexpr (!tilted) { // corners are far from each other where they are far at all
            const Float8 slopes = magnitude(sx) + magnitude(sy);
            const Float8 of_cutter = this->ball ? 2 * arc * (1.0f + slopes) : all(uncertain * radius);
            const Float8 doubt = share * (2 * highest_z + 2 * slopes * size + of_cutter);
            return select(reached, most - level + doubt, all(-__builtin_inff()));
        }
        return select(reached, most - level + turned_doubt, all(-__builtin_inff()));
    }

    FACETMILL_MEMBER void gather(std::uint32_t which, int w) {
        const FacetBlock& block = index.blocks[which / block_width];
        const std::uint32_t lane = which % block_width;
        slot[w] = which;
        if constexpr (!tilted)
            tested.set(block, lane, query.place[0], query.place[1], w);
        else
            tested.set_unturned(block, lane, w);
    }

    FACETMILL_MEMBER void consider(const Lift4& lift, const int (&edge)[double_lanes]) {
        unsigned higher = bits(lift.tip > best.tip);
        for (; higher != 0; higher &= higher - 1) {
            const int k = __builtin_ctz(higher);
            if (!(lift.tip[k] > best.tip)) continue;
            best.tip = lift.tip[k];
            best.slot = slot[k];
            best.edge = edge[k];
            best.point[0] = lift.point.x[k];
            best.point[1] = lift.point.y[k];
            best.point[2] = lift.point.z[k];
        }
    }

    /// Four of those that wait, the most promising among them.
    FACETMILL_CALLED void test() {
        int left = 0, most = 0;
        for (int i = 0; i < waiting; ++i) {
            waiting_bound[left] = waiting_bound[i];
            waiting_slot[left] = waiting_slot[i];
            most = waiting_bound[i] > waiting_bound[most] ? left : most;
            left += waiting_bound[i] > least;
        }
        waiting = left;
        int taken = 0;
        for (int next = most; taken < double_lanes && waiting > 0; next = waiting - 1) {
            tested.max_lift[taken] = double(waiting_bound[next]) + zero;
            gather(waiting_slot[next], taken++);
            --waiting;
            waiting_bound[next] = waiting_bound[waiting];
            waiting_slot[next] = waiting_slot[waiting];
        }
        if (taken == 0) return;
        if constexpr (tilted) tested.turn(query.place, query.frame, taken);
        tested.fill(taken);
        tested.run(
            surface, [&]() __attribute__((always_inline)) { return best.tip; },
            [&](const Lift4& lift, const int(&edge)[double_lanes])
                __attribute__((always_inline)) { consider(lift, edge); });
        raise(best.tip);
    }

    /// The first block that is opened gives a lower bound too: it lets most of the tree be passed over.
    /// Upright, where that is cheap, all of them do, which saves exact tests.
    template <bool first>
    FACETMILL_CALLED void open_block(std::uint32_t which) {
        const FacetBlock& block = index.blocks[which];
        if constexpr (!tilted)
            if (flat_bottom && top_of(block) <= best.tip) return;
        Float8 below;
        const Float8 above = facet_bounds < first || !tilted > (block, below);
        if constexpr (first || !tilted) {
            const float most = max_of(below);
            if (most > least) {
                least = sure = most;
                sure_slot = which * std::uint32_t(block_width)
                            + std::uint32_t(__builtin_ctz(bits(below == all(most)) | 1u << block_width));
            }
        }
        std::uint32_t slots[block_width];
        for (std::uint32_t k = 0; k < block_width; ++k)
            slots[k] = which * std::uint32_t(block_width) + k;
        waiting += keep(bits(above > least), above, slots, waiting_bound + waiting, waiting_slot + waiting);
        // What is as high as a level floor is told from it by its own digits alone.
        const bool at_once = first && !tilted && flat_bottom;
        while (waiting > (at_once ? 0 : max_waiting))
            test();
    }

    /// What is surely there is more than was asked for.
    FACETMILL_MEMBER bool is_enough() {
        const double tip = double(sure) + zero;
        if (tip > query.enough && tip > best.tip) {
            best.tip = tip;
            best.slot = sure_slot;
        }
        return best.tip > query.enough;
    }

    FACETMILL_MEMBER static unsigned leaves(const TreeNode& node) {
        Int8 child;
        __builtin_memcpy(&child, node.child, sizeof child);
        return bits(child < 0); // TreeNode::leaf is the sign
    }

    /// Children in whose boxes the highest contact may lie, as the slopes around their vertices say.
    FACETMILL_MEMBER unsigned touchable(const TreeNode& node) const {
        const auto on = this->contact(load(node.slope_lo_x), load(node.slope_hi_x), load(node.slope_lo_y),
                                      load(node.slope_hi_y));
        const Float8 ax = load(node.cx) + at[0], ay = load(node.cy) + at[1];
        const Float8 hx = load(node.hx) + this->slack, hy = load(node.hy) + this->slack;
        return bits((ax - hx <= on.hi_x) & (ax + hx >= on.lo_x) & (ay - hy <= on.hi_y)
                    & (ay + hy >= on.lo_y));
    }

    template <std::size_t size>
    FACETMILL_MEMBER static void fetch_lines(const void* from) {
#pragma GCC unroll 16
        for (std::size_t i = 0; i < size; i += 64)
            __builtin_prefetch(static_cast<const char*>(from) + i);
    }

    /// Asks the memory for what will most likely be opened.
    FACETMILL_MEMBER void fetch(const TreeNode& node, unsigned nodes_wanted, unsigned blocks_wanted) const {
        constexpr std::size_t node_part = tilted ? offsetof(TreeNode, highest) : offsetof(TreeNode, normal_x);
        for (; nodes_wanted != 0; nodes_wanted &= nodes_wanted - 1)
            fetch_lines<node_part>(index.nodes + node.child[__builtin_ctz(nodes_wanted)]);
        for (; blocks_wanted != 0; blocks_wanted &= blocks_wanted - 1)
            fetch_lines<sizeof(FacetBlock)>(index.blocks
                                            + (node.child[__builtin_ctz(blocks_wanted)] & ~TreeNode::leaf));
    }

    FACETMILL_CALLED void open_node(const TreeNode& node) {
        const Float8 bound = child_bounds(node);
        unsigned lanes = bits(bound > least);
        const unsigned leaf = leaves(node);
        if constexpr (!tilted) {
            // Around large parts slopes are of all kinds.
            const bool small = node.hx[0] + node.hy[0] < radius;
            if ((small ? lanes : lanes & leaf) != 0) lanes &= (small ? 0u : ~leaf) | touchable(node);
            if (flat_bottom)
                for (unsigned open = lanes; open != 0; open &= open - 1) {
                    const int k = __builtin_ctz(open);
                    if (node.highest[k] <= best.tip) lanes &= ~(1u << k);
                }
        }
        fetch(node, lanes & ~leaf, lanes & leaf);
        nodes += keep(lanes & ~leaf, bound, node.child, node_bound + nodes, node_child + nodes);
        blocks += keep(lanes & leaf, bound, node.child, block_bound + blocks, block_child + blocks);
    }

    FACETMILL_MEMBER void open_blocks() {
        for (int i = 0; i < blocks; ++i) {
            const std::uint32_t block = block_child[i] & ~TreeNode::leaf;
            if (block_bound[i] > least && block != opened) open_block<false>(block);
        }
        blocks = 0;
    }

    /// Moves the largest of the last few bounds of a list to its end.
    FACETMILL_MEMBER static void best_last(float* bound, std::uint32_t* child, int count) {
        const Float8 late = load(bound + count - 8), early = load(bound + count - 16);
        const Float8 largest = all(max_of(larger(late, early)));
        const unsigned found = bits(early == largest) | bits(late == largest) << 8;
        const int most = found == 0 ? count - 1 : count + 15 - __builtin_clz(found);
        const float b = bound[most];
        const std::uint32_t c = child[most];
        bound[most] = bound[count - 1];
        child[most] = child[count - 1];
        bound[count - 1] = b;
        child[count - 1] = c;
    }

    FACETMILL_MEMBER void run() {
        // First guesses let most of the tree be passed over: where the last lift came from, and the most
        // promising way down.
        opened = no_slot;
        if (query.hint != no_slot) {
            opened = query.hint / std::uint32_t(block_width);
            open_block<true>(opened);
            if (is_enough()) return;
        }
        if (query.cut_nodes == 0) open_node(index.nodes[0]);
        for (int i = 0; i < query.cut_nodes; ++i)
            open_node(query.cut[i]);
        while (nodes > 0 && blocks == 0) {
            best_last(node_bound, node_child, nodes);
            --nodes;
            if (node_bound[nodes] > least) open_node(index.nodes[node_child[nodes]]);
        }
        if (blocks > 0) {
            best_last(block_bound, block_child, blocks);
            --blocks;
            const std::uint32_t block = block_child[blocks] & ~TreeNode::leaf;
            if (block_bound[blocks] > least && block != opened) open_block<true>(block);
            if (!tilted) open_blocks();
            if (is_enough()) return;
        }
        while (nodes > 0) {
            --nodes;
            if (!(node_bound[nodes] > least)) continue;
            open_node(index.nodes[node_child[nodes]]);
            // At once upright: what they say from below spares nodes.
            if (blocks > (tilted ? max_blocks : 0)) {
                open_blocks();
                if (is_enough()) return;
            }
        }
        open_blocks();
        while (waiting > 0 && !is_enough())
            test();
    }
};

template <bool tilted, SurfaceShape shape>
FACETMILL_CALLED void search_shape(const IndexView& index, const SurfaceTable& surface,
                                   const AxialQuery& query, AxialAnswer& answer) {
    Search<tilted, shape> search(index, surface, query, answer);
    if (index.nodes) search.run();
}

template <bool tilted>
void search(const IndexView& index, const SurfaceTable& surface, const AxialQuery& query,
            AxialAnswer& answer) {
    switch (surface.shape) {
    case SurfaceShape::ball:
        return search_shape<tilted, SurfaceShape::ball>(index, surface, query, answer);
    case SurfaceShape::flat:
        return search_shape<tilted, SurfaceShape::flat>(index, surface, query, answer);
    case SurfaceShape::any:
        return search_shape<tilted, SurfaceShape::any>(index, surface, query, answer);
    }
}

/// The lift over one facet, and where it is touched.
void touch(const IndexView& index, const SurfaceTable& surface, const AxialQuery& query,
           AxialAnswer& answer) {
    answer.tip = query.least;
    answer.slot = no_slot;
    FacetTest tested;
    tested.set(index.blocks[query.hint / block_width], query.hint % block_width, query.place[0],
               query.place[1], 0);
    tested.max_lift[0] = __builtin_inf();
    tested.fill(1);
    tested.run(
        surface, [&]() __attribute__((always_inline)) { return answer.tip; },
        [&](const Lift4& lift, const int(&edge)[double_lanes]) __attribute__((always_inline)) {
            if (!(lift.tip[0] > answer.tip)) return;
            answer = {lift.tip[0], query.hint, edge[0], {lift.point.x[0], lift.point.y[0], lift.point.z[0]}};
        });
}

} // namespace

} // namespace facetmill::simd
