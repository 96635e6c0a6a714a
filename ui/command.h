// Commands of the workbench. A command knows what it is called, its icon, its keys, when it is enabled and
// what it does; menus, the tool bar and keys all use its one action.
#pragma once

#include "ui/icons.h"

#include <QKeySequence>
#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class QAction;
class QWidget;

namespace facetmill::ui {

struct CommandSpec {
    QString name; ///< object name of the action; menus name their entries by it
    QString text;
    std::optional<Icon> icon;
    QList<QKeySequence> keys;
    std::function<void()> execute;
    std::function<bool()> enabled = {}; ///< empty: always
    std::function<bool()> checked = {}; ///< empty: it has no check mark
    QString tip = {};                   ///< empty: the text and the first key
};

class Command : public QObject {
    Q_OBJECT
public:
    Command(CommandSpec spec, QWidget* window);

    QAction* action() const { return action_; }
    bool is_enabled() const { return !spec_.enabled || spec_.enabled(); }
    void execute();
    /// Brings the action up to date with what the command says of itself.
    void refresh();

private:
    CommandSpec spec_;
    QAction* action_ = nullptr;
};

/// All commands of a window, and actions that others keep up to date, by name.
class Commands {
public:
    explicit Commands(QWidget* window) : window_(window) {}

    void add(CommandSpec spec);
    /// Takes up an action that somebody else enables: an entry of another panel, a menu.
    void adopt(const QString& name, QAction* action);
    /// The action of this name. A name that is not known is a mistake in a table: it ends the program.
    QAction* action(const QString& name) const;
    void refresh();

private:
    QWidget* window_;
    std::vector<std::unique_ptr<Command>> commands_;
    std::map<QString, QAction*> actions_;
};

} // namespace facetmill::ui
