// Studies on the command line: workers as processes, killed at any time, and what comes of it.
#include "tests/golden/run_cli.h"
#include "tests/golden/study_job.h"
#include "tests/support/test_runner.h"

#include <QDir>
#include <QJsonArray>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include <csignal>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// The machining time of "winner" or "project".
double time_of(const QByteArray& text, const char* which) {
    const QJsonObject measures = json(text)[which].toObject()["measures"].toObject();
    return measures["machining_time"].toDouble();
}

} // namespace

class TestStudyCommand : public QObject {
    Q_OBJECT
private slots:
    void the_answer_does_not_depend_on_workers_or_kills() {
        Sandbox s;
        fill_with_study(s);
        const CliRun one = run_cli({"study", "run", "study.json", "--workers", "1", "-o", "one"}, s.path());
        QVERIFY2(one.status == 0, one.err.constData());
        const QByteArray whole = bytes_of(s.path() + "/one/study.json");
        QCOMPARE(json(whole)["all"].toArray().size(), 9);
        QVERIFY(json(one.out)["winner"].isObject());
        QVERIFY(time_of(one.out, "winner") > 0 && time_of(one.out, "winner") < time_of(one.out, "project"));
        const CliRun two = run_cli({"study", "run", "study.json", "--workers", "2", "-o", "two"}, s.path());
        QCOMPARE(two.out, one.out);
        QCOMPARE(bytes_of(s.path() + "/two/study.json"), whole);
        QCOMPARE(bytes_of(s.path() + "/two/table.md"), bytes_of(s.path() + "/one/table.md"));

        // Killed again and again, at any time; what was found stays found.
        std::mt19937 random(3);
        int found = 0;
        for (int kill = 0; kill < 10; ++kill) {
            const int after = std::uniform_int_distribution<int>(5, 30 * (kill + 1))(random);
            run_cli_and_signal({"study", "run", "study.json", "--workers", "2"}, s.path(), SIGKILL, after);
            int now = 0;
            for (const QString& key : s.files("study.study/candidates"))
                now += int(s.files("study.study/candidates/" + key)
                               .filter(QRegularExpression("^[efc].*json$"))
                               .size());
            QVERIFY2(now >= found, "what had been found was lost");
            found = now;
        }
        const CliRun run = run_cli({"study", "run", "study.json"}, s.path());
        QVERIFY2(run.status == 0, run.err.constData());
        QCOMPARE(bytes_of(s.path() + "/study.study/study.json"), whole);
        // It is known already, and the winner is a project that is planned.
        const CliRun shown = run_cli({"study", "show", "study.study"}, s.path());
        QCOMPARE(shown.out, whole);
        const CliRun adopted = run_cli({"study", "adopt", "study.study", "-o", "best.facetmill"}, s.path());
        QVERIFY2(adopted.status == 0, adopted.err.constData());
        const CliRun plan = run_cli({"plan", "best.facetmill", "-o", "plan"}, s.path());
        QVERIFY2(plan.status == 0, plan.err.constData());
        QCOMPARE(json(plan.out)["operations"].toArray()[0].toObject()["time_seconds"].toDouble(),
                 time_of(whole, "winner"));
    }

