#include "core/strategy/scallop/scallop_steps.h"

#include "core/base/parallel.h"
#include "core/base/vec.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

const double ScallopSteps::steepest = radians(84);

namespace {

/// A cusp grows with the distance by less than this power where it is nothing but the gap between two flat
/// bottoms: lines then lie nearer by that share, so that what they wander leaves no gap.
constexpr double flat_power = 0.1, flat_overlap = 0.08;

/// Two passes on a plane, `apart` from each other along `aside`, each along `along`.
class PassesOnPlane {
public:
    PassesOnPlane(const CutterCover& cover, double slope, bool down, const Progress& progress)
        : cover_(cover), progress_(progress), n_(std::sin(slope), 0, std::cos(slope)),
          limit_(4 * cover.radius()) {
        const Vec3 fall(std::cos(slope), 0, -std::sin(slope)), level(0, 1, 0);
        aside_ = down ? fall : level;
        along_ = down ? level : fall;
    }

    /// The highest that stays between them: where the one pass leaves as much as the other, or the gap that
    /// neither comes to.
    double cusp(double apart) const {
        double lo = 0, hi = apart;
        constexpr int halvings = 22;
        for (int k = 0; k < halvings; ++k) {
            progress_.check();
            const double middle = 0.5 * (lo + hi);
            (left_by(middle) < left_by(apart - middle, true) ? lo : hi) = middle;
        }
        const auto left = [&](double at) { return std::min(left_by(at), left_by(apart - at, true)); };
        return std::max({0.0, left(lo), left(hi)});
    }
    double farthest(double cusp_allowed, double most) const {
        if (cusp(most) <= cusp_allowed) return most;
        double lo = 0, hi = most;
        constexpr int halvings = 22;
        for (int k = 0; k < halvings; ++k) {
            const double middle = 0.5 * (lo + hi);
            (cusp(middle) <= cusp_allowed ? lo : hi) = middle;
        }
        return lo;
    }

private:
    /// What one pass leaves so far beside it: the least along the pass, which is convex. `back`: to the other
    /// side.
    double left_by(double beside, bool back = false) const {
        const Vec3 p = (back ? -beside : beside) * aside_, tip = cover_.tip_offset(n_);
        const auto left = [&](double t) { return cover_.ray_entry(p, n_, tip + t * along_, limit_); };
        double lo = -cover_.radius(), hi = cover_.radius();
        constexpr int rounds = 30;
        for (int k = 0; k < rounds; ++k) {
            const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3, at_a = left(a), at_b = left(b);
            // Beside the cutter both are infinite: towards the middle.
            const bool lower = at_a == at_b ? std::abs(a) < std::abs(b) : at_a < at_b;
            (lower ? hi : lo) = lower ? b : a;
        }
        return std::min(left(0.5 * (lo + hi)), left(0));
    }

    const CutterCover& cover_;
    const Progress& progress_;
    Vec3 n_, aside_, along_;
    double limit_;
};

} // namespace

ScallopSteps::ScallopSteps(const CutterCover& cover, double cusp, const Progress& progress)
    : smallest_(infinity) {
    const double most = 4 * cover.radius();
    parallel_for(2 * slopes, 1, progress, [&](std::size_t k) {
        const std::size_t i = k / 2;
        const bool down = k % 2 == 0;
        const PassesOnPlane passes(cover, steepest * double(i) / double(slopes - 1), down, progress);
        Step& step = (down ? down_ : across_)[i];
        step.apart = passes.farthest(cusp, most);
        const double twice = passes.farthest(2 * cusp, most);
        if (!(step.apart > 0 && twice < most)) {
            step.power = 0.5;
        } else if (const double power = std::log2(twice / step.apart); power < flat_power) {
            step.power = 0;
            step.apart *= 1 - flat_overlap * (1 - power / flat_power);
        } else {
            step.power = std::clamp(power, 0.25, 1.0);
        }
    });
    for (const Table* table : {&down_, &across_})
        for (const Step& step : *table)
            smallest_ = std::min(smallest_, step.apart);
}

ScallopSteps::Step ScallopSteps::at(const Table& table, double slope) {
    const double place = std::clamp(slope / steepest, 0.0, 1.0) * double(slopes - 1);
    const std::size_t i = std::min(std::size_t(place), slopes - 2);
    const double t = place - double(i);
    const Step &a = table[i], &b = table[i + 1];
    return {a.apart + t * (b.apart - a.apart), a.power + t * (b.power - a.power)};
}

} // namespace facetmill
