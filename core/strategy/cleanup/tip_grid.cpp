#include "core/strategy/cleanup/tip_grid.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Places are so far apart, in radii; where they would be too many, the last of these, or there are none.
constexpr std::array<double, 2> tip_shares{0.1, 0.2};
constexpr double max_tips = 4e6, max_tip_tiles = 2e7;
constexpr std::size_t places_at_once = std::size_t(1) << 18;
/// Tiles so far beside those of the bands are about them, and all so far beside are known: a tile is eight
/// places wide, and the cutter's radius at most ten.
constexpr int tiles_about = 1, tiles_known = 3;

/// Marks all that are so near to a mark, to either side and up and down.
std::vector<char> widened(const std::vector<char>& marks, int columns, int rows, int by) {
    std::vector<char> along(marks.size(), 0), result(marks.size(), 0);
    const auto at = [&](int x, int y) { return std::size_t(y) * std::size_t(columns) + std::size_t(x); };
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            if (marks[at(x, y)] != 0)
                for (int k = std::max(x - by, 0); k <= std::min(x + by, columns - 1); ++k)
                    along[at(k, y)] = 1;
    for (int y = 0; y < rows; ++y)
        for (int k = std::max(y - by, 0); k <= std::min(y + by, rows - 1); ++k)
            for (int x = 0; x < columns; ++x)
                result[at(x, y)] = result[at(x, y)] | along[at(x, k)];
    return result;
}

} // namespace

/// The nearest so far: the square of its distance from the disc that the cutter is rounded about.
struct TipGrid::Best {
    float square;
    Vec2 at = Vec2::Zero();
    bool found = false;
};

TipGrid::TipGrid(const AxialLift& lift, const CutterCover& cover, const Box3& part,
                 std::span<const RestBand* const> bands, const Progress& progress)
    : radius_(cover.radius()) {
    if (!cover.rounded_disc()) return;
    disc_ = cover.rounded_disc()->disc;
    rounding_ = cover.rounded_disc()->rounding;
    if (std::any_of(tip_shares.begin(), tip_shares.end(),
                    [&](double share) { return make_tiles(share, part, bands); }))
        find_heights(lift, progress);
}

TipGrid::Tile TipGrid::tile_of(const Vec2& p) const {
    const Vec2 rel = (p - lo_) / (tile * spacing_);
    return {std::clamp(int(std::floor(rel.x())), 0, columns_ - 1),
            std::clamp(int(std::floor(rel.y())), 0, rows_ - 1)};
}

/// False where they would be too many.
bool TipGrid::make_tiles(double share, const Box3& part, std::span<const RestBand* const> bands) {
    spacing_ = share * radius_;
    const double side = tile * spacing_;
    const Vec2 size = part.size().head<2>() / side;
    about_.clear();
    if (!(size.x() * size.y() < max_tip_tiles)) return false;
    constexpr int beside = tiles_known + 1;
    lo_ = part.lo.head<2>() - Vec2::Constant(beside * side);
    columns_ = int(size.x()) + 2 * beside + 1;
    rows_ = int(size.y()) + 2 * beside + 1;
    std::vector<char> marks(std::size_t(columns_) * std::size_t(rows_), 0);
    for (const RestBand* band : bands)
        for (const auto& [a, b, c] : band->band) {
            const auto [x0, y0] = tile_of(a.cwiseMin(b).cwiseMin(c).head<2>());
            const auto [x1, y1] = tile_of(a.cwiseMax(b).cwiseMax(c).head<2>());
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x)
                    marks[number(x, y)] = 1;
        }
    const std::vector<char> known = widened(marks, columns_, rows_, tiles_known);
    if (double(std::count(known.begin(), known.end(), 1)) * tile * tile > max_tips) return false;
    about_ = widened(marks, columns_, rows_, tiles_about);
    tiles_.assign(known.size(), no_tile);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < known.size(); ++i)
        if (known[i] != 0) tiles_[i] = count++;
    lowest_.assign(count, float(infinity));
    return true;
}

