#include "ui/region_dialog.h"

#include "ui/parameter_form.h"
#include "ui/text.h"
#include "ui/theme.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QHideEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

namespace {

/// What the dialog shows of the operation's parameters, in this order.
constexpr const char* keys[] = {"lead_limit",  "assumed_lead_limit",  "rework_offset",
                                "rework_tool", "machining_direction", "view_direction"};

} // namespace

RegionDialog::RegionDialog(QWidget* parent) : QDialog(parent, Qt::Tool) {
    setObjectName(QStringLiteral("region_dialog"));
    setWindowTitle(tr("Settings of Rework Region"));
    setSizeGripEnabled(true);

    form_ = new ParameterForm(this);
    form_->set_help_scope(QStringLiteral("global_local"));
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
    regions_ = new RegionPage(this);
    advice_ = new AdvicePage(this);
    tabs_->addTab(regions_, tr("Regions"));
    tabs_->addTab(advice_, tr("Trade-off"));
    connect(regions_, &RegionPage::region_switched, this, &RegionDialog::region_switched);
    connect(regions_, &RegionPage::region_grown, this, &RegionDialog::region_grown);
    connect(regions_, &RegionPage::region_chosen, this, &RegionDialog::region_chosen);
    connect(regions_, &RegionPage::edits_dropped, this, &RegionDialog::edits_dropped);
    connect(regions_, &RegionPage::refused, this, [this](const QString& why) {
        if (!why.isEmpty() || !problem_->text().isEmpty()) show_problem({}, why);
    });
    connect(advice_, &AdvicePage::lead_wanted, this, &RegionDialog::lead_wanted);
    connect(advice_, &AdvicePage::lead_chosen, this, &RegionDialog::lead_chosen);

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
    color();
}

RegionDialog::~RegionDialog() {
    form_->disconnect(this);
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
    regions_->set_lengths(unit, operation.rework()->rework_offset);
    advice_->set_unit(unit);
}

void RegionDialog::show_regions(const std::vector<ReworkRegion>& regions, const QString& status) {
    regions_->show_regions(regions);
    told_ = kept_together(status);
    status_->setText(told_);
}

void RegionDialog::show_no_regions(const QString& why) {
    regions_->show_no_regions(why);
    told_.clear();
    status_->clear();
}

void RegionDialog::show_problem(const std::string& key, const QString& message) {
    // What the field says by itself stays.
    if (!marked_.empty() && form_->error(marked_) == marked_with_) form_->set_error(marked_, {});
    marked_.clear();
    const bool in_form =
        std::any_of(std::begin(keys), std::end(keys), [&](const char* k) { return key == k; });
    if (in_form && !message.isEmpty()) {
        marked_ = key;
        form_->set_error(key, message);
        marked_with_ = form_->error(key);
    }
    problem_->setText(in_form ? QString() : kept_together(message));
    problem_->setVisible(!in_form && !message.isEmpty());
}

QString RegionDialog::problem() const {
    return marked_.empty() ? problem_->text() : form_->error(marked_);
}

QString RegionDialog::status() const {
    return status_->text();
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
