#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/cutter/cutter.h"
#include "core/cutter/refuse.h"

#include <array>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

void check_values(const AptCutter& c) {
    const std::array<std::pair<const char*, double>, 7> values{
        {{"d", c.d}, {"r", c.r}, {"e", c.e}, {"f", c.f}, {"alpha", c.alpha}, {"beta", c.beta}, {"h", c.h}}};
    for (const auto& [letter, value] : values) {
        if (!std::isfinite(value)) refuse(letter, "the value is not a finite number", "enter a number");
        if (std::abs(value) > tolerance::largest_coordinate)
            refuse(letter, "the value " + mm(value) + " is too large",
                   "at most " + mm(tolerance::largest_coordinate));
    }
    if (c.d <= 0) refuse("d", "the diameter " + mm(c.d) + " is not above 0", "enter a positive diameter");
    if (c.r < 0) refuse("r", "the corner radius " + mm(c.r) + " is negative", "enter 0 or more");
    if (c.alpha < 0 || c.alpha >= 0.5 * pi)
        refuse("alpha", "the bottom angle is out of range", "0 or more and below 90°");
    if (std::abs(c.beta) >= 0.5 * pi)
        refuse("beta", "the taper angle is out of range", "above -90° and below 90°");
    if (c.alpha + c.beta > 0.5 * pi + tolerance::cutter_angle)
        refuse("beta", "bottom angle and taper angle make no convex cutter", "together at most 90°");
    if (c.h <= 0) refuse("h", "the height " + mm(c.h) + " is not above 0", "enter a positive height");
}

/// Where a line (through `through`, unit direction u) meets the circle: parameters along the line. Tangent,
/// and meeting itself in one parameter, when it misses by rounding only.
struct LineMeetsCircle {
    bool meets = false, tangent = false;
    double before = 0, after = 0;
};
LineMeetsCircle meet(const Vec2& through, const Vec2& u, const Vec2& center, double r, double noise) {
    const Vec2 to = center - through;
    const double along = u.dot(to);
    const double distance = std::abs(u.x() * to.y() - u.y() * to.x());
    if (std::abs(distance - r) <= noise) return {true, true, along, along};
    if (distance > r) return {};
    const double half = std::sqrt((r - distance) * (r + distance));
    return {true, false, along - half, along + half};
}

/// The corner circle between its joints with bottom and side, or the sharp corner itself.
struct Corner {
    bool rounded = false;
    Vec2 first_point, last_point, center;
    double radius = 0;
};

/// Angle of the circle's tangent at p, from the outward radial direction: the outward normal is 90° behind
/// it.
double tangent_angle(const Vec2& center, const Vec2& p) {
    return std::atan2(p.x() - center.x(), center.y() - p.y());
}

std::optional<Corner> corner_of(const AptCutter& c, const Vec2& bottom, const Vec2& side,
                                const Vec2& corner) {
    const Vec2 center(c.e, c.f);
    const double noise = tolerance::cutter_angle * std::max({c.d, c.r, std::abs(c.e), std::abs(c.f)});
    const LineMeetsCircle low = meet(Vec2::Zero(), bottom, center, c.r, noise);
    const LineMeetsCircle high = meet(corner, side, center, c.r, noise);
    if (!low.meets || !high.meets) return std::nullopt;
    // Where a line cuts the circle twice, the boundary passes from the bottom line to the circle at the outer
    // meeting and from the circle to the side line at the lower one: only there it turns to the steeper side.
    const double start = low.after, end = high.before;
    // A circle through the tip may seem to meet the bottom line beyond it, far though when it meets it at a
    // small angle.
    const bool before_tip = start < 0 && std::abs(center.norm() - c.r) > noise;
    if (before_tip || start * bottom.x() > 0.5 * c.d + noise || end < -noise) return std::nullopt;
    Corner k{true, std::max(0.0, start) * bottom, corner + std::max(0.0, end) * side, center, c.r};
    if (tangent_angle(center, k.first_point) > tangent_angle(center, k.last_point)) {
        if ((k.first_point - k.last_point).norm() > noise) return std::nullopt;
        k.last_point = k.first_point;
    }
    return k;
}

ProfilePiece line(const Vec2& from, const Vec2& to) {
    return {ProfilePiece::Kind::line, from, to, Vec2::Zero(), 0};
}

