// Where a machine's axes stand for a tool pose, and where the tool is for where they stand.
//
// Tool poses are in part coordinates, joints in the machine's frame (machine.h). The chain, from the part to
// the tool: the inner table axis, the outer one, X Y Z, the outer head axis, the inner one, the tool. Each
// rotary axis turns what it carries about its line by `sign` times its angle; the tool stands along +Z below
// the spindle nose at zero angles. A tool axis is left(alpha) right(beta) z with the two rotations of the
// chain, so that beta follows from the height of the axis over left's plane (two solutions) and alpha from
// its azimuth.
#pragma once

#include "core/base/vec.h"
#include "core/setup/machine.h"
#include "core/setup/tool_pose.h"

#include <array>
#include <optional>

namespace facetmill {

struct Tool;

/// Where the axes of a machine stand.
struct Joints {
    Vec3 linear = Vec3::Zero(); ///< X, Y, Z, mm: the spindle nose at zero rotary angles
    /// Radians, in the order of Machine::rotary; 0 for an axis that the machine has not.
    std::array<double, 2> rotary{0, 0};

    /// By number: 0..2 linear, 3.. rotary.
    double operator[](int joint) const { return joint < 3 ? linear[joint] : rotary[std::size_t(joint - 3)]; }
};

/// Where the part's origin lies in the frame of the machine when the middle of the bottom of the part's box
/// stands on Machine::table: by default over the middle of the rotary table, or of the travel in X and Y.
/// Throws Error(out_of_range) for an empty box.
Vec3 default_part_origin(const Machine& machine, const Box3& part_box);

/// Number in Machine::rotary of a table that turns a part about a line with this direction, either way round;
/// -1 where the machine has none.
int turning_table(const Machine& machine, const Vec3& direction);
/// Where the part's origin lies when its turning axis runs in the line of that table (`point`: any of the
/// axis), and along it where default_part_origin puts it.
Vec3 turning_part_origin(const Machine& machine, int table, const Vec3& point, const Box3& part_box);

/// Tip to spindle nose: flutes, shank and holder, mm.
double gauge_length(const Tool& tool);

class Kinematics {
public:
    /// `tool_length`: from tip to spindle nose, mm. `part_origin`: where the part's origin lies in the frame
    /// of the machine at zero rotary angles. Throws Error(out_of_range) for values that are not finite and
    /// for a negative length.
    Kinematics(const Machine& machine, double tool_length, const Vec3& part_origin);

    const Machine& machine() const { return machine_; }
    int rotary_axes() const { return int(machine_.rotary.size()); }

    ToolPose forward(const Joints& joints) const;
    /// Where X, Y, Z stand so that the tip is there with these rotary angles.
    Vec3 linear(const Vec3& tip, const Joints& rotary) const { return linear_for(tip, rotary); }

    struct Solutions {
        int count = 0;
        std::array<Joints, 2> at;
        bool singular = false;
    };
    /// Rotary angles in (-pi, pi]; travel is not looked at. Singular is a tool axis within
    /// tolerance::level_angle of the first rotation's line, left of the chain (C of a head with A on it; C of
    /// a table on A): its angle is free and is near's, there is one solution, and the axis it holds is that
    /// line. count 0: the machine cannot hold the axis to within tolerance::level_angle, wherever its limits
    /// are. Axes held otherwise are exact to 1e-12, tips to 1e-9 mm for parts of 100 mm. Throws
    /// Error(internal) for a pose that is not finite or whose axis is no unit vector.
    Solutions inverse(const ToolPose& pose, const Joints& near) const;
    /// The solutions within travel, their rotary angles wound by whole turns as near to those of `from` as
    /// their travel allows.
    Solutions within_travel(const ToolPose& pose, const Joints& from) const;
    /// That of them which is reached soonest from `from`; nothing when none is within travel.
    std::optional<Joints> nearest(const ToolPose& pose, const Joints& from) const;

    struct Reach {
        enum class Limit { none, axis, rotary_travel, linear_travel };
        Limit limit = Limit::none;
        int joint = -1;    ///< of a travel: the one that ends too early
        double beyond = 0; ///< of a travel: by how much, mm or radians
    };
    /// What keeps the machine from holding a pose; where solutions are kept by different limits, the one that
    /// ends nearest, linear before rotary. A free angle is taken at the value nearest to 0.
    Reach reach(const ToolPose& pose) const;
    bool reaches(const ToolPose& pose) const { return reach(pose).limit == Reach::Limit::none; }

    /// Joint-motion time, s: the slowest axis at its largest speed (Lu 3.123 with the machine's own joints).
    /// With accelerations every axis starts and ends at rest, as fast as it may (a trapezoid or triangle of
    /// speed).
    double time(const Joints& a, const Joints& b, bool accelerations = false) const;
    /// The joint that decides `time` without accelerations, for charts; 0 where nothing moves.
    int slowest_axis(const Joints& a, const Joints& b) const;

private:
    /// One rotation of the chain from the part to the tool, as the tool axis feels it.
    struct Turn {
        Vec3 line = Vec3::UnitX();
        double sign = 1;      // of the rotation for a positive joint
        std::size_t axis = 0; // in Machine::rotary
    };
    Vec3 linear_for(const Vec3& tip, const Joints& joints) const;
    Vec3 to_bed(Vec3 point, const Joints& joints) const;
    std::optional<Joints> wound(Joints solution, bool singular, const Vec3& tip, const Joints& from,
                                Reach* reach) const;

    Machine machine_;
    double tool_length_;
    Vec3 part_origin_;
    std::array<Turn, 2> turns_; // left, right
    double line_angle_ = 0;     // between the two lines
    double tool_angle_ = 0;     // between the last line and Z
    double right_zero_ = 0;     // angle of right that brings the tool nearest to left's line
};

/// Duration of a motion over `distance` from rest to rest at no more than `speed` and `acceleration`, s.
double trapezoid_time(double distance, double speed, double acceleration);

} // namespace facetmill
