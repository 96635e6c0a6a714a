// Between two locations a program leaves it to the machine how the axis turns. With the tip held on its
// straight line the axis goes on a great circle, by its coordinates evenly, or as the rotary joints turn it
// when each moves evenly: near the pole of a machine these differ by many degrees. A path is cut up until
// they do not matter.
#pragma once

#include "core/setup/kinematics.h"
#include "core/setup/motion.h"

#include <vector>

namespace facetmill {

class EvenMotion {
public:
    /// `radius`: the cutter's; `limit`: how far any point of the cutter may be moved by the difference, mm.
    EvenMotion(const Kinematics& kinematics, double radius, double limit);

    /// Whether the axis turns nearly alike from a to b on a great circle, by its coordinates and by the
    /// machine's joints, in whichever of its two manners the machine holds a; whether a joint comes to its
    /// end there is not asked. Of poses that it cannot hold the first two are asked alone.
    bool even(const CutterLocation& a, const CutterLocation& b) const;
    /// The same of joints that move evenly; where the machine stands at its pole, and one of them may stand
    /// anywhere, a turn that is small enough will do.
    bool even(const CutterLocation& a, const CutterLocation& b, const Joints& from, const Joints& to) const;
    /// Shares of the route from a to b at which locations have to be put, ascending; none where it is even.
    std::vector<double> cuts(const CutterLocation& a, const CutterLocation& b) const;

private:
    void cut(const CutterLocation& a, const CutterLocation& b, double from, double to, int depth,
             std::vector<double>& shares) const;

    const Kinematics& kinematics_;
    double max_apart_; ///< between axes, as a distance of unit vectors
};

} // namespace facetmill
