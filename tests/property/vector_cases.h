// Random cases of cutter, facet, axis and vector, case i always the same, among them every degenerate family.
#pragma once

#include "core/gouge/vector_lift.h"
#include "tests/unit/gouge/lift_cases.h"

#include <array>
#include <string>

namespace facetmill::test {

struct VectorCase {
    std::string family;
    AptCutter cutter;
    double raised = 0; ///< above 0: the cutter is a cylinder, and stands there as a section of the tool
    std::array<Vec3, 3> corner;
    Posture posture;
};

inline constexpr int facet_families = 18, vector_families = 9, axis_families = 4;

inline Vec3 random_unit(Random& rng) {
    for (;;) {
        const Vec3 v(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
        if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
    }
}

/// A point of the body's surface in its own frame, and the outward normal there (one of them on a circle).
inline std::pair<Vec3, Vec3> surface_point(Random& rng, const CutterProfile& profile, bool on_circle) {
    const auto& pieces = profile.pieces();
    const int last = int(pieces.size());
    const int i = whole(rng, 0, last);
    const double turn = uniform(rng, 0, 2 * pi), t = on_circle ? whole(rng, 0, 1) : uniform(rng, 0, 1);
    Vec2 p, n;
    if (i == last) {
        p = Vec2(t * pieces.back().to.x(), pieces.back().to.y());
        n = Vec2(0, 1);
    } else {
        const ProfilePiece& piece = pieces[std::size_t(i)];
        const double angle = piece.angle_at_start() + t * (piece.angle_at_end() - piece.angle_at_start());
        n = Vec2(std::sin(angle), -std::cos(angle));
        p = piece.kind == ProfilePiece::Kind::arc ? Vec2(piece.center + piece.radius * n)
                                                  : Vec2(piece.from + t * (piece.to - piece.from));
    }
    const auto round = [&](const Vec2& v) {
        return Vec3(v.x() * std::cos(turn), v.x() * std::sin(turn), v.y());
    };
    return {round(p), round(n)};
}

/// Case number i: cutters of 1 to 20 mm, facets within about 100 mm.
inline VectorCase vector_case(std::uint64_t i) {
    Random rng(0x9E3779B97F4A7C15ull * (i + 1));
    VectorCase c;
    const double d = std::exp(uniform(rng, 0, std::log(20.0)));
    const int kind = whole(rng, 0, 15);
    c.cutter = kind < 14 ? random_cutter(rng, kind, d) : AptCutter::flat(d, d * uniform(rng, 0.2, 5));
    if (kind >= 14) c.raised = uniform(rng, 1, 30);
    int facet_family = int(i % facet_families), vector_family = int(i / facet_families % vector_families),
        axis_family = int(i / (facet_families * vector_families) % axis_families);
    const bool grid = facet_family >= 14 && facet_family <= 15;
    if (grid) {
        // Everything on whole numbers, axes and vectors along the coordinates: many things coincide.
        const double width = 2.0 * whole(rng, 1, 4);
        switch (whole(rng, 0, 4)) {
        case 0:
            c.cutter = AptCutter::ball(width, 2.0 * whole(rng, 2, 8));
            break;
        case 1:
            c.cutter = AptCutter::flat(width, 2.0 * whole(rng, 1, 8));
            break;
        case 2:
            c.cutter = AptCutter::bull(width, 0.25 * width, 2.0 * whole(rng, 2, 8));
            break;
        case 3:
            c.cutter = AptCutter::cone(width, 0.25 * pi);
            break;
        default:
            c.cutter = AptCutter::from_shape(width, 0, radians(30), 0, 12);
        }
        c.raised = 0;
        axis_family = whole(rng, 0, 1);
        if (facet_family == 14) vector_family = whole(rng, 0, 3);
    }
    Posture& posture = c.posture;
    posture.tip = grid ? Vec3(whole(rng, -3, 3), whole(rng, -3, 3), whole(rng, -3, 3))
                       : Vec3(uniform(rng, -40, 40), uniform(rng, -40, 40), uniform(rng, -40, 40));
    switch (axis_family) {
    case 0:
        posture.axis = Vec3::UnitZ();
        break;
    case 1:
        posture.axis = (whole(rng, 0, 1) ? 1 : -1) * Vec3::Unit(whole(rng, 0, 2));
        break;
    case 2: { // tilted within a coordinate plane
        const double angle = uniform(rng, 0, 2 * pi);
        posture.axis = Vec3::Zero();
        const int k = whole(rng, 0, 2);
        posture.axis[k] = std::cos(angle);
        posture.axis[(k + 1) % 3] = std::sin(angle);
        break;
    }
    default:
        posture.axis = random_unit(rng);
    }
    // The frame of the body, with any turn about the axis.
    const Vec3 z = posture.axis;
    const Vec3 x = (std::abs(z.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY()).cross(z).normalized(),
               y = z.cross(x);
    const auto in_part = [&](const Vec3& p) { return Vec3(p.x() * x + p.y() * y + p.z() * z); };

    const CutterProfile profile(c.cutter);
    const bool on_circle = facet_family == 13;
    auto [touch, normal] = surface_point(rng, profile, on_circle);
    touch = in_part(touch + Vec3(0, 0, c.raised));
    normal = in_part(normal);
    const Vec3 tangent = normal.cross(random_unit(rng)).normalized();

    // The vector; those that need the facet come below.
    Vec3 v = random_unit(rng);
    switch (vector_family) {
    case 0:
        v = posture.axis;
        break;
    case 1:
        v = -posture.axis;
        break;
    case 2: // across the axis
        v = in_part(grid ? Vec3::Unit(whole(rng, 0, 1)) : Vec3(std::cos(touch.x()), std::sin(touch.x()), 0))
                .normalized();
        break;
    case 3:
        v = (whole(rng, 0, 1) ? 1 : -1) * Vec3::Unit(whole(rng, 0, 2));
        break;
    case 4: // nearly along the axis
        v = (posture.axis + std::pow(10.0, uniform(rng, -16, -2)) * v).normalized();
        break;
    default:
        // Lifted off what it touches, sometimes only grazing it.
        if (whole(rng, 0, 1)) {
            if (v.dot(normal) > 0) v = -v;
        } else {
            v = (tangent - std::pow(10.0, uniform(rng, -8, 0)) * normal).normalized();
        }
    }

    const double reach = profile.max_radius();
    const double size = reach * std::exp(uniform(rng, -3, 1.5));
    Vec3 &p = c.corner[0], &q = c.corner[1], &s = c.corner[2];
    const auto some = [&](double scale) {
        return Vec3(uniform(rng, -scale, scale), uniform(rng, -scale, scale), uniform(rng, -scale, scale));
    };
    const auto generic = [&](const Vec3& at) {
        for (Vec3& corner : c.corner)
            corner = at + some(size);
    };
    generic(touch);
    switch (facet_family) {
    case 0:
        c.family = "any";
        break;
    case 1:
        c.family = "touching plane";
        for (Vec3& corner : c.corner)
            corner -= normal.dot(corner - touch) * normal;
        break;
    case 2: {
        c.family = "touching edge";
        const Vec3 along = size * tangent;
        p = touch - uniform(rng, 0.1, 1) * along;
        q = touch + uniform(rng, 0.1, 1) * along;
        s = touch + some(size);
        if (normal.dot(s - touch) < 0) s -= 2 * normal.dot(s - touch) * normal;
        break;
    }
    case 3:
        c.family = "touching corner";
        p = touch;
        for (std::size_t k = 1; k < 3; ++k)
            if (normal.dot(c.corner[k] - touch) < 0)
                c.corner[k] -= 2 * normal.dot(c.corner[k] - touch) * normal;
        break;
    case 4:
        c.family = "needle";
        s = p + uniform(rng, 0, 1) * (q - p) + some(1) * size * std::pow(10.0, uniform(rng, -14, -2));
        break;
    case 5: // no area: one line, one point, a corner named twice
        c.family = "degenerate";
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
    case 6:
        c.family = "edge along the vector";
        q = p + uniform(rng, -2, 2) * size * v;
        break;
    case 7:
        c.family = "edge nearly along the vector";
        q = p + uniform(rng, -2, 2) * size * v + size * std::pow(10.0, uniform(rng, -14, -2)) * some(1);
        break;
    case 8:
        c.family = "vector in the facet";
        s = p + uniform(rng, -1, 1) * (q - p) + uniform(rng, -2, 2) * size * v;
        if (whole(rng, 0, 1)) s += size * std::pow(10.0, uniform(rng, -14, -2)) * some(1);
        break;
    case 9:
        c.family = "edge along the axis";
        q = p + uniform(rng, -2, 2) * size * posture.axis;
        break;
    case 10: // bottom, top and circles lie flat on it
        c.family = "facet across the axis";
        for (Vec3& corner : c.corner)
            corner -= posture.axis.dot(corner - touch) * posture.axis;
        break;
    case 11:
        c.family = "edge through the axis";
        p = (whole(rng, 0, 1) ? 0 : uniform(rng, 0, reach)) * posture.axis - size * random_unit(rng);
        q = p + 2 * size * random_unit(rng);
        p = 2 * (touch.dot(posture.axis)) * posture.axis - q;
        break;
    case 12:
        c.family = "large";
        for (Vec3& corner : c.corner)
            corner = touch + some(100);
        break;
    case 13: // corners and edges on the circles between the regions
        c.family = "on a circle";
        p = touch;
        if (whole(rng, 0, 1)) q = 2 * touch.dot(posture.axis) * posture.axis - touch;
        if (whole(rng, 0, 1)) s = touch + size * tangent;
        break;
    case 14:
    case 15:
        c.family = "grid";
        for (Vec3& corner : c.corner)
            corner = Vec3(whole(rng, -5, 5), whole(rng, -5, 5), whole(rng, -3, 3));
        break;
    case 16:
        c.family = "small";
        for (Vec3& corner : c.corner)
            corner = touch + some(1e-3 * size);
        break;
    default: // along a generator, or flat on the side
        c.family = "along the side";
        const ProfilePiece& side =
            profile.pieces()[std::size_t(whole(rng, 0, int(profile.pieces().size()) - 1))];
        const double angle = uniform(rng, 0, 2 * pi);
        const auto on_side = [&](double t) {
            const Vec2 at = side.from + t * (side.to - side.from);
            return in_part(Vec3(at.x() * std::cos(angle), at.x() * std::sin(angle), at.y() + c.raised));
        };
        p = on_side(uniform(rng, -1, 1));
        q = on_side(uniform(rng, 0, 2));
        if (whole(rng, 0, 1)) {
            const Vec3 around = in_part(Vec3(-std::sin(angle), std::cos(angle), 0));
            s = p + uniform(rng, -1, 1) * (q - p) + uniform(rng, -1, 1) * size * around;
        }
    }
    const double facet_lift = grid ? whole(rng, -2, 2) : uniform(rng, -30, 30);
    for (Vec3& corner : c.corner)
        corner += posture.tip + facet_lift * v;
    posture.direction = v;
    return c;
}

} // namespace facetmill::test
