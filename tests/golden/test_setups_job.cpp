// A project of several setups through the program's own door: plan, simulate and report run all of them.
#include "core/mesh/mesh_io.h"
#include "tests/golden/run_cli.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const char* const block_project =
    R"({ "facetmill": 2, "units": "mm", "part": { "file": "block.stl" }, "post": "linuxcnc",
  "tools": [ { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 } ],
  "setups": [
    { "name": "Top", "stock": { "kind": "box", "margin": [0, 0, 1] }, "wcs": "G54",
      "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.1, "clearance": 3 } ] },
    { "name": "Bottom", "place": { "rotate": [180, 0, 0], "translate": [0, 30, 24] }, "wcs": "G55", "programs": "one",
      "operations": [ { "kind": "finish3", "name": "Below", "tool": 1, "tolerance": 0.1, "clearance": 3 } ] } ] })";

QByteArray block_with(const char* from, const char* to) {
    QByteArray text = block_project;
    if (!text.contains(from)) qFatal("the test's text is not in the project");
    return text.replace(from, to);
}

/// A folder with the block and its project.
struct Block : Sandbox {
    explicit Block(const QByteArray& project = block_project) {
        save_stl(HollowedBlock::mesh(), (path() + "/block.stl").toStdString(), LengthUnit::mm, {});
        write("job.facetmill", project);
    }
    CliRun run(const QStringList& arguments) const { return run_cli(arguments, path()); }
    QByteArray file(const QString& name) const { return bytes_of(path() + "/" + name); }
};

QStringList names_in(const QJsonArray& list) {
    QStringList names;
    for (const QJsonValue& v : list)
        names << v.toObject()["name"].toString();
    return names;
}

} // namespace

class TestSetupsJob : public QObject {
    Q_OBJECT
private slots:

    void plan_writes_all_setups() {
        const Block block;
        const CliRun run = block.run({"plan", "job.facetmill", "-o", "out"});
        QVERIFY2(run.status == 0, run.err.constData());
        QCOMPARE(block.files("out"), QStringList({"01-Finish.apt", "01-Finish.ngc", "02-Below.apt",
                                                  "block-2-Bottom.ngc", "report.json"}));
        const QJsonObject report = json(run.out);
        QCOMPARE(block.file("out/report.json"), run.out);
        const QJsonArray setups = report["setups"].toArray();
        QCOMPARE(names_in(setups), QStringList({"Top", "Bottom"}));
        QCOMPARE(setups[1].toObject()["place"].toObject()["rotate"].toArray()[0].toDouble(), 180.0);
        QCOMPARE(setups[1].toObject()["stock"].toObject()["kind"].toString(), QString("rest"));
        QCOMPARE(names_in(setups[1].toObject()["operations"].toArray()), QStringList({"Below"}));
        QVERIFY(block.file("out/01-Finish.ngc").contains("G54"));
        QVERIFY(block.file("out/block-2-Bottom.ngc").contains("G55"));
        // One operation: its program alone, though the setup before was planned for its stock.
        const CliRun one = block.run({"plan", "job.facetmill", "--op", "Below", "-o", "one"});
        QVERIFY2(one.status == 0, one.err.constData());
        QCOMPARE(block.files("one"), QStringList({"02-Below.apt", "block-2-Bottom.ngc", "report.json"}));
        QCOMPARE(block.file("one/02-Below.apt"), block.file("out/02-Below.apt"));
    }

    /// Packed it is the same project: the same programs, from wherever it lies.
    void packed_it_plans_the_same() {
        const Block block;
        QCOMPARE(block.run({"pack", "job.facetmill", "-o", "sent.facetmill"}).status, 0);
        QCOMPARE(block.run({"plan", "job.facetmill", "-o", "out"}).status, 0);
        QVERIFY(QFile::remove(block.path() + "/block.stl"));
        const CliRun run = block.run({"plan", "sent.facetmill", "-o", "packed"});
        QVERIFY2(run.status == 0, run.err.constData());
        QCOMPARE(block.files("packed"), block.files("out"));
        for (const QString& name : block.files("out"))
            if (name != "report.json") QCOMPARE(block.file("packed/" + name), block.file("out/" + name));
        QCOMPARE(block.files(), QStringList({"job.facetmill", "out", "packed", "sent.facetmill"}));
    }

    void simulate_judges_them_as_one() {
        const Block block;
        const CliRun run = block.run({"simulate", "job.facetmill", "--resolution", "0.4", "-o", "out"});
        QVERIFY2(run.status == 0, run.err.constData());
        QCOMPARE(block.files("out"), QStringList({"deviation.vtp", "stock.stl", "verify.json"}));
        const QJsonObject verified = json(run.out);
        QCOMPARE(verified["verdict"].toString(), QString("verified"));
        QCOMPARE(names_in(verified["operations"].toArray()), QStringList({"Finish", "Below"}));
        const QJsonArray setups = verified["setups"].toArray();
        QCOMPARE(names_in(setups), QStringList({"Top", "Bottom"}));
        QCOMPARE(setups[1].toObject()["verdict"].toString(), QString("verified"));
        const double left = HollowedBlock::size().prod() - 2 * HollowedBlock::hollow_volume();
        QVERIFY(std::abs(verified["stock_volume"].toDouble() - left) < 0.1 * HollowedBlock::hollow_volume());
        for (const QJsonValue& why : verified["uncut_reasons"].toArray())
            QCOMPARE(why.toObject()["why"].toString(), QString("no_axis_sees"));
    }

