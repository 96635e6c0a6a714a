// Body of axial_kernel_*.cpp: lifts over eight places close together, vertical axis. The tree is gone down
// once for all of them. A facet is prepared once: where its plane touches the cutter moves with the cutter,
// so the lift over the plane and the sides of the edges on which it is touched are linear in the place. What
// a facet asks for is bounded for eight places at a time, from above and from below, in single precision, by
// its plane and those of its own edges that the contact lies beyond. What the bounds leave over, mostly one
// or two facets a place, gets the exact test.
//
// An edge belongs to one facet. A facet whose plane is surely touched outside, beyond edges of other facets
// only, has nothing to say: on the way from its highest point to the plane's contact, on which the lift never
// falls, one of those edges is crossed.
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_bounds.h"
#include "core/gouge/axial_facet_test.h"
#include "core/gouge/axial_kernel.h"

namespace facetmill::simd {

namespace {

class PacketSearch : Bounds<false> {
public:
    FACETMILL_MEMBER PacketSearch(const IndexView& i, const SurfaceTable& s, const AxialPacket& p,
                                  const AxialQuery& first, double* t)
        : Bounds<false>(i, s, first), packet(p), tips(t) {
        float x[float_lanes], y[float_lanes];
        for (int k = 0; k < float_lanes; ++k) {
            const int lane = k < packet.count ? k : 0;
            x[k] = float(packet.x[lane] - first.place[0]);
            y[k] = float(packet.y[lane] - first.place[1]);
            tips[k] = no_lift;
        }
        dx = load(x);
        dy = load(y);
        for (int k = 0; k < float_lanes; ++k) {
            lo_dx = k == 0 || x[k] < lo_dx ? x[k] : lo_dx;
            hi_dx = k == 0 || x[k] > hi_dx ? x[k] : hi_dx;
            lo_dy = k == 0 || y[k] < lo_dy ? y[k] : lo_dy;
            hi_dy = k == 0 || y[k] > hi_dy ? y[k] : hi_dy;
        }
        // Sums at the other places are larger by the distances to them and to their reach.
        margin += float(tolerance::float_slack * 80 * surface.max_radius);
        least = all(-__builtin_inff());
        floor = all(float(-2 * (index.half_size[2] + surface.max_radius) - 1));
        steep_rho = float(surface.max_radius);
        for (int k = 0; k < surface.count; ++k) {
            const SurfacePiece& q = surface.piece[k];
            if (!(q.slope1 > steepest)) continue;
            steep_rho = float(q.slope0 >= steepest
                                  ? q.rho0
                                  : q.e + q.r * (steepest / __builtin_sqrt(1 + steepest * steepest)));
            break;
        }
    }

    FACETMILL_MEMBER void run() {
        for (int i = 0; i < packet.cut_nodes; ++i)
            open_node(packet.cut[i]);
        while (waiting > 0) {
            // Of the last few the most promising; when there are many, simply the last.
            int most = waiting - 1;
            for (int i = waiting - 2; waiting <= many && i >= 0 && i >= waiting - 2 * int(block_width); --i)
                most = key[i] > key[most] ? i : most;
            const Child next = child[most];
            const Float8 bound = load(child_bound[most]);
            --waiting;
            if (most != waiting) {
                key[most] = key[waiting];
                child[most] = child[waiting];
                store(load(child_bound[waiting]), child_bound[most]);
            }
            if (bits(bound > least) == 0) continue;
            const std::uint32_t which = next.node->child[next.lane];
            if (!(which & TreeNode::leaf))
                open_node(index.nodes[which]);
            else if (is_promising(*next.node, next.lane))
                open_block(which & ~TreeNode::leaf);
        }
        flush();
    }

private:
    static constexpr double steepest = tolerance::steepest_followed;

    const AxialPacket& packet;
    double* tips;

    Float8 dx, dy; ///< the places from the first
    float lo_dx = 0, hi_dx = 0, lo_dy = 0, hi_dy = 0;
    Float8 least;    ///< no more than the answers, from `zero`
    Float8 floor;    ///< stands for `least` where nothing is known yet
    float steep_rho; ///< g is followed up to here, where it has the steepest slope; from here its tangent

