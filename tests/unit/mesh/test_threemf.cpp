// 3MF: units, transforms, components, the choice of objects, and a corpus of odd and broken files.
#include "tests/support/cancel_at.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/mesh/threemf_support.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const Vec3 size(2, 3, 4);

Mesh small_box() {
    return box_mesh(Vec3(0, 0, 0), size);
}

LoadedMesh chosen(const Maker3mf& maker, const std::string& objects) {
    MeshReading reading;
    reading.objects = objects;
    return read_mesh(threemf_bytes(maker), "a.3mf", reading, Progress());
}

Box3 box_of(const Maker3mf& maker, const std::string& objects = {}) {
    return chosen(maker, objects).mesh->box();
}

bool near(const Box3& box, const Vec3& lo, const Vec3& hi) {
    return (box.lo - lo).norm() < 1e-9 && (box.hi - hi).norm() < 1e-9;
}

std::string error_of(const std::string& bytes, const std::string& objects = {}) {
    try {
        MeshReading reading;
        reading.objects = objects;
        read_mesh(bytes, "a.3mf", reading, Progress());
    } catch (const Error& e) {
        return std::string(code_name(e.code())) + " " + e.what();
    }
    return "ok";
}

/// Three objects on the plate, one of them put together from another and a fourth.
Maker3mf assembly() {
    return {.objects =
                mesh_3mf(small_box(), 1, "name=\"Box\"") + mesh_3mf(small_box(), 2, "name=\"Lid\"")
                + mesh_3mf(small_box(), 3, "name=\"Support\" type=\"support\"")
                + components_3mf(7,
                                 "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/>"
                                 "<component objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 100 50 0\"/>",
                                 "name=\"Both\""),
            .items = "<item objectid=\"1\"/><item objectid=\"7\" transform=\"1 0 0 0 1 0 0 0 1 0 0 10\"/>"
                     "<item objectid=\"3\"/>"};
}

} // namespace

class TestThreemf : public QObject {
    Q_OBJECT
private slots:

    void the_file_states_its_unit() {
        const std::vector<std::tuple<std::string, double, LengthUnit>> units = {
            {"", 1, LengthUnit::mm},
            {"unit=\"millimeter\"", 1, LengthUnit::mm},
            {"unit=\"micron\"", 0.001, LengthUnit::mm},
            {"unit=\"centimeter\"", 10, LengthUnit::cm},
            {"unit=\"inch\"", 25.4, LengthUnit::inch},
            {"unit=\"meter\"", 1000, LengthUnit::m}};
        for (const auto& [attribute, mm, unit] : units) {
            const std::string bytes = threemf_bytes({.objects = mesh_3mf(small_box()), .unit = attribute});
            for (const std::optional<LengthUnit> asked :
                 {std::optional<LengthUnit>(), std::optional(LengthUnit::mm),
                  std::optional(LengthUnit::inch)}) {
                MeshReading reading;
                reading.unit = asked;
                const LoadedMesh loaded = read_mesh(bytes, "a.3mf", reading, Progress());
                QVERIFY((loaded.mesh->box().hi - mm * size).norm() < 1e-9 * mm);
                QVERIFY(loaded.report.unit_known && loaded.report.assumed_unit == unit
                        && loaded.report.unit_guess == unit);
                const auto& words = loaded.report.warnings;
                QCOMPARE(std::count(words.begin(), words.end(), "unit_differs"),
                         asked && *asked != unit ? 1 : 0);
            }
        }
        for (const char* unit : {"foot", "furlong", "Millimeter", ""}) {
            const std::string error = error_of(threemf_bytes(
                {.objects = mesh_3mf(small_box()), .unit = "unit=\"" + std::string(unit) + "\""}));
            QVERIFY2(error.starts_with("unsupported_format")
                         && error.find("'" + std::string(unit) + "'") != std::string::npos,
                     error.c_str());
        }
    }

