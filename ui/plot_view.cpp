#include "ui/plot_view.h"

#include "core/base/vec.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "viz/palette.h"
#include "viz/round_ticks.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill::ui {

namespace {

constexpr double margin = 8, tick_length = 4, key_gap = 14, key_sample = 18;
constexpr double headroom = 0.06; ///< share of the height, above and below the curves
/// Limits are in view from the beginning where they leave the curves at least this share of the height.
constexpr double min_share = 0.4;
constexpr double mark_room =
    14; ///< along the axis for one in full size; where there is less they are smaller

QString number(double v, double step) {
    // As many digits as tell neighbouring ticks apart.
    const int digits = std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
    return QString::number(v, 'f', digits).replace(QChar('-'), QChar(0x2212));
}

std::array<QColor, 3> lines_of(const Colors& colors) {
    const auto& lines = colors.chart_lines;
    return {to_qt(lines[0]), to_qt(lines[1]), to_qt(lines[2])};
}

} // namespace

struct PlotView::Look {
    QColor ground, ink, quiet, grid, cursor;
    std::array<QColor, 3> series;
    QFont font;
};

PlotView::PlotView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("plot_view"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(false);
}

void PlotView::set_content(PlotContent content) {
    content_ = std::move(content);
    empty_text_.clear();
    whole_ = whole();
    view_ = whole_;
    redraw();
}

void PlotView::clear(const QString& why) {
    content_ = {};
    empty_text_ = why;
    cursor_.reset();
    redraw();
}

void PlotView::set_cursor(std::optional<double> x) {
    if (x == cursor_) return;
    cursor_ = x;
    // What is zoomed follows the cursor when it leaves.
    if (x && drag_ == Drag::none && (*x < view_.left() || *x > view_.right())) {
        view_.moveLeft(*x - view_.width() / 2);
        hold_view();
        redraw();
    }
    update();
}

QRectF PlotView::whole() const {
    if (content_.x.empty()) return {0, 0, 1, 1};
    double low = infinity, high = -infinity;
    for (const PlotSeries& s : content_.series)
        for (const double v : s.y)
            if (std::isfinite(v)) {
                low = std::min(low, v);
                high = std::max(high, v);
            }
    if (low > high) low = high = 0;
    if (high - low < 1e-9 * std::max({1.0, std::abs(low), std::abs(high)})) {
        low -= 0.5;
        high += 0.5;
    }
    // The nearest first.
    std::vector<double> limits;
    for (const PlotSeries& s : content_.series)
        for (const double v : {s.low_limit, s.high_limit})
            if (std::isfinite(v)) limits.push_back(v);
    const double curves = high - low, middle = (low + high) / 2;
    std::sort(limits.begin(), limits.end(),
              [&](double a, double b) { return std::abs(a - middle) < std::abs(b - middle); });
    for (const double v : limits) {
        const double with_low = std::min(low, v), with_high = std::max(high, v);
        if (curves < min_share * (with_high - with_low)) break;
        low = with_low;
        high = with_high;
    }
    const double more = headroom * (high - low);
    const double first = content_.x.front(), last = std::max(content_.x.back(), first + 1e-9);
    return {first, low - more, last - first, high - low + 2 * more};
}

void PlotView::redraw() {
    drawn_ = false;
    update();
}

void PlotView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    redraw(); // another palette or font
}

void PlotView::reset_view() {
    view_ = whole_;
    redraw();
}

void PlotView::hold_view() {
    const double least = 1e-5 * whole_.width();
    view_.setWidth(std::clamp(view_.width(), least, whole_.width()));
    view_.moveLeft(std::clamp(view_.left(), whole_.left(), whole_.right() - view_.width()));
    view_.setHeight(std::clamp(view_.height(), 1e-4 * whole_.height(), 40 * whole_.height()));
    // The curves do not get lost.
    view_.moveTop(
        std::clamp(view_.top(), whole_.top() - 0.9 * view_.height(), whole_.bottom() - 0.1 * view_.height()));
}

void PlotView::zoom_x(double about, double factor) {
    const double width = std::clamp(view_.width() / factor, 1e-5 * whole_.width(), whole_.width());
    const double share = (about - view_.left()) / view_.width();
    view_.setLeft(about - share * width);
    view_.setWidth(width);
    hold_view();
    redraw();
}

QRectF PlotView::frame(const QSize& size, bool titled) const {
    const QFontMetricsF fm(font());
    double widest = 0;
    const int most = std::max(3, int(size.height() / (2 * fm.height())));
    const double step = round_step(view_.height(), most);
    for (const double v : round_ticks(view_.top(), view_.bottom(), most))
        widest = std::max(widest, fm.horizontalAdvance(number(v, step)));
    const double left = margin + widest + tick_length + 4;
    const double top = margin + fm.height() + 6 + (titled ? 1.6 * fm.height() : 0);
    const double bottom = size.height() - margin - 2 * fm.height() - tick_length - 2;
    return {left, top, std::max(10.0, size.width() - left - 2 * margin), std::max(10.0, bottom - top)};
}

