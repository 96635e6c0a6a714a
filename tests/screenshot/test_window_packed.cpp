// Packed projects in the window: a copy is saved, asked where to unpack it, and opened from there.
#include "core/base/archive.h"
#include "core/base/file.h"
#include "tests/screenshot/window_support.h"
#include "ui/settings.h"
#include "ui/text.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

class TestWindowPacked : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void a_copy_is_packed_and_opened_elsewhere() {
        QVERIFY(!action(w(), "save_packed")->isEnabled());
        QVERIFY(open_part());
        const QString folder = scratch_folder(QStringLiteral("packed"));
        QVERIFY(w().files().save_to(folder + QStringLiteral("/job.facetmill")));
        const QString sent = folder + QStringLiteral("/sent.facetmill");
        bool asked = false;
        answer_file_dialog(asked); // Cancel
        action(w(), "save_packed")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(asked && !QFile::exists(sent));
        w().files().save_packed_to(sent);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(QFile::exists(sent), qPrintable(w().message_bar().message()));
        QVERIFY(!w().document().modified());
        QCOMPARE(ui::path_text(w().document().project().path), folder + QStringLiteral("/job.facetmill"));
        const std::string packed = project_to_json(load_project(ui::path_of(sent)));
        QVERIFY(!ui::settings::recent_files().contains(sent));

        // Given up, everything stays as it was.
        w().open_file(sent);
        QVERIFY(wait_until_settled(w()));
        auto* dialog = unpack_dialog();
        QVERIFY(dialog);
        auto* line = dialog->findChild<QLineEdit*>(QStringLiteral("unpack_folder"));
        QCOMPARE(line->text(), folder + QStringLiteral("/sent"));
        shot(w(), QStringLiteral("window-unpack"));
        shot(*dialog, QStringLiteral("dialog-unpack"));
        dialog->reject();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!QDir(folder + QStringLiteral("/sent")).exists());
        QCOMPARE(ui::path_text(w().document().project().path), folder + QStringLiteral("/job.facetmill"));

        // Never over what is there.
        QVERIFY(QDir(folder).mkdir(QStringLiteral("sent")));
        w().open_file(sent);
        QVERIFY(wait_until_settled(w()));
        dialog = unpack_dialog();
        QVERIFY(dialog);
        line = dialog->findChild<QLineEdit*>(QStringLiteral("unpack_folder"));
        QCOMPARE(line->text(), folder + QStringLiteral("/sent-2"));
        auto* button = dialog->findChild<QPushButton*>(QStringLiteral("unpack"));
        line->setText(folder);
        QVERIFY(!button->isEnabled());
        QVERIFY(!dialog->findChild<QLabel*>(QStringLiteral("unpack_trouble"))->text().isEmpty());
        line->setText(folder + QStringLiteral("/deep/there"));
        QVERIFY(button->isEnabled());
        button->click();
        QVERIFY(wait_until_settled(w()));
        const QString project = folder + QStringLiteral("/deep/there/job.facetmill");
        QCOMPARE(ui::path_text(w().document().project().path), project);
        QVERIFY(w().document().part_is_current());
        QVERIFY(!w().document().modified());
        QCOMPARE(project_to_json(w().document().project()), packed);
        QCOMPARE(ui::settings::recent_files().front(), project);
        QVERIFY(!ui::settings::recent_files().contains(sent));
    }

    void what_cannot_be_unpacked_is_told() {
        QVERIFY(open_part());
        const QString folder = scratch_folder(QStringLiteral("packed-bad"));
        const QString sent = folder + QStringLiteral("/sent.facetmill");
        w().files().save_packed_to(sent);
        QVERIFY(wait_until_settled(w()));
        std::string bytes(InputFile(ui::path_of(sent)).bytes());
        bytes.resize(bytes.size() / 2);
        for (const std::string& bad : {bytes, archive_bytes({{"a.stl", "x"}})}) {
            QFile file(sent);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bad.data(), qint64(bad.size()));
            file.close();
            bool discarded = false;
            answer_next(QMessageBox::Discard, discarded);
            w().open_file(sent);
            QVERIFY(wait_until_settled(w()));
            QVERIFY(unpack_dialog());
            unpack_dialog()->accept();
            QVERIFY(wait_until_settled(w()));
            QVERIFY2(w().message_bar().message().contains(QStringLiteral("sent.facetmill: ")),
                     qPrintable(w().message_bar().message()));
            QVERIFY(w().document().has_part()); // that of before
            QVERIFY(!QDir(folder + QStringLiteral("/sent")).exists());
        }
        // Over the part that it packs.
        const QString part = ui::path_text(w().document().project().part_path());
        w().message_bar().dismiss();
        w().files().save_packed_to(part);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!w().message_bar().message().isEmpty());
        QVERIFY(QFile(part).size() > 1000);
    }

private:
    QDialog* unpack_dialog() {
        for (auto* dialog : w().findChildren<QDialog*>(QStringLiteral("unpack_dialog")))
            if (dialog->isVisible()) return dialog;
        return nullptr;
    }
};

FACETMILL_TEST(TestWindowPacked)
#include "test_window_packed.moc"
