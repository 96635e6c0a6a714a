#include "core/verify/removal_batch.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace facetmill {

namespace {

/// Items between two looks at whether the job was cancelled: one item takes a tile's 256 rays a few
/// microseconds at most.
constexpr std::size_t items_per_check = 64;
/// Items whose rays one thread prepares at a time, which is less work than to hand them out one by one.
constexpr std::size_t items_per_block = 32;

std::ptrdiff_t bytes_of(const RayTile& tile) {
    return std::ptrdiff_t(sizeof tile + tile.more.capacity() * sizeof(RayTile::Piece));
}

/// Between what an item may lie on a ray, from the middle of the stock.
struct Bounds {
    float low, high;
};

/// How far an upright tool that moves straight reaches along rays, by how far these are from its way: closer
/// than its box, and without looking for where it is met.
class UprightReach {
public:
    /// Along the axis of a family of rays.
    UprightReach(const RemovalItem& item, const Vec3& middle, int axis) : axis_(axis) {
        const Vec3& up = item.move.axis;
        if (!(up.x() == 0 && up.y() == 0 && up.z() > 0)) return;
        body_ = item.body;
        // The rows of rays along x and z are apart in y, those of y in x.
        const int beside = axis == 1 ? 0 : 1;
        const Vec3 &a = item.move.from, &b = item.move.to;
        from_ = std::min(a[beside], b[beside]);
        to_ = std::max(a[beside], b[beside]);
        low_ = std::min(a[axis], b[axis]) - middle[axis] - slack;
        high_ = (axis == 2 ? item.box.hi[axis] : std::max(a[axis], b[axis])) - middle[axis] + slack;
    }
    bool is_known() const { return body_ != nullptr; }
    /// For rays at x or y, whichever is across them and no height.
    Bounds across(double place) const {
        const double radius = body_->radius() + slack, off = std::max({0.0, place - to_, from_ - place});
        if (off > radius) return {infinite, -infinite};
        if (axis_ == 2) {
            const double least = std::max(0.0, std::min(off, body_->radius()) - slack);
            return {float(low_ + body_->along(Vec3(least, 0, 0), Vec3::UnitZ()).lo), float(high_)};
        }
        const double half = std::sqrt((radius - off) * (radius + off));
        return {float(low_ - half), float(high_ + half)};
    }

private:
    static constexpr double slack = 1e-6; ///< mm; above the rounding of coordinates
    static constexpr float infinite = std::numeric_limits<float>::infinity();
    const TurnedBody* body_ = nullptr;
    int axis_;
    double from_ = 0, to_ = 0;  ///< the tip, across
    double low_ = 0, high_ = 0; ///< the tip along the rays; of those upward, `high_` is the body's top
};

/// One tile, and what items do to it one after the other.
class TileCut {
public:
    TileCut(RayTile& tile, const StockLattice& lattice, const Vec3& middle, int axis, int tile_i, int tile_j)
        : tile_(tile), lattice_(lattice), middle_(middle), axis_(axis), u_(first_across(axis)),
          v_(second_across(axis)), i0_(tile_i * RayTile::side), j0_(tile_j * RayTile::side) {
        for (int ray = 0; ray < RayTile::side * RayTile::side; ++ray)
            void_above_material(ray);
        find_all();
    }

    bool has_changed() const { return changed_; }
    /// Whether the last item, which is asked for that, has taken away enough to be cutting.
    bool has_cut() const { return cut_; }
    /// What it has taken away, mm^3.
    double volume() const { return volume_; }
    /// From so many rays.
    std::uint32_t rays() const { return rays_; }

