#include "ui/inspection_panel.h"

#include "ui/elided_label.h"
#include "ui/icon_button.h"
#include "ui/plot_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

InspectionPanel::InspectionPanel(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("inspection"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 6);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    chart_ = new QComboBox(this);
    chart_->setObjectName(QStringLiteral("chart"));
    chart_->addItems({tr("Axes over path"), tr("Axes over time"), tr("Step-over")});
    chart_->setToolTip(
        tr("What the chart shows: the angles of the rotary axes, or the step-over along the part"));
    operation_ = new QComboBox(this);
    operation_->setObjectName(QStringLiteral("chart_operation"));
    operation_->setToolTip(tr("Of which operation"));
    for (QComboBox* box : {chart_, operation_}) {
        box->setFocusPolicy(Qt::TabFocus);
        box->setMinimumContentsLength(8);
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        box->setMaximumWidth(220);
        row->addWidget(box);
    }
    readout_ = new ElidedLabel(this);
    readout_->setObjectName(QStringLiteral("chart_readout"));
    readout_->setMinimumWidth(20);
    row->addWidget(readout_, 1);
    const auto add = [&](Icon which, const QString& tip, const char* name) {
        auto* b = icon_button(this, which, tip, name);
        row->addWidget(b);
        buttons_.push_back(b);
        return b;
    };
    auto* all = add(Icon::fit, tr("Show the whole chart (double click, Home)"), "chart_reset");
    auto* picture = add(Icon::picture, tr("Export the chart as a picture (PNG)"), "chart_picture");
    auto* table = add(Icon::export_program, tr("Export the values as a table (CSV)"), "chart_table");
    column->addLayout(row);
    plot_ = new PlotView(this);
    plot_->setToolTip(
        tr("Click or drag: the tool goes there. Wheel: zoom (Ctrl: the upright axis). Right drag: "
           "move."));
    column->addWidget(plot_, 1);
    connect(all, &QToolButton::clicked, plot_, &PlotView::reset_view);
    connect(picture, &QToolButton::clicked, this, &InspectionPanel::picture_requested);
    connect(table, &QToolButton::clicked, this, &InspectionPanel::table_requested);
    set_ready(false);
}

void InspectionPanel::set_ready(bool ready) {
    for (QToolButton* b : buttons_)
        b->setEnabled(ready);
}

void InspectionPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // Beside the other box, what is read off and the buttons.
    constexpr int roomy = 520;
    const int most = std::max(80, width() / (operation_->isHidden() && width() > roomy ? 3 : 4));
    for (QComboBox* box : {chart_, operation_})
        box->setMaximumWidth(std::min(220, most));
}

} // namespace facetmill::ui