    // Children that are still to be opened. As long as they are few the most promising of the last is next;
    // then the last, and there are no more than seven siblings more on each of the levels below.
    static constexpr int many = 8 * block_width, most_waiting = many + 17 * int(block_width);
    float key[most_waiting];
    struct Child {
        const TreeNode* node;
        int lane;
    };
    Child child[most_waiting];
    alignas(32) float child_bound[most_waiting][float_lanes];
    int waiting = 0;

    // Facets for the exact test.
    static constexpr int most_candidates = 64;
    std::uint32_t candidate[most_candidates];
    alignas(32) float candidate_bound[most_candidates][float_lanes];
    int candidates = 0;

    FacetTest tested;
    int tested_place[double_lanes];
    int taken = 0;

    /// Edges of the eight facets of a block.
    struct Edges {
        float x[block_width], y[block_width], z[block_width]; ///< where it starts
        float ux[block_width], uy[block_width], run[block_width], slope[block_width];
        /// Where the plane touches: twice the area with the edge, positive inside; linear in the place.
        float side[block_width], side_x[block_width], side_y[block_width];
        float doubt[block_width]; ///< `side` is wrong by less
    };
    /// The eight facets of a block. `tangent`: no lift over the facet is higher; `plane`: none over its plane
    /// (and where it touches inside, the lift is that); both linear in the place.
    struct Prepared {
        float lo_x[block_width], hi_x[block_width], lo_y[block_width], hi_y[block_width], top[block_width];
        float plane[block_width], plane_x[block_width], plane_y[block_width];
        float tangent[block_width], tangent_x[block_width], tangent_y[block_width];
        float noise_in[block_width], noise_out[block_width]; ///< of `plane` touched inside, anywhere
        float loss[block_width];                             ///< of a lift a little inside of the rim
        float corner[block_width];                           ///< a side of more than this is inside
        float position[block_width], height_noise[block_width];
        Edges edge[3];
    };
    alignas(64) Prepared f;

    FACETMILL_MEMBER static float most_of(Float8 v) {
        v = larger(v, __builtin_shuffle(v, Int8{4, 5, 6, 7, 0, 1, 2, 3}));
        v = larger(v, __builtin_shuffle(v, Int8{2, 3, 0, 1, 6, 7, 4, 5}));
        return v[0] > v[1] ? v[0] : v[1];
    }
    FACETMILL_MEMBER static float least_of(const Float8& v) { return -most_of(-v); }

    FACETMILL_CALLED void open_node(const TreeNode& node) {
        const Float8 ax = load(node.cx) + at[0], ay = load(node.cy) + at[1];
        const Float8 hx = load(node.hx), hy = load(node.hy), reach = all(radius + slack);
        const Float8 top = load(node.cz) + load(node.hz) + margin;
        const Float8 near_x = larger(larger(ax - hx - hi_dx, lo_dx - ax - hx), all(0.0f)),
                     near_y = larger(larger(ay - hy - hi_dy, lo_dy - ay - hy), all(0.0f));
        unsigned reached = bits((hx >= 0.0f) & (near_x * near_x + near_y * near_y <= reach * reach)
                                & (top > least_of(least)));
        if (reached == 0) return;
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
        Float8 level, sx, sy;
        tangent_plane(mx, my, px, py, level, sx, sy);
        const Float8 qx = px - sx, qy = py - sy;
        const Float8 over = load(node.roof) - px * ax - py * ay - level + larger(qx * lo_x, qx * hi_x)
                            + larger(qy * lo_y, qy * hi_y) + margin;
        alignas(32) float base[block_width], base_x[block_width], base_y[block_width], tops[block_width];
        alignas(32) float left[block_width], right[block_width], front[block_width], back[block_width];
        store(over, base);
        store(sx, base_x);
        store(sy, base_y);
        store(top, tops);
        store(ax - hx, left);
        store(ax + hx, right);
        store(ay - hy, front);
        store(ay + hy, back);
        for (; reached != 0; reached &= reached - 1) {
            const int k = __builtin_ctz(reached);
            const Float8 gap_x = larger(larger(left[k] - dx, dx - right[k]), all(0.0f)),
                         gap_y = larger(larger(front[k] - dy, dy - back[k]), all(0.0f));
            Float8 bound = select(gap_x * gap_x + gap_y * gap_y <= reach * reach,
                                  smaller(base[k] + base_x[k] * dx + base_y[k] * dy, all(tops[k])),
                                  all(-__builtin_inff()));
            if (bits(bound > least) == 0) continue;
            key[waiting] = most_of(bound - larger(least, floor));
            child[waiting] = {&node, k};
            store(bound, child_bound[waiting]);
            ++waiting;
        }
    }

