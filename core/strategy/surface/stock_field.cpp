#include "core/strategy/surface/stock_field.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_lift.h"

#include <atomic>
#include <cmath>

namespace facetmill {

namespace {

/// Pieces of a motion are this many radii long: their boxes hold little that the cutter does not reach.
constexpr double piece_radii = 2;
/// From so many motions on it is worth to share their rows among threads, in so many bands a thread, of so
/// many rows at least: every band looks at every motion.
constexpr std::size_t band_motions = 16, bands_per_thread = 2, min_band = 4;
/// Motions between two looks at the cancel flag.
constexpr std::size_t motions_per_check = 64;

} // namespace

bool is_undercut(const CutterProfile& profile) {
    return profile.radius_at(profile.height()) < profile.max_radius() * (1 - tolerance::same_shape);
}

StockCutter::StockCutter(const CutterProfile& profile)
    : radius_(profile.max_radius()), height_(profile.height()) {
    static std::atomic<std::uint64_t> made{0};
    number_ = ++made;
    table_.resize(pieces + 2);
    for (std::size_t i = 0; i <= pieces; ++i) {
        const double rest = 1 - double(i) / double(pieces);
        // Just inside the rim, where rounding could leave the profile.
        table_[i] = profile.height_at(radius_ * (i == pieces ? 1 - 1e-15 : 1 - rest * rest));
    }
    table_[pieces + 1] = table_[pieces];
    for (std::size_t i = 0; i < squares; ++i)
        by_square_[i] = below(radius_ * std::sqrt(double(i) / double(squares)));
    if (is_undercut(profile)) find_covered(profile);
    std::size_t flat = 0; // knots 0 to flat are 0
    while (flat <= pieces && table_[flat] == 0)
        ++flat;
    if (flat > 1) {
        const double rest = 1 - double(flat - 1) / double(pieces);
        flat_radius_ = radius_ * (1 - rest * rest) * (1 - 1e-12);
        while (flat_radius_ > 0 && above(flat_radius_) != 0)
            flat_radius_ *= 1 - 1e-4;
    }
}

void StockCutter::find_covered(const CutterProfile& profile) {
    covered_.resize(pieces + 2);
    for (std::size_t i = 0; i <= pieces; ++i) {
        const double rest = 1 - double(i) / double(pieces), rho = radius_ * (1 - rest * rest);
        // Where it is widest the profile turns back; from there up it only narrows.
        double lo = profile.height_at(radius_ * (1 - 1e-15)), hi = height_;
        if (profile.radius_at(hi) >= rho) lo = hi;
        for (int k = 0; k < 60 && lo < hi; ++k) {
            const double mid = 0.5 * (lo + hi);
            (profile.radius_at(mid) >= rho ? lo : hi) = mid;
        }
        covered_[i] = lo;
    }
    covered_[pieces + 1] = covered_[pieces];
}

StockField::StockField(const StockSolid& solid, double cell, const Progress& progress) : box_(solid.box) {
    if (!(cell > 0))
        throw Error(ErrorCode::out_of_range, "stock", "the cells of a stock field are not above 0",
                    "report this");
    if (box_.empty()) return;
    const Vec3 size = box_.size();
    // Thin or empty stock has at least one cell.
    cell_ = std::max({cell, std::sqrt(size.x() * size.y() / max_cells), size.maxCoeff() / max_cells});
    half_diagonal_ = cell_ * std::numbers::sqrt2 / 2;
    columns_ = std::max(1, int(std::ceil(size.x() / cell_)));
    rows_ = std::max(1, int(std::ceil(size.y() / cell_)));
    cells_.assign(std::size_t(columns_) * std::size_t(rows_), {box_.hi.z(), box_.hi.z()});
    // The last cells may reach beyond the box.
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column)
            if (const Vec2 c = center(column, row); c.x() > box_.hi.x() || c.y() > box_.hi.y())
                cells_[at(column, row)].middle = -infinity;
    if (solid.kind == StockSolid::Kind::cylinder)
        fill_round(solid);
    else if (solid.kind == StockSolid::Kind::mesh)
        fill_mesh(solid, progress);
    find_runs();
    progress.set(1);
}

