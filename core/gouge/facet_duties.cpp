#include "core/gouge/facet_duties.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/contact_blocks.h"
#include "core/mesh/edge_table.h"

#include <atomic>
#include <limits>

namespace facetmill {

namespace {

/// Facets, or vertices, between two looks at whether the job was cancelled: some milliseconds.
constexpr std::size_t block = 20'000;
/// The relative error of one operation in double precision, at most.
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

EdgeKind kind_of(const Mesh& mesh, Index side, Index other) {
    const Vec3 &a = mesh.vertices[side_start(mesh, side)], &b = mesh.vertices[side_end(mesh, side)];
    const Vec3 &c = mesh.vertices[side_across(mesh, side)], &d = mesh.vertices[side_across(mesh, other)];
    const double area1 = projected_area(a, b, c), area2 = projected_area(a, b, d);
    if (!(area1 * area2 < 0)) return EdgeKind::open;
    return surely_above(a, b, c, d, area1) ? EdgeKind::valley : EdgeKind::other;
}

} // namespace

std::vector<std::uint8_t> facet_duties(const Mesh& mesh, const Progress& progress,
                                       std::vector<std::uint8_t>* is_open) {
    const std::size_t facets = mesh.facet_count(), vertices = mesh.vertices.size();
    const EdgeTable table(mesh, progress.part(0, 0.4));
    // Facets whose edges are decided in different blocks share a byte.
    std::vector<std::atomic<std::uint8_t>> edges(facets), open(vertices);
    parallel_blocks(vertices, block, progress.part(0.4, 0.9), [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            table.for_edges(v, [&](Index high, std::span<const EdgeSide> sides) {
                const EdgeSide owner = sides[0];
                unsigned duty = duty_edge_anyway;
                const bool degenerate = high == v; // a facet that names a vertex twice
                const EdgeKind kind = degenerate || sides.size() != 2
                                          ? EdgeKind::open
                                          : kind_of(mesh, owner.side, sides[1].side);
                if (kind != EdgeKind::valley) duty |= duty_edge;
                if (kind == EdgeKind::open) {
                    open[v].store(1, std::memory_order_relaxed);
                    open[high].store(1, std::memory_order_relaxed);
                }
                edges[owner.facet()].fetch_or(std::uint8_t(duty << owner.corner()),
                                              std::memory_order_relaxed);
            });
    });

    if (is_open) is_open->assign(open.begin(), open.end());
    std::vector<std::uint8_t> duties(facets, 0);
    for (std::size_t f = 0; f < facets; ++f) {
        if (f % block == 0) progress.check();
        duties[f] = edges[f].load(std::memory_order_relaxed);
        if (projected_area(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)) != 0)
            duties[f] |= duty_plane;
    }
    return duties;
}

} // namespace facetmill
