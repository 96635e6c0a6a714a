// Notation. In the tool's frame, tip of the start at 0: `u_` direction of the lines, `along_` of the motion,
// `across_` = u x along normalised, `out_` = along x across: `out_` is across the motion and on the lines'
// side (u . out = sine of the angle between them > 0). A point q has c = q . across, y = q . out, l = q .
// along. All points of one line have the same c, and at its entry and exit the swept body's outline has the
// same y.
//
// The outline's point with outward normal n(psi) = -cos(psi) across + side sin(psi) out is the body's own
// support point for that normal; psi from 0 to pi runs through all c, on the exit's side (side 1) or the
// entry's (side -1). How far n is from straight down, phi, says which feature of the profile it is:
//     cos(phi) = -n_z = A cos(psi + delta),   A = |(across_z, out_z)|,   delta = atan2(side out_z, across_z)
// which has one extremum in psi, so every feature's range of phi has at most two ranges of psi.
#include "core/verify/sweep.h"

#include "core/base/error.h"
#include "core/base/plane_geometry.h"
#include "core/base/tolerances.h"
#include "core/base/turn.h"

#include <array>
#include <limits>

namespace facetmill {

namespace {

/// Of a torus' outline, from which Newton's method starts within 1e-4 of where it ends.
constexpr double cells_a_right_angle = 8;

} // namespace

Mat3 to_tool_frame(const Vec3& axis) {
    // The rotation of least angle; for an axis that points straight down half a turn about x.
    if (axis.x() == 0 && axis.y() == 0)
        return axis.z() > 0 ? Mat3(Mat3::Identity()) : Mat3(Vec3(1, -1, -1).asDiagonal());
    return turn_between(axis, Vec3::UnitZ()).toRotationMatrix();
}

Box3 StraightMove::box(const TurnedBody& body) const {
    Box3 box;
    for (const Vec3& tip : {from, to})
        for (double z : {body.bottom(), body.top()})
            box.add(tip + z * axis);
    for (int k = 0; k < 3; ++k) {
        const double reach = body.radius() * std::sqrt(std::max(0.0, (1 - axis[k]) * (1 + axis[k])));
        box.lo[k] -= reach;
        box.hi[k] += reach;
    }
    return box;
}

SweepRays::SweepRays(const TurnedBody& body, const StraightMove& move, const Vec3& direction)
    : body_(&body), frame_(to_tool_frame(move.axis)), from_(move.from) {
    u_ = frame_ * direction;
    const Vec3 route = move.to - move.from;
    length_ = route.norm();
    const double size = std::hypot(body.radius(), body.top() - body.bottom());
    Vec3 world_along = Vec3::Zero();
    if (length_ > size * tolerance::sweep_roundings) world_along = route / length_;
    // All in part coordinates first: what is exactly vertical there stays so.
    const Vec3 cross = direction.cross(world_along);
    sine_ = cross.norm();
    world_along_ = world_along;
    along_ = frame_ * world_along;
    u_along_ = direction.dot(world_along);
    const double noise = size * tolerance::sweep_roundings;
    set_cylinder(move, direction, noise);
    parallel_ = !(sine_ > tolerance::parallel_sine);
    slow_ = u_.z() != 0 && (u_.x() != 0 || u_.y() != 0);
    if (parallel_) return;
    world_across_ = cross / sine_;
    world_out_ = world_along.cross(world_across_);
    across_ = frame_ * world_across_;
    out_ = frame_ * world_out_;
    build(-1, entry_);
    build(1, exit_);
    for (const auto* chain : {&entry_, &exit_})
        for (const Link& link : *chain)
            slow_ |= link.kind == Link::Kind::torus;
    if (!exit_.empty()) {
        const double at = world_across_.dot(from_);
        strips_[0] = {world_across_, at + exit_.front().c0 - noise, at + exit_.back().c1 + noise};
    }
}

void SweepRays::set_cylinder(const StraightMove& move, const Vec3& direction, double noise) {
    // The shadow of the cylinder round the body, which moves with it, is a strip.
    const Vec3 route = move.to - move.from, beside = move.axis.cross(direction);
    const double rise = direction.dot(move.axis), slack = 1e5 * noise;
    if (const double lean = beside.norm(); lean > tolerance::parallel_sine) {
        const Vec3 value = beside / lean;
        const double a = value.dot(move.from), b = value.dot(move.to), radius = body_->radius() + noise;
        strips_[1] = {value, std::min(a, b) - radius, std::max(a, b) + radius};
        hull_.middle = 0.5 * (a + b);
        hull_.half = 0.5 * std::abs(b - a) + radius + slack;
        hull_.per_lean = 1 / lean;
        hull_.nearest = (rise * move.axis - direction) / (lean * lean);
        const double start = -hull_.nearest.dot(move.from), shift = -hull_.nearest.dot(route);
        hull_.from = start + std::min(0.0, shift) - slack * hull_.per_lean;
        hull_.to = start + std::max(0.0, shift) + slack * hull_.per_lean;
    }
    if (std::abs(rise) > tolerance::parallel_sine) {
        hull_.level = -move.axis / rise;
        const double climb = route.dot(move.axis), start = move.from.dot(move.axis);
        const double a = (start + body_->bottom() + std::min(0.0, climb) - slack) / rise;
        const double b = (start + body_->top() + std::max(0.0, climb) + slack) / rise;
        hull_.bottom = std::min(a, b);
        hull_.top = std::max(a, b);
    }
}

/// Whether what holds the swept body has nothing of a line between `low` and `high`.
bool SweepRays::misses(const Vec3& p, double low, double high) const {
    const double level = hull_.level.dot(p);
    if (level + hull_.bottom >= high || level + hull_.top <= low) return true;
    if (hull_.per_lean == 0) return false;
    const double off = std::abs(strips_[1].value.dot(p) - hull_.middle);
    if (off > hull_.half) return true;
    const double nearest = hull_.nearest.dot(p);
    const double half = std::sqrt((hull_.half - off) * (hull_.half + off)) * hull_.per_lean;
    return nearest + hull_.from - half >= high || nearest + hull_.to + half <= low;
}

/// An angle from 0 to pi by its place p: tan(psi / 2) up to a right angle, then what that is short of 2 seen
/// from the other end. It grows with psi, is as exact near both ends as psi is, and needs no trigonometry.
struct SweepRays::Angle {
    double cosine, sine;

