// How the window answers during verification and playback. Prints a table; asserts nothing.
//
//     xvfb-run -a bench_playback [SAMPLE [TOLERANCE_MM]]
#include "tests/screenshot/bench_support.h"
#include "ui/layer_bar.h"
#include "ui/playback_bar.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QDockWidget>
#include <QSlider>

#include <cstdio>
#include <cstdlib>

using namespace facetmill;
using namespace facetmill::test;

int main(int argc, char** argv) {
    const BenchApplication app(argc, argv);
    ui::MainWindow window;
    window.resize(1280, 800);
    window.viewport().make_shaders();
    window.show();
    run_for(1000); // also for the shaders of a first picture
    window.new_from_sample(argc > 1 ? argv[1] : "concave");
    wait(window);
    if (argc > 2)
        window.document().change(QStringLiteral("tolerance"), [&](Project& p) {
            for (auto& o : p.operations)
                o->common().tolerance = std::atof(argv[2]);
        });
    Heart heart;
    QElapsedTimer timer;
    const auto measure = [&](const char* what, auto run) {
        heart.reset();
        timer.start();
        const int frames = window.viewport().frames();
        run();
        std::printf("%-30s %8.0f ms, longest pause %7.1f ms (%.1f computed), %4d pictures\n", what,
                    double(timer.elapsed()), heart.longest_ms(), heart.computed_ms(),
                    window.viewport().frames() - frames);
        std::fflush(stdout);
    };
    measure("plan", [&] {
        window.plan();
        wait(window);
    });
    ui::PlaybackController& playback = window.verification().playback();
    if (!playback.loaded()) {
        std::printf("nothing to play back\n");
        return 1;
    }
    std::printf("%zu motions, machining time %.0f s\n", playback.track().motion_count(),
                playback.track().seconds());
    measure("first picture of the stock", [&] {
        playback.step(1);
        wait(window);
    });
    using Unit = ui::PlaybackSpeed::Unit;
    for (const auto& [speed, what] :
         {std::pair(ui::PlaybackSpeed{Unit::machining_time, 10}, "play, 10 x"),
          {ui::PlaybackSpeed{Unit::machining_time, 1000}, "play, 1000 x"},
          {ui::PlaybackSpeed{Unit::motions_per_second, 1000}, "play, 1000 GOTO/s"}}) {
        playback.go_to(0);
        wait(window);
        playback.set_speed(speed);
        measure(what, [&] {
            playback.play();
            for (int i = 0; i < 50 && playback.playing(); ++i)
                run_for(100);
            playback.pause();
        });
        std::printf("%-30s %8.0f of %zu motions\n", "", playback.target(), playback.track().motion_count());
        measure("the finer stock at rest", [&] {
            wait(window);
            run_for(4000);
        });
    }
    auto* slider = window.verification().bar()->slider();
    measure("scrubbed there and back", [&] {
        for (int i = 0; i <= 120; ++i) {
            slider->setValue(int((i <= 60 ? i : 120 - i) / 60.0 * slider->maximum()));
            run_for(16);
        }
    });
    measure("to the end", [&] {
        playback.go_to(double(playback.track().motion_count()));
        wait(window);
    });
    measure("the panel", [&] {
        window.findChild<QDockWidget*>(QStringLiteral("verification_dock"))->raise();
        run_for(500);
    });
    for (const char* what : {"verify", "verify again"})
        measure(what, [&] {
            window.verify();
            wait(window);
            run_for(500);
        });
    return 0;
}
