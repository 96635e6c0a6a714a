#include "core/strategy/preview/coarse_ground.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace facetmill {

namespace {

/// Facets that a thread takes at a time, and pieces of the mesh that have a grid of their own.
constexpr std::size_t facets_per_look = 1024, ground_pieces = 4;
constexpr float no_low = std::numeric_limits<float>::max();

/// Heights that a piece of a mesh gives: over the middles of cells, and of corners.
struct GroundPiece {
    std::vector<float> height, low, corner;
    std::vector<Index> facet, corner_facet;

    explicit GroundPiece(std::size_t cells)
        : height(cells, nothing_there), low(cells, no_low), corner(cells, nothing_there),
          facet(cells, no_index), corner_facet(cells, no_index) {}

    void raise(std::size_t i, double z, std::size_t f) {
        low[i] = std::min(low[i], float(z));
        if (float(z) <= height[i]) return;
        height[i] = float(z);
        facet[i] = Index(f);
    }
    void raise_corner(std::size_t i, double z, std::size_t f) {
        low[i] = std::min(low[i], float(z));
        if (float(z) <= corner[i]) return;
        corner[i] = float(z);
        corner_facet[i] = Index(f);
    }
    void add(const GroundPiece& later) {
        for (std::size_t i = 0; i < height.size(); ++i) {
            low[i] = std::min(low[i], later.low[i]);
            if (later.height[i] > height[i]) {
                height[i] = later.height[i];
                facet[i] = later.facet[i];
            }
            if (later.corner[i] > corner[i]) {
                corner[i] = later.corner[i];
                corner_facet[i] = later.corner_facet[i];
            }
        }
    }
};

/// Facets `from` to `to` of a turned mesh.
void put_facets(const Mesh& mesh, const Mat3& turn, const CoarseGrid& grid, std::size_t from, std::size_t to,
                GroundPiece& piece) {
    for (std::size_t f = from; f < to; ++f) {
        std::array<Vec3, 3> c; // in cells
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = turn * mesh.corner(f, k);
            c[std::size_t(k)] = {(p.x() - grid.origin.x()) / grid.cell, (p.y() - grid.origin.y()) / grid.cell,
                                 p.z()};
            const int x =
                int(std::clamp(std::floor(c[std::size_t(k)].x() + 0.5), -1.0, double(grid.columns)));
            const int y = int(std::clamp(std::floor(c[std::size_t(k)].y() + 0.5), -1.0, double(grid.rows)));
            // The far border of the last cell is its own.
            const int column = std::min(x, grid.columns - 1), row = std::min(y, grid.rows - 1);
            const bool near = c[std::size_t(k)].x() <= grid.columns && c[std::size_t(k)].y() <= grid.rows;
            if (near && grid.has(column, row)) piece.raise_corner(grid.index(column, row), p.z(), f);
        }
        const auto [x0, x1] = std::minmax({c[0].x(), c[1].x(), c[2].x()});
        const auto [y0, y1] = std::minmax({c[0].y(), c[1].y(), c[2].y()});
        const int first_x = int(std::clamp(std::ceil(x0), 0.0, double(grid.columns))),
                  last_x = int(std::clamp(std::floor(x1), -1.0, double(grid.columns - 1))),
                  first_y = int(std::clamp(std::ceil(y0), 0.0, double(grid.rows))),
                  last_y = int(std::clamp(std::floor(y1), -1.0, double(grid.rows - 1)));
        const double area =
            (c[1].x() - c[0].x()) * (c[2].y() - c[0].y()) - (c[1].y() - c[0].y()) * (c[2].x() - c[0].x());
        if (area == 0) continue;
        for (int y = first_y; y <= last_y; ++y)
            for (int x = first_x; x <= last_x; ++x) {
                std::array<double, 3> share{};
                bool inside = true;
                for (std::size_t k = 0; k < 3 && inside; ++k) {
                    const Vec3 &a = c[(k + 1) % 3], &b = c[(k + 2) % 3];
                    share[k] = ((b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x())) / area;
                    inside = share[k] >= 0;
                }
                if (!inside) continue;
                piece.raise(grid.index(x, y), share[0] * c[0].z() + share[1] * c[1].z() + share[2] * c[2].z(),
                            f);
            }
    }
}

} // namespace

int CoarseGrid::column(double x) const {
    return int(std::clamp(std::floor((x - origin.x()) / cell + 0.5), -1.0, double(columns)));
}

int CoarseGrid::row(double y) const {
    return int(std::clamp(std::floor((y - origin.y()) / cell + 0.5), -1.0, double(rows)));
}

