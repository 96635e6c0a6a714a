// Where the joints of a machine stand along a program: of the ways to hold each tool axis, those that take
// the program through soonest.
//
// A shortest path over the motions. The stops of a motion are the solutions of its pose, wound near to each
// of the stops of the motion before; the program may begin with every rotary axis a turn to either side. A
// motion costs its time, and one on which the tool swings off its way more than all of them. Millimetres,
// radians, seconds; part coordinates.
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

/// Of two courses that take the same time, the one whose joints move less. `largest_swing` as in
/// MotionTimeOptions. Looks 16 384 motions ahead at most. Throws Cancelled within 20 ms.
JointCourse find_joint_course(const ClSection& program, const Kinematics& kinematics, double largest_swing,
                              const Progress& progress);

/// How far the tool axis strays from the middle between its ends while the joints move evenly, beyond half
/// the angle of the ends, radians. Stops looking once it is more than `enough`.
double swing_between(const Kinematics& kinematics, const Joints& from, const Joints& to,
                     const Vec3& axis_from, const Vec3& axis_to, double enough = infinity);

/// What the length asks for at feed, s.
double feed_time(const ClSection& program, std::size_t motion, const Vec3& step);

} // namespace facetmill
