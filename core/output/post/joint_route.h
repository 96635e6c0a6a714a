// What lies between two blocks of a program: where the tool is meant to run (the tip straight and the axis in
// one plane, or round a turning axis), and where it does run while the joints of a machine move evenly.
// Internal to the room. Millimetres, radians, part coordinates.
#pragma once

#include "core/setup/kinematics.h"
#include "core/setup/motion.h"

#include <optional>
#include <vector>

namespace facetmill {

/// How far a tool may stray from its route between two blocks.
struct StrayLimit {
    double tip = 0.01, axis = 0.002;
};

/// A place at which a motion is divided; `t` from 0 to 1.
struct RoutePlace {
    double t = 1;
    Joints at;
    CutterLocation location;
};

struct JointMotion {
    CutterLocation from, to;
    Joints from_joints, to_joints;
};

/// Divides a motion so that the tool keeps to its route within the limit while the joints move evenly between
/// the places; appends them, the motion's end last. False where the machine cannot follow it: it would have
/// to rewind, or turns over.
bool divide_motion(const Kinematics& kinematics, const JointMotion& motion,
                   const std::optional<TurningAxis>& turning, const StrayLimit& limit,
                   std::vector<RoutePlace>& places);

/// Divides a motion, into `places` alone, to whichever way to stand at its end can be reached on the route.
/// With `course_first` its own end joints are tried before; else, and where the tool cannot be led there (it
/// passes beside the pole of the machine, and an axis turns by up to half a turn meanwhile), all ways from
/// the nearest on.
bool lead_motion(const Kinematics& kinematics, const JointMotion& motion, bool course_first,
                 const std::optional<TurningAxis>& turning, const StrayLimit& limit,
                 std::vector<RoutePlace>& places);

/// The other way round: the places of an even joint motion between which the tool keeps within the limit of
/// the route that a judge takes it to run.
void trace_motion(const Kinematics& kinematics, const JointMotion& motion,
                  const std::optional<TurningAxis>& turning, const StrayLimit& limit,
                  std::vector<RoutePlace>& places);

/// How high Z goes when a program sends it up: the end of its travel, or where that has none, clear of `z`.
double travel_top(const Machine& machine, double z);
/// Seconds up to a height, there to the rotary angles, then to X and Y of `to`, and down.
double seconds_over(const Kinematics& kinematics, const Joints& from, const Joints& to, double height);

/// The joints, evenly between two.
Joints joints_between(const Joints& from, const Joints& to, double t);

} // namespace facetmill
