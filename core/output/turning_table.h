// The paths of a turning part as tables of positions, as Jasra's machine reads them (3.5, 4): one text file
// per roughing pass and one for finishing, a line per position with the turning angle, the place Y along the
// axis and the distance X of the tip from the axis. (He calls the axis that turns the part Z, the one along
// it Y and the radial one X.) Lines that start with '#' say what it is.
//
// Angles in degrees, about the axis by the right hand from ClTurning::zero, of the tool round the part: the
// part itself turns the other way. `unwound` angles grow turn after turn, `modulo` ones are within 0 and
// 360. Lengths in the program's unit, six decimals. `X` is the distance along the radial direction, so that
// a tool beside the centre line stands `offset` away from it.
//
// The writer registers itself as "turning-table"; it takes programs of one section that turns the part.
#pragma once

#include "core/output/cl_program.h"
#include "core/strategy/plan/path.h"

#include <vector>

namespace facetmill {

/// One range per layer of roughing, each with the route there and out again; one for everything else.
std::vector<ClRange> turning_ranges(const ToolMotions& motions, const StrategyResult& path);

} // namespace facetmill
