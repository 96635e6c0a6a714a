// Roughing through the program's own door: plan, report, and the verifier's judgement of what was cut; then
// roughing again with a smaller tool, which takes only what the first one left.
#include "tests/golden/run_cli.h"
#include "tests/support/test_runner.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

QByteArray rough_project() {
    QFile file(QString::fromStdString(data_path("golden/jobs/rough.facetmill")));
    if (!file.open(QIODevice::ReadOnly)) qFatal("the roughing job is not there");
    return file.readAll();
}

} // namespace

class TestRoughJob : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const CliRun sample = run_cli(
            {"sample", "complex", "--tolerance", "0.01", "--units", "in", "-o", "part.stl"}, sandbox_.path());
        QVERIFY2(sample.status == 0, sample.err);
        sandbox_.write("job.facetmill", rough_project());
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "out"}, sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        operations_ = json(run.out)["operations"].toArray();
        QCOMPARE(operations_.size(), 2);
    }

    /// At a declared tolerance: a better order may move lengths a little.
    void the_report_is_as_expected() {
        const QJsonObject rough = operations_[0].toObject();
        QCOMPARE(rough["kind"].toString(), QString("rough"));
        for (const char* key : {"passes", "stepover_min", "stepover_max", "cc_points", "cl_points",
                                "cut_length", "rapid_length", "time_seconds", "cusp_max", "seconds_planning",
                                "layers", "remaining_height", "air_length"})
            QVERIFY2(rough[key].isDouble(), key);
        const double remaining = rough["remaining_height"].toDouble();
        QVERIFY2(remaining <= 0.4 && remaining > 0.2, qPrintable(QString::number(remaining)));
        QVERIFY(std::abs(rough["stepover_max"].toDouble() - 0.95) < 1e-9);
        const double cut = rough["cut_length"].toDouble(), rapid = rough["rapid_length"].toDouble(),
                     air = rough["air_length"].toDouble();
        QVERIFY2(rapid + air <= 0.35 * (cut + rapid),
                 qPrintable(QString("rapid %1 air %2 of %3").arg(rapid).arg(air).arg(cut + rapid)));
        // The second one has the first one's floors to cut, but not the stock above them.
        const CliRun alone =
            run_cli({"plan", "job.facetmill", "-o", "alone", "--op", "Rest"}, sandbox_.path());
        QVERIFY2(alone.status == 0, alone.err);
        const QJsonObject rest = json(alone.out)["operations"].toArray()[0].toObject();
        QCOMPARE(rest["cut_length"].toDouble(), operations_[1].toObject()["cut_length"].toDouble());
        QByteArray only = rough_project();
        only.replace("\"Rough\"", "\"R0\"")
            .replace("\"tool\": 1, \"tolerance\": 0.4", "\"tool\": 2, \"depth\": 0.1, \"tolerance\": 0.2");
        sandbox_.write("fresh.facetmill", only);
        const CliRun fresh =
            run_cli({"plan", "fresh.facetmill", "-o", "fresh", "--op", "R0"}, sandbox_.path());
        QVERIFY2(fresh.status == 0, fresh.err);
        const double all = json(fresh.out)["operations"].toArray()[0].toObject()["cut_length"].toDouble();
        QVERIFY2(rest["cut_length"].toDouble() < 0.7 * all,
                 qPrintable(QString("%1 of %2").arg(rest["cut_length"].toDouble()).arg(all)));
    }

    void the_allowance_is_untouched_and_nothing_collides() {
        for (const char* op : {"Rough", ""}) {
            QStringList arguments{"simulate", "job.facetmill", "--resolution", "0.06", "-o", "verified"};
            if (*op) arguments << "--op" << op;
            const CliRun run = run_cli(arguments, sandbox_.path());
            QVERIFY2(run.status == 0, run.err);
            const QJsonObject v = json(run.out);
            QCOMPARE(v["verdict"].toString(), QString("verified"));
            QCOMPARE(v["settings"].toObject()["allowance"].toDouble(), 0.05);
            QVERIFY(v["gouge_max"].toDouble() <= 1e-4);
            QVERIFY(v["collisions"].toArray().isEmpty());
            const double stated = operations_[*op ? 0 : 1].toObject()["remaining_height"].toDouble();
            // The flat end of the second cannot enter the narrowest hollows, as its warning says.
            const double found = v[*op ? "excess_max" : "excess_p99"].toDouble();
            QVERIFY2(found <= stated, qPrintable(QString("%1 stated, %2 found").arg(stated).arg(found)));
        }
    }

    void threads_do_not_matter() {
        for (const char* n : {"1", "3"}) {
            const QString folder = QString("threads") + n;
            const CliRun run =
                run_cli({"plan", "job.facetmill", "-o", folder, "--threads", n}, sandbox_.path());
            QVERIFY2(run.status == 0, run.err);
            for (const char* file : {"/01-Rough.apt", "/02-Rest.apt"}) {
                const QByteArray is = bytes_of(sandbox_.path() + "/" + folder + file);
                QVERIFY(is.size() > 1000);
                QVERIFY(bytes_of(sandbox_.path() + "/out" + file) == is);
            }
        }
    }

    void bad_values_are_told() {
        const auto told = [&](const QString& setting) {
            const CliRun run = run_cli(
                {"plan", "job.facetmill", "-o", "bad", "--op", "Rough", "--set", setting}, sandbox_.path());
            return QString::number(run.status) + " " + run.code() + " " + run.err;
        };
        QVERIFY(told("Rough.depth=0").startsWith("1 out_of_range"));
        QVERIFY(told("Rough.depth=5").contains("flutes"));
        QVERIFY(told("Rough.stepover=1.2").contains("step-over"));
        QVERIFY(told("Rough.allowance=9").startsWith("1 empty_result"));
        QVERIFY(told("Rough.tolerance=0.000001").startsWith("1 out_of_range"));
    }

private:
    Sandbox sandbox_;
    QJsonArray operations_;
};

FACETMILL_TEST(TestRoughJob)
#include "test_rough_job.moc"