    /// To open a block costs more than a tangent of its own for every place.
    FACETMILL_CALLED bool is_promising(const TreeNode& node, int k) const {
        const Float8 cx = node.cx[k] + at[0] - dx, cy = node.cy[k] + at[1] - dy;
        return bits(bounds(cx, cy, all(node.hx[k]), all(node.hy[k]), all(node.cz[k] + node.hz[k]), cx, cy,
                           all(node.roof[k]), all(node.slope_x[k]), all(node.slope_y[k]))
                    > least)
               != 0;
    }

    /// The distance at which a plane of this slope touches.
    FACETMILL_MEMBER Float8 touching(const Float8& slope) const {
        const Float8 sine = slope / root(1.0f + slope * slope);
        Float8 rho = all(float(surface.max_radius));
        for (int i = surface.count - 1; i >= 0; --i) {
            const SurfacePiece& p = surface.piece[i];
            if (p.r != 0) {
                const Float8 on_arc =
                    smaller(larger(float(p.e) + float(p.r) * sine, all(float(p.rho0))), all(float(p.rho1)));
                rho = select(slope <= float(p.slope1), on_arc, rho);
            }
            rho = select(slope <= float(p.slope0), all(float(p.rho0)), rho);
        }
        return rho;
    }

    FACETMILL_MEMBER void prepare(const FacetBlock& block) {
        const float r = float(surface.max_radius), share = float(tolerance::float_slack);
        Float8 px[3], py[3], pz[3];
        for (int k = 0; k < 3; ++k) {
            const double ox = query.place[0], oy = query.place[1];
            px[k] = narrow(load(block.x[k]) - ox, load(block.x[k] + 4) - ox);
            py[k] = narrow(load(block.y[k]) - oy, load(block.y[k] + 4) - oy);
            pz[k] = narrow(load(block.z[k]) - zero, load(block.z[k] + 4) - zero);
        }
        const Float8 lo_x = smaller(smaller(px[0], px[1]), px[2]), hi_x = larger(larger(px[0], px[1]), px[2]);
        const Float8 lo_y = smaller(smaller(py[0], py[1]), py[2]), hi_y = larger(larger(py[0], py[1]), py[2]);
        const Float8 far = larger(larger(hi_x, -lo_x), larger(hi_y, -lo_y)) + 3 * r;
        const Float8 z_size = larger(larger(magnitude(pz[0]), magnitude(pz[1])), magnitude(pz[2]));
        const Float8 position = share * far;
        store(lo_x - position, f.lo_x);
        store(hi_x + position, f.hi_x);
        store(lo_y - position, f.lo_y);
        store(hi_y + position, f.hi_y);
        store(larger(larger(pz[0], pz[1]), pz[2]) + share * z_size, f.top);
        store(position, f.position);
        store(share * z_size, f.height_noise);

        const Float8 wx = px[1] - px[0], wy = py[1] - py[0], wz = pz[1] - pz[0];
        const Float8 vx = px[2] - px[0], vy = py[2] - py[0], vz = pz[2] - pz[0];
        const Float8 nx = wy * vz - wz * vy, ny = wz * vx - wx * vz, nz = wx * vy - wy * vx;
        const Float8 per = -1.0f / nz, sx = nx * per, sy = ny * per, slope = root(sx * sx + sy * sy);
        const Float8 longest = root(wx * wx + wy * wy); // edge 0
        const Float8 height = magnitude(nz) / longest;
        const Float8 noise = share * (z_size + (1 + slope) * far);
        const Float8 slope_doubt = 4 * noise / height; // of the slope as a vector
        const Int8 sure = (slope_doubt < float(tolerance::trusted_slope))
                          & (slope < float(tolerance::steepest_trusted))
                          & (position < float(tolerance::trusted_height) * height);
        const Float8 rho = touching(larger(slope - slope_doubt, all(0.0f)));
        const Float8 outer = touching(slope + slope_doubt);
        const Float8 contact_doubt =
            outer - rho + outer * smaller(2 * slope_doubt / slope, all(2.0f)) + 2 * position;
        const Float8 out = select(slope > 0.0f, rho / slope, all(0.0f));
        const Float8 mx = sx * out, my = sy * out;
        const Float8 never = all(__builtin_inff());
        store(select(sure, pz[0] + sx * (mx - px[0]) + sy * (my - py[0]) - rough_height(rho), never),
              f.plane);
        store(select(sure, sx, all(0.0f)), f.plane_x);
        store(select(sure, sy, all(0.0f)), f.plane_y);
        store(noise + slope_doubt * (longest + contact_doubt), f.noise_in);
        store(noise + slope_doubt * far, f.noise_out);
        const float middle_x = 0.5f * (lo_dx + hi_dx), middle_y = 0.5f * (lo_dy + hi_dy);
        const Float8 tx = smaller(larger(mx, lo_x - middle_x), hi_x - middle_x),
                     ty = smaller(larger(my, lo_y - middle_y), hi_y - middle_y);
        Float8 level, gx, gy;
        tangent_plane(tx, ty, sx, sy, level, gx, gy);
        Float8 over = pz[0] - gx * px[0] - gy * py[0];
        over = larger(over, pz[1] - gx * px[1] - gy * py[1]);
        over = larger(over, pz[2] - gx * px[2] - gy * py[2]);
        store(over - level + share * (z_size + 20 * far), f.tangent);
        store(gx, f.tangent_x);
        store(gy, f.tangent_y);
        // The point of contact for the lower bound is moved inside of the rim.
        store(slope * larger(rho - (r - 3 * position), all(0.0f)), f.loss);
        const Float8 sign = select(nz < 0.0f, all(-1.0f), all(1.0f));
        const Float8 corner = 4 * position * longest;
        store(select(sure, corner, never), f.corner);
        for (int k = 0; k < 3; ++k) {
            const int n = k == 2 ? 0 : k + 1;
            Edges& e = f.edge[k];
            const Float8 ex = px[n] - px[k], ey = py[n] - py[k], run = root(ex * ex + ey * ey),
                         per_run = 1.0f / run;
            store(px[k], e.x);
            store(py[k], e.y);
            store(pz[k], e.z);
            store(ex * per_run, e.ux);
            store(ey * per_run, e.uy);
            store(run, e.run);
            store((pz[n] - pz[k]) * per_run, e.slope);
            store(sign * (ex * (my - py[k]) - ey * (mx - px[k])), e.side);
            store(-sign * ey, e.side_x);
            store(sign * ex, e.side_y);
            store(select(sure, run * contact_doubt + corner, never), e.doubt);
        }
    }

