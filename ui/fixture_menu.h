// The menu of fixtures that can be added.
#pragma once

#include "ui/document.h"

#include <cstddef>
#include <functional>

class QMenu;
class QWidget;

namespace facetmill::ui {

/// `added`: a fixture was added at this place; `wants_mesh`: one that is a mesh is to be asked for, which is
/// done when that returns; `refused`: why none was added.
QMenu* fixture_menu(QWidget* parent, Document& document, const std::function<void(std::size_t)>& added,
                    const std::function<void(std::size_t)>& wants_mesh,
                    const std::function<void(const QString&)>& refused);

} // namespace facetmill::ui
