#include "core/strategy/five_axis/tilted_stepover.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/five_axis/strip_width.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Shares of the cutter's radius.
constexpr double bin_share = 0.25, beyond_share = 1.5, look_share = 1.0 / 16, min_width_share = 1.0 / 40;
/// Of the tolerance: an estimated posture may be lifted by this.
constexpr double lifted_share = 0.1;
/// Postures with a yaw may be lifted by this: a flat end that stands on both flanks of a hollow clears a wide
/// strip.
constexpr double yawed_share = 0.5;
/// Of the radius: so far beyond its ends a pass goes on, about, and has to clear its strip there too.
constexpr double further_share = 0.3;
/// Of the gap to the pass before: a strip that is so wide to either side needs no other posture.
constexpr double wanted_share = 0.75;
const double yaw_step = radians(15);
/// Of a step: to this it is the largest.
constexpr double step_accuracy = 0.01;
/// Of the radius: where along the travel a pose reaches the borders of its strip. A flat end that leans along
/// the travel does so the farther behind its contact the wider its strip is, a ball beside it; one with a yaw
/// up to a radius behind.
constexpr double behind_share = 0.5, ahead_share = 0.5, yawed_behind_share = 1, yawed_ahead_share = 0.25;
/// Of the radius: contacts farther apart than this are looked at half-way too.
constexpr double far_apart_share = 0.25;
constexpr std::size_t contacts_per_block = 16;
/// Steps with partial passes between are tried in this ratio; what a partial pass costs besides its length,
/// in radii of the cutter.
constexpr double step_ratio = 1.15, partial_cost = 2;
constexpr int tries_beyond = 4;
/// Of a pass: where partial passes would be longer, a full one is closer by.
constexpr double max_partial = 0.6;
/// Partial passes have partial passes between them, so deep at most.
constexpr int deepest_partial = 3;

/// The part of a line between two u; without points where it has none there.
SurfaceLine part_of_line(const SurfaceLine& line, double u0, double u1, std::array<bool, 2>& cut_short) {
    SurfaceLine part;
    const auto& p = line.points;
    cut_short = {p.front().u<u0, p.back().u> u1};
    if (!cut_short[0] && !cut_short[1]) return line;
    const auto crossing = [&](std::size_t i, double u) {
        const double step = p[i].u - p[i - 1].u;
        return line.at(line.arc[i - 1]
                       + (step > 0 ? std::clamp((u - p[i - 1].u) / step, 0.0, 1.0) : 0)
                             * (line.arc[i] - line.arc[i - 1]));
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p[i].u > u1) {
            if (i > 0 && p[i - 1].u <= u1) {
                if (part.points.empty() && p[i - 1].u < u0) part.points.push_back(crossing(i, u0));
                part.points.push_back(crossing(i, u1));
            }
            break;
        }
        if (p[i].u < u0) continue;
        if (i > 0 && part.points.empty() && p[i - 1].u < u0) part.points.push_back(crossing(i, u0));
        part.points.push_back(p[i]);
    }
    part.arc.assign(part.points.empty() ? 0 : 1, 0);
    for (std::size_t i = 1; i < part.points.size(); ++i)
        part.arc.push_back(part.arc.back() + (part.points[i].point - part.points[i - 1].point).norm());
    return part;
}

} // namespace

TiltedStepOver::TiltedStepOver(const FiveAxisField& field, double leave) : field_(field), leave_(leave) {
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
    smallest_ = 2 * min_width_share * r;
    largest_ = 2 * StripWidth::most(field);
    behind_ = behind_share * r;
    ahead_ = ahead_share * r;
    if (field.settings().posture != Finish5Settings::PostureChoice::cm2) {
        behind_ = yawed_behind_share * r;
        ahead_ = yawed_ahead_share * r;
        // From yaw 0 outward.
        const auto& nodes = field.grid().yaw;
        const std::size_t step =
            nodes.size() > 1 ? std::size_t(std::ceil(yaw_step / (nodes[1] - nodes[0]) - 0.5)) : 1;
        const auto middle =
            std::size_t(std::min_element(nodes.begin(), nodes.end(),
                                         [](double a, double b) { return std::abs(a) < std::abs(b); })
                        - nodes.begin());
        for (std::size_t away = 0; away < nodes.size(); away += std::max<std::size_t>(step, 1)) {
            if (middle + away < nodes.size()) yaws_.push_back(nodes[middle + away]);
            if (away > 0 && away <= middle) yaws_.push_back(nodes[middle - away]);
        }
    }
    look_ = std::max(1L, std::lround(look_share * r / field.lines().spacing()));
}

