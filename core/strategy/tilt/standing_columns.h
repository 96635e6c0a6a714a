// What stands of the stock in upright columns, of each as many pieces as tilted tools have left of it.
// Millimetres, part coordinates.
#pragma once

#include "core/setup/motion.h"
#include "core/setup/tool.h"
#include "core/strategy/surface/stock_field.h"

#include <cstdint>
#include <span>
#include <vector>

namespace facetmill {

/// An upright grid of columns, from a stock field: nothing is ever taken away that may stand.
class StandingColumns {
public:
    explicit StandingColumns(const StockField& field);

    double cell() const { return cell_; }
    const Box3& box() const { return box_; } ///< around the solid that the field was made of
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    Vec2 center(int column, int row) const {
        return {box_.lo.x() + (column + 0.5) * cell_, box_.lo.y() + (row + 0.5) * cell_};
    }
    double highest() const { return highest_; } ///< nothing stands, or ever stood, above it
    /// The pieces of a column from below upwards, none of them empty.
    std::span<const Interval> standing(int column, int row) const;

    /// The cells whose columns a cylinder of that radius meets that reaches up from `from` to `to`.
    struct Strip {
        int row_begin, row_end; ///< the last one included, as below
    };
    struct Run {
        int begin, end;
    };
    Strip strip(const Vec2& from, const Vec2& to, double reach) const;
    Run run(int row, const Vec2& from, const Vec2& to, double reach) const;

    /// Takes away what lies within a cylinder with a body's sides and ends on `axis`: between `low` and
    /// `high` along it from `origin`. A column loses a piece only where all of its cell lies inside.
    void clear(const CutterLocation& at, double radius, double low, double high);

private:
    void take(std::size_t cell, const Interval& away);
    std::size_t at(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    }

    Box3 box_;
    double cell_ = 1, highest_ = -infinity;
    int columns_ = 0, rows_ = 0;
    std::vector<Interval> whole_;      ///< as the field has it; empty where nothing stands
    std::vector<std::uint32_t> index_; ///< of a column's pieces, from 1; 0: it is whole
    std::vector<std::vector<Interval>> cut_;
};

/// A cylinder on a tool's axis; heights above the tip.
struct AxisCylinder {
    double radius, low, high;
};
/// Cylinders that lie within a cutter and its flutes: none of a cutter that is narrower farther up. Those
/// that would reach lower than others by less than `coarseness` are left out.
std::vector<AxisCylinder> inner_cylinders(const Tool& tool, double coarseness);
/// Cylinders that hold a cutter's end and reach up without end.
std::vector<AxisCylinder> outer_cylinders(const Tool& tool, double coarseness);

} // namespace facetmill
