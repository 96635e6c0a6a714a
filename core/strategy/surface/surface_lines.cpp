#include "core/strategy/surface/surface_lines.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace facetmill {

namespace {

SlicePoint between(const SlicePoint& a, const SlicePoint& b, double t) {
    SlicePoint p;
    p.point = a.point + t * (b.point - a.point);
    p.normal = edge_normal(a.normal, b.normal, t);
    if (p.normal.isZero()) p.normal = a.normal;
    p.u = a.u + t * (b.u - a.u);
    p.facet = t < 0.5 ? a.facet : b.facet;
    return p;
}

void measure(SurfaceLine& line) {
    line.arc.assign(1, 0);
    for (std::size_t i = 1; i < line.points.size(); ++i)
        line.arc.push_back(line.arc.back() + (line.points[i].point - line.points[i - 1].point).norm());
}

/// Points of a closed or open run in which u goes on to grow, or to fall, where it would begin anew.
void unwind(std::vector<SlicePoint>& points, double period) {
    for (std::size_t i = 1; i < points.size(); ++i)
        points[i].u = points[i - 1].u + std::remainder(points[i].u - points[i - 1].u, period);
}

void shift_u(std::vector<SlicePoint>& points, double by) {
    for (SlicePoint& p : points)
        p.u += by;
}

/// One round of a closed run, from u = 0 on, without its end.
std::vector<SlicePoint> whole_round(std::vector<SlicePoint> run, double period) {
    shift_u(run, -period * std::ceil(run.front().u / period));
    // From below 0 to a round above that: the first place where it comes to 0.
    std::size_t at = 0;
    while (at < run.size() && run[at].u < 0)
        ++at;
    if (at == 0) return run;
    const SlicePoint& before = run[at - 1];
    SlicePoint after = run[at % run.size()];
    if (at == run.size()) after.u += period;
    SlicePoint start = between(before, after, -before.u / (after.u - before.u));
    start.u = 0;
    std::vector<SlicePoint> round;
    if (before.u < 0 && after.u > 0) round.push_back(start);
    for (std::size_t i = at; i < run.size(); ++i)
        round.push_back(run[i]);
    for (std::size_t i = 0; i < at; ++i) {
        round.push_back(run[i]);
        round.back().u += period;
    }
    return round;
}

/// A closed run that goes round, cut at u = 0 and longer by as much as asked.
SurfaceLine line_round(const std::vector<SlicePoint>& run, double period, double before, double after,
                       long max_after) {
    const std::vector<SlicePoint> round = whole_round(run, period);
    const auto n = long(round.size());
    const auto at = [&](long i) {
        const long rounds = i >= 0 ? i / n : -((n - 1 - i) / n);
        SlicePoint p = round[std::size_t(i - rounds * n)];
        p.u += double(rounds) * period;
        return p;
    };
    long first = 0, last = n;
    for (double gone = 0; gone < before && first > -n; --first)
        gone += (at(first - 1).point - at(first).point).norm();
    for (double gone = 0; gone < after && last < (1 + max_after) * n; ++last)
        gone += (at(last + 1).point - at(last).point).norm();
    SurfaceLine line;
    for (long i = first; i <= last; ++i)
        line.points.push_back(at(i));
    line.goes_on = {true, true};
    measure(line);
    return line;
}

/// Lines of chains whose u goes round, from u = 0 to a round and what is asked beyond it; what is open and
/// lies across the beginning of a round is at both ends of that.
class RoundLines {
public:
    RoundLines(const SurfaceSlice::Options& options, const UpSide& up, double before, double after)
        : options_(options), up_(up), before_(before), after_(after) {}

