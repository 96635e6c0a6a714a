// Body of axial_kernel_*.cpp. The lift of a cutter over a mesh is the largest lift over its facets. A tree of
// boxes finds the facets that matter, by bounds from the convexity of the cutter:
//
// The lift z - g(rho) over a point of a facet is a concave function where z is a plane, so its tangent plane
// at one place bounds it everywhere. For a child of a node the plane is its roof, and the tangent that at the
// point of its box nearest to where the roof touches; the bound is wrong by second order in the size of the
// box only. So hardly a block is opened but those where the cutter touches.
//
// Bounds are floats, widened above their rounding; lifts are doubles.
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_elements.h"
#include "core/gouge/axial_kernel.h"

namespace facetmill::simd {

namespace {

template <bool tilted>
struct Search {
    const IndexView& index;
    const SurfaceTable& surface;
    const AxialQuery& query;
    AxialAnswer& best;

    float rim;               ///< distances beyond this are at the rim
    float inner;             ///< distances below this are surely within the cutter
    float radius;            ///< of the cutter, widened
    float slack;             ///< positions of boxes in the frame are wrong by less
    float margin;            ///< bounds are wrong by less
    float uncertain;         ///< how much a bound changes with a position, at most
    float per_tangent;       ///< index of tangent = rho * this
    float at[3];             ///< the index's origin from the place
    float turn[3][3];        ///< the frame
    double zero;             ///< bounds are relative to this height
    float sure;              ///< lower bounds of facets seen so far say that the answer is more, from `zero`
    std::uint32_t sure_slot; ///< the facet that says so
    float least;             ///< no less than best.tip from `zero`, and no more than the answer

    // Facets under test, and those that wait for it.
    alignas(32) double x[3][4], y[3][4], z[3][4];
    alignas(32) double most_lift[4]; ///< their bounds
    alignas(32) std::int64_t has_edge[3][4], has_plane[4];
    std::uint32_t slot[4];
    // Lists have room for one more vector than they hold.
    static constexpr int most_waiting = 24, most_blocks = 64;
    float waiting_bound[most_waiting + block_width];
    std::uint32_t waiting_slot[most_waiting + block_width];
    int waiting = 0;

    // Nodes and blocks that are still to be opened. With full nodes the tree is no deeper than the digits of
    // the facet count in base 8; seven siblings wait on every level.
    static constexpr int most_nodes = block_width * 16;
    float node_bound[most_nodes + block_width];
    std::uint32_t node_child[most_nodes + block_width];
    int nodes = 0;
    float block_bound[most_blocks + block_width];
    std::uint32_t block_child[most_blocks + block_width];
    int blocks = 0;
    std::uint32_t opened; ///< a block that was opened first

    FACETMILL_MEMBER Search(const IndexView& i, const SurfaceTable& s, const AxialQuery& q, AxialAnswer& b)
        : index(i), surface(s), query(q), best(b) {
        double away = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
            const double d = index.origin[k] - query.place[k];
            if (k < 2 || tilted) away += d < 0 ? -d : d;
            size += index.half_size[k];
            at[k] = float(d);
            if constexpr (tilted)
                for (int j = 0; j < 3; ++j)
                    turn[k][j] = float(query.frame[k][j]);
        }
        zero = tilted ? 0 : index.origin[2];
        if (!tilted) at[2] = 0;
        const double r = surface.max_radius, scale = away + size + r;
        const double steep = tolerance::steepest_roof + tolerance::steepest_tangent;
        slack = float(tolerance::float_slack * scale);
        inner = float(r * (1 - tolerance::rim_share));
        radius = float(r * (1 + tolerance::float_slack)) + slack;
        rim = surface.has_rim ? inner : __builtin_inff();
        margin = float(tolerance::float_slack * (1 + steep) * (tilted ? 4 : 1) * scale);
        uncertain = float(4 * (1 + steep));
        per_tangent = float(surface_tangents / r);
        best.tip = query.least;
        best.slot = no_slot;
        least = sure = -__builtin_inff();
        raise(best.tip);
    }

    /// Rounded down: what is higher by the last digit of a double must not be passed over.
    FACETMILL_MEMBER void raise(double tip) {
        const double from_zero = tip - zero;
        auto rounded = float(from_zero);
        if (double(rounded) > from_zero) rounded = __builtin_nextafterf(rounded, -__builtin_inff());
        least = rounded > least ? rounded : least;
    }

