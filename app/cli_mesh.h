// What the commands that read a mesh file have in common.
#pragma once

#include "app/cli_arguments.h"
#include "core/mesh/mesh_reading.h"

#include <vector>

namespace facetmill::cli {

/// The options with those put behind them that say how a mesh is read, beside --units: which objects of a 3MF
/// file, the relief of a picture, how closely facets follow the surfaces of a STEP or IGES file.
std::vector<OptionInfo> with_reading_options(std::vector<OptionInfo> options);
/// What they say; lengths are in --units. Throws Error(usage, out_of_range) that names the option.
MeshReading asked_reading(const Arguments& arguments);
/// Throws Error(usage) that names one of them which was given, where there is no mesh for them: a project
/// says it itself.
void refuse_reading_options(const Arguments& arguments);

} // namespace facetmill::cli
