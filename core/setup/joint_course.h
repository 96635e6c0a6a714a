// Where the joints of a machine stand along a program: most tool axes can be held in several ways, and this
// finds those that take the program through with the tool on its path, and soonest.
//
// A shortest path over the motions. The stops of a motion are the solutions of its pose, each wound to the
// turns nearest to the stops of the motion before; where the program begins, and at every rapid, also a turn
// to either side. A motion costs its time. At feed it costs besides what the tool axis strays while the
// joints move evenly, far more than time: a joint that comes to its end is wound back in the rapid before the
// run that needs it. Whoever posts, times, sweeps or links a program asks here, so that all speak of the same
// motions. Millimetres, radians, seconds; part coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/setup/kinematics.h"
#include "core/setup/motion.h"

#include <span>
#include <vector>

namespace facetmill {

struct JointCourse {
    std::vector<Joints> at; ///< at the end of each motion; where the machine cannot hold that, as before
    std::vector<bool> held;
};

/// The course that strays least, and of those the soonest; of two that take the same time, the one whose
/// joints move less. `feed_seconds`: what each motion takes at its feed, not asked of rapids; empty: joints
/// alone take time. More than `largest_swing` is avoided whatever else it costs. Looks 16 384 motions ahead
/// at most, or as far as the next rapid beyond.
JointCourse find_joint_course(std::span<const Motion> motions, std::span<const double> feed_seconds,
                              const Kinematics& kinematics, double largest_swing, const Progress& progress);

/// How far the tool axis strays from the middle between its ends while the joints move evenly, beyond half
/// the angle of the ends, radians. Stops looking once it is more than `enough`.
double swing_between(const Kinematics& kinematics, const Joints& from, const Joints& to,
                     const Vec3& axis_from, const Vec3& axis_to, double enough = infinity);

/// The ways to stand at which a run of motions can begin: the solutions of a pose within travel, each with
/// those a turn to either side of an axis that ends somewhere.
std::vector<Joints> stances(const Kinematics& kinematics, const ToolPose& pose);
/// Whether a rotary axis turns by more than half a turn, as where it is wound back.
bool turns_over(const Joints& from, const Joints& to);

} // namespace facetmill
