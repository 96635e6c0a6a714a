// The corners in which valleys meet, and what is left ahead of ends that meet no other. Millimetres, part
// coordinates.
#pragma once

#include "core/strategy/cleanup/valley.h"

namespace facetmill {

/// Ends that came to the same place go on to the centre of one corner, a node; single ones as far as what
/// they leave is the valley's. `open` says which ends of the curves a third flank made. Tips have their
/// curves.
void join_valleys(const ValleyInput& input, const std::vector<std::array<bool, 2>>& open, Valleys& valleys);

} // namespace facetmill
