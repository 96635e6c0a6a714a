// Tool axes of the operations of the shown setup: each change is one step of the history.
#pragma once

#include "core/base/vec.h"
#include "ui/document.h"

#include <cstddef>

namespace facetmill::ui {

/// The operation has a tool axis of its own (3+2).
bool has_tool_axis(const Document& document, std::size_t operation);
/// Changes that of an operation that has one: a step of the history where it is another.
void set_tool_axis(Document& document, std::size_t operation, const Vec3& axis);
/// All operations of the setup that have one get that of this one; returns how many changed.
std::size_t share_tool_axis(Document& document, std::size_t operation);

} // namespace facetmill::ui
