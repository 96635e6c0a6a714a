#include "ui/unrolled_view.h"

#include "core/base/vec.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "viz/palette.h"
#include "viz/path_tint.h"
#include "viz/round_ticks.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

constexpr double margin = 8, tick_length = 4, label_gap = 3, bar_width = 12, bar_gap = 10;
/// Side of the smallest frame.
constexpr double min_frame = 64;
constexpr double angle_step = 90, full_turn = 360;
/// Share of the whole below which no less is shown.
constexpr double max_zoom = 1e-3;

/// Entries of the legend, as many as a bar of this height has room for.
std::vector<std::pair<double, QString>> depth_ticks(const UnrolledPath& path, double height,
                                                    const QFontMetricsF& fm) {
    const int most = std::max(2, int(height / (2.2 * fm.height())));
    const double step = round_step(path.high - path.low, most);
    std::vector<std::pair<double, QString>> ticks;
    for (const double v : round_ticks(path.low, path.high, most))
        ticks.emplace_back(v, tick_text(v, step));
    return ticks;
}

/// A title of one line with its middle at `middle`, or as near as it can be and end before `from` and `to`;
/// elided where there is less room than it needs.
void draw_title(QPainter& p, const QString& text, double middle, double from, double to, double top) {
    const QFontMetricsF fm(p.font());
    const double room = std::max(to - from, 0.0);
    const QString shown = fm.elidedText(text, Qt::ElideRight, room);
    const double width = std::min(std::ceil(fm.horizontalAdvance(shown)) + 1, room);
    const double left = std::max(std::min(middle - 0.5 * width, to - width), from);
    p.drawText(QRectF(left, top, width, fm.height()), int(Qt::AlignCenter | Qt::TextDontClip), shown);
}

} // namespace

UnrolledView::UnrolledView(QWidget* parent) : ChartView(parent) {
    setObjectName(QStringLiteral("unrolled_view"));
    setAccessibleName(tr("Unrolled path"));
    setToolTip(
        tr("Click or drag: the tool goes there. Arrows: along the path. Wheel: zoom. Right drag: move. "
           "Double click, Home: all."));
}

void UnrolledView::set_path(UnrolledPathPtr path) {
    path_ = std::move(path);
    motion_.reset();
    empty_text_.clear();
    updateGeometry(); // its legend needs room
    reset_view();
}

void UnrolledView::reset_view() {
    window_ = path_ ? unrolled_whole(*path_) : UnrolledWindow();
    image_ = {};
    update();
}

void UnrolledView::hold_window() {
    if (!path_) return;
    const UnrolledWindow all = unrolled_whole(*path_);
    const auto held = [](double& from, double& to, double least, double low, double high) {
        const double size = std::clamp(to - from, least, high - low);
        from = std::clamp(0.5 * (from + to) - 0.5 * size, low, high - size);
        to = from + size;
    };
    held(window_.from, window_.to, max_zoom * (all.to - all.from), all.from, all.to);
    held(window_.low, window_.high, max_zoom * full_turn, 0, full_turn);
    image_ = {};
    update();
}

void UnrolledView::zoom_at(const QPointF& about, double factor, bool) {
    if (!path_) return;
    const QRectF in = frame();
    const double x = std::clamp((about.x() - in.left()) / in.width(), 0.0, 1.0),
                 y = std::clamp((in.bottom() - about.y()) / in.height(), 0.0, 1.0);
    const double along = window_.from + x * (window_.to - window_.from),
                 angle = window_.low + y * (window_.high - window_.low);
    const double length = (window_.to - window_.from) / factor, turn = (window_.high - window_.low) / factor;
    window_ = {along - x * length, along + (1 - x) * length, angle - y * turn, angle + (1 - y) * turn};
    hold_window();
}

void UnrolledView::clear(const QString& why) {
    set_path(nullptr);
    empty_text_ = why;
}

void UnrolledView::set_motion(std::optional<std::size_t> motion) {
    if (motion == motion_) return;
    motion_ = motion;
    // What is zoomed follows the tool when it leaves.
    if (const auto place = motion && path_ && !dragged() ? unrolled_place(*path_, *motion) : std::nullopt) {
        const double along = double(place->along), angle = double(place->angle);
        const double dx =
            along < window_.from || along > window_.to ? along - 0.5 * (window_.from + window_.to) : 0;
        const double dy =
            angle < window_.low || angle > window_.high ? angle - 0.5 * (window_.low + window_.high) : 0;
        if (dx != 0 || dy != 0) {
            window_ = {window_.from + dx, window_.to + dx, window_.low + dy, window_.high + dy};
            hold_window();
        }
    }
    update();
}

