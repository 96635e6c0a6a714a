#include "core/strategy/five_axis/posture_path.h"

#include "core/base/parallel.h"
#include "core/base/plane_geometry.h"
#include "core/base/tolerances.h"
#include "core/cspace/joint_path.h"
#include "core/strategy/five_axis/even_motion.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// A motion between neighbouring contact points is halved this often at most.
constexpr int max_divisions = 6;
/// Places that a thread takes at a time: one takes some milliseconds.
constexpr std::size_t places_per_block = 4;
/// A run of free points shorter than this, in radii of the cutter, is left to clean-up with its neighbours.
constexpr double shortest_run_share = 0.1;

/// The share of the chord tolerance by which the routes of different machines between two stops may differ:
/// what motion_share and the looks between places leave of it.
constexpr double even_share = 0.25;

struct Stop {
    ContactPlace place;
    PostureValue posture;
    CutterLocation cl;
    double cusp = 0; ///< what it leaves over its strip, mm, without the chord's share
};

/// From one contact place to the next.
struct Gap {
    bool closed = false;
    std::vector<Stop> between; ///< further stops on the motion
};

class Joiner {
public:
    Joiner(const FiveAxisField& field, const PlacedLine& line)
        : field_(field), line_(line), clock_(&field.kinematics(), field.settings().feed) {}

    Stop stop(const ContactPlace& place, const PostureValue& posture) const {
        const ToolPose pose = posture_pose(field_.cutter(), place.frame, posture);
        return {place, posture, {pose.tip, pose.axis}};
    }

    bool keeps_clear(const CutterLocation& a, const CutterLocation& b) {
        return keeps_clear_between(field_.lift(), a, b, looking_step(field_.radius(), field_.chord()),
                                   field_.settings().motion_share * field_.chord(), hint_);
    }

    /// Appends the stops that the motion from a to b needs; false where it cannot be made free.
    bool between(const Stop& a, const Stop& b, int divisions, std::vector<Stop>& stops) {
        const double angle = std::acos(std::clamp(a.cl.axis.dot(b.cl.axis), -1.0, 1.0));
        const bool turns_little = angle <= field_.settings().turn_limit * (1 + tolerance::level_angle);
        const ContactPlace middle = place_between(a.place, b.place, 0.5);
        const bool clear = keeps_clear(a.cl, b.cl);
        if (turns_little && clear && clears(a, b, 0.5 * field_.chord())) return true;
        // So near to each other, what the two do not hold between them is narrower than a hair.
        if (divisions == max_divisions) return turns_little && clear;
        Stop at;
        std::vector<Stop> first, second;
        if (!halfway(a, b, middle, at) || !between(a, at, divisions + 1, first)
            || !between(at, b, divisions + 1, second))
            return turns_little && clear && clears(a, b, field_.chord());
        stops.insert(stops.end(), first.begin(), first.end());
        stops.push_back(at);
        stops.insert(stops.end(), second.begin(), second.end());
        return true;
    }

    /// The run with further stops on its motions, where machines would go different ways between two of them
    /// (even_motion.h). The motions stay as they were checked.
    std::vector<Stop> evened(const std::vector<Stop>& run) const {
        const EvenMotion motion(field_.kinematics(), field_.radius(), even_share * field_.chord());
        std::vector<Stop> all;
        for (std::size_t i = 0; i < run.size(); ++i) {
            if (i > 0) {
                const Stop &a = run[i - 1], &b = run[i];
                for (const double t : motion.cuts(a.cl, b.cl)) {
                    const CutterLocation on = location_on_route(a.cl, b.cl, t);
                    all.push_back({place_between(a.place, b.place, t), a.posture, on, 0});
                }
            }
            all.push_back(run[i]);
        }
        return all;
    }

private:
    ContactPlace place_between(const ContactPlace& a, const ContactPlace& b, double t) const {
        ContactPlace p = field_.place(line_.line, a.s + t * (b.s - a.s), a.v, line_.travel);
        p.v_lo = a.v_lo + t * (b.v_lo - a.v_lo);
        p.v_hi = a.v_hi + t * (b.v_hi - a.v_hi);
        return p;
    }

    /// Whether the tool, on the motion too, holds a point of every line that it has to clear there, but for
    /// `slack`.
    bool clears(const Stop& a, const Stop& b, double slack) const {
        for (const double t : {0.5, 0.25, 0.75}) {
            const CutterLocation on = location_on_route(a.cl, b.cl, t);
            const auto curves = field_.strip_curves(place_between(a.place, b.place, t));
            if (!field_.builder().reaches(ToolPose{on.tip, on.axis}, curves, -slack)) return false;
        }
        return true;
    }