CoarseGround::CoarseGround(const Mesh& mesh, std::size_t part_facets, const Mat3& turn, int cells,
                           const Progress& progress)
    : part_facets_(part_facets) {
    const Box3 box = parallel_reduce(
        part_facets, facets_per_look, Box3(), progress.part(0, 0.2),
        [&](std::size_t begin, std::size_t end) {
            Box3 b;
            for (std::size_t f = begin; f < end; ++f)
                for (int k = 0; k < 3; ++k)
                    b.add(turn * mesh.corner(f, k));
            return b;
        },
        [](Box3 all, const Box3& b) {
            all.add(b);
            return all;
        });
    const double longer = box.empty() ? 0 : std::max(box.size().x(), box.size().y());
    if (!(longer > 0))
        throw Error(ErrorCode::empty_result, "preview", "the part has no extent seen along the tool axis",
                    "turn the part or choose another tool axis");
    bottom_ = box.lo.z();
    top_ = box.hi.z();
    grid_.cell = longer / cells;
    grid_.columns = std::max(1, int(std::ceil(box.size().x() / grid_.cell - 1e-9)));
    grid_.rows = std::max(1, int(std::ceil(box.size().y() / grid_.cell - 1e-9)));
    grid_.origin = box.center().head<2>() - 0.5 * grid_.cell * Vec2(grid_.columns - 1, grid_.rows - 1);

    // Each piece of the mesh has a grid of its own; put together in their order they are the same whoever
    // made them.
    std::vector<GroundPiece> pieces(ground_pieces, GroundPiece(grid_.size()));
    const std::size_t facets = mesh.facet_count();
    const Progress putting = progress.part(0.2, 1);
    parallel_for(ground_pieces, 1, putting, [&](std::size_t p) {
        const std::size_t end = facets * (p + 1) / ground_pieces;
        for (std::size_t f = facets * p / ground_pieces; f < end; f += facets_per_look) {
            putting.check();
            put_facets(mesh, turn, grid_, f, std::min(f + facets_per_look, end), pieces[p]);
        }
    });
    GroundPiece& all = pieces[0];
    for (std::size_t p = 1; p < ground_pieces; ++p)
        all.add(pieces[p]);
    for (std::size_t i = 0; i < grid_.size(); ++i) {
        if (is_there(all.height[i])) continue;
        all.height[i] = all.corner[i];
        all.facet[i] = all.corner_facet[i];
    }
    height_ = std::move(all.height);
    low_ = std::move(all.low);
    facet_ = std::move(all.facet);
}

CoarseGround CoarseGround::halved() const {
    CoarseGround half;
    half.part_facets_ = part_facets_;
    half.bottom_ = bottom_;
    half.top_ = top_;
    half.grid_.cell = 2 * grid_.cell;
    half.grid_.columns = (grid_.columns + 1) / 2;
    half.grid_.rows = (grid_.rows + 1) / 2;
    half.grid_.origin = grid_.origin + Vec2::Constant(0.5 * grid_.cell);
    half.height_.assign(half.grid_.size(), nothing_there);
    half.low_.assign(half.grid_.size(), no_low);
    half.facet_.assign(half.grid_.size(), no_index);
    for (int y = 0; y < grid_.rows; ++y)
        for (int x = 0; x < grid_.columns; ++x) {
            const std::size_t from = grid_.index(x, y), to = half.grid_.index(x / 2, y / 2);
            half.low_[to] = std::min(half.low_[to], low_[from]);
            if (height_[from] <= half.height_[to]) continue;
            half.height_[to] = height_[from];
            half.facet_[to] = facet_[from];
        }
    return half;
}

Mesh CoarseGround::mesh() const {
    const CoarseGround half = halved();
    const CoarseGrid& grid = half.grid();
    Mesh mesh;
    std::vector<Index> vertex(grid.size(), no_index);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (!half.on_part(i)) continue;
        vertex[i] = Index(mesh.vertices.size());
        const Vec2 p = grid.middle(i);
        mesh.vertices.emplace_back(p.x(), p.y(), double(half.height()[i]));
    }
    for (int y = 0; y + 1 < grid.rows; ++y)
        for (int x = 0; x + 1 < grid.columns; ++x) {
            const std::array<Index, 4> c = {vertex[grid.index(x, y)], vertex[grid.index(x + 1, y)],
                                            vertex[grid.index(x + 1, y + 1)], vertex[grid.index(x, y + 1)]};
            if (std::ranges::find(c, no_index) != c.end()) continue;
            mesh.facets.push_back({c[0], c[1], c[2]});
            mesh.facets.push_back({c[0], c[2], c[3]});
        }
    return mesh;
}

std::vector<float> distance_from(const std::vector<char>& set, const CoarseGrid& grid) {
    const float side = float(grid.cell), corner = side * std::numbers::sqrt2_v<float>;
    std::vector<float> distance(grid.size());
    for (std::size_t i = 0; i < distance.size(); ++i)
        distance[i] = set[i] ? 0 : std::numeric_limits<float>::max() / 4;
    const auto pass = [&](int first, int end, int by) {
        const int across = by > 0 ? 0 : grid.columns - 1;
        for (int y = first; y != end; y += by)
            for (int k = 0, x = across; k < grid.columns; ++k, x += by) {
                float& d = distance[grid.index(x, y)];
                const auto from = [&](int nx, int ny, float step) {
                    if (grid.has(nx, ny)) d = std::min(d, distance[grid.index(nx, ny)] + step);
                };
                from(x - by, y, side);
                from(x, y - by, side);
                from(x - by, y - by, corner);
                from(x + by, y - by, corner);
            }
    };
    pass(0, grid.rows, 1);
    pass(grid.rows - 1, -1, -1);
    return distance;
}

} // namespace facetmill