void StockField::fill_round(const StockSolid& solid) {
    const Vec3 middle = box_.center();
    const auto height = [&](double x, double y) {
        const double d = solid.axis == 2 ? std::hypot(x, y) : solid.axis == 0 ? y : x;
        if (d > solid.radius) return -infinity;
        return solid.axis == 2 ? box_.hi.z() : middle.z() + std::sqrt(solid.radius * solid.radius - d * d);
    };
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            const Vec2 c = (center(column, row) - middle.head<2>()).cwiseAbs();
            Cell& cell = cells_[at(column, row)];
            cell.top = height(std::max(0.0, c.x() - 0.5 * cell_), std::max(0.0, c.y() - 0.5 * cell_));
            cell.middle = std::min(cell.middle, height(c.x(), c.y()));
        }
}

void StockField::fill_mesh(const StockSolid& solid, const Progress& progress) {
    if (!solid.mesh || solid.mesh->facets.empty()) return;
    // A level disc that holds the cell, and whatever edge may be missing near it, comes down on it.
    const auto index = std::make_shared<ContactIndex>(solid.mesh, progress.part(0, 0.5));
    const AxialLift disc(
        index, CutterProfile(AptCutter::flat(2.0001 * (half_diagonal_ + solid.edge_loss), unlimited_height)));
    std::vector<Vec2> points(cells_.size());
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column)
            points[at(column, row)] = center(column, row);
    std::vector<double> heights(points.size());
    disc.tip_z(points, heights, progress.part(0.5, 0.75));
    for (std::size_t i = 0; i < cells_.size(); ++i)
        cells_[i].top = heights[i];
    const AxialLift needle(index,
                           CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height)));
    needle.tip_z(points, heights, progress.part(0.75, 1));
    for (std::size_t i = 0; i < cells_.size(); ++i)
        cells_[i].middle = heights[i];
}

double StockField::highest() const {
    double most = -infinity;
    for (const Cell& r : runs_)
        most = std::max(most, r.top);
    return most;
}

StockField::Cell StockField::highest_of(const Cell* cells, int count) {
    Cell most{-infinity, -infinity};
    for (const Cell* cell = cells; cell != cells + count; ++cell)
        most = {std::max(most.top, cell->top), std::max(most.middle, cell->middle)};
    return most;
}

void StockField::find_runs() {
    run_columns_ = (columns_ + run - 1) / run;
    runs_.clear();
    runs_.reserve(std::size_t(run_columns_) * std::size_t(rows_));
    for (int row = 0; row < rows_; ++row)
        for (int start = 0; start < columns_; start += run)
            runs_.push_back(highest_of(&cells_[at(start, row)], std::min(run, columns_ - start)));
    no_higher_ = highest();
}

void StockField::forget_below(double z) {
    forgotten_ = z;
    for (Cell& cell : cells_)
        forget_low(cell);
    find_runs();
}

