#include "core/cspace/cm2.h"

#include "core/base/tolerances.h"
#include "core/gouge/tool_lift.h"

#include <array>
#include <cmath>

namespace facetmill {

double cutter_curvature_across(const CutterProfile& cutter, double lead) {
    const ProfilePiece& first = cutter.lower_pieces().front();
    const bool ball = first.kind == ProfilePiece::Kind::arc
                      && std::abs(first.center.x()) <= tolerance::cutter_tangency * first.radius;
    if (ball && lead <= first.angle_at_end()) return 1 / first.radius;
    const double rho = plane_contact(cutter, lead).x();
    return rho > 0 ? std::sin(lead) / rho : infinity;
}

namespace {

/// A circle of the cutter that touches planes that lean from `from` to `to`: at distance e + r sin(lead) from
/// the axis.
struct TouchingCircle {
    double e, r, from, to;

    /// The smallest lead in it and from `lo` on with sin(lead) >= kappa (e + r sin(lead)); infinity for none.
    double lead(double kappa, double lo) const {
        const double start = std::max(lo, from);
        if (!(start <= to)) return infinity;
        // That is sin(lead) (1 - kappa r) >= kappa e; for a ball the sine does not matter.
        const double factor = 1 - kappa * r;
        if (std::abs(e) <= tolerance::cutter_tangency * r) return factor >= 0 ? start : infinity;
        if (std::sin(start) * factor >= kappa * e) return start;
        if (!(factor > 0)) return infinity; // more lead only makes it worse
        const double sine = kappa * e / factor;
        if (!(sine <= 1)) return infinity;
        const double lead = std::asin(sine);
        return lead <= to ? std::max(lead, start) : infinity;
    }
};

} // namespace

double cm2_lead(const CutterProfile& cutter, double kappa, double lead_lo, double lead_hi) {
    if (!(kappa > 0)) kappa = 0;
    const auto pieces = cutter.lower_pieces();
    // From the outer end of the bottom line outward: corner circle, joints, and the rim, which leans on to
    // the side.
    double angle = pieces.front().kind == ProfilePiece::Kind::line ? pieces.front().angle_at_start() : 0;
    double best = infinity;
    for (std::size_t i = 0; i < pieces.size() && !(best < infinity); ++i) {
        const ProfilePiece& p = pieces[i];
        if (p.kind == ProfilePiece::Kind::arc) {
            best = TouchingCircle{p.center.x(), p.radius, p.angle_at_start(), p.angle_at_end()}.lead(kappa,
                                                                                                     lead_lo);
            angle = p.angle_at_end();
        }
        const double next = i + 1 < pieces.size() ? pieces[i + 1].angle_at_start() : pi / 2;
        if (!(best < infinity) && next > angle + tolerance::cutter_angle)
            best = TouchingCircle{p.to.x(), 0, angle, next}.lead(kappa, lead_lo);
        angle = std::max(angle, next);
    }
    return std::clamp(best, lead_lo, lead_hi);
}

double normal_curvature(const VertexCurvature& at, const Vec3& direction) {
    const double x = at.direction1.dot(direction), y = at.direction2.dot(direction), square = x * x + y * y;
    if (!(square > tolerance::vanishing_sum * direction.squaredNorm())) return 0.5 * (at.k1 + at.k2);
    return (at.k1 * x * x + at.k2 * y * y) / square;
}

double hollowness(const Mesh& mesh, std::span<const VertexCurvature> curvatures, Index facet,
                  const Vec3& point, const Vec3& direction) {
    // Barycentric coordinates; of a facet without area those along its longest edge would do, but then its
    // corners are as good as alike: equal parts.
    const Vec3 normal = mesh.facet_cross(facet);
    const double area = normal.squaredNorm();
    std::array<double, 3> share{1, 1, 1};
    if (area > 0)
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = mesh.corner(facet, (k + 1) % 3) - point,
                       b = mesh.corner(facet, (k + 2) % 3) - point;
            share[std::size_t(k)] = std::clamp(a.cross(b).dot(normal) / area, 0.0, 1.0);
        }
    double sum = 0, weight = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double curvature = normal_curvature(curvatures[mesh.facets[facet][k]], direction);
        if (!std::isfinite(curvature)) continue;
        sum += share[k] * curvature;
        weight += share[k];
    }
    return weight > 0 ? -sum / weight : 0;
}

} // namespace facetmill