    void add(const SliceChain& chain, std::vector<SurfaceLine>& lines) const {
        std::vector<SlicePoint> points = chain.points;
        if (!options_.as_wound)
            for (SlicePoint& p : points)
                p.normal = up_.towards_tool(p.normal);
        const auto usable = [&](const SlicePoint& p) {
            return options_.as_wound || p.normal.z() > tolerance::vertical_normal_z;
        };
        const auto ends = std::find_if_not(points.begin(), points.end(), usable);
        if (ends == points.end()) {
            add_run(std::move(points), chain.closed, lines);
            return;
        }
        if (chain.closed) std::rotate(points.begin(), ends, points.end());
        std::vector<SlicePoint> run;
        for (const SlicePoint& p : points)
            if (usable(p))
                run.push_back(p);
            else
                add_run(std::exchange(run, {}), false, lines);
        add_run(std::move(run), false, lines);
    }

private:
    void add_run(std::vector<SlicePoint> run, bool closed, std::vector<SurfaceLine>& lines) const {
        if (run.size() < 2) return;
        const double period = options_.period;
        if (closed) run.push_back(run.front());
        unwind(run, period);
        if (run.back().u < run.front().u) std::reverse(run.begin(), run.end());
        if (closed && run.back().u - run.front().u > 0.5 * period) {
            run.pop_back();
            SurfaceLine line = line_round(run, period, before_, after_, before_ > 0 ? 2 : 1);
            if (line.length() > 0) lines.push_back(std::move(line));
            return;
        }
        if (!closed) return add_open(std::move(run), lines);
        // About a hole: there and back.
        run.pop_back();
        const auto by_u = [](const SlicePoint& a, const SlicePoint& b) { return a.u < b.u; };
        std::rotate(run.begin(), std::min_element(run.begin(), run.end(), by_u), run.end());
        const auto turn = std::max_element(run.begin(), run.end(), by_u);
        std::vector<SlicePoint> back(turn, run.end());
        back.push_back(run.front());
        std::reverse(back.begin(), back.end());
        run.erase(turn + 1, run.end());
        add_open(std::move(run), lines);
        add_open(std::move(back), lines);
    }

    void add_open(std::vector<SlicePoint> run, std::vector<SurfaceLine>& lines) const {
        if (run.size() < 2) return;
        const double period = options_.period;
        shift_u(run, -period * std::floor(run.front().u / period));
        SurfaceLine whole;
        whole.points = std::move(run);
        measure(whole);
        if (!(whole.length() > 0)) return;
        while (whole.points.back().u > 0) {
            std::array<bool, 2> cut_short{};
            SurfaceLine part = part_of_line(whole, -before_, period + std::min(after_, period), cut_short);
            if (part.points.size() >= 2 && part.length() > 0) lines.push_back(std::move(part));
            shift_u(whole.points, -period);
        }
    }

    const SurfaceSlice::Options& options_;
    const UpSide& up_;
    double before_, after_;
};

/// The runs of a chain that face the tool.
void add_usable(const SliceChain& chain, const UpSide& up, std::vector<SurfaceLine>& lines) {
    std::vector<SlicePoint> points = chain.points;
    for (SlicePoint& p : points)
        p.normal = up.towards_tool(p.normal);
    SurfaceLine line;
    const auto finish = [&] {
        if (line.points.size() >= 2) {
            if (line.points.back().u < line.points.front().u)
                std::reverse(line.points.begin(), line.points.end());
            measure(line);
            if (line.length() > 0) lines.push_back(std::move(line));
        }
        line = {};
    };
    // A closed chain starts at its smallest u: there and where u is largest it is cut in two.
    const auto by_u = [](const SlicePoint& a, const SlicePoint& b) { return a.u < b.u; };
    const SlicePoint turn = *std::max_element(points.begin(), points.end(), by_u);
    if (chain.closed) points.push_back(points.front());
    for (const SlicePoint& p : points) {
        if (p.normal.z() > tolerance::vertical_normal_z) {
            line.points.push_back(p);
            if (!chain.closed || p.point != turn.point) continue;
            finish();
            line.points.push_back(p);
        } else {
            finish();
        }
    }
    finish();
}

} // namespace

SurfaceLine part_of_line(const SurfaceLine& line, double u0, double u1, std::array<bool, 2>& cut_short) {
    SurfaceLine part;
    const auto& p = line.points;
    const std::array<bool, 2> cut{p.front().u<u0, p.back().u> u1};
    cut_short = {cut[0] || line.goes_on[0], cut[1] || line.goes_on[1]};
    if (!cut[0] && !cut[1]) return line;
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
    part.goes_on = cut_short;
    if (!part.points.empty()) measure(part);
    return part;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double square = d.squaredNorm();
    const double t = square > 0 ? std::clamp((p - a).dot(d) / square, 0.0, 1.0) : 0.0;
    return (p - a - t * d).norm();
}

