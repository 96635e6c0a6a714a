// Lift of a cutter over edges and facets, four at a time (Lu 3.5.4, equations 3.61-3.81, corrected).
// Coordinates relative to the cutter's axis: x, y from the axis, z along it. What comes back is the height of
// the tip; -inf where the element is not under the cutter.
//
// Every lift is z - g(rho) at a point of the element, so that no rounding in finding that point can lift the
// cutter higher than the element itself asks for; and since the lift is stationary there, little is lost.
#pragma once

#include "core/gouge/simd.h"
#include "core/gouge/surface_table.h"

namespace facetmill::simd {

/// The lift over what is not under the cutter.
inline constexpr double no_lift = -__builtin_inf();

struct Point4 {
    Double4 x, y, z;
};

/// Lifts and where they come from.
struct Lift4 {
    Double4 tip;
    Point4 point;
    Mask4 between; ///< edge: touched surely between its ends
};

/// sqrt(a^2 - b^2) for a >= b >= 0 without cancellation; 0 where a < b.
FACETMILL_LANES Double4 leg(const Double4& a, const Double4& b) {
    return root(larger((a - b) * (a + b), all(0.0)));
}

/// g(rho) for 0 <= rho <= max_radius.
FACETMILL_LANES Double4 height(const SurfaceTable& surface, const Double4& rho) {
    Double4 z = all(0.0);
    for (int i = 0; i < surface.count; ++i) {
        const SurfacePiece& p = surface.piece[i];
        Double4 here;
        if (p.r == 0) {
            here = p.z0 + p.slope0 * (smaller(rho, all(p.rho1)) - p.rho0);
        } else {
            const Double4 out = rho - p.e;
            here = p.f - root(larger((p.r - out) * (p.r + out), all(0.0)));
        }
        z = i == 0 ? here : select(rho > surface.piece[i - 1].rho1, here, z);
    }
    return z;
}

/// Where a plane touches whose normal has horizontal part `horizontal` >= 0 and vertical part `vertical` > 0:
/// the distance from the axis (uphill). The nearest such point where there are many. Lu 3.73-3.79.
FACETMILL_LANES Double4 plane_contact(const SurfaceTable& surface, const Double4& horizontal,
                                      const Double4& vertical) {
    Double4 rho = all(surface.max_radius);
    for (int i = surface.count - 1; i >= 0; --i) {
        const SurfacePiece& p = surface.piece[i];
        if (p.r != 0) {
            const Double4 sine = horizontal / root(horizontal * horizontal + vertical * vertical);
            rho = select(horizontal <= p.slope1 * vertical,
                         clamped(p.e + p.r * sine, all(p.rho0), all(p.rho1)), rho);
        }
        rho = select(horizontal <= p.slope0 * vertical, all(p.rho0), rho);
    }
    return rho;
}

/// Contact of a line with a corner circle; `s` as for line_contact, within [s0, s1].
FACETMILL_LANES Double4 arc_contact(const SurfacePiece& p, const Mask4& wanted, const Double4& l,
                                    const Double4& rise, const Double4& run, const Double4& s0,
                                    const Double4& s1) {
    const Double4 length = root(rise * rise + run * run);
    const Double4 k = rise / length, c = run / length;
    if (p.e == 0) return clamped(k * leg(all(p.r), l), s0, s1); // sphere
    // Torus. With x = sin(angle of the surface's normal to the axis), rho = e + r x, and the slope of the
    // section equals that of the line where
    //     (e + r x) sqrt(x^2 - k^2) = l c x,        k <= x <= 1.
    // With y = sqrt(x^2 - k^2) this is G(y) = e y / sqrt(y^2 + k^2) + r y - l c = 0. For e > 0, G grows and
    // is concave, so Newton's steps from the left of the root never pass it; for e < 0 it is convex, and from
    // the right of the root they never pass it either. The steps end when they no longer move.
    const Double4 target = l * c, zero = all(0.0), one = all(1.0);
    Double4 y;
    if (p.e > 0) {
        y = larger(zero, larger((target - p.e) / p.r, target * k / (p.e + p.r * k)));
    } else {
        const double x1 = (p.rho1 - p.e) / p.r;
        y = leg(larger(all(x1 < 1 ? x1 : 1), k), k);
    }
    constexpr int max_steps = 100; // a guard only: about 45 is the most that random tries see
    for (int i = 0; i < max_steps; ++i) {
        const Double4 x = root(y * y + k * k);
        const Double4 over = 1.0 / x, cosine = y * over, sine = k * over;
        const Double4 value = p.e * cosine + p.r * y - target;
        const Double4 slope = p.e * sine * sine * over + p.r;
        const Double4 next = clamped(y - value / slope, zero, one);
        // Away from the root's side only rounding can lead; x = 0 gives no number and stays.
        const Mask4 moves = wanted & (p.e > 0 ? next > y : next < y);
        if (bits(moves) == 0) break;
        y = select(moves, next, y);
    }
    const Double4 x = clamped(root(y * y + k * k), zero, one);
    const Double4 rho = p.e + p.r * x;
    // Both are the contact; each is the accurate one where the other cancels.
    const Double4 s = select(x < 0.5, rise / run * rho * leg(one, x) / x, leg(larger(rho, l), l));
    return select(x == 0.0, s0, clamped(s, s0, s1));
}

/// Where a line touches that passes the axis at distance l <= max_radius and rises by `rise` >= 0 over `run`
/// > 0: the distance, uphill along the line's projection, from its point nearest to the axis.
FACETMILL_LANES Double4 line_contact(const SurfaceTable& surface, const Mask4& wanted, const Double4& l,
                                     const Double4& rise, const Double4& run) {
    // Along the line, s from the foot of the axis: rho = sqrt(l^2 + s^2), and the lift changes by
    // rise/run - g'(rho) s/rho per unit of s. It never grows with s: the first piece at whose outer end it is
    // negative holds the contact (Lu 3.64-3.72, rebuilt from the derivative).
    Double4 s = leg(all(surface.max_radius), l);
    Mask4 open = wanted;
    for (int i = 0; i < surface.count; ++i) {
        const SurfacePiece& p = surface.piece[i];
        const Double4 s1 = leg(all(p.rho1), l);
        const Mask4 here = open & (l < p.rho1) & ~(rise * p.rho1 > p.slope1 * s1 * run);
        if (bits(here) == 0) continue;
        open &= ~here;
        const Mask4 inner = l <= p.rho0; // the line has left the piece's inner circle
        const Double4 s0 = leg(all(p.rho0), l);
        // s/rho at the start is 1 for a line through the axis.
        const Mask4 at_start = p.rho0 > 0 ? rise * p.rho0 <= p.slope0 * s0 * run : rise <= p.slope0 * run;
        const Mask4 ends = (inner & at_start) | (~inner & (rise == 0.0));
        Double4 inside;
        if (p.r != 0) {
            inside = arc_contact(p, here & ~ends, l, rise, run, s0, s1);
        } else { // cone and taper (Lu 3.70, and 3.68 corrected): g' = slope
            const Double4 steeper = leg(p.slope0 * run, rise);
            inside = select(steeper > 0.0, clamped(l * rise / steeper, s0, s1), s0);
        }
        s = select(here, select(ends, s0, inside), s);
        if (bits(open) == 0) break;
    }
    return s;
}

/// The lift over the whole closed edge; over one that is parallel to the axis, that over its upper end. Lu
/// 3.61-3.72. An edge that passes the rim by no more than `slack` touches it. Lanes that are not wanted give
/// anything.
FACETMILL_LANES Lift4 edge_lift(const SurfaceTable& surface, const Mask4& wanted, const Point4& a,
                                const Point4& b, const Double4& slack) {
    const Double4 dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const Double4 r = all(surface.max_radius), reach = r + slack;
    const Double4 cross = a.x * dy - a.y * dx, run = root(square);
    const Mask4 upright = ~(square > 0.0);
    const Double4 l = smaller(magnitude(cross) / run, r);
    // s runs uphill along the projection, from the point nearest to the axis.
    const Mask4 falls = b.z < a.z;
    const Point4 low{select(falls, b.x, a.x), select(falls, b.y, a.y), select(falls, b.z, a.z)};
    const Point4 high{select(falls, a.x, b.x), select(falls, a.y, b.y), select(falls, a.z, b.z)};
    const Double4 ux = (high.x - low.x) / run, uy = (high.y - low.y) / run;
    const Double4 s_low = low.x * ux + low.y * uy, s_high = high.x * ux + high.y * uy;
    const Double4 past = reach * reach - l * l;
    const Mask4 beside = (cross * cross > reach * reach * square) | ((s_low > 0.0) & (s_low * s_low > past))
                         | ((s_high < 0.0) & (s_high * s_high > past));
    const Mask4 under = wanted & (upright | ~beside);
    if (bits(under) == 0) return {all(no_lift), a, under};
    const Double4 rise = high.z - low.z;
    const Double4 best = line_contact(surface, under & ~upright, l, rise, run);
    // Beyond an end it is that corner's lift, unless rounding sees the corner outside of the cutter.
    const Mask4 at_high = upright | (best >= s_high), at_low = best <= s_low;
    const Point4 corner{select(at_high, high.x, low.x), select(at_high, high.y, low.y),
                        select(at_high, high.z, low.z)};
    const Double4 corner_square = corner.x * corner.x + corner.y * corner.y;
    const Mask4 reached = corner_square <= r * r;
    const Mask4 at_corner = (at_high | at_low) & reached;
    const Double4 s = clamped(best, s_low, s_high);
    const Double4 t = clamped((s - s_low) / run, all(0.0), all(1.0));
    const Double4 z = smaller(low.z + t * rise, high.z);
    Lift4 lift;
    lift.point.x = select(at_corner, corner.x, low.x + t * (high.x - low.x));
    lift.point.y = select(at_corner, corner.y, low.y + t * (high.y - low.y));
    lift.point.z = select(at_corner, corner.z, z);
    const Double4 rho = smaller(root(select(at_corner, corner_square, l * l + s * s)), r);
    const Mask4 touches = under & (reached | ~upright);
    lift.between = touches & ~(at_high | at_low);
    lift.tip = select(touches, lift.point.z - height(surface, rho), all(no_lift));
    return lift;
}

/// How the plane of a facet meets the cutter.
struct PlaneLift4 {
    Lift4 lift;         ///< of its inside: -inf where the plane is touched outside of the facet
    Mask4 inside;       ///< touched surely inside: no edge can ask for more
    Mask4 border;       ///< not inside, but by no more than rounding
    Mask4 outside;      ///< touched surely outside
    Double4 side[3];    ///< twice the area between edge k and the point of contact, positive inside
    Double4 edge_slack; ///< of edges that are asked because of `border`
};

/// How the planes of four facets meet the cutter. Corners 0 and 1 must be the ends of the longest edge seen
/// along the axis. Lu 3.73-3.81. Lanes that are not wanted, because the facet's projection has no area, are
/// not inside and have no border.
FACETMILL_LANES PlaneLift4 plane_lift(const SurfaceTable& surface, const Mask4& wanted, const Point4 (&p)[3],
                                      double roundings) {
    const Point4 &a = p[0], &b = p[1], &c = p[2];
    const Double4 ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const Double4 vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const Double4 nz = ux * vy - uy * vx, nx = uy * vz - uz * vy, ny = uz * vx - ux * vz;
    const Double4 area = magnitude(nz), zero = all(0.0);
    const Double4 turn = select(nz < 0.0, all(-1.0), all(1.0));
    const Double4 horizontal = root(nx * nx + ny * ny);
    const Double4 rho = plane_contact(surface, horizontal, area);
    // Uphill is against the horizontal part of the upward normal.
    const Double4 scale = select(horizontal > 0.0, -turn * rho / horizontal, zero);
    const Double4 qx = scale * nx, qy = scale * ny;

    PlaneLift4 result;
    const auto area_with = [&](const Point4& from, const Point4& to) __attribute__((always_inline)) {
        return turn * ((to.x - from.x) * (qy - from.y) - (to.y - from.y) * (qx - from.x));
    };
    result.side[0] = area_with(a, b);
    result.side[1] = area_with(b, c);
    result.side[2] = area_with(c, a);
    const Double4 least = smaller(smaller(result.side[0], result.side[1]), result.side[2]);
    // Rounding may put the point outside, or inside: the shape of the facet says by how much.
    const Double4 square = ux * ux + uy * uy, longest = root(square);
    const double epsilon = roundings * __DBL_EPSILON__;
    const Double4 noise = epsilon * longest * (rho * (1.0 + square / area) + longest);
    result.edge_slack = epsilon * (longest + rho);
    const Mask4 within = wanted & (least >= 0.0);
    result.inside = wanted & (least > noise);
    result.border = wanted & ~within & (least >= -noise);
    result.outside = wanted & (least < -noise);

    // From the point of the longest edge abreast of q, then across: stable also on needles.
    const Double4 t = ((qx - a.x) * ux + (qy - a.y) * uy) / square, t_c = (vx * ux + vy * uy) / square;
    const Double4 z = a.z + t * uz + result.side[0] / area * (vz - t_c * uz);
    const Double4 lowest = smaller(smaller(a.z, b.z), c.z), highest = larger(larger(a.z, b.z), c.z);
    const Double4 z_in = clamped(z, lowest, highest);
    result.lift.tip =
        select(within, z_in - height(surface, smaller(rho, all(surface.max_radius))), all(no_lift));
    result.lift.point = {qx, qy, z_in};
    return result;
}

} // namespace facetmill::simd
