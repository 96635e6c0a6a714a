// The places that a cutter with vertical axis may take nearest to a place of the part. Millimetres, part
// coordinates.
#pragma once

#include "core/strategy/cleanup/valley.h"

#include <span>

namespace facetmill {

/// Where a cutter with vertical axis comes nearest to touching the part at p, whose unit normal is n, and
/// how far from p it stays. n.z must not be below -tolerance::vertical_normal_z.
RestSample nearest_touch(const ValleyInput& input, const Vec3& p, const Vec3& n, LiftHint& hint);
/// The same for many at once, sooner where they are close together: `point` and `normal` are given.
void nearest_touches(const ValleyInput& input, std::span<RestSample> samples, const Progress& progress);
/// The cutter moved from there to where it is nearer to the same place, in ever smaller steps down to
/// `finest`, until it is no farther away than `enough`. Noise turns a facet's normal, and a flank beside it
/// holds the cutter up: so the position that the normal asks for may not be the nearest. Where it is to be no
/// farther away than `hopeless`, the search ends once what a step can gain is not enough.
RestSample nearest_about(const ValleyInput& input, RestSample from, double enough, double finest,
                         LiftHint& hint, double hopeless = infinity);

} // namespace facetmill
