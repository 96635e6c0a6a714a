// A part as heights on a coarse grid, seen along the tool axis: enough to show where passes will run, and
// far from enough to plan them. Millimetres, coordinates of the view (the part turned so that the tool is
// upright).
//
// A cell's height is that of the highest facet over its middle; where none lies there, of the highest corner
// within it. Walls have no area on the grid: they are the jumps between cells, and a cell's lowest corner
// says how far down the part goes at its border.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <vector>

namespace facetmill {

/// Cells of a grid, row by row; a cell's middle is `origin` and so many cells on.
struct CoarseGrid {
    Vec2 origin = Vec2::Zero(); ///< middle of the first cell
    double cell = 1;            ///< mm
    int columns = 0, rows = 0;

    std::size_t size() const { return std::size_t(columns) * std::size_t(rows); }
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(columns) + std::size_t(x); }
    bool has(int x, int y) const { return x >= 0 && y >= 0 && x < columns && y < rows; }
    Vec2 middle(int x, int y) const { return origin + cell * Vec2(x, y); }
    Vec2 middle(std::size_t i) const {
        return middle(int(i % std::size_t(columns)), int(i / std::size_t(columns)));
    }
    int column(double x) const;
    int row(double y) const;
};

class CoarseGround {
public:
    /// A mesh of which the first `part_facets` facets are the part's and the others what no tool may touch
    /// (fixtures), turned by `turn`. `cells`: along the part's longer side. Throws Error(empty_result) for a
    /// part without extent seen so.
    CoarseGround(const Mesh& mesh, std::size_t part_facets, const Mat3& turn, int cells,
                 const Progress& progress);

    const CoarseGrid& grid() const { return grid_; }
    /// Highest place of a cell; below -1e30 where nothing is.
    const std::vector<float>& height() const { return height_; }
    const std::vector<float>& lowest() const { return low_; }
    /// The facet there; no_index where nothing is.
    const std::vector<Index>& facet() const { return facet_; }
    bool on_part(std::size_t cell) const { return facet_[cell] < part_facets_; }
    std::size_t part_facets() const { return part_facets_; }
    double bottom() const { return bottom_; }
    double top() const { return top_; }
    /// With cells twice as long, each as high as the highest of four.
    CoarseGround halved() const;
    /// What of the part is seen as a sheet, with a vertex for every other cell.
    Mesh mesh() const;

private:
    CoarseGround() = default;

    CoarseGrid grid_;
    std::vector<float> height_, low_;
    std::vector<Index> facet_;
    std::size_t part_facets_ = 0;
    double bottom_ = 0, top_ = 0;
};

inline constexpr float nothing_there = -1e30f * 2;
inline bool is_there(float height) {
    return height > -1e30f;
}

/// How far each cell of a grid is from the nearest one of a set, roughly (as kings walk, diagonals counted as
/// such); large where the set is empty; mm.
std::vector<float> distance_from(const std::vector<char>& set, const CoarseGrid& grid);

} // namespace facetmill
