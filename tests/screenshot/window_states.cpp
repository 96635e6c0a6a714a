#include "tests/screenshot/window_states.h"

#include "core/mesh/mesh_io.h"
#include "tests/support/part_meshes.h"
#include "ui/help.h"
#include "ui/help_window.h"
#include "ui/project_tree.h"
#include "ui/viewport.h"
#include "ui/workspaces.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <cmath>

namespace facetmill::test {

namespace {

using ui::TreeNode;
using ui::Workspace;

constexpr const char* name_of_many_words =
    "Second finish with a name as long as nobody should give, but somebody does";

/// A sheet of hills with two holes, a loose piece, and facets that face the wrong side.
Mesh torn_sheet() {
    Mesh mesh =
        only(height_field([](double x, double y) { return 3 + 2 * std::sin(x / 5) * std::cos(y / 6); },
                          Vec2(0, 0), Vec2(40, 30), 40, 30),
             [](const Vec3& p) {
                 return (p.head<2>() - Vec2(10, 9)).norm() > 3 && (p.head<2>() - Vec2(27, 20)).norm() > 2;
             });
    for (std::size_t f : {std::size_t(300), std::size_t(301), std::size_t(700)})
        std::swap(mesh.facets[f][1], mesh.facets[f][2]);
    append_mesh(mesh, box(Vec3(44, 3, 0), Vec3(46, 5, 2)));
    return mesh;
}

class StateTour {
public:
    StateTour(ui::MainWindow& window, const Look& look) : window_(window), look_(look) {}

    void empty() {
        seen(QStringLiteral("empty"));
        for (const QAction* top : window_.menuBar()->actions()) {
            QMenu* menu = top->menu();
            menu->popup(window_.mapToGlobal(QPoint(20, 40)));
            QTest::qWait(20);
            look_(*menu, QStringLiteral("menu ") + QString(top->text()).remove(QChar('&')));
            menu->close();
        }
        trigger("first_steps");
        seen(QStringLiteral("empty, first steps"));
        trigger("first_steps");
    }

    void wrong_and_failed() {
        if (!open(sheet(), LengthUnit::mm)) return;
        window_.tree().select({TreeNode::Kind::operation, 0});
        enter(window_, "tolerance", QStringLiteral("-1"));
        enter(window_, "stepover", QStringLiteral("three"));
        seen(QStringLiteral("wrong entries"));
        window_.tree().select({TreeNode::Kind::part, 0});
        window_.document().add_operation("lathe_finish");
        window_.plan();
        seen(QStringLiteral("a plan that failed"));
    }

    void scan_room() {
        if (!open(sheet(), LengthUnit::mm)) return;
        seen(QStringLiteral("a scan that has flaws"));
        trigger("scan_room");
        seen(QStringLiteral("scan room"));
        if (auto* suggest = window_.findChild<QAbstractButton*>(QStringLiteral("scan_suggest")))
            suggest->click();
        (void)wait_until_settled(window_);
        if (auto* steps = window_.findChild<QListWidget*>(QStringLiteral("scan_steps")))
            steps->setCurrentRow(0);
        seen(QStringLiteral("scan room, recipe"));
        if (auto* preview = window_.findChild<QAbstractButton*>(QStringLiteral("scan_preview")))
            preview->click();
        seen(QStringLiteral("scan room, tried"));
        dock("scan_dock")->hide();
    }

    void missing_file() {
        const QString mesh = sheet();
        if (!open(mesh, LengthUnit::mm)) return;
        const QString project = mesh + QStringLiteral(".facetmill");
        (void)window_.files().save_to(project);
        QFile::remove(mesh);
        (void)open(project, {});
        seen(QStringLiteral("missing file"));
    }

    void long_names() {
        const QString mesh =
            scratch_folder(QStringLiteral("a folder whose name is long as well"))
            + QStringLiteral("/a scan of an old relief with rather a long name of many words.stl");
        save_stl(torn_sheet(), mesh.toStdString(), LengthUnit::mm, {});
        if (!open(mesh, LengthUnit::mm)) return;
        window_.document().change(QStringLiteral("Name"), [](Project& p) {
            p.operations.front()->common().name = name_of_many_words;
            p.operations.front()->common().tolerance = 0.2;
            p.tools.front().name = "Ball end of the upper drawer, reground, with a long name";
        });
        window_.plan();
        (void)wait_until_settled(window_);
        window_.tree().select({TreeNode::Kind::operation, 0});
        seen(QStringLiteral("long names"));
        window_.verify();
        (void)wait_until_settled(window_);
        for (const auto& [workspace, name] :
             {std::pair(Workspace::verify, "verified"), {Workspace::simulate, "simulated"}}) {
            window_.workspaces().enter(workspace);
            seen(QStringLiteral("long names, ") + QLatin1String(name));
        }
        ask("export", QStringLiteral("question export"));
        setups();
    }

