// Parts with known answers, and what a strategy needs to plan on them. Millimetres; each stands on about 40 x
// 30 mm around the origin.
#pragma once

#include "core/strategy/plan/operation.h"
#include "tests/support/part_meshes.h"

#include <functional>
#include <string>
#include <vector>

namespace facetmill::test {

struct Shape {
    std::string name;
    Mesh mesh;
    /// Places that the tool cannot reach because the part is hollower there than the tool is round.
    std::function<bool(const Vec3& point, const Tool& tool)> out_of_reach;
};

std::vector<Shape> shapes();

/// All that a strategy needs for a part and a tool; the stock is the part's box.
PlanContext context_of(const Mesh& mesh, const Tool& tool);

} // namespace facetmill::test
