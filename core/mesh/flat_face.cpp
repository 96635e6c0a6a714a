#include "core/mesh/flat_face.h"

#include <cmath>
#include <map>

namespace facetmill {

namespace {

/// Sines of the angle by which facets of one face may differ, and shares of the box that corners may lie off
/// their plane: the single precision of an STL file.
constexpr double face_angle = 1e-3, off_share = 1e-6;

} // namespace

std::vector<Index> flat_face(const Mesh& mesh, Index facet) {
    const Vec3 n = mesh.facet_normal(facet), at = mesh.corner(facet, 0);
    if (n == Vec3::Zero()) return {facet};
    const double slack = off_share * mesh.box().size().norm();
    std::vector<Index> level;
    std::multimap<Index, std::size_t> by_corner;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        bool in = true;
        for (int k = 0; k < 3; ++k)
            in = in && std::abs((mesh.corner(f, k) - at).dot(n)) <= slack;
        if (!in || mesh.facet_normal(f).cross(n).norm() > face_angle) continue;
        for (const Index v : mesh.facets[f])
            by_corner.emplace(v, level.size());
        level.push_back(Index(f));
    }
    std::vector<bool> taken(level.size(), false);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < level.size(); ++i)
        if (level[i] == facet) {
            taken[i] = true;
            open.push_back(i);
        }
    while (!open.empty()) {
        const Facet& corners = mesh.facets[level[open.back()]];
        open.pop_back();
        for (const Index v : corners)
            for (auto [i, end] = by_corner.equal_range(v); i != end; ++i)
                if (!taken[i->second]) {
                    taken[i->second] = true;
                    open.push_back(i->second);
                }
    }
    std::vector<Index> face;
    for (std::size_t i = 0; i < level.size(); ++i)
        if (taken[i]) face.push_back(level[i]);
    return face;
}

Vec3 middle_of(const Mesh& mesh, const std::vector<Index>& facets) {
    Vec3 sum = Vec3::Zero(), plain = Vec3::Zero();
    double area = 0;
    for (const Index f : facets) {
        const Vec3 middle = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
        const double here = mesh.facet_cross(f).norm();
        sum += here * middle;
        area += here;
        plain += middle / double(facets.size());
    }
    return area > 0 ? Vec3(sum / area) : plain;
}

} // namespace facetmill
