// The fixtures of the shown setup: changes of their list, each as one step of the history.
#pragma once

#include "core/job/new_fixture.h"
#include "ui/document.h"

#include <cstddef>

namespace facetmill::ui {

/// Round the stock as it is known; returns the place of the first one. Only where the part was read as the
/// project says. Throws Error(empty_result) where tabs have no place.
std::size_t add_fixture(Document& document, NewFixture what);
/// Behind itself, beside it along Y.
void duplicate_fixture(Document& document, std::size_t i);
void remove_fixture(Document& document, std::size_t i);
/// Makes a mesh of it, from this file; behind the last one a new one.
void set_fixture_file(Document& document, std::size_t i, const std::filesystem::path& file);

} // namespace facetmill::ui
