#include "core/mesh/exact_side.h"

#include "core/mesh/exact_sum.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

int summed_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    using detail::ExactDifference;
    const auto from_d = [&](const Vec3& p) {
        return std::array{ExactDifference(p.x(), d.x()), ExactDifference(p.y(), d.y()),
                          ExactDifference(p.z(), d.z())};
    };
    const auto u = from_d(a), v = from_d(b), w = from_d(c);
    constexpr std::size_t terms = 6 * 8 * 4;
    detail::ExactSum<terms> sum;
    const auto add = [&](double sign, const ExactDifference& x, const ExactDifference& y,
                         const ExactDifference& z) {
        for (const double i : {x.low, x.high})
            for (const double j : {y.low, y.high})
                for (const double k : {z.low, z.high})
                    sum.add_product(sign * i, j, k);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        add(1, u[i], v[j], w[k]);
        add(-1, u[i], v[k], w[j]);
    }
    return sum.sign();
}

/// Turns the triangle until its first corner is alone on its side of a plane, by the sides of its corners,
/// and says on which; 0 where the plane does not go through its inside.
int put_lone_first(std::array<Vec3, 3>& t, std::array<int, 3>& side) {
    const auto [least, most] = std::minmax_element(side.begin(), side.end());
    if (*least >= 0 || *most <= 0) return 0;
    const auto count = [&](int s) { return std::count(side.begin(), side.end(), s); };
    const int lone = count(1) == 1 ? 1 : -1;
    const auto at = std::find(side.begin(), side.end(), lone) - side.begin();
    std::rotate(t.begin(), t.begin() + at, t.end());
    std::rotate(side.begin(), side.begin() + at, side.end());
    return lone;
}

std::array<int, 3> sides_of(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& plane) {
    return {exact_side(plane[0], plane[1], plane[2], t[0]), exact_side(plane[0], plane[1], plane[2], t[1]),
            exact_side(plane[0], plane[1], plane[2], t[2])};
}

} // namespace

int exact_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    constexpr double share = 8e-16; // Shewchuk's bound A, 7 u + 56 u^2 with u = 2^-53, rounded up
    const Vec3 u = a - d, v = b - d, w = c - d;
    const double vw = v.y() * w.z() - v.z() * w.y(), wu = w.y() * u.z() - w.z() * u.y(),
                 uv = u.y() * v.z() - u.z() * v.y();
    const double volume = u.x() * vw + v.x() * wu + w.x() * uv;
    const double size = std::abs(u.x()) * (std::abs(v.y() * w.z()) + std::abs(v.z() * w.y()))
                        + std::abs(v.x()) * (std::abs(w.y() * u.z()) + std::abs(w.z() * u.y()))
                        + std::abs(w.x()) * (std::abs(u.y() * v.z()) + std::abs(u.z() * v.y()));
    const double doubt = share * size;
    if (volume > doubt) return 1;
    if (volume < -doubt) return -1;
    if (a == d || b == d || c == d) return 0;
    return summed_side(a, b, c, d);
}

bool triangles_cross(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u) {
    std::array<Vec3, 3> p = t, q = u;
    std::array<int, 3> side = sides_of(q, p);
    const int q_alone = put_lone_first(q, side);
    if (q_alone == 0) return false;
    side = sides_of(p, q);
    const int p_alone = put_lone_first(p, side);
    if (p_alone == 0) return false;
    // Each seen from where the other's lone corner is: then both stretches of the line that the planes have
    // in common run the same way.
    if (q_alone < 0) std::swap(p[1], p[2]);
    if (p_alone < 0) std::swap(q[1], q[2]);
    return exact_side(p[0], p[1], q[0], q[1]) < 0 && exact_side(p[0], p[2], q[2], q[0]) < 0;
}

} // namespace facetmill