/// Appends an arc, cut at the height of its centre.
void add_arc(std::vector<ProfilePiece>& pieces, const Vec2& from, const Vec2& to, const Vec2& center,
             double radius) {
    const Vec2 widest = center + Vec2(radius, 0);
    if (from.y() < center.y() && to.y() > center.y()) {
        pieces.push_back({ProfilePiece::Kind::arc, from, widest, center, radius});
        pieces.push_back({ProfilePiece::Kind::arc, widest, to, center, radius});
    } else {
        pieces.push_back({ProfilePiece::Kind::arc, from, to, center, radius});
    }
}

/// Ends the profile at height h; what is above is dropped.
void cut_at(std::vector<ProfilePiece>& pieces, double h) {
    while (!pieces.empty() && pieces.back().from.y() >= h && pieces.back().from.y() > 0)
        pieces.pop_back();
    if (pieces.empty() || pieces.back().to.y() <= h) return;
    ProfilePiece& last = pieces.back();
    if (last.kind == ProfilePiece::Kind::line) {
        const double t = (h - last.from.y()) / (last.to.y() - last.from.y());
        last.to = Vec2(last.from.x() + t * (last.to.x() - last.from.x()), h);
    } else {
        const double up = h - last.center.y();
        last.to =
            Vec2(last.center.x() + std::sqrt(std::max(0.0, (last.radius - up) * (last.radius + up))), h);
    }
}

} // namespace

double ProfilePiece::angle_at_start() const {
    return kind == Kind::line ? std::atan2(to.y() - from.y(), to.x() - from.x())
                              : tangent_angle(center, from);
}

double ProfilePiece::angle_at_end() const {
    return kind == Kind::line ? std::atan2(to.y() - from.y(), to.x() - from.x()) : tangent_angle(center, to);
}

CutterProfile::CutterProfile(const AptCutter& cutter) : cutter_(cutter) {
    check_values(cutter);
    const AptCutter& c = cutter;
    const Vec2 bottom(std::cos(c.alpha), std::sin(c.alpha)), side(std::sin(c.beta), std::cos(c.beta));
    const Vec2 corner(0.5 * c.d, 0.5 * c.d * std::tan(c.alpha));
    const double near = tolerance::cutter_tangency * std::max(c.d, c.r);

    Corner k;
    if (c.r == 0) {
        const bool unset = c.e == 0 && c.f == 0;
        if (!unset && (Vec2(c.e, c.f) - corner).norm() > near)
            refuse("e",
                   "with corner radius 0 the centre (e, f) must be the corner (" + mm(corner.x()) + ", "
                       + mm(corner.y()) + ")",
                   "correct e and f, or enter 0 for both");
        k = {false, corner, corner, corner, 0};
    } else {
        std::optional<Corner> found = corner_of(c, bottom, side, corner);
        if (!found) {
            // Rounded values in a CL file leave a gap of their last digit; a larger one is no cutter.
            const double half = std::max(0.0, 0.5 * (0.5 * pi - c.alpha - c.beta));
            const double touch = corner.x() - c.r * std::tan(half) * bottom.x();
            const Vec2 tangent(touch - c.r * bottom.y(), touch * std::tan(c.alpha) + c.r * bottom.x());
            if (touch >= -near && (tangent - Vec2(c.e, c.f)).norm() <= near) {
                cutter_.e = std::max(touch, 0.0) - c.r * bottom.y();
                cutter_.f = std::max(touch, 0.0) * std::tan(c.alpha) + c.r * bottom.x();
                found = corner_of(cutter_, bottom, side, corner);
            }
        }
        if (!found)
            refuse("r",
                   "the corner circle of radius " + mm(c.r) + " about (" + mm(c.e) + ", " + mm(c.f)
                       + ") does not round the corner between bottom and side to a convex cutter",
                   "correct r, e and f, or give the diameter at which bottom and side line meet");
        k = *found;
    }

    const double shortest = tolerance::cutter_angle * std::max(c.d, c.r);
    if (k.first_point.norm() > shortest)
        pieces_.push_back(line(Vec2::Zero(), k.first_point));
    else
        k.first_point = Vec2::Zero();
    if (k.rounded && (k.last_point - k.first_point).norm() > shortest)
        add_arc(pieces_, k.first_point, k.last_point, k.center, k.radius);
    else
        k.last_point = k.first_point;
    if (c.h > k.last_point.y()) {
        const double top_radius =
            c.beta == 0 ? k.last_point.x() : k.last_point.x() + (c.h - k.last_point.y()) * std::tan(c.beta);
        if (top_radius < -shortest)
            refuse("h",
                   "with taper angle " + format_number(degrees(c.beta))
                       + "° the side meets the axis below the height " + mm(c.h),
                   "at most " + mm(k.last_point.y() + k.last_point.x() / -std::tan(c.beta)));
        if (top_radius > tolerance::largest_coordinate)
            refuse("h", "the radius at height " + mm(c.h) + " is too large",
                   "enter a smaller height or taper angle");
        pieces_.push_back(line(k.last_point, Vec2(std::max(0.0, top_radius), c.h)));
    }
    cut_at(pieces_, c.h);
    finish();
}

