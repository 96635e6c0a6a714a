// Body of axial_kernel_*.cpp: what a block's facets ask of a cutter with a vertical axis, in single precision
// and from above and below, as packets of places want it (axial_packet_impl.h): prepared once for a block,
// from the block's own origin, linear in the place where that is possible.
#pragma once

#include "core/base/tolerances.h"
#include "core/gouge/axial_bounds.h"
#include "core/gouge/prepared_blocks.h"

namespace facetmill::simd {

namespace {

template <SurfaceShape shape>
struct PreparedBounds : Bounds<false, shape> {
    using Base = Bounds<false, shape>;
    using Base::ball, Base::pieces, Base::is_arc, Base::touching, Base::tangent_plane, Base::rough_height;
    using Base::surface, Base::zero, Base::inner, Base::radius;

    static constexpr double steepest = tolerance::steepest_followed;
    /// Facets no larger than this share of the cutter's radius are small.
    static constexpr float fine_share = 0.25f;

    float steep_rho; ///< g is followed up to here, where it has the steepest slope; from here its tangent

    /// Edges as their places see them.
    template <class F>
    struct EdgeLanes {
        F x, y, z; ///< where it starts
        F ux, uy, run, slope;
        F position, height_noise, top;
    };

    FACETMILL_MEMBER PreparedBounds(const IndexView& i, const SurfaceTable& s, const AxialQuery& q)
        : Base(i, s, q) {
        steep_rho = float(surface.max_radius);
        for (int k = 0; k < surface.count; ++k) {
            const SurfacePiece& piece = surface.piece[k];
            if (!(piece.slope1 > steepest)) continue;
            steep_rho = float(piece.slope0 >= steepest
                                  ? piece.rho0
                                  : piece.e + piece.r * (steepest / __builtin_sqrt(1 + steepest * steepest)));
            break;
        }
    }

    /// All but the edges.
    FACETMILL_CALLED void prepare(const FacetBlock& block, PreparedBlock& f) const {
        const float r = float(surface.max_radius), share = float(tolerance::float_slack);
        f.origin[0] = block.x[0][0];
        f.origin[1] = block.y[0][0];
        f.has_edges = false;
        for (std::size_t k = 0; k < block_width; ++k)
            f.duty[k] = block.duty[k] & duty_upright;
        Float8 px[3], py[3], pz[3];
        for (int k = 0; k < 3; ++k) {
            const double ox = f.origin[0], oy = f.origin[1];
            px[k] = narrow(load(block.x[k]) - ox, load(block.x[k] + 4) - ox);
            py[k] = narrow(load(block.y[k]) - oy, load(block.y[k] + 4) - oy);
            pz[k] = narrow(load(block.z[k]) - zero, load(block.z[k] + 4) - zero);
            store(px[k], f.x[k]);
            store(py[k], f.y[k]);
            store(pz[k], f.z[k]);
        }
        const Float8 lo_x = smaller(smaller(px[0], px[1]), px[2]), hi_x = larger(larger(px[0], px[1]), px[2]);
        const Float8 lo_y = smaller(smaller(py[0], py[1]), py[2]), hi_y = larger(larger(py[0], py[1]), py[2]);
        // Places that matter are within the radius of the facet, those beside them in the packet within two.
        const Float8 far = 2 * larger(larger(hi_x, -lo_x), larger(hi_y, -lo_y)) + 4 * r;
        const Float8 size = larger(hi_x - lo_x, hi_y - lo_y);
        f.is_fine = bits(size > fine_share * r) == 0;
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
        store(mx, f.contact_x);
        store(my, f.contact_y);
        store(sx, f.slope_x);
        store(sy, f.slope_y);
        store(share * (z_size + 20 * far), f.noise_tangent);
        // The point of contact for the lower bound is moved inside of the rim.
        store(slope * larger(rho - (r - 3 * position), all(0.0f)), f.loss);
        store(select(nz < 0.0f, all(-1.0f), all(1.0f)), f.turn);
        store(select(sure, 4 * position * longest, never), f.corner);
        store(select(sure, contact_doubt, never), f.contact_doubt);
    }

