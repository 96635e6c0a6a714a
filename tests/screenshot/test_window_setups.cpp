// Several setups in the window: the tree that holds them, going from one to another, and what a setup begins
// with.
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/message_bar.h"
#include "ui/parameter_form.h"
#include "ui/program_export.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/tool_list.h"
#include "ui/verification_controller.h"
#include "ui/verification_panel.h"

#include <QAction>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;
using ui::VerificationModel;

namespace {

const char* const block_project = R"({ "facetmill": 2, "units": "mm", "part": { "file": "block.stl" },
  "tools": [ { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 } ],
  "setups": [
    { "name": "Top", "stock": { "kind": "box", "margin": [0, 0, 1] },
      "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.1, "clearance": 3 } ] },
    { "name": "Bottom", "place": { "rotate": [180, 0, 0], "translate": [0, 30, 24] },
      "operations": [ { "kind": "finish3", "name": "Below", "tool": 1, "tolerance": 0.1, "clearance": 3 } ] } ] })";

/// Names of the items below the root, and of those below one of them.
QStringList items(const QTreeWidgetItem* parent) {
    QStringList names;
    for (int i = 0; i < parent->childCount(); ++i)
        names << parent->child(i)->text(0);
    return names;
}

} // namespace

class TestWindowSetups : public QObject, private WindowFixture {
    Q_OBJECT

    QTreeWidgetItem* item(TreeNode::Kind kind, std::size_t i) { return w().tree().item({kind, i}); }
    const Project& project() { return w().document().project(); }
    std::string text_now() { return project_to_json(project()); }
    void go_to(std::size_t setup) {
        w().tree().select({TreeNode::Kind::setup, setup});
        w().tree().go_to_setup_action()->trigger();
    }
    QAction* add(const char* name) {
        for (QAction* a : w().tree().add_setup_menu()->actions())
            if (a->objectName() == QLatin1String(name)) return a;
        qFatal("there is no such setup to add");
    }

private slots:
    void init() {
        QVERIFY(show_window());
        folder_ = scratch_folder(QStringLiteral("setups"));
        save_stl(HollowedBlock::mesh(), (folder_ + "/block.stl").toStdString(), LengthUnit::mm, {});
        QFile file(folder_ + "/job.facetmill");
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(block_project);
        file.close();
        w().open_file(file.fileName());
        QVERIFY(wait_until_settled(w()));
    }
    void cleanup() { close_window(); }

    void the_tree_has_the_setups() {
        QVERIFY(item(TreeNode::Kind::setup, 0) && item(TreeNode::Kind::setup, 1));
        QCOMPARE(item(TreeNode::Kind::setup, 0)->text(0), QStringLiteral("Top"));
        QVERIFY(item(TreeNode::Kind::setup, 0)->font(0).bold());
        QVERIFY(!item(TreeNode::Kind::setup, 1)->font(0).bold());
        QCOMPARE(items(item(TreeNode::Kind::setup, 1)), QStringList({"Below"}));
        QCOMPARE(item(TreeNode::Kind::operation, 0)->text(0), QStringLiteral("Finish"));
        shot(w(), QStringLiteral("setups"));
        // To the operation of another setup by a double click; back is a step of the history.
        emit w().tree().tree()->itemDoubleClicked(item(TreeNode::Kind::elsewhere, 1), 0);
        w().tree().select({TreeNode::Kind::elsewhere, 1});
        w().tree().go_to_setup_action()->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(chosen_setup(project()), std::size_t(1));
        QVERIFY(w().tree().selected() == (TreeNode{TreeNode::Kind::operation, 0}));
        QCOMPARE(items(item(TreeNode::Kind::setup, 0)), QStringList({"Finish"}));
        QVERIFY(w().document().part_is_current());
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(chosen_setup(project()), std::size_t(0));
        QVERIFY(!w().document().modified());
    }