    /// A setup with a stock of its own is judged on that.
    void own_stocks_have_files_of_their_own() {
        const Block block(block_with("\"programs\": \"one\"", "\"stock\": { \"kind\": \"box\" }"));
        const CliRun run = block.run({"simulate", "job.facetmill", "--resolution", "0.4", "-o", "out"});
        QVERIFY2(run.status == 0, run.err.constData());
        QCOMPARE(block.files("out"), QStringList({"deviation-1.vtp", "deviation-2.vtp", "stock-1.stl",
                                                  "stock-2.stl", "verify.json"}));
        const QJsonArray stocks = json(run.out)["stocks"].toArray();
        QCOMPARE(stocks.size(), 2);
        QCOMPARE(names_in(stocks[1].toObject()["setups"].toArray()), QStringList({"Bottom"}));
        QCOMPARE(json(run.out)["verdict"].toString(), QString("verified"));
    }

    /// What is read back belongs to a setup, which is asked for where there are several.
    void programs_are_read_back_in_their_setup() {
        const Block block;
        QCOMPARE(block.run({"plan", "job.facetmill", "-o", "out"}).status, 0);
        const CliRun asked = block.run({"simulate", "job.facetmill", "--cl", "out/02-Below.apt", "-o", "cl"});
        QCOMPARE(asked.status, 2);
        QVERIFY2(asked.err.contains("Top, Bottom"), asked.err.constData());
        for (const QStringList& read :
             {QStringList{"--cl", "out/02-Below.apt"}, QStringList{"--nc", "out/block-2-Bottom.ngc"}}) {
            const CliRun run = block.run(QStringList{"simulate", "job.facetmill", "--setup", "Bottom",
                                                     "--resolution", "0.4", "-o", "cl"}
                                         + read);
            const QJsonObject verified = json(run.out);
            QVERIFY2(verified["gouge_max"].toDouble() < 0.05, run.err.constData());
            QCOMPARE(verified["operations"].toArray().size(), 1);
            const double left = HollowedBlock::size().prod() - 2 * HollowedBlock::hollow_volume();
            QVERIFY(std::abs(verified["stock_volume"].toDouble() - left)
                    < 0.2 * HollowedBlock::hollow_volume());
        }
        const CliRun unknown = block.run(
            {"simulate", "job.facetmill", "--cl", "out/02-Below.apt", "--setup", "Botom", "-o", "cl"});
        QCOMPARE(unknown.status, 1);
        QVERIFY2(unknown.code() == "missing_reference" && unknown.err.contains("did you mean 'Bottom'"),
                 unknown.err.constData());
        QCOMPARE(block.run({"simulate", "job.facetmill", "--setup", "Bottom", "-o", "cl"}).status, 2);
    }

    void the_sheet_has_a_part_for_each() {
        const Block block;
        const CliRun run = block.run({"report", "job.facetmill", "-o", "sheet.html"});
        QVERIFY2(run.status == 0, run.err.constData());
        QCOMPARE(json(run.out)["programs"].toInt(), 2);
        QCOMPARE(json(run.out)["verdict"].toString(), QString("verified"));
        const QByteArray sheet = block.file("sheet.html");
        for (const char* text :
             {"2 setups", "Verified: no gouge", "Setup 1 \xC2\xB7 Top", "Setup 2 \xC2\xB7 Bottom",
              "turned by 180\xC2\xB0 about X, then moved by 0, 30, 24 mm", "G54, its zero in",
              "G55, its zero in", "what setup &#39;Top&#39; left"})
            QVERIFY2(sheet.contains(text) || sheet.contains(QByteArray(text).replace("&#39;", "'")), text);
        QCOMPARE(sheet.count("Verification by removal"), 1);
    }

    void wrong_projects_are_told_data() {
        QTest::addColumn<QByteArray>("project");
        QTest::addColumn<QByteArray>("code");
        QTest::addColumn<QByteArray>("place");
        QTest::newRow("one number for two programs")
            << block_with("\"post\": \"linuxcnc\"", "\"post\": \"fanuc\"") << QByteArray("out_of_range")
            << QByteArray("setup 'Bottom': program_number");
        QTest::newRow("work coordinates that the control has not")
            << block_with("G55", "G155") << QByteArray("out_of_range") << QByteArray("setup 'Bottom'");
        QTest::newRow("a rest of nothing")
            << block_with("{ \"kind\": \"box\", \"margin\": [0, 0, 1] }", "{ \"kind\": \"rest\" }")
            << QByteArray("missing_reference") << QByteArray("setups[0].stock.kind");
        QTest::newRow("no operations")
            << block_with("{ \"kind\": \"finish3\", \"name\": \"Below\", \"tool\": 1, \"tolerance\": 0.1, "
                          "\"clearance\": 3 }",
                          "")
            << QByteArray("missing_key") << QByteArray("setup 'Bottom': operations");
    }
    void wrong_projects_are_told() {
        QFETCH(QByteArray, project);
        QFETCH(QByteArray, code);
        QFETCH(QByteArray, place);
        const Block block(project);
        const CliRun run = block.run({"plan", "job.facetmill", "-o", "out"});
        QCOMPARE(run.status, 1);
        QCOMPARE(run.code(), code);
        QVERIFY2(run.err.contains(place), run.err.constData());
        QVERIFY(!block.files().contains("out"));
    }
};

FACETMILL_TEST(TestSetupsJob)
#include "test_setups_job.moc"
