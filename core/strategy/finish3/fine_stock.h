// What stands within single cells of a StockField, for shank and holder: what operations before leave on an
// upright wall is thinner than a cell, and a shank as wide as the cutter slides along it. Millimetres, part
// coordinates.
//
// Over a cell that is asked about points are spread, and what cut near it is asked how high it left each of
// them; and of points on the rim of a body, into which the cusps of passes on a wall come less deep than
// points of cells are apart. Few cells are asked: those that a wall crosses, beside passes that run deeper
// along it than the flutes are long.
#pragma once

#include "core/gouge/axial_lift.h"
#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/stock_field.h"

#include <cstdint>
#include <vector>

namespace facetmill {

class FineStock {
public:
    /// For a field of what operations before left, and for points about `spacing` apart, farther where a
    /// cell would have more than a thousand. What stands no
    /// farther than `skin` from the part, or above it, is not asked, nor what is lower than `from`. `cutter`
    /// is that of the operation, with which cut() cuts. No cell that lies outside `within`, seen along Z, by
    /// more than one of them is asked about. The field has to outlive this.
    FineStock(const PlanContext& context, const StockField& field, const StockCutter& cutter, double spacing,
              double skin, double from, const Box3& within);

    /// How much higher than `base` something stands in a cell (as StockField counts them) within `radius` of
    /// p; 0 where nothing does.
    double over(std::size_t cell, const Vec2& p, double radius, double base);
    void cut(const Vec3& a, const Vec3& b);

private:
    struct Cut {
        Vec3 a, b;
        std::uint32_t cutter;
    };
    /// The points over a cell.
    struct Points {
        std::size_t cuts = 0;             ///< of its tile, that were asked
        std::vector<std::uint32_t> near;  ///< of these, what comes near the cell
        std::vector<std::uint32_t> chain; ///< of these, what lowered a point on a rim, one after the other
        float top;                        ///< before any of them
        float highest;                    ///< no point is higher
        std::vector<float> heights;
    };
    struct Lowering {
        std::uint32_t cut;
        float left;
    };

    void add_cut(const Cut& cut);
    std::size_t tile_of(const Vec2& p) const;
    Vec2 center(std::size_t cell) const;
    Points& points(std::size_t cell);
    void cut_from(Points& points, const Vec2& center, std::uint32_t number) const;
    float lowered(float height, const Vec2& p, const Cut& cut) const;
    double over_rim(Points& points, std::size_t cell, const Vec2& p, double radius, double base);
    float standing(Points& points, const Vec2& p, double enough);
    void scan(Points& points, const Vec2& p);
    double part_top(const Vec2& p) const { return part_.tip_z(p.x(), p.y()) + skin_; }

    const StockField& field_;
    std::vector<StockCutter> cutters_; ///< the operation's own is the last
    AxialLift part_;
    double skin_, from_, half_diagonal_, tile_, rim_spacing_, rim_depth_;
    std::vector<Vec2> spread_; ///< the points of every cell, from its centre
    int tile_columns_ = 0, tile_rows_ = 0;
    std::vector<Cut> cuts_;
    std::vector<std::vector<std::uint32_t>> near_; ///< what may cut from the cells of a tile, in its order
    std::vector<std::int32_t> index_;              ///< of points_, by cells; below 0: none yet
    std::vector<Points> points_;
    std::vector<Lowering> lowerings_; ///< of one place: scan()'s own
};

} // namespace facetmill
