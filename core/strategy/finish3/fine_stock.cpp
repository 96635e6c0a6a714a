#include "core/strategy/finish3/fine_stock.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Places are filed by tiles that are so wide, in radii of the operation's cutter.
constexpr double tile_radii = 2;
/// The golden ratio less 1: whole multiples of it are spread evenly over a unit.
constexpr double golden = 0.6180339887498949;
/// Points over a cell, at most: the cells of a large stock are many times as wide as points of a small cutter
/// are apart.
constexpr double max_points = 1024;

} // namespace

FineStock::FineStock(const PlanContext& context, const StockField& field, const StockCutter& cutter,
                     double spacing, double skin, double from)
    : field_(field), part_(context.contact, CutterProfile(AptCutter::flat(2 * skin, unlimited_height))),
      skin_(skin), from_(from), half_diagonal_(std::sqrt(0.5) * field.cell()),
      tile_(tile_radii * cutter.radius()) {
    // No two of a cell are on one line in x or in y: walls mostly run along these, with thin skins.
    const double n = std::clamp(std::ceil(field.cell() / spacing * field.cell() / spacing), 1.0, max_points);
    for (double k = 0; k < n; ++k)
        spread_.push_back(field.cell() * Vec2((k + 0.5) / n - 0.5, std::fmod((k + 0.5) * golden, 1.0) - 0.5));
    index_.assign(std::size_t(field.columns()) * std::size_t(field.rows()), -1);
    tile_columns_ = int(double(field.columns()) * field.cell() / tile_) + 1;
    tile_rows_ = int(double(field.rows()) * field.cell() / tile_) + 1;
    near_.resize(std::size_t(tile_columns_) * std::size_t(tile_rows_));
    for (const auto& earlier : context.earlier) {
        cutters_.emplace_back(CutterProfile(earlier->cutter));
        for (const auto& [a, b] : earlier->motions)
            add_cut({a, b, std::uint32_t(cutters_.size() - 1)});
    }
    cutters_.push_back(cutter);
}

void FineStock::cut(const Vec3& a, const Vec3& b) {
    add_cut({a, b, std::uint32_t(cutters_.size() - 1)});
}

void FineStock::add_cut(const Cut& cut) {
    const StockCutter& cutter = cutters_[cut.cutter];
    if (std::max(cut.a.z(), cut.b.z()) + cutter.height() <= from_) return;
    const auto number = std::uint32_t(cuts_.size());
    cuts_.push_back(cut);
    const double reach = cutter.radius() + half_diagonal_;
    const Vec2 lo = field_.box().lo.head<2>(), a = cut.a.head<2>(), motion = cut.b.head<2>() - a;
    // The box of a long motion holds much that it does not come near.
    const double pieces = std::max(1.0, std::ceil(motion.norm() / tile_));
    for (double k = 0; k < pieces; ++k) {
        const Vec2 p = a + k / pieces * motion, q = a + (k + 1) / pieces * motion;
        const auto range = [&](int axis, int n) {
            const double from = (std::min(p[axis], q[axis]) - reach - lo[axis]) / tile_,
                         to = (std::max(p[axis], q[axis]) + reach - lo[axis]) / tile_;
            return std::pair(int(std::clamp(std::floor(from), 0.0, double(n))),
                             int(std::clamp(std::floor(to), -1.0, double(n - 1))));
        };
        const auto [column0, column1] = range(0, tile_columns_);
        const auto [row0, row1] = range(1, tile_rows_);
        for (int row = row0; row <= row1; ++row)
            for (int column = column0; column <= column1; ++column) {
                auto& tile = near_[std::size_t(row) * std::size_t(tile_columns_) + std::size_t(column)];
                if (tile.empty() || tile.back() != number) tile.push_back(number);
            }
    }
}