    static Angle at(double p) {
        const double t = p <= 1 ? p : 2 - p, scale = 1 / (1 + t * t), cosine = (1 - t * t) * scale;
        return {p <= 1 ? cosine : -cosine, 2 * t * scale};
    }
    double place() const { return cosine >= 0 ? sine / (1 + cosine) : 2 - sine / (1 - cosine); }
    /// Turned on by `step`, to its third power.
    Angle turned(double step) const {
        const double t = 0.5 * step, scale = 1 / (1 + t * t), c = (1 - t * t) * scale, s = 2 * t * scale;
        return {cosine * c - sine * s, sine * c + cosine * s};
    }
};

Vec3 SweepRays::normal(double side, double psi) const {
    return -std::cos(psi) * across_ + side * std::sin(psi) * out_;
}

/// Support point for n(psi). Where n is vertical the point on the corner's circle is that of normals towards
/// `from_psi`.
Vec3 SweepRays::outline_point(const TurnedBody::Feature& f, double side, double psi, double from_psi) const {
    const Vec3 n = normal(side, psi);
    Vec2 h = n.head<2>();
    double away = h.norm();
    if (!(away > tolerance::unit_rounding)) {
        h = (from_psi - psi) * (std::sin(psi) * across_ + side * std::cos(psi) * out_).head<2>();
        away = h.norm();
    }
    const Vec2 radial = away > 0 ? Vec2(h / away) : Vec2(Vec2::Zero());
    Vec3 q = f.r * n;
    q.head<2>() += f.center.x() * radial;
    q.z() += f.center.y();
    return q;
}

void SweepRays::build(double side, std::vector<Link>& chain) {
    const auto& features = body_->features_;
    const double a = std::hypot(across_.z(), out_.z());
    const double delta = a > 0 ? std::atan2(side * out_.z(), across_.z()) : 0;
    const bool lowest = delta <= 0; // the extremum is where n points down most
    const double turn = std::clamp(lowest ? -delta : pi - delta, 0.0, pi);
    const auto phi_at = [&](double psi) {
        return std::acos(std::clamp(a * std::cos(psi + delta), -1.0, 1.0));
    };
    // psi of an angle phi, before the extremum or after it.
    const auto psi_at = [&](double phi, bool before) {
        const double w = a > 0 ? std::acos(std::clamp(std::cos(phi) / a, -1.0, 1.0)) : 0;
        const double psi =
            lowest ? (before ? -delta - w : -delta + w) : (before ? w - delta : 2 * pi - delta - w);
        return std::clamp(psi, 0.0, pi);
    };
    const double width = 2 * (body_->radius() + body_->top() - body_->bottom());
    const double tiny = tolerance::vanishing_outline * width;

    bool any = false;
    Vec3 end = Vec3::Zero(); // of the chain so far, (c, y, l)
    const auto image = [&](const Vec3& q) { return Vec3(q.dot(across_), q.dot(out_), q.dot(along_)); };
    const auto join = [&](const Vec3& start) {
        if (any && start.x() - end.x() > tiny) {
            Link line;
            line.c0 = end.x();
            line.c1 = start.x();
            line.y0 = end.y();
            line.l0 = end.z();
            line.slope_y = (start.y() - end.y()) / (start.x() - end.x());
            line.slope_l = (start.z() - end.z()) / (start.x() - end.x());
            chain.push_back(line);
        }
        any = true;
        end = start;
    };
    const auto feature_link = [&](const TurnedBody::Feature& f, double psi0, double psi1) {
        join(image(outline_point(f, side, psi0, psi1)));
        const Vec3 start = end, stop = image(outline_point(f, side, psi1, psi0));
        if (stop.x() - start.x() > tiny) {
            Link link;
            link.c0 = start.x();
            link.c1 = stop.x();
            link.middle_c = f.center.y() * across_.z();
            link.middle_y = f.center.y() * out_.z();
            link.middle_l = f.center.y() * along_.z();
            const Vec2 m = across_.head<2>(), k = out_.head<2>(), d = along_.head<2>();
            const double mm = m.norm(), e = f.center.x();
            if (f.r > 0 && std::abs(e) <= tolerance::cutter_angle * f.r) {
                link.kind = Link::Kind::sphere;
                link.scale = 1 / f.r;
                link.sin_y = side * f.r;
            } else if (f.r > 0) {
                link.kind = Link::Kind::torus;
                link.e = e;
                link.r = f.r;
                const Angle from{std::cos(psi0), std::sin(psi0)}, to{std::cos(psi1), std::sin(psi1)};
                link.cos0 = from.cosine;
                link.cos1 = to.cosine;
                link.p0 = from.place();
                link.p1 = to.place();
                tabulate_torus(link, side);
            } else {
                // (cos, sin) of the place on the circle from the direction of m.
                link.kind = Link::Kind::circle;
                link.scale = 1 / (e * mm);
                const Vec2 t = m / mm, s(-t.y(), t.x());
                const double sign = side * (m.x() * k.y() - m.y() * k.x()) >= 0 ? 1 : -1;
                link.cos_y = e * k.dot(t);
                link.sin_y = sign * e * k.dot(s);
                link.cos_l = e * d.dot(t);
                link.sin_l = sign * e * d.dot(s);
            }
            chain.push_back(link);
            end = stop;
        } else if (stop.x() > end.x()) {
            end = stop;
        }
    };
    const auto run = [&](double psi0, double psi1, bool before) {
        if (!(psi1 > psi0)) return;
        const double phi0 = phi_at(psi0), phi1 = phi_at(psi1);
        const bool up = phi1 >= phi0;
        const auto n = std::ptrdiff_t(features.size());
        double psi = psi0;
        for (std::ptrdiff_t step = 0; step < n; ++step) {
            const auto& f = features[std::size_t(up ? step : n - 1 - step)];
            const double leave = up ? f.to : f.from, enter = up ? f.from : f.to;
            if (up ? leave < phi0 || enter > phi1 : leave > phi0 || enter < phi1) continue;
            const bool last = up ? leave >= phi1 : leave <= phi1;
            const double next = last ? psi1 : std::max(psi, psi_at(leave, before));
            feature_link(f, psi, next);
            psi = next;
        }
    };
    run(0, turn, true);
    run(turn, pi, false);
}

/// The outline's point on a torus for the normal at `psi`.
struct SweepRays::TorusPoint {
    Vec2 radial = Vec2::Zero(), swing = Vec2::Zero(); ///< towards its side; by how much that turns with psi
    double c = 0, slope = 0;                          ///< offset, and by how much it grows with psi
};

SweepRays::TorusPoint SweepRays::torus_point(const Link& link, double side, const Angle& psi) const {
    const Vec2 m = across_.head<2>(), k = out_.head<2>();
    const Vec2 h = -psi.cosine * m + side * psi.sine * k, turn = psi.sine * m + side * psi.cosine * k;
    TorusPoint at;
    if (const double away = h.norm(); away > 0) {
        at.radial = h / away;
        at.swing = (turn - at.radial.dot(turn) * at.radial) / away;
    }
    at.c = link.e * at.radial.dot(m) + link.middle_c - link.r * psi.cosine;
    at.slope = link.e * at.swing.dot(m) + link.r * psi.sine;
    return at;
}

/// psi at offset `c`, sought from `cosine` on, and the outline's point there.
SweepRays::TorusPoint SweepRays::find_on_torus(const Link& link, double side, double c, double cosine,
                                               Angle& psi) const {
    // c(psi) grows; Newton's method kept within a bracket.
    double low = link.p0, high = link.p1;
    psi = {cosine, std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)))};
    const double noise =
        std::numeric_limits<double>::epsilon() * (std::abs(link.e) + link.r + std::abs(link.middle_c));
    TorusPoint at;
    for (int i = 0; i < 100; ++i) {
        const Vec2 before = at.radial;
        at = torus_point(link, side, psi);
        if (at.radial.isZero(0)) at.radial = before;
        const double miss = at.c - c;
        if (std::abs(miss) <= noise) break;
        (miss > 0 ? high : low) = psi.place();
        const double step = at.slope > 0 ? -miss / at.slope : infinity;
        if (std::abs(step) <= tolerance::unit_rounding) break;
        const Angle next = psi.turned(step);
        const double p = next.place();
        const bool within = std::abs(step) < 1 && next.sine > 0 && p > low && p < high;
        psi = within ? next : Angle::at(0.5 * (low + high));
        if (within && std::abs(step) * std::max(1.0, at.swing.norm()) <= tolerance::last_newton_step) {
            at.radial += step * at.swing; // off by the square of the step
            break;
        }
    }
    return at;
}

