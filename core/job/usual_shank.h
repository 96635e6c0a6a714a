// How long the shanks of a project's tools are until a user says so.
#pragma once

#include "core/job/project.h"

namespace facetmill {

/// The shank of the tool of a new project around so high a part: past the part, however deep the tool goes,
/// and out of the holder by what one can read off a rule. Millimetres.
double usual_shank_length(const Tool& tool, double part_height, LengthUnit unit);

/// Tools whose shank is as long as that for a part of one height get the length for another, as when the part
/// is laid down: what a user wrote stays.
void follow_part_height(Project& project, double before, double after);

} // namespace facetmill
