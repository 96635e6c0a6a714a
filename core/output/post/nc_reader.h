// Programs of a control, read back: what the machine will do, whoever wrote them.
//
// The reader follows the modes that the post's codes set (units, feeds, tool length, work coordinates, TCP)
// and takes nothing for granted: a number without a unit, a cut without feed or spindle, a tool length that
// is not called, a tool change or a motion of X, Y and rotary axes while the tool is neither up nor at a
// known height, a work coordinate system other than the setup's, a place out of travel and every word that
// the control's file does not know are refused with their line.
#pragma once

#include "core/base/progress.h"
#include "core/output/cl_program.h"
#include "core/output/post/post.h"
#include "core/setup/kinematics.h"
#include "core/setup/machine.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct NcTool {
    std::string name;
    AptCutter cutter;
    double gauge_length = 0;
};

/// What the program will be run on.
struct NcSetup {
    Machine machine;
    Vec3 part_origin = Vec3::Zero(); ///< as in PostSetup
    std::string wcs;                 ///< where the part's origin lies; empty: the post's first
    std::map<long, NcTool> tools;
    std::optional<TurningAxis> turning; ///< of a part that turns: places are joined round it
    /// Even motions of the joints come back as motions of the tool that are as near as this to them.
    double tip_tolerance = 0.0005, axis_tolerance = 0.0005;
};

struct NcProgram {
    std::vector<std::shared_ptr<const ClSection>> sections; ///< one for each tool in its turn
    std::vector<std::vector<std::uint32_t>> lines;          ///< of each section's motions
    /// Where the rotary axes stand after each motion of each section, radians; empty for one in which the
    /// control chooses how to hold an axis that is told as a vector.
    std::vector<std::vector<Joints>> joints;
    std::size_t blocks = 0; ///< that move something
    double seconds = 0;     ///< of all motion, for each tool between the first place that is come down to and
                            ///< the last retract
    Box3 reach;             ///< of X, Y, Z in the machine's frame
};

/// Throws Error(syntax, truncated, out_of_range, missing_key, missing_reference, empty_result, encoding)
/// whose place is "file:line".
NcProgram read_nc(std::string_view text, const std::string& file, const Post& post, const NcSetup& setup,
                  const Progress& progress);

} // namespace facetmill
