#include "core/strategy/cleanup/valley_trace.h"

#include "core/base/tolerances.h"
#include "core/strategy/cleanup/pencil_probe.h"
#include "core/strategy/cleanup/valley_scale.h"
#include "core/strategy/surface/point_grid.h"

#include <optional>

namespace facetmill {

namespace {

/// Places asked on the half circle ahead of a point, and on the ring around a seed.
constexpr int arc_samples = 13, ring_samples = 24;
constexpr int arc_halvings = 16;
/// After so many steps beyond a place where it was lost a curve has not ended.
constexpr int steps_to_go_on = 4;
constexpr std::size_t max_steps = 200000;
/// The tip rises and falls along a steep valley: a step longer than this, in space, is taken again with a
/// smaller arc, and after one shorter than this the arc grows again.
constexpr double longest_step = 1.6, shortest_step = 0.6, arc_growth = 1.5;
/// A curve is closed where it has come back to its start, nearer than this many steps, after so many points.
constexpr double closing_steps = 0.75;
constexpr std::size_t closing_points = 8;
/// A curve joins another, and a seed is on one, within this many steps.
constexpr double joining_steps = 0.5, known_steps = 1.2;
/// It joins itself where it comes back to a place that it passed so many steps before: round and round a
/// pocket that it did not start in.
constexpr double own_steps = 4;

class ValleyTracer {
public:
    explicit ValleyTracer(const ValleyInput& input)
        : in_(input), probe_(input), scale_(input), done_(scale_.step) {}

    std::vector<TracedValley> run(const std::vector<PencilSeed>& seeds, const Progress& progress) {
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            progress.set(double(i) / double(seeds.size()));
            const double known = known_steps * scale_.step;
            if (near_done(seeds[i].about, known)) continue;
            const auto seed = pencil_at(probe_, seeds[i]);
            if (!seed || near_done(*seed, known)) continue;
            if (auto valley = follow(*seed, progress)) keep(std::move(*valley));
        }
        return std::move(valleys_);
    }

private:
    struct Trace {
        std::vector<PencilPoint> points;
        bool closed = false;
        CurveEnd end = CurveEnd::lost;
    };
    struct Jump {
        double angle = 0;
        PencilPoint point;
    };

    /// All jumps on an arc about a place, counter-clockwise.
    std::vector<Jump> jumps(const Vec2& about, double rho, double from, double to, int samples) const {
        LiftHint hint;
        const auto on_arc = [&](double angle) {
            return probe_.touch_at(about + rho * Vec2(std::cos(angle), std::sin(angle)), hint);
        };
        std::vector<Jump> found;
        CutterTouch last = on_arc(from);
        double angle = from;
        for (int k = 1; k < samples; ++k) {
            const double next_angle = from + (to - from) * k / (samples - 1);
            const CutterTouch next = on_arc(next_angle);
            if (last.valid && next.valid)
                if (const auto jump = probe_.jump(on_arc, angle, next_angle, last, next, arc_halvings)) {
                    // Going on along the arc's radius, what comes later is on the left.
                    Jump f;
                    f.point = probe_.pencil((*jump)[1], (*jump)[0]);
                    const Vec2 d = f.point.tip.head<2>() - about;
                    f.angle = std::atan2(d.y(), d.x());
                    found.push_back(f);
                }
            last = next;
            angle = next_angle;
        }
        return found;
    }

    /// Where the curve through `last` goes on, on the half circle ahead of it: the jump between the same
    /// flanks.
    std::optional<Jump> next_on_curve(const PencilPoint& last, double rho, double heading) const {
        std::optional<Jump> best;
        double least = PencilProbe::max_move;
        for (const Jump& f :
             jumps(last.tip.head<2>(), rho, heading - 0.5 * pi, heading + 0.5 * pi, arc_samples))
            if (const double m = probe_.moved(f.point, last); m <= least) {
                least = m;
                best = f;
            }
        return best;
    }

    /// The way that a curve has come, to see where it comes back to it.
    class OwnRoute {
    public:
        explicit OwnRoute(const ValleyTracer& tracer) : tracer_(tracer), seen_(tracer.scale_.step) {}
        /// Has the curve been where its last point is? Asked for each point once.
        bool comes_back(const std::vector<PencilPoint>& points) {
            const PencilPoint& last = points.back();
            const double step = tracer_.scale_.step, within = joining_steps * step;
            if (points.size() > 1) length_ += (last.tip - points[points.size() - 2].tip).norm();
            const bool back = seen_.near_until(last.tip, within, [&](std::size_t i) {
                return length_ - lengths_[i] > own_steps * step && tracer_.is_same(points[i], last, within);
            });
            seen_.add(last.tip);
            lengths_.push_back(length_);
            return back;
        }

    private:
        const ValleyTracer& tracer_;
        PointGrid seen_;
        std::vector<double> lengths_; ///< from the start to each point
        double length_ = 0;
    };

