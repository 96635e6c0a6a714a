#include "core/verify/stock_model.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/verify/stock_tiles.h"

#include <cmath>

namespace facetmill {

std::uint64_t RayTile::next_stamp() {
    static std::atomic<std::uint64_t> last{0};
    return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

std::uint32_t RayTile::take() {
    if (spare != none) {
        const std::uint32_t place = spare;
        spare = more[place].next;
        return place;
    }
    more.emplace_back();
    return std::uint32_t(more.size() - 1);
}

void RayTile::give_back(std::uint32_t place) {
    more[place].next = spare;
    spare = place;
}

void RayTile::append(int ray, float from, float to) {
    Piece* last = &first[std::size_t(ray)];
    if (last->empty()) {
        *last = {from, to, none};
        return;
    }
    std::uint32_t at = none;
    while (last->next != none) {
        at = last->next;
        last = &more[at];
    }
    const std::uint32_t place = take();
    (at == none ? first[std::size_t(ray)] : more[at]).next = place;
    more[place] = {from, to, none};
}

double RayTile::remove(int ray, float from, float to) {
    Piece& head = first[std::size_t(ray)];
    if (head.empty()) return 0;
    double length = 0;
    // `before` leads to the piece at hand; pieces are named by place, as `more` may grow.
    std::uint32_t before = none, at = none; // `at` none: the head
    while (true) {
        Piece& p = at == none ? head : more[at];
        if (p.lo >= to) break;
        const std::uint32_t next = p.next;
        if (p.hi > from) {
            length += double(std::min(p.hi, to)) - double(std::max(p.lo, from));
            if (p.lo < from && p.hi > to) {
                const float end = p.hi;
                p.hi = from;
                const std::uint32_t place = take();
                more[place] = {to, end, next};
                (at == none ? head : more[at]).next = place;
                break;
            }
            if (p.lo < from) {
                p.hi = from;
            } else if (p.hi > to) {
                p.lo = to;
                break;
            } else if (at != none) {
                (before == none ? head : more[before]).next = next;
                give_back(at);
                at = next;
                if (at == none) break;
                continue;
            } else if (next == none) {
                head = Piece();
                break;
            } else {
                head = more[next];
                give_back(next);
                continue;
            }
        }
        if (next == none) break;
        before = at;
        at = next;
    }
    return length;
}

void RayTile::find_bounds() {
    lo = 1;
    hi = -1;
    for (const Piece& head : first) {
        if (head.empty()) continue;
        const Piece* last = &head;
        while (last->next != none)
            last = &more[last->next];
        lo = lo > hi ? head.lo : std::min(lo, head.lo);
        hi = std::max(hi, last->hi);
    }
}

std::size_t StockLattice::rays() const {
    const auto n = [&](int k) { return std::size_t(nodes[std::size_t(k)]); };
    return n(0) * n(1) + n(1) * n(2) + n(2) * n(0);
}

namespace {
/// Rays of a lattice, at most: the tables of their tiles alone take 90 MB then.
constexpr double max_rays = 1e9;
} // namespace

double StockLattice::rays_over(const Box3& box, double resolution) {
    const Vec3 n = (box.size() / resolution).array().ceil() + 1;
    return n.x() * n.y() + n.y() * n.z() + n.z() * n.x();
}

StockLattice StockLattice::over(const Box3& box, double resolution, LengthUnit unit) {
    const Vec3 size = box.size();
    if (box.empty() || !(size.minCoeff() > 0))
        throw Error(ErrorCode::empty_result, "stock", "has no volume", "give the stock a margin");
    if (!(resolution > 0) || !std::isfinite(resolution))
        throw Error(ErrorCode::out_of_range, "resolution", "is not above 0", "enter a positive length");
    if (const double rays = rays_over(box, resolution); !(rays <= max_rays))
        throw Error(ErrorCode::limit_exceeded, "resolution",
                    length_text(resolution, unit) + " makes " + format_number(std::round(rays), 6)
                        + " rays through the stock, more than " + format_number(max_rays),
                    "use at least " + length_text(resolution * std::sqrt(rays / max_rays) * 1.01, unit, 3));
    StockLattice lattice;
    for (int k = 0; k < 3; ++k) {
        const int cells = std::max(1, int(std::ceil(size[k] / resolution)));
        const double inset = tolerance::lattice_inset * size[k] / cells;
        lattice.nodes[std::size_t(k)] = cells + 1;
        lattice.origin[k] = box.lo[k] + inset;
        lattice.spacing[k] = (size[k] - 2 * inset) / cells;
    }
    return lattice;
}

std::shared_ptr<RayTile> solid_tile(const StockSolid& solid, const StockLattice& lattice, int axis,
                                    int tile_i, int tile_j) {
    auto tile = std::make_shared<RayTile>();
    const int u = first_across(axis), v = second_across(axis);
    const Vec3 middle = solid.box.center();
    const double half = 0.5 * solid.box.size()[axis];
    for (int j = 0; j < RayTile::side; ++j)
        for (int i = 0; i < RayTile::side; ++i) {
            const int a = tile_i * RayTile::side + i, b = tile_j * RayTile::side + j;
            if (a >= lattice.nodes[std::size_t(u)] || b >= lattice.nodes[std::size_t(v)]) continue;
            double reach = half;
            if (solid.kind == StockSolid::Kind::cylinder) {
                const double x = lattice.origin[u] + a * lattice.spacing[u] - middle[u];
                const double y = lattice.origin[v] + b * lattice.spacing[v] - middle[v];
                // Of a ray along the cylinder both count; of one across it the one that is not along it.
                const double off = solid.axis == axis ? std::hypot(x, y) : solid.axis == u ? y : x;
                const double square = (solid.radius - off) * (solid.radius + off);
                if (square <= 0) continue;
                if (solid.axis != axis) reach = std::min(half, std::sqrt(square));
            }
            tile->append(i + RayTile::side * j, float(-reach), float(reach));
        }
    tile->find_bounds();
    return tile;
}

StockModel::StockModel(const StockSolid& solid, const StockLattice& lattice, const Progress& progress)
    : solid_(solid), lattice_(lattice) {
    for (int axis = 0; axis < 3; ++axis)
        tiles_[std::size_t(axis)].resize(
            std::size_t(tiles_of(lattice.nodes[std::size_t(first_across(axis))]))
            * std::size_t(tiles_of(lattice.nodes[std::size_t(second_across(axis))])));
    if (solid.kind == StockSolid::Kind::mesh) fill_from_mesh(solid, lattice, tiles_, progress);
    progress.set(1.0);
}

namespace {

/// fn(lo, hi) for every stretch of a ray, in coordinates from the middle.
template <class Fn>
void for_stretches(const RayTile& tile, int ray, Fn&& fn) {
    const RayTile::Piece* p = &tile.first[std::size_t(ray)];
    if (p->empty()) return;
    while (true) {
        fn(double(p->lo), double(p->hi));
        if (p->next == RayTile::none) return;
        p = &tile.more[p->next];
    }
}

} // namespace

std::vector<std::array<double, 2>> StockModel::stretches(int axis, int i, int j) const {
    const int across = tiles_of(lattice_.nodes[std::size_t(first_across(axis))]);
    const int ti = i / RayTile::side, tj = j / RayTile::side;
    std::shared_ptr<RayTile> tile =
        tiles_[std::size_t(axis)][std::size_t(ti) + std::size_t(across) * std::size_t(tj)];
    if (!tile) tile = solid_tile(solid_, lattice_, axis, ti, tj);
    std::vector<std::array<double, 2>> found;
    const double middle = solid_.box.center()[axis];
    for_stretches(*tile, i % RayTile::side + RayTile::side * (j % RayTile::side), [&](double lo, double hi) {
        found.push_back({lo + middle, hi + middle});
    });
    return found;
}

double StockModel::volume() const {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = first_across(axis), v = second_across(axis);
        const int nu = lattice_.nodes[std::size_t(u)], nv = lattice_.nodes[std::size_t(v)];
        double lengths = 0;
        for (int tj = 0; tj < tiles_of(nv); ++tj)
            for (int ti = 0; ti < tiles_of(nu); ++ti) {
                auto tile =
                    tiles_[std::size_t(axis)][std::size_t(ti) + std::size_t(tiles_of(nu)) * std::size_t(tj)];
                if (!tile) tile = solid_tile(solid_, lattice_, axis, ti, tj);
                for (int ray = 0; ray < RayTile::side * RayTile::side; ++ray) {
                    const int i = ti * RayTile::side + ray % RayTile::side,
                              j = tj * RayTile::side + ray / RayTile::side;
                    // Rays on the border stand for half a cell.
                    const double weight =
                        (i == 0 || i == nu - 1 ? 0.5 : 1) * (j == 0 || j == nv - 1 ? 0.5 : 1);
                    for_stretches(*tile, ray, [&](double lo, double hi) { lengths += weight * (hi - lo); });
                }
            }
        sum += lengths * lattice_.spacing[u] * lattice_.spacing[v];
    }
    return sum / 3;
}

std::size_t StockModel::bytes() const {
    std::size_t sum = sizeof *this;
    for (const auto& family : tiles_) {
        sum += family.capacity() * sizeof family[0];
        for (const auto& tile : family)
            if (tile) sum += sizeof *tile + tile->more.capacity() * sizeof(RayTile::Piece);
    }
    return sum;
}

} // namespace facetmill
