#include "ui/chart_view.h"

#include "ui/text.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {
constexpr double zoom_step = 1.25;
}

QString tick_text(double v, double step) {
    const int digits = std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
    return in_user_numbers(QString::number(v, 'f', digits)).replace(QChar('-'), QChar(0x2212));
}

ChartView::ChartView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
}

void ChartView::mousePressEvent(QMouseEvent* event) {
    if (!filled() || drag_) return;
    const bool left = event->button() == Qt::LeftButton, shift = event->modifiers() & Qt::ShiftModifier;
    if (left && !shift) {
        drag_.begin(Drag::place, event->position());
        point_at(event->position());
    } else if (left || event->button() == Qt::RightButton || event->button() == Qt::MiddleButton) {
        drag_.begin(Drag::move, event->position());
    }
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
    const auto by = drag_.travel(*event);
    if (!by || !filled()) return;
    if (drag_.kind() == Drag::place)
        point_at(event->position());
    else
        move_by(*by);
}

void ChartView::mouseReleaseEvent(QMouseEvent*) {
    drag_.end();
}

void ChartView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) reset_view();
}

void ChartView::wheelEvent(QWheelEvent* event) {
    // With Alt the system turns it sideways.
    const double upward = wheel_steps(*event), steps = upward != 0 ? upward : event->angleDelta().x() / 120.0;
    if (steps == 0 || !filled()) return;
    zoom_at(event->position(), std::pow(zoom_step, steps), event->modifiers() & Qt::ControlModifier);
    event->accept();
}

void ChartView::keyPressEvent(QKeyEvent* event) {
    const int by = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (event->key()) {
    case Qt::Key_Left:
        return emit stepped(-by);
    case Qt::Key_Right:
        return emit stepped(by);
    case Qt::Key_Home:
        return reset_view();
    case Qt::Key_Plus:
        return zoom_by_key(zoom_step);
    case Qt::Key_Minus:
        return zoom_by_key(1 / zoom_step);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace facetmill::ui
