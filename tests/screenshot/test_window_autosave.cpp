// Work that is not saved: kept while the window lives, offered when it did not end in order.
#include "tests/screenshot/slow_disk.h"
#include "tests/screenshot/window_support.h"
#include "ui/autosave.h"
#include "ui/inspection_controller.h"
#include "ui/message_bar.h"
#include "ui/own_folders.h"
#include "ui/program_export.h"
#include "ui/project_saving.h"
#include "ui/project_tree.h"
#include "ui/settings.h"
#include "ui/templates.h"
#include "ui/text.h"
#include "ui/tool_library_dialog.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QDirIterator>
#include <QDockWidget>
#include <QFile>
#include <QMap>
#include <QMessageBox>
#include <QStandardPaths>
#include <QTest>
#include <QTimer>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

namespace {

constexpr double edited_tolerance = 0.03, saved_tolerance = 0.02; // in

QString data_folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/autosave");
}

QByteArray bytes_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// What is kept beside the project of that folder.
QStringList kept_beside(const QString& folder) {
    return QDir(folder).entryList({QStringLiteral("*.autosave-*")}, QDir::Files | QDir::Hidden);
}

/// What is kept in the user's data folder, records and all, but for the locks of windows that live.
QStringList kept_at_home() {
    return QDir(data_folder())
        .entryList({QStringLiteral("*.json"), QStringLiteral("*.facetmill")}, QDir::Files | QDir::Hidden);
}

/// Presses a button of the question about unsaved work, and tells what it said.
void answer(QMessageBox::ButtonRole role, QString& said, const QString& picture = {}) {
    QTimer::singleShot(50, qApp, [role, &said, picture] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box || box->objectName() != QLatin1String("unsaved_work")) return;
        said = box->text() + QChar('\n') + box->informativeText();
        if (!picture.isEmpty()) shot(*box, picture);
        for (QAbstractButton* button : box->buttons())
            if (box->buttonRole(button) == role) return button->click();
    });
}

} // namespace

class TestWindowAutosave : public QObject, private WindowFixture {
    Q_OBJECT

    QString folder_;

    QString job() const { return folder_ + QStringLiteral("/job.facetmill"); }
    /// And waits until it is on the disk.
    void keep() {
        w().files().autosave().keep();
        w().files().autosave().finish();
    }
    double tolerance() { return first_operation(w()).tolerance / mm_per_inch; }
    void set_tolerance(double inches) {
        w().document().change(QStringLiteral("Edit"), [inches](Project& p) {
            p.operations[0]->common().tolerance = inches * mm_per_inch;
        });
    }
    /// A project that was saved, and changed since.
    bool save_and_edit(const QString& name) {
        folder_ = scratch_folder(name);
        if (!open_part()) return false;
        set_tolerance(saved_tolerance);
        if (!w().files().save_to(job())) return false;
        set_tolerance(edited_tolerance);
        return true;
    }
    /// The window is gone, and all files are as they were when it was killed: its lock is nobody's any more.
    void kill() {
        QMap<QString, QByteArray> files;
        for (const QString& folder : {data_folder(), folder_}) {
            QDirIterator it(folder, QDir::Files | QDir::Hidden);
            while (it.hasNext())
                if (const QString path = it.next(); !path.endsWith(QStringLiteral(".lock")))
                    files[path] = bytes_of(path);
        }
        close_window();
        for (auto it = files.begin(); it != files.end(); ++it) {
            if (QFile::exists(it.key())) continue;
            QFile file(it.key());
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(it.value()) == it.value().size());
        }
    }

