// A form made from parameter descriptions: label, editor, unit, the range and the help of the parameter at
// hand, and under a field what is wrong with it. The form never writes into the struct it shows: it hands
// over values that passed their check, and whoever owns the struct sets them (and can take them back).
#pragma once

#include "ui/parameter_editor.h"

#include <QWidget>

#include <algorithm>
#include <map>
#include <vector>

class QGridLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace facetmill::ui {

class ParameterForm : public QWidget {
    Q_OBJECT
public:
    explicit ParameterForm(QWidget* parent = nullptr);
    ~ParameterForm() override;

    /// Builds the rows anew, for other parameters. `choices` puts a fixed set in place of free entry;
    /// `hidden` keys have no row. The descriptions are kept by reference: they stand in tables that live as
    /// long as the program.
    void set_parameters(const std::vector<const ParameterInfo*>& parameters, LengthUnit unit,
                        const std::map<std::string, std::vector<FormChoice>>& choices = {},
                        const std::vector<std::string>& hidden = {});
    /// Shows the present values. A field that is being edited, or whose entry is invalid, keeps it while the
    /// value beneath it is unchanged.
    void set_values(const Parameterized& values, LengthUnit unit);
    /// The next values are of something else: no field keeps an entry.
    void forget_entries() {
        std::ranges::for_each(rows_, [](Row& r) { r.has_value = false; });
    }

    /// Sections of the manual's reference that hold the parameters, the first of them for drawings ("setups
    /// place"); set before the values.
    void set_help_scope(const QString& scope);
    /// Lengths that fields know by name.
    void set_names(NamedLengths names) { names_ = std::move(names); }

    /// Points: these rows, once they are built anew, have a button by which the point is picked in the view.
    void set_pickable(std::vector<std::string> keys) { pickable_ = std::move(keys); }
    /// The row whose point is being picked, or none ("").
    void set_picking(const std::string& key);

    /// What a row is called, within a sentence: "step-over".
    QString spoken_label(const std::string& key) const;
    /// Into the first field, its text selected.
    void focus_first();
    /// Without it the help is in the tool tips alone, and no room is kept for it below the fields.
    void set_help_shown(bool on);
    /// Also hand over values while the user still types, as soon as they are good. Off at first.
    void set_live(bool live) { live_ = live; }

    /// Takes over an entry that is not finished yet (the focus is still in it). False when a field is
    /// invalid; that field then has the focus.
    bool commit();
    bool valid() const;
    /// Shows `message` under the field until its next change; an empty one takes it away. For checks that
    /// need more than the one value.
    void set_error(const std::string& key, const QString& message);
    QString error(const std::string& key) const;
    /// Text under fields whose values are good by themselves; those of before go. Errors stay before it.
    void set_remarks(const std::map<std::string, QString>& remarks);

signals:
    /// A value that passed its check and differs from the shown one.
    void edited(const std::string& key, const facetmill::ParameterValue& value);
    /// Picking of a point was asked for, or (`on` false) given up.
    void pick_requested(const std::string& key, bool on);
    /// The form became valid or invalid.
    void validity_changed(bool valid);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        const ParameterInfo* info = nullptr;
        ParameterValue value = 0.0;
        bool has_value = false;
        QLabel* label = nullptr;
        ParameterEditor* editor = nullptr;
        QLabel* unit = nullptr;
        QToolButton *reset = nullptr, *pick = nullptr;
        QLabel* error = nullptr;
        bool invalid = false;
    };
    void add_row(QGridLayout* grid, const ParameterInfo& info, const std::vector<FormChoice>& choices);
    /// Checks the entry of a row and shows the message; true when `value` is good.
    bool check(Row& row, ParameterValue& value);
    void finish(std::size_t index);
    void show_error(Row& row, const QString& message, bool invalid);
    QString help_of(const Row& row) const;
    void show_help(const Row* row);
    Row* row_of(const QObject* widget);

    std::vector<Row> rows_;
    std::vector<std::string> pickable_;
    QVBoxLayout* layout_ = nullptr;
    QWidget* body_ = nullptr;
    QLabel* help_ = nullptr;
    NamedLengths names_;
    LengthUnit unit_ = LengthUnit::mm;
    bool advanced_open_ = false, live_ = false;
};

/// A description's help as rich text: a drawing where there is one (help_pages.h knows the scopes), what it
/// does, range, default, key.
QString help_html(const ParameterInfo& info, LengthUnit unit, const QString& scope = {});

} // namespace facetmill::ui
