#include "core/verify/axis_courses.h"

#include "core/base/tolerances.h"
#include "core/verify/sweep.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t motions_per_check = 1024;
/// Courses that keep all of a tool within this (mm) are one.
constexpr double same_course = 5e-5;
/// Places of a motion at which courses are held against each other: near where they are farthest apart, a
/// quarter and half of the way.
constexpr std::array<double, 4> compared{0.2, 0.5, 0.75, 0.9};

double reach_of(const VerifyTool& tool) {
    double reach = tool.cutter.height() + tool.cutter.max_radius();
    for (const ToolSection& s : tool.sections)
        reach = std::max(reach, s.to + s.radius);
    return reach;
}

} // namespace

AxisCourses::AxisCourses(const VerifyProgram& program, const Progress& progress) : program_(&program) {
    if (program.turning) return;
    const auto& motions = program.motions->motions;
    bool turns = false;
    for (std::size_t i = 1; i < motions.size() && !turns; ++i)
        turns = motions[i].to.axis != motions[i - 1].to.axis;
    if (!turns) return;
    if (program.machine && !program.machine->rotary.empty()) follow_joints(progress);
    const double reach = reach_of(program.tool);
    differs_.assign(motions.size(), 0);
    for (std::size_t i = 1; i < motions.size(); ++i) {
        if (i % motions_per_check == 0) progress.check();
        if (motions[i].to.axis == motions[i - 1].to.axis) continue;
        for (const AxisCourse course : others) {
            if (course == AxisCourse::joint_linear && (angles_.empty() || !angles_[i] || !angles_[i - 1]))
                continue;
            double apart = 0;
            for (const double s : compared)
                apart = std::max(
                    apart,
                    (at(Index(i), course, s).axis - at(Index(i), AxisCourse::great_circle, s).axis).norm());
            if (apart * reach > same_course) differs_[i] |= std::uint8_t(1u << unsigned(course));
        }
    }
}

CutterLocation AxisCourses::at(Index motion, AxisCourse course, double s) const {
    const CutterLocation &a = from(motion), &b = program_->motions->motions[motion].to;
    if (course == AxisCourse::great_circle || a.axis == b.axis || s <= 0 || s >= 1)
        return location_between(a, b, program_->turning, s);
    const Vec3 tip = a.tip + s * (b.tip - a.tip);
    if (course == AxisCourse::normalized_linear) return {tip, ((1 - s) * a.axis + s * b.axis).normalized()};
    const auto &first = *angles_[motion - 1], &last = *angles_[motion];
    Joints joints;
    for (std::size_t k = 0; k < 2; ++k)
        joints.rotary[k] = first[k] + s * (last[k] - first[k]);
    return {tip, kinematics_->forward(joints).axis};
}

void AxisCourses::follow_joints(const Progress& progress) {
    // Where part and spindle nose are makes no difference to the rotary axes.
    kinematics_.emplace(*program_->machine, 0, Vec3::Zero());
    const auto& motions = program_->motions->motions;
    angles_.resize(motions.size());
    Angles before;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (i % motions_per_check == 0) progress.check();
        angles_[i] = next(motions[i].to.axis, before);
        if (angles_[i]) before = angles_[i];
    }
}

AxisCourses::Angles AxisCourses::next(const Vec3& axis, const Angles& from) const {
    Joints near;
    if (from) near.rotary = *from;
    const Kinematics::Solutions solutions = kinematics_->inverse({Vec3::Zero(), axis.normalized()}, near);
    Angles best;
    double least = infinity;
    for (int i = 0; i < solutions.count; ++i) {
        std::array<double, 2> angles{0, 0};
        double longest = 0;
        for (std::size_t k = 0; k < program_->machine->rotary.size(); ++k) {
            const Travel& travel = program_->machine->rotary[k].travel;
            const double angle = solutions.at[std::size_t(i)].rotary[k], start = near.rotary[k];
            const double nearest = start + std::remainder(angle - start, 2 * pi);
            double shortest = infinity;
            for (const double turns : {0.0, -1.0, 1.0}) {
                const double to = nearest + 2 * pi * turns;
                if (!travel.contains(to, tolerance::level_angle) || std::abs(to - start) >= shortest)
                    continue;
                shortest = std::abs(to - start);
                angles[k] = to;
            }
            longest = std::max(longest, shortest);
        }
        if (!(longest < least)) continue;
        least = longest;
        best = angles;
    }
    return best;
}

} // namespace facetmill
