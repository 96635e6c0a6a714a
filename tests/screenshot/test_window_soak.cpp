// Open, plan, verify, close, over and over in one workbench: what is in use must not grow. FACETMILL_SOAK=N
// makes N rounds, a thousand in the slow tests; without it a few, which show that a round does what it says.
#include "tests/screenshot/window_support.h"
#include "tests/support/memory_in_use.h"
#include "ui/verification_controller.h"

#include <vtkFreeTypeTools.h>

#include <QElapsedTimer>
#include <QFile>
#include <QPixmapCache>
#include <QTest>

#include <algorithm>
#include <cstdio>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double most_growth = 0.01;
/// Rounds of one window: what it keeps from one project to the next counts, and what it leaves when it is
/// closed.
constexpr int rounds_a_window = 10;
constexpr int usual_rounds = 2, fewest_to_judge = 100;

/// VTK keeps faces and sizes of fonts, up to numbers of its own; which ones depends on what was drawn last,
/// and is a hundred kilobytes more or less from one look to the next.
class KeptGlyphs : public vtkFreeTypeTools {
public:
    static void forget() { (vtkFreeTypeTools::GetInstance()->*(&KeptGlyphs::ReleaseCacheManager))(); }
};

MemoryInUse in_use() {
    KeptGlyphs::forget();
    return memory_in_use();
}

} // namespace

class TestWindowSoak : public QObject, private WindowFixture {
    Q_OBJECT

    const int usual_cache_ = QPixmapCache::cacheLimit();

    void round_of(const QString& project) {
        w().open_file(project);
        QVERIFY(wait_until_settled(w()) && w().document().part_is_current());
        w().plan();
        QVERIFY(wait_until_settled(w()) && w().document().state(0) == ui::OperationState::planned);
        w().verify();
        QVERIFY(wait_until_settled(w()) && w().verification().model().any());
    }

private slots:
    void cleanup() {
        close_window();
        QPixmapCache::setCacheLimit(usual_cache_);
    }

    void nothing_grows() {
        const int asked = qEnvironmentVariableIntValue("FACETMILL_SOAK");
        const int rounds = asked > 0 ? asked : usual_rounds;
        const QString folder = scratch_folder(QStringLiteral("soak"));
        write_mesh(folder);
        QStringList projects;
        for (const char* operation : {R"("kind": "finish3", "tool": 1, "tolerance": 0.2)",
                                      R"("kind": "rough", "tool": 2, "tolerance": 0.5)"}) {
            projects << folder + QStringLiteral("/job%1.facetmill").arg(projects.size());
            QFile file(projects.back());
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(QByteArray(R"({ "facetmill": 1, "units": "in", "part": { "file": "surface.stl" },
  "stock": { "kind": "box", "margin": [0.1, 0.1, 0.1] },
  "tools": [ { "number": 1, "name": "Ball", "diameter": 6, "corner_radius": 3 },
             { "number": 2, "name": "Flat", "diameter": 6 } ],
  "operations": [ { "name": "One", )")
                       + operation + " } ] }");
        }
        // Qt's cache of drawn pixmaps fills up to a limit of its own (10 MB) and then drops the oldest: while
        // it fills, it would hide what grows without an end. Emptied by `clear` it keeps the names of all
        // that was in it (Qt 6.4), some 20 kB a window: nothing is to come in.
        QPixmapCache::setCacheLimit(0);
        QElapsedTimer timer;
        timer.start();
        MemoryInUse early;
        for (int k = 0; k < rounds; ++k) {
            if (k % rounds_a_window == 0) {
                close_window();
                if (k + rounds_a_window > rounds / 10 && early.allocated == 0) early = in_use();
                if (asked > 0 && k > 0 && k % std::max(rounds / 10, rounds_a_window) == 0) {
                    std::printf("after %d rounds: in use %.3f MB\n", k, in_use().allocated / 1e6);
                    std::fflush(stdout);
                }
                QVERIFY(show_window());
                w().resize(640, 480); // less to draw
            }
            round_of(projects[k % projects.size()]);
            if (QTest::currentTestFailed()) return;
        }
        close_window();
        const MemoryInUse late = in_use();
        if (asked > 0)
            std::printf(
                "%d rounds in %.0f s: in use %.2f MB, then %.2f MB (%+.2f %%); resident %.0f MB, then "
                "%.0f MB (%+.2f %%)\n",
                rounds, 1e-3 * double(timer.elapsed()), early.allocated / 1e6, late.allocated / 1e6,
                100 * (late.allocated / early.allocated - 1), early.resident / 1e6, late.resident / 1e6,
                100 * (late.resident / early.resident - 1));
        if (rounds >= fewest_to_judge) QVERIFY(late.allocated <= (1 + most_growth) * early.allocated);
    }
};

FACETMILL_TEST(TestWindowSoak)
#include "test_window_soak.moc"
