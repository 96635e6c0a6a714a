#include "ui/parameter_form.h"

#include "core/base/usual_value.h"
#include "ui/help.h"
#include "ui/help_pages.h"
#include "ui/icons.h"
#include "ui/language.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/value_words.h"
#include "ui/whole_text.h"
#include "ui/worded.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QRegularExpression>
#include <QScrollArea>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

namespace {

/// Pixels: a label may ask for as much, so that fields have room in a narrow form.
constexpr int widest_word = 136;
constexpr int unit_gap = 4; // between a label and the unit beside it

QGridLayout* make_grid(QWidget* holder) {
    auto* grid = new QGridLayout(holder);
    grid->setContentsMargins(8, 4, 4, 4);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(0, 2);
    grid->setColumnStretch(1, 3);
    return grid;
}

} // namespace

QString help_html(const ParameterInfo& info, LengthUnit unit, const QString& scope) {
    constexpr int drawing_width = 200;
    QString html = QStringLiteral("<b>%1</b><br>%2")
                       .arg(worded(info.label).toHtmlEscaped(),
                            with_shown_words(info, worded(info.help)).toHtmlEscaped());
    // What is written in files stands between marks.
    static const QRegularExpression code(QStringLiteral("`([^`]*)`"));
    html.replace(code, QStringLiteral("<tt>\\1</tt>"));
    const QString range = worded(info.range_text(unit));
    QStringList facts;
    if (!range.isEmpty()) facts << ParameterForm::tr("Range: %1").arg(range.toHtmlEscaped());
    if (info.kind != ParameterKind::text && !info.is_list()) {
        const QString unit_text = text(edge_unit_name(info.quantity, unit));
        const ParameterValue usual = usual_value(info, unit);
        QString value = in_user_numbers(text(info.value_text(usual, unit)));
        if (const auto* word = std::get_if<std::string>(&usual)) value = shown_word(info, *word);
        if (!std::holds_alternative<std::string>(usual) && !unit_text.isEmpty())
            value += QStringLiteral(" ") + unit_text;
        facts << ParameterForm::tr("Default: %1").arg(value.toHtmlEscaped());
    }
    const QString drawing = parameter_drawing(scope.section(QChar(' '), 0, 0), text(info.key));
    if (!drawing.isEmpty())
        html.prepend(help_drawing_html(drawing, QApplication::palette(), drawing_width)
                     + QStringLiteral("<br>"));
    if (!facts.isEmpty()) html += QStringLiteral("<br><i>%1</i>").arg(facts.join(QStringLiteral(" · ")));
    return html;
}

ParameterForm::ParameterForm(QWidget* parent) : QWidget(parent) {
    layout_ = new QVBoxLayout(this);
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(0);
    body_ = new QWidget(this);
    layout_->addWidget(body_);
    help_ = new QLabel(this);
    help_->setObjectName(QStringLiteral("parameter_help"));
    help_->setWordWrap(true);
    help_->setTextFormat(Qt::RichText);
    help_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    help_->setMargin(8);
    help_->setForegroundRole(QPalette::PlaceholderText);
    layout_->addWidget(help_);
    layout_->addStretch(1);
}

ParameterForm::~ParameterForm() {
    // A field that loses the focus because it goes must not report to rows that are gone.
    for (const Row& row : rows_)
        row.editor->disconnect(this);
}

