// Studies that are worked on elsewhere, from their page: by another computer, where a script stands for ssh,
// and by a cluster, where a script stands for sbatch. With FACETMILL_SLURM=1 in the environment the Slurm
// that is there is used (tests/faults/study_on_slurm begins one).
#include "core/setup/machine.h"
#include "core/study/study_folder.h"
#include "tests/screenshot/window_support.h"
#include "ui/controllers.h"
#include "ui/project_tree.h"
#include "ui/study_chart.h"
#include "ui/study_controller.h"
#include "ui/study_figures.h"
#include "ui/study_form.h"
#include "ui/study_place.h"
#include "ui/study_table.h"
#include "ui/worded.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>

#include <algorithm>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr const char* ssh_script = R"(#!/bin/sh
while [ "$1" = -o ]; do shift 2; done
echo "$1" >>"$(dirname "$0")/hosts"
[ "$1" = nobody ] && exit 255
shift
exec sh -c "$*"
)";

/// Array jobs are done at once; the one that depends on them as soon as who handed it over lets go of the
/// folder.
constexpr const char* sbatch_script = R"(#!/bin/sh
count=0
for word; do
    case $word in
    --array=1-*) count=${word#--array=1-} count=${count%\%*} ;;
    --dependency=*) depends=yes ;;
    esac
    script=$word
done
echo "$script" >>"$(dirname "$0")/jobs"
if [ -n "$depends" ]; then
    (while [ -e "$script" ]; do sleep 0.2; sh "$script" && break; done) >/dev/null 2>&1 </dev/null &
else
    i=0
    while [ $((i += 1)) -le "$count" ]; do SLURM_ARRAY_TASK_ID=$i sh "$script" >/dev/null 2>&1 </dev/null; done
fi
wc -l <"$(dirname "$0")/jobs" | tr -d ' '
)";

QByteArray content_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestWindowStudyPlaces : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("FACETMILL_CLI", FACETMILL_CLI_PROGRAM); }
    void init() {
        path_ = qgetenv("PATH");
        QVERIFY(show_window());
        QVERIFY(open_part());
        folder_ = scratch_folder(QStringLiteral("study-places"));
        w().tree().select({ui::TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.03"));
        QVERIFY(w().files().save_to(folder_ + QStringLiteral("/job.facetmill")));
        QVERIFY(settled());
        study().open();
        ask();
    }
    void cleanup() {
        qputenv("PATH", path_);
        leave_as_found();
    }

    void another_computer_works_by_ssh() {
        put_before_path("ssh", ssh_script);
        choose_place(StudyPlace::Where::here);
        QVERIFY(!host()->isEnabled());
        choose_place(StudyPlace::Where::ssh);
        QVERIFY(host()->isEnabled());
        shot(dialog(), QStringLiteral("study-ssh"));
        QTest::mouseClick(dialog().start_button(), Qt::LeftButton);
        QVERIFY2(!study().running() && dialog().status().contains(QStringLiteral("Name the host")),
                 qPrintable(dialog().status()));
        type_over(host(), QStringLiteral("nobody"));
        study().start();
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("cannot be reached without a password")),
                 qPrintable(dialog().status()));
        type_over(host(), QStringLiteral("user@mill2"));
        study().start();
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("wins")), qPrintable(dialog().status()));
        QVERIFY(content_of(folder_ + QStringLiteral("/bin/hosts")).count("user@mill2\n") >= 7);
        comes_to_the_same_here();
    }

    void a_cluster_works_by_slurm() {
        const bool real = qEnvironmentVariableIsSet("FACETMILL_SLURM");
        if (!real) put_before_path("sbatch", sbatch_script);
        choose_place(StudyPlace::Where::slurm);
        study().start();
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("is with Slurm, jobs")),
                 qPrintable(dialog().status()));
        shot(dialog(), QStringLiteral("study-slurm"));
        // The page looks now and then, until all is there.
        QVERIFY(
            QTest::qWaitFor([&] { return dialog().status().contains(QStringLiteral("wins")); }, patience_ms));
        QVERIFY(settled());
        QVERIFY(study().look()->outcome.lost.empty());
        QVERIFY(QFile::exists(folder_ + QStringLiteral("/job.study/slurm/step-3.tasks")));
        if (!real) QCOMPARE(content_of(folder_ + QStringLiteral("/bin/jobs")).count('\n'), 6); // two a step
        comes_to_the_same_here();
    }

    /// Also where the cluster took what it was given and does nothing with it.
    void stop_lets_go_of_a_cluster() {
        if (qEnvironmentVariableIsSet("FACETMILL_SLURM")) QSKIP("the Slurm that is there does its work");
        put_before_path("sbatch", "#!/bin/sh\necho 17\n");
        choose_place(StudyPlace::Where::slurm);
        study().start();
        QVERIFY(settled());
        QVERIFY(dialog().stop_button()->isEnabled());
        QCOMPARE(standing_of_last(), QStringLiteral("–")); // nobody has looked at it
        QTest::mouseClick(dialog().stop_button(), Qt::LeftButton);
        QVERIFY2(dialog().status().contains(QStringLiteral("scancel")), qPrintable(dialog().status()));
        QVERIFY(dialog().start_button()->isEnabled());
        // A cluster that nobody answers for is not waited for.
        put_before_path("sbatch", "#!/bin/sh\nexec sleep 300\n");
        study().start();
        QVERIFY(study().running());
        QTest::qWait(300);
        QTest::mouseClick(dialog().stop_button(), Qt::LeftButton);
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("Stopped")), qPrintable(dialog().status()));
    }

    /// A study from its file can be worked on elsewhere as well.
    void an_opened_study_has_its_place() {
        put_before_path("ssh", ssh_script);
        study().start();
        study().stop();
        QVERIFY(settled());
        study().open_study(folder_ + QStringLiteral("/job.study.json"));
        QVERIFY(settled());
        dialog().pages()->setCurrentIndex(0);
        QVERIFY(dialog().place()->isVisible());
        choose_place(StudyPlace::Where::ssh);
        type_over(host(), QStringLiteral("mill2"));
        study().start();
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("wins")), qPrintable(dialog().status()));
        QVERIFY(QFile::exists(folder_ + QStringLiteral("/bin/hosts")));
    }

    void machine_stock_and_chords_vary() {
        type_over(values("direction"), QStringLiteral("auto"));
        type_over(values("tolerance"), QStringLiteral("0.03"));
        QVERIFY(!dialog().start_button()->isEnabled());
        type_over(values("chord_tolerance"), QStringLiteral("auto; 0.002"));
        type_over(values("margin"), QStringLiteral("0.5 0.25"));
        QVERIFY(!dialog().start_button()->isEnabled());
        type_over(values("margin"), QStringLiteral("0.5; 1 0.5 0.25"));
        QTreeWidgetItem* machine = nullptr;
        for (int i = 0; i < tree().topLevelItemCount(); ++i)
            for (int k = 0; k < tree().topLevelItem(i)->childCount(); ++k)
                if (tree().topLevelItem(i)->child(k)->text(0) == QStringLiteral("Machine"))
                    machine = tree().topLevelItem(i)->child(k);
        QVERIFY(machine && machine->childCount() > 1);
        const QString label = ui::worded(find_machine("tarus-tpi-2000").label);
        int ticked = 0;
        for (int k = 0; k < machine->childCount(); ++k) {
            QTreeWidgetItem* one = machine->child(k);
            if (one->checkState(0) == Qt::Checked || one->text(0) != label) continue;
            one->setCheckState(0, Qt::Checked);
            ++ticked;
        }
        QCOMPARE(ticked, 1);
        QVERIFY(machine->font(0).bold());
        const QString estimate = dialog().findChild<QLabel*>(QStringLiteral("study_estimate"))->text();
        QVERIFY2(estimate.contains(QStringLiteral("Candidates: 8 to plan")), qPrintable(estimate));
        shot(dialog(), QStringLiteral("study-machine"));
        study().start();
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("wins")), qPrintable(dialog().status()));
        const QByteArray asked = content_of(folder_ + QStringLiteral("/job.study.json"));
        for (const char* place :
             {"\"machine\":", "\"stock.margin\"", "\"operations[Finish].chord_tolerance\""})
            QVERIFY2(asked.contains(place), asked.constData());
        // Each of the eight is another project, and was planned.
        const auto& rows = dialog().front()->figures()->rows;
        QCOMPARE(rows.size(), std::size_t(9));
        QVERIFY(std::all_of(rows.begin() + 1, rows.end(),
                            [](const ui::StudyRow& row) { return !row.same && row.looks[0] == true; }));
    }

