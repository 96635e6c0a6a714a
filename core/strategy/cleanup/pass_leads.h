// Smooth runs into passes of clean-up and out of them. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/cleanup_job.h"

namespace facetmill {

/// Adds to each end an arc that leaves along the pass and turns upwards. Where the arc meets the part, a
/// straight move along the normal at that end; where both do, nothing. The pass has two points or more.
/// `front`, `back`: which ends get one.
void add_leads(const StripCutting& with, Pass& pass, bool front = true, bool back = true);

/// Adds leads to upright passes in the order in which they are cut, at the ends between which the tool goes
/// up and down, farther apart than `linked` seen from above. Nearer ones are joined along the surface. None
/// where shank or holder would touch.
void lead_between(const CleanupJob& job, std::vector<Pass>& passes, double linked, const Progress& progress);

} // namespace facetmill