    /// Follows the curve from `start`, whose left and right are those of going along `heading`.
    Trace trace(const PencilPoint& start, double heading, const Progress& progress) const {
        Trace t;
        t.points.push_back(start);
        double rho = scale_.step, stop = 0;
        std::optional<Vec3> lost_at;
        bool ending = false;
        int passed = 0; // steps since the curve was lost
        OwnRoute route(*this);
        route.comes_back(t.points);
        while (t.points.size() < max_steps) {
            progress.check();
            const PencilPoint& last = t.points.back();
            const auto next = next_on_curve(last, rho, heading);
            if (!next) {
                // Steps become shorter from here on, until it is clear that the curve goes on.
                if (!ending) {
                    // Found again and lost again on the spot, it would be followed for ever.
                    if (lost_at && (last.tip - *lost_at).norm() < ValleyScale::end_share * scale_.step)
                        return t;
                    lost_at = last.tip;
                    stop = ValleyScale::end_share * rho;
                }
                ending = true;
                passed = 0;
                rho *= 0.5;
                if (rho < stop) return t;
                continue;
            }
            const double length = (next->point.tip - last.tip).norm();
            if (length > longest_step * scale_.step && rho > tolerance::lift_accuracy * scale_.radius) {
                rho *= 0.5;
                continue;
            }
            if (ending && ++passed == steps_to_go_on) ending = false;
            heading = next->angle;
            t.points.push_back(next->point);
            if (near_done(next->point, joining_steps * scale_.step)) {
                t.end = CurveEnd::joined;
                return t;
            }
            if (has_come_round(t, start)) {
                t.closed = true;
                t.points.pop_back();
                return t;
            }
            if (route.comes_back(t.points)) {
                t.end = CurveEnd::joined;
                return t;
            }
            if (!is_on_part(t.points.back())) {
                t.end = CurveEnd::off_part;
                return t;
            }
            if (!ending && length < shortest_step * scale_.step)
                rho = std::min(arc_growth * rho, scale_.step);
        }
        return t;
    }

    bool has_come_round(const Trace& t, const PencilPoint& start) const {
        const PencilPoint& last = t.points.back();
        return t.points.size() > closing_points && (last.tip - start.tip).norm() < closing_steps * scale_.step
               && probe_.moved(last, start) < PencilProbe::max_move;
    }

    /// A first look, without the fit.
    bool is_on_part(const PencilPoint& p) const {
        const Vec3 up = p.normal[0] + p.normal[1];
        if (up.norm() < tolerance::level_angle) return true;
        return in_.grid->first_hit(0.5 * (p.touch[0] + p.touch[1]), -up.normalized(), scale_.reach)
            .has_value();
    }

    /// Are both between the same flanks, and so near to each other?
    bool is_same(const PencilPoint& q, const PencilPoint& p, double within) const {
        if ((q.tip - p.tip).norm() > within) return false;
        return probe_.moved(p, q) < PencilProbe::max_move
               || probe_.moved(p, turned_round(q)) < PencilProbe::max_move;
    }

    /// Is a finished curve between the same flanks so near?
    bool near_done(const PencilPoint& p, double within) const {
        return done_.near_until(p.tip, within, [&](std::size_t i) {
            const auto [valley, point] = all_[i];
            return is_same(valleys_[valley].curve.points[point], p, within);
        });
    }

    /// The two directions along the curve from a seed. A ring about it crosses the curve twice; on one side
    /// maybe a smaller one only, where another curve is near.
    std::array<std::optional<double>, 2> headings(const PencilPoint& seed, const PencilPoint& turned) const {
        std::array<std::optional<double>, 2> heading;
        for (double rho = scale_.step;
             rho > ValleyScale::end_share * scale_.step && !(heading[0] && heading[1]); rho *= 0.5) {
            const auto ring = jumps(seed.tip.head<2>(), rho, -pi, pi, ring_samples);
            for (const std::size_t side : {0, 1}) {
                if (heading[side]) continue;
                double least = PencilProbe::max_move;
                for (const Jump& f : ring)
                    if (const double m = probe_.moved(f.point, side == 0 ? seed : turned); m < least) {
                        least = m;
                        heading[side] = f.angle;
                    }
            }
        }
        return heading;
    }

    /// The curve through a seed, to both sides of it.
    std::optional<TracedValley> follow(const PencilPoint& seed, const Progress& progress) const {
        const PencilPoint turned = turned_round(seed);
        const auto heading = headings(seed, turned);
        if (!heading[0] && !heading[1]) return std::nullopt;
        Trace ahead, back;
        if (heading[0]) ahead = trace(seed, *heading[0], progress);
        if (heading[1] && !ahead.closed) back = trace(turned, *heading[1], progress);
        TracedValley valley;
        valley.ends = {back.end, ahead.end};
        if (ahead.closed) {
            valley.curve.closed = true;
            valley.curve.points = std::move(ahead.points);
            return valley;
        }
        auto& points = valley.curve.points;
        for (std::size_t k = back.points.size(); k-- > 1;)
            points.push_back(turned_round(back.points[k]));
        if (ahead.points.empty()) ahead.points.push_back(seed);
        points.insert(points.end(), ahead.points.begin(), ahead.points.end());
        return valley;
    }

    void keep(TracedValley valley) {
        const auto& points = valley.curve.points;
        for (std::size_t k = 0; k < points.size(); ++k) {
            done_.add(points[k].tip);
            all_.push_back({std::uint32_t(valleys_.size()), std::uint32_t(k)});
        }
        valleys_.push_back(std::move(valley));
    }

    const ValleyInput& in_;
    PencilProbe probe_;
    ValleyScale scale_;
    std::vector<TracedValley> valleys_;
    std::vector<std::array<std::uint32_t, 2>> all_; ///< points of all finished curves: which, and where
    PointGrid done_;                                ///< their tips
};

} // namespace

std::vector<TracedValley> trace_valleys(const ValleyInput& input, const std::vector<PencilSeed>& seeds,
                                        const Progress& progress) {
    return ValleyTracer(input).run(seeds, progress);
}

} // namespace facetmill
