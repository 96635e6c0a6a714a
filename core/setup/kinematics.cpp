#include "core/setup/kinematics.h"

#include "core/base/error.h"
#include "core/base/plane_geometry.h"
#include "core/base/tolerances.h"
#include "core/setup/tool.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr double full_turn = 2 * pi;

Vec3 turned(const Vec3& v, const Vec3& line, double cosine, double sine) {
    // The part along the line stays as it is, to the last bit.
    const Vec3 along = line * line.dot(v), across = v - along;
    return along + cosine * across + sine * line.cross(across);
}
Vec3 turned(const Vec3& v, const Vec3& line, double angle) {
    return turned(v, line, std::cos(angle), std::sin(angle));
}

/// Angle about `line` from `a` to `b`.
double azimuth(const Vec3& line, const Vec3& a, const Vec3& b) {
    const Vec3 pa = a - line * line.dot(a), pb = b - line * line.dot(b);
    return std::atan2(line.dot(pa.cross(pb)), pa.dot(pb));
}

/// In (-pi, pi].
double wrapped(double angle) {
    if (angle > -pi && angle <= pi) return angle;
    const double w = std::remainder(angle, full_turn);
    return w <= -pi ? pi : w;
}

/// How far outside its travel a joint stands, beyond what rounding may do.
double outside(const Travel& travel, double value, double slack) {
    return travel.contains(value, slack) ? 0 : std::max(travel.lo - value, value - travel.hi);
}

} // namespace

Vec3 default_part_origin(const Machine& machine, const Box3& part_box) {
    if (part_box.empty())
        throw Error(ErrorCode::out_of_range, "machine", "the part to place has no size", "give a part");
    const Vec3 middle = part_box.center();
    return machine.table - Vec3(middle.x(), middle.y(), part_box.lo.z());
}

int turning_table(const Machine& machine, const Vec3& direction) {
    // Of tables on tables only the one at the bed keeps its direction whatever the other does.
    for (std::size_t i = 0; i < machine.rotary.size(); ++i)
        if (const RotaryAxis& r = machine.rotary[i];
            r.carries == RotaryAxis::Carries::table
            && r.direction.cross(direction).norm() <= tolerance::level_angle)
            return int(i);
    return -1;
}

Vec3 turning_part_origin(const Machine& machine, int table, const Vec3& point, const Box3& part_box) {
    const RotaryAxis& r = machine.rotary.at(std::size_t(table));
    const Vec3 origin = default_part_origin(machine, part_box);
    const Vec3 off = r.point - (point + origin);
    return origin + off - off.dot(r.direction) * r.direction;
}

double gauge_length(const Tool& tool) {
    double length = tool.flute_length + tool.shank_length;
    for (const HolderSection& s : tool.holder)
        length += s.length;
    return length;
}

Kinematics::Kinematics(const Machine& machine, double tool_length, const Vec3& part_origin)
    : machine_(machine), tool_length_(tool_length), part_origin_(part_origin) {
    if (!std::isfinite(tool_length) || tool_length < 0)
        throw Error(ErrorCode::out_of_range, "machine", "the length of the tool is negative or no number",
                    "give the length from tip to spindle nose");
    if (!part_origin.allFinite())
        throw Error(ErrorCode::out_of_range, "machine", "the place of the part is no number",
                    "check the part");
    std::size_t n = 0;
    const auto& rotary = machine_.rotary;
    for (std::size_t i = rotary.size(); i-- > 0;)
        if (rotary[i].carries == RotaryAxis::Carries::table)
            turns_[n++] = {rotary[i].direction, -rotary[i].sign, i};
    for (std::size_t i = 0; i < rotary.size(); ++i)
        if (rotary[i].carries == RotaryAxis::Carries::tool)
            turns_[n++] = {rotary[i].direction, rotary[i].sign, i};
    const Vec3 z = Vec3::UnitZ();
    if (n == 1) tool_angle_ = angle_between(turns_[0].line, z);
    if (n == 2) {
        const Vec3 &a = turns_[0].line, &b = turns_[1].line;
        line_angle_ = angle_between(a, b);
        tool_angle_ = angle_between(b, z);
        right_zero_ = std::atan2(b.cross(z).dot(a), z.dot(a) - z.dot(b) * a.dot(b));
    }
}