/// What Newton's method starts from: cosines of psi at offsets equally far apart, and how they change from
/// one to the next.
void SweepRays::tabulate_torus(Link& link, double side) {
    link.first = starts_.size();
    link.cells = std::max(1, int(std::ceil((link.p1 - link.p0) * cells_a_right_angle)));
    const double step = (link.c1 - link.c0) / link.cells;
    for (int i = 0; i <= link.cells; ++i) {
        Start start{i == 0 ? link.cos0 : link.cos1, infinity};
        if (i > 0 && i < link.cells) {
            Angle psi{};
            const double between = link.cos0 + (link.cos1 - link.cos0) * i / link.cells;
            const TorusPoint at = find_on_torus(link, side, link.c0 + i * step, between, psi);
            start = {psi.cosine, at.slope > 0 ? -psi.sine / at.slope * step : infinity};
        }
        starts_.push_back(start);
    }
    // At the ends both change and sine may be 0: as of a parabola.
    for (int i = 0; i <= link.cells; ++i) {
        Start* const s = starts_.data() + link.first + i;
        if (std::isfinite(s->change)) continue;
        const int before = i > 0 ? -1 : 0, after = i < link.cells ? 1 : 0;
        const double chord = (s[after].cosine - s[before].cosine) / (after - before);
        const double beyond = before == 0 ? s[after].change : after == 0 ? s[before].change : chord;
        s->change = std::isfinite(beyond) ? 2 * chord - beyond : chord;
    }
}

