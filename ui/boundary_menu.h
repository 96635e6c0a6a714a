// The menu of boundaries that can be added.
#pragma once

#include "ui/document.h"

#include <cstddef>
#include <functional>

class QMenu;
class QWidget;

namespace facetmill::ui {

/// `added`: a boundary was added at this place.
QMenu* boundary_menu(QWidget* parent, Document& document, const std::function<void(std::size_t)>& added);

} // namespace facetmill::ui
