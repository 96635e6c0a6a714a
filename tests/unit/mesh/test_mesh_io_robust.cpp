// Mesh files cut at every byte, with random bytes changed, read by one and by several threads, and cancelled.
#include "core/base/parallel.h"
#include "tests/support/cancel_at.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/mesh/mesh_io_support.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

struct Sample {
    const char* name;
    std::string bytes;
};

/// A small part in every format.
std::vector<Sample> samples(const Mesh& mesh) {
    return {{"binary.stl", binary_stl(mesh)},
            {"ascii.stl", ascii_stl(mesh)},
            {"part.obj", obj_text(mesh)},
            {"ascii.ply", ascii_ply(mesh)},
            {"little.ply", binary_ply(mesh, false)},
            {"big.ply", binary_ply(mesh, true)}};
}

/// What every result must keep to, whatever the file.
void check_invariants(const LoadedMesh& loaded) {
    const Mesh& mesh = *loaded.mesh;
    const MeshReport& r = loaded.report;
    QVERIFY(!mesh.facets.empty());
    QCOMPARE(mesh.facets.size() + r.degenerate, r.facets);
    QCOMPARE(mesh.vertices.size(), r.vertices);
    QVERIFY(r.vertices <= r.welded_vertices && r.shells >= 1 && r.shells <= mesh.facets.size());
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const Facet& f : mesh.facets) {
        QVERIFY(f[0] != f[1] && f[1] != f[2] && f[2] != f[0]);
        for (const Index v : f) {
            QVERIFY(v < mesh.vertices.size());
            used[v] = true;
        }
    }
    QVERIFY(std::find(used.begin(), used.end(), false) == used.end());
    for (const Vec3& v : mesh.vertices)
        QVERIFY(v.allFinite() && v.cwiseAbs().maxCoeff() <= 1e7);
    QVERIFY(std::isfinite(r.file_volume) && std::isfinite(r.file_area) && !r.file_box.empty());
    QVERIFY(std::is_sorted(r.warnings.begin(), r.warnings.end()));
    QVERIFY(std::adjacent_find(r.warnings.begin(), r.warnings.end()) == r.warnings.end());
    for (const std::string& word : r.warnings)
        QVERIFY2(!explain_warning(word).empty(), word.c_str());
}

bool has(const LoadedMesh& loaded, const char* word) {
    const auto& all = loaded.report.warnings;
    return std::find(all.begin(), all.end(), word) != all.end();
}

} // namespace

class TestMeshRobust : public QObject {
    Q_OBJECT
private slots:

    /// Cut at every byte: refused, or loaded with all facets; with fewer only where the format cannot tell
    /// (OBJ), and then with a warning (open edges, or a last line that does not end).
    void cut_at_every_byte() {
        const Mesh mesh = box_mesh(Vec3(0, 0, 0), Vec3(20, 30.5, 40.25));
        for (const Sample& sample : samples(mesh)) {
            std::size_t refused = 0;
            for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
                const std::string name = sample.name;
                try {
                    const LoadedMesh loaded = read(sample.bytes.substr(0, size), name);
                    check_invariants(loaded);
                    if (name == "part.obj") {
                        QVERIFY(has(loaded, "open_edges") || has(loaded, "unterminated_line"));
                    } else {
                        QVERIFY2(loaded.report.facets == 12 && loaded.report.watertight, name.c_str());
                        QVERIFY(has(loaded, "missing_endsolid") || has(loaded, "unterminated_line")
                                || sample.bytes.find("endsolid part", size - 13)
                                       == size - 12 // all but the line end
                                || sample.bytes.find("endsolid", size - 13)
                                       != std::string::npos); // a part of the name
                    }
                } catch (const Error& e) {
                    ++refused;
                    QVERIFY(e.code() != ErrorCode::internal);
                    QVERIFY2(std::string(e.what()).find(name) != std::string::npos, e.what());
                    QVERIFY2(size > 0 || e.code() == ErrorCode::empty_file, e.what());
                }
            }
            QVERIFY2(refused + 800 > sample.bytes.size() && refused > 100, sample.name);
        }
    }

    /// An open sheet: of a binary or ASCII STL file, or a PLY file, no cut may give a smaller mesh.
    void cut_sheet_is_never_believed() {
        Mesh sheet = torus_mesh(6, 5);
        sheet.facets.resize(37);
        for (const Sample& sample : samples(sheet)) {
            if (std::string(sample.name) == "part.obj") continue;
            for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
                try {
                    const LoadedMesh loaded = read(sample.bytes.substr(0, size), sample.name);
                    QVERIFY2(loaded.report.facets == 37, sample.name);
                    QVERIFY(sample.bytes.size() - size < 8); // the end of the last name or of the last line
                } catch (const Error&) {
                }
            }
        }
    }

    /// Random bytes changed, removed, repeated: an error or a mesh that keeps the invariants.
    void random_damage() {
        const Mesh mesh = torus_mesh(5, 4);
        std::mt19937_64 rng(20240611);
        const auto below = [&](std::size_t n) { return std::size_t(rng() % n); };
        std::size_t loaded_count = 0, refused_count = 0;
        for (const Sample& sample : samples(mesh))
            for (int round = 0; round < 1500; ++round) {
                std::string bytes = sample.bytes;
                const std::size_t changes = 1 + below(4);
                for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
                    const std::size_t at = round % 3 == 0 ? below(std::min<std::size_t>(bytes.size(), 260))
                                                          : below(bytes.size());
                    switch (below(6)) {
                    case 0:
                        bytes[at] = char(bytes[at] ^ (1 << below(8)));
                        break;
                    case 1:
                        bytes[at] = char(rng());
                        break;
                    case 2:
                        bytes.erase(at, 1 + below(20));
                        break;
                    case 3:
                        bytes.insert(at, bytes.substr(below(bytes.size()), below(60)));
                        break;
                    case 4:
                        bytes[at] = "0123456789-.eE \n\r/\\,#"[below(21)];
                        break;
                    default:
                        bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), "\xFF\xFF\xFF\xFF");
                        break;
                    }
                }
                try {
                    check_invariants(read(bytes, sample.name));
                    ++loaded_count;
                } catch (const Error& e) {
                    ++refused_count;
                    const std::string line = e.what();
                    QVERIFY2(line.find(sample.name) != std::string::npos
                                 && line.find('\n') == std::string::npos && line.size() < 500,
                             line.c_str());
                }
            }
        QVERIFY(loaded_count > 500 && refused_count > 500); // both ways were tried
    }

    /// Random bytes under a good start.
    void random_bytes() {
        std::mt19937_64 rng(7);
        const std::string starts[] = {
            "",
            "solid x\n",
            "solid x\nfacet normal 0 0 1\nouter loop\nvertex ",
            "v 0 0 0\nf ",
            "ply\nformat ascii 1.0\n",
            "ply\nformat binary_big_endian 1.0\nelement vertex 9\nproperty float x\nproperty "
            "float y\nproperty float z\nelement face 5\nproperty list uchar uint "
            "vertex_indices\nend_header\n"};
        for (int round = 0; round < 3000; ++round) {
            std::string bytes = starts[std::size_t(round) % std::size(starts)];
            const std::size_t count = rng() % 700;
            const bool text = rng() % 2;
            for (std::size_t i = 0; i < count; ++i)
                bytes += text ? "0123456789 \n\t-.e/vfln#"[rng() % 22] : char(rng());
            for (const char* name : {"a.stl", "a.obj", "a.ply", "a"}) {
                try {
                    check_invariants(read(bytes, name));
                } catch (const Error& e) {
                    QVERIFY(e.code() != ErrorCode::internal);
                }
            }
        }
    }

    void threads_do_not_matter() {
        // 76 800 facets: several blocks of every loop.
        const Mesh torus = torus_mesh(trials(240, 2), trials(160, 2));
        Mesh broken = torus;
        for (std::size_t f = 0; f < broken.facets.size(); f += 97)
            std::swap(broken.facets[f][0], broken.facets[f][1]);
        broken.facets.resize(broken.facets.size() - 1000);
        broken.facets.insert(broken.facets.end(), torus.facets.begin(), torus.facets.begin() + 500);
        for (const Mesh* mesh : {&torus, static_cast<const Mesh*>(&broken)})
            for (const Sample& sample : samples(*mesh)) {
                set_thread_count(1);
                const LoadedMesh one = read(sample.bytes, sample.name);
                for (const int threads : under_sanitizer ? std::vector{3} : std::vector{2, 3, 0}) {
                    set_thread_count(threads);
                    const LoadedMesh many = read(sample.bytes, sample.name);
                    QVERIFY(same_mesh(*one.mesh, *many.mesh));
                    QCOMPARE(many.report.file_volume, one.report.file_volume);
                    QVERIFY(std::memcmp(&many.report.file_area, &one.report.file_area, sizeof(double)) == 0);
                    QVERIFY(std::memcmp(&many.report.file_volume, &one.report.file_volume, sizeof(double))
                            == 0);
                    QCOMPARE(many.report.shells, one.report.shells);
                    QCOMPARE(many.report.open_edges, one.report.open_edges);
                    QCOMPARE(many.report.inconsistent_edges, one.report.inconsistent_edges);
                    QCOMPARE(many.report.non_manifold_edges, one.report.non_manifold_edges);
                    QCOMPARE(many.report.non_manifold_vertices, one.report.non_manifold_vertices);
                    QCOMPARE(many.report.duplicate, one.report.duplicate);
                    QVERIFY(many.report.warnings == one.report.warnings);
                }
                set_thread_count(0);
            }
    }

    void cancelled_before_and_meanwhile() {
        const Mesh torus = under_sanitizer ? torus_mesh(120, 75) : torus_mesh(400, 250);
        std::size_t cancelled_count = 0;
        for (const Sample& sample : samples(torus)) {
            Job before;
            before.cancel();
            QVERIFY_EXCEPTION_THROWN(read_mesh(sample.bytes, sample.name, LengthUnit::mm, Progress(before)),
                                     Cancelled);
            // Cancelled when it has got so far; the fraction only grows, so every stage is met.
            for (const double fraction : {0.05, 0.3, 0.5, 0.7, 0.9}) {
                Job job;
                const bool cancelled = cancelled_at(job, fraction, [&](const Progress& p) {
                    read_mesh(sample.bytes, sample.name, LengthUnit::mm, p);
                });
                cancelled_count += cancelled;
                // It may have finished before the watcher ran; where it was cancelled, it had come as far as
                // asked.
                QVERIFY(!cancelled || job.fraction() >= fraction);
                QVERIFY(cancelled || job.fraction() > 0.99);
            }
        }
        QVERIFY(cancelled_count > 0);
    }

    void progress_reaches_the_end() {
        for (const Sample& sample : samples(torus_mesh(60, 40))) {
            Job job;
            read_mesh(sample.bytes, sample.name, LengthUnit::mm, Progress(job));
            QVERIFY2(job.fraction() > 0.99, sample.name);
        }
    }
};

FACETMILL_TEST(TestMeshRobust)
#include "test_mesh_io_robust.moc"
