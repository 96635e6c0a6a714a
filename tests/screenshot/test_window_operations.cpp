// One operation among others in the window: planned while the next still is, verified and exported alone,
// switched off, renamed in place, dragged, copied into another project.
#include "core/job/program_files.h"
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/cut_texts.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/language.h"
#include "ui/message_bar.h"
#include "ui/operation_actions.h"
#include "ui/operation_list.h"
#include "ui/project_tree.h"
#include "ui/project_tree_view.h"
#include "ui/status_line.h"
#include "ui/verification_controller.h"
#include "ui/verification_panel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QProgressBar>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;
using ui::OperationState;
using ui::TreeNode;

namespace {

const char* const sheet_project = R"({ "facetmill": 1, "units": "mm", "part": { "file": "block.stl" },
  "stock": { "kind": "box", "margin": [0, 0, 1] },
  "tools": [ { "number": 1, "name": "Ball 6", "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 },
             { "number": 2, "name": "Ball 8", "diameter": 8, "corner_radius": 4, "flute_length": 20, "shank_length": 30 } ],
  "operations": [
    { "kind": "finish3", "name": "Coarse", "tool": 2, "tolerance": 0.3, "allowance": 0.4, "clearance": 3 },
    { "kind": "finish3", "name": "Middle", "tool": 1, "tolerance": 0.2, "clearance": 3 },
    { "kind": "finish3", "name": "Fine", "tool": 1, "tolerance": 0.1, "clearance": 3 } ] })";

const char* const two_setups =
    R"({ "facetmill": 2, "units": "in", "part": { "file": "block.stl", "units": "mm" },
  "tools": [ { "number": 1, "name": "Other", "diameter": 0.5, "flute_length": 1, "shank_length": 1 } ],
  "setups": [
    { "name": "Top", "stock": { "kind": "box", "margin": [0, 0, 0.1] },
      "operations": [ { "kind": "finish3", "name": "Coarse", "tool": 1 }, { "kind": "finish3", "name": "Last", "tool": 1 } ] },
    { "name": "Bottom", "operations": [ { "kind": "finish3", "name": "Below", "tool": 1 } ] } ] })";

} // namespace

class TestWindowOperations : public QObject, private WindowFixture {
    Q_OBJECT

    const Project& project() { return w().document().project(); }
    bool open(const char* json, const QString& name) {
        folder_ = scratch_folder(name);
        save_stl(HollowedBlock::mesh(), (folder_ + "/block.stl").toStdString(), LengthUnit::mm, {});
        QFile file(folder_ + "/job.facetmill");
        if (!file.open(QIODevice::WriteOnly)) return false;
        file.write(json);
        file.close();
        w().open_file(file.fileName());
        return wait_until_settled(w());
    }
    ui::ProjectTreeView* tree() { return w().tree().findChild<ui::ProjectTreeView*>(); }
    QTreeWidgetItem* item(TreeNode::Kind kind, std::size_t i) { return w().tree().item({kind, i}); }
    void choose(std::size_t operation) { w().tree().select({TreeNode::Kind::operation, operation}); }
    QStringList names() {
        QStringList all;
        for (const auto& o : project().operations)
            all << QString::fromStdString(o->common().name);
        return all;
    }
    QAction* of_tree(const QString& text) {
        for (QAction* a : w().tree().operations().findChildren<QAction*>())
            if (a->text() == text) return a;
        qFatal("there is no such action");
    }
    /// Types a name over the item of what is selected.
    void rename(const QString& name) {
        tree()->setFocus();
        QTest::keyClick(tree(), Qt::Key_F2);
        auto* line = tree()->findChild<QLineEdit*>();
        QVERIFY(line);
        type_over(line, name);
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!tree()->findChild<QLineEdit*>(), patience_ms);
        QCoreApplication::processEvents();
    }

