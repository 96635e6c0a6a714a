// How the window answers while a large part is read, planned and cancelled. Prints a table; asserts nothing.
//
//     xvfb-run -a bench_window [FACETS]
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/bench_support.h"
#include "ui/main_window.h"
#include "ui/project_tree.h"
#include "ui/settings.h"
#include "ui/theme.h"
#include "ui/viewport.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <vector>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A wavy height field of about `facets` facets, 200 mm square.
MeshPtr height_field(std::size_t facets) {
    auto mesh = std::make_shared<Mesh>();
    const auto n = Index(std::sqrt(double(facets) / 2)) + 1;
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
            const double x = 200.0 * i / (n - 1), y = 200.0 * j / (n - 1);
            mesh->vertices.emplace_back(x, y, 12 * std::sin(x / 18) * std::cos(y / 23));
        }
    for (Index j = 0; j + 1 < n; ++j)
        for (Index i = 0; i + 1 < n; ++i) {
            const Index a = j * n + i;
            mesh->facets.push_back({a, a + 1, a + n + 1});
            mesh->facets.push_back({a, a + n + 1, a + n});
        }
    return mesh;
}

} // namespace

int main(int argc, char** argv) {
    const BenchApplication app(argc, argv);
    const std::size_t facets = argc > 1 ? std::size_t(std::atoll(argv[1])) : 1000000;
    const QString path = app.home() + QStringLiteral("/field.stl");
    save_stl(*height_field(facets), path.toStdString(), LengthUnit::mm, {});

    QElapsedTimer timer;
    timer.start();
    ui::MainWindow window;
    window.resize(1280, 800);
    std::printf("%-44s %10.1f ms\n", "the window made", double(timer.restart()));
    window.viewport().make_shaders();
    std::printf("%-44s %10.1f ms\n", "shaders, before it is shown", double(timer.restart()));
    window.show();
    run_for(200);
    Heart heart;
    const auto row = [&](const char* what, double total_ms) {
        const double pause = heart.longest_ms(), computed = heart.computed_ms();
        std::printf("%-44s %10.1f ms total %10.1f ms longest pause (%s) %10.1f ms most computed in a round\n",
                    what, total_ms, pause, qPrintable(heart.longest_by_cause()), computed);
        std::fflush(stdout);
    };

    heart.reset();
    timer.start();
    window.open_file(path, LengthUnit::mm);
    wait(window);
    row("read and show the part", double(timer.elapsed()));
    std::printf("%-44s %10.1f ms\n", "its full picture", window.viewport().last_frame_ms());

    // Fine enough to last until it is cancelled.
    window.document().change(QStringLiteral("tolerance"), [](Project& p) {
        for (auto& o : p.operations)
            o->common().tolerance = 0.001;
    });
    heart.reset();
    timer.restart();
    window.plan();
    run_for(3000);
    row("first 3 s of planning, window idle", double(timer.elapsed()));

    heart.reset();
    timer.restart();
    for (int i = 0; i < 20 && window.job().running(); ++i) {
        window.tree().select({i % 2 ? ui::TreeNode::Kind::operation : ui::TreeNode::Kind::part, 0});
        window.viewport().view_cube();
        run_for(25);
    }
    row("forms changed 20 times while planning", double(timer.elapsed()));

    heart.reset();
    timer.restart();
    for (int i = 0; i < 10 && window.job().running(); ++i) {
        window.viewport().set_view(i % 2 ? StandardView::top : StandardView::iso);
        run_for(50);
    }
    row("view turned 10 times while planning", double(timer.elapsed()));

    // As a hand does it: the pointer moves on every 16 ms, whatever has been drawn by then.
    ui::Viewport& view = window.viewport();
    const QPoint middle = view.rect().center();
    const auto mouse = [&](QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons) {
        QMouseEvent event(type, at, view.mapToGlobal(at), button, buttons, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    };
    const auto drag = [&](const char* what) {
        heart.reset();
        timer.restart();
        const int frames = view.frames();
        mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::LeftButton);
        for (int i = 1; i <= 60; ++i) {
            mouse(QEvent::MouseMove, middle + QPoint(4 * i, i), Qt::NoButton, Qt::LeftButton);
            run_for(16);
        }
        mouse(QEvent::MouseButtonRelease, middle + QPoint(240, 60), Qt::LeftButton, Qt::NoButton);
        const int drawn = view.frames() - frames;
        run_for(1000);
        row(what, double(timer.elapsed()));
        std::printf("%-44s %10d frames, the last one %.1f ms\n", "", drawn, view.last_frame_ms());
    };
    drag("turned by the mouse, planning");
    heart.reset();
    timer.restart();
    for (int i = 0; i < 20; ++i) {
        mouse(QEvent::MouseMove, middle + QPoint(3 * i, 2 * i), Qt::NoButton, Qt::NoButton);
        run_for(80);
    }
    row("pointer over the part, planning", double(timer.elapsed()));

    // What the user sees: the word in the status bar, painted.
    class Painted : public QObject {
    public:
        Painted(QLabel* label, const QElapsedTimer& clock) : label_(label), clock_(clock) {
            label->installEventFilter(this);
        }
        double ms = 0;

    private:
        bool eventFilter(QObject*, QEvent* event) override {
            if (event->type() == QEvent::Paint && ms == 0 && label_->text() == QStringLiteral("Ready"))
                ms = double(clock_.nsecsElapsed()) * 1e-6;
            return false;
        }
        QLabel* label_;
        const QElapsedTimer& clock_;
    } painted(window.findChild<QLabel*>(QStringLiteral("activity")), timer);
    double ended_ms = 0;
    QObject::connect(&window.job(), &ui::BackgroundJob::ended, &window,
                     [&] { ended_ms = double(timer.nsecsElapsed()) * 1e-6; });
    // Cancels at moments spread over the first `over_ms` of a job.
    const auto cancels = [&](const char* what, int tries, int over_ms, const std::function<void()>& start) {
        std::vector<double> end, said, returned;
        double pause = 0;
        QString cause;
        for (int i = 0; i < tries; ++i) {
            start();
            run_for(over_ms * (2 * i + 1) / (2 * tries));
            if (!window.job().running()) continue;
            heart.reset();
            painted.ms = 0;
            timer.restart();
            window.cancel();
            returned.push_back(double(timer.nsecsElapsed()) * 1e-6);
            while (window.job().running() || painted.ms == 0)
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
            end.push_back(ended_ms);
            said.push_back(painted.ms);
            if (heart.longest_ms() > pause) cause = heart.longest_by_cause();
            pause = std::max(pause, heart.longest_ms());
            wait(window);
        }
        if (end.empty()) {
            std::printf("%-44s %10s\n", what, "the job had always ended");
            return;
        }
        for (auto* list : {&end, &said, &returned})
            std::sort(list->begin(), list->end());
        const auto middle_and_worst = [](const std::vector<double>& list) {
            return QString::asprintf("%.1f (worst %.1f)", list[list.size() / 2], list.back());
        };
        std::printf(
            "%-44s %10zu of %d: ended after %s ms, window said so after %s ms, cancel() took %s ms, longest "
            "pause %.1f ms (%s)\n",
            what, end.size(), tries, qPrintable(middle_and_worst(end)), qPrintable(middle_and_worst(said)),
            qPrintable(middle_and_worst(returned)), pause, qPrintable(cause));
        std::fflush(stdout);
    };
    heart.reset();
    timer.restart();
    window.cancel();
    wait(window);
    run_for(1000);
    row("after the cancel", double(timer.elapsed()));
    drag("turned by the mouse, idle");
    cancels("planning cancelled", 20, 4000, [&] { window.plan(); });
    // The part anew in another place: indexing and all before it run again.
    cancels("reading and first planning cancelled", 10, 2000, [&] {
        static double turn = 0;
        window.document().change(QStringLiteral("turn"), [](Project& p) { p.part.rotate[2] = turn += 0.01; });
        run_for(1);
        window.plan();
    });
    cancels("reading the file cancelled", 20, 1500, [&] {
        window.document().clear(); // nothing to be asked about
        std::filesystem::last_write_time(path.toStdString(), std::filesystem::file_time_type::clock::now());
        window.open_file(path, LengthUnit::mm);
    });
    return 0;
}
