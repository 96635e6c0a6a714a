#include "core/strategy/plan/plan_text.h"

#include "core/base/figures.h"

#include <algorithm>

namespace facetmill {

namespace {

constexpr double min_percent = 1e-3;

} // namespace

std::string PlanText::operator()(double mm) const {
    return length_text(mm, unit);
}

std::string PlanText::operator()(const Vec3& place) const {
    const Vec3 p = to_setup * place;
    std::string all;
    for (int k = 0; k < 3; ++k)
        all += (k == 0 ? "(" : ", ") + coordinate_text(p[k] / mm_per(unit));
    return all + ") " + std::string(unit_name(unit));
}

std::string share_text(double part, double whole) {
    return format_number(std::max(100 * part / whole, min_percent), 2) + " %";
}

} // namespace facetmill
