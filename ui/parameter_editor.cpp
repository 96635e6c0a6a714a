#include "ui/parameter_editor.h"

#include "ui/elided_label.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/value_words.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLineEdit>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolButton>
#include <QToolTip>

#include <algorithm>

namespace facetmill::ui {

namespace {

void mark_line(QWidget* widget, bool invalid) {
    QPalette palette;
    if (invalid) {
        const QPalette base = widget->parentWidget() ? widget->parentWidget()->palette() : QPalette();
        const QColor bad = signal_colors(base).bad;
        const QColor ground = base.color(QPalette::Base);
        palette = base; // words in their own colour, which can be read on the other ground as well
        palette.setColor(QPalette::Base, mixed(ground, 5, bad));
    }
    widget->setPalette(palette);
}

/// A wheel turned to scroll the form must not change the combo box under the pointer.
class WheelGuard : public QObject {
public:
    explicit WheelGuard(QWidget* widget) : QObject(widget) {
        widget->setFocusPolicy(Qt::StrongFocus);
        widget->installEventFilter(this);
    }
    bool eventFilter(QObject* object, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(object)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

/// number, integer, text; with `parts` 2 or 3 also pair and triple.
class LineEditor : public ParameterEditor {
public:
    LineEditor(const ParameterInfo& info, int parts, QWidget* parent) : info_(info) {
        setParent(parent);
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(4);
        for (int i = 0; i < parts; ++i) {
            auto* line = new QLineEdit(this);
            line->setObjectName(text(info.key) + (parts > 1 ? QString::number(i) : QString()));
            line->setMinimumWidth(parts > 1 ? 32 : 60);
            // Three beside one another have hardly room for six figures each.
            if (parts > 2) line->setTextMargins(-2, 0, -2, 0);
            line->setMaxLength(200);
            connect(line, &QLineEdit::textEdited, this, [this] {
                touched_ = true;
                emit changed();
            });
            connect(line, &QLineEdit::editingFinished, this, &ParameterEditor::finished);
            row->addWidget(line);
            lines_.push_back(line);
        }
        setFocusProxy(lines_.front());
    }
    // A line that loses the focus because it goes must not report through an editor that is half gone.
    ~LineEditor() override {
        for (QLineEdit* line : lines_)
            line->disconnect(this);
    }

    void show_value(const ParameterValue& value, LengthUnit unit) override {
        touched_ = false;
        std::vector<QString> shown;
        if (const auto* d = std::get_if<double>(&value))
            shown = {shown_number(*d, info_, unit)};
        else if (const auto* p = std::get_if<std::array<double, 2>>(&value))
            for (const double v : *p)
                shown.push_back(shown_number(v, info_, unit));
        else if (const auto* t = std::get_if<std::array<double, 3>>(&value))
            for (const double v : *t)
                shown.push_back(shown_number(v, info_, unit));
        else
            shown = {text(info_.value_text(value, unit))};
        for (std::size_t i = 0; i < lines_.size() && i < shown.size(); ++i) {
            QLineEdit* line = lines_[i];
            if (line->text() == shown[i] && !line->isModified()) continue;
            // What was typed is the document's now: the line has nothing of its own to take back.
            const int at = line->text() == shown[i] ? line->cursorPosition() : 0;
            line->setText(shown[i]);
            line->setCursorPosition(at);
        }
        shown_ = shown;
        exact_.clear();
        if (const auto* t = std::get_if<std::array<double, 3>>(&value)) keep_exact(*t, unit);
        if (const auto* p = std::get_if<std::array<double, 2>>(&value)) keep_exact(*p, unit);
    }
    QString entered() const override {
        if (lines_.size() == 1) return lines_.front()->text();
        // Each field has its own decimal mark: a comma goes between them. What was not typed stays as it is,
        // to the last digit.
        QStringList parts;
        for (std::size_t i = 0; i < lines_.size(); ++i)
            parts << (i < exact_.size() && lines_[i]->text() == shown_[i]
                          ? exact_[i]
                          : with_decimal_point(lines_[i]->text(), info_.key));
        return parts.join(QStringLiteral(", "));
    }
    bool touched() const override { return touched_; }
    void mark(bool invalid) override {
        for (auto* line : lines_)
            mark_line(line, invalid);
    }

private:
    template <std::size_t N>
    void keep_exact(const std::array<double, N>& values, LengthUnit unit) {
        constexpr int exact_digits = 17;
        for (const double v : values)
            exact_.push_back(text(format_number(v / info_.scale(unit), exact_digits)));
    }

    const ParameterInfo& info_;
    std::vector<QLineEdit*> lines_;
    std::vector<QString> shown_; ///< by the lines
    std::vector<QString> exact_; ///< the same, whole, where they are several numbers
    bool touched_ = false;
};

/// number_or_word: a combo box to type into, with the words as its items.
class NumberOrWordEditor : public ParameterEditor {
public:
    NumberOrWordEditor(const ParameterInfo& info, QWidget* parent) : info_(info) {
        setParent(parent);
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(0, 0, 0, 0);
        combo_ = new QComboBox(this);
        combo_->setObjectName(text(info.key));
        combo_->setEditable(true);
        combo_->setInsertPolicy(QComboBox::NoInsert);
        combo_->setMinimumContentsLength(4); // beside a unit as long as "mm/min", in a small window
        combo_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        combo_->lineEdit()->setMaxLength(200);
        for (const auto& word : info.words)
            combo_->addItem(shown_word(info, word));
        new WheelGuard(combo_);
        connect(combo_->lineEdit(), &QLineEdit::textEdited, this, [this] {
            touched_ = true;
            emit changed();
        });
        connect(combo_, &QComboBox::activated, this, [this] {
            touched_ = true;
            emit changed();
            emit finished();
        });
        connect(combo_->lineEdit(), &QLineEdit::editingFinished, this, &ParameterEditor::finished);
        row->addWidget(combo_);
        setFocusProxy(combo_);
    }
    ~NumberOrWordEditor() override { combo_->lineEdit()->disconnect(this); }
    void show_value(const ParameterValue& value, LengthUnit unit) override {
        touched_ = false;
        if (const auto* d = std::get_if<double>(&value))
            combo_->setEditText(shown_number(*d, info_, unit));
        else
            combo_->setEditText(shown_word(info_, std::get<std::string>(value)));
        combo_->lineEdit()->setCursorPosition(0);
    }
    QString entered() const override { return word_of(info_, combo_->currentText()); }
    bool touched() const override { return touched_; }
    void mark(bool invalid) override { mark_line(combo_->lineEdit(), invalid); }

private:
    const ParameterInfo& info_;
    QComboBox* combo_ = nullptr;
    bool touched_ = false;
};

/// Names of tools and machines can be longer than the form is wide: they end in dots, and the list and the
/// tool tip have them in full.
class ElidedCombo : public QComboBox {
public:
    using QComboBox::QComboBox;
    void showPopup() override {
        view()->setMinimumWidth(view()->sizeHintForColumn(0) + 24);
        QComboBox::showPopup();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QStylePainter painter(this);
        QStyleOptionComboBox option;
        initStyleOption(&option);
        const int room =
            style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this).width();
        option.currentText = fontMetrics().elidedText(option.currentText, Qt::ElideRight, room - 4);
        painter.drawComplexControl(QStyle::CC_ComboBox, option);
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
    }
    bool event(QEvent* event) override {
        if (event->type() == QEvent::ToolTip && toolTip().isEmpty()) {
            QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), currentText(), this);
            return true;
        }
        return QComboBox::event(event);
    }
};

/// choice, and anything that was given a fixed set.
class ChoiceEditor : public ParameterEditor {
public:
    ChoiceEditor(const ParameterInfo& info, const std::vector<FormChoice>& choices, QWidget* parent)
        : info_(info) {
        setParent(parent);
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(0, 0, 0, 0);
        combo_ = new ElidedCombo(this);
        combo_->setObjectName(text(info.key));
        combo_->setMinimumContentsLength(6);
        combo_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        for (const auto& choice : choices)
            combo_->addItem(choice.label, text(info.value_text(choice.value, LengthUnit::mm)));
        new WheelGuard(combo_);
        connect(combo_, &QComboBox::activated, this, [this] {
            touched_ = true;
            emit changed();
            emit finished();
        });
        row->addWidget(combo_);
        setFocusProxy(combo_);
    }
    void show_value(const ParameterValue& value, LengthUnit) override {
        touched_ = false;
        const QString entry = text(info_.value_text(value, LengthUnit::mm));
        int index = combo_->findData(entry);
        if (index < 0) {
            // A value that refers to nothing (a tool that is not there) is shown, not replaced in silence.
            combo_->insertItem(0, ParameterEditor::tr("%1 (missing)").arg(entry), entry);
            index = 0;
        }
        combo_->setCurrentIndex(index);
    }
    QString entered() const override { return combo_->currentData().toString(); }
    bool touched() const override { return touched_; }
    void mark(bool invalid) override { mark_line(combo_, invalid); }

private:
    const ParameterInfo& info_;
    QComboBox* combo_ = nullptr;
    bool touched_ = false;
};

class BooleanEditor : public ParameterEditor {
public:
    BooleanEditor(const ParameterInfo& info, QWidget* parent) {
        setParent(parent);
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(0, 0, 0, 0);
        box_ = new QCheckBox(this);
        box_->setObjectName(text(info.key));
        connect(box_, &QCheckBox::clicked, this, [this] {
            touched_ = true;
            emit changed();
            emit finished();
        });
        row->addWidget(box_);
        setFocusProxy(box_);
    }
    void show_value(const ParameterValue& value, LengthUnit) override {
        touched_ = false;
        box_->setChecked(std::get<bool>(value));
    }
    QString entered() const override {
        return box_->isChecked() ? QStringLiteral("true") : QStringLiteral("false");
    }
    bool touched() const override { return touched_; }
    void mark(bool) override {}

private:
    QCheckBox* box_ = nullptr;
    bool touched_ = false;
};

/// names, records: how many there are, and a button that takes them all away. What stands in them comes from
/// elsewhere in the window.
class ListEditor : public ParameterEditor {
public:
    ListEditor(const ParameterInfo& info, QWidget* parent) : info_(info), value_(info.empty_list()) {
        setParent(parent);
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(4);
        count_ = new ElidedLabel(this);
        count_->setObjectName(text(info.key));
        clear_ = new QToolButton(this);
        clear_->setText(ParameterEditor::tr("Clear"));
        clear_->setFocusPolicy(Qt::StrongFocus);
        clear_->setObjectName(QStringLiteral("clear_") + text(info.key));
        connect(clear_, &QToolButton::clicked, this, [this] {
            value_ = info_.empty_list();
            touched_ = true;
            emit changed();
            emit finished();
        });
        row->addWidget(count_, 1);
        row->addWidget(clear_);
        setFocusProxy(clear_);
    }
    void show_value(const ParameterValue& value, LengthUnit unit) override {
        touched_ = false;
        value_ = value;
        unit_ = unit;
        count_->set_text(shown_count(info_, value));
        clear_->setEnabled(value != info_.empty_list());
    }
    QString entered() const override { return text(info_.value_text(value_, unit_)); }
    bool touched() const override { return touched_; }
    void mark(bool) override {}

private:
    const ParameterInfo& info_;
    ParameterValue value_;
    LengthUnit unit_ = LengthUnit::mm;
    ElidedLabel* count_ = nullptr;
    QToolButton* clear_ = nullptr;
    bool touched_ = false;
};

/// Neither a number nor anything that comes to one.
bool is_word(const QString& entered) {
    return std::none_of(entered.begin(), entered.end(),
                        [](QChar c) { return c.isDigit() || QStringLiteral("=.+-*/()").contains(c); });
}

/// What was entered with every number in it worked out, in the field's unit.
QString worked_out(const ParameterInfo& info, const QString& entered, LengthUnit unit,
                   const NamedLengths& names) {
    QStringList parts = entered.split(QChar(','));
    for (QString& part : parts) {
        double ignored = 0;
        if (is_word(part) || parse_number(utf8(part.trimmed()), ignored)) continue;
        const double value = evaluate(utf8(part), info.quantity, unit, names, info.key);
        part = text(format_number(value / info.scale(unit), 17));
    }
    return parts.join(QChar(','));
}

} // namespace

