#include "core/strategy/tilt/standing_columns.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {
/// The radii of the cylinders that stand for a cutter's end, in its largest one.
constexpr std::array end_shares{1.0, 0.85, 0.6};
/// Pieces of a column that are shorter are not worth having: in cells.
constexpr double shortest_share = 0.05;
} // namespace

StandingColumns::StandingColumns(const StockField& field)
    : box_(field.box()), cell_(field.cell()), highest_(field.highest()), columns_(field.columns()),
      rows_(field.rows()), whole_(std::size_t(columns_) * std::size_t(rows_)), index_(whole_.size(), 0) {
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            const double top = field.top(column, row), bottom = box_.lo.z();
            if (top > bottom) whole_[at(column, row)] = {bottom, top};
        }
}

std::span<const Interval> StandingColumns::standing(int column, int row) const {
    const std::size_t cell = at(column, row);
    if (index_[cell] > 0) return cut_[index_[cell] - 1];
    const Interval& whole = whole_[cell];
    return {&whole, whole.hi > whole.lo ? std::size_t(1) : 0};
}

StandingColumns::Strip StandingColumns::strip(const Vec2& from, const Vec2& to, double reach) const {
    const auto index = [&](double y) {
        return int(std::clamp(std::floor((y - box_.lo.y()) / cell_), -1.0, double(rows_)));
    };
    return {std::max(0, index(std::min(from.y(), to.y()) - reach)),
            std::min(rows_ - 1, index(std::max(from.y(), to.y()) + reach))};
}

StandingColumns::Run StandingColumns::run(int row, const Vec2& from, const Vec2& to, double reach) const {
    const auto index = [&](double x) {
        return int(std::clamp(std::floor((x - box_.lo.x()) / cell_), -1.0, double(columns_)));
    };
    double left = std::min(from.x(), to.x()) - reach, right = std::max(from.x(), to.x()) + reach;
    const Vec2 along = to - from;
    const double dy = center(0, row).y() - from.y(), length = along.norm();
    if (std::abs(along.y()) > tolerance::level_angle * length) {
        const double middle = from.x() + dy * along.x() / along.y(),
                     wide = reach * length / std::abs(along.y());
        left = std::max(left, middle - wide);
        right = std::min(right, middle + wide);
    }
    return {std::max(0, index(left)), std::min(columns_ - 1, index(right))};
}

void StandingColumns::clear(const CutterLocation& place, double radius, double low, double high) {
    const double half = std::sqrt(0.5) * cell_, level = std::hypot(place.axis.x(), place.axis.y());
    // Points of a cell lie so much farther from the axis, and along it, than those over its centre.
    const double inner = radius - half, begin = low + half * level, end = high - half * level;
    if (!(inner > 0 && end > begin)) return;
    const Vec3 &a = place.axis, &tip = place.tip;
    const Vec2 from = (tip + begin * a).head<2>(), to = (tip + end * a).head<2>();
    const Strip rows = strip(from, to, radius);
    const double square = level * level;
    for (int row = rows.row_begin; row <= rows.row_end; ++row) {
        const Run cells = run(row, from, to, radius);
        for (int column = cells.begin; column <= cells.end; ++column) {
            const Vec2 middle = center(column, row);
            const Vec3 w(middle.x() - tip.x(), middle.y() - tip.y(), -tip.z());
            const double along = w.dot(a), cross = w.z() - a.z() * along,
                         away = w.squaredNorm() - along * along;
            Interval inside{(begin - along) / a.z(), (end - along) / a.z()};
            if (square > tolerance::level_angle) {
                const double root = cross * cross - square * (away - inner * inner);
                if (root <= 0) continue;
                inside.lo = std::max(inside.lo, (-cross - std::sqrt(root)) / square);
                inside.hi = std::min(inside.hi, (-cross + std::sqrt(root)) / square);
            } else {
                // So upright that it is the same over all of the column's height, but for nothing.
                const double z = 0.5 * (inside.lo + inside.hi);
                if (away + 2 * z * cross + z * z * square > inner * inner) continue;
            }
            if (inside.hi > inside.lo) take(at(column, row), inside);
        }
    }
}

void StandingColumns::take(std::size_t cell, const Interval& away) {
    const Interval& whole = whole_[cell];
    if (!(whole.hi > whole.lo) || away.hi <= whole.lo || away.lo >= whole.hi) return;
    if (index_[cell] == 0) {
        cut_.push_back({whole});
        index_[cell] = std::uint32_t(cut_.size());
    }
    std::vector<Interval>& pieces = cut_[index_[cell] - 1];
    const double shortest = shortest_share * cell_;
    for (std::size_t i = 0; i < pieces.size();) {
        Interval& piece = pieces[i];
        if (away.hi <= piece.lo || away.lo >= piece.hi) {
            ++i;
            continue;
        }
        const Interval below{piece.lo, away.lo}, above{away.hi, piece.hi};
        // What would be cut in two by next to nothing stays whole.
        if (below.length() > 0 && above.length() > 0) {
            if (away.length() > shortest) {
                piece = below;
                pieces.insert(pieces.begin() + std::ptrdiff_t(i) + 1, above);
            }
            return;
        }
        if (below.length() > 0)
            piece = below;
        else if (above.length() > 0)
            piece = above;
        else {
            pieces.erase(pieces.begin() + std::ptrdiff_t(i));
            continue;
        }
        ++i;
    }
}

std::vector<AxisCylinder> inner_cylinders(const Tool& tool, double coarseness) {
    const CutterProfile profile(tool.cutter());
    std::vector<AxisCylinder> found;
    if (is_undercut(profile)) return found;
    for (const double share : end_shares) {
        const double radius = share * profile.max_radius(),
                     low = profile.height_at(radius * (1 - tolerance::same_shape));
        if (low < tool.flute_length && (found.empty() || found.back().low - low >= coarseness))
            found.push_back({radius, low, tool.flute_length});
    }
    return found;
}

std::vector<AxisCylinder> outer_cylinders(const Tool& tool, double coarseness) {
    const CutterProfile profile(tool.cutter());
    // The lower surface rises outwards: beyond a radius nothing is lower than it is there.
    std::vector<AxisCylinder> found;
    double radius = std::max(profile.max_radius(), 0.5 * tool.diameter);
    for (std::size_t i = 1; i < end_shares.size(); ++i) {
        const double inner = end_shares[i] * profile.max_radius(), low = profile.height_at(inner);
        if (low < coarseness) break;
        found.push_back({radius, low, infinity});
        radius = inner;
    }
    found.push_back({radius, 0, infinity});
    return found;
}

} // namespace facetmill
