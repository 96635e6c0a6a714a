#include "ui/log_view.h"

#include "ui/text.h"
#include "ui/theme.h"

#include <QEvent>
#include <QScrollBar>
#include <QTime>

namespace facetmill::ui {

namespace {

constexpr int max_entries = 5000;

} // namespace

LogView::LogView(QWidget* parent) : QPlainTextEdit(parent) {
    setObjectName(QStringLiteral("log"));
    setAccessibleName(tr("Log"));
    setReadOnly(true);
    setFrameShape(QFrame::NoFrame);
    setMaximumBlockCount(max_entries);
    setLineWrapMode(QPlainTextEdit::WidgetWidth);
    setPlaceholderText(tr("Nothing has happened yet."));
}

void LogView::add(MessageBar::Kind kind, const QString& line) {
    if (entries_.size() >= max_entries) entries_.erase(entries_.begin(), entries_.begin() + max_entries / 10);
    entries_.push_back({kind, QTime::currentTime().toString(QStringLiteral("HH:mm:ss")), line});
    const QScrollBar* bar = verticalScrollBar();
    const bool at_end = bar->value() >= bar->maximum() - 2;
    append(entries_.back());
    if (at_end) verticalScrollBar()->setValue(verticalScrollBar()->maximum());
}

void LogView::append(const Entry& entry) {
    const SignalColors signal = signal_colors(palette());
    const QColor color = entry.kind == MessageBar::Kind::error     ? signal.bad
                         : entry.kind == MessageBar::Kind::warning ? signal.attention
                                                                   : palette().color(QPalette::Text);
    appendHtml(
        QStringLiteral("<span style=\"color:%1\">%2&nbsp;&nbsp;</span><span style=\"color:%3\">%4</span>")
            .arg(signal.quiet.name(), entry.time, color.name(), kept_together(entry.line).toHtmlEscaped()));
}

void LogView::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || entries_.empty()) return;
    clear(); // the lines are written in colours of the palette
    for (const Entry& entry : entries_)
        append(entry);
    verticalScrollBar()->setValue(verticalScrollBar()->maximum());
}

} // namespace facetmill::ui
