#include "ui/study_chart.h"
#include "ui/study_words.h"
#include "ui/text.h"
#include "viz/round_ticks.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

constexpr double front_margin = 0.06; ///< of what is seen, on each side
constexpr double front_reach = 12;    ///< of a click, points

/// How an axis says a measure: its unit, and how many of a study's make one.
struct AxisScale {
    double per = 1;
    QString unit;
};

AxisScale axis_scale(Measure measure, double largest, LengthUnit unit) {
    constexpr double minute = 60, hour = 3600;
    if (is_length(measure)) return {1, text(unit_name(unit))};
    if (measure == Measure::uncut_share) return {0.01, QStringLiteral("%")};
    if (measure != Measure::machining_time) return {1, {}};
    if (largest >= 3 * hour) return {hour, QStringLiteral("h")};
    if (largest >= 5 * minute) return {minute, QStringLiteral("min")};
    return {1, QStringLiteral("s")};
}

} // namespace

StudyFrontChart::StudyFrontChart(QWidget* parent) : StudyChart(parent) {
    setObjectName(QStringLiteral("study_front"));
    setAccessibleName(tr("Front of the study"));
    setAccessibleDescription(tr("Candidates by two measures; a line joins those that no other surpasses"));
}

void StudyFrontChart::set_axes(Measure x, Measure y) {
    x_ = x;
    y_ = y;
    own_view_ = false;
    reset_view();
}

std::optional<QPointF> StudyFrontChart::values(std::size_t candidate) const {
    if (figures()->rows[candidate].same) return std::nullopt;
    const auto x = figures()->value(candidate, x_), y = figures()->value(candidate, y_);
    if (!x || !y) return std::nullopt;
    return QPointF(*x, *y);
}

void StudyFrontChart::figures_changed() {
    if (!own_view_) reset_view();
}

void StudyFrontChart::reset_view() {
    own_view_ = false;
    if (!filled()) return;
    double lo_x = infinity, hi_x = -infinity, lo_y = infinity, hi_y = -infinity;
    for (std::size_t i = 0; i < figures()->rows.size(); ++i)
        if (const auto v = values(i)) {
            lo_x = std::min(lo_x, v->x());
            hi_x = std::max(hi_x, v->x());
            lo_y = std::min(lo_y, v->y());
            hi_y = std::max(hi_y, v->y());
        }
    if (lo_x > hi_x) lo_x = lo_y = 0, hi_x = hi_y = 1;
    const double dx = hi_x > lo_x ? hi_x - lo_x : std::max(std::abs(hi_x), 1.0) * 0.1;
    const double dy = hi_y > lo_y ? hi_y - lo_y : std::max(std::abs(hi_y), 1e-3) * 0.1;
    view_ = QRectF(lo_x - front_margin * dx, lo_y - front_margin * dy, hi_x - lo_x + 2 * front_margin * dx,
                   hi_y - lo_y + 2 * front_margin * dy);
    update();
}

QRectF StudyFrontChart::frame(const QSize& size, bool exported) const {
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    return QRectF(QPointF(metrics.horizontalAdvance(QStringLiteral("0.00000")) + 10, 2 * line + 6),
                  QPointF(size.width() - (exported ? 16 : 10), size.height() - 2 * line - 8));
}

QPointF StudyFrontChart::place(const QPointF& v, const QRectF& in) const {
    return {in.left() + (v.x() - view_.left()) / view_.width() * in.width(),
            in.bottom() - (v.y() - view_.top()) / view_.height() * in.height()};
}

std::optional<QPointF> StudyFrontChart::place_of(std::size_t candidate) const {
    const auto v = values(candidate);
    if (!v) return std::nullopt;
    return place(*v, frame(size(), false));
}

void StudyFrontChart::paint(QPainter& p, const QSize& size, const StudyChartLook& look, bool exported) const {
    const QRectF in = frame(size, exported);
    if (in.width() < 20 || in.height() < 20) return;
    p.setFont(look.font);
    paint_axes(p, in, look);
    paint_key(p, in, look);
    paint_points(p, in, look, exported);
}

void StudyFrontChart::paint_axes(QPainter& p, const QRectF& in, const StudyChartLook& look) const {
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    const AxisScale sx = axis_scale(x_, view_.right(), figures()->unit);
    const AxisScale sy = axis_scale(y_, view_.bottom(), figures()->unit);
    const auto named = [](Measure m, const AxisScale& s) {
        return s.unit.isEmpty() ? measure_label(m) : QStringLiteral("%1 (%2)").arg(measure_label(m), s.unit);
    };
    const int max_x = std::max(2, int(in.width() / metrics.horizontalAdvance(QStringLiteral("000000"))));
    const int max_y = std::max(2, int(in.height() / (2 * line)));
    const double lo_x = view_.left() / sx.per, hi_x = view_.right() / sx.per;
    const double lo_y = view_.top() / sy.per, hi_y = view_.bottom() / sy.per;
    for (const double t : round_ticks(lo_x, hi_x, max_x)) {
        const double x = place({t * sx.per, 0}, in).x();
        p.setPen(look.grid);
        p.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
        p.setPen(look.quiet);
        p.drawText(QRectF(x - 60, in.bottom() + 2, 120, line), Qt::AlignHCenter,
                   tick_text(t, round_step(hi_x - lo_x, max_x)));
    }
    for (const double t : round_ticks(lo_y, hi_y, max_y)) {
        const double y = place({0, t * sy.per}, in).y();
        p.setPen(look.grid);
        p.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
        p.setPen(look.quiet);
        p.drawText(QRectF(0, y - line / 2, in.left() - 5, line), Qt::AlignRight | Qt::AlignVCenter,
                   tick_text(t, round_step(hi_y - lo_y, max_y)));
    }
    p.setPen(look.ink);
    p.drawText(QRectF(in.left(), in.bottom() + line + 3, in.width(), line), Qt::AlignRight, named(x_, sx));
    p.drawText(QRectF(4, 2, in.right() - 4, line), Qt::AlignLeft, named(y_, sy));
    // What may not be gone beyond.
    p.setPen(QPen(look.attention, 1, Qt::DashLine));
    if (const auto most = figures()->limit(y_); most && *most < view_.bottom() && *most > view_.top())
        p.drawLine(QPointF(in.left(), place({0, *most}, in).y()),
                   QPointF(in.right(), place({0, *most}, in).y()));
    if (const auto most = figures()->limit(x_); most && *most < view_.right() && *most > view_.left())
        p.drawLine(QPointF(place({*most, 0}, in).x(), in.top()),
                   QPointF(place({*most, 0}, in).x(), in.bottom()));
}