    /// About where a plane touches the cutter; (ux, uy): uphill, as long as the sine of its slope.
    FACETMILL_MEMBER void touched(const Float8& ux, const Float8& uy, Float8& x_out, Float8& y_out) const {
        if (surface.guess_e == 0 && surface.guess_level == 0) { // a ball
            x_out = ux * surface.guess_r;
            y_out = uy * surface.guess_r;
            return;
        }
        const Float8 square = ux * ux + uy * uy;
        const Float8 scale =
            select(square > surface.guess_level * surface.guess_level,
                   surface.guess_e * rough_inverse_root(larger(square, all(__FLT_MIN__))) + surface.guess_r,
                   all(0.0f));
        x_out = ux * scale;
        y_out = uy * scale;
    }

    /// A plane below g that is near it at (mx, my): level + sx x + sy y. At the rim, where g ends, the one of
    /// those that is as steep there as the part's plane with slopes (px, py).
    FACETMILL_MEMBER void tangent_plane(const Float8& mx, const Float8& my, const Float8& px,
                                        const Float8& py, Float8& level, Float8& sx, Float8& sy) const {
        const Float8 square = mx * mx + my * my;
        // A little short, so that no direction is longer than 1.
        const Float8 per = (1 - 2 * rough_share) * rough_inverse_root(larger(square, all(__FLT_MIN__)));
        const Float8 rho = square * per;
        const Int8 entry = truncated(smaller(rho * per_tangent, all(float(surface_tangents) - 1)));
        const Int8 low = entry & 7;
        const Int8 upper = entry > 7;
        const Float8 ux = mx * per, uy = my * per;
        level = select(upper, pick(load(surface.tangent_at0 + 8), low), pick(load(surface.tangent_at0), low));
        Float8 slope =
            select(upper, pick(load(surface.tangent_slope + 8), low), pick(load(surface.tangent_slope), low));
        const Int8 at_rim = rho >= rim;
        const Float8 steep = smaller(larger(px * ux + py * uy, all(surface.rim_slope)),
                                     all(float(tolerance::steepest_tangent)));
        slope = select(at_rim, steep, slope);
        level = select(at_rim, surface.rim_height - steep * radius, level);
        sx = slope * ux;
        sy = slope * uy;
    }

    /// Bounds of the lifts over eight boxes in the cutter's frame: middle, half size, top, and a roof that
    /// has height `roof` over (rx, ry). -inf where the cutter does not reach.
    FACETMILL_MEMBER Float8 bounds(const Float8& cx, const Float8& cy, const Float8& hx, const Float8& hy,
                                   const Float8& top, const Float8& rx, const Float8& ry, const Float8& roof,
                                   const Float8& px, const Float8& py) const {
        const Float8 reach = all(radius);
        const Float8 lo_x = larger(cx - hx - slack, -reach), hi_x = smaller(cx + hx + slack, reach);
        const Float8 lo_y = larger(cy - hy - slack, -reach), hi_y = smaller(cy + hy + slack, reach);
        const Float8 near_x = larger(larger(lo_x, -hi_x), all(0.0f)),
                     near_y = larger(larger(lo_y, -hi_y), all(0.0f));
        const Int8 reached =
            (lo_x <= hi_x) & (lo_y <= hi_y) & (near_x * near_x + near_y * near_y <= reach * reach);
        // The tangent plane of the lift over the roof is taken at the point of the box nearest to where the
        // roof touches the cutter: there the lift is about highest.
        const Float8 per = rough_inverse_root(1.0f + px * px + py * py);
        Float8 mx, my;
        touched(px * per, py * per, mx, my);
        mx = smaller(larger(mx, lo_x), hi_x);
        my = smaller(larger(my, lo_y), hi_y);
        Float8 level, sx, sy;
        tangent_plane(mx, my, px, py, level, sx, sy);
        const Float8 gx = px - sx, gy = py - sy;
        const Float8 over =
            roof - px * rx - py * ry - level + larger(gx * lo_x, gx * hi_x) + larger(gy * lo_y, gy * hi_y);
        return select(reached, smaller(over, top) + margin, all(-__builtin_inff()));
    }