ParameterEditor* make_parameter_editor(const ParameterInfo& info, const std::vector<FormChoice>& choices,
                                       QWidget* parent) {
    if (!choices.empty()) return new ChoiceEditor(info, choices, parent);
    switch (info.kind) {
    case ParameterKind::number_or_word:
        return new NumberOrWordEditor(info, parent);
    case ParameterKind::boolean:
        return new BooleanEditor(info, parent);
    case ParameterKind::choice: {
        std::vector<FormChoice> words;
        for (const auto& word : info.words)
            words.push_back({shown_word(info, word), word});
        return new ChoiceEditor(info, words, parent);
    }
    case ParameterKind::names:
    case ParameterKind::records:
        return new ListEditor(info, parent);
    case ParameterKind::pair:
        return new LineEditor(info, 2, parent);
    case ParameterKind::triple:
        return new LineEditor(info, 3, parent);
    case ParameterKind::number:
    case ParameterKind::integer:
    case ParameterKind::text:
        break;
    }
    return new LineEditor(info, 1, parent);
}

ParameterValue read_entered(const ParameterInfo& info, const QString& entered, LengthUnit unit,
                            const NamedLengths& names) {
    const bool numbers = info.kind == ParameterKind::number || info.kind == ParameterKind::integer
                         || info.kind == ParameterKind::pair || info.kind == ParameterKind::triple;
    if (numbers && entered.trimmed().isEmpty())
        throw Error(ErrorCode::wrong_type, info.key, utf8(QObject::tr("nothing is entered")),
                    utf8(QObject::tr("enter a number")));
    const bool word = info.kind == ParameterKind::number_or_word;
    const bool single = info.kind == ParameterKind::number || info.kind == ParameterKind::integer
                        || (word && !is_word(entered));
    const QString point = single ? with_decimal_point(entered, info.key) : entered;
    if (info.kind == ParameterKind::number && point.contains(QChar(',')))
        throw Error(ErrorCode::wrong_type, info.key, utf8(QObject::tr("a comma is not a decimal mark")),
                    utf8(QObject::tr("use a point: 0.5")));
    return info.parse(utf8(numbers || word ? worked_out(info, point, unit, names) : entered), unit);
}

} // namespace facetmill::ui
