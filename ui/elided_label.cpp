#include "ui/elided_label.h"

#include <QPainter>

namespace facetmill::ui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::set_text(const QString& text, const QStringList& shorter) {
    shorter_ = shorter;
    setText(text);
    setToolTip(text);
    update(); // the shorter ones may be other ones
}

QRect ElidedLabel::text_area() const {
    return contentsRect().adjusted(std::max(0, indent()), 0, 0, 0);
}

QString ElidedLabel::shown_text() const {
    const int room = text_area().width();
    QString said = text();
    for (const QString& each : shorter_) {
        if (fontMetrics().horizontalAdvance(said) <= room) break;
        said = each;
    }
    return fontMetrics().elidedText(said, mode_, room);
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
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(text_area(), int(alignment()), shown_text());
}

} // namespace facetmill::ui
