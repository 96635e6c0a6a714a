// The commands of the headless program; each stands in a file of its own.
#pragma once

#include "app/cli_arguments.h"

namespace facetmill::cli {

Command info_command();
Command sample_command();
Command place_command();
Command repair_command();
Command plan_command();
Command simulate_command();
Command cspace_command();
Command drop_command();
Command render_command();
Command export_command();
Command report_command();
Command pack_command();
Command unpack_command();
Command template_command();
Command study_command();
Command tools_command();
Command reference_command();

/// All, in the order of the help.
const std::vector<Command>& commands();

/// The option --threads, and its use.
OptionInfo threads_option();
void use_threads(const Arguments& arguments);

} // namespace facetmill::cli
