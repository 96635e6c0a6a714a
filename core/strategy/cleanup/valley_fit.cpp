#include "core/strategy/cleanup/valley_fit.h"

#include "core/base/tolerances.h"
#include "core/strategy/cleanup/border_touch.h"

#include <algorithm>

namespace facetmill {

namespace {

/// A centre runs back if it moves against the tip: by this cosine, and by this share of the tip's movement.
constexpr double back_share = 0.1;

/// use(point, length) for the points up to a length of `window` along the tips' path, from point i to one
/// side (1, -1).
template <class Use>
void within(const ValleyCurve& curve, std::size_t i, std::ptrdiff_t side, double window, Use&& use) {
    const auto& p = curve.points;
    const auto n = std::ptrdiff_t(p.size());
    double length = 0;
    auto k = std::ptrdiff_t(i);
    for (std::ptrdiff_t moved = 1; moved < n; ++moved) {
        std::ptrdiff_t next = k + side;
        if (curve.closed) next = (next + n) % n;
        if (next < 0 || next >= n) break;
        length += (p[std::size_t(next)].tip - p[std::size_t(k)].tip).norm();
        if (length > window) break;
        k = next;
        use(std::size_t(k), length);
    }
}

} // namespace

bool runs_back(const PencilPoint& a, const PencilPoint& b) {
    const Vec3 center = b.center - a.center, tip = b.tip - a.tip;
    return center.dot(tip) < -back_share * center.norm() * tip.norm()
           && center.norm() > back_share * tip.norm();
}

std::vector<Rolls> rolling(const ValleyInput& input, const ValleyCurve& curve, double window) {
    const auto& p = curve.points;
    std::vector<Rolls> rolls(p.size(), Rolls::no);
    for (std::size_t i = 0; i < p.size(); ++i) {
        bool back = true;
        std::size_t asked = 0;
        for (const std::ptrdiff_t side : {-1, 1}) {
            std::size_t last = i;
            within(curve, i, side, window, [&](std::size_t k, double) {
                if (p[k].on_part) last = k;
            });
            if (last == i) continue;
            ++asked;
            back = back && p[i].on_part && runs_back(p[i], p[last]);
        }
        int over = 0;
        for (std::size_t side = 0; side < 2; ++side)
            over +=
                rolls_over_border(*input.mesh, *input.grid, *input.side, p[i].touch[side], p[i].normal[side]);
        if (over == 2 || (asked > 0 && back))
            rolls[i] = Rolls::out;
        else if (over == 1)
            rolls[i] = Rolls::on_one_side;
    }
    return rolls;
}

void fit_up(ValleyCurve& curve, double window, const std::vector<Rolls>& rolls) {
    auto& p = curve.points;
    std::vector<Vec3> sums(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
        Vec3 sum = Vec3::Zero();
        const auto add = [&](std::size_t k, double length) {
            const double weight = window > 0 ? 1 - length / window : 1;
            if (rolls[k] == Rolls::no) sum += weight * (p[k].normal[0] + p[k].normal[1]);
        };
        add(i, 0);
        for (const std::ptrdiff_t side : {-1, 1})
            within(curve, i, side, window, add);
        sums[i] = sum;
    }
    // Beyond as at the last place before.
    for (std::size_t i = 1; i < p.size(); ++i)
        if (sums[i] == Vec3::Zero()) sums[i] = sums[i - 1];
    for (std::size_t i = p.size(); i-- > 1;)
        if (sums[i - 1] == Vec3::Zero()) sums[i - 1] = sums[i];
    for (std::size_t i = 0; i < p.size(); ++i) {
        Vec3 sum = sums[i] == Vec3::Zero() ? Vec3(p[i].normal[0] + p[i].normal[1]) : sums[i];
        // A 3-axis cutter is never moved downwards out of a valley.
        sum.z() = std::max(sum.z(), 0.0);
        p[i].up = sum.norm() > tolerance::level_angle ? Vec3(sum.normalized()) : Vec3::UnitZ();
    }
}

} // namespace facetmill
