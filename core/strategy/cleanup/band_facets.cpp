#include "core/strategy/cleanup/band_facets.h"

#include "core/base/parallel.h"
#include "core/strategy/surface/cell_set.h"
#include "core/strategy/surface/point_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace facetmill {

namespace {

constexpr std::size_t facets_per_check = 8192;
/// Points of the band that are asked are so far apart, of the distance.
constexpr double facet_point_share = 0.3;

} // namespace

std::vector<BandFacet> facets_beside(const Mesh& mesh, const FacetGrid& grid, const RestBand& band,
                                     double within, const Progress& progress) {
    const double apart = facet_point_share * within;
    CellSet thin(apart);
    PointGrid points(within);
    // Columns over the band and beside it, seen from above.
    std::set<std::array<long, 2>> columns;
    const auto add = [&](const Vec3& p) {
        if (!thin.add_first(p)) return;
        points.add(p);
        const long x = std::lround(std::floor(p.x() / within)), y = std::lround(std::floor(p.y() / within));
        for (const long dx : {-1, 0, 1})
            for (const long dy : {-1, 0, 1})
                columns.insert({x + dx, y + dy});
    };
    for (std::size_t i = 0; i < band.band.size(); ++i) {
        if (i % facets_per_check == 0) progress.check();
        for (const Vec3& p : band.band[i])
            add(p);
    }
    std::vector<Index> facets;
    for (const auto& [x, y] : columns) {
        progress.check();
        grid.near(Vec2(double(x) + 0.5, double(y) + 0.5) * within, 0.5 * within,
                  [&](Index f) { facets.push_back(f); });
    }
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());

    std::vector<BandFacet> all(facets.size());
    std::vector<char> beside(facets.size(), 0);
    parallel_for(facets.size(), facets_per_check / 8, progress, [&](std::size_t i) {
        const Vec3 &a = mesh.corner(facets[i], 0), &b = mesh.corner(facets[i], 1),
                   &c = mesh.corner(facets[i], 2);
        const Vec3 middle = (a + b + c) / 3;
        const double size = std::sqrt(
            std::max({(a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm()}));
        all[i] = {facets[i], middle, size};
        const double reach = within + apart + size;
        beside[i] = points.near_until(
            middle, reach, [&](std::size_t k) { return (points.points()[k] - middle).norm() <= reach; });
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (beside[i]) all[kept++] = all[i];
    all.resize(kept);
    return all;
}

} // namespace facetmill