private slots:
    void init() {
        QVERIFY(show_window());
        QVERIFY(open(sheet_project, QStringLiteral("operations")));
    }
    void cleanup() { close_window(); }

    /// A path is there while the next one is still being planned, and stays when that is cancelled.
    void what_is_planned_is_kept() {
        w().document().change(QStringLiteral("Edit"),
                              [](Project& p) { p.operations[1]->common().tolerance = 0.0005; });
        bool shown_early = false;
        connect(&w().document(), &ui::Document::states_changed, this, [&] {
            if (w().document().state(0) != OperationState::planned || shown_early) return;
            shown_early = w().job().running() && w().document().state(1) == OperationState::planning;
            QTimer::singleShot(0, &w(), [&] { w().cancel(); });
        });
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(shown_early);
        QCOMPARE(w().document().state(0), OperationState::planned);
        QCOMPARE(w().document().state(1), OperationState::not_planned);
        QCOMPARE(w().document().state(2), OperationState::not_planned);
        QVERIFY(w().document().result(0));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("Coarse")),
                 qPrintable(w().message_bar().message()));
        shot(w(), QStringLiteral("operations-cancelled"));
    }

    /// It is not told of a tool that undo took away again.
    void a_tool_that_came_along_goes_with_its_message() {
        w().document().change(QStringLiteral("One tool"), [](Project& p) {
            p.tools.resize(1);
            for (auto& o : p.operations)
                o->common().tool = p.tools.front().number;
        });
        w().document().add_operation("cleanup");
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("was added to it")),
                 qPrintable(w().message_bar().message()));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().message_bar().message(), QString());
    }

    /// One form does for operations of a kind, and no entry stays in it for another one.
    void a_form_is_built_once_for_a_kind() {
        w().document().change(QStringLiteral("Alike"), [](Project& p) {
            p.operations[0]->common().tolerance = p.operations[1]->common().tolerance;
        });
        QCOMPARE(w().document().operation(0).kind(), w().document().operation(1).kind());
        choose(0);
        QPointer<QLineEdit> tolerance = field(w(), "tolerance");
        const QString was = tolerance->text();
        enter(w(), "tolerance", QStringLiteral("wide"));
        QVERIFY(!error_under(w(), "tolerance").isEmpty());
        choose(1);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(field(w(), "tolerance"), tolerance.data());
        QCOMPARE(tolerance->text(), was);
        QCOMPARE(error_under(w(), "tolerance"), QString());
    }

    void says_which_and_how_long() {
        auto* activity = w().findChild<QLabel*>(QStringLiteral("activity"));
        bool second = false;
        connect(&w().job(), &ui::BackgroundJob::progressed, this, [&](double, const QString& label) {
            second = second || label.startsWith(QStringLiteral("Middle (2 of 3)"));
        });
        w().document().change(QStringLiteral("Edit"),
                              [](Project& p) { p.operations[1]->common().tolerance = 0.0005; });
        w().plan();
        QTRY_VERIFY_WITH_TIMEOUT(second || !w().job().running(), patience_ms);
        QVERIFY(second);
        if (w().job().running()) QVERIFY(activity->text().startsWith(QStringLiteral("Middle (2 of 3)")));
        w().cancel();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(ui::time_left_text(3), QStringLiteral("a few s left"));
        QCOMPARE(ui::time_left_text(42), QStringLiteral("40 s left"));
        QCOMPARE(ui::time_left_text(57), QStringLiteral("1 min left"));
        QCOMPARE(ui::time_left_text(200), QStringLiteral("3 min left"));
        QCOMPARE(ui::time_left_text(5400), QStringLiteral("1.5 h left"));
        QCOMPARE(ui::time_left_text(36000 * 3), QStringLiteral("30 h left"));
        // However long that is in a language, the bar has room for it.
        for (const char* language : {"de", "fr", "en"}) {
            ui::speak(language);
            QWidget window;
            window.resize(600, 40);
            QProgressBar bar(&window);
            window.show();
            bar.setRange(0, 100);
            bar.setValue(88);
            bar.setFixedWidth(60);
            for (const double seconds : {3.0, 42.0, 5400.0}) {
                ui::say_in_bar(bar, QStringLiteral("%p % · ") + ui::time_left_text(seconds));
                QCOMPARE(found_at_rest([&] { return cut_texts(window); }), QStringList());
                bar.setFixedWidth(60);
                QVERIFY(!found_at_rest([&] { return cut_texts(window); }).isEmpty());
            }
        }
    }

    void switched_off_it_is_left_out() {
        choose(1);
        of_tree(QStringLiteral("Switched off"))->trigger();
        QCOMPARE(w().document().state(1), OperationState::off);
        QVERIFY(item(TreeNode::Kind::operation, 1)->toolTip(0).contains(QStringLiteral("Switched off")));
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QCOMPARE(w().document().state(2), OperationState::planned);
        const auto plan = w().document().complete_plan();
        QVERIFY(plan);
        QCOMPARE(plan->operations.size(), std::size_t(2));
        QCOMPARE(program_file_name(project(), *plan, 1), std::string("03-Fine.apt"));
        w().verify();
        QVERIFY(wait_until_settled(w()));
        const auto& model = w().verification().model();
        QVERIFY(model.current());
        QVERIFY(model.verdict(0) != ui::Verdict::none && model.verdict(2) != ui::Verdict::none);
        QVERIFY(model.verdict(1) == ui::Verdict::none);
        shot(w(), QStringLiteral("operations-off"));
        // What is on again is as it was before it was off; the verdict was on another job.
        choose(1);
        of_tree(QStringLiteral("Switched off"))->trigger();
        QCOMPARE(w().document().state(1), OperationState::not_planned);
        QVERIFY(!model.current() && !w().document().complete_plan());
        w().plan();
        QVERIFY(wait_until_settled(w()));
        of_tree(QStringLiteral("Switched off"))->trigger();
        of_tree(QStringLiteral("Switched off"))->trigger();
        QCOMPARE(w().document().state(1), OperationState::planned);
        // All of them off: said, not planned.
        for (std::size_t i = 0; i < 3; ++i)
            ui::switch_operation(w().document(), i, true);
        w().plan();
        QVERIFY(!w().job().running());
        QVERIFY(w().message_bar().message().contains(QStringLiteral("switched off")));
        QVERIFY(!w().document().complete_plan() && !w().verification().can_verify());
    }

    /// The first of three leaves its allowance: by itself that is what it is to leave.
    void verified_up_to_one() {
        choose(0);
        of_tree(QStringLiteral("Verify up to this operation"))->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QCOMPARE(w().document().state(1), OperationState::not_planned);
        const auto& model = w().verification().model();
        QVERIFY(model.current());
        QCOMPARE(model.last_judged(), QStringLiteral("Coarse"));
        QCOMPARE(model.verification().used.allowance, 0.4);
        QVERIFY2(model.verification().passed(), qPrintable(model.failure_text()));
        QVERIFY(model.verdict(0) == ui::Verdict::verified && model.verdict(1) == ui::Verdict::none);
        QVERIFY(w().verification().doubt().contains(QStringLiteral("Coarse")));
        QVERIFY(model.subject_text().contains(QStringLiteral("up to “Coarse”")));
        shot(w(), QStringLiteral("operations-verified-to"));
        // The others are no part of it; a change of this one is.
        ui::switch_operation(w().document(), 2, true);
        QVERIFY(model.current());
        w().document().change(QStringLiteral("Edit"),
                              [](Project& p) { p.operations[0]->common().tolerance = 0.25; });
        QVERIFY(!model.current());
    }

    void exported_alone() {
        choose(1);
        w().plan(std::size_t(1));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().document().complete_plan());
        const QString out = scratch_folder(QStringLiteral("alone"));
        w().exports().save_programs(out, std::size_t(1));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(QDir(out).entryList(QDir::Files),
                 QStringList({QStringLiteral("02-Middle.apt"), QStringLiteral("report.json")}));
        w().exports().save_programs(out, std::size_t(0));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("not planned")));
    }

    void renamed_in_place() {
        choose(1);
        rename(QStringLiteral("Upper side"));
        QCOMPARE(names(), QStringList({"Coarse", "Upper side", "Fine"}));
        QCOMPARE(item(TreeNode::Kind::operation, 1)->text(0), QStringLiteral("Upper side"));
        // Nothing that another has, and nothing empty.
        for (const QString& bad : {QStringLiteral("Fine"), QStringLiteral("  ")}) {
            choose(1);
            rename(bad);
            QVERIFY(!w().message_bar().message().isEmpty());
            QCOMPARE(names(), QStringList({"Coarse", "Upper side", "Fine"}));
            QCOMPARE(item(TreeNode::Kind::operation, 1)->text(0), QStringLiteral("Upper side"));
        }
        w().document().undo_stack().undo();
        QCOMPARE(names(), QStringList({"Coarse", "Middle", "Fine"}));
    }

    void dragged_to_another_place() {
        emit tree()->moved(item(TreeNode::Kind::operation, 0), item(TreeNode::Kind::operation, 2), true);
        QCoreApplication::processEvents();
        QCOMPARE(names(), QStringList({"Middle", "Fine", "Coarse"}));
        QVERIFY(w().tree().selected() == (TreeNode{TreeNode::Kind::operation, 2}));
        emit tree()->moved(item(TreeNode::Kind::operation, 2), item(TreeNode::Kind::operation, 0), false);
        QCoreApplication::processEvents();
        QCOMPARE(names(), QStringList({"Coarse", "Middle", "Fine"}));
        const int steps = w().document().undo_stack().count();
        emit tree()->moved(item(TreeNode::Kind::operation, 1), item(TreeNode::Kind::operation, 0), true);
        QCoreApplication::processEvents();
        QCOMPARE(w().document().undo_stack().count(), steps); // it stands there
        // Into another setup.
        bool asked = false;
        answer_next(QMessageBox::Discard, asked);
        QVERIFY(open(two_setups, QStringLiteral("dragged")));
        emit tree()->moved(item(TreeNode::Kind::operation, 0), item(TreeNode::Kind::elsewhere, 2), false);
        QCoreApplication::processEvents();
        QCOMPARE(names(), QStringList({"Last"}));
        QCOMPARE(setup_at(project(), 1).operations.size(), std::size_t(2));
        QCOMPARE(setup_at(project(), 1).operations[0]->common().name, std::string("Coarse"));
        w().document().undo_stack().undo();
        QCOMPARE(names(), QStringList({"Coarse", "Last"}));
        QCOMPARE(w().document().setup_ids()[1].size(), std::size_t(1));
    }

    void copied_into_another_project() {
        choose(0);
        tree()->setFocus();
        QTest::keyClick(tree(), Qt::Key_C, Qt::ControlModifier);
        QVERIFY(open(two_setups, QStringLiteral("copied")));
        choose(0);
        tree()->setFocus();
        QTest::keyClick(tree(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(names(), QStringList({"Coarse", "Coarse 2", "Last"}));
        const OperationCommon& made = w().document().operation(1).common();
        QCOMPARE(made.tolerance, 0.3); // lengths are lengths
        QCOMPARE(made.allowance, 0.4);
        QCOMPARE(project().tools.size(), std::size_t(2));
        QCOMPARE(project().tools[1].name, std::string("Ball 8"));
        QCOMPARE(made.tool, project().tools[1].number);
        QVERIFY(w().tree().selected() == (TreeNode{TreeNode::Kind::operation, 1}));
        check_project(project());
        w().document().undo_stack().undo(); // the tool goes with it
        QCOMPARE(project().tools.size(), std::size_t(1));
        QApplication::clipboard()->setText(QStringLiteral("an apple"));
        QTest::keyClick(tree(), Qt::Key_V, Qt::ControlModifier);
        QVERIFY(w().message_bar().message().contains(QStringLiteral("no operation")));
        QCOMPARE(names(), QStringList({"Coarse", "Last"}));
    }

private:
    QString folder_;
};

FACETMILL_TEST(TestWindowOperations)
#include "test_window_operations.moc"
