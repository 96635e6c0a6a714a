// Open, plan, verify, close, over and over in one process: what is in use must not grow. FACETMILL_SOAK=N
// makes N rounds, ten thousand in the slow tests. The first tenth fills what is kept for the process: the
// threads' scratch, arenas, tables that are made once.
#include "core/job/planner.h"
#include "core/job/posting.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "tests/support/memory_in_use.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <fstream>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double most_growth = 0.01;

/// One operation of every way of planning, over a part of a few facets.
constexpr const char* operations[] = {
    R"("kind": "finish3", "tool": 1, "tolerance": 0.3)",
    R"("kind": "rough", "tool": 2, "tolerance": 0.5)",
    R"("kind": "finish5", "tool": 1, "tolerance": 0.5, "grid_degrees": 20)",
};

std::filesystem::path write_project(const std::filesystem::path& folder, std::size_t which) {
    const auto path = folder / ("job" + std::to_string(which) + ".facetmill");
    std::ofstream(path) << R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl" },
  "machine": "trunnion-ac", "stock": { "kind": "box", "margin": [1, 1, 1] },
  "tools": [ { "number": 1, "name": "Ball", "diameter": 4, "corner_radius": 2 },
             { "number": 2, "name": "Flat", "diameter": 4 } ],
  "operations": [ { "name": "One", )"
                        << operations[which] << " } ] }";
    return path;
}

/// Everything is made anew, and gone at the end. False where nothing was cut.
bool round_of(const std::filesystem::path& file) {
    const Project project = load_project(file);
    check_project(project);
    Planner planner;
    const auto plan = planner.plan(project, {}, {});
    const auto programs = verify_programs(project, plan);
    VerifySettings settings = verify_settings(project, plan.get());
    settings.resolution = settings.sample_spacing = 0.8;
    const Verification v = verify(*plan->part->mesh, plan->stock, programs, settings, {});
    return !programs.empty() && v.surface && !v.surface->points.empty()
           && !verify_json(project, programs, v).empty();
}

} // namespace

class TestSoak : public QObject {
    Q_OBJECT
private slots:
    void nothing_grows() {
        const int rounds = std::max(100, qEnvironmentVariableIntValue("FACETMILL_SOAK"));
        QTemporaryDir dir;
        const std::filesystem::path folder = dir.path().toStdString();
        save_stl(height_field([](double x, double y) { return 0.5 * std::sin(x) + 0.2 * y; }, Vec2(-4, -3),
                              Vec2(4, 3), 3, 2),
                 folder / "part.stl", LengthUnit::mm, {});
        std::vector<std::filesystem::path> files;
        for (std::size_t k = 0; k < std::size(operations); ++k)
            files.push_back(write_project(folder, k));
        QElapsedTimer timer;
        timer.start();
        MemoryInUse early;
        for (int k = 0; k < rounds; ++k) {
            QVERIFY2(round_of(files[std::size_t(k) % files.size()]), qPrintable(QString::number(k)));
            if (k + 1 == rounds / 10) early = memory_in_use();
        }
        const MemoryInUse late = memory_in_use();
        std::printf("%d rounds in %.0f s: in use %.3f MB, then %.3f MB (%+.2f %%); resident %.1f MB, then "
                    "%.1f MB (%+.2f %%)\n",
                    rounds, 1e-3 * double(timer.elapsed()), early.allocated / 1e6, late.allocated / 1e6,
                    100 * (late.allocated / early.allocated - 1), early.resident / 1e6, late.resident / 1e6,
                    100 * (late.resident / early.resident - 1));
        QVERIFY(late.allocated <= (1 + most_growth) * early.allocated);
    }
};

FACETMILL_TEST(TestSoak)
#include "test_soak.moc"
