#include "ui/plot_painting.h"

#include "core/base/vec.h"
#include "ui/chart_view.h"
#include "viz/round_ticks.h"

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

constexpr double plot_margin = 8, plot_tick = 4, key_gap = 14, key_sample = 18;
constexpr double mark_room =
    14; ///< along the axis for one in full size; where there is less they are smaller

/// One picture: what all of its pieces are painted with.
class PlotPainting {
public:
    PlotPainting(QPainter& p, const PlotContent& content, const QRectF& view, const QRectF& frame,
                 const PlotLook& look)
        : p_(p), content_(content), view_(view), in_(frame), look_(look) {}
    void paint_axes() const;
    void paint_series(std::size_t k) const;
    void paint_key() const;

private:
    QPointF place(double x, double y) const { return plot_place(view_, in_, x, y); }

    QPainter& p_;
    const PlotContent& content_;
    const QRectF view_, in_;
    const PlotLook& look_;
};

void PlotPainting::paint_axes() const {
    const QFontMetricsF fm(look_.font);
    p_.setRenderHint(QPainter::Antialiasing, false);
    // Upright.
    // In a low chart closer together: one tick alone says nothing.
    const int max_y = std::max(
        {3, int(in_.height() / (1.6 * fm.height())), std::min(5, int(in_.height() / (1.1 * fm.height())))});
    const double step_y = round_step(view_.height(), max_y);
    for (const double v : round_ticks(view_.top(), view_.bottom(), max_y)) {
        const double y = std::round(place(view_.left(), v).y()) + 0.5;
        p_.setPen(look_.grid);
        p_.drawLine(QPointF(in_.left(), y), QPointF(in_.right(), y));
        p_.setPen(look_.ink);
        p_.drawLine(QPointF(in_.left() - plot_tick, y), QPointF(in_.left(), y));
        p_.drawText(QRectF(0, y - fm.height() / 2, in_.left() - plot_tick - 3, fm.height()),
                    int(Qt::AlignRight | Qt::AlignVCenter), tick_text(v, step_y));
    }
    // Along.
    const double wide = fm.horizontalAdvance(QStringLiteral("−00000.0"));
    const int max_x = std::max(2, int(in_.width() / (1.4 * wide)));
    const double step_x = round_step(view_.width(), max_x);
    double written = -infinity;
    for (const double v : round_ticks(view_.left(), view_.right(), max_x)) {
        const double x = std::round(place(v, view_.top()).x()) + 0.5;
        p_.setPen(look_.grid);
        p_.drawLine(QPointF(x, in_.top()), QPointF(x, in_.bottom()));
        p_.setPen(look_.ink);
        p_.drawLine(QPointF(x, in_.bottom()), QPointF(x, in_.bottom() + plot_tick));
        const QString label = tick_text(v, step_x);
        const double w = fm.horizontalAdvance(label);
        if (x - w / 2 < written + 6) continue;
        p_.drawText(QRectF(x - w, in_.bottom() + plot_tick + 1, 2 * w, fm.height()), int(Qt::AlignCenter),
                    label);
        written = x + w / 2;
    }
    p_.setPen(look_.ink);
    p_.drawRect(QRectF(std::round(in_.left()) + 0.5, std::round(in_.top()) + 0.5, std::round(in_.width()) - 1,
                       std::round(in_.height()) - 1));
    const QString label = fm.elidedText(content_.x_label, Qt::ElideMiddle, in_.width());
    p_.drawText(QRectF(in_.left(), in_.bottom() + plot_tick + 2 + fm.height(), in_.width(), fm.height()),
                int(Qt::AlignHCenter | Qt::AlignTop), label);
    p_.setRenderHint(QPainter::Antialiasing, true);
}

void PlotPainting::paint_series(std::size_t k) const {
    const PlotSeries& s = content_.series[k];
    const QColor color = look_.series[k % look_.series.size()];
    p_.save();
    p_.setClipRect(in_.adjusted(0, 0, 1, 1));
    QColor faint = color;
    faint.setAlpha(170);
    p_.setPen(QPen(faint, 1, Qt::DashLine));
    for (const double limit : {s.low_limit, s.high_limit})
        if (std::isfinite(limit)) {
            const double y = std::round(place(0, limit).y()) + 0.5;
            p_.drawLine(QPointF(in_.left(), y), QPointF(in_.right(), y));
        }

    // What is in view, with a value on either side.
    const auto& x = content_.x;
    std::size_t first = std::size_t(std::lower_bound(x.begin(), x.end(), view_.left()) - x.begin());
    std::size_t end = std::size_t(std::upper_bound(x.begin(), x.end(), view_.right()) - x.begin());
    first -= first > 0;
    end = std::min(end + 1, std::min(x.size(), s.y.size()));
    p_.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPolygonF line;
    const auto flush = [&] {
        if (line.size() == 1) p_.drawPoint(line.front());
        if (line.size() > 1) p_.drawPolyline(line);
        line.clear();
    };
    // Many values in one column of pixels are its least and largest.
    const bool many = double(end - first) > 4 * in_.width();
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
        const QPointF at = place(x[i], s.y[i]);
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
        p_.setBrush(fill);
        p_.drawEllipse(place(x[i], s.y[i]), radius, radius);
    };
    if (content_.dots && !many)
        for (std::size_t i = first; i < end; ++i)
            dot(i, 2.2, color);
    const auto seen = std::lower_bound(s.marks.begin(), s.marks.end(), first);
    const auto beyond = std::lower_bound(s.marks.begin(), s.marks.end(), end);
    const bool small = double(beyond - seen) * mark_room > in_.width();
    p_.setPen(QPen(color, small ? 1.0 : 1.4));
    for (auto it = seen; it != beyond; ++it)
        dot(*it, small ? 1.5 : 3.2, look_.ground);
    p_.restore();
}

