#include "core/strategy/five_axis/partial_passes.h"

#include "core/base/tolerances.h"
#include "core/strategy/five_axis/strip_width.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// Steps between full passes are tried in this ratio, until so many in a row are no better.
constexpr double step_ratio = 1.15;
constexpr int tries_beyond = 4;
/// What a partial pass costs besides its length, in radii of the cutter.
constexpr double partial_cost = 2;
/// Where partial passes would be longer than this share of a full one, a full one is closer by.
constexpr double max_partial = 0.6;
/// Partial passes have partial passes between them, so deep at most.
constexpr int deepest_partial = 3;
/// Beside contacts without a posture passes are no closer than this, in radii of the cutter.
constexpr double min_unfree_gap = 0.2;

} // namespace

PassGap PartialPasses::next(const EstimatedPass& last, double usual, const Progress& progress) {
    PassGap gap;
    Step whole = whole_step(last, nullptr, bins_.all(), usual, progress);
    unfree_gap_ =
        min_gain_ > 0 ? std::max(whole.pass.v - last.v, min_unfree_gap * field_.radius()) : infinity;
    if (min_gain_ > 0 && whole.satisfied && !may_gain(last, whole.pass)) {
        gap.next = std::move(whole.pass);
    } else {
        const double most = whole.satisfied && min_gain_ > 0
                                ? (1 - min_gain_) * travel_per_width(last, whole.pass, bins_.all())
                                : infinity;
        gap.next = cheapest(last, nullptr, bins_.all(), whole, usual, progress);
        if (gap.next && !(travel_per_width(last, *gap.next, bins_.all()) < most))
            gap.next = std::move(whole.pass);
    }
    fill(last, gap.next ? &*gap.next : nullptr, bins_.all(), 0, gap, progress);
    std::stable_sort(gap.partial.begin(), gap.partial.end(),
                     [](const PartialPass& a, const PartialPass& b) { return a.pass.plane < b.pass.plane; });
    find_borders(last, gap);
    return gap;
}

TiltedStepOver::Step PartialPasses::whole_step(const EstimatedPass& last, const EstimatedPass* limit,
                                               const BinRange& within, double usual,
                                               const Progress& progress) const {
    return stepover_.next(&last, turns_ ? -last.travel : last.travel, usual, limit, within, progress);
}

bool PartialPasses::fits(const EstimatedPass& a, const EstimatedPass* b, std::size_t i) const {
    const double gap = (b ? b->v : field_.lines().hi()) - a.v;
    if (gap > unfree_gap_ + tolerance::level_angle && (a.unfree[i] || (b && b->unfree[i]))) return false;
    return stepover_.fits(&a, b, i);
}

bool PartialPasses::fits(const EstimatedPass& a, const EstimatedPass* b, const BinRange& within) const {
    for (std::size_t i = within.first; i <= within.last; ++i)
        if (!fits(a, b, i)) return false;
    return true;
}

void PartialPasses::find_borders(const EstimatedPass& last, PassGap& gap) const {
    const double part_hi = field_.lines().hi();
    gap.border_lo.assign(bins_.count(), part_hi);
    gap.border_hi.assign(bins_.count(), part_hi);
    for (PartialPass& p : gap.partial) {
        p.border_lo.assign(bins_.count(), p.pass.v);
        p.border_hi.assign(bins_.count(), p.pass.v);
    }
    for (std::size_t i = 0; i < bins_.count(); ++i) {
        const EstimatedPass* from = &last;
        double* strip_end = &gap.border_lo[i];
        for (PartialPass& p : gap.partial) {
            if (i < p.bins.first || i > p.bins.last) continue;
            *strip_end = p.border_lo[i] = stepover_.border(*from, p.pass, i);
            from = &p.pass;
            strip_end = &p.border_hi[i];
        }
        *strip_end = gap.border_hi[i] = gap.next ? stepover_.border(*from, *gap.next, i) : part_hi;
    }
}

std::vector<BinRange> PartialPasses::narrow_ranges(const EstimatedPass& a, const EstimatedPass* b,
                                                   const BinRange& within) const {
    const double r = field_.radius(), gap = (b ? b->v : field_.lines().hi()) - a.v;
    // A pose clears what lies beside and behind it.
    const double aside = std::min(0.5 * gap, StripWidth::max_width(field_));
    const double beyond = stepover_.passes().behind() + r - std::sqrt(r * r - aside * aside);
    std::vector<BinRange> ranges;
    for (std::size_t i = within.first; i <= within.last; ++i) {
        if (fits(a, b, i)) continue;
        // Two that would run into each other, or whose ends cost as much as the travel between them, are one.
        if (!ranges.empty()
            && double(i - ranges.back().last) * bins_.width() <= 2 * beyond + partial_cost * r)
            ranges.back().last = i;
        else
            ranges.push_back({i, i, beyond});
    }
    return ranges;
}