/// The cells near a line.
struct CellsNear {
    /// visit(cell, square of its centre's distance from the line, share of the line nearest to it) for cells
    /// that are wanted(cell), whose centre is within `reach`, but for those that surely have no top above
    /// `floor`; ends when visit returns false. Most cells near a line are cut already: `wanted` is asked
    /// first.
    /// `ahead`: only what lies on this side of a, if it is not 0; little else is visited then.
    /// `may_matter(most, square)`: false where cells that are nowhere higher, nor nearer to the line than the
    /// root of `square`, are left out.
    template <class Field, class Wanted, class Visit, class Matters>
    static void line(Field& field, const Vec2& a, const Vec2& b, double reach, double floor, Wanted&& wanted,
                     Visit&& visit, const StockRows& rows, const Vec2& ahead, Matters&& may_matter) {
        if (field.cells_.empty()) return;
        const double cell_ = field.cell_;
        const Box3& box_ = field.box_;
        const Vec2 motion = b - a;
        const double square = motion.squaredNorm();
        const auto first = [&](double x, double lo) {
            return int(std::clamp(std::floor((x - reach - lo) / cell_ - 0.5), 0.0, 2e9));
        };
        const auto last = [&](double x, double lo, int n) {
            return int(std::clamp(std::ceil((x + reach - lo) / cell_ - 0.5), -1.0, double(n - 1)));
        };
        const Vec2 lo = a.cwiseMin(b), hi = a.cwiseMax(b);
        const auto beside = [](double from, double to, double low, double high) {
            return std::max({from - high, low - to, 0.0});
        };
        const int row1 = std::min(last(hi.y(), box_.lo.y(), field.rows_), rows.last);
        const int all0 = first(lo.x(), box_.lo.x()), all1 = last(hi.x(), box_.lo.x(), field.columns_);
        const double reach_square = reach * reach;
        for (int row = std::max(first(lo.y(), box_.lo.y()), rows.first); row <= row1; ++row) {
            auto* runs = field.runs_.data() + std::ptrdiff_t(row) * field.run_columns_;
            auto* cells = field.cells_.data() + std::ptrdiff_t(row) * field.columns_;
            int column0 = all0, column1 = all1;
            // (x - a.x) ahead.x > -(y - a.y) ahead.y, and a cell more.
            const double y = field.center(0, row).y(), level = (a.y() - y) * ahead.y();
            if (ahead.x() != 0) {
                const double column =
                    std::clamp((a.x() + level / ahead.x() - box_.lo.x()) / cell_, -2.0, 2e9);
                if (ahead.x() > 0)
                    column0 = std::max(column0, int(column) - 1);
                else
                    column1 = std::min(column1, int(column) + 1);
            } else if (level > cell_ * std::abs(ahead.y())) {
                continue;
            }
            const double across = beside(y, y, lo.y(), hi.y());
            for (int begin = column0; begin <= column1;) {
                auto& most = runs[begin / field.run];
                const int start = begin / field.run * field.run,
                          end = std::min(column1, start + field.run - 1);
                const double along = beside(field.center(begin, row).x(), field.center(end, row).x(), lo.x(),
                                            hi.x()),
                             near = (1 - tolerance::figure_rounding) * (along * along + across * across);
                if (most.top > floor && near <= reach_square && may_matter(most, near)) {
                    for (int column = begin; column <= end; ++column) {
                        auto& cell = cells[column];
                        if (!wanted(cell)) continue;
                        const Vec2 p = field.center(column, row) - a;
                        const double t = square > 0 ? std::clamp(p.dot(motion) / square, 0.0, 1.0) : 0;
                        const double d2 = (p - t * motion).squaredNorm();
                        if (d2 > reach_square) continue;
                        if (!visit(cell, d2, t)) return;
                    }
                    if constexpr (!std::is_const_v<Field>)
                        most = Field::highest_of(cells + start, std::min(field.run, field.columns_ - start));
                }
                begin = end + 1;
            }
        }
    }
    template <class Field, class Wanted, class Visit>
    static void line(Field& field, const Vec2& a, const Vec2& b, double reach, double floor, Wanted&& wanted,
                     Visit&& visit, const StockRows& rows = {}) {
        line(field, a, b, reach, floor, wanted, visit, rows, Vec2::Zero(),
             [](const StockField::Cell&, double) { return true; });
    }
};

namespace {

/// Calls piece(from, to) for short pieces of a motion, as shares of it; ends when it returns false.
template <class Piece>
void short_pieces(double length, double longest, Piece&& piece) {
    const double n = std::max(1.0, std::ceil(length / longest));
    for (double k = 0; k < n; ++k)
        if (!piece(k / n, (k + 1) / n)) return;
}

} // namespace

