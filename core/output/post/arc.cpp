#include "core/output/post/arc.h"

#include "core/base/plane_geometry.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Fewer motions say nothing of a circle: three points always lie on one.
constexpr std::size_t min_motions = 3;
/// Of one motion, so that what bounds the climb of a helix between two points holds.
constexpr double largest_step = 1;
/// Difference of even motion on an arc and on its chord, in shares of the chord, by the square of the angle.
constexpr double chord_pace = 0.02;

/// Angle from a to b by the right hand, [0, 2 pi).
double turn(double a, double b) {
    const double by = std::remainder(b - a, 2 * pi);
    return by < 0 ? by + 2 * pi : by;
}

/// Points in the plane of an arc: along the chord from its middle, and across it.
class Fit {
public:
    Fit(std::span<const Vec3> points, int normal, const ArcLimits& limits)
        : points_(points), normal_(normal), limits_(limits) {}

    std::optional<PlaneArc> arc();

private:
    bool centre();
    bool keeps() const;

    std::span<const Vec3> points_;
    int normal_, u_ = 0, v_ = 0;
    const ArcLimits& limits_;
    PlaneArc arc_;
};

/// The centre on the middle line of the chord that fits best; false for what is straight or goes round too
/// far.
bool Fit::centre() {
    const Vec3 &a = points_.front(), &b = points_.back();
    const double cu = b[u_] - a[u_], cv = b[v_] - a[v_], length = std::hypot(cu, cv);
    if (!(length > tolerance::smallest_chord)) return false;
    const double mu = 0.5 * (a[u_] + b[u_]), mv = 0.5 * (a[v_] + b[v_]), half = 0.5 * length;
    double squares = 0, products = 0, side = 0;
    for (const Vec3& p : points_.subspan(1, points_.size() - 2)) {
        const double du = p[u_] - mu, dv = p[v_] - mv;
        const double x = (du * cu + dv * cv) / length, y = (dv * cu - du * cv) / length;
        squares += y * y;
        products += y * (x * x + y * y - half * half);
        side += y;
    }
    if (!(squares > 0) || !(std::abs(side) > 0)) return false;
    const double h = products / (2 * squares);
    const double radius = std::hypot(half, h);
    if (!(radius >= limits_.smallest_radius && radius <= limits_.largest_radius)) return false;
    const double angle = 2 * std::atan2(half, side > 0 ? -h : h);
    if (!(angle <= limits_.largest_angle)) return false;
    arc_.normal = normal_;
    arc_.from = a;
    arc_.to = b;
    arc_.centre = a;
    arc_.centre[u_] = mu - h * cv / length;
    arc_.centre[v_] = mv + h * cu / length;
    // Points to the left of the chord are passed clockwise.
    arc_.angle = side > 0 ? -angle : angle;
    return true;
}

bool Fit::keeps() const {
    const double radius = arc_.radius(), whole = std::abs(arc_.angle);
    const double climb = arc_.to[normal_] - arc_.from[normal_];
    if (!limits_.helix && std::abs(climb) > limits_.off) return false;
    const auto polar = [&](const Vec3& p) {
        return Eigen::Vector2d(p[u_] - arc_.centre[u_], p[v_] - arc_.centre[v_]);
    };
    const double start = std::atan2(polar(arc_.from)[1], polar(arc_.from)[0]);
    double before = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const Eigen::Vector2d p = polar(points_[i]), q = polar(points_[i - 1]);
        const double at = std::atan2(p[1], p[0]);
        const double gone =
            i + 1 == points_.size() ? whole : (arc_.angle > 0 ? turn(start, at) : turn(at, start));
        const double step = gone - before;
        if (!(step >= 0 && step <= largest_step)) return false;
        const double radial = p.norm() - radius;
        const double axial = points_[i][normal_] - arc_.from[normal_] - climb * gone / whole;
        if (!(std::hypot(radial, axial) <= limits_.off)) return false;
        const Eigen::Vector2d d = p - q;
        const double square = d.squaredNorm();
        const double t = square > 0 ? std::clamp(-q.dot(d) / square, 0.0, 1.0) : 0;
        const double pace =
            chord_pace * step * step * std::abs(points_[i][normal_] - points_[i - 1][normal_]);
        if (!(std::hypot(radius - (q + t * d).norm(), pace) <= limits_.bulge)) return false;
        before = gone;
    }
    return true;
}

