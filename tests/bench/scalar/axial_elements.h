// Lift of a cutter over a vertex, an edge and a facet (Lu 3.5.4, equations 3.61-3.81, corrected). Coordinates
// relative to the cutter's axis: x, y from the axis, z of the part. What comes back is the height of the tip;
// -inf where the element is not under the cutter. The point is where the element is touched, again relative
// to the axis.
//
// Each function evaluates z - g(rho) at a point of the element, so that no rounding in finding that point can
// lift the cutter higher than the element itself asks for; and since the lift is stationary there, little is
// lost.
#pragma once

#include "core/base/tolerances.h"
#include "core/base/vec.h"
#include "tests/bench/scalar/lower_surface.h"

namespace facetmill::scalar {

/// A lift and where it comes from.
struct ElementLift {
    double tip_z = -infinity;
    Vec3 point = Vec3::Zero();
};

inline double lift_at(const LowerSurface& surface, double rho, double z) {
    return z - surface.height(std::min(rho, surface.max_radius()));
}

/// Lu 3.61-3.62.
inline ElementLift vertex_lift(const LowerSurface& surface, const Vec3& p) {
    const double square = p.x() * p.x() + p.y() * p.y(), r = surface.max_radius();
    if (!(square <= r * r)) return {};
    return {lift_at(surface, std::sqrt(square), p.z()), p};
}

/// The whole closed edge. Lu 3.63-3.72; a vertical edge is left to its ends. An edge that passes the rim by
/// no more than `slack` touches it.
inline ElementLift edge_lift(const LowerSurface& surface, const Vec3& a, const Vec3& b, double slack = 0) {
    const double dx = b.x() - a.x(), dy = b.y() - a.y(), square = dx * dx + dy * dy;
    const double r = surface.max_radius();
    const double cross = a.x() * dy - a.y() * dx;
    if (!(square > 0) || cross * cross > (r + slack) * (r + slack) * square) return {};
    const double run = std::sqrt(square);
    const double l = std::min(std::abs(cross) / run, r);
    // s runs uphill along the projection, from the point nearest to the axis.
    const bool falls = b.z() < a.z();
    const Vec3 &low = falls ? b : a, &high = falls ? a : b;
    const double sign = falls ? -1 : 1;
    const double s_low = sign * (low.x() * dx + low.y() * dy) / run,
                 s_high = sign * (high.x() * dx + high.y() * dy) / run;
    const double past = (r + slack) * (r + slack) - l * l;
    if ((s_low > 0 && s_low * s_low > past) || (s_high < 0 && s_high * s_high > past)) return {};
    const double rise = high.z() - low.z();
    const double best = surface.line_contact(l, rise, run);
    // Beyond an end it is that corner's lift, unless rounding sees the corner outside of the cutter.
    if (best >= s_high || best <= s_low) {
        const ElementLift corner = vertex_lift(surface, best >= s_high ? high : low);
        if (corner.tip_z > -infinity) return corner;
    }
    const double s = std::clamp(best, s_low, s_high);
    const double t = std::clamp((s - s_low) / run, 0.0, 1.0);
    const double z = std::min(low.z() + t * rise, high.z());
    return {lift_at(surface, std::sqrt(l * l + s * s), z),
            Vec3(low.x() + t * (high.x() - low.x()), low.y() + t * (high.y() - low.y()), z)};
}

/// The inside of a facet, and its border as far as the facet's plane touches the cutter there. Corner 0 to 1
/// is its longest edge seen along the axis. Lu 3.73-3.81.
inline ElementLift facet_lift(const LowerSurface& surface, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 u = b - a, v = c - a;
    Vec3 n = u.cross(v);
    const double area = std::abs(n.z());
    if (!(area > 0)) return {};
    if (n.z() < 0) n = -n;
    const double horizontal = std::sqrt(n.x() * n.x() + n.y() * n.y());
    const double rho = surface.plane_contact(horizontal, area);
    // Uphill is against the horizontal part of the upward normal.
    const double scale = horizontal > 0 ? -rho / horizontal : 0;
    const double qx = scale * n.x(), qy = scale * n.y();

    // Twice the area of the triangle that each edge makes with q; all positive inside.
    const double turn = u.x() * v.y() - u.y() * v.x() > 0 ? 1 : -1;
    const auto area_with = [&](const Vec3& p, const Vec3& q) {
        return turn * ((q.x() - p.x()) * (qy - p.y()) - (q.y() - p.y()) * (qx - p.x()));
    };
    const double side0 = area_with(a, b), side1 = area_with(b, c), side2 = area_with(c, a);
    if (side0 >= 0 && side1 >= 0 && side2 >= 0) {
        // From the point of the longest edge abreast of q, then across: stable also on needles.
        const double along = u.x() * u.x() + u.y() * u.y();
        const double t = ((qx - a.x()) * u.x() + (qy - a.y()) * u.y()) / along;
        const double t_c = (v.x() * u.x() + v.y() * u.y()) / along;
        const double z = a.z() + t * u.z() + side0 / area * (v.z() - t_c * u.z());
        const double lowest = std::min({a.z(), b.z(), c.z()}), highest = std::max({a.z(), b.z(), c.z()});
        const double z_in = std::clamp(z, lowest, highest);
        return {lift_at(surface, rho, z_in), Vec3(qx, qy, z_in)};
    }
    // Rounding may have put q outside: the shape of the facet says by how much. Then the edge it left by has
    // the contact, which may be an edge that is not tested on its own.
    const double longest = std::sqrt(u.x() * u.x() + u.y() * u.y());
    const double noise = tolerance::contact_roundings * std::numeric_limits<double>::epsilon() * longest
                         * (rho * (1 + longest * longest / area) + longest);
    const double slack =
        tolerance::contact_roundings * std::numeric_limits<double>::epsilon() * (longest + rho);
    ElementLift best;
    const auto ask = [&](double side, const Vec3& p, const Vec3& q) {
        if (side >= 0) return;
        const ElementLift lift = edge_lift(surface, p, q, slack);
        if (lift.tip_z > best.tip_z) best = lift;
    };
    if (std::min({side0, side1, side2}) >= -noise) {
        ask(side0, a, b);
        ask(side1, b, c);
        ask(side2, c, a);
    }
    return best;
}

} // namespace facetmill::scalar
