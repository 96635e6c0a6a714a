#include "core/strategy/surface/cutter_cover.h"

#include "core/base/tolerances.h"

namespace facetmill {

namespace {

/// So near to the rim of a ball, in radii, its profile is looked at in full.
constexpr double clear_of_ends = 1e-3;

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

std::optional<CutterCover::RoundedDisc> rounded_disc_of(const CutterProfile& profile) {
    auto pieces = profile.lower_pieces();
    CutterCover::RoundedDisc shape{0, 0};
    if (pieces.front().kind == ProfilePiece::Kind::line) {
        if (pieces.front().to.y() != 0) return std::nullopt;
        shape.disc = pieces.front().to.x();
        pieces = pieces.subspan(1);
    }
    if (!pieces.empty()) {
        if (pieces.size() > 1 || pieces.front().kind == ProfilePiece::Kind::line) return std::nullopt;
        shape.rounding = pieces.front().radius;
        const double off = tolerance::cutter_angle * profile.max_radius();
        if ((pieces.front().center - Vec2(shape.disc, shape.rounding)).norm() > off) return std::nullopt;
    }
    const double lack = profile.max_radius() - (shape.disc + shape.rounding);
    return std::abs(lack) <= tolerance::cutter_angle * profile.max_radius() ? std::optional(shape)
                                                                            : std::nullopt;
}

/// A line d + t n, given from the tip, against the lower surface of a cutter, taken endless upward. The
/// height of that surface over the line is convex in t, because the cutter is.
class LineThroughCutter {
public:
    LineThroughCutter(const CutterProfile& profile, const Vec3& d, const Vec3& n)
        : profile_(profile), z_(d.z()), rise_(n.z()), a_(n.head<2>().squaredNorm()),
          b_(d.head<2>().dot(n.head<2>())), c_(d.head<2>().squaredNorm()), nearest_(-b_ / a_),
          min_square_(std::max(0.0, c_ - b_ * b_ / a_)) {}

    /// Smallest t in [enter, leave] that is in the cutter, where the line is not beyond its largest radius;
    /// infinite where there is none.
    double entry(double enter, double leave) const {
        if (gap(enter) <= 0) return enter;
        // Piece by piece of the profile, inward as far as the line goes and outward again: on each there is
        // a closed form, or nearly.
        const auto pieces = profile_.lower_pieces();
        double t = enter;
        for (std::size_t k = pieces.size(); k-- > 0;) {
            const double inner = pieces[k].from.x();
            const bool turns = inner * inner <= min_square_;
            if (pieces[k].to.x() * pieces[k].to.x() <= min_square_) break;
            const double end = turns ? nearest_ : nearest_ - half_chord(inner);
            if (const double found = entry_on(pieces[k], t, std::min(end, leave)); found < infinity)
                return found;
            t = std::max(t, end);
            if (t >= leave) return infinity;
        }
        for (const ProfilePiece& piece : pieces) {
            const double outer = piece.to.x();
            if (outer * outer <= min_square_) continue;
            const double end = nearest_ + half_chord(outer);
            if (end <= t) continue;
            if (const double found = entry_on(piece, t, std::min(end, leave)); found < infinity) return found;
            t = end;
            if (t >= leave) return infinity;
        }
        return infinity;
    }

private:
    double rho(double t) const { return std::sqrt(std::max(0.0, c_ + t * (2 * b_ + t * a_))); }
    double gap(double t) const {
        return profile_.height_at(std::min(rho(t), profile_.max_radius())) - (z_ + t * rise_);
    }
    /// Half the length, in t, over which the line is within this radius.
    double half_chord(double radius) const {
        return std::sqrt(std::max(0.0, (radius * radius - min_square_) / a_));
    }

    /// Where the line first meets the piece in [from, to], on which it is over or under that piece alone; it
    /// is outside at `from`.
    double entry_on(const ProfilePiece& piece, double from, double to) const {
        if (!(from < to)) return infinity;
        const bool ends_inside = gap(to) <= 0;
        double t = infinity;
        if (piece.kind == ProfilePiece::Kind::line)
            t = entry_of_line(piece, from);
        else if (piece.center.x() == 0)
            t = entry_of_sphere(piece);
        else
            t = entry_of_torus(piece, from, to);
        if (ends_inside) return std::clamp(t, from, to); // rounding alone can say otherwise
        return t >= from && t <= to ? t : infinity;
    }

