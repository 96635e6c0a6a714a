// Readers and writer format by format: what is accepted, what is refused and with which word, line and
// warning.
#include "core/base/text.h"
#include "core/base/tolerances.h"
#include "core/mesh/exact_area.h"
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_reader.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/gltf_support.h"
#include "tests/unit/mesh/mesh_io_support.h"
#include "tests/unit/mesh/picture_support.h"
#include "tests/unit/mesh/threemf_support.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <iterator>
#include <limits>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const Mesh& box() {
    static const Mesh mesh = box_mesh(Vec3(0, 0, 0), Vec3(20, 30, 40));
    return mesh;
}

/// The same triangles in the same order, whatever the numbering of the vertices.
bool same_triangles(const Mesh& a, const Mesh& b, double tolerance = 0.0) {
    if (a.facets.size() != b.facets.size()) return false;
    for (std::size_t f = 0; f < a.facets.size(); ++f)
        for (int k = 0; k < 3; ++k)
            if ((a.corner(f, k) - b.corner(f, k)).cwiseAbs().maxCoeff() > tolerance) return false;
    return true;
}

Mesh moved_box() {
    return box_mesh(Vec3(100, 0, 0), Vec3(101, 1, 1));
}

#define COMPARE_TEXT(found, expected)                                                                        \
    QCOMPARE(QString::fromStdString(found), QString::fromStdString(expected))

} // namespace

class TestMeshFormats : public QObject {
    Q_OBJECT
private slots:

    void every_format_gives_the_same_mesh_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("format");
        const auto row = [](const char* tag, const std::string& bytes, const char* name, const char* format) {
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size())) << name << format;
        };
        row("binary STL", binary_stl(box()), "a.stl", "STL binary");
        row("ASCII STL", ascii_stl(box()), "a.STL", "STL ASCII");
        row("OBJ", obj_text(box()), "a.obj", "OBJ");
        row("ASCII PLY", ascii_ply(box()), "a.ply", "PLY ASCII");
        row("little endian PLY", binary_ply(box(), false), "a.ply", "PLY binary");
        row("big endian PLY", binary_ply(box(), true), "a.ply", "PLY binary");
        // Without a known extension the content decides.
        row("binary STL by content", binary_stl(box()), "a", "STL binary");
        row("ASCII STL by content", ascii_stl(box()), "dir.d/a.txt", "STL ASCII");
        row("OBJ by content", obj_text(box()), "a.mesh", "OBJ");
        row("PLY by content", binary_ply(box(), true), "a.mesh", "PLY binary");
    }
    void every_format_gives_the_same_mesh() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        QFETCH(QString, format);
        const LoadedMesh loaded = read(bytes.toStdString(), name.toStdString());
        QVERIFY(same_triangles(*loaded.mesh, box()));
        QCOMPARE(QString::fromStdString(loaded.report.format), format);
        QCOMPARE(loaded.report.facets, std::size_t(12));
        QCOMPARE(loaded.report.welded_vertices, std::size_t(8));
        QCOMPARE(loaded.report.vertices, std::size_t(8));
        QVERIFY(loaded.report.watertight);
        QVERIFY(std::abs(loaded.report.file_volume - 24000) < 1e-9);
        QVERIFY(std::abs(loaded.report.file_area - 2 * (600 + 800 + 1200)) < 1e-9);
        QVERIFY(loaded.report.warnings.empty());
        // Numbered by first occurrence among the corners.
        Index next = 0;
        for (const Facet& f : loaded.mesh->facets)
            for (const Index v : f) {
                QVERIFY(v <= next);
                next = std::max(next, v + 1);
            }
        // Inches.
        const LoadedMesh inch = read(bytes.toStdString(), name.toStdString(), LengthUnit::inch);
        Mesh larger = box();
        for (Vec3& v : larger.vertices)
            v *= 25.4;
        QVERIFY(same_triangles(*inch.mesh, larger, 1e-12));
        QVERIFY(std::abs(inch.report.file_volume - 24000) < 1e-8);
        QVERIFY((inch.report.file_box.hi - Vec3(20, 30, 40)).norm() == 0.0);
        QVERIFY((inch.report.box_mm().hi - 25.4 * Vec3(20, 30, 40)).norm() < 1e-9);
    }

    /// Every content is claimed by its own format and by no other.
    void the_table_of_formats_is_consistent() {
        struct Sample {
            std::string_view format;
            std::string bytes;
        };
        const std::vector<Sample> samples = {{"STL", binary_stl(box())},
                                             {"STL", binary_stl(box(), "solid but binary")},
                                             {"STL", ascii_stl(box())},
                                             {"STL", "\xEF\xBB\xBF " + ascii_stl(box())},
                                             {"OBJ", obj_text(box())},
                                             {"PLY", ascii_ply(box())},
                                             {"PLY", replaced_all(ascii_ply(box()), "\n", "\r\n")},
                                             {"PLY", binary_ply(box(), false)},
                                             {"PLY", binary_ply(box(), true)},
                                             {"3MF", threemf_bytes({.objects = mesh_3mf(box())})},
                                             {"STEP", "ISO-10303-21;\nHEADER;\n"},
                                             {"IGES", std::string(72, ' ') + "S      1\n"},
                                             {"glTF", GltfMaker().glb()},
                                             {"glTF", GltfMaker().text()},
                                             {"PNG", PngMaker().bytes()},
                                             {"TIFF", TiffMaker().bytes()}};
        std::set<std::string_view> names, extensions;
        for (const MeshFormat& format : mesh_formats()) {
            QVERIFY(names.insert(format.name).second);
            QVERIFY(format.label.starts_with('a') && format.label.find(format.name) != std::string::npos);
            QVERIFY(!format.extensions.empty());
            for (const std::string_view extension : format.extensions) {
                QVERIFY(extensions.insert(extension).second);
                QVERIFY(extension.size() > 1 && extension[0] == '.');
                for (const char c : extension)
                    QVERIFY(c == '.' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'));
                QCOMPARE(mesh_format_of(extension), &format);
            }
            std::size_t own = 0;
            for (const Sample& sample : samples) {
                QCOMPARE(format.sniff(sample.bytes), format.name == sample.format);
                own += format.name == sample.format;
            }
            QVERIFY2(own > 0, "a format without a sample");
            // Nor is a file claimed that was cut after one of its first lines.
            for (const Sample& sample : samples)
                for (std::size_t n = 1; n < std::min<std::size_t>(sample.bytes.size(), 400); ++n)
                    if (format.name != sample.format && sample.bytes[n - 1] == '\n')
                        QVERIFY(!format.sniff(sample.bytes.substr(0, n)));
        }
        for (const Sample& sample : samples) {
            if (mesh_format_of("." + in_small_letters(std::string(sample.format)))->has_surfaces) continue;
            const LoadedMesh loaded = read(sample.bytes, "no extension");
            if (sample.format == "glTF") { // floats of metres
                QCOMPARE(loaded.mesh->facet_count(), std::size_t(12));
                continue;
            }
            QVERIFY(loaded.report.format.starts_with(sample.format));
            QVERIFY(loaded.report.is_relief || same_triangles(*loaded.mesh, box(), 1e-12));
        }
        QCOMPARE(mesh_format_of(".step"), mesh_format_of(".stp"));
        QCOMPARE(mesh_format_of(".brep"), nullptr);
        QCOMPARE(mesh_format_of(""), nullptr);
        for (const MeshFormat& format : mesh_formats())
            QVERIFY(mesh_format_names().find(format.name) != std::string::npos);
        QVERIFY(mesh_format_names(" or ").find(" or ") != std::string::npos);
    }

    void other_formats_are_refused_by_name_and_by_content() {
        for (const char* name : {"a.brep", "a.sldprt", "a.amf", "a.off"})
            COMPARE_TEXT(outcome("ISO-10303-21;\nHEADER;\n", name), "unsupported_format");
        COMPARE_TEXT(outcome("ISO-10303-21;\nHEADER;\n", "part"), "truncated");
        COMPARE_TEXT(outcome(std::string("PK\x03\x04", 4) + std::string(200, 'x'), "part"),
                     "unsupported_format");
        QVERIFY(error_line("ISO-10303-21;\n", "x.brep").find("3MF, glTF, STEP, IGES, PNG or TIFF") < 1000);
        QVERIFY(error_line("ISO-10303-21;\n", "x").find("STEP") != std::string::npos);
        for (const char* name : {"a.obj", "a"})
            COMPARE_TEXT(outcome("", name), "empty_file");
        // The extension holds: another content under it is refused, and named.
        COMPARE_TEXT(outcome(ascii_stl(box()), "a.ply"), "syntax");
        for (const std::string& bytes : {ascii_stl(box()), binary_ply(box(), false), binary_stl(box())})
            COMPARE_TEXT(outcome(bytes, "a.obj"), "syntax");
        COMPARE_TEXT(outcome(obj_text(box()), "a.stl"), "not_stl");
        QVERIFY(error_line(obj_text(box()), "a.stl").find("OBJ") != std::string::npos);
    }

    /// As some writers have it; also before another solid, and as the name of nothing else.
    void end_solid_in_two_words() {
        const std::string text = ascii_stl(box());
        for (const char* words : {"end solid", "END  SOLID", "end\tsolid"}) {
            COMPARE_TEXT(outcome(replaced_all(text, "endsolid", words), "a.stl"), "ok");
            COMPARE_TEXT(
                outcome(replaced_all(text, "endsolid part", words) + ascii_stl(moved_box()), "a.stl"),
                "ok,multiple_shells,multiple_solids");
        }
        // A sheet, which is no longer taken for a file that was cut.
        std::string sheet = text;
        const std::size_t begin = sheet.find("facet "), end = sheet.find("endfacet\n") + 9;
        sheet.erase(begin, end - begin);
        COMPARE_TEXT(outcome(replaced_all(sheet, "endsolid", "end solid"), "a.stl"), "ok,open_edges");
        COMPARE_TEXT(outcome(replaced_all(sheet, "endsolid part", "end"), "a.stl"), "truncated");
        COMPARE_TEXT(outcome(replaced_all(sheet, "endsolid part", "end\nsolid"), "a.stl"), "truncated");
    }

    /// Binary files in which a transfer as text has made every LF a CR LF.
    void binary_stl_sent_as_text() {
        std::size_t sent = 0;
        for (const char* header : {"test", "solid test", "a line\nand another"})
            for (Index around = 8; around < 40; ++around) {
                const std::string sound = binary_stl(torus_mesh(around, 10), header);
                COMPARE_TEXT(outcome(sound, "a.stl").substr(0, 2), "ok");
                const std::string damaged = replaced_all(sound, "\n", "\r\n");
                if (damaged == sound || sound.find("\r\n") != std::string::npos) continue;
                ++sent;
                const std::string line = error_line(damaged, "a.stl");
                QVERIFY2(line.find("transfer as text") != std::string::npos, line.c_str());
            }
        QVERIFY(sent > 20);
        // What merely has bytes behind its end, among them such pairs, is read on.
        COMPARE_TEXT(outcome(binary_stl(box()) + "\r\n", "a.stl"), "ok,trailing_data");
    }

    void files_that_are_none() {
        const auto code = [](const std::string& path) {
            try {
                load_mesh(path, LengthUnit::mm, Progress());
            } catch (const Error& e) {
                return std::string(code_name(e.code()));
            }
            return std::string("ok");
        };
        QTemporaryDir folder;
        const std::string in = folder.path().toStdString();
        COMPARE_TEXT(code(in + "/none.stl"), "not_found");
        COMPARE_TEXT(code(in), "is_directory");
        std::ofstream(in + "/empty.stl").close();
        COMPARE_TEXT(code(in + "/empty.stl"), "empty_file");
    }

    // STL
    // -------------------------------------------------------------------------------------------------------------

    void binary_counts() {
        const std::string good = binary_stl(box());
        const auto with_count = [&](std::uint32_t count, const std::string& tail = {}) {
            std::string bytes = good + tail;
            std::memcpy(&bytes[80], &count, 4);
            return outcome(bytes, "a.stl");
        };
        COMPARE_TEXT(with_count(12), "ok");
        COMPARE_TEXT(with_count(0), "ok,count_wrong");
        COMPARE_TEXT(with_count(5), "ok,count_wrong");
        COMPARE_TEXT(with_count(0xFFFFFFFFu), "ok,count_wrong");
        COMPARE_TEXT(with_count(13), "truncated");
        COMPARE_TEXT(with_count(12, "end"), "ok,trailing_data");
        COMPARE_TEXT(with_count(10, "end"), "ok,open_edges,trailing_data");
        COMPARE_TEXT(with_count(0, "end"), "count_mismatch");
        COMPARE_TEXT(with_count(13, "end"), "truncated");
        COMPARE_TEXT(with_count(0xFFFFFFFFu, "end"), "truncated");
        std::string damaged = good + "end"; // most facets of the twelve are noise
        for (std::size_t i = 84; i < 600; ++i)
            damaged[i] = char(i * 2654435761u >> 13);
        COMPARE_TEXT(outcome(damaged, "a.stl"), "count_mismatch");
    }

    void binary_attributes() {
        std::string bytes = binary_stl(box());
        bytes[84 + 50 * 7 + 48] = 5;
        COMPARE_TEXT(outcome(bytes, "a.stl"), "ok,attribute_data");
        std::string payload = binary_stl(box()).substr(0, 84);
        for (std::size_t f = 0; f < 12; ++f) {
            std::string record = binary_stl(box()).substr(84 + 50 * f, 50);
            record[48] = char(f % 4 * 3); // none with the first
            payload += record + std::string(f % 4 * 3, 'p');
        }
        COMPARE_TEXT(outcome(payload, "a.stl"), "ok,attribute_payload");
        QVERIFY(same_triangles(*read(payload, "a.stl").mesh, box()));
    }

    void binary_bytes_reversed() {
        std::string bytes = binary_stl(box());
        std::reverse(&bytes[80], &bytes[80] + 4);
        for (std::size_t f = 0; f < 12; ++f)
            for (std::size_t w = 0; w < 12; ++w)
                std::reverse(&bytes[84 + 50 * f + 4 * w], &bytes[84 + 50 * f + 4 * w] + 4);
        COMPARE_TEXT(outcome(bytes, "a.stl"), "ok,big_endian");
        QVERIFY(same_triangles(*read(bytes, "a.stl").mesh, box()));
    }

    void binary_headers() {
        COMPARE_TEXT(outcome(binary_stl(box(), "solid a\nfacet normal 0 0 1\nouter loop\nvertex"), "a.stl"),
                     "ok,binary_solid_header");
        COMPARE_TEXT(outcome(binary_stl(box(), "solid " + std::string(74, ' ')) + "\r\n", "a.stl"),
                     "ok,binary_solid_header,trailing_data");
        COMPARE_TEXT(outcome(binary_stl(box(), std::string(80, 'h')), "a.stl"), "ok");
        COMPARE_TEXT(outcome(binary_stl(box(), "solidarity"), "a.stl"), "ok");
        COMPARE_TEXT(read(binary_stl(box(), "my part  "), "a.stl").report.name, "my part");
        // A header of text alone is not a text file.
        const std::string cut = binary_stl(box(), std::string(80, 'h'));
        for (const std::size_t size : {84u, 85u, 90u, 133u, 134u})
            COMPARE_TEXT(outcome(cut.substr(0, size), "a.stl"), "truncated");
    }

    void negative_zero_is_zero() {
        Mesh sheet;
        sheet.vertices = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {-0.0, 0, -0.0}, {0, 9, 0}, {9, 9, -0.0}};
        sheet.facets = {{0, 1, 2}, {3, 5, 4}};
        for (const std::string& bytes : {binary_stl(sheet), ascii_stl(sheet)}) {
            const LoadedMesh loaded = read(bytes, "a.stl");
            QCOMPARE(loaded.report.welded_vertices, std::size_t(4));
            for (const Vec3& v : loaded.mesh->vertices)
                for (int i = 0; i < 3; ++i)
                    QVERIFY(!std::signbit(v[i]));
        }
    }

    void ascii_variants() {
        const std::string good = ascii_stl(box());
        COMPARE_TEXT(outcome(replaced_all(good, "\n", "\r"), "a.stl"), "ok");
        COMPARE_TEXT(outcome(replaced_all(good, "\n", "\r\n"), "a.stl"), "ok");
        COMPARE_TEXT(outcome(replaced_all(good, "\n", " "), "a.stl"), "ok");
        COMPARE_TEXT(outcome(replaced_all(good, " ", "\t\t"), "a.stl"), "ok");
        COMPARE_TEXT(outcome("\xEF\xBB\xBF \n" + good, "a.stl"), "ok");
        COMPARE_TEXT(outcome(replaced_all(good, "vertex", "VerTex"), "a.stl"), "ok");
        COMPARE_TEXT(outcome(replaced_all(good, " 20 ", " +2.0D+001 "), "a.stl"), "ok");
        COMPARE_TEXT(outcome(replaced_all(good, " 20 ", " 20,0 "), "a.stl"), "ok,comma_decimal");
        COMPARE_TEXT(outcome(replaced(replaced_all(good, " 20 ", " 20,0 "), " 30 ", " 30.0 "), "a.stl"),
                     "syntax");
        COMPARE_TEXT(outcome(replaced_all(good, " 20 ", " 2,000,0 "), "a.stl"), "syntax");
        COMPARE_TEXT(outcome(replaced(good, "facet normal 0 0 -1", "facet normal"), "a.stl"),
                     "ok,bad_normals");
        COMPARE_TEXT(outcome(replaced(good, "facet normal 0 0 -1", "facet"), "a.stl"), "ok,bad_normals");
        COMPARE_TEXT(outcome(replaced(good, "normal 0 0 -1", "normal 0 nan -1.#IND00"), "a.stl"),
                     "ok,bad_normals");
        COMPARE_TEXT(outcome(replaced(good, "normal 0 0 -1", "normal 0 0 1"), "a.stl"),
                     "ok,normals_disagree");
        COMPARE_TEXT(outcome(replaced(good, "normal 0 0 -1", "normal 0 -1"), "a.stl"), "syntax");
        COMPARE_TEXT(outcome(replaced(good, "endfacet\n", "endfacet\nattribute 12\n"), "a.stl"),
                     "ok,unknown_lines");
        COMPARE_TEXT(outcome(good + "some words\n", "a.stl"), "ok,trailing_data");
        COMPARE_TEXT(outcome(good + std::string(64, '\0'), "a.stl"), "ok,trailing_data");
        COMPARE_TEXT(outcome(good + "\x1A", "a.stl"), "ok,trailing_data");
        COMPARE_TEXT(outcome(good + "\n \n", "a.stl"), "ok");
    }

    void ascii_solids() {
        const std::string good = ascii_stl(box());
        const std::string second = ascii_stl(box_mesh(Vec3(50, 0, 0), Vec3(60, 10, 10)), "second");
        const std::string both = "multiple_shells,multiple_solids";
        COMPARE_TEXT(outcome(good + second, "a.stl"), "ok," + both);
        COMPARE_TEXT(outcome(good + "junk\n" + second, "a.stl"), "ok," + both + ",unknown_lines");
        COMPARE_TEXT(outcome(good + "a solid note\n" + second + "solid end\n", "a.stl"),
                     "ok,empty_solid,missing_endsolid," + both + ",unknown_lines");
        COMPARE_TEXT(outcome(good + "remarks\nsolid work\n", "a.stl"), "ok,trailing_data");
        // All on one line: the name behind endsolid must not swallow the second solid.
        COMPARE_TEXT(outcome(replaced_all(good + second, "\n", " "), "a.stl"), "ok," + both);
        QCOMPARE(read(replaced_all(good + second, "\n", " "), "a.stl").report.facets, std::size_t(24));
        // Facets behind endsolid belong to nothing: refused, not lost.
        COMPARE_TEXT(outcome(replaced(good, "endfacet\n", "endfacet\nendsolid part\n"), "a.stl"), "syntax");
        COMPARE_TEXT(
            outcome(replaced_all(replaced(good, "endfacet\n", "endfacet\nendsolid part\n"), "\n", " "),
                    "a.stl"),
            "syntax");
        COMPARE_TEXT(outcome("solid a\nendsolid a\n" + good, "a.stl"), "ok,empty_solid,multiple_solids");
        COMPARE_TEXT(outcome("solid a\nendsolid a\n", "a.stl"), "no_facets");
        COMPARE_TEXT(
            read(ascii_stl(box(), "facet normal 1 2 3 outer loop vertex endsolid"), "a.stl").report.name,
            "facet normal 1 2 3 outer loop vertex endsolid");
        QCOMPARE(read(ascii_stl(box(), std::string(5000, 'n')), "a.stl").report.name.size(),
                 std::size_t(203));
    }

    void ascii_end() {
        const std::string good = ascii_stl(box());
        COMPARE_TEXT(outcome(replaced(good, "endsolid part\n", ""), "a.stl"), "ok,missing_endsolid");
        Mesh open = box();
        open.facets.pop_back();
        COMPARE_TEXT(outcome(ascii_stl(open), "a.stl"), "ok,open_edges");
        COMPARE_TEXT(outcome(replaced(ascii_stl(open), "endsolid part\n", ""), "a.stl"), "truncated");
        COMPARE_TEXT(outcome(replaced(good, "endsolid part\n", "fac"), "a.stl"), "truncated");
    }

    void ascii_refused() {
        const std::string good = ascii_stl(box());
        const auto changed = [&](const char* from, const char* to) {
            return outcome(replaced(good, from, to), "a.stl");
        };
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 30"), "syntax");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 30 0 0"), "syntax");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 30mm 0"), "syntax");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 0x1E 0"), "syntax");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 3e 0"), "syntax");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 - 0"), "syntax");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 inf 0"), "non_finite");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 -1.#INF 0"), "non_finite");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 -nan(ind) 0"), "non_finite");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 1e999 0"), "coordinate_range");
        COMPARE_TEXT(changed("vertex 0 30 0", "vertex 0 10000001 0"), "coordinate_range");
        COMPARE_TEXT(changed("vertex 0 30 0\n", "vertex 0 30 0\nvertex 1 1 0\n"), "not_triangles");
        COMPARE_TEXT(changed("  vertex 0 30 0\n", ""), "syntax");
        COMPARE_TEXT(changed(" endloop\n", ""), "syntax");
        COMPARE_TEXT(changed("endfacet\n", ""), "syntax");
        COMPARE_TEXT(changed("outer loop", "outerloop"), "syntax");
        COMPARE_TEXT(changed("facet normal", "fadet normal"), "syntax");
        QVERIFY(error_line(replaced(good, "vertex 0 30 0", "vertex 0 x 0"), "a.stl")
                    .starts_with("a.stl, line 5: "));
        QVERIFY(
            error_line(replaced_all(replaced(good, "vertex 0 30 0", "vertex 0 x 0"), "\n", "\r\n"), "a.stl")
                .starts_with("a.stl, line 5: "));
        QVERIFY(error_line(replaced_all(replaced(good, "vertex 0 30 0", "vertex 0 x 0"), "\n", "\r"), "a.stl")
                    .starts_with("a.stl, line 5: "));
    }

    /// Long files are read in pieces side by side; the result must be that of one piece, also where a name or
    /// an unknown line imitates a facet.
    void ascii_in_pieces() {
        const Mesh torus = torus_mesh(100, 80);
        const std::string good = ascii_stl(torus);
        QVERIFY(good.size() > (std::size_t(4) << 20));
        const LoadedMesh loaded = read(good, "a.stl");
        QVERIFY(same_triangles(*loaded.mesh, torus));
        QVERIFY(loaded.report.warnings.empty());
        COMPARE_TEXT(outcome(replaced(good, "endsolid part\n", ""), "a.stl"), "ok,missing_endsolid");
        const std::string middle = replaced(good, "endfacet\n", "endfacet\nendsolid a\nsolid b\n", 7000);
        COMPARE_TEXT(outcome(middle, "a.stl"), "ok,multiple_solids");
        COMPARE_TEXT(outcome(replaced(good, "endfacet\n", "endfacet\nsolid b\n", 7000), "a.stl"),
                     "ok,missing_endsolid,multiple_solids");
        std::string fake;
        while (fake.size() < 3'000'000)
            fake += "endfacet facet ";
        const std::string lines = replaced(good, "endfacet\n", "endfacet\nnote " + fake + "\n", 7000);
        COMPARE_TEXT(outcome(lines, "a.stl"), "ok,unknown_lines");
        QVERIFY(same_triangles(*read(lines, "a.stl").mesh, torus));
        QVERIFY(
            same_triangles(*read(replaced(good, "solid part", "solid part " + fake), "a.stl").mesh, torus));
        const std::string bad = replaced(good, "vertex", "vrtex", 30'000);
        COMPARE_TEXT(outcome(bad, "a.stl"), "syntax");
        const std::size_t line =
            std::size_t(std::count(bad.begin(), bad.begin() + std::ptrdiff_t(bad.find("vrtex")), '\n'));
        QVERIFY(error_line(bad, "a.stl").starts_with("a.stl, line " + std::to_string(line + 1) + ":"));
        COMPARE_TEXT(outcome(replaced_all(good, ".", ","), "a.stl"), "ok,comma_decimal");
    }

    // OBJ
    // -------------------------------------------------------------------------------------------------------------

    void obj_index_forms() {
        const std::string vertices = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nvt 0 0\nvn 0 0 1\n";
        const std::string expected = "ok,open_edges";
        for (const char* face :
             {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f -4 -3 -2",
              "f -4/-1/-1 -3//-1 -2/-1", "  f\t1  2 3  # last", "f 1 \\\n 2 3", "f 1 2\\\r\n 3"}) {
            const std::string text = vertices + face + "\n";
            COMPARE_TEXT(outcome(text, "a.obj"), expected);
            const LoadedMesh loaded = read(text, "a.obj");
            QCOMPARE(loaded.mesh->facets.size(), std::size_t(1));
            QVERIFY(loaded.mesh->corner(0, 1) == Vec3(9, 0, 0) && loaded.mesh->corner(0, 2) == Vec3(9, 9, 0));
        }
        COMPARE_TEXT(outcome("f 1 2 3\n" + vertices, "a.obj"), expected); // vertices that come later
        for (const char* face :
             {"f 1 2", "f 1 2 0", "f 1 2 5", "f 1 2 -5", "f 1 2 x", "f 1 2 3.5", "f 1/ 2/ 3/", "f 1 2 /3",
              "f 1/1/1/1 2 3", "f 1 2 99999999999999999999", "f 1 2 4294967297", "f 1 2 3//", "f"}) {
            COMPARE_TEXT(outcome(vertices + face + "\nv 1 1 1\n", "a.obj"),
                         std::string(face) == "f 1 2 5" ? expected : "syntax");
            if (std::string(face) != "f 1 2 5")
                QVERIFY2(error_line(vertices + face + "\ng\n", "a.obj").starts_with("a.obj, line 7: "), face);
        }
        COMPARE_TEXT(outcome(vertices + "f 1 2 6\n", "a.obj"), "syntax");
    }

    void obj_vertices() {
        const std::string face = "v 9 0 0\nv 9 9 0\nf 1 2 3\n";
        for (const char* v :
             {"v 0 0 0", "v 0 0 0 1", "v 0 0 0 0.5 0.5 0.5", "v 0 0 0 1 0.5 0.5 0.5", "v +0 -0. .0e0"})
            COMPARE_TEXT(outcome(std::string(v) + "\n" + face, "a.obj"), "ok,open_edges");
        COMPARE_TEXT(outcome("v 0 0 0 2\n" + face, "a.obj"), "ok,open_edges,weights_ignored");
        for (const char* v :
             {"v 0 0", "v", "v 0 0 0 1 1", "v 0 0 0 1 1 1 1 1", "v 0 0 z", "v 0 0 0x1", "v 0 0 1,5"})
            COMPARE_TEXT(outcome(std::string(v) + "\n" + face, "a.obj"), "syntax");
        COMPARE_TEXT(outcome("v 0 0 nan\n" + face, "a.obj"), "non_finite");
        COMPARE_TEXT(outcome("v 0 0 1e8\n" + face, "a.obj"), "coordinate_range");
        COMPARE_TEXT(outcome("v 0 0 1e999\n" + face, "a.obj"), "coordinate_range");
    }

    void obj_statements() {
        const std::string text = obj_text(box());
        COMPARE_TEXT(outcome(text + "g a b\ns off\nusemtl m\nmtllib \xC3\xBC.mtl\n\n# end\n", "a.obj"), "ok");
        COMPARE_TEXT(outcome(text + "l 1 2\np 3\n", "a.obj"), "ok,lines_ignored");
        COMPARE_TEXT(outcome(text + "surf 0 1 0 1 1 2 3\n", "a.obj"), "ok,free_form_ignored");
        COMPARE_TEXT(outcome(text + "frobnicate 1\n", "a.obj"), "ok,unknown_lines");
        COMPARE_TEXT(outcome(text.substr(0, text.size() - 1), "a.obj"), "ok,unterminated_line");
        COMPARE_TEXT(outcome(text + "f 1 2", "a.obj"), "truncated");
        COMPARE_TEXT(outcome("v 0 0 0\nv 1 0 0\n", "a.obj"), "no_facets");
        COMPARE_TEXT(read(text, "a.obj").report.name, "part");
        QVERIFY(same_triangles(*read(replaced_all(text, "\n", "\r"), "a.obj").mesh, box()));
    }

    void obj_polygons() {
        // A convex pentagon, a quadrangle with a notch at its first corner's fan, and one whose second corner
        // is on an edge.
        const auto area_of = [](const std::string& text, std::size_t facets) {
            const LoadedMesh loaded = read(text, "a.obj");
            return loaded.report.facets == facets && loaded.report.degenerate == 0 ? loaded.report.file_area
                                                                                   : -1.0;
        };
        const std::string pentagon = "v 0 0 0\nv 9 0 0\nv 12 6 0\nv 6 9 0\nv 0 6 0\nf 1 2 3 4 5\n";
        COMPARE_TEXT(outcome(pentagon, "a.obj"), "ok,open_edges,polygons_triangulated");
        QVERIFY(std::abs(area_of(pentagon, 3) - 81.0) < 1e-9);
        QCOMPARE(read(pentagon, "a.obj").report.open_edges, std::size_t(5));
        // Arrow head: the fan from the first corner would fold over.
        const std::string arrow = "v 0 0 5\nv 10 10 5\nv 2 0 5\nv 10 -10 5\nf 4 2 1 3\nf 1 4 3 2\n";
        const LoadedMesh folded = read(replaced(arrow, "f 4 2 1 3\n", "f 2 1 4 3\n"), "a.obj");
        COMPARE_TEXT(outcome("v 0 0 5\nv 10 10 5\nv 2 0 5\nv 10 -10 5\nf 4 3 2 1\n", "a.obj"),
                     "ok,open_edges,polygons_triangulated");
        QVERIFY(std::abs(area_of("v 0 0 5\nv 10 10 5\nv 2 0 5\nv 10 -10 5\nf 4 3 2 1\n", 2) - 20.0) < 1e-9);
        QVERIFY(std::abs(area_of("v 0 0 5\nv 10 10 5\nv 2 0 5\nv 10 -10 5\nf 2 1 4 3\n", 2) - 20.0) < 1e-9);
        QCOMPARE(folded.report.facets, std::size_t(4));
        // A U of eight corners.
        const std::string u = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 6 9 0\nv 6 3 0\nv 3 3 0\nv 3 9 0\nv 0 9 0\n";
        QVERIFY(std::abs(area_of(u + "f 3 4 5 6 7 8 1 2\n", 6) - (81 - 18)) < 1e-9);
        QVERIFY(std::abs(area_of(u + "f 8 7 6 5 4 3 2 1\n", 6) - (81 - 18)) < 1e-9);
        // A corner in the middle of a side takes part in a triangle with area.
        QVERIFY(std::abs(area_of("v 0 0 0\nv 5 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nf 1 2 3 4 5\n", 3) - 81.0)
                < 1e-9);
        COMPARE_TEXT(outcome("v 0 0 0\nv 9 9 0\nv 9 0 0\nv 0 9 0\nv 4 12 0\nf 1 2 3 4 5\n", "a.obj"),
                     "ok,open_edges,polygons_folded,polygons_triangulated");
    }

    // PLY
    // -------------------------------------------------------------------------------------------------------------

    void ply_layouts() {
        // Properties in another order, other types, more elements before, between and behind, lists to pass
        // over.
        for (const bool big : {false, true}) {
            std::string bytes =
                std::string("ply\r\nformat binary_") + (big ? "big" : "little")
                + "_endian 1.0\r\nobj_info x\r\nelement junk 2\r\nproperty list ushort double d\r\n"
                  "property char c\r\nelement vertex 4\r\nproperty uchar red\r\nproperty float z\r\n"
                  "property list uchar short l\r\nproperty short x\r\nproperty double y\r\n"
                  "element edge 3\r\nproperty int a\r\nproperty int b\r\nelement face 2\r\n"
                  "property float quality\r\nproperty list uint16 uint8 vertex_index\r\n"
                  "property list uchar float texcoord\r\nend_header\r\n";
            const auto put = [&]<class T>(T value) { append_raw(bytes, &value, sizeof value, big); };
            for (int i = 0; i < 2; ++i) {
                put(std::uint16_t(i * 3));
                for (int k = 0; k < 3 * i; ++k)
                    put(double(k));
                put(std::int8_t(-1));
            }
            const double points[4][3] = {{0, 0, 1}, {-9, 0, 1}, {-9, -9, 1.5}, {0, -9, 1}};
            for (const auto& p : points) {
                put(std::uint8_t(255));
                put(float(p[2]));
                put(std::uint8_t(2));
                put(std::int16_t(7));
                put(std::int16_t(7));
                put(std::int16_t(p[0]));
                put(p[1]);
            }
            for (int i = 0; i < 6; ++i)
                put(std::int32_t(i));
            put(1.0f);
            put(std::uint16_t(3));
            for (const int v : {0, 1, 2})
                put(std::uint8_t(v));
            put(std::uint8_t(0));
            put(1.0f);
            put(std::uint16_t(3));
            for (const int v : {0, 2, 3})
                put(std::uint8_t(v));
            put(std::uint8_t(1));
            put(0.5f);
            COMPARE_TEXT(outcome(bytes, "a.ply"), "ok,open_edges");
            const LoadedMesh loaded = read(bytes, "a.ply");
            QVERIFY(loaded.mesh->corner(0, 2) == Vec3(-9, -9, 1.5)
                    && loaded.mesh->corner(1, 2) == Vec3(0, -9, 1));
            COMPARE_TEXT(outcome(bytes + "x", "a.ply"), "ok,open_edges,trailing_data");
            for (std::size_t size = bytes.size() - 1; size > 5; --size)
                COMPARE_TEXT(outcome(bytes.substr(0, size), "a.ply"), "truncated");
        }
    }

    void ply_text() {
        const std::string good = ascii_ply(box());
        COMPARE_TEXT(outcome(replaced_all(good, "\n", "\r\n"), "a.ply"), "ok");
        COMPARE_TEXT(outcome(replaced_all(good, "\n", "\r"), "a.ply"), "ok");
        COMPARE_TEXT(outcome(good + "\n\n", "a.ply"), "ok");
        COMPARE_TEXT(outcome(good + "3 0 1 2\n", "a.ply"), "ok,trailing_data");
        COMPARE_TEXT(outcome(good.substr(0, good.size() - 1), "a.ply"), "ok,unterminated_line");
        COMPARE_TEXT(outcome(good.substr(0, good.rfind('\n', good.size() - 2) + 1), "a.ply"), "truncated");
        const auto changed = [&](const char* from, const char* to) {
            return outcome(replaced(good, from, to), "a.ply");
        };
        COMPARE_TEXT(changed("20 30 40\n", "20 30\n"), "syntax");
        COMPARE_TEXT(changed("20 30 40\n", "20 30 40 1\n"), "syntax");
        COMPARE_TEXT(changed("20 30 40\n", "20 30 nan\n"), "non_finite");
        COMPARE_TEXT(changed("20 30 40\n", "20 30 1e30\n"), "coordinate_range");
        COMPARE_TEXT(changed("20 30 40\n", "20 30 4x\n"), "syntax");
        COMPARE_TEXT(changed("3 0 2 3\n", "3 0 2 8\n"), "syntax");
        COMPARE_TEXT(changed("3 0 2 3\n", "3 0 2 -3\n"), "syntax");
        COMPARE_TEXT(changed("3 0 2 3\n", "3 0 2 1.5\n"), "syntax");
        COMPARE_TEXT(changed("3 0 2 3\n", "-3 0 2 3\n"), "syntax");
        COMPARE_TEXT(changed("3 0 2 3\n", "2 0 2\n"), "ok,lines_ignored,open_edges");
        COMPARE_TEXT(changed("3 0 2 3\n", "4 0 2 3 1\n"),
                     "ok,duplicate_facets,non_manifold_edges,polygons_triangulated");
    }

    void ply_headers() {
        const std::string good = ascii_ply(box());
        const auto changed = [&](const std::string& from, const std::string& to) {
            return outcome(replaced(good, from, to), "a.ply");
        };
        COMPARE_TEXT(changed("ply\n", "plx\n"), "syntax");
        COMPARE_TEXT(changed("format ascii 1.0\n", ""), "syntax");
        COMPARE_TEXT(changed("ascii", "asci"), "syntax");
        COMPARE_TEXT(changed("1.0", "2.0"), "syntax");
        COMPARE_TEXT(changed("property double z", "property double w"), "syntax");
        COMPARE_TEXT(changed("property double z", "property longdouble z"), "syntax");
        COMPARE_TEXT(changed("vertex_indices", "corners"), "syntax");
        COMPARE_TEXT(changed("list uchar int", "list float int"), "syntax");
        COMPARE_TEXT(changed("list uchar int", "list uchar float"), "syntax");
        COMPARE_TEXT(changed("element face 12", "element face x"), "syntax");
        COMPARE_TEXT(changed("element face 12", "element face -1"), "syntax");
        COMPARE_TEXT(changed("element face 12", "element vertex 12"), "syntax");
        COMPARE_TEXT(changed("comment a part", "remark"), "syntax");
        COMPARE_TEXT(changed("element face", "element tristrips"), "ok"); // each a strip of one
        COMPARE_TEXT(changed("element face", "element edge"), "no_facets");
        COMPARE_TEXT(changed("element face 12", "element face 0"), "no_facets");
        COMPARE_TEXT(changed("element face 12", "element face 13"), "truncated");
        // Counts that lie by far: refused before memory is taken for them.
        for (const char* count : {"4000000000", "18446744073709551615", "99999999999999999999999"}) {
            const std::string words = std::string(count).size() > 20 ? "syntax" : "truncated";
            COMPARE_TEXT(changed("element face 12", std::string("element face ") + count), words);
            COMPARE_TEXT(changed("element vertex 8", std::string("element vertex ") + count), words);
            for (const bool big : {false, true}) {
                const std::string binary = binary_ply(box(), big);
                COMPARE_TEXT(
                    outcome(replaced(binary, "element face 12", std::string("element face ") + count),
                            "a.ply"),
                    words);
                COMPARE_TEXT(
                    outcome(replaced(binary, "element vertex 8", std::string("element vertex ") + count),
                            "a.ply"),
                    words);
            }
        }
        // Elements without properties take no place, however many.
        COMPARE_TEXT(changed("element face", "element ghost 18446744073709551615\nelement face"), "ok");
        // Names are looked for one by one: more than any writer has would take the square of their number.
        std::string many_elements, many_properties;
        for (int i = 0; i < 1100; ++i) {
            many_elements += "element e" + std::to_string(i) + " 0\n";
            many_properties += "property float p" + std::to_string(i) + "\n";
        }
        COMPARE_TEXT(changed("element face", many_elements + "element face"), "limit_exceeded");
        COMPARE_TEXT(changed("property double x", many_properties + "property double x"), "limit_exceeded");
        // A list length that lies.
        std::string list =
            "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uint uint vertex_indices\nend_header\n"
            + std::string(36, '\1') + "\xF0\xFF\xFF\xFF" + std::string(40, '\0');
        COMPARE_TEXT(outcome(list, "a.ply"), "truncated");
    }

    // Writing
    // ---------------------------------------------------------------------------------------------------------

    void saved_meshes_come_back() {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("a.stl").toStdString();
        Mesh torus = torus_mesh(60, 40);
        for (Vec3& v : torus.vertices)
            v = rounded_to_float(v);
        save_stl(torus, path, LengthUnit::mm, Progress());
        QVERIFY(std::filesystem::file_size(path) == 84 + 50 * torus.facets.size());
        const LoadedMesh loaded = load_mesh(path, LengthUnit::mm, Progress());
        QVERIFY(same_triangles(*loaded.mesh, torus));
        QCOMPARE(loaded.report.vertices, torus.vertices.size());
        QVERIFY(loaded.report.warnings.empty()); // also: stored normals agree, attribute words are zero
        QVERIFY(loaded.report.name.find("facetmill") == 0);

        Mesh part = box(); // inches on disk
        for (Vec3& v : part.vertices)
            v *= 25.4;
        save_stl(part, path, LengthUnit::inch, Progress());
        QVERIFY((load_mesh(path, LengthUnit::inch, Progress()).report.file_box.hi - Vec3(20, 30, 40)).norm()
                < 1e-9);
        QVERIFY(same_triangles(*load_mesh(path, LengthUnit::inch, Progress()).mesh, part, 1e-9));
    }

    void refused_writes_leave_nothing() {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("a.stl").toStdString();
        const auto code = [&](const Mesh& mesh, const std::filesystem::path& to) {
            try {
                save_stl(mesh, to, LengthUnit::mm, Progress());
            } catch (const Error& e) {
                return std::string(code_name(e.code()));
            }
            return std::string("ok");
        };
        Mesh bad = box();
        bad.vertices[7].x() = 1e39;
        COMPARE_TEXT(code(bad, path), "coordinate_range");
        bad.vertices[7].x() = std::numeric_limits<double>::quiet_NaN();
        COMPARE_TEXT(code(bad, path), "non_finite");
        COMPARE_TEXT(code(Mesh(), path), "no_facets");
        COMPARE_TEXT(code(box(), path / "none" / "a.stl"), "unwritable");
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(save_stl(box(), path, LengthUnit::mm, Progress(job)), Cancelled);
        QVERIFY(std::filesystem::is_empty(folder.path().toStdString()));
    }

    // Pieces of the readers
    // -------------------------------------------------------------------------------------------

    void collinear_exactly() {
        using detail::exactly_collinear;
        QVERIFY(exactly_collinear(Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3)));
        QVERIFY(exactly_collinear(Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(9, 9, 9)));
        QVERIFY(!exactly_collinear(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
        // One unit in the last place beside the line, where plain arithmetic sees nothing.
        const double third = 1.0 / 3.0, next = std::nextafter(2.0 * third, 1.0);
        QVERIFY(exactly_collinear(Vec3(0, 0, 0), Vec3(third, third, 0), Vec3(2 * third, 2 * third, 0)));
        QVERIFY(!exactly_collinear(Vec3(0, 0, 0), Vec3(third, third, 0), Vec3(2 * third, next, 0)));
        const Vec3 a(12, 12, 1e6), b(24, 24, 1e6);
        const Vec3 c(0.5, 0.5 + 0x1p-53, 1e6);
        QVERIFY(exactly_collinear(a, b, Vec3(0.5, 0.5, 1e6)));
        QVERIFY(!exactly_collinear(a, b, c) && !exactly_collinear(c, a, b) && !exactly_collinear(b, c, a));
        for (int axis = 0; axis < 3; ++axis) { // whichever projection shows the area
            Vec3 u = Vec3::Constant(1), v = Vec3::Constant(2);
            u[axis] = v[axis] = 5;
            v[(axis + 1) % 3] = std::nextafter(2.0, 3.0);
            QVERIFY(!exactly_collinear(Vec3::Constant(0).array() + (Vec3::Unit(axis) * 5).array(), u, v));
        }
    }

    void numbers() {
        using detail::NumberForm;
        using detail::read_number;
        double v = 0;
        const auto form = [&](const char* text, char mark = '.') { return read_number(text, v, mark); };
        for (const auto& [text, value] : {std::pair{"1", 1.0},
                                          {"-1.5", -1.5},
                                          {"+1.5e2", 150.0},
                                          {".5", 0.5},
                                          {"5.", 5.0},
                                          {"1d3", 1000.0},
                                          {"1D-003", 0.001},
                                          {"1e-400", 0.0},
                                          {"0e999999999999999999999", 0.0},
                                          {"0.00000000000000000000000001e-320", 0.0}}) {
            QVERIFY2(form(text) == NumberForm::number, text);
            QVERIFY2(v == value && !std::signbit(v) == !(value < 0), text);
        }
        QVERIFY(form("-0.0") == NumberForm::number && !std::signbit(v));
        for (const char* text : {"1e400", "-1e400", "1e99999999999999999999", "100000e305"})
            QVERIFY2(form(text) == NumberForm::overflow, text);
        for (const char* text :
             {"nan", "NaN", "-inf", "+Infinity", "1.#QNAN", "-1.#IND00", "1.#INF", "nan(ind)", "-nan(0x7)"})
            QVERIFY2(form(text) == NumberForm::non_finite, text);
        for (const char* text : {"", "+", "-", ".", "+-1", "--1", "1.2.3", "0x10", "1e", "1e+", "nano",
                                 "infinite", "1.#XYZ", "1,2.3", "1,2,3", "1f", "e5", "-e5", "١"})
            QVERIFY2(form(text) == NumberForm::invalid, text);
        QVERIFY(form("1,5") == NumberForm::comma);
        QVERIFY(form("1,5", ',') == NumberForm::number && v == 1.5);
        QVERIFY(form("15", ',') == NumberForm::number && v == 15);
        QVERIFY(form("1.5", ',') == NumberForm::point);
        QVERIFY(form("1.#IND", ',') == NumberForm::non_finite);
    }

    void unterminated_number_reads_within_its_bytes() {
        // The text ends with the view, not with a zero byte.
        const std::string digits = "12345";
        double v = 0;
        QVERIFY(detail::read_number(std::string_view(digits).substr(0, 2), v) == detail::NumberForm::number);
        QCOMPARE(v, 12.0);
    }
};

FACETMILL_TEST(TestMeshFormats)
#include "test_mesh_io_formats.moc"
