#include "core/verify/stock_surface.h"

#include "core/base/parallel.h"
#include "core/mesh/weld.h"
#include "core/verify/stock_patch.h"

#include <algorithm>
#include <unordered_map>

namespace facetmill {

namespace {

/// Cells along a side of a block: few, so that a patch takes about 5 ms and a picture follows the cut; more
/// than the layer of cells around it, which is looked at for its normals only, costs.
constexpr int cells_per_block = 24;
/// Blocks whose triangles are in memory at a time: enough for all threads, some hundred MB at most.
constexpr std::size_t blocks_at_a_time = 512;
/// Facets of a surface as one mesh: about 2 GB with all that planners make of it.
constexpr std::size_t max_stock_facets = 20'000'000;

} // namespace

StockSurface::StockSurface(const StockLattice& lattice) : lattice_(lattice) {
    for (std::size_t k = 0; k < 3; ++k)
        blocks_[k] = (lattice.nodes[k] + 1 + cells_per_block - 1) / cells_per_block;
}

std::size_t StockSurface::patch_count() const {
    return std::size_t(blocks_[0]) * std::size_t(blocks_[1]) * std::size_t(blocks_[2]);
}

CellRange StockSurface::range(std::size_t patch) const {
    const std::array<int, 3> at{int(patch % std::size_t(blocks_[0])),
                                int(patch / std::size_t(blocks_[0]) % std::size_t(blocks_[1])),
                                int(patch / (std::size_t(blocks_[0]) * std::size_t(blocks_[1])))};
    CellRange r{};
    for (std::size_t k = 0; k < 3; ++k) {
        r.from[k] = -1 + at[k] * cells_per_block;
        r.to[k] = std::min(r.from[k] + cells_per_block, lattice_.nodes[k]);
    }
    return r;
}

std::uint64_t StockSurface::stamp(const StockModel& stock, std::size_t patch) const {
    const CellRange r = range(patch);
    std::uint64_t sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto u = std::size_t(first_across(axis)), v = std::size_t(second_across(axis));
        const int across = tiles_of(lattice_.nodes[u]);
        const auto tile = [&](int node, std::size_t k) {
            return std::clamp(node, 0, lattice_.nodes[k] - 1) / RayTile::side;
        };
        for (int j = tile(r.from[v] - 1, v); j <= tile(r.to[v] + 1, v); ++j)
            for (int i = tile(r.from[u] - 1, u); i <= tile(r.to[u] + 1, u); ++i) {
                const auto& t =
                    stock.tiles_[std::size_t(axis)][std::size_t(i) + std::size_t(across) * std::size_t(j)];
                sum =
                    sum * 0x9E3779B97F4A7C15u + (t ? t->stamp : 0); // not a sum only: stamps may trade places
            }
    }
    return sum;
}

std::shared_ptr<const StockPatch> StockSurface::patch(const StockModel& stock, std::size_t patch) const {
    return make_patch(stock.solid(), lattice_, stock.tiles_, range(patch));
}

std::shared_ptr<const StockPatch> sparse_patch(std::shared_ptr<const StockPatch> whole) {
    if (!whole || whole->points.empty()) return whole;
    const StockPatch& patch = *whole;
    const auto& points = patch.points;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
        if (std::any_of(points.begin(), points.end(),
                        [&](const auto& p) { return p[k] != points.front()[k]; }))
            continue;
        // A sheet over a grid of cells, none of them missing.
        const auto places = [&](std::size_t axis) {
            std::vector<float> all;
            for (const auto& p : points)
                all.push_back(p[axis]);
            std::sort(all.begin(), all.end());
            all.erase(std::unique(all.begin(), all.end()), all.end());
            return all;
        };
        const std::vector<float> across = places(u), up = places(v);
        const std::size_t n = across.size(), m = up.size();
        if (n < 3 || m < 3 || points.size() != n * m || patch.triangles.size() != 2 * (n - 1) * (m - 1))
            break;
        std::vector<std::uint32_t> grid(n * m, 0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto a =
                std::size_t(std::lower_bound(across.begin(), across.end(), points[i][u]) - across.begin());
            const auto b = std::size_t(std::lower_bound(up.begin(), up.end(), points[i][v]) - up.begin());
            grid[a + n * b] = std::uint32_t(i);
        }
        std::vector<std::uint32_t> rim;
        for (std::size_t a = 0; a + 1 < n; ++a)
            rim.push_back(grid[a]);
        for (std::size_t b = 0; b + 1 < m; ++b)
            rim.push_back(grid[n - 1 + n * b]);
        for (std::size_t a = n - 1; a > 0; --a)
            rim.push_back(grid[a + n * (m - 1)]);
        for (std::size_t b = m - 1; b > 0; --b)
            rim.push_back(grid[n * b]);
        const auto& t = patch.triangles.front();
        const auto side = [&](std::size_t axis, std::uint32_t to) {
            return double(points[to][axis]) - double(points[t[0]][axis]);
        };
        const bool turned = side(u, t[1]) * side(v, t[2]) < side(v, t[1]) * side(u, t[2]);
        if (turned) std::reverse(rim.begin(), rim.end());
        auto sheet = std::make_shared<StockPatch>();
        sheet->box = patch.box;
        std::array<float, 3> outward{0, 0, 0};
        outward[k] = turned ? -1.0f : 1.0f;
        sheet->normals.assign(rim.size() + 1, outward); // those of the rim lean where the next block bends
        for (const std::uint32_t corner : rim)
            sheet->points.push_back(points[corner]);
        sheet->points.push_back(points[grid[n / 2 + n * (m / 2)]]);
        const auto corners = std::uint32_t(rim.size());
        for (std::uint32_t i = 0; i < corners; ++i)
            sheet->triangles.push_back({corners, i, (i + 1) % corners});
        return sheet;
    }
    return whole;
}