    /// The posture at a place with the axis at which the machine's joints are half-way.
    PostureValue between_joints(const Stop& a, const Stop& b, const ContactPlace& middle) const {
        const Stand from = clock_.stand({a.cl.tip, a.cl.axis}, nullptr),
                    to = clock_.stand({b.cl.tip, b.cl.axis}, &from);
        return posture_of_axis(middle.frame, clock_.axis_between(from.joints, to.joints, 0.5));
    }

    /// A free posture half-way: where the joints are, or where that is not free the one between the two or
    /// the nearest on a small grid.
    bool halfway(const Stop& a, const Stop& b, const ContactPlace& middle, Stop& at) {
        const auto& settings = field_.settings();
        const auto curves = field_.strip_curves(middle);
        const auto is_free = [&](double to_lead, double to_yaw) {
            PostureValue p;
            p.lead = std::clamp(to_lead, settings.lead_limits[0], settings.lead_limits[1]);
            p.yaw = std::clamp(to_yaw, settings.yaw_limits[0], settings.yaw_limits[1]);
            const double bottom = field_.builder().bottom(middle.frame, p.lead, p.yaw, hint_);
            const double top = field_.builder().top(middle.frame, p.lead, p.yaw, curves);
            if (!(bottom <= top)) return false;
            p.delta = std::clamp(0.5 * (a.posture.delta + b.posture.delta), bottom, top);
            if (!field_.builder().holds(middle.frame, p)) return false;
            at = stop(middle, p);
            return true;
        };
        const PostureValue even = between_joints(a, b, middle);
        if (is_free(even.lead, even.yaw)) return true;
        const double lead = 0.5 * (a.posture.lead + b.posture.lead);
        const double yaw = 0.5 * (a.posture.yaw + b.posture.yaw);
        const double step = settings.grid_step;
        constexpr std::array<std::array<int, 2>, 9> around{
            {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
        for (const double scale : {0.5, 1.0})
            for (const auto& [i, k] : around)
                if (is_free(lead + i * scale * step, yaw + k * scale * step)) return true;
        return on_grid(a, b, middle, curves, at);
    }

    /// The free node whose axis is nearest to both.
    bool on_grid(const Stop& a, const Stop& b, const ContactPlace& middle,
                 const std::vector<RaisedCurve>& curves, Stop& at) {
        const CSpace space = field_.builder().build(middle.frame, curves);
        const PostureGrid& grid = field_.grid();
        double nearest = -1;
        for (std::size_t l = 0; l < grid.lead.size(); ++l)
            for (std::size_t o = 0; o < grid.yaw.size(); ++o) {
                const std::size_t n = grid.node(l, o);
                if (space.block[n] != PostureBlock::free) continue;
                const Vec3 axis = posture_axis(middle.frame, grid.lead[l], grid.yaw[o]);
                const double cosine = std::min(axis.dot(a.cl.axis), axis.dot(b.cl.axis));
                if (cosine <= nearest) continue;
                nearest = cosine;
                at = stop(middle, {grid.lead[l], grid.yaw[o], space.bottom[n]});
            }
        return nearest > a.cl.axis.dot(b.cl.axis);
    }

    const FiveAxisField& field_;
    const PlacedLine& line_;
    MoveClock clock_;
    ToolLift::Hint hint_;
};

} // namespace

CutterLocation location_on_route(const CutterLocation& a, const CutterLocation& b, double t) {
    CutterLocation at;
    at.tip = a.tip + t * (b.tip - a.tip);
    const double angle = angle_between(a.axis, b.axis);
    if (angle < tolerance::level_angle) {
        at.axis = (a.axis + t * (b.axis - a.axis)).normalized();
    } else {
        const double over = 1 / std::sin(angle);
        at.axis =
            (std::sin((1 - t) * angle) * over * a.axis + std::sin(t * angle) * over * b.axis).normalized();
    }
    return at;
}

double looking_step(double radius, double chord) {
    return std::sqrt(chord * radius);
}

bool keeps_clear_between(const ToolLift& lift, const CutterLocation& a, const CutterLocation& b, double step,
                         double limit, ToolLift::Hint& hint) {
    const double turned = (b.axis - a.axis).norm() * lift.cutter().max_radius();
    const double distance = (b.tip - a.tip).norm() + turned;
    constexpr int least = 4, most = 256, max_halvings = 6, sure_halvings = 2;
    // A lift that grows faster than this belongs to a wall, which the rim does not pass within a step unless
    // one of the step's ends is in it.
    constexpr double steepest = 2;
    const int pieces = distance < most * step ? std::max(least, int(std::ceil(distance / step))) : most;
    const auto lift_at = [&](double t) {
        const CutterLocation at = location_on_route(a, b, t);
        return lift.lift({at.tip, at.axis}, hint);
    };
    const auto between = [&](const auto& self, double t0, double l0, double t1, double l1,
                             int halvings) -> bool {
        // Alike: in touch with the same round place from end to end, or clear; but for edges between, which
        // the rim passes within a part of a step.
        const bool alike = halvings <= max_halvings - sure_halvings && std::abs(l1 - l0) <= 0.5 * limit;
        if (halvings == 0 || alike) return true;
        if (std::max(l0, l1) < -steepest * distance * (t1 - t0)) return true;
        const double t = 0.5 * (t0 + t1), l = lift_at(t);
        return l <= limit && self(self, t0, l0, t, l, halvings - 1) && self(self, t, l, t1, l1, halvings - 1);
    };
    double last = lift_at(0);
    for (int k = 1; k <= pieces; ++k) {
        const double t = double(k) / pieces, here = lift_at(t);
        if (k < pieces && here > limit) return false;
        if (!between(between, double(k - 1) / pieces, last, t, here, max_halvings)) return false;
        last = here;
    }
    return true;
}

double posture_cusp(const FiveAxisField& field, const ContactPlace& place, const PostureValue& posture) {
    const auto curves = field.strip_curves(place);
    const double top = field.builder().top(place.frame, posture.lead, posture.yaw, curves);
    const double margin = (top - posture.delta) * std::cos(posture.lead);
    return std::max(field.cusp() - field.chord() - margin, 0.0);
}

JoinedPasses join_postures(const FiveAxisField& field, const PlacedLine& line, const Progress& progress) {
    JoinedPasses result;
    Joiner joiner(field, line);
    std::vector<Stop> stops(line.places.size());
    std::vector<Gap> gaps(line.places.size()); // before each place
    parallel_for(stops.size(), places_per_block, progress.part(0, 0), [&](std::size_t i) {
        if (!line.choices[i].free) return;
        Joiner own(field, line);
        stops[i] = own.stop(line.places[i], line.choices[i].posture);
        stops[i].cusp = posture_cusp(field, stops[i].place, stops[i].posture);
        if (i == 0 || !line.choices[i - 1].free) return;
        gaps[i].closed = own.between(own.stop(line.places[i - 1], line.choices[i - 1].posture), stops[i], 0,
                                     gaps[i].between);
        for (Stop& s : gaps[i].between)
            s.cusp = posture_cusp(field, s.place, s.posture);
    });
    std::vector<Stop> run;
    std::size_t begin = 0; // the place that the run began with
    // Beyond the end of the surface a place is there for what its pose would have held on the border.
    const auto on_part = [&](const ContactPlace& place) -> CutterContact {
        const double s = std::clamp(place.s, 0.0, line.line.length());
        if (s == place.s) return {place.surface, place.frame.normal};
        const SlicePoint end = line.line.at(s);
        return {end.point, end.normal};
    };
    const auto finish = [&](std::size_t end) {
        if (run.empty()) return;
        double length = 0;
        for (std::size_t i = 1; i < run.size(); ++i)
            length += (run[i].place.surface - run[i - 1].place.surface).norm();
        if (length < shortest_run_share * field.radius()) {
            for (const Stop& s : run)
                result.uncut.push_back(on_part(s.place));
        } else {
            Pass pass;
            for (const Stop& s : joiner.evened(run)) {
                pass.cc.push_back({s.place.surface, s.place.frame.normal});
                pass.cl.push_back(s.cl);
                result.cusp = std::max(result.cusp, s.cusp);
                result.lead_min = std::min(result.lead_min, s.posture.lead);
                result.lead_max = std::max(result.lead_max, s.posture.lead);
            }
            if (line.before && begin == 0) {
                const Stop further = joiner.stop(*line.before, run.front().posture);
                if (joiner.keeps_clear(further.cl, run.front().cl)) {
                    pass.cc.insert(pass.cc.begin(), {further.place.surface, further.place.frame.normal});
                    pass.cl.insert(pass.cl.begin(), further.cl);
                }
            }
            if (line.after && end == line.places.size()) {
                const Stop further = joiner.stop(*line.after, run.back().posture);
                if (joiner.keeps_clear(run.back().cl, further.cl)) {
                    pass.cc.push_back({further.place.surface, further.place.frame.normal});
                    pass.cl.push_back(further.cl);
                }
            }
            result.passes.push_back(std::move(pass));
        }
        run.clear();
    };
    for (std::size_t i = 0; i < line.places.size(); ++i) {
        if (!line.choices[i].free) {
            finish(i);
            result.uncut.push_back(on_part(line.places[i]));
            continue;
        }
        if (!run.empty()) {
            if (gaps[i].closed) {
                run.insert(run.end(), gaps[i].between.begin(), gaps[i].between.end());
            } else {
                // What lies between the two is cut by neither.
                CutterContact middle = on_part(run.back().place);
                middle.point = 0.5 * (middle.point + on_part(stops[i].place).point);
                finish(i);
                result.uncut.push_back(middle);
            }
        }
        if (run.empty()) begin = i;
        run.push_back(stops[i]);
    }
    finish(line.places.size());
    return result;
}

} // namespace facetmill
