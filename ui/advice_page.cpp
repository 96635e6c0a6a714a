#include "ui/advice_page.h"

#include "ui/plot_view.h"
#include "ui/text.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill::ui {

namespace {

constexpr double no_advice = std::numeric_limits<double>::quiet_NaN();
constexpr double longest_in_minutes = 300 * 60; ///< beyond it the axis of time counts hours

QString advice_angle(double radians) {
    return number_text(degrees(radians), 3) + QChar(0x00B0);
}

/// A chart that is zoomed stays so.
bool same(const PlotContent& a, const PlotContent& b) {
    return a.x == b.x && a.x_label == b.x_label && a.y_label == b.y_label
           && std::equal(
               a.series.begin(), a.series.end(), b.series.begin(), b.series.end(),
               [](const PlotSeries& p, const PlotSeries& q) { return p.name == q.name && p.y == q.y; });
}

const StrategyEstimate* least(const std::vector<StrategyEstimate>& all) {
    const auto at = std::min_element(all.begin(), all.end(),
                                     [](const auto& a, const auto& b) { return a.seconds() < b.seconds(); });
    return at == all.end() ? nullptr : &*at;
}

} // namespace

AdvicePage::AdvicePage(QWidget* parent) : QWidget(parent) {
    quantity_ = new QComboBox(this);
    quantity_->setObjectName(QStringLiteral("advice_quantity"));
    quantity_->addItems({tr("Machining time"), tr("Number of regions"), tr("Surface to rework")});
    axis_ = new QComboBox(this);
    axis_->setObjectName(QStringLiteral("advice_axis"));
    axis_->addItems({tr("over lead limit"), tr("over diameter")});
    for (QComboBox* box : {quantity_, axis_}) {
        box->setFocusPolicy(Qt::TabFocus);
        connect(box, &QComboBox::currentIndexChanged, this, &AdvicePage::fill_chart);
    }
    plot_ = new PlotView(this);
    plot_->setToolTip(tr("Over the lead limit: click or drag to set it. Wheel: zoom. Right drag: move."));
    connect(plot_, &PlotView::cursor_moved, this, [this](double x) {
        if (!advice_) return;
        if (!over_lead()) {
            plot_->set_cursor(x);
            return show_cursor();
        }
        lead_limit_ = radians(std::max(0.1, std::round(10 * x) / 10));
        show_cursor();
        emit lead_wanted(lead_limit_);
    });
    readout_ = new QLabel(this);
    readout_->setObjectName(QStringLiteral("advice_readout"));
    readout_->setWordWrap(true);
    suggestion_ = new QLabel(this);
    suggestion_->setObjectName(QStringLiteral("advice_suggestion"));
    suggestion_->setWordWrap(true);
    use_ = new QPushButton(this);
    use_->setObjectName(QStringLiteral("use_suggested"));
    use_->setAutoDefault(false);
    connect(use_, &QPushButton::clicked, this, [this] {
        if (const auto lead = suggested()) emit lead_chosen(*lead);
    });

    auto* row = new QHBoxLayout;
    row->addWidget(quantity_);
    row->addWidget(axis_);
    row->addStretch(1);
    auto* foot = new QHBoxLayout;
    foot->addWidget(suggestion_, 1);
    foot->addWidget(use_, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(plot_, 1);
    column->addWidget(readout_);
    column->addLayout(foot);
    clear_advice({});
}

bool AdvicePage::over_lead() const {
    return axis_->currentIndex() == 0;
}

QString AdvicePage::estimate_text(const StrategyEstimate& e) const {
    const QString regions = tr("%1 regions", nullptr, int(e.regions)).arg(count_text(e.regions));
    return tr("main %1 + rework %2 = %3; %4, %5 % of the surface")
        .arg(duration_text(e.main_seconds), duration_text(e.rework_seconds), duration_text(e.seconds()),
             regions, number_text(100 * e.rework_share, 2));
}

void AdvicePage::show_advice(const ToolAdvice& advice, double diameter, double lead_limit) {
    advice_ = advice;
    diameter_ = diameter;
    lead_limit_ = lead_limit;
    fill_chart();
}

void AdvicePage::clear_advice(const QString& why) {
    advice_.reset();
    plot_->clear(why);
    readout_->clear();
    suggestion_->clear();
    use_->hide();
}

std::optional<double> AdvicePage::suggested() const {
    const StrategyEstimate* best = advice_ ? least(advice_->by_lead) : nullptr;
    return best ? std::optional(best->lead_limit) : std::nullopt;
}

QString AdvicePage::advice_text() const {
    return suggestion_->text();
}

void AdvicePage::fill_chart() {
    if (!advice_) return;
    const std::vector<StrategyEstimate>& all = over_lead() ? advice_->by_lead : advice_->by_diameter;
    if (all.empty()) return clear_advice(tr("There is nothing to compare"));
    PlotContent content;
    content.dots = true;
    content.x_label =
        over_lead()
            ? tr("Lead limit (°), tool D %1").arg(shown_length(diameter_, unit_, 4))
            : tr("Tool diameter (%1), lead limit %2").arg(text(unit_name(unit_)), advice_angle(lead_limit_));
    for (const StrategyEstimate& e : all)
        content.x.push_back(over_lead() ? degrees(e.lead_limit) : e.diameter / mm_per(unit_));
    const auto add = [&](const QString& name, auto&& value) -> PlotSeries& {
        PlotSeries s{name, {}, {}, no_advice, no_advice};
        for (const StrategyEstimate& e : all)
            s.y.push_back(value(e));
        content.series.push_back(std::move(s));
        return content.series.back();
    };
    if (quantity_->currentIndex() == 0) {
        double longest = 0;
        for (const StrategyEstimate& e : all)
            longest = std::max(longest, e.seconds());
        const bool hours = longest > longest_in_minutes;
        const double per = hours ? 3600 : 60;
        content.title = tr("Estimated machining time");
        content.y_label = hours ? tr("Time (h)") : tr("Time (min)");
        add(tr("main"), [&](const StrategyEstimate& e) { return e.main_seconds / per; });
        add(tr("rework"), [&](const StrategyEstimate& e) { return e.rework_seconds / per; });
        PlotSeries& both = add(tr("both"), [&](const StrategyEstimate& e) { return e.seconds() / per; });
        both.marks.push_back(std::size_t(least(all) - all.data()));
        content.marks_label = tr("least");
    } else if (quantity_->currentIndex() == 1) {
        content.title = tr("Number of rework regions");
        content.y_label = tr("Regions");
        add({}, [](const StrategyEstimate& e) { return double(e.regions); });
    } else {
        content.title = tr("Surface to rework");
        content.y_label = tr("Rework (% of the surface)");
        add({}, [](const StrategyEstimate& e) { return 100 * e.rework_share; });
    }
    if (!same(content, plot_->content())) plot_->set_content(std::move(content));

    const StrategyEstimate& best = advice_->best;
    const StrategyEstimate* own = least(advice_->by_lead);
    suggestion_->setText(
        kept_together(tr("Least by this estimate: lead limit %1 with this tool, %2; of all tools D %3 with "
                         "%4, %5.")
                          .arg(advice_angle(own->lead_limit), duration_text(own->seconds()),
                               shown_length(best.diameter, unit_, 3), advice_angle(best.lead_limit),
                               duration_text(best.seconds()))));
    suggestion_->setToolTip(
        std::isfinite(advice_->diameter)
            ? tr("By Wang's (1) a tool of up to D %1 matches all but 5 % of the hollow places at this limit.")
                  .arg(shown_length(advice_->diameter, unit_, 3))
            : tr("No place is hollow: any tool matches."));
    use_->setText(tr("Use %1").arg(advice_angle(own->lead_limit)));
    use_->setToolTip(tr("Set the lead limit to it"));
    use_->setVisible(true);
    use_->setEnabled(std::abs(own->lead_limit - lead_limit_) > radians(0.005));
    if (over_lead())
        show_cursor();
    else {
        plot_->set_cursor(diameter_ / mm_per(unit_));
        show_cursor();
    }
}

/// What is estimated at the cursor: of the nearest of the values that were compared.
void AdvicePage::show_cursor() {
    if (!advice_) return;
    if (over_lead()) plot_->set_cursor(degrees(lead_limit_));
    const std::vector<StrategyEstimate>& all = over_lead() ? advice_->by_lead : advice_->by_diameter;
    const auto& x = plot_->content().x;
    if (all.empty() || x.size() != all.size() || !plot_->cursor()) return;
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
        if (std::abs(x[i] - *plot_->cursor()) < std::abs(x[nearest] - *plot_->cursor())) nearest = i;
    const StrategyEstimate& e = all[nearest];
    readout_->setText(kept_together((over_lead() ? tr("At %1: ").arg(advice_angle(e.lead_limit))
                                                 : tr("With D %1: ").arg(shown_length(e.diameter, unit_, 4)))
                                    + estimate_text(e)));
}

} // namespace facetmill::ui
