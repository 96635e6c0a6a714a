// 3MF files as other programs write them, each a box of 2 x 3 x 4: what XML, archives and drafts allow.
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/threemf_support.h"

#include <QTest>

#include <cctype>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const Vec3 box_size(2, 3, 4);

std::string box_object() {
    return mesh_3mf(box_mesh(Vec3(0, 0, 0), box_size));
}

/// The archive with this text in place of the model's.
std::string with_model(const std::string& model) {
    return archive_bytes({{"[Content_Types].xml", "<Types/>"},
                          {"_rels/.rels", Maker3mf{}.relationships()},
                          {"3D/3dmodel.model", model}});
}

/// As Fusion 360 streams archives: before each file, lengths are said in part, and the rest behind it.
std::string as_streamed(std::string archive) {
    const auto word = [&](std::size_t at, int count) {
        std::uint32_t v = 0;
        for (int k = count - 1; k >= 0; --k)
            v = v << 8 | static_cast<unsigned char>(archive[at + std::size_t(k)]);
        return v;
    };
    const std::size_t end = archive.rfind("PK\5\6");
    std::size_t entry = word(end + 16, 4);
    for (std::uint32_t n = word(end + 10, 2); n > 0; --n) {
        const std::size_t local = word(entry + 42, 4);
        archive[entry + 8] = char(archive[entry + 8] | 8); // a descriptor follows
        archive[local + 6] = char(archive[local + 6] | 8);
        for (std::size_t k = 14; k < 22; ++k) // checksum and packed size
            archive[local + k] = '\0';
        entry += 46 + word(entry + 28, 2) + word(entry + 30, 2) + word(entry + 32, 2);
    }
    return archive;
}

std::string in_16_bits(const std::string& text, bool big) {
    std::string wide = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : replaced_all(text, "UTF-8", "UTF-16"))
        wide += big ? std::string{'\0', c} : std::string{c, '\0'};
    return wide;
}

} // namespace

class TestThreemfKinds : public QObject {
    Q_OBJECT
private slots:

