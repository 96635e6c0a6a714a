// Where the zero of a project's work coordinate system lies, and programs told from there. Everything else is
// in part coordinates, APT files as well.
#pragma once

#include "core/job/project.h"
#include "core/output/cl_program.h"

#include <string>

namespace facetmill {

struct PreparedPart; // planner.h

/// In part coordinates, mm. `stock`: its box. Throws Error(missing_reference) where the zero is on a stock
/// that is not there.
Vec3 work_zero(const ProgramSpec& spec, const Box3& part, const Box3& stock);
Vec3 work_zero(const Project& project, const PreparedPart& part);
/// "G54", or what the control has first; "zero" where no control is chosen or its file cannot be read.
std::string work_zero_name(const Project& project);
/// "the part's origin", "the stock's top, middle of X, low Y": what it is on; with `zero` behind, in the
/// unit, where that is not 0.
std::string work_zero_text(const ProgramSpec& spec, LengthUnit unit);

/// The same motions of the same tool, all places moved.
ClSection moved_section(const ClSection& section, const Vec3& by);

} // namespace facetmill