SweepRays::Touch SweepRays::touch_torus(const Link& link, double side, double c) const {
    const double place = (c - link.c0) / (link.c1 - link.c0) * link.cells;
    const int cell = std::clamp(int(place), 0, link.cells - 1);
    const Start &a = starts_[link.first + std::size_t(cell)],
                &b = starts_[link.first + std::size_t(cell) + 1];
    const double t = place - cell, rise = b.cosine - a.cosine;
    const double bend = t * (1 - t) * ((1 - t) * (a.change - rise) - t * (b.change - rise));
    Angle psi{};
    const double start = std::clamp(a.cosine + t * rise + bend, link.cos1, link.cos0);
    const TorusPoint at = find_on_torus(link, side, c, start, psi);
    return {link.e * at.radial.dot(out_.head<2>()) + link.middle_y + side * link.r * psi.sine,
            link.e * at.radial.dot(along_.head<2>()) + link.middle_l};
}

SweepRays::Touch SweepRays::touch(const std::vector<Link>& chain, double side, double c) const {
    const Link* link = chain.data();
    const Link* const last = link + chain.size() - 1;
    while (link < last && c > link->c1)
        ++link;
    if (link->kind == Link::Kind::line) {
        const double t = c - link->c0;
        return {link->y0 + t * link->slope_y, link->l0 + t * link->slope_l};
    }
    if (link->kind == Link::Kind::torus) return touch_torus(*link, side, std::clamp(c, link->c0, link->c1));
    const double cosine = std::clamp((c - link->middle_c) * link->scale, -1.0, 1.0);
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return {link->middle_y + link->cos_y * cosine + link->sin_y * sine,
            link->middle_l + link->cos_l * cosine + link->sin_l * sine};
}

