#include "core/strategy/plan/strip.h"

#include "core/mesh/triangle_distance.h"

namespace facetmill {

namespace {
/// A place that is no farther from a strip's facets than this share of the part's size lies on it.
constexpr double on_strip = 1e-4;
} // namespace

std::optional<std::size_t> strip_at(const Vec3& p, std::span<const Strip* const> strips, double part_size) {
    std::optional<std::size_t> nearest;
    const double reach = on_strip * part_size;
    double least = reach * reach;
    for (std::size_t i = 0; i < strips.size(); ++i)
        for (const auto& [a, b, c] : strips[i]->band)
            if (const double d = squared_distance(p, a, b, c); d < least) {
                least = d;
                nearest = i;
            }
    return nearest;
}

} // namespace facetmill