    void sound_files_data() {
        QTest::addColumn<QByteArray>("bytes");
        const auto raw = [](const char* tag, const std::string& bytes) {
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size()));
        };
        const auto row = [&](const char* tag, const Maker3mf& maker) { raw(tag, threemf_bytes(maker)); };
        const std::string mesh = box_object();
        const std::string model = Maker3mf{.objects = mesh}.model();
        const std::string core = "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"";
        raw("sizes said behind the files", as_streamed(threemf_bytes({.objects = mesh})));
        raw("the draft of 2013", with_model(replaced_all(model, "core/2015/02", "2013/01")));
        row("blanks around coordinates", {.objects = replaced_all(mesh, "x=\"2\"", "x=\"   2.0E+00 \"")});
        row("blanks around numbers of vertices", {.objects = replaced_all(mesh, "v1=\"4\"", "v1=\" 4\t\"")});
        row("blanks around numbers of objects", {.objects = mesh, .items = "<item objectid=\" 1 \"/>"});
        row("zeros in front", {.objects = replaced_all(mesh, "y=\"3\"", "y=\"0003.000\"")});
        row("a point and nothing behind", {.objects = replaced_all(mesh, "z=\"4\"", "z=\"4.\"")});
        row("quotes of one stroke", {.objects = replaced_all(mesh, "\"", "'")});
        row("elements with ends of their own",
            {.objects = replaced_all(replaced_all(mesh, "<vertices>", "<vertices >"), "</triangles>",
                                     "</triangles\n>")});
        {
            std::string prefixed = replaced_all(model, core, "xmlns:c" + core.substr(5));
            for (const char* name : {"model", "resources", "build", "item", "object", "mesh", "vertices",
                                     "triangles", "vertex", "triangle"})
                for (const char* end : {" ", ">", "/"})
                    for (const char* start : {"<", "</"})
                        prefixed = replaced_all(prefixed, std::string(start) + name + end,
                                                std::string(start) + "c:" + name + end);
            raw("a prefix for all of it", with_model(prefixed));
        }
        raw("UTF-16, the small end first", with_model(in_16_bits(model, false)));
        raw("UTF-16, the large end first", with_model(in_16_bits(model, true)));
        raw("a mark in front of UTF-8", with_model("\xEF\xBB\xBF" + model));
        raw("ISO 8859-1", with_model(replaced_all(replaced_all(model, "UTF-8", "ISO-8859-1"), "<object ",
                                                  "<object name=\"B\xFC"
                                                  "chse\" ")));
        raw("no declaration", with_model(model.substr(model.find('\n') + 1)));
        raw("lines end as in DOS", with_model(replaced_all(model, "><", ">\r\n<")));
        raw("blank lines behind the end", with_model(model + "\n\n  \n"));
        row("characters by their numbers", {.objects = replaced_all(mesh, "x=\"2\"", "x=\"&#50;\"")});
        row("a section of plain text",
            {.objects = "<metadata name=\"Title\"><![CDATA[<object id=\"1\"/>]]></metadata>" + mesh});
        row("what an application says of it",
            {.objects = "<metadata name=\"s:settings\" xmlns:s=\"urn:s\">0.2, 15 %</metadata>" + mesh});
        row("universal numbers",
            {.objects = mesh,
             .items = "<item objectid=\"1\" p:UUID=\"74bb9c7d-38be-4cf5-9ba2-2a8ecb7b9f22\"/>"});
        row("sets of triangles",
            {.objects = replaced_all(mesh, "</triangles>",
                                     "</triangles><t:trianglesets><t:triangleset name=\"Top\" "
                                     "identifier=\"t\"><t:ref index=\"1\"/>"
                                     "</t:triangleset></t:trianglesets>"),
             .model_attributes =
                 "xmlns:t=\"http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07\""});
        row("a property of every corner",
            {.objects =
                 "<basematerials id=\"9\"><base name=\"PLA\" displaycolor=\"#FF8000\"/></basematerials>"
                 + replaced_all(mesh, "<triangle ", "<triangle pid=\"9\" p1=\"0\" p2=\"0\" p3=\"0\" ")});
        row("a picture of the object",
            {.objects = replaced_all(mesh, "<object ", "<object thumbnail=\"/Thumbnails/a.png\" "),
             .more = {{"Thumbnails/a.png", "no picture"}}});
        row("settings of slicers beside", {.objects = mesh,
                                           .more = {{"Metadata/Slic3r_PE.config", "; fill_density = 15%"},
                                                    {"Metadata/model_settings.config", "<config/>"}}});
        row("a solid support beside",
            {.objects = mesh + mesh_3mf(box_mesh(Vec3(0, 0, -5), Vec3(1, 1, 0)), 2, "type=\"solidsupport\""),
             .items = "<item objectid=\"1\"/><item objectid=\"2\"/>"});
        row("vertices that nobody names",
            {.objects =
                 replaced_all(mesh, "</vertices>", "<vertex x=\"90\" y=\"90\" z=\"90\"/></vertices>")});
        row("turned about Z, and back",
            {.objects =
                 mesh
                 + components_3mf(2, "<component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 0\"/>"),
             .items = "<item objectid=\"2\" transform=\"0 -1 0 1 0 0 0 0 1 0 0 0\"/>"});
        row("smaller, and larger again",
            {.objects =
                 mesh
                 + components_3mf(2, "<component objectid=\"1\" transform=\".5 0 0 0 .5 0 0 0 .5 0 0 0\"/>"),
             .items = "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 0\"/>"});
        row("mirrored twice",
            {.objects =
                 mesh
                 + components_3mf(2, "<component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"),
             .items = "<item objectid=\"2\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"});
        row("not to be printed",
            {.objects = mesh,
             .items = "<item objectid=\"1\" partnumber=\"7-A\" q:printable=\"0\" xmlns:q=\"urn:q\"/>"});
    }
    void sound_files() {
        QFETCH(QByteArray, bytes);
        const LoadedMesh loaded = read_mesh(bytes.toStdString(), "a.3mf", {}, Progress());
        QCOMPARE(loaded.mesh->facet_count(), std::size_t(12));
        QVERIFY(loaded.report.watertight);
        QVERIFY(std::abs(loaded.report.file_volume - 24) < 1e-9);
        const Box3 box = loaded.mesh->box();
        QVERIFY(box.lo.norm() < 1e-9 && (box.hi - box_size).norm() < 1e-9);
    }

    void broken_files_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("expected");
        const auto raw = [](const char* tag, const std::string& bytes, const char* expected) {
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size())) << expected;
        };
        const auto row = [&](const char* tag, const Maker3mf& maker, const char* expected) {
            raw(tag, threemf_bytes(maker), expected);
        };
        const std::string mesh = box_object();
        const std::string model = Maker3mf{.objects = mesh}.model();
        row("a coordinate of blanks", {.objects = replaced_all(mesh, "x=\"2\"", "x=\"  \"")}, "syntax");
        row("two numbers in one", {.objects = replaced_all(mesh, "x=\"2\"", "x=\"2 0\"")}, "syntax");
        row("half a vertex's number", {.objects = replaced_all(mesh, "v1=\"4\"", "v1=\"4.5\"")}, "syntax");
        row("an attribute twice", {.objects = replaced_all(mesh, "x=\"2\"", "x=\"2\" x=\"2\"")}, "syntax");
        row("infinite", {.objects = replaced_all(mesh, "x=\"2\"", "x=\"INF\"")}, "non_finite");
        row("slices in place of a mesh",
            {.objects = replaced_all(mesh, "<object ", "<object s:meshresolution=\"lowres\" "),
             .model_attributes = "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\""},
            "unsupported_format");
        raw("a draft that nobody knows", with_model(replaced_all(model, "core/2015/02", "2012/01")),
            "syntax");
        raw("words of another encoding",
            with_model(replaced_all(model, "<object ",
                                    "<object name=\"B\xFC"
                                    "chse\" ")),
            "syntax");
        raw("two models in one", with_model(model + model.substr(model.find('\n') + 1)), "syntax");
        {
            std::string many;
            for (int k = 0; k < 3000; ++k)
                many += "<vertex x=\"0\" y=\"0\" z=\"1\"/>";
            std::string items;
            for (int k = 0; k < 60'000; ++k)
                items += "<item objectid=\"1\"/>";
            row("vertices of no facet, again and again",
                {.objects = replaced_all(mesh, "</vertices>", many + "</vertices>"), .items = items},
                "limit_exceeded");
        }
        {
            std::string bent = as_streamed(threemf_bytes({.objects = mesh}));
            bent[bent.find("PK\3\4", 30) + 80] ^= 0x55; // a byte of a packed file
            raw("damaged, and sizes said behind", bent, "syntax");
        }
    }
    void broken_files() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, expected);
        try {
            read_mesh(bytes.toStdString(), "a.3mf", {}, Progress());
            QVERIFY2(false, "it was read");
        } catch (const Error& e) {
            QCOMPARE(QString::fromStdString(std::string(code_name(e.code()))), expected);
            QVERIFY(!e.remedy().empty());
            QVERIFY(std::string(e.what()).find("a.3mf") != std::string::npos);
        }
    }
};

FACETMILL_TEST(TestThreemfKinds)
#include "test_threemf_kinds.moc"
