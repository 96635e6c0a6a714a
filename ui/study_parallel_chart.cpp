#include "ui/study_chart.h"
#include "ui/study_words.h"
#include "ui/text.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <set>

namespace facetmill::ui {

namespace {

constexpr double axis_grip = 9;    ///< how near to an axis it is taken hold of, points
constexpr double line_reach = 8;   ///< how near to a line it is clicked, points
constexpr double min_range = 0.02; ///< a shorter drag is a click

/// Distance of a point from a segment.
double distance_to(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF d = b - a, e = p - a;
    const double length = QPointF::dotProduct(d, d);
    const double t = length > 0 ? std::clamp(QPointF::dotProduct(e, d) / length, 0.0, 1.0) : 0;
    const QPointF off = e - t * d;
    return std::hypot(off.x(), off.y());
}

} // namespace

StudyParallelChart::StudyParallelChart(QWidget* parent) : StudyChart(parent) {
    setObjectName(QStringLiteral("study_parallel"));
    setAccessibleName(tr("What varies, and what comes of it"));
    setAccessibleDescription(tr("A line per candidate across an axis for everything that varies and for "
                                "measures; a drag along an axis keeps a range of it"));
}

void StudyParallelChart::figures_changed() {
    std::vector<Axis> axes;
    if (filled()) {
        for (int v = 0; v < figures()->variations.size(); ++v)
            axes.push_back({.name = figures()->variations[v], .variation = std::size_t(v)});
        std::vector<Measure> shown = figures()->want;
        for (const SetLimit& l : figures()->limits)
            shown.push_back(l.measure);
        shown.push_back(Measure::machining_time);
        shown.push_back(Measure::excess_max);
        std::set<Measure> seen;
        for (const Measure m : shown) {
            if (!seen.insert(m).second) continue;
            Axis axis{
                .name = measure_head(m, figures()->unit), .measure = m, .low = infinity, .high = -infinity};
            for (std::size_t i = 0; i < figures()->rows.size(); ++i)
                if (const auto v = figures()->value(i, m)) {
                    axis.low = std::min(axis.low, *v);
                    axis.high = std::max(axis.high, *v);
                }
            if (axis.low <= axis.high) axes.push_back(axis);
        }
    }
    for (std::size_t a = 0; a < std::min(axes.size(), axes_.size()); ++a)
        if (axes[a].name == axes_[a].name && axes[a].low == axes_[a].low && axes[a].high == axes_[a].high)
            axes[a].range = axes_[a].range;
    axes_ = std::move(axes);
}

std::optional<double> StudyParallelChart::share_of(std::size_t candidate, const Axis& axis) const {
    if (axis.variation) {
        const auto& chosen = figures()->rows[candidate].chosen;
        if (chosen.empty()) return std::nullopt; // the project as it stands is none of the combinations
        const qsizetype n = figures()->choices[*axis.variation].size();
        return (double(chosen[*axis.variation]) + 0.5) / double(n);
    }
    const auto v = figures()->value(candidate, axis.measure);
    if (!v) return std::nullopt;
    return axis.high > axis.low ? 0.05 + 0.9 * (*v - axis.low) / (axis.high - axis.low) : 0.5;
}

QRectF StudyParallelChart::frame(const QSize& size) const {
    const double line = QFontMetricsF(font()).height();
    // Above it two rows of names and two of values, two of values below.
    return QRectF(QPointF(40, 4 * line + 8), QPointF(size.width() - 40.0, size.height() - 2 * line - 8));
}

double StudyParallelChart::axis_x(std::size_t axis, const QRectF& in) const {
    if (axes_.size() < 2) return in.center().x();
    return in.left() + in.width() * double(axis) / double(axes_.size() - 1);
}

QPointF StudyParallelChart::axis_place(std::size_t axis, double share) const {
    const QRectF in = frame(size());
    return {axis_x(axis, in), in.bottom() - share * in.height()};
}

std::vector<QPointF> StudyParallelChart::line_of(std::size_t candidate, const QRectF& in) const {
    std::vector<QPointF> line;
    if (figures()->rows[candidate].same) return line;
    for (std::size_t a = 0; a < axes_.size(); ++a)
        if (const auto s = share_of(candidate, axes_[a]))
            line.emplace_back(axis_x(a, in), in.bottom() - *s * in.height());
    return line;
}

std::optional<QPointF> StudyParallelChart::place_of(std::size_t candidate) const {
    const std::vector<QPointF> line = line_of(candidate, frame(size()));
    if (line.size() < 2) return std::nullopt;
    // Where lines part: between the last two axes.
    return (line[line.size() - 2] + line.back()) / 2;
}

std::vector<char> StudyParallelChart::kept_by_ranges() const {
    std::vector<char> kept;
    if (!filled()
        || std::none_of(axes_.begin(), axes_.end(), [](const Axis& a) { return a.range.has_value(); }))
        return kept;
    for (std::size_t i = 0; i < figures()->rows.size(); ++i)
        kept.push_back(std::all_of(axes_.begin(), axes_.end(), [&](const Axis& axis) {
            if (!axis.range) return true;
            const auto s = share_of(i, axis);
            return s && *s >= axis.range->first && *s <= axis.range->second;
        }));
    return kept;
}

void StudyParallelChart::clear_ranges() {
    for (Axis& axis : axes_)
        axis.range.reset();
    emit ranges_changed();
    update();
}

QString StudyParallelChart::end_text(const Axis& axis, bool high) const {
    if (axis.variation) return {};
    return measure_text(axis.measure, high ? axis.high : axis.low);
}

/// What belongs to an axis, in one of two rows from `top` on: neighbours stand in different ones, so that
/// each has twice the room.
void StudyParallelChart::paint_at_axis(QPainter& p, const QRectF& in, std::size_t axis, const QString& words,
                                       double top) const {
    const QFontMetricsF metrics(font());
    const double room = axes_.size() > 1 ? in.width() / double(axes_.size() - 1) : in.width();
    const QString fitting = metrics.elidedText(words, Qt::ElideRight, std::max(2 * room - 8, 60.0));
    const double half = metrics.horizontalAdvance(fitting) / 2;
    const double at = std::clamp(axis_x(axis, in), half + 2, std::max(half + 2, in.right() + 38 - half));
    p.drawText(QPointF(at - half, top + (axis % 2 == 0 ? 0 : metrics.height()) + metrics.ascent()), fitting);
}

void StudyParallelChart::paint_axes(QPainter& p, const QRectF& in, const StudyChartLook& look) const {
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    const double room = axes_.size() > 1 ? in.width() / double(axes_.size() - 1) : in.width();
    for (std::size_t a = 0; a < axes_.size(); ++a) {
        const Axis& axis = axes_[a];
        const double x = axis_x(a, in);
        p.setPen(QPen(look.ink, 1.2));
        p.drawLine(QPointF(x, in.top()), QPointF(x, in.bottom()));
        paint_at_axis(p, in, a, axis.name, 2);
        p.setPen(look.quiet);
        if (axis.variation) {
            const QStringList& labels = figures()->choices[*axis.variation];
            if (double(labels.size()) * line > in.height() * 1.2) continue;
            for (qsizetype c = 0; c < labels.size(); ++c) {
                const double y = in.bottom() - (double(c) + 0.5) / double(labels.size()) * in.height();
                const QString label = metrics.elidedText(
                    labels[c], Qt::ElideRight, a + 1 < axes_.size() ? std::max(room - 10, 20.0) : 36);
                const QPointF at(x + 4, y - 3);
                // Lines are many, and go through it.
                QColor ground = look.ground;
                ground.setAlpha(200);
                p.fillRect(metrics.boundingRect(label).translated(at).adjusted(-1, 0, 1, 0), ground);
                p.drawText(at, label);
            }
        } else {
            paint_at_axis(p, in, a, end_text(axis, true), 2 * line + 4);
            paint_at_axis(p, in, a, end_text(axis, false), in.bottom() + 4);
        }
        if (!axis.range) continue;
        QColor band = look.attention;
        band.setAlpha(90);
        p.fillRect(QRectF(QPointF(x - 5, in.bottom() - axis.range->second * in.height()),
                          QPointF(x + 5, in.bottom() - axis.range->first * in.height())),
                   band);
    }
}

void StudyParallelChart::paint(QPainter& p, const QSize& size, const StudyChartLook& look,
                               bool exported) const {
    const QRectF in = frame(size);
    if (in.width() < 40 || in.height() < 20 || axes_.empty()) return;
    p.setFont(look.font);
    const auto draw = [&](std::size_t i, QColor color, double width) {
        const std::vector<QPointF> line = line_of(i, in);
        if (line.size() < 2) return;
        if (!is_kept(i)) color.setAlpha(22);
        p.setPen(QPen(color, width));
        p.drawPolyline(line.data(), int(line.size()));
    };
    const auto& rows = figures()->rows;
    for (const int pass : {0, 1, 2})
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const CandidateStanding s = rows[i].standing;
            const int group = s == CandidateStanding::winner || s == CandidateStanding::front ? 2
                              : s == CandidateStanding::out                                   ? 0
                                                                                              : 1;
            if (group != pass) continue;
            QColor color = s == CandidateStanding::winner  ? look.good
                           : s == CandidateStanding::front ? look.accent
                           : s == CandidateStanding::out   ? look.bad
                                                           : look.quiet;
            if (group < 2) color.setAlpha(110);
            draw(i, color, group == 2 ? 2 : 1);
        }
    paint_axes(p, in, look);
    if (!exported && chosen()) draw(*chosen(), look.ink, 3);
}

