// The project as a tree: part, stock, machine, tools, operations with their state, and the buttons that
// change the lists.
#pragma once

#include "ui/document.h"
#include "ui/icons.h"

#include <QTreeWidget>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QMenu;
class QToolBar;
class QTreeWidgetItem;

namespace facetmill::ui {

struct TreeNode {
    /// stock_after: what an operation leaves, below it in the tree; setup: only where there are several;
    /// elsewhere: an operation of a setup that is not chosen, by its place among all of the project.
    enum class Kind {
        part,
        stock,
        fixture,
        boundary,
        machine,
        limits,
        tools,
        tool,
        operations,
        operation,
        stock_after,
        setup,
        elsewhere
    };
    Kind kind = Kind::part;
    std::size_t index = 0; ///< which tool, fixture, boundary or operation
    bool operator==(const TreeNode&) const = default;
};

class OperationActions;
class ProjectTreeView;
class VerificationModel;

class ProjectTree : public QWidget {
    Q_OBJECT
public:
    explicit ProjectTree(Document& document, QWidget* parent = nullptr);
    ~ProjectTree() override;

    std::optional<TreeNode> selected() const;
    void select(const TreeNode& node);
    QTreeWidget* tree();
    OperationActions& operations() { return *operations_; }
    QTreeWidgetItem* item(const TreeNode& node) const;

    /// Shows a badge for the verdict on every operation. The model lives as long as the tree.
    void set_verification(const VerificationModel& model);

    QAction* add_tool_action() { return add_tool_; }
    QAction* tool_library_action() { return tool_library_; }
    QMenu* add_operation_menu() { return add_operation_; }
    QMenu* add_setup_menu() { return add_setup_; }
    QMenu* add_fixture_menu() { return add_fixture_; }
    QMenu* add_boundary_menu() { return add_boundary_; }
    QAction* go_to_setup_action() { return go_to_setup_; }
    QAction* edit_action() { return edit_; }
    QAction* duplicate_action() { return duplicate_; }
    QAction* remove_action() { return remove_; }
    QAction* rename_action() { return rename_; }
    QAction* up_action() { return up_; }
    QAction* down_action() { return down_; }

signals:
    void selection_changed();
    void edit_tool(std::size_t index);
    void new_tool();
    /// The parameters of what is selected are wanted, by Enter, or by F2 where it has no name of its own.
    void edit_parameters();
    /// A mesh for a new fixture at this place of the list is asked for.
    void new_mesh_fixture(std::size_t at);
    /// A change that the project refuses.
    void refused(const QString& why);

private:
    void make_tree();
    void make_actions();
    QToolBar* make_bar();
    void rebuild();
    /// The setup that is selected, or has the selected operation of another one.
    std::optional<std::size_t> selected_setup() const;
    void go_to_setup();
    void change_setups(const std::function<void()>& change);
    void show_states();
    void show_verdicts();
    void update_actions();
    void edit_selected();
    void duplicate();
    void remove();
    void move(int by);
    void menu(const QPoint& at);

    Document& document_;
    const VerificationModel* verification_ = nullptr;
    ProjectTreeView* tree_ = nullptr;
    OperationActions* operations_ = nullptr;
    QAction *add_tool_ = nullptr, *tool_library_ = nullptr, *edit_ = nullptr, *rename_ = nullptr,
            *duplicate_ = nullptr, *remove_ = nullptr, *up_ = nullptr, *down_ = nullptr;
    QMenu *add_operation_ = nullptr, *add_setup_ = nullptr, *add_fixture_ = nullptr, *add_boundary_ = nullptr;
    QAction* go_to_setup_ = nullptr;
    bool rebuilding_ = false;
};

/// Data of actions of `ProjectTree::tree` that its menu offers for the part.
inline constexpr const char* part_action = "part";

/// What the tree can do, by the names that menus know it by.
std::vector<std::pair<const char*, QAction*>> tree_commands(ProjectTree& tree);

/// "Planned", "Out of date", ...
QString state_text(OperationState state);

} // namespace facetmill::ui
