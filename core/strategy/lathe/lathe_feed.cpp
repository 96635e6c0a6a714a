#include "core/strategy/lathe/lathe_feed.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Lines on which cusps are measured are followed to this share of the cusp.
constexpr double line_share = 0.05;
/// How steeply feeds may change along the line, and what share of a feed their places may be apart.
constexpr double steepest = 0.5, place_share = 0.25;
/// No feed is longer than this share of the cutter's diameter.
constexpr double widest_share = 0.95;
/// Lines on which cusps are measured: about as far apart as a step on a level plane, within these limits.
/// LathePath aims below the allowed cusp for the angles between.
constexpr std::size_t fewest_lines = 24, max_lines = 720;
/// Halvings while a feed is sought: to a hundredth of it, and always on the safe side.
constexpr int feed_halvings = 7;
/// Places between two cutters at which the cusp is looked at, and halvings of their distance about the
/// highest.
constexpr int pieces = 6, crest_rounds = 4;
/// Cosine: contacts whose normals are nearer than that have others between them.
constexpr double near_normals = 0.9;
/// In radii of the cutter: contacts of neighbouring tips that are farther apart have jumped.
constexpr double far_contacts = 0.2;

} // namespace

SideFeed::SideFeed(const LatheField& field, bool across_turns, double from, double to, double cusp,
                   const Progress& progress)
    : field_(field), across_turns_(across_turns), from_(across_turns ? from : 0),
      to_(across_turns ? to : 2 * pi), cusp_(cusp) {
    const CutterCover& cover = field.cover();
    const double radius = cover.radius(), part = std::max(field.part_radius(), tolerance::smallest_extent);
    // A ball of the cutter's size on a plane gives the scale.
    const double level = 2 * std::sqrt(std::max(2 * radius * cusp - cusp * cusp, cusp * cusp));
    per_length_ = across_turns ? 1 : 1 / part;
    largest_ = std::min(2 * widest_share * std::max(radius, 0.5 * level) * per_length_,
                        across_turns ? infinity : 0.25 * pi);
    smallest_ = tolerance::smallest_step_share * std::min(level * per_length_, largest_);
    last_ = std::min(1.2 * level * per_length_, largest_);

    LineTolerance fine;
    fine.below = fine.above = line_share * cusp;
    fine.spacing = std::min(0.25 * level, safe_lathe_spacing(cover.profile(), part, line_share * cusp));
    const double apart = across_turns ? 2 * pi * part : to - from;
    const auto n = std::clamp(std::size_t(std::ceil(apart / level)), fewest_lines, max_lines);
    lines_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double at = (double(i) + (across_turns ? 0.0 : 0.5)) / double(n);
        std::array<LathePlace, 2> ends;
        if (across_turns)
            ends = {LathePlace{2 * pi * at, from}, LathePlace{2 * pi * at, to}};
        else // a little round, so that gaps over the closing line are seen
            ends = {LathePlace{0, from + at * (to - from)},
                    LathePlace{2 * pi + largest_, from + at * (to - from)}};
        Line& line = lines_[i];
        line.points =
            trace(field, ends, fine, progress.part(double(i) / double(n), double(i + 1) / double(n)));
        for (const LathePoint& p : line.points)
            line.at.push_back(across_turns ? p.place.y : p.place.angle);
    }
}

LathePlace SideFeed::place(const Line& line, double at) const {
    LathePlace place = line.points.front().place;
    (across_turns_ ? place.y : place.angle) = at;
    return place;
}

SideFeed::Stand SideFeed::stand(const Line& line, double at) const {
    const auto above = std::upper_bound(line.at.begin(), line.at.end(), at) - line.at.begin();
    const auto i = std::size_t(std::clamp(above, std::ptrdiff_t(1), std::ptrdiff_t(line.at.size() - 1)));
    const double span = line.at[i] - line.at[i - 1];
    const double t = span > 0 ? std::clamp((at - line.at[i - 1]) / span, 0.0, 1.0) : 1;
    const CutterLocation tool = field_.frame().at(
        place(line, at), line.points[i - 1].u + t * (line.points[i].u - line.points[i - 1].u));
    const Vec3 x = field_.frame().axis().direction.cross(tool.axis).normalized();
    return {tool.tip, x, tool.axis.cross(x), tool.axis};
}

