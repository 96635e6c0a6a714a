// Stand-ins for test parts that were published only as pictures: Lu's A-pillar and his surface with a gap
// (Fig. 5-7), and a car body. Their shapes are ours; what they share with the originals are the features that
// make them hard.
#include "core/mesh/sample_standins.h"

#include "core/base/units.h"
#include "core/mesh/bspline.h"
#include "core/mesh/sample_parts.h"
#include "core/mesh/sample_tessellate.h"

#include <array>
#include <cmath>

namespace facetmill::sample {

namespace {

/// Open polyline in the (y, z) plane with rounded inner corners. Pieces in order, line, arc, line ... line:
/// piece i holds the parameters i to i + 1.
struct Profile {
    static constexpr std::size_t corners = 6;
    static constexpr int pieces = 2 * int(corners) - 3;
    std::array<Vec2, corners> corner;
    std::array<double, corners> radius; ///< 0 at both ends

    Vec2 point(double t) const {
        const int piece = std::min(int(t), pieces - 1);
        const double w = t - piece;
        const std::size_t i = std::size_t(piece / 2);
        if (piece % 2 == 0) {
            const Vec2 from = corner[i] + cut(i) * direction(i);
            const Vec2 to = corner[i + 1] - cut(i + 1) * direction(i);
            return from + w * (to - from);
        }
        const Vec2 d = direction(i);
        const double turned = turn(i + 1);
        const Vec2 inward = turned > 0.0 ? Vec2(-d.y(), d.x()) : Vec2(d.y(), -d.x());
        const double angle = w * std::abs(turned), r = radius[i + 1];
        return corner[i + 1] - cut(i + 1) * d + r * std::sin(angle) * d
               + r * (1.0 - std::cos(angle)) * inward;
    }

private:
    Vec2 direction(std::size_t line) const { return (corner[line + 1] - corner[line]).normalized(); }
    /// Angle from the line before a corner to the one after it, counter-clockwise positive.
    double turn(std::size_t i) const {
        const Vec2 a = direction(i - 1), b = direction(i);
        return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    /// How much of the lines the rounding takes.
    double cut(std::size_t i) const {
        return radius[i] > 0.0 ? radius[i] * std::tan(0.5 * std::abs(turn(i))) : 0.0;
    }
};

/// Sheet of profiles along x from 0 to `length` (inches); `place(x)` gives the profile there, `lift(x, y)` is
/// added to z.
template <class Place, class Lift>
Mesh swept(double length, int cells, Place&& place, Lift&& lift, double tolerance, const char* name,
           const Progress& progress) {
    const PatchFunction patch = [&](double x, double v) {
        const Vec2 p = place(x).point(v);
        return Vec3(mm_per_inch * Vec3(x, p.x(), p.y() + lift(x, p.x())));
    };
    // Cells about as long as wide, lines on all joints of the profile.
    PatchGrid grid;
    for (int i = 0; i <= cells; ++i)
        grid.a.push_back(length * i / cells);
    for (int piece = 0; piece < Profile::pieces; ++piece) {
        double size = 0.0;
        for (const double x : {0.0, 0.5 * length, length}) {
            const Profile p = place(x);
            size = std::max(size, (p.point(piece + 1.0) - p.point(piece)).norm());
        }
        const int parts = std::max(1, int(std::lround(size * cells / length)));
        for (int i = 0; i < parts; ++i)
            grid.b.push_back(piece + double(i) / parts);
    }
    grid.b.push_back(Profile::pieces);
    return tessellate_patch(patch, grid, tolerance, name, progress);
}

// 20 in long: flange, concave blend, wall, crown, wall, concave blend, flange; it rises, sways and gets
// slimmer.
constexpr double pillar_length = 20.0;
Profile pillar_profile(double x) {
    const double t = x / pillar_length, sway = 1.5 * t * t;
    const double crown = 0.7 - 0.2 * t, foot = crown + 0.5, height = 1.2 - 0.4 * t, edge = 2.2;
    const double blend = 0.3 - 0.12 * t, shoulder = 0.35 - 0.1 * t;
    return Profile{{Vec2(sway - edge, 0), Vec2(sway - foot, 0), Vec2(sway - crown, height),
                    Vec2(sway + crown, height), Vec2(sway + foot, 0), Vec2(sway + edge, 0)},
                   {0, blend, shoulder, shoulder, blend, 0}};
}
double pillar_rise(double x, double) {
    return 5.0 * std::sin(0.5 * pi * x / pillar_length);
}

// 6 x 5 in, domed: a winding gap 1 in deep between two walls, its floor 1.2 in wide at one end and 0.6 in
// at the other.
constexpr double gap_length = 6.0;
Profile gap_profile(double x) {
    const double t = x / gap_length, middle = 0.3 * std::sin(2.0 * pi * t);
    const double floor = 0.6 - 0.3 * t, top = floor + 0.15, depth = 1.0, edge = 2.5;
    return Profile{{Vec2(-edge, depth), Vec2(middle - top, depth), Vec2(middle - floor, 0),
                    Vec2(middle + floor, 0), Vec2(middle + top, depth), Vec2(edge, depth)},
                   {0, 0.25, 0.15, 0.15, 0.25, 0}};
}
double gap_rise(double x, double y) {
    const double s = x / (0.5 * gap_length) - 1.0;
    return 0.3 * (1.0 - s * s) - 0.05 * y * y;
}

/// The curve at a parameter of all profiles, mm.
template <class Place, class Lift>
std::vector<Vec3> along(double length, Place&& place, Lift&& lift, double parameter) {
    constexpr int pieces = 800;
    std::vector<Vec3> curve;
    for (int i = 0; i <= pieces; ++i) {
        const double x = length * i / pieces;
        const Vec2 p = place(x).point(parameter);
        curve.emplace_back(mm_per_inch * Vec3(x, p.x(), p.y() + lift(x, p.x())));
    }
    return curve;
}

} // namespace

Mesh pillar(double tolerance, const Progress& progress) {
    return swept(pillar_length, 80, pillar_profile, pillar_rise, tolerance, "pillar", progress);
}

std::vector<std::vector<Vec3>> pillar_valleys() {
    return {along(pillar_length, pillar_profile, pillar_rise, 1.5),
            along(pillar_length, pillar_profile, pillar_rise, 7.5)};
}

Mesh gap(double tolerance, const Progress& progress) {
    return swept(gap_length, 32, gap_profile, gap_rise, tolerance, "gap", progress);
}

std::vector<std::vector<Vec3>> gap_valleys() {
    return {along(gap_length, gap_profile, gap_rise, 3.5), along(gap_length, gap_profile, gap_rise, 5.5)};
}

std::vector<Vec3> gap_floor() {
    return along(gap_length, gap_profile, gap_rise, 4.5);
}

Mesh shell(double tolerance, const Progress& progress) {
    // 12 x 6 in: nose, windscreen, roof and tail, sides falling away, and four scoops with walls up to about
    // 65 degrees. Their tightest hollow has a radius of 3.5 mm: the ball of D 6.35 mm that Wang reworks with
    // fits everywhere.
    static const CubicBSpline spine({{0, 0.7},
                                     {1, 0.9},
                                     {2.5, 1.25},
                                     {4, 1.35},
                                     {5, 1.6},
                                     {6, 2.4},
                                     {7.5, 2.5},
                                     {9, 2.2},
                                     {10.5, 1.9},
                                     {11.5, 1.6},
                                     {12, 1.3}});
    struct Scoop {
        double x, y, half_length, half_width, depth;
    };
    static constexpr std::array<Scoop, 4> scoops{{{2.6, -1.15, 1.1, 0.75, 0.55},
                                                  {2.6, 1.15, 1.1, 0.75, 0.55},
                                                  {8.7, -1.75, 1.3, 0.95, 0.85},
                                                  {8.7, 1.75, 1.3, 0.95, 0.85}}};
    constexpr double half_width = 3.0;
    const PatchFunction patch = [](double a, double y) {
        const Vec2 top = spine.point(a);
        const double s = y / half_width, x = top.x();
        double z = top.y() * (1.0 - 0.7 * s * s * s * s);
        for (const Scoop& scoop : scoops) {
            // Flat floor inside 0.2 of a rounded rectangle, a wall with continuous curvature out to its rim.
            const double across = std::pow((x - scoop.x) / scoop.half_length, 4)
                                  + std::pow((y - scoop.y) / scoop.half_width, 4);
            const double w = std::clamp((1.0 - std::sqrt(std::sqrt(across))) / 0.8, 0.0, 1.0);
            z -= scoop.depth * w * w * w * (10.0 + w * (6.0 * w - 15.0));
        }
        return Vec3(mm_per_inch * Vec3(x, y, z));
    };
    PatchGrid grid;
    grid.a = even_stations([&patch](double a) { return patch(a, 0.0); }, 0.0, 1.0, 64);
    for (int i = 0; i <= 32; ++i)
        grid.b.push_back(half_width * (i / 16.0 - 1.0));
    return tessellate_patch(patch, grid, tolerance, "shell", progress);
}

} // namespace facetmill::sample
