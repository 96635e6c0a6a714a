// Body of axial_kernel_*.cpp: lifts over eight places close together, vertical axis. The tree is gone down
// once for all of them. A facet is prepared once: where its plane touches the cutter moves with the cutter,
// so the lift over the plane and the sides of the edges on which it is touched are linear in the place. What
// a facet asks for is bounded from above and from below, in single precision, by its plane and those of its
// own edges that the contact lies beyond: for eight places at a time, or, where the mesh is fine and a block
// matters to few of them, for the eight facets of the block at a time. What the bounds leave over, mostly one
// or two facets a place, gets the exact test.
//
// An edge belongs to one facet. A facet whose plane is surely touched outside, beyond edges of other facets
// only, has nothing to say: on the way from its highest point to the plane's contact, on which the lift never
// falls, one of those edges is crossed.
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/axial_packet_pairs_impl.h"

namespace facetmill::simd {

namespace {

template <SurfaceShape shape>
class PacketSearch : PacketPairs<shape> {
public:
    FACETMILL_MEMBER PacketSearch(const IndexView& i, const SurfaceTable& s, const AxialPacket& p,
                                  const AxialQuery& first, AxialPacketAnswer& answer)
        : PacketPairs<shape>(i, s, p, first, answer), flat_bottom(has_flat_bottom(s)) {
        for (int k = 0; k < last_few; ++k)
            key_room[k] = -__builtin_inff();
    }

    FACETMILL_MEMBER void run() {
        for (int i = 0; i < packet.cut_nodes; ++i)
            open_node(packet.cut[i]);
        while (waiting > 0) {
            const int most = most_promising();
            const Child next = child[most];
            const PlaceFloats bound = load_places(child_bound[most]);
            --waiting;
            if (most != waiting) {
                key[most] = key[waiting];
                child[most] = child[waiting];
                store(load_places(child_bound[waiting]), child_bound[most]);
            }
            if (bits(bound > least) == 0) continue;
            if (flat_bottom && next.node->highest[next.lane] <= lowest_tip) continue;
            const std::uint32_t which = next.node->child[next.lane];
            if (!(which & TreeNode::leaf))
                open_node(index.nodes[which]);
            else if (const unsigned places = bits(bound > least) & promised(*next.node, next.lane))
                open_block(which & ~TreeNode::leaf, next.contact, places);
        }
        flush();
    }

private:
    using Base = PacketPairs<shape>;
    using Base::index, Base::query, Base::at, Base::radius, Base::inner, Base::slack, Base::margin;
    using Base::packet, Base::place_x, Base::place_y, Base::dx, Base::dy, Base::lo_dx, Base::hi_dx,
        Base::lo_dy, Base::hi_dy, Base::least, Base::floor;
    using Base::prepare, Base::prepare_edges, Base::facet_tangent, Base::point_lift, Base::edge_bounds;
    using Base::raise, Base::add, Base::flush, Base::fetch, Base::room_of, Base::min_tip;
    using Base::tips;
    using Base::touched, Base::tangent_plane, Base::contact, Base::bounds, Base::rough_height;
    using typename Base::Contact, typename Base::Places;
    template <class F>
    using EdgeLanes = typename Base::template EdgeLanes<F>;

    const bool flat_bottom;
    /// The least of the answers so far, of a flat bottom only. On a level floor all boxes are as high, which
    /// their own digits tell and bounds in single precision cannot.
    double lowest_tip = no_lift;

    /// Places whose facets, eight each, fill the lanes.
    static constexpr int together = place_lanes / int(block_width);
    /// With small facets that matter to no more places than this something else is better put into the lanes:
    /// the facets of the block; edges of several facets.
    static constexpr int few_places = shape == SurfaceShape::ball ? 6 * together : 2 + 2 * together,
                         few_edge_places = 2;

    /// Where on the cutter, from its axis, a box can be touched.
    struct ContactRange {
        float lo_x, hi_x, lo_y, hi_y;
    };

