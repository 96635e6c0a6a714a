// The marching cubes of one block. A lattice node is inside where its ray along z has material. An edge of a
// cell between an inside and an outside node has a corner where its own ray ends; its ray may see it
// differently where the surface is nearly parallel to it, then the middle of the edge serves. One layer of
// nodes round the lattice is outside, so that the surface is closed.
#include "core/verify/stock_patch.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace facetmill {

namespace {

/// An edge whose corner is not made yet, and a point that is not yet in the patch.
constexpr auto no_corner = 0xFFFFFFFFu;

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

class PatchMaker {
public:
    PatchMaker(const StockSolid& solid, const StockLattice& lattice, const TileFamilies& tiles,
               const CellRange& own)
        : solid_(solid), lattice_(lattice), tiles_(tiles), own_(own), middle_(solid.box.center()) {
        // One more layer of cells all round, for normals that go on from block to block.
        std::array<std::size_t, 3> size;
        for (std::size_t k = 0; k < 3; ++k) {
            from_[k] = std::max(own.from[k] - 1, -1);
            to_[k] = std::min(own.to[k] + 1, lattice.nodes[k]);
            size[k] = std::size_t(to_[k] - from_[k] + 1);
        }
        step_ = {1, size[0], size[0] * size[1]};
        count_ = size[0] * size[1] * size[2];
    }

    std::shared_ptr<const StockPatch> make() {
        if (is_within_or_beyond() || !find_inside()) return nullptr;
        find_cuts();
        join_corners();
        return triangles_.empty() ? nullptr : own_part();
    }

private:
    using Triangle = std::array<std::uint32_t, 3>;
    struct Cell {
        int i, j, k;
        std::size_t node; ///< its first
        bool is_own;
    };

    std::size_t index(int i, int j, int k) const {
        return std::size_t(i - from_[0]) + step_[1] * std::size_t(j - from_[1])
               + step_[2] * std::size_t(k - from_[2]);
    }
    /// The node at corner c of a cell whose first node is n.
    std::size_t at_corner(std::size_t n, int c) const {
        return n + step_[0] * std::size_t(c & 1) + step_[1] * std::size_t(c >> 1 & 1)
               + step_[2] * std::size_t(c >> 2);
    }
    /// The place of a node along an axis, as rays have it.
    double node_at(int axis, int i) const {
        return lattice_.origin[axis] + i * lattice_.spacing[axis] - middle_[axis];
    }

    /// visit(i, j, tile, ray) for the rays of a family within the range.
    template <class Visit>
    void for_rays(int axis, Visit&& visit) const {
        const auto u = std::size_t(first_across(axis)), v = std::size_t(second_across(axis));
        const int ub = std::max(from_[u], 0), ue = std::min(to_[u], lattice_.nodes[u] - 1);
        const int vb = std::max(from_[v], 0), ve = std::min(to_[v], lattice_.nodes[v] - 1);
        for (int tj = vb / RayTile::side; tj <= ve / RayTile::side; ++tj)
            for (int ti = ub / RayTile::side; ti <= ue / RayTile::side; ++ti) {
                const auto tile = tile_of(tiles_[std::size_t(axis)], axis, ti, tj, solid_, lattice_);
                for (int b = std::max(vb, tj * RayTile::side);
                     b <= std::min(ve, (tj + 1) * RayTile::side - 1); ++b)
                    for (int a = std::max(ub, ti * RayTile::side);
                         a <= std::min(ue, (ti + 1) * RayTile::side - 1); ++a)
                        visit(a, b, *tile, a % RayTile::side + RayTile::side * (b % RayTile::side));
            }
    }

    /// True of most blocks of a large stock. They have no surface.
    bool is_within_or_beyond() const {
        const int low_z = std::max(from_[2], 0), high_z = std::min(to_[2], lattice_.nodes[2] - 1);
        bool within = true, beyond = true;
        for (std::size_t k = 0; k < 3; ++k)
            within = within && from_[k] >= 0 && to_[k] < lattice_.nodes[k];
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
        return within || beyond;
    }

    /// Which nodes are inside, as the rays along z see it; false where all are, or none.
    bool find_inside() {
        inside_.assign(count_, 0);
        for_rays(2, [&](int i, int j, const RayTile& tile, int ray) {
            const RayTile::Piece* p = &tile.first[std::size_t(ray)];
            if (p->empty()) return;
            for (int k = std::max(from_[2], 0); k <= std::min(to_[2], lattice_.nodes[2] - 1); ++k) {
                const double z = node_at(2, k);
                while (p->hi < z && p->next != RayTile::none)
                    p = &tile.more[p->next];
                if (z >= p->lo && z <= p->hi) inside_[index(i, j, k)] = 1;
            }
        });
        const auto sum = std::size_t(std::count(inside_.begin(), inside_.end(), std::uint8_t(1)));
        return sum != 0 && sum != count_;
    }

