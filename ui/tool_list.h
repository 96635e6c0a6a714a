// Changes of the project's tools, each as one step of the history.
#pragma once

#include "core/setup/tool_edit.h"
#include "ui/document.h"

#include <cstddef>

namespace facetmill::ui {

/// How names of tools are written in the language of the window.
ToolNameStyle spoken_tool_names();
/// "Kugel 2,5": what the program calls a tool by itself, in the language of the window.
std::string usual_tool_name_said(const Tool& tool, LengthUnit unit);
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