    // Children that are still to be opened. As long as they are few the most promising of the last is next;
    // then the last, and there are no more than seven siblings more on each of the levels below.
    static constexpr int many = 8 * block_width, max_waiting = many + 17 * int(block_width);
    static constexpr int last_few = 2 * block_width;
    float key_room[last_few + max_waiting]; ///< the first: those of nothing
    float* const key = key_room + last_few;
    struct Child {
        const TreeNode* node;
        int lane;
        ContactRange contact;
    };
    Child child[max_waiting];
    alignas(64) float child_bound[max_waiting][place_lanes];
    int waiting = 0;

    /// The most promising of the last few children that wait; when there are many, simply the last.
    FACETMILL_MEMBER int most_promising() const {
        if (waiting > many) return waiting - 1;
        const Float8 late = load(key + waiting - 8), early = load(key + waiting - 16);
        const Float8 most = all(max_of(larger(late, early)));
        const unsigned found = bits(early == most) | bits(late == most) << 8;
        return found == 0 ? waiting - 1 : waiting + 15 - __builtin_clz(found);
    }

    FACETMILL_CALLED void open_node(const TreeNode& node) {
        const Float8 ax = load(node.cx) + at[0], ay = load(node.cy) + at[1];
        const Float8 hx = load(node.hx), hy = load(node.hy), reach = all(radius + slack);
        const Float8 top = load(node.cz) + load(node.hz) + margin;
        const Float8 near_x = larger(larger(ax - hx - hi_dx, lo_dx - ax - hx), all(0.0f)),
                     near_y = larger(larger(ay - hy - hi_dy, lo_dy - ay - hy), all(0.0f));
        // Places from which the cutter can touch something in the box.
        const Contact on = contact(load(node.slope_lo_x), load(node.slope_hi_x), load(node.slope_lo_y),
                                   load(node.slope_hi_y));
        const Float8 first_x = ax - hx - slack - on.hi_x, last_x = ax + hx + slack - on.lo_x;
        const Float8 first_y = ay - hy - slack - on.hi_y, last_y = ay + hy + slack - on.lo_y;
        unsigned reached =
            bits((hx >= 0.0f) & (near_x * near_x + near_y * near_y <= reach * reach) & (first_x <= hi_dx)
                 & (last_x >= lo_dx) & (first_y <= hi_dy) & (last_y >= lo_dy) & (top > min_of(least)));
        if (reached == 0) return;
        // Strips, and how far the places lie across and along them.
        auto strips = this->strips_of(node, ax, ay, all(slack));
        const auto spread = [&](const Float8& x, const Float8& y, bool high) __attribute__((always_inline)) {
            const Float8 x0 = x * lo_dx, x1 = x * hi_dx, y0 = y * lo_dy, y1 = y * hi_dy;
            return high ? larger(x0, x1) + larger(y0, y1) : smaller(x0, x1) + smaller(y0, y1);
        };
        if (index.has_strips) {
            strips.lo = larger(strips.lo, spread(strips.x, strips.y, false) - reach);
            strips.hi = smaller(strips.hi, spread(strips.x, strips.y, true) + reach);
            reached &= bits(strips.lo <= strips.hi);
            if (reached == 0) return;
        }
        // The tangent plane of the lift over the roof, for a place in the middle, serves them all.
        const Float8 px = load(node.slope_x), py = load(node.slope_y);
        const Float8 lo_x = larger(ax - hx - slack, all(lo_dx) - reach),
                     hi_x = smaller(ax + hx + slack, all(hi_dx) + reach);
        const Float8 lo_y = larger(ay - hy - slack, all(lo_dy) - reach),
                     hi_y = smaller(ay + hy + slack, all(hi_dy) + reach);
        const float middle_x = 0.5f * (lo_dx + hi_dx), middle_y = 0.5f * (lo_dy + hi_dy);
        const Float8 per = rough_inverse_root(1.0f + px * px + py * py);
        Float8 mx, my;
        touched(px * per, py * per, mx, my);
        mx = smaller(larger(mx, lo_x - middle_x), hi_x - middle_x);
        my = smaller(larger(my, lo_y - middle_y), hi_y - middle_y);
        if (index.has_strips) {
            auto from_middle = strips;
            const Float8 moved = strips.across(all(middle_x), all(middle_y));
            from_middle.lo = strips.lo - moved;
            from_middle.hi = strips.hi - moved;
            from_middle.move_into(mx, my);
        }
        Float8 level, sx, sy;
        tangent_plane(mx, my, px, py, level, sx, sy);
        const Float8 qx = px - sx, qy = py - sy;
        Float8 most = larger(qx * lo_x, qx * hi_x) + larger(qy * lo_y, qy * hi_y);
        if (index.has_strips)
            most = smaller(most, strips.most(qx, qy, spread(-strips.y, strips.x, false) - reach,
                                             spread(-strips.y, strips.x, true) + reach));
        const Float8 over = load(node.roof) - px * ax - py * ay - level + most + margin;
        alignas(32) float base[block_width], base_x[block_width], base_y[block_width], tops[block_width];
        alignas(32) float left[block_width], right[block_width], front[block_width], back[block_width];
        store(over, base);
        store(sx, base_x);
        store(sy, base_y);
        store(top, tops);
        store(first_x, left);
        store(last_x, right);
        store(first_y, front);
        store(last_y, back);
        alignas(32) float contacts[4][block_width];
        store(on.lo_x, contacts[0]);
        store(on.hi_x, contacts[1]);
        store(on.lo_y, contacts[2]);
        store(on.hi_y, contacts[3]);
        for (; reached != 0; reached &= reached - 1) {
            const int k = __builtin_ctz(reached);
            const PlaceFloats bound =
                select((dx >= left[k]) & (dx <= right[k]) & (dy >= front[k]) & (dy <= back[k]),
                       smaller(base[k] + base_x[k] * dx + base_y[k] * dy, tops[k]), -__builtin_inff());
            if (bits(bound > least) == 0) continue;
            if (flat_bottom && node.highest[k] <= lowest_tip) continue;
            fetch(node.child[k]);
            key[waiting] = max_of(bound - larger(least, floor));
            child[waiting] = {&node, k, {contacts[0][k], contacts[1][k], contacts[2][k], contacts[3][k]}};
            store(bound, child_bound[waiting]);
            ++waiting;
        }
    }