    /// Where the edges between an inside and an outside node are cut, each by its own ray.
    void find_cuts() {
        for (int axis = 0; axis < 3; ++axis) {
            auto& shares = cut_[std::size_t(axis)];
            shares.assign(count_, 0.5f);
            const std::size_t step = step_[std::size_t(axis)];
            for_rays(axis, [&](int a, int b, const RayTile& tile, int ray) {
                const RayTile::Piece* head = &tile.first[std::size_t(ray)];
                if (head->empty()) return;
                std::array<int, 3> at;
                at[std::size_t(first_across(axis))] = a;
                at[std::size_t(second_across(axis))] = b;
                for (int c = from_[std::size_t(axis)]; c < to_[std::size_t(axis)]; ++c) {
                    at[std::size_t(axis)] = c;
                    const std::size_t n = index(at[0], at[1], at[2]);
                    if (inside_[n] == inside_[n + step]) continue;
                    const double low = node_at(axis, c), width = lattice_.spacing[axis];
                    for (const RayTile::Piece* p = head;; p = &tile.more[p->next]) {
                        const double t = ((inside_[n] ? p->hi : p->lo) - low) / width;
                        if (t >= 0 && t <= 1) {
                            shares[n] =
                                float(std::clamp(t, tolerance::edge_margin, 1 - tolerance::edge_margin));
                            break;
                        }
                        if (p->next == RayTile::none) break;
                    }
                }
            });
        }
    }

    /// Puts triangles between the corners, cell by cell.
    void join_corners() {
        for (auto& c : corner_of_)
            c.assign(count_, no_corner);
        for (int k = from_[2]; k < to_[2]; ++k)
            for (int j = from_[1]; j < to_[1]; ++j)
                for (int i = from_[0]; i < to_[0]; ++i) {
                    const std::size_t n = index(i, j, k);
                    int state = 0;
                    for (int c = 0; c < 8; ++c)
                        state |= inside_[at_corner(n, c)] << c;
                    if (state == 0 || state == 255) continue;
                    const bool is_own = i >= own_.from[0] && i < own_.to[0] && j >= own_.from[1]
                                        && j < own_.to[1] && k >= own_.from[2] && k < own_.to[2];
                    for (const auto& polygon : cell_polygons().of[std::size_t(state)])
                        fill({i, j, k, n, is_own}, polygon);
                }
    }

    void fill(const Cell& cell, const std::vector<int>& polygon) {
        corners_.clear();
        for (const int e : polygon)
            corners_.push_back(corner(cell, e));
        if (!needs_center(polygon)) {
            for (std::size_t x = 1; x + 1 < corners_.size(); ++x)
                add(cell, {corners_[0], corners_[x], corners_[x + 1]});
            return;
        }
        Vec3 center = Vec3::Zero();
        for (const std::uint32_t x : corners_)
            center += points_[x] / double(corners_.size());
        const std::uint32_t middle = add(center);
        for (std::size_t x = 0; x < corners_.size(); ++x)
            add(cell, {middle, corners_[x], corners_[(x + 1) % corners_.size()]});
    }

    /// The corner on edge e of a cell, which up to four cells share.
    std::uint32_t corner(const Cell& cell, int e) {
        const int axis = e / 4, c = edge_start(e);
        const std::size_t start = at_corner(cell.node, c);
        std::uint32_t& corner = corner_of_[std::size_t(axis)][start];
        if (corner == no_corner) {
            Vec3 at = lattice_.node(cell.i + (c & 1), cell.j + (c >> 1 & 1), cell.k + (c >> 2));
            at[axis] += double(cut_[std::size_t(axis)][start]) * lattice_.spacing[axis];
            corner = add(at);
        }
        return corner;
    }

    std::uint32_t add(const Vec3& point) {
        points_.push_back(point);
        normals_.push_back(Vec3::Zero());
        return std::uint32_t(points_.size() - 1);
    }

    /// Triangles of the cells around count for the normals only.
    void add(const Cell& cell, const Triangle& t) {
        const Vec3 cross = (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]);
        for (const std::uint32_t x : t)
            normals_[x] += cross;
        if (cell.is_own) triangles_.push_back(t);
    }

    /// The triangles with only what they use, in their order.
    std::shared_ptr<const StockPatch> own_part() const {
        auto patch = std::make_shared<StockPatch>();
        std::vector<std::uint32_t> place(points_.size(), no_corner);
        for (Triangle t : triangles_) {
            for (std::uint32_t& x : t) {
                if (place[x] == no_corner) {
                    place[x] = std::uint32_t(patch->points.size());
                    const Vec3& q = points_[x];
                    const Vec3 normal =
                        normals_[x].norm() > 0 ? Vec3(normals_[x].normalized()) : Vec3(Vec3::UnitZ());
                    patch->points.push_back({float(q.x()), float(q.y()), float(q.z())});
                    patch->normals.push_back({float(normal.x()), float(normal.y()), float(normal.z())});
                    patch->box.add(q);
                }
                x = place[x];
            }
            patch->triangles.push_back(t);
        }
        return patch;
    }

    const StockSolid& solid_;
    const StockLattice& lattice_;
    const TileFamilies& tiles_;
    const CellRange& own_;
    Vec3 middle_;
    std::array<int, 3> from_, to_;    ///< nodes, both included
    std::array<std::size_t, 3> step_; ///< from a node to the next along each axis
    std::size_t count_ = 0;
    std::vector<std::uint8_t> inside_;
    /// Of the edges that start at a node, per axis: the share of the way at which an edge is cut, and its
    /// corner.
    std::array<std::vector<float>, 3> cut_;
    std::array<std::vector<std::uint32_t>, 3> corner_of_;
    std::vector<std::uint32_t> corners_; ///< of the polygon that is filled
    std::vector<Vec3> points_, normals_;
    std::vector<Triangle> triangles_;
};

} // namespace

std::shared_ptr<const StockPatch> make_patch(const StockSolid& solid, const StockLattice& lattice,
                                             const TileFamilies& tiles, const CellRange& own) {
    return PatchMaker(solid, lattice, tiles, own).make();
}

} // namespace facetmill
