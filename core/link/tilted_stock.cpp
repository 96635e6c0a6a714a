#include "core/link/tilted_stock.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

TiltedStock::TiltedStock(StockField field, const Tool& tool, double cutter_radius, double gap)
    : field_(std::move(field)), bottom_(field_.box().lo.z()), highest_(field_.highest()), gap_(gap) {
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
    whole_ = above_flutes_;
    whole_.push_back({std::max(cutter_radius, 0.5 * tool.diameter), 0});
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
    const double across = std::sqrt(2.0) * field_.cell();
    return lift(at, above_flutes_, -across, across) > across;
}

/// The largest over all columns and bodies; any above `enough` where there is one.
double TiltedStock::lift(const CutterLocation& at, const std::vector<Body>& bodies, double gap,
                         double enough) const {
    const double cell = field_.cell(), half = std::sqrt(0.5) * cell;
    double widest = 0;
    for (const Body& b : bodies)
        widest = std::max(widest, b.radius);
    const double reach = widest + gap + half;
    const Vec3& a = at.axis;
    const double level = std::hypot(a.x(), a.y()), square = level * level;
    // Above the highest top no body meets anything: so far along the axis, in the plan.
    const double far =
        (std::max(0.0, highest_ - at.tip.z()) + reach) / std::max(a.z(), tolerance::level_angle);
    const Vec2 from(at.tip.x(), at.tip.y()), to = from + far * Vec2(a.x(), a.y());
    const Vec3& low = field_.box().lo;
    const auto index = [&](double x, double origin, int count) {
        return int(std::clamp(std::floor((x - origin) / cell), -1.0, double(count)));
    };
    const int row_begin = std::max(0, index(std::min(from.y(), to.y()) - reach, low.y(), field_.rows())),
              row_end = std::min(field_.rows() - 1,
                                 index(std::max(from.y(), to.y()) + reach, low.y(), field_.rows()));
    double largest = -infinity;
    for (int row = row_begin; row <= row_end; ++row) {
        double left = std::min(from.x(), to.x()) - reach, right = std::max(from.x(), to.x()) + reach;
        const double dy = field_.center(0, row).y() - from.y();
        if (std::abs(a.y()) > tolerance::level_angle) {
            // The strip about the axis.
            const double middle = from.x() + dy * a.x() / a.y(), wide = reach * level / std::abs(a.y());
            left = std::max(left, middle - wide);
            right = std::min(right, middle + wide);
        }
        const int begin = std::max(0, index(left, low.x(), field_.columns())),
                  end = std::min(field_.columns() - 1, index(right, low.x(), field_.columns()));
        for (int column = begin; column <= end; ++column) {
            const double top = field_.top(column, row);
            if (!(top > bottom_)) continue;
            // A point of the column at height z: w + z e_z from the tip.
            const Vec2 center = field_.center(column, row);
            const Vec3 w(center.x() - from.x(), center.y() - from.y(), -at.tip.z());
            const double along = w.dot(a), cross = w.z() - a.z() * along,
                         away = w.squaredNorm() - along * along;
            for (const Body& b : bodies) {
                const double radius = b.radius + gap + half;
                if (!(radius > 0)) continue;
                double z = top;
                if (square > tolerance::level_angle) {
                    const double root = cross * cross - square * (away - radius * radius);
                    if (root < 0) continue;
                    const double side = std::sqrt(root);
                    if ((-cross - side) / square > top || (-cross + side) / square < bottom_) continue;
                    z = std::min(top, (-cross + side) / square);
                } else if (away + 2 * z * cross + z * z * square > radius * radius) {
                    continue;
                }
                largest = std::max(largest, along + z * a.z() + half * level - b.height);
                if (largest > enough) return largest;
            }
        }
    }
    return largest;
}

} // namespace facetmill