namespace {

/// Where on the line at y a disc that is moved from a to b comes: a disc at either end, and what is between
/// the two sides.
Interval swept_range(const Vec2& a, const Vec2& b, double radius, double y) {
    const Vec2 motion = b - a;
    const double length = motion.norm();
    const Vec2 side = length > 0 ? Vec2(Vec2(-motion.y(), motion.x()) * (radius / length)) : Vec2(0, radius);
    Interval range{infinity, -infinity};
    for (const Vec2& end : {a, b}) {
        const double rest = radius * radius - (y - end.y()) * (y - end.y());
        if (rest < 0) continue;
        range = {std::min(range.lo, end.x() - std::sqrt(rest)),
                 std::max(range.hi, end.x() + std::sqrt(rest))};
    }
    for (const double s : {-1.0, 1.0}) {
        const Vec2 p = a + s * side, q = b + s * side;
        if ((p.y() - y) * (q.y() - y) > 0 || p.y() == q.y()) continue;
        const double x = p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
        range = {std::min(range.lo, x), std::max(range.hi, x)};
    }
    return range;
}

} // namespace

void StockField::cut_level(const Vec2& a, const Vec2& b, double radius, double z, double top,
                           const Rows& rows) {
    const double low = std::min(a.y(), b.y()) - radius, high = std::max(a.y(), b.y()) + radius;
    const int row0 = std::max({0, int(std::ceil((low - box_.lo.y()) / cell_ - 0.5)), rows.first});
    const int row1 = std::min({rows_ - 1, int(std::floor((high - box_.lo.y()) / cell_ - 0.5)), rows.last});
    for (int row = row0; row <= row1; ++row) {
        const auto [from, to] = swept_range(a, b, radius, box_.lo.y() + (row + 0.5) * cell_);
        if (!(from <= to)) continue;
        const int column0 = std::max(0, int(std::ceil((from - box_.lo.x()) / cell_ - 0.5)));
        const int column1 = std::min(columns_ - 1, int(std::floor((to - box_.lo.x()) / cell_ - 0.5)));
        Cell* cells = cells_.data() + std::ptrdiff_t(row) * columns_;
        Cell* runs = runs_.data() + std::ptrdiff_t(row) * run_columns_;
        for (int begin = column0; begin <= column1;) {
            const int start = begin / run * run, end = std::min(column1, start + run - 1);
            if (runs[begin / run].top > z) {
                for (int column = begin; column <= end; ++column) {
                    for (double* height : {&cells[column].top, &cells[column].middle})
                        if (*height > z && *height <= top) *height = z;
                    forget_low(cells[column]);
                }
                runs[begin / run] = highest_of(cells + start, std::min(run, columns_ - start));
            }
            begin = end + 1;
        }
    }
}

/// Cuts one after another, in bands of rows, of each of which a thread makes all.
class BandCuts {
public:
    using Motion = StockField::Motion;
    /// All must outlive this.
    BandCuts(StockField& field, const StockCutter& cutter, std::span<const Motion> motions,
             const Box3& within)
        : field_(field), cutter_(cutter), motions_(motions), within_(within) {}

