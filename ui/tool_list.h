// Changes of the project's tools, each as one step of the history.
#pragma once

#include "ui/document.h"

#include <cstddef>

namespace facetmill::ui {

/// "Kugel 6": what the program calls a tool by itself, in the language of the window.
std::string usual_tool_name_said(const Tool& tool, LengthUnit unit);
/// The word for a shape in a tool's name, likewise.
std::string say_shape(const std::string& english);
/// The same for all tools of a project that have the usual English name.
void name_tools(Project& project);

void add_tool(Document& document, const Tool& tool);
/// Operations and boundaries stay with the tool when it gets another number.
void set_tool(Document& document, std::size_t i, const Tool& tool);
/// Behind it, with a free number.
void duplicate_tool(Document& document, std::size_t i);
/// Throws Error(missing_reference) when an operation or a boundary uses it.
void remove_tool(Document& document, std::size_t i);

} // namespace facetmill::ui