const std::vector<std::shared_ptr<const StockPatch>>&
PatchGroups::of(const std::vector<std::shared_ptr<const StockPatch>>& patches) {
    const auto size = [&](std::size_t k) { return patches[k] ? patches[k]->triangles.size() : 0; };
    bool fits = patches.size() == patches_.size();
    for (std::size_t g = 0, k = 0; fits && g < ends_.size(); ++g) {
        std::size_t sum = 0, from = k;
        for (; k < ends_[g]; ++k)
            sum += size(k);
        fits = sum <= 2 * triangles_ || k - from == 1;
    }
    if (!fits) {
        ends_.clear();
        std::size_t sum = 0;
        for (std::size_t k = 0; k < patches.size(); ++k) {
            if (sum > 0 && sum + size(k) > triangles_) {
                ends_.push_back(k);
                sum = 0;
            }
            sum += size(k);
        }
        if (!patches.empty()) ends_.push_back(patches.size());
        groups_.assign(ends_.size(), nullptr);
        patches_.assign(patches.size(), nullptr);
    }
    for (std::size_t g = 0, k = 0; g < ends_.size(); k = ends_[g++]) {
        const auto from = patches.begin() + std::ptrdiff_t(k),
                   to = patches.begin() + std::ptrdiff_t(ends_[g]);
        if (std::equal(from, to, patches_.begin() + std::ptrdiff_t(k))) continue;
        std::shared_ptr<const StockPatch> only;
        std::shared_ptr<StockPatch> sum;
        for (auto patch = from; patch != to; ++patch) {
            if (!*patch) continue;
            if (!only) {
                only = *patch;
                continue;
            }
            if (!sum) sum = std::make_shared<StockPatch>(*only);
            const auto first = std::uint32_t(sum->points.size());
            const StockPatch& p = **patch;
            sum->points.insert(sum->points.end(), p.points.begin(), p.points.end());
            sum->normals.insert(sum->normals.end(), p.normals.begin(), p.normals.end());
            for (const auto& [a, b, c] : p.triangles)
                sum->triangles.push_back({first + a, first + b, first + c});
            sum->box.add(p.box);
        }
        groups_[g] = sum ? sum : only;
    }
    patches_ = patches;
    return groups_;
}

void stock_triangles(const StockModel& stock,
                     const std::function<void(const Vec3& a, const Vec3& b, const Vec3& c)>& take,
                     const Progress& progress) {
    const StockSurface surface(stock.lattice());
    const Progress quiet = progress.part(0, 0); // cancels, and leaves the fraction alone
    std::vector<std::shared_ptr<const StockPatch>> pieces(blocks_at_a_time);
    for (std::size_t begin = 0; begin < surface.patch_count(); begin += blocks_at_a_time) {
        const std::size_t n = std::min(blocks_at_a_time, surface.patch_count() - begin);
        parallel_for(n, 1, quiet,
                     [&](std::size_t i) { pieces[i] = sparse_patch(surface.patch(stock, begin + i)); });
        for (std::size_t i = 0; i < n; ++i) {
            if (!pieces[i]) continue;
            const auto at = [&](std::uint32_t corner) {
                const auto& p = pieces[i]->points[corner];
                return Vec3(p[0], p[1], p[2]);
            };
            for (const auto& t : pieces[i]->triangles)
                take(at(t[0]), at(t[1]), at(t[2]));
        }
        progress.set(double(begin + n) / double(surface.patch_count()));
    }
}

Mesh stock_mesh(const StockModel& stock, const Progress& progress) {
    struct Hash {
        std::size_t operator()(const std::array<double, 3>& p) const {
            return std::size_t(detail::position_hash(Vec3(p[0], p[1], p[2])));
        }
    };
    Mesh mesh;
    std::unordered_map<std::array<double, 3>, Index, Hash> known;
    const auto vertex = [&](const Vec3& p) {
        const std::array<double, 3> at{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}; // no negative zeros
        const auto [place, is_new] = known.try_emplace(at, Index(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(Vec3(at[0], at[1], at[2]));
        return place->second;
    };
    stock_triangles(
        stock,
        [&](const Vec3& a, const Vec3& b, const Vec3& c) {
            const Facet facet{vertex(a), vertex(b), vertex(c)};
            // A facet that is a line leaves the others closed without it.
            if (facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0]) return;
            if (mesh.facets.size() >= max_stock_facets)
                throw Error(ErrorCode::limit_exceeded, "stock",
                            "its surface has more than " + std::to_string(max_stock_facets) + " facets",
                            "give the setup a stock of its own, or use larger tools before it");
            mesh.facets.push_back(facet);
        },
        progress);
    return mesh;
}

} // namespace facetmill
