// Meshes and tools that tests are written with. Millimetres; each mesh stands on about 40 x 30 mm around the
// origin.
#pragma once

#include "core/mesh/mesh.h"
#include "core/setup/tool.h"

#include <functional>
#include <vector>

namespace facetmill::test {

/// A sheet z = f(x, y) over a rectangle, nx by ny cells of two facets each.
Mesh height_field(const std::function<double(double, double)>& f, const Vec2& lo, const Vec2& hi, int nx,
                  int ny);
/// The facets of `mesh` whose centre passes `keep`.
Mesh only(const Mesh& mesh, const std::function<bool(const Vec3&)>& keep);
Mesh turned(const Mesh& mesh, double angle_about_z);
/// A closed box.
Mesh box(const Vec3& lo, const Vec3& hi);
/// Two levels with an upright wall between them along y = 0 (low where y > 0), as a sheet.
Mesh step(double low, double high);
/// The upper half of a sphere around the origin, with a level bottom: closed.
Mesh dome(double radius, int rings);

Tool ball_tool(double diameter);
Tool flat_tool(double diameter);
Tool bull_tool(double diameter, double corner);

struct ShapedTool {
    const char* name;
    Tool tool;
};
/// Ball, flat, bull and cone (the last).
std::vector<ShapedTool> tools_of_every_shape();

/// A closed block with its lowest corner at the origin and a round, shallow hollow in the middle of each of
/// its six sides, which a ball of 6 mm reaches everywhere from above.
struct HollowedBlock {
    static constexpr double radius = 9, depth = 3; ///< of the hollows
    static Vec3 size() { return {40, 30, 24}; }
    static double hollow_volume();
    static Mesh mesh();
};

/// Smooth, a wall and a hole in one part.
Mesh mixed();

} // namespace facetmill::test
