#include "core/mesh/sight.h"

#include "core/base/parallel.h"
#include "core/mesh/facet_boxes.h"
#include "core/mesh/triangle_distance.h"

#include <cmath>

namespace facetmill {

namespace {

/// Where rays begin, in extents of the mesh: above the rounding of coordinates, below any detail of a part.
constexpr double start_share = 1e-7;
/// Facets that share a box where few rays are asked for, boxes that one thread makes at a time, and facets
/// that are held against a ray in the time that one takes to get its place in a tree.
constexpr std::size_t max_together = 32, boxes_per_task = 512;
constexpr double tests_for_a_place = 100;

/// How far along d from p a facet is hit, beyond `start`; infinity where it is passed by.
double hit(const Mesh& mesh, std::size_t facet, const Vec3& p, const Vec3& d, double start) {
    const Vec3 &a = mesh.corner(facet, 0), e1 = mesh.corner(facet, 1) - a, e2 = mesh.corner(facet, 2) - a;
    const Vec3 across = d.cross(e2);
    const double steep = e1.dot(across);
    if (steep == 0) return infinity;
    const Vec3 from = p - a, turned = from.cross(e1);
    const double v = from.dot(across) / steep, w = d.dot(turned) / steep, t = e2.dot(turned) / steep;
    return v >= 0 && w >= 0 && v + w <= 1 && t > start ? t : infinity;
}

/// A line p + t d that is held against many boxes, grown by `more`, without a division. Where d has no part
/// along an axis 1 / d is infinite: both sides of a box that p is beside are then infinitely far ahead, or
/// behind.
class LineAndBoxes {
public:
    LineAndBoxes(const Vec3& p, const Vec3& d, double more)
        : per_(d.cwiseInverse()), lo_(p + Vec3::Constant(more)), hi_(p - Vec3::Constant(more)) {}
    /// Whether the line comes into the box between two t.
    bool meets(const Box3& box, double from, double to) const {
        for (int k = 0; k < 3; ++k) {
            const double a = (box.lo[k] - lo_[k]) * per_[k], b = (box.hi[k] - hi_[k]) * per_[k];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        return from <= to && from < infinity;
    }

private:
    Vec3 per_, lo_, hi_;
};

/// Whether nothing is hit along d from p, beyond `start`; the tree is over boxes of so many facets each, in
/// the mesh's order. The first facet that is hit answers.
bool passes_all(const Mesh& mesh, const BoxTree& tree, std::size_t together, const Vec3& p, const Vec3& d,
                double start) {
    const LineAndBoxes line(p, d, start);
    return tree.each_until([&](const Box3& box) { return line.meets(box, start, infinity); },
                           [&](std::size_t i) {
                               const std::size_t end = std::min(mesh.facet_count(), (i + 1) * together);
                               for (std::size_t f = i * together; f < end; ++f)
                                   if (hit(mesh, f, p, d, start) < infinity) return false;
                               return true;
                           });
}

} // namespace

MeshSight::MeshSight(const Mesh& mesh, const Progress& progress)
    : mesh_(mesh), start_(start_share * mesh.box().size().norm()) {
    tree_ = BoxTree(facet_boxes(mesh), progress);
}

double MeshSight::first_hit(const Vec3& p, const Vec3& d, double most) const {
    const LineAndBoxes line(p, d, start_);
    double within = most, nearest = infinity;
    tree_.each([&](const Box3& box) { return line.meets(box, start_, within); },
               [&](std::size_t facet) {
                   const double here = hit(mesh_, facet, p, d, start_);
                   if (here > within) return;
                   within = nearest = here;
               });
    return nearest;
}

bool MeshSight::is_free(const Vec3& p, const Vec3& d) const {
    return passes_all(mesh_, tree_, 1, p, d, start_);
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
    const LineAndBoxes line(p, d, r);
    tree_.each([&](const Box3& box) { return line.meets(box, 0, length); }, visit);
}

OpenSight::OpenSight(const Mesh& mesh, std::size_t rays, const Progress& progress)
    : mesh_(mesh), start_(start_share * mesh.box().size().norm()) {
    const auto half_surface = [](const Vec3& size) {
        return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
    };
    const std::size_t n = mesh.facet_count();
    std::vector<Box3> boxes((n + max_together - 1) / max_together);
    parallel_for(boxes.size(), boxes_per_task, progress.part(0, 0.2), [&](std::size_t i) {
        for (std::size_t f = i * max_together; f < std::min(n, (i + 1) * max_together); ++f)
            for (int k = 0; k < 3; ++k)
                boxes[i].add(mesh.corner(f, k));
    });
    double surface = 0;
    for (const Box3& box : boxes)
        surface += half_surface(box.size());
    // A line through a convex body meets another one in it as often as their surfaces say (Cauchy).
    const double whole = half_surface(mesh.box().size()),
                 tests = whole > 0 ? double(max_together) * surface / whole : double(n);
    const bool few = double(rays) * tests < tests_for_a_place * double(n);
    together_ = few ? max_together : 1;
    tree_ = BoxTree(few ? std::move(boxes) : facet_boxes(mesh), progress.part(0.2, 1));
}

bool OpenSight::is_free(const Vec3& p, const Vec3& d) const {
    return passes_all(mesh_, tree_, together_, p, d, start_);
}

} // namespace facetmill
