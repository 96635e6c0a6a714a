#include "core/repair/patch.h"

#include "core/base/error.h"
#include "core/base/plane_geometry.h"
#include "core/mesh/exact_area.h"
#include "core/mesh/topology.h"
#include "core/repair/plane_polygon.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

/// Time grows with the cube of the corners, memory with the square.
constexpr std::size_t max_woven_corners = 200;
constexpr int max_divisions = 40;
constexpr std::size_t max_patch_facets = 2'000'000;

/// How good triangles over a part of the curve are: the sharpest bend, then the area.
struct Bend {
    double angle = 0, area = 0;
    bool operator<(const Bend& other) const {
        // Angles that differ by less than a degree are alike: else noise would decide.
        constexpr double alike = 0.02;
        if (std::abs(angle - other.angle) > alike) return angle < other.angle;
        return area < other.area;
    }
};

/// Triangles over the whole curve from the best ones over each part of it.
class Weaver {
public:
    explicit Weaver(const PatchRim& rim)
        : rim_(rim), n_(rim.points.size()), best_(n_ * n_), middle_(n_ * n_, no_index) {}

    bool weave(const Progress& progress, std::vector<Facet>& facets) {
        for (std::size_t span = 2; span < n_; ++span) {
            progress.check();
            for (std::size_t i = 0; i + span < n_; ++i)
                choose(i, i + span);
        }
        if (middle_[n_ - 1] == no_index) return false;
        std::vector<std::pair<std::size_t, std::size_t>> parts{{0, n_ - 1}};
        while (!parts.empty()) {
            const auto [i, j] = parts.back();
            parts.pop_back();
            if (j < i + 2) continue;
            const std::size_t k = middle_[i * n_ + j];
            facets.push_back({Index(i), Index(k), Index(j)});
            parts.emplace_back(i, k);
            parts.emplace_back(k, j);
        }
        return true;
    }

private:
    Vec3 cross(std::size_t i, std::size_t k, std::size_t j) const {
        return (rim_.points[k] - rim_.points[i]).cross(rim_.points[j] - rim_.points[i]);
    }
    /// Normal of what lies beyond the side from i to j as the triangles over it are: the facet beyond the
    /// rim, or the triangle.
    Vec3 normal_over(std::size_t i, std::size_t j) const {
        return j == i + 1 ? rim_.normals[i] : cross(i, middle_[i * n_ + j], j);
    }
    bool is_taken(std::size_t i, std::size_t j) const {
        return j > i + 1 && !(i == 0 && j == n_ - 1) && rim_.is_taken(Index(i), Index(j));
    }

    void choose(std::size_t i, std::size_t j) {
        if (is_taken(i, j)) return;
        Bend best;
        Index middle = no_index;
        for (std::size_t k = i + 1; k < j; ++k) {
            if (k > i + 1 && middle_[i * n_ + k] == no_index) continue;
            if (j > k + 1 && middle_[k * n_ + j] == no_index) continue;
            const Vec3 normal = cross(i, k, j);
            if (exactly_collinear(rim_.points[i], rim_.points[k], rim_.points[j])) continue;
            Bend bend;
            const Bend &a = best_[i * n_ + k], &b = best_[k * n_ + j];
            bend.angle = std::max({a.angle, b.angle, angle_between(normal, normal_over(i, k)),
                                   angle_between(normal, normal_over(k, j))});
            if (i == 0 && j == n_ - 1)
                bend.angle = std::max(bend.angle, angle_between(normal, rim_.normals[n_ - 1]));
            bend.area = a.area + b.area + 0.5 * normal.norm();
            if (middle == no_index || bend < best) {
                best = bend;
                middle = Index(k);
            }
        }
        best_[i * n_ + j] = best;
        middle_[i * n_ + j] = middle;
    }

    const PatchRim& rim_;
    std::size_t n_;
    std::vector<Bend> best_;
    std::vector<Index> middle_;
};

Vec3 rim_normal(const PatchRim& rim) {
    Vec3 sum = Vec3::Zero();
    const std::size_t n = rim.points.size();
    for (std::size_t i = 0; i < n; ++i)
        sum += (rim.points[i] - rim.points[0]).cross(rim.points[(i + 1) % n] - rim.points[0]);
    return sum.normalized();
}