void ParameterForm::set_parameters(const std::vector<const ParameterInfo*>& parameters, LengthUnit unit,
                                   const std::map<std::string, std::vector<FormChoice>>& choices,
                                   const std::vector<std::string>& hidden) {
    unit_ = unit;
    for (const Row& row : rows_)
        row.editor->disconnect(this);
    rows_.clear();
    auto* old = body_;
    body_ = new QWidget(this);
    delete layout_->replaceWidget(old, body_); // the item that held it
    old->setParent(nullptr);
    old->deleteLater(); // the edit that led here may come from one of its fields
    auto* column = new QVBoxLayout(body_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* plain = new QWidget(body_);
    auto* plain_grid = make_grid(plain);
    column->addWidget(plain);
    auto* fold = new QToolButton(body_);
    auto* advanced = new QWidget(body_);
    auto* advanced_grid = make_grid(advanced);
    bool any_advanced = false;
    for (const ParameterInfo* info : parameters) {
        if (std::find(hidden.begin(), hidden.end(), info->key) != hidden.end()) continue;
        const auto found = choices.find(info->key);
        add_row(info->advanced ? advanced_grid : plain_grid, *info,
                found == choices.end() ? std::vector<FormChoice>{} : found->second);
        any_advanced |= info->advanced;
    }
    fold->setObjectName(QStringLiteral("advanced"));
    fold->setText(tr("Advanced"));
    fold->setCheckable(true);
    fold->setAutoRaise(true);
    fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    const auto unfold = [this, fold, advanced](bool open) {
        advanced_open_ = open;
        fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        advanced->setVisible(open);
    };
    connect(fold, &QToolButton::toggled, this, unfold);
    fold->setChecked(advanced_open_);
    unfold(advanced_open_);
    fold->setVisible(any_advanced);
    if (!any_advanced) advanced->hide();
    column->addWidget(fold);
    column->addWidget(advanced);
    body_->show(); // at once: a layout would do so only from the event loop
    show_help(nullptr);
    emit validity_changed(true);
}

namespace {

/// Those that take the keys.
QList<QWidget*> fields_of(const ParameterEditor& editor) {
    QList<QWidget*> fields;
    for (QWidget* w : editor.findChildren<QWidget*>())
        if ((w->focusPolicy() & Qt::TabFocus) && !qobject_cast<QComboBox*>(w->parentWidget())) fields << w;
    return fields;
}

/// Room for any unit that a project may have: that of millimetres is the wider one of feeds.
int widest_unit(const ParameterInfo& info, const QFontMetrics& metrics) {
    int widest = 0;
    for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch})
        widest = std::max(widest, metrics.horizontalAdvance(worded(edge_unit_name(info.quantity, unit))));
    return widest;
}

/// What a screen reader says of the fields: the parameter's label, with the axis where there are three.
void name_fields(const QList<QWidget*>& fields, const QString& label) {
    for (qsizetype i = 0; i < fields.size(); ++i) {
        const QString which = fields.size() == 3 ? QString(QChar('X' + char(i))) : QString::number(i + 1);
        fields[i]->setAccessibleName(fields.size() < 2 ? label : label + QChar(' ') + which);
    }
}

/// Of a place that is picked in the view, down while that goes on.
QToolButton* pick_button(const std::string& key, QWidget* holder) {
    auto* pick = new QToolButton(holder);
    pick->setObjectName(QStringLiteral("pick_") + text(key));
    pick->setIcon(icon(Icon::pick));
    pick->setIconSize(QSize(14, 14));
    pick->setAutoRaise(true);
    pick->setCheckable(true);
    pick->setFocusPolicy(Qt::TabFocus);
    pick->setToolTip(ParameterForm::tr("Pick it in the view"));
    pick->setAccessibleName(pick->toolTip());
    return pick;
}

} // namespace

