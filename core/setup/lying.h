// How a part can lie on a flat table: on the faces of its convex hull, and what each of them means for the
// machining. The part is any mesh, closed or not; corners counter-clockwise seen from outside.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/setup/placement.h"

#include <string>
#include <vector>

namespace facetmill {

struct LyingFace {
    Vec3 down = -Vec3::UnitZ(); ///< out of the part: -Z once it lies
    std::vector<Vec3> outline;  ///< of the support, counter-clockwise seen from outside; mm
    double support_area = 0;    ///< within the outline, mm^2
    double contact_area = 0;    ///< of facets that lie on the table, mm^2
    double height = 0;          ///< of the part as it lies, mm
    double facing_down = 0;     ///< share of the surface that faces the table without lying on it
    /// Radians that the table may be tilted before the part falls, about the side of the outline that is
    /// nearest to its centre of mass.
    double tips_at = 0;
};

enum class LyingOrder {
    largest, ///< the largest area on the table first, then the largest outline
    best,    ///< the least surface that a tool from above cannot come to, the most that lies, standing firmly
};

/// At most so many are told.
inline constexpr std::size_t max_lying_faces = 24;

/// The faces that a part stays on by itself, in order. The mass is the part's where it is closed and its
/// hull's where it is not. Throws Error(empty_result) for points on a line.
std::vector<LyingFace> lying_faces(const Mesh& mesh, LyingOrder order, const Progress& progress);

/// The shortest turn that makes a direction (unit) -Z; a part upside down turns over about X.
Mat3 turn_to_lie(const Vec3& down);
/// A quarter turn, or several, about X, Y or Z.
Mat3 quarter_turn(int axis, int quarters);
/// The smallest turn about Z that lays an edge along X, whichever way it runs. Throws Error(out_of_range)
/// where the edge stands upright.
Mat3 turn_along_x(const Vec3& edge);
/// Out of the part, through three points: which way is down when it lies on them. Throws Error(out_of_range)
/// for points on a line, and for a plane with the part on both sides of it alike.
Vec3 down_through(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& middle);
/// The turn about Z with the smallest box around what is seen from above, its longer side along X; of several
/// the smallest turn.
Mat3 turn_to_square(const Mesh& mesh, const Progress& progress = {});

/// The turn that brings the principal axes of a mesh's surface (its second moments by area about its middle)
/// along X, Y and Z: the longest along X, the shortest along Z; of the four ways round the smallest turn.
/// Where two of them are alike, as in what is round, the third alone is brought, by the smallest turn. Throws
/// Error(out_of_range) where all are alike.
Mat3 turn_to_principal(const Mesh& mesh, const Progress& progress = {});

/// The box of a mesh once turned about the origin.
Box3 turned_box(const Mesh& mesh, const Mat3& turn, const Progress& progress = {});
/// The placement of a part (`mesh`: in its place) after a turn: the middle of its box keeps its X and Y, and
/// its lowest point has Z 0. Angles that are whole degrees but for half a thousandth of a millimetre of the
/// part are whole degrees.
Placement laid(const Placement& placement, const Mesh& mesh, const Mat3& turn, const Progress& progress = {});

} // namespace facetmill
