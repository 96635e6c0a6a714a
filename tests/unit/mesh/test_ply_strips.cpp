// PLY files whose facets are stored as strips.
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/mesh_io_support.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A torus in strips, one for each step around, in one list with -1 between.
std::string strips_of_torus(Index around, Index across, bool binary) {
    const Mesh torus = torus_mesh(around, across);
    std::vector<std::int32_t> list;
    for (Index i = 0; i < around; ++i) {
        if (i > 0) list.push_back(-1);
        for (Index j = 0; j <= across; ++j) {
            list.push_back(std::int32_t(i * across + j % across));
            list.push_back(std::int32_t((i + 1) % around * across + j % across));
        }
    }
    std::string text = "ply\nformat " + std::string(binary ? "binary_little_endian" : "ascii")
                       + " 1.0\nelement vertex " + std::to_string(torus.vertices.size())
                       + "\nproperty double x\nproperty double y\nproperty double z\nelement tristrips 1\n"
                         "property list int int vertex_indices\nend_header\n";
    for (const Vec3& v : torus.vertices)
        if (binary)
            for (int k = 0; k < 3; ++k)
                append_raw(text, &v[k], 8);
        else
            text += vector_text(v) + "\n";
    const auto count = std::int32_t(list.size());
    if (binary) {
        append_raw(text, &count, 4);
        for (const std::int32_t v : list)
            append_raw(text, &v, 4);
        return text;
    }
    text += std::to_string(count);
    for (const std::int32_t v : list)
        text += " " + std::to_string(v);
    return text + "\n";
}

} // namespace

class TestPlyStrips : public QObject {
    Q_OBJECT
private slots:
    void strips_are_the_triangles_in_them() {
        for (const bool binary : {false, true}) {
            const LoadedMesh loaded = read(strips_of_torus(12, 9, binary), "a.ply");
            QCOMPARE(loaded.mesh->facet_count(), std::size_t(2 * 12 * 9));
            QVERIFY(loaded.report.watertight);
            QCOMPARE(loaded.report.inconsistent_edges, std::size_t(0));
            const double volume = std::abs(loaded.report.file_volume);
            QVERIFY(
                std::abs(volume / std::abs(read(obj_text(torus_mesh(12, 9)), "a.obj").report.file_volume) - 1)
                < 0.02); // the other diagonals
        }
    }

    void strips_may_hold_triangles_of_no_area() {
        const std::string head =
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
            "property float z\nelement tristrips 1\n"
            "property list uchar int vertex_indices\nend_header\n"
            "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
        const auto facets = [&](const char* list) { return read(head + list, "a.ply").mesh->facets; };
        QVERIFY(facets("4 0 1 2 3\n") == (std::vector<Facet>{{0, 1, 2}, {2, 1, 3}}));
        // A vertex that is repeated joins two strips, and turns the next triangle.
        QVERIFY(facets("5 0 1 2 2 3\n") == (std::vector<Facet>{{0, 1, 2}}));
        QVERIFY(facets("6 0 1 2 2 1 3\n") == (std::vector<Facet>{{0, 1, 2}, {1, 2, 3}}));
        QVERIFY(facets("7 0 1 2 -1 2 1 3\n") == (std::vector<Facet>{{0, 1, 2}, {2, 1, 3}}));
    }

    void broken_strips_are_refused() {
        const std::string sound = strips_of_torus(4, 4, false);
        const auto changed = [&](const char* from, const char* to) {
            std::string text = sound;
            text.replace(text.find(from), std::strlen(from), to);
            return outcome(text, "a.ply");
        };
        QCOMPARE(outcome(sound, "a.ply"), std::string("ok"));
        QCOMPARE(changed(" -1 ", " -2 "), std::string("syntax"));
        QCOMPARE(changed(" -1 ", " 16 "), std::string("syntax"));
        QCOMPARE(changed(" -1 ", " 1.5 "), std::string("syntax"));
        QCOMPARE(changed("list int int", "list int float"), std::string("syntax"));
        QCOMPARE(changed("tristrips 1", "tristrips 0"), std::string("no_facets"));
        QCOMPARE(outcome(sound.substr(0, sound.size() - 40), "a.ply"), std::string("truncated"));
    }
};

FACETMILL_TEST(TestPlyStrips)
#include "test_ply_strips.moc"
