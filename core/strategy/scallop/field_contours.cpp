#include "core/strategy/scallop/field_contours.h"

#include <algorithm>
#include <map>

namespace facetmill {

namespace {

/// Edges of the grid: twice the number of their first place, and one more where they run across rows.
using GridEdge = std::size_t;

class ContourWalk {
public:
    ContourWalk(const MetricGrid& field, const std::vector<double>& values, double value)
        : field_(field), values_(values), value_(value) {}

    std::vector<FieldContour> run(const Progress& progress) {
        for (int r = 0; r + 1 < field_.rows; ++r) {
            progress.check();
            for (int c = 0; c + 1 < field_.columns; ++c)
                cell(c, r);
        }
        std::vector<FieldContour> all;
        // Open ones from their ends, then what is closed.
        for (const bool open : {true, false})
            for (const auto& [edge, next] : next_)
                if (!done_.count(edge) && (!open || next.size() == 1)) all.push_back(follow(edge));
        return all;
    }

private:
    bool above(std::size_t i) const { return values_[i] > value_; }

    void cell(int c, int r) {
        const std::size_t a = field_.number(c, r), b = a + 1, d = field_.number(c, r + 1), e = d + 1;
        for (const std::size_t i : {a, b, d, e})
            if (!field_.cut[i] || !(values_[i] < infinity)) return;
        std::array<GridEdge, 4> crossed{};
        std::size_t n = 0;
        // Counter-clockwise from the lower edge.
        if (above(a) != above(b)) crossed[n++] = 2 * a;
        if (above(b) != above(e)) crossed[n++] = 2 * b + 1;
        if (above(d) != above(e)) crossed[n++] = 2 * d;
        if (above(a) != above(d)) crossed[n++] = 2 * a + 1;
        if (n == 2) join(crossed[0], crossed[1]);
        if (n != 4) return;
        const bool middle = 0.25 * (values_[a] + values_[b] + values_[d] + values_[e]) > value_;
        const bool round_a = middle != above(a); // lines cut off the corners a and e
        join(crossed[0], round_a ? crossed[3] : crossed[1]);
        join(crossed[2], round_a ? crossed[1] : crossed[3]);
    }
    void join(GridEdge a, GridEdge b) {
        next_[a].push_back(b);
        next_[b].push_back(a);
    }
    FieldContour follow(GridEdge first) {
        FieldContour contour;
        contour.value = value_;
        GridEdge at = first;
        for (;;) {
            done_[at] = true;
            const std::size_t i = at / 2, j = at % 2 == 0 ? i + 1 : i + std::size_t(field_.columns);
            const double t = std::clamp((value_ - values_[i]) / (values_[j] - values_[i]), 0.0, 1.0);
            contour.places.emplace_back((1 - t) * field_.place(i) + t * field_.place(j));
            contour.corners.push_back(i);
            contour.corners.push_back(j);
            const auto& next = next_.at(at);
            const auto on =
                std::find_if(next.begin(), next.end(), [&](GridEdge e) { return !done_.count(e); });
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
    double value_;
    std::map<GridEdge, std::vector<GridEdge>> next_;
    std::map<GridEdge, bool> done_;
};

} // namespace

std::vector<FieldContour> field_contours(const MetricGrid& field, const std::vector<double>& values,
                                         double value, const Progress& progress) {
    return ContourWalk(field, values, value).run(progress);
}

} // namespace facetmill
