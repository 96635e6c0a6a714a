#include "ui/log_view.h"

#include "ui/theme.h"

#include <QScrollBar>
#include <QTime>

namespace facetmill::ui {

LogView::LogView(QWidget* parent) : QPlainTextEdit(parent) {
    setObjectName(QStringLiteral("log"));
    setReadOnly(true);
    setFrameShape(QFrame::NoFrame);
    setMaximumBlockCount(5000);
    setLineWrapMode(QPlainTextEdit::WidgetWidth);
    setPlaceholderText(tr("Nothing has happened yet."));
}

void LogView::add(MessageBar::Kind kind, const QString& line) {
    const SignalColours signal = signal_colours(palette());
    const QColor colour = kind == MessageBar::Kind::error     ? signal.bad
                          : kind == MessageBar::Kind::warning ? signal.attention
                                                              : palette().color(QPalette::Text);
    const QScrollBar* bar = verticalScrollBar();
    const bool at_end = bar->value() >= bar->maximum() - 2;
    appendHtml(
        QStringLiteral("<span style=\"color:%1\">%2&nbsp;&nbsp;</span><span style=\"color:%3\">%4</span>")
            .arg(signal.quiet.name(), QTime::currentTime().toString(QStringLiteral("HH:mm:ss")),
                 colour.name(), line.toHtmlEscaped()));
    if (at_end) verticalScrollBar()->setValue(verticalScrollBar()->maximum());
}

} // namespace facetmill::ui