CutterProfile CutterProfile::grown(double allowance) const {
    if (!std::isfinite(allowance) || allowance < 0)
        refuse("allowance", "the allowance is negative or not a finite number", "enter 0 or more");
    if (allowance == 0) return *this;
    const auto normal = [](double angle) { return Vec2(std::sin(angle), -std::cos(angle)); };

    CutterProfile g;
    g.cutter_ = cutter_;
    // `angle` is that of the boundary's tangent so far: 0 on the axis, pi where the top is reached.
    double angle = 0;
    Vec2 at(0, -allowance);
    const auto turn_to = [&](const Vec2& joint, double next) {
        if (next - angle > tolerance::cutter_angle) {
            const Vec2 to = joint + allowance * normal(next);
            add_arc(g.pieces_, at, to, joint, allowance);
            at = to;
        }
        angle = std::max(angle, next);
    };
    for (const ProfilePiece& p : pieces_) {
        turn_to(p.from, p.angle_at_start());
        const Vec2 to = p.to + allowance * normal(p.angle_at_end());
        if (p.kind == ProfilePiece::Kind::line)
            g.pieces_.push_back(line(at, to));
        else
            g.pieces_.push_back({p.kind, at, to, p.center, p.radius + allowance});
        at = to;
        angle = std::max(angle, p.angle_at_end());
    }
    turn_to(pieces_.back().to, pi);
    for (ProfilePiece& p : g.pieces_) {
        p.from.y() += allowance;
        p.to.y() += allowance;
        if (p.kind == ProfilePiece::Kind::arc) p.center.y() += allowance;
    }
    g.pieces_.front().from = Vec2::Zero();
    g.finish();
    return g;
}

void CutterProfile::finish() {
    for (const ProfilePiece& p : pieces_)
        max_radius_ = std::max({max_radius_, p.from.x(), p.to.x()});
    height_ = pieces_.back().to.y();
    lower_count_ = 0;
    while (lower_count_ < pieces_.size() && pieces_[lower_count_].from.x() < max_radius_)
        ++lower_count_;
    if (max_radius_ < tolerance::smallest_cutter)
        refuse("d", "the cutter's radius " + mm(max_radius_) + " is too small",
               "at least " + mm(tolerance::smallest_cutter));
}

double CutterProfile::height_at(double rho) const {
    rho = std::abs(rho);
    if (!(rho <= max_radius_)) return std::isnan(rho) ? rho : infinity;
    for (const ProfilePiece& p : lower_pieces()) {
        if (rho > p.to.x()) continue;
        if (p.kind == ProfilePiece::Kind::line) {
            const double t = (rho - p.from.x()) / (p.to.x() - p.from.x());
            return p.from.y() + t * (p.to.y() - p.from.y());
        }
        const double out = rho - p.center.x();
        return p.center.y() - std::sqrt(std::max(0.0, (p.radius - out) * (p.radius + out)));
    }
    return lower_pieces().back().to.y();
}

double CutterProfile::radius_at(double z) const {
    if (std::isnan(z)) return z;
    if (z < 0) return 0;
    if (z > height_) return pieces_.back().to.x();
    double radius = 0; // the largest among the pieces that reach this height
    for (const ProfilePiece& p : pieces_) {
        if (z < p.from.y() || z > p.to.y()) continue;
        double here;
        if (p.kind == ProfilePiece::Kind::arc) {
            const double up = z - p.center.y();
            here = p.center.x() + std::sqrt(std::max(0.0, (p.radius - up) * (p.radius + up)));
        } else if (p.to.y() > p.from.y()) {
            const double t = (z - p.from.y()) / (p.to.y() - p.from.y());
            here = p.from.x() + t * (p.to.x() - p.from.x());
        } else {
            here = p.to.x();
        }
        radius = std::max(radius, here);
    }
    return radius;
}

} // namespace facetmill
