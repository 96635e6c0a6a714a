// STEP and IGES files: solids of known volume, the deviation that is told against closed forms, units,
// assemblies, and everything that can be wrong with a file or with the program that reads it.
#include "core/base/child_process.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/surface_reader.h"
#include "tests/support/surface_files.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <thread>

using namespace facetmill;
using namespace facetmill::test;

namespace {

LoadedMesh loaded(const std::string& bytes, const std::string& name = "part.step",
                  const MeshReading& reading = {}) {
    return read_mesh(bytes, name, reading, Progress());
}

std::string code_of(const std::function<void()>& job, std::string* line = nullptr) {
    try {
        job();
    } catch (const Error& e) {
        if (line) *line = e.what();
        return std::string(code_name(e.code()));
    } catch (const Cancelled&) {
        return "cancelled";
    }
    return "ok";
}

/// Small enough that some readers take it for a file: for programs that do not read it.
const std::string some_step = "ISO-10303-21;\nHEADER;\nENDSEC;\nEND-ISO-10303-21;\n";

/// Puts a shell script in the place of the program that reads surfaces.
class OtherReader {
public:
    explicit OtherReader(const std::string& script) : path_(folder_.path().toStdString() + "/reader") {
        std::ofstream(path_) << "#!/bin/sh\n" << script << "\n";
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all);
        qputenv("FACETMILL_STEP", path_.c_str());
    }
    ~OtherReader() { qputenv("FACETMILL_STEP", before_); }
    OtherReader(const OtherReader&) = delete;
    OtherReader& operator=(const OtherReader&) = delete;

private:
    QTemporaryDir folder_;
    std::string path_;
    QByteArray before_ = qgetenv("FACETMILL_STEP");
};

double volume(const Mesh& mesh) {
    double six = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        six += mesh.corner(f, 0).dot(mesh.corner(f, 1).cross(mesh.corner(f, 2)));
    return six / 6;
}

/// The largest heights of a surface over and under the facets, by many places on each; `distance` is that of
/// a place from the surface, positive outside.
std::pair<double, double> out_and_in(const Mesh& mesh, const std::function<double(const Vec3&)>& distance) {
    double out = 0, in = 0;
    constexpr int n = 8;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                const Vec3 p = (double(i) * mesh.corner(f, 0) + double(j) * mesh.corner(f, 1)
                                + double(n - i - j) * mesh.corner(f, 2))
                               / n;
                const double d = distance(p);
                out = std::max(out, -d); // the facet is inside: the surface lies outside
                in = std::max(in, d);
            }
    return {out, in};
}

void check_solid(const LoadedMesh& found, double exact_volume, std::size_t faces,
                 const std::function<double(const Vec3&)>& distance) {
    const MeshReport& r = found.report;
    QVERIFY(r.watertight && r.degenerate == 0 && r.volume_mm3() > 0);
    QVERIFY(r.surfaces && r.surfaces->solids == 1 && r.surfaces->loose_faces == 0);
    QCOMPARE(r.surfaces->faces, faces);
    QCOMPARE(found.faces->size(), found.mesh->facet_count());
    const auto [out, in] = out_and_in(*found.mesh, distance);
    // What is told holds, and is not far from what is.
    QVERIFY2(
        out <= r.surfaces->out + 1e-9 && in <= r.surfaces->in + 1e-9,
        qPrintable(QString("%1 %2, told %3 %4").arg(out).arg(in).arg(r.surfaces->out).arg(r.surfaces->in)));
    QVERIFY(r.surfaces->out <= 1.5 * out + 1e-6 && r.surfaces->in <= 1.5 * in + 1e-6);
    QVERIFY(std::max(out, in) <= r.surfaces->chord || !r.warnings.empty());
    const double band = (r.surfaces->out + r.surfaces->in) * r.area_mm2();
    QVERIFY(std::abs(volume(*found.mesh) - exact_volume) <= band + 1e-9 * exact_volume);
}

} // namespace

