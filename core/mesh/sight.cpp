#include "core/mesh/sight.h"

#include "core/mesh/facet_boxes.h"

#include "core/mesh/triangle_distance.h"

#include <cmath>

namespace facetmill {

namespace {

/// Where rays begin, in extents of the mesh: above the rounding of coordinates, below any detail of a part.
constexpr double start_share = 1e-7;

} // namespace

MeshSight::MeshSight(const Mesh& mesh, const Progress& progress)
    : mesh_(mesh), start_(start_share * mesh.box().size().norm()) {
    tree_ = BoxTree(facet_boxes(mesh), progress);
}

bool MeshSight::is_free(const Vec3& p, const Vec3& d) const {
    // As `meets`, without a division. Where d has no part along an axis 1 / d is infinite: both sides of a
    // box that p is beside are then infinitely far ahead, or behind.
    const Vec3 per = d.cwiseInverse(), lo = p + Vec3::Constant(start_), hi = p - Vec3::Constant(start_);
    return tree_.each_until(
        [&](const Box3& box) {
            double from = start_, to = infinity;
            for (int k = 0; k < 3; ++k) {
                const double a = (box.lo[k] - lo[k]) * per[k], b = (box.hi[k] - hi[k]) * per[k];
                from = std::max(from, std::min(a, b));
                to = std::min(to, std::max(a, b));
            }
            return from <= to && from < infinity;
        },
        [&](std::size_t facet) { return hit(facet, p, d) == infinity; });
}

double MeshSight::first_hit(const Vec3& p, const Vec3& d) const {
    double nearest = infinity;
    tree_.each([&](const Box3& box) { return meets(box, p, d, start_, nearest, start_); },
               [&](std::size_t facet) { nearest = std::min(nearest, hit(facet, p, d)); });
    return nearest;
}

double MeshSight::distance(const Vec3& p, double most, double share, double least) const {
    double found = most * most, square = found; // nearer than `square` is worth finding
    tree_.nearest(p, square, [&](std::size_t f) {
        const Vec3 &a = mesh_.corner(f, 0), &b = mesh_.corner(f, 1), &c = mesh_.corner(f, 2);
        // Most are not as near even in their plane.
        const Vec3 n = (b - a).cross(c - a);
        const double off = (p - a).dot(n);
        if (off * off > square * n.squaredNorm()) return;
        const double here = squared_distance(p, a, b, c);
        if (!(here < square)) return;
        found = square = here;
        if (share == 1) return;
        const double nearer = least + share * std::max(0.0, std::sqrt(here) - least);
        square = std::min(here, nearer * nearer);
    });
    return std::sqrt(found);
}

void MeshSight::each_near(const Vec3& p, const Vec3& d, double length, double r,
                          const std::function<void(std::size_t facet)>& visit) const {
    tree_.each([&](const Box3& box) { return meets(box, p, d, 0, length, r); }, visit);
}

/// Whether the line comes into the box, grown by `more`, between two lengths.
bool MeshSight::meets(const Box3& box, const Vec3& p, const Vec3& d, double from, double to, double more) {
    for (int k = 0; k < 3; ++k) {
        const double a = box.lo[k] - more - p[k], b = box.hi[k] + more - p[k];
        if (d[k] == 0) {
            if (a > 0 || b < 0) return false;
        } else {
            from = std::max(from, std::min(a / d[k], b / d[k]));
            to = std::min(to, std::max(a / d[k], b / d[k]));
        }
    }
    return from <= to;
}

/// How far the ray goes to the facet; infinity where it passes it by.
double MeshSight::hit(std::size_t facet, const Vec3& p, const Vec3& d) const {
    const Vec3 &a = mesh_.corner(facet, 0), e1 = mesh_.corner(facet, 1) - a, e2 = mesh_.corner(facet, 2) - a;
    const Vec3 across = d.cross(e2);
    const double steep = e1.dot(across);
    if (steep == 0) return infinity;
    const Vec3 from = p - a, turned = from.cross(e1);
    const double v = from.dot(across) / steep, w = d.dot(turned) / steep, t = e2.dot(turned) / steep;
    return v >= 0 && w >= 0 && v + w <= 1 && t > start_ ? t : infinity;
}

} // namespace facetmill
