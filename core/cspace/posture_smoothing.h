// Rotary axes that run evenly. Internal to this room.
//
// Where the feed decides the time the cheapest path has no opinion on axes that go to and fro. So stretches
// of it are pulled taut: between two of its stops the rotary axes run at an even speed, if every posture on
// the way is free. The longest stretches come first; what the border of the spaces does not let be pulled as
// a whole is pulled in pieces, so that an axis turns back only where it has to. Then single stops are drawn
// between their neighbours, which rounds the corners that are left.
#pragma once

#include "core/cspace/posture_stop.h"

#include <span>

namespace facetmill {

/// Changes postures of the first `own` stops of a path, of one per point, but for the first; those kept by
/// hand stay. No stretch takes longer by more than three thousandths for it.
void smooth_postures(const PostureStops& stops, std::span<const PassPoint> points, std::size_t own,
                     std::vector<PostureStop>& path, const Progress& progress);

} // namespace facetmill
