#include "tests/support/reference_lift.h"

#include <algorithm>
#include <cmath>

namespace facetmill::test {

namespace {

Real3 real3(const Vec3& v) {
    return {Real(v.x()), Real(v.y()), Real(v.z())};
}
Real3 operator+(const Real3& a, const Real3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Real3 operator-(const Real3& a, const Real3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Real3 operator*(Real s, const Real3& a) {
    return {s * a.x, s * a.y, s * a.z};
}
Real dot(const Real3& a, const Real3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Real3 cross(const Real3& a, const Real3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real length(const Real3& a) {
    return std::sqrt(dot(a, a));
}

/// Golden-section search for the minimum of a function without a second valley on [lo, hi]; both ends are
/// asked too. `done(value)` ends it early.
template <class F, class Done>
Real golden_minimum(Real lo, Real hi, Real accuracy, F&& f, Done&& done) {
    const Real golden = (std::sqrt(Real(5)) - 1) / 2;
    Real x1 = hi - golden * (hi - lo), x2 = lo + golden * (hi - lo), f1 = f(x1), f2 = f(x2);
    Real best = std::min({f(lo), f(hi), f1, f2});
    while (hi - lo > accuracy && !done(best)) {
        if (f1 < f2) {
            hi = x2;
            x2 = x1;
            f2 = f1;
            x1 = hi - golden * (hi - lo);
            f1 = f(x1);
        } else {
            lo = x1;
            x1 = x2;
            f1 = f2;
            x2 = lo + golden * (hi - lo);
            f2 = f(x2);
        }
        best = std::min({best, f1, f2});
        if (!(x1 > lo && x2 < hi && x1 < x2)) break;
    }
    return best;
}

/// Along the line q - s v: the tightest constraint of the body and its slope.
struct OnLine {
    Real value, slope;
};
OnLine on_line(const ReferenceBody& body, const ReferencePosture& posture, const Real3& q, Real s) {
    const Real3 p = q - s * posture.v;
    const Real z = dot(p, posture.axis);
    const Real3 out = p - z * posture.axis;
    const Real rho = length(out);
    const ReferenceBody::Outside o = body.outside(rho, z);
    const Real rho_slope = rho > 0 ? -dot(out, posture.v) / rho : 0;
    return {o.value, o.nr * rho_slope - o.nz * dot(posture.v, posture.axis)};
}

/// The lift over a point, or, where there is none, something far lower that falls with the distance by which
/// the body misses the point: together a function whose upper sets are convex.
Real point_merit(const ReferenceBody& body, const ReferencePosture& posture, const Real3& q) {
    const Real far = dot(q, posture.v) + body.reach(); // beyond it nothing of the body can be
    // Newton's steps from above on a convex function never pass its last zero.
    Real s = far;
    OnLine at = on_line(body, posture, q, s);
    for (int i = 0; i < 2000 && at.value > 0 && at.slope > 0; ++i) {
        const Real next = s - at.value / at.slope;
        if (!(next < s)) return s;
        s = next;
        at = on_line(body, posture, q, s);
    }
    if (at.value <= 0) return s;
    const Real miss = golden_minimum(
        dot(q, posture.v) - body.reach(), far, 1e-15L * (1 + std::abs(far)),
        [&](Real t) { return on_line(body, posture, q, t).value; }, [](Real value) { return value <= 0; });
    return -1e9L * (1 + miss);
}

struct Local {
    std::array<Real3, 3> q;
    Local(const ReferencePosture& posture, const ReferenceFacet& facet) {
        for (std::size_t k = 0; k < 3; ++k)
            q[k] = real3(facet[k]) - posture.tip;
    }
};

/// `fall` = -m . v > 0.
Real bound_local(const ReferenceBody& body, const ReferencePosture& posture, const Local& local,
                 const Real3& m, Real fall, Real grow) {
    const Real mz = dot(m, posture.axis);
    const Real mr = length(m - mz * posture.axis);
    const Real least = std::min({dot(m, local.q[0]), dot(m, local.q[1]), dot(m, local.q[2])});
    return (body.extent(mr, mz) + grow * length(m) - least) / fall;
}

/// What a bound needs of a direction, all of it linear in that: so those of m + w n come without them.
struct Row {
    Real3 m, out;
    Real z;
    std::array<Real, 3> at;
    Row(const ReferencePosture& posture, const Local& local, const Real3& direction)
        : m(direction), out(m - dot(m, posture.axis) * posture.axis),
          z(dot(m, posture.axis)), at{dot(m, local.q[0]), dot(m, local.q[1]), dot(m, local.q[2])} {}
};

/// The bound by m + w n, whose product with v is -1.
Real bound_on(const ReferenceBody& body, const Row& m, const Row& n, Real w, Real grow) {
    Real least = m.at[0] + w * n.at[0];
    for (std::size_t k = 1; k < 3; ++k)
        least = std::min(least, m.at[k] + w * n.at[k]);
    const Real grown = grow != 0 ? grow * length(m.m + w * n.m) : 0;
    return body.extent(length(m.out + w * n.out), m.z + w * n.z) + grown - least;
}

/// The closest point of a segment, as a distance.
Real from_segment(const Real3& p, const Real3& a, const Real3& b) {
    const Real3 d = b - a;
    const Real square = dot(d, d);
    const Real t = square > 0 ? std::clamp(dot(p - a, d) / square, Real(0), Real(1)) : 0;
    return length(p - (a + t * d));
}

} // namespace

ReferenceBody::ReferenceBody(const AptCutter& cutter, double height) {
    const Real d2 = Real(cutter.d) / 2, alpha = cutter.alpha, beta = cutter.beta, h = cutter.h, base = height;
    const Real ca = std::cos(alpha), sa = std::sin(alpha), cb = std::cos(beta), sb = std::sin(beta);
    const Real corner_z = d2 * std::tan(alpha);
    Corner first{d2, corner_z}, last = first;
    e_ = cutter.e;
    f_ = cutter.f;
    r_ = cutter.r;
    if (r_ > 0) {
        // Outer crossing of the circle with the bottom line, lower one with the side line.
        const auto half_chord = [&](Real distance) {
            const Real square = r_ * r_ - distance * distance;
            return square > 1e-11L * r_ * r_ ? std::sqrt(square) : 0; // less is a tangent's rounding
        };
        const Real a = std::max(Real(0), e_ * ca + f_ * sa + half_chord(f_ * ca - e_ * sa));
        const Real b =
            (e_ - d2) * sb + (f_ - corner_z) * cb - half_chord((d2 - e_) * cb - (corner_z - f_) * sb);
        first = {a * ca, a * sa};
        last = {d2 + std::max(Real(0), b) * sb, corner_z + std::max(Real(0), b) * cb};
        rounded_ = first.z < h;
    }
    // What is above h is cut off.
    if (first.z >= h) first = last = {h / std::tan(alpha), h};
    if (rounded_ && last.z > h)
        last = {e_ + std::sqrt(std::max(Real(0), (r_ - (h - f_)) * (r_ + (h - f_)))), h};
    const Real top = last.z < h ? std::max(Real(0), last.rho + (h - last.z) * std::tan(beta)) : last.rho;
    corners_ = {
        {0, base}, {first.rho, first.z + base}, {last.rho, last.z + base}, {top, h + base}, {0, h + base}};
    lines_ = {{sa, -ca, -ca * base}, {0, 1, h + base}, {0, -1, -base}};
    if (last.z < h) lines_.push_back({cb, -sb, cb * last.rho - sb * (last.z + base)});
    f_ += base;
    if (rounded_) {
        start_r_ = (first.rho - e_) / r_;
        start_z_ = (first.z + base - f_) / r_;
        end_r_ = (last.rho - e_) / r_;
        end_z_ = (last.z + base - f_) / r_;
    }
    for (const Corner& c : corners_)
        reach_ = std::max(reach_, std::hypot(c.rho, c.z));
    if (rounded_) reach_ = std::max(reach_, std::hypot(e_, f_) + r_);
}

Real ReferenceBody::extent(Real mr, Real mz) const {
    Real most = no_lift;
    for (const Corner& c : corners_)
        most = std::max(most, mr * c.rho + mz * c.z);
    if (rounded_ && start_r_ * mz - start_z_ * mr >= 0 && mr * end_z_ - mz * end_r_ >= 0)
        most = std::max(most, mr * e_ + mz * f_ + r_ * std::sqrt(mr * mr + mz * mz));
    return most;
}

ReferenceBody::Outside ReferenceBody::outside(Real rho, Real z) const {
    Outside worst{no_lift, 0, 0};
    for (const Line& l : lines_) {
        const Real value = l.nr * rho + l.nz * z - l.c;
        if (value > worst.value) worst = {value, l.nr, l.nz};
    }
    if (!rounded_) return worst;
    // The largest n . (p - centre) - r over the arc's normals n.
    const Real dr = rho - e_, dz = z - f_;
    const auto take = [&](Real nr, Real nz) {
        const Real value = nr * dr + nz * dz - r_;
        if (value > worst.value) worst = {value, nr, nz};
    };
    take(start_r_, start_z_);
    take(end_r_, end_z_);
    const Real away = std::sqrt(dr * dr + dz * dz);
    if (away > 0 && start_r_ * dz - start_z_ * dr >= 0 && dr * end_z_ - dz * end_r_ >= 0)
        take(dr / away, dz / away);
    return worst;
}

ReferencePosture::ReferencePosture(const Vec3& t, const Vec3& a, const Vec3& direction)
    : tip(real3(t)), axis(real3(a)), v(real3(direction)) {
    axis = (1 / length(axis)) * axis;
    v = (1 / length(v)) * v;
}

Real reference_lift(const ReferenceBody& body, const ReferencePosture& posture, const ReferenceFacet& facet) {
    const Local local(posture, facet);
    const Real3 u = local.q[1] - local.q[0], across = local.q[2] - local.q[1];
    const auto never = [](Real) { return false; };
    const Real best = -golden_minimum(
        0, 1, 1e-17L,
        [&](Real y) {
            return golden_minimum(
                0, 1, 1e-17L,
                [&](Real x) { return -point_merit(body, posture, local.q[0] + y * (u + x * across)); },
                never);
        },
        never);
    return best < -1e8L ? no_lift : best;
}

Real bound_of(const ReferenceBody& body, const ReferencePosture& posture, const ReferenceFacet& facet,
              const Vec3& m, Real grow) {
    const Real3 direction = real3(m);
    if (!(dot(direction, posture.v) < 0)) return std::numeric_limits<Real>::infinity();
    return bound_local(body, posture, Local(posture, facet), direction, -dot(direction, posture.v), grow);
}

Real reference_bound(const ReferenceBody& body, const ReferencePosture& posture, const ReferenceFacet& facet,
                     Real grow, Real enough) {
    const Local local(posture, facet);
    // Lifts of points that are touched are no lower than this: a lower bound says that none is.
    Real lowest = -body.reach() - std::abs(grow) - 1;
    for (const Real3& q : local.q)
        lowest -= length(q);
    const Real stop = std::max(enough, lowest);
    const Real3 &v = posture.v, unit = std::abs(v.x) < 0.6L ? Real3{1, 0, 0} : Real3{0, 1, 0};
    Real3 g1 = cross(v, unit);
    g1 = (1 / length(g1)) * g1;
    const Real3 g2 = cross(v, g1);
    const auto done = [&](Real value) { return value <= stop; };
    // All m with m . v = -1, through a map of (-1, 1) to all numbers that is as even as angles are, so that
    // those nearly across v are reached as well.
    const auto stretched = [](Real u) { return u / ((1 - u) * (1 + u)); };
    const Real end = 1 - 1e-17L, accuracy = 1e-16L;
    const Row along(posture, local, g2);
    const Real least = golden_minimum(
        -end, end, accuracy,
        [&](Real psi) {
            const Real s = stretched(psi), scale = std::sqrt(1 + s * s);
            const Row from(posture, local, s * g1 - v);
            return golden_minimum(
                -end, end, accuracy,
                [&](Real phi) { return bound_on(body, from, along, scale * stretched(phi), grow); }, done);
        },
        done);
    return least <= lowest ? no_lift : least;
}

Witness witness(const ReferenceBody& body, const ReferencePosture& posture, const ReferenceFacet& facet,
                const Vec3& point, double lift) {
    const Local local(posture, facet);
    const Real3 q = real3(point) - posture.tip, p = q - Real(lift) * posture.v;
    const Real z = dot(p, posture.axis);
    Witness w{std::numeric_limits<Real>::infinity(), body.outside(length(p - z * posture.axis), z).value};
    for (std::size_t k = 0; k < 3; ++k)
        w.from_facet = std::min(w.from_facet, from_segment(q, local.q[k], local.q[(k + 1) % 3]));
    const Real3 n = cross(local.q[1] - local.q[0], local.q[2] - local.q[0]);
    if (length(n) > 0) {
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k)
            inside = inside && dot(cross(local.q[(k + 1) % 3] - local.q[k], q - local.q[k]), n) >= 0;
        if (inside) w.from_facet = std::min(w.from_facet, std::abs(dot(q - local.q[0], n)) / length(n));
    }
    return w;
}

Vec3 normal_at(const ReferenceBody& body, const ReferencePosture& posture, const Vec3& point, double lift) {
    const Real3 p = real3(point) - posture.tip - Real(lift) * posture.v;
    const Real z = dot(p, posture.axis);
    const Real3 out = p - z * posture.axis;
    const Real rho = length(out);
    const ReferenceBody::Outside o = body.outside(rho, z);
    const Real3 n = (rho > 0 ? o.nr / rho : 0) * out + o.nz * posture.axis;
    return Vec3(double(n.x), double(n.y), double(n.z));
}

Real reference_bound(const ReferenceBody& body, const ReferencePosture& posture, const Mesh& mesh,
                     Real grow) {
    // Facets that may have the highest lift first; the rest need no more than the proof that they have not.
    std::vector<std::pair<Real, std::size_t>> order;
    const auto facet_at = [&](std::size_t f) {
        return ReferenceFacet{mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)};
    };
    const Vec3 back(double(-posture.v.x), double(-posture.v.y), double(-posture.v.z));
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        order.push_back({bound_of(body, posture, facet_at(f), back, grow), f});
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    Real best = no_lift;
    for (const auto& [most, f] : order) {
        if (most <= best) break;
        best = std::max(best, reference_bound(body, posture, facet_at(f), grow, best));
    }
    return best;
}

} // namespace facetmill::test