/// From the part's frame, turned by the tables, to the machine's.
Vec3 Kinematics::to_bed(Vec3 point, const Joints& joints) const {
    for (std::size_t i = machine_.rotary.size(); i-- > 0;)
        if (const RotaryAxis& r = machine_.rotary[i]; r.carries == RotaryAxis::Carries::table)
            point = r.point + turned(point - r.point, r.direction, r.sign * joints.rotary[i]);
    return point;
}

/// Where X, Y, Z stand so that the tip is at `tip` of the part with these rotary angles.
Vec3 Kinematics::linear_for(const Vec3& tip, const Joints& joints) const {
    Vec3 below(0, 0, -tool_length_);
    for (std::size_t i = machine_.rotary.size(); i-- > 0;)
        if (const RotaryAxis& r = machine_.rotary[i]; r.carries == RotaryAxis::Carries::tool)
            below = r.point + turned(below - r.point, r.direction, r.sign * joints.rotary[i]);
    return to_bed(tip + part_origin_, joints) - below;
}

ToolPose Kinematics::forward(const Joints& joints) const {
    ToolPose pose{Vec3(0, 0, -tool_length_), Vec3::UnitZ()};
    const auto& rotary = machine_.rotary;
    const auto turn = [&](const RotaryAxis& r, double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        pose.tip = r.point + turned(pose.tip - r.point, r.direction, c, s);
        pose.axis = turned(pose.axis, r.direction, c, s);
    };
    for (std::size_t i = rotary.size(); i-- > 0;)
        if (const RotaryAxis& r = rotary[i]; r.carries == RotaryAxis::Carries::tool)
            turn(r, r.sign * joints.rotary[i]);
    pose.tip += joints.linear;
    for (std::size_t i = 0; i < rotary.size(); ++i)
        if (const RotaryAxis& r = rotary[i]; r.carries == RotaryAxis::Carries::table)
            turn(r, -r.sign * joints.rotary[i]);
    pose.tip -= part_origin_;
    pose.axis.normalize();
    return pose;
}

Kinematics::Solutions Kinematics::inverse(const ToolPose& pose, const Joints& near) const {
    const Vec3 &v = pose.axis, z = Vec3::UnitZ();
    if (!pose.tip.allFinite() || !(std::abs(v.norm() - 1) <= tolerance::unit_axis))
        throw Error(ErrorCode::internal, "kinematics",
                    "a tool pose is not finite or its axis is no unit vector", "report this");
    Solutions found;
    const auto add = [&](double left, double right) {
        Joints& j = found.at[std::size_t(found.count++)];
        const double angles[] = {left, right};
        for (std::size_t i = 0; i < machine_.rotary.size(); ++i)
            j.rotary[turns_[i].axis] = wrapped(turns_[i].sign * angles[i]);
        j.linear = linear_for(pose.tip, j);
    };
    if (machine_.rotary.empty()) {
        if (angle_between(v, z) <= tolerance::level_angle) add(0, 0);
        return found;
    }
    const Turn &left = turns_[0], &right = turns_[1];
    double height = angle_between(v, left.line);
    if (machine_.rotary.size() == 1) {
        if (std::abs(height - tool_angle_) <= tolerance::level_angle) add(azimuth(left.line, z, v), 0);
        return found;
    }
    found.singular = std::min(height, pi - height) < tolerance::level_angle;
    if (found.singular) height = height < 1 ? 0 : pi;
    // The lines and the axis, turned by right alone, are the corners of a triangle on the sphere with these
    // sides; its angle at right's line is how far right turns from where the tool is nearest to left's. Half
    // the perimeter less each side, and pi less the half, are positive in a triangle that exists; as factors
    // they keep small ones exact.
    const double half = 0.5 * (height + line_angle_ + tool_angle_);
    const double less[] = {half - height, half - line_angle_, half - tool_angle_, pi - half};
    double product = 4;
    for (const double l : less) {
        if (2 * l < -tolerance::level_angle) return found;
        product *= std::sin(std::max(l, 0.0));
    }
    const double sine = std::sqrt(std::max(product, 0.0));
    const double swing = std::atan2(sine, std::cos(height) - std::cos(line_angle_) * std::cos(tool_angle_));
    const auto solve = [&](double beta) {
        const double alpha = found.singular ? left.sign * near.rotary[left.axis]
                                            : azimuth(left.line, turned(z, right.line, beta), v);
        add(alpha, beta);
    };
    solve(right_zero_ + swing);
    if (sine > 0) solve(right_zero_ - swing);
    if (found.singular) found.count = std::min(found.count, 1);
    return found;
}

