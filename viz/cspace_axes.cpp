#include "viz/cspace_axes.h"

#include <cmath>

namespace facetmill {

namespace {

std::string number(double v) {
    return format_number(std::abs(v) < 1e-9 ? 0.0 : v, 6);
}

} // namespace

std::array<Vec2, 4> floor_corners(const CSpaceDisplay& display) {
    return {Vec2(0, 0), Vec2(display.size.x(), 0), Vec2(display.size.x(), display.size.y()),
            Vec2(0, display.size.y())};
}

CSpaceAxes cspace_axes(const CSpaceDisplay& display, const Mat3& camera, LengthUnit unit) {
    CSpaceAxes a;
    const auto corners = floor_corners(display);
    const auto at = [](const Vec2& p, double z) { return Vec3(p.x(), p.y(), z); };
    double nearest = -infinity, leftmost = infinity;
    std::size_t left = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 seen = camera * at(corners[k], 0);
        if (seen.z() > nearest + 1e-9) {
            nearest = seen.z();
            a.front = k;
        }
        if (seen.x() < leftmost - 1e-9) {
            leftmost = seen.x();
            left = k;
        }
    }
    const Vec2 front = corners[a.front];
    const bool far_y = front.y() > 0, far_x = front.x() > 0;
    a.lead.name = "Lead, deg";
    a.lead.outward = Vec3(0, far_y ? 1 : -1, 0);
    a.lead.middle = Vec3(display.size.x() / 2, front.y(), CSpaceDisplay::floor);
    for (const double v : display.lead_ticks) {
        const Vec3 p = display.place({v, 0, 0});
        a.lead.ticks.push_back({Vec3(p.x(), front.y(), CSpaceDisplay::floor), number(degrees(v))});
    }
    a.yaw.name = "Yaw, deg";
    a.yaw.outward = Vec3(far_x ? 1 : -1, 0, 0);
    a.yaw.middle = Vec3(front.x(), display.size.y() / 2, CSpaceDisplay::floor);
    for (const double v : display.yaw_ticks) {
        const Vec3 p = display.place({0, v, 0});
        a.yaw.ticks.push_back({Vec3(front.x(), p.y(), CSpaceDisplay::floor), number(degrees(v))});
    }
    a.delta.name = "Lift, " + std::string(unit_name(unit));
    a.delta.outward = -Vec3(camera.row(0));
    for (const double v : display.delta_ticks)
        a.delta.ticks.push_back(
            {at(corners[left], v / display.delta_max * CSpaceDisplay::height), number(v / mm_per(unit))});
    a.delta.middle = at(corners[left], CSpaceDisplay::height);
    return a;
}

CSpaceSegments cspace_frame(const CSpaceDisplay& display, const CSpaceAxes& axes) {
    CSpaceSegments lines;
    const auto line = [&](const Vec3& a, const Vec3& b) {
        for (const Vec3* v : {&a, &b})
            for (int k = 0; k < 3; ++k)
                lines.push_back(float((*v)[k]));
    };
    const auto at = [](const Vec2& p, double z) { return Vec3(p.x(), p.y(), z); };
    const auto corners = floor_corners(display);
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 &p = corners[k], &q = corners[(k + 1) % 4];
        line(at(p, CSpaceDisplay::floor), at(q, CSpaceDisplay::floor));
        line(at(p, 0), at(q, 0));
        const bool front = k == axes.front;
        if (!front) line(at(p, CSpaceDisplay::floor), at(p, CSpaceDisplay::height));
        if (k != axes.front && (k + 1) % 4 != axes.front)
            line(at(p, CSpaceDisplay::height), at(q, CSpaceDisplay::height));
    }
    for (const CSpaceAxis* axis : {&axes.lead, &axes.yaw, &axes.delta})
        for (const CSpaceTick& t : axis->ticks)
            line(t.at, t.at + CSpaceAxes::tick * axis->outward);
    return lines;
}

} // namespace facetmill
