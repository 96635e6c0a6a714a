#include "core/verify/axis_courses.h"

#include "core/base/tolerances.h"
#include "core/setup/joint_course.h"
#include "core/verify/sweep.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t motions_per_check = 1024;
/// Courses that keep all of a tool within this (mm) are one.
constexpr double same_course = 5e-5;
/// Axes that are held to within this are those of the program.
constexpr double same_axis = 4e-6;
/// How far a tool may swing off its path before that counts more than time.
const double largest_swing = radians(1);
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
    return {tip, program_->machine_turn * kinematics_->forward(joints).axis};
}

void AxisCourses::follow_joints(const Progress& progress) {
    // Where part and spindle nose are makes no difference to the rotary axes, but where linear axes end.
    Machine machine = *program_->machine;
    machine.travel = {};
    kinematics_.emplace(machine, 0, Vec3::Zero());
    const auto& motions = program_->motions->motions;
    std::vector<Joints> at;
    std::vector<bool> held(motions.size(), true);
    if (program_->joints && program_->joints->size() == motions.size()) {
        at = *program_->joints;
    } else {
        std::vector<Motion> there = motions; // in the machine's coordinates
        for (Motion& m : there)
            m.to = {program_->machine_turn.transpose() * m.to.tip,
                    program_->machine_turn.transpose() * m.to.axis};
        JointCourse course = find_joint_course(there, {}, *kinematics_, largest_swing, progress);
        at = std::move(course.at);
        held = std::move(course.held);
    }
    angles_.resize(motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (i % motions_per_check == 0) progress.check();
        const Vec3 axis = program_->machine_turn * kinematics_->forward(at[i]).axis;
        if (held[i] && (axis - motions[i].to.axis).norm() <= same_axis) angles_[i] = at[i].rotary;
    }
}

} // namespace facetmill