    /// The longest overlap with what must not touch.
    const RemovalTouch& apply(const RemovalItem& item, const SweepRays& swept) {
        touch_ = {item.program, item.motion, item.kind, {}, {}};
        cut_ = false;
        volume_ = 0;
        rays_ = 0;
        low_ = float(item.box.lo[axis_] - middle_[axis_]);
        high_ = float(item.box.hi[axis_] - middle_[axis_]);
        if (is_void(all_, {low_, high_})) return touch_;
        const auto [ib, ie] = rays_within(item.box, u_, i0_);
        const auto [jb, je] = rays_within(item.box, v_, j0_);
        Vec3 p = middle_;
        p[u_] = lattice_.origin[u_] + i0_ * lattice_.spacing[u_];
        p[v_] = lattice_.origin[v_] + j0_ * lattice_.spacing[v_];
        const UprightReach reach(item, middle_, axis_);
        set_bounds({low_, high_});
        if (reach.is_known() && axis_ == 0)
            for (int i = ib; i < ie; ++i)
                set_bounds(i, reach.across(p[u_] + i * lattice_.spacing[u_]));
        const std::array<RowStrip, 2> strips{in_rays(swept.strips()[0], p), in_rays(swept.strips()[1], p)};
        for (int j = jb; j < je; ++j) {
            p[v_] = lattice_.origin[v_] + (j0_ + j) * lattice_.spacing[v_];
            if (reach.is_known() && axis_ != 0) {
                const Bounds bounds = reach.across(p[v_]);
                if (is_void(row(j), bounds)) continue;
                set_bounds(bounds);
            } else if (is_void(row(j), {low_, high_})) {
                continue;
            }
            int first = ib, last = ie - 1;
            for (const RowStrip& strip : strips)
                strip.narrow(j, first, last);
            if (first <= last) apply_to_row(item, swept, first, last, j, p);
        }
        if (!all_.known) find_all();
        return touch_;
    }

private:
    /// Rays of the tile across which a box lies, along one of the two directions: from, and one past the
    /// last.
    std::pair<int, int> rays_within(const Box3& box, int k, int start) const {
        const auto at = [&](double x) { return (x - lattice_.origin[k]) / lattice_.spacing[k] - start; };
        const int most = std::min(RayTile::side, lattice_.nodes[std::size_t(k)] - start);
        return {int(std::clamp(std::ceil(at(box.lo[k])), 0.0, double(most))),
                int(std::clamp(std::floor(at(box.hi[k])) + 1, 0.0, double(most)))};
    }

    /// A strip that lines have to be in, as the stretch of a row that is in it: from `low` to `high` in row
    /// 0, `shift` farther in each next one. In rays.
    struct RowStrip {
        double low = -infinity, high = infinity, shift = 0;
        bool along = false; ///< the strip runs along the rows: low, high and shift are across, in mm

        void narrow(int row, int& first, int& last) const {
            if (along) {
                if (row * shift < low || row * shift > high) last = -1;
                return;
            }
            // No ceil and floor, which are calls.
            constexpr int beyond = 2 * RayTile::side;
            const double from = std::max(low + row * shift, -1.0),
                         to = std::min(high + row * shift, beyond - 1.0);
            if (!(from < beyond && to > -1)) {
                last = -1;
                return;
            }
            first = std::max(first, beyond - int(beyond - from));
            last = std::min(last, int(to + beyond) - beyond);
        }
    };
    /// `p`: where ray (0, 0) of the tile is.
    RowStrip in_rays(const SweepRays::Strip& strip, const Vec3& p) const {
        const double start = strip.value.dot(p), step = strip.value[u_] * lattice_.spacing[u_],
                     next = strip.value[v_] * lattice_.spacing[v_];
        if (step == 0) return {strip.low - start, strip.high - start, next, true};
        const double a = (strip.low - start) / step, b = (strip.high - start) / step;
        return {std::min(a, b), std::max(a, b), -next / step, false};
    }