    /// The places that a block may matter to, as bits. To open it costs more than a tangent for each of them.
    FACETMILL_CALLED unsigned promised(const TreeNode& node, int k) const {
        const auto of = [](float v) __attribute__((always_inline)) {
            return all_of<PlaceFloats>(v);
        };
        const PlaceFloats cx = node.cx[k] + at[0] - dx, cy = node.cy[k] + at[1] - dy;
        return bits(bounds(cx, cy, of(node.hx[k]), of(node.hy[k]), of(node.cz[k] + node.hz[k]), cx, cy,
                           of(node.roof[k]), of(node.slope_x[k]), of(node.slope_y[k]),
                           this->template doubt<PlaceFloats>())
                    > least);
    }

    FACETMILL_CALLED void open_block(std::uint32_t which, const ContactRange& on, unsigned places) {
        if (flat_bottom) {
            const double top = top_of(index.blocks[which]);
            unsigned higher = 0;
            for (unsigned left = places; left != 0; left &= left - 1) {
                const int k = __builtin_ctz(left);
                higher |= unsigned(top > tips[k]) << k;
            }
            places = higher;
            if (places == 0) return;
        }
        PreparedBlock& f = packet.prepared->prepared[room_of(which)];
        std::uint32_t& there = packet.prepared->block[room_of(which)];
        if (there != which) {
            prepare(index.blocks[which], f);
            there = which;
        }
        const double ox = f.origin[0], oy = f.origin[1];
        const Places p{from_origin(place_x, ox), from_origin(place_y, oy)};
        if (f.is_fine && __builtin_popcount(places) <= few_places)
            ask_places(f, which, p, on, places);
        else
            ask_facets(f, which, p, on, places);
        if (flat_bottom && lowest_tip == no_lift) lowest_tip = min_tip();
    }

