// The lowest place of a function of one variable that falls up to it and rises from it.
#pragma once

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

} // namespace facetmill