private:
    using StudyPlace = ui::StudyPlace;

    bool settled() {
        return QTest::qWaitFor([&] { return !w().busy(); }, patience_ms) && wait_until_settled(w());
    }
    ui::StudyController& study() { return w().controllers().study(); }
    ui::StudyDialog& dialog() { return *study().dialog(); }
    QTreeWidget& tree() { return *dialog().form()->vary(); }
    QLineEdit* host() { return dialog().findChild<QLineEdit*>(QStringLiteral("study_host")); }
    QLineEdit* values(const char* key) {
        return dialog().findChild<QLineEdit*>(QStringLiteral("study_values_") + QLatin1String(key));
    }
    /// Two tolerances, two directions.
    void ask() {
        type_over(values("tolerance"), QStringLiteral("0.02; 0.03"));
        type_over(values("direction"), QStringLiteral("x; y"));
    }
    /// Of the last line of the table.
    QString standing_of_last() {
        const QAbstractItemModel& lines = *dialog().table()->model();
        return lines.index(lines.rowCount() - 1, 1).data().toString();
    }
    void choose_place(StudyPlace::Where where) {
        auto* place = dialog().findChild<QComboBox*>(QStringLiteral("study_place"));
        place->setCurrentIndex(place->findData(int(where)));
    }
    void put_before_path(const char* name, const char* script) {
        QDir(folder_).mkpath(QStringLiteral("bin"));
        QFile file(folder_ + QStringLiteral("/bin/") + QLatin1String(name));
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(script);
        file.setPermissions(file.permissions() | QFileDevice::ExeOwner);
        file.close();
        qputenv("PATH", (folder_ + QStringLiteral("/bin:")).toUtf8() + path_);
    }
    /// The same question worked on by this computer has the same answer, byte by byte.
    void comes_to_the_same_here() {
        // Who worked last writes it behind the values by which the page knows the winner.
        QByteArray elsewhere;
        QVERIFY(QTest::qWaitFor(
            [&] {
                elsewhere = content_of(folder_ + QStringLiteral("/job.study/study.json"));
                return !elsewhere.isEmpty();
            },
            patience_ms));
        QTest::mouseClick(dialog().findChild<QPushButton*>(QStringLiteral("study_new")), Qt::LeftButton);
        QVERIFY(QDir(folder_ + QStringLiteral("/job.study")).removeRecursively());
        ask();
        choose_place(StudyPlace::Where::here);
        study().start();
        QVERIFY(settled());
        QCOMPARE(content_of(folder_ + QStringLiteral("/job.study/study.json")), elsewhere);
    }

    QString folder_;
    QByteArray path_;
};

FACETMILL_TEST(TestWindowStudyPlaces)
#include "test_window_study_places.moc"