bool PartialPasses::may_gain(const EstimatedPass& last, const EstimatedPass& whole) const {
    // In each bin by itself the passes were as far apart as its own strips allow.
    const double step = whole.v - last.v;
    double least = 0, travelled = 0;
    for (std::size_t i = 0; i < bins_.count(); ++i) {
        if (!last.comes[i] && !whole.comes[i]) continue;
        const double allowed =
            last.unfree[i] || whole.unfree[i] ? step : last.width_hi[i] + whole.width_lo[i];
        least += step / std::clamp(allowed, step, std::max(step, largest_));
        travelled += 1;
    }
    return least < (1 - min_gain_) * travelled;
}

double PartialPasses::partial_count(const EstimatedPass& a, const EstimatedPass* b, std::size_t i) const {
    const double gap = (b ? b->v : field_.lines().hi()) - a.v;
    double width = 0;
    if (a.comes[i] && std::isfinite(a.width_hi[i])) width += a.width_hi[i];
    if (b && b->comes[i] && std::isfinite(b->width_lo[i])) width += b->width_lo[i];
    if (a.unfree[i] || (b && b->unfree[i])) width = std::max(width, std::min(unfree_gap_, gap));
    return passes_in(gap, width);
}

std::array<double, 2> PartialPasses::min_partial(const EstimatedPass& last, const Found& found,
                                                 const BinRange& within, std::vector<double>& likely) const {
    const double gap = found.v - last.v;
    double travel = 0, length = 0, most = 0, beyond = 0;
    for (std::size_t i = within.first; i <= within.last; ++i) {
        if (!last.comes[i] || !std::isfinite(last.width_hi[i])) continue;
        // Contacts that are not known can only make strips narrower, or have no posture.
        const double width = last.width_hi[i] + found.width_lo[i];
        if (!(width < gap - 0.5 * field_.lines().spacing())) continue;
        const double passes = passes_in(gap, std::max(width, std::min(unfree_gap_, gap)));
        travel += passes * bins_.width();
        length += bins_.width();
        most = std::max({most, passes, 1.0});
        beyond = stepover_.passes().behind();
        likely[i] = gap - width;
    }
    travel += most * (2 * beyond + (most > 0 ? partial_cost * field_.radius() : 0));
    return {travel, (length + 2 * beyond) / (double(within.last + 1 - within.first) * bins_.width())};
}

double PartialPasses::travel_per_width(const EstimatedPass& last, const EstimatedPass& next,
                                       const BinRange& within) const {
    return (own_travel(next) + partial_travel(last, &next, within)) / (next.v - last.v);
}

double PartialPasses::own_travel(const EstimatedPass& pass) const {
    double travelled = 0;
    for (const SurfaceLine& line : pass.lines)
        travelled += std::abs(line.points.back().u - line.points.front().u) + partial_cost * field_.radius();
    return travelled;
}

double PartialPasses::partial_travel(const EstimatedPass& a, const EstimatedPass* b,
                                     const BinRange& within) const {
    double travel = 0;
    for (const BinRange& range : narrow_ranges(a, b, within)) {
        double most = 1;
        for (std::size_t i = range.first; i <= range.last; ++i) {
            const double passes = partial_count(a, b, i);
            travel += passes * bins_.width();
            most = std::max(most, passes);
        }
        travel += most * (2 * range.beyond + partial_cost * field_.radius());
    }
    return travel;
}

double PartialPasses::partial_share(const EstimatedPass& a, const EstimatedPass& b,
                                    const BinRange& within) const {
    double partial = 0, whole = 0;
    for (const BinRange& range : narrow_ranges(a, &b, within))
        partial += double(range.last + 1 - range.first) * bins_.width() + 2 * range.beyond;
    for (std::size_t i = within.first; i <= within.last; ++i)
        if (a.comes[i] || b.comes[i]) whole += bins_.width();
    return whole > 0 ? partial / whole : 0;
}

