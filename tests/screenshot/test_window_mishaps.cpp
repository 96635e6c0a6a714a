// What users do that nobody planned for: other files in the middle of a job, bad places, keys only.
#include "core/output/post/post.h"
#include "core/setup/machine.h"
#include "tests/screenshot/window_support.h"
#include "ui/cspace_controller.h"
#include "ui/inspection_controller.h"
#include "ui/message_bar.h"
#include "ui/parameter_form.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/text.h"
#include "ui/tool_dialog.h"
#include "ui/unrolled_controller.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include <functional>
#include <map>
#include <memory>

using namespace facetmill;
using namespace facetmill::test;
using ui::OperationState;
using ui::TreeNode;

class TestWindowMishaps : public QObject, private WindowFixture {
    Q_OBJECT

    /// A plan that takes minutes is under way.
    bool start_long_plan() {
        if (!open_part()) return false;
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.00002"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QTest::qWait(100);
        return w().job().running() && w().document().state(0) == OperationState::planning;
    }

    static bool write(const QString& path, const std::string& text) {
        QFile file(path);
        return file.open(QIODevice::WriteOnly)
               && file.write(QByteArray::fromStdString(text)) == qint64(text.size());
    }
    static QByteArray bytes(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void another_file_while_planning() {
        QVERIFY(start_long_plan());
        const QString other =
            write_mesh(scratch_folder(QStringLiteral("other")), QStringLiteral("other.stl"));
        bool asked = false;
        answer_next(QMessageBox::Discard, asked);
        w().open_file(other, LengthUnit::inch);
        QVERIFY(asked);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().windowTitle().startsWith(QStringLiteral("other")));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        QVERIFY(!w().document().result(0)); // nothing of the old plan arrives
        QVERIFY(w().last_failure().isEmpty());
    }

