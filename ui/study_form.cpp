#include "ui/study_form.h"

#include "core/study/study.h"
#include "ui/study_words.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/value_words.h"
#include "ui/worded.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

namespace {

/// Data of a line of the tree: the variation, and the choice; of measures: the measure.
constexpr int variation_role = Qt::UserRole, choice_role = Qt::UserRole + 1;

QString chosen_words(const DraftVariation& v) {
    QStringList on;
    for (const DraftVariation::Choice& c : v.choices)
        if (c.on) on << c.label;
    return on.join(QStringLiteral("; "));
}

/// "Tolerance (in)".
QString with_unit(const DraftVariation& v, LengthUnit unit) {
    const QString in = v.info ? worded(edge_unit_name(v.info->quantity, unit)) : QString();
    return in.isEmpty() ? v.what : QStringLiteral("%1 (%2)").arg(v.what, in);
}

} // namespace

StudyForm::StudyForm(QWidget* parent) : QWidget(parent) {
    build_vary();
    build_measures();
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(measures_, 1);
    column->addWidget(build_options());
    auto* halves = new QSplitter(Qt::Horizontal, this);
    halves->setChildrenCollapsible(false);
    halves->addWidget(vary_);
    halves->addWidget(right);
    halves->setStretchFactor(0, 3);
    halves->setStretchFactor(1, 2);
    estimate_ = new QLabel(this);
    estimate_->setObjectName(QStringLiteral("study_estimate"));
    estimate_->setWordWrap(true);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(6, 6, 6, 2);
    all->addWidget(halves, 1);
    all->addWidget(estimate_);
}

void StudyForm::build_vary() {
    vary_ = new QTreeWidget(this);
    vary_->setObjectName(QStringLiteral("study_vary"));
    vary_->setAccessibleName(tr("What may vary"));
    vary_->setHeaderLabels({tr("What may vary"), tr("Values")});
    vary_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    vary_->setMinimumWidth(220);
    vary_->setToolTip(tr("Tick the tools and strategies that may serve; write several numbers with a "
                         "semicolon between them"));
    connect(vary_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (!filling_) take_check(item);
    });
}

void StudyForm::build_measures() {
    measures_ = new QTreeWidget(this);
    measures_->setObjectName(QStringLiteral("study_measures"));
    measures_->setAccessibleName(tr("What is wanted"));
    measures_->setHeaderLabels({tr("To be kept small"), tr("At most")});
    measures_->setRootIsDecorated(false);
    measures_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    measures_->setToolTip(
        tr("Those that are ticked make the front; a limit is a number, or ×1.1 for 1.1 times "
           "what the project comes to"));
    measures_->setMinimumWidth(200);
    connect(measures_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (filling_) return;
        const auto m = std::size_t(item->data(0, variation_role).toInt());
        draft_.measures[m].wanted = item->checkState(0) == Qt::Checked;
        emit changed();
    });
}

QWidget* StudyForm::build_options() {
    auto* options = new QWidget(this);
    auto* form = new QFormLayout(options);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    first_ = new QComboBox(options);
    first_->setObjectName(QStringLiteral("study_first"));
    first_->setToolTip(tr("Of those that meet all limits, the one with the least of this wins"));
    for (const Measure m : all_measures())
        first_->addItem(measure_label(m), int(m));
    connect(first_, &QComboBox::activated, this, [this] {
        draft_.first = Measure(first_->currentData().toInt());
        emit changed();
    });
    samples_ = new QSpinBox(options);
    samples_->setObjectName(QStringLiteral("study_samples"));
    samples_->setRange(0, int(Study::max_candidates));
    samples_->setSpecialValueText(tr("all combinations"));
    samples_->setToolTip(tr("So many of the combinations, chosen by chance, the same each time; 0: all"));
    connect(samples_, &QSpinBox::valueChanged, this, [this](int n) {
        draft_.samples = std::size_t(n);
        if (!filling_) emit changed();
    });
    form->addRow(tr("The winner has the least"), first_);
    form->addRow(tr("Candidates"), samples_);
    for (QWidget* field : std::initializer_list<QWidget*>{first_, samples_})
        field->setAccessibleName(static_cast<QLabel*>(form->labelForField(field))->text());
    return options;
}

void StudyForm::set_draft(StudyDraft draft) {
    draft_ = std::move(draft);
    filling_ = true;
    fill_vary();
    fill_measures();
    first_->setCurrentIndex(first_->findData(int(draft_.first)));
    samples_->setValue(int(draft_.samples));
    filling_ = false;
    order_tabs();
    tell_counts();
    emit changed();
}

/// Tab goes down one list with its fields, then down the other, then to the rest.
void StudyForm::order_tabs() {
    QWidget* last = vary_;
    const auto next = [&](QWidget* field) {
        QWidget::setTabOrder(last, field);
        last = field;
    };
    for (QLineEdit* field : vary_fields_)
        next(field);
    next(measures_);
    for (QLineEdit* field : limit_fields_)
        next(field);
    for (QWidget* field : std::initializer_list<QWidget*>{first_, samples_})
        next(field);
}

