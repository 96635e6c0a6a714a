// Whether the joints of a machine can follow a run of motions at feed: an axis that ends somewhere has to
// begin the run where it has room for all of it. Part coordinates.
#pragma once

#include "core/setup/kinematics.h"
#include "core/setup/motion.h"
#include "core/strategy/five_axis/even_motion.h"

#include <span>
#include <vector>

namespace facetmill {

/// All ways in which the machine may stand at a place of a run, having followed it from its beginning with no
/// axis that turned over (joint_course.h finds one of them).
class JointRun {
public:
    /// Both must outlive this.
    JointRun(const Kinematics& kinematics, const EvenMotion& motion)
        : kinematics_(&kinematics), motion_(&motion) {}

    /// A run begins here, after a rapid.
    void begin(const CutterLocation& at);
    /// On to the next place; false, and nothing has changed, where an axis would have to turn over. Places
    /// that the machine cannot hold at all end a run, and another one begins after them.
    bool go(const CutterLocation& to);
    /// How many of these it can go to, one after the other.
    std::size_t reach(std::span<const CutterLocation> route) const;
    bool follows(std::span<const CutterLocation> route) const { return reach(route) == route.size(); }
    /// The share of the motion to a place, of those it cannot go to, that it can still make.
    double share_to(const CutterLocation& to) const;
    const CutterLocation& at() const { return at_; }

private:
    std::vector<Joints> onward(const CutterLocation& to) const;

    const Kinematics* kinematics_;
    const EvenMotion* motion_;
    CutterLocation at_;
    std::vector<Joints> stances_;
};

} // namespace facetmill
