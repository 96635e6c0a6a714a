#include "ui/region_page.h"

#include "ui/icons.h"
#include "ui/parameter_editor.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/worded.h"
#include "viz/strip_display.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

/// Growing goes by this share of the offset, at least by one digit of what is shown.
constexpr double step_share = 0.25;
constexpr double min_step_mm = 0.25, min_step_inch = 0.01;

/// As near to a growth (mm) as a region takes.
double allowed_growth(double grow) {
    const ParameterInfo& info = region_edit_parameters().find("grow")->info;
    return std::clamp(grow, info.minimum, info.maximum);
}

} // namespace

RegionPage::RegionPage(QWidget* parent) : QWidget(parent) {
    table_ = new QTableWidget(0, 5, this);
    table_->setObjectName(QStringLiteral("region_table"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    table_->setAlternatingRowColors(true);
    table_->setWordWrap(false);
    table_->setTextElideMode(Qt::ElideRight);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setHighlightSections(false);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->setAccessibleName(tr("Rework regions"));
    connect(table_, &QTableWidget::cellChanged, this, &RegionPage::cell_edited);
    connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
        update_buttons();
        if (!filling_) emit region_chosen(chosen());
    });
    none_ = new QLabel(this);
    none_->setObjectName(QStringLiteral("no_regions"));
    none_->setWordWrap(true);
    none_->setAlignment(Qt::AlignCenter);
    none_->setMargin(16);
    none_->setForegroundRole(QPalette::PlaceholderText);
    stack_ = new QStackedWidget(this);
    stack_->addWidget(table_);
    stack_->addWidget(none_);

    const auto button = [&](Icon which, const QString& label, const QString& tip, const char* name) {
        auto* b = new QToolButton(this);
        b->setObjectName(QLatin1String(name));
        b->setIcon(icon(which));
        b->setText(label);
        b->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        b->setToolTip(tip);
        b->setFocusPolicy(Qt::TabFocus);
        return b;
    };
    grow_ = button(Icon::add, tr("Grow"), tr("Move the boundary of the chosen region outward"), "grow");
    shrink_ =
        button(Icon::remove, tr("Shrink"),
               tr("Move the boundary of the chosen region inward, never inside of what is uncut"), "shrink");
    drop_ = new QPushButton(tr("Drop edits"), this);
    drop_->setObjectName(QStringLiteral("drop_edits"));
    drop_->setToolTip(tr("Forget what was switched off, grown, shrunk and dragged by hand"));
    drop_->setAutoDefault(false);
    connect(grow_, &QToolButton::clicked, this, [this] { step_grow(1); });
    connect(shrink_, &QToolButton::clicked, this, [this] { step_grow(-1); });
    connect(drop_, &QPushButton::clicked, this, &RegionPage::edits_dropped);
    auto* row = new QHBoxLayout;
    row->addWidget(grow_);
    row->addWidget(shrink_);
    row->addStretch(1);
    row->addWidget(drop_);
    auto* hint = new QLabel(tr("Drag a dot on a boundary in the view to move it."), this);
    hint->setForegroundRole(QPalette::PlaceholderText);
    hint->setWordWrap(true);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    column->addWidget(stack_, 1);
    column->addLayout(row);
    column->addWidget(hint);
    show_no_regions({});
}

void RegionPage::set_lengths(LengthUnit unit, double rework_offset) {
    unit_ = unit;
    const double smallest = unit == LengthUnit::inch ? min_step_inch * mm_per_inch : min_step_mm;
    step_ = std::max(smallest, step_share * rework_offset);
}

