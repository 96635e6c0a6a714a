#include "tests/bench/scalar/lower_surface.h"

#include "core/base/error.h"

namespace facetmill::scalar {

namespace {

/// sqrt(a^2 - b^2) for a >= b >= 0 without cancellation.
double leg(double a, double b) {
    return std::sqrt(std::max(0.0, (a - b) * (a + b)));
}

double slope_of(double angle, bool vertical) {
    return vertical ? infinity : std::tan(angle);
}

} // namespace

LowerSurface::LowerSurface(const CutterProfile& profile) : max_radius_(profile.max_radius()) {
    for (const ProfilePiece& p : profile.lower_pieces()) {
        if (p.to.x() <= p.from.x()) continue;
        if (count_ == max_pieces)
            throw Error(ErrorCode::internal, "LowerSurface", "the profile has too many pieces",
                        "report this");
        Piece q{};
        q.rho0 = p.from.x();
        q.rho1 = p.to.x();
        if (p.kind == ProfilePiece::Kind::line) {
            q.z0 = p.from.y();
            q.slope0 = q.slope1 = std::max(0.0, (p.to.y() - p.from.y()) / (q.rho1 - q.rho0));
        } else {
            q.e = p.center.x();
            q.f = p.center.y();
            q.r = p.radius;
            q.slope0 = std::max(0.0, slope_of(p.angle_at_start(), false));
            q.slope1 = slope_of(p.angle_at_end(), p.to.y() >= q.f);
        }
        pieces_[count_++] = q;
    }
    // Tangents at three distances; that at 0 would be horizontal or a cone's, which the first covers well
    // enough.
    constexpr std::array<double, 3> at{0.4, 0.75, 0.95};
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double rho = at[i] * max_radius_;
        const Piece* p = pieces_.data();
        while (p != pieces_.data() + count_ - 1 && rho > p->rho1)
            ++p;
        const double slope = p->r == 0 ? p->slope0 : (rho - p->e) / leg(p->r, std::abs(rho - p->e));
        tangents_[i] = {height(rho) - slope * rho, slope};
    }
}

double LowerSurface::plane_contact(double horizontal, double vertical) const {
    for (std::size_t i = 0; i < count_; ++i) {
        const Piece& p = pieces_[i];
        if (horizontal <= p.slope0 * vertical) return p.rho0;
        if (p.r != 0 && horizontal <= p.slope1 * vertical) {
            const double sine = horizontal / std::sqrt(horizontal * horizontal + vertical * vertical);
            return std::clamp(p.e + p.r * sine, p.rho0, p.rho1);
        }
    }
    return max_radius_;
}

double LowerSurface::line_contact(double l, double rise, double run) const {
    // Along the line, s from the foot of the axis: rho = sqrt(l^2 + s^2), and the lift changes by
    // rise/run - g'(rho) s/rho per unit of s. It never grows with s: the first piece at whose outer end it is
    // negative holds the contact (Lu 3.64-3.72, rebuilt from the derivative).
    for (std::size_t i = 0; i < count_; ++i) {
        const Piece& p = pieces_[i];
        if (p.rho1 <= l) continue;
        const double s1 = leg(p.rho1, l);
        if (rise * p.rho1 > p.slope1 * s1 * run) continue;
        double s0 = 0;
        if (p.rho0 >= l) {
            s0 = leg(p.rho0, l);
            // s/rho at the start is 1 for a line through the axis.
            if (p.rho0 > 0 ? rise * p.rho0 <= p.slope0 * s0 * run : rise <= p.slope0 * run) return s0;
        } else if (rise == 0) {
            return 0;
        }
        if (p.r != 0) return arc_contact(p, l, rise, run, s0, s1);
        // Cone and taper (Lu 3.70, and 3.68 corrected): g' = slope.
        const double steeper = leg(p.slope0 * run, rise);
        return steeper > 0 ? std::clamp(l * rise / steeper, s0, s1) : s0;
    }
    return l < max_radius_ ? leg(max_radius_, l) : 0;
}

double LowerSurface::arc_contact(const Piece& p, double l, double rise, double run, double s0,
                                 double s1) const {
    const double length = std::sqrt(rise * rise + run * run);
    const double k = rise / length, c = run / length;
    if (p.e == 0) return std::clamp(k * leg(p.r, l), s0, s1); // sphere
    // Torus. With x = sin(angle of the surface's normal to the axis), rho = e + r x, and the slope of the
    // section equals that of the line where
    //     (e + r x) sqrt(x^2 - k^2) = l c x,        k <= x <= 1.
    // With y = sqrt(x^2 - k^2) this is G(y) = e y / sqrt(y^2 + k^2) + r y - l c = 0. For e > 0, G grows and
    // is concave, so Newton's steps from the left of the root never pass it; for e < 0 it is convex, and from
    // the right of the root they never pass it either. The steps end when they no longer move: the root to
    // full precision.
    const double target = l * c;
    double y;
    if (p.e > 0) {
        y = std::max({0.0, (target - p.e) / p.r, target * k / (p.e + p.r * k)});
    } else {
        const double x1 = std::min(1.0, (p.rho1 - p.e) / p.r);
        y = leg(std::max(x1, k), k);
    }
    constexpr int max_steps = 100; // a guard only: about 45 is the most that random tries see
    for (int i = 0; i < max_steps; ++i) {
        const double x = std::sqrt(y * y + k * k);
        if (x == 0) break;
        const double value = p.e * (y / x) + p.r * y - target;
        const double slope = p.e * (k / x) * (k / x) / x + p.r;
        const double step = -value / slope;
        const double next = std::clamp(y + step, 0.0, 1.0);
        // Away from the root's side only rounding can lead.
        if ((p.e > 0 ? next <= y : next >= y)) break;
        y = next;
    }
    const double x = std::clamp(std::sqrt(y * y + k * k), 0.0, 1.0);
    if (x == 0) return s0;
    const double rho = p.e + p.r * x;
    // Both are the contact; each is the accurate one where the other cancels.
    const double s = x < 0.5 ? rise / run * rho * leg(1, x) / x : leg(std::max(rho, l), l);
    return std::clamp(s, s0, s1);
}

} // namespace facetmill::scalar
