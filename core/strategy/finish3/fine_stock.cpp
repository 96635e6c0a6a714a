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
/// Points on a body's rim lie so much closer than those of cells: cusps of the passes on a wall that are a
/// few thousandths deep in a shank are no wider than one or two of these.
constexpr double rim_share = 0.5;
/// So deep in a body, in radii of the operation's cutter, what stands touches it: more than a hole of its own
/// cutter differs from it between two places that are asked.
constexpr double rim_depth = 1e-4;

} // namespace

FineStock::FineStock(const PlanContext& context, const StockField& field, const StockCutter& cutter,
                     double spacing, double skin, double from, const Box3& within)
    : field_(field), part_(context.contact, CutterProfile(AptCutter::flat(2 * skin, unlimited_height))),
      skin_(skin), from_(from), half_diagonal_(std::sqrt(0.5) * field.cell()),
      tile_(tile_radii * cutter.radius()), rim_spacing_(rim_share * spacing),
      rim_depth_(rim_depth * cutter.radius()) {
    // No two of a cell are on one line in x or in y: walls mostly run along these, with thin skins.
    const double n = std::clamp(std::ceil(field.cell() / spacing * field.cell() / spacing), 1.0, max_points);
    for (double k = 0; k < n; ++k)
        spread_.push_back(field.cell() * Vec2((k + 0.5) / n - 0.5, std::fmod((k + 0.5) * golden, 1.0) - 0.5));
    index_.assign(std::size_t(field.columns()) * std::size_t(field.rows()), -1);
    tile_columns_ = int(double(field.columns()) * field.cell() / tile_) + 1;
    tile_rows_ = int(double(field.rows()) * field.cell() / tile_) + 1;
    near_.resize(std::size_t(tile_columns_) * std::size_t(tile_rows_));
    for (const auto& earlier : context.earlier) {
        const StockCutter& made = cutters_.emplace_back(CutterProfile(earlier->cutter));
        const Vec3 reach = Vec3::Constant(made.radius() + field.cell());
        for (const auto& [a, b] : earlier->motions)
            if (((a.cwiseMin(b) - reach).array() <= within.hi.array()).head<2>().all()
                && ((a.cwiseMax(b) + reach).array() >= within.lo.array()).head<2>().all())
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
        made.top = made.highest = float(field_.top(int(cell % columns), int(cell / columns)));
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
        cut_from(result, middle, cuts[result.cuts]);
    result.highest = *std::max_element(result.heights.begin(), result.heights.end());
    return result;
}

namespace {

/// Any place of a motion gives a height over p that is not too low: the nearest, and the lower end.
/// `lower(z, d)`: a tip at height z comes so near.
template <class Lower>
void over_motion(const Vec3& a, const Vec3& b, const Vec2& p, Lower&& lower) {
    const Vec2 motion = (b - a).head<2>(), from = p - a.head<2>();
    const double square = motion.squaredNorm();
    const double t = square > 0 ? std::clamp(from.dot(motion) / square, 0.0, 1.0) : 0.0;
    lower(a.z() + t * (b.z() - a.z()), (from - t * motion).norm());
    if (a.z() == b.z()) return;
    const Vec3& low = a.z() < b.z() ? a : b;
    lower(low.z(), (p - low.head<2>()).norm());
}

} // namespace

void FineStock::cut_from(Points& points, const Vec2& center, std::uint32_t number) const {
    const Cut& cut = cuts_[number];
    const StockCutter& cutter = cutters_[cut.cutter];
    const double low = std::min(cut.a.z(), cut.b.z());
    if (low >= double(points.top)) return;
    double away = infinity;
    over_motion(cut.a, cut.b, center, [&](double, double d) { away = std::min(away, d); });
    if (away > cutter.radius() + half_diagonal_) return;
    const double lowest = low + cutter.below(std::max(0.0, away - half_diagonal_));
    if (lowest >= double(points.top)) return;
    points.near.push_back(number);
    if (lowest >= double(points.highest)) return;
    for (std::size_t k = 0; k < points.heights.size(); ++k)
        if (double(points.heights[k]) > low)
            points.heights[k] = lowered(points.heights[k], center + spread_[k], cut);
}

float FineStock::lowered(float height, const Vec2& p, const Cut& cut) const {
    const StockCutter& cutter = cutters_[cut.cutter];
    over_motion(cut.a, cut.b, p, [&](double z, double d) {
        if (d > cutter.radius() || double(height) <= z || double(height) > z + cutter.covered(d)) return;
        height = std::min(height, float(z + cutter.above(d)));
    });
    return height;
}

double FineStock::over(std::size_t cell, const Vec2& p, double radius, double base) {
    Points& all = points(cell);
    const Vec2 middle = center(cell);
    double over = 0;
    for (std::size_t k = 0; double(all.highest) > base && k < all.heights.size(); ++k) {
        float& height = all.heights[k];
        if (double(height) - base <= over) continue;
        const Vec2 at = middle + spread_[k];
        if ((at - p).squaredNorm() >= radius * radius) continue;
        if (double(height) <= part_top(at))
            height = -std::numeric_limits<float>::infinity(); // and only gets lower
        else
            over = double(height) - base;
    }
    return over + over_rim(all, cell, p, radius, base + over);
}

/// A cusp that comes into a body from beside it is widest at its rim.
double FineStock::over_rim(Points& points, std::size_t cell, const Vec2& p, double radius, double base) {
    const double rim = radius - rim_depth_;
    const Vec2 middle = center(cell), to = middle - p;
    const double away = to.norm();
    if (std::abs(away - rim) > half_diagonal_ || double(points.top) <= base) return 0;
    const double step = rim_spacing_ / rim;
    const double half = away > half_diagonal_ ? std::asin(half_diagonal_ / away) : pi;
    const double middle_angle = std::atan2(to.y(), to.x());
    const double last = std::floor((middle_angle + half) / step);
    double over = 0;
    for (double k = std::ceil((middle_angle - half) / step); k <= last; ++k) {
        const Vec2 at = p + rim * Vec2(std::cos(k * step), std::sin(k * step));
        if ((at - middle).cwiseAbs().maxCoeff() > 0.5 * field_.cell()) continue;
        const float height = standing(points, at, base + over);
        if (double(height) > base + over) over = double(height) - base;
    }
    return over;
}

/// How high it stands at a place of a cell; or nothing where that is not above `enough`, or the part as high.
float FineStock::standing(Points& points, const Vec2& p, double enough) {
    constexpr float nothing = -std::numeric_limits<float>::infinity();
    const Vec2 hi = field_.box().hi.head<2>();
    if (p.x() > hi.x() || p.y() > hi.y()) return nothing;
    // Mostly what cut one place cut its neighbour, too. Less than all that cut leaves no less.
    const auto left = [&] {
        float height = points.top;
        for (const std::uint32_t number : points.chain)
            height = lowered(height, p, cuts_[number]);
        return height;
    };
    float height = left();
    if (double(height) <= enough) return nothing;
    // Beside a wall it is mostly the part that stands.
    enough = std::max(enough, part_top(p));
    if (double(height) <= enough) return nothing;
    scan(points, p);
    height = left();
    return double(height) > enough ? height : nothing;
}

/// Finds the chain of a place: the cuts without which all that cut there would leave more. Flutes that are
/// shorter than a wall is high take several.
void FineStock::scan(Points& points, const Vec2& p) {
    lowerings_.clear();
    float height = points.top;
    for (const std::uint32_t number : points.near)
        if (const float left = lowered(height, p, cuts_[number]); left < height)
            lowerings_.push_back({number, height = left});
    points.chain.clear();
    for (std::size_t last = lowerings_.size(); last > 0;) {
        const Lowering& lowering = lowerings_[last - 1];
        points.chain.push_back(lowering.cut);
        // The first height from which this one alone leaves as little.
        std::size_t first = 0;
        const auto before = [&] { return first == 0 ? points.top : lowerings_[first - 1].left; };
        while (first + 1 < last && lowered(before(), p, cuts_[lowering.cut]) > lowering.left)
            ++first;
        last = first;
    }
    std::reverse(points.chain.begin(), points.chain.end());
}

} // namespace facetmill
