// Random cutter and triangle cases for axial lifts, case i always the same, among them every degenerate
// family.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"
#include "tests/support/random_meshes.h"

namespace facetmill::test {

/// Any convex cutter of about `d` in diameter; `kind` counts through the shapes.
inline AptCutter random_cutter(Random& rng, int kind, double d) {
    const double h = d * uniform(rng, 1, 4);
    const double alpha = radians(uniform(rng, 1, 60)), beta = radians(uniform(rng, 0.5, 25));
    const auto some = [&](double a, double b) {
        return uniform(rng, 0.05, 0.95) * AptCutter::largest_corner_radius(d, a, b);
    };
    switch (kind % 14) {
    case 0:
        return AptCutter::ball(d, h);
    case 1:
        return AptCutter::flat(d, h);
    case 2:
        return AptCutter::bull(d, some(0, 0), h);
    case 3:
        return AptCutter::cone(d, radians(uniform(rng, 5, 85)));
    case 4:
        return AptCutter::from_shape(d, 0, alpha, 0, h);
    case 5:
        return AptCutter::from_shape(d, 0, 0, beta, h);
    case 6:
        return AptCutter::from_shape(d, 0, alpha, beta, h);
    case 7:
        return AptCutter::from_shape(d, some(alpha, 0), alpha, 0, h);
    case 8:
        return AptCutter::from_shape(d, some(0, beta), 0, beta, h);
    case 9:
        return AptCutter::from_shape(d, some(alpha, beta), alpha, beta, h);
    case 10:
        return AptCutter::tapered_ball(d / 2, beta, h);
    case 11:
        return AptCutter::from_shape(d, some(0, -beta), 0, -beta, 0.5 * d);
    case 12: { // a corner circle that is not tangent, kinks at both joints
        const double r = d * uniform(rng, 0.3, 0.45);
        return {d, r, d / 2 - 0.8 * r, 0.8 * r, 0, 0.3 * beta, h};
    }
    default: { // a pointed arc: its centre beyond the axis
        const double e = -d * uniform(rng, 0.05, 0.4), r = d / 2 - e;
        return {d, r, e, std::sqrt(r * r - e * e), 0, 0, h};
    }
    }
}

struct LiftCase {
    const char* family = "";
    AptCutter cutter;
    Vec3 corner[3];
    double x = 0, y = 0;
};

inline constexpr int lift_families = 14;

/// Case number i, of family i % lift_families: cutters of 1 to 20 mm over triangles within about 100 mm.
inline LiftCase lift_case(std::uint64_t i) {
    Random rng(0x9E3779B97F4A7C15ull * (i + 1));
    LiftCase c;
    const double d = std::exp(uniform(rng, 0, std::log(20.0)));
    c.cutter = random_cutter(rng, whole(rng, 0, 13), d);
    const double reach = CutterProfile(c.cutter).max_radius();
    const auto random_point = [&](double size, double height) {
        return Vec3(uniform(rng, -size, size), uniform(rng, -size, size), uniform(rng, -height, height));
    };
    c.x = uniform(rng, -40, 40);
    c.y = uniform(rng, -40, 40);
    const Vec3 axis(c.x, c.y, 0);
    Vec3 &p = c.corner[0], &q = c.corner[1], &s = c.corner[2];
    const double size = reach * std::exp(uniform(rng, -3, 1.5));
    const Vec3 at = axis + random_point(0.8 * reach, reach);
    const auto generic = [&](double z) {
        for (Vec3& v : c.corner)
            v = at + random_point(size, z);
    };
    switch (i % lift_families) {
    case 0:
        c.family = "any";
        generic(size);
        break;
    case 1:
        c.family = "gentle";
        generic(0.2 * size);
        break;
    case 2:
        c.family = "steep";
        generic(10 * size);
        break;
    case 3: { // a thin triangle
        c.family = "needle";
        generic(size);
        s = p + uniform(rng, 0, 1) * (q - p)
            + random_point(1, 1) * size * std::pow(10.0, uniform(rng, -12, -2));
        break;
    }
    case 4: { // a facet that is vertical but for a little
        c.family = "nearly vertical";
        generic(size);
        s.head<2>() =
            p.head<2>() + uniform(rng, -1, 2) * (q - p).head<2>()
            + size * std::pow(10.0, uniform(rng, -12, -2)) * Vec2(uniform(rng, -1, 1), uniform(rng, -1, 1));
        break;
    }
    case 5: // exactly vertical, facet and edges
        c.family = "vertical";
        generic(size);
        s.head<2>() = whole(rng, 0, 1) ? p.head<2>() : Vec2(0.5 * (p + q).head<2>());
        if (whole(rng, 0, 3) == 0) q.head<2>() = p.head<2>();
        break;
    case 6: // level facets and edges, on halves so that coordinates coincide
        c.family = "level";
        generic(size);
        for (Vec3& v : c.corner)
            v.z() = 1.5;
        if (whole(rng, 0, 1)) p.z() = 2;
        break;
    case 7: // no area: one line, one point, a corner named twice
        c.family = "degenerate";
        generic(size);
        switch (whole(rng, 0, 3)) {
        case 0:
            s = 0.5 * (p + q);
            break;
        case 1:
            s = q;
            break;
        case 2:
            q = s = p;
            break;
        default:
            s = p + 2 * (q - p);
        }
        break;
    case 8: { // an edge or a corner right under the axis
        c.family = "under the axis";
        c.x = c.y = 0;
        generic(size);
        const Vec3 u(size * whole(rng, -3, 3), size * whole(rng, -3, 3), size * uniform(rng, -1, 1));
        const int k = whole(rng, 0, 2);
        p = Vec3(0, 0, uniform(rng, -1, 1)) - (k == 0 ? Vec3(Vec3::Zero()) : u);
        q = p + 2.5 * u;
        break;
    }
    case 9: { // corners and edges exactly on the circles between the regions: multiples of 3-4-5, and edges
              // parallel to x
        c.family = "on a circle";
        c.x = whole(rng, -4, 4);
        c.y = whole(rng, -4, 4);
        const double r = 5 * std::exp2(double(whole(rng, -2, 1)));
        const double e = 0.25 * r * whole(rng, 0, 3), corner = whole(rng, 0, 1) ? 0.125 * r : 0;
        const double alpha = whole(rng, 0, 2) == 0 ? radians(30) : 0;
        c.cutter = corner > 0 && e + corner <= r ? AptCutter::bull(2 * (e + corner), corner, 100)
                                                 : AptCutter::from_shape(2 * r, 0, alpha, 0, 100);
        const double circle = whole(rng, 0, 1) ? CutterProfile(c.cutter).max_radius() : e;
        const Vec3 base(c.x, c.y, 0);
        p = base + Vec3(0.6 * circle, 0.8 * circle, whole(rng, 0, 4));
        q = base
            + (whole(rng, 0, 1) ? Vec3(-0.6 * circle, 0.8 * circle, 1) : Vec3(circle, 3, whole(rng, 0, 4)));
        s = base + Vec3(whole(rng, -8, 8), circle, whole(rng, 0, 4));
        break;
    }
    case 10: { // a plane or an edge as steep as the cone
        c.family = "as steep as the cone";
        const double half_angle = whole(rng, 0, 1) ? 0.25 * pi : radians(whole(rng, 10, 80));
        c.cutter = AptCutter::cone(d, half_angle);
        generic(size);
        const double slope = 1 / std::tan(half_angle);
        const double direction = whole(rng, 0, 1) ? 0 : uniform(rng, 0, 2 * pi);
        for (Vec3& v : c.corner)
            v.z() = slope * ((v.x() - c.x) * std::cos(direction) + (v.y() - c.y) * std::sin(direction));
        break;
    }
    case 11: // long edges that pass by, contact far from the corners
        c.family = "large";
        for (Vec3& v : c.corner)
            v = at + random_point(100, uniform(rng, 0.1, 60));
        break;
    case 12: // small under a large cutter, often at its side
        c.family = "small";
        for (Vec3& v : c.corner)
            v = axis + Vec3(0, reach * uniform(rng, 0.9, 1.02), 0) + random_point(0.05 * reach, 0.3 * reach);
        break;
    default: // on a coarse grid, where many things coincide
        c.family = "grid";
        c.x = whole(rng, -2, 2);
        c.y = whole(rng, -2, 2);
        c.cutter = random_cutter(rng, whole(rng, 0, 3), 2.0 * whole(rng, 1, 4));
        for (Vec3& v : c.corner)
            v = Vec3(whole(rng, -5, 5), whole(rng, -5, 5), whole(rng, -3, 3));
    }
    return c;
}

} // namespace facetmill::test
