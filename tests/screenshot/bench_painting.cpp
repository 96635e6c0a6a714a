// How the window answers while facets of a large part are painted. Prints a table; asserts nothing.
//
//     xvfb-run -a bench_painting [FACETS]
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/bench_support.h"
#include "ui/boundary_box.h"
#include "ui/boundary_list.h"
#include "ui/main_window.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/viewport.h"

#include <QAbstractButton>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QMouseEvent>

#include <cmath>
#include <cstdio>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A wavy height field of about `facets` facets, 200 mm square.
Mesh wavy_field(std::size_t facets) {
    Mesh mesh;
    const auto n = Index(std::sqrt(double(facets) / 2)) + 1;
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
            const double x = 200.0 * i / (n - 1), y = 200.0 * j / (n - 1);
            mesh.vertices.emplace_back(x, y, 12 * std::sin(x / 18) * std::cos(y / 23));
        }
    for (Index j = 0; j + 1 < n; ++j)
        for (Index i = 0; i + 1 < n; ++i) {
            const Index a = j * n + i;
            mesh.facets.push_back({a, a + 1, a + n + 1});
            mesh.facets.push_back({a, a + n + 1, a + n});
        }
    return mesh;
}

} // namespace

int main(int argc, char** argv) {
    const BenchApplication app(argc, argv);
    const QString path = app.home() + QStringLiteral("/field.stl");
    save_stl(wavy_field(argc > 1 ? std::size_t(std::atoll(argv[1])) : 1000000), path.toStdString(),
             LengthUnit::mm, {});

    ui::MainWindow window;
    window.resize(1280, 800);
    window.viewport().make_shaders();
    window.show();
    run_for(1000); // also for the shaders of a first picture
    window.open_file(path, LengthUnit::mm);
    wait(window);
    run_for(2000);
    std::printf("%zu facets, whole picture %.1f ms\n", window.document().part()->mesh->facet_count(),
                window.viewport().last_frame_ms());
    Heart heart;
    QElapsedTimer timer;
    const auto row = [&](const char* what, int drawn) {
        std::printf("%-34s %8lld ms total, longest pause %7.1f ms, most computed in a round %7.1f ms, %d "
                    "frames, the last one %.1f ms\n",
                    what, static_cast<long long>(timer.elapsed()), heart.longest_ms(), heart.computed_ms(),
                    drawn, window.viewport().last_frame_ms());
        std::fflush(stdout);
    };
    ui::BoundaryBox& box = *window.properties().boundary_box();
    const auto press = [&](const char* name) {
        box.findChild<QAbstractButton*>(QString::fromLatin1(name))->click();
    };
    window.tree().select(
        {ui::TreeNode::Kind::boundary, ui::add_boundary(window.document(), Boundary::Kind::facets)});
    wait(window);
    heart.reset();
    timer.start();
    press("paint");
    run_for(1);
    row("painting begins", 0);
    wait(window);

    // As a hand does it: the pointer moves on every 16 ms, whatever has been drawn by then.
    ui::Viewport& view = window.viewport();
    const QPoint middle = view.rect().center();
    const auto mouse = [&](QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons,
                           Qt::KeyboardModifiers keys) {
        QMouseEvent event(type, at, view.mapToGlobal(at), button, buttons, keys);
        QCoreApplication::sendEvent(&view, &event);
    };
    const auto stroke = [&](const char* what, double radius, Qt::KeyboardModifiers keys) {
        box.findChild<QDoubleSpinBox*>(QStringLiteral("paint_radius"))->setValue(radius);
        heart.reset();
        timer.restart();
        const int frames = view.frames();
        mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::LeftButton, keys);
        for (int i = 1; i <= 60; ++i) {
            mouse(QEvent::MouseMove, middle + QPoint(3 * i - 90, int(30 * std::sin(0.2 * i))), Qt::NoButton,
                  Qt::LeftButton, keys);
            run_for(16);
        }
        row(what, view.frames() - frames);
        heart.reset();
        timer.restart();
        mouse(QEvent::MouseButtonRelease, middle + QPoint(90, 0), Qt::LeftButton, Qt::NoButton, keys);
        run_for(300);
        row("  let go", view.frames() - frames);
        wait(window);
    };
    stroke("brush of 2 mm", 2, {});
    stroke("brush of 10 mm", 10, {});
    stroke("brush of 10 mm, erasing", 10, Qt::ShiftModifier);
    const auto once = [&](const char* what, auto&& work) {
        heart.reset();
        timer.restart();
        work();
        run_for(1);
        wait(window);
        row(what, 0);
    };
    press("paint_flood");
    once("flood", [&] {
        mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::LeftButton, {});
        mouse(QEvent::MouseButtonRelease, middle, Qt::LeftButton, Qt::NoButton, {});
    });
    once("clear", [&] { press("paint_clear"); });
    press("paint_box");
    once("box over all that is seen", [&] {
        mouse(QEvent::MouseButtonPress, {2, 2}, Qt::LeftButton, Qt::LeftButton, {});
        mouse(QEvent::MouseButtonRelease, {view.width() - 2, view.height() - 2}, Qt::LeftButton, Qt::NoButton,
              {});
    });
    once("shrink by a ring", [&] { press("paint_shrink"); });
    return 0;
}
