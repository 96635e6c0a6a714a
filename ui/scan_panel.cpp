#include "ui/scan_panel.h"

#include "ui/elided_label.h"
#include "ui/flow_layout.h"
#include "ui/icon_button.h"
#include "ui/parameter_form.h"
#include "ui/scan_words.h"
#include "ui/text.h"
#include "ui/theme.h"

#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <functional>
#include <utility>

namespace facetmill::ui {

namespace {

constexpr int rows_of_survey = 9, rows_of_steps = 9; // lines of text
/// Qt's maximum of a progress bar.
constexpr int whole_progress = 1000;

QLabel* bold_heading(const QString& title, QWidget* parent) {
    auto* label = new QLabel(title, parent);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

QLabel* quiet_label(QWidget* parent, const char* name) {
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

QPushButton* push_button(const QString& label, const QString& tip, const char* name, QWidget* parent) {
    auto* b = new QPushButton(label, parent);
    b->setObjectName(QLatin1String(name));
    b->setToolTip(tip);
    return b;
}

/// No room is kept for one that says nothing.
void show_text(QLabel* label, const QString& words) {
    label->setText(kept_together(words));
    label->setVisible(!words.isEmpty());
}

QMenu* kind_menu(QWidget* parent, const std::function<void(RepairStep::Kind)>& add) {
    auto* menu = new QMenu(parent);
    menu->setObjectName(QStringLiteral("scan_add_menu"));
    menu->setToolTipsVisible(true);
    const auto& words = repair_step_parameters().find("kind")->info.words;
    for (std::size_t k = 0; k < words.size(); ++k) {
        const auto kind = RepairStep::Kind(k);
        if (kind == RepairStep::Kind::hole) continue; // it is chosen in the list of holes
        QAction* a = menu->addAction(step_name(kind), parent, [add, kind] { add(kind); });
        a->setObjectName(QStringLiteral("add_") + text(words[k]));
        a->setToolTip(step_help(kind));
    }
    return menu;
}

} // namespace

ScanPanel::ScanPanel(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("scan_panel"));
    auto* inside = new QWidget(this);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(8, 6, 8, 6);
    title_ = new ElidedLabel(inside);
    title_->setObjectName(QStringLiteral("scan_title"));
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    subtitle_ = quiet_label(inside, "scan_subtitle");
    note_ = new QLabel(inside);
    note_->setObjectName(QStringLiteral("scan_note"));
    note_->setWordWrap(true);
    column->addWidget(title_);
    column->addWidget(subtitle_);
    column->addWidget(note_);
    content_ = new QWidget(inside);
    auto* all = new QVBoxLayout(content_);
    all->setContentsMargins(0, 0, 0, 0);
    build_survey(all);
    build_steps(all);
    column->addWidget(content_);
    column->addStretch(1);

    auto* scroll = new QScrollArea(this);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->setSpacing(0);
    outer->addWidget(scroll, 1);
    // Always in sight, however far the rest is scrolled.
    footer_ = new QWidget(this);
    auto* bottom = new QVBoxLayout(footer_);
    bottom->setContentsMargins(8, 4, 8, 6);
    build_trial(bottom);
    outer->addWidget(footer_);
    show_progress(-1, {});
    show_sides(false, std::nullopt);
    show_can({});
}

void ScanPanel::build_survey(QVBoxLayout* column) {
    column->addWidget(bold_heading(tr("What the file holds"), this));
    survey_ = new QTreeWidget(this);
    survey_->setObjectName(QStringLiteral("scan_survey"));
    survey_->setAccessibleName(tr("What the file holds"));
    survey_->setColumnCount(after_column + 1);
    survey_->setHeaderLabels({QString(), tr("File"), tr("After")});
    survey_->headerItem()->setToolTip(now_column, tr("As the file is"));
    survey_->headerItem()->setToolTip(
        after_column, tr("What the recipe makes of it; of single holes and pieces what becomes of them"));
    survey_->header()->setSectionResizeMode(what_column, QHeaderView::Stretch);
    survey_->header()->setSectionResizeMode(now_column, QHeaderView::ResizeToContents);
    survey_->header()->setSectionResizeMode(after_column, QHeaderView::ResizeToContents);
    survey_->header()->setStretchLastSection(false);
    survey_->header()->setSectionsMovable(false);
    survey_->header()->setMinimumSectionSize(40);
    survey_->setUniformRowHeights(true);
    survey_->setIndentation(14);
    survey_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    survey_->setFixedHeight((rows_of_survey + 1) * (survey_->fontMetrics().height() + 6));
    column->addWidget(survey_);
    const auto choose = [this](QTreeWidgetItem* item) {
        if (filling_ || !item || !item->parent()) return;
        emit part_chosen(std::size_t(survey_->indexOfTopLevelItem(item->parent())),
                         std::size_t(item->parent()->indexOfChild(item)));
    };
    connect(survey_, &QTreeWidget::currentItemChanged, this, choose);
    // Again where the view has been turned away meanwhile.
    connect(survey_, &QTreeWidget::itemClicked, this, choose);
}

void ScanPanel::build_steps(QVBoxLayout* column) {
    column->addWidget(bold_heading(tr("Recipe"), this));
    steps_ = new QListWidget(this);
    steps_->setObjectName(QStringLiteral("scan_steps"));
    steps_->setAccessibleName(tr("Steps of the recipe"));
    steps_->setWordWrap(true);
    steps_->setTextElideMode(Qt::ElideRight);
    steps_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    steps_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    steps_->setFixedHeight(rows_of_steps * (steps_->fontMetrics().height() + 3));
    empty_ = quiet_label(this, "scan_empty");
    empty_->setText(tr("No step yet: the file is taken as it is. Suggest makes a recipe for what was found; "
                       "Add takes single steps."));
    column->addWidget(empty_);
    column->addWidget(steps_);

    auto* buttons = new QWidget(this);
    auto* row = new FlowLayout(buttons, 4);
    row->setContentsMargins(0, 0, 0, 0);
    add_ = new QToolButton(this);
    add_->setObjectName(QStringLiteral("scan_add"));
    add_->setIcon(icon(Icon::add));
    add_->setText(tr("Add"));
    add_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add_->setToolTip(tr("Add a step behind the chosen one"));
    add_->setFocusPolicy(Qt::TabFocus);
    add_->setPopupMode(QToolButton::InstantPopup);
    QMenu* menu = kind_menu(add_, [this](RepairStep::Kind kind) { emit add_wanted(kind); });
    add_->setMenu(menu);
    remove_ = icon_button(this, Icon::remove, tr("Remove the step (Del)"), "scan_remove");
    up_ = icon_button(this, Icon::up, tr("Carry the step out earlier"), "scan_up");
    down_ = icon_button(this, Icon::down, tr("Carry the step out later"), "scan_down");
    suggest_ = push_button(tr("Su&ggest"),
                           tr("Puts steps for what was found in the place of the recipe, to be changed"),
                           "scan_suggest", this);
    row->addWidget(add_);
    for (QToolButton* b : {remove_, up_, down_})
        row->addWidget(b);
    row->addWidget(suggest_);
    column->addWidget(buttons);

    form_ = new ParameterForm(this);
    form_->set_live(true);
    form_->set_help_shown(false); // what the step is for stands below the fields
    form_->set_help_scope(QStringLiteral("part-repair"));
    column->addWidget(form_);
    remark_ = quiet_label(this, "scan_remark");
    column->addWidget(remark_);

    auto* by_key = new QAction(this);
    by_key->setShortcut(QKeySequence::Delete);
    by_key->setShortcutContext(Qt::WidgetShortcut);
    steps_->addAction(by_key);
    connect(by_key, &QAction::triggered, remove_, &QToolButton::click);
    connect(steps_, &QListWidget::currentRowChanged, this, [this] {
        if (!filling_) emit step_chosen();
    });
    connect(steps_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!filling_) emit switched(std::size_t(steps_->row(item)), item->checkState() == Qt::Checked);
    });
    connect(remove_, &QToolButton::clicked, this, &ScanPanel::remove_wanted);
    connect(up_, &QToolButton::clicked, this, [this] { emit move_wanted(-1); });
    connect(down_, &QToolButton::clicked, this, [this] { emit move_wanted(+1); });
    connect(suggest_, &QPushButton::clicked, this, &ScanPanel::suggest_wanted);
    connect(form_, &ParameterForm::edited, this, &ScanPanel::edited);
}