void StudyFrontChart::paint_points(QPainter& p, const QRectF& in, const StudyChartLook& look,
                                   bool exported) const {
    p.save();
    p.setClipRect(in.adjusted(-8, -8, 8, 8));
    const auto& rows = figures()->rows;
    std::vector<QPointF> front;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].standing == CandidateStanding::winner || rows[i].standing == CandidateStanding::front)
            if (const auto v = values(i)) front.push_back(*v);
    std::sort(front.begin(), front.end(), [](const QPointF& a, const QPointF& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() > b.y();
    });
    p.setPen(QPen(look.accent, 1.5));
    for (std::size_t i = 1; i < front.size(); ++i)
        p.drawLine(place(front[i - 1], in), place(front[i], in));
    // The best are drawn last, so that nothing covers them.
    for (const bool best : {false, true})
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const bool is_best = i == 0 || rows[i].standing == CandidateStanding::winner
                                 || rows[i].standing == CandidateStanding::front;
            if (is_best != best) continue;
            if (const auto v = values(i)) paint_mark(p, place(*v, in), i, look);
        }
    if (!exported && chosen())
        if (const auto v = values(*chosen())) paint_chosen(p, place(*v, in), look);
    p.restore();
}

void StudyFrontChart::paint_key(QPainter& p, const QRectF& in, const StudyChartLook& look) const {
    const QFontMetricsF metrics(font());
    const double y = metrics.height() * 1.5 + 4;
    double x = 10;
    const auto& rows = figures()->rows;
    const auto entry = [&](std::size_t row, const QString& words) {
        if (x + metrics.horizontalAdvance(words) + 14 > in.right()) return;
        paint_mark(p, {x, y}, row, look);
        p.setPen(look.quiet);
        p.drawText(QPointF(x + 9, y + metrics.ascent() / 2 - 1), words);
        x += metrics.horizontalAdvance(words) + 28;
    };
    for (const CandidateStanding s :
         {CandidateStanding::winner, CandidateStanding::front, CandidateStanding::verified,
          CandidateStanding::behind, CandidateStanding::out}) {
        for (std::size_t i = 1; i < rows.size(); ++i)
            if (rows[i].standing == s && values(i)) {
                entry(i, standing_label(s));
                break;
            }
    }
    if (values(0)) entry(0, tr("the project"));
}

std::optional<std::size_t> StudyFrontChart::candidate_at(const QPointF& at) const {
    const QRectF in = frame(size(), false);
    std::optional<std::size_t> nearest;
    double least = front_reach;
    for (std::size_t i = 0; i < figures()->rows.size(); ++i) {
        const auto v = values(i);
        if (!v || !is_kept(i)) continue;
        const QPointF d = place(*v, in) - at;
        if (const double distance = std::hypot(d.x(), d.y()); distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

std::vector<std::size_t> StudyFrontChart::order() const {
    std::vector<std::size_t> all;
    if (!filled()) return all;
    for (std::size_t i = 0; i < figures()->rows.size(); ++i)
        if (values(i) && is_kept(i)) all.push_back(i);
    std::stable_sort(all.begin(), all.end(),
                     [this](std::size_t a, std::size_t b) { return values(a)->x() < values(b)->x(); });
    return all;
}

void StudyFrontChart::move_by(const QPointF& by) {
    const QRectF in = frame(size(), false);
    view_.translate(-by.x() / in.width() * view_.width(), by.y() / in.height() * view_.height());
    own_view_ = true;
    update();
}

void StudyFrontChart::zoom_at(const QPointF& about, double factor, bool upright) {
    const QRectF in = frame(size(), false);
    const double sx = (about.x() - in.left()) / in.width(), sy = (in.bottom() - about.y()) / in.height();
    const double w = view_.width() / (upright ? 1 : factor), h = view_.height() / factor;
    view_ = QRectF(view_.left() + sx * (view_.width() - w), view_.top() + sy * (view_.height() - h), w, h);
    own_view_ = true;
    update();
}

void StudyFrontChart::zoom_by_key(double factor) {
    zoom_at(frame(size(), false).center(), factor, false);
}

} // namespace facetmill::ui
