// Sums of products of doubles without rounding (Shewchuk, "Adaptive precision floating-point arithmetic and
// fast robust geometric predicates", 1997: expansions). Internal to the room.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace facetmill::detail {

/// A number as an unevaluated sum of doubles that do not overlap, the largest last: exact, as long as nothing
/// overflows and no product loses bits below 1e-290. `most`: how many terms are added at most.
template <std::size_t most>
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
    /// Two terms.
    void add_product(double x, double y) {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }
    /// Four terms.
    void add_product(double x, double y, double z) {
        const double product = x * y;
        add_product(std::fma(x, y, -product), z);
        add_product(product, z);
    }
    bool zero() const { return count_ == 0; }
    /// -1, 0 or 1.
    int sign() const { return count_ == 0 ? 0 : terms_[count_ - 1] > 0 ? 1 : -1; }

private:
    std::array<double, most> terms_{};
    std::size_t count_ = 0;
};

/// x - y = high + low, exactly.
struct ExactDifference {
    double high, low;
    ExactDifference(double x, double y) : high(x - y) {
        const double shifted = x - high;
        low = (x - (high + shifted)) + (shifted - y);
    }
};

} // namespace facetmill::detail
