#include "core/gouge/vector_elements.h"
#include "core/base/plane_geometry.h"

#include "core/base/tolerances.h"

#include <array>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

/// The distance from 1 to the next double: bounds of rounding are multiples of it.
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int max_steps = 200; // a guard only: steps halve an interval of doubles at worst

/// Value and slope of a convex function along the line.
struct Slope {
    double value, slope;
};

/// Ends the interval [lo, hi] of the line where the convex function `f` becomes positive for good. False when
/// it is positive on the whole interval. `guess` is the place by a closed form, or not-a-number; `trust`: the
/// closed form is as good as Newton's.
template <class F>
bool end_where_positive(double lo, double& hi, double guess, bool trust, bool& moved, F&& f) {
    Slope at = f(hi);
    if (at.value <= 0) return true;
    moved = true;
    double s = hi;
    if (guess < hi && guess >= lo) {
        s = guess;
        if (trust) {
            hi = s;
            return true;
        }
        // One step of Newton's from either side lands above the place, because f is convex.
        const Slope there = f(s);
        if (there.slope > 0) {
            const double next = s - there.value / there.slope;
            if (there.value <= 0 ? next <= s : next >= s) {
                hi = s;
                return true;
            }
            if (next < hi) {
                s = next;
                at = f(s);
            } else {
                s = hi;
            }
        } else {
            s = hi;
        }
    }
    // From above Newton's steps never pass the place.
    for (int i = 0; i < max_steps && at.value > 0; ++i) {
        if (!(at.slope > 0)) return false;
        const double next = s - at.value / at.slope;
        if (next < lo) return false;
        if (!(next < s)) break;
        s = next;
        at = f(s);
    }
    hi = s;
    return s >= lo;
}

/// How far inside of an arc's range of normals, or beyond it, a point of the half-plane is: the largest n .
/// (p - centre) - r over the normals n of the arc. Convex.
struct ArcDistance {
    double value, nr, nz;
    bool in_range;
};
ArcDistance arc_distance(const RevolvedBody::Piece& p, double rho, double z) {
    const double dr = rho - p.e, dz = z - p.f;
    const bool after = p.nr0 * dz - p.nz0 * dr >= 0, before = dr * p.nz1 - dz * p.nr1 >= 0;
    if (after && before && (p.nr0 + p.nr1) * dr + (p.nz0 + p.nz1) * dz > 0) {
        const double distance = std::sqrt(dr * dr + dz * dz);
        return {distance - p.r, dr / distance, dz / distance, true};
    }
    const double start = p.nr0 * dr + p.nz0 * dz, end = p.nr1 * dr + p.nz1 * dz;
    return start > end ? ArcDistance{start - p.r, p.nr0, p.nz0, false}
                       : ArcDistance{end - p.r, p.nr1, p.nz1, false};
}

/// How far a point of the line q - s w is outside of what a line or an arc of the profile bounds.
Slope distance_on_line(const RevolvedBody::Piece& p, const LiftVector& w, const Vec3& q, double s) {
    const double x = q.x() - s * w.wx, z = q.z() - s * w.wz, rho = std::sqrt(x * x + q.y() * q.y());
    const double rho_slope = rho > 0 ? -w.wx * x / rho : 0;
    if (!p.arc) return {p.nr0 * (rho - p.rho0) + p.nz0 * (z - p.z0), p.nr0 * rho_slope - p.nz0 * w.wz};
    const ArcDistance d = arc_distance(p, rho, z);
    return {d.value, d.nr * rho_slope - d.nz * w.wz};
}

/// Lift over a point whose line is parallel to the axis.
VectorElement lift_along_axis(const RevolvedBody& body, const LiftVector& w, const Vec3& q) {
    const double square = q.x() * q.x() + q.y() * q.y(), radius = body.max_radius();
    if (!(square <= radius * radius)) return {};
    const double rho = std::min(std::sqrt(square), radius);
    const RevolvedBody::Support s = w.wz > 0 ? body.lowest(rho) : body.highest(rho);
    return {(q.z() - s.z) / w.wz, q, s.piece};
}

/// The same for a line across the axis: the section of the body is a disc.
VectorElement lift_across_axis(const RevolvedBody& body, const LiftVector& w, const Vec3& q) {
    if (!(q.z() >= body.bottom() && q.z() <= body.top())) return {};
    const RevolvedBody::Section section = body.section(q.z());
    if (!(std::abs(q.y()) <= section.rho)) return {};
    return {(q.x() + leg_length(section.rho, q.y())) / w.wx, q, section.piece};
}

