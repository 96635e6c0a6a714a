// Passes in closed rings about a piece of the surface: a blade, a hub, the wall of a bottle.
//
// A piece that goes round has two borders that the rings lie between, the two that enclose most and face
// apart; or one, and its end, the place farthest from that, where a hole is opened that no tool notices.
// Between them v is harmonic on the surface, as in flow_map.h: its lines are closed, never meet, and each
// goes round once. Other borders are left free, and rings that meet one end there. u is what goes round:
// harmonic too, but for a cut from border to border at which it begins anew. Both are stretched to lengths.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/refine.h"
#include "core/strategy/surface/pass_map.h"

namespace facetmill {

/// Whether rings serve a connected piece, wound outward: it has two borders to lie between, or one and bulges
/// by 180° or more over it; and rings come about as close together on all sides.
bool goes_round(const Mesh& piece, const Progress& progress);

/// The map of rings about a piece that goes round, from its higher border (or end) to the lower one; where v
/// grows lies to the right of growing u, seen from outside. Where it has one border alone its end is opened:
/// vertices and facets are added to it. Throws Error(internal) for a piece without a border.
PassMap ring_map(DerivedMesh& piece, const Progress& progress);

} // namespace facetmill