void PlotPainting::paint_key() const {
    const QFontMetricsF fm(look_.font);
    const double y = in_.top() - 4 - fm.height() / 2;
    double x = in_.left();
    const double end = in_.right();
    const auto write = [&](const QString& label, const QColor& color) {
        const double w = fm.horizontalAdvance(label);
        p_.setPen(color);
        p_.drawText(QRectF(x, y - fm.height(), w + 2, 2 * fm.height()), int(Qt::AlignLeft | Qt::AlignVCenter),
                    label);
        x += w + key_gap;
    };
    write(content_.y_label, look_.ink);
    bool limits = false, marks = false;
    for (std::size_t k = 0; k < content_.series.size(); ++k) {
        const PlotSeries& s = content_.series[k];
        limits |= std::isfinite(s.low_limit) || std::isfinite(s.high_limit);
        marks |= !s.marks.empty();
        if (content_.series.size() < 2 && s.name.isEmpty()) continue;
        if (x + key_sample + 4 + fm.horizontalAdvance(s.name) > end) return;
        p_.setPen(QPen(look_.series[k % look_.series.size()], 2.4));
        p_.drawLine(QPointF(x, y), QPointF(x + key_sample, y));
        x += key_sample + 4;
        write(s.name, look_.ink);
    }
    if (marks && x + 12 + fm.horizontalAdvance(content_.marks_label) <= end) {
        p_.setPen(QPen(look_.quiet, 1.4));
        p_.setBrush(look_.ground);
        p_.drawEllipse(QPointF(x + 4, y), 3.2, 3.2);
        x += 12;
        write(content_.marks_label, look_.ink);
    }
    if (limits && x + key_sample + 4 + fm.horizontalAdvance(QObject::tr("limits")) <= end) {
        p_.setPen(QPen(look_.quiet, 1, Qt::DashLine));
        p_.drawLine(QPointF(x, y + 0.5), QPointF(x + key_sample, y + 0.5));
        x += key_sample + 4;
        write(QObject::tr("limits"), look_.ink);
    }
}

} // namespace

QRectF plot_frame(const QRectF& view, const QFont& font, const QSize& size, bool titled) {
    const QFontMetricsF fm(font);
    double widest = 0;
    const int most = std::max(3, int(size.height() / (2 * fm.height())));
    const double step = round_step(view.height(), most);
    for (const double v : round_ticks(view.top(), view.bottom(), most))
        widest = std::max(widest, fm.horizontalAdvance(tick_text(v, step)));
    const double left = plot_margin + widest + plot_tick + 4;
    const double top = plot_margin + fm.height() + 6 + (titled ? 1.6 * fm.height() : 0);
    const double bottom = size.height() - plot_margin - 2 * fm.height() - plot_tick - 2;
    return {left, top, std::max(10.0, size.width() - left - 2 * plot_margin), std::max(10.0, bottom - top)};
}

QPointF plot_place(const QRectF& view, const QRectF& frame, double x, double y) {
    return {frame.left() + (x - view.left()) / view.width() * frame.width(),
            frame.bottom() - (y - view.top()) / view.height() * frame.height()};
}

void paint_plot(QPainter& p, const PlotContent& content, const QRectF& view, const QSize& size,
                const PlotLook& look, bool titled) {
    const QRectF in = plot_frame(view, look.font, size, titled);
    const PlotPainting painting(p, content, view, in, look);
    painting.paint_axes();
    for (std::size_t k = 0; k < content.series.size(); ++k)
        painting.paint_series(k);
    painting.paint_key();
    if (!titled) return;
    QFont bold = look.font;
    bold.setBold(true);
    p.setFont(bold);
    p.setPen(look.ink);
    p.drawText(QRectF(in.left(), plot_margin / 2, in.width(), 1.6 * QFontMetricsF(bold).height()),
               int(Qt::AlignLeft | Qt::AlignVCenter),
               QFontMetricsF(bold).elidedText(content.title, Qt::ElideMiddle, in.width()));
}

} // namespace facetmill::ui
