// The reference page of all parameters, from their descriptions.
#pragma once

#include <string>

namespace facetmill {

/// Markdown: the project file, part, stock, machines, tools, every registered operation. Ranges and defaults
/// in mm.
std::string reference_page();

} // namespace facetmill