std::array<double, 2> TiltedStepOver::cleared(double u, int travel) const {
    return travel > 0 ? std::array{u - behind_, u + ahead_} : std::array{u - ahead_, u + behind_};
}

std::size_t TiltedStepOver::bin(double u) const {
    return std::size_t(std::clamp((u - u_lo_) / bin_, 0.0, double(bins_ - 1)));
}

void TiltedStepOver::estimate(EstimatedPass::Contact& contact, double& lead, ToolLift::Hint& hint) const {
    const auto& limits = field_.settings().lead_limits;
    const double step = std::min(field_.settings().grid_step, radians(3));
    const auto lift = [&](double at) { return field_.builder().bottom(contact.place.frame, at, 0, hint); };
    const double enough = lifted_share * field_.cusp();
    // From the neighbour's inclination: down as far as it serves, else up until it does.
    double at = std::clamp(lead, limits[0], limits[1]), delta = lift(at);
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
            for (at = std::clamp(lead, limits[0], limits[1]); at > limits[0];) {
                at = std::max(at - step, limits[0]);
                delta = lift(at);
                if (delta < best_delta) {
                    best = at;
                    best_delta = delta;
                }
            }
    }
    lead = best;
    contact.posture = {best, 0, best_delta};
    contact.usable = best_delta <= field_.cusp();
}

void TiltedStepOver::find_widths(EstimatedPass::Contact& contact, double gap, ToolLift::Hint& hint) const {
    const double wanted = wanted_share * gap;
    const ContactPlace& place = contact.place;
    const CSpaceBuilder& builder = field_.builder();
    StripWidth width(field_, place, look_);
    const auto value = [&](const StripWidth::Width& lo, const StripWidth::Width& hi) {
        return std::min(lo.width, wanted) * std::min(hi.width, wanted);
    };
    StripWidth::Width lo = width(contact.posture, -1), hi = width(contact.posture, +1);
    double most = value(lo, hi);
    const double enough = wanted * wanted;
    const double hollow = std::max(field_.hollowness(place, place.frame.feed), 0.0), r = field_.radius();
    // Nodes of the grid: what is free there the choice of postures finds.
    for (const double yaw : yaws_) {
        if (most >= enough) break;
        // Leaning to a side a flat end lies over the strip's border there with its whole width, and in a
        // hollow along the travel holds it with heel or toe only: what lies between them stays.
        const double aside = std::abs(std::sin(yaw));
        const double arched = 0.5 * hollow * r * r * aside * (2 - aside);
        for (const double lead : field_.grid().lead) {
            const PostureValue posture{lead, yaw, builder.bottom(place.frame, lead, yaw, hint)};
            if (!(posture.delta <= yawed_share * field_.cusp())) continue;
            if (builder.holds(place.frame, posture) && width.clears_own_line(posture)) {
                const PostureValue arching{lead, yaw, posture.delta + arched};
                const StripWidth::Width l = width(arching, -1), h = width(arching, +1);
                if (value(l, h) > most) {
                    most = value(l, h);
                    contact.posture = posture;
                    lo = l;
                    hi = h;
                }
            }
            // Inclined further its strip is narrower.
            if (posture.delta <= lifted_share * field_.cusp() || most >= enough) break;
        }
    }
    // Strips end in planes of the lattice.
    const double spacing = field_.lines().spacing();
    const auto whole = [&](double w) { return std::floor(w / spacing + tolerance::level_angle) * spacing; };
    contact.width_lo = whole(lo.width);
    contact.width_hi = whole(hi.width);
    contact.end_lo = lo.end;
    contact.end_hi = hi.end;
}

