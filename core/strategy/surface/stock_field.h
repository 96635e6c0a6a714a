// What stands of the stock, as planners see it: over every cell of a level grid the height of its top.
// Millimetres, part coordinates, tools with the axis +Z. It shares nothing with the verifier, which judges.
//
// Two heights a cell:
//   top     no material of the cell is higher: what must not be touched is asked here, so that links, shanks
//           and holders keep clear of what may stand.
//   middle  over the cell's centre, exact but for the cutter's table: where a cut removes something. A cell
//           that a wall crosses has a high top for ever; its centre tells whether there is still work.
//
// Material is believed to reach down without end, and what the cutting part leaves above its own height
// stays. So where the field is wrong there is less material than it says.
#pragma once

#include "core/base/progress.h"
#include "core/cutter/cutter.h"
#include "core/setup/stock_solid.h"
#include "core/strategy/surface/contact_domain.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace facetmill {

/// True of a cutter that is narrower above its largest radius, as dovetails and lollipops are.
bool is_undercut(const CutterProfile& profile);

/// The lower surface of a cutter in a table.
class StockCutter {
public:
    explicit StockCutter(const CutterProfile& profile);

    double radius() const { return radius_; }
    double height() const { return height_; }
    /// Within this distance from the axis the lower surface is flat, for `above` too; 0 where it is not.
    double flat_radius() const { return flat_radius_; }
    /// Not below, and not above, the height of the lower surface over the tip at distance rho from the axis;
    /// infinite beyond the radius.
    double above(double rho) const { return rho > radius_ ? infinity : table_[knot(rho) + 1]; }
    double below(double rho) const { return rho > radius_ ? infinity : table_[knot(rho)]; }
    /// Not above the height of the lower surface where the square of that distance is `square`; coarse,
    /// quick.
    double at_least(double square) const {
        return by_square_[std::min(squares - 1, std::size_t(square / (radius_ * radius_) * double(squares)))];
    }
    /// Up to this height over the tip, at least, the cutting part takes away what stands at distance rho: all
    /// of its height, but beside the neck of an undercut one, over which material stays.
    double covered(double rho) const {
        return covered_.empty() || rho > radius_ ? height_ : covered_[knot(rho) + 1];
    }

private:
    void find_covered(const CutterProfile& profile);
    static constexpr std::size_t pieces = 4096, squares = 256;
    /// Closer towards the rim, where a ball's surface stands upright: on a ball all steps are alike.
    std::size_t knot(double rho) const {
        return std::size_t((1 - std::sqrt(std::max(0.0, 1 - rho / radius_))) * double(pieces));
    }
    friend class StockField;
    friend class BandCuts;
    double radius_, height_, flat_radius_ = 0;
    std::uint64_t number_;                ///< no other cutter has it, but for copies
    std::vector<double> table_, covered_; ///< covered_: of an undercut cutter only
    std::array<double, squares> by_square_{};
};

/// Some of the rows of a stock field, both ends included. The cells of a row depend on no other's.
struct StockRows {
    int first = 0, last = std::numeric_limits<int>::max();
};

class StockField {
public:
    /// Cells of about `cell`, coarser where they would be more than `max_cells`. Throws
    /// Error(out_of_range) for a cell that is not above 0.
    StockField(const StockSolid& solid, double cell, const Progress& progress);

    static constexpr double max_cells = 2e6;

