// The window's actions, menus and tool bar.
#include "ui/main_window.h"

#include "core/mesh/sample.h"
#include "core/output/apt.h"
#include "ui/icons.h"
#include "ui/project_tree.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>
#include <QToolButton>

namespace facetmill::ui {

QAction* MainWindow::add_action(std::optional<Icon> which, const QString& label, const QKeySequence& key,
                                const char* name, const std::function<void()>& run) {
    auto* action = new QAction(label, this);
    if (which) action->setIcon(icon(*which));
    action->setShortcut(key);
    action->setObjectName(QLatin1String(name));
    connect(action, &QAction::triggered, this, run);
    addAction(action);
    QString tip = label;
    tip.remove(QChar('&')).remove(QStringLiteral("…"));
    if (!key.isEmpty()) tip += QStringLiteral(" (%1)").arg(key.toString(QKeySequence::NativeText));
    action->setToolTip(tip);
    return action;
}

void MainWindow::build_actions() {
    new_ = add_action(Icon::new_project, tr("&New"), QKeySequence::New, "new", [this] { close_project(); });
    open_ = add_action(Icon::open, tr("&Open…"), QKeySequence::Open, "open", [this] { open_with_dialog(); });
    save_ = add_action(Icon::save, tr("&Save"), QKeySequence::Save, "save", [this] { save(); });
    save_as_ = add_action({}, tr("Save &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), "save_as",
                          [this] { save_as(); });
    export_ = add_action(Icon::export_program, tr("&Export %1…").arg(text(apt_writer().label)),
                         QKeySequence(Qt::CTRL | Qt::Key_E), "export", [this] { export_with_dialog(); });
    sheet_ = add_action({}, tr("Export set&up sheet…"), {}, "setup_sheet", [this] { sheet_with_dialog(); });
    picture_ =
        add_action(Icon::picture, tr("Export &picture…"), {}, "picture", [this] { picture_with_dialog(); });

    undo_ = document_.undo_stack().createUndoAction(this, tr("&Undo"));
    undo_->setIcon(icon(Icon::undo));
    undo_->setShortcut(QKeySequence::Undo);
    undo_->setObjectName(QStringLiteral("undo"));
    redo_ = document_.undo_stack().createRedoAction(this, tr("&Redo"));
    redo_->setIcon(icon(Icon::redo));
    redo_->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    redo_->setObjectName(QStringLiteral("redo"));

    plan_ = add_action(Icon::plan, tr("&Plan"), {}, "plan", [this] { plan(); });
    plan_->setShortcuts({QKeySequence(Qt::Key_F5), QKeySequence(Qt::CTRL | Qt::Key_P)});
    plan_->setToolTip(tr("Plan all operations (F5)"));
    verify_ =
        add_action(Icon::verify, tr("&Verify"), QKeySequence(Qt::Key_F6), "verify", [this] { verify(); });
    verify_->setToolTip(tr("Cut a model of the stock with all operations and compare it with the part (F6)"));
    cancel_ =
        add_action(Icon::cancel, tr("&Cancel"), QKeySequence(Qt::Key_Escape), "cancel", [this] { cancel(); });

    fit_ = add_action(Icon::fit, tr("&Fit"), QKeySequence(Qt::Key_F), "fit", [this] { viewport_->fit(); });
    view_actions_.push_back(fit_);
    constexpr Icon icons[] = {Icon::view_iso,  Icon::view_front,  Icon::view_top, Icon::view_right,
                              Icon::view_rear, Icon::view_bottom, Icon::view_left};
    // The keys count as the list does: 0 isometric, 1 front, 2 top, 3 right, 4 rear, 5 bottom, 6 left.
    int digit = 0;
    for (const StandardView view : standard_views()) {
        const std::string name = "view_" + std::string(view_name(view));
        view_actions_.push_back(add_action(icons[std::size_t(view)], text(view_label(view)),
                                           QKeySequence(Qt::Key_0 + digit), name.c_str(),
                                           [this, view] { viewport_->set_view(view); }));
        ++digit;
    }
}

void MainWindow::build_menus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->setObjectName(QStringLiteral("file_menu"));
    file->addAction(new_);
    sample_menu_ = file->addMenu(icon(Icon::part), tr("New from sa&mple"));
    sample_menu_->setObjectName(QStringLiteral("sample_menu"));
    sample_menu_->setToolTipsVisible(true);
    for (const SampleKind& kind : sample_kinds()) {
        QAction* a = sample_menu_->addAction(text(kind.label), this,
                                             [this, name = kind.name] { new_from_sample(name); });
        a->setObjectName(QStringLiteral("sample_") + text(kind.name));
        a->setToolTip(text(kind.help));
    }
    file->addAction(open_);
    recent_menu_ = file->addMenu(tr("Open &recent"));
    recent_menu_->setToolTipsVisible(true);
    connect(recent_menu_, &QMenu::aboutToShow, this, &MainWindow::fill_recent_menu);
    fill_recent_menu();
    file->addSeparator();
    file->addAction(save_);
    file->addAction(save_as_);
    file->addSeparator();
    file->addAction(export_);
    file->addAction(sheet_);
    file->addAction(picture_);
    file->addSeparator();
    file->addAction(add_action({}, tr("&Quit"), QKeySequence::Quit, "quit", [this] { close(); }));

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addAction(undo_);
    edit->addAction(redo_);
    edit->addSeparator();
    edit->addMenu(tree_->add_operation_menu());
    edit->addAction(tree_->add_tool_action());
    edit->addAction(tree_->edit_action());
    edit->addAction(tree_->duplicate_action());
    edit->addAction(tree_->remove_action());
    edit->addAction(tree_->up_action());
    edit->addAction(tree_->down_action());
    edit->addSeparator();
    QMenu* units = edit->addMenu(tr("&Unit"));
    auto* unit_group = new QActionGroup(this);
    for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
        QAction* a = units->addAction(unit == LengthUnit::mm ? tr("&Millimetres") : tr("&Inches"), this,
                                      [this, unit] { set_unit(unit); });
        a->setCheckable(true);
        unit_group->addAction(a);
        unit_actions_.push_back(a);
    }

