// The whole workbench under a virtual display, driven by mouse and keys: planning and editing.
#include "tests/screenshot/window_support.h"
#include "ui/parameter_form.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/report_view.h"
#include "ui/tool_dialog.h"
#include "ui/tool_library_dialog.h"
#include "ui/tool_sketch.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScopeGuard>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>
#include <set>

using namespace facetmill;
using namespace facetmill::test;
using ui::OperationState;
using ui::TreeNode;

class TestWindow : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void empty_window_says_how_to_begin() {
        QVERIFY(w().findChild<QWidget*>(QStringLiteral("start_hint"))->isVisible());
        QVERIFY(!action(w(), "plan")->isEnabled());
        QVERIFY(!action(w(), "save")->isEnabled());
        QVERIFY(!action(w(), "export")->isEnabled());
        QVERIFY(!w().document().modified());
        shot(w(), QStringLiteral("window-empty"));
        w().resize(800, 600);
        shot(w(), QStringLiteral("window-empty-small"));
    }

    void new_from_sample_then_plan() {
        auto* sample = action(w(), "sample_concave");
        QVERIFY(sample);
        sample->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().findChild<QWidget*>(QStringLiteral("start_hint"))->isVisible());
        QVERIFY(w().document().has_part());
        QCOMPARE(w().document().unit(), LengthUnit::inch);
        QVERIFY(!w().document().modified()); // nothing is lost with it
        QVERIFY(w().windowTitle().startsWith(QStringLiteral("concave")));
        QVERIFY(!w().windowTitle().contains(QChar('*')));
        QCOMPARE(w().document().operation_count(), std::size_t(1));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        QVERIFY(w().report().toPlainText().contains(QStringLiteral("Facets")));
        shot(w(), QStringLiteral("window-sample"));

        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.01"));
        const QImage before = view_picture(w());
        QTest::keyClick(&w(), Qt::Key_P, Qt::ControlModifier);
        QVERIFY(w().job().running());
        QCOMPARE(w().document().state(0), OperationState::planning);
        QVERIFY(w().findChild<QProgressBar*>(QStringLiteral("progress"))->isVisible());
        QVERIFY(action(w(), "cancel")->isEnabled());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(!w().findChild<QProgressBar*>(QStringLiteral("progress"))->isVisible());
        QVERIFY(changed_pixels(before, view_picture(w())) > 5000); // the path is there
        const QString report = w().report().toPlainText();
        for (const char* word : {"Passes", "Step-over", "CC points", "CL points", "Cut length",
                                 "Machining time", "Expected cusp", " in"})
            QVERIFY2(report.contains(QLatin1String(word)), word);
        shot(w(), QStringLiteral("window-planned"));
    }

    void parameters_are_checked_in_place() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));
        QCOMPARE(first_operation(w()).tolerance, 0.02 * 25.4);
        enter(w(), "tolerance", QStringLiteral("-1"));
        QVERIFY2(error_under(w(), "tolerance").contains(QStringLiteral("above 0 in")),
                 qPrintable(error_under(w(), "tolerance")));
        QCOMPARE(first_operation(w()).tolerance, 0.02 * 25.4);
        shot(w(), QStringLiteral("window-invalid"));
        // A plan from a value that is not the one on the screen would be a wrong plan.
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(!w().job().running());
        QVERIFY(w().message_bar().message().contains(QStringLiteral("not valid")));
        enter(w(), "tolerance", QStringLiteral("0.03"));
        QVERIFY(error_under(w(), "tolerance").isEmpty());
        QCOMPARE(first_operation(w()).tolerance, 0.03 * 25.4);
        enter(w(), "name", QStringLiteral("  "));
        QVERIFY(!error_under(w(), "name").isEmpty());
        QCOMPARE(first_operation(w()).name, std::string("Finish"));
    }

    void what_planning_would_refuse_is_said_in_the_form() {
        QVERIFY(open_part());
        const std::size_t rough = w().document().add_operation("rough");
        QCOMPARE(rough, std::size_t(0));
        w().tree().select({TreeNode::Kind::operation, rough});
        enter(w(), "stepover", QStringLiteral("50"));
        QVERIFY(error_under(w(), "stepover").startsWith(QStringLiteral("Wider than the tool")));
        QVERIFY(w().properties().commit()); // the value itself is good, and is kept
        QCOMPARE(std::get<double>(w().document().operation(rough).get("stepover")), 50 * 25.4);
        shot(w(), QStringLiteral("remark-under-field"));
        enter(w(), "stepover", QStringLiteral("auto"));
        QVERIFY(error_under(w(), "stepover").isEmpty());

        w().tree().select({TreeNode::Kind::operation, w().document().add_operation("finish5")});
        auto* hint = w().properties().findChild<QLabel*>(QStringLiteral("properties_hint"));
        QVERIFY(hint && hint->isVisible());
        QVERIFY2(hint->text().contains(QStringLiteral("no rotary axis")), qPrintable(hint->text()));
        shot(w(), QStringLiteral("remark-on-machine"));
        w().document().change(QStringLiteral("Machine"), [](Project& p) { p.machine = "tarus-tpi-2000"; });
        QVERIFY(!hint->text().contains(QStringLiteral("rotary")));
    }

    void an_open_entry_counts_when_planning() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        type_over(field(w(), "tolerance"), QStringLiteral("0.025"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(first_operation(w()).tolerance, 0.025 * 25.4);
        QCOMPARE(w().document().state(0), OperationState::planned);
    }

    void undo_redo_and_states() {
        QVERIFY(open_and_plan());
        enter(w(), "feed", QStringLiteral("55"));
        QCOMPARE(w().document().state(0), OperationState::stale);
        QVERIFY(w().report().toPlainText().contains(QStringLiteral("Out of date")));
        QVERIFY(!w().document().complete_plan());
        QTest::keyClick(&w(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(std::abs(first_operation(w()).feed - 55 * 25.4) > 1);
        QCOMPARE(w().document().state(0), OperationState::planned); // the result fits again
        QVERIFY(w().document().complete_plan() != nullptr);
        QTest::keyClick(&w(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(first_operation(w()).feed, 55 * 25.4);
        QCOMPARE(w().document().state(0), OperationState::stale);
    }

    void operations_and_tools_come_and_go() {
        QVERIFY(open_and_plan());
        auto& tree = w().tree();
        tree.duplicate_action()->trigger();
        QCOMPARE(w().document().operation_count(), std::size_t(2));
        QCOMPARE(w().document().operation(1).common().name, std::string("Finish 2"));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QCOMPARE(w().document().state(1), OperationState::not_planned);
        tree.select({TreeNode::Kind::operation, 1});
        enter(w(), "name", QStringLiteral("Finish"));
        QVERIFY(error_under(w(), "name").contains(QStringLiteral("Another operation")));
        enter(w(), "name", QStringLiteral("Second"));
        tree.up_action()->trigger();
        QCOMPARE(w().document().operation(0).common().name, std::string("Second"));
        QCOMPARE(w().document().state(1), OperationState::stale); // something else stands before it
        for (QAction* a : tree.add_operation_menu()->actions())
            if (a->text().startsWith(QStringLiteral("Clean-up"))) a->trigger();
        QCOMPARE(w().document().operation_count(), std::size_t(3));
        QCOMPARE(tree.selected()->index, std::size_t(2));
        QCOMPARE(w().document().operation(2).kind(), std::string_view("cleanup"));
        QCOMPARE(w().document().project().tools.size(),
                 std::size_t(2)); // it brought a smaller one, and says so
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("T2 Ball")),
                 qPrintable(w().message_bar().message()));
        shot(w(), QStringLiteral("tool-added"));
        tree.remove_action()->trigger();
        QCOMPARE(w().document().operation_count(), std::size_t(2));

        tree.select({TreeNode::Kind::tool, 0});
        tree.remove_action()->trigger(); // an operation needs it
        QCOMPARE(w().document().project().tools.size(), std::size_t(2));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("uses this tool")));
        tree.duplicate_action()->trigger();
        QCOMPARE(w().document().project().tools.size(), std::size_t(3));
        QCOMPARE(w().document().project().tools[1].number, 3L);
        tree.remove_action()->trigger();
        QCOMPARE(w().document().project().tools.size(), std::size_t(2));
        // All of it can be taken back.
        while (w().document().undo_stack().canUndo())
            w().document().undo_stack().undo();
        QCOMPARE(w().document().operation_count(), std::size_t(1));
        QVERIFY(wait_until_settled(w()));
    }

    void cancel_leaves_everything_as_it_was() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.00002")); // minutes of work
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(w().job().running());
        int beats = 0;
        qint64 longest = 0;
        QElapsedTimer since, whole;
        QTimer heart;
        connect(&heart, &QTimer::timeout, this, [&] {
            ++beats;
            longest = std::max(longest, since.restart());
        });
        since.start();
        heart.start(5);
        QTest::qWait(400);
        QTRY_VERIFY_WITH_TIMEOUT(beats > 3, patience_ms); // the window lives, on a busy machine too
        heart.stop();
        QVERIFY(w().job().running());
        shot(w(), QStringLiteral("window-planning"));
        whole.start();
        QTest::keyClick(&w(), Qt::Key_Escape);
        QVERIFY(w().job().cancelling());
        QVERIFY(wait_until_settled(w()));
        qInfo("longest pause of the window %lld ms; cancelled after %lld ms", longest, whole.elapsed());
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        QVERIFY(!w().document().result(0));
        QVERIFY(w().last_failure().isEmpty()); // giving up is no failure
        QVERIFY(w().message_bar().message().isEmpty());
        QVERIFY(action(w(), "plan")->isEnabled());
        QVERIFY(!action(w(), "cancel")->isEnabled());
        QVERIFY(w().findChild<QPlainTextEdit*>(QStringLiteral("log"))
                    ->toPlainText()
                    .contains(QStringLiteral("Cancelled")));
        // And it can be planned after all.
        enter(w(), "tolerance", QStringLiteral("0.03"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
    }

    void a_failed_operation_says_why() {
        QVERIFY(open_and_plan());
        w().tree().select({TreeNode::Kind::part, 0});
        enter(w(), "tessellation_tolerance1", QStringLiteral("1")); // leaves nothing of the tolerance
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::failed);
        QVERIFY(!w().document().result(0)); // no old path beside a failure
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("tolerance")),
                 qPrintable(w().message_bar().message()));
        QVERIFY(w().findChild<QPlainTextEdit*>(QStringLiteral("log"))
                    ->toPlainText()
                    .contains(w().message_bar().message().left(30)));
        QVERIFY(QApplication::activeModalWidget() == nullptr);
        QVERIFY(w().report().toPlainText().contains(QStringLiteral("Failed")));
        shot(w(), QStringLiteral("window-failed"));
    }

    void a_missing_part_says_why() {
        QVERIFY(open_part());
        const QString file = QString::fromStdString(w().document().project().part_path().string());
        QVERIFY(QFile::remove(file));
        w().tree().select({TreeNode::Kind::part, 0});
        enter(w(), "rotate2", QStringLiteral("90")); // the part is read again
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("surface.stl")),
                 qPrintable(w().message_bar().message()));
        QVERIFY(!w().document().part_is_current());
        QVERIFY(!w().document().complete_plan());
    }

    void units_switch_the_display_only() {
        QVERIFY(open_and_plan());
        const double tolerance = first_operation(w()).tolerance;
        QCOMPARE(field(w(), "tolerance")->text(), QStringLiteral("0.02"));
        auto* box = w().findChild<QComboBox*>(QStringLiteral("unit"));
        QCOMPARE(box->currentIndex(), 1);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Up);
        QCOMPARE(w().document().unit(), LengthUnit::mm);
        QCOMPARE(field(w(), "tolerance")->text(), QStringLiteral("0.508"));
        QCOMPARE(first_operation(w()).tolerance, tolerance);
        QCOMPARE(w().document().state(0), OperationState::planned);
        QVERIFY(w().report().toPlainText().contains(QStringLiteral(" mm")));
        shot(w(), QStringLiteral("window-mm"));
    }

    void the_machine_is_chosen() {
        QVERIFY(open_and_plan());
        w().tree().select({TreeNode::Kind::machine, 0});
        auto* box = w().properties().form()->findChild<QComboBox*>(QStringLiteral("machine"));
        QVERIFY(box && box->count() >= 2);
        const std::string before = w().document().project().machine;
        box->setFocus();
        QTest::keyClick(box, box->currentIndex() == 0 ? Qt::Key_Down : Qt::Key_Up);
        QVERIFY(w().document().project().machine != before);
        QCOMPARE(w().document().state(0), OperationState::stale); // the machining time is another
        shot(w(), QStringLiteral("window-machine"));
    }

    void tool_dialog() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::tool, 0});
        shot(w(), QStringLiteral("window-tool"));
        const Tool before = w().document().project().tools[0];
        w().tree().edit_action()->trigger();
        auto* dialog = w().findChild<ui::ToolDialog*>();
        QVERIFY(dialog);
        QVERIFY(activate(*dialog));
        auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        auto* sketch = dialog->findChild<ui::ToolSketch*>();
        auto* form = dialog->findChild<ui::ParameterForm*>();
        const auto line = [&](const char* name) { return form->findChild<QLineEdit*>(QLatin1String(name)); };
        auto* shape = dialog->findChild<QComboBox*>(QStringLiteral("shape"));
        const auto choose_shape = [&](int index) {
            shape->setCurrentIndex(index);
            emit shape->activated(index);
        };
        QVERIFY(ok->isEnabled());
        QVERIFY(sketch->why_not().isEmpty());
        shot(*dialog, QStringLiteral("dialog-tool"));

        type_over(line("diameter"), QStringLiteral("-3"));
        QVERIFY(!ok->isEnabled());
        QVERIFY(!form->error("diameter").isEmpty());
        // A ball stays one, on a shank as wide, and its name says so.
        type_over(line("diameter"), QStringLiteral("0.75"));
        QVERIFY2(ok->isEnabled(), qPrintable(dialog->problem()));
        QCOMPARE(dialog->tool().corner_radius, 0.75 * 25.4 / 2);
        QCOMPARE(line("corner_radius")->text(), QStringLiteral("0.375"));
        QCOMPARE(dialog->tool().shank_diameter, 0.75 * 25.4);
        QCOMPARE(line("name")->text(), QStringLiteral("Ball 0.75"));
        choose_shape(2);
        QCOMPARE(line("name")->text(), QStringLiteral("Flat 0.75"));
        type_over(line("corner_radius"), QStringLiteral("5")); // larger than the tool
        QVERIFY(!ok->isEnabled());
        QVERIFY(!dialog->problem().isEmpty());
        QVERIFY(!sketch->why_not().isEmpty());
        shot(*dialog, QStringLiteral("dialog-tool-invalid"));
        type_over(line("corner_radius"), QStringLiteral("0.1"));
        QVERIFY2(ok->isEnabled(), qPrintable(dialog->problem()));
        QVERIFY(sketch->why_not().isEmpty());
        shot(*dialog, QStringLiteral("dialog-tool-bull"));

        QCOMPARE(line("name")->text(), QStringLiteral("Bull 0.75 R0.1"));
        type_over(line("name"), QStringLiteral("Mine"));
        for (int i = 1; i < shape->count(); ++i) {
            choose_shape(i);
            QVERIFY2(dialog->problem().isEmpty(), qPrintable(shape->itemText(i) + dialog->problem()));
            QVERIFY2(sketch->why_not().isEmpty(), qPrintable(shape->itemText(i)));
            shot(*dialog, QStringLiteral("dialog-tool-shape%1").arg(i));
        }
        choose_shape(3);
        QCOMPARE(dialog->tool().name, std::string("Mine"));

        auto* holder = dialog->findChild<QTableWidget*>(QStringLiteral("holder"));
        const int sections = holder->rowCount();
        // An empty table says so.
        auto* none = dialog->findChild<QLabel*>(QStringLiteral("holder_none"));
        QVERIFY(sections == 0 && none && none->isVisible()
                && none->text().contains(QStringLiteral("No holder")));
        QTest::mouseClick(dialog->findChild<QToolButton*>(QStringLiteral("add_section")), Qt::LeftButton);
        QCOMPARE(holder->rowCount(), sections + 1);
        QVERIFY(!none->isVisible());
        holder->item(sections, 0)->setText(QStringLiteral("x"));
        QVERIFY(!ok->isEnabled());
        holder->item(sections, 0)->setText(QStringLiteral("6/2"));
        QCOMPARE(holder->item(sections, 0)->text(), QStringLiteral("3"));
        QVERIFY(ok->isEnabled());
        QTest::mouseClick(ok, Qt::LeftButton);
        const Tool after = w().document().project().tools[0];
        QCOMPARE(after.diameter, 0.75 * 25.4);
        QCOMPARE(after.corner_radius, 0.75 * 25.4 / 8);
        QCOMPARE(after.holder.size(), std::size_t(sections + 1));
        QCOMPARE(after.holder.back().diameter, 3 * 25.4);
        QVERIFY(after.diameter != before.diameter);

        // A new tool gets a free number, and not one that is taken.
        w().tree().add_tool_action()->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(
            w().findChild<ui::ToolDialog*>() && w().findChild<ui::ToolDialog*>() != dialog, patience_ms);
        dialog = w().findChild<ui::ToolDialog*>();
        QCOMPARE(dialog->tool().number, 2L);
        form = dialog->findChild<ui::ParameterForm*>();
        type_over(line("number"), QStringLiteral("1"));
        QVERIFY(dialog->problem().contains(QStringLiteral("another tool")));
        dialog->reject();
        QCOMPARE(w().document().project().tools.size(), std::size_t(1));
    }

    /// Feeds typed into a tool's dialog, taken over by operations as they take the tool, and from the menu.
    void feeds_of_a_tool() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::tool, 0});
        w().tree().edit_action()->trigger();
        auto* dialog = w().findChild<ui::ToolDialog*>();
        QVERIFY(dialog && activate(*dialog));
        dialog->findChild<QTabWidget*>(QStringLiteral("lists"))->setCurrentIndex(1);
        auto* table = dialog->findChild<QTableWidget*>(QStringLiteral("cutting"));
        auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        auto* add = dialog->findChild<QToolButton*>(QStringLiteral("add_cutting"));
        for (const auto& [material, spindle, feed] :
             {std::tuple("Lime wood", "18000", "90"), {"Brass", "9000", "20"}}) {
            QTest::mouseClick(add, Qt::LeftButton);
            const int row = table->rowCount() - 1;
            table->item(row, 1)->setText(QString::fromLatin1(material));
            table->item(row, 2)->setText(QString::fromLatin1(spindle));
            table->item(row, 3)->setText(QString::fromLatin1(feed));
        }
        QVERIFY(table->item(0, 4)->text().isEmpty()); // nobody has said it
        table->item(1, 3)->setText(QStringLiteral("quick"));
        QVERIFY(!ok->isEnabled() && dialog->problem().contains(QStringLiteral("row 2, feed")));
        shot(*dialog, QStringLiteral("dialog-tool-feeds"));
        // Rows come and go, and what cannot be read stays to be mended.
        QTest::mouseClick(add, Qt::LeftButton);
        QCOMPARE(table->item(1, 3)->text(), QStringLiteral("quick"));
        QVERIFY(!ok->isEnabled());
        table->setCurrentCell(2, 0);
        QTest::mouseClick(dialog->findChild<QToolButton*>(QStringLiteral("remove_cutting")), Qt::LeftButton);
        QCOMPARE(table->rowCount(), 2);
        table->item(1, 3)->setText(QStringLiteral("20"));
        QVERIFY2(ok->isEnabled(), qPrintable(dialog->problem()));
        QTest::mouseClick(ok, Qt::LeftButton);
        const Project& project = w().document().project();
        QCOMPARE(project.tools[0].cutting.size(), std::size_t(2));
        QCOMPARE(project.tools[0].cutting[0].feed, 90 * 25.4);

        w().tree().select({TreeNode::Kind::operation, 0});
        auto* choice = w().findChild<QPushButton*>(QStringLiteral("cutting_choice"));
        QVERIFY(choice->isVisible());
        QCOMPARE(choice->text(), QStringLiteral("Feeds of the tool"));
        emit choice->menu()->aboutToShow();
        QCOMPARE(choice->menu()->actions().size(), 2);
        choice->menu()->actions().at(1)->trigger();
        QCOMPARE(project.operations[0]->common().spindle, 9000.0);
        QCOMPARE(project.operations[0]->common().feed, 20 * 25.4);
        QVERIFY2(choice->text().contains(QStringLiteral("Brass")), qPrintable(choice->text()));
        shot(w(), QStringLiteral("window-feeds"));
        w().document().undo_stack().undo();
        QCOMPARE(choice->text(), QStringLiteral("Feeds of the tool"));
        // A new tool like the last one is not run like it.
        QCoreApplication::sendPostedEvents(nullptr,
                                           QEvent::DeferredDelete); // the new one may lie where it lay
        QVERIFY(!w().findChild<ui::ToolDialog*>());
        w().tree().add_tool_action()->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(w().findChild<ui::ToolDialog*>(), patience_ms);
        QVERIFY(w().findChild<ui::ToolDialog*>()->tool().cutting.empty());
        w().findChild<ui::ToolDialog*>()->reject();
        w().tree().select({TreeNode::Kind::stock, 0});
        QVERIFY(!choice->isVisible());
    }

    /// From the menu, with nothing kept yet; then tools kept, imported, found, added and exported.
    void tool_library() {
        const QTemporaryDir data;
        const QByteArray before = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", data.path().toUtf8());
        const auto as_before = qScopeGuard(
            [&before] { before.isEmpty() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", before); });
        QVERIFY(open_part());
        w().tree().tool_library_action()->trigger();
        auto* dialog = w().findChild<ui::ToolLibraryDialog*>();
        QVERIFY(dialog && activate(*dialog));
        auto* table = dialog->findChild<QTableWidget*>(QStringLiteral("tools"));
        auto* add = dialog->findChild<QPushButton*>(QStringLiteral("add"));
        auto* told = dialog->findChild<QLabel*>(QStringLiteral("told"));
        auto* remarks = dialog->findChild<QPlainTextEdit*>(QStringLiteral("remarks"));
        QCOMPARE(table->rowCount(), 0);
        QVERIFY(!add->isEnabled() && !dialog->findChild<QPushButton*>(QStringLiteral("export"))->isEnabled());
        shot(*dialog, QStringLiteral("dialog-library-empty"));

        QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("keep")), Qt::LeftButton);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(table->rowCount(), int(w().document().project().tools.size()));
        const QString file = data.path() + QStringLiteral("/Shop of a neighbour.json");
        QFile json(file);
        QVERIFY(json.open(QIODevice::WriteOnly));
        json.write(R"({"data": [
            {"type": "ball end mill", "unit": "inches", "description": "1/4 ball", "BMC": "carbide",
             "geometry": {"DC": 0.25, "LCF": 0.75, "LB": 1.5, "SFDM": 0.25, "NOF": 2}, "post-process": {"number": 1},
             "start-values": {"presets": [{"name": "Wood", "n": 18000, "v_f": 90, "tool-coolant": "flood"}]}},
            {"type": "flat end mill", "unit": "inches", "description": "1/2 flat, the long one that nobody likes to use",
             "BMC": "hss", "geometry": {"DC": 0.5, "LCF": 2, "LB": 4, "SFDM": 0.5, "NOF": 4},
             "post-process": {"number": 2}},
            {"type": "thread mill", "description": "1/4-20", "geometry": {"DC": 0.2}}]})");
        json.close();
        dialog->import_file(file);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(table->rowCount(), int(w().document().project().tools.size()) + 2);
        QVERIFY(remarks->isVisible() && remarks->toPlainText().contains(QStringLiteral("thread mill"))
                && remarks->toPlainText().contains(QStringLiteral("tool-coolant")));
        shot(*dialog, QStringLiteral("dialog-library"));

        auto* filter = dialog->findChild<QLineEdit*>(QStringLiteral("filter"));
        type_over(filter, QStringLiteral("hss"));
        QCOMPARE(table->rowCount(), 1);
        type_over(filter, QStringLiteral("nothing of the kind"));
        QCOMPARE(table->rowCount(), 0);
        QVERIFY(dialog->findChild<QLabel*>(QStringLiteral("empty"))->isVisible());
        type_over(filter, QStringLiteral("neighbour"));
        QCOMPARE(table->rowCount(), 2);
        table->selectAll();
        QVERIFY(add->isEnabled());
        QTest::mouseClick(add, Qt::LeftButton);
        const auto& tools = w().document().project().tools;
        QCOMPARE(tools.size(), std::size_t(3));
        std::set<long> numbers;
        for (const Tool& tool : tools)
            numbers.insert(tool.number);
        QCOMPARE(numbers.size(), tools.size());
        QVERIFY(std::any_of(tools.begin(), tools.end(), [](const Tool& t) { return t.name == "1/4 ball"; }));
        w().document().undo_stack().undo();
        QCOMPARE(w().document().project().tools.size(), std::size_t(1));

        const QString out = data.path() + QStringLiteral("/out.tbl");
        dialog->export_to(out);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(QFile::exists(out), qPrintable(told->text() + remarks->toPlainText()));
        QVERIFY(remarks->toPlainText().contains(QStringLiteral("not carried")));
        dialog->import_file(data.path() + QStringLiteral("/missing.json"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(told->text().contains(QStringLiteral("Nothing")));
        dialog->resize(520, 300);
        shot(*dialog, QStringLiteral("dialog-library-small"));
        // A holder alone is for the tools of the project.
        QFile holder(data.path() + QStringLiteral("/BT30.fcholder"));
        QVERIFY(holder.open(QIODevice::WriteOnly));
        holder.write(R"({"name": "BT30", "units": "mm", "profile": [[15, 0], [22, 12], [22, 32]]})");
        holder.close();
        dialog->import_file(holder.fileName());
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(told->text().contains(QStringLiteral("holders")), qPrintable(told->text()));
        dialog->reject();
        w().tree().select({TreeNode::Kind::tool, 0});
        w().tree().edit_action()->trigger();
        auto* edited = w().findChild<ui::ToolDialog*>();
        QVERIFY(edited);
        auto* menu = edited->findChild<QToolButton*>(QStringLiteral("library_holder"))->menu();
        emit menu->aboutToShow();
        QCOMPARE(menu->actions().size(), 1);
        QCOMPARE(menu->actions().front()->text(), QStringLiteral("BT30"));
        menu->actions().front()->trigger();
        QCOMPARE(edited->tool().holder.size(), std::size_t(7)); // a millimetre a step
        QVERIFY(
            edited->findChild<QLabel*>(QStringLiteral("problem"))->text().contains(QStringLiteral("Cones")));
        QCOMPARE(edited->tool().holder.back().diameter, 44.0);
        edited->reject();
    }
};
FACETMILL_TEST(TestWindow)

#include "test_window.moc"