bool lay_flat(const PatchRim& rim, const Progress& progress, std::vector<Facet>& facets) {
    const Vec3 normal = rim_normal(rim);
    if (!(normal.norm() > 0.5)) return false;
    const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
    std::vector<Vec2> points;
    std::vector<Index> ring;
    for (const Vec3& p : rim.points) {
        ring.push_back(Index(points.size()));
        points.emplace_back((p - rim.points[0]).dot(x), (p - rim.points[0]).dot(y));
    }
    auto flat = triangulate_rings(points, {ring}, progress);
    if (!flat) return false;
    const std::size_t n = ring.size();
    for (const Facet& f : *flat) {
        if (exactly_collinear(rim.points[f[0]], rim.points[f[1]], rim.points[f[2]])) return false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = f[k], b = f[(k + 1) % 3];
            const std::size_t apart = a < b ? b - a : a - b;
            if (apart > 1 && apart + 1 < n && rim.is_taken(a, b)) return false;
        }
    }
    facets = std::move(*flat);
    return true;
}

HalfedgeMesh half_edges(const Patch& patch) {
    HalfedgeMesh half;
    std::vector<OpenMesh::VertexHandle> handles;
    for (const Vec3& p : patch.points)
        handles.push_back(half.add_vertex({p.x(), p.y(), p.z()}));
    for (const Facet& f : patch.facets)
        half.add_face(handles[f[0]], handles[f[1]], handles[f[2]]);
    return half;
}

Vec3 place_of(const HalfedgeMesh& half, OpenMesh::VertexHandle v) {
    const auto& p = half.point(v);
    return {p[0], p[1], p[2]};
}

/// Divides the patch, with the spacing of vertices carried inward from the rim.
class Divider {
public:
    Divider(Patch& patch, const PatchRim& rim)
        : patch_(patch), rim_(rim), half_(half_edges(patch)), spacing_(rim.spacing) {}

    void divide(const Progress& progress) {
        relax(progress);
        for (int pass = 0; pass < max_divisions && split(progress); ++pass)
            relax(progress);
        patch_.points.clear();
        for (const auto v : half_.vertices())
            patch_.points.push_back(place_of(half_, v));
        patch_.facets.clear();
        for (const auto f : half_.faces()) {
            auto it = half_.cfv_begin(f);
            const int a = (it++)->idx(), b = (it++)->idx(), c = it->idx();
            patch_.facets.push_back({Index(a), Index(b), Index(c)});
        }
    }

private:
    bool split(const Progress& progress) {
        progress.check();
        const std::size_t faces = half_.n_faces();
        if (faces > max_patch_facets)
            throw Error(ErrorCode::limit_exceeded, "holes",
                        "a hole would be filled with more than " + std::to_string(max_patch_facets)
                            + " facets",
                        "fill it flat, or leave it with a smaller size");
        bool any = false;
        for (std::size_t i = 0; i < faces; ++i) {
            const OpenMesh::FaceHandle f{int(i)};
            Vec3 center = Vec3::Zero();
            double spacing = 0;
            for (const auto v : half_.fv_range(f)) {
                center += place_of(half_, v) / 3;
                spacing += spacing_[std::size_t(v.idx())] / 3;
            }
            bool wide = true;
            for (const auto v : half_.fv_range(f)) {
                const double reach = std::sqrt(2.0) * (place_of(half_, v) - center).norm();
                wide = wide && reach > spacing && reach > spacing_[std::size_t(v.idx())];
            }
            if (!wide) continue;
            half_.split(f, half_.add_vertex({center.x(), center.y(), center.z()}));
            spacing_.push_back(spacing);
            any = true;
        }
        return any;
    }

    /// Turns edges within the patch whose facets look past each other with more than half a turn.
    void relax(const Progress& progress) {
        constexpr int max_rounds = 30;
        for (int round = 0; round < max_rounds; ++round) {
            progress.check();
            bool any = false;
            for (const auto e : half_.edges()) {
                if (half_.is_boundary(e) || !wants_turn(e) || !half_.is_flip_ok(e)) continue;
                half_.flip(e);
                any = true;
            }
            if (!any) return;
        }
    }
    bool wants_turn(OpenMesh::EdgeHandle e) const {
        const auto h = half_.halfedge_handle(e, 0), o = half_.halfedge_handle(e, 1);
        const auto va = half_.from_vertex_handle(h), vb = half_.to_vertex_handle(h);
        const auto vc = half_.to_vertex_handle(half_.next_halfedge_handle(h));
        const auto vd = half_.to_vertex_handle(half_.next_halfedge_handle(o));
        const Vec3 a = place_of(half_, va), b = place_of(half_, vb), c = place_of(half_, vc),
                   d = place_of(half_, vd);
        if (angle_between(a - c, b - c) + angle_between(a - d, b - d) <= pi + 1e-6) return false;
        const Vec3 before1 = (b - a).cross(c - a), before2 = (a - b).cross(d - b);
        const Vec3 after1 = (d - c).cross(b - c), after2 = (c - d).cross(a - d);
        // Neither folds over.
        if (after1.dot(before1) <= 0 || after1.dot(before2) <= 0 || after2.dot(before1) <= 0
            || after2.dot(before2) <= 0)
            return false;
        const std::size_t corners = rim_.points.size();
        const auto i = std::size_t(vc.idx()), j = std::size_t(vd.idx());
        return !(i < corners && j < corners && rim_.is_taken(Index(i), Index(j)));
    }