/// The section of a body by the plane through an edge and along w, in axes that turn the plane's normal into
/// the x, z plane.
struct Slice {
    double m1x, m1z, c;   ///< plane: m1x x + m1z z = c, m1x >= 0
    double e2x, e2y, e2z; ///< unit vector in the plane across the edge, away from w; e2y >= 0
    double dx, dy, dz;    ///< unit vector along the edge
    double touch;         ///< distance from the plane that counts as in it
};

/// Points of a section that may be the farthest along e2: all of them lie on the body's surface and in the
/// plane, so none is farther than the farthest, whichever pieces they come from.
struct Candidates {
    struct Point {
        double value, x, y, z;
        unsigned piece;
    };
    std::array<Point, 4 * RevolvedBody::max_pieces + 2> points;
    std::size_t count = 0;

    void add(const Slice& k, double x, double y, double z, unsigned piece) {
        points[count++] = {k.e2x * x + k.e2y * y + k.e2z * z, x, y, z, piece};
    }
};

/// Lu 3.172-3.175: the two points in which a circle of the surface meets the plane.
void try_circle(const Slice& k, const RevolvedBody::Circle& circle, Candidates& found) {
    const double reach = k.m1x * circle.rho, away = k.c - k.m1z * circle.z;
    if (std::abs(away) > reach + k.touch) return;
    double x;
    if (reach > k.touch) {
        x = std::clamp(away / k.m1x, -circle.rho, circle.rho);
    } else { // the whole circle lies in the plane
        const double level = std::sqrt(k.e2x * k.e2x + k.e2y * k.e2y);
        x = level > 0 ? circle.rho * (k.e2x / level) : circle.rho;
    }
    const double y = leg_length(circle.rho, x);
    found.add(k, x, y, circle.z, circle.piece);
    if (y > 0) found.add(k, x, -y, circle.z, circle.piece);
}

/// Lu 3.148-3.155 for cone and taper: a cone's normals are constant along its generators, so the condition
/// that the normal is across the edge gives the two generators, and the plane the point on each.
void try_cone(const Slice& k, const RevolvedBody::Piece& p, unsigned piece, Candidates& found) {
    const double level = std::sqrt(k.dx * k.dx + k.dy * k.dy);
    if (!(level > 0)) return; // the edge is parallel to the axis: its ends and the circles have it
    const double ratio = -p.nz0 * k.dz / (p.nr0 * level);
    if (!(std::abs(ratio) <= 1)) return;
    const double ux = k.dx / level, uy = k.dy / level, side = leg_length(1, ratio);
    for (const double sign : {1.0, -1.0}) {
        const double cosine = ratio * ux - sign * side * uy, sine = ratio * uy + sign * side * ux;
        const double at0 = k.m1x * p.rho0 * cosine + k.m1z * p.z0;
        const double at1 = k.m1x * p.rho1 * cosine + k.m1z * p.z1;
        const double t = (k.c - at0) / (at1 - at0);
        if (!(t >= 0 && t <= 1)) continue;
        const double rho = p.rho0 + t * (p.rho1 - p.rho0);
        found.add(k, rho * cosine, rho * sine, p.z0 + t * (p.z1 - p.z0), piece);
    }
}

/// An arc about the axis: the section of a sphere is a circle.
void try_sphere(const Slice& k, const RevolvedBody::Piece& p, unsigned piece, Candidates& found) {
    const double away = k.c - k.m1z * p.f;
    if (!(std::abs(away) <= p.r)) return;
    const double out = leg_length(p.r, away), z = p.f + away * k.m1z + out * k.e2z;
    if (z < p.z0 || z > p.z1) return;
    found.add(k, away * k.m1x + out * k.e2x, out * k.e2y, z, piece);
}