    FACETMILL_MEMBER Float8 child_bounds(const TreeNode& node) const {
        const Float8 ax = load(node.cx) + at[0], ay = load(node.cy) + at[1], az = load(node.cz);
        const Float8 hx = load(node.hx), hy = load(node.hy), hz = load(node.hz);
        const Float8 roof = load(node.roof), px = load(node.slope_x), py = load(node.slope_y);
        if constexpr (!tilted) {
            return bounds(ax, ay, hx, hy, az + hz, ax, ay, roof, px,
                          py); // unused lanes reach nowhere: hx < 0
        } else {
            const auto& m = turn;
            const auto size = [](float v) { return v < 0 ? -v : v; };
            const Float8 bz = az + at[2], rz = roof + at[2];
            const Float8 cx = m[0][0] * ax + m[0][1] * ay + m[0][2] * bz;
            const Float8 cy = m[1][0] * ax + m[1][1] * ay + m[1][2] * bz;
            const Float8 cz = m[2][0] * ax + m[2][1] * ay + m[2][2] * bz;
            const Float8 ex = size(m[0][0]) * hx + size(m[0][1]) * hy + size(m[0][2]) * hz;
            const Float8 ey = size(m[1][0]) * hx + size(m[1][1]) * hy + size(m[1][2]) * hz;
            const Float8 ez = size(m[2][0]) * hx + size(m[2][1]) * hy + size(m[2][2]) * hz;
            // The roof's plane in the frame, where it is still a roof and not too steep.
            const Float8 up = m[2][2] - m[2][0] * px - m[2][1] * py;
            const Float8 nx = m[0][2] - m[0][0] * px - m[0][1] * py,
                         ny = m[1][2] - m[1][0] * px - m[1][1] * py;
            const Int8 roofed = larger(magnitude(nx), magnitude(ny)) <= float(tolerance::steepest_roof) * up;
            const Float8 zero8 = all(0.0f), per = 1.0f / select(roofed, up, all(1.0f));
            const Float8 sx = select(roofed, -nx * per, zero8), sy = select(roofed, -ny * per, zero8);
            const Float8 rx = m[0][0] * ax + m[0][1] * ay + m[0][2] * rz;
            const Float8 ry = m[1][0] * ax + m[1][1] * ay + m[1][2] * rz;
            const Float8 rh = m[2][0] * ax + m[2][1] * ay + m[2][2] * rz;
            const Float8 top = cz + ez;
            const Float8 b = bounds(cx, cy, ex, ey, top, rx, ry, select(roofed, rh, top), sx, sy);
            return select(hx >= 0.0f, b, all(-__builtin_inff()));
        }
    }

    /// g in single precision; rho within the radius.
    FACETMILL_MEMBER Float8 rough_height(const Float8& rho) const {
        Float8 g = all(0.0f);
        for (int i = 0; i < surface.count; ++i) {
            const SurfacePiece& p = surface.piece[i];
            Float8 here;
            if (p.r == 0) {
                here = float(p.z0) + float(p.slope0) * (rho - float(p.rho0));
            } else {
                const Float8 out = rho - float(p.e);
                here = float(p.f) - root(larger((float(p.r) - out) * (float(p.r) + out), all(0.0f)));
            }
            g = i == 0 ? here : select(rho > float(surface.piece[i - 1].rho1), here, g);
        }
        return g;
    }

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
        const Int8 reached = near_x * near_x + near_y * near_y <= radius * radius;
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
        mx = smaller(larger(mx, lo_x), hi_x);
        my = smaller(larger(my, lo_y), hi_y);
        Float8 level, sx, sy;
        tangent_plane(mx, my, nx * up, ny * up, level, sx, sy);
        Float8 most = pz[0] - sx * px[0] - sy * py[0];
        most = larger(most, pz[1] - sx * px[1] - sy * py[1]);
        most = larger(most, pz[2] - sx * px[2] - sy * py[2]);
        const Float8 size = larger(larger(hi_x, -lo_x), larger(hi_y, -lo_y));
        const Float8 highest_z = larger(larger(magnitude(pz[0]), magnitude(pz[1])), magnitude(pz[2]));
        const Float8 noise = float(tolerance::float_slack) * (highest_z + uncertain * (size + radius));
        if constexpr (both) {
            // The point of the facet with the same barycentric coordinates, those below 0 made 0.
            const auto weight = [&](int i, int j) __attribute__((always_inline)) {
                const Float8 w = (px[i] - ax) * (py[j] - ay) - (px[j] - ax) * (py[i] - ay);
                return larger(select(nz < 0.0f, -w, w), all(0.0f));
            };
            const Float8 w0 = weight(1, 2), w1 = weight(2, 0), w2 = weight(0, 1);
            const Float8 share = 1.0f / (w0 + w1 + w2);
            const Float8 qx = share * (w0 * px[0] + w1 * px[1] + w2 * px[2]);
            const Float8 qy = share * (w0 * py[0] + w1 * py[1] + w2 * py[2]);
            const Float8 qz = share * (w0 * pz[0] + w1 * pz[1] + w2 * pz[2]);
            const Float8 q_square = qx * qx + qy * qy;
            // Where the cutter's side is steep, its height at a rounded distance says nothing: stay inside.
            const Float8 q_rho = root(q_square) + float(tolerance::float_slack) * (size + radius);
            below = select((q_rho < inner) & (q_square >= 0.0f),
                           qz - (1 + float(tolerance::float_slack)) * rough_height(q_rho) - noise,
                           all(-__builtin_inff()));
        }
        return select(reached, most - level + noise, all(-__builtin_inff()));
    }

