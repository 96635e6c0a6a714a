// How the window answers while a large part is read, planned and cancelled. Prints a table; asserts nothing.
//
//     xvfb-run -a bench_window [FACETS]
#include "core/mesh/mesh_io.h"
#include "ui/main_window.h"
#include "ui/project_tree.h"
#include "ui/settings.h"
#include "ui/theme.h"
#include "ui/viewport.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTimer>

#include <cmath>
#include <cstdio>

#include <vtkObject.h>

using namespace facetmill;

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

/// The longest time the event loop did not come round.
class Heart : public QObject {
public:
    Heart() {
        connect(&timer_, &QTimer::timeout, this, [this] {
            longest_ = std::max(longest_, since_.nsecsElapsed());
            since_.restart();
        });
        timer_.setTimerType(Qt::PreciseTimer);
        timer_.start(1);
        since_.start();
    }
    void reset() {
        longest_ = 0;
        since_.restart();
    }
    double longest_ms() const { return double(longest_) * 1e-6; }

private:
    QTimer timer_;
    QElapsedTimer since_;
    qint64 longest_ = 0;
};

void run_for(int ms) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < ms)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
}

void wait(ui::MainWindow& window) {
    while (window.busy())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    run_for(50);
}

} // namespace

int main(int argc, char** argv) {
    QTemporaryDir home;
    qputenv("XDG_CONFIG_HOME", (home.path() + QStringLiteral("/config")).toUtf8());
    qputenv("XDG_CACHE_HOME", (home.path() + QStringLiteral("/cache")).toUtf8());
    vtkObject::GlobalWarningDisplayOff();
    ui::Viewport::set_default_format();
    QApplication::setOrganizationName(QStringLiteral("FacetmillTest"));
    QApplication app(argc, argv);
    const std::size_t facets = argc > 1 ? std::size_t(std::atoll(argv[1])) : 1000000;
    const QString path = home.path() + QStringLiteral("/field.stl");
    save_stl(*height_field(facets), path.toStdString(), LengthUnit::mm, {});

    ui::MainWindow window;
    window.resize(1280, 800);
    window.show();
    run_for(300);
    Heart heart;
    const auto row = [&](const char* what, double total_ms) {
        std::printf("%-44s %10.1f ms total %10.1f ms longest pause\n", what, total_ms, heart.longest_ms());
        std::fflush(stdout);
    };
    QElapsedTimer timer;

    heart.reset();
    timer.start();
    window.open_file(path, LengthUnit::mm);
    wait(window);
    row("read and show the part", double(timer.elapsed()));
    std::printf("%-44s %10.1f ms\n", "one frame of it", window.viewport().last_frame_ms());

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

    const bool still = window.job().running();
    double ended_ms = 0;
    QObject::connect(&window.job(), &ui::BackgroundJob::ended, &window,
                     [&] { ended_ms = double(timer.nsecsElapsed()) * 1e-6; });
    timer.restart();
    window.cancel();
    const double returned_ms = double(timer.nsecsElapsed()) * 1e-6;
    wait(window);
    std::printf("%-44s %10.1f ms until it ended, %.2f ms until cancel() returned%s\n", "cancel", ended_ms,
                returned_ms, still ? "" : " (planning had already ended)");
    return 0;
}
