#include "core/strategy/finish3/stepover.h"

#include "core/base/tolerances.h"
#include "core/strategy/finish3/gap_cusp.h"
#include "core/strategy/plan/budget.h"

namespace facetmill {

namespace {

/// No step is more than this share of the diameter: Lu's c for roughing.
constexpr double max_step_share = 0.95;
/// Accepted without a further try: share of the allowed cusp.
constexpr double good_share = 0.96;
/// Accepted after a few tries.
constexpr double fair_share = 0.92;

} // namespace

StepOver::StepOver(const StepOverInput& input) : in_(input), field_(input) {
    largest_ = max_step_share * 2 * in_.cover->radius();
    guess_ = std::min(largest_, field_.level_step());
    smallest_ = tolerance::smallest_step_share * std::min(field_.level_step(), largest_);
}

std::vector<Interval> StepOver::ranges(double v, double back, double ahead) const {
    return in_.domain->strip(v - back, v + ahead, in_.merge);
}

DriveLine StepOver::line(double v, double back, double ahead, const Progress& progress) const {
    DriveLine line;
    line.v = v;
    line.back = back;
    line.ahead = ahead;
    LineTolerance rough;
    rough.below = rough.above = cusp_detail(in_.cusp);
    rough.spacing = field_.spacing();
    for (const Interval& r : ranges(v, back, ahead))
        line.runs.push_back(
            lift_line(field_.lift(), v * in_.frame.across, in_.frame.along, r.lo, r.hi, rough, progress));
    return line;
}

double StepOver::worst_cusp(const DriveLine* a, const DriveLine* b, double edge,
                            const Progress& progress) const {
    return GapCusp(field_, a, b, edge).largest(progress);
}

StepOver::Step StepOver::next(const DriveLine* a, const Progress& progress) {
    const double from = a ? a->v : in_.domain->lo();
    const double cap = std::min(a ? largest_ : 0.5 * largest_, in_.domain->hi() - from);
    Step best, last;
    best.satisfied = last.satisfied = false;
    double low = 0, high = infinity;
    double step = std::min(a ? guess_ : 0.5 * guess_, cap);
    // At a slanted border the line before reaches half of the way, and so does this one. The step after this
    // one is not known yet: as much as it will likely be.
    DriveLine longer;
    const auto attempt = [&](double d) {
        Step s;
        s.line = line(from + d, reach_share * d, reach_share * std::max(d, guess_), progress);
        if (a && a->ahead < reach_share * d) {
            longer = line(a->v, a->back, reach_share * std::max(d, guess_), progress);
            a = &longer;
        }
        s.cusp = worst_cusp(a, &s.line, from, progress);
        s.satisfied = s.cusp <= in_.cusp;
        return s;
    };
    for (int tries = 0; tries < 24; ++tries) {
        Step s = attempt(step);
        double wish = 0.5 * step;
        if (s.cusp < infinity)
            wish = s.cusp > 0 ? std::min(step * std::sqrt(0.985 * in_.cusp / s.cusp), 4 * step) : 4 * step;
        if (s.satisfied) {
            low = step;
            const bool good = s.cusp >= good_share * in_.cusp;
            best = std::move(s);
            if (good || step >= cap) break;
        } else {
            high = step;
            last = std::move(s);
            if (step <= smallest_) break;
        }
        if (low > 0 && high < infinity && high - low <= 0.01 * high) break;
        // A step is only as the root of the cusp: what is left to gain is small.
        if (tries >= 2 && best.satisfied && best.cusp >= fair_share * in_.cusp) break;
        if (low == 0) {
            step = std::clamp(wish, 0.1 * high, 0.99 * high);
            step = std::max(step, std::min(smallest_, 0.9 * high));
        } else if (high == infinity) {
            step = std::min(std::max(wish, 1.02 * low), cap);
        } else {
            const double margin = 0.1 * (high - low);
            step = std::clamp(wish, low + margin, high - margin);
        }
        step = std::min(step, cap);
    }
    if (best.satisfied) {
        if (a) guess_ = std::min(low, largest_);
        return best;
    }
    // No step is small enough. Take the largest that leaves hardly more than the smallest does: what a
    // smaller step does not improve is not the step's fault.
    double fine = last.cusp;
    for (double d = std::min(2 * step, cap); d > step && d <= guess_; d = std::min(2 * d, cap)) {
        Step s = attempt(d);
        if (!(s.cusp <= 1.05 * fine)) break;
        last = std::move(s);
        if (d >= cap) break;
    }
    return last;
}

} // namespace facetmill