QPointF PlotView::place_of(double x, double y, const QRectF& in) const {
    return {in.left() + (x - view_.left()) / view_.width() * in.width(),
            in.bottom() - (y - view_.top()) / view_.height() * in.height()};
}

QPointF PlotView::place_of(double x, double y) const {
    return place_of(x, y, frame(size(), false));
}

double PlotView::x_at(double pixel) const {
    const QRectF in = frame(size(), false);
    const double x = view_.left() + (pixel - in.left()) / in.width() * view_.width();
    return std::clamp(x, whole_.left(), whole_.right());
}

void PlotView::paint_axes(QPainter& p, const QRectF& in, const Look& look) const {
    const QFontMetricsF fm(look.font);
    p.setRenderHint(QPainter::Antialiasing, false);
    // Upright.
    // In a low chart closer together: one tick alone says nothing.
    const int max_y = std::max(
        {3, int(in.height() / (1.6 * fm.height())), std::min(5, int(in.height() / (1.1 * fm.height())))});
    const double step_y = round_step(view_.height(), max_y);
    for (const double v : round_ticks(view_.top(), view_.bottom(), max_y)) {
        const double y = std::round(place_of(view_.left(), v, in).y()) + 0.5;
        p.setPen(look.grid);
        p.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
        p.setPen(look.ink);
        p.drawLine(QPointF(in.left() - tick_length, y), QPointF(in.left(), y));
        p.drawText(QRectF(0, y - fm.height() / 2, in.left() - tick_length - 3, fm.height()),
                   int(Qt::AlignRight | Qt::AlignVCenter), number(v, step_y));
    }
    // Along.
    const double wide = fm.horizontalAdvance(QStringLiteral("−00000.0"));
    const int max_x = std::max(2, int(in.width() / (1.4 * wide)));
    const double step_x = round_step(view_.width(), max_x);
    double written = -infinity;
    for (const double v : round_ticks(view_.left(), view_.right(), max_x)) {
        const double x = std::round(place_of(v, view_.top(), in).x()) + 0.5;
        p.setPen(look.grid);
        p.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
        p.setPen(look.ink);
        p.drawLine(QPointF(x, in.bottom()), QPointF(x, in.bottom() + tick_length));
        const QString label = number(v, step_x);
        const double w = fm.horizontalAdvance(label);
        if (x - w / 2 < written + 6) continue;
        p.drawText(QRectF(x - w, in.bottom() + tick_length + 1, 2 * w, fm.height()), int(Qt::AlignCenter),
                   label);
        written = x + w / 2;
    }
    p.setPen(look.ink);
    p.drawRect(QRectF(std::round(in.left()) + 0.5, std::round(in.top()) + 0.5, std::round(in.width()) - 1,
                      std::round(in.height()) - 1));
    const QString label = fm.elidedText(content_.x_label, Qt::ElideMiddle, in.width());
    p.drawText(QRectF(in.left(), in.bottom() + tick_length + 2 + fm.height(), in.width(), fm.height()),
               int(Qt::AlignHCenter | Qt::AlignTop), label);
    p.setRenderHint(QPainter::Antialiasing, true);
}