    view_menu_ = menuBar()->addMenu(tr("&View"));
    view_menu_->addActions(QList<QAction*>(view_actions_.begin(), view_actions_.end()));
    view_menu_->addSeparator();
    QMenu* shading = view_menu_->addMenu(tr("Part &shading"));
    auto* shading_group = new QActionGroup(this);
    for (const auto& [style, label, name] : {std::tuple{PartStyle::smooth, tr("&Smooth"), "shade_smooth"},
                                             std::tuple{PartStyle::flat, tr("&Flat"), "shade_flat"},
                                             std::tuple{PartStyle::wire, tr("&Wire"), "shade_wire"}}) {
        QAction* a = shading->addAction(label, this, [this, s = style] {
            viewport_->scene().set_part_style(s);
            viewport_->refresh();
        });
        a->setObjectName(QLatin1String(name));
        a->setCheckable(true);
        a->setChecked(style == PartStyle::smooth);
        shading_group->addAction(a);
    }
    QMenu* theme = view_menu_->addMenu(tr("&Colours"));
    auto* theme_group = new QActionGroup(this);
    for (const auto& [value, label] :
         {std::pair{Theme::system, tr("As the &system")}, std::pair{Theme::light, tr("&Light")},
          std::pair{Theme::dark, tr("&Dark")}}) {
        QAction* a = theme->addAction(label, this, [this, v = value] {
            settings::set_theme(v);
            set_theme(v);
        });
        a->setObjectName(QStringLiteral("theme_") + theme_name(value));
        a->setCheckable(true);
        theme_group->addAction(a);
        theme_actions_.push_back(a);
    }
    view_menu_->addSeparator();
    for (QDockWidget* dock : {project_dock_, properties_dock_, report_dock_, verification_dock_, cspace_dock_,
                              unrolled_dock_, strips_dock_, chart_dock_, log_dock_})
        view_menu_->addAction(dock->toggleViewAction());