void ScanPanel::build_trial(QVBoxLayout* column) {
    summary_ = new QLabel(footer_);
    summary_->setObjectName(QStringLiteral("scan_summary"));
    summary_->setWordWrap(true);
    column->addWidget(summary_);
    running_ = new QWidget(footer_);
    auto* run = new QHBoxLayout(running_);
    run->setContentsMargins(0, 0, 0, 0);
    progress_ = new QProgressBar(running_);
    progress_->setObjectName(QStringLiteral("scan_progress"));
    progress_->setAccessibleName(tr("Progress of the preview"));
    progress_->setRange(0, whole_progress);
    stop_ = push_button(tr("Stop"), tr("Stop the preview (Esc)"), "scan_stop", running_);
    run->addWidget(progress_, 1);
    run->addWidget(stop_);
    column->addWidget(running_);

    auto* trial = new QWidget(footer_);
    auto* sides = new FlowLayout(trial, 8);
    sides->setContentsMargins(0, 0, 0, 0);
    preview_ = push_button(tr("P&review"),
                           tr("Carries the recipe out and shows what it would make; the "
                              "project stays as it is"),
                           "scan_preview", footer_);
    before_ = new QRadioButton(tr("&Before"), footer_);
    before_->setObjectName(QStringLiteral("scan_before"));
    before_->setToolTip(tr("The view shows the file's mesh, and tinted what the recipe takes away"));
    after_ = new QRadioButton(tr("Af&ter"), footer_);
    after_->setObjectName(QStringLiteral("scan_after"));
    after_->setToolTip(tr("The view shows what the recipe makes, in colours of how far it moved, and tinted "
                          "what is new"));
    sides->addWidget(preview_);
    sides->addWidget(before_);
    sides->addWidget(after_);
    column->addWidget(trial);

    auto* end = new QWidget(footer_);
    auto* last = new FlowLayout(end, 8);
    last->setContentsMargins(0, 0, 0, 0);
    apply_ = push_button(tr("Appl&y"), tr("Puts the recipe into the project, as one step that can be undone"),
                         "scan_apply", footer_);
    reset_ = push_button(tr("&Cancel"), tr("Goes back to the recipe of the project; nothing is changed"),
                         "scan_reset", footer_);
    last->addWidget(apply_);
    last->addWidget(reset_);
    column->addWidget(end);
    connect(preview_, &QPushButton::clicked, this, &ScanPanel::preview_wanted);
    connect(stop_, &QPushButton::clicked, this, &ScanPanel::stop_wanted);
    connect(apply_, &QPushButton::clicked, this, &ScanPanel::apply_wanted);
    connect(reset_, &QPushButton::clicked, this, &ScanPanel::reset_wanted);
    connect(before_, &QRadioButton::clicked, this, [this] { emit side_wanted(false); });
    connect(after_, &QRadioButton::clicked, this, [this] { emit side_wanted(true); });
}