void PlotView::paint_series(QPainter& p, const QRectF& in, const Look& look, std::size_t k) const {
    const PlotSeries& s = content_.series[k];
    const QColor color = look.series[k % look.series.size()];
    p.save();
    p.setClipRect(in.adjusted(0, 0, 1, 1));
    QColor faint = color;
    faint.setAlpha(170);
    p.setPen(QPen(faint, 1, Qt::DashLine));
    for (const double limit : {s.low_limit, s.high_limit})
        if (std::isfinite(limit)) {
            const double y = std::round(place_of(0, limit, in).y()) + 0.5;
            p.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
        }

    // What is in view, with a value on either side.
    const auto& x = content_.x;
    std::size_t first = std::size_t(std::lower_bound(x.begin(), x.end(), view_.left()) - x.begin());
    std::size_t end = std::size_t(std::upper_bound(x.begin(), x.end(), view_.right()) - x.begin());
    first -= first > 0;
    end = std::min(end + 1, std::min(x.size(), s.y.size()));
    p.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPolygonF line;
    const auto flush = [&] {
        if (line.size() == 1) p.drawPoint(line.front());
        if (line.size() > 1) p.drawPolyline(line);
        line.clear();
    };
    // Many values in one column of pixels are its least and largest.
    const bool many = double(end - first) > 4 * in.width();
    double column = -infinity;
    QPointF low, high, last;
    const auto add_column = [&] {
        if (column == -infinity) return;
        line << low << high << last;
        column = -infinity;
    };
    for (std::size_t i = first; i < end; ++i) {
        if (!std::isfinite(s.y[i])) {
            add_column();
            flush();
            continue;
        }
        const QPointF at = place_of(x[i], s.y[i], in);
        if (!many) {
            line << at;
            continue;
        }
        if (const double c = std::floor(at.x()); c != column) {
            add_column();
            line << at;
            column = c;
            low = high = at;
        }
        if (at.y() > low.y()) low = at;
        if (at.y() < high.y()) high = at;
        last = at;
    }
    add_column();
    flush();

    const auto dot = [&](std::size_t i, double radius, const QBrush& fill) {
        if (i >= s.y.size() || !std::isfinite(s.y[i])) return;
        p.setBrush(fill);
        p.drawEllipse(place_of(x[i], s.y[i], in), radius, radius);
    };
    if (content_.dots && !many)
        for (std::size_t i = first; i < end; ++i)
            dot(i, 2.2, color);
    const auto seen = std::lower_bound(s.marks.begin(), s.marks.end(), first);
    const auto beyond = std::lower_bound(s.marks.begin(), s.marks.end(), end);
    const bool small = double(beyond - seen) * mark_room > in.width();
    p.setPen(QPen(color, small ? 1.0 : 1.4));
    for (auto it = seen; it != beyond; ++it)
        dot(*it, small ? 1.5 : 3.2, look.ground);
    p.restore();
}

void PlotView::paint_key(QPainter& p, const QRectF& in, const Look& look) const {
    const QFontMetricsF fm(look.font);
    const double y = in.top() - 4 - fm.height() / 2;
    double x = in.left();
    const double end = in.right();
    const auto write = [&](const QString& label, const QColor& color) {
        const double w = fm.horizontalAdvance(label);
        p.setPen(color);
        p.drawText(QRectF(x, y - fm.height(), w + 2, 2 * fm.height()), int(Qt::AlignLeft | Qt::AlignVCenter),
                   label);
        x += w + key_gap;
    };
    write(content_.y_label, look.ink);
    bool limits = false, marks = false;
    for (std::size_t k = 0; k < content_.series.size(); ++k) {
        const PlotSeries& s = content_.series[k];
        limits |= std::isfinite(s.low_limit) || std::isfinite(s.high_limit);
        marks |= !s.marks.empty();
        if (content_.series.size() < 2 && s.name.isEmpty()) continue;
        if (x + key_sample + 4 + fm.horizontalAdvance(s.name) > end) return;
        p.setPen(QPen(look.series[k % look.series.size()], 2.4));
        p.drawLine(QPointF(x, y), QPointF(x + key_sample, y));
        x += key_sample + 4;
        write(s.name, look.ink);
    }
    if (marks && x + 12 + fm.horizontalAdvance(content_.marks_label) <= end) {
        p.setPen(QPen(look.quiet, 1.4));
        p.setBrush(look.ground);
        p.drawEllipse(QPointF(x + 4, y), 3.2, 3.2);
        x += 12;
        write(content_.marks_label, look.ink);
    }
    if (limits && x + key_sample + 4 + fm.horizontalAdvance(tr("limits")) <= end) {
        p.setPen(QPen(look.quiet, 1, Qt::DashLine));
        p.drawLine(QPointF(x, y + 0.5), QPointF(x + key_sample, y + 0.5));
        x += key_sample + 4;
        write(tr("limits"), look.ink);
    }
}

void PlotView::paint(QPainter& p, const QSize& size, const Look& look, bool exported) const {
    p.fillRect(QRect(QPoint(0, 0), size), look.ground);
    p.setRenderHint(QPainter::Antialiasing);
    p.setFont(look.font);
    if (empty()) {
        p.setPen(look.quiet);
        p.drawText(QRectF(QPointF(0, 0), QSizeF(size)).adjusted(margin, margin, -margin, -margin),
                   int(Qt::AlignCenter | Qt::TextWordWrap), empty_text_);
        return;
    }
    const QRectF in = frame(size, exported);
    paint_axes(p, in, look);
    for (std::size_t k = 0; k < content_.series.size(); ++k)
        paint_series(p, in, look, k);
    paint_key(p, in, look);
    if (exported) {
        QFont bold = look.font;
        bold.setBold(true);
        p.setFont(bold);
        p.setPen(look.ink);
        p.drawText(QRectF(in.left(), margin / 2, in.width(), 1.6 * QFontMetricsF(bold).height()),
                   int(Qt::AlignLeft | Qt::AlignVCenter),
                   QFontMetricsF(bold).elidedText(content_.title, Qt::ElideMiddle, in.width()));
    }
}

