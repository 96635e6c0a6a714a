// Marks on the cells of a grid, seen from above, and whether a rectangle holds any. Millimetres.
#pragma once

#include "core/mesh/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace facetmill {

class MarkGrid {
public:
    /// Cells over the box and a margin around it.
    MarkGrid(const Box3& box, double cell, double margin);

    /// Marks all cells that the square about a place reaches, `radius` to either side.
    void mark(const Vec2& at, double radius);
    /// After the last mark, before the first question.
    void finish();
    /// Is a cell marked that the rectangle reaches?
    bool any(const Vec2& lo, const Vec2& hi) const;

private:
    std::array<int, 2> cell_of(const Vec2& p) const;
    std::size_t at_corner(int x, int y) const {
        return std::size_t(y) * std::size_t(columns_ + 1) + std::size_t(x);
    }

    Vec2 lo_;
    double cell_;
    int columns_ = 0, rows_ = 0;
    std::vector<std::int64_t> sum_; ///< marked cells below and left of each corner
};

} // namespace facetmill