void StudyForm::fill_vary() {
    vary_->clear();
    vary_fields_.clear();
    QTreeWidgetItem* operation = nullptr;
    QString named;
    for (std::size_t i = 0; i < draft_.vary.size(); ++i) {
        const DraftVariation& v = draft_.vary[i];
        if (v.kind == DraftVariation::Kind::orders) {
            auto* row = new QTreeWidgetItem(vary_, {v.what, tr("every order")});
            row->setData(0, variation_role, int(i));
            row->setData(0, choice_role, -1);
            row->setCheckState(0, v.on ? Qt::Checked : Qt::Unchecked);
            continue;
        }
        if (!operation || named != v.operation) {
            named = v.operation;
            operation = new QTreeWidgetItem(vary_, {elided(named, 30)});
            operation->setToolTip(0, named);
            operation->setFirstColumnSpanned(true);
            QFont bold = font();
            bold.setBold(true);
            operation->setFont(0, bold);
            operation->setFlags(Qt::ItemIsEnabled);
            operation->setExpanded(true);
        }
        auto* row = new QTreeWidgetItem(operation, {with_unit(v, draft_.unit)});
        row->setData(0, variation_role, int(i));
        row->setData(0, choice_role, -1);
        if (v.kind == DraftVariation::Kind::choices)
            add_choices(row, i);
        else
            add_field(row, i);
    }
}

void StudyForm::add_choices(QTreeWidgetItem* row, std::size_t variation) {
    const DraftVariation& v = draft_.vary[variation];
    row->setText(1, chosen_words(v));
    for (std::size_t c = 0; c < v.choices.size(); ++c) {
        auto* item = new QTreeWidgetItem(row, {v.choices[c].label});
        item->setData(0, variation_role, int(variation));
        item->setData(0, choice_role, int(c));
        item->setFirstColumnSpanned(true);
        item->setCheckState(0, v.choices[c].on ? Qt::Checked : Qt::Unchecked);
    }
}

void StudyForm::add_field(QTreeWidgetItem* row, std::size_t variation) {
    const DraftVariation& v = draft_.vary[variation];
    auto* field = new QLineEdit(v.typed, vary_);
    field->setObjectName(QStringLiteral("study_values_") + text(v.path.substr(v.path.rfind('.') + 1)));
    field->setAccessibleName(tr("%1: %2").arg(v.operation, v.what));
    QStringList known;
    for (const std::string& word : v.info->words)
        known << shown_word(*v.info, word);
    const QString range = in_user_numbers(worded(v.info->range_text(draft_.unit)));
    const QString words =
        v.info->kind == ParameterKind::triple ? tr("A number for all sides or three with blanks between them "
                                                   "(x, y, z), %1; a semicolon between "
                                                   "one value and the next")
                                                    .arg(range)
        : v.info->kind == ParameterKind::pair
            ? tr("Two numbers with a blank between them, %1; a semicolon between one pair and the next")
                  .arg(range)
        : known.isEmpty()
            ? tr("Numbers with a semicolon between them, %1").arg(range)
            : tr("Numbers or %1, with a semicolon between them").arg(known.join(QStringLiteral(", ")));
    field->setToolTip(words);
    vary_->setItemWidget(row, 1, field);
    vary_fields_.push_back(field);
    connect(field, &QLineEdit::textEdited, this, [this, variation](const QString& typed) {
        draft_.vary[variation].typed = typed;
        tell_counts();
        emit changed();
    });
}

void StudyForm::take_check(QTreeWidgetItem* item) {
    const int v = item->data(0, variation_role).toInt(), c = item->data(0, choice_role).toInt();
    DraftVariation& variation = draft_.vary[std::size_t(v)];
    const bool on = item->checkState(0) == Qt::Checked;
    if (variation.kind == DraftVariation::Kind::orders)
        variation.on = on;
    else if (c >= 0)
        variation.choices[std::size_t(c)].on = on;
    tell_counts();
    emit changed();
}

/// What varies stands out, with its values beside it.
void StudyForm::tell_counts() {
    filling_ = true;
    const auto tell = [this](QTreeWidgetItem* row) {
        if (!row->data(0, variation_role).isValid()) return;
        const DraftVariation& v = draft_.vary[std::size_t(row->data(0, variation_role).toInt())];
        if (v.kind == DraftVariation::Kind::choices) {
            row->setText(1, chosen_words(v));
            row->setToolTip(1, chosen_words(v));
        }
        QFont bold = font();
        bold.setBold(v.count(draft_.unit) > 1);
        row->setFont(0, bold);
    };
    for (int i = 0; i < vary_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* top = vary_->topLevelItem(i);
        tell(top);
        for (int k = 0; k < top->childCount(); ++k)
            tell(top->child(k));
    }
    filling_ = false;
}

void StudyForm::fill_measures() {
    measures_->clear();
    limit_fields_.clear();
    for (std::size_t i = 0; i < draft_.measures.size(); ++i) {
        const DraftMeasure& m = draft_.measures[i];
        QString named = measure_head(m.measure, draft_.unit);
        if (m.measure == Measure::machining_time) named = tr("%1 (min)").arg(measure_label(m.measure));
        if (m.measure == Measure::uncut_share) named = tr("%1 (%)").arg(measure_label(m.measure));
        auto* row = new QTreeWidgetItem(measures_, {named});
        row->setData(0, variation_role, int(i));
        row->setCheckState(0, m.wanted ? Qt::Checked : Qt::Unchecked);
        auto* field = new QLineEdit(m.most, measures_);
        field->setObjectName(QStringLiteral("study_most_") + text(measure_name(m.measure)));
        field->setAccessibleName(tr("At most: %1").arg(named));
        field->setPlaceholderText(QStringLiteral("–"));
        field->setMinimumWidth(50);
        measures_->setItemWidget(row, 1, field);
        limit_fields_.push_back(field);
        connect(field, &QLineEdit::textEdited, this, [this, i](const QString& typed) {
            draft_.measures[i].most = typed;
            emit changed();
        });
    }
}

void StudyForm::show_estimate(const QString& words, bool alarm) {
    estimate_->setText(kept_together(words));
    QPalette colors = palette();
    if (alarm) colors.setColor(QPalette::WindowText, signal_colors(palette()).bad);
    estimate_->setPalette(colors);
}

} // namespace facetmill::ui