    Patch& patch_;
    const PatchRim& rim_;
    HalfedgeMesh half_;
    std::vector<double> spacing_;
};

/// The Laplacian of one vertex: what its neighbors, weighed by nearness, lie off it on the average.
struct Laplacian {
    std::vector<std::pair<Index, double>> patch; ///< vertices of the patch; the vertex itself has -1
    Vec3 beyond = Vec3::Zero();                  ///< the share of neighbors beyond the rim
};

std::vector<Laplacian> laplacians(const Patch& patch, const PatchRim& rim) {
    std::vector<std::vector<Index>> neighbors(patch.points.size());
    for (const Facet& f : patch.facets)
        for (std::size_t k = 0; k < 3; ++k) {
            neighbors[f[k]].push_back(f[(k + 1) % 3]);
            neighbors[f[(k + 1) % 3]].push_back(f[k]);
        }
    std::vector<Laplacian> result(patch.points.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
        auto& around = neighbors[v];
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        const auto weight = [&](const Vec3& p) { return 1 / std::max((p - patch.points[v]).norm(), 1e-12); };
        double sum = 0;
        for (const Index u : around)
            sum += weight(patch.points[u]);
        if (v < rim.points.size())
            for (const Vec3& p : rim.beyond[v])
                sum += weight(p);
        for (const Index u : around)
            result[v].patch.emplace_back(u, weight(patch.points[u]) / sum);
        if (v < rim.points.size())
            for (const Vec3& p : rim.beyond[v])
                result[v].beyond += weight(p) / sum * p;
        result[v].patch.emplace_back(Index(v), -1.0);
    }
    return result;
}

void fair(Patch& patch, const PatchRim& rim) {
    const std::size_t corners = rim.points.size(), added = patch.points.size() - corners;
    if (added == 0) return;
    const std::vector<Laplacian> rows = laplacians(patch, rim);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right(Eigen::Index(rows.size()), 3);
    for (std::size_t v = 0; v < rows.size(); ++v) {
        Vec3 known = rows[v].beyond;
        for (const auto& [u, w] : rows[v].patch) {
            if (u < corners)
                known += w * patch.points[u];
            else
                entries.emplace_back(int(v), int(u - corners), w);
        }
        right.row(Eigen::Index(v)) = -known.transpose();
    }
    Eigen::SparseMatrix<double> matrix{Eigen::Index(rows.size()), Eigen::Index(added)};
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> normal = matrix.transpose() * matrix;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    if (solver.info() != Eigen::Success) return; // the vertices stay in the flat patch
    const Eigen::MatrixXd found = solver.solve(matrix.transpose() * right);
    if (!found.allFinite()) return;
    for (std::size_t i = 0; i < added; ++i)
        patch.points[corners + i] = found.row(Eigen::Index(i)).transpose();
}

} // namespace

std::optional<Patch> flat_patch(const PatchRim& rim, const Progress& progress) {
    Patch patch;
    patch.points = rim.points;
    const bool woven = rim.points.size() <= max_woven_corners && Weaver(rim).weave(progress, patch.facets);
    if (!woven) {
        patch.facets.clear();
        if (!lay_flat(rim, progress, patch.facets)) return std::nullopt;
    }
    patch.min_fold = pi;
    const std::size_t n = rim.points.size();
    for (const Facet& f : patch.facets)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = f[k], b = f[(k + 1) % 3];
            if (b != (a + 1) % n) continue;
            const Vec3 normal =
                (patch.points[f[1]] - patch.points[f[0]]).cross(patch.points[f[2]] - patch.points[f[0]]);
            patch.min_fold = std::min(patch.min_fold, angle_between(normal, rim.normals[a]));
        }
    return patch;
}

void fair_patch(Patch& patch, const PatchRim& rim, const Progress& progress) {
    Divider(patch, rim).divide(progress);
    progress.check();
    fair(patch, rim);
    for (std::size_t v = rim.points.size(); v < patch.points.size(); ++v)
        patch.points[v] = rounded_to_float(patch.points[v]);
}

} // namespace facetmill::detail
