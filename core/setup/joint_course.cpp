#include "core/setup/joint_course.h"

#include "core/base/plane_geometry.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace facetmill {

namespace {

constexpr std::size_t check_every = 512;
/// Motions that are decided together.
constexpr std::size_t block_size = 16384;
/// Beyond it a rapid is waited for, this many blocks at most: within a run joints may need all of its length.
constexpr std::size_t blocks_to_rapid = 8;
/// Stops of one motion: both solutions, a few turns apart.
constexpr std::size_t max_stops = 24;
/// Share of the joint time that counts: a little, so that of courses that take as long the calmer one is
/// found.
constexpr double calm_share = 1e-3;
/// What a swing costs, s: more than any program takes without; and what smaller ones cost by their size, s
/// per radian. Motions that go on as they should stray alike whichever way the machine stands.
constexpr double swing_seconds = 1e9, stray_seconds = 5e6;
/// What it costs to turn over at feed where the tool hardly strays, and in a rapid beside the part, s: less
/// than to stray, more than to do it between two rapids.
constexpr double turned_over_seconds = 1000, beside_part_seconds = 100;
/// Joints that turn by less together do not stray by anything that counts.
constexpr double no_turn = 2e-5; // radians
/// A tool that strays by less than this of what is a swing does not swing between the places looked at.
constexpr double look_for_swing = 0.5;

/// Rotary axes are looked at every so far; and no more than this, whatever the machine turns.
constexpr double look_every = pi / 8, max_turned = 100 * pi;

struct Stop {
    Joints at;
    double cost = infinity;
    std::uint32_t from = 0; ///< of the stops of the motion before
};

/// Solutions of one pose that are closer than this are one, wound from different sides; radians.
constexpr double same_angle = tolerance::level_angle;

bool same_rotary(const Joints& a, const Joints& b) {
    return std::abs(a.rotary[0] - b.rotary[0]) < same_angle
           && std::abs(a.rotary[1] - b.rotary[1]) < same_angle;
}

/// How far, at most of three places, the tool axis is from the great circle between its ends while the joints
/// move evenly; a distance of unit vectors. From `enough` on it is not looked at closer.
double strays_by(const Kinematics& kinematics, const Joints& from, const Joints& to, const Vec3& a,
                 const Vec3& b, double enough) {
    const double angle = angle_between(a, b), sine = std::sin(angle);
    double off = 0;
    for (const double t : {0.5, 0.25, 0.75}) {
        if (off > enough) break;
        Joints at;
        for (std::size_t r = 0; r < 2; ++r)
            at.rotary[r] = from.rotary[r] + t * (to.rotary[r] - from.rotary[r]);
        const Vec3 on = sine > tolerance::level_angle
                            ? Vec3((std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / sine)
                            : Vec3(a + t * (b - a));
        off = std::max(off, (kinematics.forward(at).axis - on).norm());
    }
    return off;
}

void add_stance(const Joints& stance, std::vector<Joints>& found) {
    if (std::none_of(found.begin(), found.end(), [&](const Joints& w) { return same_rotary(w, stance); }))
        found.push_back(stance);
}

class Course {
public:
    Course(std::span<const Motion> motions, std::span<const double> feed_seconds,
           const Kinematics& kinematics, double largest_swing)
        : motions_(motions), feed_seconds_(feed_seconds), kinematics_(kinematics),
          largest_swing_(largest_swing) {
        found_.at.resize(motions_.size());
        found_.held.resize(motions_.size());
    }

    JointCourse run(const Progress& progress) {
        for (std::size_t i = 0; i < motions_.size(); ++i) {
            if (i % check_every == 0) progress.set(double(i) / double(motions_.size()));
            add(i);
            const bool whole = layers_.size() >= block_size && (rapid(i) || layers_.size() >= max_block);
            if (whole || i + 1 == motions_.size()) decide(i);
        }
        return std::move(found_);
    }

private:
    static constexpr std::size_t max_block = blocks_to_rapid * block_size;

    bool rapid(std::size_t i) const { return motions_[i].kind == MotionKind::rapid; }

    std::vector<Stop> stops(std::size_t i) const {
        const ToolPose pose{motions_[i].to.tip, motions_[i].to.axis};
        std::vector<Joints> found;
        for (const Stop& b : last_) {
            const Kinematics::Solutions held = kinematics_.within_travel(pose, b.at);
            for (std::size_t k = 0; k < std::size_t(held.count); ++k)
                add_stance(held.at[k], found);
        }
        if (last_.empty() || rapid(i))
            for (const Joints& stance : stances(kinematics_, pose))
                add_stance(stance, found);
        std::vector<Stop> all;
        for (const Joints& stance : found)
            all.push_back({stance, infinity, 0});
        return all;
    }

    void add(std::size_t i) {
        const bool first = last_.empty();
        std::vector<Stop> here = stops(i);
        found_.held[i] = !here.empty();
        if (here.empty()) {
            // Nothing moves until a pose can be held again.
            here = first ? std::vector<Stop>{Stop{{}, 0, 0}} : last_;
            for (std::size_t k = 0; k < here.size(); ++k)
                here[k].from = std::uint32_t(k);
        } else {
            for (Stop& s : here)
                if (first)
                    s.cost = calm_share * kinematics_.time(Joints{}, s.at);
                else
                    relax(i, s);
            drop_turns(here);
            if (here.size() > max_stops) {
                std::stable_sort(here.begin(), here.end(),
                                 [](const Stop& a, const Stop& b) { return a.cost < b.cost; });
                here.resize(max_stops);
            }
        }
        layers_.push_back(here);
        last_ = std::move(here);
    }

    /// The cheapest of those stops that differ by whole turns of an axis that goes round and round: it is
    /// enough.
    void drop_turns(std::vector<Stop>& stops) const {
        const auto& rotary = kinematics_.machine().rotary;
        const auto same = [&](const Stop& a, const Stop& b) {
            for (std::size_t r = 0; r < rotary.size(); ++r) {
                const double d = a.at.rotary[r] - b.at.rotary[r];
                const double turns = rotary[r].travel.limited() ? 0 : std::round(d / (2 * pi));
                if (std::abs(d - 2 * pi * turns) > same_angle) return false;
            }
            return true;
        };
        std::vector<Stop> kept;
        for (const Stop& s : stops) {
            const auto twin =
                std::find_if(kept.begin(), kept.end(), [&](const Stop& k) { return same(s, k); });
            if (twin == kept.end())
                kept.push_back(s);
            else if (s.cost < twin->cost)
                *twin = s;
        }
        stops = std::move(kept);
    }

    /// The cheapest way to a stop: asked in the order of their time, until time alone is more than the best.
    void relax(std::size_t i, Stop& to) const {
        const double feed = rapid(i) || feed_seconds_.empty() ? 0.0 : feed_seconds_[i];
        std::array<std::pair<double, std::uint32_t>, max_stops> routes;
        for (std::size_t k = 0; k < last_.size(); ++k) {
            const double joints = kinematics_.time(last_[k].at, to.at);
            routes[k] = {last_[k].cost + std::max(feed, joints) + calm_share * joints, std::uint32_t(k)};
        }
        std::sort(routes.begin(), routes.begin() + long(last_.size()));
        for (std::size_t k = 0; k < last_.size(); ++k) {
            const auto& [seconds, from] = routes[k];
            if (seconds >= to.cost) return;
            const double cost = seconds + strayed(i, last_[from].at, to.at, to.cost - seconds);
            if (cost < to.cost) {
                to.cost = cost;
                to.from = from;
            }
        }
    }

    /// What it costs that the tool is not on its path during a motion; where it is more than `enough`, that
    /// it is.
    double strayed(std::size_t i, const Joints& from, const Joints& to, double enough) const {
        if (!found_.held[i - 1]) return 0;
        // All of the joints' way is the most that the tool can be off.
        const double turned =
            std::abs(to.rotary[0] - from.rotary[0]) + std::abs(to.rotary[1] - from.rotary[1]);
        if (turned < no_turn) return 0;
        const bool beside_part = !rapid(i - 1) || (i + 1 < motions_.size() && !rapid(i + 1));
        if (rapid(i) && (!beside_part || turned <= largest_swing_)) return 0;
        const Vec3 &a = motions_[i - 1].to.axis, &b = motions_[i].to.axis;
        const double too_far = enough * (1 + tolerance::figure_rounding) / stray_seconds;
        const double off = strays_by(kinematics_, from, to, a, b, rapid(i) ? infinity : too_far);
        if (!rapid(i) && off > too_far) return infinity;
        if (rapid(i)) return off > largest_swing_ || turns_over(from, to) ? beside_part_seconds : 0;
        const bool swings = off > look_for_swing * largest_swing_
                            && swing_between(kinematics_, from, to, a, b, largest_swing_) > largest_swing_;
        return (swings ? swing_seconds : 0) + stray_seconds * off
               + (turns_over(from, to) ? turned_over_seconds : 0);
    }

    /// Fixes the motions of the block that ends with motion `end`; the next one starts from there.
    void decide(std::size_t end) {
        const auto cheapest = std::min_element(last_.begin(), last_.end(),
                                               [](const Stop& a, const Stop& b) { return a.cost < b.cost; });
        auto k = std::size_t(cheapest - last_.begin());
        for (std::size_t n = layers_.size(); n-- > 0;) {
            const Stop& s = layers_[n][k];
            found_.at[end + 1 - layers_.size() + n] = s.at;
            k = s.from;
        }
        layers_.clear();
        last_ = {*cheapest};
        last_.front().cost = 0;
    }

    std::span<const Motion> motions_;
    std::span<const double> feed_seconds_;
    const Kinematics& kinematics_;
    double largest_swing_;
    JointCourse found_;
    std::vector<std::vector<Stop>> layers_; ///< of the block
    std::vector<Stop> last_;
};

} // namespace

JointCourse find_joint_course(std::span<const Motion> motions, std::span<const double> feed_seconds,
                              const Kinematics& kinematics, double largest_swing, const Progress& progress) {
    return Course(motions, feed_seconds, kinematics, largest_swing).run(progress);
}

std::vector<Joints> stances(const Kinematics& kinematics, const ToolPose& pose) {
    const auto turns = [&](std::size_t axis) {
        const auto& rotary = kinematics.machine().rotary;
        const bool ends = axis < rotary.size() && rotary[axis].travel.limited();
        return ends ? std::vector<double>{0, 2 * pi, -2 * pi} : std::vector<double>{0};
    };
    std::vector<Joints> found;
    for (const double first : turns(0))
        for (const double second : turns(1)) {
            const auto held = kinematics.within_travel(pose, Joints{Vec3::Zero(), {first, second}});
            for (std::size_t k = 0; k < std::size_t(held.count); ++k)
                add_stance(held.at[k], found);
        }
    return found;
}

bool turns_over(const Joints& from, const Joints& to) {
    constexpr double half_turn = pi * (1 + tolerance::figure_rounding);
    return std::abs(to.rotary[0] - from.rotary[0]) > half_turn
           || std::abs(to.rotary[1] - from.rotary[1]) > half_turn;
}

double swing_between(const Kinematics& kinematics, const Joints& from, const Joints& to,
                     const Vec3& axis_from, const Vec3& axis_to, double enough) {
    const Vec3 sum = axis_from + axis_to;
    if (kinematics.rotary_axes() == 0 || !(sum.norm() > tolerance::unit_axis)) return 0; // there is no middle
    double turned = 0;
    for (std::size_t r = 0; r < 2; ++r)
        turned += std::abs(to.rotary[r] - from.rotary[r]);
    // Half-way is where axes stray most, but after whole turns they are back in the middle there.
    const int pieces = 2 * int(std::ceil(std::min(turned, max_turned) / (2 * look_every)) + 1);
    const double middle = 0.5 * angle_between(axis_from, axis_to);
    double most = 0;
    for (int k = 1; k < pieces && most - middle <= enough; ++k) {
        const double t = double(k) / pieces;
        Joints at;
        at.linear = from.linear + t * (to.linear - from.linear);
        for (std::size_t r = 0; r < 2; ++r)
            at.rotary[r] = from.rotary[r] + t * (to.rotary[r] - from.rotary[r]);
        most = std::max(most, angle_between(kinematics.forward(at).axis, sum));
    }
    return most - middle;
}

} // namespace facetmill
