#include "core/verify/motion_shadows.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Of the cutter's radius: smaller cells hold fewer motions each that have to be asked, and more in all.
constexpr double cell_share = 0.25;
constexpr double max_cells = 1e6;
/// Cells overlap by so much of their size, above the rounding of where a line leaves one for the next.
constexpr double overlap_share = 1e-6;

} // namespace

/// Where the motions stand, and the lowest places of their cutter by the distance from its axis.
class MotionShadows::Builder {
public:
    Builder(MotionShadows& grid, const MotionProbes& probes) : grid_(grid), radius_(probes.body_.radius()) {
        const MotionTree& tree = *probes.tree_;
        grid.frame_ = to_tool_frame(tree.nodes_.front().axis);
        Box3 box;
        for (const MotionTree::Node& node : tree.nodes_) {
            if (node.right != 0) continue;
            moves_.push_back({grid.frame_ * tree.from(node.motion).tip,
                              grid.frame_ * tree.to(node.motion).tip, node.motion});
            box.add(moves_.back().from);
            box.add(moves_.back().to);
        }
        // The order of the tree depends on nothing but the motions; theirs is simpler.
        std::sort(moves_.begin(), moves_.end(),
                  [](const Move& a, const Move& b) { return a.motion < b.motion; });
        for (std::size_t k = 0; k < profile_.size(); ++k)
            profile_[k] = heights(probes.body_, radius_ * double(k) / steps).lo;
        grid.ceiling_ = box.lo.z() + heights(probes.body_, radius_).hi - tolerance::probe_rounding;
        const Vec2 size = (box.hi - box.lo).head<2>() + Vec2::Constant(2 * radius_);
        grid.cell_ = std::max(cell_share * radius_, std::sqrt(size.prod() / max_cells));
        grid.lo_ = box.lo.head<2>() - Vec2::Constant(radius_);
        grid.columns_ = 1 + int(size.x() / grid.cell_);
        grid.rows_ = 1 + int(size.y() / grid.cell_);
        half_ = (1 + overlap_share) * std::sqrt(0.5) * grid.cell_;
    }

    void build(const Progress& progress) {
        const auto columns = std::size_t(grid_.columns_), rows = std::size_t(grid_.rows_);
        std::vector<std::vector<Shadow>> cells(columns * rows);
        const std::size_t band = std::max<std::size_t>(4, rows / 32);
        parallel_blocks(rows, band, progress, [&](std::size_t begin, std::size_t end) {
            // How high the lowest motion over a cell comes at most.
            std::vector<double> highest(columns * (end - begin), infinity);
            each(begin, end, [&](std::size_t cell, const Move&, const Heights& h) {
                double& most = highest[cell - begin * columns];
                most = std::min(most, h.hi);
            });
            each(begin, end, [&](std::size_t cell, const Move& move, const Heights& h) {
                if (h.lo <= highest[cell - begin * columns]) cells[cell].push_back({h.lo, move.motion});
            });
            for (std::size_t cell = begin * columns; cell < end * columns; ++cell)
                std::sort(cells[cell].begin(), cells[cell].end(), [](const Shadow& a, const Shadow& b) {
                    return a.low < b.low || (a.low == b.low && a.motion < b.motion);
                });
        });
        grid_.first_.reserve(cells.size() + 1);
        grid_.first_.push_back(0);
        for (const std::vector<Shadow>& cell : cells)
            grid_.first_.push_back(grid_.first_.back() + cell.size());
        grid_.shadows_.reserve(grid_.first_.back());
        for (const std::vector<Shadow>& cell : cells)
            grid_.shadows_.insert(grid_.shadows_.end(), cell.begin(), cell.end());
    }

private:
    static constexpr int steps = 512;
    struct Move {
        Vec3 from, to;
        Index motion;
    };
    /// Along the axis.
    struct Heights {
        double lo, hi;
    };
    /// Of the body's lower and upper surface, at a distance from its axis.
    static Heights heights(const TurnedBody& body, double rho) {
        const Stretch s = body.along(Vec3(std::min(rho, body.radius()), 0, 0), Vec3::UnitZ());
        return {s.lo, s.hi};
    }
    /// The lower surface rises from the axis outward.
    double lowest(double rho) const {
        return profile_[std::size_t(std::max(0.0, rho) / radius_ * steps)] - tolerance::probe_rounding;
    }
    double highest(double rho) const {
        return profile_[std::min(steps, 1 + int(rho / radius_ * steps))] + tolerance::probe_rounding;
    }

    /// Of a motion over the cell about `middle`: where its lowest place may be at least, and where all of the
    /// cell lies over it, where its lower surface is at most. False where it does not come over the cell.
    bool over(const Move& move, const Vec2& middle, Heights& h) const {
        const Vec2 route = (move.to - move.from).head<2>(), off = middle - move.from.head<2>();
        const double square = route.squaredNorm(), rise = move.to.z() - move.from.z();
        const double least = std::min(0.0, rise);
        double distance = off.norm(), lo = least, hi = least;
        if (square > tolerance::probe_rounding * tolerance::probe_rounding) {
            const double foot = off.dot(route) / square, s = std::clamp(foot, 0.0, 1.0);
            distance = (off - s * route).norm();
            const double beside = (off - foot * route).squaredNorm(), reach = radius_ + half_;
            if (distance > reach) return false;
            const double about = std::sqrt(std::max(0.0, reach * reach - beside) / square);
            const double first = std::clamp(foot - about, 0.0, 1.0),
                         last = std::clamp(foot + about, 0.0, 1.0);
            lo = std::max(least, std::min(first * rise, last * rise));
            hi = s * rise;
        } else if (distance > radius_ + half_) {
            return false;
        }
        const double near = std::max(0.0, distance - half_), far = distance + half_;
        h.lo = move.from.z() + lo + lowest(std::min(near, radius_));
        h.hi = far < radius_ ? move.from.z() + hi + highest(far) : infinity;
        return true;
    }

