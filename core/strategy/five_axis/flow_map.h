// Passes that flow over a piece of the surface from one of its edges to the other: blades from root to tip
// beside their edges, shrouds from hub to rim.
//
// The border of a piece has four corners, where it reaches farthest along and across the travel at once. What
// lies between those on one side is the edge at which passes begin, what lies across from it the one at which
// they end; both are passes themselves. Between them v is harmonic on the surface (no pull or push: its lines
// never meet, fold over or close), with the other two sides of the border and holes left free, so that lines
// come to them at right angles. Likewise u from the one free side to the other. Both are then stretched until
// they change as lengths do.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/surface/drive_frame.h"
#include "core/strategy/surface/pass_map.h"

namespace facetmill {

/// `mesh`: pieces that face up (+Z), each of them apart from the others; `frame`: along and across the
/// travel. Where a piece has no border to go by its lines are those of drive planes. Between pieces v has a
/// gap (mm).
PassMap flow_map(const Mesh& mesh, const DriveFrame& frame, double gap, const Progress& progress);

} // namespace facetmill