    /// What is void in all of some rays.
    struct Void {
        float lo = -std::numeric_limits<float>::infinity(), hi = std::numeric_limits<float>::infinity();
        bool known = false; ///< false: to be found anew
    };
    /// Whether what lies within the bounds is no material in any of them.
    static bool is_void(const Void& common, const Bounds& within) {
        return common.known && within.low >= common.lo && within.high <= common.hi;
    }
    /// Of all rays of a row, or of one.
    void set_bounds(const Bounds& bounds) {
        lane_low_.fill(bounds.low);
        lane_high_.fill(bounds.high);
    }
    void set_bounds(int lane, const Bounds& bounds) {
        lane_low_[std::size_t(lane)] = bounds.low;
        lane_high_[std::size_t(lane)] = bounds.high;
    }
    const Void& row(int j) {
        Void& common = rows_[std::size_t(j)];
        if (common.known) return common;
        common = {};
        const auto start = std::size_t(RayTile::side * j);
        for (std::size_t i = start; i < start + RayTile::side; ++i) {
            common.lo = void_lo_[i] > common.lo ? void_lo_[i] : common.lo;
            common.hi = void_hi_[i] < common.hi ? void_hi_[i] : common.hi;
        }
        common.known = true;
        return common;
    }
    void find_all() {
        all_ = {};
        for (int j = 0; j < RayTile::side; ++j) {
            const Void& common = row(j);
            all_.lo = std::max(all_.lo, common.lo);
            all_.hi = std::min(all_.hi, common.hi);
        }
        all_.known = true;
    }

    /// Rays `first` to `last` of row j; p is at the row's first one.
    void apply_to_row(const RemovalItem& item, const SweepRays& swept, int first, int last, int j, Vec3 p) {
        const int row_start = RayTile::side * j;
        std::array<std::int32_t, RayTile::side> filled;
        for (int i = 0; i < RayTile::side; ++i) {
            const auto ray = std::size_t(row_start + i);
            const auto lane = std::size_t(i);
            filled[lane] = int(lane_low_[lane] < void_lo_[ray]) | int(lane_high_[lane] > void_hi_[ray]);
        }
        while (first <= last && !filled[std::size_t(first)])
            ++first;
        while (first <= last && !filled[std::size_t(last)])
            --last;
        if (first > last) return;
        Vec3 step = Vec3::Zero();
        step[u_] = lattice_.spacing[u_];
        p[u_] = lattice_.origin[u_] + (i0_ + first) * lattice_.spacing[u_];
        SweepRow::Flags wanted{};
        for (int i = first; i <= last; ++i)
            wanted[std::size_t(i - first)] = filled[std::size_t(i)];
        SweepRow met;
        const auto start = std::size_t(row_start + first);
        met.ask(swept, p, step, last - first + 1, low_, high_, wanted, &void_lo_[start], &void_hi_[start]);
        for (int i = first; i <= last; ++i) {
            const auto lane = std::size_t(i - first);
            if (!wanted[lane] || !(met.lo[lane] <= met.hi[lane])) continue;
            const float from = float(met.lo[lane]), to = float(met.hi[lane]);
            const int ray = row_start + i;
            if (is_void(ray, from, to)) continue;
            if (find_void(ray, from, to)) continue;
            if (item.cuts) {
                if (item.length > 0 && !cut_) cut_ = overlap(ray, from, to) > air_depth;
                take(i, j, tile_.remove(ray, from, to));
                find_void(ray, from, to);
            } else {
                p[u_] = lattice_.origin[u_] + (i0_ + i) * lattice_.spacing[u_];
                see_overlaps(ray, from, to, p);
            }
        }
    }

    /// Notes that ray (i, j) of the tile has lost so much of its length.
    void take(int i, int j, double length) {
        if (!(length > 0)) return;
        changed_ = true;
        ++rays_;
        // As in StockModel::volume.
        const auto on_border = [&](int at, int k) {
            return at == 0 || at == lattice_.nodes[std::size_t(k)] - 1;
        };
        const double weight = (on_border(i0_ + i, u_) ? 0.5 : 1) * (on_border(j0_ + j, v_) ? 0.5 : 1);
        volume_ += weight * length * lattice_.spacing[u_] * lattice_.spacing[v_];
    }

