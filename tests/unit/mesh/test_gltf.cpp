// glTF: a box of 2 x 3 x 4 by every way that files have of saying it, and files that cannot be.
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/mesh/gltf_support.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

void add_row(const char* tag, const std::string& bytes, const char* name, const char* expected = "") {
    QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size())) << name << expected;
}

void columns_of_files() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("expected");
}

} // namespace

class TestGltf : public QObject {
    Q_OBJECT
private slots:

    void sound_files_data() {
        columns_of_files();
        const auto row = [](const char* tag, const GltfMaker& maker, const char* words = "") {
            add_row(tag, maker.glb(), "a.glb", words);
        };
        const GltfMaker plain;
        row("binary", plain);
        add_row("text", plain.text(), "a.gltf");
        add_row("by its content, binary", plain.glb(), "part");
        add_row("by its content, text", plain.text(), "part");
        add_row("its name in capitals", plain.glb(), "A.GLB");
        add_row("a mark in front of the text", "\xEF\xBB\xBF" + plain.text(), "a.gltf");
        add_row("binary, data in the text", GltfMaker::binary(plain.text(), ""), "a.glb");
        add_row("binary, named as text", plain.glb(), "a.gltf");
        add_row("bytes behind the end", plain.glb() + "more", "a.glb");
        GltfMaker maker;
        maker.index_type = 5121;
        row("indices of one byte", maker);
        maker.index_type = 5125;
        row("indices of four bytes", maker);
        maker = {};
        maker.indexed = false;
        row("no indices", maker);
        maker = {};
        maker.stride = 32;
        row("other numbers between", maker);
        maker = {};
        maker.number_type = 5122;
        maker.stride = 8;
        maker.more = R"(,"extensionsRequired":["KHR_mesh_quantization"])";
        maker.nodes = R"([{"mesh":0,"scale":[0.001,0.001,0.001]}])";
        row("whole numbers", maker);
        maker.normalized = true;
        maker.nodes = R"([{"mesh":0,"scale":[32.767,32.767,32.767]}])";
        row("whole numbers as shares", maker);
        maker = {};
        maker.more =
            R"(,"extensionsRequired":["KHR_materials_unlit","KHR_texture_transform"],"materials":[{}])";
        row("materials are required", maker);
        maker.more = R"(,"extensionsUsed":["KHR_draco_mesh_compression"],"extras":{"a":[1,{"b":2}]})";
        row("compression is used elsewhere", maker);
        maker = {};
        maker.asset = R"("version":"2.1","minVersion":"2.0","generator":"x")";
        row("a later version", maker);
        maker = {};
        maker.scenes = "[]";
        add_row("no scene", replaced(maker.text(), R"("scene":0,)", ""), "a.gltf");
        maker.nodes = R"([{"mesh":0,"translation":[1,1,1]},{"children":[0],"translation":[-1,-1,-1]}])";
        row("nodes under others, no scene", maker);
        maker = {};
        maker.nodes = R"([{"children":[1],"rotation":[0,0.70710678118654752,0,0.70710678118654752]},)"
                      R"({"mesh":0,"rotation":[0,-0.70710678118654752,0,0.70710678118654752]}])";
        row("turned, and back", maker);
        maker.nodes = R"([{"children":[1],"matrix":[2,0,0,0,0,2,0,0,0,0,2,0,0.5,0,0,1]},)"
                      R"({"mesh":0,"matrix":[0.5,0,0,0,0,0.5,0,0,0,0,0.5,0,-0.25,0,0,1]}])";
        row("matrices", maker);
        maker.nodes = R"([{"children":[1],"scale":[-1,1,1]},{"mesh":0,"scale":[-1,1,1]}])";
        row("mirrored twice", maker);
        maker.nodes = R"([{"children":[1,2]},{"mesh":0},{"camera":0}])";
        row("a camera beside", maker);
        maker = {};
        maker.primitive = R"(},{"attributes":{"POSITION":0},"mode":1)";
        row("lines beside", maker, "lines_ignored");
        maker.primitive = R"(,"targets":[{"POSITION":0}])";
        row("other shapes beside", maker, "shapes_at_rest");
        maker = {};
        maker.nodes = R"([{"mesh":0,"skin":0}])";
        row("bones", maker, "shapes_at_rest");
    }
    void sound_files() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        QFETCH(QString, expected);
        const LoadedMesh loaded = read_mesh(bytes.toStdString(), name.toStdString(), {}, Progress());
        QCOMPARE(loaded.mesh->facet_count(), std::size_t(12));
        QVERIFY(loaded.report.watertight && loaded.report.unit_known);
        QCOMPARE(loaded.report.assumed_unit, LengthUnit::m);
        const Box3 box = loaded.mesh->box();
        QVERIFY2(box.lo.norm() < 1e-5 && (box.hi - gltf_size).norm() < 1e-5,
                 qPrintable(QString::number(box.hi.z())));
        QVERIFY(std::abs(loaded.report.volume_mm3() - 24) < 1e-3); // and outward
        std::set<std::string> words(loaded.report.warnings.begin(), loaded.report.warnings.end());
        QCOMPARE(words.erase("y_up_turned"), std::size_t(1));
        QCOMPARE(words, expected.isEmpty() ? std::set<std::string>()
                                           : std::set<std::string>{expected.toStdString()});
        for (const std::string& word : loaded.report.warnings)
            QVERIFY(!explain_warning(word).empty());
    }

    /// Strips and fans have the winding that the standard says.
    void strips_and_fans() {
        for (const int mode : {5, 6}) {
            GltfMaker maker;
            maker.mode = mode;
            maker.corners = mode == 5 ? std::vector<Index>{0, 1, 2, 3} : std::vector<Index>{0, 1, 3, 2};
            const LoadedMesh loaded = read_mesh(maker.glb(), "a.glb", {}, Progress());
            QCOMPARE(loaded.mesh->facet_count(), std::size_t(2)); // the floor of the box
            QCOMPARE(loaded.report.inconsistent_edges, std::size_t(0));
            for (std::size_t f = 0; f < 2; ++f)
                QVERIFY(loaded.mesh->facet_normal(f).z() > 0.999);
            QVERIFY(std::abs(loaded.report.area_mm2() - 6) < 1e-4);
        }
    }

    void objects_are_chosen() {
        GltfMaker maker;
        maker.scenes = R"([{"nodes":[1]},{"nodes":[0,1,2]}])";
        maker.nodes =
            R"([{"mesh":0,"name":"Box"},{"children":[3],"name":"Both"},{"mesh":0,"name":"Lid","translation":[1,0,0]},)"
            R"({"mesh":0,"name":"Deep","translation":[0,5,0]}])";
        const auto box_of = [&](const char* objects, const std::string& bytes) {
            MeshReading reading;
            reading.objects = objects;
            return read_mesh(bytes, "a.glb", reading, Progress()).mesh->box();
        };
        // The scene that is shown holds one alone; Y up became Z up.
        QVERIFY(std::abs(box_of("", maker.glb()).lo.z() - 5000) < 1e-3);
        const std::string other = replaced(maker.text(), R"("scene":0)", R"("scene":1)");
        QVERIFY(std::abs(box_of("Lid", other).lo.x() - 1000) < 1e-3);
        QVERIFY(std::abs(box_of("0", other).hi.x() - 2) < 1e-3);
        QVERIFY(std::abs(box_of("Both", other).hi.z() - 5004) < 1e-3);
        QVERIFY(std::abs(box_of("Box, Lid", other).hi.x() - 1002) < 1e-3);
        MeshReading reading;
        reading.objects = "Lit";
        try {
            read_mesh(other, "a.gltf", reading, Progress());
            QFAIL("there is none");
        } catch (const Error& e) {
            QCOMPARE(e.code(), ErrorCode::missing_reference);
            QVERIFY2(e.remedy().find("2 (Lid)") != std::string::npos, e.remedy().c_str());
        }
        const LoadedMesh all = read_mesh(other, "a.gltf", {}, Progress());
        QCOMPARE(all.report.objects.size(), std::size_t(3));
        QCOMPARE(all.report.objects[0].facets, std::size_t(12));
    }

    void broken_files_data() {
        columns_of_files();
        const GltfMaker plain;
        const std::string text = plain.text(), glb = plain.glb();
        const auto changed = [&](const char* tag, const std::string& from, const std::string& to,
                                 const char* expected) {
            add_row(tag, replaced(text, from, to), "a.gltf", expected);
        };
        add_row("nothing", "", "a.glb", "empty_file");
        add_row("no glTF", "what", "a.gltf", "syntax");
        add_row("JSON of something else", "{\"a\":1}", "a.gltf", "syntax");
        add_row("an STL file", binary_stl(box_mesh(Vec3(0, 0, 0), Vec3(1, 1, 1))), "a.glb", "syntax");
        add_row("a header alone", glb.substr(0, 12), "a.glb", "truncated");
        add_row("cut in its text", glb.substr(0, 300), "a.glb", "truncated");
        add_row("cut in its data", glb.substr(0, glb.size() - 5), "a.glb", "truncated");
        add_row("a text that is cut", text.substr(0, text.size() / 2), "a.gltf", "truncated,syntax");
        add_row("binary of version 1", replaced(glb, std::string("glTF\2", 5), std::string("glTF\1", 5)),
                "a.glb", "unsupported_format");
        add_row("data first", replaced(glb, "JSON", "BIN "), "a.glb", "syntax");
        changed("version 1", "2.0", "1.0", "unsupported_format");
        changed("no version", "\"version\":\"2.0\"", "", "unsupported_format");
        changed("no asset", "\"asset\"", "\"assets\"", "syntax");
        changed("compressed shapes", "\"scene\":0",
                "\"scene\":0,\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]", "unsupported_format");
        changed("packed numbers", "\"scene\":0",
                "\"scene\":0,\"extensionsRequired\":[\"EXT_meshopt_compression\"]", "unsupported_format");
        changed("copies by instancing", "\"scene\":0",
                "\"scene\":0,\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"]", "unsupported_format");
        changed("data elsewhere", "data:application/octet-stream;base64,", "box.bin?", "missing_reference");
        changed("no base64", "base64,", "base64,!", "syntax");
        changed("no data", ",\"uri\"", ",\"url\"", "missing_reference");
        changed("a buffer that is too short",
                "\"buffers\":[{\"byteLength\":", "\"buffers\":[{\"byteLength\":9", "truncated");
        changed("a scene that is not there", "\"scene\":0", "\"scene\":3", "missing_reference");
        changed("a node that is not there", "\"nodes\":[0]", "\"nodes\":[7]", "missing_reference");
        changed("a mesh that is not there", "\"mesh\":0", "\"mesh\":7", "missing_reference");
        changed("an accessor that is not there", "\"POSITION\":0", "\"POSITION\":7", "missing_reference");
        changed("no positions", "\"POSITION\":0", "\"NORMAL\":0", "syntax");
        changed("a part of a buffer that is not there", "\"bufferView\":0", "\"bufferView\":7",
                "missing_reference");
        changed("positions of two numbers", "\"VEC3\"", "\"VEC2\"", "syntax");
        changed("an unknown type", "\"componentType\":5126", "\"componentType\":5130", "syntax");
        changed("indices with a point", "\"componentType\":5123", "\"componentType\":5126", "syntax");
        changed("more positions than there are", "\"count\":8", "\"count\":9", "syntax");
        changed("as many as numbers go", "\"count\":8", "\"count\":900000000000000", "syntax");
        changed("fewer positions than are named", "\"count\":8", "\"count\":7", "syntax");
        changed("two corners left over", "\"count\":36", "\"count\":35", "syntax");
        changed("negative", "\"count\":8", "\"count\":-8", "syntax");
        changed("half a number", "\"count\":8", "\"count\":8.5", "syntax");
        changed("numbers over each other", "\"byteStride\":12", "\"byteStride\":4", "syntax");
        changed("beyond its buffer", "\"byteOffset\"", "\"byteLength\":9999,\"byteOffset\"", "syntax");
        changed("changes to other numbers", "\"type\":\"VEC3\"", "\"type\":\"VEC3\",\"sparse\":{}",
                "unsupported_format");
        changed("points alone", "\"mode\":4", "\"mode\":0", "no_facets");
        changed("no mesh on the stage", "{\"mesh\":0,\"name\":\"Box\"}", "{}", "no_facets");
        changed("a node in itself", "\"mesh\":0", "\"children\":[0]", "limit_exceeded");
        changed("a place that flattens", "\"mesh\":0", "\"mesh\":0,\"scale\":[1,0,1]", "out_of_range");
        changed("no rotation", "\"mesh\":0", "\"mesh\":0,\"rotation\":[0,0,0,0]", "syntax");
        changed("a rotation of three", "\"mesh\":0", "\"mesh\":0,\"rotation\":[0,0,1]", "syntax");
        changed("a matrix that is no place", "\"mesh\":0",
                "\"mesh\":0,\"matrix\":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]", "syntax");
        changed("far away", "\"mesh\":0", "\"mesh\":0,\"translation\":[1e9,0,0]", "coordinate_range");
        {
            GltfMaker maker;
            std::string data = maker.data();
            std::fill_n(data.begin(), 4, '\xFF');
            add_row("not a number", GltfMaker::binary(maker.json(""), data), "a.glb", "non_finite");
        }
    }
    void broken_files() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        QFETCH(QString, expected);
        try {
            read_mesh(bytes.toStdString(), name.toStdString(), {}, Progress());
            QVERIFY2(false, "it was read");
        } catch (const Error& e) {
            QVERIFY2(expected.split(',').contains(QString::fromStdString(std::string(code_name(e.code())))),
                     e.what());
            QVERIFY2(!e.remedy().empty()
                         && std::string(e.what()).find(name.toStdString()) != std::string::npos,
                     e.what());
        }
    }

    /// Objects of objects of objects are worked out first, and bytes that are changed give a mesh or an
    /// error.
    void limits_and_damage() {
        GltfMaker maker;
        maker.nodes = "[";
        for (int k = 0; k < 30; ++k)
            maker.nodes += "{\"children\":[" + std::to_string(k + 1) + "," + std::to_string(k + 1) + "]},";
        maker.nodes += "{\"mesh\":0}]";
        QVERIFY_THROWS_EXCEPTION(Error, read_mesh(maker.glb(), "a.glb", {}, Progress()));
        std::mt19937 random(5);
        for (const std::string& sound : {GltfMaker().glb(), GltfMaker().text()})
            for (int trial = 0; trial < trials(1500, 3); ++trial) {
                std::string damaged = sound;
                for (std::uint32_t k = 0; k < 1 + random() % 3; ++k)
                    damaged[random() % damaged.size()] = char(random());
                try {
                    read_mesh(damaged, "a.glb", {}, Progress());
                } catch (const Error& e) {
                    QVERIFY(!e.message().empty() && e.code() != ErrorCode::internal);
                }
            }
    }
};

FACETMILL_TEST(TestGltf)
#include "test_gltf.moc"
