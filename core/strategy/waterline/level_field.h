// Tip heights over a grid: where the levels of a part run, roughly, and what its slopes ask of them.
// Millimetres, part coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/gouge/axial_lift.h"
#include "core/strategy/surface/cutter_cover.h"

#include <functional>
#include <span>
#include <vector>

namespace facetmill {

/// Where and how an upright cutter touches.
struct TipTouch {
    double tip_z = -infinity;
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
    bool any = false; ///< something of the part
    /// The surface is as steep here as the cutter where it touches: it does not just roll over an edge.
    bool surface = false;
    /// Radians from level.
    double slope() const { return std::acos(std::clamp(normal.z(), -1.0, 1.0)); }
};

/// `facets`: of the part, before those of anything else in the lift's index.
class TouchTeller {
public:
    TouchTeller(ContactIndexPtr index, const CutterCover& cover, std::size_t facets, double allowance)
        : index_(std::move(index)), cover_(cover), facets_(facets), allowance_(allowance) {}
    TipTouch operator()(const Vec2& p, const AxialContact& contact) const;
    double allowance() const { return allowance_; }
    const CutterCover& cover() const { return cover_; }

private:
    bool corner_lies_on(const Vec3& normal, const Vec3& rel) const;

    ContactIndexPtr index_;
    const CutterCover& cover_;
    std::size_t facets_;
    double allowance_;
};

class LevelField {
public:
    /// Touches of rows `first` to the last of those given, which are `columns` each.
    using UseRows = std::function<void(int first, std::span<const TipTouch> touches)>;

    /// Over the box and `beyond` around it. `use` gets bands of rows, every band beginning with the last row
    /// of the one before.
    LevelField(const AxialLift& lift, const TouchTeller& tell, const Box3& box, double beyond, double spacing,
               const UseRows& use, const Progress& progress);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    double spacing() const { return spacing_; }
    Vec2 place(int column, int row) const { return lo_ + spacing_ * Vec2(column, row); }
    double height(int column, int row) const { return heights_[number(column, row)]; }
    std::size_t number(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    }
    /// Whether between these rows and the columns of a block something lies on both sides of z.
    static constexpr int block = 32;
    bool crosses(int row, int block_number, double z) const {
        const auto& [low, high] =
            ranges_[std::size_t(row) * std::size_t(blocks_) + std::size_t(block_number)];
        return low <= z && high > z;
    }
    int blocks() const { return blocks_; }

private:
    void find_ranges(const Progress& progress);

    Vec2 lo_ = Vec2::Zero();
    double spacing_;
    int columns_ = 0, rows_ = 0, blocks_ = 0;
    std::vector<double> heights_;
    std::vector<std::pair<double, double>> ranges_; ///< lowest and highest of the cells of a block
};

} // namespace facetmill
