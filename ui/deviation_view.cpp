#include "ui/deviation_view.h"

#include "ui/icons.h"
#include "ui/number_box.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "viz/palette.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

constexpr std::size_t bins = 60;
constexpr int end_width = 7, end_gap = 2; // of the bars for what lies beyond the range

/// Without the zeros behind the last digit that says something.
class LengthBox : public NumberBox {
public:
    using NumberBox::NumberBox;
    QString textFromValue(double value) const override { return number_text(value, 5); }
};

} // namespace

DeviationHistogramView::DeviationHistogramView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("histogram"));
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setSizePolicy(policy);
}

void DeviationHistogramView::show_deviation(DeviationDisplayPtr display, const DeviationScale& scale,
                                            LengthUnit unit) {
    const bool same = display == display_ && histogram_ && histogram_->scale == scale;
    unit_ = unit;
    display_ = std::move(display);
    if (!display_)
        histogram_.reset();
    else if (!same)
        histogram_ = deviation_histogram(*display_, scale, bins);
    update();
}

/// Where things stand in the widget.
struct DeviationHistogramView::Frame {
    QRectF bars; ///< where the bins are, without the ends
    double step = 0;
    double highest = 0; ///< mm^2 of the highest bar
};

DeviationHistogramView::Frame DeviationHistogramView::frame() const {
    Frame f;
    const QFontMetrics fm(font());
    const int side = end_width + end_gap + 4;
    f.bars = QRectF(side, fm.height() + 3, width() - 2 * side, height() - 3 * fm.height() - 12);
    f.step = f.bars.width() / double(bins);
    if (histogram_) {
        for (const double b : histogram_->bins)
            f.highest = std::max(f.highest, b);
        f.highest = std::max({f.highest, histogram_->below, histogram_->above});
    }
    return f;
}

void DeviationHistogramView::paintEvent(QPaintEvent*) {
    if (!histogram_) return;
    const DeviationHistogram& h = *histogram_;
    const DeviationScale& s = h.scale;
    const Frame f = frame();
    QPainter p(this);
    const QColor ink = palette().color(QPalette::Text), quiet = palette().color(QPalette::PlaceholderText);
    const QFontMetrics fm(font());
    p.setPen(quiet);
    if (!(h.total > 0)) {
        p.drawText(rect(), int(Qt::AlignCenter), tr("Nothing was judged"));
        return;
    }
    p.drawText(QRectF(0, 0, width(), fm.height()), int(Qt::AlignLeft | Qt::AlignVCenter),
               fm.elidedText(tr("Share of the area, highest %1").arg(percent_text(f.highest / h.total)),
                             Qt::ElideRight, width()));
    // Whatever there is shows, be it ever so little: a gouge is small.
    const auto bar = [&](double x, double w, double area, const QColor& color) {
        if (!(area > 0)) return;
        const double high = std::max(2.0, f.bars.height() * area / f.highest);
        p.fillRect(QRectF(x, f.bars.bottom() - high, w, high), color);
    };
    const double range = s.high - s.low;
    for (std::size_t i = 0; i < bins; ++i) {
        const double x0 = std::round(f.bars.x() + f.step * double(i)),
                     x1 = std::round(f.bars.x() + f.step * double(i + 1));
        bar(x0, std::max(1.0, x1 - x0), h.bins[i],
            to_qt(deviation_color(s, s.low + range * (double(i) + 0.5) / double(bins))));
    }
    const QColor red = to_qt(deviation_color_at(-1)), blue = to_qt(deviation_color_at(1));
    bar(f.bars.x() - end_gap - end_width, end_width, h.below, red);
    bar(f.bars.right() + end_gap, end_width, h.above, blue);

    p.setPen(ink);
    p.drawLine(QPointF(f.bars.x() - end_gap - end_width, f.bars.bottom() + 0.5),
               QPointF(f.bars.right() + end_gap + end_width, f.bars.bottom() + 0.5));
    // The limits of what is good.
    p.setPen(QPen(ink, 1, Qt::DashLine));
    for (const double limit : {-s.gouge_limit, s.tolerance})
        if (limit > s.low && limit < s.high) {
            const double x = std::round(f.bars.x() + f.bars.width() * (limit - s.low) / range) + 0.5;
            p.drawLine(QPointF(x, f.bars.y()), QPointF(x, f.bars.bottom()));
        }
    p.setPen(ink);
    double free = -1e9;
    for (const ScaleMark& m : scale_marks(s, unit_, 0.02)) {
        const double x = f.bars.x() + f.bars.width() * (m.value - s.low) / range;
        p.drawLine(QPointF(x, f.bars.bottom()), QPointF(x, f.bars.bottom() + 4));
        const QString label = in_user_numbers(text(m.label));
        const double w = fm.horizontalAdvance(label);
        const double at = std::clamp(x - w / 2, 0.0, std::max(0.0, width() - w));
        const bool last = m.value == s.high;
        const QString end = in_user_numbers(text(scale_marks(s, unit_, 0.02).back().label));
        const double end_at = width() - fm.horizontalAdvance(end) - 6.0;
        if (at < free || (!last && at + w > end_at)) continue;
        p.drawText(QPointF(at, f.bars.bottom() + 5 + fm.ascent()), label);
        free = at + w + 6;
    }
    p.setPen(quiet);
    const QRectF bottom(0, height() - fm.height(), width(), fm.height());
    p.drawText(bottom, int(Qt::AlignLeft | Qt::AlignVCenter), tr("gouge"));
    p.drawText(bottom, int(Qt::AlignHCenter | Qt::AlignVCenter), text(unit_name(unit_)));
    p.drawText(bottom, int(Qt::AlignRight | Qt::AlignVCenter), tr("excess"));
}