    QMenu* plan = menuBar()->addMenu(tr("&Plan"));
    plan->addAction(plan_);
    plan->addAction(verify_);
    plan->addAction(cancel_);
    plan->addSeparator();
    plan->addAction(export_);

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addAction(add_action({}, tr("&Keys and mouse"), QKeySequence(Qt::Key_F1), "keys",
                               [this] { show_shortcuts(); }));
    help->addAction(add_action({}, tr("&About Facetmill"), {}, "about", [this] { show_about(); }));

    auto* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tool_bar"));
    bar->setIconSize(QSize(20, 20));
    bar->setMovable(false);
    bar->addAction(open_);
    bar->addAction(save_);
    bar->addSeparator();
    bar->addAction(undo_);
    bar->addAction(redo_);
    bar->addSeparator();
    for (QAction* a : {plan_, verify_}) {
        bar->addAction(a);
        static_cast<QToolButton*>(bar->widgetForAction(a))->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
    bar->addAction(cancel_);
    bar->addAction(export_);
    bar->addSeparator();
    for (QAction* a : view_actions_)
        bar->addAction(a);
    view_menu_->addAction(bar->toggleViewAction());
}

void MainWindow::fill_recent_menu() {
    recent_menu_->clear();
    for (const QString& path : settings::recent_files()) {
        QAction* a = recent_menu_->addAction(elided(QFileInfo(path).fileName(), 50), this,
                                             [this, path] { open_file(path); });
        a->setToolTip(path);
    }
    recent_menu_->setEnabled(!recent_menu_->isEmpty());
}

void MainWindow::show_shortcuts() {
    QString rows;
    const auto row = [&](const QString& key, const QString& what) {
        rows += QStringLiteral("<tr><td style=\"padding:2px 18px 2px 0; white-space:nowrap\"><b>%1</b></td>"
                               "<td style=\"padding:2px 0; white-space:nowrap\">%2</td></tr>")
                    .arg(key, what);
    };
    row(tr("Left drag"), tr("turn the view about the point under the pointer"));
    row(tr("Middle drag, Shift + left drag"), tr("move the view"));
    row(tr("Wheel, right drag"), tr("zoom about the pointer"));
    row(tr("Double click, F"), tr("fit"));
    row(tr("Click on a path"), tr("show the tool there; ← and → step along the path (Shift: by ten)"));
    row(tr("← →  ↑ ↓"), tr("with the configuration space in view: points along the pass, passes"));
    row(tr("In a chart or the unrolled path"),
        tr("click or drag: the tool there; wheel: zoom; right drag: move; Home: all"));
    row(tr("0 … 6"), tr("isometric, front, top, right, rear, bottom, left"));
    row(tr("F5, Ctrl+P"), tr("plan"));
    row(tr("F6"), tr("verify"));
    row(tr("Space"), tr("play, pause"));
    row(tr(",  ."), tr("one motion back, on (← and → too while playing back; Shift: ten)"));
    row(tr("Esc"), tr("cancel the running job"));
    row(tr("Ctrl+E"), tr("export %1 programs and the report").arg(text(apt_writer().label)));
    row(tr("Ctrl+Z, Ctrl+Shift+Z"), tr("undo, redo"));
    row(tr("Enter, F2"), tr("edit the selected tool or the parameters of the selection"));
    row(tr("Del"), tr("remove the selected tool or operation"));
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Keys and mouse"),
                                QStringLiteral("<table cellspacing=\"0\">%1</table>").arg(rows),
                                QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::show_about() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Facetmill"),
                                tr("<h3>Facetmill %1</h3><p>Plans tool paths on triangle meshes.</p>"
                                   "<p>Built with Qt %2, VTK, Eigen, OpenMesh and oneTBB.<br>Licensed under "
                                   "the Apache License 2.0.</p>")
                                    .arg(QCoreApplication::applicationVersion(), QLatin1String(qVersion())),
                                QMessageBox::Close, this);
    box->setIconPixmap(application_icon().pixmap(64, 64));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace facetmill::ui
