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
/// A step that leaves something to partial lines is tried again where another one is cheaper and differs by
/// more than this share, so often at most.
constexpr double same_choice = 0.08;
constexpr int max_choices = 3;
/// It has to save this share of the travel.
constexpr double worth_leaving = 0.9;
/// And leave no more than this share of the line.
constexpr double max_left = 0.5;
/// Partial lines lie no farther than this share of the way to the next line.
constexpr double before_limit = 0.75;
/// Steps whose travel is estimated are in this ratio.
constexpr double step_ratio = 1.1;
/// What a piece of a line travels beside its own length, in radii: its ends, the way to it and back.
constexpr double piece_cost = 1.5;
/// Where lines do not come by at all, this share of their step may do.
constexpr double unmet_share = 0.25;

} // namespace

StepOver::StepOver(const StepOverInput& input) : in_(input), field_(input) {
    largest_ = max_step_share * 2 * in_.cover->radius();
    guess_ = std::min(largest_, field_.level_step());
    smallest_ = tolerance::smallest_step_share * std::min(field_.level_step(), largest_);
}

std::vector<Interval> StepOver::ranges(double v, double back, double ahead, const Interval* within) const {
    if (!within) return in_.domain->strip(v - back, v + ahead, in_.merge);
    const Interval wide{within->lo - beyond(), within->hi + beyond()};
    std::vector<Interval> all = in_.domain->strip(v - back, v + ahead, in_.merge, &wide);
    for (Interval& r : all)
        r = {std::max(r.lo, wide.lo), std::min(r.hi, wide.hi)};
    std::erase_if(all, [](const Interval& r) { return !(r.lo <= r.hi); });
    return all;
}

DriveLine StepOver::line(double v, double back, double ahead, const Interval* within,
                         const Progress& progress) const {
    DriveLine line;
    line.v = v;
    line.back = back;
    line.ahead = ahead;
    LineTolerance rough;
    rough.below = rough.above = cusp_detail(in_.cusp);
    rough.spacing = field_.spacing();
    for (const Interval& r : ranges(v, back, ahead, within))
        line.runs.push_back(
            lift_line(field_.lift(), v * in_.frame.across, in_.frame.along, r.lo, r.hi, rough, progress));
    return line;
}

namespace {

double largest_of(const std::vector<CuspAt>& found) {
    double worst = 0;
    for (const CuspAt& c : found)
        worst = std::max(worst, c.cusp);
    return worst;
}

} // namespace

double StepOver::worst_cusp(const DriveLine* a, const DriveLine* b, double edge,
                            const Progress& progress) const {
    return largest_of(GapCusp(field_, a, b, edge).along(progress));
}

std::vector<Interval> StepOver::left_between(const DriveLine& a, const DriveLine& b, const Interval& within,
                                             const Progress& progress) const {
    return left_of(GapCusp(field_, &a, &b, 0, &within).along(progress), &within);
}

bool StepOver::leaves_any_between(const DriveLine& a, const DriveLine& b, const Interval& within,
                                  const Progress& progress) const {
    return GapCusp(field_, &a, &b, 0, &within).is_any_above(progress);
}

std::vector<Interval> StepOver::left_of(const std::vector<CuspAt>& found, const Interval* within) const {
    std::vector<Interval> left;
    for (const CuspAt& c : found)
        if (c.cusp > in_.cusp) left.push_back({c.u - field_.spacing(), c.u + field_.spacing()});
    left = joined(std::move(left), join());
    if (within)
        for (Interval& r : left)
            r = {std::max(r.lo, within->lo), std::min(r.hi, within->hi)};
    return left;
}

double StepOver::cap_of(const Search& search) const {
    const double from = search.a ? search.a->v : in_.domain->lo();
    return std::min(search.a ? largest_ : 0.5 * largest_, search.limit - from);
}

/// Half of what the two lines of a step reach into it is the line's before; at a slanted border it has to be
/// made longer for a wide step. The step after this one is not known yet: as much as it will likely be.
StepOver::Step StepOver::attempt(const Search& search, const DriveLine*& a, DriveLine& longer, double d,
                                 std::vector<CuspAt>& found, const Progress& progress) const {
    const double from = a ? a->v : in_.domain->lo();
    Step s;
    s.line =
        line(from + d, reach_share * d, reach_share * std::max(d, search.guess), search.within, progress);
    if (a && a->ahead < reach_share * d) {
        longer = line(a->v, a->back, reach_share * std::max(d, search.guess), search.within, progress);
        a = &longer;
    }
    found = GapCusp(field_, a, &s.line, from, search.within).along(progress);
    s.cusp = largest_of(found);
    s.satisfied = s.cusp <= in_.cusp;
    return s;
}

