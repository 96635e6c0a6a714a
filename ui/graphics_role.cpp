#include "ui/graphics_role.h"

#include "ui/chart_view.h"
#include "ui/gl_canvas.h"

#include <QAccessibleWidget>

namespace facetmill::ui {

namespace {

QAccessibleInterface* graphic_of(const QString&, QObject* object) {
    auto* widget = qobject_cast<QWidget*>(object);
    const bool draws = dynamic_cast<GlCanvas*>(widget) || dynamic_cast<ChartView*>(widget);
    return draws ? new QAccessibleWidget(widget, QAccessible::Graphic) : nullptr;
}

} // namespace

void tell_graphics() {
    QAccessible::installFactory(graphic_of); // known already, it is not taken twice
}

} // namespace facetmill::ui
