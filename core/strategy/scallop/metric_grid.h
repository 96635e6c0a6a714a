// A metric over the places of a grid, which distances and contours are asked of. Millimetres.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <span>

namespace facetmill {

/// What it refers to has to outlive it.
struct MetricGrid {
    using Metric = std::array<double, 3>; ///< xx, xy, yy: squares of displacements, in steps

    Vec2 lo = Vec2::Zero(); ///< the first place
    double spacing = 1;
    int columns = 0, rows = 0;
    std::span<const char> cut; ///< places that belong to it
    std::span<const Metric> metric;

    struct Seed {
        std::size_t place;
        double distance; ///< in steps
    };

    std::size_t size() const { return cut.size(); }
    bool has(int column, int row) const { return column >= 0 && row >= 0 && column < columns && row < rows; }
    std::size_t number(int column, int row) const {
        return std::size_t(row) * std::size_t(columns) + std::size_t(column);
    }
    Vec2 place(std::size_t i) const {
        return lo + spacing * Vec2(double(i % std::size_t(columns)), double(i / std::size_t(columns)));
    }
};

} // namespace facetmill