    double cell() const { return cell_; }
    const Box3& box() const { return box_; } ///< around the solid
    /// Cells in x and y, and the centre and the heights of one; -inf where there is no material.
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    Vec2 center(int column, int row) const {
        return {box_.lo.x() + (column + 0.5) * cell_, box_.lo.y() + (row + 0.5) * cell_};
    }
    double top(int column, int row) const { return cells_[at(column, row)].top; }
    double middle(int column, int row) const { return cells_[at(column, row)].middle; }
    double highest() const; ///< top of all
    /// Not below it, at no cost: what stood highest at first.
    double no_higher() const { return no_higher_; }
    /// Cells on which nothing stands higher than z, from now on, are as if without material: whoever asks
    /// only what is higher spends no time on them.
    void forget_below(double z);
    /// The cutter moves straight from a to b at feed.
    void cut(const StockCutter& cutter, const Vec3& a, const Vec3& b);
    /// The same for motions (from, to) one after the other, on all cores. Cells that lie
    /// outside `within`, seen along Z, by more than one of them may stay higher.
    using Motion = std::array<Vec3, 2>;
    void cut(const StockCutter& cutter, std::span<const Motion> motions, const Progress& progress,
             const Box3& within = everywhere());
    static Box3 everywhere() { return {Vec3::Constant(-infinity), Vec3::Constant(infinity)}; }
    /// Tells of each of them whether it has work (`has_work`) when its turn comes.
    std::vector<char> cut_telling_work(const StockCutter& cutter, std::span<const Motion> motions,
                                       double least, const Progress& progress);
    /// The lowest tip height at which the cutter, moved level and straight from a to b, touches nothing; -inf
    /// where nothing is.
    double clear_height(const StockCutter& cutter, const Vec2& a, const Vec2& b) const;
    /// The same by the heights over the cells' centres: what it touches lower is narrower than a cell.
    double stand_height(const StockCutter& cutter, const Vec2& a, const Vec2& b) const;
    /// The highest top within `radius` of the line from a to b, if that is above `floor`; else any height not
    /// above it.
    double highest_near(const Vec2& a, const Vec2& b, double radius, double floor = -infinity) const;
    /// Calls visit for the cells that come within `radius` of p and whose top is above z; `cell` counts along
    /// rows.
    void each_above(const Vec2& p, double radius, double z,
                    const std::function<void(std::size_t cell, double top)>& visit) const;
    /// Where on the line from a to b (shares 0 to 1 of it, level) the cutter takes away more than `least` of
    /// height. Cells beside the line count where the axis passes them.
    std::vector<Interval> work(const StockCutter& cutter, const Vec3& a, const Vec3& b, double least) const;
    bool has_work(const StockCutter& cutter, const Vec3& a, const Vec3& b, double least) const;

private:
    struct Cell {
        double top, middle;
    };
    std::size_t at(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    }
    static Cell highest_of(const Cell* cells, int count);
    void find_runs();
    void forget_low(Cell& cell) const {
        if (cell.top <= forgotten_) cell = {-infinity, -infinity};
    }
    using Rows = StockRows;
    friend struct CellsNear;
    friend class BandCuts;
    void cut_rows(const StockCutter& cutter, const Vec3& a, const Vec3& b, bool stood_at_a, const Rows& rows);
    bool has_work(const StockCutter& cutter, const Vec3& a, const Vec3& b, double least,
                  const Rows& rows) const;
    /// What stands over cells whose centre is within `radius` of the line from a to b, but not above `top`,
    /// is cut down to z.
    void cut_level(const Vec2& a, const Vec2& b, double radius, double z, double top, const Rows& rows);
    void fill_round(const StockSolid& solid);
    void fill_mesh(const StockSolid& solid, const Progress& progress);
    void cut_piece(const StockCutter& cutter, const Vec3& p, const Vec3& q, bool stood_at_p,
                   const Rows& rows);

    Box3 box_;
    double cell_ = 1, half_diagonal_ = 1;
    double no_higher_ = -infinity;
    double forgotten_ = -infinity; ///< what stands no higher is
    int columns_ = 0, rows_ = 0;
    std::vector<Cell> cells_;
    static constexpr int run = 8; ///< cells of a row
    int run_columns_ = 0;
    std::vector<Cell> runs_; ///< the highest top and middle of each run
    /// What was cut last: a cutter of this surface stood here at its end.
    Vec3 last_tip_ = Vec3::Constant(infinity);
    std::uint64_t last_cutter_ = 0;
};

} // namespace facetmill