double SideFeed::left_over(const std::array<Stand, 2>& tools, const CutterContact& cc, double low) const {
    const CutterCover& cover = field_.cover();
    // What is to stay stands on the part. The cutter is convex and reaches up: where it holds the place that
    // is `low` above, no more than that is left.
    const Vec3 from = cc.point + field_.allowance() * cc.normal, place = from + low * cc.normal;
    for (const Stand& tool : tools)
        if (cover.holds(tool.in_frame(place - tool.tip))) return low;
    const double limit = 2 * cover.radius();
    double least = infinity;
    for (const Stand& tool : tools) {
        const Vec3 n = tool.in_frame(cc.normal);
        if (!(n.z() >= 0)) continue;
        least = std::min(least, cover.ray_entry(tool.in_frame(from - tool.tip), n, Vec3::Zero(), limit));
    }
    return std::max(least, low);
}

double SideFeed::cusp(const Line& line, double a, double b, double enough) const {
    const std::array<Stand, 2> tools{stand(line, a), stand(line, b)};
    double most = 0;
    const auto lerp = [](const CutterContact& c0, const CutterContact& c1, double t) {
        return CutterContact{c0.point + t * (c1.point - c0.point),
                             (c0.normal + t * (c1.normal - c0.normal)).normalized()};
    };
    const auto left = [&](const CutterContact& cc, double low) { return left_over(tools, cc, low); };
    const auto begin = std::lower_bound(line.at.begin(), line.at.end(), a) - line.at.begin();
    const auto end = std::upper_bound(line.at.begin(), line.at.end(), b) - line.at.begin();
    const auto held = [&](std::size_t i) { return line.points[i].held == LathePoint::HeldBy::part; };
    for (auto i = begin; i < end && most <= enough; ++i) {
        const LathePoint& here = line.points[std::size_t(i)];
        if (!held(std::size_t(i))) continue;
        most = left(here.cc, most);
        // A bottom that tips over from one rim to the other touches all between them at once.
        if (i == begin || !held(std::size_t(i - 1))) continue;
        const CutterContact& before = line.points[std::size_t(i - 1)].cc;
        if ((here.cc.point - before.point).norm() < far_contacts * field_.cover().radius()
            || here.cc.normal.dot(before.normal) < near_normals)
            continue;
        for (int k = 1; k < pieces; ++k)
            most = left(lerp(before, here.cc, double(k) / pieces), most);
    }
    if (most > enough) return most;
    // Between points: contacts there lie between theirs where those are near to each other.
    double best = a, highest = 0, step = (b - a) / pieces;
    const auto between = [&](double at) {
        const auto j = std::upper_bound(line.at.begin(), line.at.end(), at) - line.at.begin();
        if (j <= 0 || j >= std::ptrdiff_t(line.at.size())) return 0.0;
        const auto i = std::size_t(j);
        if (!held(i) || !held(i - 1)) return 0.0;
        const CutterContact &c0 = line.points[i - 1].cc, &c1 = line.points[i].cc;
        const double span = line.at[i] - line.at[i - 1];
        if (!(span > 0) || c0.normal.dot(c1.normal) < near_normals) return 0.0;
        const double t = (at - line.at[i - 1]) / span;
        return left(lerp(c0, c1, t), highest);
    };
    // The highest place, more exactly: the crest between two pointed cutters is sharp.
    for (int k = 1; k < pieces; ++k)
        if (const double here = between(a + k * step); here > highest) {
            highest = here;
            best = a + k * step;
        }
    for (int round = 0; round < crest_rounds && highest > 0 && most <= enough; ++round) {
        step *= 0.5;
        for (const double at : {best - step, best + step})
            if (const double here = at > a && at < b ? between(at) : 0; here > highest) {
                highest = here;
                best = at;
            }
    }
    most = std::max(most, highest);
    return most;
}

double SideFeed::advance_at(double a, const Progress& progress) {
    const double top = std::min(largest_, 2 * last_);
    const auto fit = [&](const Line& line, double advance) {
        return cusp(line, a, std::min(a + advance, line.at.back()), cusp_) <= cusp_;
    };
    constexpr std::size_t lines_per_block = 8;
    const double found = parallel_reduce(
        lines_.size(), lines_per_block, top, progress,
        [&](std::size_t begin, std::size_t end) {
            double best = top;
            for (std::size_t i = begin; i < end; ++i) {
                if (fit(lines_[i], best)) continue;
                double good = 0, bad = best;
                for (int k = 0; k < feed_halvings; ++k) {
                    const double mid = 0.5 * (good + bad);
                    (fit(lines_[i], mid) ? good : bad) = mid;
                }
                best = good;
            }
            return best;
        },
        [](double x, double y) { return std::min(x, y); });
    last_ = std::max(found, smallest_);
    return found;
}

