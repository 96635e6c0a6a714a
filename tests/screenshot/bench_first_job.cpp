// How the window answers through a whole first job: opened, laid down, planned, verified, seen in all
// workspaces, played back, exported. Prints a table of the longest pauses of its event loop; asserts nothing.
//
//     xvfb-run -a bench_first_job [FACETS]
//     FACETMILL_TRACE_PAUSES=40 xvfb-run -a bench_first_job    # also where each pause above 40 ms goes
#include "core/job/project.h"
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/bench_support.h"
#include "tests/support/part_meshes.h"
#include "ui/controllers.h"
#include "ui/place_controller.h"
#include "ui/playback_bar.h"
#include "ui/program_export.h"
#include "ui/project_files.h"
#include "ui/project_tree.h"
#include "ui/verification_controller.h"
#include "ui/workspaces.h"

#include <QAbstractButton>
#include <QAction>
#include <QKeyEvent>

#include <cmath>
#include <cstdio>
#include <functional>

using namespace facetmill;
using namespace facetmill::test;

int main(int argc, char** argv) {
    const BenchApplication app(argc, argv);
    const int cells = int(std::sqrt((argc > 1 ? std::atof(argv[1]) : 200000.0) / 2));
    const QString path = app.home() + QStringLiteral("/relief.stl");
    save_stl(height_field([](double x, double y) { return 3 + std::sin(x / 7) * std::cos(y / 8); },
                          Vec2(0, 0), Vec2(60, 40), cells, cells),
             path.toStdString(), LengthUnit::mm, {});
    ui::MainWindow window;
    window.resize(1280, 800);
    window.viewport().make_shaders();
    window.show();
    run_for(1500); // also for the shaders of a first picture
    Heart heart;
    std::printf("%-24s %10s %14s %14s   %s\n", "", "total, ms", "longest pause", "most computed",
                "the longest pause by cause, ms");
    const auto row = [&](const char* what, const std::function<void()>& act) {
        QElapsedTimer timer;
        heart.reset();
        timer.start();
        act();
        wait(window);
        run_for(300);
        std::printf("%-24s %10.0f %14.1f %14.1f   %s\n", what, double(timer.elapsed()), heart.longest_ms(),
                    heart.computed_ms(), qPrintable(heart.longest_by_cause()));
        std::fflush(stdout);
    };
    const auto trigger = [&](const char* name) {
        if (auto* action = window.findChild<QAction*>(QLatin1String(name))) action->trigger();
    };
    const auto press = [&](int key) {
        QKeyEvent down(QEvent::KeyPress, key, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &down);
    };
    row("steps shown", [&] { trigger("first_steps"); });
    row("opened", [&] { window.open_file(path, LengthUnit::mm); });
    row("place panel", [&] { trigger("place"); });
    row("turned by 90 degrees", [&] {
        window.document().change(QStringLiteral("Turn"), [](Project& p) { p.part.rotate[2] = 0.5 * pi; });
    });
    row("perspective, and back", [&] {
        trigger("perspective");
        run_for(200);
        trigger("perspective");
    });
    row("roughing added", [&] { window.document().add_operation("rough"); });
    row("forms of all nodes", [&] {
        using Kind = ui::TreeNode::Kind;
        for (const Kind kind : {Kind::part, Kind::stock, Kind::machine, Kind::tool, Kind::operation}) {
            window.tree().select({kind, 0});
            run_for(40);
        }
    });
    row("planned", [&] { trigger("plan"); });
    row("verified", [&] { trigger("verify"); });
    row("all workspaces", [&] {
        using W = ui::Workspace;
        for (const W w : {W::prepare, W::plan, W::verify, W::simulate}) {
            window.workspaces().enter(w);
            run_for(150);
        }
    });
    row("played back for 2 s", [&] {
        press(Qt::Key_Space);
        run_for(2000);
        press(Qt::Key_Space);
    });
    row("exported", [&] { window.exports().save_programs(app.home() + QStringLiteral("/programs")); });
    row("saved", [&] { window.files().save_to(app.home() + QStringLiteral("/job.facetmill")); });
    // As it was: plan and verdict are read, not made.
    row("opened again", [&] { window.open_file(app.home() + QStringLiteral("/job.facetmill")); });
    if (!window.verification().model().current()) std::printf("it is not as it was\n");
    for (const char* name : {"place_square", "place_principal"})
        row(name, [&] { window.findChild<QAbstractButton*>(QLatin1String(name))->click(); });
    return 0;
}
