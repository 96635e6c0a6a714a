#include "core/strategy/preview/preview_levels.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace facetmill {

namespace {

constexpr std::size_t max_levels = 400;
/// The share of a level's surface that may be less steep than what the step below it comes from: pieces of
/// levels lie there.
constexpr double flatter_share = 0.25;
/// Levels are no nearer to each other than this share of the step on a wall.
constexpr double nearest_level = 0.05;

/// Contours of a field of heights, square by square: from its edges to chains.
class Contours {
public:
    explicit Contours(const CoarseGrid& grid) : grid_(grid) {}

    /// The corners of the square at (x, y) in turn, above a level or not.
    template <class Height>
    void square(int x, int y, const Height& height, double level) {
        constexpr std::array<std::array<int, 2>, 4> corner = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        std::array<double, 4> h{};
        int above = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            h[k] = height(x + corner[k][0], y + corner[k][1]) - level;
            above |= h[k] > 0 ? 1 << k : 0;
        }
        if (above == 0 || above == 15) return;
        std::vector<std::pair<std::size_t, Vec2>> ends;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t n = (k + 1) % 4;
            if ((h[k] > 0) == (h[n] > 0)) continue;
            const double t = std::clamp(h[k] / (h[k] - h[n]), 0.0, 1.0);
            const Vec2 a = grid_.middle(x + corner[k][0], y + corner[k][1]),
                       b = grid_.middle(x + corner[n][0], y + corner[n][1]);
            // An edge's number: twice its lower left end's, and one more where it is upright.
            const int ex = x + (k == 1 ? 1 : 0), ey = y + (k == 2 ? 1 : 0);
            ends.emplace_back(2 * grid_.index(ex, ey) + (k % 2), a + t * (b - a));
        }
        // Saddles: what is above is kept apart.
        if (ends.size() == 4 && (above & 1)) std::rotate(ends.begin(), ends.begin() + 1, ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
            places_[ends[i].first] = ends[i].second;
            places_[ends[i + 1].first] = ends[i + 1].second;
            next_[ends[i].first].push_back(ends[i + 1].first);
            next_[ends[i + 1].first].push_back(ends[i].first);
        }
    }

    /// Closed ones end where they begin.
    std::vector<PlanLine> chains() {
        std::vector<PlanLine> all;
        const auto take = [&](std::size_t from) {
            while (!next_[from].empty()) {
                PlanLine line{places_[from]};
                std::size_t at = from;
                while (!next_[at].empty()) {
                    const std::size_t to = next_[at].back();
                    next_[at].pop_back();
                    std::erase(next_[to], at);
                    at = to;
                    line.push_back(places_[at]);
                }
                all.push_back(std::move(line));
            }
        };
        std::vector<std::size_t> ends, others;
        for (const auto& [edge, to] : next_)
            (to.size() == 1 ? ends : others).push_back(edge);
        for (const auto* some : {&ends, &others})
            for (const std::size_t edge : *some)
                take(edge);
        return all;
    }

private:
    const CoarseGrid& grid_;
    std::map<std::size_t, Vec2> places_;
    std::map<std::size_t, std::vector<std::size_t>> next_;
};