/// A torus (Lu 3.161-3.169, which ask for a fourfold root; a tangent is a double one): normals across the
/// edge are m(phi) = cos(phi) e2 + sin(phi) m1, and the distance of the point with that normal from the
/// edge's plane never falls with phi, because the hull of the torus is convex. So its zero is found by
/// Newton's steps that are kept inside a bracket. e < 0 makes a body with points at both ends.
void try_torus(const Slice& k, const RevolvedBody::Piece& p, unsigned piece, Candidates& found) {
    const double end = p.e < 0 ? leg_length(p.r, p.e) : 0; // half the distance between those points
    struct OnTorus {
        double value, slope, x, y, z, rho;
    };
    const auto place = [&](double cosine, double sine) {
        const double mx = cosine * k.e2x + sine * k.m1x, my = cosine * k.e2y,
                     mz = cosine * k.e2z + sine * k.m1z;
        const double mr = std::sqrt(mx * mx + my * my), rho = p.e + p.r * mr;
        if (rho <= 0 || mr == 0) { // a pointed end, or the middle of the flat of the hull
            const double z = p.f + (p.e < 0 ? std::copysign(end, mz) : p.r * mz);
            return OnTorus{k.m1z * z - k.c, 0, 0, 0, z, std::max(0.0, rho)};
        }
        const double x = rho * mx / mr, y = rho * my / mr, z = p.f + p.r * mz;
        const double turn = k.e2y * k.e2y * k.m1x * k.m1x * cosine / (mr * mr * mr);
        return OnTorus{k.m1x * x + k.m1z * z - k.c, p.r * cosine + p.e * turn, x, y, z, rho};
    };
    double lo = -0.5 * pi, hi = 0.5 * pi;
    if (place(0, -1).value > 0 || place(0, 1).value < 0) return;
    double phi = std::asin(std::clamp((k.c - k.m1z * p.f) / (p.r + std::abs(p.e) * k.m1x), -1.0, 1.0));
    OnTorus at{};
    double last_width = infinity;
    for (int i = 0; i < max_steps; ++i) {
        at = place(std::cos(phi), std::sin(phi));
        if (at.value == 0) break;
        (at.value < 0 ? lo : hi) = phi;
        double next = phi - at.value / at.slope;
        // Newton's, unless it leaves the bracket or three steps have not halved it.
        const bool slow = i % 3 == 2 && hi - lo > 0.5 * last_width;
        if (i % 3 == 2) last_width = hi - lo;
        if (!(next > lo && next < hi) || (slow && std::abs(next - phi) > epsilon))
            next = lo + 0.5 * (hi - lo);
        if (next == phi || !(next > lo && next < hi)) break;
        phi = next;
    }
    if (at.z < p.z0 || at.z > p.z1) return;
    // Near the flat of the hull the place may be some way off the plane, or the zero a jump over the flat:
    // then what counts is where the circle through it meets the plane.
    if (std::abs(at.value) <= k.touch)
        found.add(k, at.x, at.y, at.z, piece);
    else
        try_circle(k, {at.rho, at.z, piece}, found);
}

} // namespace

VectorElement vector_vertex_lift(const RevolvedBody& body, const LiftVector& w, const Vec3& q) {
    if (w.wx == 0) return lift_along_axis(body, w, q);
    if (w.wz == 0) return lift_across_axis(body, w, q);
    // The line q - s w: first the cylinder of the largest radius, then bottom and top, then cones and arcs.
    // The body is their common part, so each only shortens the interval.
    const double radius = body.max_radius();
    if (!(std::abs(q.y()) <= radius)) return {};
    const double half = leg_length(radius, q.y());
    double lo = (q.x() - half) / w.wx, hi = (q.x() + half) / w.wx;
    unsigned piece = 0;
    const auto pieces = body.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (std::max(pieces[i].rho0, pieces[i].rho1) >= radius) piece = unsigned(i);
    const double down = (q.z() - body.bottom()) / w.wz, up = (q.z() - body.top()) / w.wz;
    lo = std::max(lo, std::min(down, up));
    const double slab = std::max(down, up);
    if (slab < hi) {
        hi = slab;
        piece = w.wz > 0 ? 0 : unsigned(pieces.size() - 1);
    }
    const double touch = tolerance::touch_roundings * epsilon
                         * (radius + std::abs(q.x()) + std::abs(q.y()) + std::abs(q.z())
                            + std::min(std::abs(lo), std::abs(hi)));
    if (hi < lo - touch) return {};
    lo = std::min(lo, hi) - touch;

    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const RevolvedBody::Piece& p = pieces[i];
        bool moved = false;
        const auto distance = [&](double s) { return distance_on_line(p, w, q, s); };
        if (p.arc) {
            double guess = std::numeric_limits<double>::quiet_NaN();
            if (p.e == 0) {
                const Vec3 from = q - Vec3(0, 0, p.f);
                const double along = w.wx * from.x() + w.wz * from.z();
                const Vec3 nearest = from - along * w.vec();
                const double away = nearest.norm();
                if (away <= p.r) {
                    guess = along + leg_length(p.r, away);
                    const double rho = std::hypot(q.x() - guess * w.wx, q.y());
                    if (!arc_distance(p, rho, q.z() - guess * w.wz).in_range)
                        guess = std::numeric_limits<double>::quiet_NaN();
                }
            }
            if (!end_where_positive(lo, hi, guess, true, moved, distance)) return {};
        } else if (p.nr0 > 0 && p.nz0 != 0) {
            // Lu 3.128-3.134 and 3.138-3.144, from the point at the present end: (x - t wx)^2 + y^2 = (k0 +
            // k1 t)^2; the sign of 3.131 put right.
            const double x = q.x() - hi * w.wx, k1 = p.nz0 / p.nr0 * w.wz,
                         k0 = p.rho0 - p.nz0 / p.nr0 * (q.z() - hi * w.wz - p.z0);
            const double a = w.wx * w.wx - k1 * k1, b = x * w.wx + k0 * k1,
                         c = x * x + q.y() * q.y() - k0 * k0;
            const double root = std::sqrt(b * b - a * c);
            const double guess = hi + (b > 0 ? (b + root) / a : c / (b - root));
            if (!end_where_positive(lo, hi, guess, false, moved, distance)) return {};
        }
        if (moved) piece = unsigned(i);
    }
    // What the later pieces took away may have been all that the earlier ones left.
    for (const RevolvedBody::Piece& p : pieces)
        if (!p.level() && distance_on_line(p, w, q, hi).value > touch) return {};
    return {hi, q, piece};
}

