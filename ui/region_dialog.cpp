#include "ui/region_dialog.h"

#include "ui/icons.h"
#include "ui/parameter_form.h"
#include "ui/plot_view.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "viz/strip_display.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHeaderView>
#include <QHideEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill::ui {

namespace {

/// What the dialog shows of the operation's parameters, in this order.
constexpr const char* keys[] = {"lead_limit",  "assumed_lead_limit",  "rework_offset",
                                "rework_tool", "machining_direction", "view_direction"};
/// Growing goes by this share of the offset, at least by one digit of what is shown.
constexpr double step_share = 0.25;
constexpr double min_step_mm = 0.25, min_step_inch = 0.01;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double longest_in_minutes = 300 * 60; ///< beyond it the axis of time counts hours

QString angle_text(double radians) {
    return text(format_number(degrees(radians), 3)) + QChar(0x00B0);
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

/// As near to a growth (mm) as a region takes.
double allowed_growth(double grow) {
    const ParameterInfo& info = region_edit_parameters().find("grow")->info;
    return std::clamp(grow, info.minimum, info.maximum);
}

} // namespace

RegionDialog::RegionDialog(QWidget* parent) : QDialog(parent, Qt::Tool) {
    setObjectName(QStringLiteral("region_dialog"));
    setWindowTitle(tr("Settings of Rework Region"));
    setSizeGripEnabled(true);

    form_ = new ParameterForm(this);
    form_->set_live(true);
    form_->set_help_shown(false); // there is little room
    form_->installEventFilter(this);
    connect(form_, &ParameterForm::edited, this, &RegionDialog::edited);
    auto* scroll = scroll_ = new QScrollArea(this);
    scroll->setWidget(form_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumHeight(90);

    problem_ = new QLabel(this);
    problem_->setObjectName(QStringLiteral("region_problem"));
    problem_->setWordWrap(true);
    problem_->setMargin(4);
    problem_->hide();

    tabs_ = new QTabWidget(this);
    tabs_->setObjectName(QStringLiteral("region_tabs"));
    tabs_->addTab(make_region_page(), tr("Regions"));
    tabs_->addTab(make_advice_page(), tr("Trade-off"));

    status_ = new QLabel(this);
    status_->setObjectName(QStringLiteral("region_status"));
    status_->setWordWrap(true);
    status_->setMinimumWidth(60);
    progress_ = new QProgressBar(this);
    progress_->setObjectName(QStringLiteral("region_progress"));
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(4);
    QSizePolicy keep = progress_->sizePolicy();
    keep.setRetainSizeWhenHidden(true); // nothing moves when it comes
    progress_->setSizePolicy(keep);
    progress_->hide();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QAbstractButton* b : buttons->buttons())
        if (auto* push = qobject_cast<QPushButton*>(b)) push->setAutoDefault(false); // Enter is the field's
    auto* foot = new QHBoxLayout;
    foot->addWidget(status_, 1);
    foot->addWidget(buttons);

    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(8, 6, 8, 8);
    all->setSpacing(4);
    all->addWidget(scroll, 4);
    all->addWidget(problem_);
    all->addWidget(tabs_, 5);
    all->addWidget(progress_);
    all->addLayout(foot);
    show_no_regions({});
    clear_advice({});
    color();
}

RegionDialog::~RegionDialog() {
    form_->disconnect(this);
}

QWidget* RegionDialog::make_region_page() {
    auto* page = new QWidget(this);
    table_ = new QTableWidget(0, 5, page);
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
    connect(table_, &QTableWidget::cellChanged, this, &RegionDialog::cell_edited);
    connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
        update_buttons();
        if (!filling_) emit region_chosen(chosen());
    });
    none_ = new QLabel(page);
    none_->setObjectName(QStringLiteral("no_regions"));
    none_->setWordWrap(true);
    none_->setAlignment(Qt::AlignCenter);
    none_->setMargin(16);
    none_->setForegroundRole(QPalette::PlaceholderText);
    stack_ = new QStackedWidget(page);
    stack_->addWidget(table_);
    stack_->addWidget(none_);

    const auto button = [&](Icon which, const QString& label, const QString& tip, const char* name) {
        auto* b = new QToolButton(page);
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
    drop_ = new QPushButton(tr("Drop edits"), page);
    drop_->setObjectName(QStringLiteral("drop_edits"));
    drop_->setToolTip(tr("Forget what was switched off, grown, shrunk and dragged by hand"));
    drop_->setAutoDefault(false);
    connect(grow_, &QToolButton::clicked, this, [this] { step_grow(1); });
    connect(shrink_, &QToolButton::clicked, this, [this] { step_grow(-1); });
    connect(drop_, &QPushButton::clicked, this, &RegionDialog::edits_dropped);
    auto* row = new QHBoxLayout;
    row->addWidget(grow_);
    row->addWidget(shrink_);
    row->addStretch(1);
    row->addWidget(drop_);
    auto* hint = new QLabel(tr("Drag a dot on a boundary in the view to move it."), page);
    hint->setForegroundRole(QPalette::PlaceholderText);
    hint->setWordWrap(true);

    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    column->addWidget(stack_, 1);
    column->addLayout(row);
    column->addWidget(hint);
    return page;
}

