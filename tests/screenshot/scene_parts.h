// Small parts and paths for the scene's tests.
#pragma once

#include "core/mesh/mesh.h"
#include "core/setup/motion.h"
#include "core/strategy/plan/path.h"
#include "viz/path_display.h"

#include <functional>

namespace facetmill::test {

/// A closed box with outward facets.
MeshPtr box_part(const Vec3& lo, const Vec3& hi);
/// z = height(x, y) over a rectangle, n x n cells, facing up, open.
MeshPtr sheet_part(const Vec2& lo, const Vec2& hi, int n,
                   const std::function<double(double, double)>& height);
MeshPtr moved(const MeshPtr& mesh, const Vec3& by);

/// A gentle hill on [0, 100] x [0, 80].
double hill(double x, double y);
inline constexpr double hill_length = 100, hill_width = 80;
MeshPtr hill_part();

/// Zigzag passes over the hill: a ball of the given radius on the contacts, links between neighbours, and one
/// move at clearance height in the middle, so that every kind of motion occurs.
PathSource hill_path(int passes, int points, double ball_radius);

} // namespace facetmill::test
