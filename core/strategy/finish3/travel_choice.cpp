#include "core/strategy/finish3/travel_choice.h"

#include "core/strategy/finish3/partial_lines.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Gaps that are planned, one for so many that are expected; and their number.
constexpr double lines_per_sample = 15;
constexpr double min_gaps = 2, max_gaps = 8;
/// What a piece of a line travels beside its own length, in radii.
constexpr double travel_of_piece = 2;
/// A share of lines that leave something counts as so many times that share of the travel.
constexpr double unsatisfied_weight = 10;
/// Another direction is better where travel and what stays together come to less than this share.
constexpr double clearly_less = 0.95;

} // namespace

double TravelEstimate::cost() const {
    return length * (1 + unsatisfied_weight * unsatisfied);
}

TravelEstimate estimate_travel(const StepOverInput& input, const Progress& progress) {
    const StepOver stepover(input);
    const double lo = input.domain->lo(), hi = input.domain->hi(), guess = stepover.first_guess();
    TravelEstimate estimate;
    const double samples = std::clamp(std::round((hi - lo) / guess / lines_per_sample), min_gaps, max_gaps);
    double per_width = 0, lines = 0, unsatisfied = 0;
    for (double i = 0; i < samples; ++i) {
        const double v = lo + (hi - lo) * (i + 0.5) / samples, reach = StepOver::reach_share * guess;
        const DriveLine first = stepover.line(v, reach, reach, nullptr, progress);
        const StepOver::Step step = stepover.next({&first, hi, nullptr, guess, true}, progress);
        const double width = step.line.v - v;
        if (!(width > 0)) continue;
        double level = 0, length = 0, pieces = double(step.line.runs.size());
        for (const auto& run : step.line.runs)
            for (std::size_t k = 1; k < run.size(); ++k) {
                level += run[k].s - run[k - 1].s;
                length += std::hypot(run[k].s - run[k - 1].s, run[k].z - run[k - 1].z);
            }
        const double steep = level > 0 ? length / level : 1;
        PartialLines partial(stepover);
        partial.fill(first, step.line, step.left, progress);
        for (const PlannedLine& line : partial.take()) {
            ++lines;
            for (const Interval& r :
                 stepover.ranges(line.v, line.back, line.ahead, line.within ? &*line.within : nullptr)) {
                length += steep * r.length();
                ++pieces;
            }
        }
        ++lines;
        unsatisfied += partial.unsatisfied() + (step.satisfied ? 0 : 1);
        per_width += (length + travel_of_piece * input.cover->radius() * pieces) / width;
    }
    estimate.length = per_width / samples * (hi - lo);
    estimate.unsatisfied = lines > 0 ? unsatisfied / lines : 0;
    return estimate;
}

bool is_better(const PlannedTravel& other, const PlannedTravel& than) {
    const auto price = [](const PlannedTravel& t) { return t.length * (much_left + t.left); };
    return price(other) < clearly_less * price(than);
}

double travel_length(const std::vector<Pass>& passes, double radius) {
    double length = travel_of_piece * radius * double(passes.size());
    for (const Pass& pass : passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            length += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
    return length;
}

} // namespace facetmill
