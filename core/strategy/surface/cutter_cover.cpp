#include "core/strategy/surface/cutter_cover.h"

#include "core/base/golden_section.h"
#include "core/base/tolerances.h"

namespace facetmill {

namespace {

double angle_of(const ProfilePiece& piece, const Vec2& at) {
    return std::atan2(at.y() - piece.center.y(), at.x() - piece.center.x());
}

/// The point of a piece where support sin * rho - cos * z is largest.
Vec2 piece_support(const ProfilePiece& piece, double sine, double cosine) {
    const auto value = [&](const Vec2& q) { return sine * q.x() - cosine * q.y(); };
    if (piece.kind == ProfilePiece::Kind::arc) {
        const Vec2 q = piece.center + piece.radius * Vec2(sine, -cosine);
        const double a = std::atan2(-cosine, sine), from = angle_of(piece, piece.from),
                     to = angle_of(piece, piece.to);
        if (a >= std::min(from, to) && a <= std::max(from, to)) return q;
    }
    return value(piece.to) > value(piece.from) ? piece.to : piece.from;
}

/// The point of a piece nearest to q, and the normal of the piece there, pointing to the axis side.
struct Near {
    Vec2 foot = Vec2::Zero(), normal = Vec2::Zero();
    double distance = infinity;
    bool inside = false; ///< the foot is no end of the piece, nor as good as one
};

Near nearest(const ProfilePiece& piece, const Vec2& q) {
    Near near;
    if (piece.kind == ProfilePiece::Kind::line) {
        const Vec2 d = piece.to - piece.from;
        const double length = d.norm();
        if (length == 0) return near;
        const double t = (q - piece.from).dot(d) / (length * length);
        near.foot = piece.from + std::clamp(t, 0.0, 1.0) * d;
        near.normal = Vec2(-d.y(), d.x()) / length;
    } else {
        const double a = angle_of(piece, q), from = angle_of(piece, piece.from),
                     to = angle_of(piece, piece.to);
        const double low = std::min(from, to), high = std::max(from, to), c = std::clamp(a, low, high);
        const Vec2 out(std::cos(c), std::sin(c));
        near.foot = piece.center + piece.radius * out;
        near.normal = -out;
    }
    near.distance = (q - near.foot).norm();
    near.inside = std::min((near.foot - piece.from).norm(), (near.foot - piece.to).norm())
                  > tolerance::contact_distance;
    return near;
}

} // namespace

CutterCover::CutterCover(const CutterProfile& profile, double slack)
    : profile_(profile), slack_(slack), radius_(profile.max_radius()) {
    const auto& pieces = profile_.pieces();
    const ProfilePiece& first = pieces.front();
    if (first.kind == ProfilePiece::Kind::line && first.from.x() == 0) {
        const double rise = first.to.y() - first.from.y(), run = first.to.x();
        if (rise <= slack)
            flat_radius_ = run;
        else
            flat_radius_ = run * slack / rise;
        if (rise > 0 && std::atan2(rise, run) > tolerance::level_angle) flat_radius_ = 0;
    }
    for (const ProfilePiece& p : pieces)
        if (p.to.x() >= radius_ * (1 - tolerance::cutter_angle)) {
            shoulder_ = p.to.y();
            break;
        }
    ball_ = first.kind == ProfilePiece::Kind::arc && first.center.x() == 0 && first.radius == radius_;
}

Vec2 CutterCover::support(const Vec3& n) const {
    const double cosine = n.z(), sine = std::hypot(n.x(), n.y());
    const auto value = [&](const Vec2& q) { return sine * q.x() - cosine * q.y(); };
    Vec2 best(0, 0);
    for (const ProfilePiece& piece : profile_.pieces()) {
        const Vec2 q = piece_support(piece, sine, cosine);
        if (value(q) > value(best)) best = q;
    }
    const ProfilePiece& first = profile_.pieces().front();
    if (first.kind == ProfilePiece::Kind::line && first.from.x() == 0) {
        // Among the points on the bottom line within the slack of touching, the one nearest to the
        // axis.
        const double lack = value(best) - slack_ * cosine;
        const double end = value(first.to);
        if (lack <= 0) return {0, 0};
        if (end >= lack) return first.to * (lack / end);
    }
    return best;
}

Vec3 CutterCover::tip_offset(const Vec3& n) const {
    const Vec2 q = support(n);
    const double sine = std::hypot(n.x(), n.y());
    if (sine == 0) return Vec3(0, 0, -q.y());
    return Vec3(q.x() * n.x() / sine, q.x() * n.y() / sine, -q.y());
}

double CutterCover::ray_entry(const Vec3& p, const Vec3& n, const Vec3& tip, double limit) const {
    const Vec3 d = p - tip;
    const double a = n.x() * n.x() + n.y() * n.y();
    const double b = d.x() * n.x() + d.y() * n.y();
    const double c = d.x() * d.x() + d.y() * d.y() - radius_ * radius_;
    if (a < tolerance::upright_sine_square) { // straight up
        if (c > 0) return infinity;
        const double t = profile_.height_at(std::sqrt(c + radius_ * radius_)) - d.z();
        return t <= limit ? t : infinity;
    }
    // The line is within the radius of the axis for t in [enter, leave].
    const double disc = b * b - a * c;
    if (disc <= 0) return infinity;
    const double root = std::sqrt(disc);
    const double enter = (-b - root) / a, leave = std::min((-b + root) / a, limit);
    if (enter > limit) return infinity;
    if (d.z() + enter * n.z() >= shoulder_) return enter; // through the side
    if (ball_) {
        const Vec3 e(d.x(), d.y(), d.z() - radius_);
        const double f = e.dot(n);
        const double q = f * f - (e.squaredNorm() - radius_ * radius_);
        if (q < 0) return infinity;
        const double t = -f - std::sqrt(q);
        return t <= limit ? t : infinity;
    }
    // Height of the cutter's surface over the line: convex in t, because the cutter is convex.
    const auto gap = [&](double t) {
        const double x = d.x() + t * n.x(), y = d.y() + t * n.y();
        return profile_.height_at(std::min(std::hypot(x, y), radius_)) - (d.z() + t * n.z());
    };
    double low = enter, high = leave;
    if (gap(low) <= 0) return low;
    double inside = high;
    if (gap(high) > 0) {
        // Any point inside will do.
        const LowPlace lowest = golden_minimum(gap, low, high, tolerance::ray_accuracy, 0);
        if (lowest.value > 0) return infinity;
        inside = lowest.at;
    }
    high = inside;
    while (high - low > tolerance::ray_accuracy) {
        const double mid = 0.5 * (low + high);
        (gap(mid) <= 0 ? high : low) = mid;
    }
    return high;
}

bool CutterCover::holds(const Vec3& rel) const {
    const double square = rel.x() * rel.x() + rel.y() * rel.y();
    if (square > radius_ * radius_) return false;
    if (rel.z() >= shoulder_) return true;
    if (ball_) {
        const double z = rel.z() - radius_;
        return square + z * z <= radius_ * radius_;
    }
    return rel.z() >= profile_.height_at(std::sqrt(square));
}

double CutterCover::distance(const Vec3& rel) const {
    const double square = rel.x() * rel.x() + rel.y() * rel.y();
    if (ball_) {
        // Beside the shaft the axis counts, below it the middle.
        const double below = std::min(rel.z() - radius_, 0.0);
        return std::max(std::sqrt(square + below * below) - radius_, 0.0);
    }
    const Vec2 q(std::sqrt(square), rel.z());
    if (q.y() >= shoulder_) return std::max(q.x() - radius_, 0.0); // beside the shaft
    if (q.x() <= radius_ && q.y() >= profile_.height_at(q.x())) return 0;
    double best = (q - Vec2(radius_, shoulder_)).norm();
    for (const ProfilePiece& piece : profile_.lower_pieces())
        best = std::min(best, nearest(piece, q).distance);
    return best;
}

std::optional<Vec3> CutterCover::contact_normal(const Vec3& rel) const {
    const double rho = std::hypot(rel.x(), rel.y());
    const Vec2 q(rho, rel.z());
    Near best;
    for (const ProfilePiece& piece : profile_.pieces()) {
        const Near near = nearest(piece, q);
        if (near.distance < best.distance) best = near;
    }
    Vec2 normal = best.normal;
    if (best.distance > tolerance::contact_distance) {
        normal = (best.foot - q) / best.distance; // an allowance lies between
    } else if (!best.inside) {
        // Smooth where the other piece that ends here has the same normal, and on the axis where the mirror
        // image joins.
        bool smooth =
            best.foot.x() <= tolerance::contact_distance && std::abs(normal.x()) < tolerance::level_angle;
        int alike = 0; // counts the nearest piece too
        for (const ProfilePiece& piece : profile_.pieces()) {
            const Near near = nearest(piece, q);
            if (near.distance <= best.distance + tolerance::contact_distance
                && normal.dot(near.normal) > 1 - tolerance::level_angle)
                ++alike;
        }
        smooth = smooth || alike > 1;
        if (!smooth) return std::nullopt;
    }
    if (rho == 0) return Vec3(0, 0, 1);
    return Vec3(normal.x() * rel.x() / rho, normal.x() * rel.y() / rho, normal.y()).normalized();
}

} // namespace facetmill
