#include "ui/window_commands.h"

#include "core/base/parallel.h"
#include "core/output/apt.h"
#include "ui/all_setups.h"
#include "ui/autosave.h"
#include "ui/command.h"
#include "ui/controllers.h"
#include "ui/first_steps.h"
#include "ui/help.h"
#include "ui/help_dialogs.h"
#include "ui/inputs_controller.h"
#include "ui/main_window.h"
#include "ui/measure_controller.h"
#include "ui/mesh_export.h"
#include "ui/plan_runner.h"
#include "ui/preferences_dialog.h"
#include "ui/program_export.h"
#include "ui/project_files.h"
#include "ui/project_saving.h"
#include "ui/properties_panel.h"
#include "ui/scan_controller.h"
#include "ui/settings.h"
#include "ui/start_hint.h"
#include "ui/study_controller.h"
#include "ui/suggest_controller.h"
#include "ui/templates.h"
#include "ui/text.h"
#include "ui/undo_keys.h"
#include "ui/viewport.h"
#include "ui/worded.h"
#include "ui/workspaces.h"

#include <QAction>
#include <QToolButton>

#include <tuple>

namespace facetmill::ui {

namespace {

void add_mesh_commands(Commands& commands, MainWindow& w) {
    MeshExport& meshes = w.exports().meshes();
    const auto add = [&](const QString& name, const QString& title, MeshExport::What what,
                         const QString& tip) {
        commands.add({name,
                      title,
                      {},
                      {},
                      [&meshes, what] { meshes.with_dialog(what); },
                      [&w, &meshes, what] { return !w.job().running() && meshes.has(what); },
                      {},
                      tip});
    };
    add("export_part", tr("&Part…"), MeshExport::What::part, tr("The part as it lies, as STL, 3MF or PLY"));
    add("export_stock", tr("&Stock…"), MeshExport::What::stock,
        tr("What all operations leave of the stock, as STL, 3MF or PLY"));
    add("export_deviation", tr("&Deviation…"), MeshExport::What::deviation,
        tr("The surface of the verdict with its deviations: as figures in PLY, as colours in 3MF and STL"));
}

void add_file_commands(Commands& commands, MainWindow& w) {
    const auto has_part = [&w] { return w.document().has_part(); };
    const auto idle = [&w] { return w.document().has_part() && !w.job().running(); };
    const auto can_export = [&w, idle] { return idle() && !w.document().program(); };
    ProjectFiles& files = w.files();
    ProgramExport& exports = w.exports();
    commands.add({"new",
                  tr("&New"),
                  Icon::new_project,
                  {QKeySequence(QKeySequence::New)},
                  [&] { files.close_project(); },
                  has_part});
    commands.add({"open", tr("&Open…"), Icon::open, {QKeySequence(QKeySequence::Open)}, [&] {
                      files.open_with_dialog();
                  }});
    commands.add({"open_program",
                  tr("Open pro&gram…"),
                  {},
                  {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)},
                  [&] { files.open_program_with_dialog(); },
                  idle,
                  {},
                  tr("Show, play back and verify an existing program (%1) without planning")
                      .arg(worded(apt_writer().label))});
    commands.add({"close_program",
                  tr("&Close program"),
                  {},
                  {},
                  [&w] { w.document().show_program(nullptr); },
                  [&w] { return w.document().program() != nullptr && !w.job().running(); }});
    commands.add({"save",
                  tr("&Save"),
                  Icon::save,
                  {QKeySequence(QKeySequence::Save)},
                  [&] { files.saving().save(); },
                  has_part});
    commands.add({"save_as",
                  tr("Save &as…"),
                  {},
                  {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)},
                  [&] { files.saving().save_as(); },
                  has_part});
    commands.add({"save_packed",
                  tr("Save pac&ked copy…"),
                  {},
                  {},
                  [&] { files.save_packed_with_dialog(); },
                  idle,
                  {},
                  tr("Write the project with its meshes, machines and posts into one file, to be sent")});
    commands.add({"save_template",
                  tr("Sa&ve as template…"),
                  {},
                  {},
                  [&w] { w.templates().save_with_dialog(); },
                  has_part,
                  {},
                  tr("Keep operations, tools and settings of this setup for other parts")});
    InputsController& inputs = w.controllers().inputs();
    commands.add({"replace_part",
                  tr("Re&place part…"),
                  {},
                  {},
                  [&] { inputs.replace_part_with_dialog(); },
                  idle,
                  {},
                  tr("Make another mesh the part; operations, tools and the rest stay as they are")});
    commands.add({"locate",
                  tr("&Locate missing file…"),
                  {},
                  {},
                  [&] { inputs.locate_with_dialog(); },
                  [&] { return !inputs.missing().empty(); },
                  {},
                  tr("Say where a file is that the project names and that is not there")});
    commands.add({"export",
                  tr("&Export programs…"),
                  Icon::export_program,
                  {QKeySequence(Qt::CTRL | Qt::Key_E)},
                  [&] { exports.programs_with_dialog(); },
                  can_export});
    commands.add({"setup_sheet",
                  tr("Export set&up sheet…"),
                  {},
                  {},
                  [&] { exports.sheet_with_dialog(); },
                  can_export});
    commands.add({"picture",
                  tr("Export p&icture…"),
                  Icon::picture,
                  {},
                  [&] { exports.picture_with_dialog(); },
                  has_part});
    add_mesh_commands(commands, w);
    commands.add({"quit", tr("&Quit"), {}, {QKeySequence(QKeySequence::Quit)}, [&w] { w.close(); }});
}

