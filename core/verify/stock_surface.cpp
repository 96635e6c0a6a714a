// A lattice node is inside where its ray along z has material. An edge of a cell between an inside and an
// outside node has a corner where its own ray ends; its ray may see it differently where the surface is
// nearly parallel to it, then the middle of the edge serves. One layer of nodes round the lattice is outside,
// so that the surface is closed.
#include "core/verify/stock_surface.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/verify/stock_tiles.h"

#include <algorithm>

namespace facetmill {

namespace {

constexpr int cells_per_block = 24;
constexpr std::size_t blocks_at_a_time = 512;

/// Corner c of a cell is at (c & 1, c >> 1 & 1, c >> 2). Edge e runs along axis e / 4 from corner
/// `edge_start(e)`.
constexpr int edge_start(int e) {
    const int axis = e / 4, k = e % 4;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return (k & 1) << u | (k >> 1) << v;
}
int edge_between(int a, int b) {
    const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
    for (int e = 4 * axis; e < 4 * axis + 4; ++e)
        if (edge_start(e) == std::min(a, b)) return e;
    return -1;
}

/// The closed polygons, as edges, that part the inside corners of a cell from the others; one entry for each
/// of the 256 ways to be inside. On a face with inside corners opposite each other these are kept apart, on
/// both of its sides.
struct CellPolygons {
    std::array<std::vector<std::vector<int>>, 256> of;

    CellPolygons() {
        // Corners of the six faces, counter-clockwise from outside.
        static constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
        for (int inside = 0; inside < 256; ++inside) {
            std::array<int, 12> next;
            next.fill(-1);
            for (const auto& face : faces) {
                // Each run of inside corners is entered and left; the polygon goes from where it is entered
                // to where it is left.
                for (int k = 0; k < 4; ++k) {
                    const int a = face[k], b = face[(k + 1) % 4];
                    if (!(inside >> a & 1) || (inside >> b & 1)) continue;
                    int start = k;
                    while (inside >> face[(start + 3) % 4] & 1)
                        start = (start + 3) % 4;
                    next[std::size_t(edge_between(face[(start + 3) % 4], face[start]))] = edge_between(a, b);
                }
            }
            std::array<bool, 12> done{};
            for (int e = 0; e < 12; ++e) {
                if (next[std::size_t(e)] < 0 || done[std::size_t(e)]) continue;
                std::vector<int> polygon;
                for (int at = e; !done[std::size_t(at)]; at = next[std::size_t(at)]) {
                    done[std::size_t(at)] = true;
                    polygon.push_back(at);
                }
                of[std::size_t(inside)].push_back(std::move(polygon));
            }
        }
    }
};

const CellPolygons& cell_polygons() {
    static const CellPolygons all;
    return all;
}

/// A fan from one corner would put diagonals into a face of the cell where two corners of the polygon lie on
/// it apart; the neighbour may do the same there. Such polygons get a corner of their own.
bool needs_center(const std::vector<int>& polygon) {
    if (polygon.size() <= 3) return false;
    const auto faces_of = [](int e) {
        // Faces as bits: 2 axis + side.
        const int axis = e / 4, c = edge_start(e);
        int bits = 0;
        for (int k = 0; k < 3; ++k)
            if (k != axis) bits |= 1 << (2 * k + (c >> k & 1));
        return bits;
    };
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j)
            if (!(i == 0 && j == n - 1) && (faces_of(polygon[i]) & faces_of(polygon[j]))) return true;
    return false;
}

std::shared_ptr<const RayTile> tile_of(const std::vector<std::shared_ptr<RayTile>>& family, int axis, int ti,
                                       int tj, const StockSolid& solid, const StockLattice& lattice) {
    const int across = tiles_of(lattice.nodes[std::size_t(first_across(axis))]);
    const auto& tile = family[std::size_t(ti) + std::size_t(across) * std::size_t(tj)];
    return tile ? tile : solid_tile(solid, lattice, axis, ti, tj);
}

} // namespace

StockSurface::StockSurface(const StockLattice& lattice) : lattice_(lattice) {
    for (std::size_t k = 0; k < 3; ++k)
        blocks_[k] = (lattice.nodes[k] + 1 + cells_per_block - 1) / cells_per_block;
}

std::size_t StockSurface::patch_count() const {
    return std::size_t(blocks_[0]) * std::size_t(blocks_[1]) * std::size_t(blocks_[2]);
}

StockSurface::Range StockSurface::range(std::size_t patch) const {
    const std::array<int, 3> at{int(patch % std::size_t(blocks_[0])),
                                int(patch / std::size_t(blocks_[0]) % std::size_t(blocks_[1])),
                                int(patch / (std::size_t(blocks_[0]) * std::size_t(blocks_[1])))};
    Range r{};
    for (std::size_t k = 0; k < 3; ++k) {
        r.from[k] = -1 + at[k] * cells_per_block;
        r.to[k] = std::min(r.from[k] + cells_per_block, lattice_.nodes[k]);
    }
    return r;
}