QWidget* RegionDialog::make_advice_page() {
    auto* page = new QWidget(this);
    quantity_ = new QComboBox(page);
    quantity_->setObjectName(QStringLiteral("advice_quantity"));
    quantity_->addItems({tr("Machining time"), tr("Number of regions"), tr("Surface to rework")});
    axis_ = new QComboBox(page);
    axis_->setObjectName(QStringLiteral("advice_axis"));
    axis_->addItems({tr("over lead limit"), tr("over diameter")});
    for (QComboBox* box : {quantity_, axis_}) {
        box->setFocusPolicy(Qt::TabFocus);
        connect(box, &QComboBox::currentIndexChanged, this, &RegionDialog::fill_chart);
    }
    plot_ = new PlotView(page);
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
    readout_ = new QLabel(page);
    readout_->setObjectName(QStringLiteral("advice_readout"));
    readout_->setWordWrap(true);
    suggestion_ = new QLabel(page);
    suggestion_->setObjectName(QStringLiteral("advice_suggestion"));
    suggestion_->setWordWrap(true);
    use_ = new QPushButton(page);
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
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(plot_, 1);
    column->addWidget(readout_);
    column->addLayout(foot);
    return page;
}

void RegionDialog::show_settings(const Operation& operation, LengthUnit unit,
                                 const std::vector<FormChoice>& tools) {
    setWindowTitle(tr("Settings of Rework Region – %1").arg(elided(text(operation.common().name), 40)));
    const bool same_tools = tools.size() == tools_.size()
                            && std::equal(tools.begin(), tools.end(), tools_.begin(),
                                          [](const FormChoice& a, const FormChoice& b) {
                                              return a.label == b.label && a.value == b.value;
                                          });
    if (!built_ || !same_tools) {
        std::vector<const ParameterInfo*> shown;
        for (const char* key : keys)
            shown.push_back(&operation.parameter(key));
        form_->set_parameters(shown, unit, {{"rework_tool", tools}});
        for (ParameterEditor* e : form_->findChildren<ParameterEditor*>())
            connect(e, &ParameterEditor::finished, this, &RegionDialog::finished_editing);
        for (QToolButton* b : form_->findChildren<QToolButton*>())
            if (b->objectName().startsWith(QLatin1String("reset_")))
                connect(b, &QToolButton::clicked, this, &RegionDialog::finished_editing);
        tools_ = tools;
        built_ = true;
    }
    form_->set_values(operation, unit);
    unit_ = unit;
    const double smallest = unit == LengthUnit::inch ? min_step_inch * mm_per_inch : min_step_mm;
    step_ = std::max(smallest, step_share * operation.rework()->rework_offset);
}

void RegionDialog::show_regions(const std::vector<ReworkRegion>& regions, const QString& status) {
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
        auto* name = put(name_column, text(r.strip.name), Qt::ItemIsUserCheckable);
        name->setCheckState(r.strip.enabled ? Qt::Checked : Qt::Unchecked);
        name->setToolTip(r.strip.enabled ? tr("Cut by the rework tool; uncheck to leave it out")
                                         : tr("Switched off: it is not cut"));
        put(area_column, text(format_number(r.strip.area / (per * per), 3)))
            ->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        auto* grow = put(grow_column, text(format_number(r.grow / per, 4)), Qt::ItemIsEditable);
        grow->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grow->setToolTip(tr("How far its boundary lies outside the offset; double click to enter it"));
        put(tool_column, r.strip.tool > 0 ? tr("T%1").arg(r.strip.tool) : tr("none"));
        put(reason_column, sentence(text(r.strip.reason)));
    }
    filling_ = false;
    color();
    for (const int c : {name_column, area_column, grow_column, tool_column})
        table_->resizeColumnToContents(c);
    stack_->setCurrentWidget(table_);
    told_ = status;
    status_->setText(status);
    choose(was && *was < regions.size() ? was : std::nullopt);
    update_buttons();
}

