// The tool's path over a turning part: heights u along a route of places (theta, y), close enough that the
// motion between them, which is straight in (theta, y, u), neither gouges nor leaves more than it may.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/lathe/lathe_field.h"
#include "core/strategy/surface/lift_line.h"

#include <span>
#include <vector>

namespace facetmill {

/// The spacing at which nothing can be missed. A point of the part at the distance R from the axis passes the
/// cutter on an arc, which leaves its chord by c^2 / 8R; the chord dips into a cutter that stands clear at
/// both of its ends by what safe_spacing (lift_line.h) says. Both together stay within `below`.
double safe_lathe_spacing(const CutterProfile& profile, double part_radius, double below);

/// Distance that the part's outermost points make under the cutter between two places, mm.
double lathe_distance(const LathePlace& a, const LathePlace& b, double part_radius);

/// Points over the polyline of `route` (at least one place), all of its places among them. Every point is on
/// the field but for corners of radial moves, which are above it. Places looked at are no farther apart than
/// `tolerance.spacing`, in mm of the distance that any point of the part makes under the cutter (see
/// safe_lathe_spacing); more are put in where the path falls by more than that, and where neighbours say that
/// the field bends by more than the tolerance holds. Throws Error(limit_exceeded) beyond max_lathe_points.
std::vector<LathePoint> trace(const LatheField& field, std::span<const LathePlace> route,
                              const LineTolerance& tolerance, const Progress& progress);

/// Leaves out points that the motion between the others passes within the tolerances, but never one of the
/// route's places (in its order). This also takes off the jitter that facets cause.
std::vector<LathePoint> thinned(const std::vector<LathePoint>& points, std::span<const LathePlace> route,
                                double part_radius, double below, double above);

/// Places of a path, at most: some hours of work, and 4 GB.
inline constexpr double max_lathe_points = 4e7;

} // namespace facetmill
