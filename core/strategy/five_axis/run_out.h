// How far a pass goes on beyond its last contact place, so that the tool has cleared its strip to the border.
//
// Every pose holds a point of every line of the strip (core/cspace/README.md, "Top"), but not the point
// abreast of the contact: a tool that is turned aside holds a line on the far side well behind. Along the
// pass that does not matter, since what is held moves on with the tool; at the border the tool has to go on
// until the ends of all lines have been held.
#pragma once

#include "core/strategy/five_axis/five_axis_field.h"

#include <optional>

namespace facetmill {

/// A further place of the pass after its end (`last`) or before its beginning, for the posture that it has
/// there; none where none is needed or it is not free. `end` is the last place, or the first.
std::optional<ContactPlace> run_out(const FiveAxisField& field, const SurfaceLine& line,
                                    const ContactPlace& end, const PostureValue& posture, int travel,
                                    bool last);

} // namespace facetmill