void SideFeed::measure(const Progress& progress) {
    std::size_t looked = 0, failed = 0;
    const Progress still = progress.part(0, 0);
    const auto value = [&](double a) {
        ++looked;
        const double v = advance_at(a, still);
        if (v < smallest_) ++failed;
        return std::max(v, smallest_);
    };
    // Places as far apart as a share of the feeds there; towards a shoulder as near as the cusp asks for.
    const double nearest = place_share * cusp_ * per_length_;
    at_ = {from_};
    advance_ = {value(from_)};
    const auto fill = [&](const auto& self, double b, double vb, int depth) -> void {
        const double a = at_.back(), va = advance_.back();
        const double gap = b - a;
        // A jump of the feed is followed to its place.
        const bool wide = gap > place_share * std::max(va, vb);
        const bool jump = std::abs(vb - va) > 2 * gap && gap > nearest;
        if ((wide || jump) && depth < 40) {
            const double mid = 0.5 * (a + b), vm = value(mid);
            self(self, mid, vm, depth + 1);
            self(self, b, vb, depth + 1);
            return;
        }
        at_.push_back(b);
        advance_.push_back(vb);
        progress.set((b - from_) / (to_ - from_));
    };
    if (to_ > from_) {
        const auto coarse = std::size_t(std::clamp(std::ceil((to_ - from_) / largest_), 1.0, 64.0));
        for (std::size_t i = 1; i <= coarse; ++i) {
            const double b = i == coarse ? to_ : from_ + (to_ - from_) * double(i) / double(coarse);
            fill(fill, b, value(b), 0);
        }
    }
    unsatisfied_ = double(failed) / double(looked);
    slow();
}

/// Slow to both sides: no advance may be longer than one near it allows.
void SideFeed::slow() {
    for (std::size_t i = 1; i < at_.size(); ++i)
        advance_[i] = std::min(advance_[i], advance_[i - 1] + steepest * (at_[i] - at_[i - 1]));
    for (std::size_t i = at_.size(); i-- > 1;)
        advance_[i - 1] = std::min(advance_[i - 1], advance_[i] + steepest * (at_[i] - at_[i - 1]));
}

void SideFeed::limit(std::span<const FeedLimit> limits) {
    // Each limit from where an advance of its length just comes to its place. Longer ones from before that do
    // not, as advances change slowly.
    struct Stretch {
        double first, last, most;
    };
    std::vector<Stretch> stretches;
    std::vector<double> places = at_;
    for (const FeedLimit& l : limits)
        for (const double turn : {0.0, 2 * pi}) {
            if (turn > 0 && across_turns_) continue;
            const double most = std::max(l.advance, smallest_), last = std::min(l.at + turn, to_),
                         first = std::max(l.at + turn - most, from_);
            if (!(first <= last)) continue;
            stretches.push_back({first, last, most});
            places.insert(places.end(), {first, last});
        }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<double> advances;
    for (const double at : places)
        advances.push_back(allowed(at));
    for (const Stretch& s : stretches) {
        const auto begin = std::lower_bound(places.begin(), places.end(), s.first) - places.begin();
        for (auto i = std::size_t(begin); i < places.size() && places[i] <= s.last; ++i)
            advances[i] = std::min(advances[i], s.most);
    }
    at_ = std::move(places);
    advance_ = std::move(advances);
    slow();
}

double SideFeed::allowed(double a) const {
    const auto above = std::upper_bound(at_.begin(), at_.end(), a) - at_.begin();
    if (above <= 0) return advance_.front();
    if (above >= std::ptrdiff_t(at_.size())) return advance_.back();
    const auto i = std::size_t(above);
    const double t = (a - at_[i - 1]) / (at_[i] - at_[i - 1]);
    return advance_[i - 1] + t * (advance_[i] - advance_[i - 1]);
}

double SideFeed::cusp_of(double advance, const Progress& progress) const {
    // Advances begin anywhere: every half of one.
    const auto n = std::size_t(std::clamp(std::ceil((to_ - from_) / (0.5 * advance)), 1.0, 4000.0));
    return parallel_reduce(
        lines_.size(), 4, 0.0, progress,
        [&](std::size_t begin, std::size_t end) {
            double most = 0;
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t k = 0; k < n; ++k) {
                    progress.check();
                    const double a = from_ + (to_ - from_) * double(k) / double(n);
                    most = std::max(most,
                                    cusp(lines_[i], a, std::min(a + advance, lines_[i].at.back()), infinity));
                }
            return most;
        },
        [](double x, double y) { return std::max(x, y); });
}

} // namespace facetmill