void RegionDialog::show_no_regions(const QString& why) {
    filling_ = true;
    table_->setRowCount(0);
    filling_ = false;
    grown_.clear();
    none_->setText(why);
    stack_->setCurrentWidget(none_);
    told_.clear();
    status_->clear();
    update_buttons();
}

void RegionDialog::set_edited(bool edited) {
    drop_->setEnabled(edited);
}

void RegionDialog::show_problem(const std::string& key, const QString& message) {
    // What the field says by itself stays.
    if (!marked_.empty() && form_->error(marked_) == marked_with_) form_->set_error(marked_, {});
    marked_.clear();
    const bool in_form =
        std::any_of(std::begin(keys), std::end(keys), [&](const char* k) { return key == k; });
    if (in_form && !message.isEmpty()) {
        marked_ = key;
        marked_with_ = message;
        form_->set_error(key, message);
    }
    problem_->setText(in_form ? QString() : message);
    problem_->setVisible(!in_form && !message.isEmpty());
}

QString RegionDialog::problem() const {
    return marked_.empty() ? problem_->text() : form_->error(marked_);
}

QString RegionDialog::status() const {
    return status_->text();
}

std::optional<std::size_t> RegionDialog::chosen() const {
    const auto rows = table_->selectionModel()->selectedRows();
    if (rows.isEmpty()) return std::nullopt;
    return std::size_t(rows.front().row());
}

void RegionDialog::choose(std::optional<std::size_t> region) {
    if (region == chosen()) return;
    if (region)
        table_->selectRow(int(*region));
    else
        table_->clearSelection();
}

void RegionDialog::cell_edited(int row, int column) {
    if (filling_ || row < 0 || std::size_t(row) >= grown_.size()) return;
    const auto region = std::size_t(row);
    QTableWidgetItem* item = table_->item(row, column);
    if (column == name_column) {
        emit region_switched(region, item->checkState() == Qt::Checked);
        return;
    }
    if (column != grow_column) return;
    double value = 0;
    const ParameterInfo& info = region_edit_parameters().find("grow")->info;
    QString entered = item->text().trimmed();
    entered.replace(QChar(0x2212), QChar('-'));
    const bool good = parse_number(utf8(entered), value) && value * mm_per(unit_) >= info.minimum
                      && value * mm_per(unit_) <= info.maximum;
    if (!good) {
        filling_ = true;
        item->setText(text(format_number(grown_[region] / mm_per(unit_), 4)));
        filling_ = false;
        show_problem({}, tr("“%1” is not a length to grow by: enter a number, below 0 to shrink")
                             .arg(elided(entered, 30)));
        return;
    }
    if (!problem_->text().isEmpty()) show_problem({}, {});
    grown_[region] = value * mm_per(unit_);
    emit region_grown(region, grown_[region]);
}

void RegionDialog::step_grow(int direction) {
    const auto region = chosen();
    if (!region || *region >= grown_.size()) return;
    // Round numbers, whatever it was before.
    const double grow = allowed_growth(step_ * (std::round(grown_[*region] / step_) + direction));
    grown_[*region] = grow;
    filling_ = true;
    table_->item(int(*region), grow_column)->setText(text(format_number(grow / mm_per(unit_), 4)));
    filling_ = false;
    emit region_grown(*region, grow);
}

void RegionDialog::update_buttons() {
    const bool any = chosen().has_value();
    grow_->setEnabled(any);
    shrink_->setEnabled(any);
}

bool RegionDialog::over_lead() const {
    return axis_->currentIndex() == 0;
}

QString RegionDialog::estimate_text(const StrategyEstimate& e) const {
    const QString regions = e.regions == 1 ? tr("1 region") : tr("%1 regions").arg(count_text(e.regions));
    return tr("main %1 + rework %2 = %3; %4, %5 % of the surface")
        .arg(duration_text(e.main_seconds), duration_text(e.rework_seconds), duration_text(e.seconds()),
             regions, text(format_number(100 * e.rework_share, 2)));
}

