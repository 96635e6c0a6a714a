#include "core/strategy/surface/box_rows.h"

#include <limits>

namespace facetmill {

namespace {

constexpr std::size_t check_every = 16384, max_rows = 65536, rows_per_task = 16;

} // namespace

BoxRows::BoxRows(std::vector<FlatBox> boxes, const Progress& progress) : boxes_(std::move(boxes)) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo, total = 0;
    std::size_t used = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        if (i % check_every == 0) progress.check();
        const FloatInterval& v = boxes_[i].v;
        if (!(v.lo <= v.hi)) continue;
        lo = std::min(lo, double(v.lo));
        hi = std::max(hi, double(v.hi));
        total += double(v.hi) - double(v.lo);
        ++used;
    }
    if (used == 0) return;
    lo_ = lo;
    hi_ = hi;
    // Rows as wide as the mean box: every box lies in two of them on average.
    const double width = std::max(total / double(used), (hi - lo) / double(max_rows));
    rows_ = width > 0 ? std::size_t(std::ceil((hi - lo) / width)) : 1;
    rows_ = std::clamp<std::size_t>(rows_, 1, max_rows);
    per_width_ = hi > lo ? double(rows_) / (hi - lo) : 0;
    fill_rows(progress);
}

void BoxRows::fill_rows(const Progress& progress) {
    start_.assign(rows_ + 1, 0);
    const auto each = [&](auto&& call) {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            if (i % check_every == 0) progress.check();
            const FloatInterval& v = boxes_[i].v;
            if (!(v.lo <= v.hi)) continue;
            const std::size_t last = row(v.hi);
            for (std::size_t r = row(v.lo); r <= last; ++r)
                call(r, i);
        }
    };
    each([&](std::size_t r, std::size_t) { ++start_[r + 1]; });
    for (std::size_t r = 0; r < rows_; ++r)
        start_[r + 1] += start_[r];
    items_.resize(start_[rows_]);
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    each([&](std::size_t r, std::size_t i) { items_[next[r]++] = std::uint32_t(i); });
    longest_.assign(rows_, 0);
    parallel_blocks(rows_, rows_per_task, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            const std::span<std::uint32_t> row_items(items_.data() + start_[r], start_[r + 1] - start_[r]);
            std::sort(row_items.begin(), row_items.end(), [this](std::uint32_t a, std::uint32_t b) {
                return boxes_[a].u.lo != boxes_[b].u.lo ? boxes_[a].u.lo < boxes_[b].u.lo : a < b;
            });
            for (const std::uint32_t i : row_items)
                longest_[r] =
                    std::max(longest_[r], rounded_up(double(boxes_[i].u.hi) - double(boxes_[i].u.lo)));
        }
    });
}

} // namespace facetmill