PlotView::Look PlotView::look() const {
    const bool dark = is_dark(palette());
    QColor grid = palette().color(QPalette::Text);
    grid.setAlpha(dark ? 40 : 28);
    return {palette().color(QPalette::Base),
            palette().color(QPalette::Text),
            palette().color(QPalette::PlaceholderText),
            grid,
            palette().color(QPalette::Highlight),
            lines_of(view_colors(palette())),
            font()};
}

void PlotView::paintEvent(QPaintEvent*) {
    const Look look = this->look();
    // The curves of a long path take a while; a cursor that is carried along does not draw them anew.
    const qreal ratio = devicePixelRatioF();
    if (const QSize pixels = (QSizeF(size()) * ratio).toSize(); !drawn_ || cache_.size() != pixels) {
        cache_ = QPixmap(pixels);
        cache_.setDevicePixelRatio(ratio);
        QPainter p(&cache_);
        paint(p, size(), look, false);
        drawn_ = true;
    }
    QPainter p(this);
    p.drawPixmap(0, 0, cache_);
    p.setRenderHint(QPainter::Antialiasing);
    if (empty()) return;
    const QRectF in = frame(size(), false);
    if (cursor_ && *cursor_ >= view_.left() && *cursor_ <= view_.right()) {
        const double x = std::round(place_of(*cursor_, view_.top(), in).x()) + 0.5;
        p.setPen(QPen(look.cursor, 1.5));
        p.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
        p.setPen(Qt::NoPen);
        p.setBrush(look.cursor);
        p.drawPolygon(QPolygonF({{x - 5, in.top()}, {x + 5, in.top()}, {x, in.top() + 7}}));
    }
    if (hasFocus()) {
        p.setRenderHint(QPainter::Antialiasing, false);
        p.setBrush(Qt::NoBrush);
        p.setPen(look.cursor);
        p.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

QImage PlotView::picture(const QSize& size) const {
    const auto& paper = fixed_colors().paper;
    QColor grid = to_qt(paper.ink);
    grid.setAlpha(28);
    QImage image(size, QImage::Format_RGB32);
    // As large as a chart of 800 points width, in as many pixels as asked for.
    const double scale = std::max(1.0, size.width() / 800.0);
    QPainter p(&image);
    p.scale(scale, scale);
    const QSize inner(int(size.width() / scale), int(size.height() / scale));
    p.fillRect(QRect(QPoint(0, 0), inner + QSize(1, 1)), to_qt(paper.ground));
    paint(p, inner,
          {to_qt(paper.ground), to_qt(paper.ink), to_qt(paper.quiet), grid, to_qt(paper.cursor),
           lines_of(colors_of(facetmill::Palette::light)), font()},
          true);
    return image;
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    if (empty() || drag_ != Drag::none) return;
    last_ = event->position();
    const bool left = event->button() == Qt::LeftButton;
    if (left && !(event->modifiers() & Qt::ShiftModifier)) {
        drag_ = Drag::cursor;
        emit cursor_moved(x_at(last_.x()));
    } else if (left || event->button() == Qt::RightButton || event->button() == Qt::MiddleButton) {
        drag_ = Drag::move;
    }
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) drag_ = Drag::none; // the release went elsewhere
    if (drag_ == Drag::none || empty()) return;
    const QPointF by = event->position() - last_;
    last_ = event->position();
    if (drag_ == Drag::cursor) {
        emit cursor_moved(x_at(last_.x()));
        return;
    }
    const QRectF in = frame(size(), false);
    view_.translate(-by.x() / in.width() * view_.width(), by.y() / in.height() * view_.height());
    hold_view();
    redraw();
}

void PlotView::mouseReleaseEvent(QMouseEvent*) {
    drag_ = Drag::none;
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) reset_view();
}

void PlotView::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    const double steps = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    if (steps == 0 || empty()) return;
    const double factor = std::pow(1.25, steps);
    const QRectF in = frame(size(), false);
    if (event->modifiers() & Qt::ControlModifier) {
        const double share = (in.bottom() - event->position().y()) / in.height();
        const double about = view_.top() + share * view_.height(), height = view_.height() / factor;
        view_.setTop(about - share * height);
        view_.setHeight(height);
        hold_view();
        redraw();
    } else {
        zoom_x(x_at(event->position().x()), factor);
    }
    event->accept();
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    const int by = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    const double middle = cursor_.value_or(view_.center().x());
    switch (event->key()) {
    case Qt::Key_Left:
        return emit stepped(-by);
    case Qt::Key_Right:
        return emit stepped(by);
    case Qt::Key_Home:
        return reset_view();
    case Qt::Key_Plus:
        return zoom_x(middle, 1.25);
    case Qt::Key_Minus:
        return zoom_x(middle, 0.8);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace facetmill::ui