SlicePoint SurfaceLine::at(double s) const {
    const auto after = std::lower_bound(arc.begin(), arc.end(), s);
    const std::size_t i = std::clamp<std::size_t>(std::size_t(after - arc.begin()), 1, points.size() - 1);
    const double piece = arc[i] - arc[i - 1];
    const double t = piece > 0 ? (s - arc[i - 1]) / piece : 0.0;
    if (t >= 0 && t <= 1) return between(points[i - 1], points[i], t);
    // Beyond an end: straight on, in the direction that the line has there, with the normal of the end.
    const bool front = t < 0;
    SlicePoint end = front ? points.front() : points.back();
    const double beyond = front ? s : s - length();
    end.point += beyond * direction(s);
    if (piece > 0) end.u += beyond * (points[i].u - points[i - 1].u) / piece;
    return end;
}

Vec3 SurfaceLine::direction(double s) const {
    const auto after = std::upper_bound(arc.begin(), arc.end(), s);
    std::size_t i = std::clamp<std::size_t>(std::size_t(after - arc.begin()), 1, points.size() - 1);
    // Pieces without length have no direction.
    while (i + 1 < points.size() && !(arc[i] > arc[i - 1]))
        ++i;
    while (i > 1 && !(arc[i] > arc[i - 1]))
        --i;
    return (points[i].point - points[i - 1].point).normalized();
}

SurfaceSlice::SurfaceSlice(std::vector<SurfaceLine> lines, const Options& options)
    : steepest_u_(options.steepest_u) {
    for (SurfaceLine& line : lines) {
        Chain chain;
        const double before = line.goes_on[0] ? 0 : options.extension,
                     after = line.goes_on[1] ? 0 : options.extension;
        if (!line.goes_on[0]) ends_.push_back({line.points.front().point, line.points.front().u, true});
        if (!line.goes_on[1]) ends_.push_back({line.points.back().point, line.points.back().u, false});
        const auto [least, most] =
            std::minmax_element(line.points.begin(), line.points.end(),
                                [](const SlicePoint& a, const SlicePoint& b) { return a.u < b.u; });
        // What lies beyond a round is asked for at its beginning.
        if (options.period > 0)
            ranges_.push_back({std::max(least->u, 0.0), std::min(most->u, options.period)});
        else
            ranges_.push_back({least->u, most->u});
        const auto add = [&](const SlicePoint& p) { chain.push_back(p); };
        if (before > 0) add(line.at(-before));
        std::size_t last = 0;
        add(line.points.front());
        const auto fill = [&](std::size_t from, std::size_t to) {
            const double gap = line.arc[to] - line.arc[from];
            const auto pieces = std::size_t(std::ceil(gap / options.longest));
            for (std::size_t k = 1; k < pieces; ++k)
                add(line.at(line.arc[from] + gap * double(k) / double(pieces)));
            add(line.points[to]);
        };
        for (std::size_t i = 2; i < line.points.size(); ++i) {
            bool keep = line.arc[i] - line.arc[last] > options.longest;
            const SlicePoint &a = line.points[last], &b = line.points[i];
            // The tips of the normals too: what is wanted of the line is its raised copy.
            for (std::size_t k = last + 1; k < i && !keep; ++k) {
                const SlicePoint& p = line.points[k];
                keep = distance_to_segment(p.point, a.point, b.point) > options.deviation
                       || distance_to_segment(p.point + options.longest * p.normal,
                                              a.point + options.longest * a.normal,
                                              b.point + options.longest * b.normal)
                              > 20 * options.deviation;
            }
            if (!keep) continue;
            fill(last, i - 1);
            last = i - 1;
        }
        fill(last, line.points.size() - 1);
        if (after > 0) add(line.at(line.length() + after));
        chains_.push_back(std::move(chain));
    }
    for (std::size_t c = 0; c < chains_.size(); ++c)
        for (std::size_t i = 0; i < chains_[c].size(); ++i)
            by_u_.push_back({chains_[c][i].u, std::uint32_t(c), std::uint32_t(i)});
    std::sort(by_u_.begin(), by_u_.end(), [](const Reference& a, const Reference& b) {
        return a.u != b.u ? a.u < b.u : a.chain != b.chain ? a.chain < b.chain : a.place < b.place;
    });
}

