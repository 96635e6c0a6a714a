// Passes, options and the words for motions that tests of links share.
#pragma once

#include "core/link/link.h"
#include "tests/property/shapes.h"

#include <initializer_list>
#include <string>

namespace facetmill::test {

inline Pass pass(std::initializer_list<Vec3> tips) {
    Pass p;
    for (const Vec3& t : tips) {
        p.cl.push_back({t, Vec3(0, 0, 1)});
        p.cc.push_back({t, Vec3(0, 0, 1)});
    }
    return p;
}

inline std::string kinds_of(const ToolMotions& m) {
    std::string text;
    for (const Motion& motion : m.motions)
        text += "racl^"[int(motion.kind)];
    return text;
}

inline LinkOptions near_options(double distance) {
    LinkOptions o;
    o.clearance = 5;
    o.link_distance = distance;
    o.chord_tolerance = 0.002;
    return o;
}

inline const Mesh& level() {
    static const Mesh mesh =
        height_field([](double, double) { return 0.0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3);
    return mesh;
}

} // namespace facetmill::test
