// Curvature at vertices: Meyer's operators for mean and Gaussian, a height function fitted for the principal
// ones.
#include "core/base/parallel.h"
#include "core/base/plane_geometry.h"
#include "core/base/tolerances.h"
#include "core/mesh/geometry.h"
#include "core/mesh/geometry_incidence.h"
#include "core/mesh/normal_equations.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// Neighbours with more facets than this are hubs of fans; what lies beyond them is not near.
constexpr std::size_t hub = 64;

VertexCurvature nothing() {
    const Vec3 none = Vec3::Constant(nan);
    return {nan, nan, none, none, nan, nan, nan};
}

/// Corners after and before `vertex` in the facet's order.
struct RingEdge {
    Index from, to;
};

RingEdge ring_edge(const Facet& f, Index vertex) {
    const std::size_t k = f[0] == vertex ? 0 : f[1] == vertex ? 1 : 2;
    return {f[(k + 1) % 3], f[(k + 2) % 3]};
}

/// True if the facets close round the vertex in one fan, all wound alike: their outer edges form one directed
/// loop.
bool closed_fan(const std::vector<RingEdge>& sorted_by_from) {
    const std::size_t n = sorted_by_from.size();
    if (n < 3) return false;
    for (std::size_t i = 1; i < n; ++i)
        if (sorted_by_from[i].from == sorted_by_from[i - 1].from) return false;
    const Index first = sorted_by_from[0].from;
    Index at = first;
    for (std::size_t steps = 1; steps <= n; ++steps) {
        const auto it = std::lower_bound(sorted_by_from.begin(), sorted_by_from.end(), at,
                                         [](const RingEdge& e, Index v) { return e.from < v; });
        if (it == sorted_by_from.end() || it->from != at) return false;
        at = it->to;
        if (at == first) return steps == n;
    }
    return false;
}

/// Coefficients of `n` of x, y, x^2/2, xy, y^2/2, x^3, x^2 y, x y^2, y^3 from number `skip` on that fit the
/// heights best.
bool fit_height(const std::vector<Vec3>& local, Eigen::Index n, Eigen::Index skip,
                Eigen::Matrix<double, 9, 1>& coefficients) {
    NormalMatrix ata = NormalMatrix::Zero(n, n);
    NormalVector atz = NormalVector::Zero(n);
    for (const Vec3& p : local) {
        const double x = p.x(), y = p.y();
        Eigen::Matrix<double, 9, 1> all;
        all << x, y, 0.5 * x * x, x * y, 0.5 * y * y, x * x * x, x * x * y, x * y * y, y * y * y;
        const NormalVector row = all.segment(skip, n);
        // Nearer points count more; the vertex itself is met exactly.
        const double weight = 1.0 / p.squaredNorm();
        ata.noalias() += weight * row * row.transpose();
        atz += weight * p.z() * row;
    }
    // Columns scaled to equal length, so that long thin neighbourhoods do not look ambiguous.
    const NormalVector scale = ata.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) return false;
    ata = scale.asDiagonal() * ata * scale.asDiagonal();
    const NormalSolution solution = solve_normal_equations(ata, scale.cwiseProduct(atz));
    if (!(solution.pivot_min > tolerance::fit_pivot)) return false;
    coefficients.setZero();
    coefficients.segment(skip, n) = scale.cwiseProduct(solution.x);
    return coefficients.allFinite();
}

Vec3 signed_direction(const Vec3& d) {
    Eigen::Index largest = 0;
    d.cwiseAbs().maxCoeff(&largest);
    return d[largest] < 0.0 ? Vec3(-d) : d;
}