QRectF UnrolledView::frame(const QSize& size, const QFontMetricsF& fm, bool titled) const {
    const double left =
        margin + fm.height() + 4 + fm.horizontalAdvance(QStringLiteral("360.0°")) + tick_length + label_gap;
    const double top = margin + fm.height() * (titled ? 2.4 : 1.0);
    const double bottom = size.height() - margin - 2 * fm.height() - tick_length - 2;
    const double height = std::max(bottom - top, min_frame);
    double widest = 0;
    if (path_)
        for (const auto& [unused, label] : depth_ticks(*path_, height, fm))
            widest = std::max(widest, fm.horizontalAdvance(label));
    const double right = size.width() - margin - bar_gap - bar_width - tick_length - label_gap - widest;
    return {left, top, std::max(right - left, min_frame), height};
}

QSize UnrolledView::minimumSizeHint() const {
    const QSize probe(1000, 1000);
    const QRectF in = frame(probe, QFontMetricsF(font()), false);
    return {probe.width() - int(in.width() - min_frame), probe.height() - int(in.height() - min_frame)};
}

QRectF UnrolledView::frame() const {
    return frame(size(), QFontMetricsF(font()), false);
}

QPointF UnrolledView::place_of(double along, double angle) const {
    const QRectF in = frame();
    return {in.left() + in.width() * (along - window_.from) / (window_.to - window_.from),
            in.bottom() - in.height() * (angle - window_.low) / (window_.high - window_.low)};
}

QImage UnrolledView::image_for(const QSize& pixels, const UnrolledWindow& window) const {
    const UnrolledImage raw = unrolled_image(*path_, window, pixels.width(), pixels.height());
    return QImage(raw.rgba.data(), raw.width, raw.height, 4 * raw.width, QImage::Format_RGBA8888).copy();
}

void UnrolledView::paint(QPainter& p, const QSize& size, const QImage& image, const UnrolledWindow& window,
                         bool titled) const {
    const QFontMetricsF fm(p.font());
    const QRectF in = frame(size, fm, titled);
    const QColor ink = titled ? to_qt(fixed_colors().paper.ink) : palette().color(QPalette::WindowText);
    QColor grid = ink;
    grid.setAlphaF(0.18f);
    p.drawImage(in, image);
    // Length along the axis.
    p.setPen(ink);
    const int max_x = std::max(2, int(in.width() / (fm.horizontalAdvance(QStringLiteral("−000.0")) + 16)));
    const double step_x = round_step(window.to - window.from, max_x);
    for (const double v : round_ticks(window.from, window.to, max_x)) {
        const double x = in.left() + in.width() * (v - window.from) / (window.to - window.from);
        p.setPen(grid);
        p.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
        p.setPen(ink);
        p.drawLine(QPointF(x, in.bottom()), QPointF(x, in.bottom() + tick_length));
        p.drawText(QRectF(x - 60, in.bottom() + tick_length + 1, 120, fm.height()), int(Qt::AlignCenter),
                   tick_text(v, step_x));
    }
    const QString unit = text(path_->unit);
    draw_title(p, tr("Along the axis (%1)").arg(unit), in.center().x(), margin, size.width() - margin,
               in.bottom() + tick_length + 2 + fm.height());
    // Turning angle: quarters of the turn, round steps where that is too coarse.
    const auto y_of = [&](double angle) {
        return in.bottom() - in.height() * (angle - window.low) / (window.high - window.low);
    };
    const int max_angles = std::max(2, int(in.height() / (2.2 * fm.height())));
    const bool quarters = window.high - window.low >= 2 * angle_step;
    const double step_angle = quarters ? angle_step : round_step(window.high - window.low, max_angles);
    std::vector<double> angles;
    if (quarters)
        for (double v = 0; v <= full_turn; v += angle_step)
            angles.push_back(v);
    else
        angles = round_ticks(window.low, window.high, max_angles);
    for (const double v : angles) {
        const double y = y_of(v);
        if (y < in.top() - 0.5 || y > in.bottom() + 0.5) continue;
        p.setPen(grid);
        p.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
        p.setPen(ink);
        p.drawLine(QPointF(in.left() - tick_length, y), QPointF(in.left(), y));
        p.drawText(QRectF(0, y - fm.height() / 2, in.left() - tick_length - label_gap, fm.height()),
                   int(Qt::AlignRight | Qt::AlignVCenter), tick_text(v, step_angle) + QChar(0x00B0));
    }
    // What the cutter cannot come to.
    p.save();
    p.setClipRect(in);
    p.setBrush(Qt::NoBrush);
    for (const UnrolledPath::Unreached& r : path_->unreached) {
        const auto x = [&](double v) {
            return in.left() + in.width() * (v - window.from) / (window.to - window.from);
        };
        const QRectF box = QRectF(QPointF(x(r.from), y_of(r.high)), QPointF(x(r.to), y_of(r.low)))
                               .adjusted(-2, -2, 2, 2); // seen, however small
        p.setPen(QPen(to_qt(fixed_colors().outline_ring), 2.5));
        p.drawRect(box);
        p.setPen(QPen(to_qt(fixed_colors().outline), 1.2, Qt::DashLine));
        p.drawRect(box);
    }
    p.restore();
    p.save();
    // Upward, from above the row of the other title.
    p.translate(margin, size.height());
    p.rotate(-90);
    draw_title(p, tr("Turning angle"), size.height() - in.center().y(), margin + fm.height(),
               size.height() - margin, 0);
    p.restore();
    p.setBrush(Qt::NoBrush);
    p.drawRect(in);
    // Legend.
    const QRectF bar(in.right() + bar_gap, in.top(), bar_width, in.height());
    const int rows = std::max(2, int(bar.height()));
    for (int k = 0; k < rows; ++k) {
        p.fillRect(
            QRectF(bar.left(), bar.top() + bar.height() * k / rows, bar.width(), bar.height() / rows + 1),
            to_qt(path_tint_color(1 - (k + 0.5) / rows)));
    }
    p.drawRect(bar);
    for (const auto& [v, label] : depth_ticks(*path_, bar.height(), fm)) {
        const double y = bar.bottom() - bar.height() * unrolled_share(*path_, v);
        p.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + tick_length, y));
        p.drawText(QPointF(bar.right() + tick_length + label_gap, y + fm.ascent() / 2 - 1), label);
    }
    draw_title(p, tr("Depth (%1)").arg(unit), size.width(), margin, size.width() - margin,
               in.top() - fm.height() - 3);
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
    if (image_.size() != pixels) image_ = image_for(pixels, window_);
    paint(p, size(), image_, window_, false);
    if (!motion_) return;
    const auto place = unrolled_place(*path_, *motion_);
    if (!place) return;
    const QPointF at = place_of(double(place->along), double(place->angle));
    if (!in.adjusted(-1, -1, 1, 1).contains(at)) return;
    p.setPen(QPen(to_qt(fixed_colors().outline), 3));
    p.setBrush(Qt::NoBrush);
    p.drawEllipse(at, 6, 6);
    p.setPen(QPen(to_qt(fixed_colors().outline_ring), 1.5));
    p.drawEllipse(at, 6, 6);
}

