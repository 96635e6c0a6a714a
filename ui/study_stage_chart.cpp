#include "ui/study_chart.h"
#include "ui/study_words.h"
#include "ui/text.h"

#include <QPainter>

#include <algorithm>

namespace facetmill::ui {

StudyStageChart::StudyStageChart(QWidget* parent) : StudyChart(parent) {
    setObjectName(QStringLiteral("study_stages"));
    setAccessibleName(tr("Stages of the study"));
    setAccessibleDescription(
        tr("A bar per candidate, as high as its machining time, in a strip for each stage of the study"));
}

void StudyStageChart::figures_changed() {
    order_.clear();
    longest_ = 1e-9;
    if (!filled()) return;
    const auto& rows = figures()->rows;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!rows[i].same) order_.push_back(i);
    const auto time = [&](std::size_t i) {
        return rows[i].measures[Measure::machining_time].value_or(infinity);
    };
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return time(a) < time(b); });
    for (const std::size_t i : order_)
        longest_ = std::max(longest_, rows[i].measures[Measure::machining_time].value_or(0));
}

QRectF StudyStageChart::strip(std::size_t rung, const QSize& size, bool exported) const {
    const double line = QFontMetricsF(font()).height();
    const double bottom = exported ? 10 : 6;
    const double key = line + 6, each = (size.height() - key - bottom) / double(all_rungs.size());
    const double top = key + double(rung) * each;
    return QRectF(QPointF(10, top + line + 4), QPointF(size.width() - 10.0, top + each - 2));
}

QRectF StudyStageChart::bar(std::size_t slot, const QRectF& in) const {
    const double width = in.width() / double(std::max<std::size_t>(order_.size(), 1));
    const double share =
        figures()->rows[order_[slot]].measures[Measure::machining_time].value_or(longest_) / longest_;
    const double gap = width > 4 ? 1 : 0, height = std::max(2.0, share * in.height());
    return QRectF(in.left() + double(slot) * width, in.bottom() - height, std::max(width - gap, 0.5), height);
}

QString StudyStageChart::strip_text(std::size_t rung) const {
    std::size_t looked = 0, passed = 0;
    for (const StudyRow& row : figures()->rows) {
        if (row.same) continue;
        if (row.looks[rung]) ++looked;
        if (row.looks[rung].value_or(false)) ++passed;
    }
    const QString counts = tr("%1, %2 of them passed").arg(count_text(looked), count_text(passed));
    return tr("%1: %2").arg(sentence(rung_label(all_rungs[rung])), counts);
}

void StudyStageChart::paint(QPainter& p, const QSize& size, const StudyChartLook& look, bool exported) const {
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    p.setFont(look.font);
    double x = 10;
    const auto entry = [&](const QColor& color, const QString& words) {
        if (x + metrics.horizontalAdvance(words) + 14 > size.width()) return;
        p.fillRect(QRectF(x, 4, 8, line - 4), color);
        p.setPen(look.quiet);
        p.drawText(QPointF(x + 12, 2 + metrics.ascent()), words);
        x += metrics.horizontalAdvance(words) + 26;
    };
    entry(look.accent, tr("passed"));
    entry(look.bad, tr("did not pass"));
    entry(look.good, standing_label(CandidateStanding::winner));
    entry(look.grid, tr("not looked at"));
    for (std::size_t r = 0; r < all_rungs.size(); ++r) {
        const QRectF in = strip(r, size, exported);
        if (in.height() < 4) continue;
        p.setPen(look.ink);
        p.drawText(QPointF(in.left(), in.top() - 5), strip_text(r));
        for (std::size_t slot = 0; slot < order_.size(); ++slot) {
            const std::size_t i = order_[slot];
            const StudyRow& row = figures()->rows[i];
            QColor color = !row.looks[r]                               ? look.grid
                           : !*row.looks[r]                            ? look.bad
                           : row.standing == CandidateStanding::winner ? look.good
                                                                       : look.accent;
            if (!is_kept(i)) color.setAlpha(std::min(color.alpha(), 50));
            p.fillRect(bar(slot, in), color);
            if (!exported && chosen() == i) {
                p.setPen(QPen(look.ink, 2));
                p.setBrush(Qt::NoBrush);
                p.drawRect(bar(slot, in).adjusted(-1.5, -1.5, 1.5, 1.5));
            }
        }
        p.setPen(look.quiet);
        p.drawLine(in.bottomLeft(), in.bottomRight());
    }
}

std::optional<QPointF> StudyStageChart::place_of(std::size_t candidate) const {
    const auto at = std::find(order_.begin(), order_.end(), candidate);
    if (at == order_.end()) return std::nullopt;
    return bar(std::size_t(at - order_.begin()), strip(0, size(), false)).center();
}

std::optional<std::size_t> StudyStageChart::candidate_at(const QPointF& at) const {
    for (std::size_t r = 0; r < all_rungs.size(); ++r) {
        const QRectF in = strip(r, size(), false);
        if (!in.contains(at) || order_.empty()) continue;
        const auto slot = std::size_t((at.x() - in.left()) / in.width() * double(order_.size()));
        return order_[std::min(slot, order_.size() - 1)];
    }
    return std::nullopt;
}

} // namespace facetmill::ui