    void transforms_are_applied_in_order() {
        // A quarter turn about Z, then a shift; the component is shifted before that.
        Maker3mf maker{
            .objects =
                mesh_3mf(small_box())
                + components_3mf(2, "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 10 0 0\"/>"),
            .items = "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 5\"/>"};
        QVERIFY(near(box_of(maker), Vec3(-3, 10, 5), Vec3(0, 12, 9)));
        // A mirrored object is still wound outward.
        maker.items = "<item objectid=\"1\" transform=\"-2 0 0 0 1 0 0 0 1 0 0 0\"/>";
        const LoadedMesh mirrored = chosen(maker, "");
        QVERIFY(near(mirrored.mesh->box(), Vec3(-4, 0, 0), Vec3(0, 3, 4)));
        QVERIFY(std::abs(mirrored.report.file_volume - 48) < 1e-9 && mirrored.report.watertight);
        // The same object thrice.
        maker.items = "<item objectid=\"1\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 10 0 0\"/>"
                      "<item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 0 10 0\"/>";
        QCOMPARE(chosen(maker, "").report.shells, std::size_t(3));
    }

    void objects_are_chosen() {
        const Maker3mf maker = assembly();
        const auto facets = [&](const char* objects) { return chosen(maker, objects).report.facets; };
        QCOMPARE(facets(""), std::size_t(36));
        QCOMPARE(facets("Lid"), std::size_t(12));
        QCOMPARE(facets("2"), std::size_t(12));
        QCOMPARE(facets("Both"), std::size_t(24));
        QCOMPARE(facets("Both, Lid"), std::size_t(24)); // once
        QCOMPARE(facets("Box"), std::size_t(24));       // wherever it lies
        QVERIFY(near(box_of(maker, "Lid"), Vec3(100, 50, 10), Vec3(102, 53, 14)));
        const LoadedMesh all = chosen(maker, "");
        QVERIFY(std::count(all.report.warnings.begin(), all.report.warnings.end(), "objects_left_out") == 1);
        QCOMPARE(all.report.objects.size(), std::size_t(4));
        QCOMPARE(QString::fromStdString(all.report.objects[3].name), QString("Both"));
        QCOMPARE(all.report.objects[3].facets, std::size_t(24));
        QVERIFY(all.report.objects[1].read && !all.report.objects[2].read);
        const std::string error = error_of(threemf_bytes(maker), "Lit");
        QVERIFY2(error.starts_with("missing_reference") && error.find("2 (Lid)") != std::string::npos,
                 error.c_str());
        // What is not on the plate can be named.
        Maker3mf shelf{.objects = mesh_3mf(small_box(), 4, "name=\"Spare\""), .items = ""};
        QVERIFY(error_of(threemf_bytes(shelf)).starts_with("no_facets"));
        QVERIFY(near(box_of(shelf, "Spare"), Vec3(0, 0, 0), size));
    }

    void slices_are_told() {
        const auto words = [](const char* attributes) {
            return outcome(threemf_bytes({.objects = mesh_3mf(small_box(), 1, attributes),
                                          .model_attributes = "xmlns:s=\"http://schemas.microsoft.com/"
                                                              "3dmanufacturing/slice/2015/07\""}),
                           "a.3mf");
        };
        QCOMPARE(QString::fromStdString(words("s:slicestackid=\"1\"")), QString("ok,slices_ignored"));
        QCOMPARE(QString::fromStdString(words("s:meshresolution=\"lowres\"")), QString("unsupported_format"));
    }

    void models_lie_in_several_files() {
        Maker3mf part{.objects = mesh_3mf(small_box()), .items = "<item objectid=\"1\"/>"};
        Maker3mf maker{.objects =
                           components_3mf(5, "<component p:path=\"/3D/Objects/Part.model\" objectid=\"1\"/>"),
                       .items = "<item objectid=\"5\"/>",
                       .model_attributes = "requiredextensions=\"p\"",
                       .more = {{"3D/Objects/part.model", part.model()}}};
        QVERIFY(near(box_of(maker), Vec3(0, 0, 0), size));
        maker.more.clear();
        QVERIFY(error_of(threemf_bytes(maker)).starts_with("missing_reference"));
        part.unit = "unit=\"inch\"";
        maker.more = {{"3D/Objects/part.model", part.model()}};
        QVERIFY(error_of(threemf_bytes(maker)).starts_with("unsupported_format"));
    }

