#include "tests/support/brute_lift.h"

#include "tests/support/convex_bound.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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

/// Largest value of a concave function on [lo, hi], its ends included, to a hundredth of the 1e-9 mm that
/// tests allow. Where it is nowhere above `floor` any of its values will do.
template <class F>
Real golden_maximum(Real lo, Real hi, F&& f, Real floor = none) {
    constexpr Real accuracy = 1e-11L;
    const Real golden = (std::sqrt(Real(5)) - 1) / 2;
    Real at_lo = f(lo), at_hi = f(hi);
    Real best = std::max(at_lo, at_hi);
    Real x1 = hi - golden * (hi - lo), x2 = lo + golden * (hi - lo), f1 = f(x1), f2 = f(x2);
    // To the last digit of a double: the function may be as steep as the facet, or steeper on the cutter's
    // side.
    while (hi - lo > 1e-16L * std::max({Real(1), std::abs(lo), std::abs(hi)})) {
        best = std::max({best, f1, f2});
        if (-no_lower(lo, x1, x2, hi, -at_lo, -f1, -f2, -at_hi) <= std::max(best, floor) + accuracy) break;
        if (f1 < f2) {
            lo = x1;
            at_lo = f1;
            x1 = x2;
            f1 = f2;
            x2 = lo + golden * (hi - lo);
            f2 = f(x2);
        } else {
            hi = x2;
            at_hi = f2;
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
    return z - cutter.height(std::min(std::sqrt(x * x + y * y), cutter.radius()));
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

Real edge_lift(const BruteCutter& cutter, const Point& a, const Point& b, Real floor) {
    const Interval t = within_disc(a, b, cutter.radius());
    if (t.empty()) return none;
    const auto over = [&](Real s) {
        const Point p = along(a, b, s);
        return lift_at(cutter, p.x, p.y, p.z);
    };
    return golden_maximum(t.lo, t.hi, over, floor);
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

/// A facet nowhere above `floor` may be told lower than it is.
Real facet_lift(const BruteCutter& cutter, Point (&p)[3], Real floor) {
    Real best = none;
    for (int k = 0; k < 3; ++k)
        best = std::max(best, edge_lift(cutter, p[k], p[(k + 1) % 3], std::max(best, floor)));
    const Real area = turn(p[0], p[1], p[2].x, p[2].y);
    if (area == 0) return best; // seen along the axis it is its edges
    const Real r = cutter.radius();
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
    const auto over_chord = [&](Real x) {
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
    };
    return std::max(best, golden_maximum(range.lo, range.hi, over_chord, std::max(best, floor)));
}

} // namespace

BruteCutter::BruteCutter(std::function<Real(Real)> g, Real max_radius)
    : function_(std::move(g)), radius_(max_radius) {}

BruteCutter::BruteCutter(const AptCutter& cutter)
    : r_(cutter.r), e_(cutter.e), f_(cutter.f), bottom_(std::tan(Real(cutter.alpha))),
      side_(std::tan(Real(cutter.beta))), corner_(Real(cutter.d) / 2), corner_z_(corner_ * bottom_),
      rho_a_(corner_), rho_b_(corner_) {
    const Real h = cutter.h;
    if (r_ > 0) {
        // Outer crossing of the circle with z = rho tan(alpha), lower one with rho = corner + (z - corner_z)
        // tan(beta).
        const Real ca = std::cos(Real(cutter.alpha)), sa = std::sin(Real(cutter.alpha));
        const Real cb = std::cos(Real(cutter.beta)), sb = std::sin(Real(cutter.beta));
        const auto half_chord = [&](Real distance) {
            const Real square = r_ * r_ - distance * distance;
            return square > 1e-11L * r_ * r_ ? std::sqrt(square) : 0; // less is a tangent's rounding
        };
        rho_a_ = std::max(Real(0), (e_ * ca + f_ * sa + half_chord(f_ * ca - e_ * sa)) * ca);
        const Real t = (e_ - corner_) * sb + (f_ - corner_z_) * cb
                       - half_chord((corner_ - e_) * cb - (corner_z_ - f_) * sb);
        rho_b_ = corner_ + t * sb;
        if (corner_z_ + t * cb > f_)
            rho_b_ = e_ + r_; // beyond its widest place the circle is no lower surface
    }
    radius_ = rho_b_;
    if (side_ > 0) radius_ = std::max(radius_, corner_ + (h - corner_z_) * side_);
    if (height(radius_) > h * (1 + 1e-15L)) { // the cutter ends below: find where
        Real lo = 0, hi = radius_;
        for (int i = 0; i < 200; ++i) {
            const Real middle = (lo + hi) / 2;
            (height(middle) <= h ? lo : hi) = middle;
        }
        radius_ = lo;
    }
}

double brute_lift(const BruteCutter& cutter, const Vec3& a, const Vec3& b, const Vec3& c, double x, double y,
                  double floor) {
    const auto local = [&](const Vec3& v) { return Point{Real(v.x()) - x, Real(v.y()) - y, Real(v.z())}; };
    Point p[3] = {local(a), local(b), local(c)};
    return double(facet_lift(cutter, p, Real(floor)));
}

double brute_lift(const BruteCutter& cutter, const Mesh& mesh, double x, double y) {
    // No point of a facet is higher than its highest corner, and none is nearer to the axis than its box.
    struct Candidate {
        double most;
        std::size_t facet;
    };
    std::vector<Candidate> candidates;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        Box3 box;
        for (int k = 0; k < 3; ++k)
            box.add(mesh.corner(f, k));
        const Real dx = std::max({Real(box.lo.x()) - x, x - Real(box.hi.x()), Real(0)});
        const Real dy = std::max({Real(box.lo.y()) - y, y - Real(box.hi.y()), Real(0)});
        const Real distance = std::sqrt(dx * dx + dy * dy);
        if (distance > cutter.radius()) continue;
        candidates.push_back({double(Real(box.hi.z()) - cutter.height(distance)) + 1e-12, f});
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.most > b.most; });
    double best = -infinity;
    for (const Candidate& c : candidates) {
        if (c.most <= best) break;
        best = std::max(best, brute_lift(cutter, mesh.corner(c.facet, 0), mesh.corner(c.facet, 1),
                                         mesh.corner(c.facet, 2), x, y, best));
    }
    return best;
}

} // namespace facetmill::test
