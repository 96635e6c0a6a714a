#include "core/base/usual_value.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

double round_to_digit(double v) {
    if (v == 0) return 0;
    const double power = std::pow(10.0, std::floor(std::log10(std::abs(v)) + 1e-9));
    const double digit = std::round(v / power);
    // Below 1 divided by a whole number, as a file's 0.04 is read.
    return power < 1 ? digit / std::round(1 / power) : digit * power;
}

ParameterValue usual_value(const ParameterInfo& info, LengthUnit unit) {
    const bool in_unit = info.quantity == Quantity::length || info.quantity == Quantity::feed;
    if (unit != LengthUnit::inch || !in_unit) return info.default_value;
    const auto rounded = [&](double v) {
        const double usual = round_to_digit(v / info.scale(unit)) * info.scale(unit);
        return usual < info.minimum || usual > info.maximum ? v : usual;
    };
    ParameterValue value = info.default_value;
    if (auto* d = std::get_if<double>(&value)) *d = rounded(*d);
    if (auto* p = std::get_if<std::array<double, 2>>(&value)) std::ranges::transform(*p, p->begin(), rounded);
    if (auto* t = std::get_if<std::array<double, 3>>(&value)) std::ranges::transform(*t, t->begin(), rounded);
    return value;
}

void take_usual_values(Parameterized& values, LengthUnit unit) {
    for (const ParameterInfo* info : values.parameters())
        if (const ParameterValue usual = usual_value(*info, unit);
            usual != info->default_value && values.get(info->key) == info->default_value)
            values.set(info->key, usual);
}

} // namespace facetmill