std::uint64_t StockSurface::stamp(const StockModel& stock, std::size_t patch) const {
    const Range r = range(patch);
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
    const Range own = range(patch);
    // One more layer of cells all round, for normals that go on from block to block.
    std::array<int, 3> from, to, size; // nodes from .. to
    for (std::size_t k = 0; k < 3; ++k) {
        from[k] = std::max(own.from[k] - 1, -1);
        to[k] = std::min(own.to[k] + 1, lattice_.nodes[k]);
        size[k] = to[k] - from[k] + 1;
    }
    const auto index = [&](int i, int j, int k) {
        return std::size_t(i - from[0])
               + std::size_t(size[0])
                     * (std::size_t(j - from[1]) + std::size_t(size[1]) * std::size_t(k - from[2]));
    };
    const std::size_t count = std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
    const Vec3 middle = stock.solid().box.center();

    // fn(i, j, tile, ray) for the rays of a family within the range.
    const auto for_rays = [&](int axis, auto&& fn) {
        const auto u = std::size_t(first_across(axis)), v = std::size_t(second_across(axis));
        const int ub = std::max(from[u], 0), ue = std::min(to[u], lattice_.nodes[u] - 1);
        const int vb = std::max(from[v], 0), ve = std::min(to[v], lattice_.nodes[v] - 1);
        for (int tj = vb / RayTile::side; tj <= ve / RayTile::side; ++tj)
            for (int ti = ub / RayTile::side; ti <= ue / RayTile::side; ++ti) {
                const auto tile =
                    tile_of(stock.tiles_[std::size_t(axis)], axis, ti, tj, stock.solid(), lattice_);
                for (int b = std::max(vb, tj * RayTile::side);
                     b <= std::min(ve, (tj + 1) * RayTile::side - 1); ++b)
                    for (int a = std::max(ub, ti * RayTile::side);
                         a <= std::min(ue, (ti + 1) * RayTile::side - 1); ++a)
                        fn(a, b, *tile, a % RayTile::side + RayTile::side * (b % RayTile::side));
            }
    };
    const auto node_at = [&](int axis, int i) {
        return lattice_.origin[axis] + i * lattice_.spacing[axis] - middle[axis];
    };

    // Most blocks of a large stock are within it or beyond it.
    const int low_z = std::max(from[2], 0), high_z = std::min(to[2], lattice_.nodes[2] - 1);
    bool within = true, beyond = true;
    for (std::size_t k = 0; k < 3; ++k)
        within = within && from[k] >= 0 && to[k] < lattice_.nodes[k];
    const double bottom = node_at(2, low_z), top = node_at(2, high_z);
    for_rays(2, [&](int, int, const RayTile& tile, int ray) {
        if (!within && !beyond) return;
        const RayTile::Piece* p = &tile.first[std::size_t(ray)];
        if (p->empty()) {
            within = false;
            return;
        }
        while (p->hi < bottom && p->next != RayTile::none)
            p = &tile.more[p->next];
        within = within && p->lo <= bottom && p->hi >= top;
        beyond = beyond && (p->lo > top || p->hi < bottom);
    });
    if (within || beyond) return nullptr;

    std::vector<std::uint8_t> inside(count, 0);
    for_rays(2, [&](int i, int j, const RayTile& tile, int ray) {
        const RayTile::Piece* p = &tile.first[std::size_t(ray)];
        if (p->empty()) return;
        for (int k = std::max(from[2], 0); k <= std::min(to[2], lattice_.nodes[2] - 1); ++k) {
            const double z = node_at(2, k);
            while (p->hi < z && p->next != RayTile::none)
                p = &tile.more[p->next];
            if (z >= p->lo && z <= p->hi) inside[index(i, j, k)] = 1;
        }
    });
    const auto sum = std::size_t(std::count(inside.begin(), inside.end(), std::uint8_t(1)));
    if (sum == 0 || sum == count) return nullptr;

    // Share of the way along each cut edge at which its corner lies; of edges that start at a node, per axis.
    std::array<std::vector<float>, 3> cut;
    for (int axis = 0; axis < 3; ++axis) {
        auto& shares = cut[std::size_t(axis)];
        shares.assign(count, 0.5f);
        const std::size_t step = axis == 0   ? 1
                                 : axis == 1 ? std::size_t(size[0])
                                             : std::size_t(size[0]) * std::size_t(size[1]);
        for_rays(axis, [&](int a, int b, const RayTile& tile, int ray) {
            const RayTile::Piece* head = &tile.first[std::size_t(ray)];
            if (head->empty()) return;
            std::array<int, 3> at;
            at[std::size_t(first_across(axis))] = a;
            at[std::size_t(second_across(axis))] = b;
            for (int c = from[std::size_t(axis)]; c < to[std::size_t(axis)]; ++c) {
                at[std::size_t(axis)] = c;
                const std::size_t n = index(at[0], at[1], at[2]);
                if (inside[n] == inside[n + step]) continue;
                const double low = node_at(axis, c), width = lattice_.spacing[axis];
                for (const RayTile::Piece* p = head;; p = &tile.more[p->next]) {
                    const double t = ((inside[n] ? p->hi : p->lo) - low) / width;
                    if (t >= 0 && t <= 1) {
                        shares[n] = float(std::clamp(t, tolerance::edge_margin, 1 - tolerance::edge_margin));
                        break;
                    }
                    if (p->next == RayTile::none) break;
                }
            }
        });
    }

    auto patch_out = std::make_shared<StockPatch>();
    std::array<std::vector<std::uint32_t>, 3> corner_of; // corner of a cut edge
    for (auto& c : corner_of)
        c.assign(count, 0xFFFFFFFFu);
    std::vector<Vec3> points, normals;
    const std::array<std::size_t, 3> steps{1, std::size_t(size[0]),
                                           std::size_t(size[0]) * std::size_t(size[1])};
    std::vector<std::array<std::uint32_t, 3>> mine;
    std::vector<std::uint32_t> corners;
    for (int k = from[2]; k < to[2]; ++k)
        for (int j = from[1]; j < to[1]; ++j)
            for (int i = from[0]; i < to[0]; ++i) {
                const std::size_t n = index(i, j, k);
                int state = 0;
                for (int c = 0; c < 8; ++c)
                    state |= inside[n + steps[0] * std::size_t(c & 1) + steps[1] * std::size_t(c >> 1 & 1)
                                    + steps[2] * std::size_t(c >> 2)]
                             << c;
                if (state == 0 || state == 255) continue;
                const bool in_block = i >= own.from[0] && i < own.to[0] && j >= own.from[1] && j < own.to[1]
                                      && k >= own.from[2] && k < own.to[2];
                for (const auto& polygon : cell_polygons().of[std::size_t(state)]) {
                    corners.clear();
                    for (int e : polygon) {
                        const auto axis = std::size_t(e / 4);
                        const int c = edge_start(e);
                        const std::size_t start = n + steps[0] * std::size_t(c & 1)
                                                  + steps[1] * std::size_t(c >> 1 & 1)
                                                  + steps[2] * std::size_t(c >> 2);
                        std::uint32_t& corner = corner_of[axis][start];
                        if (corner == 0xFFFFFFFFu) {
                            corner = std::uint32_t(points.size());
                            Vec3 at = lattice_.node(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
                            at[int(axis)] += double(cut[axis][start]) * lattice_.spacing[int(axis)];
                            points.push_back(at);
                            normals.push_back(Vec3::Zero());
                        }
                        corners.push_back(corner);
                    }
                    const auto emit = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                        const Vec3 cross = (points[b] - points[a]).cross(points[c] - points[a]);
                        for (std::uint32_t x : {a, b, c})
                            normals[x] += cross;
                        if (in_block) mine.push_back({a, b, c});
                    };
                    if (needs_center(polygon)) {
                        Vec3 center = Vec3::Zero();
                        for (std::uint32_t x : corners)
                            center += points[x] / double(corners.size());
                        points.push_back(center);
                        normals.push_back(Vec3::Zero());
                        for (std::size_t x = 0; x < corners.size(); ++x)
                            emit(std::uint32_t(points.size() - 1), corners[x],
                                 corners[(x + 1) % corners.size()]);
                    } else {
                        for (std::size_t x = 1; x + 1 < corners.size(); ++x)
                            emit(corners[0], corners[x], corners[x + 1]);
                    }
                }
            }
    if (mine.empty()) return nullptr;

    // Only what the block's own triangles use, in their order.
    std::vector<std::uint32_t> place(points.size(), 0xFFFFFFFFu);
    for (auto& t : mine) {
        for (std::uint32_t& x : t) {
            if (place[x] == 0xFFFFFFFFu) {
                place[x] = std::uint32_t(patch_out->points.size());
                const Vec3& q = points[x];
                const Vec3 normal =
                    normals[x].norm() > 0 ? Vec3(normals[x].normalized()) : Vec3(Vec3::UnitZ());
                patch_out->points.push_back({float(q.x()), float(q.y()), float(q.z())});
                patch_out->normals.push_back({float(normal.x()), float(normal.y()), float(normal.z())});
                patch_out->box.add(q);
            }
            x = place[x];
        }
        patch_out->triangles.push_back(t);
    }
    return patch_out;
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

} // namespace facetmill