StepOver::Choice StepOver::cheapest_step(const std::vector<CuspAt>& found, double step, double cap) const {
    // A cusp is as the square of the step.
    std::vector<double> need(found.size()), width(found.size(), 0);
    Choice whole{cap, false};
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double c = found[i].cusp;
        need[i] = c == infinity
                      ? unmet_share * step
                      : std::min(c > 0 ? step * std::sqrt(0.985 * in_.cusp / c) : infinity, 4 * step);
        need[i] = std::max(need[i], smallest_);
        whole.step = std::min(whole.step, need[i]);
        if (i > 0) {
            const double half = 0.5 * std::min(found[i].u - found[i - 1].u, 2 * field_.spacing());
            width[i - 1] += half;
            width[i] += half;
        }
    }
    // Travel per width: lines, partial lines, and what each piece takes beside its own length.
    const double piece = piece_cost * in_.cover->radius();
    const auto travel = [&](double x) {
        double sum = piece, most = 0, last = -infinity, once = 0, more = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double lines = std::ceil(x / need[i] - tolerance::level_angle);
            sum += width[i] * lines;
            (lines > 1 ? more : once) += width[i];
            if (lines <= 1) continue;
            if (found[i].u - last > join()) {
                sum += most * piece;
                most = 0;
            }
            last = found[i].u;
            most = std::max(most, lines - 1);
        }
        // Where most of it asks for lines between, the last of them would come close to its neighbour.
        return more <= max_left * (more + once) ? (sum + most * piece) / x : infinity;
    };
    Choice best = whole;
    double least = worth_leaving * travel(whole.step);
    for (double x = step_ratio * whole.step; whole.step < cap; x *= step_ratio) {
        x = std::min(x, cap);
        if (const double t = travel(x); t < least) {
            least = t;
            best = {x, true};
        }
        if (x >= cap || x > 4 * step) break;
    }
    return best;
}

StepOver::Step StepOver::next(const Search& search, const Progress& progress) const {
    if (!search.may_leave || !search.a) return farthest(search, progress);
    const double cap = (search.within ? before_limit : 1) * cap_of(search);
    Search now = search;
    double step = std::min(search.guess, cap);
    const DriveLine* a = search.a;
    DriveLine longer;
    std::vector<CuspAt> found;
    for (int tries = 0;; ++tries) {
        Step s = attempt(search, a, longer, step, found, progress);
        const Choice choice = cheapest_step(found, step, cap);
        if (!choice.leaves) {
            if (s.satisfied && (s.cusp >= good_share * in_.cusp || step >= cap)) return s;
            now.guess = choice.step;
            return farthest(now, progress);
        }
        if (tries + 1 < max_choices && std::abs(choice.step - step) > same_choice * step) {
            step = choice.step;
            continue;
        }
        s.left = left_of(found, search.within);
        if (!s.left.empty()) s.cusp = in_.cusp;
        s.satisfied = true;
        return s;
    }
}

StepOver::Step StepOver::farthest(const Search& search, const Progress& progress) const {
    const double cap = cap_of(search);
    Step best, last;
    best.satisfied = last.satisfied = false;
    double low = 0, high = infinity;
    double step = std::min(search.a ? search.guess : 0.5 * search.guess, cap);
    const DriveLine* a = search.a;
    DriveLine longer;
    std::vector<CuspAt> found;
    for (int tries = 0; tries < 24; ++tries) {
        Step s = attempt(search, a, longer, step, found, progress);
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
    if (best.satisfied) return best;
    // No step is small enough. Take the largest that leaves hardly more than the smallest does: what a
    // smaller step does not improve is not the step's fault.
    const double fine = last.cusp;
    for (double d = std::min(2 * step, cap); d > step && d <= search.guess; d = std::min(2 * d, cap)) {
        Step s = attempt(search, a, longer, d, found, progress);
        if (!(s.cusp <= 1.05 * fine)) break;
        last = std::move(s);
        if (d >= cap) break;
    }
    return last;
}

} // namespace facetmill