    void what_goes_wrong_is_told() {
        Sandbox s;
        fill_with_study(s);
        QCOMPARE(run_cli({"study", "run", "none.json"}, s.path()).code(), QByteArray("not_found"));
        QCOMPARE(run_cli({"study", "walk", "study.json"}, s.path()).status, 2);
        QCOMPARE(run_cli({"study", "run", "study.json", "--on", "moon"}, s.path()).status, 2);
        QCOMPARE(run_cli({"study", "run", "study.json", "-o", "job.facetmill"}, s.path()).code(),
                 QByteArray("unwritable"));
        // A limit that none meets.
        s.write("hard.json", QByteArray(study_text).replace("\"excess_p95\": 0.5", "\"excess_p95\": 0.01"));
        const CliRun hard = run_cli({"study", "run", "hard.json"}, s.path());
        QCOMPARE(hard.status, 1);
        QVERIFY2(hard.err.contains("nearest comes") && hard.err.contains("at most 0.01 is allowed"),
                 hard.err.constData());
        QVERIFY(json(hard.out)["winner"].isNull() && !json(hard.out)["nearest"].isNull());
        // A study of another program, and a candidate that was changed.
        const QString request = s.path() + "/hard.study/request.json";
        const QByteArray own = bytes_of(request);
        s.write("hard.study/request.json", QByteArray(own).replace("facetmill-cli 0", "facetmill-cli 9"));
        const CliRun other = run_cli({"study", "resume", "hard.study"}, s.path());
        QCOMPARE(other.code(), QByteArray("newer_version"));
        s.write("hard.study/request.json", own);
        bool refused = false;
        const QString key = s.files("hard.study/candidates").at(0);
        const QString candidate = "hard.study/candidates/" + key + "/project.facetmill";
        s.write(candidate, bytes_of(s.path() + "/" + candidate) + "\n");
        QVERIFY(QFile::remove(s.path() + "/hard.study/candidates/" + key + "/estimate.json")
                || QFile::remove(s.path() + "/hard.study/candidates/" + key + "/fine.json"));
        for (const char* rung : {"estimate", "fine"}) {
            const CliRun work =
                run_cli({"study", "work", "hard.study", "--candidate", key, "--rung", rung}, s.path());
            if (work.status == 0) continue; // that one is known already
            QCOMPARE(work.code(), QByteArray("out_of_range"));
            QCOMPARE(json(work.out)["error"].toObject()["code"].toString(), QString("out_of_range"));
            refused = true;
        }
        QVERIFY(refused);
        // A worker that has no place for what it found ends the run, and says why.
        CliRun first = run_cli({"study", "run", "study.json", "-o", "full"}, s.path());
        QCOMPARE(first.status, 0);
        const QString there = s.path() + "/full/candidates/" + s.files("full/candidates").at(0);
        QFile::remove(there + "/estimate.json");
        QFile::remove(there + "/fine.json");
        QVERIFY(QDir().mkpath(there + "/estimate.json") && QDir().mkpath(there + "/fine.json"));
        first = run_cli({"study", "resume", "full"}, s.path());
        QCOMPARE(first.code(), QByteArray("unwritable"));
    }

    /// A file system with so little room that the study does not fit: it ends and says so, and goes on from
    /// what was found as soon as there is room.
    void a_full_disk_is_told_and_nothing_is_lost() {
        Sandbox s;
        fill_with_study(s);
        QVERIFY(QDir(s.path()).mkpath("roomy"));
        QCOMPARE(run_cli({"study", "run", "study.json", "-o", "roomy/s"}, s.path()).status, 0);
        const QByteArray whole =
            bytes_of(s.path() + "/roomy/s/study.json"); // as deep as the other: files are named from there
        QDir(s.path()).mkpath("small");
        constexpr int no_mount = 77;
        const char* const script = R"(mount -t tmpfs -o size=$2k tmpfs small || exit 77
"$1" study run study.json -o small/s 2>said; status=$?
ls small/s/candidates 2>/dev/null | wc -l >begun
mount -o remount,size=64m small || exit 77
"$1" study run study.json -o small/s || exit 78
cp small/s/study.json last.json; exit $status
)";
        bool stopped_halfway = false;
        for (const int kib : {8, 24, 56, 88}) {
            QFile::remove(s.path() + "/last.json");
            QProcess run;
            run.setWorkingDirectory(s.path());
            run.start("unshare", {"-m", "sh", "-c", script, "sh", FACETMILL_CLI, QString::number(kib)});
            QVERIFY(run.waitForFinished(60'000));
            if (run.error() == QProcess::FailedToStart || run.exitCode() == no_mount
                || run.readAllStandardError().contains("unshare failed"))
                QSKIP("there is no right to mount a file system: not root, or in a container without it");
            const QByteArray said = bytes_of(s.path() + "/said");
            QCOMPARE(run.exitCode(), 1);
            QVERIFY2(said.contains("error [unwritable]") && said.contains("No space left"), said.constData());
            QCOMPARE(bytes_of(s.path() + "/last.json"), whole);
            stopped_halfway = stopped_halfway || bytes_of(s.path() + "/begun").trimmed().toInt() > 2;
        }
        QVERIFY(stopped_halfway);
    }
};

FACETMILL_TEST(TestStudyCommand)
#include "test_study.moc"
