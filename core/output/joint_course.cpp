#include "core/output/joint_course.h"

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
/// Stops of one motion: both solutions, a few turns apart.
constexpr std::size_t max_stops = 12;
/// Share of the joint time that counts: a little, so that of courses that take as long the calmer one is
/// found.
constexpr double calm_share = 1e-3;
/// What a swing costs, s: more than any program takes without.
constexpr double swing_seconds = 1e9;

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

class Course {
public:
    Course(const ClSection& program, const Kinematics& kinematics, double largest_swing)
        : program_(program), motions_(program.motions.motions), kinematics_(kinematics),
          largest_swing_(largest_swing) {
        found_.at.resize(motions_.size());
        found_.held.resize(motions_.size());
    }

    JointCourse run(const Progress& progress) {
        for (std::size_t i = 0; i < motions_.size(); ++i) {
            if (i % check_every == 0) progress.set(double(i) / double(motions_.size()));
            add(i);
            if (layers_.size() == block_size || i + 1 == motions_.size()) decide(i);
        }
        return std::move(found_);
    }

private:
    /// Poses from which solutions are wound where nothing was held before: a turn to either side of an axis
    /// that ends somewhere.
    std::vector<Stop> seeds() const {
        const auto turns = [&](std::size_t axis) {
            const auto& rotary = kinematics_.machine().rotary;
            const bool ends = axis < rotary.size() && rotary[axis].travel.limited();
            return ends ? std::vector<double>{0, 2 * pi, -2 * pi} : std::vector<double>{0};
        };
        std::vector<Stop> all;
        for (const double first : turns(0))
            for (const double second : turns(1)) {
                Stop s;
                s.at.rotary = {first, second};
                all.push_back(s);
            }
        return all;
    }

    void add(std::size_t i) {
        const bool first = last_.empty();
        const std::vector<Stop> before = first ? seeds() : last_;
        const ToolPose pose{motions_[i].to.tip, motions_[i].to.axis};
        std::vector<Stop> here;
        for (const Stop& b : before) {
            const Kinematics::Solutions held = kinematics_.within_travel(pose, b.at);
            for (std::size_t k = 0; k < std::size_t(held.count); ++k) {
                const auto known = [&](const Stop& s) { return same_rotary(s.at, held.at[k]); };
                if (std::none_of(here.begin(), here.end(), known)) here.push_back({held.at[k], infinity, 0});
            }
        }
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

    /// The cheapest way to a stop. Ways without a swing are cheaper than all others, so of the ways in the
    /// order of their time the first without one is it.
    void relax(std::size_t i, Stop& to) const {
        const bool rapid = motions_[i].kind == MotionKind::rapid;
        const double feed = rapid ? 0.0 : feed_time(program_, i, motions_[i].to.tip - motions_[i - 1].to.tip);
        std::array<std::pair<double, std::uint32_t>, max_stops> routes;
        for (std::size_t k = 0; k < last_.size(); ++k) {
            const double joints = kinematics_.time(last_[k].at, to.at);
            routes[k] = {last_[k].cost + std::max(feed, joints) + calm_share * joints, std::uint32_t(k)};
        }
        std::sort(routes.begin(), routes.begin() + long(last_.size()));
        for (std::size_t k = 0; k < last_.size(); ++k) {
            const auto& [seconds, from] = routes[k];
            const double cost = seconds + (rapid || !swings(i, last_[from].at, to.at) ? 0.0 : swing_seconds);
            if (cost < to.cost) {
                to.cost = cost;
                to.from = from;
            }
            if (cost == seconds) return;
        }
    }

    bool swings(std::size_t i, const Joints& from, const Joints& to) const {
        if (!found_.held[i - 1]) return false;
        // Half the joints' way is the most that the tool can be off.
        double turned = 0;
        for (std::size_t r = 0; r < 2; ++r)
            turned += std::abs(to.rotary[r] - from.rotary[r]);
        return turned > largest_swing_
               && swing_between(kinematics_, from, to, motions_[i - 1].to.axis, motions_[i].to.axis,
                                largest_swing_)
                      > largest_swing_;
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

    const ClSection& program_;
    const std::vector<Motion>& motions_;
    const Kinematics& kinematics_;
    double largest_swing_;
    JointCourse found_;
    std::vector<std::vector<Stop>> layers_; ///< of the block
    std::vector<Stop> last_;
};

} // namespace

JointCourse find_joint_course(const ClSection& program, const Kinematics& kinematics, double largest_swing,
                              const Progress& progress) {
    return Course(program, kinematics, largest_swing).run(progress);
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

double feed_time(const ClSection& program, std::size_t motion, const Vec3& step) {
    return step.norm() / program.feed(motion) * 60.0;
}

} // namespace facetmill