void add_plan_commands(Commands& commands, MainWindow& w) {
    commands.add({"place",
                  tr("P&lace part…"),
                  Icon::place,
                  {QKeySequence(Qt::Key_P)},
                  [&w] { w.show_place(); },
                  [&w] { return w.document().has_part(); },
                  {},
                  tr("Lay the part on a face, turn, move or mirror it (P)")});
    commands.add({"scan_room",
                  tr("&Scan room…"),
                  {},
                  {QKeySequence(Qt::Key_R)},
                  [&w] { w.controllers().scan().open(); },
                  [&w] { return w.document().has_part(); },
                  {},
                  tr("Mend the part's mesh: loose pieces, holes, noise, facets (R)")});
    const auto can_plan = [&w] { return w.planning().can_plan(); };
    commands.add({"plan",
                  tr("&Plan"),
                  Icon::plan,
                  {QKeySequence(Qt::Key_F5), QKeySequence(Qt::CTRL | Qt::Key_P)},
                  [&w] { w.plan(); },
                  can_plan,
                  {},
                  tr("Plan all operations (F5)")});
    commands.add({"verify",
                  tr("&Verify"),
                  Icon::verify,
                  {QKeySequence(Qt::Key_F6)},
                  [&w] { w.verify(); },
                  [&w, can_plan] { return can_plan() || (w.document().program() && !w.job().running()); },
                  {},
                  tr("Cut a model of the stock with all operations and compare it with the part (F6)")});
    const auto can_plan_all = [&w] { return w.planning().all_setups().can_plan(); };
    commands.add({"plan_all",
                  tr("Plan all &setups"),
                  {},
                  {QKeySequence(Qt::SHIFT | Qt::Key_F5)},
                  [&w] { w.planning().all_setups().plan(); },
                  can_plan_all,
                  {},
                  tr("Plan every setup, each on the stock that those before it leave (Shift+F5)")});
    commands.add({"verify_all",
                  tr("Verify all se&tups"),
                  {},
                  {QKeySequence(Qt::SHIFT | Qt::Key_F6)},
                  [&w] { w.planning().all_setups().verify(); },
                  can_plan_all,
                  {},
                  tr("Plan what is not planned yet, and judge all setups as one job (Shift+F6)")});
    commands.add({"suggest",
                  tr("S&uggest an operation…"),
                  {},
                  {QKeySequence(Qt::Key_G)},
                  [&w] { w.controllers().suggest().open(); },
                  [&w] { return w.document().has_part(); },
                  {},
                  tr("Plan and judge finishing operations of all kinds, and suggest the three best (G)")});
    commands.add({"study",
                  tr("Stud&y…"),
                  {},
                  {QKeySequence(Qt::Key_S)},
                  [&w] { w.controllers().study().open(); },
                  {},
                  {},
                  tr("Find out which tools and settings serve best: many are planned and verified (S)")});
    QObject::connect(&w.controllers().study(), &StudyController::save_wanted, &w.files(),
                     [&w] { w.files().saving().save(); });
    commands.add({"cancel",
                  tr("&Cancel"),
                  Icon::cancel,
                  {QKeySequence(Qt::Key_Escape)},
                  [&w] { w.cancel(); },
                  [&w] { return w.job().running() && !w.job().cancelling(); }});
}