std::optional<EstimatedPass> PartialPasses::cheapest(const EstimatedPass& last, const EstimatedPass* limit,
                                                     const BinRange& within, Step whole, double usual,
                                                     const Progress& progress) const {
    const auto& lines = field_.lines();
    const long end = limit ? limit->plane : lines.beyond(lines.hi(), lines.lo());
    const int travel = turns_ ? -last.travel : last.travel;
    const double rest = lines.v(end) - last.v;
    std::optional<EstimatedPass> best;
    double least = infinity;
    const auto better = [&](EstimatedPass&& p) {
        const double travelled = travel_per_width(last, p, within);
        if (!(travelled < least)) return false;
        // Where most of the travel asks for passes between, the last of them would come close to its
        // neighbour.
        if (whole.satisfied && partial_share(last, p, within) > max_partial) return false;
        least = travelled;
        best = std::move(p);
        return true;
    };
    // The pass that asks for none will be among them.
    const bool whole_serves = whole.satisfied && !(partial_share(last, whole.pass, within) > max_partial);
    const double whole_travel = whole_serves ? travel_per_width(last, whole.pass, within) : infinity;
    const long whole_plane = whole.pass.plane;
    const double whole_gap = whole.pass.v - last.v;
    std::vector<double> likely(bins_.count(), 0);
    const auto tried = [&](double step) {
        const long plane = std::min(last.plane + std::max(1L, std::lround(step / lines.spacing())), end - 1);
        if (whole_serves && plane == whole_plane
            && std::abs(step - whole_gap) <= tolerance::level_angle * step)
            return false; // the same pass
        Found found{lines.v(plane), 0, std::vector<double>(bins_.count(), infinity)};
        const double refused =
            std::min(least, whole_travel) * (found.v - last.v) * (1 + tolerance::level_angle);
        PassEstimator::Refusal refusal;
        // Its own travel alone may be too much.
        refusal.lines = [&](const EstimatedPass& p) {
            found.own_travel = own_travel(p);
            return !(found.own_travel < refused);
        };
        refusal.likely = likely;
        refusal.contacts = [&](const EstimatedPass& p, std::span<const EstimatedContact> contacts) {
            for (const EstimatedContact& c : contacts) {
                if (!c.usable || c.left) continue;
                const double width = std::max(c.width_lo, stepover_.passes().min_width());
                const auto [from, to] = stepover_.passes().cleared(c.place.u, p.travel);
                for (std::size_t b = bins_.at(from); b <= bins_.at(to); ++b)
                    found.width_lo[b] = std::min(found.width_lo[b], width);
            }
            const auto [partial, share] = min_partial(last, found, within, likely);
            return !(found.own_travel + partial < refused) || (whole.satisfied && share > max_partial);
        };
        auto p = stepover_.passes().estimate(plane, travel, step, within, refusal, progress.part(0, 0));
        return p && better(std::move(*p));
    };
    const double most = std::max(std::min(largest_, rest), smallest_);
    const double start = std::clamp(usual, smallest_, most);
    tried(start);
    if (whole.satisfied) better(std::move(whole.pass));
    // What is travelled per width falls and rises several times as steps grow.
    int worse = 0;
    for (double step = start * step_ratio; step < most * step_ratio && worse < tries_beyond;
         step *= step_ratio)
        worse = tried(std::min(step, most)) ? 0 : worse + 1;
    worse = 0;
    for (double step = start / step_ratio; step > smallest_ && worse < tries_beyond; step /= step_ratio)
        worse = tried(step) ? 0 : worse + 1;
    // At the end partial passes alone may be less.
    if (rest <= largest_ && partial_travel(last, limit, within) < least * (best->v - last.v)) best.reset();
    return best;
}

void PartialPasses::fill(const EstimatedPass& a, const EstimatedPass* b, const BinRange& within, int depth,
                         PassGap& gap, const Progress& progress) const {
    const auto& lines = field_.lines();
    for (const BinRange& range : narrow_ranges(a, b, within)) {
        const EstimatedPass* last = &a;
        const long end = b ? b->plane : lines.beyond(lines.hi(), lines.lo());
        double usual = 0.5 * (lines.v(end) - a.v);
        while (!fits(*last, b, range)) {
            if (end - last->plane <= 1) {
                gap.satisfied = false;
                break;
            }
            std::optional<EstimatedPass> next;
            if (depth < deepest_partial) {
                next =
                    cheapest(*last, b, range, whole_step(*last, b, range, usual, progress), usual, progress);
                // Narrow in a part of the range only.
                if (!next) {
                    fill(*last, b, range, depth + 1, gap, progress);
                    break;
                }
            } else {
                Step step = whole_step(*last, b, range, usual, progress);
                if (step.satisfied && !fits(*last, &step.pass, range)) {
                    const long planes = std::max(1L, long(unfree_gap_ / lines.spacing()));
                    step.pass = stepover_.passes().estimate(last->plane + planes, step.pass.travel,
                                                            unfree_gap_, range, progress.part(0, 0));
                }
                if (!step.satisfied && b && b->v - last->v <= smallest_) {
                    gap.satisfied = false;
                    break;
                }
                next = std::move(step.pass);
            }
            usual = next->v - last->v;
            const EstimatedPass* before = last;
            gap.partial.push_back({std::move(*next), range, {}, {}});
            last = &gap.partial.back().pass;
            if (depth < deepest_partial) fill(*before, last, range, depth + 1, gap, progress);
        }
    }
}

} // namespace facetmill
