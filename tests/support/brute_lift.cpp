#include "tests/support/brute_lift.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace facetmill::test {

namespace {

using Real = long double;
constexpr Real none = -std::numeric_limits<Real>::infinity();

struct Point {
    Real x, y, z;
};

struct Interval {
    Real lo, hi;
    bool empty() const { return !(lo <= hi); }
};

/// Largest value of a concave function on [lo, hi], its ends included.
template <class F>
Real golden_maximum(Real lo, Real hi, F&& f) {
    const Real golden = (std::sqrt(Real(5)) - 1) / 2;
    Real best = std::max(f(lo), f(hi));
    Real x1 = hi - golden * (hi - lo), x2 = lo + golden * (hi - lo), f1 = f(x1), f2 = f(x2);
    // To the last digit of a double: the function may be as steep as the facet, or steeper on the cutter's
    // side.
    while (hi - lo > 1e-17L * std::max({Real(1), std::abs(lo), std::abs(hi)})) {
        if (f1 < f2) {
            lo = x1;
            x1 = x2;
            f1 = f2;
            x2 = lo + golden * (hi - lo);
            f2 = f(x2);
        } else {
            hi = x2;
            x2 = x1;
            f2 = f1;
            x1 = hi - golden * (hi - lo);
            f1 = f(x1);
        }
        if (!(x1 > lo && x2 < hi && x1 < x2)) break;
    }
    return std::max({best, f1, f2});
}

Real lift_at(const BruteCutter& cutter, Real x, Real y, Real z) {
    return z - cutter.height(std::min(std::hypot(x, y), cutter.radius));
}

/// Parameters of a + t (b - a), 0 <= t <= 1, within the disc.
Interval within_disc(const Point& a, const Point& b, Real radius) {
    const Real dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    if (square == 0) return std::hypot(a.x, a.y) <= radius ? Interval{0, 1} : Interval{1, 0};
    const Real foot = -(a.x * dx + a.y * dy) / square;
    const Real distance = std::abs(a.x * dy - a.y * dx) / std::sqrt(square);
    if (distance > radius) return {1, 0};
    const Real half = std::sqrt((radius - distance) * (radius + distance) / square);
    return {std::max(Real(0), foot - half), std::min(Real(1), foot + half)};
}

Point along(const Point& a, const Point& b, Real t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

Real edge_lift(const BruteCutter& cutter, const Point& a, const Point& b) {
    const Interval t = within_disc(a, b, cutter.radius);
    if (t.empty()) return none;
    return golden_maximum(t.lo, t.hi, [&](Real s) {
        const Point p = along(a, b, s);
        return lift_at(cutter, p.x, p.y, p.z);
    });
}

Real turn(const Point& a, const Point& b, Real x, Real y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// The facet cut by the plane of one x: from and to, low y first.
struct Chord {
    Point from, to;
};
std::optional<Chord> chord_at(const Point (&p)[3], Real x) {
    std::optional<Chord> chord;
    const auto add = [&](const Point& q) {
        if (!chord) chord = Chord{q, q};
        if (q.y < chord->from.y) chord->from = q;
        if (q.y > chord->to.y) chord->to = q;
    };
    for (int k = 0; k < 3; ++k) {
        const Point &a = p[k], &b = p[(k + 1) % 3];
        if (a.x == x) add(a);
        if ((a.x < x && x < b.x) || (b.x < x && x < a.x)) add(along(a, b, (x - a.x) / (b.x - a.x)));
    }
    return chord;
}

Real facet_lift(const BruteCutter& cutter, Point (&p)[3]) {
    Real best = std::max(
        {edge_lift(cutter, p[0], p[1]), edge_lift(cutter, p[1], p[2]), edge_lift(cutter, p[2], p[0])});
    const Real area = turn(p[0], p[1], p[2].x, p[2].y);
    if (area == 0) return best; // seen along the axis it is its edges
    const Real r = cutter.radius;
    // Scan across the longer side.
    const auto extent = [&](Real Point::*c) {
        return std::max({p[0].*c, p[1].*c, p[2].*c}) - std::min({p[0].*c, p[1].*c, p[2].*c});
    };
    if (extent(&Point::y) > extent(&Point::x))
        for (Point& q : p)
            std::swap(q.x, q.y);
    const Real sense = turn(p[0], p[1], p[2].x, p[2].y) > 0 ? 1 : -1;
    // The range of x of the facet within the disc: its corners, its border's crossings of the circle, the
    // circle's ends.
    Interval range{std::numeric_limits<Real>::infinity(), none};
    const auto reach = [&](Real x) {
        range.lo = std::min(range.lo, x);
        range.hi = std::max(range.hi, x);
    };
    for (int k = 0; k < 3; ++k) {
        const Interval t = within_disc(p[k], p[(k + 1) % 3], r);
        if (t.empty()) continue;
        reach(along(p[k], p[(k + 1) % 3], t.lo).x);
        reach(along(p[k], p[(k + 1) % 3], t.hi).x);
    }
    for (Real end : {-r, r}) {
        bool inside = true;
        for (int k = 0; k < 3; ++k)
            inside = inside && sense * turn(p[k], p[(k + 1) % 3], end, 0) >= 0;
        if (inside) reach(end);
    }
    if (range.empty()) return best;
    const Real interior = golden_maximum(range.lo, range.hi, [&](Real x) {
        const std::optional<Chord> chord = chord_at(p, x);
        if (!chord) return none;
        const Real half = std::sqrt(std::max(Real(0), (r - x) * (r + x)));
        const Real lo = std::max(chord->from.y, -half), hi = std::min(chord->to.y, half);
        if (lo > hi) return none;
        const Real length = chord->to.y - chord->from.y;
        return golden_maximum(lo, hi, [&](Real y) {
            const Real t = length > 0 ? (y - chord->from.y) / length : 0;
            return lift_at(cutter, x, y, chord->from.z + t * (chord->to.z - chord->from.z));
        });
    });
    return std::max(best, interior);
}

} // namespace

BruteCutter::BruteCutter(std::function<long double(long double)> g, long double max_radius)
    : height(std::move(g)), radius(max_radius) {}

BruteCutter::BruteCutter(const AptCutter& cutter) {
    const Real r = cutter.r, e = cutter.e, f = cutter.f, h = cutter.h;
    const Real bottom = std::tan(Real(cutter.alpha)), side = std::tan(Real(cutter.beta));
    const Real corner = Real(cutter.d) / 2, corner_z = corner * bottom;
    // Distances at which the bottom gives over to the circle and the circle to the side.
    Real rho_a = corner, rho_b = corner;
    if (r > 0) {
        // Outer crossing of the circle with z = rho tan(alpha), lower one with rho = corner + (z - corner_z)
        // tan(beta).
        const Real ca = std::cos(Real(cutter.alpha)), sa = std::sin(Real(cutter.alpha));
        const Real cb = std::cos(Real(cutter.beta)), sb = std::sin(Real(cutter.beta));
        const auto half_chord = [&](Real distance) {
            const Real square = r * r - distance * distance;
            return square > 1e-11L * r * r ? std::sqrt(square) : 0; // less is a tangent's rounding
        };
        rho_a = std::max(Real(0), (e * ca + f * sa + half_chord(f * ca - e * sa)) * ca);
        const Real t =
            (e - corner) * sb + (f - corner_z) * cb - half_chord((corner - e) * cb - (corner_z - f) * sb);
        rho_b = corner + t * sb;
        if (corner_z + t * cb > f) rho_b = e + r; // beyond its widest place the circle is no lower surface
    }
    height = [=](Real rho) -> Real {
        if (rho <= rho_a) return rho * bottom;
        if (rho <= rho_b) return f - std::sqrt(std::max(Real(0), (r - (rho - e)) * (r + (rho - e))));
        return corner_z + (rho - corner) / side;
    };
    radius = rho_b;
    if (side > 0) radius = std::max(radius, corner + (h - corner_z) * side);
    if (height(radius) > h) { // the cutter ends below: find where
        Real lo = 0, hi = radius;
        for (int i = 0; i < 200; ++i) {
            const Real middle = (lo + hi) / 2;
            (height(middle) <= h ? lo : hi) = middle;
        }
        radius = lo;
    }
}

double brute_lift(const BruteCutter& cutter, const Vec3& a, const Vec3& b, const Vec3& c, double x,
                  double y) {
    const auto local = [&](const Vec3& v) { return Point{Real(v.x()) - x, Real(v.y()) - y, Real(v.z())}; };
    Point p[3] = {local(a), local(b), local(c)};
    return double(facet_lift(cutter, p));
}

double brute_lift(const BruteCutter& cutter, const Mesh& mesh, double x, double y) {
    double best = -infinity;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        best =
            std::max(best, brute_lift(cutter, mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2), x, y));
    return best;
}

} // namespace facetmill::test
