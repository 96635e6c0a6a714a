#include "core/gouge/vertex_slopes.h"

#include "core/base/tolerances.h"
#include "core/gouge/contact_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

/// A slope that stands for infinity: the kernels square it, and its square is still a float.
constexpr float steepest = 1e9f;

/// The slope of a facet; false where it is not known well, or nothing is known of how far the facet goes on.
bool facet_slope(const Vec3& a, const Vec3& b, const Vec3& c, double min_height, double& x, double& y) {
    const Vec3 u = b - a, v = c - a, n = u.cross(v);
    const double square =
        std::max({u.head<2>().squaredNorm(), v.head<2>().squaredNorm(), (c - b).head<2>().squaredNorm()});
    // Seen along Z, |n.z()| is the longest edge times the height over it.
    const double least = min_height * min_height * square,
                 slim = tolerance::needle * tolerance::needle * square * square;
    if (!(n.z() * n.z() > std::max(least, slim))) return false;
    x = -n.x() / n.z();
    y = -n.y() / n.z();
    return std::max(std::abs(x), std::abs(y)) < tolerance::steepest_trusted;
}

} // namespace

SlopeRange SlopeRange::none() {
    return {steepest, -steepest, steepest, -steepest};
}

SlopeRange SlopeRange::all() {
    return {-steepest, steepest, -steepest, steepest};
}

void SlopeRange::add(const SlopeRange& other) {
    lo_x = std::min(lo_x, other.lo_x);
    hi_x = std::max(hi_x, other.hi_x);
    lo_y = std::min(lo_y, other.lo_y);
    hi_y = std::max(hi_y, other.hi_y);
}

std::vector<SlopeRange> vertex_slopes(const Mesh& mesh, const std::vector<std::uint8_t>& is_open,
                                      const Progress& progress) {
    std::vector<SlopeRange> slopes(mesh.vertices.size(), SlopeRange::none());
    double size = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        size = std::max(size, mesh.vertices[v].cwiseAbs().maxCoeff());
        if (is_open[v]) slopes[v] = SlopeRange::all();
    }
    const double min_height = tolerance::smallest_facet * size;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % 20000 == 0) progress.check();
        SlopeRange range = SlopeRange::all();
        double x, y;
        if (facet_slope(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2), min_height, x, y)) {
            const double slack = tolerance::slope_slack * (1 + std::abs(x) + std::abs(y));
            range = {float(x - slack), float(x + slack), float(y - slack), float(y + slack)};
        }
        for (const Index v : mesh.facets[f])
            slopes[v].add(range);
    }
    return slopes;
}

} // namespace facetmill
