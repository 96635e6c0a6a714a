#include "core/strategy/scallop/field_distances.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace facetmill {

namespace {

/// Places are looked at in the order of their distances, as well as buckets so wide, in steps, tell it: as
/// wide as what lies between two places. Beyond so many all share the last.
constexpr double bucket_width = 0.14;
constexpr std::size_t max_buckets = 1000000;
/// An improvement by less of what counts as settled goes no farther.
constexpr double share_of_settled = 1e-6;
constexpr std::size_t places_a_check = 4096;

/// To the eight places round one, counter-clockwise.
constexpr std::array<std::array<int, 2>, 8> round_a_place{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

class Fronts {
public:
    Fronts(const MetricGrid& field, double settled)
        : field_(field), min_gain_(share_of_settled * settled), distance_(field.size(), infinity),
          waiting_(field.size(), 0) {
        for (std::size_t k = 0; k < by_.size(); ++k)
            by_[k] = std::ptrdiff_t(round_a_place[k][1]) * field.columns + round_a_place[k][0];
    }

    std::vector<double> run(const std::vector<MetricGrid::Seed>& seeds, const Progress& progress) {
        for (const MetricGrid::Seed& s : seeds)
            lowest_ = std::min(lowest_, s.distance);
        for (const MetricGrid::Seed& s : seeds)
            if (s.distance < distance_[s.place]) reach(s.place, s.distance);
        std::size_t looked_at = 0;
        for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
            for (std::size_t k = 0; k < buckets_[bucket].size(); ++k) {
                if (++looked_at % places_a_check == 0)
                    progress.set(std::min(1.0, double(looked_at) / double(2 * field_.size())));
                const std::size_t i = buckets_[bucket][k];
                if (!waiting_[i]) continue; // it came nearer, and has gone on
                waiting_[i] = 0;
                if (field_.cut[i]) go_on_from(i);
            }
            std::vector<std::uint32_t>().swap(buckets_[bucket]);
        }
        return std::move(distance_);
    }

private:
    void reach(std::size_t i, double distance) {
        distance_[i] = distance;
        waiting_[i] = 1;
        const double at = std::min((distance - lowest_) / bucket_width, double(max_buckets - 1));
        const auto bucket = std::size_t(at);
        if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
        buckets_[bucket].push_back(std::uint32_t(i));
    }

    /// To the eight places round it, across the triangles that have it as a corner.
    void go_on_from(std::size_t i) {
        const auto column = int(i % std::size_t(field_.columns)), row = int(i / std::size_t(field_.columns));
        for (std::size_t k = 0; k < by_.size(); ++k) {
            const int c = column + round_a_place[k][0], r = row + round_a_place[k][1];
            if (!field_.has(c, r)) continue;
            const auto n = std::size_t(std::ptrdiff_t(i) + by_[k]);
            if (!field_.cut[n]) continue;
            // Seen from there, what is gone on from lies the other way.
            const std::size_t back = (k + 4) % by_.size();
            const double here = distance_[n], left = value_at(n, c, r, (back + 1) % by_.size()),
                         right = value_at(n, c, r, (back + 7) % by_.size());
            if (!(std::min({distance_[i], left, right}) < here)) continue;
            const Side from = side(n, back);
            double best = distance_[i] + field_.spacing * std::sqrt(from.square);
            best = std::min(best, across(n, from, distance_[i], (back + 1) % by_.size(), left));
            best = std::min(best, across(n, from, distance_[i], (back + 7) % by_.size(), right));
            if (best < here - min_gain_) reach(n, best);
        }
    }

    double value_at(std::size_t n, int column, int row, std::size_t k) const {
        if (!field_.has(column + round_a_place[k][0], row + round_a_place[k][1])) return infinity;
        const auto i = std::size_t(std::ptrdiff_t(n) + by_[k]);
        return field_.cut[i] ? distance_[i] : infinity;
    }

    /// A displacement to a place beside, and what the metric makes of it: its square, and its product with
    /// others, which is taken with (x, y).
    struct Side {
        std::array<int, 2> by;
        double x, y, square;
    };
    Side side(std::size_t n, std::size_t k) const {
        const auto& [xx, xy, yy] = field_.metric[n];
        const auto& a = round_a_place[k];
        const double x = xx * a[0] + xy * a[1], y = xy * a[0] + yy * a[1];
        return {a, x, y, x * a[0] + y * a[1]};
    }

    /// Across the triangle with another place beside, over which distances change evenly; infinite where the
    /// way does not lead through it.
    double across(std::size_t n, const Side& from, double da, std::size_t k, double db) const {
        if (!(db < infinity)) return infinity;
        const auto& [xx, xy, yy] = field_.metric[n];
        const auto& b = round_a_place[k];
        const int ex = b[0] - from.by[0], ey = b[1] - from.by[1];
        const double alpha = xx * ex * ex + 2 * xy * ex * ey + yy * ey * ey, beta = from.x * ex + from.y * ey,
                     gamma = from.square, rise = (db - da) / field_.spacing;
        const double left = alpha - rise * rise, area = alpha * gamma - beta * beta;
        if (!(left > 0 && area > 0)) return infinity;
        const double t = (-beta - rise * std::sqrt(area / left)) / alpha;
        if (!(t > 0 && t < 1)) return infinity;
        return da + t * (db - da)
               + field_.spacing * std::sqrt(std::max(0.0, (alpha * t + 2 * beta) * t + gamma));
    }

    const MetricGrid& field_;
    double min_gain_, lowest_ = 0;
    std::array<std::ptrdiff_t, 8> by_{};
    std::vector<double> distance_;
    std::vector<char> waiting_; ///< to go on from there
    std::vector<std::vector<std::uint32_t>> buckets_;
};

} // namespace

std::vector<double> field_distances(const MetricGrid& field, const std::vector<MetricGrid::Seed>& seeds,
                                    const Progress& progress, double settled) {
    return Fronts(field, settled).run(seeds, progress);
}

} // namespace facetmill
