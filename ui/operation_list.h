// Changes of the operations of the shown setup, beside those that a form makes: each is one step of the
// history.
#pragma once

#include "core/base/vec.h"
#include "ui/document.h"

#include <QStringList>

#include <cstddef>
#include <string>
#include <string_view>

namespace facetmill::ui {

/// What a new operation of this kind is called, in the user's language: "Finish".
std::string first_name_of(const std::string& kind);
/// Names the operations of a new project so.
void name_operations(Project& project);

/// The operation has a tool axis of its own (3+2).
bool has_tool_axis(const Document& document, std::size_t operation);
/// Changes that of an operation that has one: a step of the history where it is another.
void set_tool_axis(Document& document, std::size_t operation, const Vec3& axis);
/// All operations of the setup that have one get that of this one; returns how many changed.
std::size_t share_tool_axis(Document& document, std::size_t operation);

void duplicate_operation(Document& document, std::size_t operation);
/// Up (-1) or down (+1) if it can go there.
void move_operation(Document& document, std::size_t operation, int by);
void switch_operation(Document& document, std::size_t operation, bool off);
/// To another place, before the operation that stands at `at` of a setup, or behind its last one. The shown
/// setup stays shown. True where it was another place.
bool place_operation(Document& document, std::size_t operation, std::size_t setup, std::size_t at);
/// What a paste made: the place of the first operation, and what could not be taken along.
struct Pasted {
    std::size_t place = 0;
    QStringList remarks;
};
/// Operations that were copied (copied_operations.h), behind the one at `after`, or behind the last one.
/// Throws what pasted_operations does.
Pasted paste_operations(Document& document, std::string_view copied, std::optional<std::size_t> after);

} // namespace facetmill::ui
