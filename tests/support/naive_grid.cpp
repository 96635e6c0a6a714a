#include "tests/support/naive_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill::test {

namespace {

double segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double square = d.squaredNorm();
    const double t = square > 0 ? std::clamp((p - a).dot(d) / square, 0.0, 1.0) : 0;
    return (p - a - t * d).norm();
}

double facet_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double rim =
        std::min({segment_distance(p, a, b), segment_distance(p, b, c), segment_distance(p, c, a)});
    const Vec3 n = (b - a).cross(c - a);
    if (!(n.norm() > 0)) return rim;
    const Vec3 u = n.normalized(), q = p - u.dot(p - a) * u;
    const bool within = (b - a).cross(q - a).dot(u) >= 0 && (c - b).cross(q - b).dot(u) >= 0
                        && (a - c).cross(q - c).dot(u) >= 0;
    return within ? std::abs(u.dot(p - a)) : rim;
}

} // namespace

NaiveFacets::NaiveFacets(const Mesh& mesh) : mesh_(mesh), box_(mesh.box()) {
    const Vec3 size = box_.size();
    size_ = std::max(size.maxCoeff() / 100, 1e-9);
    for (int k = 0; k < 3; ++k)
        n_[std::size_t(k)] = std::max(1, int(std::ceil(size[k] / size_)));
    cells_.resize(std::size_t(n_[0]) * std::size_t(n_[1]) * std::size_t(n_[2]));
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        Box3 around;
        for (int k = 0; k < 3; ++k)
            around.add(mesh.corner(f, k));
        std::array<int, 3> at;
        for (at[2] = column(around.lo.z(), 2); at[2] <= column(around.hi.z(), 2); ++at[2])
            for (at[1] = column(around.lo.y(), 1); at[1] <= column(around.hi.y(), 1); ++at[1])
                for (at[0] = column(around.lo.x(), 0); at[0] <= column(around.hi.x(), 0); ++at[0])
                    cells_[cell(at)].push_back(std::uint32_t(f));
    }
}

bool NaiveFacets::farther_than(const Vec3& p, double r) const {
    std::array<int, 3> at;
    for (at[2] = column(p.z() - r, 2); at[2] <= column(p.z() + r, 2); ++at[2])
        for (at[1] = column(p.y() - r, 1); at[1] <= column(p.y() + r, 1); ++at[1])
            for (at[0] = column(p.x() - r, 0); at[0] <= column(p.x() + r, 0); ++at[0])
                for (const std::uint32_t f : cells_[cell(at)])
                    if (facet_distance(p, mesh_.corner(f, 0), mesh_.corner(f, 1), mesh_.corner(f, 2)) < r)
                        return false;
    return true;
}

bool NaiveFacets::open(const Vec3& p, const Vec3& d, double start) const {
    const double end = box_.size().norm() + (p - box_.center()).norm();
    std::size_t last = std::size_t(-1);
    for (double t = 0; t <= end; t += 0.25 * size_) {
        const Vec3 q = p + t * d;
        if (((q - box_.lo).array() < -size_).any() || ((q - box_.hi).array() > size_).any()) continue;
        const std::array<int, 3> at{column(q.x(), 0), column(q.y(), 1), column(q.z(), 2)};
        if (cell(at) == last) continue;
        last = cell(at);
        for (const std::uint32_t f : cells_[last]) {
            const Vec3 &a = mesh_.corner(f, 0), n = mesh_.facet_cross(f);
            const double steep = n.dot(d);
            if (steep == 0) continue;
            const double hit = n.dot(a - p) / steep;
            if (!(hit > start)) continue;
            const Vec3 x = p + hit * d;
            bool within = true;
            for (int k = 0; k < 3; ++k) {
                const Vec3 &u = mesh_.corner(f, k), &v = mesh_.corner(f, (k + 1) % 3);
                within = within && (v - u).cross(x - u).dot(n) >= 0;
            }
            if (within) return false;
        }
    }
    return true;
}

} // namespace facetmill::test
