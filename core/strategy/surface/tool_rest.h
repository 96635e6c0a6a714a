// What a tool leaves of a part that it has been over everywhere: hollows narrower than it, inner edges, feet
// of walls. Looked at along Z, the tool's axis; millimetres.
//
// A place of the surface is left where the cutter, wherever it can stand without cutting into the part, stays
// farther than an amount from it along its normal: the closing of the part with the cutter, asked place by
// place. The cutter counts by its shape up to its largest radius; shank, holder, stock and what operations
// really do play no part.
#pragma once

#include "core/gouge/axial_lift.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/surface/plan_region.h"

#include <array>
#include <vector>

namespace facetmill {

class ToolRest {
public:
    /// Throws Error(out_of_range) for an amount that is not above 0, Error(limit_exceeded) for a cutter so
    /// small against the part that the places to look at, a third of its radius apart, would be more than
    /// four million.
    ToolRest(ContactIndexPtr part, const CutterProfile& cutter, double more_than, const Progress& progress);

    /// How much higher the cutter stays, at its lowest over the place that lies the amount above the part's
    /// top there along the normal; not above 0: no more than that is left. -inf beside the part.
    double lack(const Vec2& p) const;
    /// The border of all places where something is left: closed loops that run counter-clockwise round them.
    /// Places are looked at `spacing` apart, so hollows and remains narrower than that can be missed; between
    /// them the border is where `lack` is 0, were it straight there. A single place that the cutter all but
    /// reaches does not count.
    std::vector<PlanEdge> outline(const Progress& progress) const;
    double spacing() const { return spacing_; }

    static constexpr double max_places = 4e6;

private:
    static constexpr std::size_t sides = 4;
    /// A place of the part's top, and the best that is known for it.
    struct Place {
        Vec3 over;                      ///< what the cutter is to hold
        Vec2 tip = Vec2::Zero();        ///< of the cutter, were the part even here
        std::array<Vec2, sides> beside; ///< those of the grid from which it comes nearest
        double lack = -infinity;
    };
    void find_tips(const Progress& progress);
    /// As far as the grid of tips tells; above 0 the lack may be too large.
    Place look(const Vec2& p) const;
    void look_on_grid(Place& place) const;
    void look_closer(Place& place) const;
    std::vector<double> lacks(const Progress& progress) const;
    void drop_specks(std::vector<double>& lacks) const;
    /// The eight places round one that is not an outer one.
    std::array<std::size_t, 8> neighbors(std::size_t i) const {
        return {i - columns_ - 1, i - columns_, i - columns_ + 1, i - 1, i + 1,
                i + columns_ - 1, i + columns_, i + columns_ + 1};
    }
    double over(const Vec3& q, const Vec2& tip, double tip_z) const;
    Vec2 tip_place(int column, int row) const { return tips_lo_ + tip_spacing_ * Vec2(column, row); }
    Vec2 place_at(std::size_t column, std::size_t row) const {
        return lo_ + spacing_ * Vec2(double(column), double(row));
    }

    ContactIndexPtr part_;
    AxialLift lift_, needle_;
    CutterCover cover_;
    double radius_, more_than_, spacing_ = 1;
    Vec2 lo_;                            ///< of the places; the outer ones lie beside the part
    std::size_t columns_ = 0, rows_ = 0; ///< of places
    double tip_spacing_ = 1;
    Vec2 tips_lo_;
    int tip_columns_ = 0, tip_rows_ = 0;
    std::vector<double> tips_;
    static constexpr int tile = 8; ///< tips, each way
    int tile_columns_ = 0, tile_rows_ = 0;
    std::vector<double> tile_lowest_;
};

} // namespace facetmill
