#include "core/strategy/finish3/partial_lines.h"

#include <algorithm>
#include <utility>

namespace facetmill {

namespace {

/// Partial lines have partial lines between them, so deep at most.
constexpr int deepest_partial = 4;
/// Where less than this share of a range is left to do, its lines end.
constexpr double narrowed = 0.7;

} // namespace

void PartialLines::fill(const DriveLine& a, const DriveLine& b, const std::vector<Interval>& ranges,
                        const Progress& progress) {
    for (const Interval& range : ranges)
        fill(a, b, range, 0, progress);
}

void PartialLines::fill(const DriveLine& a, const DriveLine& b, const Interval& range, int depth,
                        const Progress& progress) {
    DriveLine last = a;
    std::size_t own = lines_.size(); // of `last`, once it is one of these
    bool is_own = false;
    const auto ends_at = [&](double v) {
        if (is_own) lines_[own].ahead = StepOver::reach_share * (v - last.v);
    };
    double guess = std::min(0.5 * (b.v - a.v), stepover_.first_guess());
    for (;;) {
        std::vector<Interval> left;
        if (is_own) left = stepover_.left_between(last, b, range, progress);
        if (is_own ? left.empty() : !stepover_.leaves_any_between(last, b, range, progress)) break;
        if (b.v - last.v <= stepover_.smallest_step()) {
            ++unsatisfied_;
            break;
        }
        double length = 0;
        for (const Interval& r : left)
            length += r.length();
        if (is_own && depth < deepest_partial && length < narrowed * range.length()) {
            ends_at(b.v);
            for (const Interval& r : left)
                fill(last, b, r, depth + 1, progress);
            return;
        }
        StepOver::Search search;
        search.a = &last;
        search.limit = b.v;
        search.within = &range;
        search.guess = guess;
        search.may_leave = depth < deepest_partial;
        StepOver::Step step = stepover_.next(search, progress);
        cusp_max_ = std::max(cusp_max_, step.cusp);
        if (!step.satisfied) ++unsatisfied_;
        if (!(step.line.v < b.v)) break;
        // Beside a place that no step serves the others still take theirs.
        if (step.satisfied) guess = step.line.v - last.v;
        ends_at(step.line.v);
        const DriveLine before = std::exchange(last, std::move(step.line));
        for (const Interval& r : step.left)
            fill(before, last, r, depth + 1, progress);
        own = lines_.size();
        is_own = true;
        lines_.push_back({last.v, last.back, last.ahead, range});
    }
    ends_at(b.v);
}

std::vector<PlannedLine> PartialLines::take() {
    std::stable_sort(lines_.begin(), lines_.end(),
                     [](const PlannedLine& a, const PlannedLine& b) { return a.v < b.v; });
    return std::exchange(lines_, {});
}

} // namespace facetmill