    /// Calls before(motion, rows) before each of them is made.
    template <class Before>
    void run(Before&& before, const Progress& progress) {
        if (motions_.empty()) return;
        std::vector<StockRows> reached;
        reached.reserve(motions_.size());
        StockRows all{field_.rows_, -1};
        const StockRows asked{row_at(within_.lo.y()) - 1, row_at(within_.hi.y()) + 1};
        for (const Motion& motion : motions_) {
            reached.push_back(is_near(motion) ? rows_of(motion) : StockRows{field_.rows_, -1});
            all = {std::min(all.first, reached.back().first), std::max(all.last, reached.back().last)};
        }
        all = {std::max({all.first, asked.first, 0}), std::min({all.last, asked.last, field_.rows_ - 1})};
        const bool stood = field_.last_tip_ == motions_.front()[0] && field_.last_cutter_ == cutter_.number_;
        const auto n = std::size_t(std::max(all.last - all.first + 1, 0));
        const auto bands = bands_per_thread * std::size_t(thread_count());
        // A single thread takes all rows at once, and so it is with few motions.
        const std::size_t band = motions_.size() < band_motions || thread_count() == 1
                                     ? n
                                     : std::max(min_band, (n + bands - 1) / bands);
        parallel_blocks(n, band, progress, [&](std::size_t begin, std::size_t end) {
            const StockRows rows{all.first + int(begin), all.first + int(end) - 1};
            for (std::size_t i = 0; i < motions_.size(); ++i) {
                if (i % motions_per_check == 0) progress.check();
                if (reached[i].last < rows.first || reached[i].first > rows.last) continue;
                const auto& [a, b] = motions_[i];
                before(i, rows);
                field_.cut_rows(cutter_, a, b, i == 0 ? stood : motions_[i - 1][1] == a, rows);
            }
        });
        field_.last_tip_ = motions_.back()[1];
        field_.last_cutter_ = cutter_.number_;
    }

private:
    /// Those that the cutter reaches, and a few more.
    StockRows rows_of(const Motion& motion) const {
        const auto [low, high] = std::minmax(motion[0].y(), motion[1].y());
        return {row_at(low - cutter_.radius()) - 1, row_at(high + cutter_.radius()) + 1};
    }
    int row_at(double y) const { return int(std::clamp((y - field_.box_.lo.y()) / field_.cell_, -2.0, 2e9)); }
    /// Whether it may come into the columns that are asked about.
    bool is_near(const Motion& motion) const {
        const auto [low, high] = std::minmax(motion[0].x(), motion[1].x());
        const double reach = cutter_.radius() + field_.cell_;
        return low - reach <= within_.hi.x() && high + reach >= within_.lo.x();
    }

    StockField& field_;
    const StockCutter& cutter_;
    std::span<const Motion> motions_;
    const Box3& within_;
};

void StockField::cut(const StockCutter& cutter, const Vec3& a, const Vec3& b) {
    cut_rows(cutter, a, b, last_tip_ == a && last_cutter_ == cutter.number_, {});
    last_tip_ = b;
    last_cutter_ = cutter.number_;
}

void StockField::cut(const StockCutter& cutter, std::span<const Motion> motions, const Progress& progress,
                     const Box3& within) {
    BandCuts(*this, cutter, motions, within).run([](std::size_t, const Rows&) {}, progress);
}

std::vector<char> StockField::cut_telling_work(const StockCutter& cutter, std::span<const Motion> motions,
                                               double least, const Progress& progress) {
    std::vector<std::atomic<char>> work(motions.size());
    const auto look = [&](std::size_t i, const Rows& rows) {
        const auto& [a, b] = motions[i];
        if (!work[i] && has_work(cutter, a, b, least, rows)) work[i] = 1;
    };
    const Box3 all = everywhere();
    BandCuts(*this, cutter, motions, all).run(look, progress);
    return {work.begin(), work.end()};
}

void StockField::cut_rows(const StockCutter& cutter, const Vec3& a, const Vec3& b, bool stood_at_a,
                          const Rows& rows) {
    const Vec3 motion = b - a;
    short_pieces(motion.head<2>().norm(), piece_radii * cutter.radius(), [&](double from, double to) {
        cut_piece(cutter, a + from * motion, to == 1 ? b : Vec3(a + to * motion), stood_at_a, rows);
        stood_at_a = true;
        return true;
    });
}

