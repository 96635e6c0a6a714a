#include "ui/window_menus.h"

#include "core/mesh/sample.h"
#include "ui/command.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/window_docks.h"
#include "ui/worded.h"
#include "viz/scene.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace facetmill::ui {

namespace {

/// A name as a command has it; "-" is a line between entries.
using Entries = QStringList;

struct MenuTable {
    QString name;
    QString title;
    Entries entries;
};

Entries views() {
    Entries names{"fit"};
    for (const StandardView view : standard_views())
        names << "view_" + text(view_name(view));
    return names;
}

/// Menus inside others; their own names are entries there.
std::vector<MenuTable> submenus() {
    return {{"mesh_menu", tr("Export mes&h"), {"export_part", "export_stock", "export_deviation"}},
            {"unit_menu", tr("Un&it"), {"unit_mm", "unit_inch"}},
            {"shading_menu", tr("Part &shading"), {"shade_smooth", "shade_flat", "shade_wire"}},
            {"colour_menu", tr("&Colours"), {"theme_system", "theme_light", "theme_dark"}}};
}

std::vector<MenuTable> menus() {
    return {
        {"file_menu",
         tr("&File"),
         {"new",
          "samples",
          "open",
          "recent",
          "open_program",
          "close_program",
          "-",
          "save",
          "save_as",
          "save_packed",
          "-",
          "apply_template",
          "save_template",
          "-",
          "replace_part",
          "locate",
          "-",
          "export",
          "setup_sheet",
          "picture",
          "mesh_menu",
          "-",
          "quit"}},
        {"edit_menu",
         tr("&Edit"),
         {"undo",
          "redo",
          "-",
          "place",
          "scan_room",
          "-",
          "add_operation",
          "add_tool",
          "tool_library",
          "add_fixture",
          "add_boundary",
          "add_setup",
          "go_to_setup",
          "edit",
          "rename",
          "switch_off",
          "copy_operation",
          "paste_operation",
          "duplicate",
          "remove",
          "up",
          "down",
          "-",
          "unit_menu",
          "preferences"}},
        {"view_menu", tr("&View"),
         Entries{"see_prepare", "see_plan", "see_verify", "see_simulate", "-"} + views()
             + Entries{"perspective", "measure", "-", "shading_menu", "colour_menu", "-", "project_dock",
                       "properties_dock", "report_dock", "verification_dock", "cspace_dock", "unrolled_dock",
                       "strips_dock", "place_dock", "scan_dock", "chart_dock", "log_dock", "tool_bar"}},
        {"plan_menu",
         tr("&Plan"),
         {"plan", "verify", "-", "plan_all", "verify_all", "-", "suggest", "study", "-", "cancel", "-",
          "export"}},
        {"help_menu", tr("&Help"), {"manual", "first_job", "first_steps", "keys", "about"}}};
}

Entries tools() {
    return Entries{"open",  "save", "-",      "undo",   "redo",   "-",
                   "place", "plan", "verify", "cancel", "export", "-"}
           + views();
}

void fill(QWidget* menu, const Entries& entries, const Commands& commands) {
    for (const QString& name : entries) {
        if (name == QChar('-')) {
            auto* line = new QAction(menu);
            line->setSeparator(true);
            menu->addAction(line);
        } else {
            menu->addAction(commands.action(name));
        }
    }
}

/// One of the entries is checked.
void exclude_each_other(QMenu* menu) {
    auto* group = new QActionGroup(menu);
    for (QAction* action : menu->actions())
        group->addAction(action);
}

} // namespace

QMenu* make_sample_menu(QMainWindow* window, const std::function<void(const std::string&)>& take) {
    auto* menu = new QMenu(tr("New from sa&mple"), window);
    menu->setIcon(icon(Icon::part));
    menu->setObjectName(QStringLiteral("sample_menu"));
    menu->setToolTipsVisible(true);
    for (const SampleKind& kind : sample_kinds()) {
        QAction* a = menu->addAction(worded(kind.label), window, [take, name = kind.name] { take(name); });
        a->setObjectName(QStringLiteral("sample_") + text(kind.name));
        a->setToolTip(worded(kind.help));
    }
    return menu;
}

QMenu* make_recent_menu(QMainWindow* window, const std::function<void(const QString&)>& open) {
    auto* menu = new QMenu(tr("Open &recent"), window);
    menu->setToolTipsVisible(true);
    const auto refill = [window, menu, open] {
        menu->clear();
        for (const QString& path : settings::recent_files()) {
            QAction* a =
                menu->addAction(elided(QFileInfo(path).fileName(), 50), window, [open, path] { open(path); });
            a->setToolTip(path);
        }
        menu->setEnabled(!menu->isEmpty());
    };
    QObject::connect(menu, &QMenu::aboutToShow, menu, refill);
    refill();
    return menu;
}

void build_menus(QMainWindow* window, Commands& commands, const WindowDocks& docks) {
    auto* bar = new QToolBar(tr("Tools"), window);
    bar->setObjectName(QStringLiteral("tool_bar"));
    bar->setIconSize(QSize(20, 20));
    bar->setMovable(false);
    commands.adopt("tool_bar", bar->toggleViewAction());
    for (const QDockWidget* dock : docks.all())
        commands.adopt(dock->objectName(), dock->toggleViewAction());
    for (const MenuTable& table : submenus()) {
        auto* menu = new QMenu(table.title, window);
        menu->setObjectName(table.name);
        fill(menu, table.entries, commands);
        exclude_each_other(menu);
        commands.adopt(table.name, menu->menuAction());
    }
    for (const MenuTable& table : menus()) {
        QMenu* menu = window->menuBar()->addMenu(table.title);
        menu->setObjectName(table.name);
        fill(menu, table.entries, commands);
        commands.adopt(table.name, menu->menuAction());
    }
    window->addToolBar(bar);
    fill(bar, tools(), commands);
    // What is used most says what it is.
    for (const char* name : {"plan", "verify"})
        if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(commands.action(name))))
            button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
}

} // namespace facetmill::ui