Stretch SweepRays::at_end(const Vec3& p, bool last) const {
    const Vec3 local = frame_ * (p - from_) - (last ? length_ : 0.0) * along_;
    return body_->along(local, u_);
}

Stretch SweepRays::operator()(const Vec3& p, double low, double high) const {
    if (misses(p, low, high)) return {};
    if (parallel_) {
        Stretch s = at_end(p, false);
        const double shift = length_ * u_along_;
        s.lo += std::min(0.0, shift);
        s.hi += std::max(0.0, shift);
        return s;
    }
    if (exit_.empty()) return {};
    const Vec3 local = p - from_;
    const double c = local.dot(world_across_);
    if (!(c >= exit_.front().c0 && c <= exit_.back().c1)) return {};
    const double y = local.dot(world_out_), l = local.dot(world_along_);
    const Touch entry = touch(entry_, -1, c), exit = touch(exit_, 1, c);
    Stretch result{(entry.y - y) / sine_, (exit.y - y) / sine_};
    // The tool that had moved for ever would not reach it either.
    if (result.lo >= high || result.hi <= low) return {};
    const double entry_at = l + result.lo * u_along_ - entry.l, exit_at = l + result.hi * u_along_ - exit.l;
    const int entry_end = entry_at < 0 ? -1 : entry_at > length_ ? 1 : 0;
    const int exit_end = exit_at < 0 ? -1 : exit_at > length_ ? 1 : 0;
    if (entry_end == 0 && exit_end == 0) return result;
    // The body at the nearer end instead. An end that is beyond what matters is as good at the other end of
    // the motion, where that is asked for anyway and is beyond as well.
    Stretch first, second;
    const bool apart = entry_end != 0 && exit_end != 0 && entry_end != exit_end;
    if (apart) {
        // First the end that the motion leads to: what is behind the tool is most often gone.
        Stretch& ahead = second;
        ahead = at_end(p, true);
        const bool enough = !ahead.empty() && (entry_end > 0 ? ahead.hi >= high : ahead.lo <= low);
        if (enough) return ahead;
        first = at_end(p, false);
    } else {
        if (entry_end < 0 || exit_end < 0) first = at_end(p, false);
        if (entry_end > 0 || exit_end > 0) second = at_end(p, true);
    }
    if (entry_end != 0) result.lo = (entry_end < 0 ? first : second).lo;
    if (exit_end != 0) result.hi = (exit_end < 0 ? first : second).hi;
    return result;
}