VectorElement vector_edge_lift(const RevolvedBody& body, const LiftVector& w, const Vec3& a, const Vec3& b,
                               double& along) {
    along = std::numeric_limits<double>::quiet_NaN();
    const Vec3 run = b - a;
    const double length = run.norm();
    if (!(length > 0)) return {};
    const Vec3 d = run / length;
    Vec3 m1 = d.cross(w.vec());
    const double sine = m1.norm();
    if (!(sine > 0)) return {}; // along w: the higher end has the lift
    m1 /= sine;
    const Vec3 e2 = d.cross(m1).normalized(); // e2 . w = -sine
    // Turned about the axis until m1 has no y, and mirrored until e2's y is not negative.
    Slice k{};
    k.m1x = std::sqrt(m1.x() * m1.x() + m1.y() * m1.y());
    const double ux = k.m1x > 0 ? m1.x() / k.m1x : 1, uy = k.m1x > 0 ? m1.y() / k.m1x : 0;
    k.m1z = m1.z();
    k.e2x = ux * e2.x() + uy * e2.y();
    k.e2y = ux * e2.y() - uy * e2.x();
    k.e2z = e2.z();
    k.dx = ux * d.x() + uy * d.y();
    k.dy = ux * d.y() - uy * d.x();
    k.dz = d.z();
    const double mirror = k.e2y < 0 ? -1 : 1;
    k.e2y *= mirror;
    k.dy *= mirror;
    k.c = m1.dot(a);
    k.touch = tolerance::touch_roundings * epsilon * (a.norm() + length + body.max_radius());

    Candidates found;
    for (const RevolvedBody::Circle& circle : body.circles())
        try_circle(k, circle, found);
    const auto pieces = body.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const RevolvedBody::Piece& p = pieces[i];
        if (p.level()) continue; // its circles have it
        if (!p.arc)
            try_cone(k, p, unsigned(i), found);
        else if (p.e == 0)
            try_sphere(k, p, unsigned(i), found);
        else
            try_torus(k, p, unsigned(i), found);
    }
    if (found.count == 0) return {};
    const auto from = found.points.begin(), to = from + std::ptrdiff_t(found.count);
    const auto best =
        std::max_element(from, to, [](const auto& p, const auto& q) { return p.value < q.value; });
    // As far but for rounding: where a flat or a generator lies along the edge, all between two such points
    // touches.
    double first = infinity, last = -infinity;
    for (auto c = from; c != to; ++c)
        if (c->value >= best->value - k.touch) {
            const double place = k.dx * (c->x - best->x) + k.dy * (c->y - best->y) + k.dz * (c->z - best->z);
            first = std::min(first, place);
            last = std::max(last, place);
        }
    const Vec3 p(ux * best->x - uy * mirror * best->y, uy * best->x + ux * mirror * best->y, best->z);
    double lift = e2.dot(p - a) / sine;
    const double at_best = d.dot(p + lift * w.vec() - a);
    const double place = std::clamp(std::clamp(at_best, 0.0, length), at_best + first, at_best + last);
    along = place / length;
    // Beyond an end by no more than may be rounding, the end is touched, which rounding may see pass the body
    // by. Sliding along d the line comes `sine` times the way nearer to where it was.
    const double on_edge = std::clamp(place, 0.0, length);
    if (std::abs(place - on_edge) * sine > k.touch) return {};
    lift += (on_edge - place) * d.dot(w.vec());
    return {lift, a + std::clamp(along, 0.0, 1.0) * run, best->piece};
}

