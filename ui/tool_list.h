// Changes of the project's tools, each as one step of the history.
#pragma once

#include "ui/document.h"

#include <cstddef>

namespace facetmill::ui {

void add_tool(Document& document, const Tool& tool);
/// Operations and boundaries stay with the tool when it gets another number.
void set_tool(Document& document, std::size_t i, const Tool& tool);
/// Behind it, with a free number.
void duplicate_tool(Document& document, std::size_t i);
/// Throws Error(missing_reference) when an operation or a boundary uses it.
void remove_tool(Document& document, std::size_t i);

} // namespace facetmill::ui
