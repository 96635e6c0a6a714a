// Parts with known answers, as meshes. Millimetres; each stands on about 40 x 30 mm around the origin.
#pragma once

#include "core/strategy/plan/operation.h"

#include <functional>
#include <string>
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

struct Shape {
    std::string name;
    Mesh mesh;
    /// Places that the tool cannot reach because the part is hollower there than the tool is round.
    std::function<bool(const Vec3& point, const Tool& tool)> out_of_reach;
};

std::vector<Shape> shapes();

/// All that a strategy needs for a part and a tool; the stock is the part's box.
PlanContext context_of(const Mesh& mesh, const Tool& tool);
Tool ball_tool(double diameter);
Tool flat_tool(double diameter);
Tool bull_tool(double diameter, double corner);

struct ShapedTool {
    const char* name;
    Tool tool;
};
/// Ball, flat, bull and cone (the last).
std::vector<ShapedTool> tools_of_every_shape();

/// Smooth, a wall and a hole in one part.
Mesh mixed();

} // namespace facetmill::test