std::optional<PlaneArc> Fit::arc() {
    arc_.normal = normal_;
    u_ = arc_.first();
    v_ = arc_.second();
    if (!centre() || !keeps()) return std::nullopt;
    return arc_;
}

/// The most motions, from three on, that lie on an arc about this axis.
std::optional<ArcRun> run_about(std::span<const Vec3> points, int normal, const ArcLimits& limits) {
    const auto fitted = [&](std::size_t motions) {
        return Fit(points.first(motions + 1), normal, limits).arc();
    };
    const std::size_t most = points.size() - 1;
    std::optional<ArcRun> best;
    std::size_t too_many = most + 1;
    for (std::size_t n = min_motions; n <= most; n = n == most ? most + 1 : std::min(most, n + n / 2)) {
        const auto arc = fitted(n);
        if (!arc) {
            too_many = n;
            break;
        }
        best = ArcRun{*arc, n};
    }
    while (best && too_many - best->motions > 1) {
        const std::size_t n = (best->motions + too_many) / 2;
        if (const auto arc = fitted(n))
            best = ArcRun{*arc, n};
        else
            too_many = n;
    }
    return best;
}

} // namespace

double PlaneArc::radius() const {
    return std::hypot(from[first()] - centre[first()], from[second()] - centre[second()]);
}

double PlaneArc::radius_at_end() const {
    return std::hypot(to[first()] - centre[first()], to[second()] - centre[second()]);
}

double PlaneArc::length() const {
    return std::hypot(0.5 * (radius() + radius_at_end()) * angle, to[normal] - from[normal]);
}

Vec3 PlaneArc::at(double t) const {
    if (t <= 0) return from;
    if (t >= 1) return to;
    const int u = first(), v = second();
    const double start = std::atan2(from[v] - centre[v], from[u] - centre[u]);
    const double r = (1 - t) * radius() + t * radius_at_end(), a = start + t * angle;
    Vec3 p;
    p[u] = centre[u] + r * std::cos(a);
    p[v] = centre[v] + r * std::sin(a);
    p[normal] = (1 - t) * from[normal] + t * to[normal];
    return p;
}

PlaneArc arc_about(const Vec3& from, const Vec3& to, const Vec3& centre, int normal, bool clockwise) {
    PlaneArc arc{normal, from, to, centre, 0};
    arc.centre[normal] = from[normal];
    const int u = arc.first(), v = arc.second();
    const double a = std::atan2(from[v] - centre[v], from[u] - centre[u]),
                 b = std::atan2(to[v] - centre[v], to[u] - centre[u]);
    const bool whole = from[u] == to[u] && from[v] == to[v];
    const double by = whole ? 2 * pi : clockwise ? turn(b, a) : turn(a, b);
    arc.angle = clockwise ? -by : by;
    return arc;
}

std::optional<PlaneArc> arc_with_radius(const Vec3& from, const Vec3& to, double radius, int normal,
                                        bool clockwise, double slack) {
    PlaneArc arc{normal, from, to, from, 0};
    const int u = arc.first(), v = arc.second();
    const double cu = to[u] - from[u], cv = to[v] - from[v], length = std::hypot(cu, cv);
    if (!(length > 0) || 0.5 * length > std::abs(radius) + slack) return std::nullopt;
    const double off = leg_length(std::abs(radius), 0.5 * length);
    // Less than half a turn clockwise has its centre to the right.
    const double h = clockwise == (radius > 0) ? -off : off;
    Vec3 centre = from;
    centre[u] = 0.5 * (from[u] + to[u]) - h * cv / length;
    centre[v] = 0.5 * (from[v] + to[v]) + h * cu / length;
    return arc_about(from, to, centre, normal, clockwise);
}

std::optional<ArcRun> arc_run(std::span<const Vec3> points, const ArcLimits& limits) {
    std::optional<ArcRun> best;
    if (points.size() <= min_motions) return best;
    for (int normal = 2; normal >= 0; --normal)
        if (limits.normals[std::size_t(normal)])
            if (const auto run = run_about(points, normal, limits);
                run && (!best || run->motions > best->motions))
                best = run;
    return best;
}

} // namespace facetmill