void ScanPanel::show_head(const QString& title, const QString& subtitle, const QString& note) {
    title_->set_text(title);
    title_->setVisible(!title.isEmpty());
    show_text(subtitle_, subtitle);
    show_text(note_, note);
    content_->setVisible(note.isEmpty());
    footer_->setVisible(note.isEmpty());
}

void ScanPanel::fill_line(QTreeWidgetItem* item, const Line& line) const {
    item->setText(what_column, line.what);
    item->setText(now_column, line.now);
    item->setText(after_column, line.after);
    for (const int c : {now_column, after_column})
        item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    for (int c = what_column; c <= after_column; ++c)
        item->setToolTip(c, line.help);
    QFont font = survey_->font();
    font.setBold(line.flaw);
    item->setFont(now_column, font);
}

void ScanPanel::show_survey(const std::vector<Line>& lines) {
    filling_ = true;
    survey_->clear();
    for (const Line& line : lines) {
        auto* item = new QTreeWidgetItem(survey_);
        fill_line(item, line);
        for (const Line& part : line.parts)
            fill_line(new QTreeWidgetItem(item), part);
    }
    filling_ = false;
}

void ScanPanel::show_after(const std::vector<Line>& lines) {
    for (int i = 0; i < survey_->topLevelItemCount() && std::size_t(i) < lines.size(); ++i) {
        QTreeWidgetItem* item = survey_->topLevelItem(i);
        const Line& line = lines[std::size_t(i)];
        item->setText(after_column, line.after);
        for (int k = 0; k < item->childCount() && std::size_t(k) < line.parts.size(); ++k)
            item->child(k)->setText(after_column, line.parts[std::size_t(k)].after);
    }
}