    /// Uphill from the foot of the axis, about where a line at distance l from the axis touches that rises by
    /// `slope` >= 0.
    FACETMILL_MEMBER Float8 line_guess(const Float8& l, const Float8& slope) const {
        const auto leg = [](const Float8& a, const Float8& b) __attribute__((always_inline)) {
            return root(larger((a - b) * (a + b), all(0.0f)));
        };
        Float8 s = all(0.0f);
        for (int i = 0; i < surface.count; ++i) {
            const SurfacePiece& p = surface.piece[i];
            Float8 here;
            if (p.r == 0) {
                const Float8 k = all(float(p.slope0));
                here = l * slope / root(larger((k - slope) * (k + slope), all(1e-30f)));
                here = select(slope >= k, slope * 1e30f, here);
            } else {
                const Float8 over = 1.0f / root(1.0f + slope * slope), sine = slope * over;
                const float e = float(p.e), r = float(p.r);
                if (p.e == 0) {
                    here = sine * leg(all(r), l);
                } else {
                    const Float8 target = l * over;
                    Float8 y = larger(all(0.0f), larger((target - e) / r, target * sine / (e + r * sine)));
                    Float8 x = root(y * y + sine * sine);
                    const Float8 per = 1.0f / x; // a step of Newton's is enough for a guess
                    const Float8 value = e * y * per + r * y - target;
                    const Float8 change = e * sine * sine * per * per * per + r;
                    y = smaller(larger(y - value / change, all(0.0f)), all(1.0f));
                    x = smaller(root(y * y + sine * sine), all(1.0f));
                    here = leg(e + r * x, l);
                }
            }
            if (i == 0) {
                s = here;
                continue;
            }
            const float joint = float(p.rho0);
            const Float8 s0 = leg(all(joint), l);
            const Int8 beyond = (l >= joint) | (slope * joint > float(surface.piece[i - 1].slope1) * s0);
            s = select(beyond, larger(here, s0), s);
        }
        return s;
    }

