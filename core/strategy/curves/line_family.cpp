#include "core/strategy/curves/line_family.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace facetmill {

namespace {

/// Pieces of lines go so far beyond the range that asks for them, in radii of the cutter; those with a gap of
/// as much as the second between them are one.
constexpr double beyond_radii = 0.25, joined_radii = 1.5;
/// Three parts are tried where two leave too much over more than this share of the length, and taken where
/// they do not.
constexpr double much_left = 0.1;
/// Lines of a family, at most: more come from a part in another unit.
constexpr std::size_t max_lines = 100'000;
/// What was overlooked is looked for so often, at most.
constexpr int max_looks = 6;
/// A line is divided in pieces until they are as straight as the chord tolerance asks, at most so often.
constexpr int max_halvings = 14, first_pieces = 16;

double length_of(std::span<const Interval> ranges) {
    double sum = 0;
    for (const Interval& r : ranges)
        sum += r.length();
    return sum;
}

void add_all(std::vector<Pass>& to, const FamilyLine& from) {
    to.insert(to.end(), from.passes.begin(), from.passes.end());
}

} // namespace

PlanLine FamilyPlanner::places(double w, const Interval& range) const {
    PlanLine line{family_.at(range.lo, w)};
    const auto add = [&](const auto& self, double t0, double t1, const Vec2& a, const Vec2& b,
                         int depth) -> void {
        const double middle = 0.5 * (t0 + t1);
        const Vec2 m = family_.at(middle, w), d = b - a;
        const double square = d.squaredNorm();
        const double along = square > 0 ? std::clamp((m - a).dot(d) / square, 0.0, 1.0) : 0;
        if (depth == 0 || (m - a - along * d).norm() <= job_.chord) {
            if (b != line.back()) line.push_back(b);
            return;
        }
        self(self, t0, middle, a, m, depth - 1);
        self(self, middle, t1, m, b, depth - 1);
    };
    for (int k = 0; k < first_pieces; ++k) {
        const double t0 = range.lo + range.length() * k / first_pieces,
                     t1 = k + 1 == first_pieces ? range.hi
                                                : range.lo + range.length() * (k + 1) / first_pieces;
        add(add, t0, t1, line.back(), family_.at(t1, w), max_halvings);
    }
    return line;
}

FamilyLine FamilyPlanner::line(double w, std::span<const Interval> ranges, const Progress& progress) const {
    FamilyLine made{w, false, {}};
    for (const Interval& range : ranges) {
        const PlanLine on = places(w, range);
        if (on.size() < 2) continue;
        for (Pass& p : job_.passes(on, beside_, progress))
            made.passes.push_back(std::move(p));
    }
    return made;
}

FamilyLine FamilyPlanner::whole_line(double w, const Progress& progress) const {
    const Interval all{0, 1};
    FamilyLine made = line(w, {&all, 1}, progress);
    made.whole = true;
    return made;
}

double FamilyPlanner::t_of(double length, double w) const {
    constexpr int pieces = 8;
    double sum = 0;
    for (int k = 0; k < pieces; ++k)
        sum += (family_.at(double(k + 1) / pieces, w) - family_.at(double(k) / pieces, w)).norm();
    return sum > 0 ? length / sum : 1;
}

double FamilyPlanner::width(double w0, double w1, std::span<const Interval> ranges) const {
    constexpr int looks = 8;
    double widest = 0;
    for (const Interval& r : ranges)
        for (int k = 0; k <= looks; ++k) {
            const double t = r.lo + r.length() * k / looks;
            widest = std::max(widest, (family_.at(t, w1) - family_.at(t, w0)).norm());
        }
    return widest;
}

std::vector<Interval> FamilyPlanner::left_between(const FamilyLine& a, const FamilyLine& b,
                                                  std::span<const Interval> ranges,
                                                  const Progress& progress) const {
    std::vector<Pass> both = a.passes;
    add_all(both, b);
    const LevelSweep swept(both, job_.profile, progress);
    const double look = std::min(t_of(judge_.spacing(), a.w), t_of(judge_.spacing(), b.w));
    std::vector<AcrossGap> gap;
    std::vector<Interval> stands; // what every place stands for
    for (const Interval& r : ranges) {
        const double n = std::max(1.0, std::ceil(r.length() / look)), step = r.length() / n;
        for (double k = 0; k <= n; ++k) {
            const double t = r.lo + k * step;
            gap.push_back({family_.at(t, a.w), family_.at(t, b.w)});
            stands.push_back({std::max(r.lo, t - step), std::min(r.hi, t + step)});
        }
    }
    const std::vector<char> high = judge_.high(gap, swept, progress);
    std::vector<Interval> left;
    for (std::size_t i = 0; i < high.size(); ++i)
        if (high[i] != 0) left.push_back(stands[i]);
    return joined(std::move(left), t_of(joined_radii * job_.radius(), a.w));
}

FamilyPlanner::Divided FamilyPlanner::divided(const FamilyLine& a, const FamilyLine& b,
                                              const std::vector<Interval>& left, int parts,
                                              const Progress& progress) const {
    Divided d;
    const double beyond = t_of(beyond_radii * job_.radius(), 0.5 * (a.w + b.w));
    std::vector<Interval> wide;
    for (const Interval& r : left)
        wide.push_back({std::max(0.0, r.lo - beyond), std::min(1.0, r.hi + beyond)});
    wide = joined(std::move(wide), t_of(joined_radii * job_.radius(), 0.5 * (a.w + b.w)));
    for (int k = 1; k < parts; ++k)
        d.lines.push_back(line(a.w + (b.w - a.w) * k / parts, wide, progress));
    for (std::size_t k = 0; k <= d.lines.size(); ++k) {
        d.left.push_back(
            left_between(k == 0 ? a : d.lines[k - 1], k < d.lines.size() ? d.lines[k] : b, left, progress));
        d.share += length_of(d.left.back()) / (double(parts) * length_of(left));
    }
    return d;
}

