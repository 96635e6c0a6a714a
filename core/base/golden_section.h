// The lowest place of a function of one variable that falls up to it and rises from it.
#pragma once

#include <algorithm>
#include <limits>

namespace facetmill {

struct LowPlace {
    double at = 0, value = 0;
};

/// Golden-section search (Kiefer 1953) in [lo, hi], until the place is known to `accuracy` or a value is not
/// above `enough`. Returns the best place that was asked. On a stretch where the function is level, or that
/// is known to rounding, any of its places.
template <class F>
LowPlace golden_minimum(F&& f, double lo, double hi, double accuracy, double enough) {
    constexpr double golden = 0.6180339887498949;
    constexpr int max_steps = 80; // beyond the last bit of any interval
    LowPlace a{hi - golden * (hi - lo)}, b{lo + golden * (hi - lo)};
    a.value = f(a.at);
    b.value = f(b.at);
    for (int i = 0; i < max_steps && a.value > enough && b.value > enough && !(hi - lo < accuracy); ++i) {
        if (a.value < b.value) {
            hi = b.at;
            b = a;
            a.at = hi - golden * (hi - lo);
            a.value = f(a.at);
        } else {
            lo = a.at;
            a = b;
            b.at = lo + golden * (hi - lo);
            b.value = f(b.at);
        }
    }
    if (a.value <= enough) return a;
    return b.value < a.value ? b : a;
}

/// The least value in [lo, hi] of such a function that may be infinite beside a stretch where it is not, as
/// of a line that meets a body only here and there. Where two values are the same, both infinite, the stretch
/// is taken to be on the side that `low_side` says.
template <class F>
double min_where_finite(F&& f, double lo, double hi, bool low_side) {
    constexpr double section = 0.382; // as above, to three digits: both places are asked anew in each step
    constexpr int steps = 24;         // to 1e-5 of the interval
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < steps; ++i) {
        const double x1 = lo + section * (hi - lo), x2 = hi - section * (hi - lo);
        const double f1 = f(x1), f2 = f(x2);
        least = std::min({least, f1, f2});
        if (f1 < f2 || (f1 == f2 && low_side))
            hi = x2;
        else
            lo = x1;
    }
    return least;
}

} // namespace facetmill
