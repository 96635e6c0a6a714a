// Studies on other machines: what is handed to Slurm and ssh, and what comes back. Both are played here;
// tests/faults/study_on_slurm begins a real Slurm.
#include "tests/golden/run_cli.h"
#include "tests/golden/study_job.h"
#include "tests/support/test_runner.h"

#include <QDir>
#include <QFile>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Runs what a job array would run, one after the other.
const char* const playing_sbatch = R"(#!/bin/sh
for word; do
    case $word in --array=*) n=${word#--array=1-} n=${n%%%*} ;; esac
    script=$word
done
case $script in
*-gather.sh) ;;
*) i=1; while [ $i -le $n ]; do SLURM_ARRAY_TASK_ID=$i sh "$script" >/dev/null 2>&1; i=$((i + 1)); done ;;
esac
echo "7;cluster"
)";

/// A program of this name comes before all others while this lives.
class Played {
public:
    Played(const Sandbox& s, const char* name, const char* script) : before_(qgetenv("PATH")) {
        QDir(s.path()).mkpath("played");
        s.write(QString("played/") + name, script);
        QFile::setPermissions(s.path() + "/played/" + name,
                              QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("PATH", (s.path() + "/played:").toUtf8() + before_);
    }
    ~Played() { qputenv("PATH", before_); }
    Played(const Played&) = delete;
    Played& operator=(const Played&) = delete;

private:
    QByteArray before_;
};

} // namespace

class TestStudyPlaces : public QObject {
    Q_OBJECT

    Sandbox job_;
    QByteArray whole_;

private slots:
    void initTestCase() {
        fill_with_study(job_);
        const CliRun here = run_cli({"study", "run", "study.json", "-o", "here"}, job_.path());
        QVERIFY2(here.status == 0, here.err.constData());
        whole_ = bytes_of(job_.path() + "/here/study.json");
    }

    void slurm_is_handed_step_after_step() {
        const Played sbatch(job_, "sbatch", playing_sbatch);
        CliRun run = run_cli({"study", "run", "study.json", "-o", "there", "--on", "slurm"}, job_.path());
        QVERIFY2(run.status == 0, run.err.constData());
        QCOMPARE(json(run.out)["array_job"].toString(), QString("7"));
        QCOMPARE(json(run.out)["looks"].toInt(), 8); // one of the eight is the project as it stands
        QVERIFY(bytes_of(job_.path() + "/there/study.json").isEmpty());
        for (int step = 2; step < 8 && bytes_of(job_.path() + "/there/study.json").isEmpty(); ++step) {
            run = run_cli({"study", "gather", "there"}, job_.path());
            QVERIFY2(run.status == 0, run.err.constData());
        }
        QCOMPARE(bytes_of(job_.path() + "/there/study.json"), whole_);
    }

    void looks_that_never_come_are_lost() {
        const Played sbatch(job_, "sbatch", "#!/bin/sh\necho 8\n");
        CliRun run = run_cli({"study", "run", "study.json", "-o", "never", "--on", "slurm"}, job_.path());
        for (int step = 0; step < 2; ++step) {
            QVERIFY2(run.status == 0, run.err.constData());
            run = run_cli({"study", "gather", "never"}, job_.path());
        }
        QVERIFY2(run.status == 0, run.err.constData());
        run = run_cli({"study", "gather", "never"}, job_.path());
        QCOMPARE(run.code(), QByteArray(""));
        QVERIFY2(run.status == 1 && run.err.contains("3 jobs of Slurm ended without a result"),
                 run.err.constData());
        // They are asked for again by whoever goes on.
        const CliRun here = run_cli({"study", "resume", "never"}, job_.path());
        QVERIFY2(here.status == 0, here.err.constData());
        QCOMPARE(bytes_of(job_.path() + "/never/study.json"), whole_);
    }