    /// A plane of slopes (gx, gy) below the cutter that is good where it touches the facets from (x, y), and
    /// the bound that it gives of their lifts, at x = y = 0.
    template <class F>
    FACETMILL_MEMBER F facet_tangent(const PreparedBlock& f, const F& x, const F& y, F& gx, F& gy) const {
        const F tx = smaller(larger(repeat<F>(f.contact_x), repeat<F>(f.lo_x) - x), repeat<F>(f.hi_x) - x),
                ty = smaller(larger(repeat<F>(f.contact_y), repeat<F>(f.lo_y) - y), repeat<F>(f.hi_y) - y);
        F level;
        tangent_plane(tx, ty, repeat<F>(f.slope_x), repeat<F>(f.slope_y), level, gx, gy);
        F over = repeat<F>(f.z[0]) - gx * repeat<F>(f.x[0]) - gy * repeat<F>(f.y[0]);
        over = larger(over, repeat<F>(f.z[1]) - gx * repeat<F>(f.x[1]) - gy * repeat<F>(f.y[1]));
        over = larger(over, repeat<F>(f.z[2]) - gx * repeat<F>(f.x[2]) - gy * repeat<F>(f.y[2]));
        return over - level + repeat<F>(f.noise_tangent);
    }

    /// The lift over a point of every facet from (x, y), from below: the one where the facet's plane touches,
    /// with barycentric coordinates below 0 made 0. -inf where it is not surely under the cutter.
    template <class F>
    FACETMILL_MEMBER F point_lift(const PreparedBlock& f, const F& x, const F& y) const {
        constexpr auto inward = float(1 - 3 * tolerance::rim_share); // a little inside of the rim
        const F ax = inward * repeat<F>(f.contact_x) + x, ay = inward * repeat<F>(f.contact_y) + y;
        const F sign = repeat<F>(f.turn);
        F toward_x[3], toward_y[3], weight[3];
        for (int k = 0; k < 3; ++k) {
            toward_x[k] = repeat<F>(f.x[k]) - ax;
            toward_y[k] = repeat<F>(f.y[k]) - ay;
        }
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            weight[k] = larger(sign * (toward_x[i] * toward_y[j] - toward_x[j] * toward_y[i]), 0.0f);
        }
        const F share = 1.0f / (weight[0] + weight[1] + weight[2]);
        const auto mean = [&](const float(&corner)[3][block_width]) __attribute__((always_inline)) {
            return share
                   * (weight[0] * repeat<F>(corner[0]) + weight[1] * repeat<F>(corner[1])
                      + weight[2] * repeat<F>(corner[2]));
        };
        const F qx = mean(f.x) - x, qy = mean(f.y) - y, square = qx * qx + qy * qy;
        const F height = mean(f.z) - repeat<F>(f.noise_tangent), position = repeat<F>(f.position);
        constexpr float widened = 1 + float(tolerance::float_slack);
        if constexpr (ball) {
            // (rho + 4 position)^2 is less than this.
            const F farther = square + 16 * position * radius;
            const RoughPiece& arc = surface.rough[0];
            return select(farther < inner * inner,
                          height - widened * (arc.f - root(larger(arc.r * arc.r - farther, 0.0f))),
                          -__builtin_inff());
        }
        const F rho = root(square) + 4 * position;
        return select((rho < inner) & (square >= 0.0f), height - widened * rough_height(rho),
                      -__builtin_inff());
    }

    FACETMILL_CALLED static void prepare_edges(PreparedBlock& f) {
        const Float8 sign = load(f.turn), mx = load(f.contact_x), my = load(f.contact_y);
        const Float8 contact_doubt = load(f.contact_doubt), corner = load(f.corner);
        for (int k = 0; k < 3; ++k) {
            const int n = k == 2 ? 0 : k + 1;
            PreparedBlock::Edges& e = f.edge[k];
            const Float8 px = load(f.x[k]), py = load(f.y[k]);
            const Float8 ex = load(f.x[n]) - px, ey = load(f.y[n]) - py, run = root(ex * ex + ey * ey),
                         per_run = 1.0f / run;
            store(ex * per_run, e.ux);
            store(ey * per_run, e.uy);
            store(run, e.run);
            store((load(f.z[n]) - load(f.z[k])) * per_run, e.slope);
            store(sign * (ex * (my - py) - ey * (mx - px)), e.side);
            store(-sign * ey, e.side_x);
            store(sign * ex, e.side_y);
            store(larger(run * contact_doubt + corner, corner), e.doubt);
        }
        f.has_edges = true;
    }

