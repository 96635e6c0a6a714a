#include "core/verify/loose_pieces.h"

#include "core/verify/playback.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace facetmill {

namespace {

/// So many rays in all: a look at them takes a tenth of a second. The first are too few to tell a piece from
/// a rod between rays.
constexpr double min_searched_rays = 1e4, search_rays = 1e5, max_searched_rays = 3e5;
/// Pieces that are smaller than this share of all that is left are crumbs; larger ones than the other are no
/// chips of the stock, but a frame that the part hung in.
constexpr double crumb_share = 1e-3, frame_share = 0.02;
/// Facets of the part that are asked which piece lies behind them, at most, and how far behind, in spacings.
constexpr std::size_t asked_facets = 400;
constexpr double behind = 1.5;

/// Stretches of material of all three families of rays, numbered through.
class Stretches {
public:
    Stretches(const StockModel& stock, const Progress& progress) : lattice_(stock.lattice()) {
        for (int axis = 0; axis < 3; ++axis) {
            const int n = across(axis, 0), m = across(axis, 1);
            first_[axis].reserve(std::size_t(n) * std::size_t(m) + 1);
            for (int j = 0; j < m; ++j) {
                progress.check();
                for (int i = 0; i < n; ++i) {
                    first_[axis].push_back(ends_.size());
                    for (const auto& stretch : stock.stretches(axis, i, j))
                        ends_.push_back(stretch);
                }
            }
            first_[axis].push_back(ends_.size());
        }
        above_.resize(ends_.size());
        std::iota(above_.begin(), above_.end(), std::size_t(0));
        for (int axis = 0; axis < 3; ++axis)
            join_neighbours(axis, progress);
        join_crossings(progress);
    }

    /// Nodes across an axis: along the next one (0) and the one after that (1).
    int across(int axis, int which) const { return lattice_.nodes[std::size_t((axis + 1 + which) % 3)]; }
    /// Numbers of the first stretch of a ray and of the one behind its last.
    std::array<std::size_t, 2> of(int axis, int i, int j) const {
        const std::size_t ray = std::size_t(i) + std::size_t(j) * std::size_t(across(axis, 0));
        return {first_[axis][ray], first_[axis][ray + 1]};
    }
    const std::array<double, 2>& ends(std::size_t stretch) const { return ends_[stretch]; }
    /// The same number for all that hang together.
    std::size_t root(std::size_t stretch) const {
        while (above_[stretch] != stretch)
            stretch = above_[stretch] = above_[above_[stretch]];
        return stretch;
    }

private:
    void join(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        if (a != b) above_[std::max(a, b)] = std::min(a, b);
    }
    void join_overlaps(const std::array<std::size_t, 2>& a, const std::array<std::size_t, 2>& b) {
        for (std::size_t p = a[0], q = b[0]; p < a[1] && q < b[1];) {
            if (std::min(ends_[p][1], ends_[q][1]) > std::max(ends_[p][0], ends_[q][0])) join(p, q);
            if (ends_[p][1] < ends_[q][1])
                ++p;
            else
                ++q;
        }
    }
    void join_neighbours(int axis, const Progress& progress) {
        const int n = across(axis, 0), m = across(axis, 1);
        for (int j = 0; j < m; ++j) {
            progress.check();
            for (int i = 0; i < n; ++i) {
                if (i + 1 < n) join_overlaps(of(axis, i, j), of(axis, i + 1, j));
                if (j + 1 < m) join_overlaps(of(axis, i, j), of(axis, i, j + 1));
            }
        }
    }
    /// The rays along X and Y through every node that lies on a stretch along Z.
    void join_crossings(const Progress& progress) {
        for (int y = 0; y < across(2, 1); ++y) {
            progress.check();
            for (int x = 0; x < across(2, 0); ++x)
                for (auto [s, end] = of(2, x, y); s < end; ++s) {
                    const double z0 = lattice_.origin.z(), step = lattice_.spacing.z();
                    const int low = std::max(0, int(std::ceil((ends_[s][0] - z0) / step))),
                              high =
                                  std::min(lattice_.nodes[2] - 1, int(std::floor((ends_[s][1] - z0) / step)));
                    for (int z = low; z <= high; ++z) {
                        const Vec3 node = lattice_.node(x, y, z);
                        join_at(s, 0, y, z, node.x());
                        join_at(s, 1, z, x, node.y());
                    }
                }
        }
    }
    void join_at(std::size_t stretch, int axis, int i, int j, double at) {
        for (auto [s, end] = of(axis, i, j); s < end; ++s)
            if (ends_[s][0] <= at && at <= ends_[s][1]) return join(stretch, s);
    }

