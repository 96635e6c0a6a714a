// Files in and out of the window: opening, asking, dropping, saving, exporting, and what is refused.
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "core/output/apt.h"
#include "tests/screenshot/window_support.h"
#include "ui/dropped_files.h"
#include "ui/part_dialog.h"
#include "ui/playback_controller.h"
#include "ui/project_files.h"
#include "ui/project_tree.h"
#include "ui/report_view.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using ui::OperationState;
using ui::TreeNode;

class TestWindowFiles : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void bad_files_are_refused() {
        const QString folder = scratch_folder(QStringLiteral("bad"));
        const auto write = [&](const char* name, const QByteArray& bytes) {
            QFile f(folder + QChar('/') + QLatin1String(name));
            if (!f.open(QIODevice::WriteOnly)) return QString();
            f.write(bytes);
            return f.fileName();
        };
        for (const QString& path :
             {write("empty.stl", {}), write("text.stl", "hello"),
              write("picture.stl", "\x89PNG\r\n\x1a\n0000"), folder + QStringLiteral("/missing.stl"), folder,
              write("broken.facetmill", "{ \"facetmill\": 1, "),
              write("wrong.facetmill", "{ \"facetmill\": 1, \"units\": \"in\", \"colour\": 3 }")}) {
            w().message_bar().dismiss();
            w().open_file(path);
            QVERIFY(wait_until_settled(w()));
            QVERIFY2(!w().message_bar().message().isEmpty(), qPrintable(path));
            QVERIFY(!w().message_bar().message().contains(QChar('\n')));
            QVERIFY(!w().document().has_part());
            QVERIFY(QApplication::activeModalWidget() == nullptr);
        }
        QVERIFY(ui::settings::recent_files().filter(QStringLiteral("/bad/")).isEmpty());
    }

    void the_unit_of_a_mesh_is_asked() {
        const QString path = write_mesh(scratch_folder(QStringLiteral("ask")));
        w().open_file(path);
        QVERIFY(wait_until_settled(w()));
        auto* dialog = w().findChild<ui::PartDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        QVERIFY(!w().document().has_part());
        QString all;
        for (const auto* label : dialog->findChildren<QLabel*>())
            all += label->text() + QChar('\n');
        QVERIFY2(all.contains(QStringLiteral(" mm")) && all.contains(QStringLiteral(" in")), qPrintable(all));
        shot(*dialog, QStringLiteral("dialog-unit"));
        auto* inches = dialog->findChild<QRadioButton*>(QStringLiteral("unit_inch"));
        QTest::mouseClick(inches, Qt::LeftButton, {}, QPoint(8, inches->height() / 2));
        dialog->findChild<QCheckBox*>()->setChecked(true);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                          Qt::LeftButton);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().has_part());
        QCOMPARE(w().document().unit(), LengthUnit::inch);
        const double width_inch = w().document().part()->box.size().x();
        // Asked not to ask again, it does not; and the size is 25.4 times that in millimetres.
        w().open_file(path); // nothing is lost with what was only opened
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().findChild<ui::PartDialog*>());
        QCOMPARE(w().document().part()->box.size().x(), width_inch);
        w().open_file(path, LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(std::abs(w().document().part()->box.size().x() * 25.4 - width_inch) < 1e-6 * width_inch);
        // A scan in metres becomes a project in millimetres.
        const QString scan = write_mesh(scratch_folder(QStringLiteral("scan")));
        w().open_file(scan);
        QVERIFY(wait_until_settled(w()));
        dialog = w().findChild<ui::PartDialog*>();
        QVERIFY(dialog);
        dialog->findChild<QRadioButton*>(QStringLiteral("unit_m"))->click();
        dialog->accept();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().unit(), LengthUnit::mm);
        QCOMPARE(w().document().project().part.unit, LengthUnit::m);
        QVERIFY(std::abs(w().document().part()->box.size().x() * 25.4 - 1000 * width_inch)
                < 1e-6 * 1000 * width_inch);
    }

    void drag_and_drop() {
        const QString path = write_mesh(scratch_folder(QStringLiteral("drop")));
        ui::settings::remember_unit(path, LengthUnit::inch);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        const QPoint at = w().viewport().mapTo(&w(), w().viewport().rect().center());
        QDragEnterEvent enter_event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&w(), &enter_event);
        QVERIFY(enter_event.isAccepted());
        QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&w(), &drop);
        QVERIFY(drop.isAccepted());
        QTRY_VERIFY_WITH_TIMEOUT(w().busy() || w().document().has_part(), patience_ms);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().has_part());
        QCOMPARE(ui::settings::recent_files().value(0), path);
        // What is no part says so, and what is shown stays; no question is asked about it.
        const auto drop_files = [&](const QStringList& paths) {
            QMimeData files;
            QList<QUrl> urls;
            for (const QString& file : paths)
                urls << QUrl::fromLocalFile(file);
            files.setUrls(urls);
            QDragEnterEvent entering(at, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&w(), &entering);
            QVERIFY(entering.isAccepted());
            QDropEvent dropping(at, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
            w().message_bar().dismiss();
            QApplication::sendEvent(&w(), &dropping);
            QTRY_VERIFY_WITH_TIMEOUT(!w().message_bar().message().isEmpty(), patience_ms);
            QVERIFY(wait_until_settled(w()));
        };
        const QString folder = QFileInfo(path).path(), picture = folder + QStringLiteral("/photo.bmp");
        QVERIFY(w().viewport().grab().save(picture));
        const auto* part = w().document().part().get();
        drop_files({picture});
        QVERIFY(w().message_bar().message().contains(QStringLiteral("“photo.bmp” is a picture")));
        shot(w(), QStringLiteral("window-dropped-picture"));
        drop_files({folder});
        QVERIFY(w().message_bar().message().contains(QStringLiteral("is a folder")));
        drop_files({path, write_mesh(folder, QStringLiteral("other.stl"))});
        QVERIFY(
            w().message_bar().message().contains(QStringLiteral("“other.stl”; there is one part at a time")));
        QCOMPARE(w().document().part().get(), part);
        QVERIFY(!w().last_failure().size());
        // A program is shown over the part, as by the menu; without a part it waits for one.
        bool asked = false;
        answer_next(QMessageBox::Discard, asked);
        action(w(), "sample_convex")->trigger();
        QVERIFY(wait_until_settled(w()));
        w().plan();
        QVERIFY(wait_until_settled(w()));
        w().exports().save_programs(folder);
        QVERIFY(wait_until_settled(w()));
        const QStringList programs = QDir(folder).entryList({QStringLiteral("*.apt")});
        QVERIFY2(!programs.isEmpty(), qPrintable(w().message_bar().message()));
        drop_files({folder + QLatin1Char('/') + programs.front()});
        QVERIFY(w().document().program());
        const ui::DroppedFiles waits = ui::sort_dropped({programs.front()}, false);
        QVERIFY(waits.programs.isEmpty() && waits.open.isEmpty()
                && waits.refusal.contains(QStringLiteral("open the project")));
        QCOMPARE(ui::sort_dropped({QStringLiteral("a.stl"), QStringLiteral("a.facetmill")}, true).open,
                 QStringLiteral("a.facetmill"));
        QMimeData text;
        text.setText(QStringLiteral("no file"));
        QDragEnterEvent refused(at, Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
        refused.ignore();
        QApplication::sendEvent(&w(), &refused);
        QVERIFY(!refused.isAccepted());
    }

    void save_open_and_export() {
        const QString folder = scratch_folder(QStringLiteral("job"));
        action(w(), "sample_convex")->trigger();
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));

        w().exports().save_programs(folder); // nothing is planned
        QVERIFY(w().message_bar().message().contains(QStringLiteral("Plan")));
        QVERIFY(QDir(folder).isEmpty());

        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().files().save_to(folder + QStringLiteral("/job.facetmill")));
        QVERIFY(!w().document().modified());
        QVERIFY(w().windowTitle().startsWith(QStringLiteral("job.facetmill –")));
        QVERIFY(QFile::exists(folder + QStringLiteral("/convex.stl"))); // the sample came along
        QCOMPARE(w().document().project().part.file, std::string("convex.stl"));
        QCOMPARE(w().document().state(0), OperationState::planned); // saving makes nothing stale
        QVERIFY(w().document().part_is_current());

        w().exports().save_programs(folder + QStringLiteral("/out"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        const QStringList written = QDir(folder + QStringLiteral("/out")).entryList(QDir::Files);
        QCOMPARE(written, QStringList({QStringLiteral("01-Finish.apt"), QStringLiteral("report.json")}));
        const auto read =
            read_apt((folder + QStringLiteral("/out/01-Finish.apt")).toStdString(), LengthUnit::inch, {});
        QCOMPARE(read.program.sections.at(0)->motions.motions.size(),
                 w().document().result(0)->program.motions.motions.size());

        // Exported after a change, a program would not be that of the project.
        enter(w(), "tolerance", QStringLiteral("0.03"));
        QVERIFY(w().windowTitle().startsWith(QStringLiteral("job.facetmill* –")));
        w().exports().save_programs(folder + QStringLiteral("/late"));
        QVERIFY(!w().job().running());
        QVERIFY(!QFile::exists(folder + QStringLiteral("/late")));

        w().exports().save_picture(folder + QStringLiteral("/view.png"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(QImage(folder + QStringLiteral("/view.png")).size(),
                 w().viewport().size() * w().viewport().devicePixelRatioF());
        w().exports().save_picture(folder + QStringLiteral("/no/such/folder.png"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("folder.png")));

        bool asked = false;
        answer_next(QMessageBox::Cancel, asked);
        w().open_file(folder + QStringLiteral("/job.facetmill"));
        QVERIFY(asked);
        QCOMPARE(first_operation(w()).tolerance, 0.03 * 25.4); // nothing was thrown away
        asked = false;
        answer_next(QMessageBox::Discard, asked);
        w().open_file(folder + QStringLiteral("/job.facetmill"));
        QVERIFY(asked);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(first_operation(w()).tolerance, 0.02 * 25.4);
        QVERIFY(w().document().part_is_current());
        QVERIFY(!w().document().modified());
        // Writing into a place that cannot be.
        QVERIFY(!w().files().save_to(folder + QStringLiteral("/nowhere/job.facetmill")));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("nowhere")));
    }

    /// A program from elsewhere is shown, played back and verified, and nothing is planned.
    void a_program_from_a_file() {
        QVERIFY(open_part());
        const QString folder = scratch_folder(QStringLiteral("program"));
        const Box3 box = w().document().part()->box;
        const double per = 25.4;
        QByteArray apt = "PARTNO X\nUNITS/INCHES\nCUTTER/0.5,0.25,0,0.25,0,0,1\nLOADTL/7\nRAPID\n";
        std::size_t gotos = 0;
        const auto go = [&](double x, double y, double z) {
            apt += QStringLiteral("GOTO/%1,%2,%3\n").arg(x / per).arg(y / per).arg(z / per).toUtf8();
            ++gotos;
        };
        go(box.lo.x(), box.lo.y(), box.hi.z() + 20);
        for (int row = 0; row <= 8; ++row) {
            const double y = box.lo.y() + row / 8.0 * box.size().y();
            go(row % 2 == 0 ? box.lo.x() : box.hi.x(), y, box.hi.z());
            go(row % 2 == 0 ? box.hi.x() : box.lo.x(), y, box.hi.z());
        }
        QFile file(folder + QStringLiteral("/other.apt"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(apt + "FINI\n") > 0);
        file.close();

        QVERIFY(!action(w(), "close_program")->isEnabled());
        w().files().open_program({file.fileName()});
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY(w().document().program() && w().viewport().scene().has(Layer::cl));
        QCOMPARE(w().document().state(0), OperationState::not_planned);
        QVERIFY(w().report().toPlainText().contains(QStringLiteral("other.apt")));
        QVERIFY(!action(w(), "export")->isEnabled()); // it is a file already
        ui::VerificationController& verification = w().verification();
        QVERIFY(verification.playback().loaded());
        QCOMPARE(verification.playback().track().motion_count(), gotos);
        verification.playback().go_to(double(gotos));
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("opened-program"));
        QTest::keyClick(&w(), Qt::Key_F6);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(verification.model().any() && verification.model().current());
        QCOMPARE(verification.model().verdict(), ui::Verdict::failed); // far above the part
        QCOMPARE(w().document().state(0), OperationState::not_planned);

        action(w(), "close_program")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().document().program() && !verification.playback().loaded());
        QVERIFY(!w().viewport().scene().has(Layer::cl));
        QCOMPARE(verification.model().verdict(), ui::Verdict::stale);
        w().files().open_program({folder + QStringLiteral("/none.apt")});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("none.apt")));
        QVERIFY(!w().document().program());

        // What is planned takes its place.
        w().files().open_program({file.fileName()});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().program());
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().document().program());
        QCOMPARE(w().document().state(0), OperationState::planned);
    }

    /// Part and machine are files that others may write, too.
    void files_that_change_on_disk() {
        const QString folder = scratch_folder(QStringLiteral("changing"));
        const auto write = [&](const char* name, const std::string& text) {
            QFile f(folder + QChar('/') + QLatin1String(name));
            return f.open(QIODevice::WriteOnly)
                   && f.write(QByteArray::fromStdString(text)) == qint64(text.size());
        };
        const std::string machine = find_machine("generic-3-axis").source;
        QVERIFY(write("own.json", machine));
        QVERIFY(open_part());
        QVERIFY(w().files().save_to(folder + QStringLiteral("/job.facetmill")));
        w().document().change(QStringLiteral("Own machine"), [](Project& p) { p.machine = "own.json"; });
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.02"));
        const auto plan = [&] {
            QTest::keyClick(&w(), Qt::Key_F5);
            return wait_until_settled(w()) && w().document().state(0) == OperationState::planned;
        };
        QVERIFY(plan());
        QSignalSpy states(&w().document(), &ui::Document::states_changed);
        QVERIFY(write("own.json", machine + "\n"));
        QTRY_VERIFY_WITH_TIMEOUT(states.count() > 0, patience_ms); // the window hears of it by itself
        QCOMPARE(w().document().state(0), OperationState::stale);
        QVERIFY(plan());

        const QString part = ui::path_text(w().document().project().part_path());
        const std::size_t facets = w().document().part()->mesh->facets.size();
        save_stl(*make_sample("convex", 0.05, {}), part.toStdString(), LengthUnit::inch, {});
        QTRY_VERIFY_WITH_TIMEOUT(w().document().part()->mesh->facets.size() != facets, patience_ms);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().part_is_current());
        QCOMPARE(w().document().state(0), OperationState::stale);
        QVERIFY(plan());
        // Gone: said, and what was read stays in sight.
        QVERIFY(QFile::rename(part, part + QStringLiteral(".away")));
        QTRY_VERIFY_WITH_TIMEOUT(!w().message_bar().message().isEmpty(), patience_ms);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().viewport().scene().has(Layer::part));
        QCOMPARE(w().document().state(0), OperationState::stale);
        // Back: as before.
        QVERIFY(QFile::rename(part + QStringLiteral(".away"), part));
        QTRY_COMPARE_WITH_TIMEOUT(w().document().state(0), OperationState::planned, patience_ms);
    }

    void closing_asks_for_unsaved_changes() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.03"));
        bool asked = false;
        answer_next(QMessageBox::Cancel, asked);
        w().close();
        QVERIFY(asked);
        QVERIFY(w().isVisible());
        // What was planned of a part that is nowhere saved, too, without any change.
        w().document().undo_stack().undo();
        QVERIFY(!w().document().modified());
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().modified());
        asked = false;
        answer_next(QMessageBox::Discard, asked);
        w().close();
        QVERIFY(asked);
        QVERIFY(!w().isVisible());
    }

    void what_was_only_opened_is_not_asked_about() {
        QVERIFY(open_part());
        QVERIFY(!w().document().modified());
        w().close();
        QVERIFY(!w().isVisible());
    }
};
FACETMILL_TEST(TestWindowFiles)

#include "test_window_files.moc"