void FamilyPlanner::insert(const FamilyLine& a, const FamilyLine& b, const std::vector<Interval>& left,
                           std::vector<FamilyLine>& out, const Progress& progress) {
    if (left.empty()) return;
    if (width(a.w, b.w, left) < smallest()) {
        ++unsatisfied_;
        return;
    }
    Divided d = divided(a, b, left, 2, progress);
    if (d.share > much_left)
        if (Divided three = divided(a, b, left, 3, progress); three.share <= much_left) d = std::move(three);
    const std::vector<FamilyLine> lines = std::move(d.lines);
    for (std::size_t k = 0; k < d.left.size(); ++k) {
        insert(k == 0 ? a : lines[k - 1], k < lines.size() ? lines[k] : b, d.left[k], out, progress);
        if (k < lines.size()) out.push_back(lines[k]);
    }
}

void FamilyPlanner::fill(std::vector<FamilyLine>& lines, bool around, const Progress& progress) {
    if (lines.size() < 2 && !around) return;
    const std::size_t gaps = lines.size() - (around ? 0 : 1);
    std::vector<std::vector<FamilyLine>> between(gaps);
    std::atomic<std::size_t> made = lines.size();
    parallel_for(gaps, 1, progress, [&](std::size_t i) {
        const Progress here = progress.part(0, 0);
        FamilyLine next = lines[(i + 1) % lines.size()];
        if (i + 1 == lines.size()) next.w += 1;
        const Interval all{0, 1};
        insert(lines[i], next, left_between(lines[i], next, {&all, 1}, here), between[i], here);
        if (made.fetch_add(between[i].size()) + between[i].size() > max_lines)
            throw Error(ErrorCode::limit_exceeded, "stepover",
                        "the tolerance asks for more than " + std::to_string(max_lines) + " passes",
                        "allow a larger tolerance or set a step-over");
    });
    std::vector<FamilyLine> all;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        all.push_back(std::move(lines[i]));
        if (i < gaps) std::move(between[i].begin(), between[i].end(), std::back_inserter(all));
    }
    lines = std::move(all);
}

void FamilyPlanner::fill_overlooked(std::vector<FamilyLine>& lines, bool around, const Mesh& surface,
                                    const Progress& progress) {
    if (lines.size() < 2) return;
    for (int round = 0; round < max_looks; ++round) {
        const Progress here = progress.part(double(round) / max_looks, double(round + 1) / max_looks);
        std::vector<Pass> passes;
        for (const FamilyLine& l : lines)
            add_all(passes, l);
        UncutInput input = job_.uncut_input(surface);
        input.tell_passed = true;
        const UncutReport report =
            uncut_by_levels(input, job_.context, {passes, {}}, job_.profile, job_.cusp_allowed, here);
        // Which gap they lie in: neighbours at any t are at least these, since the rest are pieces.
        std::map<std::size_t, std::vector<LineFamily::Place>> found;
        for (const Vec3& tip : report.passed_tips)
            if (const auto at = family_.where(tip.head<2>())) {
                const auto after = std::upper_bound(lines.begin(), lines.end(), at->w,
                                                    [](double w, const FamilyLine& l) { return w < l.w; });
                const std::size_t next = std::size_t(after - lines.begin());
                if (!around && (next == 0 || next == lines.size())) continue;
                found[next].push_back(*at);
            }
        if (found.empty()) break;
        std::vector<FamilyLine> more;
        for (auto& [next, places] : found) {
            std::vector<Interval> ranges;
            double w = 0;
            const double beyond = t_of(beyond_radii * job_.radius(), places.front().w);
            for (const auto& at : places) {
                ranges.push_back({std::max(0.0, at.t - beyond), std::min(1.0, at.t + beyond)});
                w += at.w / double(places.size());
            }
            more.push_back(line(w, joined(std::move(ranges), t_of(joined_radii * job_.radius(), w)), here));
        }
        std::erase_if(more, [](const FamilyLine& l) { return l.passes.empty(); });
        if (more.empty()) break;
        std::move(more.begin(), more.end(), std::back_inserter(lines));
        std::stable_sort(lines.begin(), lines.end(),
                         [](const FamilyLine& a, const FamilyLine& b) { return a.w < b.w; });
    }
    progress.set(1);
}

void take_passes(std::vector<FamilyLine> lines, StrategyResult& result) {
    for (FamilyLine& line : lines) {
        for (Pass& p : line.passes) {
            p.drive = result.drive_planes;
            result.passes.push_back(std::move(p));
        }
        ++result.drive_planes;
    }
}

StrategyResult finished(const CurveJob& job, const FamilyPlanner& planner, StrategyResult result,
                        const char* what_to_check, const Progress& progress) {
    if (result.passes.empty())
        throw Error(ErrorCode::empty_result, job.settings.name, "no pass meets the part", what_to_check);
    // Moves may run above the exact path by the chord tolerance, which the step-over has left room for.
    result.cusp_max = job.settings.stepover.is_number() ? job.chord : job.cusp_allowed;
    CurveFinish(job).run(result, {job.context.part.get(), planner.unsatisfied(), false}, progress);
    return result;
}

} // namespace facetmill