std::size_t FineStock::tile_of(const Vec2& p) const {
    const Vec2 at = (p - field_.box().lo.head<2>()) / tile_;
    const auto column = std::size_t(std::clamp(int(at.x()), 0, tile_columns_ - 1)),
               row = std::size_t(std::clamp(int(at.y()), 0, tile_rows_ - 1));
    return row * std::size_t(tile_columns_) + column;
}

Vec2 FineStock::center(std::size_t cell) const {
    const auto columns = std::size_t(field_.columns());
    return field_.center(int(cell % columns), int(cell / columns));
}

FineStock::Points& FineStock::points(std::size_t cell) {
    const Vec2 middle = center(cell);
    std::int32_t& number = index_[cell];
    if (number < 0) {
        number = std::int32_t(points_.size());
        Points& made = points_.emplace_back();
        // What the field tells is nowhere too low.
        const auto columns = std::size_t(field_.columns());
        made.highest = float(field_.top(int(cell % columns), int(cell / columns)));
        made.heights.assign(spread_.size(), made.highest);
        for (std::size_t k = 0; k < made.heights.size(); ++k) {
            const Vec2 p = middle + spread_[k], hi = field_.box().hi.head<2>();
            if (p.x() > hi.x() || p.y() > hi.y()) made.heights[k] = -std::numeric_limits<float>::infinity();
        }
    }
    Points& result = points_[std::size_t(number)];
    const auto& cuts = near_[tile_of(middle)];
    if (result.cuts == cuts.size()) return result;
    for (; result.cuts < cuts.size(); ++result.cuts)
        cut_from(result, middle, cuts_[cuts[result.cuts]]);
    result.highest = *std::max_element(result.heights.begin(), result.heights.end());
    return result;
}

void FineStock::cut_from(Points& points, const Vec2& center, const Cut& cut) const {
    const StockCutter& cutter = cutters_[cut.cutter];
    const Vec3& low = cut.a.z() < cut.b.z() ? cut.a : cut.b;
    if (low.z() >= double(points.highest)) return;
    const Vec2 a = cut.a.head<2>(), motion = cut.b.head<2>() - a;
    const double square = motion.squaredNorm(), radius = cutter.radius();
    const auto share = [&](const Vec2& p) {
        return square > 0 ? std::clamp((p - a).dot(motion) / square, 0.0, 1.0) : 0.0;
    };
    const double away = (center - a - share(center) * motion).norm();
    if (away > radius + half_diagonal_) return;
    if (low.z() + cutter.below(std::max(0.0, away - half_diagonal_)) >= double(points.highest)) return;
    const auto lower_to = [&](float& height, double z, double d) {
        if (d > radius || double(height) <= z || double(height) > z + cutter.covered(d)) return;
        height = std::min(height, float(z + cutter.above(d)));
    };
    for (std::size_t k = 0; k < points.heights.size(); ++k) {
        float& height = points.heights[k];
        if (double(height) <= low.z()) continue;
        const Vec2 p = center + spread_[k];
        // Any place of the motion gives a height that is not too low: the nearest, and the lower end.
        const double t = share(p);
        lower_to(height, cut.a.z() + t * (cut.b.z() - cut.a.z()), (p - a - t * motion).norm());
        if (cut.a.z() != cut.b.z()) lower_to(height, low.z(), (p - low.head<2>()).norm());
    }
}

double FineStock::over(std::size_t cell, const Vec2& p, double radius, double base) {
    Points& all = points(cell);
    if (double(all.highest) <= base) return 0;
    const Vec2 middle = center(cell);
    double over = 0;
    for (std::size_t k = 0; k < all.heights.size(); ++k) {
        float& height = all.heights[k];
        if (double(height) - base <= over) continue;
        const Vec2 at = middle + spread_[k];
        if ((at - p).squaredNorm() >= radius * radius) continue;
        if (double(height) <= part_.tip_z(at.x(), at.y()) + skin_)
            height = -std::numeric_limits<float>::infinity(); // it is the part, and only gets lower
        else
            over = double(height) - base;
    }
    return over;
}

} // namespace facetmill