void TiltedStepOver::answer_beyond_ends(EstimatedPass& pass, double gap) const {
    const double further = further_share * field_.radius();
    ToolLift::Hint hint;
    for (std::size_t l = 0; l < pass.lines.size(); ++l)
        for (const bool first : {true, false}) {
            auto& contacts = pass.contacts[l];
            EstimatedPass::Contact& end = first ? contacts.front() : contacts.back();
            if (pass.cut_short[l][first ? 0 : 1] || !end.usable) continue;
            const double s = first ? -further : pass.lines[l].length() + further;
            EstimatedPass::Contact beyond{.place = field_.place(pass.lines[l], s, pass.v, pass.travel)};
            double lead = end.posture.lead;
            estimate(beyond, lead, hint);
            if (!beyond.usable) continue;
            find_widths(beyond, gap, hint);
            end.width_lo = std::min(end.width_lo, beyond.width_lo);
            end.width_hi = std::min(end.width_hi, beyond.width_hi);
        }
}

EstimatedPass TiltedStepOver::estimate(long plane, int travel, double gap, const Bins& within,
                                       const Progress& progress) const {
    EstimatedPass pass;
    pass.plane = plane;
    pass.v = field_.lines().v(plane);
    pass.travel = travel;
    const bool everywhere = within.first == 0 && within.last == bins_ - 1;
    const double u0 = u_lo_ + double(within.first) * bin_ - within.beyond,
                 u1 = u_lo_ + double(within.last + 1) * bin_ + within.beyond;
    for (SurfaceLine& line : field_.lines().lines(pass.v)) {
        std::array<bool, 2> cut_short{false, false};
        if (!everywhere) line = part_of_line(line, u0, u1, cut_short);
        if (line.points.size() < 2 || !(line.length() > 0)) continue;
        pass.lines.push_back(std::move(line));
        pass.cut_short.push_back(cut_short);
    }
    // Between contacts that are far apart the strip has to be as wide.
    std::vector<EstimatedPass::Contact> between;
    for (const SurfaceLine& line : pass.lines) {
        auto& contacts = pass.contacts.emplace_back();
        const std::vector<double> samples = field_.samples(line);
        for (const double s : samples)
            contacts.push_back({.place = field_.place(line, s, pass.v, travel)});
        find_widths(contacts, gap, progress);
        std::vector<EstimatedPass::Contact> middles;
        for (std::size_t i = 1; i < samples.size(); ++i)
            if (samples[i] - samples[i - 1] > far_apart_share * field_.radius())
                middles.push_back(
                    {.place = field_.place(line, 0.5 * (samples[i] + samples[i - 1]), pass.v, travel)});
        find_widths(middles, gap, progress);
        between.insert(between.end(), middles.begin(), middles.end());
    }
    // Postures with a yaw may be free at the last contact and not where the pass goes on.
    if (!yaws_.empty()) answer_beyond_ends(pass, gap);
    pass.width_lo.assign(bins_, 0);
    pass.width_hi.assign(bins_, 0);
    pass.end_lo.assign(bins_, 0);
    pass.end_hi.assign(bins_, 0);
    pass.comes.assign(bins_, false);
    const double least = min_width_share * field_.radius(), most = StripWidth::most(field_);
    const auto count = [&](const EstimatedPass::Contact& c, double beyond_lo, double beyond_hi) {
        const auto [from, to] = cleared(c.place.u, travel);
        for (std::size_t b = bin(from - beyond_lo); b <= bin(to + beyond_hi); ++b) {
            if (!pass.comes[b]) pass.width_lo[b] = pass.width_hi[b] = infinity;
            pass.comes[b] = true;
            // What no posture serves is no fault of the step: it is left to clean-up, as far as a pass can
            // answer for.
            const bool counts = c.usable && !c.left;
            pass.end_lo[b] = std::max(pass.end_lo[b], counts ? c.end_lo : most);
            pass.end_hi[b] = std::max(pass.end_hi[b], counts ? c.end_hi : most);
            if (!counts) continue;
            pass.width_lo[b] = std::min(pass.width_lo[b], std::max(c.width_lo, least));
            pass.width_hi[b] = std::min(pass.width_hi[b], std::max(c.width_hi, least));
        }
    };
    const double beyond = beyond_share * field_.radius();
    for (std::size_t l = 0; l < pass.contacts.size(); ++l)
        for (const auto& c : pass.contacts[l]) {
            // Beyond its ends a pass goes on as far as its strip does.
            const auto& contacts = pass.contacts[l];
            const bool first = &c == &contacts.front() && !pass.cut_short[l][0],
                       last = &c == &contacts.back() && !pass.cut_short[l][1];
            count(c, first ? beyond : 0, last ? beyond : 0);
        }
    for (const auto& c : between)
        if (c.usable) count(c, 0, 0);
    return pass;
}