void TipGrid::find_heights(const AxialLift& lift, const Progress& progress) {
    heights_.resize(lowest_.size() * tile * tile);
    // Some at a time: all together they would be by far the most that clean-up has to remember at once.
    std::vector<Vec2> places;
    places.reserve(places_at_once + tile * tile);
    std::vector<double> found;
    std::size_t done = 0;
    const auto ask = [&] {
        found.resize(places.size());
        lift.tip_z(places, found,
                   progress.part(double(done) / double(heights_.size()),
                                 double(done + places.size()) / double(heights_.size())));
        for (const double z : found) {
            // Where it meets nothing the cutter has no place.
            heights_[done] = z > -infinity ? float(z) : float(infinity);
            float& lowest = lowest_[done / (tile * tile)];
            lowest = std::min(lowest, heights_[done]);
            ++done;
        }
        places.clear();
    };
    for (int y = 0; y < rows_; ++y)
        for (int x = 0; x < columns_; ++x) {
            if (tiles_[number(x, y)] == no_tile) continue;
            for (int k = 0; k < tile * tile; ++k)
                places.emplace_back(corner(x, y) + spacing_ * Vec2(k % tile, k / tile));
            if (places.size() >= places_at_once) ask();
        }
    if (!places.empty()) ask();
}

bool TipGrid::is_about(const Vec3& p) const {
    if (about_.empty()) return false;
    const auto [x, y] = tile_of(p.head<2>());
    return about_[number(x, y)] != 0;
}

void TipGrid::look_at(int x, int y, const Vec3& p, Best& best) const {
    const std::uint32_t known = tiles_[number(x, y)];
    if (known == no_tile) return;
    const double width = (tile - 1) * spacing_;
    const Vec2 rel = corner(x, y) - p.head<2>();
    const double away =
        std::hypot(std::max({rel.x(), -rel.x() - width, 0.0}), std::max({rel.y(), -rel.y() - width, 0.0}));
    const double beside = std::max(away - disc_, 0.0),
                 below = std::max(double(lowest_[known]) + rounding_ - p.z(), 0.0);
    if (!(beside * beside + below * below < double(best.square))) return;
    using Row = Eigen::Array<float, tile, 1>;
    const Row along = (float(rel.x()) + float(spacing_) * Row::LinSpaced(tile, 0, tile - 1)).square();
    const float* heights = heights_.data() + std::size_t(known) * tile * tile;
    for (int k = 0; k < tile; ++k, heights += tile) {
        const auto across = float(rel.y() + spacing_ * k);
        Row square = along + across * across;
        if (disc_ > 0) square = (square.sqrt() - float(disc_)).max(0.0F).square();
        square += (Eigen::Map<const Row>(heights) - float(p.z() - rounding_)).max(0.0F).square();
        if (!(square.minCoeff() < best.square)) continue;
        int first = 0;
        best.square = square.minCoeff(&first);
        best.at = corner(x, y) + spacing_ * Vec2(first, k);
        best.found = true;
    }
}

std::optional<Vec2> TipGrid::nearest(const Vec3& p, double within) const {
    if (about_.empty() || !(within > 0)) return std::nullopt;
    const double reach = within + rounding_;
    Best best{float(reach * reach)};
    const Vec2 at = p.head<2>(), beside = Vec2::Constant(disc_ + reach);
    // Mostly it is one about the place.
    const Tile middle = tile_of(at), from = tile_of(at - beside), to = tile_of(at + beside);
    look_at(middle[0], middle[1], p, best);
    for (int y = from[1]; y <= to[1]; ++y)
        for (int x = from[0]; x <= to[0]; ++x)
            if (x != middle[0] || y != middle[1]) look_at(x, y, p, best);
    return best.found ? std::optional(best.at) : std::nullopt;
}

} // namespace facetmill