std::vector<std::vector<Vec3>> at_height(const std::vector<PlanLine>& chains, double z, double detail) {
    std::vector<std::vector<Vec3>> lines;
    for (const PlanLine& chain : chains) {
        std::vector<Vec3> line;
        for (const Vec2& p : chain) {
            const Vec3 q(p.x(), p.y(), z);
            const std::size_t n = line.size();
            if (n > 1) {
                const Vec3 d = q - line[n - 2], last = line[n - 1] - line[n - 2];
                if (last.cross(d).norm() <= detail * d.norm() && last.dot(d) > 0 && d.norm() < 40 * detail) {
                    line[n - 1] = q;
                    continue;
                }
            }
            line.push_back(q);
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace

std::vector<double> level_heights(const PreviewField& field, const LevelSlicer& slicer,
                                  const PreviewLevels& levels) {
    const Interval& range = slicer.heights();
    std::vector<double> heights;
    if (!(range.hi > range.lo)) return heights;
    // Tips by height, in bins as deep as the finest step.
    const double bin = std::max((range.hi - range.lo) / 4096, 1e-9);
    struct Steepness {
        double z, down;
    };
    std::vector<Steepness> all;
    for (std::size_t i = 0; i < field.grid().size(); ++i)
        if (field.kept(i))
            all.push_back({double(field.tips().z(i)), levels.step.down(field.tips().rise(i).norm())});
    std::ranges::stable_sort(all, [](const Steepness& a, const Steepness& b) { return a.z > b.z; });
    std::size_t first = 0;
    for (double z = range.hi; z > range.lo + bin && heights.size() < 100 * max_levels;) {
        double step = levels.deepest;
        if (levels.fixed) {
            step = *levels.fixed;
        } else {
            while (first < all.size() && all[first].z > z)
                ++first;
            // What lies within the deepest step, or within a length that is a step at most.
            std::vector<double> downs;
            for (std::size_t i = first; i < all.size() && all[i].z > z - levels.deepest; ++i)
                downs.push_back(all[i].down);
            if (!downs.empty()) {
                const auto at = downs.begin() + std::ptrdiff_t(flatter_share * double(downs.size() - 1));
                std::ranges::nth_element(downs, at);
                step = std::min(levels.deepest, *at);
            }
        }
        z -= std::max({step, nearest_level * std::min(levels.step.level, levels.deepest), bin});
        heights.push_back(std::max(z, range.lo + 0.5 * bin));
    }
    return heights;
}

LevelSlicer::LevelSlicer(const PreviewField& field, const Interval& slopes)
    : field_(field), slopes_(slopes), low_(field.tips().ground().bottom() - 1) {
    const CoarseGrid& grid = field.grid();
    ranges_.assign(grid.size(), {nothing_there, nothing_there});
    for (int y = 0; y + 1 < grid.rows; ++y)
        for (int x = 0; x + 1 < grid.columns; ++x) {
            const std::array<float, 4> h = {float(height(x, y)), float(height(x + 1, y)),
                                            float(height(x, y + 1)), float(height(x + 1, y + 1))};
            const auto [least, most] = std::minmax_element(h.begin(), h.end());
            if (!cuts(x, y)) continue;
            ranges_[grid.index(x, y)] = {*least, *most};
            const double foot = *least <= float(low_) ? wall_below(x, y) : double(*least);
            if (foot >= double(*most)) continue;
            heights_.lo = std::min(heights_.lo, foot);
            heights_.hi = std::max(heights_.hi, double(*most));
        }
}

double LevelSlicer::height(int x, int y) const {
    // Beside the part the tip may stand as low as anywhere.
    const float h = field_.tips().z(field_.grid().index(x, y));
    return is_there(h) ? double(h) : low_;
}

bool LevelSlicer::cuts(int x, int y) const {
    const CoarseGrid& grid = field_.grid();
    const Vec2 rise(0.5 * (height(x + 1, y) + height(x + 1, y + 1) - height(x, y) - height(x, y + 1)),
                    0.5 * (height(x, y + 1) + height(x + 1, y + 1) - height(x, y) - height(x + 1, y)));
    const double slope = std::atan(rise.norm() / grid.cell);
    if (slope < slopes_.lo || slope > slopes_.hi) return false;
    for (const std::size_t i :
         {grid.index(x, y), grid.index(x + 1, y), grid.index(x, y + 1), grid.index(x + 1, y + 1)})
        if (field_.kept(i)) return true;
    return wall_below(x, y) < infinity;
}

/// How far down a wall goes round the part, where a square lies across the border of all tips; a sheet has
/// none.
double LevelSlicer::wall_below(int x, int y) const {
    const CoarseGrid& grid = field_.grid();
    const CoarseTips& tips = field_.tips();
    double highest = -infinity, wall = infinity;
    bool beside = false;
    for (const std::size_t i :
         {grid.index(x, y), grid.index(x + 1, y), grid.index(x, y + 1), grid.index(x + 1, y + 1)}) {
        beside = beside || !is_there(tips.z(i));
        const int holder = tips.holder(i);
        if (holder < 0 || double(tips.z(i)) <= highest || !tips.ground().on_part(std::size_t(holder)))
            continue;
        highest = double(tips.z(i));
        wall = double(tips.ground().lowest()[std::size_t(holder)]);
    }
    return beside ? wall : infinity;
}

std::vector<std::vector<Vec3>> LevelSlicer::lines(double z) const {
    const CoarseGrid& grid = field_.grid();
    Contours contours(grid);
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        if (!(ranges_[i][1] > float(z) && ranges_[i][0] <= float(z))) continue;
        const int x = int(i % std::size_t(grid.columns)), y = int(i / std::size_t(grid.columns));
        if (ranges_[i][0] <= float(low_) && z < wall_below(x, y)) continue;
        contours.square(
            x, y, [&](int cx, int cy) { return height(cx, cy); }, z);
    }
    return at_height(contours.chains(), z, 0.1 * grid.cell);
}

namespace {

/// The lines of the levels that are drawn, one in so many of them.
void add_levels(std::vector<std::vector<std::vector<Vec3>>>& made, std::size_t every, PassPreview& preview) {
    std::size_t cut = 0;
    for (auto& lines : made) {
        cut += lines.empty() ? 0 : 1;
        for (auto& line : lines)
            preview.lines.push_back(std::move(line));
    }
    preview.passes += cut * every;
    preview.drawn_every = std::max(preview.drawn_every, every);
}

} // namespace

void lay_levels(const PreviewField& field, const PreviewLevels& levels, PassPreview& preview,
                const Progress& progress) {
    const LevelSlicer slicer(field, levels.slopes);
    const std::vector<double> heights = level_heights(field, slicer, levels);
    const std::size_t every = std::max<std::size_t>(1, (heights.size() + max_levels - 1) / max_levels);
    std::vector<std::vector<std::vector<Vec3>>> made((heights.size() + every - 1) / every);
    parallel_for(made.size(), 1, progress,
                 [&](std::size_t i) { made[i] = slicer.lines(heights[i * every]); });
    add_levels(made, every, preview);
}

namespace {

/// Where on a layer the tip is free and something of the stock may stand.
struct FreeTips {
    const PreviewField& field;
    Box3 stock;
    double z;

    bool at(const Vec2& p) const {
        if (p.x() < stock.lo.x() || p.x() > stock.hi.x() || p.y() < stock.lo.y() || p.y() > stock.hi.y())
            return false;
        const auto height = field.tips().height(p);
        return !height || *height <= z;
    }
};

/// Pieces of a straight line where the tip is free.
void lay_free(const FreeTips& free, const Vec2& from, const Vec2& to, double spacing,
              std::vector<std::vector<Vec3>>& lines) {
    const int steps = std::max(1, int(std::ceil((to - from).norm() / spacing)));
    std::vector<Vec3> run;
    const auto end_run = [&] {
        if (run.size() > 1) lines.push_back({run.front(), run.back()});
        run.clear();
    };
    for (int k = 0; k <= steps; ++k) {
        const Vec2 p = from + double(k) / steps * (to - from);
        if (free.at(p))
            run.emplace_back(p.x(), p.y(), free.z);
        else
            end_run();
    }
    end_run();
}

} // namespace

void lay_layers(const PreviewField& field, const Box3& stock, const std::vector<double>& heights,
                double travel, double stepover, PassPreview& preview, const Progress& progress) {
    const std::size_t every = std::max<std::size_t>(1, (heights.size() + max_levels - 1) / max_levels);
    std::vector<std::vector<std::vector<Vec3>>> made((heights.size() + every - 1) / every);
    const DriveFrame frame(travel);
    Interval u{infinity, -infinity}, v{infinity, -infinity};
    for (const double x : {stock.lo.x(), stock.hi.x()})
        for (const double y : {stock.lo.y(), stock.hi.y()}) {
            const Vec3 p(x, y, 0);
            u.lo = std::min(u.lo, frame.u(p));
            u.hi = std::max(u.hi, frame.u(p));
            v.lo = std::min(v.lo, frame.v(p));
            v.hi = std::max(v.hi, frame.v(p));
        }
    const int lines = std::max(1, int(std::ceil((v.hi - v.lo) / stepover)));
    const LevelSlicer slicer(field, every_slope);
    parallel_for(made.size(), 1, progress, [&](std::size_t i) {
        const FreeTips free{field, stock, heights[i * every]};
        for (int k = 0; k < lines; ++k) {
            progress.check();
            const double at = v.lo + (v.hi - v.lo) * (k + 0.5) / lines;
            lay_free(free, frame.xy(u.lo, at), frame.xy(u.hi, at), field.grid().cell, made[i]);
        }
        if (made[i].empty()) return;
        // Then round what it does not enter.
        for (auto& line : slicer.lines(free.z))
            made[i].push_back(std::move(line));
    });
    add_levels(made, every, preview);
}

std::vector<PlanCurve> cell_outlines(const std::vector<char>& cells, const CoarseGrid& grid) {
    const auto in = [&](int x, int y) { return grid.has(x, y) && cells[grid.index(x, y)] ? 1.0 : 0.0; };
    // One more cell on every side, so that what reaches the grid's border is gone round.
    CoarseGrid wider = grid;
    wider.columns += 2;
    wider.rows += 2;
    wider.origin -= Vec2::Constant(grid.cell);
    Contours around(wider);
    for (int y = 0; y + 1 < wider.rows; ++y)
        for (int x = 0; x + 1 < wider.columns; ++x)
            around.square(
                x, y, [&](int cx, int cy) { return in(cx - 1, cy - 1); }, 0.5);
    std::vector<PlanCurve> curves;
    for (PlanLine& line : around.chains()) {
        if (line.size() < 4) continue;
        line.pop_back(); // closed
        PlanCurve curve{std::move(line), true};
        // The steps of the cells, smoothed: each place with its neighbours.
        constexpr int rounds = 3;
        for (int r = 0; r < rounds; ++r) {
            const std::vector<Vec2> old = curve.points;
            const std::size_t n = old.size();
            for (std::size_t i = 0; i < n; ++i)
                curve.points[i] = 0.25 * old[(i + n - 1) % n] + 0.5 * old[i] + 0.25 * old[(i + 1) % n];
        }
        if (turned_area(curve) < 0) curve = reversed(std::move(curve));
        curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace facetmill
