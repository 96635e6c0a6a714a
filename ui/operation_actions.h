// What the project's tree offers for one operation beside what it offers for all lists: to plan it, to verify
// up to it, to write its program alone, to switch it off, to copy and paste it.
#pragma once

#include "ui/document.h"

#include <QAction>

#include <utility>
#include <vector>

class QMenu;

namespace facetmill::ui {

class OperationActions : public QObject {
    Q_OBJECT
public:
    OperationActions(Document& document, QWidget* tree);

    /// The place of the operation that is meant from now on; none: no operation is selected.
    void set_operation(std::optional<std::size_t> place);
    /// Into a context menu: those for the operation that is meant.
    void add_to(QMenu& menu);
    QAction* copy_action() { return copy_; }
    QAction* paste_action() { return paste_; }
    QAction* switch_action() { return switch_; }
    /// By the names that menus know them by.
    std::vector<std::pair<const char*, QAction*>> commands();

signals:
    void plan_wanted(std::size_t operation);
    void verify_wanted(std::size_t operation);
    void export_wanted(std::size_t operation);
    /// An operation came to this place.
    void pasted(std::size_t operation);
    /// What cannot be, or could not be taken along.
    void refused(const QString& why);

private:
    void copy();
    void paste();

    Document& document_;
    QWidget* tree_ = nullptr;
    std::optional<std::size_t> operation_;
    QAction *plan_ = nullptr, *verify_ = nullptr, *export_ = nullptr, *switch_ = nullptr, *copy_ = nullptr,
            *paste_ = nullptr;
};

} // namespace facetmill::ui