std::optional<std::size_t> StudyParallelChart::candidate_at(const QPointF& at) const {
    const QRectF in = frame(size());
    std::optional<std::size_t> nearest;
    double least = line_reach;
    for (std::size_t i = 0; i < figures()->rows.size(); ++i) {
        if (!is_kept(i)) continue;
        const std::vector<QPointF> line = line_of(i, in);
        for (std::size_t k = 1; k < line.size(); ++k)
            if (const double d = distance_to(at, line[k - 1], line[k]); d < least) {
                least = d;
                nearest = i;
            }
    }
    return nearest;
}

std::vector<std::size_t> StudyParallelChart::order() const {
    std::vector<std::size_t> all;
    if (!filled()) return all;
    for (std::size_t i = 0; i < figures()->rows.size(); ++i)
        if (is_kept(i) && !figures()->rows[i].same) all.push_back(i);
    return all;
}

std::optional<std::size_t> StudyParallelChart::axis_at(const QPointF& at) const {
    const QRectF in = frame(size());
    if (at.y() < in.top() - 4 || at.y() > in.bottom() + 4) return std::nullopt;
    for (std::size_t a = 0; a < axes_.size(); ++a)
        if (std::abs(at.x() - axis_x(a, in)) <= axis_grip) return a;
    return std::nullopt;
}

