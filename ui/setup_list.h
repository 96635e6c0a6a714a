// The setups of a document: going from one to another, and changes of their list, each as one step of the
// history.
#pragma once

#include "ui/document.h"

#include <cstddef>

namespace facetmill::ui {

/// The document shows another setup; what was planned of this one waits.
void choose_setup(Document& document, std::size_t i);

/// How a new setup holds the part.
enum class NewSetup { as_it_lies, flipped_about_x, flipped_about_y };
/// After the chosen one, with its machine and control, to go on with what that leaves; it is chosen. Turned
/// over about the middle of the part, whose box stays where it is, as the zero on it does. Only where the
/// part was read as the project says.
void add_setup(Document& document, NewSetup how);
/// Behind itself, with operations and names of their own; the copy is chosen.
void duplicate_setup(Document& document, std::size_t i);
/// Throws Error(missing_reference) for the only one, and where the first would go on with what is gone.
void remove_setup(Document& document, std::size_t i);
/// Moves it up (-1) or down (+1) if it can go there. Throws likewise.
void move_setup(Document& document, std::size_t i, int by);

} // namespace facetmill::ui
