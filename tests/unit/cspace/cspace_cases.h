// What the tests of the configuration space share.
#pragma once

#include "core/cspace/contact_frame.h"
#include "tests/support/brute_lift.h"
#include "tests/support/random_meshes.h"

#include <span>
#include <utility>
#include <vector>

namespace facetmill::test {

struct NamedCutter {
    const char* name;
    AptCutter cutter;
};
inline const std::vector<NamedCutter>& cutters() {
    static const std::vector<NamedCutter> all = {
        {"flat", AptCutter::flat(12, 25)},
        {"ball", AptCutter::ball(10, 25)},
        {"bull", AptCutter::bull(12, 2, 25)},
        {"cone", AptCutter::cone(12, radians(30))},
        {"tapered ball", AptCutter::tapered_ball(2, radians(8), 25)},
        {"tapered", AptCutter::from_shape(8, 1.5, radians(10), radians(12), 20)},
        {"drill point", AptCutter::from_shape(10, 0, radians(30), 0, 20)},
        {"dovetail", AptCutter::from_shape(12, 1, 0, radians(-15), 10)},
        {"short ball", AptCutter::ball(10, 3)},
    };
    return all;
}

inline Vec3 random_unit(Random& rng) {
    for (;;) {
        const Vec3 v(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
        if (v.norm() <= 1 && v.norm() > 0.1) return v.normalized();
    }
}

inline ContactFrame random_frame(Random& rng) {
    return ContactFrame::at(20 * random_unit(rng), random_unit(rng), random_unit(rng));
}

/// A point in a frame of the tool: the tip is the origin, z the axis.
inline Vec3 in_tool(const ToolPose& pose, const Vec3& p) {
    const Vec3 u = pose.axis.unitOrthogonal(), v = pose.axis.cross(u), d = p - pose.tip;
    return Vec3(d.dot(u), d.dot(v), d.dot(pose.axis));
}

} // namespace facetmill::test
