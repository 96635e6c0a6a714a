// Finds, among many boxes on a plane, those that meet a strip, or a window of it. In rows along u, and in
// every row by where they begin: a strip that is looked at over a short window costs what lies in the window.
#pragma once

#include "core/base/parallel.h"
#include "core/base/round_outward.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace facetmill {

/// In float, rounded outward; empty where lo > hi.
struct FloatInterval {
    float lo = 1, hi = 0;
    void add(double lowest, double highest) {
        const float low = rounded_down(lowest), high = rounded_up(highest);
        if (lo > hi) {
            lo = low;
            hi = high;
        } else {
            lo = std::min(lo, low);
            hi = std::max(hi, high);
        }
    }
};

struct FlatBox {
    FloatInterval u, v;
};

class BoxRows {
public:
    BoxRows() = default;
    /// Boxes with an empty v are left out. 24 bytes a box.
    BoxRows(std::vector<FlatBox> boxes, const Progress& progress);

    /// Calls visit(i, box) once for every box that meets v0 <= v <= v1 and u0 <= u <= u1, in an order that
    /// depends on nothing but the boxes and the query; along a row u.lo never falls.
    template <class Visit>
    void visit(double v0, double v1, double u0, double u1, Visit&& visit) const;

    bool empty() const { return items_.empty(); }
    double lo() const { return lo_; } ///< of v; lo > hi where there are none
    double hi() const { return hi_; }

private:
    std::size_t row(double v) const {
        const double r = std::floor((v - lo_) * per_width_);
        return r <= 0 ? 0 : std::min(std::size_t(std::min(r, 1e9)), rows_ - 1);
    }
    void fill_rows(const Progress& progress);

    double lo_ = 0, hi_ = -1, per_width_ = 0;
    std::size_t rows_ = 0;
    std::vector<FlatBox> boxes_;
    std::vector<std::uint32_t> start_, items_;
    std::vector<float> longest_; ///< along u, of each row
};

template <class Visit>
void BoxRows::visit(double v0, double v1, double u0, double u1, Visit&& visit) const {
    if (items_.empty() || !(v0 <= v1) || v1 < lo_ || v0 > hi_) return;
    const std::size_t first = row(v0), last = row(v1);
    for (std::size_t r = first; r <= last; ++r) {
        const auto end = items_.begin() + start_[r + 1];
        auto at = std::lower_bound(items_.begin() + start_[r], end, u0 - double(longest_[r]),
                                   [this](std::uint32_t i, double u) { return double(boxes_[i].u.lo) < u; });
        for (; at != end; ++at) {
            const FlatBox& box = boxes_[*at];
            if (double(box.u.lo) > u1) break;
            if (double(box.u.hi) < u0 || double(box.v.hi) < v0 || double(box.v.lo) > v1) continue;
            if (r != first && row(box.v.lo) != r) continue; // seen in an earlier row
            visit(std::size_t(*at), box);
        }
    }
}

} // namespace facetmill