    void odd_files_that_are_sound_data() {
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char* tag, const Maker3mf& maker) {
            const std::string bytes = threemf_bytes(maker);
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size()));
        };
        const std::string mesh = mesh_3mf(small_box());
        const auto with = [&](const std::string& from, const std::string& to) {
            std::string changed = mesh;
            changed.replace(changed.find(from), from.size(), to);
            return Maker3mf{.objects = changed};
        };
        row("plain", {.objects = mesh});
        row("no unit", {.objects = mesh, .unit = ""});
        row("a target without slash", {.objects = mesh, .target = "3D/3dmodel.model"});
        row("a target in other capitals", {.objects = mesh, .target = "/3d/3DModel.MODEL"});
        row("a model of another name", {.objects = mesh, .model_name = "a/b.model", .target = "/a/b.model"});
        row("a model without ending", {.objects = mesh, .model_name = "part", .target = "/part"});
        row("comments",
            {.objects = "<!-- one -->" + mesh + "<!-- two -->", .before_model = "<!-- three -->"});
        row("an instruction", {.objects = mesh, .before_model = "<?what ever?>"});
        row("metadata", {.objects = mesh + "<metadata name=\"Title\">x &amp; y</metadata>"});
        row("elements of another namespace",
            {.objects = "<q:object xmlns:q=\"urn:q\" id=\"1\"><q:mesh/></q:object>" + mesh});
        row("a vertex of another namespace", with("<vertices>", "<vertices><q:vertex xmlns:q=\"urn:q\"/>"));
        row("an identity",
            {.objects = mesh, .items = "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0\"/>"});
        row("much white space",
            {.objects = mesh,
             .items = " \n\t<item\n objectid = '1'\r\n transform=' 1 0 0\t0 1 0 0 0 1   0 0 0 ' /> "});
        row("exponents", with("x=\"2\"", "x=\"+2.0e0\""));
        row("negative zero", with("x=\"0\"", "x=\"-0\""));
        row("unused object", {.objects = mesh + mesh_3mf(box_mesh(Vec3(0, 0, 0), Vec3(9, 9, 9)), 2)});
        row("an empty object beside", {.objects = mesh + "<object id=\"2\"/>",
                                       .items = "<item objectid=\"1\"/><item objectid=\"2\"/>"});
        row("an object without facets beside",
            {.objects = mesh + "<object id=\"2\"><mesh><vertices/><triangles/></mesh></object>",
             .items = "<item objectid=\"2\"/><item objectid=\"1\"/>"});
        row("a support beside", {.objects = mesh + mesh_3mf(small_box(), 2, "type=\"support\""),
                                 .items = "<item objectid=\"2\"/><item objectid=\"1\"/>"});
        row("a modifier as component",
            {.objects = mesh + mesh_3mf(box_mesh(Vec3(0, 0, 0), Vec3(9, 9, 9)), 2, "type=\"other\"")
                        + components_3mf(3, "<component objectid=\"1\"/><component objectid=\"2\"/>"),
             .items = "<item objectid=\"3\"/>"});
        row("a surface", {.objects = mesh_3mf(small_box(), 1, "type=\"surface\"")});
        row("objects in reverse order", {.objects = components_3mf(2, "<component objectid=\"1\"/>") + mesh,
                                         .items = "<item objectid=\"2\"/>"});
        row("a component of a component", {.objects = mesh + components_3mf(2, "<component objectid=\"1\"/>")
                                                      + components_3mf(3, "<component objectid=\"2\"/>"),
                                           .items = "<item objectid=\"3\"/>"});
        row("a large number of an object",
            {.objects = mesh_3mf(small_box(), 2147483647), .items = "<item objectid=\"2147483647\"/>"});
        row("a recommended extension",
            {.objects = mesh, .model_attributes = "recommendedextensions=\"q\" xmlns:q=\"urn:q\""});
        row("a required one that is known",
            {.objects = mesh,
             .model_attributes =
                 "requiredextensions=\"m p\" "
                 "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\""});
        row("materials", with("<triangle ", "<triangle pid=\"5\" p1=\"0\" "));
        row("pictures beside",
            {.objects = mesh,
             .more = {{"Metadata/thumbnail.png", "no picture"}, {"3D/_rels/3dmodel.model.rels", "<r/>"}}});
        row("a name in Chinese", {.objects = mesh_3mf(small_box(), 1, "name=\"\xE9\x9B\xB6\xE4\xBB\xB6\"")});
        row("a facet of no area beside",
            with("<triangles>", "<triangles><triangle v1=\"0\" v2=\"0\" v3=\"1\"/>"));
        Maker3mf wide{.objects = mesh};
        std::string utf16("\xFF\xFE");
        std::string text = wide.model();
        text.replace(text.find("UTF-8"), 5, "UTF-16");
        for (const char c : text)
            utf16 += {c, '\0'};
        const std::string bytes =
            archive_bytes({{"_rels/.rels", wide.relationships()}, {"3D/3dmodel.model", utf16}});
        QTest::newRow("UTF-16, no content types") << QByteArray(bytes.data(), qsizetype(bytes.size()));
    }
    void odd_files_that_are_sound() {
        QFETCH(QByteArray, bytes);
        const LoadedMesh loaded = read(bytes.toStdString(), "a.3mf");
        QCOMPARE(loaded.mesh->facets.size(), std::size_t(12));
        QVERIFY(loaded.report.watertight && near(loaded.mesh->box(), Vec3(0, 0, 0), size));
        QVERIFY(std::abs(loaded.report.file_volume - 24) < 1e-9);
        for (const std::string& word : loaded.report.warnings)
            QVERIFY2(!explain_warning(word).empty(), word.c_str());
    }

    void broken_files_are_refused_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("expected");
        const auto raw = [](const char* tag, const std::string& bytes, const char* expected) {
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size())) << expected;
        };
        const auto row = [&](const char* tag, const Maker3mf& maker, const char* expected) {
            raw(tag, threemf_bytes(maker), expected);
        };
        const std::string mesh = mesh_3mf(small_box());
        const auto with = [&](const std::string& from, const std::string& to) {
            std::string changed = mesh;
            changed.replace(changed.find(from), from.size(), to);
            return Maker3mf{.objects = changed};
        };
        row("entities", {.objects = mesh, .before_model = "<!DOCTYPE model [<!ENTITY a \"b\">]>"}, "syntax");
        row("a thousand million laughs",
            {.objects = mesh + "<metadata>&c;</metadata>",
             .before_model = "<!DOCTYPE m [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\"><!ENTITY c "
                             "\"&b;&b;&b;\">]>"},
            "syntax");
        row("an entity of elsewhere",
            {.objects = mesh, .before_model = "<!DOCTYPE m SYSTEM \"file:///etc/passwd\">"}, "syntax");
        row("an entity that nobody declares", {.objects = mesh + "<metadata>&x;</metadata>"}, "syntax");
        row("no mesh", {.objects = "<object id=\"1\"/>"}, "no_facets");
        row("no object", {.objects = "", .items = ""}, "no_facets");
        row("nothing on the plate", {.objects = mesh, .items = ""}, "no_facets");
        row("an item of no object", {.objects = mesh, .items = "<item objectid=\"2\"/>"},
            "missing_reference");
        row("a component of no object", {.objects = components_3mf(1, "<component objectid=\"9\"/>")},
            "missing_reference");
        row("an object that holds itself", {.objects = components_3mf(1, "<component objectid=\"1\"/>")},
            "limit_exceeded");
        row("two that hold each other",
            {.objects = components_3mf(1, "<component objectid=\"2\"/>")
                        + components_3mf(2, "<component objectid=\"1\"/>")},
            "limit_exceeded");
        std::string chain = mesh, doubled = mesh;
        for (int k = 2; k < 90; ++k) {
            const std::string part = "<component objectid=\"" + std::to_string(k - 1) + "\"/>";
            chain += components_3mf(k, part);
            if (k < 50) doubled += components_3mf(k, part + part);
        }
        row("a chain of ninety", {.objects = chain, .items = "<item objectid=\"89\"/>"}, "limit_exceeded");
        row("doubled forty times", {.objects = doubled, .items = "<item objectid=\"40\"/>"},
            "limit_exceeded");
        row("eleven numbers",
            {.objects = mesh, .items = "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0\"/>"},
            "syntax");
        row("thirteen numbers",
            {.objects = mesh, .items = "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0 0\"/>"},
            "syntax");
        row("a transform that flattens",
            {.objects = mesh, .items = "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"/>"},
            "out_of_range");
        row("a transform that is no number",
            {.objects = mesh, .items = "<item objectid=\"1\" transform=\"nan 0 0 0 1 0 0 0 1 0 0 0\"/>"},
            "syntax");
        row("a transform to far away",
            {.objects = mesh, .items = "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 1e9 0 0\"/>"},
            "coordinate_range");
        row("a vertex that is not there", with("v3=\"3\"", "v3=\"8\""), "syntax");
        row("a negative vertex", with("v3=\"3\"", "v3=\"-1\""), "syntax");
        row("a triangle of two corners", with(" v3=\"3\"", ""), "syntax");
        row("a vertex without z", with(" z=\"0\"", ""), "syntax");
        row("not a number", with("x=\"2\"", "x=\"nan\""), "non_finite");
        row("beyond double", with("x=\"2\"", "x=\"1e999\""), "coordinate_range");
        row("far away", with("x=\"2\"", "x=\"1e20\""), "coordinate_range");
        row("a decimal comma", with("x=\"2\"", "x=\"2,5\""), "syntax");
        row("no number of an object", with("id=\"1\"", ""), "syntax");
        row("a number twice", {.objects = mesh + mesh}, "syntax");
        row("a vertex outside of objects", {.objects = "<vertex x=\"0\" y=\"0\" z=\"0\"/>"}, "syntax");
        row("an element that does not end", {.objects = mesh + "<object id=\"3\">"}, "syntax");
        row("a prefix of nothing", {.objects = mesh + "<q:a/>"}, "syntax");
        row("unit foot", {.objects = mesh, .unit = "unit=\"foot\""}, "unsupported_format");
        row("beams are required",
            {.objects = mesh,
             .model_attributes =
                 "requiredextensions=\"b\" "
                 "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\""},
            "unsupported_format");
        row("secret content is required",
            {.objects = mesh,
             .model_attributes =
                 "requiredextensions=\"sc\" "
                 "xmlns:sc=\"http://schemas.microsoft.com/3dmanufacturing/securecontent/2019/04\""},
            "unsupported_format");
        row("a required prefix of nothing",
            {.objects = mesh, .model_attributes = "requiredextensions=\"zz\""}, "unsupported_format");
        row("a target that is not there", {.objects = mesh, .target = "/3D/other.model"},
            "missing_reference");
        row("only a support", {.objects = mesh_3mf(small_box(), 1, "type=\"support\"")}, "no_facets");
        row("nested deeply",
            {.objects =
                 [] {
                     std::string deep;
                     for (int k = 0; k < 99; ++k)
                         deep += "<a>";
                     for (int k = 0; k < 99; ++k)
                         deep += "</a>";
                     return deep;
                 }()},
            "limit_exceeded");
        const Maker3mf sound{.objects = mesh};
        raw("no relationships", archive_bytes({{"3D/3dmodel.model", sound.model()}}), "syntax");
        std::string wrong = sound.relationships();
        wrong.replace(wrong.find("2013/01/3dmodel"), 15, "2013/01/2dmodel");
        raw("a wrong relationship",
            archive_bytes({{"_rels/.rels", wrong}, {"3D/3dmodel.model", sound.model()}}), "syntax");
        std::string external = sound.relationships();
        external.replace(external.find(" Id="), 1, " TargetMode=\"External\" ");
        raw("a model elsewhere",
            archive_bytes({{"_rels/.rels", external}, {"3D/3dmodel.model", sound.model()}}), "syntax");
        raw("relationships that are no XML",
            archive_bytes({{"_rels/.rels", "what"}, {"3D/3dmodel.model", sound.model()}}), "syntax");
        raw("a model that is no XML",
            archive_bytes({{"_rels/.rels", sound.relationships()}, {"3D/3dmodel.model", "what"}}), "syntax");
        raw("a model that is empty",
            archive_bytes({{"_rels/.rels", sound.relationships()}, {"3D/3dmodel.model", ""}}), "syntax");
        raw("another XML",
            archive_bytes({{"_rels/.rels", sound.relationships()}, {"3D/3dmodel.model", "<svg/>"}}),
            "syntax");
        raw("a bomb",
            archive_bytes({{"_rels/.rels", sound.relationships()},
                           {"3D/3dmodel.model", sound.model() + std::string(80u << 20, ' ')}}),
            "limit_exceeded");
        raw("another archive", archive_bytes({{"a.txt", "b"}}), "syntax");
        raw("no archive", binary_stl(small_box()), "syntax");
        const std::string bytes = threemf_bytes(sound);
        raw("cut", bytes.substr(0, bytes.size() / 2), "syntax");
        raw("cut at its end", bytes.substr(0, bytes.size() - 3), "syntax");
        std::string secret = bytes;
        // The flag of encryption, of each file and in the list of files.
        for (std::size_t at = 0; (at = secret.find("PK\x03\x04", at)) != std::string::npos; ++at)
            secret[at + 6] = char(secret[at + 6] | 1);
        for (std::size_t at = 0; (at = secret.find("PK\x01\x02", at)) != std::string::npos; ++at)
            secret[at + 8] = char(secret[at + 8] | 1);
        raw("encrypted", secret, "unsupported_format");
    }
    void broken_files_are_refused() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, expected);
        const std::string error = error_of(bytes.toStdString());
        QVERIFY2(error.starts_with(expected.toStdString() + " "), error.c_str());
        QVERIFY2(error.find("a.3mf") != std::string::npos, error.c_str());
        QVERIFY(printable(error, error.size()) == error);
    }

    void cancelling_and_damage() {
        const std::string bytes =
            threemf_bytes({.objects = mesh_3mf(torus_mesh(trials(200, 2), trials(100, 2)))});
        for (const double fraction : {0.05, 0.2, 0.33, 0.6, 0.9}) {
            Job job;
            QVERIFY(
                cancelled_at(job, fraction, [&](const Progress& p) { read_mesh(bytes, "a.3mf", {}, p); }));
        }
        std::mt19937 random(5);
        const Maker3mf maker = assembly();
        for (int trial = 0; trial < trials(1500, 3); ++trial) {
            // In the XML, which an archive's sums would else protect.
            std::string model = maker.model();
            for (std::uint32_t k = 0; k < 1 + random() % 3; ++k)
                model[random() % model.size()] = "\"<>/ =0913-ex\n"[random() % 14];
            QVERIFY(!error_of(
                         archive_bytes({{"_rels/.rels", maker.relationships()}, {"3D/3dmodel.model", model}}))
                         .empty());
            std::string damaged = threemf_bytes(maker);
            damaged[random() % damaged.size()] = char(random());
            QVERIFY(!error_of(damaged).empty());
        }
    }
};

FACETMILL_TEST(TestThreemf)
#include "test_threemf.moc"
