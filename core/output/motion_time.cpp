#include "core/output/motion_time.h"

#include "core/base/tolerances.h"
#include "core/setup/joint_course.h"

#include <cmath>

namespace facetmill {

Vec3 program_part_origin(const ClSection& program, const Machine& machine, const MotionTimeOptions& options) {
    if (options.part_origin) return *options.part_origin;
    Box3 box = program.part_box;
    if (box.empty())
        for (const Motion& m : program.motions.motions)
            box.add(m.to.tip);
    if (const auto& turning = program.motions.turning; turning && !box.empty())
        if (const int table = turning_table(machine, turning->direction); table >= 0)
            return turning_part_origin(machine, table, turning->point, box);
    return box.empty() ? machine.table : default_part_origin(machine, box);
}

namespace {

int turns_max(const Kinematics& kinematics, const Joints& from, const Joints& to) {
    const bool second = kinematics.rotary_axes() == 2
                        && std::abs(to.rotary[1] - from.rotary[1]) > std::abs(to.rotary[0] - from.rotary[0]);
    return second ? 4 : 3;
}

double feed_time(const ClSection& program, std::size_t motion, const Vec3& step) {
    return step.norm() / program.feed(motion) * 60.0;
}

/// The joints of all motions, findings about what cannot be held, and no times yet.
MachineMotion follow(const ClSection& program, const Kinematics& kinematics, const MotionTimeOptions& options,
                     const Progress& progress) {
    using Limit = Kinematics::Reach::Limit;
    const auto& motions = program.motions.motions;
    std::vector<double> feed_seconds(motions.size(), 0);
    for (std::size_t i = 1; i < motions.size(); ++i)
        feed_seconds[i] = feed_time(program, i, motions[i].to.tip - motions[i - 1].to.tip);
    const JointCourse course =
        find_joint_course(motions, feed_seconds, kinematics, options.largest_swing, progress);
    MachineMotion result;
    result.motions.resize(motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
        MotionJoints& m = result.motions[i];
        m.at = course.at[i];
        m.held = course.held[i];
        if (m.held) {
            if (i == 0 || !course.held[i - 1] || motions[i].kind == MotionKind::rapid) continue;
            const Joints& from = course.at[i - 1];
            const double swing =
                swing_between(kinematics, from, m.at, motions[i - 1].to.axis, motions[i].to.axis);
            if (swing > options.largest_swing)
                result.findings.push_back(
                    {MotionFinding::Kind::swing, i, turns_max(kinematics, from, m.at), swing});
        } else {
            const auto reach = kinematics.reach({motions[i].to.tip, motions[i].to.axis});
            const auto kind = reach.limit == Limit::rotary_travel   ? MotionFinding::Kind::rotary_travel
                              : reach.limit == Limit::linear_travel ? MotionFinding::Kind::linear_travel
                                                                    : MotionFinding::Kind::axis;
            result.findings.push_back({kind, i, reach.joint, reach.beyond});
        }
    }
    return result;
}

double rapid_time(const Vec3& step, const Machine& machine) {
    return step.cwiseAbs().cwiseQuotient(machine.rapid_mm_per_s).maxCoeff();
}

void set_times(MachineMotion& result, const ClSection& program, const Kinematics& kinematics) {
    const auto& motions = program.motions.motions;
    const Machine& machine = kinematics.machine();
    for (std::size_t i = 1; i < motions.size(); ++i) {
        MotionJoints& m = result.motions[i];
        const Joints& from = result.motions[i - 1].at;
        const bool rapid = motions[i].kind == MotionKind::rapid;
        const Vec3 step = motions[i].to.tip - motions[i - 1].to.tip;
        if (!program.multi_axis || !m.held)
            m.seconds = rapid ? rapid_time(step, machine) : feed_time(program, i, step);
        else
            m.seconds = std::max(rapid ? 0.0 : feed_time(program, i, step), kinematics.time(from, m.at));
        if (m.seconds > 0)
            for (int k = 0; k < machine.joints(); ++k)
                m.rates[std::size_t(k)] = (m.at[k] - from[k]) / m.seconds;
    }
}

/// Times with the axes' accelerations, from the speeds of the motions without.
void add_accelerations(MachineMotion& result, const Machine& machine) {
    auto& motions = result.motions;
    // What it takes to change from one motion's speeds to the other's; from or to rest at the ends.
    const auto change = [&](std::size_t i, std::size_t next) {
        double seconds = 0;
        for (int k = 0; k < machine.joints(); ++k) {
            const auto j = std::size_t(k);
            const double before = i > 0 ? motions[i].rates[j] : 0,
                         after = next < motions.size() ? motions[next].rates[j] : 0;
            seconds = std::max(seconds, std::abs(after - before) / (2 * machine.acceleration(k)));
        }
        return i == 0 || next == motions.size() ? seconds : 0.5 * seconds;
    };
    std::vector<double> longer(motions.size());
    for (std::size_t i = 1; i < motions.size(); ++i) {
        double rest = motions[i].seconds;
        for (int k = 0; k < machine.joints(); ++k)
            if (const double speed = std::abs(motions[i].rates[std::size_t(k)]); speed > 0)
                rest = std::max(rest,
                                trapezoid_time(speed * motions[i].seconds, speed, machine.acceleration(k)));
        longer[i] = std::min(rest, motions[i].seconds + change(i - 1, i) + change(i, i + 1));
    }
    for (std::size_t i = 1; i < motions.size(); ++i) {
        if (motions[i].seconds > 0)
            for (double& rate : motions[i].rates)
                rate *= motions[i].seconds / longer[i];
        motions[i].seconds = longer[i];
    }
}

void add_quality(MachineMotion& result, const ClSection& program, const Machine& machine) {
    std::array<int, 5> route{};
    for (std::size_t i = 1; i < result.motions.size(); ++i) {
        const MotionJoints& m = result.motions[i];
        result.time_seconds += m.seconds;
        if (program.motions.motions[i].kind == MotionKind::rapid) {
            route = {};
            continue;
        }
        for (int k = 0; k < machine.joints(); ++k) {
            const auto j = std::size_t(k);
            const double step = m.at[k] - result.motions[i - 1].at[k];
            if (k >= 3 && std::abs(m.rates[j]) > result.largest_angular_rate) {
                result.largest_angular_rate = std::abs(m.rates[j]);
                result.fastest_turn = i;
            }
            if (std::abs(step) <= (k < 3 ? tolerance::smallest_chord : tolerance::level_angle)) continue;
            const int now = step > 0 ? 1 : -1;
            result.reversals[j] += route[j] == -now;
            route[j] = now;
        }
    }
}

} // namespace

MachineMotion machine_motion(const ClSection& program, const Machine& machine,
                             const MotionTimeOptions& options, const Progress& progress) {
    const auto& motions = program.motions.motions;
    if (motions.empty()) return {};
    const Kinematics kinematics(machine, program.gauge_length,
                                program_part_origin(program, machine, options));
    MachineMotion result = follow(program, kinematics, options, progress);
    set_times(result, program, kinematics);
    if (options.accelerations) add_accelerations(result, machine);
    add_quality(result, program, machine);
    return result;
}

std::vector<double> motion_seconds(const ClSection& program, const Machine& machine,
                                   const MotionTimeOptions& options, const Progress& progress) {
    const auto& motions = program.motions.motions;
    std::vector<double> seconds(motions.size(), 0);
    if (program.multi_axis || options.accelerations) {
        const MachineMotion all = machine_motion(program, machine, options, progress);
        for (std::size_t i = 0; i < motions.size(); ++i)
            seconds[i] = all.motions[i].seconds;
        return seconds;
    }
    for (std::size_t i = 1; i < motions.size(); ++i) {
        const Vec3 step = motions[i].to.tip - motions[i - 1].to.tip;
        seconds[i] =
            motions[i].kind == MotionKind::rapid ? rapid_time(step, machine) : feed_time(program, i, step);
    }
    return seconds;
}

MotionTotals motion_totals(const ClSection& program, const Machine& machine, const MotionTimeOptions& options,
                           const Progress& progress, MachineMotion* followed) {
    MotionTotals totals;
    double rapid_seconds = 0, feed_seconds = 0;
    const auto& motions = program.motions.motions;
    // The first motion comes from nobody knows where: it has no length.
    for (std::size_t i = 1; i < motions.size(); ++i) {
        const Vec3 step = motions[i].to.tip - motions[i - 1].to.tip;
        const Vec3 &from = motions[i - 1].to.axis, &to = motions[i].to.axis;
        totals.turn_max = std::max(totals.turn_max, std::atan2(from.cross(to).norm(), from.dot(to)));
        if (motions[i].kind == MotionKind::rapid) {
            totals.rapid_length += step.norm();
            rapid_seconds += rapid_time(step, machine);
        } else {
            totals.cut_length += step.norm();
            feed_seconds += feed_time(program, i, step);
        }
    }
    if (program.multi_axis || options.accelerations) {
        MachineMotion all = machine_motion(program, machine, options, progress);
        totals.time_seconds = all.time_seconds;
        if (followed) *followed = std::move(all);
    } else {
        // One feed: the length at once, not its many roundings.
        if (program.motion_feeds.empty()) feed_seconds = totals.cut_length / program.feed_mm_per_min * 60.0;
        totals.time_seconds = rapid_seconds + feed_seconds;
    }
    return totals;
}

std::string finding_text(const MotionFinding& finding, const Machine& machine, LengthUnit unit) {
    const std::string place = "motion " + std::to_string(finding.motion + 1) + ": ";
    const auto angle = [](double a) { return format_number(degrees(a), 4) + "°"; };
    switch (finding.kind) {
    case MotionFinding::Kind::axis:
        return place + "the machine cannot incline the tool like this";
    case MotionFinding::Kind::rotary_travel:
        return place + machine.axis_name(finding.joint) + " ends " + angle(finding.amount) + " too early";
    case MotionFinding::Kind::linear_travel:
        return place + machine.axis_name(finding.joint) + " ends " + length_text(finding.amount, unit)
               + " too early";
    case MotionFinding::Kind::swing:
        return place + machine.axis_name(finding.joint) + " swings the tool " + angle(finding.amount)
               + " off its path while it cuts";
    }
    return place;
}

} // namespace facetmill