    /// Whether [from, to] of a ray is known to hold no material.
    bool is_void(int ray, float from, float to) const {
        return from >= void_lo_[std::size_t(ray)] && to <= void_hi_[std::size_t(ray)];
    }
    void void_above_material(int ray) {
        const RayTile::Piece* piece = &tile_.first[std::size_t(ray)];
        void_lo_[std::size_t(ray)] = -std::numeric_limits<float>::infinity();
        void_hi_[std::size_t(ray)] = std::numeric_limits<float>::infinity();
        if (piece->empty()) return;
        while (piece->next != RayTile::none)
            piece = &tile_.more[piece->next];
        void_lo_[std::size_t(ray)] = piece->hi;
    }
    /// Remembers what is void round [from, to], if all of that is. Material only becomes less: it stays void.
    bool find_void(int ray, float from, float to) {
        float below = -std::numeric_limits<float>::infinity(), above = std::numeric_limits<float>::infinity();
        const RayTile::Piece* piece = &tile_.first[std::size_t(ray)];
        if (!piece->empty())
            for (;; piece = &tile_.more[piece->next]) {
                if (piece->lo >= to) {
                    above = piece->lo;
                    break;
                }
                if (piece->hi > from) return false;
                below = piece->hi;
                if (piece->next == RayTile::none) break;
            }
        void_lo_[std::size_t(ray)] = below;
        void_hi_[std::size_t(ray)] = above;
        rows_[std::size_t(ray / RayTile::side)].known = all_.known = false;
        return true;
    }

    double overlap(int ray, float from, float to) const {
        double most = 0;
        for (const RayTile::Piece* piece = &tile_.first[std::size_t(ray)];;
             piece = &tile_.more[piece->next]) {
            most = std::max(most, double(std::min(to, piece->hi)) - double(std::max(from, piece->lo)));
            if (piece->next == RayTile::none) return most;
        }
    }

    void see_overlaps(int ray, float from, float to, const Vec3& p) {
        const auto k = std::size_t(axis_);
        for (const RayTile::Piece* piece = &tile_.first[std::size_t(ray)];;
             piece = &tile_.more[piece->next]) {
            const double a = std::max(from, piece->lo), b = std::min(to, piece->hi);
            if (b - a > touch_.overlap[k]) {
                touch_.overlap[k] = b - a;
                touch_.place[k] = p;
                touch_.place[k][axis_] += 0.5 * (a + b);
            }
            if (piece->next == RayTile::none) break;
        }
    }

    RayTile& tile_;
    const StockLattice& lattice_;
    const Vec3& middle_;
    int axis_, u_, v_, i0_, j0_;
    float low_ = 0, high_ = 0;                              ///< of the item, along the rays
    std::array<float, RayTile::side> lane_low_, lane_high_; ///< the same on each ray of a row
    bool changed_ = false, cut_ = false;
    double volume_ = 0;
    std::uint32_t rays_ = 0;
    RemovalTouch touch_;
    /// Of each ray a stretch without material, the one last met.
    std::array<float, std::size_t(RayTile::side) * RayTile::side> void_lo_, void_hi_;
    std::array<Void, RayTile::side> rows_; ///< of each row
    Void all_;                             ///< of the tile
};

} // namespace

RemovalBatch::RemovalBatch(const StockSolid& solid, const StockLattice& lattice, TileFamilies& tiles,
                           const std::vector<RemovalItem>& items, int only)
    : solid_(solid), lattice_(lattice), tiles_(tiles), items_(items), cut_(items.size()),
      used_(items.size(), {false, false, false}), rays_(items.size()) {
    for (int axis = 0; axis < 3; ++axis)
        if (only < 0 || axis == only) find_work(axis);
    touches_.resize(work_.size());
    grown_.assign(work_.size(), 0);
}

/// Which tiles of a family an item may change.
void RemovalBatch::find_work(int axis) {
    const Vec3 middle = solid_.box.center();
    const auto k = std::size_t(axis);
    const auto tu = std::size_t(tiles_of(lattice_.nodes[std::size_t(first_across(axis))]));
    std::vector<std::int32_t> of_tile(tiles_[k].size(), -1);
    for (std::size_t n = 0; n < items_.size(); ++n) {
        const Box3& box = items_[n].box;
        const TileRange reached = tiles_in(box, lattice_, axis);
        for (int j = reached.from[1]; j <= reached.to[1]; ++j)
            for (int i = reached.from[0]; i <= reached.to[0]; ++i) {
                const std::size_t index = std::size_t(i) + tu * std::size_t(j);
                const auto& tile = tiles_[k][index];
                if (tile
                    && (tile->lo > tile->hi || box.lo[axis] - middle[axis] > tile->hi
                        || box.hi[axis] - middle[axis] < tile->lo))
                    continue;
                if (of_tile[index] < 0) {
                    of_tile[index] = std::int32_t(work_.size());
                    work_.push_back({axis, i, j, {}, {}});
                }
                work_[std::size_t(of_tile[index])].items.push_back(std::uint32_t(n));
                used_[n][k] = true;
            }
    }
}