    template <class Visit>
    void each(std::size_t begin, std::size_t end, const Visit& visit) const {
        const auto place = [&](double x, int k) { return (x - grid_.lo_[k]) / grid_.cell_; };
        const double more = radius_ + (half_ - std::sqrt(0.5) * grid_.cell_);
        for (const Move& move : moves_) {
            const Vec2 lo = move.from.cwiseMin(move.to).head<2>() - Vec2::Constant(more),
                       hi = move.from.cwiseMax(move.to).head<2>() + Vec2::Constant(more);
            const double low = place(lo.y(), 1), high = place(hi.y(), 1);
            if (high < double(begin) || low >= double(end)) continue;
            const auto j0 = std::size_t(std::max(low, double(begin))),
                       j1 = std::size_t(std::min(high, double(end - 1)));
            const auto i0 = std::size_t(std::max(place(lo.x(), 0), 0.0)),
                       i1 = std::size_t(std::min(place(hi.x(), 0), double(grid_.columns_ - 1)));
            for (std::size_t j = j0; j <= j1; ++j)
                for (std::size_t i = i0; i <= i1; ++i) {
                    const Vec2 middle = grid_.lo_ + grid_.cell_ * Vec2(double(i) + 0.5, double(j) + 0.5);
                    if (Heights h{}; over(move, middle, h))
                        visit(i + std::size_t(grid_.columns_) * j, move, h);
                }
        }
    }

    MotionShadows& grid_;
    double radius_, half_ = 0;              ///< of the cutter; of a cell's diagonal
    std::vector<Move> moves_;               ///< in the tool's frame
    std::array<double, steps + 1> profile_; ///< heights of the lower surface
};

MotionShadows::MotionShadows(const MotionProbes& probes, const Progress& progress) {
    const MotionTree& tree = probes.motions();
    if (tree.empty() || tree.turns() || tree.nodes_.front().cone > 0) return;
    Builder(*this, probes).build(progress);
}

bool MotionShadows::know(const Vec3& p, const Vec3& n, double length) const {
    if (columns_ == 0 || !(length < infinity)) return false;
    const double start = frame_.row(2).dot(p), rise = frame_.row(2).dot(n);
    return std::max(start, start + length * rise) < ceiling_;
}

template <class Visit>
void MotionShadows::walk(const Vec3& p, const Vec3& n, double from, double to, const Visit& visit) const {
    const Vec3 start = frame_ * p, d = frame_ * n;
    const std::array<int, 2> count{columns_, rows_};
    std::array<double, 2> x{}, change{}; // in cells
    double t = from, end = to;
    for (int k = 0; k < 2; ++k) {
        x[std::size_t(k)] = (start[k] - lo_[k]) / cell_;
        change[std::size_t(k)] = d[k] / cell_;
        const double at = x[std::size_t(k)], c = change[std::size_t(k)], last = count[std::size_t(k)];
        if (c == 0) {
            if (at < 0 || at > last) return;
            continue;
        }
        const double a = -at / c, b = (last - at) / c;
        t = std::max(t, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (!(t <= end)) return;
    std::array<int, 2> cell{};
    for (std::size_t k = 0; k < 2; ++k)
        cell[k] = std::clamp(int(std::floor(x[k] + t * change[k])), 0, count[k] - 1);
    for (;;) {
        double next = infinity;
        std::size_t across = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            if (change[k] == 0) continue;
            const double side = ((change[k] > 0 ? cell[k] + 1 : cell[k]) - x[k]) / change[k];
            if (!(side < next)) continue;
            next = side;
            across = k;
        }
        const double stop = std::min(next, end);
        const std::size_t at = std::size_t(cell[0]) + std::size_t(columns_) * std::size_t(cell[1]);
        const double top = std::max(start.z() + t * d.z(), start.z() + stop * d.z());
        end = std::min(end, visit(Passage{{shadows_.data() + first_[at], first_[at + 1] - first_[at]},
                                          t,
                                          stop,
                                          top + tolerance::probe_rounding}));
        if (next >= end) return;
        cell[across] += change[across] > 0 ? 1 : -1;
        if (cell[across] < 0 || cell[across] >= count[across]) return;
        t = std::max(t, next);
    }
}

bool MotionShadows::lower(const MotionProbes& probes, const Vec3& p, const Vec3& n, LineProbe& probe,
                          RecentSweeps& recent) const {
    MotionProbes::Line line{p, n};
    line.set(probe.value, probes.slack_);
    bool lowered = false;
    std::vector<Index>& asked = recent.asked;
    asked.clear();
    walk(p, n, line.near, probe.value, [&](const Passage& passage) {
        for (const Shadow& shadow : passage.shadows) {
            if (shadow.low > passage.top) break;
            if (std::find(asked.begin(), asked.end(), shadow.motion) != asked.end()) continue;
            asked.push_back(shadow.motion);
            lowered = probes.ask(shadow.motion, line, probe, &recent) || lowered;
        }
        return line.far;
    });
    return lowered;
}

} // namespace facetmill