void ScanPanel::show_steps(const std::vector<Step>& steps, std::optional<std::size_t> chosen) {
    filling_ = true;
    // The same items where there are as many, so that the keys stay where they are.
    while (steps_->count() > int(steps.size()))
        delete steps_->takeItem(steps_->count() - 1);
    while (steps_->count() < int(steps.size()))
        new QListWidgetItem(steps_);
    const auto signal = signal_colors(palette());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step& step = steps[i];
        QListWidgetItem* item = steps_->item(int(i));
        const QString name = tr("%1. %2").arg(i + 1).arg(step.name);
        item->setText(step.result.isEmpty() ? name : name + QChar('\n') + step.result);
        item->setToolTip(step.help);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(step.off ? Qt::Unchecked : Qt::Checked);
        item->setForeground(step.failed ? QBrush(signal.bad)
                            : step.off  ? palette().brush(QPalette::PlaceholderText)
                                        : QBrush());
    }
    steps_->setCurrentRow(chosen ? int(*chosen) : -1);
    filling_ = false;
    steps_->setVisible(!steps.empty());
    empty_->setVisible(steps.empty());
    remove_->setEnabled(can_edit_ && chosen);
    up_->setEnabled(can_edit_ && chosen && *chosen > 0);
    down_->setEnabled(can_edit_ && chosen && *chosen + 1 < steps.size());
}

std::optional<std::size_t> ScanPanel::chosen() const {
    const int row = steps_->currentRow();
    return row < 0 ? std::nullopt : std::optional(std::size_t(row));
}

void ScanPanel::show_parameters(RepairStep* step, LengthUnit unit, const NamedLengths& names) {
    form_->setVisible(step && !repair_keys(step->kind).empty());
    if (!step) {
        form_kind_.reset();
        form_->set_parameters({}, unit);
        return;
    }
    if (form_kind_ != step->kind || form_unit_ != unit) {
        form_kind_ = step->kind;
        form_unit_ = unit;
        std::vector<const ParameterInfo*> read;
        for (const std::string& key : repair_keys(step->kind))
            read.push_back(&repair_step_parameters().find(key)->info);
        form_->set_parameters(read, unit);
    }
    form_->set_names(names);
    form_->set_values(ParameterView<RepairStep>(*step, repair_step_parameters()), unit);
}

void ScanPanel::show_remark(const QString& remark, bool alarm) {
    show_text(remark_, remark);
    QPalette shades = palette();
    remark_->setForegroundRole(alarm ? QPalette::WindowText : QPalette::PlaceholderText);
    if (alarm) shades.setColor(QPalette::WindowText, signal_colors(shades).bad);
    remark_->setPalette(shades);
}

void ScanPanel::show_can(const Can& can) {
    can_edit_ = can.edit;
    add_->setEnabled(can.edit);
    suggest_->setEnabled(can.edit);
    steps_->setEnabled(can.edit);
    form_->setEnabled(can.edit);
    preview_->setEnabled(can.preview);
    apply_->setEnabled(can.apply);
    reset_->setEnabled(can.reset);
}

void ScanPanel::show_progress(double fraction, const QString& label) {
    running_->setVisible(fraction >= 0);
    progress_->setValue(int(whole_progress * std::max(fraction, 0.0)));
    progress_->setFormat(label);
    progress_->setToolTip(label);
}

void ScanPanel::show_sides(bool there, std::optional<bool> after) {
    for (QRadioButton* b : {before_, after_}) {
        b->setEnabled(there);
        b->setAutoExclusive(false); // else one of them could not be let go
        b->setChecked(after && *after == (b == after_));
        b->setAutoExclusive(true);
    }
}

void ScanPanel::show_summary(const QString& summary) {
    show_text(summary_, summary);
}

} // namespace facetmill::ui