QImage UnrolledView::picture(const QSize& size) const {
    QImage image(size, QImage::Format_RGB32);
    image.fill(to_qt(fixed_colors().paper.ground));
    if (!path_) return image;
    QPainter p(&image);
    p.setRenderHint(QPainter::Antialiasing);
    QFont large = font();
    large.setPixelSize(std::max(12, size.height() / 40));
    p.setFont(large);
    const UnrolledWindow all = unrolled_whole(*path_);
    paint(p, size, image_for(frame(size, QFontMetricsF(large), true).size().toSize(), all), all, true);
    return image;
}

void UnrolledView::point_at(const QPointF& at) {
    if (!path_) return;
    const QRectF in = frame();
    const double along =
        window_.from + (window_.to - window_.from) * std::clamp((at.x() - in.left()) / in.width(), 0.0, 1.0);
    const double angle =
        window_.low
        + (window_.high - window_.low) * std::clamp((in.bottom() - at.y()) / in.height(), 0.0, 1.0);
    if (const auto motion = unrolled_pick(*path_, window_, along, angle, int(in.width()), int(in.height())))
        emit motion_wanted(*motion);
}

void UnrolledView::move_by(const QPointF& by) {
    const QRectF in = frame();
    const double dx = -by.x() / in.width() * (window_.to - window_.from),
                 dy = by.y() / in.height() * (window_.high - window_.low);
    window_ = {window_.from + dx, window_.to + dx, window_.low + dy, window_.high + dy};
    hold_window();
}

void UnrolledView::zoom_by_key(double factor) {
    zoom_at(frame().center(), factor, false);
}

void UnrolledView::keyPressEvent(QKeyEvent* event) {
    const int by = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    if (event->key() == Qt::Key_Up)
        emit stepped(by);
    else if (event->key() == Qt::Key_Down)
        emit stepped(-by);
    else
        ChartView::keyPressEvent(event);
}

} // namespace facetmill::ui
