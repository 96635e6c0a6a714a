// Rays of a stock that is given as a mesh: where each ray crosses facets, in and out by turns.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/verify/stock_tiles.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Twice the area of (a, b, p), with the same value but for the sign whichever way round an edge is given: a
/// ray through an edge crosses exactly one of its two facets.
double side_of(const Vec2& a, const Vec2& b, const Vec2& p) {
    const bool turned = std::pair(b.x(), b.y()) < std::pair(a.x(), a.y());
    const Vec2 &s = turned ? b : a, &e = turned ? a : b;
    const double cross = (e.x() - s.x()) * (p.y() - s.y()) - (e.y() - s.y()) * (p.x() - s.x());
    return turned ? -cross : cross;
}

/// Whether a facet seen along the ray holds p; points on an edge belong to the facet on one side of it.
bool holds(const std::array<Vec2, 3>& t, const Vec2& p) {
    int positive = 0, negative = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 &a = t[k], &b = t[(k + 1) % 3];
        double s = side_of(a, b, p);
        if (s == 0) s = std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()) ? 1 : -1;
        (s > 0 ? positive : negative) += 1;
    }
    return positive == 3 || negative == 3;
}

} // namespace

void fill_from_mesh(const StockSolid& solid, const StockLattice& lattice, TileFamilies& families,
                    const Progress& progress) {
    const Mesh& mesh = *solid.mesh;
    const Vec3 middle = solid.box.center();
    for (int axis = 0; axis < 3; ++axis) {
        const int u = first_across(axis), v = second_across(axis);
        const int nu = lattice.nodes[std::size_t(u)], nv = lattice.nodes[std::size_t(v)];
        const int tu = tiles_of(nu), tv = tiles_of(nv);
        auto& family = families[std::size_t(axis)];
        const auto tile_at = [&](double x, int k, int tiles) {
            const double t = (x - lattice.origin[k]) / (lattice.spacing[k] * RayTile::side);
            return int(std::clamp(std::floor(t), 0.0, double(tiles - 1)));
        };
        std::vector<std::vector<Index>> facets(family.size());
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            if (f % 20000 == 0) progress.check();
            Box3 box;
            for (int k = 0; k < 3; ++k)
                box.add(mesh.corner(f, k));
            for (int j = tile_at(box.lo[v], v, tv); j <= tile_at(box.hi[v], v, tv); ++j)
                for (int i = tile_at(box.lo[u], u, tu); i <= tile_at(box.hi[u], u, tu); ++i)
                    facets[std::size_t(i) + std::size_t(tu) * std::size_t(j)].push_back(Index(f));
        }
        parallel_for(family.size(), 1, progress.part(axis / 3.0, (axis + 1) / 3.0), [&](std::size_t n) {
            auto tile = std::make_shared<RayTile>();
            const int i0 = int(n) % tu * RayTile::side, j0 = int(n) / tu * RayTile::side;
            std::array<std::vector<float>, RayTile::side * RayTile::side> crossings;
            for (const Index f : facets[n]) {
                std::array<Vec2, 3> t;
                Vec2 low = Vec2::Constant(infinity), high = -low;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vec3& q = mesh.corner(f, int(k));
                    t[k] = Vec2(q[u], q[v]);
                    low = low.cwiseMin(t[k]);
                    high = high.cwiseMax(t[k]);
                }
                const Vec3 cross = mesh.facet_cross(f);
                if (cross[axis] == 0) continue;
                const auto range = [&](double from, double to, int k, int start, int nodes) {
                    const auto at = [&](double x) {
                        return (x - lattice.origin[k]) / lattice.spacing[k] - start;
                    };
                    const int most = std::min(RayTile::side, nodes - start);
                    return std::pair(int(std::clamp(std::ceil(at(from)) - 1, 0.0, double(most))),
                                     int(std::clamp(std::floor(at(to)) + 2, 0.0, double(most))));
                };
                const auto [ib, ie] = range(low.x(), high.x(), u, i0, nu);
                const auto [jb, je] = range(low.y(), high.y(), v, j0, nv);
                for (int j = jb; j < je; ++j)
                    for (int i = ib; i < ie; ++i) {
                        const Vec2 p(lattice.origin[u] + (i0 + i) * lattice.spacing[u],
                                     lattice.origin[v] + (j0 + j) * lattice.spacing[v]);
                        if (!holds(t, p)) continue;
                        const Vec3& q = mesh.corner(f, 0);
                        const double at =
                            q[axis] - (cross[u] * (p.x() - q[u]) + cross[v] * (p.y() - q[v])) / cross[axis];
                        crossings[std::size_t(i + RayTile::side * j)].push_back(
                            float(std::clamp(at, solid.box.lo[axis], solid.box.hi[axis]) - middle[axis]));
                    }
            }
            for (std::size_t ray = 0; ray < crossings.size(); ++ray) {
                auto& c = crossings[ray];
                if (c.size() % 2)
                    throw Error(ErrorCode::out_of_range, "stock",
                                "the mesh is not closed: a line enters it and does not leave",
                                "give a closed mesh, or a box or cylinder");
                std::sort(c.begin(), c.end());
                for (std::size_t k = 0; k + 1 < c.size(); k += 2)
                    if (c[k + 1] > c[k]) tile->append(int(ray), c[k], c[k + 1]);
            }
            tile->find_bounds();
            tile->stamp = RayTile::next_stamp();
            family[n] = std::move(tile);
        });
    }
}

} // namespace facetmill
