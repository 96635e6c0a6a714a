#include "core/strategy/cleanup/valley_runs.h"

#include "core/base/parallel.h"
#include "core/strategy/cleanup/valley_fit.h"
#include "core/strategy/cleanup/valley_scale.h"
#include "core/strategy/surface/point_grid.h"

#include <numeric>
#include <optional>

namespace facetmill {

namespace {

/// A centre that goes on straight over the surface by a step moves by no more than this many; else it is on
/// another surface.
constexpr double same_surface = 1.5;

/// One traced curve, cut down to where something is left along it.
class CurveRuns {
public:
    CurveRuns(const ValleyInput& input, const TracedValley& traced)
        : in_(input), scale_(input), curve_(traced.curve), ends_(traced.ends) {}

    std::vector<ValleyRun> run(const Progress& progress) {
        thin_out();
        // Each by its own normals first: they say where the cutter rolls out over a rim.
        fit_up(curve_, 0, std::vector<Rolls>(curve_.points.size(), Rolls::no));
        place_all(progress);
        rolls_ = rolling(in_, curve_, scale_.fit);
        fit_up(curve_, scale_.fit, rolls_);
        place_all(progress);
        return runs();
    }

private:
    using Range = std::array<std::size_t, 2>; ///< [from, to) of points, counted from first_

    /// Where a curve was lost its steps became ever shorter.
    void thin_out() {
        const double apart = ValleyScale::min_step * scale_.step;
        std::vector<PencilPoint> kept;
        for (const PencilPoint& p : curve_.points)
            if (kept.empty() || (p.tip - kept.back().tip).norm() >= apart) kept.push_back(p);
        if (curve_.points.size() > 1 && !curve_.closed && kept.size() > 1) kept.back() = curve_.points.back();
        curve_.points = std::move(kept);
    }

    /// Centres and gaps.
    void place_all(const Progress& progress) {
        parallel_for(curve_.points.size(), 64, progress.part(0, 0),
                     [&](std::size_t i) { place(curve_.points[i]); });
    }
    void place(PencilPoint& p) const {
        p.from = 0.5 * (p.touch[0] + p.touch[1]);
        const auto hit = in_.grid->first_hit(p.from, -p.up, scale_.reach);
        p.on_part = hit.has_value();
        if (!hit) return;
        p.center = p.from - hit->distance * p.up;
        p.gap = in_.cover->distance(p.center - p.tip);
    }

    std::size_t at(std::size_t i) const { return (first_ + i) % curve_.points.size(); }

    /// Length of the centres' polyline from one point to another.
    double length(std::size_t a, std::size_t b) const {
        const auto& p = curve_.points;
        double sum = 0;
        for (std::size_t i = a; i < b; ++i)
            sum += (p[at(i + 1)].center - p[at(i)].center).norm();
        return sum;
    }

    /// The points at which the cutter leaves too much in a valley.
    std::vector<char> good_points() const {
        const auto& p = curve_.points;
        const std::size_t n = p.size();
        std::vector<char> good(n);
        for (std::size_t i = 0; i < n; ++i)
            good[i] = p[i].on_part && rolls_[i] != Rolls::out && p[i].gap > in_.tolerance;
        for (std::size_t i = curve_.closed ? 0 : 1; i < n; ++i) {
            const std::size_t before = i > 0 ? i - 1 : n - 1;
            if (p[before].on_part && p[i].on_part && runs_back(p[before], p[i])) good[i] = good[before] = 0;
        }
        return good;
    }

    /// Ranges of good points, short interruptions bridged.
    std::vector<Range> ranges(const std::vector<char>& good) const {
        const auto& p = curve_.points;
        std::vector<Range> result;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!good[at(i)]) continue;
            bool bridge = !result.empty() && length(result.back()[1] - 1, i) <= in_.ripple;
            for (std::size_t k = bridge ? result.back()[1] : i; k < i; ++k)
                bridge = bridge && p[at(k)].on_part;
            if (bridge || (!result.empty() && result.back()[1] == i))
                result.back()[1] = i + 1;
            else
                result.push_back({i, i + 1});
        }
        return result;
    }

    std::vector<ValleyRun> runs() {
        const std::size_t n = curve_.points.size();
        const std::vector<char> good = good_points();
        // A closed curve is opened at its first bad place.
        if (curve_.closed) {
            const auto bad = std::find(good.begin(), good.end(), 0);
            if (bad != good.end()) first_ = std::size_t(bad - good.begin());
        }
        std::vector<ValleyRun> result;
        for (const auto& [a, b] : ranges(good)) {
            ValleyRun run;
            run.curve.closed = b - a == n && curve_.closed;
            if (length(a, b - 1) < in_.ripple && !run.curve.closed) continue;
            for (std::size_t i = a; i < b; ++i)
                run.curve.points.push_back(curve_.points[at(i)]);
            if (!run.curve.closed) go_to_borders(run.curve, a, b);
            run.open = {!curve_.closed && a == 0 && ends_[0] != CurveEnd::off_part,
                        !curve_.closed && b == n && ends_[1] != CurveEnd::off_part};
            result.push_back(std::move(run));
        }
        return result;
    }

