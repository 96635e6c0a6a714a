#include "ui/study_chart.h"

#include "ui/study_words.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "viz/palette.h"

#include <QHelpEvent>
#include <QPainter>
#include <QPolygonF>
#include <QToolTip>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr double mark_radius = 4.5;
constexpr int faint_alpha = 50;

/// As it is on paper: the light look on white.
StudyChartLook paper_look(const QFont& font) {
    const auto& paper = fixed_colors().paper;
    const Colors& colors = colors_of(facetmill::Palette::light);
    QColor grid = to_qt(paper.ink);
    grid.setAlpha(28);
    return {to_qt(paper.ground),
            to_qt(paper.ink),
            to_qt(paper.quiet),
            grid,
            to_qt(colors.signal.good),
            to_qt(colors.signal.attention),
            to_qt(colors.signal.bad),
            to_qt(colors.chart_lines[0]),
            font};
}

} // namespace

StudyChart::StudyChart(QWidget* parent) : ChartView(parent) {
    setMouseTracking(true);
    connect(this, &ChartView::stepped, this, [this](int by) {
        const std::vector<std::size_t> all = order();
        if (all.empty()) return;
        const auto at =
            chosen_ ? std::find(all.begin(), all.end(), *chosen_) - all.begin() : std::ptrdiff_t(all.size());
        const auto last = std::ptrdiff_t(all.size()) - 1;
        const std::ptrdiff_t to =
            at > last ? (by > 0 ? 0 : last) : std::clamp(at + by, std::ptrdiff_t(0), last);
        emit candidate_chosen(all[std::size_t(to)]);
    });
}

void StudyChart::show_figures(StudyFiguresPtr figures) {
    figures_ = std::move(figures);
    figures_changed();
    update();
}

void StudyChart::choose(std::optional<std::size_t> candidate) {
    chosen_ = candidate;
    update();
}

void StudyChart::set_kept(std::vector<char> kept) {
    kept_ = std::move(kept);
    update();
}

void StudyChart::point_at(const QPointF& at) {
    if (const auto candidate = candidate_at(at)) emit candidate_chosen(*candidate);
}

StudyChartLook StudyChart::look() const {
    const SignalColors signal = signal_colors(palette());
    QColor grid = palette().color(QPalette::Text);
    grid.setAlpha(is_dark(palette()) ? 40 : 28);
    return {palette().color(QPalette::Base),
            palette().color(QPalette::Text),
            palette().color(QPalette::PlaceholderText),
            grid,
            signal.good,
            signal.attention,
            signal.bad,
            to_qt(view_colors(palette()).chart_lines[0]),
            font()};
}

void StudyChart::paintEvent(QPaintEvent*) {
    const StudyChartLook look = this->look();
    QPainter p(this);
    p.fillRect(rect(), look.ground);
    p.setRenderHint(QPainter::Antialiasing);
    if (filled()) return paint(p, size(), look, false);
    p.setPen(look.quiet);
    p.drawText(rect().adjusted(12, 8, -12, -8), Qt::AlignCenter | Qt::TextWordWrap,
               tr("No candidate has been looked at yet."));
}

QImage StudyChart::picture(const QSize& size) const {
    QImage image(size, QImage::Format_RGB32);
    // As large as a chart of 800 points width, in as many pixels as asked for.
    const double scale = std::max(1.0, size.width() / 800.0);
    const StudyChartLook look = paper_look(font());
    image.fill(look.ground);
    QPainter p(&image);
    p.setRenderHint(QPainter::Antialiasing);
    p.scale(scale, scale);
    if (filled()) paint(p, QSize(int(size.width() / scale), int(size.height() / scale)), look, true);
    return image;
}

bool StudyChart::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !filled()) return ChartView::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto candidate = candidate_at(help->pos()))
        QToolTip::showText(help->globalPos(), tip_of(*candidate), this);
    else
        QToolTip::hideText();
    return true;
}

QString StudyChart::tip_of(std::size_t candidate) const {
    const StudyRow& row = figures_->rows[candidate];
    QStringList lines{tr("%1: %2").arg(candidate).arg(row.choice), standing_label(row.standing)};
    for (const Measure m : {Measure::machining_time, Measure::excess_max})
        if (const auto v = row.measures[m])
            lines << tr("%1: %2").arg(measure_head(m, figures_->unit), measure_text(m, *v));
    if (!row.why.isEmpty()) lines << elided(row.why, 160);
    return lines.join(QChar('\n'));
}

void StudyChart::paint_mark(QPainter& p, const QPointF& at, std::size_t candidate,
                            const StudyChartLook& look) const {
    const StudyRow& row = figures_->rows[candidate];
    const auto shade = [&](QColor color) {
        if (!is_kept(candidate)) color.setAlpha(faint_alpha);
        return color;
    };
    p.setBrush(Qt::NoBrush);
    if (candidate == 0) {
        const double r = mark_radius + 1.5;
        p.setPen(QPen(shade(look.ink), 1.5));
        p.drawPolygon(
            QPolygonF{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)});
        return;
    }
    switch (row.standing) {
    case CandidateStanding::winner:
        p.setPen(QPen(shade(look.good), 2));
        p.setBrush(shade(look.good));
        p.drawEllipse(at, mark_radius + 1.5, mark_radius + 1.5);
        return;
    case CandidateStanding::front:
        p.setPen(Qt::NoPen);
        p.setBrush(shade(look.accent));
        p.drawEllipse(at, mark_radius, mark_radius);
        return;
    case CandidateStanding::out: {
        const double r = mark_radius - 1;
        p.setPen(QPen(shade(look.bad), 1.5));
        p.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
        p.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
        return;
    }
    default:
        p.setPen(QPen(shade(row.standing == CandidateStanding::verified ? look.accent : look.quiet), 1.5));
        p.drawEllipse(at, mark_radius - 0.5, mark_radius - 0.5);
    }
}

void StudyChart::paint_chosen(QPainter& p, const QPointF& at, const StudyChartLook& look) const {
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(look.ink, 2));
    p.drawEllipse(at, mark_radius + 5, mark_radius + 5);
}

} // namespace facetmill::ui
