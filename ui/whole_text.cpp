#include "ui/whole_text.h"

#include "ui/help.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHelpEvent>
#include <QLineEdit>
#include <QPainter>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QStyleOptionFrame>
#include <QToolTip>

namespace facetmill::ui {

namespace {

constexpr int beside_text = 2; ///< pixels that QLineEdit leaves on both sides of its text

QRect room_of(const QLineEdit& line) {
    QStyleOptionFrame option;
    option.initFrom(&line);
    option.lineWidth = line.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &line);
    return line.style()
        ->subElementRect(QStyle::SE_LineEditContents, &option, &line)
        .marginsRemoved(line.textMargins())
        .adjusted(beside_text, 0, -beside_text, 0);
}

int room_of(const QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    const int icon = box.itemIcon(box.currentIndex()).isNull() ? 0 : box.iconSize().width() + 4;
    return box.style()
               ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
               .width()
           - icon;
}

void paint_shortened(QLineEdit& line) {
    QPainter painter(&line);
    QStyleOptionFrame option;
    option.initFrom(&line);
    option.lineWidth = line.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &line);
    option.state |= QStyle::State_Sunken;
    line.style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, &line);
    const QRect room = room_of(line);
    painter.setPen(line.palette().color(QPalette::Text));
    painter.drawText(room, int(Qt::AlignLeft | Qt::AlignVCenter),
                     line.fontMetrics().elidedText(line.text(), Qt::ElideRight, room.width()));
}

} // namespace

QString shortened_text(const QWidget& widget) {
    const auto cut = [&](const QString& text, int room) {
        return widget.fontMetrics().horizontalAdvance(text) > room ? text : QString();
    };
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
        return line->echoMode() == QLineEdit::Normal ? cut(line->text(), room_of(*line).width()) : QString();
    if (const auto* box = qobject_cast<const QComboBox*>(&widget))
        return cut(box->currentText(), room_of(*box));
    return {};
}

QString with_whole_text(const QWidget& widget, const QString& tip) {
    const QString whole = shortened_text(widget);
    if (whole.isEmpty() || tip.contains(whole)) return tip;
    const QString first = QStringLiteral("<p><b>%1</b></p>").arg(whole.toHtmlEscaped());
    return first + (Qt::mightBeRichText(tip) ? tip : tip.toHtmlEscaped());
}

bool WholeText::eventFilter(QObject* object, QEvent* event) {
    auto* widget = static_cast<QWidget*>(object);
    switch (event->type()) {
    case QEvent::Paint:
        if (auto* line = qobject_cast<QLineEdit*>(widget);
            line && !line->hasFocus() && !shortened_text(*line).isEmpty()) {
            paint_shortened(*line);
            return true;
        }
        break;
    case QEvent::ToolTip: {
        // The form tells what belongs to a parameter.
        const QWidget* editor = widget->parentWidget();
        if (shortened_text(*widget).isEmpty()
            || (widget->toolTip().isEmpty() && editor && editor->property(help_key_property).isValid()))
            break;
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                           with_whole_text(*widget, widget->toolTip()), widget);
        return true;
    }
    case QEvent::MouseButtonPress:
    case QEvent::KeyPress:
        if (auto* box = qobject_cast<QComboBox*>(widget); box && box->count() > 0)
            box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0)
                                         + box->view()->verticalScrollBar()->sizeHint().width());
        break;
    default:
        break;
    }
    return QObject::eventFilter(object, event);
}

} // namespace facetmill::ui