    /// Bounds of the lift over an edge of a facet.
    FACETMILL_MEMBER void edge_bounds(const Edges& e, int lane, Float8& above, Float8& below) const {
        const Float8 never = all(-__builtin_inff());
        const Float8 ax = e.x[lane] - dx, ay = e.y[lane] - dy;
        const float position = f.position[lane], r = float(surface.max_radius), run = e.run[lane];
        const float slope = e.slope[lane], steep = slope < 0 ? -slope : slope;
        const float noise = f.height_noise[lane] + (float(steepest) + 4 + steep) * position;
        if (!(steep < float(tolerance::steepest_edge) && run > 0)) {
            below = never;
            above = all(f.top[lane]);
            return;
        }
        const Float8 from = ax * e.ux[lane] + ay * e.uy[lane], to = from + run;
        const Float8 l = magnitude(ax * e.uy[lane] - ay * e.ux[lane]);
        const float wide = r + 2 * position, narrow_r = r - 3 * position;
        const Float8 half = root(larger((wide - l) * (wide + l), all(0.0f)));
        const Float8 lo = larger(from, -half), hi = smaller(to, half);
        const Int8 reached = (l <= wide) & (lo <= hi + 4 * position);
        Float8 s = line_guess(smaller(l, all(r)), all(steep));
        s = slope < 0 ? -s : s;
        const Float8 half_in = float(1 - tolerance::rim_share) * half;
        s = smaller(larger(s, -half_in), half_in);
        s = smaller(larger(s, from), to);
        const Float8 rho = root(l * l + s * s);
        // g and its slope, or the tangent of the steepest place that is followed.
        const Float8 followed = smaller(rho, all(steep_rho));
        Float8 g = all(0.0f), change = all(0.0f);
        for (int i = 0; i < surface.count; ++i) {
            const SurfacePiece& p = surface.piece[i];
            Float8 here, change_here;
            if (p.r == 0) {
                here = float(p.z0) + float(p.slope0) * (followed - float(p.rho0));
                change_here = all(float(p.slope0));
            } else {
                const Float8 away = followed - float(p.e);
                const Float8 up = root(larger((float(p.r) - away) * (float(p.r) + away), all(1e-12f)));
                here = float(p.f) - up;
                change_here = larger(away, all(0.0f)) / up;
            }
            const Int8 in = followed > (i == 0 ? -1.0f : float(surface.piece[i - 1].rho1));
            g = select(in, here, g);
            change = select(in, change_here, change);
        }
        change = smaller(change, all(float(steepest)));
        const Float8 lift = e.z[lane] + slope * (s - from) - g;
        const Float8 rises = slope - change * (s / larger(rho, all(1e-30f)));
        below =
            select(reached & (rho < smaller(all(narrow_r + position), all(steep_rho))), lift - noise, never);
        above = lift - change * (rho - followed) + larger(rises * (lo - s), rises * (hi - s)) + noise;
        above = select(reached, above, never);
    }