    FACETMILL_MEMBER void gather(std::uint32_t which, int w) {
        const FacetBlock& block = index.blocks[which / block_width];
        const std::uint32_t lane = which % block_width;
        slot[w] = which;
        unsigned duty = block.duty[lane];
        if constexpr (!tilted) {
            for (int k = 0; k < 3; ++k) {
                x[k][w] = block.x[k][lane] - query.place[0];
                y[k][w] = block.y[k][lane] - query.place[1];
                z[k][w] = block.z[k][lane];
            }
        } else {
            const auto& m = query.frame;
            double cx[3], cy[3], cz[3];
            for (int k = 0; k < 3; ++k) {
                const double ax = block.x[k][lane] - query.place[0], ay = block.y[k][lane] - query.place[1],
                             az = block.z[k][lane] - query.place[2];
                cx[k] = m[0][0] * ax + m[0][1] * ay + m[0][2] * az;
                cy[k] = m[1][0] * ax + m[1][1] * ay + m[1][2] * az;
                cz[k] = m[2][0] * ax + m[2][1] * ay + m[2][2] * az;
            }
            // The longest edge first, as the lift over the plane wants it.
            int first = 0;
            double longest = -1;
            for (int k = 0; k < 3; ++k) {
                const int n = k == 2 ? 0 : k + 1;
                const double ex = cx[n] - cx[k], ey = cy[n] - cy[k], square = ex * ex + ey * ey;
                if (square > longest) {
                    longest = square;
                    first = k;
                }
            }
            unsigned edges = 0;
            for (int k = 0; k < 3; ++k) {
                const int from = (k + first) % 3;
                x[k][w] = cx[from];
                y[k][w] = cy[from];
                z[k][w] = cz[from];
                if (duty & (duty_edge_anyway << from)) edges |= 1u << k;
            }
            // The coordinates themselves carry rounding from being turned: a projection that it could have
            // made has no area, and then its edges say everything.
            const double left = (x[1][w] - x[0][w]) * (y[2][w] - y[0][w]),
                         right = (y[1][w] - y[0][w]) * (x[2][w] - x[0][w]), area = left - right;
            const double noise = tolerance::area_roundings * 0.5 * __DBL_EPSILON__
                                 * ((left < 0 ? -left : left) + (right < 0 ? -right : right));
            duty = edges | (area > noise || area < -noise ? unsigned(duty_plane) : 0u);
        }
        for (int k = 0; k < 3; ++k)
            has_edge[k][w] = duty & (duty_edge << k) ? -1 : 0;
        has_plane[w] = duty & duty_plane ? -1 : 0;
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
            most_lift[taken] = double(waiting_bound[next]) + zero;
            gather(waiting_slot[next], taken++);
            --waiting;
            waiting_bound[next] = waiting_bound[waiting];
            waiting_slot[next] = waiting_slot[waiting];
        }
        if (taken == 0) return;
        for (int w = taken; w < double_lanes; ++w) {
            for (int k = 0; k < 3; ++k) {
                x[k][w] = x[k][0];
                y[k][w] = y[k][0];
                z[k][w] = z[k][0];
                has_edge[k][w] = 0;
            }
            has_plane[w] = 0;
            most_lift[w] = -__builtin_inf();
        }
        const Point4 p[3] = {{load(x[0]), load(y[0]), load(z[0])},
                             {load(x[1]), load(y[1]), load(z[1])},
                             {load(x[2]), load(y[2]), load(z[2])}};
        const auto mask = [](const std::int64_t* m) __attribute__((always_inline)) {
            Mask4 v;
            __builtin_memcpy(&v, m, sizeof v);
            return v;
        };
        const PlaneLift4 plane = plane_lift(surface, mask(has_plane), p, tolerance::contact_roundings);
        static constexpr int no_edge[] = {-1, -1, -1, -1};
        consider(plane.lift, no_edge);
        const Mask4 edges[3] = {mask(has_edge[0]), mask(has_edge[1]), mask(has_edge[2])};
        Mask4 open = ~plane.inside & (load(most_lift) > best.tip);
        // First the edge that the way to the plane's contact leaves by. If it is touched between its ends the
        // facet is done: from a higher place y of the facet a straight way to the plane's contact, on which
        // the lift is nowhere lower than at y, would cross the edge's line where it is higher than its
        // highest.
        const Mask4 first_is_1 = plane.side[1] < plane.side[0];
        const Double4 lower = select(first_is_1, plane.side[1], plane.side[0]);
        const Mask4 first_is_2 = plane.side[2] < lower;
        Mask4 asked_first = open & plane.outside & (edges[0] | edges[1] | edges[2]);
        if (bits(asked_first) != 0) {
            const auto one = [&](const Double4& v0, const Double4& v1, const Double4& v2)
                __attribute__((always_inline)) {
                return select(first_is_2, v2, select(first_is_1, v1, v0));
            };
            const Point4 a{one(p[0].x, p[1].x, p[2].x), one(p[0].y, p[1].y, p[2].y),
                           one(p[0].z, p[1].z, p[2].z)};
            const Point4 b{one(p[1].x, p[2].x, p[0].x), one(p[1].y, p[2].y, p[0].y),
                           one(p[1].z, p[2].z, p[0].z)};
            const Lift4 lift = edge_lift(surface, asked_first, a, b, all(0.0));
            const unsigned one_bits = bits(first_is_1), two_bits = bits(first_is_2);
            int edge[double_lanes];
            for (int k = 0; k < double_lanes; ++k)
                edge[k] = two_bits >> k & 1 ? 2 : int(one_bits >> k & 1);
            consider(lift, edge);
            open &= ~lift.between & (load(most_lift) > best.tip);
        }
        if (bits(open) != 0) {
            const Mask4 was_first[3] = {asked_first & ~first_is_1 & ~first_is_2,
                                        asked_first & first_is_1 & ~first_is_2, asked_first & first_is_2};
            static constexpr int number[3][double_lanes] = {{0, 0, 0, 0}, {1, 1, 1, 1}, {2, 2, 2, 2}};
            for (int k = 0; k < 3; ++k) {
                const Point4 &a = p[k], &b = p[k == 2 ? 0 : k + 1];
                const Mask4 border = plane.border & (plane.side[k] < 0.0);
                const Mask4 asked =
                    open & (edges[k] | border) & ~was_first[k] & (larger(a.z, b.z) > best.tip);
                if (bits(asked) == 0) continue;
                consider(edge_lift(surface, asked, a, b, select(border, plane.edge_slack, all(0.0))),
                         number[k]);
            }
        }
        raise(best.tip);
    }

    /// The first block that is opened gives a lower bound too: it lets most of the tree be passed over.
    template <bool first>
    FACETMILL_CALLED void open_block(std::uint32_t which) {
        const FacetBlock& block = index.blocks[which];
        Float8 below;
        const Float8 above = facet_bounds<first>(block, below);
        if constexpr (first) {
            alignas(32) float bound[block_width];
            store(below, bound);
            for (unsigned lanes = bits(below > least); lanes != 0; lanes &= lanes - 1) {
                const int lane = __builtin_ctz(lanes);
                if (!(bound[lane] > least)) continue;
                least = sure = bound[lane];
                sure_slot = which * std::uint32_t(block_width) + std::uint32_t(lane);
            }
        }
        std::uint32_t slots[block_width];
        for (std::uint32_t k = 0; k < block_width; ++k)
            slots[k] = which * std::uint32_t(block_width) + k;
        waiting += keep(bits(above > least), above, slots, waiting_bound + waiting, waiting_slot + waiting);
        while (waiting > most_waiting)
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

    FACETMILL_CALLED void open_node(const TreeNode& node) {
        const Float8 bound = child_bounds(node);
        const unsigned lanes = bits(bound > least), leaf = leaves(node);
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
        int most = count - 1;
        for (int i = count - 2; i >= 0 && i >= count - 2 * int(block_width); --i)
            most = bound[i] > bound[most] ? i : most;
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
            if (is_enough()) return;
        }
        while (nodes > 0) {
            --nodes;
            if (!(node_bound[nodes] > least)) continue;
            open_node(index.nodes[node_child[nodes]]);
            if (blocks > most_blocks) {
                open_blocks();
                if (is_enough()) return;
            }
        }
        open_blocks();
        while (waiting > 0 && !is_enough())
            test();
    }
};

template <bool tilted>
void search(const IndexView& index, const SurfaceTable& surface, const AxialQuery& query,
            AxialAnswer& answer) {
    Search<tilted> search(index, surface, query, answer);
    if (index.nodes) search.run();
}

} // namespace

} // namespace facetmill::simd
