// Places of the cutter on a grid about bands, all asked at once, and which of them comes nearest to a place
// of the part. A search from there on has few steps left, and where none comes near enough there is none to
// search. Millimetres, part coordinates, axis +Z.
#pragma once

#include "core/gouge/axial_lift.h"
#include "core/strategy/cleanup/rest_band.h"
#include "core/strategy/surface/cutter_cover.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

class TipGrid {
public:
    /// About the bands, up to the cutter's radius and a little more beyond them. Empty for a cutter that is
    /// no rounded disc, and where so many places as it would take are not worth it.
    TipGrid(const AxialLift& lift, const CutterCover& cover, const Box3& part,
            std::span<const RestBand* const> bands, const Progress& progress);

    /// Are all places known that the cutter takes near p?
    bool is_about(const Vec3& p) const;
    /// The place (x, y) of the tip from which the cutter comes nearest to p, of those on the grid that come
    /// nearer than `within`.
    std::optional<Vec2> nearest(const Vec3& p, double within) const;
    /// Between neighbours.
    double spacing() const { return spacing_; }

private:
    static constexpr int tile = 8; ///< places, each way
    static constexpr std::uint32_t no_tile = 0xFFFFFFFFu;
    using Tile = std::array<int, 2>;
    struct Best;

    Tile tile_of(const Vec2& p) const;
    std::size_t number(int x, int y) const { return std::size_t(y) * std::size_t(columns_) + std::size_t(x); }
    Vec2 corner(int x, int y) const { return lo_ + tile * spacing_ * Vec2(x, y); }
    bool make_tiles(double share, const Box3& part, std::span<const RestBand* const> bands);
    void find_heights(const AxialLift& lift, const Progress& progress);
    void look_at(int x, int y, const Vec3& p, Best& best) const;

    double radius_, disc_ = 0, rounding_ = 0;
    double spacing_ = 0;
    Vec2 lo_ = Vec2::Zero();
    int columns_ = 0, rows_ = 0;       ///< of tiles
    std::vector<char> about_;          ///< tiles in and beside bands
    std::vector<std::uint32_t> tiles_; ///< which of `heights_`; no_tile: not known
    std::vector<float> lowest_;        ///< per known tile
    std::vector<float> heights_; ///< tip heights, known tile by known tile, rows along X; infinite: none
};

} // namespace facetmill