    FACETMILL_CALLED void open_block(std::uint32_t which) {
        const FacetBlock& block = index.blocks[which];
        prepare(block);
        const Float8 near_x = larger(larger(load(f.lo_x) - hi_dx, lo_dx - load(f.hi_x)), all(0.0f)),
                     near_y = larger(larger(load(f.lo_y) - hi_dy, lo_dy - load(f.hi_y)), all(0.0f));
        const Float8 reach = all(radius);
        unsigned open =
            bits((near_x * near_x + near_y * near_y <= reach * reach) & (load(f.top) > least_of(least)));
        const Float8 never = all(-__builtin_inff());
        for (; open != 0; open &= open - 1) {
            const int k = __builtin_ctz(open);
            const unsigned duty = block.duty[k] & duty_upright;
            if (duty == 0) continue;
            const Float8 gap_x = larger(larger(f.lo_x[k] - dx, dx - f.hi_x[k]), all(0.0f)),
                         gap_y = larger(larger(f.lo_y[k] - dy, dy - f.hi_y[k]), all(0.0f));
            const Float8 plane = f.plane[k] + f.plane_x[k] * dx + f.plane_y[k] * dy;
            const Float8 tangent = f.tangent[k] + f.tangent_x[k] * dx + f.tangent_y[k] * dy;
            const Float8 cap = smaller(tangent, smaller(plane + f.noise_out[k], all(f.top[k])));
            const Int8 alive = (gap_x * gap_x + gap_y * gap_y <= reach * reach) & (cap > least);
            if (bits(alive) == 0) continue;
            const auto side = [&](int e) __attribute__((always_inline)) {
                return f.edge[e].side[k] + f.edge[e].side_x[k] * dx + f.edge[e].side_y[k] * dy;
            };
            const Float8 side0 = side(0), side1 = side(1), side2 = side(2);
            Float8 above = never, below = never;
            if (duty & duty_plane) {
                const Int8 outside = (side0 < -f.edge[0].doubt[k]) | (side1 < -f.edge[1].doubt[k])
                                     | (side2 < -f.edge[2].doubt[k]);
                const float corner = f.corner[k];
                const Int8 inside = (side0 > corner) & (side1 > corner) & (side2 > corner);
                above = select(outside, never, select(inside, plane + f.noise_in[k], cap));
                below = select(inside, plane - f.noise_in[k] - f.loss[k], never);
            }
            for (int e = 0; e < 3; ++e) {
                if (!(duty & (duty_edge << e))) continue;
                const Float8 here = e == 0 ? side0 : e == 1 ? side1 : side2;
                Int8 seen = alive;
                if (duty & duty_plane) seen &= ~(here >= f.edge[e].doubt[k]);
                if (bits(seen) == 0) continue;
                Float8 edge_above, edge_below;
                edge_bounds(f.edge[e], k, edge_above, edge_below);
                above = select(seen, larger(edge_above, above), above);
                below = larger(edge_below, below);
            }
            above = smaller(above, cap);
            least = larger(below, least);
            if (bits(alive & (above > least)) == 0) continue;
            if (candidates == most_candidates) make_room();
            candidate[candidates] = which * std::uint32_t(block_width) + std::uint32_t(k);
            store(select(alive, above, never), candidate_bound[candidates]);
            ++candidates;
        }
    }

    FACETMILL_CALLED void make_room() {
        int left = 0;
        for (int i = 0; i < candidates; ++i) {
            const Float8 bound = load(candidate_bound[i]);
            if (bits(bound > least) == 0) continue;
            candidate[left] = candidate[i];
            store(bound, candidate_bound[left++]);
        }
        candidates = left;
        if (2 * candidates > most_candidates) flush();
    }

    FACETMILL_CALLED void flush() {
        for (int i = 0; i < candidates; ++i) {
            const Float8 bound = load(candidate_bound[i]);
            for (unsigned lanes = bits(bound > least); lanes != 0; lanes &= lanes - 1) {
                const int lane = __builtin_ctz(lanes);
                if (lane >= packet.count) break;
                const std::uint32_t slot = candidate[i];
                tested.set(index.blocks[slot / block_width], slot % block_width, packet.x[lane],
                           packet.y[lane], taken);
                tested.most_lift[taken] = double(bound[lane]) + zero;
                tested_place[taken++] = lane;
                if (taken == double_lanes) test();
            }
        }
        if (taken > 0) test();
        candidates = 0;
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
            const float low = rounded_down(floor4[w]);
            if (low > least[place]) least[place] = low;
        }
        taken = 0;
    }
};

void packet(const IndexView& index, const SurfaceTable& surface, const AxialPacket& packet,
            double (&tips)[AxialPacket::most_places]) {
    AxialQuery first;
    first.place[0] = packet.x[0];
    first.place[1] = packet.y[0];
    PacketSearch search(index, surface, packet, first, tips);
    if (index.nodes) search.run();
}

} // namespace

} // namespace facetmill::simd
