#include "ui/unrolled_view.h"

#include "core/base/vec.h"
#include "ui/text.h"
#include "viz/palette.h"
#include "viz/path_tint.h"
#include "viz/round_ticks.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

constexpr double margin = 8, tick_length = 4, bar_width = 12, bar_gap = 10;
constexpr double angle_step = 90, full_turn = 360;

QString number(double v, double step) {
    const int digits = std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
    return QString::number(v, 'f', digits).replace(QChar('-'), QChar(0x2212));
}

} // namespace

UnrolledView::UnrolledView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("unrolled_view"));
    setFocusPolicy(Qt::StrongFocus);
    setToolTip(tr("Click or drag: the tool goes there. Arrows: along the path."));
}

void UnrolledView::set_path(UnrolledPathPtr path) {
    path_ = std::move(path);
    motion_.reset();
    image_ = {};
    empty_text_.clear();
    update();
}

void UnrolledView::clear(const QString& why) {
    set_path(nullptr);
    empty_text_ = why;
}

void UnrolledView::set_motion(std::optional<std::size_t> motion) {
    if (motion == motion_) return;
    motion_ = motion;
    update();
}

QRectF UnrolledView::frame(const QSize& size, const QFontMetricsF& fm, bool titled) const {
    const double left =
        margin + fm.height() + 4 + fm.horizontalAdvance(QStringLiteral("360°")) + tick_length + 3;
    const double widest = fm.horizontalAdvance(QStringLiteral("−000.00"));
    const double right = size.width() - margin - bar_gap - bar_width - tick_length - 3 - widest;
    const double top = margin + fm.height() * (titled ? 2.4 : 1.0);
    const double bottom = size.height() - margin - 2 * fm.height() - tick_length - 2;
    return {left, top, std::max(right - left, 20.0), std::max(bottom - top, 20.0)};
}

QRectF UnrolledView::frame() const {
    return frame(size(), QFontMetricsF(font()), false);
}

QPointF UnrolledView::place_of(double along, double angle) const {
    const QRectF in = frame();
    return {in.left() + in.width() * (along - path_->from) / (path_->to - path_->from),
            in.bottom() - in.height() * angle / full_turn};
}

QImage UnrolledView::image_for(const QSize& pixels) const {
    const UnrolledImage raw = unrolled_image(*path_, pixels.width(), pixels.height());
    return QImage(raw.rgba.data(), raw.width, raw.height, 4 * raw.width, QImage::Format_RGBA8888).copy();
}