void RegionPage::show_regions(const std::vector<ReworkRegion>& regions) {
    const auto was = chosen();
    const double per = mm_per(unit_);
    const QString unit = text(unit_name(unit_));
    filling_ = true;
    table_->setHorizontalHeaderLabels({tr("Region"), tr("Area (%1)").arg(unit + QChar(0x00B2)),
                                       tr("Grow (%1)").arg(unit), tr("Tool"), tr("Reason")});
    table_->setRowCount(int(regions.size()));
    grown_.clear();
    for (int row = 0; row < table_->rowCount(); ++row) {
        const ReworkRegion& r = regions[std::size_t(row)];
        grown_.push_back(r.grow);
        const auto put = [&](Column column, const QString& words, Qt::ItemFlags flags = {}) {
            auto* item = new QTableWidgetItem(words);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | flags);
            item->setToolTip(words);
            table_->setItem(row, column, item);
            return item;
        };
        auto* name = put(name_column, worded(r.strip.name), Qt::ItemIsUserCheckable);
        name->setCheckState(r.strip.enabled ? Qt::Checked : Qt::Unchecked);
        name->setToolTip(r.strip.enabled ? tr("Cut by the rework tool; uncheck to leave it out")
                                         : tr("Switched off: it is not cut"));
        put(area_column, number_text(r.strip.area / (per * per), 3))
            ->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        auto* grow = put(grow_column, number_text(r.grow / per, 4), Qt::ItemIsEditable);
        grow->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grow->setToolTip(tr("How far its boundary lies outside the offset; double click to enter it"));
        put(tool_column, r.strip.tool > 0 ? tr("T%1").arg(r.strip.tool) : tr("none"));
        put(reason_column, sentence(worded(r.strip.reason)));
    }
    filling_ = false;
    color();
    for (const int c : {name_column, area_column, grow_column, tool_column})
        table_->resizeColumnToContents(c);
    stack_->setCurrentWidget(table_);
    choose(was && *was < regions.size() ? was : std::nullopt);
    update_buttons();
}

void RegionPage::show_no_regions(const QString& why) {
    filling_ = true;
    table_->setRowCount(0);
    filling_ = false;
    grown_.clear();
    none_->setText(kept_together(why));
    stack_->setCurrentWidget(none_);
    update_buttons();
}

void RegionPage::set_edited(bool edited) {
    drop_->setEnabled(edited);
}

std::optional<std::size_t> RegionPage::chosen() const {
    const auto rows = table_->selectionModel()->selectedRows();
    if (rows.isEmpty()) return std::nullopt;
    return std::size_t(rows.front().row());
}

void RegionPage::choose(std::optional<std::size_t> region) {
    if (region == chosen()) return;
    if (region)
        table_->selectRow(int(*region));
    else
        table_->clearSelection();
}

void RegionPage::cell_edited(int row, int column) {
    if (filling_ || row < 0 || std::size_t(row) >= grown_.size()) return;
    const auto region = std::size_t(row);
    QTableWidgetItem* item = table_->item(row, column);
    if (column == name_column) {
        emit region_switched(region, item->checkState() == Qt::Checked);
        return;
    }
    if (column != grow_column) return;
    QString entered = item->text().trimmed();
    entered.replace(QChar(0x2212), QChar('-'));
    std::optional<double> grow;
    try {
        grow =
            std::get<double>(read_entered(region_edit_parameters().find("grow")->info, entered, unit_, {}));
    } catch (const Error&) {
        emit refused(tr("“%1” is not a length to grow by: enter a number, below 0 to shrink")
                         .arg(elided(entered, 30)));
    }
    filling_ = true;
    item->setText(number_text(grow.value_or(grown_[region]) / mm_per(unit_), 4));
    filling_ = false;
    if (!grow) return;
    emit refused({});
    grown_[region] = *grow;
    emit region_grown(region, *grow);
}

void RegionPage::step_grow(int direction) {
    const auto region = chosen();
    if (!region || *region >= grown_.size()) return;
    // Round numbers, whatever it was before.
    const double grow = allowed_growth(step_ * (std::round(grown_[*region] / step_) + direction));
    grown_[*region] = grow;
    filling_ = true;
    table_->item(int(*region), grow_column)->setText(number_text(grow / mm_per(unit_), 4));
    filling_ = false;
    emit region_grown(*region, grow);
}

void RegionPage::update_buttons() {
    const bool any = chosen().has_value();
    grow_->setEnabled(any);
    shrink_->setEnabled(any);
}

void RegionPage::color() {
    // As the view draws them.
    const auto view = is_dark(palette()) ? facetmill::Palette::dark : facetmill::Palette::light;
    filling_ = true;
    for (int row = 0; row < table_->rowCount(); ++row) {
        QTableWidgetItem* name = table_->item(row, name_column);
        const bool on = name->checkState() == Qt::Checked;
        name->setIcon(swatch(strip_color(std::size_t(row), on, view), devicePixelRatioF()));
    }
    filling_ = false;
}

void RegionPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && table_) color();
}

} // namespace facetmill::ui
