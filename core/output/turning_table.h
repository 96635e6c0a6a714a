// The paths of a turning part as tables of positions, as Jasra's machine reads them (3.5, 4): one text file
// per roughing pass and one for finishing, a line per position with the turning angle, the place Y along the
// axis and the distance X of the tip from the axis. (He calls the axis that turns the part Z, the one along
// it Y and the radial one X.) Lines that start with '#' say what it is.
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/output/cl_program.h"
#include "core/strategy/plan/path.h"

#include <cstddef>
#include <vector>

namespace facetmill {

/// Motions [first, last) of a program.
struct TurningTableRange {
    int pass = -1; ///< of roughing, from 0; -1: all there is
    std::size_t first = 0, last = 0;
};

/// One range per layer of roughing, each with the way there and out again; one for everything else.
std::vector<TurningTableRange> turning_table_ranges(const ClProgram& program, const StrategyResult& path);

enum class AngleWinding { unwound, modulo };

/// Angles in degrees, about the axis by the right hand from TurnedPath::zero, of the tool round the part: the
/// part itself turns the other way. `unwound` angles grow turn after turn, `modulo` ones are within 0 and
/// 360. Lengths in the program's unit, six decimals. `X` is the distance along the radial direction, so that
/// a tool beside the centre line stands `offset` away from it. Throws Error(internal) for a program without a
/// turning axis, and what OutputFile throws. Cancellation per 4096 motions.
void write_turning_table(const ClProgram& program, const TurnedPath& turned, const TurningTableRange& range,
                         AngleWinding winding, OutputFile& file, const Progress& progress);

} // namespace facetmill
