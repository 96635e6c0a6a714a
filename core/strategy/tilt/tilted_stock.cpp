#include "core/strategy/tilt/tilted_stock.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {
/// The places of a cut at which the flutes take away what stands, in radii of the cutter: between them they
/// leave next to nothing.
constexpr double cut_step_share = 0.3;
} // namespace

TiltedStock::TiltedStock(const StockField& field, const Tool& tool, double cutter_radius, double gap)
    : columns_(field), gap_(gap), step_(cut_step_share * cutter_radius),
      inner_(inner_cylinders(tool, field.cell())) {
    double height = tool.flute_length;
    // What the cutter's end has cut is as wide as the cutter, up to the flutes' end.
    above_flutes_.push_back({cutter_radius, height});
    const auto add = [&](double diameter, double length) {
        if (length > 0) above_flutes_.push_back({0.5 * diameter, height});
        height += length;
    };
    add(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& section : tool.holder)
        add(section.diameter, section.length);
    for (const Body& b : above_flutes_)
        (b.radius > cutter_radius ? wide_ : narrow_).push_back(b);
    whole_ = above_flutes_;
    for (const AxisCylinder& c : outer_cylinders(tool, field.cell()))
        whole_.push_back({c.radius, c.low});
    // Beside the neck of an undercut cutter it has not cut.
    behind_ = is_undercut(CutterProfile(tool.cutter())) ? whole_ : above_flutes_;
}

double TiltedStock::lift(const CutterLocation& at, double clearance) const {
    return lift(at, whole_, gap_, infinity) + clearance;
}

bool TiltedStock::free_behind(const CutterLocation& at) const {
    return !(lift(at, behind_, 0, 0) > 0);
}

bool TiltedStock::holds_shank(const CutterLocation& at) const {
    const double across = std::sqrt(2.0) * columns_.cell();
    return lift(at, above_flutes_, -across, across) > across;
}

bool TiltedStock::may_hold(const CutterLocation& at) const {
    if (lift(at, wide_, gap_, 0) > 0) return true;
    const double across = std::sqrt(2.0) * columns_.cell();
    return lift(at, narrow_, -across, across) > across;
}

namespace {

/// The highest place of the pieces that lies in the interval; -inf where none does.
double highest_within(std::span<const Interval> pieces, const Interval& in) {
    for (std::size_t i = pieces.size(); i-- > 0;) {
        if (pieces[i].lo > in.hi) continue;
        return pieces[i].hi < in.lo ? -infinity : std::min(pieces[i].hi, in.hi);
    }
    return -infinity;
}

} // namespace

void TiltedStock::cut(const CutterLocation& from, const CutterLocation& to) {
    if (inner_.empty()) return;
    const Vec3 top_from = from.tip + inner_.front().high * from.axis,
               top_to = to.tip + inner_.front().high * to.axis;
    const double far = std::max((to.tip - from.tip).norm(), (top_to - top_from).norm());
    const int steps = std::max(1, int(std::ceil(far / step_)));
    for (int i = 1; i <= steps; ++i) {
        const double share = double(i) / steps;
        const CutterLocation at{from.tip + share * (to.tip - from.tip),
                                (from.axis + share * (to.axis - from.axis)).normalized()};
        for (const AxisCylinder& c : inner_)
            columns_.clear(at, c.radius, c.low, c.high);
    }
}

/// The largest over all columns and bodies; any above `enough` where there is one.
double TiltedStock::lift(const CutterLocation& at, const std::vector<Body>& bodies, double gap,
                         double enough) const {
    const double cell = columns_.cell(), half = std::sqrt(0.5) * cell;
    double widest = 0;
    for (const Body& b : bodies)
        widest = std::max(widest, b.radius);
    const double reach = widest + gap + half;
    const Vec3& a = at.axis;
    const double level = std::hypot(a.x(), a.y()), square = level * level;
    // Above the highest top no body meets anything: so far along the axis, in the plan.
    const double far =
        (std::max(0.0, columns_.highest() - at.tip.z()) + reach) / std::max(a.z(), tolerance::level_angle);
    const Vec2 from(at.tip.x(), at.tip.y()), to = from + far * Vec2(a.x(), a.y());
    const StandingColumns::Strip rows = columns_.strip(from, to, reach);
    double largest = -infinity;
    for (int row = rows.row_begin; row <= rows.row_end; ++row) {
        const StandingColumns::Run cells = columns_.run(row, from, to, reach);
        for (int column = cells.begin; column <= cells.end; ++column) {
            const std::span<const Interval> standing = columns_.standing(column, row);
            if (standing.empty()) continue;
            // A point of the column at height z: w + z e_z from the tip.
            const Vec2 center = columns_.center(column, row);
            const Vec3 w(center.x() - from.x(), center.y() - from.y(), -at.tip.z());
            const double along = w.dot(a), cross = w.z() - a.z() * along,
                         away = w.squaredNorm() - along * along;
            for (const Body& b : bodies) {
                const double radius = b.radius + gap + half;
                if (!(radius > 0)) continue;
                Interval meets{-infinity, infinity};
                if (square > tolerance::level_angle) {
                    const double root = cross * cross - square * (away - radius * radius);
                    if (root < 0) continue;
                    const double side = std::sqrt(root);
                    meets = {(-cross - side) / square, (-cross + side) / square};
                } else if (const double z = standing.back().hi;
                           away + 2 * z * cross + z * z * square > radius * radius) {
                    continue;
                }
                const double z = highest_within(standing, meets);
                largest = std::max(largest, along + z * a.z() + half * level - b.height);
                if (largest > enough) return largest;
            }
        }
    }
    return largest;
}

} // namespace facetmill
