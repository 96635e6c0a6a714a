// The order of finishing passes. They are planned plane by plane over the whole part; where regions, holes or
// partial passes break them into pieces, cut in that order the tool would travel from piece to piece of every
// plane. What finishing leaves does not depend on the order, so one piece is followed by the nearest.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/plan/path.h"

namespace facetmill {

/// What the tool travels from the end of one pass to the start of the next, mm: straight, or up to `clear_z`
/// and down again, whichever is less.
double travel_between(const Vec3& from, const Vec3& to, double clear_z);

/// Passes whose ends are no farther apart than this, mm, seen from above, are linked on the surface: four
/// step-overs, or the cutter's radius where that is more.
double surface_link_distance(double stepover, double cutter_diameter);

/// Puts passes in an order in which the tool travels less between them; the first stays first. `either_way`:
/// passes may be turned round. Where that is no better than before, they stay as they are. The same order for
/// the same passes.
void order_by_travel(std::vector<Pass>& passes, bool either_way, double clear_z, const Progress& progress);

} // namespace facetmill
