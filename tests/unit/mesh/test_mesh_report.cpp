// Counts, sums and warnings of meshes whose faults are known by construction.
#include "core/mesh/mesh_report.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/mesh_io_support.h"

#include <QTest>

#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

MeshReport analysed(const Mesh& mesh, LengthUnit unit = LengthUnit::mm) {
    MeshReport report;
    report.assumed_unit = unit;
    analyse_mesh(mesh, report, Progress());
    return report;
}

std::string words(const MeshReport& report) {
    std::string text;
    for (const std::string& w : report.warnings)
        text += (text.empty() ? "" : ",") + w;
    return text;
}

Mesh joined(const Mesh& a, const Mesh& b) {
    Mesh mesh = a;
    for (const Facet& f : b.facets) {
        Facet g;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = b.vertices[f[k]];
            const auto at = std::find(mesh.vertices.begin(), mesh.vertices.end(), p);
            g[k] = Index(at - mesh.vertices.begin());
            if (at == mesh.vertices.end()) mesh.vertices.push_back(p);
        }
        mesh.facets.push_back(g);
    }
    return mesh;
}

void reverse(Mesh& mesh) {
    for (Facet& f : mesh.facets)
        std::swap(f[1], f[2]);
}

/// The same counts by maps over all edges: slow and plain.
struct PlainCounts {
    std::size_t open = 0, non_manifold = 0, inconsistent = 0, duplicate = 0, shells = 0, split_vertices = 0;

    explicit PlainCounts(const Mesh& mesh) {
        std::map<std::pair<Index, Index>, std::vector<std::pair<std::size_t, bool>>> edges;
        std::set<std::set<Index>> seen;
        for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
            const Facet& c = mesh.facets[f];
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = c[k], b = c[(k + 1) % 3];
                edges[std::minmax(a, b)].emplace_back(f, a < b);
            }
            duplicate += !seen.insert({c[0], c[1], c[2]}).second;
        }
        std::vector<std::size_t> shell(mesh.facets.size());
        std::iota(shell.begin(), shell.end(), std::size_t(0));
        const auto merge = [](std::vector<std::size_t>& set, std::size_t a, std::size_t b) {
            const std::size_t from = set[a], to = set[b];
            std::replace(set.begin(), set.end(), from, to);
        };
        for (const auto& [edge, uses] : edges) {
            open += uses.size() == 1;
            non_manifold += uses.size() > 2;
            inconsistent += uses.size() == 2 && uses[0].second == uses[1].second;
            for (const auto& use : uses)
                merge(shell, use.first, uses[0].first);
        }
        shells = std::set<std::size_t>(shell.begin(), shell.end()).size();
        for (Index v = 0; v < mesh.vertices.size(); ++v) {
            std::vector<std::size_t> fan(mesh.facets.size());
            std::iota(fan.begin(), fan.end(), std::size_t(0));
            for (const auto& [edge, uses] : edges)
                if (edge.first == v || edge.second == v)
                    for (const auto& use : uses)
                        merge(fan, use.first, uses[0].first);
            std::set<std::size_t> fans;
            for (std::size_t f = 0; f < mesh.facets.size(); ++f)
                if (std::find(mesh.facets[f].begin(), mesh.facets[f].end(), v) != mesh.facets[f].end())
                    fans.insert(fan[f]);
            split_vertices += fans.size() > 1;
        }
    }
};

const Vec3 origin(0, 0, 0);

} // namespace

class TestMeshReport : public QObject {
    Q_OBJECT
private slots:

    void counts_equal_the_plain_ones() {
        std::mt19937_64 rng(5);
        std::size_t faults = 0;
        for (int round = 0; round < 300; ++round) {
            Mesh mesh; // few vertices and many facets: every fault occurs
            const Index vertices = Index(4 + rng() % 9);
            for (Index v = 0; v < vertices; ++v)
                mesh.vertices.emplace_back(double(rng() % 100), double(rng() % 100), double(rng() % 100));
            const std::size_t facets = 1 + rng() % 24;
            while (mesh.facets.size() < facets) {
                const Facet f = {Index(rng() % vertices), Index(rng() % vertices), Index(rng() % vertices)};
                if (f[0] != f[1] && f[1] != f[2] && f[2] != f[0]) mesh.facets.push_back(f);
            }
            const PlainCounts plain(mesh);
            const MeshReport report = analysed(mesh);
            QCOMPARE(report.open_edges, plain.open);
            QCOMPARE(report.non_manifold_edges, plain.non_manifold);
            QCOMPARE(report.inconsistent_edges, plain.inconsistent);
            QCOMPARE(report.duplicate, plain.duplicate);
            QCOMPARE(report.shells, plain.shells);
            QCOMPARE(report.non_manifold_vertices, plain.split_vertices);
            faults += (plain.open > 0) + (plain.non_manifold > 0) + (plain.inconsistent > 0)
                      + (plain.duplicate > 0) + (plain.shells > 1) + (plain.split_vertices > 0);
        }
        QVERIFY(faults > 600);
    }