/// Any place of the piece gives a height that is not too low; the nearest is the best on a level one, the
/// lower end where it goes down steeply. Where the cutter stood at p before, it has cut there: what lies
/// behind is nearest to p.
void StockField::cut_piece(const StockCutter& cutter, const Vec3& p, const Vec3& q, bool stood_at_p,
                           const Rows& rows) {
    const Vec3& low = p.z() < q.z() ? p : q;
    const Vec2 on = (q - p).head<2>();
    if (p.z() == q.z() && cutter.flat_radius() > half_diagonal_)
        cut_level(p.head<2>(), q.head<2>(), cutter.flat_radius() - half_diagonal_, p.z(),
                  p.z() + cutter.covered(cutter.flat_radius()), rows);
    const auto higher = [z = low.z()](const Cell& cell) { return cell.top > z; };
    // Most cells in reach stay as they are: low enough, or under the rim, which takes the middle alone.
    const double inner = std::max(0.0, cutter.radius() - half_diagonal_), whole = inner * inner;
    const auto lower = [&](Cell& cell, double square, double z) {
        const double least = z + cutter.at_least(square);
        const bool middle = cell.middle > std::max(low.z(), least), top = square <= whole && cell.top > least;
        if (!(middle || top)) return true;
        const double d = std::sqrt(square);
        const auto lower_to = [&](double& height, double slack) {
            if (height <= low.z() || height > z + cutter.covered(d + slack)) return;
            height = std::min(height, z + cutter.above(d + slack));
        };
        if (middle) lower_to(cell.middle, 0);
        if (top) lower_to(cell.top, half_diagonal_);
        forget_low(cell);
        return true;
    };
    // Nor does what is no higher than the lower end would leave it anywhere so far away.
    const double lowest = low.z() - tolerance::bound_slack * (std::abs(p.z()) + std::abs(q.z()));
    const auto may_lower = [&](const Cell& most, double square) {
        const double d = std::sqrt(square);
        return most.middle > lowest + cutter.below(d)
               || (square <= whole && most.top > lowest + cutter.below(d + half_diagonal_));
    };
    CellsNear::line(
        *this, p.head<2>(), q.head<2>(), cutter.radius(), low.z(), higher,
        [&](Cell& cell, double square, double t) { return lower(cell, square, p.z() + t * (q.z() - p.z())); },
        rows, stood_at_p ? on : Vec2(Vec2::Zero()), may_lower);
    // Ahead of its lower end, that was the nearest.
    const bool falls = q.z() < p.z();
    if (p.z() == q.z() || (!falls && stood_at_p)) return;
    CellsNear::line(
        *this, low.head<2>(), low.head<2>(), cutter.radius(), low.z(), higher,
        [&](Cell& cell, double square, double) { return lower(cell, square, low.z()); }, rows,
        falls ? Vec2(-on) : on, may_lower);
}

double StockField::clear_height(const StockCutter& cutter, const Vec2& a, const Vec2& b) const {
    double height = -infinity;
    const Vec2 motion = b - a;
    short_pieces(motion.norm(), piece_radii * cutter.radius(), [&](double from, double to) {
        CellsNear::line(
            *this, a + from * motion, a + to * motion, cutter.radius() + half_diagonal_, height,
            [&](const Cell& cell) { return cell.top > height; },
            [&](const Cell& cell, double square, double) {
                const double d = std::sqrt(square);
                height = std::max(height, cell.top - cutter.below(std::max(0.0, d - half_diagonal_)));
                return true;
            });
        return true;
    });
    return height;
}

double StockField::stand_height(const StockCutter& cutter, const Vec2& a, const Vec2& b) const {
    double height = -infinity;
    const Vec2 motion = b - a;
    short_pieces(motion.norm(), piece_radii * cutter.radius(), [&](double from, double to) {
        CellsNear::line(
            *this, a + from * motion, a + to * motion, cutter.radius(), height,
            [&](const Cell& cell) { return cell.middle > height; },
            [&](const Cell& cell, double square, double) {
                const double d = std::sqrt(square);
                height = std::max(height, cell.middle - cutter.below(d));
                return true;
            });
        return true;
    });
    return height;
}