/// Principal curvatures and directions of the height function at the vertex; false where no fit is unique.
bool fit_principal(const Mesh& mesh, Index vertex, const Vec3& normal, const std::vector<Index>& near,
                   std::vector<Vec3>& local, VertexCurvature& result) {
    Eigen::Index axis = 0;
    normal.cwiseAbs().minCoeff(&axis);
    const Vec3 ex = normal.cross(Vec3::Unit(axis)).normalized();
    const Vec3 ey = normal.cross(ex);
    double size = 0.0;
    local.clear();
    for (const Index v : near) {
        const Vec3 d = mesh.vertices[v] - mesh.vertices[vertex];
        if (!(d.squaredNorm() > 0.0)) continue;
        local.emplace_back(d.dot(ex), d.dot(ey), d.dot(normal));
        size = std::max(size, d.norm());
    }
    for (Vec3& p : local)
        p /= size;
    Eigen::Matrix<double, 9, 1> c;
    const bool fitted = (local.size() >= 12 && fit_height(local, 9, 0, c))
                        || (local.size() >= 7 && fit_height(local, 5, 0, c))
                        || (local.size() >= 3 && fit_height(local, 3, 2, c));
    if (!fitted) return false;

    // Shape operator from the fundamental forms of (x, y, h): with I = L L^T it is similar to the symmetric
    // L^-1 II L^-T, whose eigenvectors q give the tangents L^-T q. Heights fall where curvature is positive.
    const double hx = c[0], hy = c[1];
    const double bend = -1.0 / (size * std::sqrt(1.0 + hx * hx + hy * hy));
    Eigen::Matrix2d second;
    second << c[2], c[3], c[3], c[4];
    second *= bend;
    const double l00 = std::sqrt(1.0 + hx * hx), l10 = hx * hy / l00,
                 l11 = std::sqrt(1.0 + hy * hy - l10 * l10);
    Eigen::Matrix2d inverse_l;
    inverse_l << 1.0 / l00, 0.0, -l10 / (l00 * l11), 1.0 / l11;
    const Eigen::Matrix2d shape = inverse_l * second * inverse_l.transpose();
    const PrincipalForm principal =
        principal_form(shape(0, 0), 0.5 * (shape(0, 1) + shape(1, 0)), shape(1, 1));
    result.k1 = principal.high;
    result.k2 = principal.low;
    const auto tangent = [&](double qx, double qy) {
        const Vec2 w = inverse_l.transpose() * Vec2(qx, qy);
        return signed_direction((w.x() * (ex + hx * normal) + w.y() * (ey + hy * normal)).normalized());
    };
    result.direction1 = tangent(std::cos(principal.angle), std::sin(principal.angle));
    result.direction2 = tangent(-std::sin(principal.angle), std::cos(principal.angle));
    return true;
}

} // namespace

std::vector<VertexCurvature> vertex_curvatures(const Mesh& mesh, const std::vector<Vec3>& normals,
                                               const Progress& progress) {
    const VertexFacets around = facets_around_vertices(mesh, progress);
    std::vector<VertexCurvature> curvatures(mesh.vertices.size(), nothing());
    parallel_blocks(curvatures.size(), 2'000, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<RingEdge> ring;
        std::vector<Index> near;
        std::vector<Vec3> local;
        for (std::size_t v = begin; v < end; ++v) {
            const Vec3& p = mesh.vertices[v];
            const Vec3& n = normals[v];
            if (!(n.squaredNorm() > 0.0)) continue;
            ring.clear();
            Vec3 laplace = Vec3::Zero();
            double area = 0.0, angles = 0.0;
            for (const Index f : around.around(v)) {
                const RingEdge e = ring_edge(mesh.facets[f], Index(v));
                if (e.from == e.to || e.from == v || e.to == v) continue; // a facet that is an edge
                ring.push_back(e);
                const Vec3 &a = mesh.vertices[e.from], &b = mesh.vertices[e.to];
                const Vec3 pa = a - p, pb = b - p, ab = b - a;
                const double twice_area = pa.cross(pb).norm();
                angles += angle_between(pa, pb);
                if (!(twice_area > tolerance::vanishing_sum * std::max(pa.squaredNorm(), pb.squaredNorm())))
                    continue;
                const double dot_p = pa.dot(pb), dot_a = -pa.dot(ab), dot_b = pb.dot(ab);
                const double cot_a = dot_a / twice_area, cot_b = dot_b / twice_area;
                // The edge to a faces the angle at b, and the other way round.
                laplace -= cot_b * pa + cot_a * pb;
                if (dot_p < 0.0)
                    area += 0.25 * twice_area;
                else if (dot_a < 0.0 || dot_b < 0.0)
                    area += 0.125 * twice_area;
                else
                    area += 0.125 * (cot_b * pa.squaredNorm() + cot_a * pb.squaredNorm());
            }
            std::sort(ring.begin(), ring.end(),
                      [](const RingEdge& x, const RingEdge& y) { return x.from < y.from; });
            if (!closed_fan(ring) || !(area > 0.0)) continue;
            VertexCurvature& c = curvatures[v];
            c.mixed_area = area;
            c.mean = laplace.dot(n) / (4.0 * area); // half of the operator, which is twice the mean curvature
            c.gauss = (2.0 * pi - angles) / area;

            near.clear();
            for (const RingEdge& e : ring) {
                near.push_back(e.from);
                const auto beyond = around.around(e.from);
                if (beyond.size() > hub) continue;
                for (const Index f : beyond)
                    for (const Index w : mesh.facets[f])
                        if (w != v) near.push_back(w);
            }
            std::sort(near.begin(), near.end());
            near.erase(std::unique(near.begin(), near.end()), near.end());
            if (!fit_principal(mesh, Index(v), n, near, local, c)) {
                const double radius = std::sqrt(std::max(0.0, c.mean * c.mean - c.gauss));
                c.k1 = c.mean + radius;
                c.k2 = c.mean - radius;
                c.direction1 = c.direction2 = Vec3::Zero();
            }
        }
    });
    return curvatures;
}

} // namespace facetmill
