// Operations on their way from one project to another, through the clipboard: a project file of their own,
// with the tools and boundaries that they use.
#pragma once

#include "core/job/project.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// One operation of the shown setup as text. Throws what project_to_json does.
std::string copied_operation(const Project& project, std::size_t operation);
/// True where a text may be one: it is looked at no further.
bool may_be_operations(std::string_view text);

struct PastedOperations {
    std::vector<std::unique_ptr<Operation>> operations; ///< named and numbered for the other project
    std::vector<Tool> tools;                            ///< that it does not have, with free numbers
    std::vector<std::string> remarks;                   ///< sentences: what of them could not be taken along
};

/// For the shown setup of a project, which stays as it is. A tool that is the same there but for its number
/// is that one; boundaries are taken by their names where the setup has them; postures and regions that were
/// kept for places of another part are left behind. Throws what parse_project does, its place "clipboard".
PastedOperations pasted_operations(std::string_view text, const Project& project);
/// The same for the operations of another project's shown setup.
PastedOperations pasted_operations(const Project& from, const Project& project);

} // namespace facetmill
