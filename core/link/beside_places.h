// Where a rapid down may end that does not end over its place: beside a wall, whose cells stay as high as the
// wall in a stock field for ever, nothing is known to be gone. Millimetres.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <cmath>

namespace facetmill {

/// Such a place has to save this share of the way down at feed.
inline constexpr double beside_worth = 0.5;

/// The places that are asked about, seen from above: a quarter of the cutter's radius away in eight
/// directions, and a half.
inline std::array<Vec2, 16> places_around(const Vec2& p, double radius) {
    constexpr int directions = 8;
    std::array<Vec2, 16> places;
    std::size_t n = 0;
    for (const double away : {0.25, 0.5})
        for (int k = 0; k < directions; ++k) {
            const double angle = 2 * pi * k / directions, r = away * radius;
            places[n++] = p + Vec2(r * std::cos(angle), r * std::sin(angle));
        }
    return places;
}

} // namespace facetmill