void ParameterForm::add_row(QGridLayout* grid, const ParameterInfo& info,
                            const std::vector<FormChoice>& choices) {
    const std::size_t index = rows_.size();
    Row row;
    row.info = &info;
    auto* holder = grid->parentWidget();
    const int line = grid->rowCount();

    row.label = new QLabel(worded(info.label), holder);
    row.label->setWordWrap(true);
    int longest = 0; // lines break between words alone
    for (const QString& word : row.label->text().split(QLatin1Char(' ')))
        longest = std::max(longest, row.label->fontMetrics().horizontalAdvance(word) + 1);
    row.label->setMinimumWidth(std::min(longest, widest_word));
    // Made before the fields, it comes before them with Tab, too, as it stands.
    if (std::find(pickable_.begin(), pickable_.end(), info.key) != pickable_.end()) {
        row.pick = pick_button(info.key, holder);
        connect(row.pick, &QToolButton::clicked, this,
                [this, key = info.key](bool on) { emit pick_requested(key, on); });
    }
    row.editor = make_parameter_editor(info, choices, holder);
    row.label->setBuddy(row.editor);
    row.editor->setProperty(help_key_property, text(info.key));
    row.unit = new QLabel(holder);
    row.unit->setForegroundRole(QPalette::PlaceholderText);
    row.unit->setMinimumWidth(widest_unit(info, row.unit->fontMetrics()));
    row.reset = new QToolButton(holder);
    row.reset->setIcon(icon(Icon::reset));
    row.reset->setIconSize(QSize(14, 14));
    row.reset->setAutoRaise(true);
    row.reset->setObjectName(QStringLiteral("reset_") + text(info.key));
    row.reset->setToolTip(tr("Back to the default"));
    row.reset->setAccessibleName(said_of(row.label->text(), row.reset->toolTip()));
    QSizePolicy keep = row.reset->sizePolicy();
    keep.setRetainSizeWhenHidden(true);
    row.reset->setSizePolicy(keep);
    row.reset->hide();
    row.error = new QLabel(holder);
    row.error->setObjectName(QStringLiteral("error_") + text(info.key));
    row.error->setWordWrap(true);
    row.error->hide();

    // Three fields side by side would else push the defaults of all rows out of a narrow form.
    const bool has_unit = !edge_unit_name(info.quantity, LengthUnit::mm).empty(),
               beside_label = has_unit && info.kind == ParameterKind::triple;
    if (row.pick || beside_label) {
        auto* both = new QHBoxLayout;
        both->setContentsMargins(0, 0, 0, 0);
        both->addWidget(row.label, 1);
        if (beside_label) {
            both->addSpacing(unit_gap);
            both->addWidget(row.unit);
        }
        if (row.pick) both->addWidget(row.pick);
        grid->addLayout(both, line, 0);
    } else {
        grid->addWidget(row.label, line, 0);
    }
    if (info.is_list()) { // words and a button: it needs the room of unit and default, and has neither
        grid->addWidget(row.editor, line, 1, 1, 3);
        row.unit->hide();
    } else if (!has_unit || beside_label) {
        grid->addWidget(row.editor, line, 1, 1, 2);
        grid->addWidget(row.reset, line, 3);
        if (!has_unit) row.unit->hide();
    } else {
        grid->addWidget(row.editor, line, 1);
        grid->addWidget(row.unit, line, 2);
        grid->addWidget(row.reset, line, 3);
    }
    grid->addWidget(row.error, line + 1, 0, 1, 4);

    connect(row.editor, &ParameterEditor::changed, this, [this, index] {
        Row& r = rows_[index];
        ParameterValue value;
        if (!check(r, value) || !live_ || (r.has_value && value == r.value)) return;
        r.value = value; // the text stays as it is typed
        r.has_value = true;
        const std::string key = r.info->key;
        emit edited(key, value);
    });
    connect(row.editor, &ParameterEditor::finished, this, [this, index] { finish(index); });
    connect(row.reset, &QToolButton::clicked, this, [this, index] {
        Row& r = rows_[index];
        const ParameterValue value = usual_value(*r.info, unit_);
        r.editor->show_value(value, unit_);
        show_error(r, {}, false);
        const std::string key = r.info->key;
        emit edited(key, value);
    });
    name_fields(fields_of(*row.editor), row.label->text());
    row.editor->setAccessibleDescription(worded(info.help));
    for (QWidget* w : row.editor->findChildren<QWidget*>())
        w->installEventFilter(this);
    row.editor->installEventFilter(this);
    row.label->installEventFilter(this);
    rows_.push_back(row);
}

void ParameterForm::set_values(const Parameterized& values, LengthUnit unit) {
    const bool unit_changed = unit != unit_;
    unit_ = unit;
    for (Row& row : rows_) {
        const ParameterValue value = values.get(row.info->key);
        const bool same = row.has_value && value == row.value && !unit_changed;
        row.value = value;
        row.has_value = true;
        row.unit->setText(worded(edge_unit_name(row.info->quantity, unit)));
        // A list has a button of its own that clears it.
        row.reset->setVisible(row.info->kind != ParameterKind::text && !row.info->is_list()
                              && value != usual_value(*row.info, unit));
        if (same && (row.invalid || row.editor->touched())) continue;
        row.editor->show_value(value, unit);
        if (row.invalid || !same) show_error(row, {}, false);
    }
}

bool ParameterForm::check(Row& row, ParameterValue& value) {
    try {
        value = read_entered(*row.info, row.editor->entered(), unit_, names_);
        show_error(row, {}, false);
        return true;
    } catch (const Error& e) {
        show_error(row, with_shown_words(*row.info, failure_text(e)), true);
        return false;
    }
}

