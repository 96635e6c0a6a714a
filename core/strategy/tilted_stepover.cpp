#include "core/strategy/tilted_stepover.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Shares of the cutter's radius.
constexpr double bin_share = 0.25, spread_share = 0.5, beyond_share = 2, look_share = 1.0 / 16,
                 least_width_share = 1.0 / 40;
constexpr double most_width_share = 0.97;
/// Of the tolerance: an estimated posture may be lifted by this.
constexpr double lifted_share = 0.1;
/// Of a width: left unused, because postures are estimates.
constexpr double safety = 0.95;
/// Of a step: to this it is the largest.
constexpr double step_accuracy = 0.01;
constexpr std::size_t contacts_per_block = 16;

} // namespace

TiltedStepOver::TiltedStepOver(const FiveAxisField& field) : field_(field) {
    const double r = field.radius();
    u_lo_ = infinity;
    double u_hi = -infinity;
    for (const double x : {field.context().part_box.lo.x(), field.context().part_box.hi.x()})
        for (const double y : {field.context().part_box.lo.y(), field.context().part_box.hi.y()}) {
            const double u = field.drive().u(Vec3(x, y, 0));
            u_lo_ = std::min(u_lo_, u);
            u_hi = std::max(u_hi, u);
        }
    bin_ = bin_share * r;
    bins_ = std::size_t((u_hi - u_lo_) / bin_) + 1;
    smallest_ = 2 * least_width_share * r;
    largest_ = 2 * most_width_share * r;
    look_ = std::max(1L, std::lround(look_share * r / field.lines().spacing()));
}

double TiltedStepOver::spread() const {
    return spread_share * field_.radius();
}

std::size_t TiltedStepOver::bin(double u) const {
    return std::size_t(std::clamp((u - u_lo_) / bin_, 0.0, double(bins_ - 1)));
}

void TiltedStepOver::estimate(EstimatedPass::Contact& contact, double& lambda, ToolLift::Hint& hint) const {
    const auto& limits = field_.settings().lead_limits;
    const double step = std::min(field_.settings().grid_degrees, radians(3));
    const auto lift = [&](double at) { return field_.builder().bottom(contact.place.frame, at, 0, hint); };
    const double enough = lifted_share * field_.cusp();
    // From the neighbour's inclination: down as far as it serves, else up until it does.
    double at = std::clamp(lambda, limits[0], limits[1]), delta = lift(at);
    double best = at, best_delta = delta;
    if (delta <= enough) {
        while (at > limits[0]) {
            const double lower = std::max(at - step, limits[0]), d = lift(lower);
            if (!(d <= enough)) break;
            best = at = lower;
            best_delta = d;
        }
    } else {
        while (at < limits[1] && !(best_delta <= enough)) {
            at = std::min(at + step, limits[1]);
            delta = lift(at);
            if (delta < best_delta) {
                best = at;
                best_delta = delta;
            }
        }
        if (!(best_delta <= enough))
            for (at = std::clamp(lambda, limits[0], limits[1]); at > limits[0];) {
                at = std::max(at - step, limits[0]);
                delta = lift(at);
                if (delta < best_delta) {
                    best = at;
                    best_delta = delta;
                }
            }
    }
    contact.lambda = lambda = best;
    contact.delta = best_delta;
    contact.usable = best_delta <= field_.cusp();
}

double TiltedStepOver::width(const EstimatedPass::Contact& contact, int side, double& end) const {
    const auto& lines = field_.lines();
    const double r = field_.radius();
    const long own = lines.beyond(contact.place.v, contact.place.v);
    // Looks at planes that are multiples of look_, so that passes share their slices.
    long plane = own + side;
    while (plane % look_ != 0)
        plane += side;
    double last_v = contact.place.v, last_margin = infinity;
    RaisedCurve curve;
    long inside = own;
    for (;; inside = plane, plane += side * look_) {
        double v = lines.v(plane);
        const double away = std::abs(v - contact.place.v);
        if (away > most_width_share * r + look_share * r) return most_width_share * r;
        const bool ends = !field_.raised_line(contact.place, plane, curve);
        if (ends) {
            // Up to the very last plane that the surface has.
            for (long outside = plane; std::abs(outside - inside) > 1;) {
                const long middle = inside + (outside - inside) / 2;
                (field_.raised_line(contact.place, middle, curve) ? inside : outside) = middle;
            }
            v = lines.v(inside);
            end = std::abs(v - contact.place.v);
            if (!field_.raised_line(contact.place, inside, curve)) return infinity;
        }
        const double margin =
            field_.builder().top(contact.place.frame, contact.lambda, 0, {&curve, 1}) - contact.delta;
        if (!(margin >= 0)) {
            // The margin falls ever faster: the straight line between two looks is on the safe side.
            double share = 0;
            if (std::isfinite(last_margin) && std::isfinite(margin))
                share = last_margin / (last_margin - margin);
            return safety * std::abs(last_v + share * (v - last_v) - contact.place.v);
        }
        if (ends) return infinity;
        last_v = v;
        last_margin = margin;
    }
}

