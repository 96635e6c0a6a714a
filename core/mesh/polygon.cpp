// Polygons of OBJ and PLY files to triangles.
#include "core/mesh/mesh_reader.h"

namespace facetmill::detail {

namespace {

/// Looking for ears takes up to the cube of the corners in time; larger polygons are cut as fans, folded or
/// not.
constexpr std::size_t max_ear_corners = 256;

Vec3 polygon_normal(const std::vector<Vec3>& points, const Index* corners, std::size_t count) {
    const Vec3& base = points[corners[0]];
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < count; ++i)
        sum += (points[corners[i]] - base).cross(points[corners[i + 1]] - base);
    return sum;
}

/// Cuts ears in the plane across `normal`; false when no ear is left though corners are.
bool cut_ears(const std::vector<Vec3>& points, const Index* corners, std::size_t count, const Vec3& normal,
              std::vector<Facet>& facets) {
    const auto turn = [&](Index a, Index b, Index c) {
        return (points[b] - points[a]).cross(points[c] - points[a]).dot(normal);
    };
    std::vector<Index> ring(corners, corners + count);
    while (ring.size() > 3) {
        const std::size_t n = ring.size();
        bool cut = false;
        for (std::size_t i = 0; i < n && !cut; ++i) {
            const Index a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
            if (turn(a, b, c) <= 0.0) continue;
            bool clear = true;
            for (std::size_t j = 0; j < n && clear; ++j) {
                const Index p = ring[j];
                if (p == a || p == b || p == c) continue;
                clear = turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0 || turn(c, a, p) < 0.0;
            }
            if (!clear) continue;
            facets.push_back({a, b, c});
            ring.erase(ring.begin() + std::ptrdiff_t(i));
            cut = true;
        }
        if (!cut) return false;
    }
    if (turn(ring[0], ring[1], ring[2]) <= 0.0) return false;
    facets.push_back({ring[0], ring[1], ring[2]});
    return true;
}

} // namespace

bool triangulate_polygon(const std::vector<Vec3>& points, const Index* corners, std::size_t count,
                         std::vector<Facet>& facets) {
    if (count == 3) {
        facets.push_back({corners[0], corners[1], corners[2]});
        return true;
    }
    const Vec3 normal = polygon_normal(points, corners, count);
    const Vec3& base = points[corners[0]];
    bool folds =
        false; // or has a triangle without area, which would leave its middle corner on the edge of another
    for (std::size_t i = 1; i + 1 < count && !folds && !normal.isZero(0.0); ++i)
        folds = (points[corners[i]] - base).cross(points[corners[i + 1]] - base).dot(normal) <= 0.0;
    const std::size_t before = facets.size();
    if (folds && count <= max_ear_corners) {
        if (cut_ears(points, corners, count, normal, facets)) return true;
        facets.resize(before);
    }
    for (std::size_t i = 1; i + 1 < count; ++i)
        facets.push_back({corners[0], corners[i], corners[i + 1]});
    return !folds;
}

} // namespace facetmill::detail