void add_workspace_commands(Commands& commands, MainWindow& w) {
    for (std::size_t i = 0; i < workspace_count; ++i) {
        const auto workspace = Workspace(i);
        commands.add({QStringLiteral("see_") + QLatin1String(workspace_name(workspace)),
                      workspace_label(workspace),
                      {},
                      {QKeySequence(Qt::Key_F7 + int(i))},
                      [&w, workspace] { w.workspaces().button(workspace)->click(); },
                      {},
                      [&w, workspace] { return w.workspaces().current() == workspace; },
                      workspace_help(workspace)});
    }
}

void add_view_commands(Commands& commands, MainWindow& w) {
    const auto has_part = [&w] { return w.document().has_part(); };
    Viewport& viewport = w.viewport();
    commands.add(
        {"fit", tr("&Fit"), Icon::fit, {QKeySequence(Qt::Key_F)}, [&] { viewport.fit(); }, has_part});
    constexpr Icon icons[] = {Icon::view_iso,  Icon::view_front,  Icon::view_top, Icon::view_right,
                              Icon::view_rear, Icon::view_bottom, Icon::view_left};
    // The keys count as the list does: 0 isometric, 1 front, 2 top, 3 right, 4 rear, 5 bottom, 6 left.
    int digit = 0;
    for (const StandardView view : standard_views())
        commands.add({"view_" + text(view_name(view)),
                      worded(view_label(view)),
                      icons[std::size_t(view)],
                      {QKeySequence(Qt::Key_0 + digit++)},
                      [&, view] { viewport.set_view(view); },
                      has_part});
    commands.add({"perspective",
                  tr("Pe&rspective"),
                  {},
                  {QKeySequence(Qt::SHIFT | Qt::Key_P)},
                  [&] {
                      settings::set_perspective(!settings::perspective());
                      viewport.set_perspective(settings::perspective());
                  },
                  {},
                  [] { return settings::perspective(); },
                  tr("What is nearer is larger; there is no scale bar then (Shift+P)")});
    for (const auto& [style, label, name] : {std::tuple{PartStyle::smooth, tr("&Smooth"), "shade_smooth"},
                                             std::tuple{PartStyle::flat, tr("&Flat"), "shade_flat"},
                                             std::tuple{PartStyle::wire, tr("&Wire"), "shade_wire"}})
        commands.add({name,
                      label,
                      {},
                      {},
                      [&, s = style] {
                          viewport.scene().part().set_style(s);
                          viewport.refresh();
                      },
                      {},
                      [&, s = style] { return viewport.scene().part().style() == s; }});
}