bool SurfaceSlice::covers(double u0, double u1) const {
    return std::any_of(ranges_.begin(), ranges_.end(),
                       [&](const auto& range) { return range[0] <= u1 && range[1] >= u0; });
}

bool SurfaceSlice::near(const Vec3& p, const Vec3& normal, double u, double reach, double raise,
                        std::vector<Vec3>& raised) const {
    raised.clear();
    const auto middle = std::lower_bound(by_u_.begin(), by_u_.end(), u,
                                         [](const Reference& r, double at) { return r.u < at; });
    const double farthest = reach * reach;
    double least = farthest, beside = reach;
    const Reference* nearest = nullptr;
    // What is farther along the line than the nearest so far is farther; of two as near the first counts.
    const auto is_beside = [&](const Reference& r) { return std::abs(r.u - u) <= steepest_u_ * beside; };
    const auto look_at = [&](const Reference& r) {
        const SlicePoint& place = chains_[r.chain][r.place];
        // The other side of a thin wall is not the surface that goes on here.
        if (place.normal.dot(normal) <= 0) return;
        const double square = (place.point - p).squaredNorm();
        if (square < least || (square == least && square < farthest && &r < nearest)) {
            least = square;
            nearest = &r;
            beside = std::min(reach, std::sqrt(square) + tolerance::contact_distance);
        }
    };
    for (auto r = middle; r != by_u_.end() && is_beside(*r); ++r)
        look_at(*r);
    for (auto r = middle; r != by_u_.begin() && is_beside(*std::prev(r)); --r)
        look_at(*std::prev(r));
    if (!nearest) return false;
    const Chain& places = chains_[nearest->chain];
    const auto within = [&](std::size_t i) {
        return std::abs(places[i].u - u) <= steepest_u_ * reach
               && (places[i].point - p).squaredNorm() <= 4 * reach * reach;
    };
    // One place beyond the reach on either side, so that the line is not cut short.
    std::size_t begin = nearest->place, end = nearest->place;
    while (begin > 0 && within(begin))
        --begin;
    while (end + 1 < places.size() && within(end))
        ++end;
    raised.reserve(end + 1 - begin);
    for (std::size_t i = begin; i <= end; ++i)
        raised.push_back(places[i].point + raise * places[i].normal);
    return true;
}

SurfaceLines::SurfaceLines(const Mesh& mesh, const MeshGeometry& geometry, const DriveFrame& frame,
                           double spacing, const SurfaceSlice::Options& options, const Progress& progress,
                           const Mat3& back, const PassMap* map)
    : slicer_(mesh, geometry, frame, progress, map), spacing_(spacing), options_(options),
      up_(mesh, progress), back_(back), turned_(back != Mat3::Identity()) {}

long SurfaceLines::beyond(double v, double from) const {
    const double at = (v - lo()) / spacing_;
    return v >= from ? long(std::ceil(at - tolerance::level_angle))
                     : long(std::floor(at + tolerance::level_angle));
}

std::vector<SurfaceLine> SurfaceLines::lines(double v) const {
    return lines(v, 0, options_.overlap);
}

std::vector<SurfaceLine> SurfaceLines::lines(double v, double before, double after) const {
    std::vector<SurfaceLine> all;
    for (const SliceChain& chain : slicer_.slice(v))
        if (options_.period > 0)
            RoundLines(options_, up_, before, after).add(chain, all);
        else
            add_usable(chain, up_, all);
    if (turned_)
        for (SurfaceLine& line : all)
            for (SlicePoint& p : line.points) {
                p.point = back_ * p.point;
                p.normal = back_ * p.normal;
            }
    return all;
}

std::shared_ptr<const SurfaceSlice> SurfaceLines::slice(long plane) const {
    {
        const std::lock_guard lock(mutex_);
        if (const auto it = slices_.find(plane); it != slices_.end()) return it->second;
    }
    // Two threads may both make it; they make the same.
    auto made = std::make_shared<const SurfaceSlice>(
        lines(v(plane), options_.extension, options_.overlap + options_.extension), options_);
    const std::lock_guard lock(mutex_);
    return slices_.emplace(plane, std::move(made)).first->second;
}

void SurfaceLines::forget(long below) {
    const std::lock_guard lock(mutex_);
    slices_.erase(slices_.begin(), slices_.lower_bound(below));
}

} // namespace facetmill
