#include "ui/icon_button.h"

#include <QToolButton>

namespace facetmill::ui {

QToolButton* icon_button(QWidget* parent, Icon which, const QString& tip, const char* name, int side) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setIcon(icon(which));
    button->setIconSize(QSize(side, side));
    button->setAutoRaise(true);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

} // namespace facetmill::ui