void UnrolledView::paint(QPainter& p, const QSize& size, const QImage& image, bool titled) const {
    const QFontMetricsF fm(p.font());
    const QRectF in = frame(size, fm, titled);
    const QColor ink = titled ? QColor(Qt::black) : palette().color(QPalette::WindowText);
    QColor grid = ink;
    grid.setAlphaF(0.18f);
    p.drawImage(in, image);
    // Length along the axis.
    p.setPen(ink);
    const int most_x = std::max(2, int(in.width() / (fm.horizontalAdvance(QStringLiteral("−000.0")) + 16)));
    const double step_x = round_step(path_->to - path_->from, most_x);
    for (const double v : round_ticks(path_->from, path_->to, most_x)) {
        const double x = in.left() + in.width() * (v - path_->from) / (path_->to - path_->from);
        p.setPen(grid);
        p.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
        p.setPen(ink);
        p.drawLine(QPointF(x, in.bottom()), QPointF(x, in.bottom() + tick_length));
        p.drawText(QRectF(x - 60, in.bottom() + tick_length + 1, 120, fm.height()), int(Qt::AlignCenter),
                   number(v, step_x));
    }
    const QString unit = text(path_->unit);
    p.drawText(QRectF(in.left(), in.bottom() + tick_length + 2 + fm.height(), in.width(), fm.height()),
               int(Qt::AlignCenter), tr("Along the axis (%1)").arg(unit));
    // Turning angle.
    for (double v = 0; v <= full_turn; v += angle_step) {
        const double y = in.bottom() - in.height() * v / full_turn;
        p.setPen(grid);
        p.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
        p.setPen(ink);
        p.drawLine(QPointF(in.left() - tick_length, y), QPointF(in.left(), y));
        p.drawText(QRectF(0, y - fm.height() / 2, in.left() - tick_length - 3, fm.height()),
                   int(Qt::AlignRight | Qt::AlignVCenter), number(v, 1) + QChar(0x00B0));
    }
    p.save();
    p.translate(margin + fm.height() / 2, in.center().y());
    p.rotate(-90);
    p.drawText(QRectF(-in.height() / 2, -fm.height() / 2, in.height(), fm.height()), int(Qt::AlignCenter),
               tr("Turning angle"));
    p.restore();
    p.setBrush(Qt::NoBrush);
    p.drawRect(in);
    // Legend.
    const QRectF bar(in.right() + bar_gap, in.top(), bar_width, in.height());
    const int rows = std::max(2, int(bar.height()));
    for (int k = 0; k < rows; ++k) {
        const Rgb c = path_tint_color(1 - (k + 0.5) / rows);
        p.fillRect(
            QRectF(bar.left(), bar.top() + bar.height() * k / rows, bar.width(), bar.height() / rows + 1),
            QColor::fromRgbF(float(c.r), float(c.g), float(c.b)));
    }
    p.drawRect(bar);
    const int most_y = std::max(2, int(bar.height() / (2.2 * fm.height())));
    const double step_y = round_step(path_->high - path_->low, most_y);
    for (const double v : round_ticks(path_->low, path_->high, most_y)) {
        const double y = bar.bottom() - bar.height() * unrolled_share(*path_, v);
        p.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + tick_length, y));
        p.drawText(QPointF(bar.right() + tick_length + 3, y + fm.ascent() / 2 - 1), number(v, step_y));
    }
    const QString legend = tr("Depth (%1)").arg(unit);
    p.drawText(QRectF(size.width() - margin - 200, in.top() - fm.height() - 3, 200, fm.height()),
               int(Qt::AlignRight | Qt::AlignVCenter), legend);
    if (titled) {
        QFont bold = p.font();
        bold.setBold(true);
        p.setFont(bold);
        p.drawText(QRectF(in.left(), margin - 2, in.width(), fm.height()),
                   int(Qt::AlignLeft | Qt::AlignVCenter), text(path_->operation->name));
    }
}

void UnrolledView::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    if (!path_) {
        p.setPen(palette().color(QPalette::PlaceholderText));
        p.drawText(QRectF(rect()).adjusted(margin, margin, -margin, -margin),
                   int(Qt::AlignCenter) | int(Qt::TextWordWrap), empty_text_);
        return;
    }
    const QRectF in = frame();
    const QSize pixels = (in.size() * devicePixelRatioF()).toSize();
    if (image_.size() != pixels) image_ = image_for(pixels);
    paint(p, size(), image_, false);
    if (!motion_) return;
    const auto place = unrolled_place(*path_, *motion_);
    if (!place) return;
    const QPointF at = place_of(double(place->along), double(place->angle));
    p.setPen(QPen(Qt::black, 3));
    p.setBrush(Qt::NoBrush);
    p.drawEllipse(at, 6, 6);
    p.setPen(QPen(Qt::white, 1.5));
    p.drawEllipse(at, 6, 6);
}

QImage UnrolledView::picture(const QSize& size) const {
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    if (!path_) return image;
    QPainter p(&image);
    p.setRenderHint(QPainter::Antialiasing);
    QFont large = font();
    large.setPixelSize(std::max(12, size.height() / 40));
    p.setFont(large);
    paint(p, size, image_for(frame(size, QFontMetricsF(large), true).size().toSize()), true);
    return image;
}

void UnrolledView::take(const QPointF& at) {
    if (!path_) return;
    const QRectF in = frame();
    const double along =
        path_->from + (path_->to - path_->from) * std::clamp((at.x() - in.left()) / in.width(), 0.0, 1.0);
    const double angle = full_turn * std::clamp((in.bottom() - at.y()) / in.height(), 0.0, 1.0);
    if (const auto motion = unrolled_pick(*path_, along, angle, int(in.width()), int(in.height())))
        emit motion_wanted(*motion);
}

void UnrolledView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) take(event->position());
}

void UnrolledView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) take(event->position());
}

void UnrolledView::keyPressEvent(QKeyEvent* event) {
    const int by = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    if (event->key() == Qt::Key_Right || event->key() == Qt::Key_Up)
        emit stepped(by);
    else if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Down)
        emit stepped(-by);
    else
        QWidget::keyPressEvent(event);
}

} // namespace facetmill::ui