VectorElement vector_facet_lift(const RevolvedBody& body, const LiftVector& w, const Vec3& a_in,
                                const Vec3& b_in, const Vec3& c_in, double none_above, int& feature) {
    feature = 0;
    // Edge a to b is the longest.
    const double ab = (b_in - a_in).squaredNorm(), bc = (c_in - b_in).squaredNorm(),
                 ca = (a_in - c_in).squaredNorm();
    const int turn = ab >= bc && ab >= ca ? 0 : bc >= ca ? 1 : 2;
    const Vec3 &a = turn == 0   ? a_in
                    : turn == 1 ? b_in
                                : c_in,
               &b = turn == 0   ? b_in
                    : turn == 1 ? c_in
                                : a_in,
               &c = turn == 0   ? c_in
                    : turn == 1 ? a_in
                                : b_in;
    const std::array<const Vec3*, 3> corner{&a, &b, &c};

    VectorElement best;
    const auto take = [&](const VectorElement& one, int of_feature) {
        if (!(one.lift > best.lift)) return;
        best = one;
        feature = of_feature;
    };

    const Vec3 u = b - a, v = c - a;
    const double longest = u.norm();
    // Which of the edges may hold the contact: 0 is that from a to b.
    std::array<bool, 3> ask{true, true, true};
    bool trusted = false;
    double highest = infinity; // no point of the facet asks for more than its plane, but for rounding
    if (longest > 0) {
        // Height of the triangle over its longest edge, exactly across that edge: so a needle's plane may be
        // turned about the edge by rounding, but does not leave it.
        const Vec3 along = u / longest;
        double foot = along.dot(v);
        Vec3 across = v - foot * along;
        const double rest = along.dot(across); // rounding of the first step, no longer small on a needle
        foot += rest;
        across -= rest * along;
        const double height = across.norm();
        const double size = std::max(
            {a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff(), body.max_radius()});
        const double noise = tolerance::touch_roundings * epsilon * size;
        if (height > noise) {
            Vec3 n = along.cross(across) / height;
            double climb = n.dot(w.vec());
            if (climb < 0) {
                n = -n;
                climb = -climb;
            }
            if (climb > 0) {
                const double mr = std::sqrt(n.x() * n.x() + n.y() * n.y());
                const RevolvedBody::Support s = body.support(mr, -n.z());
                const double out = mr > 0 ? -s.rho / mr : 0;
                const Vec3 p(out * n.x(), out * n.y(), s.z);
                const double lift = n.dot(a - p) / climb;
                // A plane that is sure to be far nearer to the truth than the facet is wide, and not seen
                // edge-on.
                trusted = climb > tolerance::edge_on
                          && noise * (body.max_radius() + longest) < tolerance::plane_trust * height * height;
                if (trusted) {
                    highest = lift + tolerance::touch_roundings * noise / climb;
                    if (highest <= none_above) return {};
                }
                const Vec3 q = p + lift * w.vec() - a;
                const double y = q.dot(across) / (height * height);
                const double x = (q.dot(along) - y * foot) / longest;
                const std::array<double, 3> share{1 - x - y, x, y};
                if (share[0] >= 0 && share[1] >= 0 && share[2] >= 0) {
                    take({lift, a + x * u + y * v, s.piece}, 3);
                    if (trusted) return best;
                } else if (trusted) {
                    // The lift is concave on the facet: on the way to the plane's contact it does not fall,
                    // so the highest lift lies on an edge that this way can leave by.
                    for (std::size_t i = 0; i < 3; ++i)
                        ask[i] = share[(i + 2) % 3] < tolerance::plane_trust;
                }
            }
        }
    }
    std::array<bool, 3> ask_corner{false, false, false};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!ask[i]) continue;
        const std::size_t next = (i + 1) % 3;
        double place;
        const VectorElement edge = vector_edge_lift(body, w, *corner[i], *corner[next], place);
        take(edge, 2);
        // Both ends, unless the contact is well inside: then no end has more.
        const bool inside = place >= tolerance::plane_trust && place <= 1 - tolerance::plane_trust;
        if (!trusted || !inside) ask_corner[i] = ask_corner[next] = true;
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (ask_corner[i]) take(vector_vertex_lift(body, w, *corner[i]), 1);
    best.lift = std::min(best.lift, highest); // so that what was skipped by it is surely nothing more
    return best;
}

} // namespace facetmill
