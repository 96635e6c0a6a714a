// What of a setup serves other parts: its operations, the tools that they need, stock, machine, programs and
// limits. Kept as a project file of its own.
#pragma once

#include "core/job/project.h"

#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// The shown setup as a template. What belongs to the part is left out: painted and drawn boundaries,
/// fixtures, places of its surface. Throws what project_to_json does.
std::string template_text(const Project& project);

struct AppliedTemplate {
    Project project;
    std::vector<std::string> remarks; ///< sentences: what of the template does not fit this part or setup
};

/// The project with the template's operations in place of those of the shown setup, its stock, machine,
/// control and limits, and its tools beside those that are still used. Boundaries that
/// any part has come along, the others are taken by their names where the setup has them. `name` is what
/// messages call the template. Throws what parse_project does.
AppliedTemplate apply_template(std::string_view text, const std::string& name, const Project& project);

/// "3 operations, 2 tools". Throws likewise.
std::string template_summary(std::string_view text, const std::string& name);

} // namespace facetmill
