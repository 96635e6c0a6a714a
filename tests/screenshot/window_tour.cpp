#include "tests/screenshot/window_tour.h"

#include "core/mesh/mesh_report.h"
#include "core/strategy/plan/operation.h"
#include "ui/axis_dialog.h"
#include "ui/controllers.h"
#include "ui/export_dialog.h"
#include "ui/part_dialog.h"
#include "ui/preferences_dialog.h"
#include "ui/project_tree.h"
#include "ui/region_dialog.h"
#include "ui/study_controller.h"
#include "ui/suggest_dialog.h"
#include "ui/text.h"
#include "ui/tool_dialog.h"
#include "ui/tool_library_dialog.h"
#include "ui/unpack_dialog.h"
#include "ui/workspaces.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QPointer>
#include <QRegularExpression>
#include <QTabBar>
#include <QTest>

namespace facetmill::test {

namespace {

using ui::TreeNode;
using ui::Workspace;

void rest() {
    QTest::qWait(15);
}

} // namespace

void tour_window(ui::MainWindow& window, const Look& look) {
    using Kind = TreeNode::Kind;
    const auto seen = [&](const QString& page) {
        rest();
        look(window, page);
    };
    for (const auto& [kind, name] : {std::pair(Kind::part, "part"),
                                     {Kind::stock, "stock"},
                                     {Kind::machine, "machine"},
                                     {Kind::tool, "tool"}}) {
        window.tree().select({kind, 0});
        seen(QStringLiteral("node %1").arg(QLatin1String(name)));
    }
    for (const OperationKind& kind : operation_kinds()) {
        const std::size_t at = window.document().add_operation(kind.kind);
        window.tree().select({Kind::operation, at});
        seen(QStringLiteral("operation %1").arg(ui::text(kind.kind)));
        window.document().undo_stack().undo();
    }
    for (QAction* fixture : window.tree().add_fixture_menu()->actions().mid(0, 3)) {
        const int steps = window.document().undo_stack().index();
        fixture->trigger();
        seen(QStringLiteral("fixture %1").arg(fixture->text()));
        while (window.document().undo_stack().index() > steps)
            window.document().undo_stack().undo();
        (void)wait_until_settled(window); // nothing can be added until the part is read with what there is
    }
    for (QAction* boundary : window.tree().add_boundary_menu()->actions()) {
        const int steps = window.document().undo_stack().index();
        boundary->trigger();
        seen(QStringLiteral("boundary %1").arg(boundary->text()));
        while (window.document().undo_stack().index() > steps)
            window.document().undo_stack().undo();
        (void)wait_until_settled(window); // nothing can be added until the part is read with what there is
    }
    window.tree().select({Kind::operation, 0});
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        const bool hidden = dock->isHidden();
        if (hidden)
            dock->toggleViewAction()->trigger();
        else
            dock->raise();
        seen(dock->objectName());
        if (hidden) dock->toggleViewAction()->trigger();
    }
    for (const Workspace workspace :
         {Workspace::prepare, Workspace::plan, Workspace::verify, Workspace::simulate}) {
        window.workspaces().enter(workspace);
        seen(ui::workspace_label(workspace));
    }
    window.workspaces().enter(Workspace::plan);
}

QSet<QString> tour_dialogs(ui::MainWindow& window, const Look& look) {
    QSet<QString> classes;
    const auto visit = [&](QDialog* dialog) {
        dialog->show();
        rest();
        const QString name =
            QString::fromLatin1(dialog->metaObject()->className()).section(QStringLiteral("::"), -1);
        classes << name;
        QTabBar* tabs = dialog->findChild<QTabBar*>();
        for (int i = 0; i < (tabs ? tabs->count() : 1); ++i) {
            if (tabs) tabs->setCurrentIndex(i);
            rest();
            look(*dialog, tabs ? name + QChar(' ') + tabs->tabText(i) : name);
        }
        dialog->close();
        rest();
    };
    const auto visit_all = [&] {
        QList<QPointer<QDialog>> open;
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* dialog = qobject_cast<QDialog*>(top); dialog && dialog->isVisible()) open << dialog;
        for (const auto& dialog : open)
            if (dialog) visit(dialog);
    };
    for (QAction* a : {action(window, "preferences"), window.tree().tool_library_action(),
                       action(window, "keys"), action(window, "about")}) {
        a->trigger();
        rest();
        visit_all();
    }
    for (const std::optional<std::size_t> tool :
         {std::optional<std::size_t>(), std::optional<std::size_t>(0)}) {
        ui::ToolDialog::open_for(window.document(), tool, &window);
        rest();
        visit_all();
    }
    const QString folder = scratch_folder(QStringLiteral("tour"));
    ui::AxisDialog axis(QStringLiteral("Finish"), Vec3(0.3, 0.2, 0.9), &window);
    visit(&axis);
    MeshReport report;
    report.format = "STL binary";
    report.facets = 12;
    report.file_box.add(Vec3(0, 0, 0));
    report.file_box.add(Vec3(100, 60, 20));
    ui::PartDialog part(QStringLiteral("a part with quite a long name.stl"), report, LengthUnit::mm, &window);
    visit(&part);
    ui::ExportDialog programs(folder, {QStringLiteral("1-Rough.nc"), QStringLiteral("report.json")},
                              {QStringLiteral(".nc")}, &window);
    visit(&programs);
    ui::UnpackDialog unpack(ui::path_of(folder + QStringLiteral("/sent.facetmill")), &window);
    visit(&unpack);
    ui::RegionDialog regions(&window);
    const auto operation = make_operation("global_local");
    regions.show_settings(*operation, LengthUnit::inch, {{QStringLiteral("1 Ball"), ParameterValue(1L)}});
    regions.show_no_regions(QStringLiteral("Plan first."));
    visit(&regions);
    ui::SuggestDialog suggest(&window);
    suggest.show_status(QStringLiteral("-"));
    suggest.show_cards({{{}, QStringLiteral("Waterline"), QStringLiteral("4 min"), {QStringLiteral("-")}}});
    visit(&suggest);
    window.controllers().study().open();
    visit(window.controllers().study().dialog());
    return classes;
}

QSet<QString> dialog_classes() {
    QSet<QString> classes;
    const QDir ui(QStringLiteral(FACETMILL_TEST_DATA "/../ui"));
    static const QRegularExpression pattern(QStringLiteral("class (\\w+) : public (QDialog|FolderDialog)"));
    for (const QString& name : ui.entryList({QStringLiteral("*.h")})) {
        QFile file(ui.filePath(name));
        if (!file.open(QIODevice::ReadOnly)) continue;
        for (auto it = pattern.globalMatch(QString::fromUtf8(file.readAll())); it.hasNext();)
            classes << it.next().captured(1);
    }
    classes.remove(QStringLiteral("FolderDialog")); // what two of them have in common
    return classes;
}

} // namespace facetmill::test
