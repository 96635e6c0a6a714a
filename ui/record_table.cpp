#include "ui/record_table.h"

#include "ui/icons.h"
#include "ui/language.h"
#include "ui/parameter_editor.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/value_words.h"
#include "ui/worded.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

namespace {

QString heading(const ParameterInfo& field, LengthUnit unit) {
    const QString in = worded(edge_unit_name(field.quantity, unit));
    return in.isEmpty() ? worded(field.label) : QStringLiteral("%1\n(%2)").arg(worded(field.label), in);
}

/// 0 says that nobody has said it.
bool may_be_unsaid(const ParameterInfo& field) {
    return field.kind == ParameterKind::number && field.minimum == 0 && !field.open_minimum
           && field.default_value == ParameterValue(0.0);
}

QToolButton* make_button(Icon which, const QString& name, const QString& tip, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(name);
    button->setIcon(icon(which));
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    return button;
}

} // namespace

RecordTable::RecordTable(std::vector<const ParameterInfo*> fields, LengthUnit unit, const Words& words,
                         std::function<std::vector<ParameterValue>(const ParameterRecords&)> new_record,
                         QWidget* parent)
    : QWidget(parent), fields_(std::move(fields)), unit_(unit), called_(words.called),
      new_record_(std::move(new_record)) {
    table_ = new QTableWidget(0, int(fields_.size()), this);
    table_->setObjectName(words.name);
    table_->setAccessibleName(words.called);
    for (int k = 0; k < table_->columnCount(); ++k) {
        const ParameterInfo& field = *fields_[std::size_t(k)];
        auto* head = new QTableWidgetItem(heading(field, unit_));
        head->setToolTip(worded(field.help));
        table_->setHorizontalHeaderItem(k, head);
    }
    table_->installEventFilter(this);
    table_->verticalHeader()->setVisible(false);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setMinimumHeight(86);
    none_ = new QLabel(words.none, table_->viewport());
    none_->setObjectName(words.name + QStringLiteral("_none"));
    none_->setAlignment(Qt::AlignCenter);
    none_->setWordWrap(true);
    none_->setForegroundRole(QPalette::PlaceholderText);
    auto* over = new QVBoxLayout(table_->viewport());
    over->addWidget(none_);
    connect(table_, &QTableWidget::itemChanged, this, [this] {
        if (!filling_) read();
    });
    auto* add = make_button(Icon::add, QStringLiteral("add_") + words.row, words.add, this);
    auto* remove = make_button(Icon::remove, QStringLiteral("remove_") + words.row, words.remove, this);
    connect(add, &QToolButton::clicked, this, &RecordTable::add_row);
    connect(remove, &QToolButton::clicked, this, &RecordTable::remove_row);
    buttons_ = new QVBoxLayout;
    buttons_->addWidget(add);
    buttons_->addWidget(remove);
    buttons_->addStretch(1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 4, 4, 4);
    row->addWidget(table_, 1);
    row->addLayout(buttons_);
}

bool RecordTable::eventFilter(QObject* object, QEvent* event) {
    if (object == table_ && (event->type() == QEvent::Resize || event->type() == QEvent::Show)) fit_columns();
    return QWidget::eventFilter(object, event);
}

/// As wide as their heads, and what is left shared out; where there is too little the table is scrolled.
void RecordTable::fit_columns() {
    QHeaderView* heads = table_->horizontalHeader();
    int need = 0;
    for (int k = 0; k < heads->count(); ++k)
        need += heads->sectionSizeHint(k);
    const int more = std::max(0, table_->viewport()->width() - need) / std::max(1, heads->count());
    for (int k = 0; k < heads->count(); ++k)
        heads->resizeSection(k, heads->sectionSizeHint(k) + more);
}

void RecordTable::add_button(QToolButton* button) {
    buttons_->insertWidget(buttons_->count() - 1, button);
}

void RecordTable::set_records(const ParameterRecords& records) {
    records_ = records;
    show();
}

void RecordTable::add_row() {
    records_.all.push_back(new_record_(records_));
    filling_ = true;
    table_->insertRow(table_->rowCount());
    show_row(table_->rowCount() - 1, records_.all.back());
    filling_ = false;
    show_none();
    read(); // cells that cannot be read yet stand as they are
}

void RecordTable::remove_row() {
    if (table_->rowCount() == 0) return;
    const int row = table_->currentRow() >= 0 ? table_->currentRow() : table_->rowCount() - 1;
    if (std::size_t(row) < records_.all.size()) records_.all.erase(records_.all.begin() + row);
    filling_ = true;
    table_->removeRow(row);
    filling_ = false;
    show_none();
    read();
}

QString RecordTable::shown(const ParameterValue& value, const ParameterInfo& field) const {
    if (may_be_unsaid(field) && value == field.default_value) return {};
    if (const auto* number = std::get_if<double>(&value)) return shown_number(*number, field, unit_);
    return in_user_numbers(text(field.value_text(value, unit_)));
}

/// What nobody touched keeps all its digits.
ParameterValue RecordTable::entered(int row, int column, const QString& entry) const {
    const ParameterInfo& field = *fields_[std::size_t(column)];
    if (std::size_t(row) < records_.all.size()) {
        const ParameterValue& before = records_.all[std::size_t(row)][std::size_t(column)];
        if (entry == shown(before, field)) return before;
    }
    if (may_be_unsaid(field) && entry.trimmed().isEmpty()) return field.default_value;
    const ParameterValue value = read_entered(field, entry, unit_, {});
    field.check(value, unit_);
    return value;
}

void RecordTable::show_row(int row, const std::vector<ParameterValue>& record) {
    for (int k = 0; k < table_->columnCount(); ++k) {
        const ParameterInfo& field = *fields_[std::size_t(k)];
        auto* item = new QTableWidgetItem(shown(record[std::size_t(k)], field));
        if (field.kind != ParameterKind::text) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        table_->setItem(row, k, item);
    }
}

void RecordTable::show() {
    filling_ = true;
    table_->setRowCount(int(records_.all.size()));
    for (int row = 0; row < table_->rowCount(); ++row)
        show_row(row, records_.all[std::size_t(row)]);
    problem_.clear();
    filling_ = false;
    show_none();
}

void RecordTable::show_none() {
    none_->setVisible(table_->rowCount() == 0);
}

void RecordTable::read() {
    ParameterRecords now;
    problem_.clear();
    filling_ = true;
    for (int row = 0; row < table_->rowCount(); ++row) {
        auto& record = now.all.emplace_back();
        for (int k = 0; k < table_->columnCount(); ++k) {
            const ParameterInfo& field = *fields_[std::size_t(k)];
            QTableWidgetItem* item = table_->item(row, k);
            try {
                record.push_back(entered(row, k, item ? item->text() : QString()));
                if (!item) continue;
                item->setForeground(QBrush());
                item->setText(shown(record.back(), field));
            } catch (const Error& e) {
                if (item) item->setForeground(QBrush(signal_colors(palette()).bad));
                if (problem_.isEmpty())
                    problem_ =
                        tr("%1 %2, %3: %4")
                            .arg(called_)
                            .arg(row + 1)
                            .arg(in_a_sentence(worded(field.label)), with_lengths_in(failure_text(e), unit_));
            }
        }
    }
    filling_ = false;
    if (problem_.isEmpty()) records_ = std::move(now);
    emit edited();
}

} // namespace facetmill::ui