    void good_and_turned() {
        Mesh mesh = box_mesh(Vec3(-5, 1, 2), Vec3(15, 21, 32));
        MeshReport report = analysed(mesh);
        QVERIFY(report.watertight && report.warnings.empty());
        QVERIFY(std::abs(report.file_volume - 12000) < 1e-9 && std::abs(report.file_area - 3200) < 1e-9);
        QCOMPARE(report.vertices, std::size_t(8));
        QCOMPARE(report.welded_vertices, std::size_t(8));
        QCOMPARE(report.facets, std::size_t(12));
        QVERIFY(report.file_box.lo == Vec3(-5, 1, 2) && report.file_box.hi == Vec3(15, 21, 32));
        reverse(mesh);
        report = analysed(mesh);
        QCOMPARE(words(report), std::string("inside_out"));
        QVERIFY(report.watertight && std::abs(report.file_volume + 12000) < 1e-9);
        std::swap(mesh.facets[3][0], mesh.facets[3][1]);
        report = analysed(mesh);
        QCOMPARE(words(report), std::string("inconsistent_winding,inside_out"));
        QCOMPARE(report.inconsistent_edges, std::size_t(3));
        QVERIFY(!report.watertight);
    }

    /// Whether a sheet lies this or that side of the origin does not make it inside out.
    void sheets_have_no_inside() {
        for (const double z : {-50.0, 0.0, 50.0}) {
            Mesh sheet;
            sheet.vertices = {{0, 0, z}, {9, 0, z}, {9, 9, z}, {0, 9, z}};
            sheet.facets = {{0, 1, 2}, {0, 2, 3}};
            MeshReport report = analysed(sheet);
            QCOMPARE(words(report), std::string("open_edges"));
            QCOMPARE(report.open_edges, std::size_t(4));
            QVERIFY(std::abs(report.file_volume - 27 * z) < 1e-9); // about the origin, as documented
            sheet.facets.push_back({0, 2, 1});
            sheet.facets.push_back({0, 3, 2});
            report = analysed(sheet);
            QVERIFY(words(report).find("inside_out") == std::string::npos);
        }
    }

    void cavities_and_pieces() {
        const Mesh outer = box_mesh(Vec3(0, 0, 0), Vec3(30, 30, 30));
        Mesh inner = box_mesh(Vec3(10, 10, 10), Vec3(20, 20, 20));
        reverse(inner);
        const MeshReport cavity = analysed(joined(outer, inner));
        QCOMPARE(words(cavity), std::string("multiple_shells"));
        QVERIFY(cavity.watertight && std::abs(cavity.file_volume - 26000) < 1e-9);
        // Touching at a vertex: two pieces. Along an edge: one, with an edge of four facets.
        const MeshReport vertex = analysed(joined(outer, box_mesh(Vec3(30, 30, 30), Vec3(40, 40, 40))));
        QCOMPARE(words(vertex), std::string("multiple_shells"));
        QCOMPARE(vertex.non_manifold_vertices, std::size_t(1));
        QCOMPARE(vertex.shells, std::size_t(2));
        const MeshReport edge = analysed(joined(outer, box_mesh(Vec3(30, 30, 0), Vec3(40, 40, 30))));
        QCOMPARE(words(edge), std::string("non_manifold_edges"));
        QCOMPARE(edge.shells, std::size_t(1));
        QCOMPARE(edge.non_manifold_vertices, std::size_t(0));
        const MeshReport twice = analysed(joined(outer, outer));
        QCOMPARE(words(twice), std::string("duplicate_facets,non_manifold_edges"));
        QCOMPARE(twice.duplicate, std::size_t(12));
        QCOMPARE(twice.non_manifold_edges, std::size_t(18));
    }