    /// z = slope rho + height: the cone's two halves meet the line where the square of both sides is the
    /// same.
    double entry_of_line(const ProfilePiece& piece, double from) const {
        const double slope = (piece.to.y() - piece.from.y()) / (piece.to.x() - piece.from.x()),
                     w = z_ - (piece.from.y() - slope * piece.from.x());
        if (slope == 0) return rise_ > 0 ? -w / rise_ : infinity;
        const double square = slope * slope, a = square * a_ - rise_ * rise_, b = square * b_ - w * rise_,
                     c = square * c_ - w * w, root = b * b - a * c;
        if (root < 0) return infinity;
        const double q = -(b + std::copysign(std::sqrt(root), b));
        double first = infinity;
        for (const double t : {q / a, c / q})
            // Of the half that opens upward, and where the line comes in.
            if (std::isfinite(t) && w + t * rise_ >= 0 && t >= from - tolerance::ray_accuracy)
                first = std::min(first, t);
        return first;
    }

    double entry_of_sphere(const ProfilePiece& piece) const {
        const double e = z_ - piece.center.y(), f = b_ + e * rise_,
                     root = f * f - (c_ + e * e - piece.radius * piece.radius);
        return root < 0 ? infinity : -f - std::sqrt(root);
    }

    /// The distance from the circle about the axis is convex, beyond its radius, so that Newton's steps from
    /// outside come nearer and never pass the root.
    double entry_of_torus(const ProfilePiece& piece, double from, double to) const {
        constexpr int max_steps = 60; // where the line only touches, a step halves what is left
        double t = from;
        for (int i = 0; i < max_steps && t <= to; ++i) {
            const double here = rho(t), x = std::max(here - piece.center.x(), 0.0),
                         y = std::min(z_ + t * rise_ - piece.center.y(), 0.0), far = std::hypot(x, y),
                         beyond = far - piece.radius;
            if (beyond <= 0) return t;
            const double slope = ((here > 0 ? x * (b_ + t * a_) / here : 0) + y * rise_) / far;
            if (!(slope < 0)) return infinity;
            t -= beyond / slope;
            if (-beyond / slope <= tolerance::ray_accuracy) return t;
        }
        return t <= to ? t : infinity;
    }

    const CutterProfile& profile_;
    double z_, rise_, a_, b_, c_; ///< rho^2 = a t^2 + 2 b t + c
    double nearest_, min_square_; ///< t nearest to the axis, and the square of that distance
};

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
    rounded_disc_ = rounded_disc_of(profile_);
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

double CutterCover::ray_entry_above(const Vec3& d, const Vec3& n, double limit, double on_ball) const {
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
    if (ball_) return on_ball;
    return LineThroughCutter(profile_, d, n).entry(enter, leave);
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

double CutterCover::distance_from_profile(const Vec3& rel) const {
    const Vec2 q(std::hypot(rel.x(), rel.y()), rel.z());
    if (q.y() >= shoulder_) return std::max(q.x() - radius_, 0.0); // beside the shaft
    if (q.x() <= radius_ && q.y() >= profile_.height_at(q.x())) return 0;
    double best = (q - Vec2(radius_, shoulder_)).norm();
    for (const ProfilePiece& piece : profile_.lower_pieces())
        best = std::min(best, nearest(piece, q).distance);
    return best;
}

std::optional<Vec3> CutterCover::contact_normal(const Vec3& rel) const {
    if (ball_ && rel.z() < (1 - clear_of_ends) * radius_) {
        // Towards the middle, wherever the lower half is smooth: but for its rim, and within it.
        const Vec3 inward(-rel.x(), -rel.y(), radius_ - rel.z());
        const double far = inward.norm();
        if (far > radius_ - tolerance::contact_distance) return inward / far;
    }
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