    void five_axes() {
        const QString path = write_mesh(scratch_folder(QStringLiteral("five_axes")));
        if (!open(path, LengthUnit::inch)) return;
        window_.document().add_operation("finish5");
        window_.document().remove_operation(0);
        window_.document().change(QStringLiteral("Coarse"), [](Project& p) {
            p.machine = "tarus-tpi-2000";
            p.operations[0]->common().tolerance = 0.03 * mm_per_inch;
            p.operations[0]->set("grid_degrees", ParameterValue(radians(9)));
            p.operations[0]->set("normal_limit", ParameterValue(radians(20)));
            p.operations[0]->set("posture", ParameterValue(std::string("cm2")));
        });
        window_.plan();
        (void)wait_until_settled(window_);
        for (const char* name : {"chart_dock", "cspace_dock"}) {
            QDockWidget* shown = dock(name);
            shown->show();
            shown->raise();
            seen(QStringLiteral("five axes, ") + QLatin1String(name));
        }
        dock("cspace_dock")->hide();
        dock("chart_dock")->hide();
    }

    void turning() {
        allow_discarding();
        window_.new_from_sample("square-prism");
        if (!wait_until_settled(window_)) return;
        window_.document().remove_operation(0);
        window_.document().change(QStringLiteral("coarse"), [](Project& p) {
            p.operations[0]->common().tolerance = 0.5;
            p.operations[0]->set("points_per_turn", ParameterValue(72.0));
            p.operations[0]->set("side_feed", ParameterValue(4.0));
        });
        window_.plan();
        (void)wait_until_settled(window_);
        window_.tree().select({TreeNode::Kind::operation, 0});
        dock("unrolled_dock")->show();
        dock("unrolled_dock")->raise();
        seen(QStringLiteral("turning"));
        dock("unrolled_dock")->hide();
    }

    void manual() {
        auto* help = window_.findChild<ui::Help*>();
        for (const char* topic : {"", "operations.html#waterline"}) {
            help->open(QLatin1String(topic));
            help->window()->resize(window_.size() * 0.9);
            QTest::qWait(300); // the page is made anew for its width
            look_(*help->window(), QStringLiteral("manual ") + QLatin1String(topic));
        }
        help->window()->close();
    }

private:
    void setups() {
        if (QMenu* menu = window_.tree().add_setup_menu(); menu && !menu->actions().isEmpty())
            menu->actions().front()->trigger();
        (void)wait_until_settled(window_);
        window_.tree().select({TreeNode::Kind::setup, 1});
        seen(QStringLiteral("two setups"));
        ask("new", QStringLiteral("question unsaved"));
    }
    void seen(const QString& page) {
        (void)wait_until_settled(window_);
        look_(window_, page);
    }
    QDockWidget* dock(const char* name) { return window_.findChild<QDockWidget*>(QLatin1String(name)); }
    void trigger(const char* name) {
        if (QAction* a = action(window_, name)) a->trigger();
        (void)wait_until_settled(window_);
    }
    /// What a command asks first, which is then left.
    void ask(const char* command, const QString& page) {
        QTimer::singleShot(150, &window_, [this, page] {
            auto* box = qobject_cast<QDialog*>(QApplication::activeModalWidget());
            if (!box) return;
            look_(*box, page);
            box->reject();
        });
        trigger(command);
        QTest::qWait(200);
    }
    /// Whatever was done is thrown away when another file is opened.
    void allow_discarding() {
        QTimer::singleShot(100, &window_, [] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box && box->objectName() == QLatin1String("unsaved_changes"))
                box->button(QMessageBox::Discard)->click();
        });
    }
    bool open(const QString& path, std::optional<LengthUnit> unit) {
        allow_discarding();
        window_.open_file(path, unit);
        return wait_until_settled(window_);
    }
    static QString sheet() {
        const QString path = scratch_folder(QStringLiteral("states")) + QStringLiteral("/torn.stl");
        save_stl(torn_sheet(), path.toStdString(), LengthUnit::mm, {});
        return path;
    }

    ui::MainWindow& window_;
    const Look& look_;
};

} // namespace

void tour_states(ui::MainWindow& window, const Look& look) {
    StateTour tour(window, look);
    tour.empty();
    tour.wrong_and_failed();
    tour.scan_room();
    tour.missing_file();
    tour.long_names();
    tour.five_axes();
    tour.turning();
    tour.manual();
}

} // namespace facetmill::test
