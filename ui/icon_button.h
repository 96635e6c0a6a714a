// The buttons of panels and bars: an icon alone, with what it does as its tip.
#pragma once

#include "ui/icons.h"

class QToolButton;

namespace facetmill::ui {

/// Reached by Tab only: after a click the keys still mean what they meant in the view.
QToolButton* icon_button(QWidget* parent, Icon which, const QString& tip, const char* name, int side = 16);

} // namespace facetmill::ui
