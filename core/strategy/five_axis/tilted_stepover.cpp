#include "core/strategy/five_axis/tilted_stepover.h"

#include "core/base/tolerances.h"
#include "core/strategy/five_axis/strip_width.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

/// A step is the largest one to within this share of itself.
constexpr double step_accuracy = 0.01;

} // namespace

TiltedStepOver::TiltedStepOver(const FiveAxisField& field, double leave)
    : field_(field), passes_(field, leave), look_(StripWidth::planes_apart(field)) {}

bool TiltedStepOver::surface_between(double v0, double v1, std::size_t bin) const {
    const auto& lines = field_.lines();
    const double u0 = bins().begin(bin);
    const auto covers = [&](long k) {
        return lines.v(k) > v0 && lines.v(k) < v1 && lines.slice(k)->covers(u0, u0 + bins().width());
    };
    for (long k = lines.beyond(v0, v1) / look_ * look_; lines.v(k) < v1; k += look_)
        if (covers(k)) return true;
    // Beside the two passes it is there most likely.
    return covers(lines.beyond(v0, v0) + 1) || covers(lines.beyond(v1, v0) - 1);
}

bool TiltedStepOver::fits(const EstimatedPass* a, const EstimatedPass* b, std::size_t i) const {
    const double v0 = a ? a->v : field_.lines().lo(), v1 = b ? b->v : field_.lines().hi();
    const double wa = a ? a->width_hi[i] : 0, wb = b ? b->width_lo[i] : 0;
    // Where the surface ends it may begin again before the other pass, or beyond the last one.
    const double from = v0 + (std::isfinite(wa) ? wa : a->end_hi[i]),
                 to = v1 - (std::isfinite(wb) ? wb : b->end_lo[i]);
    if (from >= to) return true;
    const bool asked = (a && a->comes[i]) || (b && b->comes[i]),
               ends = (a && !a->comes[i]) || (b && !b->comes[i]);
    if (std::isfinite(wa) && std::isfinite(wb) && asked && !ends) return false;
    // Where the border slants one of the two may end before: what lies between has to be part at all.
    return !surface_between(from, to, i);
}

bool TiltedStepOver::fits(const EstimatedPass* a, const EstimatedPass* b, const BinRange& within) const {
    for (std::size_t i = within.first; i <= within.last; ++i)
        if (!fits(a, b, i)) return false;
    return true;
}

double TiltedStepOver::missing(const EstimatedPass& last, double v, int travel,
                               const EstimatedContact& contact, const BinRange& within) const {
    if (!contact.usable || contact.left || !std::isfinite(contact.width_lo)) return -infinity;
    const auto [from, to] = passes_.cleared(contact.place.u, travel);
    // Other contacts can only make the strip narrower there (fits).
    double gap = -infinity;
    for (std::size_t i = std::max(bins().at(from), within.first); i <= std::min(bins().at(to), within.last);
         ++i)
        if (last.comes[i] && std::isfinite(last.width_hi[i]))
            gap = std::max(gap,
                           v - std::max(contact.width_lo, passes_.min_width()) - (last.v + last.width_hi[i]));
    return gap;
}

TiltedStepOver::Step TiltedStepOver::next(const EstimatedPass* last, int travel, double usual,
                                          const EstimatedPass* limit, const BinRange& within,
                                          const Progress& progress) const {
    const auto& lines = field_.lines();
    const long from = last ? last->plane : 0;
    const long end = limit ? limit->plane : lines.beyond(lines.hi(), lines.lo());
    const auto steps = [&](double gap) { return std::max(1L, std::lround(gap / lines.spacing())); };
    const double smallest = passes_.smallest_step(), largest = passes_.largest_step();
    const long least = steps(last ? smallest : 0.5 * smallest);
    const long most = std::max(least, std::min(steps(last ? largest : 0.5 * largest), end - 1 - from));
    double hard_u = last ? last->hardest_u : std::numeric_limits<double>::quiet_NaN();
    // Where one step asked for too much, a smaller one most likely does.
    std::vector<double> asked(bins().count(), -infinity);
    if (!std::isnan(hard_u)) asked[bins().at(hard_u)] = infinity;
    double hardest = 0;
    const auto tried = [&](long step, bool refusable) {
        progress.check();
        const double gap = double(step) * lines.spacing(), v = lines.v(from + step);
        PassEstimator::Refusal refusal;
        hardest = 0;
        if (refusable && last) {
            refusal.likely = asked;
            refusal.contacts = [&, v](const EstimatedPass&, std::span<const EstimatedContact> contacts) {
                for (const EstimatedContact& c : contacts) {
                    const double more = missing(*last, v, travel, c, within);
                    asked[bins().at(c.place.u)] = more;
                    if (!(more > hardest)) continue;
                    hardest = more;
                    hard_u = c.place.u;
                }
                return hardest > 0;
            };
        }
        return passes_.estimate(from + step, travel, last ? gap : 2 * gap, within, refusal,
                                progress.part(0, 0));
    };
    long good = 0, bad = most + 1;
    EstimatedPass best;
    long step = std::clamp(steps(usual), least, most);
    while (true) {
        std::optional<EstimatedPass> p = tried(step, true);
        if (p && fits(last, &*p, within)) {
            good = step;
            best = std::move(*p);
            if (bad - good <= 1) break;
            // Not known to fail anywhere near: reach out.
            step = bad > most ? std::min(most, std::max(good + 1, good + good / 6)) : (good + bad) / 2;
        } else {
            bad = step;
            if (bad <= least) break;
            step = good > 0 ? (good + bad) / 2 : std::max(least, bad - std::max(1L, bad / 6));
        }
        if (good > 0 && double(bad - good) <= step_accuracy * double(good)) break;
    }
    if (good == 0) best = *tried(least, false);
    best.hardest_u = hard_u;
    return {std::move(best), good > 0};
}

double TiltedStepOver::border(const EstimatedPass& a, const EstimatedPass& b, std::size_t i) const {
    const double gap = b.v - a.v;
    const double wa = a.width_hi[i], wb = b.width_lo[i];
    double at = 0.5 * gap;
    // Where one of them does not come, the other answers for what it can: the rest is no part (fits).
    if (a.comes[i] != b.comes[i] && std::isfinite(wa) && std::isfinite(wb))
        at = a.comes[i] ? std::min(wa, gap) : std::max(gap - wb, 0.0);
    else if (std::isfinite(wa) && std::isfinite(wb))
        at = wa + wb > 0 ? gap * wa / (wa + wb) : at;
    else if (std::isfinite(wa))
        at = std::min(at, wa);
    else if (std::isfinite(wb))
        at = std::max(at, gap - wb);
    const double spacing = field_.lines().spacing();
    return a.v + std::floor(at / spacing + tolerance::level_angle) * spacing;
}

std::vector<double> TiltedStepOver::borders(const EstimatedPass& a, const EstimatedPass& b) const {
    std::vector<double> borders(bins().count());
    for (std::size_t i = 0; i < borders.size(); ++i)
        borders[i] = border(a, b, i);
    return borders;
}

} // namespace facetmill