void StudyParallelChart::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && filled())
        if (const auto axis = axis_at(event->position())) {
            const QRectF in = frame(size());
            dragged_ = axis;
            drag_from_ = std::clamp((in.bottom() - event->position().y()) / in.height(), 0.0, 1.0);
            return;
        }
    StudyChart::mousePressEvent(event);
}

void StudyParallelChart::mouseMoveEvent(QMouseEvent* event) {
    setCursor(filled() && (dragged_ || axis_at(event->position())) ? Qt::SplitVCursor : Qt::ArrowCursor);
    if (!dragged_ || *dragged_ >= axes_.size()) return StudyChart::mouseMoveEvent(event);
    const QRectF in = frame(size());
    const double to = std::clamp((in.bottom() - event->position().y()) / in.height(), 0.0, 1.0);
    if (std::abs(to - drag_from_) < min_range) return;
    axes_[*dragged_].range = {std::min(drag_from_, to), std::max(drag_from_, to)};
    emit ranges_changed();
    update();
}

void StudyParallelChart::mouseReleaseEvent(QMouseEvent* event) {
    if (!dragged_) return StudyChart::mouseReleaseEvent(event);
    const QRectF in = frame(size());
    const double to = (in.bottom() - event->position().y()) / in.height();
    if (std::abs(to - drag_from_) < min_range && *dragged_ < axes_.size()) {
        axes_[*dragged_].range.reset();
        emit ranges_changed();
        update();
    }
    dragged_.reset();
}

void StudyParallelChart::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete) return clear_ranges();
    StudyChart::keyPressEvent(event);
}

} // namespace facetmill::ui
