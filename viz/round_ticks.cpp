#include "viz/round_ticks.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

double round_step(double range, int most) {
    if (!(range > 0) || !std::isfinite(range)) return 1;
    const double least = range / std::max(most, 1);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= least * (1 - 1e-9)) return step * power;
    return 10 * power;
}

std::vector<double> round_ticks(double lo, double hi, int most) {
    const double step = round_step(hi - lo, most);
    std::vector<double> ticks;
    for (double k = std::ceil(lo / step - 1e-6); k * step <= hi + 1e-6 * step; ++k)
        ticks.push_back(k == 0 ? 0 : k * step);
    return ticks;
}

} // namespace facetmill
