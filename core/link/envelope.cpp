#include "core/link/envelope.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// By how much the axis, and the place on the sphere, turn in one rapid at most.
const double rapid_turn = radians(5);

/// How far below the tip's level a tilted tool reaches: its lower rims, cutter, shank and holder.
double reach_below(const Tool& tool, double cutter_radius, double axis_z) {
    const double tilt = std::sqrt(std::max(0.0, 1 - axis_z * axis_z));
    double below = std::max(cutter_radius, 0.5 * tool.diameter) * tilt;
    double height = tool.flute_length;
    const auto body = [&](double diameter, double length) {
        below = std::max(below, 0.5 * diameter * tilt - height * axis_z);
        height += length;
    };
    body(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& section : tool.holder)
        body(section.diameter, section.length);
    return below;
}

double widest(const Tool& tool, double cutter_radius) {
    double radius = std::max({cutter_radius, 0.5 * tool.diameter, 0.5 * tool.shank_diameter});
    for (const HolderSection& section : tool.holder)
        radius = std::max(radius, 0.5 * section.diameter);
    return radius;
}

double angle(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Unit vectors from one to another, evenly; both are of length 1 and not opposite.
Vec3 turned(const Vec3& from, const Vec3& to, double share) {
    const double whole = angle(from, to);
    if (!(whole > tolerance::level_angle)) return to;
    return ((std::sin((1 - share) * whole) * from + std::sin(share * whole) * to) / std::sin(whole))
        .normalized();
}

double length_of(const std::vector<CutterLocation>& route) {
    double length = 0;
    for (std::size_t i = 1; i < route.size(); ++i)
        length += (route[i].tip - route[i - 1].tip).norm();
    return length;
}

void append(std::vector<CutterLocation>& route, const CutterLocation& at) {
    if (route.empty() || route.back().tip != at.tip || route.back().axis != at.axis) route.push_back(at);
}

/// Turns the axis on the spot.
void turn_to(std::vector<CutterLocation>& route, const Vec3& axis) {
    const CutterLocation from = route.back();
    const int pieces = int(std::ceil(angle(from.axis, axis) / rapid_turn));
    for (int k = 1; k <= pieces; ++k)
        append(route, {from.tip, k == pieces ? axis : turned(from.axis, axis, double(k) / pieces)});
}

} // namespace

Envelope::Envelope(const EnvelopeInput& in) {
    Box3 box; // round part and stock
    for (const Box3& b : {in.part, in.stock})
        if (!b.empty()) box.add(b);
    center_ = box.center();
    const double wide = widest(*in.tool, in.cutter_radius);
    level_ = std::max(box.hi.z(), in.highest_tip) + reach_below(*in.tool, in.cutter_radius, in.lowest_axis_z)
             + in.clearance;
    // Chords between places of the sphere run within it.
    radius_ = (0.5 * box.size().norm() + wide + in.clearance) / std::cos(0.5 * rapid_turn);
    reachable_ = in.reachable;
}

bool Envelope::reachable(const std::vector<CutterLocation>& route) const {
    return !reachable_ || std::all_of(route.begin(), route.end(), reachable_);
}

CutterLocation Envelope::on_level(const CutterLocation& at) const {
    const double up = (level_ - at.tip.z()) / at.axis.z();
    CutterLocation above{at.tip + up * at.axis, at.axis};
    above.tip.z() = level_; // to the last digit: these rapids are level
    return above;
}

CutterLocation Envelope::on_sphere(const CutterLocation& at) const {
    const Vec3 from = at.tip - center_;
    const double along = from.dot(at.axis);
    const double square = along * along + radius_ * radius_ - from.squaredNorm();
    // From beyond it outward until the axis points away from the middle.
    const double t = std::max(square > 0 ? -along + std::sqrt(square) : -along, 0.0);
    return {at.tip + t * at.axis, at.axis};
}

CutterLocation Envelope::out(const CutterLocation& at) const {
    const CutterLocation level = on_level(at), sphere = on_sphere(at);
    const bool level_first = (level.tip - at.tip).norm() <= (sphere.tip - at.tip).norm();
    const CutterLocation &first = level_first ? level : sphere, &second = level_first ? sphere : level;
    return reachable({first}) || !reachable({second}) ? first : second;
}

std::vector<CutterLocation> Envelope::over(const CutterLocation& from, const CutterLocation& to) const {
    const CutterLocation a = on_level(from), b = on_level(to);
    std::vector<CutterLocation> route{a};
    const int pieces = std::max(1, int(std::ceil(angle(a.axis, b.axis) / rapid_turn)));
    for (int k = 1; k <= pieces; ++k) {
        const double share = double(k) / pieces;
        append(route, k == pieces
                          ? b
                          : CutterLocation{a.tip + share * (b.tip - a.tip), turned(a.axis, b.axis, share)});
    }
    return route;
}

/// Along the sphere by bearing and height, which is never lower than its ends, with the axis outward.
std::vector<CutterLocation> Envelope::round(const CutterLocation& from, const CutterLocation& to) const {
    const CutterLocation a = on_sphere(from), b = on_sphere(to);
    const Vec3 u = a.tip - center_, v = b.tip - center_;
    const double high_u = std::atan2(u.z(), std::hypot(u.x(), u.y())),
                 high_v = std::atan2(v.z(), std::hypot(v.x(), v.y()));
    const double bearing = std::atan2(u.y(), u.x());
    const double turn = std::remainder(std::atan2(v.y(), v.x()) - bearing, 2 * pi);
    const auto outward = [](const Vec3& radial) {
        Vec3 axis = radial.normalized();
        axis.z() = std::max(axis.z(), tolerance::lowest_axis_z);
        return Vec3(axis.normalized());
    };
    std::vector<CutterLocation> route{a};
    turn_to(route, outward(u));
    const int pieces = std::max(1, int(std::ceil(std::hypot(turn, high_v - high_u) / rapid_turn)));
    for (int k = 1; k <= pieces; ++k) {
        const double share = double(k) / pieces;
        const double high = high_u + share * (high_v - high_u), at = bearing + share * turn;
        const double far = std::max(radius_, u.norm() + share * (v.norm() - u.norm()));
        const Vec3 radial(std::cos(high) * std::cos(at), std::cos(high) * std::sin(at), std::sin(high));
        append(route,
               {k == pieces ? b.tip : Vec3(center_ + far * radial), outward(k == pieces ? v : radial)});
    }
    turn_to(route, b.axis);
    return route;
}

std::vector<CutterLocation> Envelope::route(const CutterLocation& from, const CutterLocation& to) const {
    const auto whole = [&](const std::vector<CutterLocation>& route) {
        return (route.front().tip - from.tip).norm() + length_of(route) + (route.back().tip - to.tip).norm();
    };
    std::vector<CutterLocation> level = over(from, to), sphere = round(from, to);
    if (whole(sphere) < whole(level)) std::swap(level, sphere);
    return reachable(level) || !reachable(sphere) ? level : sphere;
}

} // namespace facetmill
