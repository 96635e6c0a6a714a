#include "core/mesh/exact_area.h"

#include <array>
#include <cmath>
#include <limits>

namespace facetmill::detail {

namespace {

/// A number as an unevaluated sum of doubles that do not overlap: exact.
class ExactSum {
public:
    void add(double value) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double sum = value + terms_[i];
            const double shifted = sum - value;
            const double error = (value - (sum - shifted)) + (terms_[i] - shifted);
            if (error != 0.0) terms_[kept++] = error;
            value = sum;
        }
        count_ = kept;
        if (value != 0.0) terms_[count_++] = value;
    }
    void add_product(double x, double y) {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }
    bool zero() const { return count_ == 0; }

private:
    std::array<double, 24> terms_{};
    std::size_t count_ = 0;
};

/// x - y = high + low, exactly.
struct Difference {
    double high, low;
    Difference(double x, double y) : high(x - y) {
        const double shifted = x - high;
        low = (x - (high + shifted)) + (shifted - y);
    }
};

bool zero_determinant(double ax, double ay, double bx, double by, double cx, double cy) {
    const Difference ux(bx, ax), uy(by, ay), vx(cx, ax), vy(cy, ay);
    ExactSum sum;
    for (const double x : {ux.high, ux.low})
        for (const double y : {vy.high, vy.low})
            sum.add_product(x, y);
    for (const double y : {uy.high, uy.low})
        for (const double x : {vx.high, vx.low})
            sum.add_product(-y, x);
    return sum.zero();
}

} // namespace

bool exactly_collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
    constexpr double bound = 8.0 * std::numeric_limits<double>::epsilon();
    const Vec3 u = b - a, v = c - a;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double left = u[i] * v[j], right = u[j] * v[i];
        if (std::abs(left - right) > bound * (std::abs(left) + std::abs(right))) return false;
    }
    return zero_determinant(a.x(), a.y(), b.x(), b.y(), c.x(), c.y())
           && zero_determinant(a.y(), a.z(), b.y(), b.z(), c.y(), c.z())
           && zero_determinant(a.z(), a.x(), b.z(), b.x(), c.z(), c.x());
}

} // namespace facetmill::detail