void RegionDialog::show_advice(const ToolAdvice& advice, double diameter, double lead_limit) {
    advice_ = advice;
    diameter_ = diameter;
    lead_limit_ = lead_limit;
    fill_chart();
}

void RegionDialog::clear_advice(const QString& why) {
    advice_.reset();
    plot_->clear(why);
    readout_->clear();
    suggestion_->clear();
    use_->hide();
}

std::optional<double> RegionDialog::suggested() const {
    const StrategyEstimate* best = advice_ ? least(advice_->by_lead) : nullptr;
    return best ? std::optional(best->lead_limit) : std::nullopt;
}

QString RegionDialog::advice_text() const {
    return suggestion_->text();
}

void RegionDialog::fill_chart() {
    if (!advice_) return;
    const std::vector<StrategyEstimate>& all = over_lead() ? advice_->by_lead : advice_->by_diameter;
    if (all.empty()) return clear_advice(tr("There is nothing to compare"));
    PlotContent content;
    content.dots = true;
    content.x_label =
        over_lead()
            ? tr("Lead limit (°), tool D %1").arg(shown_length(diameter_, unit_, 4))
            : tr("Tool diameter (%1), lead limit %2").arg(text(unit_name(unit_)), angle_text(lead_limit_));
    for (const StrategyEstimate& e : all)
        content.x.push_back(over_lead() ? degrees(e.lead_limit) : e.diameter / mm_per(unit_));
    const auto add = [&](const QString& name, auto&& value) -> PlotSeries& {
        PlotSeries s{name, {}, {}, none, none};
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
        tr("Least by this estimate: lead limit %1 with this tool, %2; of all tools D %3 with "
           "%4, %5.")
            .arg(angle_text(own->lead_limit), duration_text(own->seconds()),
                 shown_length(best.diameter, unit_, 3), angle_text(best.lead_limit),
                 duration_text(best.seconds())));
    suggestion_->setToolTip(
        std::isfinite(advice_->diameter)
            ? tr("By Wang's (1) a tool of up to D %1 matches all but 5 % of the hollow places at this limit.")
                  .arg(shown_length(advice_->diameter, unit_, 3))
            : tr("No place is hollow: any tool matches."));
    use_->setText(tr("Use %1").arg(angle_text(own->lead_limit)));
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
void RegionDialog::show_cursor() {
    if (!advice_) return;
    if (over_lead()) plot_->set_cursor(degrees(lead_limit_));
    const std::vector<StrategyEstimate>& all = over_lead() ? advice_->by_lead : advice_->by_diameter;
    const auto& x = plot_->content().x;
    if (all.empty() || x.size() != all.size() || !plot_->cursor()) return;
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
        if (std::abs(x[i] - *plot_->cursor()) < std::abs(x[nearest] - *plot_->cursor())) nearest = i;
    const StrategyEstimate& e = all[nearest];
    readout_->setText((over_lead() ? tr("At %1: ").arg(angle_text(e.lead_limit))
                                   : tr("With D %1: ").arg(shown_length(e.diameter, unit_, 4)))
                      + estimate_text(e));
}

void RegionDialog::set_busy(bool busy, double fraction, const QString& label) {
    progress_->setVisible(busy);
    progress_->setValue(int(1000 * fraction));
    if (!busy)
        status_->setText(told_);
    else if (!label.isEmpty())
        status_->setText(label + QChar(0x2026));
}

void RegionDialog::color() {
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, signal_colors(palette()).bad);
    problem_->setPalette(colors);
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

void RegionDialog::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && problem_) color();
}

bool RegionDialog::eventFilter(QObject* watched, QEvent* event) {
    // The form takes no more than it needs; the lists and charts below have the rest.
    if (watched == form_ && (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)) {
        const QLayout& layout = *form_->layout();
        const int high = layout.hasHeightForWidth() ? layout.totalHeightForWidth(form_->width())
                                                    : layout.totalSizeHint().height();
        scroll_->setMaximumHeight(std::max(scroll_->minimumHeight(), high));
    }
    return QDialog::eventFilter(watched, event);
}

void RegionDialog::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    if (!event->spontaneous()) emit closed();
}

} // namespace facetmill::ui
