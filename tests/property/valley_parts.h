// Parts whose valleys are known, for clean-up; millimetres. And the same parts as a scan would give them.
#pragma once

#include "core/mesh/mesh.h"

#include <string>
#include <vector>

namespace facetmill::test {

struct ValleyPart {
    std::string name;
    Mesh mesh;
    /// Polylines; all that a ball of the diameter below cannot enter.
    std::vector<std::vector<Vec3>> valleys;
    double previous = 12, diameter = 4; ///< balls: the previous tool, and the one that cleans up
};

ValleyPart mould_part();
/// Three planes that meet in a corner, as seen from above: three valleys that go out from it.
ValleyPart corner_part();
/// A level groove with flanks at 50 degrees, that runs on a circle: closed.
ValleyPart ring_part();

/// The same surface by other facets: edges are divided anywhere, `rounds` times; and every vertex is moved
/// by up to `noise` any way.
Mesh scanned(const Mesh& mesh, double longest, double noise, std::uint64_t seed);

/// Distance from a polyline.
double distance_to(const std::vector<std::vector<Vec3>>& lines, const Vec3& p);
/// Places along polylines, `spacing` apart.
std::vector<Vec3> places_along(const std::vector<std::vector<Vec3>>& lines, double spacing);

} // namespace facetmill::test