EstimatedPass TiltedStepOver::estimate(long plane, int travel, const Progress& progress) const {
    EstimatedPass pass;
    pass.plane = plane;
    pass.v = field_.lines().v(plane);
    pass.travel = travel;
    pass.lines = field_.lines().lines(pass.v);
    for (const SurfaceLine& line : pass.lines) {
        auto& contacts = pass.contacts.emplace_back();
        for (const double s : field_.samples(line))
            contacts.push_back({field_.place(line, s, pass.v, travel), 0, 0, false, 0, 0});
        // Blocks have their own hints: the same bits for every thread count.
        parallel_blocks(contacts.size(), contacts_per_block, progress,
                        [&](std::size_t begin, std::size_t end) {
                            double lambda = field_.settings().lead_limits[0];
                            ToolLift::Hint hint;
                            for (std::size_t i = begin; i < end; ++i) {
                                progress.check();
                                auto& c = contacts[i];
                                estimate(c, lambda, hint);
                                if (!c.usable) continue;
                                // Strips end in planes of the lattice.
                                const double spacing = field_.lines().spacing();
                                const auto whole = [&](double w) {
                                    return std::floor(w / spacing + tolerance::level_angle) * spacing;
                                };
                                c.width_lo = whole(width(c, -1, c.end_lo));
                                c.width_hi = whole(width(c, +1, c.end_hi));
                            }
                        });
    }
    pass.width_lo.assign(bins_, 0);
    pass.width_hi.assign(bins_, 0);
    pass.end_lo.assign(bins_, 0);
    pass.end_hi.assign(bins_, 0);
    pass.comes.assign(bins_, false);
    const double least = least_width_share * field_.radius();
    for (const auto& contacts : pass.contacts)
        for (const auto& c : contacts) {
            // Beyond its ends a pass goes on as far as its strip does.
            const double back = &c == &contacts.front() ? beyond_share : spread_share;
            const double ahead = &c == &contacts.back() ? beyond_share : spread_share;
            const std::size_t last = bin(c.place.u + ahead * field_.radius());
            for (std::size_t b = bin(c.place.u - back * field_.radius()); b <= last; ++b) {
                if (!pass.comes[b]) pass.width_lo[b] = pass.width_hi[b] = infinity;
                pass.comes[b] = true;
                // What no posture serves is no fault of the step: it is left to clean-up, as far as a pass
                // can answer for.
                const double most = most_width_share * field_.radius();
                pass.end_lo[b] = std::max(pass.end_lo[b], c.usable ? c.end_lo : most);
                pass.end_hi[b] = std::max(pass.end_hi[b], c.usable ? c.end_hi : most);
                if (!c.usable) continue;
                pass.width_lo[b] = std::min(pass.width_lo[b], std::max(c.width_lo, least));
                pass.width_hi[b] = std::min(pass.width_hi[b], std::max(c.width_hi, least));
            }
        }
    return pass;
}

bool TiltedStepOver::surface_between(double v0, double v1, std::size_t bin) const {
    const auto& lines = field_.lines();
    const double u0 = u_lo_ + double(bin) * bin_;
    for (long k = lines.beyond(v0, v1) / look_ * look_; lines.v(k) < v1; k += look_)
        if (lines.v(k) > v0 && lines.slice(k)->covers(u0, u0 + bin_)) return true;
    return false;
}

bool TiltedStepOver::fits(const EstimatedPass* a, const EstimatedPass* b) const {
    const double v0 = a ? a->v : field_.lines().lo(), v1 = b ? b->v : field_.lines().hi();
    for (std::size_t i = 0; i < bins_; ++i) {
        const double wa = a ? a->width_hi[i] : 0, wb = b ? b->width_lo[i] : 0;
        // Where the surface ends it may begin again before the other pass, or beyond the last one.
        const double from = v0 + (std::isfinite(wa) ? wa : a->end_hi[i]),
                     to = v1 - (std::isfinite(wb) ? wb : b->end_lo[i]);
        if (from >= to) continue;
        if (std::isfinite(wa) && std::isfinite(wb) && ((a && a->comes[i]) || (b && b->comes[i])))
            return false;
        if (surface_between(from, to, i)) return false;
    }
    return true;
}

TiltedStepOver::Step TiltedStepOver::next(const EstimatedPass* last, int travel, double usual,
                                          const Progress& progress) const {
    const auto& lines = field_.lines();
    const long from = last ? last->plane : 0;
    const long end = lines.beyond(lines.hi(), lines.lo());
    const auto steps = [&](double gap) { return std::max(1L, std::lround(gap / lines.spacing())); };
    const long least = steps(last ? smallest_ : 0.5 * smallest_);
    const long most = std::max(least, std::min(steps(last ? largest_ : 0.5 * largest_), end - 1 - from));
    const auto tried = [&](long step) {
        progress.check();
        return estimate(from + step, travel, progress.part(0, 0));
    };
    long good = 0, bad = most + 1;
    EstimatedPass best;
    long step = std::clamp(steps(usual), least, most);
    while (true) {
        EstimatedPass p = tried(step);
        if (fits(last, &p)) {
            good = step;
            best = std::move(p);
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
    if (good > 0) return {std::move(best), true};
    return {tried(least), false};
}

bool TiltedStepOver::reaches_border(const EstimatedPass& last) const {
    return fits(&last, nullptr);
}

std::vector<double> TiltedStepOver::borders(const EstimatedPass& a, const EstimatedPass& b) const {
    const double gap = b.v - a.v;
    std::vector<double> borders(bins_);
    for (std::size_t i = 0; i < bins_; ++i) {
        const double wa = a.width_hi[i], wb = b.width_lo[i];
        double at = 0.5 * gap;
        if (std::isfinite(wa) && std::isfinite(wb))
            at = gap * wa / (wa + wb);
        else if (std::isfinite(wa))
            at = std::min(at, wa);
        else if (std::isfinite(wb))
            at = std::max(at, gap - wb);
        const double spacing = field_.lines().spacing();
        borders[i] = a.v + std::floor(at / spacing + tolerance::level_angle) * spacing;
    }
    return borders;
}

} // namespace facetmill
