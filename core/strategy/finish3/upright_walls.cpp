#include "core/strategy/finish3/upright_walls.h"

#include "core/base/tolerances.h"
#include "core/strategy/surface/surface_lines.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t walls_per_check = 16384;

Vec3 flat(const Vec3& p) {
    return {p.x(), p.y(), 0};
}

} // namespace

UprightWalls::UprightWalls(const Mesh& mesh, double reach, const Progress& progress) : reach_(reach) {
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % walls_per_check == 0) progress.check();
        const Vec3 n = mesh.facet_normal(f);
        if (n.squaredNorm() == 0 || std::abs(n.z()) > tolerance::vertical_normal_z) continue;
        const Index first = Index(walls_.vertices.size());
        for (int k = 0; k < 3; ++k)
            walls_.vertices.push_back(mesh.corner(f, k));
        walls_.facets.push_back({first, first + 1, first + 2});
    }
    if (!walls_.facets.empty()) grid_.emplace(walls_, progress);
}

double UprightWalls::lowest(const Vec2& axis) const {
    double lowest = infinity;
    if (!grid_) return lowest;
    const Vec3 from(axis.x(), axis.y(), 0);
    grid_->near(axis, reach_, [&](Index f) {
        const Vec3 &a = walls_.corner(f, 0), &b = walls_.corner(f, 1), &c = walls_.corner(f, 2);
        const double foot = std::min({a.z(), b.z(), c.z()});
        if (foot >= lowest) return;
        // Upright, so that its edges are all that is seen of it.
        for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            if (distance_to_segment(from, flat(p), flat(q)) <= reach_) lowest = foot;
    });
    return lowest;
}

} // namespace facetmill
