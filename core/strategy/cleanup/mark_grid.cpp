#include "core/strategy/cleanup/mark_grid.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

MarkGrid::MarkGrid(const Box3& box, double cell, double margin)
    : lo_(box.lo.head<2>() - Vec2::Constant(margin + 2 * cell)), cell_(cell) {
    const Vec2 size = box.hi.head<2>() - box.lo.head<2>() + Vec2::Constant(2 * margin + 4 * cell);
    columns_ = int(size.x() / cell) + 1;
    rows_ = int(size.y() / cell) + 1;
    sum_.assign(std::size_t(columns_ + 1) * std::size_t(rows_ + 1), 0);
}

void MarkGrid::mark(const Vec2& at, double radius) {
    const auto [x0, y0] = cell_of(at - Vec2::Constant(radius));
    const auto [x1, y1] = cell_of(at + Vec2::Constant(radius));
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            sum_[at_corner(x + 1, y + 1)] = 1;
}

void MarkGrid::finish() {
    for (int y = 1; y <= rows_; ++y)
        for (int x = 1; x <= columns_; ++x)
            sum_[at_corner(x, y)] +=
                sum_[at_corner(x - 1, y)] + sum_[at_corner(x, y - 1)] - sum_[at_corner(x - 1, y - 1)];
}

bool MarkGrid::any(const Vec2& lo, const Vec2& hi) const {
    const auto [x0, y0] = cell_of(lo);
    const auto [x1, y1] = cell_of(hi);
    return sum_[at_corner(x1 + 1, y1 + 1)] - sum_[at_corner(x0, y1 + 1)] - sum_[at_corner(x1 + 1, y0)]
               + sum_[at_corner(x0, y0)]
           > 0;
}

std::array<int, 2> MarkGrid::cell_of(const Vec2& p) const {
    return {std::clamp(int(std::floor((p.x() - lo_.x()) / cell_)), 0, columns_ - 1),
            std::clamp(int(std::floor((p.y() - lo_.y()) / cell_)), 0, rows_ - 1)};
}

} // namespace facetmill