double StockField::highest_near(const Vec2& a, const Vec2& b, double radius, double floor) const {
    double height = floor;
    const Vec2 motion = b - a;
    short_pieces(motion.norm(), piece_radii * std::max(radius, cell_), [&](double from, double to) {
        CellsNear::line(
            *this, a + from * motion, a + to * motion, radius + half_diagonal_, height,
            [&](const Cell& cell) { return cell.top > height; },
            [&](const Cell& cell, double, double) {
                height = std::max(height, cell.top);
                return true;
            });
        return true;
    });
    return height;
}

void StockField::each_above(const Vec2& p, double radius, double z,
                            const std::function<void(std::size_t cell, double top)>& visit) const {
    CellsNear::line(
        *this, p, p, radius + half_diagonal_, z, [&](const Cell& cell) { return cell.top > z; },
        [&](const Cell& cell, double, double) {
            visit(std::size_t(&cell - cells_.data()), cell.top);
            return true;
        });
}

std::vector<Interval> StockField::work(const StockCutter& cutter, const Vec3& a, const Vec3& b,
                                       double least) const {
    std::vector<Interval> all;
    const Vec3 motion = b - a;
    const double length = motion.head<2>().norm();
    // In bins of a cell's length, so that what comes out is in order.
    const auto bins = std::size_t(std::max(1.0, std::ceil(length / cell_)));
    std::vector<char> busy(bins, 0);
    short_pieces(length, piece_radii * cutter.radius(), [&](double from, double to) {
        const Vec3 p = a + from * motion, q = a + to * motion;
        const double floor = std::min(p.z(), q.z()) + least;
        CellsNear::line(
            *this, p.head<2>(), q.head<2>(), cutter.radius(), floor,
            [&](const Cell& cell) { return cell.middle > floor; },
            [&](const Cell& cell, double square, double t) {
                const double share = from + t * (to - from);
                char& bin = busy[std::min(bins - 1, std::size_t(share * double(bins)))];
                if (bin) return true;
                // The lower end of an upright motion says it.
                const double z = length > 0 ? p.z() + t * (q.z() - p.z()) : std::min(a.z(), b.z());
                if (cell.middle - (z + cutter.above(std::sqrt(square))) > least) bin = 1;
                return true;
            });
        return true;
    });
    for (std::size_t i = 0; i < bins; ++i) {
        if (!busy[i]) continue;
        const double lo = double(i) / double(bins), hi = double(i + 1) / double(bins);
        if (i > 0 && busy[i - 1])
            all.back().hi = hi;
        else
            all.push_back({lo, hi});
    }
    return all;
}

bool StockField::has_work(const StockCutter& cutter, const Vec3& a, const Vec3& b, double least) const {
    return has_work(cutter, a, b, least, {});
}

bool StockField::has_work(const StockCutter& cutter, const Vec3& a, const Vec3& b, double least,
                          const Rows& rows) const {
    bool found = false;
    const Vec3 motion = b - a;
    const auto look = [&](const Vec3& p, const Vec3& q) {
        const double floor = std::min(p.z(), q.z()) + least;
        CellsNear::line(
            *this, p.head<2>(), q.head<2>(), cutter.radius(), floor,
            [&](const Cell& cell) { return cell.middle > floor; },
            [&](const Cell& cell, double square, double t) {
                const double d = std::sqrt(square);
                found = cell.middle - (p.z() + t * (q.z() - p.z()) + cutter.above(d)) > least;
                return !found;
            },
            rows);
        return !found;
    };
    short_pieces(motion.head<2>().norm(), piece_radii * cutter.radius(),
                 [&](double from, double to) { return look(a + from * motion, a + to * motion); });
    // The lower end of an upright motion says it.
    const Vec3& low = a.z() < b.z() ? a : b;
    if (!found && a.z() != b.z()) look(low, low);
    return found;
}

} // namespace facetmill