class TestSurfaces : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
#ifdef FACETMILL_STEP_PROGRAM
        qputenv("FACETMILL_STEP", FACETMILL_STEP_PROGRAM);
#endif
    }

    void solids_of_known_volume() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const MeshReading coarse = [] {
            MeshReading reading;
            reading.chord = 0.02;
            return reading;
        }();
        const LoadedMesh box = loaded(step_box(10, 20, 30));
        QCOMPARE(box.mesh->facet_count(), std::size_t(12));
        QVERIFY(box.report.watertight && std::abs(volume(*box.mesh) - 6000) < 1e-9);
        QVERIFY(box.report.surfaces->out == 0 && box.report.surfaces->in == 0);
        for (const MeshReading& reading : {MeshReading(), coarse}) {
            check_solid(loaded(step_cylinder(10, 30), "a.step", reading), pi * 100 * 30, 3,
                        [](const Vec3& p) {
                            return std::max({p.head<2>().norm() - 10, p.z() - 30, -p.z()});
                        });
            check_solid(loaded(step_sphere(10), "a.stp", reading), 4.0 / 3 * pi * 1000, 1,
                        [](const Vec3& p) { return p.norm() - 10; });
            check_solid(loaded(step_torus(20, 5), "a.STEP", reading), 2 * pi * pi * 20 * 25, 1,
                        [](const Vec3& p) { return std::hypot(p.head<2>().norm() - 20, p.z()) - 5; });
            check_solid(
                loaded(step_block_with_hole(20), "a.step", reading), 200000 - pi * 400 * 20, 7,
                [](const Vec3& p) {
                    const double hole = 20 - (p.head<2>() - Vec2(50, 50)).norm();
                    return std::max({hole, p.x() - 100, -p.x(), p.y() - 100, -p.y(), p.z() - 20, -p.z()});
                });
        }
        // A hole is smaller in the mesh than it is, a boss too: the surface lies inside of one, outside of
        // the other.
        QVERIFY(loaded(step_block_with_hole(20)).report.surfaces->out < 1e-6);
        QVERIFY(loaded(step_cylinder(10, 30)).report.surfaces->in < 1e-6);
    }

    void the_same_bytes_in_every_run() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const std::string file = step_torus(20, 5);
        const LoadedMesh one = loaded(file), two = loaded(file);
        QVERIFY(one.mesh->vertices == two.mesh->vertices && one.mesh->facets == two.mesh->facets);
        QVERIFY(*one.faces == *two.faces);
    }

    void facets_of_a_face_lie_on_it() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const LoadedMesh found = loaded(step_block_with_hole(20));
        std::vector<std::size_t> count(7, 0);
        std::vector<int> round(7, 0), flat(7, 0);
        for (std::size_t f = 0; f < found.mesh->facet_count(); ++f) {
            const Index face = found.faces->at(f);
            ++count.at(face);
            const Vec3 n = found.mesh->facet_normal(f);
            const bool of_hole =
                (found.mesh->corner(f, 0).head<2>() - Vec2(50, 50)).norm() < 20.01 && std::abs(n.z()) < 1e-9;
            ++(of_hole ? round : flat)[face];
        }
        int holes = 0;
        for (std::size_t face = 0; face < 7; ++face) {
            QVERIFY(count[face] > 0 && (round[face] == 0 || flat[face] == 0));
            holes += round[face] > 0;
        }
        QCOMPARE(holes, 1);
    }

    void units_are_those_of_the_file() {
        if (no_surface_files()) QSKIP(no_surface_files());
        struct Case {
            const char* name;
            LengthUnit unit;
        };
        for (const Case& c : {Case{"MM", LengthUnit::mm}, {"INCH", LengthUnit::inch}, {"M", LengthUnit::m}}) {
            const std::string file = step_box(10, 20, 30, c.name);
            const LoadedMesh found = loaded(file);
            QVERIFY(found.report.unit_known && found.report.assumed_unit == c.unit);
            QVERIFY((found.mesh->box().size() - Vec3(10, 20, 30)).norm() < 1e-6);
            QVERIFY((found.report.file_box.size() * mm_per(c.unit) - Vec3(10, 20, 30)).norm() < 1e-6);
            QVERIFY(found.report.watertight);
            const auto differs = [&](LengthUnit said) {
                const auto words = loaded(file, "a.step", said).report.warnings;
                return std::count(words.begin(), words.end(), "unit_differs") > 0;
            };
            QVERIFY(!differs(c.unit));
            QVERIFY(differs(LengthUnit::ft));
        }
    }

    void five_hundred_parts_are_all_in_place() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const LoadedMesh found = loaded(step_assembly(500, 25));
        QCOMPARE(found.report.surfaces->solids, std::size_t(500));
        QCOMPARE(found.report.shells, std::size_t(500));
        QVERIFY(found.report.watertight && !found.report.surfaces->parts.empty());
        QVERIFY(std::abs(volume(*found.mesh) - 3000) < 1e-6);
        QCOMPARE(found.report.surfaces->faces, std::size_t(3000));
        std::size_t in_the_last = 0;
        for (const Vec3& v : found.mesh->vertices)
            in_the_last += v.x() > 230 && v.y() > 180;
        QCOMPARE(in_the_last, std::size_t(8));
        QVERIFY(std::count(found.report.warnings.begin(), found.report.warnings.end(), "several_bodies")
                == 1);
    }

    void surfaces_alone_are_sheets() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const LoadedMesh bowl = loaded(step_bowl(10));
        QVERIFY(!bowl.report.watertight && bowl.report.surfaces->solids == 0);
        QCOMPARE(bowl.report.surfaces->loose_faces, std::size_t(1));
        QVERIFY(std::count(bowl.report.warnings.begin(), bowl.report.warnings.end(), "loose_surfaces") == 1);
        QVERIFY(bowl.report.surfaces->out == bowl.report.surfaces->in && bowl.report.surfaces->out > 0);
        for (const Vec3& v : bowl.mesh->vertices)
            QVERIFY(std::abs(v.norm() - 10) < 1e-9 && v.z() < 1e-9);
        QCOMPARE(code_of([] { loaded(step_wire()); }), std::string("no_facets"));
    }

    void iges_surfaces_are_joined() {
        if (no_surface_files()) QSKIP(no_surface_files());
        for (const bool solid : {true, false}) {
            const LoadedMesh found = loaded(iges_cylinder(10, 30, solid), "a.igs");
            QCOMPARE(found.report.format, std::string("IGES"));
            check_solid(found, pi * 100 * 30, 3, [](const Vec3& p) {
                return std::max({p.head<2>().norm() - 10, p.z() - 30, -p.z()});
            });
            const auto& words = found.report.warnings;
            QCOMPARE(std::count(words.begin(), words.end(), "surfaces_joined"), solid ? 0 : 1);
        }
    }

    void damaged_files() {
        const std::string whole = no_surface_files() ? some_step : step_cylinder(10, 30);
        QCOMPARE(code_of([] { loaded(""); }), std::string("empty_file"));
        QCOMPARE(code_of([] { loaded(std::string(5000, '\x7F')); }), std::string("unsupported_format"));
        QCOMPARE(code_of([] { loaded(some_step, "a.igs"); }), std::string("unsupported_format"));
        QCOMPARE(code_of([&] { loaded(whole.substr(0, whole.size() / 2)); }), std::string("truncated"));
        if (no_surface_files()) QSKIP(no_surface_files());
        QVERIFY(code_of([] { loaded(some_step); }) == "no_facets"
                || code_of([] { loaded(some_step); }) == "syntax");
        // Without an extension the content decides.
        QVERIFY(loaded(whole, "part").report.watertight);
        // Any byte may be wrong; the answer is a mesh or an error, and says where.
        std::uint32_t random = 1;
        for (int i = 0; i < 30; ++i) {
            std::string damaged = whole;
            for (int k = 0; k < 8; ++k) {
                random = random * 1664525u + 1013904223u;
                damaged[100 + (random >> 8) % (damaged.size() - 200)] = char(' ' + (random >> 4) % 90);
            }
            std::string line;
            const std::string code = code_of([&] { loaded(damaged); }, &line);
            QVERIFY2(code == "ok" || line.find("part.step") != std::string::npos, line.c_str());
        }
    }

    void a_limit_of_memory() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const std::string file = step_sphere(1000);
        MeshReading reading;
        reading.chord = 1e-4;
        const detail::MeshSource source{file, "large.step", 1e7, reading};
        std::string line;
        const std::string code =
            code_of([&] { detail::read_surfaces(source, "step", {.memory_mb = 300}, Progress()); }, &line);
        QVERIFY2(code == "too_large", line.c_str());
        QVERIFY(line.find("large.step") != std::string::npos);
    }

    void without_the_program() {
        const QByteArray before = qgetenv("FACETMILL_STEP");
        qputenv("FACETMILL_STEP", "/nowhere/facetmill-step");
        std::string line;
        QCOMPARE(code_of([] { loaded(some_step); }, &line), std::string("not_found"));
        QVERIFY(line.find("part.step") != std::string::npos && line.find("OpenCASCADE") != std::string::npos);
        qputenv("FACETMILL_STEP", before);
        QVERIFY(!program_places("facetmill-step").empty());
    }

    void a_program_that_fails() {
        struct Case {
            const char *script, *code, *says;
        };
        for (const Case& c :
             {Case{"kill -9 $$", "internal", "signal 9"}, Case{"kill -11 $$", "internal", "signal 11"},
              Case{"exit 3", "internal", "status 3"}, Case{"exit 0", "internal", "something else"},
              Case{"echo nothing >&4; exit 0", "internal", "something else"},
              Case{"echo progress; echo progress 7 x; echo progress nan; exit 0", "internal",
                   "something else"},
              Case{"echo error no_facets; echo what it is empty; echo remedy fill it; exit 1", "no_facets",
                   "it is empty (fill it)"},
              Case{"printf 'facetmill-tessellation 1\\nvertices 1\\nfacets 4e9\\n\\n' >&4", "internal",
                   "something else"}}) {
            const OtherReader reader(c.script);
            std::string line;
            const std::string code = code_of([] { loaded(some_step); }, &line);
            QVERIFY2(code == c.code && line.find(c.says) != std::string::npos, line.c_str());
            QVERIFY(line.find("part.step") == 0);
        }
    }

    void a_program_that_says_nothing_is_stopped() {
        const OtherReader reader("exec sleep 1000");
        const MeshReading reading;
        const detail::MeshSource source{some_step, "part.step", 1e7, reading};
        std::string line;
        QCOMPARE(code_of([&] { detail::read_surfaces(source, "step", {.silent_seconds = 0.2}, Progress()); },
                         &line),
                 std::string("internal"));
        QVERIFY2(line.find("said nothing") != std::string::npos, line.c_str());
    }

    void cancelling_ends_the_program() {
        QTemporaryDir folder;
        const std::string pid = folder.path().toStdString() + "/pid";
        const OtherReader reader("echo $$ > " + pid + "; echo progress 0.5 Working; exec sleep 1000");
        Job job;
        std::thread other([&] {
            while (job.label() != "Working")
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            job.cancel();
        });
        const std::string code = code_of([&] { read_mesh(some_step, "part.step", {}, Progress(job)); });
        other.join();
        QCOMPARE(code, std::string("cancelled"));
        QVERIFY(job.fraction() > 0 && job.fraction() < 0.5);
        int number = 0;
        std::ifstream(pid) >> number;
        QVERIFY(number > 0 && !std::filesystem::exists("/proc/" + std::to_string(number)));
    }
};

FACETMILL_TEST(TestSurfaces)
#include "test_surfaces.moc"
