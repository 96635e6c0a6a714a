#include "ui/plot_view.h"

#include "core/base/vec.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "viz/palette.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill::ui {

namespace {

constexpr double title_margin = 8;
constexpr double headroom = 0.06; ///< share of the height, above and below the curves
/// Limits are in view from the beginning where they leave the curves at least this share of the height.
constexpr double min_share = 0.4;

std::array<QColor, 3> lines_of(const Colors& colors) {
    const auto& lines = colors.chart_lines;
    return {to_qt(lines[0]), to_qt(lines[1]), to_qt(lines[2])};
}

} // namespace

PlotView::PlotView(QWidget* parent) : ChartView(parent) {
    setObjectName(QStringLiteral("plot_view"));
    setAccessibleName(tr("Chart"));
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
    if (x && !dragged() && (*x < view_.left() || *x > view_.right())) {
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
    ChartView::changeEvent(event);
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

QRectF PlotView::frame() const {
    return plot_frame(view_, font(), size(), false);
}

QPointF PlotView::place_of(double x, double y) const {
    return plot_place(view_, frame(), x, y);
}

double PlotView::x_at(double pixel) const {
    const QRectF in = frame();
    const double x = view_.left() + (pixel - in.left()) / in.width() * view_.width();
    return std::clamp(x, whole_.left(), whole_.right());
}

void PlotView::paint(QPainter& p, const QSize& size, const PlotLook& look, bool exported) const {
    p.fillRect(QRect(QPoint(0, 0), size), look.ground);
    p.setRenderHint(QPainter::Antialiasing);
    p.setFont(look.font);
    if (empty()) {
        p.setPen(look.quiet);
        p.drawText(QRectF(QPointF(0, 0), QSizeF(size))
                       .adjusted(title_margin, title_margin, -title_margin, -title_margin),
                   int(Qt::AlignCenter | Qt::TextWordWrap), empty_text_);
        return;
    }
    paint_plot(p, content_, view_, size, look, exported);
}

PlotLook PlotView::look() const {
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
    const PlotLook look = this->look();
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
    const QRectF in = frame();
    if (cursor_ && *cursor_ >= view_.left() && *cursor_ <= view_.right()) {
        const double x = std::round(place_of(*cursor_, view_.top()).x()) + 0.5;
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

void PlotView::point_at(const QPointF& at) {
    emit cursor_moved(x_at(at.x()));
}

void PlotView::move_by(const QPointF& by) {
    const QRectF in = frame();
    view_.translate(-by.x() / in.width() * view_.width(), by.y() / in.height() * view_.height());
    hold_view();
    redraw();
}

void PlotView::zoom_at(const QPointF& about, double factor, bool upright) {
    if (!upright) return zoom_x(x_at(about.x()), factor);
    const QRectF in = frame();
    const double share = (in.bottom() - about.y()) / in.height();
    const double y = view_.top() + share * view_.height(), height = view_.height() / factor;
    view_.setTop(y - share * height);
    view_.setHeight(height);
    hold_view();
    redraw();
}

void PlotView::zoom_by_key(double factor) {
    zoom_x(cursor_.value_or(view_.center().x()), factor);
}

} // namespace facetmill::ui