private slots:
    void init() {
        QDir(data_folder()).removeRecursively();
        QVERIFY(show_window());
    }
    void cleanup() {
        close_window();
        // Windows that end in order, as all of these, leave not even a lock.
        if (!QTest::currentTestFailed())
            QVERIFY2(QDir(data_folder()).isEmpty(), qPrintable(kept_at_home().join(QChar(' '))));
    }

    void kept_beside_the_project_and_restored() {
        QVERIFY(save_and_edit(QStringLiteral("named")));
        const QByteArray saved = bytes_of(job());
        QVERIFY(QFile::setPermissions(job(), QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY(kept_beside(folder_).isEmpty());
        keep();
        QCOMPARE(kept_beside(folder_).size(), 1);
        const QString kept = folder_ + QChar('/') + kept_beside(folder_).front();
        QVERIFY(kept.startsWith(folder_ + QStringLiteral("/job.autosave-")));
        // Nobody may read it who may not read the project.
        QVERIFY(!(QFile::permissions(kept) & (QFile::ReadOther | QFile::ReadGroup)));
        const QByteArray bytes = bytes_of(kept);
        keep(); // nothing has changed since
        QCOMPARE(bytes_of(kept), bytes);
        kill();

        QVERIFY(show_window());
        QString said;
        answer(QMessageBox::RejectRole, said, QStringLiteral("dialog-unsaved-work"));
        QVERIFY(!w().files().autosave().offer());
        QVERIFY2(said.contains(QStringLiteral("job.facetmill")), qPrintable(said));
        QVERIFY2(said.contains(QLocale().toString(QFileInfo(kept).lastModified(), QLocale::ShortFormat)),
                 qPrintable(said));
        QVERIFY2(said.contains(QStringLiteral("job.autosave-")), qPrintable(said));
        QVERIFY(!w().document().has_part());
        QCOMPARE(bytes_of(kept), bytes);

        said.clear();
        answer(QMessageBox::AcceptRole, said);
        QVERIFY(w().files().autosave().offer(job()));
        QVERIFY(!said.isEmpty());
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QCOMPARE(tolerance(), edited_tolerance);
        QCOMPARE(ui::path_text(w().document().project().path), job());
        QVERIFY(w().document().modified() && w().document().part_is_current());
        QVERIFY(w().message_bar().message().contains(QStringLiteral("Restored")));
        // Nothing is lost before it is saved: a window that is killed again leaves the same.
        QCOMPARE(bytes_of(job()), saved);
        QCOMPARE(bytes_of(kept), bytes);
        kill();
        QVERIFY(show_window());
        answer(QMessageBox::AcceptRole, said);
        QVERIFY(w().files().autosave().offer());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().files().save());
        w().files().autosave().finish();
        QVERIFY(kept_beside(folder_).isEmpty() && kept_at_home().isEmpty());
        QVERIFY(!w().files().autosave().offer());
    }

    void a_project_without_a_name() {
        QVERIFY(open_part());
        folder_ = scratch_folder(QStringLiteral("unnamed"));
        set_tolerance(edited_tolerance);
        const QString name = w().document().name();
        keep();
        QCOMPARE(kept_at_home().size(), 2); // and the record
        QVERIFY(!(QFile::permissions(data_folder()) & (QFile::ReadOther | QFile::ReadGroup)));
        kill();
        QVERIFY(show_window());
        QString said;
        answer(QMessageBox::AcceptRole, said);
        QVERIFY(w().files().autosave().offer());
        QVERIFY2(said.contains(name) && said.contains(QStringLiteral("never saved")), qPrintable(said));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().name(), name);
        QVERIFY(w().document().project().path.empty());
        QVERIFY(w().document().modified() && w().document().part_is_current());
        QCOMPARE(tolerance(), edited_tolerance);
        QVERIFY(w().files().save_to(job()));
        w().files().autosave().finish();
        QVERIFY(kept_at_home().isEmpty());
    }

    void after_a_while_and_before_planning() {
        QCOMPARE(ui::settings::autosave_interval(), std::chrono::seconds(30));
        QVERIFY(save_and_edit(QStringLiteral("when")));
        w().plan();
        w().files().autosave().finish();
        QCOMPARE(kept_beside(folder_).size(), 1);
        QVERIFY(wait_until_settled(w()));
        const QString kept = folder_ + QChar('/') + kept_beside(folder_).front();
        const QByteArray bytes = bytes_of(kept);
        w().files().autosave().set_interval(std::chrono::milliseconds(50));
        set_tolerance(0.025);
        QCOMPARE(bytes_of(kept), bytes);
        QTRY_VERIFY_WITH_TIMEOUT(bytes_of(kept) != bytes, patience_ms);
        QCOMPARE(kept_beside(folder_).size(), 1);
    }

    void gone_when_saved_undone_or_closed() {
        QVERIFY(save_and_edit(QStringLiteral("gone")));
        const auto kept = [&] {
            keep();
            return kept_beside(folder_).size() == 1 && !kept_at_home().isEmpty();
        };
        const auto nothing = [&] {
            w().files().autosave().finish();
            return kept_beside(folder_).isEmpty() && kept_at_home().isEmpty();
        };
        QVERIFY(kept());
        w().document().undo_stack().undo();
        QVERIFY(nothing());
        w().document().undo_stack().redo();
        QVERIFY(kept());
        QVERIFY(w().files().save());
        QVERIFY(nothing());
        set_tolerance(0.025);
        QVERIFY(kept());
        QVERIFY(w().files().save_to(folder_ + QStringLiteral("/other.facetmill")));
        QVERIFY(nothing());
        set_tolerance(edited_tolerance);
        QVERIFY(kept());
        bool asked = false;
        answer_next(QMessageBox::Discard, asked);
        w().open_file(job());
        QVERIFY(asked && wait_until_settled(w()));
        QVERIFY(nothing());
        set_tolerance(edited_tolerance);
        QVERIFY(kept());
        asked = false;
        answer_next(QMessageBox::Cancel, asked);
        w().close();
        QVERIFY(asked && !nothing()); // it goes on
        answer_next(QMessageBox::Discard, asked);
        w().close();
        QVERIFY(nothing());
    }

    void windows_keep_to_their_own() {
        QVERIFY(save_and_edit(QStringLiteral("several")));
        keep();
        const std::unique_ptr<ui::MainWindow> first = std::move(window_);
        QVERIFY(show_window());
        w().open_file(job());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().files().autosave().offer()); // the first one lives
        set_tolerance(0.025);
        keep();
        QCOMPARE(kept_beside(folder_).size(), 2);
        QVERIFY(w().files().save());
        w().files().autosave().finish();
        QCOMPARE(kept_beside(folder_).size(), 1); // the first one's
        const Project kept =
            load_project((folder_ + QChar('/') + kept_beside(folder_).front()).toStdString());
        QCOMPARE(kept.operations[0]->common().tolerance, edited_tolerance * mm_per_inch);
    }

    void discarded_and_the_next_one_restored() {
        QVERIFY(save_and_edit(QStringLiteral("two")));
        keep();
        kill();
        QVERIFY(show_window());
        w().open_file(job());
        QVERIFY(wait_until_settled(w()));
        set_tolerance(0.025);
        QTest::qWait(20); // later than the first
        keep();
        kill();
        QCOMPARE(kept_beside(folder_).size(), 2);
        // The project was saved again in the meantime.
        const QByteArray saved = bytes_of(job());
        QTest::qWait(20);
        QFile file(job());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(saved) == saved.size());
        file.close();
        QVERIFY(show_window());
        QString first, second;
        answer(QMessageBox::DestructiveRole, first);
        QTimer::singleShot(150, qApp, [&second] { answer(QMessageBox::AcceptRole, second); });
        QVERIFY(w().files().autosave().offer());
        QVERIFY2(first.contains(QStringLiteral("newer")), qPrintable(first));
        QVERIFY(!second.isEmpty() && first != second);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(tolerance(), edited_tolerance); // the older one
        QCOMPARE(kept_beside(folder_).size(), 1);
    }

    void nowhere_beside_the_project() {
        QVERIFY(save_and_edit(QStringLiteral("away")));
        QVERIFY(QDir().rename(folder_, folder_ + QStringLiteral(".away")));
        keep();
        QCOMPARE(kept_at_home().size(), 2);
        QVERIFY(QDir().rename(folder_ + QStringLiteral(".away"), folder_));
        kill();
        QVERIFY(show_window());
        QString said;
        answer(QMessageBox::AcceptRole, said);
        QVERIFY(w().files().autosave().offer());
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(ui::path_text(w().document().project().path), job());
        QVERIFY(w().document().part_is_current()); // its name is relative to the project's folder
        QCOMPARE(tolerance(), edited_tolerance);
        // Neither there: said once, and tried again.
        w().files().autosave().discard();
        w().files().autosave().finish();
        QVERIFY(QDir().rename(folder_, folder_ + QStringLiteral(".away")));
        QDir(data_folder()).removeRecursively();
        QFile in_the_way(data_folder());
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        w().message_bar().dismiss();
        set_tolerance(0.025);
        keep();
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("cannot be kept")),
                 qPrintable(w().message_bar().message()));
        w().message_bar().dismiss();
        set_tolerance(0.026);
        keep();
        QVERIFY(w().message_bar().message().isEmpty());
        QVERIFY(in_the_way.remove());
        QVERIFY(QDir().rename(folder_ + QStringLiteral(".away"), folder_));
        keep();
        QCOMPARE(kept_beside(folder_).size(), 1);
    }

    void a_slow_disk_holds_up_nobody() {
        QVERIFY(save_and_edit(QStringLiteral("slow")));
        ui::ProjectSaving& saving = w().files().saving();
        const auto saved = [&] {
            return load_project(job().toStdString()).operations[0]->common().tolerance / mm_per_inch;
        };
        w().tree().select({TreeNode::Kind::operation, 0});
        StandingDisk disk;
        w().files().autosave().keep();
        action(w(), "save")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(StandingDisk::waiting(), 1, patience_ms);
        // It takes what is typed, and says what it waits for, and that nothing is saved yet.
        enter(w(), "tolerance", QStringLiteral("0.025"));
        QCOMPARE(tolerance(), 0.025);
        QTRY_VERIFY2_WITH_TIMEOUT(w().message_bar().message().contains(QStringLiteral("Saving")),
                                  qPrintable(w().message_bar().message()), patience_ms);
        QVERIFY(saving.busy() && w().document().modified() && w().windowTitle().contains(QChar('*')));
        QCOMPARE(saved(), saved_tolerance);
        // Saved again: the later state is written later. Planning waits for what is kept.
        action(w(), "save")->trigger();
        enter(w(), "tolerance", QStringLiteral("0.035"));
        w().plan();
        QVERIFY(!QTest::qWaitFor([&] { return w().document().all_planned(); }, 200));
        QVERIFY(w().job().running() && saving.busy());
        disk.go_on();
        QTRY_VERIFY_WITH_TIMEOUT(!saving.busy(), patience_ms);
        QCOMPARE(saved(), 0.025);
        QCOMPARE(tolerance(), 0.035);
        QVERIFY(w().document().modified() && w().message_bar().message().isEmpty());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().all_planned());
        w().files().autosave().finish();
        QCOMPARE(kept_beside(folder_).size(), 1);

        // What cannot be written is said, and stays unsaved.
        QVERIFY(saving.save_to(folder_ + QStringLiteral("/none/job.facetmill")));
        QVERIFY(!saving.finish());
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("none/job.facetmill")),
                 qPrintable(w().message_bar().message()));
        QVERIFY(w().document().modified());
        QCOMPARE(ui::path_text(w().document().project().path), job());

        // Closing waits for what was begun, and has nothing to ask then.
        StandingDisk again;
        action(w(), "save")->trigger();
        QTimer::singleShot(50, &w(), [&] { again.go_on(); });
        QVERIFY(w().close());
        QCOMPARE(saved(), 0.035);
    }

    /// Whatever leaves the window is there when the disk goes on, and not before: nobody has waited for it.
    void what_leaves_waits_for_no_disk() {
        QVERIFY(plan_five_axes()); // rotary axes move: there is a chart
        w().findChild<QDockWidget*>(QStringLiteral("chart_dock"))->toggleViewAction()->trigger();
        QVERIFY(wait_until_settled(w()));
        const QString folder = scratch_folder(QStringLiteral("leaves"));
        const auto path = [&](const char* name) { return folder + QChar('/') + QLatin1String(name); };
        ui::ToolLibraryDialog library(w().document(), ui::path_of(path("tools")), &w());
        StandingDisk disk;
        w().templates().save(QStringLiteral("slow"));
        library.keep_project_tools();
        w().exports().save_picture(path("view.png"));
        w().inspection().save_picture(path("chart.png"));
        w().inspection().save_table(path("chart.csv"));
        QTRY_COMPARE_WITH_TIMEOUT(StandingDisk::waiting(), 1, patience_ms);
        QVERIFY(w().busy());
        const QString kept = ui::path_text(ui::own_template_folder() / "slow.fmtemplate");
        const QStringList files{kept, path("view.png"), path("chart.png"), path("chart.csv")};
        for (const QString& file : files)
            QVERIFY2(!QFile::exists(file), qPrintable(file));
        QVERIFY(QDir(path("tools")).isEmpty(QDir::Files));
        disk.go_on();
        QVERIFY(wait_until_settled(w()));
        for (const QString& file : files)
            QVERIFY2(QFile::exists(file), qPrintable(file));
        QVERIFY(!QDir(path("tools")).isEmpty(QDir::Files));
        QFile::remove(kept);
        // The tools that were kept, to be used elsewhere.
        StandingDisk again;
        library.export_to(path("library.json"));
        QTRY_COMPARE_WITH_TIMEOUT(StandingDisk::waiting(), 1, patience_ms);
        QVERIFY(!QFile::exists(path("library.json")));
        again.go_on();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(QFile::exists(path("library.json")));
    }

    void what_cannot_be_read_stays() {
        QVERIFY(save_and_edit(QStringLiteral("broken")));
        keep();
        const QString kept = folder_ + QChar('/') + kept_beside(folder_).front();
        kill();
        QFile file(kept);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{ \"facetmill\": 1, ") > 0);
        file.close();
        QVERIFY(show_window());
        QString said;
        answer(QMessageBox::AcceptRole, said);
        QVERIFY(!w().files().autosave().offer());
        QVERIFY(!said.isEmpty());
        QVERIFY(w().message_bar().message().contains(QStringLiteral("job.autosave-")));
        QVERIFY(!w().document().has_part());
        QCOMPARE(bytes_of(kept), QByteArray("{ \"facetmill\": 1, "));
        answer(QMessageBox::DestructiveRole, said);
        QVERIFY(!w().files().autosave().offer());
        QVERIFY(!QFile::exists(kept));
    }
};

FACETMILL_TEST(TestWindowAutosave)
#include "test_window_autosave.moc"