CutterLocation location_between(const CutterLocation& from, const CutterLocation& to,
                                const std::optional<TurningAxis>& turning, double s) {
    if (s <= 0) return from;
    if (s >= 1) return to;
    if (turning && from.axis != to.axis) {
        // Turns about the part's axis, and moves along and towards it, in proportion.
        const Vec3& d = turning->direction;
        const auto radial = [&](const Vec3& v) { return Vec3(v - v.dot(d) * d); };
        const Vec3 a = radial(from.axis), b = radial(to.axis);
        const double angle = std::atan2(d.dot(a.cross(b)), a.dot(b));
        const auto turned = [&](double by, const Vec3& v) { return Vec3(Eigen::AngleAxisd(by, d) * v); };
        const Vec3 start = from.tip - turning->point, stop = turned(-angle, to.tip - turning->point);
        const Vec3 tip = turning->point + turned(s * angle, start + s * (stop - start));
        const Vec3 back = turned(-angle, to.axis);
        return {tip, turned(s * angle, Vec3(from.axis + s * (back - from.axis)).normalized())};
    }
    const Vec3 tip = from.tip + s * (to.tip - from.tip);
    if (from.axis == to.axis) return {tip, from.axis};
    const Vec3 cross = from.axis.cross(to.axis);
    const double sine = cross.norm(), angle = std::atan2(sine, from.axis.dot(to.axis));
    if (!(sine > tolerance::unit_rounding)) {
        if (from.axis.dot(to.axis) > 0) return {tip, from.axis};
        throw Error(ErrorCode::out_of_range, "tool axis", "turns by half a turn in one motion",
                    "add a CL between, which says in which plane it turns");
    }
    return {tip, Eigen::AngleAxisd(s * angle, cross / sine) * from.axis};
}

double angle_turned(const Vec3& from, const Vec3& to, const std::optional<TurningAxis>& turning) {
    const double angle = angle_between(from, to);
    if (!turning) return angle;
    const Vec3& d = turning->direction;
    return std::max(angle, angle_between(Vec3(from - from.dot(d) * d), Vec3(to - to.dot(d) * d)));
}

std::size_t pieces_of_turn(double angle, double lever, double reach, double bound) {
    // With the axis of the middle a point at `reach` is off by reach * angle / 2 at the ends; the tip's arc
    // leaves its chord by lever * angle^2 / 8.
    const auto off = [&](double part) { return 0.5 * reach * part + 0.125 * lever * part * part; };
    auto n = std::size_t(std::ceil(std::max(1.0, 0.5 * reach * angle / bound)));
    while (off(angle / double(n)) > bound)
        n += 1 + n / 8;
    return n;
}

void straight_moves(const CutterLocation& from, const CutterLocation& to,
                    const std::optional<TurningAxis>& turning, double s0, double s1, double reach,
                    double bound, std::vector<StraightMove>& moves) {
    const auto at = [&](double s) { return location_between(from, to, turning, s); };
    const CutterLocation first = at(s0), last = at(s1);
    if (from.axis == to.axis) {
        moves.push_back({first.tip, last.tip, from.axis});
        return;
    }
    const double angle = angle_turned(first.axis, last.axis, turning);
    double lever = 0; // of the tip about the turning axis
    if (turning) {
        const auto distance = [&](const Vec3& tip) {
            const Vec3 v = tip - turning->point;
            return (v - v.dot(turning->direction) * turning->direction).norm();
        };
        lever = std::max(distance(first.tip), distance(last.tip));
    }
    const std::size_t n = pieces_of_turn(angle, lever, reach, bound);
    CutterLocation before = first;
    for (std::size_t i = 1; i <= n; ++i) {
        const CutterLocation next = i == n ? last : at(s0 + (s1 - s0) * double(i) / double(n));
        moves.push_back({before.tip, next.tip, at(s0 + (s1 - s0) * (double(i) - 0.5) / double(n)).axis});
        before = next;
    }
}

} // namespace facetmill
