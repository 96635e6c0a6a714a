// STL, 3MF and PLY as they are written: read back to the same bits, and looked at by hand.
#include "core/base/archive.h"
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_writer.h"
#include "tests/support/cancel_at.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/mesh_io_support.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <cstring>

using namespace facetmill;
using namespace facetmill::test;

namespace {

class Folder {
public:
    std::filesystem::path at(const std::string& name) const { return dir_.path().toStdString() + "/" + name; }
    std::string bytes(const std::string& name) const {
        QFile file(QString::fromStdString(at(name).string()));
        if (!file.open(QIODevice::ReadOnly)) return {};
        return file.readAll().toStdString();
    }

private:
    QTemporaryDir dir_;
};

/// A torus whose vertices lie where a float can say it, or not.
Mesh torus(bool single) {
    Mesh mesh = torus_mesh(17, 11);
    if (single)
        for (Vec3& v : mesh.vertices)
            v = rounded_to_float(v);
    return mesh;
}

std::vector<VertexColor> colors_for(const Mesh& mesh) {
    std::vector<VertexColor> colors;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        colors.push_back({std::uint8_t(v % 7 * 30), std::uint8_t(255 - v % 5), std::uint8_t(v % 3)});
    return colors;
}

template <class Word>
Word word_at(const std::string& bytes, std::size_t at) {
    Word word;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

std::string error_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& e) {
        return std::string(code_name(e.code()));
    }
    return "ok";
}

} // namespace

class TestMeshWriter : public QObject {
    Q_OBJECT
private slots:

    void read_back_to_the_same_bits_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("single");
        for (const char* name : {"a.stl", "a.3mf", "a.PLY", "plain"})
            for (const bool single : {true, false})
                if (single || QString(name).endsWith("f") || QString(name).endsWith("Y"))
                    QTest::addRow("%s %s", name, single ? "float" : "double") << name << single;
    }
    void read_back_to_the_same_bits() {
        QFETCH(QString, name);
        QFETCH(bool, single);
        const Folder folder;
        const Mesh mesh = torus(single);
        for (const bool colored : {false, true}) {
            const std::vector<VertexColor> colors = colored ? colors_for(mesh) : std::vector<VertexColor>();
            save_mesh(mesh, folder.at(name.toStdString()), {.colors = colors}, {});
            const LoadedMesh loaded = load_mesh(folder.at(name.toStdString()), LengthUnit::mm, {});
            QCOMPARE(loaded.mesh->facet_count(), mesh.facet_count());
            for (std::size_t f = 0; f < mesh.facet_count(); ++f)
                for (int k = 0; k < 3; ++k)
                    QVERIFY(loaded.mesh->corner(f, k) == mesh.corner(f, k));
            QVERIFY(loaded.report.watertight);
            std::string words;
            for (const std::string& word : loaded.report.warnings)
                words += word;
            const bool colored_stl = colored && loaded.report.format.find("STL") != std::string::npos;
            QCOMPARE(words, std::string(colored_stl ? "attribute_data" : ""));
        }
    }

    void units_are_those_asked_for() {
        const Folder folder;
        const Mesh mesh = torus(true);
        for (const LengthUnit unit : mesh_units)
            for (const char* name : {"u.stl", "u.ply", "u.3mf"}) {
                save_mesh(mesh, folder.at(name), {.unit = unit}, {});
                MeshReading reading; // a 3MF file says its unit itself
                if (mesh_format_named(name)->needs_unit()) reading.unit = unit;
                const LoadedMesh loaded = load_mesh(folder.at(name), reading, {});
                QCOMPARE(loaded.report.unit_known, std::string(name) == "u.3mf");
                const bool feet_as_inches = loaded.report.unit_known && unit == LengthUnit::ft;
                QVERIFY(loaded.report.assumed_unit == (feet_as_inches ? LengthUnit::inch : unit));
                for (std::size_t f = 0; f < mesh.facet_count(); ++f)
                    for (int k = 0; k < 3; ++k)
                        QVERIFY((loaded.mesh->corner(f, k) - mesh.corner(f, k)).norm() < 1e-5);
            }
        QVERIFY(folder.bytes("u.ply").find("lengths in ft") != std::string::npos);
    }

    void ply_holds_values_and_colors() {
        const Folder folder;
        const Mesh mesh = torus(true);
        std::vector<float> values(mesh.vertices.size());
        for (std::size_t v = 0; v < values.size(); ++v)
            values[v] = 0.25f * float(v);
        const auto colors = colors_for(mesh);
        save_mesh(mesh, folder.at("v.ply"),
                  {.unit = LengthUnit::cm, .value_name = "left_over", .values = values, .colors = colors},
                  {});
        const std::string bytes = folder.bytes("v.ply");
        QVERIFY(bytes.find("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float "
                           "left_over\n")
                != std::string::npos);
        const bool is_double = bytes.find("property double x") != std::string::npos;
        const std::size_t place = is_double ? 24 : 12, stride = place + 3 + 4;
        const std::size_t begin = bytes.find("end_header\n") + 11;
        QCOMPARE(bytes.size(), begin + stride * mesh.vertices.size() + 13 * mesh.facet_count());
        for (std::size_t v = 0; v < values.size(); ++v) {
            QVERIFY(std::memcmp(bytes.data() + begin + stride * v + place, colors[v].data(), 3) == 0);
            QCOMPARE(word_at<float>(bytes, begin + stride * v + place + 3), values[v] / 10);
        }
    }

    void stl_holds_a_color_for_each_facet() {
        const Folder folder;
        Mesh mesh;
        mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
        mesh.facets = {{0, 1, 2}};
        const std::vector<VertexColor> colors{{255, 0, 8}, {255, 0, 8}, {255, 0, 8}};
        save_mesh(mesh, folder.at("c.stl"), {.colors = colors}, {});
        QCOMPARE(word_at<std::uint16_t>(folder.bytes("c.stl"), 84 + 48),
                 std::uint16_t(0x8000 | 31 << 10 | 1));
        save_mesh(mesh, folder.at("c.stl"), {}, {});
        QCOMPARE(word_at<std::uint16_t>(folder.bytes("c.stl"), 84 + 48), std::uint16_t(0));
    }

    void a_3mf_file_is_what_the_specification_says() {
        const Folder folder;
        Mesh mesh = box_mesh(Vec3(0, 0, 0), Vec3(1, 2, 3));
        auto colors = std::vector<VertexColor>(mesh.vertices.size(), {1, 2, 3});
        colors.back() = {255, 0, 16};
        save_mesh(mesh, folder.at("s.3mf"),
                  {.unit = LengthUnit::inch, .name = "A \"<part>\" & more", .colors = colors}, {});
        const std::string bytes = folder.bytes("s.3mf");
        const ArchiveReader archive(bytes, "s.3mf");
        QCOMPARE(archive.count(), std::size_t(3));
        QCOMPARE(archive.entry_name(0), std::string("[Content_Types].xml"));
        QCOMPARE(archive.entry_name(1), std::string("_rels/.rels"));
        QVERIFY(archive.bytes(1).find("Target=\"/3D/3dmodel.model\"") != std::string::npos);
        QCOMPARE(archive.entry_name(2), std::string("3D/3dmodel.model"));
        const std::string model = archive.bytes(2);
        for (const char* piece :
             {"unit=\"inch\"", "name=\"A &quot;&lt;part&gt;&quot; &amp; more\"",
              "<m:color color=\"#010203\"/>\n<m:color color=\"#FF0010\"/>\n</m:colorgroup>",
              "<item objectid=\"1\"/>"})
            QVERIFY2(model.find(piece) != std::string::npos, piece);
        // A vertex of the colour that stands second.
        QVERIFY(model.find("p1=\"0\" p2=\"1\"") != std::string::npos);
        QCOMPARE(load_mesh(folder.at("s.3mf"), MeshReading(), {}).report.name,
                 std::string("A \"<part>\" & more"));
    }

    void the_same_mesh_gives_the_same_bytes() {
        const Folder folder;
        const Mesh mesh = torus(false);
        for (const char* name : {"t.stl", "t.3mf", "t.ply"}) {
            save_mesh(mesh, folder.at(name), {}, {});
            const std::string first = folder.bytes(name);
            save_mesh(mesh, folder.at(name), {}, {});
            QVERIFY(folder.bytes(name) == first);
        }
    }

    void what_cannot_be_written_leaves_nothing() {
        const Folder folder;
        const Mesh good = torus(true);
        Mesh far = good, hole = good;
        far.vertices[5].x() = 1e300;
        hole.vertices[5].x() = std::nan("");
        const std::vector<float> one{1};
        for (const char* name : {"b.stl", "b.3mf", "b.ply"}) {
            const auto written = [&](const Mesh& mesh, const MeshWriting& writing) {
                return error_of([&] { save_mesh(mesh, folder.at(name), writing, {}); });
            };
            QCOMPARE(written(far, {}), std::string("coordinate_range"));
            QCOMPARE(written(hole, {}), std::string("non_finite"));
            QCOMPARE(written({}, {}), std::string("no_facets"));
            QCOMPARE(written(good, {.values = one}), std::string("out_of_range"));
            QVERIFY(!std::filesystem::exists(folder.at(name)));
        }
        QCOMPARE(error_of([&] { save_mesh(good, folder.at("b.obj"), {}, {}); }),
                 std::string("unsupported_format"));
        QCOMPARE(error_of([&] {
                     save_mesh(good, folder.at("b.ply"),
                               {.value_name = "x\nproperty", .values = std::vector<float>(187, 1)}, {});
                 }),
                 std::string("out_of_range"));
        QVERIFY(!std::filesystem::exists(folder.at("b.ply")));
    }

    void cancelled_leaves_nothing() {
        const Folder folder;
        const Mesh mesh = torus_mesh(300, 200);
        for (const char* name : {"c.stl", "c.3mf", "c.ply"}) {
            Job job;
            QVERIFY(
                cancelled_at(job, 0.5, [&](const Progress& p) { save_mesh(mesh, folder.at(name), {}, p); }));
            QVERIFY(!std::filesystem::exists(folder.at(name)));
        }
    }
};

FACETMILL_TEST(TestMeshWriter)
#include "test_mesh_writer.moc"
