// The editor of one parameter, made from its description: a line, a combo box, a check box, two or three
// lines, the count of a list. Every editor hands over text that ParameterInfo::parse reads, so that forms,
// files and the command line share one grammar.
#pragma once

#include "core/base/expression.h"
#include "core/base/parameter.h"

#include <QWidget>

#include <vector>

namespace facetmill::ui {

/// A fixed set in place of free entry, for values that refer to something else (the tool of an operation).
struct FormChoice {
    QString label;
    ParameterValue value;
};

class ParameterEditor : public QWidget {
    Q_OBJECT
public:
    ~ParameterEditor() override = default;

    /// Shows a value; what the user typed is gone.
    virtual void show_value(const ParameterValue& value, LengthUnit unit) = 0;
    /// What stands in the editor, as ParameterInfo::parse reads it.
    virtual QString entered() const = 0;
    /// True from the user's first change until the next show_value.
    virtual bool touched() const = 0;
    virtual void mark(bool invalid) = 0;

signals:
    /// The user changed something; `entered` may be half a number.
    void changed();
    /// The user is through: Enter, the focus left, an item was picked.
    void finished();
};

/// Never null. Words are shown as the window says them (value_words.h).
ParameterEditor* make_parameter_editor(const ParameterInfo& info, const std::vector<FormChoice>& choices,
                                       QWidget* parent);

/// Reads what the user entered: numbers may be worked out, and carry units and names (expression.h). Throws
/// Error as ParameterInfo::parse and `evaluate`, with a remedy that speaks to somebody at a form.
ParameterValue read_entered(const ParameterInfo& info, const QString& entered, LengthUnit unit,
                            const NamedLengths& names);

} // namespace facetmill::ui
