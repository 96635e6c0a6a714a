// Edits one tool, with its profile beside the form and every value checked while it is typed.
#pragma once

#include "core/base/units.h"
#include "core/setup/tool_edit.h"
#include "ui/document.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QMenu;

namespace facetmill::ui {

class ParameterForm;
class RecordTable;
class ToolSketch;

class ToolDialog : public QDialog {
    Q_OBJECT
public:
    /// `taken`: numbers of the other tools.
    ToolDialog(const Tool& tool, LengthUnit unit, std::vector<long> taken, QWidget* parent = nullptr);

    /// Opens the dialog for a tool of the document, or for a new one, and puts what it comes to into the
    /// document. Null where there is no such tool.
    static ToolDialog* open_for(Document& document, std::optional<std::size_t> index, QWidget* parent);

    const Tool& tool() const { return edit_.tool(); }
    /// Why OK is not possible; empty when it is.
    QString problem() const;
    QString holder_remark() const;
    void accept() override;

signals:
    /// The document has the tool now, at this place.
    void taken(std::size_t index);

private:
    /// The tables of its holder's sections and of its feeds.
    QWidget* make_lists();
    /// Every holder of the user's libraries once.
    void list_holders(QMenu& menu);
    void set_value(const std::string& key, const ParameterValue& value);
    void show_values();
    void show_lists();
    void validate();

    ToolEdit edit_;
    LengthUnit unit_;
    std::vector<long> taken_;
    ParameterForm* form_ = nullptr;
    ToolSketch* sketch_ = nullptr;
    QComboBox* shape_ = nullptr;
    RecordTable *holder_ = nullptr, *cutting_ = nullptr;
    QLabel* problem_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
    std::string marked_; ///< field that carries the message of the check of all values together
    QString check_message_;
    bool validating_ = false;
};

} // namespace facetmill::ui