void TiltedStepOver::find_widths(std::vector<EstimatedPass::Contact>& contacts, double gap,
                                 const Progress& progress) const {
    // Blocks have their own hints: the same bits for every thread count.
    parallel_blocks(contacts.size(), contacts_per_block, progress, [&](std::size_t begin, std::size_t end) {
        double lead = field_.settings().lead_limits[0];
        ToolLift::Hint hint;
        for (std::size_t i = begin; i < end; ++i) {
            progress.check();
            auto& c = contacts[i];
            estimate(c, lead, hint);
            if (!c.usable) continue;
            find_widths(c, gap, hint);
            const double slope = std::abs(field_.drive().v(c.place.frame.left));
            c.left = c.width_lo + c.width_hi < leave_ * slope;
        }
    });
}

bool TiltedStepOver::surface_between(double v0, double v1, std::size_t bin) const {
    const auto& lines = field_.lines();
    const double u0 = u_lo_ + double(bin) * bin_;
    const auto covers = [&](long k) {
        return lines.v(k) > v0 && lines.v(k) < v1 && lines.slice(k)->covers(u0, u0 + bin_);
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

bool TiltedStepOver::fits(const EstimatedPass* a, const EstimatedPass* b, const Bins& within) const {
    for (std::size_t i = within.first; i <= within.last; ++i)
        if (!fits(a, b, i)) return false;
    return true;
}

TiltedStepOver::Step TiltedStepOver::next(const EstimatedPass* last, int travel, double usual,
                                          const EstimatedPass* limit, const Bins& within,
                                          const Progress& progress) const {
    const auto& lines = field_.lines();
    const long from = last ? last->plane : 0;
    const long end = limit ? limit->plane : lines.beyond(lines.hi(), lines.lo());
    const auto steps = [&](double gap) { return std::max(1L, std::lround(gap / lines.spacing())); };
    const long least = steps(last ? smallest_ : 0.5 * smallest_);
    const long most = std::max(least, std::min(steps(last ? largest_ : 0.5 * largest_), end - 1 - from));
    const auto tried = [&](long step) {
        progress.check();
        const double gap = double(step) * lines.spacing();
        return estimate(from + step, travel, last ? gap : 2 * gap, within, progress.part(0, 0));
    };
    long good = 0, bad = most + 1;
    EstimatedPass best;
    long step = std::clamp(steps(usual), least, most);
    while (true) {
        EstimatedPass p = tried(step);
        if (fits(last, &p, within)) {
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
    return fits(&last, nullptr, all());
}

std::vector<TiltedStepOver::Bins>
TiltedStepOver::narrow_ranges(const EstimatedPass& a, const EstimatedPass* b, const Bins& within) const {
    const double r = field_.radius(), gap = (b ? b->v : field_.lines().hi()) - a.v;
    // A pose clears what lies beside and behind it.
    const double aside = std::min(0.5 * gap, StripWidth::most(field_));
    const double beyond = behind_ + r - std::sqrt(r * r - aside * aside);
    std::vector<Bins> ranges;
    for (std::size_t i = within.first; i <= within.last; ++i) {
        if (fits(&a, b, i)) continue;
        // Two that would run into each other, or whose ends cost as much as the way between them, are one.
        if (!ranges.empty() && double(i - ranges.back().last) * bin_ <= 2 * beyond + partial_cost * r)
            ranges.back().last = i;
        else
            ranges.push_back({i, i, beyond});
    }
    return ranges;
}

double TiltedStepOver::partial_travel(const EstimatedPass& a, const EstimatedPass* b,
                                      const Bins& within) const {
    const double gap = (b ? b->v : field_.lines().hi()) - a.v;
    double travel = 0;
    for (const Bins& range : narrow_ranges(a, b, within)) {
        double most = 1;
        for (std::size_t i = range.first; i <= range.last; ++i) {
            double width = 0;
            if (a.comes[i] && std::isfinite(a.width_hi[i])) width += a.width_hi[i];
            if (b && b->comes[i] && std::isfinite(b->width_lo[i])) width += b->width_lo[i];
            const double passes = std::max(std::ceil(gap / std::max(width, smallest_)) - 1, 0.0);
            travel += passes * bin_;
            most = std::max(most, passes);
        }
        travel += most * (2 * range.beyond + partial_cost * field_.radius());
    }
    return travel;
}

double TiltedStepOver::partial_share(const EstimatedPass& a, const EstimatedPass& b,
                                     const Bins& within) const {
    double partial = 0, whole = 0;
    for (const Bins& range : narrow_ranges(a, &b, within))
        partial += double(range.last + 1 - range.first) * bin_ + 2 * range.beyond;
    for (std::size_t i = within.first; i <= within.last; ++i)
        if (a.comes[i] || b.comes[i]) whole += bin_;
    return whole > 0 ? partial / whole : 0;
}

std::optional<EstimatedPass> TiltedStepOver::cheapest(const EstimatedPass& last, const EstimatedPass* limit,
                                                      const Bins& within, bool turns, double usual,
                                                      const Progress& progress) const {
    const auto& lines = field_.lines();
    const long end = limit ? limit->plane : lines.beyond(lines.hi(), lines.lo());
    const int travel = turns ? -last.travel : last.travel;
    const double rest = lines.v(end) - last.v;
    std::optional<EstimatedPass> best;
    double least = infinity;
    // As far as nothing is asked for between.
    Step whole = next(&last, travel, usual, limit, within, progress);
    const auto better = [&](EstimatedPass&& p) {
        double travelled = partial_travel(last, &p, within);
        for (const SurfaceLine& line : p.lines)
            travelled +=
                std::abs(line.points.back().u - line.points.front().u) + partial_cost * field_.radius();
        if (!(travelled < least * (p.v - last.v))) return false;
        // Where most of the way asks for passes between, the last of them would come close to its neighbour.
        if (whole.satisfied && partial_share(last, p, within) > max_partial) return false;
        least = travelled / (p.v - last.v);
        best = std::move(p);
        return true;
    };
    const auto tried = [&](double step) {
        const long plane = last.plane + std::max(1L, std::lround(step / lines.spacing()));
        return better(estimate(std::min(plane, end - 1), travel, step, within, progress.part(0, 0)));
    };
    const double most = std::max(std::min(largest_, rest), smallest_);
    const double start = std::clamp(usual, smallest_, most);
    tried(start);
    if (whole.satisfied) better(std::move(whole.pass));
    // What is travelled per width falls and rises several times on the way.
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

void TiltedStepOver::fill(const EstimatedPass& a, const EstimatedPass* b, bool turns, const Bins& within,
                          int depth, Gap& gap, const Progress& progress) const {
    const auto& lines = field_.lines();
    for (const Bins& range : narrow_ranges(a, b, within)) {
        const EstimatedPass* last = &a;
        const long end = b ? b->plane : lines.beyond(lines.hi(), lines.lo());
        double usual = 0.5 * (lines.v(end) - a.v);
        while (!fits(last, b, range)) {
            if (end - last->plane <= 1) {
                gap.satisfied = false;
                break;
            }
            std::optional<EstimatedPass> next;
            if (depth < deepest_partial) {
                next = cheapest(*last, b, range, turns, usual, progress);
                // Narrow in a part of the range only.
                if (!next) {
                    fill(*last, b, turns, range, depth + 1, gap, progress);
                    break;
                }
            } else {
                Step step = this->next(last, turns ? -last->travel : last->travel, usual, b, range, progress);
                if (!step.satisfied && b && b->v - last->v <= smallest_) {
                    gap.satisfied = false;
                    break;
                }
                next = std::move(step.pass);
            }
            usual = next->v - last->v;
            const EstimatedPass* before = last;
            gap.partial.push_back({std::move(*next), range});
            last = &gap.partial.back().pass;
            if (depth < deepest_partial) fill(*before, last, turns, range, depth + 1, gap, progress);
        }
    }
}

TiltedStepOver::Gap TiltedStepOver::next_with_partial(const EstimatedPass& last, bool turns, double usual,
                                                      const Progress& progress) const {
    Gap gap;
    gap.next = cheapest(last, nullptr, all(), turns, usual, progress);
    fill(last, gap.next ? &*gap.next : nullptr, turns, all(), 0, gap, progress);
    return gap;
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
    std::vector<double> borders(bins_);
    for (std::size_t i = 0; i < bins_; ++i)
        borders[i] = border(a, b, i);
    return borders;
}

} // namespace facetmill