    /// The touched points come to the border before the centre does.
    void go_to_borders(ValleyCurve& run, std::size_t a, std::size_t b) const {
        const auto rolls_at = [&](std::size_t i) { return rolls_[at(i)] != Rolls::no; };
        if (rolls_at(b - 1) || (b < curve_.points.size() && rolls_at(b))) go_to_border(run.points);
        if (rolls_at(a) || (a > 0 && rolls_at(a - 1))) {
            std::reverse(run.points.begin(), run.points.end());
            go_to_border(run.points);
            std::reverse(run.points.begin(), run.points.end());
        }
    }

    /// The last point's centre goes on straight over the surface to the part's border, if it is near.
    void go_to_border(std::vector<PencilPoint>& p) const {
        const PencilPoint end = p.back();
        Vec3 ahead = Vec3::Zero();
        for (std::size_t i = p.size(); i-- > 0 && ahead.norm() < scale_.fit;)
            ahead = end.center - p[i].center;
        if (ahead == Vec3::Zero()) return;
        ahead.normalize();
        std::vector<PencilPoint> more;
        double length = scale_.step;
        for (; length <= scale_.radius; length += scale_.step) {
            const auto q = moved_ahead(end, ahead, length);
            if (!q) break;
            more.push_back(*q);
        }
        if (length > scale_.radius) return; // no border there
        double lo = length - scale_.step, hi = length;
        std::optional<PencilPoint> last;
        while (hi - lo > ValleyScale::end_share * scale_.step) {
            const double mid = 0.5 * (lo + hi);
            const auto q = moved_ahead(end, ahead, mid);
            (q ? lo : hi) = mid;
            if (q) last = q;
        }
        p.insert(p.end(), more.begin(), more.end());
        if (last) p.push_back(*last);
    }

    /// A point moved straight ahead, its centre over the same surface; nothing where that has ended.
    std::optional<PencilPoint> moved_ahead(const PencilPoint& from, const Vec3& ahead, double length) const {
        PencilPoint q = from;
        for (Vec3* v : {&q.tip, &q.touch[0], &q.touch[1], &q.from})
            *v += length * ahead;
        const auto hit = in_.grid->first_hit(q.from, -q.up, scale_.reach);
        if (!hit) return std::nullopt;
        q.center = q.from - hit->distance * q.up;
        if ((q.center - from.center).norm() > same_surface * length) return std::nullopt;
        return q;
    }

    const ValleyInput& in_;
    ValleyScale scale_;
    ValleyCurve curve_;
    std::array<CurveEnd, 2> ends_;
    std::vector<Rolls> rolls_;
    std::size_t first_ = 0; ///< point at which a closed curve is opened
};

/// A cutter that rolls out over the end of a valley sees it once more: of runs that lie on each other the one
/// with the most points is kept.
void leave_out_doubles(std::vector<ValleyRun>& runs, double step) {
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return runs[a].curve.points.size() > runs[b].curve.points.size();
    });
    std::vector<char> keep(runs.size(), 1);
    PointGrid known(2 * step);
    for (const std::size_t r : order) {
        const auto& points = runs[r].curve.points;
        std::size_t same = 0;
        for (const PencilPoint& p : points)
            same += known.near_until(
                p.center, step, [&](std::size_t i) { return (known.points()[i] - p.center).norm() < step; });
        if (2 * same > points.size()) {
            keep[r] = 0;
            continue;
        }
        for (const PencilPoint& p : points)
            known.add(p.center);
    }
    std::vector<ValleyRun> kept;
    for (std::size_t r = 0; r < runs.size(); ++r)
        if (keep[r]) kept.push_back(std::move(runs[r]));
    runs = std::move(kept);
}

} // namespace

std::vector<ValleyRun> valley_runs(const ValleyInput& input, const std::vector<TracedValley>& traced,
                                   const Progress& progress) {
    std::vector<ValleyRun> runs;
    for (const TracedValley& t : traced) {
        for (ValleyRun& run : CurveRuns(input, t).run(progress))
            runs.push_back(std::move(run));
        progress.check();
    }
    leave_out_doubles(runs, ValleyScale(input).step);
    return runs;
}

} // namespace facetmill
