// Sides of planes and crossings of triangles, against whole numbers without rounding.
#include "core/mesh/exact_side.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <array>

using namespace facetmill;
using namespace facetmill::test;

namespace {

__extension__ using Whole = __int128;
using Place = std::array<std::int64_t, 3>;

Vec3 vec(const Place& p) {
    return {double(p[0]), double(p[1]), double(p[2])};
}

std::array<Whole, 3> minus(const Place& a, const Place& b) {
    return {Whole(a[0]) - b[0], Whole(a[1]) - b[1], Whole(a[2]) - b[2]};
}

std::array<Whole, 3> cross(const std::array<Whole, 3>& u, const std::array<Whole, 3>& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Whole dot(const std::array<Whole, 3>& u, const std::array<Whole, 3>& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

int sign(Whole v) {
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

int whole_side(const Place& a, const Place& b, const Place& c, const Place& d) {
    return sign(dot(minus(a, d), cross(minus(b, d), minus(c, d))));
}

/// A fraction with a denominator above 0.
struct Fraction {
    Whole over, under;
    bool operator<(const Fraction& other) const { return over * other.under < other.over * under; }
};

/// Where the triangle meets the plane: the stretch between the two places where its outline comes through it,
/// as far along `line` as they lie. False where the plane does not go through its inside.
bool stretch(const std::array<Place, 3>& t, const std::array<Whole, 3>& normal, const Place& on_plane,
             const std::array<Whole, 3>& line, Fraction& from, Fraction& to) {
    std::array<Whole, 3> height, along;
    for (std::size_t k = 0; k < 3; ++k) {
        height[k] = dot(normal, minus(t[k], on_plane));
        along[k] = dot(line, minus(t[k], Place{}));
    }
    if (*std::min_element(height.begin(), height.end()) >= 0) return false;
    if (*std::max_element(height.begin(), height.end()) <= 0) return false;
    std::vector<Fraction> places;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3;
        if (height[k] == 0) places.push_back({along[k], 1});
        if (sign(height[k]) * sign(height[l]) >= 0) continue;
        const Whole d = height[k] - height[l];
        const Whole over = along[k] * -height[l] + along[l] * height[k];
        places.push_back({d > 0 ? over : -over, d > 0 ? d : -d});
    }
    from = *std::min_element(places.begin(), places.end());
    to = *std::max_element(places.begin(), places.end());
    return from < to;
}

/// The insides have a place in common: both stretches of the line in which the planes meet do.
bool whole_cross(const std::array<Place, 3>& t, const std::array<Place, 3>& u) {
    const auto normal_t = cross(minus(t[1], t[0]), minus(t[2], t[0])),
               normal_u = cross(minus(u[1], u[0]), minus(u[2], u[0]));
    const auto line = cross(normal_t, normal_u);
    Fraction t_from{}, t_to{}, u_from{}, u_to{};
    if (line == std::array<Whole, 3>{}) return false;
    if (!stretch(t, normal_u, u[0], line, t_from, t_to) || !stretch(u, normal_t, t[0], line, u_from, u_to))
        return false;
    return t_from < u_to && u_from < t_to;
}

} // namespace

class TestExactSide : public QObject {
    Q_OBJECT
private slots:

    void sides_are_exact() {
        Random rng(11);
        std::array<int, 3> seen{};
        for (int trial = 0; trial < 40000; ++trial) {
            // Three places up to 2^26 off, and a fourth in their plane but for a step or none.
            const int size = trial % 2 ? 1 << 26 : 8;
            const auto place = [&] {
                return Place{whole(rng, -size, size), whole(rng, -size, size), whole(rng, -size, size)};
            };
            const Place a = place(), b = place(), c = place();
            Place d = place();
            if (trial % 3 > 0) {
                for (std::size_t k = 0; k < 3; ++k)
                    d[k] = b[k] + c[k] - a[k] + (trial % 3 == 2 && k == 1 ? whole(rng, -1, 1) : 0);
            }
            const int want = whole_side(a, b, c, d);
            ++seen[std::size_t(want + 1)];
            QCOMPARE(exact_side(vec(a), vec(b), vec(c), vec(d)), want);
            QCOMPARE(exact_side(vec(b), vec(a), vec(c), vec(d)), -want);
            // The same far from the origin, where differences have no rounding, and small.
            const Vec3 far(0x1p52, -0x1p51, 0x1p50);
            if (size == 8) {
                QCOMPARE(exact_side(vec(a) + far, vec(b) + far, vec(c) + far, vec(d) + far), want);
                QCOMPARE(exact_side(0x1p-60 * vec(a), 0x1p-60 * vec(b), 0x1p-60 * vec(c), 0x1p-60 * vec(d)),
                         want);
            }
        }
        for (const int n : seen)
            QVERIFY(n > 4000);
    }

    /// Differences that are no doubles: 1 + 2^-60 and the like.
    void differences_may_need_more_than_a_double() {
        const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
        QCOMPARE(exact_side(a, b, c, Vec3(0.25, 0.25, 0x1p-200)), -1);
        QCOMPARE(exact_side(a, b, c, Vec3(0x1p60, 1, -0x1p-200)), 1);
        QCOMPARE(exact_side(a, b, c, Vec3(0x1p60, 1, 0)), 0);
        // On the line x = y = z but for the last bit of one.
        const Vec3 p(0x1p-60, 0x1p-60, 0x1p-60), q(1, 1, 1), r(0, 0, 1);
        QCOMPARE(exact_side(a, r, q, p), 0);
        QCOMPARE(exact_side(a, r, q, Vec3(p.x(), std::nextafter(p.y(), 1.0), p.z())),
                 -exact_side(a, r, q, Vec3(p.x(), std::nextafter(p.y(), 0.0), p.z())));
        QVERIFY(exact_side(a, r, q, Vec3(p.x(), std::nextafter(p.y(), 1.0), p.z())) != 0);
    }

    void triangles_cross_as_whole_numbers_say() {
        Random rng(12);
        int crossing = 0, touching = 0;
        for (int trial = 0; trial < 60000; ++trial) {
            // Corners of so few places that all kinds of touching happen.
            const int size = 1 + trial % 4;
            std::array<Place, 3> t, u;
            for (auto* triangle : {&t, &u})
                for (Place& p : *triangle)
                    p = {whole(rng, -size, size), whole(rng, -size, size), whole(rng, -size, size)};
            if (trial % 5 == 0) u[0] = t[0];
            const bool want = whole_cross(t, u);
            crossing += want;
            touching += !want && t[0] == u[0];
            std::array<Vec3, 3> a, b;
            for (std::size_t k = 0; k < 3; ++k) {
                a[k] = vec(t[k]);
                b[k] = vec(u[k]);
            }
            // Whichever corner is named first, and whichever triangle.
            for (int turn = 0; turn < 3; ++turn) {
                QCOMPARE(triangles_cross(a, b), want);
                QCOMPARE(triangles_cross(b, a), want);
                std::rotate(a.begin(), a.begin() + 1, a.end());
                std::swap(b[0], b[1]);
            }
        }
        QVERIFY(crossing > 3000);
        QVERIFY(touching > 3000);
    }
};

FACETMILL_TEST(TestExactSide)
#include "test_exact_side.moc"