    /// Every facet's middle gives a lower bound.
    FACETMILL_MEMBER void ask_middles(const PreparedBlock& f, const Places& p, unsigned open) {
        alignas(32) float x[block_width], y[block_width], z[block_width];
        const auto middle = [](const float(&corner)[3][block_width]) __attribute__((always_inline)) {
            return (1 / 3.0f) * (load(corner[0]) + load(corner[1]) + load(corner[2]));
        };
        store(middle(f.x), x);
        store(middle(f.y), y);
        store(middle(f.z) - load(f.noise_tangent), z);
        for (; open != 0; open &= open - 1) {
            const int k = __builtin_ctz(open);
            const PlaceFloats ax = x[k] - p.x, ay = y[k] - p.y;
            const PlaceFloats rho = root(ax * ax + ay * ay) + 4 * f.position[k];
            const PlaceFloats low = z[k] - (1 + float(tolerance::float_slack)) * rough_height(rho);
            least = larger(select(rho < inner, low, -__builtin_inff()), least);
        }
    }

    /// A facet after the other, for all places at a time.
    FACETMILL_CALLED void ask_facets(PreparedBlock& f, std::uint32_t which, const Places& p,
                                     const ContactRange& on, unsigned places) {
        // From the block's origin; wrong by less than its positions.
        const double ox = query.place[0] - f.origin[0], oy = query.place[1] - f.origin[1];
        const float lo_x = float(ox + lo_dx), hi_x = float(ox + hi_dx), lo_y = float(oy + lo_dy),
                    hi_y = float(oy + hi_dy);
        const Float8 near_x = larger(larger(load(f.lo_x) - hi_x, lo_x - load(f.hi_x)), all(0.0f)),
                     near_y = larger(larger(load(f.lo_y) - hi_y, lo_y - load(f.hi_y)), all(0.0f));
        const Float8 reach = all(radius);
        const auto never = all_of<PlaceFloats>(-__builtin_inff());
        const Float8 first_x = load(f.lo_x) - on.hi_x, last_x = load(f.hi_x) - on.lo_x;
        const Float8 first_y = load(f.lo_y) - on.hi_y, last_y = load(f.hi_y) - on.lo_y;
        unsigned open = bits((near_x * near_x + near_y * near_y <= reach * reach) & (first_x <= hi_x)
                             & (last_x >= lo_x) & (first_y <= hi_y) & (last_y >= lo_y)
                             & (load(f.top) > min_of(least)) & (widened(f.duty) != 0));
        if (f.is_fine) ask_middles(f, p, open);
        const int few_edges = f.is_fine ? few_edge_places : 0;
        alignas(32) float level[block_width], tangent_x[block_width], tangent_y[block_width];
        Float8 gx, gy;
        store(facet_tangent(f, all(0.5f * (lo_x + hi_x)), all(0.5f * (lo_y + hi_y)), gx, gy), level);
        store(gx, tangent_x);
        store(gy, tangent_y);
        alignas(32) float left[block_width], right[block_width], front[block_width], back[block_width];
        store(first_x, left);
        store(last_x, right);
        store(first_y, front);
        store(last_y, back);
        const auto of = [](float v) __attribute__((always_inline)) {
            return all_of<PlaceFloats>(v);
        };
        for (; open != 0; open &= open - 1) {
            const int k = __builtin_ctz(open);
            const unsigned duty = f.duty[k];
            const PlaceFloats plane = f.plane[k] + f.plane_x[k] * p.x + f.plane_y[k] * p.y;
            const PlaceFloats tangent = level[k] + tangent_x[k] * p.x + tangent_y[k] * p.y;
            const PlaceFloats cap = smaller(tangent, smaller(plane + f.noise_out[k], f.top[k]));
            const PlaceMask alive =
                (p.x >= left[k]) & (p.x <= right[k]) & (p.y >= front[k]) & (p.y <= back[k]) & (cap > least);
            if ((bits(alive) & places) == 0) continue;
            if (!f.has_edges) prepare_edges(f);
            const auto side = [&](int e) __attribute__((always_inline)) {
                return f.edge[e].side[k] + f.edge[e].side_x[k] * p.x + f.edge[e].side_y[k] * p.y;
            };
            const PlaceFloats sides[3] = {side(0), side(1), side(2)};
            PlaceFloats above = never;
            if (duty & duty_plane) {
                const PlaceMask outside = (sides[0] < -f.edge[0].doubt[k]) | (sides[1] < -f.edge[1].doubt[k])
                                          | (sides[2] < -f.edge[2].doubt[k]);
                const float corner = f.corner[k];
                const PlaceMask inside = (sides[0] > corner) & (sides[1] > corner) & (sides[2] > corner);
                above = select(outside, never, select(inside, plane + f.noise_in[k], cap));
                least = larger(select(inside, plane - f.noise_in[k] - f.loss[k], never), least);
            }
            unsigned asked[3] = {0, 0, 0};
            for (int e = 0; e < 3; ++e) {
                if (!(duty & (duty_edge << e))) continue;
                PlaceMask seen = alive;
                if (duty & duty_plane) seen &= ~(sides[e] >= f.edge[e].doubt[k]);
                const unsigned seen_places = bits(seen) & places;
                if (__builtin_popcount(seen_places) <= few_edges) {
                    asked[e] = seen_places;
                    continue;
                }
                const EdgeLanes<PlaceFloats> lanes{
                    f.x[e][k] - p.x,       f.y[e][k] - p.y,      of(f.z[e][k]),          of(f.edge[e].ux[k]),
                    of(f.edge[e].uy[k]),   of(f.edge[e].run[k]), of(f.edge[e].slope[k]), of(f.position[k]),
                    of(f.height_noise[k]), of(f.top[k])};
                PlaceFloats edge_above, edge_below;
                edge_bounds(lanes, edge_above, edge_below);
                above = select(seen, larger(edge_above, above), above);
                least = larger(edge_below, least);
            }
            const unsigned still_alive = bits(alive & (cap > least)) & places;
            above = smaller(above, cap);
            unsigned wanted = still_alive & (bits(above > least) | asked[0] | asked[1] | asked[2]);
            if (wanted == 0) continue;
            alignas(64) float bound[place_lanes], caps[place_lanes];
            store(above, bound);
            store(cap, caps);
            for (; wanted != 0; wanted &= wanted - 1) {
                const int place = __builtin_ctz(wanted);
                const unsigned edges_asked =
                    (asked[0] >> place & 1) | (asked[1] >> place & 1) << 1 | (asked[2] >> place & 1) << 2;
                add(f, which, k, p, place, bound[place], edges_asked, caps[place]);
            }
        }
    }

