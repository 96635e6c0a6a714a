#include "ui/elided_label.h"

#include <QPainter>

namespace facetmill::ui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::set_text(const QString& text) {
    setText(text);
    setToolTip(text);
}

void ElidedLabel::set_elide_mode(Qt::TextElideMode mode) {
    mode_ = mode;
    update();
}

QSize ElidedLabel::minimumSizeHint() const {
    return {20, QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRect area = contentsRect().adjusted(std::max(0, indent()), 0, 0, 0);
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(area, int(alignment()), fontMetrics().elidedText(text(), mode_, area.width()));
}

} // namespace facetmill::ui
