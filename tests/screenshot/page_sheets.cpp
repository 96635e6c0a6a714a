#include "tests/screenshot/page_sheets.h"

#include "ui/viewport.h"

#include <QDir>
#include <QPainter>
#include <QTest>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace facetmill::test {

namespace {

constexpr int sheet_side = 1640, title_height = 18, sheet_gap = 8;

} // namespace

PageSheets::PageSheets(QString folder, QString name, double shrink)
    : folder_(std::move(folder)), name_(std::move(name)), shrink_(shrink) {
    QDir().mkpath(folder_);
}

void PageSheets::add(QWidget& widget, const QString& title) {
    QTest::qWait(60);
    if (auto* view = widget.findChild<ui::Viewport*>())
        (void)QTest::qWaitFor([view] { return view->finished(); });
    add(widget.grab().toImage(), title);
}

void PageSheets::add(const QImage& picture, const QString& title) {
    QImage shown = picture.convertToFormat(QImage::Format_RGB32);
    shown.setDevicePixelRatio(1);
    if (shrink_ > 1)
        shown = shown.scaled(shown.size() / shrink_, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    const int width = std::max(shown.width(), 180), height = shown.height() + title_height + sheet_gap;
    if (next_.x() > 0 && next_.x() + width > sheet_side) {
        next_ = QPoint(0, next_.y() + row_);
        row_ = 0;
    }
    if (next_.y() > 0 && next_.y() + height > sheet_side) write();
    placed_.push_back({shown, title, next_});
    next_.rx() += width + sheet_gap;
    row_ = std::max(row_, height);
}

void PageSheets::write() {
    if (placed_.empty()) return;
    QSize size;
    for (const Placed& p : placed_)
        size = size.expandedTo(QSize(p.at.x() + std::max(p.picture.width(), 180) + sheet_gap,
                                     p.at.y() + p.picture.height() + title_height + sheet_gap));
    QImage sheet(size, QImage::Format_RGB32);
    sheet.fill(Qt::magenta);
    QPainter painter(&sheet);
    painter.setPen(Qt::white);
    for (const Placed& p : placed_) {
        painter.drawText(p.at + QPoint(3, title_height - 5), p.title);
        painter.drawImage(p.at + QPoint(0, title_height), p.picture);
    }
    painter.end();
    sheet.save(QStringLiteral("%1/%2-%3.png").arg(folder_, name_).arg(++written_, 2, 10, QChar('0')));
    placed_.clear();
    next_ = {};
    row_ = 0;
}

} // namespace facetmill::test