std::shared_ptr<RayTile>& RemovalBatch::place_of(const Work& work) const {
    const auto tu = std::size_t(tiles_of(lattice_.nodes[std::size_t(first_across(work.axis))]));
    return tiles_[std::size_t(work.axis)][std::size_t(work.tile_i) + tu * std::size_t(work.tile_j)];
}

void RemovalBatch::run(const Progress& progress) {
    const Progress quiet = progress.part(0, 0); // cancels, and leaves the fraction alone
    parallel_for(items_.size(), items_per_block, quiet, [&](std::size_t n) {
        for (int axis = 0; axis < 3; ++axis)
            if (used_[n][std::size_t(axis)])
                rays_[n][std::size_t(axis)].emplace(*items_[n].body, items_[n].move, Vec3(Vec3::Unit(axis)));
    });
    parallel_for(work_.size(), 1, quiet, [&](std::size_t w) { apply(w, progress); });
}

void RemovalBatch::apply(std::size_t w, const Progress& progress) {
    Work& work = work_[w];
    const auto axis = std::size_t(work.axis);
    auto& place = place_of(work);
    const std::ptrdiff_t before = place ? bytes_of(*place) : 0;
    std::shared_ptr<RayTile> tile;
    if (!place)
        tile = solid_tile(solid_, lattice_, work.axis, work.tile_i, work.tile_j);
    else if (place.use_count() > 1) // shared with a copy of the model, which stays as it is
        tile = std::make_shared<RayTile>(*place);
    else
        tile = place;
    const Vec3 middle = solid_.box.center();
    TileCut cut(*tile, lattice_, middle, work.axis, work.tile_i, work.tile_j);
    std::size_t done = 0;
    work.removed.reserve(work.items.size());
    for (const std::uint32_t n : work.items) {
        if (++done % items_per_check == 0) progress.check();
        const RemovalTouch& touch = cut.apply(items_[n], *rays_[n][axis]);
        if (touch.overlap[axis] > 0) touches_[w].push_back(touch);
        if (cut.has_cut()) cut_[n].store(true, std::memory_order_relaxed);
        work.removed.push_back({float(cut.volume()), cut.rays()});
    }
    if (!cut.has_changed()) return; // what nothing was cut from stays as the solid is, and costs nothing
    tile->find_bounds();
    tile->stamp = RayTile::next_stamp();
    grown_[w] = bytes_of(*tile) - before;
    place = std::move(tile);
}

std::vector<double> RemovalBatch::volumes() const {
    struct Removed {
        std::array<double, 3> volume{0, 0, 0};
        std::array<std::size_t, 3> rays{0, 0, 0};
    };
    std::vector<Removed> by_family(items_.size());
    // In the order of tiles, whichever was done first.
    for (const Work& work : work_)
        for (std::size_t n = 0; n < work.removed.size(); ++n) {
            Removed& of = by_family[work.items[n]];
            of.volume[std::size_t(work.axis)] += double(work.removed[n].volume);
            of.rays[std::size_t(work.axis)] += work.removed[n].rays;
        }
    std::vector<double> volumes;
    volumes.reserve(by_family.size());
    for (const Removed& of : by_family) {
        const auto most = std::max_element(of.rays.begin(), of.rays.end()) - of.rays.begin();
        volumes.push_back(of.volume[std::size_t(most)]);
    }
    return volumes;
}

std::ptrdiff_t RemovalBatch::grown() const {
    return std::accumulate(grown_.begin(), grown_.end(), std::ptrdiff_t(0));
}

} // namespace facetmill