void ParameterForm::finish(std::size_t index) {
    if (index >= rows_.size()) return;
    Row& row = rows_[index];
    if (!row.editor->touched()) return;
    ParameterValue value;
    if (!check(row, value)) return;
    if (row.has_value && value == row.value) {
        row.editor->show_value(row.value, unit_);
        return;
    }
    // The receiver may build the form anew: nothing of the row is used afterwards.
    const std::string key = row.info->key;
    row.editor->show_value(value, unit_);
    emit edited(key, value);
}

bool ParameterForm::commit() {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        finish(i);
    for (Row& row : rows_)
        if (row.invalid) {
            row.editor->setFocus(Qt::OtherFocusReason);
            return false;
        }
    return true;
}

void ParameterForm::set_help_scope(const QString& scope) {
    setProperty(help_scope_property, scope);
}

void ParameterForm::set_help_shown(bool on) {
    help_->setVisible(on);
}

void ParameterForm::set_picking(const std::string& key) {
    for (const Row& row : rows_)
        if (row.pick) row.pick->setChecked(row.info->key == key);
}

QString ParameterForm::spoken_label(const std::string& key) const {
    for (const Row& row : rows_)
        if (row.info->key == key) return in_a_sentence(worded(row.info->label));
    return text(key);
}

void ParameterForm::focus_first() {
    if (!rows_.empty()) rows_.front().editor->setFocus(Qt::TabFocusReason);
}

bool ParameterForm::valid() const {
    return std::none_of(rows_.begin(), rows_.end(), [](const Row& r) { return r.invalid; });
}

void ParameterForm::set_error(const std::string& key, const QString& message) {
    for (Row& row : rows_)
        if (row.info->key == key) show_error(row, message, !message.isEmpty());
}

QString ParameterForm::error(const std::string& key) const {
    for (const Row& row : rows_)
        if (row.info->key == key && row.invalid) return row.error->text();
    return {};
}

void ParameterForm::set_remarks(const std::map<std::string, QString>& remarks) {
    for (Row& row : rows_) {
        if (row.invalid) continue;
        const auto at = remarks.find(row.info->key);
        show_error(row, at != remarks.end() ? at->second : QString(), false);
    }
}

void ParameterForm::show_error(Row& row, const QString& message, bool invalid) {
    const bool was_valid = valid();
    row.invalid = invalid;
    row.error->setText(kept_together(message));
    row.error->setVisible(!message.isEmpty());
    QPalette palette = row.error->palette();
    palette.setColor(QPalette::WindowText, signal_colors(this->palette()).bad);
    row.error->setPalette(palette);
    row.editor->mark(invalid);
    if (was_valid != valid()) emit validity_changed(!was_valid);
}

QString ParameterForm::help_of(const Row& row) const {
    return help_html(*row.info, unit_, property(help_scope_property).toString());
}

void ParameterForm::show_help(const Row* row) {
    help_->setText(row ? kept_together(help_of(*row)) : QString());
}

ParameterForm::Row* ParameterForm::row_of(const QObject* widget) {
    for (Row& row : rows_)
        if (row.label == widget || row.editor == widget
            || (widget && widget->parent()
                && (widget->parent() == row.editor || widget->parent()->parent() == row.editor)))
            return &row;
    return nullptr;
}

bool ParameterForm::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::Enter)
        if (const Row* row = row_of(object)) show_help(row);
    // Made when it is asked for: drawings and ranges of a whole form would hold the window up.
    if (auto* at = qobject_cast<QWidget*>(object); at && event->type() == QEvent::ToolTip)
        if (const Row* row = row_of(object); row && at->toolTip().isEmpty()) {
            QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                               with_whole_text(*at, help_of(*row)), at);
            return true;
        }
    return QWidget::eventFilter(object, event);
}

void ParameterForm::changeEvent(QEvent* event) {
    // The fields have their new palettes only after the form has its own.
    if (event->type() == QEvent::PaletteChange)
        QMetaObject::invokeMethod(
            this,
            [this] {
                for (Row& row : rows_)
                    if (row.invalid) show_error(row, row.error->text(), true);
            },
            Qt::QueuedConnection);
    QWidget::changeEvent(event);
}

} // namespace facetmill::ui
