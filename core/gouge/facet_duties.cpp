#include "core/gouge/facet_duties.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/contact_blocks.h"

#include <atomic>
#include <limits>

namespace facetmill {

namespace {

constexpr double rounding = 0.5 * std::numeric_limits<double>::epsilon();

/// Twice the area of the projection along Z of a triangle, with sign; 0 where rounding could have made it.
double projected_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
    const double area = left - right;
    return std::abs(area) > tolerance::area_roundings * rounding * (std::abs(left) + std::abs(right)) ? area
                                                                                                      : 0;
}

/// True when d surely lies above the plane of the triangle a, b, c, whose projected area is `area`.
bool surely_above(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double area) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double det = u.cross(v).dot(w);
    const double size = u.cwiseAbs().maxCoeff() * v.cwiseAbs().maxCoeff() * w.cwiseAbs().maxCoeff();
    const double noise = tolerance::valley_roundings * rounding * size;
    return area > 0 ? det > noise : det < -noise;
}

enum class EdgeKind {
    open,   ///< its facets do not surely lie on different sides of it seen along Z
    valley, ///< surely
    other,
};

EdgeKind kind_of(const Mesh& mesh, Index half1, Index half2) {
    const auto corner = [&](Index half, Index k) { return mesh.facets[half / 3][(half % 3 + k) % 3]; };
    const Vec3 &a = mesh.vertices[corner(half1, 0)], &b = mesh.vertices[corner(half1, 1)];
    const Vec3 &c = mesh.vertices[corner(half1, 2)], &d = mesh.vertices[corner(half2, 2)];
    const double area1 = projected_area(a, b, c), area2 = projected_area(a, b, d);
    if (!(area1 * area2 < 0)) return EdgeKind::open;
    return surely_above(a, b, c, d, area1) ? EdgeKind::valley : EdgeKind::other;
}

} // namespace

std::vector<std::uint8_t> facet_duties(const Mesh& mesh, const Progress& progress,
                                       std::vector<std::uint8_t>* is_open) {
    constexpr std::size_t grain = 20000;
    const std::size_t facets = mesh.facet_count(), vertices = mesh.vertices.size();
    // Half-edge h is edge h % 3 of facet h / 3; filed under its lower vertex, in order.
    struct Half {
        Index high, half;
    };
    std::vector<Index> first(vertices + 1, 0);
    for (std::size_t f = 0; f < facets; ++f) {
        if (f % grain == 0) progress.check();
        const Facet& v = mesh.facets[f];
        if (std::max({v[0], v[1], v[2]}) >= vertices)
            throw Error(ErrorCode::internal, "facet " + std::to_string(f),
                        "names a vertex that the mesh has not", "report the part");
        for (std::size_t k = 0; k < 3; ++k)
            ++first[std::min(v[k], v[(k + 1) % 3]) + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v)
        first[v + 1] += first[v];
    std::vector<Half> halves(3 * facets);
    {
        std::vector<Index> next(first.begin(), first.end() - 1);
        for (std::size_t f = 0; f < facets; ++f) {
            if (f % grain == 0) progress.check();
            const Facet& v = mesh.facets[f];
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = v[k], b = v[(k + 1) % 3];
                halves[next[std::min(a, b)]++] = {std::max(a, b), Index(3 * f + k)};
            }
        }
    }

    // Facets whose edges are decided in different blocks share a byte.
    std::vector<std::atomic<std::uint8_t>> edges(facets), open(vertices);
    parallel_blocks(vertices, grain, progress.part(0.4, 0.9), [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const auto from = halves.begin() + first[v], to = halves.begin() + first[v + 1];
            std::sort(from, to, [](const Half& a, const Half& b) {
                return a.high != b.high ? a.high < b.high : a.half < b.half;
            });
            for (auto h = from; h != to;) {
                auto end_of_edge = h + 1;
                while (end_of_edge != to && end_of_edge->high == h->high)
                    ++end_of_edge;
                unsigned duty = duty_edge_anyway;
                const bool degenerate = h->high == v; // a facet that names a vertex twice
                const EdgeKind kind = degenerate || end_of_edge - h != 2
                                          ? EdgeKind::open
                                          : kind_of(mesh, h->half, (h + 1)->half);
                if (kind != EdgeKind::valley) duty |= duty_edge;
                if (kind == EdgeKind::open) {
                    open[v].store(1, std::memory_order_relaxed);
                    open[h->high].store(1, std::memory_order_relaxed);
                }
                edges[h->half / 3].fetch_or(std::uint8_t(duty << (h->half % 3)), std::memory_order_relaxed);
                h = end_of_edge;
            }
        }
    });

    if (is_open) is_open->assign(open.begin(), open.end());
    std::vector<std::uint8_t> duties(facets, 0);
    for (std::size_t f = 0; f < facets; ++f) {
        if (f % grain == 0) progress.check();
        duties[f] = edges[f].load(std::memory_order_relaxed);
        if (projected_area(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)) != 0)
            duties[f] |= duty_plane;
    }
    return duties;
}

} // namespace facetmill