/// The solution with its rotary angles wound near to `from`; nothing, and why, when that is outside travel.
std::optional<Joints> Kinematics::wound(Joints solution, bool singular, const Vec3& tip, const Joints& from,
                                        Reach* reach) const {
    for (std::size_t i = 0; i < machine_.rotary.size(); ++i) {
        const Travel& t = machine_.rotary[i].travel;
        double& angle = solution.rotary[i];
        if (singular && i == turns_[0].axis) {
            angle = std::clamp(from.rotary[i], t.lo, t.hi);
            continue;
        }
        const double wanted = std::round((from.rotary[i] - angle) / full_turn);
        const double least = std::ceil((t.lo - tolerance::level_angle - angle) / full_turn);
        const double most = std::floor((t.hi + tolerance::level_angle - angle) / full_turn);
        if (least > most) {
            // Between two turns: the nearer end of the travel is missed by this.
            *reach = {Reach::Limit::rotary_travel, int(i) + 3,
                      std::min(angle + full_turn * least - t.hi, t.lo - (angle + full_turn * most))};
            return std::nullopt;
        }
        angle += full_turn * std::clamp(wanted, least, most);
    }
    if (singular) solution.linear = linear_for(tip, solution);
    *reach = {};
    for (int k = 0; k < 3; ++k) {
        const double beyond =
            outside(machine_.travel[std::size_t(k)], solution.linear[k], tolerance::smallest_chord);
        if (beyond > reach->beyond) *reach = {Reach::Limit::linear_travel, k, beyond};
    }
    if (reach->limit != Reach::Limit::none) return std::nullopt;
    return solution;
}

Kinematics::Solutions Kinematics::within_travel(const ToolPose& pose, const Joints& from) const {
    const Solutions all = inverse(pose, from);
    Solutions held;
    held.singular = all.singular;
    for (std::size_t i = 0; i < std::size_t(all.count); ++i) {
        Reach reach;
        if (const auto candidate = wound(all.at[i], all.singular, pose.tip, from, &reach))
            held.at[std::size_t(held.count++)] = *candidate;
    }
    return held;
}

std::optional<Joints> Kinematics::nearest(const ToolPose& pose, const Joints& from) const {
    const Solutions held = within_travel(pose, from);
    std::optional<Joints> best;
    double least = infinity;
    for (std::size_t i = 0; i < std::size_t(held.count); ++i)
        if (const double t = time(from, held.at[i]); t < least) {
            least = t;
            best = held.at[i];
        }
    return best;
}

Kinematics::Reach Kinematics::reach(const ToolPose& pose) const {
    const Joints zero;
    const Solutions all = inverse(pose, zero);
    Reach nearest_limit{Reach::Limit::axis};
    for (std::size_t i = 0; i < std::size_t(all.count); ++i) {
        Reach reach;
        if (wound(all.at[i], all.singular, pose.tip, zero, &reach)) return {};
        const bool better = nearest_limit.limit == reach.limit ? reach.beyond < nearest_limit.beyond
                                                               : int(reach.limit) > int(nearest_limit.limit);
        if (better) nearest_limit = reach;
    }
    return nearest_limit;
}

double Kinematics::time(const Joints& a, const Joints& b, bool accelerations) const {
    double seconds = 0;
    for (int k = 0; k < machine_.joints(); ++k) {
        const double distance = std::abs(b[k] - a[k]);
        seconds = std::max(
            seconds, accelerations ? trapezoid_time(distance, machine_.speed(k), machine_.acceleration(k))
                                   : distance / machine_.speed(k));
    }
    return seconds;
}

int Kinematics::slowest_axis(const Joints& a, const Joints& b) const {
    int slowest = 0;
    double most = 0;
    for (int k = 0; k < machine_.joints(); ++k)
        if (const double t = std::abs(b[k] - a[k]) / machine_.speed(k); t > most) {
            most = t;
            slowest = k;
        }
    return slowest;
}

double trapezoid_time(double distance, double speed, double acceleration) {
    if (!(distance > 0)) return 0;
    if (acceleration == infinity) return distance / speed;
    return distance * acceleration >= speed * speed ? distance / speed + speed / acceleration
                                                    : 2 * std::sqrt(distance / acceleration);
}

} // namespace facetmill