    /// A vertex of a million facets goes through the sorting that can be cancelled.
    void one_vertex_of_very_many_facets() {
        Mesh fan;
        const Index n = 60'000;
        fan.vertices.emplace_back(0, 0, 0);
        for (Index i = 0; i < n; ++i)
            fan.vertices.emplace_back(50 * std::cos(2 * pi * i / n), 50 * std::sin(2 * pi * i / n), 0);
        for (Index i = 0; i < n; ++i)
            fan.facets.push_back({0, 1 + (i * 7919u + 1) % n, 1 + (i * 7919u) % n}); // in no order
        MeshReport report = analysed(fan);
        QCOMPARE(report.open_edges, std::size_t(n));
        QCOMPARE(report.inconsistent_edges, std::size_t(0));
        QCOMPARE(report.shells, std::size_t(1));
        QCOMPARE(report.non_manifold_vertices, std::size_t(0));
        fan.facets.push_back(fan.facets[n / 2]);
        report = analysed(fan);
        QCOMPARE(report.duplicate, std::size_t(1));
        QCOMPARE(report.non_manifold_edges, std::size_t(2));
    }

    /// Far from the origin the volume keeps its digits.
    void volume_far_away() {
        const Vec3 far(1e6, -2e6, 5e5);
        const MeshReport report = analysed(box_mesh(far, far + Vec3(8, 16, 4)));
        QVERIFY(std::abs(report.file_volume - 512) < 1e-9);
    }

    void units_by_size() {
        const auto of = [](double size, LengthUnit unit = LengthUnit::mm) {
            return analysed(box_mesh(origin, Vec3(size, size / 2, size / 3) * mm_per(unit)), unit);
        };
        for (const auto& [size, guess, warning] : {std::tuple{0.02, "m", "unit_suspect"},
                                                   {0.49, "m", "unit_suspect"},
                                                   {0.6, "in", "unit_suspect"},
                                                   {1.5, "in", ""},
                                                   {9.9, "in", ""},
                                                   {10.1, "mm", ""},
                                                   {9999.0, "mm", ""},
                                                   {10001.0, "mm", "unit_suspect"}}) {
            QCOMPARE(units_guess_name(of(size)), std::string(guess));
            QCOMPARE(words(of(size)), std::string(warning));
        }
        // As inches the same numbers are another size; the guess looks at the numbers.
        QCOMPARE(words(of(0.6, LengthUnit::inch)), std::string());
        QCOMPARE(units_guess_name(of(0.6, LengthUnit::inch)), std::string("in"));
        QCOMPARE(words(of(0.02, LengthUnit::inch)), std::string("unit_suspect"));
        QCOMPARE(words(of(400.0, LengthUnit::inch)), std::string("unit_suspect"));
        const MeshReport inch = of(3.0, LengthUnit::inch);
        QVERIFY(std::abs(inch.file_volume - 4.5) < 1e-12
                && std::abs(inch.volume_mm3() - 4.5 * 25.4 * 25.4 * 25.4) < 1e-9);
        QVERIFY(std::abs(inch.box_mm().hi.x() - 76.2) < 1e-12);
        QVERIFY(std::abs(inch.area_mm2() / inch.file_area - 645.16) < 1e-9);
    }

    void coarse_resolution_by_distance() {
        const auto of = [](double distance, const std::string& format) {
            const Mesh mesh = box_mesh(Vec3(distance, 0, 0), Vec3(distance + 64, 64, 64));
            const std::string words = format == "stl" ? outcome(binary_stl(mesh), "a.stl")
                                                      : outcome(binary_ply(mesh, false), "a.ply");
            return words.substr(2);
        };
        QCOMPARE(of(65536, "stl"), std::string());
        QCOMPARE(of(262144, "stl"), std::string(",coarse_resolution"));
        QCOMPARE(of(262144, "ply"), std::string()); // stored as doubles
        // In inches the steps are larger.
        const Mesh mesh = box_mesh(Vec3(16384, 0, 0), Vec3(16384 + 16, 16, 16));
        QCOMPARE(outcome(binary_stl(mesh), "a.stl", LengthUnit::mm), std::string("ok"));
        QCOMPARE(outcome(binary_stl(mesh), "a.stl", LengthUnit::inch), std::string("ok,coarse_resolution"));
    }

    void every_word_is_explained() {
        const std::vector<std::string> all = warning_words();
        QVERIFY(std::is_sorted(all.begin(), all.end()) && all.size() > 20);
        for (const std::string& word : all)
            QVERIFY2(explain_warning(word).ends_with('.') || explain_warning(word).ends_with(':'),
                     word.c_str());
        QVERIFY(explain_warning("no_such_word").empty());
    }
};

FACETMILL_TEST(TestMeshReport)
#include "test_mesh_report.moc"
