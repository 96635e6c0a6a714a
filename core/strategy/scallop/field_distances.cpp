#include "core/strategy/scallop/field_distances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr int max_rounds = 60;

/// From the eight triangles round a place, across which distances change evenly.
bool relax(const MetricGrid& field, std::size_t i, std::vector<double>& d, double& change) {
    static constexpr std::array<std::array<int, 2>, 9> round{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}};
    const auto column = int(i % std::size_t(field.columns)), row = int(i / std::size_t(field.columns));
    const auto& [xx, xy, yy] = field.metric[i];
    const auto times = [&](const std::array<int, 2>& a, const std::array<int, 2>& b) {
        return xx * a[0] * b[0] + xy * (a[0] * b[1] + a[1] * b[0]) + yy * a[1] * b[1];
    };
    const auto at = [&](const std::array<int, 2>& by) {
        const int c = column + by[0], r = row + by[1];
        if (!field.has(c, r)) return infinity;
        const std::size_t n = field.number(c, r);
        return field.cut[n] ? d[n] : infinity;
    };
    double best = d[i], da = at(round[0]);
    for (std::size_t k = 0; k + 1 < round.size(); ++k) {
        const auto &a = round[k], &b = round[k + 1];
        const double db = at(b);
        const double alone = da + field.spacing * std::sqrt(times(a, a));
        best = std::min(best, alone);
        if (da < infinity && db < infinity) {
            const std::array<int, 2> e{b[0] - a[0], b[1] - a[1]};
            const double alpha = times(e, e), beta = times(a, e), gamma = times(a, a),
                         rise = (db - da) / field.spacing;
            const double left = alpha - rise * rise, area = alpha * gamma - beta * beta;
            if (left > 0 && area > 0) {
                const double t = (-beta - rise * std::sqrt(area / left)) / alpha;
                if (t > 0 && t < 1)
                    best = std::min(best,
                                    da + t * (db - da)
                                        + field.spacing
                                              * std::sqrt(std::max(0.0, (alpha * t + 2 * beta) * t + gamma)));
            }
        }
        da = db;
    }
    if (!(best < d[i])) return false;
    change = std::max(change, d[i] < infinity ? d[i] - best : 1.0);
    d[i] = best;
    return true;
}

} // namespace

std::vector<double> field_distances(const MetricGrid& field, const std::vector<MetricGrid::Seed>& seeds,
                                    const Progress& progress, double settled) {
    std::vector<double> d(field.size(), infinity);
    for (const MetricGrid::Seed& s : seeds)
        d[s.place] = std::min(d[s.place], s.distance);
    // Fast sweeping: in each of four orders what came from one side is known; again while it turns.
    for (int round = 0; round < max_rounds; ++round) {
        progress.set(double(round) / max_rounds);
        double change = 0;
        for (int order = 0; order < 4; ++order)
            for (int r = 0; r < field.rows; ++r) {
                progress.check();
                const int row = order & 1 ? field.rows - 1 - r : r;
                for (int c = 0; c < field.columns; ++c) {
                    const std::size_t i = field.number(order & 2 ? field.columns - 1 - c : c, row);
                    if (field.cut[i]) relax(field, i, d, change);
                }
            }
        if (change < settled) break;
    }
    return d;
}

} // namespace facetmill
