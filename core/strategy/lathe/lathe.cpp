#include "core/strategy/lathe/lathe.h"

#include "core/base/tolerances.h"

#include <cmath>
#include <limits>

namespace facetmill {

namespace {

/// How far the line through `point` along `d` passes beside the box; 0 where it meets it.
double beside(const Box3& box, const Vec3& point, const Vec3& d) {
    double lo = -infinity, hi = infinity;
    for (int k = 0; k < 3; ++k) {
        if (std::abs(d[k]) <= tolerance::level_angle) {
            if (point[k] < box.lo[k] || point[k] > box.hi[k]) lo = infinity;
            continue;
        }
        const double a = (box.lo[k] - point[k]) / d[k], b = (box.hi[k] - point[k]) / d[k];
        lo = std::max(lo, std::min(a, b));
        hi = std::min(hi, std::max(a, b));
    }
    if (lo <= hi) return 0;
    // Roughly, for the message: from the box's middle to the line, less what the box reaches that way.
    const Vec3 to_middle = box.center() - point;
    const Vec3 out = to_middle - to_middle.dot(d) * d;
    const double length = out.norm();
    return std::max(length
                        - 0.5 * box.size().cwiseProduct(out.cwiseAbs()).sum()
                              / std::max(length, std::numeric_limits<double>::min()),
                    tolerance::smallest_extent);
}

} // namespace

LatheFrame::LatheFrame(const LatheCommon& s, const PlanContext& context)
    : offset_(s.offset), tilt_(s.tilt), cos_tilt_(std::cos(s.tilt)), sin_tilt_(std::sin(s.tilt)) {
    const auto vec = [](const std::array<double, 3>& v) { return Vec3(v[0], v[1], v[2]); };
    if (s.axis == LatheCommon::Axis::points) {
        const Vec3 between = vec(s.axis_to) - vec(s.axis_from);
        if (!(between.norm() > tolerance::smallest_extent))
            throw Error(ErrorCode::out_of_range, "axis_to", "the two points of the turning axis are the same",
                        "give two points of the axis");
        axis_ = {vec(s.axis_from), between.normalized()};
    } else {
        axis_.direction = Vec3::Unit(int(s.axis));
        if (s.axis_through == LatheCommon::Through::middle) {
            // Lengths still count from the part's origin.
            axis_.point = context.part_box.center();
            axis_.point[int(s.axis)] = 0;
        }
    }
    const double miss = beside(context.part_box, axis_.point, axis_.direction);
    if (miss > 0)
        throw Error(ErrorCode::out_of_range, "axis",
                    "the turning axis passes " + length_text(miss, context.unit) + " beside the part",
                    "move the part onto the axis, let the axis go through the part's middle, or give two "
                    "points of it");
    // The tool comes from +Z at angle 0 where that is possible, as on machines whose rotary axis lies level.
    Vec3 from = std::abs(axis_.direction.z()) > std::cos(radians(1)) ? Vec3::UnitX() : Vec3::UnitZ();
    from -= from.dot(axis_.direction) * axis_.direction;
    zero_ = from.normalized();
    side_ = axis_.direction.cross(zero_);
}

Vec3 LatheFrame::radial(double angle) const {
    return std::cos(angle) * zero_ + std::sin(angle) * side_;
}

Vec3 LatheFrame::tool_axis(double angle) const {
    if (tilt_ == 0) return radial(angle).normalized();
    return (cos_tilt_ * radial(angle) + sin_tilt_ * axis_.direction).normalized();
}

CutterLocation LatheFrame::at(const LathePlace& place, double u) const {
    const Vec3 r = radial(place.angle);
    Vec3 foot = axis_.point + place.y * axis_.direction;
    if (offset_ != 0) foot += offset_ * axis_.direction.cross(r);
    const Vec3 a = tool_axis(place.angle);
    return {foot + u * a, a};
}

LathePlace LatheFrame::place(const CutterLocation& at) const {
    const Vec3 r = at.axis - at.axis.dot(axis_.direction) * axis_.direction;
    const double angle = std::atan2(side_.dot(r), zero_.dot(r));
    return {angle, along(at.tip) - height(at.tip, angle) * sin_tilt_};
}

double LatheFrame::height(const Vec3& tip, double angle) const {
    return (tip - axis_.point).dot(radial(angle)) / cos_tilt_;
}

double LatheFrame::away(const Vec3& p) const {
    const Vec3 v = p - axis_.point;
    return (v - v.dot(axis_.direction) * axis_.direction).norm();
}

} // namespace facetmill
