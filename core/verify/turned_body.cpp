#include "core/base/tolerances.h"
#include "core/verify/sweep.h"

#include <array>

namespace facetmill {

namespace {

/// Where a line meets things: the first and the last.
struct Hits {
    double lo = infinity, hi = -infinity;
    void add(double t) {
        lo = std::min(lo, t);
        hi = std::max(hi, t);
    }
};

/// Roots of a t^2 + 2 b t + c; false where there are none. Without cancellation. Two that are one but for
/// rounding (a line through the point of a cone) are found.
bool roots(double a, double b, double c, double& first, double& second) {
    double d = b * b - a * c;
    if (!(d >= -tolerance::grazing_roundings * (b * b + std::abs(a * c)))) return false;
    d = std::max(d, 0.0);
    const double q = -(b + std::copysign(std::sqrt(d), b));
    if (a == 0) {
        if (q == 0) return false;
        first = second = c / q;
        return true;
    }
    first = q / a;
    second = q != 0 ? c / q : first;
    return true;
}

/// The line's passage through {dist to the circle's disc <= r}: a convex set, its distance a convex function
/// along the line, so that Newton's steps from outside never pass the root. `centre` is (rho, z) of the arc.
bool passage(const Vec2& center, double r, const Vec3& p, const Vec3& u, double from, double to,
             double accuracy, double& first, double& second) {
    struct Value {
        double f, slope;
    };
    const auto value = [&](double t) {
        const Vec3 q = p + t * u;
        const double rho = std::sqrt(q.x() * q.x() + q.y() * q.y());
        const double out = std::max(rho - center.x(), 0.0), up = q.z() - center.y();
        const double distance = std::sqrt(out * out + up * up);
        const double radial =
            rho > 0 ? (q.x() * u.x() + q.y() * u.y()) / rho : std::sqrt(u.x() * u.x() + u.y() * u.y());
        return Value{distance - r, distance > 0 ? (out * radial + up * u.z()) / distance : 0};
    };
    const auto walk = [&](double t, double direction) {
        for (int i = 0; i < 200; ++i) {
            const Value v = value(t);
            if (v.f <= accuracy) return t;
            if (v.slope * direction >= 0) return infinity; // the distance grows and never was r
            const double next = t - v.f / v.slope;
            if (next == t) return t;
            t = next;
        }
        return t;
    };
    first = walk(from, 1);
    if (!(first <= to)) return false;
    second = walk(to, -1);
    return second < infinity && second >= first - accuracy;
}

} // namespace

void TurnedBody::add(const Vec2& center, double r, double to) {
    const double from = features_.empty() ? 0 : features_.back().to;
    features_.push_back({center, r, from, std::max(from, to)});
}

TurnedBody::TurnedBody(const CutterProfile& cutter) {
    for (const ProfilePiece& p : cutter.pieces()) {
        const double start = p.angle_at_start();
        const bool joined =
            !features_.empty()
            && (features_.back().at(features_.back().to) - p.from).norm() <= tolerance::cutter_angle
            && start - features_.back().to <= tolerance::cutter_angle;
        if (!joined
            && !(features_.empty() && p.kind == ProfilePiece::Kind::arc && start <= tolerance::cutter_angle))
            add(p.from, 0, start);
        if (p.kind == ProfilePiece::Kind::arc) add(p.center, p.radius, p.angle_at_end());
        sides_.push_back(p);
    }
    const Vec2 rim = sides_.back().to;
    add(rim, 0, pi);
    if (rim.x() > 0) {
        add({0, rim.y()}, 0, pi);
        sides_.push_back({ProfilePiece::Kind::line, rim, Vec2(0, rim.y()), Vec2::Zero(), 0});
    }
    finish();
}

TurnedBody::TurnedBody(double radius, double from, double to) {
    const std::array<Vec2, 4> corners{Vec2(0, from), Vec2(radius, from), Vec2(radius, to), Vec2(0, to)};
    const std::array<double, 4> angles{0, 0.5 * pi, pi, pi};
    for (std::size_t k = 0; k < 4; ++k) {
        add(corners[k], 0, angles[k]);
        if (k > 0) sides_.push_back({ProfilePiece::Kind::line, corners[k - 1], corners[k], Vec2::Zero(), 0});
    }
    finish();
}

void TurnedBody::finish() {
    radius_ = 0;
    bottom_ = sides_.front().from.y();
    top_ = sides_.back().to.y();
    for (const ProfilePiece& s : sides_)
        radius_ = std::max({radius_, s.from.x(), s.to.x()});
    size_ = std::sqrt(radius_ * radius_ + 0.25 * (top_ - bottom_) * (top_ - bottom_));
    lower_ = 0;
    while (lower_ < sides_.size() && sides_[lower_].from.x() < radius_)
        ++lower_;
    features_.back().to = pi;
}

double TurnedBody::reach() const {
    double most = 0;
    for (const ProfilePiece& s : sides_) {
        most = std::max({most, s.from.norm(), s.to.norm()});
        // An arc may reach farther between its ends.
        if (s.kind == ProfilePiece::Kind::arc) most = std::max(most, s.center.norm() + s.radius);
    }
    return most;
}

TurnedBody TurnedBody::shrunk(double by) const {
    const Vec2 middle(0, std::min(0.5 * (bottom_ + top_), bottom_ + radius_));
    const double least = std::min(radius_, middle.y() - bottom_);
    const double scale = least > by ? 1 - by / least : 0.5;
    TurnedBody small = *this;
    const auto move = [&](Vec2& p) { p = middle + scale * (p - middle); };
    for (Feature& f : small.features_) {
        move(f.center);
        f.r *= scale;
    }
    for (ProfilePiece& s : small.sides_) {
        move(s.from);
        move(s.to);
        move(s.center);
        s.radius *= scale;
    }
    small.finish();
    return small;
}

double TurnedBody::radius_at(double z) const {
    double radius = -1;
    for (const ProfilePiece& s : sides_) {
        if (z < s.from.y() || z > s.to.y()) continue;
        double here = std::max(s.from.x(), s.to.x());
        if (s.kind == ProfilePiece::Kind::arc) {
            const double up = z - s.center.y();
            here = s.center.x() + std::sqrt(std::max(0.0, (s.radius - up) * (s.radius + up)));
        } else if (s.to.y() > s.from.y()) {
            here = s.from.x() + (s.to.x() - s.from.x()) * ((z - s.from.y()) / (s.to.y() - s.from.y()));
        }
        radius = std::max(radius, here);
    }
    return radius;
}

Stretch TurnedBody::heights_at(double rho) const {
    if (rho > radius_) return {};
    Stretch heights{sides_[lower_ - 1].to.y(), sides_[lower_ - 1].to.y()};
    const auto height = [&](const ProfilePiece& s) {
        if (s.kind == ProfilePiece::Kind::line) {
            const double t = (rho - s.from.x()) / (s.to.x() - s.from.x());
            return s.from.y() + t * (s.to.y() - s.from.y());
        }
        const double out = rho - s.center.x();
        const double half = std::sqrt(std::max(0.0, (s.radius - out) * (s.radius + out)));
        return s.from.x() < s.to.x() ? s.center.y() - half : s.center.y() + half;
    };
    for (std::size_t k = 0; k < lower_; ++k)
        if (rho <= sides_[k].to.x()) {
            heights.lo = height(sides_[k]);
            break;
        }
    for (std::size_t k = sides_.size(); k-- > lower_;)
        if (sides_[k].from.x() > sides_[k].to.x() && rho <= sides_[k].from.x()) {
            heights.hi = height(sides_[k]);
            break;
        } else if (sides_[k].from.x() == sides_[k].to.x() && sides_[k].to.x() >= rho) {
            heights.hi = sides_[k].to.y(); // a side that ends at the top
            break;
        }
    return heights;
}

Stretch TurnedBody::along(const Vec3& p, const Vec3& u) const {
    if (u.x() == 0 && u.y() == 0) {
        const Stretch heights = heights_at(std::sqrt(p.x() * p.x() + p.y() * p.y()));
        if (heights.empty()) return {};
        const double a = (heights.lo - p.z()) / u.z(), b = (heights.hi - p.z()) / u.z();
        return {std::min(a, b), std::max(a, b)};
    }
    if (u.z() == 0) {
        const double radius = radius_at(p.z());
        if (radius < 0) return {};
        const double uu = u.x() * u.x() + u.y() * u.y();
        const double middle = -(p.x() * u.x() + p.y() * u.y()) / uu;
        const double beside = (p.x() * u.y() - p.y() * u.x()) / std::sqrt(uu);
        const double square = (radius - beside) * (radius + beside);
        if (square < 0) return {};
        const double half = std::sqrt(square / uu);
        return {middle - half, middle + half};
    }
    return along_general(p, u);
}

Stretch TurnedBody::along_general(const Vec3& p, const Vec3& u) const {
    // From the point of the line nearest to the body's middle, for precision.
    const Vec3 middle(0, 0, 0.5 * (bottom_ + top_));
    const double uu = u.squaredNorm(), shift = (middle - p).dot(u) / uu;
    const Vec3 q = p + shift * u;
    const double noise = size_ * tolerance::sweep_roundings;
    if ((q - middle).squaredNorm() > (size_ + noise) * (size_ + noise)) return {};

    Hits hits;
    for (const ProfilePiece& s : sides_) {
        const double low = s.from.y() - noise, high = s.to.y() + noise;
        const auto try_at = [&](double t) {
            const double z = q.z() + t * u.z();
            if (z >= low && z <= high) hits.add(t);
        };
        double first, second;
        if (s.kind == ProfilePiece::Kind::arc && std::abs(s.center.x()) <= noise) {
            const Vec3 o(q.x(), q.y(), q.z() - s.center.y());
            if (roots(uu, o.dot(u), o.squaredNorm() - s.radius * s.radius, first, second)) {
                try_at(first);
                try_at(second);
            }
        } else if (s.kind == ProfilePiece::Kind::arc) {
            // Beyond the whole circle's body, of which this may be a small part.
            const Vec3 o(q.x(), q.y(), q.z() - s.center.y());
            const double half = (o.norm() + std::max(s.center.x(), 0.0) + 1.01 * s.radius) / std::sqrt(uu);
            if (passage(s.center, s.radius, q, u, -half, half, 0.01 * noise, first, second)) {
                const double inner = s.center.x() - noise;
                for (const double t : {first, second}) { // the circle's part that is the body's
                    const double x = q.x() + t * u.x(), y = q.y() + t * u.y();
                    if (inner <= 0 || x * x + y * y >= inner * inner) try_at(t);
                }
            }
        } else if (s.to.y() - s.from.y() <= noise) {
            // A disc: bottom or top.
            const double t = (s.from.y() - q.z()) / u.z();
            const double x = q.x() + t * u.x(), y = q.y() + t * u.y();
            const double rim = std::max(s.from.x(), s.to.x()) + noise;
            if (x * x + y * y <= rim * rim) hits.add(t);
        } else {
            const double k = (s.to.x() - s.from.x()) / (s.to.y() - s.from.y());
            // Of a pointed piece from where the line is level with the point: near it all terms are small
            // there, and none is the difference of large ones.
            double start = 0;
            Vec3 o = q;
            double radius = s.from.x() + k * (q.z() - s.from.y());
            if ((s.from.x() == 0 || s.to.x() == 0) && u.z() != 0) {
                const double level = s.from.x() == 0 ? s.from.y() : s.to.y(), at = (level - q.z()) / u.z();
                if (std::abs(at) * std::sqrt(uu) <= 2 * size_) {
                    start = at;
                    o = q + at * u;
                    radius = 0;
                }
            }
            const double grow = k * u.z();
            if (roots(u.x() * u.x() + u.y() * u.y() - grow * grow,
                      o.x() * u.x() + o.y() * u.y() - radius * grow,
                      o.x() * o.x() + o.y() * o.y() - radius * radius, first, second)) {
                try_at(start + first);
                try_at(start + second);
            }
        }
    }
    return {hits.lo + shift, hits.hi + shift};
}

} // namespace facetmill