    /// A tolerance with some zeros too many: the form says what planning would take, and planning asks first.
    void a_slip_by_some_zeros() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        auto* hint = w().findChild<QLabel*>(QStringLiteral("properties_hint"));
        QVERIFY(hint && !hint->isVisible());
        enter(w(), "tolerance", QStringLiteral("0.00000001"));
        QVERIFY2(hint->isVisible() && hint->text().contains(QStringLiteral("million points")),
                 qPrintable(hint->text()));
        bool asked = false;
        answer_next(QMessageBox::Cancel, asked);
        w().plan();
        QVERIFY(asked && !w().job().running());
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        enter(w(), "tolerance", QStringLiteral("0.02"));
        QVERIFY(!hint->isVisible());
    }

    void a_bad_file_while_planning() {
        QVERIFY(start_long_plan());
        QFile bad(scratch_folder(QStringLiteral("bad-later")) + QStringLiteral("/bad.stl"));
        QVERIFY(bad.open(QIODevice::WriteOnly));
        bad.write("solid of nothing");
        bad.close();
        bool asked = false;
        answer_next(QMessageBox::Discard, asked);
        w().open_file(bad.fileName());
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("bad.stl")),
                 qPrintable(w().message_bar().message()));
        QVERIFY(w().document().part_is_current()); // what was there is still there, and can be planned
        QVERIFY(activate(w()));                    // without a window manager nobody does after a question
        enter(w(), "tolerance", QStringLiteral("0.03"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
    }

    void closing_while_planning() {
        QVERIFY(start_long_plan());
        bool asked = false;
        answer_next(QMessageBox::Discard, asked);
        w().close();
        QVERIFY(asked);
        QVERIFY(!w().isVisible());
        close_window(); // comes back: the job has ended
    }

    /// With steps in its history that nobody saved: nothing asks it any more.
    void a_document_goes_without_a_word() {
        auto document = std::make_unique<ui::Document>();
        document->change(QStringLiteral("Name"), [](Project& p) { p.tools.emplace_back(); });
        QVERIFY(document->modified());
        int words = 0;
        connect(document.get(), &ui::Document::modified_changed, this, [&] { ++words; });
        document.reset();
        QCOMPARE(words, 0);
    }

    void undo_and_removal_while_planning() {
        QVERIFY(start_long_plan());
        w().tree().duplicate_action()->trigger();
        w().tree().select({TreeNode::Kind::operation, 0});
        w().tree().remove_action()->trigger(); // the one that is being planned
        QCOMPARE(w().document().operation_count(), std::size_t(1));
        QTest::keyClick(&w(), Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&w(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(w().job().running());
        QTest::keyClick(&w(), Qt::Key_Escape);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().operation_count(), std::size_t(1));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        QVERIFY(w().last_failure().isEmpty());
    }

    void a_tool_on_the_screen_does_not_get_into_another_project() {
        QVERIFY(open_part());
        const QString other = write_mesh(scratch_folder(QStringLiteral("late")), QStringLiteral("late.stl"));
        w().document().undo_stack().setClean();
        bool asked = false;
        answer_next(QMessageBox::Discard, asked);
        w().open_file(other, LengthUnit::mm); // takes its time
        QVERIFY(w().job().running());
        w().tree().select({TreeNode::Kind::tool, 0});
        w().tree().edit_action()->trigger();
        QVERIFY(w().findChild<ui::ToolDialog*>());
        // A file dropped on the window behind a question is refused.
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(other)});
        QDragEnterEvent dragged(QPoint(400, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        dragged.ignore();
        QApplication::sendEvent(&w(), &dragged);
        QVERIFY(!dragged.isAccepted());
        QVERIFY(wait_until_settled(w()));
        QTRY_VERIFY_WITH_TIMEOUT(!w().findChild<ui::ToolDialog*>(), patience_ms);
        QVERIFY(w().windowTitle().startsWith(QStringLiteral("late")));
        QVERIFY(!w().document().undo_stack().canUndo());
    }

    void programs_into_a_place_that_cannot_be() {
        QVERIFY(open_and_plan());
        const QString folder = scratch_folder(QStringLiteral("place"));
        QFile file(folder + QStringLiteral("/file"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        w().exports().save_programs(folder + QStringLiteral("/file/programs"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("programs")),
                 qPrintable(w().message_bar().message()));
        QCOMPARE(QDir(folder).entryList(QDir::Files), QStringList(QStringLiteral("file")));
        QCOMPARE(w().document().state(0), OperationState::planned);
        w().resize(800, 600);
        shot(w(), QStringLiteral("window-unwritable"));
    }

    void keys_only() {
        QVERIFY(open_part());
        auto* tree = w().tree().findChild<QTreeWidget*>();
        w().tree().select({TreeNode::Kind::operation, 0});
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_Return);
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(field(w(), "name")));
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("Upper side")); // over the old name
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(first_operation(w()).name, std::string("Upper side"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY(QApplication::focusWidget() != field(w(), "name"));
        w().tree().select({TreeNode::Kind::tool, 0});
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_Return);
        auto* dialog = w().findChild<ui::ToolDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        QTest::keyClick(dialog, Qt::Key_Escape);
        QVERIFY(!dialog->isVisible());
    }

    void double_clicks() {
        QVERIFY(open_and_plan());
        auto* tree = w().tree().findChild<QTreeWidget*>();
        const auto twice = [](QWidget* on, QPoint at) {
            QTest::mouseClick(on, Qt::LeftButton, {}, at);
            QTest::mouseDClick(on, Qt::LeftButton, {}, at);
        };
        for (QTreeWidgetItemIterator it(tree); *it; ++it) {
            twice(tree->viewport(), tree->visualItemRect(*it).center());
            if (auto* dialog = w().findChild<ui::ToolDialog*>()) {
                dialog->reject();
                QTRY_VERIFY_WITH_TIMEOUT(!w().findChild<ui::ToolDialog*>(), patience_ms);
            }
            if ((*it)->childCount() > 0) QVERIFY(!(*it)->isExpanded());
            (*it)->setExpanded(true);
        }
        twice(&w().viewport(), w().viewport().rect().center());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        QCOMPARE(w().document().project().tools.size(), std::size_t(1));
    }

    void help_windows() {
        for (const char* name : {"keys", "about"}) {
            action(w(), name)->trigger();
            auto* box = w().findChild<QMessageBox*>();
            QVERIFY(box && box->isVisible());
            shot(*box, QStringLiteral("dialog-") + QLatin1String(name));
            QTest::keyClick(box, Qt::Key_Escape);
            QTRY_VERIFY_WITH_TIMEOUT(!w().findChild<QMessageBox*>(), patience_ms);
        }
    }

    /// Whatever is exported, by name, by a second name of the same file and through a link.
    void outputs_over_what_was_read() {
        QVERIFY(plan_five_axes());
        const QString folder = scratch_folder(QStringLiteral("inputs"));
        const auto path = [&](const char* name) { return folder + QChar('/') + QLatin1String(name); };
        QVERIFY(write(path("own.json"), find_machine("tarus-tpi-2000").source));
        QVERIFY(write(path("post.json"), find_post("linuxcnc").source));
        QVERIFY(QFile::copy(ui::path_text(w().document().project().part_path()), path("surface.stl")));
        write_block(path("block.stl"), w().document().part()->box);
        w().document().change(QStringLiteral("Files"), [&](Project& p) {
            p.part.file = path("surface.stl").toStdString();
            p.stock.kind = StockSpec::Kind::mesh;
            p.stock.file = path("block.stl").toStdString();
            p.stock.unit = LengthUnit::inch;
            p.machine = path("own.json").toStdString();
        });
        QVERIFY(w().files().save_to(path("job.facetmill")));
        QVERIFY(wait_until_settled(w()));
        QTest::keyClick(&w(), Qt::Key_F6); // plans first
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().verification().model().current() && w().document().complete_plan());
        w().findChild<QDockWidget*>(QStringLiteral("chart_dock"))->toggleViewAction()->trigger();
        QVERIFY(wait_until_settled(w()));

        using Write = std::function<void(const QString&)>;
        const std::map<std::string, Write> outputs{
            {"picture", [&](const QString& to) { w().exports().save_picture(to); }},
            {"sheet", [&](const QString& to) { w().exports().save_sheet(to); }},
            {"chart", [&](const QString& to) { w().inspection().save_picture(to); }},
            {"values", [&](const QString& to) { w().inspection().save_table(to); }},
            {"configuration space", [&](const QString& to) { w().cspace().save_picture(to); }},
            {"postures", [&](const QString& to) { w().cspace().save_table(to); }},
            {"unrolled", [&](const QString& to) { w().unrolled().save_picture(to); }},
            {"project", [&](const QString& to) { w().files().save_to(to); }},
            {"programs", [&](const QString& to) {
                 const QString out = scratch_folder(QStringLiteral("programs"));
                 std::filesystem::create_hard_link(to.toStdString(), (out + "/report.json").toStdString());
                 w().exports().save_programs(out);
             }}};
        QStringList inputs{"surface.stl", "block.stl", "own.json", "job.facetmill"};
        const auto attack = [&](const QString& input, const std::string& what, const Write& output) {
            const QString file = folder + QChar('/') + input;
            const QByteArray before = bytes(file);
            const QString second = path("second"), link = path("link");
            std::filesystem::create_hard_link(file.toStdString(), second.toStdString());
            std::filesystem::create_symlink(file.toStdString(), link.toStdString());
            QStringList fell;
            // All of them ask the same question: one is asked in every way.
            for (const QString& to :
                 what == "picture" ? QStringList{file, second, link} : QStringList{second}) {
                w().message_bar().dismiss();
                output(to);
                if (!wait_until_settled(w())) fell << QStringLiteral("hangs");
                if (!w().message_bar().message().contains(QStringLiteral("is a file that the job reads")))
                    fell << to + QStringLiteral(" is not refused");
                if (bytes(file) != before || bytes(to) != before) fell << to + QStringLiteral(" is written");
            }
            QFile::remove(second);
            QFile::remove(link);
            return fell.isEmpty() ? QByteArray()
                                  : (QString::fromStdString(what) + QStringLiteral(": ")
                                     + fell.join(QStringLiteral(", ")))
                                        .toUtf8();
        };
        for (const auto& [what, output] : outputs) {
            for (const QString& input : inputs) {
                if (what == "project" && input == QStringLiteral("job.facetmill")) continue;
                const QByteArray fell = attack(input, what, output);
                QVERIFY2(fell.isEmpty(), fell.constData());
            }
            // The same goes through where nothing is read.
            const QString free = path("free");
            if (what == "programs") continue;
            if (what != "project") output(free);
            QVERIFY(wait_until_settled(w()));
            QVERIFY2(what == "project" || !bytes(free).isEmpty(), what.c_str());
            QFile::remove(free);
        }
        // The post, which this machine's plan need not have been posted with, and a program that is shown.
        w().document().change(QStringLiteral("Post"),
                              [&](Project& p) { p.programs.post = path("post.json").toStdString(); });
        QVERIFY(write(path("shown.apt"), "PARTNO X\nUNITS/INCHES\nCUTTER/0.5,0.25,0,0.25,0,0,1\nLOADTL/7\n"
                                         "GOTO/0,0,9\nGOTO/1,0,9\nFINI\n"));
        w().files().open_program({path("shown.apt")});
        QVERIFY(wait_until_settled(w()) && w().document().program());
        for (const char* input : {"post.json", "shown.apt"})
            for (const char* what : {"picture", "unrolled", "project"}) {
                const QByteArray fell = attack(QLatin1String(input), what, outputs.at(what));
                QVERIFY2(fell.isEmpty(), fell.constData());
            }
    }
};
FACETMILL_TEST(TestWindowMishaps)

#include "test_window_mishaps.moc"