    const StockLattice& lattice_;
    std::array<std::vector<std::size_t>, 3> first_;
    std::vector<std::array<double, 2>> ends_;
    mutable std::vector<std::size_t> above_; ///< joined to it; itself: to none
};

/// Which of the pieces the part lies in: what most of its facets have behind them.
std::optional<std::size_t> piece_of(const Mesh& part, const StockPieces& pieces, double spacing) {
    std::map<std::size_t, std::size_t> votes;
    const std::size_t stride = std::max<std::size_t>(1, part.facet_count() / asked_facets);
    for (std::size_t f = 0; f < part.facet_count(); f += stride) {
        const Vec3 middle = (part.corner(f, 0) + part.corner(f, 1) + part.corner(f, 2)) / 3,
                   in = behind * spacing * part.facet_normal(f);
        for (const Vec3& place : {Vec3(middle - in), Vec3(middle + in)})
            if (const auto piece = pieces.at(place)) ++votes[*piece];
    }
    std::optional<std::size_t> most;
    for (const auto& [piece, count] : votes)
        if (!most || count > votes[*most]) most = piece;
    return most;
}

double volume_of(const StockPieces& pieces) {
    double all = 0;
    for (const StockPiece& piece : pieces.pieces())
        all += piece.volume;
    return all;
}

/// Whether something larger than a crumb has come off by then.
bool in_pieces(const StockModel& stock, double crumb, const Progress& progress) {
    const StockPieces pieces(stock, progress);
    return pieces.pieces().size() > 1 && pieces.pieces()[1].volume > crumb;
}

/// The first motion after which there is more than one piece, as there is at the end.
MotionPlace first_apart(StockPlayback& playback, double crumb, const Progress& progress) {
    std::size_t whole = 0, apart = playback.motion_count();
    while (apart - whole > 1) {
        const std::size_t middle = (whole + apart) / 2;
        playback.go_to(double(middle), progress);
        (in_pieces(playback.stock(), crumb, progress) ? apart : whole) = middle;
    }
    return playback.place(double(whole));
}

} // namespace

StockPieces::StockPieces(const StockModel& stock, const Progress& progress) : lattice_(stock.lattice()) {
    const Stretches stretches(stock, progress);
    const double cell = lattice_.spacing.x() * lattice_.spacing.y();
    std::map<std::size_t, std::size_t> number;
    for (int y = 0; y < stretches.across(2, 1); ++y)
        for (int x = 0; x < stretches.across(2, 0); ++x) {
            first_.push_back(along_z_.size());
            for (auto [s, end] = stretches.of(2, x, y); s < end; ++s) {
                const auto [known, fresh] = number.try_emplace(stretches.root(s), pieces_.size());
                if (fresh) pieces_.emplace_back();
                StockPiece& piece = pieces_[known->second];
                const auto& [lo, hi] = stretches.ends(s);
                piece.volume += cell * (hi - lo);
                for (const double z : {lo, hi}) {
                    Vec3 end_point = lattice_.node(x, y, 0);
                    end_point.z() = z;
                    piece.box.add(end_point);
                }
                along_z_.push_back({lo, hi, known->second});
            }
        }
    first_.push_back(along_z_.size());
    std::vector<std::size_t> order(pieces_.size()), place(pieces_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return pieces_[a].volume > pieces_[b].volume; });
    std::vector<StockPiece> sorted;
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i;
        sorted.push_back(pieces_[order[i]]);
    }
    pieces_ = std::move(sorted);
    for (Stretch& stretch : along_z_)
        stretch.piece = place[stretch.piece];
}

std::optional<std::size_t> StockPieces::at(const Vec3& p) const {
    const Vec3 steps = (p - lattice_.origin).cwiseQuotient(lattice_.spacing);
    const long x = std::lround(steps.x()), y = std::lround(steps.y());
    if (x < 0 || y < 0 || x >= lattice_.nodes[0] || y >= lattice_.nodes[1]) return std::nullopt;
    const std::size_t ray = std::size_t(x) + std::size_t(y) * std::size_t(lattice_.nodes[0]);
    for (std::size_t s = first_[ray]; s < first_[ray + 1]; ++s)
        if (along_z_[s].lo <= p.z() && p.z() <= along_z_[s].hi) return along_z_[s].piece;
    return std::nullopt;
}

std::optional<LoosePieces> loose_pieces(const Mesh& part, const StockModel& left,
                                        std::span<const VerifyProgram> programs, const Progress& progress) {
    const StockSolid& stock = left.solid();
    const Vec3 size = stock.box.size();
    const double faces = size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
    const double rays = double(left.lattice().rays());
    const bool anew = rays < min_searched_rays || rays > max_searched_rays;
    const double spacing = anew ? std::sqrt(faces / std::clamp(rays, min_searched_rays, search_rays))
                                : left.lattice().spacing.maxCoeff();
    std::optional<StockPlayback> playback;
    const auto play = [&](const Progress& part_of) -> StockPlayback& {
        if (!playback)
            playback.emplace(stock, std::vector(programs.begin(), programs.end()), spacing, part_of);
        return *playback;
    };
    if (anew) play(progress.part(0, 0.05)).go_to(double(playback->motion_count()), progress.part(0.05, 0.4));
    const StockPieces pieces(anew ? playback->stock() : left, progress);
    const double crumb = crumb_share * volume_of(pieces);
    if (pieces.pieces().size() < 2 || !(pieces.pieces()[1].volume > crumb)) return std::nullopt;
    const std::size_t own = piece_of(part, pieces, spacing).value_or(0);
    LoosePieces loose;
    for (std::size_t i = 0; i < pieces.pieces().size() && pieces.pieces()[i].volume > crumb; ++i) {
        if (i == own) continue;
        if (loose.count++ == 0) loose.largest = pieces.pieces()[i];
    }
    loose.part_is_free = loose.largest.volume > frame_share * volume_of(pieces);
    loose.at = first_apart(play(progress.part(0.4, 0.4)), crumb, progress.part(0.4, 1));
    progress.set(1.0);
    return loose;
}

} // namespace facetmill
