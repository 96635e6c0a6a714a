// The tools that a project begins with, as workshops have them: of standard diameters, chosen by the part's
// size until a user says otherwise.
#pragma once

#include "core/job/project.h"
#include "core/setup/tool_edit.h"

namespace facetmill {

/// A diameter that is sold, not above `target` (mm) and a little above it where it is smaller than all of
/// them; a round number of the unit where it is much smaller.
double usual_diameter(double target, LengthUnit unit);

/// How long a tool's shank is around a part so high: past the part, however deep the tool goes, and out of
/// the holder by what one can read off a rule. Millimetres.
double usual_shank_length(const Tool& tool, double part_height, LengthUnit unit);

/// The ball that finishes a part of this size (mm): an eighth of the narrower side that lies flat.
Tool usual_finishing_tool(const Vec3& part_size, LengthUnit unit);
/// What finishing with it may leave: no less than machines hold, no more than a hundredth of it, mm.
double usual_tolerance(const Tool& tool, const Vec3& part_size, LengthUnit unit);

/// The flat that roughs for a list of tools that has none: twice as wide as the largest of them, as far as
/// spindles of a workshop hold that, with its number and name. The list is not empty.
Tool usual_roughing_tool(const Project& project);

/// Tools whose shank is as long as that for a part of one height get the length for another: what a user
/// wrote stays.
void follow_part_height(Project& project, double before, double after);
/// The part lies another way, and is so large (mm) instead: shanks follow its height, and where the only tool
/// and the tolerances are still those that the project began with, they become what it would begin with now.
/// `style`: how the tool may be named, and is.
void follow_part_size(Project& project, const Vec3& before, const Vec3& after,
                      const ToolNameStyle& style = {});

} // namespace facetmill