    void without_slurm_it_is_told() {
        {
            const Played sbatch(job_, "sbatch", "#!/bin/sh\necho no partition >&2\nexit 1\n");
            const CliRun refused =
                run_cli({"study", "run", "study.json", "-o", "refused", "--on", "slurm"}, job_.path());
            QVERIFY2(refused.status == 1 && refused.err.contains("no partition"), refused.err.constData());
            QVERIFY(!job_.files("refused/slurm").contains("step-1.tasks")); // it was not asked for
        }
        const QByteArray path = qgetenv("PATH");
        qputenv("PATH", "/nowhere");
        const CliRun none =
            run_cli({"study", "run", "study.json", "-o", "none", "--on", "slurm"}, job_.path());
        const CliRun no_ssh =
            run_cli({"study", "run", "study.json", "-o", "none", "--on", "ssh:there"}, job_.path());
        qputenv("PATH", path);
        QCOMPARE(none.code(), QByteArray("not_found"));
        QVERIFY2(none.err.contains("slurm-client"), none.err.constData());
        QCOMPARE(no_ssh.code(), QByteArray("not_found"));
    }

    void workers_begin_by_ssh() {
        const QString folder = "it's there"; // a shell reads it twice
        {
            const Played ssh(job_, "ssh", "#!/bin/sh\n[ \"$5\" = host ] || exit 9\nexec sh -c \"$6\"\n");
            const CliRun run =
                run_cli({"study", "run", "study.json", "-o", folder, "--on", "ssh:host"}, job_.path());
            QVERIFY2(run.status == 0, run.err.constData());
            QCOMPARE(bytes_of(job_.path() + "/" + folder + "/study.json"), whole_);
            const CliRun other = run_cli({"study", "run", "study.json", "-o", "other", "--on", "ssh:host",
                                          "--remote-program", "/nowhere/facetmill-cli"},
                                         job_.path());
            QVERIFY2(other.code() == "not_found" && other.err.contains("/nowhere/facetmill-cli"),
                     other.err.constData());
        }
        {
            // A worker that a signal ended there has the same status as no connection: it is asked again.
            const Played ssh(job_, "ssh", R"(#!/bin/sh
[ "$6" = true ] && exit 0
[ -e ended-3 ] && exec sh -c "$6"
[ -e ended-2 ] && touch ended-3
[ -e ended-1 ] && touch ended-2
touch ended-1
exit 255
)");
            const CliRun ended =
                run_cli({"study", "run", "study.json", "-o", "ended", "--on", "ssh:host"}, job_.path());
            QVERIFY2(ended.status == 0, ended.err.constData());
            QVERIFY(job_.files().contains("ended-3"));
            QCOMPARE(bytes_of(job_.path() + "/ended/study.json"), whole_);
        }
        const Played ssh(job_, "ssh", "#!/bin/sh\nexit 255\n");
        const CliRun away =
            run_cli({"study", "run", "study.json", "-o", "away", "--on", "ssh:host"}, job_.path());
        QVERIFY2(away.code() == "not_found" && away.err.contains("cannot be reached"), away.err.constData());
        QCOMPARE(
            run_cli({"study", "run", "study.json", "-o", "away", "--on", "ssh:-oProxyCommand=x"}, job_.path())
                .status,
            2);
    }

    /// The same file with a byte more is another program: what it would find is not taken.
    void a_node_with_another_version_is_refused() {
        const Played ssh(job_, "ssh", "#!/bin/sh\nexec sh -c \"$6\"\n");
        job_.write("other-cli", bytes_of(FACETMILL_CLI) + "\n");
        const QString other = job_.path() + "/other-cli";
        QFile::setPermissions(other, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        const CliRun run = run_cli(
            {"study", "run", "study.json", "-o", "mixed", "--on", "ssh:host", "--remote-program", other},
            job_.path());
        QCOMPARE(run.code(), QByteArray("newer_version"));
        QVERIFY2(run.err.contains("another program works on this study"), run.err.constData());
        QVERIFY(!job_.files("mixed").contains("study.json"));
        for (const QString& key : job_.files("mixed/candidates"))
            QCOMPARE(job_.files("mixed/candidates/" + key), QStringList("project.facetmill"));
    }
};

FACETMILL_TEST(TestStudyPlaces)
#include "test_study_places.moc"
