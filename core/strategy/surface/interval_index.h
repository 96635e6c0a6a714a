// Finds, among many intervals on a line, those that meet a given one. Facets are looked up by their interval
// along the step-over direction, so that a drive plane costs what it cuts, not what the part has. (Lu 3.1
// keeps facets in ordered arrays for this; ordered by one end only, a few long facets make his search scan.)
#pragma once

#include "core/base/progress.h"
#include "core/base/round_outward.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace facetmill {

class IntervalIndex {
public:
    /// interval(i) gives {lo, hi} of item i; items with lo > hi (or NaN) are left out. Linear time; about 16
    /// bytes an item.
    template <class Interval>
    IntervalIndex(std::size_t n, const Interval& interval, const Progress& progress);

    /// Calls visit(i) once for every item that may meet [lo, hi], in an order that depends on nothing but the
    /// items and the query. "May": ends are held in float, rounded outward.
    template <class Visit>
    void visit(double lo, double hi, Visit&& visit) const;

    bool empty() const { return items_.empty(); }
    double lo() const { return lo_; }
    double hi() const { return hi_; }

private:
    static constexpr std::size_t check_every = 16384;

    struct Ends {
        float lo, hi;
    };
    std::size_t bucket(double v) const {
        const double b = std::floor((v - lo_) * per_width_);
        return b <= 0 ? 0 : std::min(std::size_t(std::min(b, 1e9)), buckets_ - 1);
    }
    double lo_ = 0, hi_ = -1, per_width_ = 0;
    std::size_t buckets_ = 0;
    std::vector<Ends> ends_;
    std::vector<std::uint32_t> start_, items_;
};

template <class Interval>
IntervalIndex::IntervalIndex(std::size_t n, const Interval& interval, const Progress& progress) : ends_(n) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo, total = 0;
    std::size_t used = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (i % check_every == 0) progress.check();
        const std::pair<double, double> e = interval(i);
        if (!(e.first <= e.second)) {
            ends_[i] = {1, 0};
            continue;
        }
        ends_[i] = {rounded_down(e.first), rounded_up(e.second)};
        lo = std::min(lo, double(ends_[i].lo));
        hi = std::max(hi, double(ends_[i].hi));
        total += e.second - e.first;
        ++used;
    }
    if (used == 0) return;
    lo_ = lo;
    hi_ = hi;
    // Buckets as wide as the mean item: every item lies in two of them on average.
    const double width = std::max(total / double(used), (hi - lo) / 65536);
    buckets_ = width > 0 ? std::size_t(std::ceil((hi - lo) / width)) : 1;
    buckets_ = std::clamp<std::size_t>(buckets_, 1, 65536);
    per_width_ = hi > lo ? double(buckets_) / (hi - lo) : 0;
    start_.assign(buckets_ + 1, 0);
    const auto each = [&](auto&& call) {
        for (std::size_t i = 0; i < n; ++i) {
            if (i % check_every == 0) progress.check();
            if (ends_[i].lo > ends_[i].hi) continue;
            const std::size_t last = bucket(ends_[i].hi);
            for (std::size_t b = bucket(ends_[i].lo); b <= last; ++b)
                call(b, i);
        }
    };
    each([&](std::size_t b, std::size_t) { ++start_[b + 1]; });
    for (std::size_t b = 0; b < buckets_; ++b)
        start_[b + 1] += start_[b];
    items_.resize(start_[buckets_]);
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    each([&](std::size_t b, std::size_t i) { items_[next[b]++] = std::uint32_t(i); });
}

template <class Visit>
void IntervalIndex::visit(double lo, double hi, Visit&& visit) const {
    if (items_.empty() || !(lo <= hi) || hi < lo_ || lo > hi_) return;
    const std::size_t first = bucket(lo), last = bucket(hi);
    for (std::size_t b = first; b <= last; ++b)
        for (std::uint32_t k = start_[b]; k < start_[b + 1]; ++k) {
            const std::uint32_t i = items_[k];
            const Ends& e = ends_[i];
            if (double(e.hi) < lo || double(e.lo) > hi) continue;
            if (b != first && bucket(e.lo) != b) continue; // seen in an earlier bucket
            visit(std::size_t(i));
        }
}

} // namespace facetmill
