// Changes of several operations of the shown setup at once, each one step of the history.
#pragma once

#include "ui/document.h"

#include <cstddef>

namespace facetmill::ui {

/// The operation has a tool axis of its own (3+2).
bool has_tool_axis(const Document& document, std::size_t operation);
/// All operations of the setup that have one get that of this one; returns how many changed.
std::size_t share_tool_axis(Document& document, std::size_t operation);

} // namespace facetmill::ui