    /// Uphill from the foot of the axis, about where a line at distance l from the axis touches that rises by
    /// `slope` >= 0.
    template <class F>
    FACETMILL_MEMBER F line_guess(const F& l, const F& slope) const {
        const auto leg = [](const F& a, const F& b) __attribute__((always_inline)) {
            return root(larger((a - b) * (a + b), all_of<F>(0.0f)));
        };
        F s = all_of<F>(0.0f);
        for (int i = 0; i < pieces(); ++i) {
            const RoughPiece& p = surface.rough[i];
            F here;
            if (!is_arc(p)) {
                const F k = all_of<F>(p.slope0);
                here = l * slope / root(larger((k - slope) * (k + slope), all_of<F>(1e-30f)));
                here = select(slope >= k, slope * 1e30f, here);
            } else {
                const F over = 1.0f / root(1.0f + slope * slope), sine = slope * over;
                if (ball || p.e == 0) {
                    here = sine * leg(all_of<F>(p.r), l);
                } else {
                    const F target = l * over;
                    F y = larger(all_of<F>(0.0f),
                                 larger((target - p.e) * p.per_r, target * sine / (p.e + p.r * sine)));
                    F x = root(y * y + sine * sine);
                    const F per = 1.0f / x; // a step of Newton's is enough for a guess
                    const F value = p.e * y * per + p.r * y - target;
                    const F change = p.e * sine * sine * per * per * per + p.r;
                    y = smaller(larger(y - value / change, all_of<F>(0.0f)), all_of<F>(1.0f));
                    x = smaller(root(y * y + sine * sine), all_of<F>(1.0f));
                    here = leg(p.e + p.r * x, l);
                }
            }
            if (i == 0) {
                s = here;
                continue;
            }
            const F s0 = leg(all_of<F>(p.rho0), l);
            const auto beyond = (l >= p.rho0) | (slope * p.rho0 > surface.rough[i - 1].slope1 * s0);
            s = select(beyond, larger(here, s0), s);
        }
        return s;
    }

    /// Bounds of the lifts over edges.
    template <class F>
    FACETMILL_CALLED void edge_bounds(const EdgeLanes<F>& e, F& above, F& below) const {
        const F never = all_of<F>(-__builtin_inff());
        const float r = float(surface.max_radius);
        const F steep = magnitude(e.slope);
        const F noise = e.height_noise + (float(steepest) + 4 + steep) * e.position;
        const auto known = (steep < float(tolerance::steepest_edge)) & (e.run > 0.0f);
        const F from = e.x * e.ux + e.y * e.uy, to = from + e.run;
        const F l = magnitude(e.x * e.uy - e.y * e.ux);
        const F wide = r + 2 * e.position, narrow_r = r - 3 * e.position;
        const F half = root(larger((wide - l) * (wide + l), all_of<F>(0.0f)));
        const F lo = larger(from, -half), hi = smaller(to, half);
        const auto reached = (l <= wide) & (lo <= hi + 4 * e.position);
        F s = line_guess(smaller(l, all_of<F>(r)), steep);
        s = select(e.slope < 0.0f, -s, s);
        const F half_in = float(1 - tolerance::rim_share) * half;
        s = smaller(larger(s, -half_in), half_in);
        s = smaller(larger(s, from), to);
        const F rho = root(l * l + s * s);
        // g and its slope, or the tangent of the steepest place that is followed.
        const F followed = smaller(rho, all_of<F>(steep_rho));
        F g = all_of<F>(0.0f), change = all_of<F>(0.0f);
        for (int i = 0; i < pieces(); ++i) {
            const RoughPiece& p = surface.rough[i];
            F here, change_here;
            if (!is_arc(p)) {
                here = p.z0 + p.slope0 * (followed - p.rho0);
                change_here = all_of<F>(p.slope0);
            } else {
                const F away = followed - p.e;
                const F up = root(larger((p.r - away) * (p.r + away), all_of<F>(1e-12f)));
                here = p.f - up;
                change_here = larger(away, all_of<F>(0.0f)) / up;
            }
            const auto in = followed > (i == 0 ? -1.0f : surface.rough[i - 1].rho1);
            g = select(in, here, g);
            change = select(in, change_here, change);
        }
        change = smaller(change, all_of<F>(float(steepest)));
        const F lift = e.z + e.slope * (s - from) - g;
        const F rises = e.slope - change * (s / larger(rho, all_of<F>(1e-30f)));
        below = select(known & reached & (rho < smaller(narrow_r + e.position, all_of<F>(steep_rho))),
                       lift - noise, never);
        above = lift - change * (rho - followed) + larger(rises * (lo - s), rises * (hi - s)) + noise;
        above = select(known, select(reached, above, never), e.top);
    }
};

} // namespace

} // namespace facetmill::simd
