#include "core/strategy/scallop/field_contours.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace facetmill {

namespace {

/// Edges of the grid: twice the number of their first place, and one more where they run across rows.
using GridEdge = std::size_t;
constexpr std::uint32_t no_edge = 0xffffffff;

/// Lines of one level through the cells that it passes.
class ContourWalk {
public:
    ContourWalk(const MetricGrid& field, const std::vector<double>& values, double level)
        : field_(field), values_(values), level_(level) {}

    std::vector<FieldContour> run(const std::vector<std::uint32_t>& cells, const Progress& progress) {
        for (const std::uint32_t i : cells)
            cell(i);
        progress.check();
        link();
        std::vector<FieldContour> all;
        // Open ones from their ends, then what is closed.
        for (const bool open : {true, false})
            for (std::uint32_t e = 0; e < edges_.size(); ++e)
                if (!done_[e] && (!open || next_[e][1] == no_edge)) all.push_back(follow(e));
        return all;
    }

private:
    bool above(std::size_t i) const { return values_[i] > level_; }

    void cell(std::size_t a) {
        const std::size_t b = a + 1, d = a + std::size_t(field_.columns), e = d + 1;
        std::array<GridEdge, 4> crossed{};
        std::size_t n = 0;
        // Counter-clockwise from the lower edge.
        if (above(a) != above(b)) crossed[n++] = 2 * a;
        if (above(b) != above(e)) crossed[n++] = 2 * b + 1;
        if (above(d) != above(e)) crossed[n++] = 2 * d;
        if (above(a) != above(d)) crossed[n++] = 2 * a + 1;
        if (n == 2) join(crossed[0], crossed[1]);
        if (n != 4) return;
        const bool middle = 0.25 * (values_[a] + values_[b] + values_[d] + values_[e]) > level_;
        const bool round_a = middle != above(a); // lines cut off the corners a and e
        join(crossed[0], round_a ? crossed[3] : crossed[1]);
        join(crossed[2], round_a ? crossed[1] : crossed[3]);
    }
    void join(GridEdge a, GridEdge b) {
        joined_.push_back({a, b});
        joined_.push_back({b, a});
    }

    /// An edge lies between two cells: it is joined to one or two others.
    void link() {
        std::stable_sort(joined_.begin(), joined_.end(),
                         [](const auto& a, const auto& b) { return a[0] < b[0]; });
        for (const auto& [edge, other] : joined_)
            if (edges_.empty() || edges_.back() != edge) edges_.push_back(edge);
        next_.assign(edges_.size(), {no_edge, no_edge});
        done_.assign(edges_.size(), 0);
        std::size_t at = 0;
        for (const auto& [edge, other] : joined_) {
            if (edges_[at] != edge) ++at;
            const auto found = std::lower_bound(edges_.begin(), edges_.end(), other);
            next_[at][next_[at][0] == no_edge ? 0 : 1] = std::uint32_t(found - edges_.begin());
        }
    }

    FieldContour follow(std::uint32_t first) {
        FieldContour contour;
        contour.value = level_;
        std::uint32_t at = first;
        for (;;) {
            done_[at] = 1;
            const GridEdge edge = edges_[at];
            const std::size_t i = edge / 2, j = edge % 2 == 0 ? i + 1 : i + std::size_t(field_.columns);
            const double t = std::clamp((level_ - values_[i]) / (values_[j] - values_[i]), 0.0, 1.0);
            contour.places.emplace_back((1 - t) * field_.place(i) + t * field_.place(j));
            contour.corners.push_back(i);
            contour.corners.push_back(j);
            const auto& next = next_[at];
            const auto* on =
                std::find_if(next.begin(), next.end(), [&](auto e) { return e != no_edge && !done_[e]; });
            if (on == next.end()) {
                contour.closed =
                    contour.places.size() > 2 && std::find(next.begin(), next.end(), first) != next.end();
                return contour;
            }
            at = *on;
        }
    }

    const MetricGrid& field_;
    const std::vector<double>& values_;
    double level_;
    std::vector<std::array<GridEdge, 2>> joined_;
    std::vector<GridEdge> edges_; ///< in order
    std::vector<std::array<std::uint32_t, 2>> next_;
    std::vector<char> done_;
};

/// For every level the cells that it passes, named by their first corner.
std::vector<std::vector<std::uint32_t>> passed_cells(const MetricGrid& field,
                                                     const std::vector<double>& values,
                                                     std::span<const double> levels,
                                                     const Progress& progress) {
    std::vector<std::vector<std::uint32_t>> cells(levels.size());
    for (int r = 0; r + 1 < field.rows; ++r) {
        progress.check();
        for (int c = 0; c + 1 < field.columns; ++c) {
            const std::size_t a = field.number(c, r), d = field.number(c, r + 1);
            if (!field.cut[a] || !field.cut[a + 1] || !field.cut[d] || !field.cut[d + 1]) continue;
            const auto [least, most] = std::minmax({values[a], values[a + 1], values[d], values[d + 1]});
            if (!(most < infinity)) continue;
            // Those that some corners are above and others are not.
            for (auto level = std::lower_bound(levels.begin(), levels.end(), least);
                 level != levels.end() && *level < most; ++level)
                cells[std::size_t(level - levels.begin())].push_back(std::uint32_t(a));
        }
    }
    return cells;
}

} // namespace

std::vector<std::vector<FieldContour>> field_contours(const MetricGrid& field,
                                                      const std::vector<double>& values,
                                                      std::span<const double> levels,
                                                      const Progress& progress) {
    const auto cells = passed_cells(field, values, levels, progress.part(0, 0.5));
    std::vector<std::vector<FieldContour>> found(levels.size());
    parallel_for(levels.size(), 1, progress.part(0.5, 1), [&](std::size_t k) {
        found[k] = ContourWalk(field, values, levels[k]).run(cells[k], progress.part(0, 0));
    });
    return found;
}

} // namespace facetmill
