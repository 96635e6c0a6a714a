// What the tests of the configuration space share.
#pragma once

#include "core/cspace/cspace.h"
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

inline Tool tool_of(double diameter, double corner, double flutes, double shank_diameter, double shank_length,
                    double holder_diameter) {
    Tool tool;
    tool.diameter = diameter;
    tool.corner_radius = corner;
    tool.flute_length = flutes;
    tool.shank_diameter = shank_diameter;
    tool.shank_length = shank_length;
    tool.holder = {{holder_diameter, 30}};
    return tool;
}

inline void add_quad(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = Index(mesh.vertices.size());
    for (const Vec3& p : {a, b, c, d})
        mesh.vertices.push_back(p);
    mesh.facets.push_back({first, first + 1, first + 2});
    mesh.facets.push_back({first, first + 2, first + 3});
}

inline Mesh level_plane(double half) {
    Mesh mesh;
    add_quad(mesh, {-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0});
    return mesh;
}

inline std::shared_ptr<Mesh> hills(std::uint64_t seed) {
    return field(
        16, 60, [](double x, double y) { return 4 * std::sin(0.15 * x) * std::cos(0.12 * y) + 0.05 * x; },
        0.3, seed);
}

/// Of a mesh, with a tool and a grid that goes with it.
struct Bench {
    std::shared_ptr<const Mesh> mesh;
    Tool tool;
    PostureGrid grid = PostureGrid::make(0, radians(60), radians(-90), radians(90), radians(15));
    ToolLift lift;
    CSpaceInput input;
    Bench(Mesh m, const Tool& t)
        : mesh(std::make_shared<Mesh>(std::move(m))), tool(t),
          lift(std::make_shared<ContactIndex>(mesh, Progress()), t) {
        input.lift = &lift;
        input.grid = &grid;
        input.local_radius = t.diameter;
    }
};

/// On both sides of the origin, along X.
inline std::vector<RaisedCurve> beside(double distance, double height) {
    return {{{-30, distance, height}, {0, distance, height}, {30, distance, height}},
            {{-30, -distance, height}, {30, -distance, height}}};
}

} // namespace facetmill::test