void add_setting_commands(Commands& commands, MainWindow& w) {
    for (const auto& [unit, label, name] : {std::tuple{LengthUnit::mm, tr("&Millimetres"), "unit_mm"},
                                            std::tuple{LengthUnit::inch, tr("&Inches"), "unit_inch"}})
        commands.add({name,
                      label,
                      {},
                      {},
                      [&w, u = unit] { set_unit(w, u); },
                      [&w] { return w.document().has_part(); },
                      [&w, u = unit] { return w.document().unit() == u; }});
    for (const auto& [theme, label] :
         {std::pair{Theme::system, tr("As the &system")}, std::pair{Theme::light, tr("&Light")},
          std::pair{Theme::dark, tr("&Dark")}})
        commands.add({QStringLiteral("theme_") + theme_name(theme),
                      label,
                      {},
                      {},
                      [&w, t = theme] {
                          settings::set_theme(t);
                          w.set_theme(t);
                      },
                      {},
                      [&w, t = theme] { return w.theme() == t; }});
    commands.add({"measure",
                  tr("&Measure"),
                  {},
                  {QKeySequence(Qt::Key_M)},
                  [&w] { w.controllers().measure().set_active(!w.controllers().measure().active()); },
                  [&w] { return w.document().part() != nullptr; },
                  [&w] { return w.controllers().measure().active(); },
                  tr("Distance and angle between two points of the part (M)")});
    commands.add({"preferences",
                  tr("Pre&ferences…"),
                  {},
                  {QKeySequence(Qt::CTRL | Qt::Key_Comma)},
                  [&w] {
                      auto* dialog = new PreferencesDialog(&w);
                      dialog->setAttribute(Qt::WA_DeleteOnClose);
                      QObject::connect(dialog, &QDialog::accepted, &w, [&w] { take_preferences(w); });
                      dialog->open();
                  },
                  {},
                  {},
                  tr("Mouse, colours, machine of new projects, threads (Ctrl+,)")});
}

/// Undo and redo follow the document's history by themselves.
void add_history(Commands& commands, MainWindow& w) {
    QAction* undo = w.document().undo_stack().createUndoAction(&w, tr("&Undo"));
    undo->setIcon(icon(Icon::undo));
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = w.document().undo_stack().createRedoAction(&w, tr("&Redo"));
    redo->setIcon(icon(Icon::redo));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    new UndoKeys(&w);
    for (const auto& [name, action] : {std::pair{"undo", undo}, std::pair{"redo", redo}}) {
        action->setObjectName(QLatin1String(name));
        commands.adopt(name, action);
    }
}

} // namespace

void add_commands(Commands& commands, MainWindow& window) {
    add_file_commands(commands, window);
    add_history(commands, window);
    add_plan_commands(commands, window);
    add_workspace_commands(commands, window);
    add_view_commands(commands, window);
    add_setting_commands(commands, window);
    auto* help = new Help(&window);
    commands.add({"manual",
                  tr("&Manual"),
                  {},
                  {QKeySequence(Qt::Key_F1)},
                  [help] { help->open_here(); },
                  {},
                  {},
                  tr("The manual at the place of what has the keys (F1)")});
    commands.add({"first_job", tr("&First job, step by step"), {}, {}, [help] {
                      help->open(QStringLiteral("first_job.html"));
                  }});
    auto* steps = new FirstSteps(window);
    commands.add({"first_steps",
                  tr("Show the &steps of a first job"),
                  {},
                  {},
                  [steps] { steps->isVisible() ? steps->hide() : steps->start(); },
                  {},
                  [steps] { return steps->isVisible(); },
                  tr("Above the view: what comes next, ticked off as it is done")});
    commands.add({"keys", tr("&Keys and mouse"), {}, {QKeySequence(Qt::SHIFT | Qt::Key_F1)}, [&window] {
                      show_shortcuts(&window);
                  }});
    commands.add({"about", tr("&About Facetmill"), {}, {}, [&window] { show_about(&window); }});
}

void take_preferences(MainWindow& w) {
    w.set_theme(settings::theme());
    w.viewport().set_navigation(settings::navigation());
    w.viewport().set_perspective(settings::perspective());
    w.files().autosave().set_interval(settings::autosave_interval());
    set_thread_count(settings::threads());
    w.start_page().show_usual();
}

void set_unit(MainWindow& w, LengthUnit unit) {
    if (!w.document().has_part() || unit == w.document().unit()) return;
    if (!w.properties().commit()) {
        w.update_commands(); // the box goes back
        w.messages().warning(tr("A parameter is not valid: correct it before the unit is changed."));
        return;
    }
    w.document().change(tr("Change unit"), [unit](Project& p) { p.unit = unit; });
}

} // namespace facetmill::ui
