#include "core/link/later_cuts.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Tiles are so wide in radii of the cutter, and so many at most along a side.
constexpr double tile_radii = 2, max_tiles = 1024;

} // namespace

LaterCuts::LaterCuts(StockField field, const CutterProfile& cutter, double lowest, const Progress& progress)
    : field_(std::move(field)), cutter_(cutter), progress_(progress.part(1, 1)) {
    const bool at_once = is_undercut(cutter) || !(lowest + cutter.height() >= field_.highest());
    if (field_.box().empty() || at_once) return;
    const Vec3 size = field_.box().size();
    tile_ = std::max(tile_radii * cutter.max_radius(), std::max(size.x(), size.y()) / max_tiles);
    columns_ = int(size.x() / tile_) + 1;
    rows_ = int(size.y() / tile_) + 1;
    near_.resize(std::size_t(columns_) * std::size_t(rows_));
}

LaterCuts::Tiles LaterCuts::tiles(const Vec2& lo, const Vec2& hi) const {
    const auto number = [&](double x, int axis, int count) {
        return int(std::clamp(std::floor((x - field_.box().lo[axis]) / tile_), -1.0, double(count)));
    };
    return {std::max(number(lo.x(), 0, columns_), 0), std::min(number(hi.x(), 0, columns_), columns_ - 1),
            std::max(number(lo.y(), 1, rows_), 0), std::min(number(hi.y(), 1, rows_), rows_ - 1)};
}

void LaterCuts::feed(const Vec3& from, const Vec3& to) {
    if (near_.empty()) {
        field_.cut(cutter_, from, to);
        return;
    }
    const Vec2 a = from.head<2>(), b = to.head<2>(), beside = Vec2::Constant(cutter_.radius());
    const Tiles all = tiles(a.cwiseMin(b) - beside, a.cwiseMax(b) + beside);
    const auto number = std::uint32_t(fed_.size());
    fed_.push_back({from, to});
    cut_.push_back(0);
    for (int row = all.row0; row <= all.row1; ++row)
        for (int column = all.column0; column <= all.column1; ++column)
            near_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)].push_back(number);
}

/// The cuts of tiles that nobody has asked for yet.
void LaterCuts::take(const Tiles& all, std::vector<std::uint32_t>& cuts) {
    for (int row = all.row0; row <= all.row1; ++row)
        for (int column = all.column0; column <= all.column1; ++column) {
            auto& tile = near_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
            cuts.insert(cuts.end(), tile.begin(), tile.end());
            tile.clear();
        }
}

const StockField& LaterCuts::about(const Vec2& a, const Vec2& b, double radius) {
    if (near_.empty()) return field_;
    const Vec2 beside = Vec2::Constant(radius + field_.cell());
    std::vector<std::uint32_t> now;
    // In pieces: the box round a long line may be most of the part.
    const double n = std::max(1.0, std::ceil((b - a).norm() / tile_));
    for (double i = 0; i < n; ++i) {
        const Vec2 p = a + i / n * (b - a), q = a + (i + 1) / n * (b - a);
        take(tiles(p.cwiseMin(q) - beside, p.cwiseMax(q) + beside), now);
    }
    std::sort(now.begin(), now.end());
    std::vector<StockField::Motion> cuts;
    for (const std::uint32_t i : now)
        if (!std::exchange(cut_[i], char(1))) cuts.push_back(fed_[i]);
    field_.cut(cutter_, cuts, progress_);
    return field_;
}

} // namespace facetmill