    /// A place after the other, for all facets at a time.
    FACETMILL_CALLED void ask_places(PreparedBlock& f, std::uint32_t which, const Places& at_places,
                                     const ContactRange& on, unsigned places) {
        const Float8 never = all(-__builtin_inff());
        const Int8 duty = widened(f.duty), has_plane = (duty & int(duty_plane)) != 0;
        alignas(32) float caps[few_places][float_lanes];
        int place[few_places];
        unsigned alive[few_places];
        int count = 0;
        const auto of = [](const float(&v)[block_width]) __attribute__((always_inline)) {
            return repeat<PlaceFloats>(v);
        };
        const unsigned has_duty = bits(duty != 0);
        while (places != 0) {
            int p[together];
            float px[together], py[together], lows[together];
            for (int j = 0; j < together; ++j) {
                p[j] = j > 0 && places == 0 ? p[0] : __builtin_ctz(places);
                places &= places - 1;
                px[j] = lane(at_places.x, p[j]);
                py[j] = lane(at_places.y, p[j]);
                lows[j] = lane(least, p[j]);
            }
            const auto x = each_eight<PlaceFloats>(px), y = each_eight<PlaceFloats>(py);
            const PlaceMask touchable = (x >= of(f.lo_x) - on.hi_x) & (x <= of(f.hi_x) - on.lo_x)
                                        & (y >= of(f.lo_y) - on.hi_y) & (y <= of(f.hi_y) - on.lo_y);
            PlaceFloats gx, gy;
            const PlaceFloats over = facet_tangent(f, x, y, gx, gy);
            const PlaceFloats plane = of(f.plane) + of(f.plane_x) * x + of(f.plane_y) * y;
            const PlaceFloats cap =
                smaller(over + gx * x + gy * y, smaller(plane + of(f.noise_out), of(f.top)));
            const unsigned open = bits(touchable & (cap > each_eight<PlaceFloats>(lows)));
            if (open == 0) continue;
            const PlaceFloats low = point_lift(f, x, y);
            for (int j = 0; j < together && (j == 0 || p[j] != p[0]); ++j) {
                alive[count] = open >> j * block_width & has_duty;
                if (alive[count] == 0) continue;
                raise(p[j], max_of(eight(low, j)));
                store(eight(cap, j), caps[count]);
                place[count++] = p[j];
            }
        }
        if (count == 0) return;
        if (!f.has_edges) prepare_edges(f);
        for (int i = 0; i < count; ++i) {
            const int p = place[i];
            const Float8 x = all(lane(at_places.x, p)), y = all(lane(at_places.y, p)), cap = load(caps[i]);
            const auto side = [&](int e) __attribute__((always_inline)) {
                return load(f.edge[e].side) + load(f.edge[e].side_x) * x + load(f.edge[e].side_y) * y;
            };
            const Float8 sides[3] = {side(0), side(1), side(2)};
            const Float8 doubts[3] = {load(f.edge[0].doubt), load(f.edge[1].doubt), load(f.edge[2].doubt)};
            const Float8 corner = load(f.corner);
            const Float8 plane = load(f.plane) + load(f.plane_x) * x + load(f.plane_y) * y;
            const Int8 outside = (sides[0] < -doubts[0]) | (sides[1] < -doubts[1]) | (sides[2] < -doubts[2]);
            const Int8 inside = has_plane & (sides[0] > corner) & (sides[1] > corner) & (sides[2] > corner);
            Float8 above = select(inside, plane + load(f.noise_in), cap);
            above = smaller(select(has_plane & ~outside, above, never), cap);
            const float low = max_of(select(inside, plane - load(f.noise_in) - load(f.loss), never));
            raise(p, low);
            unsigned asked[3];
            for (int e = 0; e < 3; ++e)
                asked[e] =
                    bits(((duty & (int(duty_edge) << e)) != 0) & ~(has_plane & (sides[e] >= doubts[e])));
            unsigned wanted = alive[i] & bits(cap > lane(least, p))
                              & (bits(above > lane(least, p)) | asked[0] | asked[1] | asked[2]);
            if (wanted == 0) continue;
            alignas(32) float bound[float_lanes];
            store(above, bound);
            for (; wanted != 0; wanted &= wanted - 1) {
                const int k = __builtin_ctz(wanted);
                const unsigned edges_asked =
                    (asked[0] >> k & 1) | (asked[1] >> k & 1) << 1 | (asked[2] >> k & 1) << 2;
                add(f, which, k, at_places, p, bound[k], edges_asked, caps[i][k]);
            }
        }
    }
};

void packet(const IndexView& index, const SurfaceTable& surface, const AxialPacket& packet,
            AxialPacketAnswer& answer) {
    AxialQuery first;
    first.place[0] = packet.x[0];
    first.place[1] = packet.y[0];
    if (!index.nodes) {
        for (double& tip : answer.tips)
            tip = no_lift;
        for (std::uint32_t& slot : answer.touched)
            slot = no_slot;
    } else if (surface.shape == SurfaceShape::ball) {
        PacketSearch<SurfaceShape::ball>(index, surface, packet, first, answer).run();
    } else if (surface.shape == SurfaceShape::flat) {
        PacketSearch<SurfaceShape::flat>(index, surface, packet, first, answer).run();
    } else {
        PacketSearch<SurfaceShape::any>(index, surface, packet, first, answer).run();
    }
}

} // namespace

} // namespace facetmill::simd
