// The corpus of odd and broken STEP and IGES files: texts made from a sound one.
#include "core/mesh/mesh_io.h"
#include "tests/support/surface_files.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/mesh_io_support.h"
#include "tests/unit/mesh/step_text.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Every number of an entity goes up.
std::string renumbered(const std::string& step, int by) {
    std::string text;
    for (std::size_t i = 0; i < step.size(); ++i) {
        text += step[i];
        if (step[i] != '#') continue;
        std::size_t end = i + 1;
        while (end < step.size() && step[end] >= '0' && step[end] <= '9')
            ++end;
        if (end > i + 1) text += std::to_string(std::stoi(step.substr(i + 1, end - i - 1)) + by);
        i = end - 1;
    }
    return text;
}

} // namespace

class TestSurfaceCorpus : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
#ifdef FACETMILL_STEP_PROGRAM
        qputenv("FACETMILL_STEP", FACETMILL_STEP_PROGRAM);
#endif
    }

    void odd_files_that_are_sound_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        if (no_surface_files()) QSKIP(no_surface_files());
        const std::string box = step_box(10, 20, 30);
        const auto row = [](const char* tag, const std::string& bytes, const char* name = "a.step") {
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size())) << name;
        };
        row("plain", box);
        row("stp", box, "a.stp");
        row("its name in capitals", box, "A.STEP");
        row("by its content", box, "part");
        row("inches", step_box(10, 20, 30, "INCH"));
        row("metres", step_box(10, 20, 30, "M"));
        std::string text = box;
        text = replaced_all(text, "\n", "\r\n");
        row("lines end as in DOS", text);
        text = box;
        text = replaced_all(text, "\n", "\n\n");
        row("empty lines", text);
        text = box;
        text = replaced_all(text, "=", " =\t");
        row("blanks and tabs", text);
        row("one line for all data", [&] {
            std::string all;
            for (const std::string& one : entities_of(box))
                all += one;
            return with_entities(box, {all});
        }());
        row("comments", replaced(box, "DATA;", "/* before */ DATA; /* ; of #1 = 'them' */"));
        row("an entity that nobody names",
            replaced(box, "DATA;", "DATA;\n#99999=CARTESIAN_POINT('',(1.,2.,3.));"));
        row("large numbers of entities", renumbered(box, 1'000'000));
        row("in reverse order", [&] {
            auto all = entities_of(box);
            std::reverse(all.begin(), all.end());
            return with_entities(box, all);
        }());
        row("bytes behind the end", box + "\n\n  \n");
        row("a name in Chinese", replaced(box, "FILE_NAME('", "FILE_NAME('\\X2\\96F64EF6\\X0\\"));
    }
    void odd_files_that_are_sound() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        const LoadedMesh loaded = read_mesh(bytes.toStdString(), name.toStdString(), {}, Progress());
        QCOMPARE(loaded.mesh->facet_count(), std::size_t(12));
        QVERIFY(loaded.report.watertight);
        QVERIFY((loaded.mesh->box().size() - Vec3(10, 20, 30)).norm() < 1e-6);
    }

    void broken_files_are_refused_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        if (no_surface_files()) QSKIP(no_surface_files());
        const std::string box = step_box(10, 20, 30);
        const auto row = [](const char* tag, const std::string& bytes, const char* name = "a.step") {
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size())) << name;
        };
        row("nothing", "");
        row("a text", "ISO standards are fine\n");
        row("a header alone", box.substr(0, box.find("DATA;")));
        row("no data", with_entities(box, {}));
        row("cut in the middle", box.substr(0, box.size() / 2));
        row("cut before its end", box.substr(0, box.find("END-ISO")));
        row("a line alone", step_wire());
        row("points alone", with_entities(box, {"#1=CARTESIAN_POINT('',(1.,2.,3.));"}));
        row("an IGES file", iges_cylinder(10, 30, true));
        row("a STEP file named as IGES", box, "a.iges");
        row("an STL file", binary_stl(box_mesh(Vec3(0, 0, 0), Vec3(1, 1, 1))));
        row("an archive", std::string("PK\3\4", 4) + box);
        row("the faces are gone", [&] {
            auto all = entities_of(box);
            std::erase_if(all,
                          [](const std::string& e) { return e.find("ADVANCED_FACE") != std::string::npos; });
            return with_entities(box, all);
        }());
        row("the points are gone", [&] {
            auto all = entities_of(box);
            std::erase_if(
                all, [](const std::string& e) { return e.find("CARTESIAN_POINT") != std::string::npos; });
            return with_entities(box, all);
        }());
        row("zeros", std::string(4096, '\0'));
        row("in 16 bits", [&] {
            std::string wide("\xFF\xFE");
            for (const char c : box)
                wide += {c, '\0'};
            return wide;
        }());
    }
    void broken_files_are_refused() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        try {
            read_mesh(bytes.toStdString(), name.toStdString(), {}, Progress());
            QVERIFY2(false, "it was read");
        } catch (const Error& e) {
            QVERIFY2(std::string(e.what()).find(name.toStdString()) != std::string::npos, e.what());
            QVERIFY(e.code() != ErrorCode::internal);
            QVERIFY(!e.remedy().empty());
        }
    }
};

FACETMILL_TEST(TestSurfaceCorpus)
#include "test_surface_corpus.moc"
