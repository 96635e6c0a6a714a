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
    /// Creases are found to less; the middle of a blend depends on where the ball touches its facets.
    double beside = 0.15, beside_noisy = 0.3;
};

ValleyPart mould_part();
/// The samples, with what a ball of 25.4 mm cannot enter: in the pillar two blends; in the gap two blends as
/// far as the ball that comes nearest to them stands on the floor, and the floor's middle from where the ball
/// does not come down to it.
ValleyPart pillar_part();
ValleyPart gap_part();
/// Three planes that meet in a corner, as seen from above: three valleys that go out from it.
ValleyPart corner_part();
/// A level groove with flanks at 50 degrees, that runs on a circle: closed.
ValleyPart ring_part();

/// The same surface by other facets: edges longer than `longest` are divided anywhere, diagonals turned; and
/// every vertex is moved by up to `noise` any way.
Mesh scanned(const Mesh& mesh, double longest, double noise, std::uint64_t seed);

/// Distance from a polyline.
double distance_to(const std::vector<std::vector<Vec3>>& lines, const Vec3& p);
/// Places along polylines, `spacing` apart.
std::vector<Vec3> places_along(const std::vector<std::vector<Vec3>>& lines, double spacing);

} // namespace facetmill::test