bool DeviationHistogramView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !histogram_ || !(histogram_->total > 0))
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const DeviationHistogram& h = *histogram_;
    const Frame f = frame();
    const double x = help->pos().x() - f.bars.x();
    const auto length = [&](double mm) { return shown_length(mm, unit_, 3); };
    QString tip;
    if (x < 0) {
        tip = tr("below %1: %2").arg(length(h.scale.low), percent_text(h.below / h.total));
    } else if (x >= f.bars.width()) {
        tip = tr("above %1: %2").arg(length(h.scale.high), percent_text(h.above / h.total));
    } else {
        const auto i = std::min(std::size_t(x / f.step), bins - 1);
        const double width = (h.scale.high - h.scale.low) / double(bins);
        tip = tr("%1 to %2: %3")
                  .arg(length(h.scale.low + width * double(i)), length(h.scale.low + width * double(i + 1)),
                       percent_text(h.bins[i] / h.total));
    }
    QToolTip::showText(help->globalPos(), tip, this);
    return true;
}

DeviationRangeEditor::DeviationRangeEditor(QWidget* parent) : QWidget(parent) {
    const auto box = [this](const char* name, const QString& tip) {
        auto* b = new LengthBox(this);
        b->setObjectName(QLatin1String(name));
        b->setKeyboardTracking(false);
        b->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        b->setToolTip(tip);
        b->setAccessibleName(tip);
        b->setMinimumWidth(56);
        b->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        connect(b, &QDoubleSpinBox::valueChanged, this, &DeviationRangeEditor::take);
        return b;
    };
    low_ = box("range_low", tr("Deeper gouges than this have the last red"));
    high_ = box("range_high", tr("More excess than this has the last blue"));
    auto* back = new QToolButton(this);
    back->setObjectName(QStringLiteral("range_reset"));
    back->setIcon(icon(Icon::reset));
    back->setAutoRaise(true);
    back->setToolTip(tr("Range from the tolerance"));
    back->setAccessibleName(back->toolTip());
    connect(back, &QToolButton::clicked, this, &DeviationRangeEditor::reset);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(new QLabel(tr("Range"), this));
    row->addWidget(low_, 1);
    row->addWidget(new QLabel(QStringLiteral("–"), this));
    row->addWidget(high_, 1);
    row->addWidget(back);
}

void DeviationRangeEditor::set_scale(const DeviationScale& scale, LengthUnit unit) {
    unit_ = unit;
    const double mm = mm_per(unit);
    const int decimals = unit == LengthUnit::inch ? 5 : 4;
    const double least = std::pow(10.0, -decimals);
    const QSignalBlocker block_low(low_), block_high(high_);
    for (QDoubleSpinBox* b : {low_, high_}) {
        b->setDecimals(decimals);
        b->setSuffix(QChar(0x00A0) + text(unit_name(unit)));
    }
    low_->setRange(-1000, -least);
    high_->setRange(least, 1000);
    low_->setValue(scale.low / mm);
    high_->setValue(scale.high / mm);
}

void DeviationRangeEditor::take() {
    emit edited(low_->value() * mm_per(unit_), high_->value() * mm_per(unit_));
}

} // namespace facetmill::ui
