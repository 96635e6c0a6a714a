// How long a program takes and how far it goes, and where the axes of the machine stand meanwhile.
//
// A program of three axes takes its lengths at feed, and rapids with every axis at its own largest speed. In
// a program of several axes each motion at feed takes what its length asks for at feed or what the slowest
// joint asks for, whichever is longer, and a rapid what the slowest joint asks for (Lu 3.123, with the
// machine's own joints). Most tool axes can be held in two ways and by several turns of an axis; the machine
// is taken to follow the course with the fewest findings, and of these the soonest, as a post-processor that
// looks ahead makes it (joint_course.h).
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/output/cl_program.h"
#include "core/setup/kinematics.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

struct MotionTimeOptions {
    /// Axes take time to change their speed. An estimate per motion: it takes half of |change of speed| / 2a
    /// more where it meets each neighbour (all of it where the program begins and ends), which makes a motion
    /// from rest to rest a trapezoid and straight runs free; never more than that trapezoid.
    bool accelerations = false;
    /// Where the part's origin lies in the frame of the machine. Default: default_part_origin for the
    /// program's part_box, or for the box of its tips where it knows no part; for a part that turns, with its
    /// axis in the line of a table that can turn it.
    std::optional<Vec3> part_origin;
    /// How far the tool axis may stray, on a motion at feed, from the middle between its ends before it is a
    /// finding, beyond half the angle between the ends; radians. Axes stray where they rewind or go round a
    /// singular pose.
    double largest_swing = radians(1);
};

/// Where a program's part origin lies, as the option says.
Vec3 program_part_origin(const ClSection& program, const Machine& machine,
                         const MotionTimeOptions& options = {});

struct MotionTotals {
    double cut_length = 0;   ///< mm, all motion at feed
    double rapid_length = 0; ///< mm
    double time_seconds = 0; ///< as above
    double turn_max = 0;     ///< largest turn of the tool axis in one motion, radians
};

struct MachineMotion;

/// `followed`, if given, becomes what machine_motion finds where the totals come from it: in programs of
/// several axes, and with accelerations. Otherwise it is left alone.
MotionTotals motion_totals(const ClSection& program, const Machine& machine,
                           const MotionTimeOptions& options = {}, const Progress& progress = {},
                           MachineMotion* followed = nullptr);

/// Time of each motion; their sum is the total's. The first takes none: nothing is known of where it starts.
std::vector<double> motion_seconds(const ClSection& program, const Machine& machine,
                                   const MotionTimeOptions& options = {}, const Progress& progress = {});

/// One motion as the machine makes it.
struct MotionJoints {
    Joints at; ///< at its end; where the machine cannot hold that, where it stood before
    bool held = true;
    double seconds = 0;
    std::array<double, 5>
        rates{}; ///< mean speed of each joint, mm/s and rad/s, with sign; 0 for a motion without time
};

/// What the machine cannot do. Data, not an error: shown with the path.
struct MotionFinding {
    enum class Kind {
        axis,          ///< cannot hold this tool axis at all
        rotary_travel, ///< a rotary axis ends too early
        linear_travel, ///< a linear axis ends too early
        swing,         ///< holds both ends, but between them the tool swings off its path while it cuts
    };
    Kind kind = Kind::axis;
    std::size_t motion = 0;
    int joint = -1;    ///< the axis that ends, or turns most in a swing; -1 for `axis`
    double amount = 0; ///< how far beyond the travel, or off its path; mm or radians
};
/// "motion 12: A ends 5.2° too early".
std::string finding_text(const MotionFinding& finding, const Machine& machine, LengthUnit unit);

struct MachineMotion {
    std::vector<MotionJoints> motions;
    std::vector<MotionFinding> findings; ///< in the order of the motions; one per motion
    /// Motions at feed only. How often each joint turns back, by more than rounding, within runs between
    /// rapids.
    std::array<std::size_t, 5> reversals{};
    double largest_angular_rate = 0; ///< the fastest of the rotary axes, rad/s
    std::size_t fastest_turn = 0;    ///< the motion that has it
    double time_seconds = 0;         ///< the sum
};

/// The program on the machine, motion by motion; for programs of three axes with the axis +Z. Throws
/// Error(out_of_range) as Kinematics does.
MachineMotion machine_motion(const ClSection& program, const Machine& machine,
                             const MotionTimeOptions& options = {}, const Progress& progress = {});

} // namespace facetmill