    /// What the setup before leaves is there once this one is planned, and gone when that one changes.
    void a_setup_begins_with_the_rest() {
        go_to(1);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY(w().document().part() && !w().document().has_stock());
        QVERIFY((w().document().part()->box.size() - HollowedBlock::size()).norm() < 1e-3);
        QTest::keyClick(&w(), Qt::Key_F6); // plans first
        QVERIFY(wait_until_settled(w()));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        QVERIFY(w().document().has_stock() && w().document().part()->stock_mesh);
        const auto plan = w().document().complete_plan();
        QVERIFY(plan && plan->stock.kind == StockSolid::Kind::mesh);
        // The first hollow is above in the first setup, below in this one.
        double lowest = 100;
        for (const Vec3& p : plan->stock.mesh->vertices)
            if ((p - Vec3(20, 15, p.z())).norm() < 1 && p.z() > 1) lowest = std::min(lowest, p.z());
        QVERIFY2(std::abs(lowest - HollowedBlock::depth) < 0.2, qPrintable(QString::number(lowest)));
        QVERIFY(w().verification().model().any());
        QVERIFY2(w().verification().model().verification().passed(), "not verified");
        shot(w(), QStringLiteral("setups-second"));
        // Elsewhere and back: nothing has to be planned anew.
        go_to(0);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned); // it had to be
        go_to(1);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        w().document().change(QStringLiteral("Edit"),
                              [](Project& p) { p.before[0].operations[0]->common().allowance = 0.2; });
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), ui::OperationState::stale);
        QVERIFY(!w().document().has_stock());
    }

    /// Planned and judged together: what one cuts is not uncut for the other, and the verdict is that of
    /// both.
    void all_setups_are_one_job() {
        const VerificationModel& model = w().verification().model();
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(model.any() && !model.covers_all());
        auto* button = w().findChild<QPushButton*>(QStringLiteral("verify_all_button"));
        QVERIFY(button && button->isVisible() && button->isEnabled());
        shot(w(), QStringLiteral("setups-one-alone"));
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(w().job().running());
        QCOMPARE(w().document().state(0), ui::OperationState::planned); // not once more
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY2(model.verdict() == ui::Verdict::verified, qPrintable(model.failure_text()));
        QVERIFY(model.current() && model.covers_all());
        QCOMPARE(model.outcome().setups.size(), std::size_t(2));
        QCOMPARE(model.program_name(1), QStringLiteral("Below"));
        QVERIFY(w().verification().doubt().isEmpty());
        QVERIFY(!button->isVisible());
        const double uncut = model.verification().uncut_share;
        // The same from the other side, with the colours on the part as it lies there.
        go_to(1);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), ui::OperationState::planned);
        QVERIFY(w().document().has_stock());
        QVERIFY(model.current() && model.fits_part());
        QCOMPARE(model.verdict(0), ui::Verdict::verified);
        QCOMPARE(model.verification().uncut_share, uncut);
        const Box3 &part = w().document().part()->box, colours = model.shown_setup()->display->box;
        QVERIFY((part.lo - colours.lo).norm() < 1e-3 && (part.hi - colours.hi).norm() < 1e-3);
        shot(w(), QStringLiteral("setups-verified"));
        // So does the sheet: one for both, with the picture of the one that is seen.
        w().exports().save_sheet(folder_ + "/sheet.html");
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QFile sheet(folder_ + "/sheet.html");
        QVERIFY(sheet.open(QIODevice::ReadOnly));
        const QByteArray html = sheet.readAll();
        QVERIFY(html.contains("Top") && html.contains("Bottom") && html.contains("Finish")
                && html.contains("Below"));
        QCOMPARE(html.count("<img"), 1);
        // The plan of this one goes on from what it began with.
        w().plan(0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY(model.current());
        // A verdict on one of them alone takes its place, there only; a change ends all.
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(model.outcome().setups.size(), std::size_t(1));
        go_to(0);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(model.outcome().setups.size(), std::size_t(2));
        QVERIFY(model.current());
        w().document().change(QStringLiteral("Edit"),
                              [](Project& p) { p.after[0].operations[0]->common().feed = 333; });
        QVERIFY(!model.current());
        QCOMPARE(model.verdict(), ui::Verdict::stale);
    }

    /// A finding is seen in the setup that made it.
    void a_finding_leads_to_its_setup() {
        w().document().change(QStringLiteral("Edit"), [](Project& p) {
            p.limits.gouge_limit = {1e-6, {}};
        }); // what rounding leaves
        QTest::keyClick(&w(), Qt::Key_F6, Qt::ShiftModifier);
        QVERIFY(wait_until_settled(w()));
        const VerificationModel& model = w().verification().model();
        QCOMPARE(model.verdict(), ui::Verdict::failed);
        std::size_t which = 0;
        while (which < model.findings().size()
               && model.program_name(model.findings()[which].by.program) != QStringLiteral("Below"))
            ++which;
        QVERIFY(which < model.findings().size());
        const Vec3 above = model.findings()[which].place;
        QTreeWidget* list = w().verification().panel()->findings();
        const auto rows = list->findItems(QStringLiteral("Below"), Qt::MatchExactly, 3);
        QVERIFY(!rows.isEmpty());
        for (QTreeWidgetItem* row : rows)
            if (row->data(0, Qt::UserRole).toULongLong() == which) list->setCurrentItem(row);
        emit list->itemClicked(list->currentItem(), 0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(chosen_setup(project()), std::size_t(1));
        QVERIFY(model.current());
        const SetupFrame frame = frame_of(project().place);
        QVERIFY((model.findings()[which].place - frame(above)).norm() < 1e-9);
        QVERIFY(w().verification().engaged());
        shot(w(), QStringLiteral("setups-finding"));
    }

    void setups_are_added_renamed_moved_and_removed() {
        const std::string before = text_now();
        go_to(1);
        QVERIFY(wait_until_settled(w()));
        const Box3 box = w().document().part()->box;
        add("setup_about_y")->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(setup_count(project()), std::size_t(3));
        QCOMPARE(chosen_setup(project()), std::size_t(2));
        QCOMPARE(project().name, std::string("Setup 3"));
        QVERIFY(project().stock.kind == StockSpec::Kind::rest);
        QVERIFY(project().operations.empty());
        // Over about Y, with its box where it was.
        QVERIFY(w().document().part_is_current());
        const Box3 over = w().document().part()->box;
        QVERIFY((over.lo - box.lo).norm() < 1e-6 && (over.hi - box.hi).norm() < 1e-6);
        const SetupFrame frame =
            frame_of(project().place).after(frame_of(setup_at(project(), 1).place).inverse());
        QVERIFY(frame.turn == Mat3(Vec3(-1, 1, -1).asDiagonal()));
        // Its name, by the form; that of another setup is refused.
        w().tree().select({TreeNode::Kind::setup, 2});
        enter(w(), "name", QStringLiteral("Bottom"));
        QVERIFY(!error_under(w(), "name").isEmpty());
        enter(w(), "name", QStringLiteral("Once more"));
        QCOMPARE(project().name, std::string("Once more"));
        QVERIFY(item(TreeNode::Kind::setup, 2)->text(0) == QStringLiteral("Once more"));
        // A copy of the second, with names of its own.
        w().tree().select({TreeNode::Kind::setup, 1});
        w().tree().duplicate_action()->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(setup_count(project()), std::size_t(4));
        QCOMPARE(project().name, std::string("Bottom 2"));
        QCOMPARE(project().operations[0]->common().name, std::string("Below 2"));
        check_project(project());
        w().tree().down_action()->trigger();
        QCOMPARE(setup_at(project(), 3).name, std::string("Bottom 2"));
        w().tree().remove_action()->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(setup_count(project()), std::size_t(3));
        // The second cannot be the first: nothing comes before that.
        const std::string now = text_now();
        w().tree().select({TreeNode::Kind::setup, 1});
        w().tree().up_action()->trigger();
        QCOMPARE(text_now(), now);
        QVERIFY(w().message_bar().message().contains(QStringLiteral("stock of its own")));
        w().tree().select({TreeNode::Kind::setup, 0});
        w().tree().remove_action()->trigger();
        QCOMPARE(text_now(), now);
        // All of that can be undone, a step each, and what is saved is all of it.
        QVERIFY(w().files().save_to(folder_ + "/again.facetmill"));
        QCOMPARE(project_to_json(load_project((folder_ + "/again.facetmill").toStdString())), now);
        while (w().document().undo_stack().canUndo())
            w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(text_now(), before);
        while (w().document().undo_stack().canRedo())
            w().document().undo_stack().redo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(text_now(), now);
    }

    /// Tools that operations of another setup use stay, and keep their number there.
    void tools_are_those_of_all_setups() {
        Project one = project();
        one.operations.clear();
        w().document().change(QStringLiteral("Clear"), [](Project& p) { p.operations.clear(); });
        QCOMPARE(code_of_removal(), std::string("missing_reference"));
        Tool tool = project().tools[0];
        tool.number = 7;
        ui::set_tool(w().document(), 0, tool);
        QCOMPARE(setup_at(project(), 1).operations[0]->common().tool, 7L);
        QCOMPARE(w().document().free_operation_name("Below"), std::string("Below 2"));
    }

    /// A project of one setup looks as ever, and gets its second one by a click.
    void one_setup_has_no_item() {
        w().tree().select({TreeNode::Kind::setup, 1});
        w().tree().remove_action()->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(setup_count(project()), std::size_t(1));
        QVERIFY(!item(TreeNode::Kind::setup, 0));
        QVERIFY(item(TreeNode::Kind::operation, 0));
        add("setup_about_x")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(item(TreeNode::Kind::setup, 1));
        QCOMPARE(project().name, std::string("Setup 2"));
        // As the file had it: that was such a flip.
        const SetupFrame frame = frame_of(project().place);
        QVERIFY(frame.turn == Mat3(Vec3(1, -1, -1).asDiagonal()));
        QVERIFY((frame.move - Vec3(0, 30, 24)).norm() < 1e-4);
    }

private:
    std::string code_of_removal() {
        try {
            ui::remove_tool(w().document(), 0);
        } catch (const Error& e) {
            return std::string(code_name(e.code()));
        }
        return "none";
    }
    QString folder_;
};

FACETMILL_TEST(TestWindowSetups)
#include "test_window_setups.moc"
