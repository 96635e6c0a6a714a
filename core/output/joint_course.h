// Where the joints of a machine stand along a program: most tool axes can be held in several ways, and this
// finds those that take the program through soonest.
//
// A shortest path over the motions. The stops of a motion are the solutions of its pose, each wound to the
// turns nearest to the stops of the motion before; the program may begin with every rotary axis a turn to
// either side. A motion costs its time; one on which the tool swings off its path costs more than all of
// them. Millimetres, radians, seconds; part coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/output/cl_program.h"
#include "core/setup/kinematics.h"

#include <vector>

namespace facetmill {

struct JointCourse {
    std::vector<Joints> at; ///< at the end of each motion; where the machine cannot hold that, as before
    std::vector<bool> held;
};

/// The soonest course; of two that take the same time, the one whose joints move less. `largest_swing` as in
/// MotionTimeOptions. Looks 16 384 motions ahead at most.
JointCourse find_joint_course(const ClSection& program, const Kinematics& kinematics, double largest_swing,
                              const Progress& progress);

/// How far the tool axis strays from the middle between its ends while the joints move evenly, beyond half
/// the angle of the ends, radians. Stops looking once it is more than `enough`.
double swing_between(const Kinematics& kinematics, const Joints& from, const Joints& to,
                     const Vec3& axis_from, const Vec3& axis_to, double enough = infinity);

/// Time of a motion at its feed, by its length alone, s.
double feed_time(const ClSection& program, std::size_t motion, const Vec3& step);

} // namespace facetmill
