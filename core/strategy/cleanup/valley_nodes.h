// The corners in which valleys meet, and what is left ahead of ends that meet no other. Millimetres, part
// coordinates.
#pragma once

#include "core/strategy/cleanup/valley_runs.h"

namespace facetmill {

/// The runs as the curves of a result whose tips are known: open ends that came to the same place go on to
/// the centre of one corner, a node; single ones to as far as what they leave is the valley's.
void join_valleys(const ValleyInput& input, std::vector<ValleyRun> runs, Valleys& result);

} // namespace facetmill
