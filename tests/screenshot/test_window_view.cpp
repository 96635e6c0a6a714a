// The view and the looks of the window: layers, cameras, picking, themes, sizes.
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "ui/layer_bar.h"
#include "ui/playback_bar.h"
#include "ui/project_tree.h"
#include "ui/settings.h"
#include "ui/tool_dialog.h"
#include "ui/verification_controller.h"
#include "ui/view_cube.h"
#include "ui/viewport.h"
#include "ui/workspaces.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QWheelEvent>

#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;
using ui::MainWindow;
using ui::TreeNode;
using ui::ViewLayer;
using ui::Workspace;
using ui::Workspaces;

namespace {

double angle_between(const Vec3& a, const Vec3& b) {
    return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

} // namespace

class TestWindowView : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void layers_change_the_picture() {
        QVERIFY(open_and_plan());
        w().viewport().set_view(StandardView::iso);
        const QImage reference = view_picture(w());
        QMenu* menu = w().layers().menu_button()->menu();
        menu->popup(w().layers().menu_button()->mapToGlobal(QPoint(0, 0)));
        QVERIFY(QTest::qWaitForWindowExposed(menu));
        for (const ViewLayer layer :
             {ViewLayer::part, ViewLayer::edges, ViewLayer::stock, ViewLayer::cc, ViewLayer::cuts,
              ViewLayer::links, ViewLayer::rapids, ViewLayer::tool}) {
            auto* box = w().layers().box(layer);
            QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
            const int changed = changed_pixels(reference, view_picture(w()));
            QVERIFY2(changed > 10, qPrintable(box->objectName()));
            QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
            QCOMPARE(changed_pixels(reference, view_picture(w())), 0);
        }
        QVERIFY(menu->isVisible()); // for the next one
        shot(*menu, QStringLiteral("layer-menu"));
        QTest::keyClick(menu, Qt::Key_Escape);
        QVERIFY(!menu->isVisible());
        w().layers().set_shown(ViewLayer::cuts, false); // the path lies over most of the part
        const QImage smooth = view_picture(w());
        for (const char* style : {"shade_flat", "shade_wire"}) {
            action(w(), style)->trigger();
            QVERIFY2(changed_pixels(smooth, view_picture(w()), 4) > 100, style);
        }
        shot(w(), QStringLiteral("window-wire"));
        action(w(), "shade_smooth")->trigger();
        w().layers().set_shown(ViewLayer::cuts, true);
        QCOMPARE(changed_pixels(reference, view_picture(w())), 0);
        w().layers().set_shown(ViewLayer::stock, true);
        w().layers().set_shown(ViewLayer::edges, true);
        w().layers().set_shown(ViewLayer::cc, true);
        shot(w(), QStringLiteral("window-all-layers"));
    }

    void view_keys_and_cube() {
        QVERIFY(open_part());
        auto& view = w().viewport();
        const struct {
            Qt::Key key;
            StandardView view;
            Vec3 sight;
        } expected[] = {
            {Qt::Key_1, StandardView::front, {0, 1, 0}},  {Qt::Key_2, StandardView::top, {0, 0, -1}},
            {Qt::Key_3, StandardView::right, {-1, 0, 0}}, {Qt::Key_4, StandardView::rear, {0, -1, 0}},
            {Qt::Key_5, StandardView::bottom, {0, 0, 1}}, {Qt::Key_6, StandardView::left, {1, 0, 0}},
        };
        view.setFocus();
        for (const auto& e : expected) {
            QTest::keyClick(&view, e.key);
            QVERIFY2(angle_between(view.sight(), e.sight) < 1e-6,
                     qPrintable(QString::number(e.key - Qt::Key_0)));
        }
        QTest::keyClick(&view, Qt::Key_0);
        const Vec3 iso = view.sight();
        QVERIFY(iso.z() < -0.3 && std::abs(iso.x()) > 0.3 && std::abs(iso.y()) > 0.3);
        // The three faces that the corner shows, each clicked where it is drawn.
        for (const StandardView face : {StandardView::top, StandardView::front, StandardView::right}) {
            QTest::keyClick(&view, Qt::Key_0);
            const auto center = view.view_cube()->face_center(face);
            QVERIFY(center.has_value());
            QTest::mouseClick(view.view_cube(), Qt::LeftButton, {}, center->toPoint());
            for (const auto& e : expected)
                if (e.view == face) QVERIFY(angle_between(view.sight(), e.sight) < 1e-6);
        }
        QVERIFY(!view.view_cube()->face_center(StandardView::left)); // it looks from the right now
        QTest::mouseClick(view.view_cube(), Qt::LeftButton, {},
                          view.view_cube()->face_center(StandardView::iso)->toPoint());
        QVERIFY(angle_between(view.sight(), iso) < 1e-6);
        // The arrows roll the picture by a quarter of a turn; four times it is as it was.
        view.set_view(StandardView::top);
        const auto roll = [&](int quarters) {
            QTest::mouseClick(view.view_cube(), Qt::LeftButton, {},
                              view.view_cube()->roll_center(quarters).toPoint());
        };
        roll(1);
        QVERIFY(angle_between(view.up(), Vec3(-1, 0, 0)) < 1e-9); // what was on the left is above
        QVERIFY(angle_between(view.sight(), Vec3(0, 0, -1)) < 1e-9);
        shot(w(), QStringLiteral("view-rolled"));
        roll(-1);
        QVERIFY(angle_between(view.up(), Vec3(0, 1, 0)) < 1e-9);
        for (int i = 0; i < 4; ++i)
            roll(-1);
        QVERIFY(angle_between(view.up(), Vec3(0, 1, 0)) < 1e-9);
        view.set_view(StandardView::iso);
        // Beside the cube the view is the view.
        QCOMPARE(view.childAt(view.view_cube()->pos() + QPoint(2, 2)), nullptr);
        QCOMPARE(view.childAt(view.view_cube()->geometry().center()), view.view_cube());
        // Digits typed into a field are digits.
        w().tree().select({TreeNode::Kind::operation, 0});
        type_over(field(w(), "tolerance"), QStringLiteral("0.0123"));
        QCOMPARE(field(w(), "tolerance")->text(), QStringLiteral("0.0123"));
        QVERIFY(angle_between(view.sight(), iso) < 1e-6);
    }

    /// The buttons of every style, and what a turntable keeps upright.
    void navigation_styles() {
        QVERIFY(open_part());
        auto& view = w().viewport();
        const QPoint middle = view.rect().center();
        const auto drag = [&](Qt::MouseButton button, Qt::KeyboardModifiers keys) {
            view.set_view(StandardView::iso);
            const Vec3 sight = view.sight();
            const Vec2 at = view.scene().camera().display_of(w().document().part()->box.center());
            const auto diagonal = [&] {
                const Box3 box = w().document().part()->box;
                return (view.scene().camera().display_of(box.hi) - view.scene().camera().display_of(box.lo))
                    .norm();
            };
            const double wide = diagonal();
            QTest::mousePress(&view, button, keys, middle);
            for (int i = 1; i <= 4; ++i) {
                const QPoint to = middle + QPoint(40, 10) * i / 4;
                QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, button, keys);
                QApplication::sendEvent(&view, &event);
            }
            QTest::mouseRelease(&view, button, keys, middle + QPoint(40, 10));
            if (angle_between(view.sight(), sight) > 0.01) return QStringLiteral("turn");
            if (std::abs(diagonal() - wide) > 1e-6 * wide) return QStringLiteral("zoom");
            const Vec2 now = view.scene().camera().display_of(w().document().part()->box.center());
            return (now - at).norm() > 20 ? QStringLiteral("move") : QStringLiteral("nothing");
        };
        struct Style {
            ui::NavigationStyle style;
            const char *left, *middle, *shift_middle, *control_middle, *shift_right;
        };
        using S = ui::NavigationStyle;
        for (const Style& s : {Style{S::facetmill, "turn", "move", "move", "move", "zoom"},
                               Style{S::fusion, "nothing", "move", "turn", "zoom", "nothing"},
                               Style{S::freecad, "nothing", "move", "move", "move", "turn"},
                               Style{S::blender, "nothing", "turn", "move", "zoom", "nothing"},
                               Style{S::solidworks, "nothing", "turn", "zoom", "move", "nothing"}}) {
            for (const ui::Orbit orbit : {ui::Orbit::turntable, ui::Orbit::trackball}) {
                view.set_navigation({s.style, orbit});
                QCOMPARE(drag(Qt::LeftButton, {}), QLatin1String(s.left));
                QCOMPARE(drag(Qt::MiddleButton, {}), QLatin1String(s.middle));
                QCOMPARE(drag(Qt::MiddleButton, Qt::ShiftModifier), QLatin1String(s.shift_middle));
                QCOMPARE(drag(Qt::MiddleButton, Qt::ControlModifier), QLatin1String(s.control_middle));
                QCOMPARE(drag(Qt::RightButton, Qt::ShiftModifier), QLatin1String(s.shift_right));
            }
            // A click picks in every style.
            view.set_view(StandardView::top);
            QSignalSpy picked(&view, &ui::Viewport::part_picked);
            QTest::mouseClick(&view, Qt::LeftButton, {}, middle);
            QCOMPARE(picked.count(), 1);
        }
        view.set_navigation({});
    }

    /// Whatever was dragged before: nothing rolls, the sight turns about Z by as much as is asked.
    void a_turntable_stays_level() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> angle(-2, 2);
        for (int i = 0; i < 500; ++i) {
            Vec3 forward(angle(random), angle(random), angle(random));
            forward.normalize();
            const Vec3 up = forward.cross(Vec3(angle(random), angle(random), angle(random))).normalized();
            const ui::Sight sight{forward, up};
            const double across = angle(random), down = angle(random);
            const Mat3 turn = ui::orbit_turn(ui::Orbit::turntable, sight, across, down);
            QVERIFY((turn * turn.transpose() - Mat3::Identity()).norm() < 1e-9 && turn.determinant() > 0);
            const Vec3 now = turn * forward, upward = turn * up;
            QVERIFY(std::abs(now.cross(upward).z()) < 1e-9);
            const Mat3 roll = ui::orbit_turn(ui::Orbit::trackball, sight, across, 0);
            QVERIFY((roll * up - up).norm() < 1e-9);
            QVERIFY(std::abs(angle_between(roll * forward, forward) - std::abs(across)) < 1e-9);
            // Once it stands upright it looks no further than straight up or down.
            const ui::Sight level{now, upward};
            if (upward.z() < 0) continue; // it stood on its head
            const Mat3 far = ui::orbit_turn(ui::Orbit::turntable, level, across, 2 * down);
            QVERIFY((far * upward).z() > -1e-9);
            const double from = std::asin(std::clamp(now.z(), -1.0, 1.0)),
                         to = std::asin(std::clamp((far * now).z(), -1.0, 1.0));
            QVERIFY(std::abs(to - std::clamp(from + 2 * down, -pi / 2, pi / 2)) < 1e-6);
        }
        // Off the poles and back.
        const ui::Sight top{Vec3(0, 0, -1), Vec3(0, 1, 0)};
        QVERIFY((ui::orbit_turn(ui::Orbit::turntable, top, 0, -1) - Mat3::Identity()).norm() < 1e-9);
        QVERIFY(std::abs((ui::orbit_turn(ui::Orbit::turntable, top, 0, 1) * top.forward).z() + std::cos(1.0))
                < 1e-9);
    }

    void mouse_turns_moves_and_zooms() {
        QVERIFY(open_part());
        auto& view = w().viewport();
        view.set_view(StandardView::top);
        const QPoint middle = view.rect().center();
        const auto drag = [&](Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint by) {
            QTest::mousePress(&view, button, modifiers, middle);
            for (int i = 1; i <= 4; ++i) {
                QMouseEvent event(QEvent::MouseMove, middle + by * i / 4,
                                  view.mapToGlobal(middle + by * i / 4), Qt::NoButton, button, modifiers);
                QApplication::sendEvent(&view, &event);
            }
            QTest::mouseRelease(&view, button, modifiers, middle + by);
        };
        const Vec3 anchor = w().document().part()->box.center();
        const Vec2 at = view.scene().camera().display_of(anchor);
        drag(Qt::LeftButton, {}, QPoint(60, 30)); // no further than straight down
        QVERIFY(angle_between(view.sight(), Vec3(0, 0, -1)) < 1e-6);
        QVERIFY(angle_between(view.up(), Vec3(0, 1, 0)) > 0.1);
        drag(Qt::LeftButton, {}, QPoint(60, -30));
        QVERIFY(angle_between(view.sight(), Vec3(0, 0, -1)) > 0.1);
        QVERIFY(std::abs(view.sight().cross(view.up()).z()) < 1e-9); // the horizon is level
        view.set_view(StandardView::top);
        drag(Qt::MiddleButton, {}, QPoint(50, -20));
        Vec2 now = view.scene().camera().display_of(anchor);
        QVERIFY((now - at - Vec2(50, -20)).norm() < 1.5); // what was grabbed stays under the pointer
        QVERIFY(angle_between(view.sight(), Vec3(0, 0, -1)) < 1e-9);
        drag(Qt::LeftButton, Qt::ShiftModifier, QPoint(-50, 20));
        now = view.scene().camera().display_of(anchor);
        QVERIFY((now - at).norm() < 2);
        // The wheel zooms about the pointer.
        const QPoint corner = view.rect().topLeft() + QPoint(200, 150);
        const auto under = view.scene().part().pick(middle.x(), middle.y());
        QVERIFY(under.has_value());
        QWheelEvent wheel(QPointF(middle), view.mapToGlobal(QPointF(middle)), {}, QPoint(0, 240),
                          Qt::NoButton, {}, Qt::NoScrollPhase, false);
        const double before =
            (view.scene().camera().display_of(under->point) - Vec2(corner.x(), corner.y())).norm();
        const Box3 box = w().document().part()->box;
        const double width_before =
            (view.scene().camera().display_of(box.hi) - view.scene().camera().display_of(box.lo)).norm();
        QApplication::sendEvent(&view, &wheel);
        QVERIFY((view.scene().camera().display_of(under->point) - Vec2(middle.x(), middle.y())).norm() < 1.5);
        QVERIFY(
            std::abs((view.scene().camera().display_of(under->point) - Vec2(corner.x(), corner.y())).norm()
                     - before)
            < 2);
        const double width_after =
            (view.scene().camera().display_of(box.hi) - view.scene().camera().display_of(box.lo)).norm();
        QVERIFY(std::abs(width_after / width_before - 1.44) < 0.01);
        QTest::mouseDClick(&view, Qt::LeftButton, {}, middle);
        const double width_fit =
            (view.scene().camera().display_of(box.hi) - view.scene().camera().display_of(box.lo)).norm();
        QVERIFY(std::abs(width_fit / width_before - 1) < 0.01);
    }

    void a_click_on_the_path_shows_the_tool_there() {
        QVERIFY(open_and_plan());
        auto& view = w().viewport();
        view.set_view(StandardView::top);
        QVERIFY(view_picture(w()).width() > 0);
        const auto result = w().document().result(0);
        const auto& pass = result->path.passes[result->path.passes.size() / 2];
        const std::size_t point = pass.cl.size() / 2;
        const Vec2 at = view.scene().camera().display_of(pass.cl[point].tip);
        QSignalSpy picked(&view, &ui::Viewport::path_picked);
        QTest::mouseClick(&view, Qt::LeftButton, {},
                          QPoint(int(std::lround(at.x())), int(std::lround(at.y()))));
        QCOMPARE(picked.size(), 1);
        auto* readout = w().findChild<QLabel*>(QStringLiteral("readout"));
        const QString first = readout->text();
        QVERIFY2(first.startsWith(QStringLiteral("Finish")) && first.contains(QStringLiteral("pass")),
                 qPrintable(first));
        QVERIFY(view.scene().has(Layer::tool));
        QTest::keyClick(&view, Qt::Key_Right);
        const QString next = readout->text();
        QVERIFY(next != first);
        QTest::keyClick(&view, Qt::Key_Left);
        QCOMPARE(readout->text(), first);
        shot(w(), QStringLiteral("window-picked"));
    }

    void the_view_draws_only_on_demand() {
        QVERIFY(open_part());
        QTRY_VERIFY_WITH_TIMEOUT(w().viewport().finished(), patience_ms);
        QTest::qWait(100);
        const int frames = w().viewport().frames();
        w().findChild<QLabel*>(QStringLiteral("activity"))->setText(QStringLiteral("something else"));
        w().viewport().view_cube()->update();
        w().viewport().update();
        QTest::qWait(150);
        QCOMPARE(w().viewport().frames(), frames);
        w().viewport().refresh();
        w().viewport().refresh();
        QTRY_VERIFY_WITH_TIMEOUT(w().viewport().finished(), patience_ms);
        QTest::qWait(150);
        // One picture, and where that takes long a coarse one before it.
        QVERIFY(w().viewport().frames() > frames && w().viewport().frames() <= frames + 2);
    }

    void shaders_are_made_before_a_window_is_shown() {
        const QImage usual = view_picture(w());
        close_window();
        window_ = std::make_unique<MainWindow>();
        w().resize(1280, 800);
        QVERIFY(!w().viewport().shaders_made());
        const QSize had = w().viewport().size();
        w().viewport().make_shaders();
        QVERIFY(w().viewport().shaders_made());
        QCOMPARE(w().viewport().size(), had);
        w().show();
        QVERIFY(activate(w()));
        QCOMPARE(changed_pixels(view_picture(w()), usual, 0), 0); // they leave no trace
    }

    void a_large_part_turns_coarsely_and_rests_in_full() {
        constexpr Index n = 201; // a side: more facets than a part without a preview has
        Mesh sheet;
        for (Index j = 0; j < n; ++j)
            for (Index i = 0; i < n; ++i)
                sheet.vertices.emplace_back(i * 0.5, j * 0.5, 4 * std::sin(i * 0.06) * std::cos(j * 0.05));
        for (Index j = 0; j + 1 < n; ++j)
            for (Index i = 0; i + 1 < n; ++i) {
                const Index a = j * n + i;
                sheet.facets.push_back({a, a + 1, a + n + 1});
                sheet.facets.push_back({a, a + n + 1, a + n});
            }
        QVERIFY(sheet.facets.size() > largest_part_without_preview);
        const QString path = scratch_folder(QStringLiteral("large")) + QStringLiteral("/sheet.stl");
        save_stl(sheet, path.toStdString(), LengthUnit::mm, {});
        w().open_file(path, LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        auto& view = w().viewport();
        QVERIFY(view.scene().has_preview());
        const auto shown = [&] { return view.picture(); };
        QCOMPARE(changed_pixels(shown(), view_picture(w()), 0), 0); // drawn in steps or at once: the same

        view.content_changed(); // as for a part of unknown cost, whatever this machine can do
        const QPoint middle = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, {}, middle);
        QMouseEvent move(QEvent::MouseMove, middle + QPoint(30, 20),
                         view.mapToGlobal(middle + QPoint(30, 20)), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(&view, &move);
        const QImage coarse = shown();
        QVERIFY(!view.finished());
        // It has a smaller framebuffer of its own; the full picture's is not made anew for every drag.
        auto* gl = vtkOpenGLRenderWindow::SafeDownCast(view.scene().camera().window());
        QVERIFY(gl);
        const int *kept = gl->GetRenderFramebuffer()->GetLastSize(), *whole = gl->GetSize();
        QCOMPARE(QSize(kept[0], kept[1]), QSize(whole[0], whole[1]));
        // What is picked is what is under the pointer, however coarse the picture.
        const auto under = view.scene().part().pick(middle.x(), middle.y());
        QVERIFY(under.has_value());
        QVERIFY((view.scene().camera().display_of(under->point) - Vec2(middle.x(), middle.y())).norm()
                < 1e-6);
        QTest::qWait(600);
        QVERIFY(!view.finished()); // held, not let go
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(30, 20));
        QTRY_VERIFY_WITH_TIMEOUT(view.finished(), patience_ms);
        QTest::qWait(50);
        const QImage full = shown();
        QVERIFY(changed_pixels(coarse, full, 0) > 100);
        QCOMPARE(changed_pixels(full, view_picture(w()), 0), 0);
    }

    void the_window_goes_on_while_opengl_draws() {
        QVERIFY(open_part());
        auto& view = w().viewport();
        QVERIFY(wait_until_settled(w()));
        const QImage before = view.picture(), widget = view.grab().toImage();
        const int frames = view.frames();
        view.scene().set_palette(Palette::dark);
        view.refresh();
        view.repaint();
        // Asked for, and not waited for: the old picture stands.
        QCOMPARE(view.frames(), frames);
        QVERIFY(!view.finished());
        QCOMPARE(changed_pixels(widget, view.grab().toImage(), 0), 0);
        QTRY_VERIFY_WITH_TIMEOUT(view.frames() > frames && view.finished(), patience_ms);
        QVERIFY(changed_pixels(before, view.picture(), 0) > 1000);
        // Changes while it draws are in the next one, and who asks for the picture gets the newest.
        view.scene().set_palette(Palette::light);
        view.refresh();
        view.repaint();
        view.scene().set_palette(Palette::dark);
        view.refresh();
        const QImage dark = view_picture(w());
        QVERIFY(changed_pixels(before, dark, 0) > 1000);
        view.scene().set_palette(Palette::light);
        view.refresh();
        QCOMPARE(changed_pixels(before, view_picture(w()), 0), 0);
    }

    void no_empty_bar_of_tabs_is_left() {
        QVERIFY(open_part());
        for (const int width : {800, 1280, 800, 1280, 800}) {
            w().resize(width, width * 5 / 8);
            QTest::qWait(100);
            for (const QTabBar* bar : w().findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
                QVERIFY2(bar->count() > 0 || !bar->isVisible() || !bar->geometry().intersects(w().rect()),
                         qPrintable(QString::number(width)));
        }
    }

    void each_workspace_has_its_own() {
        Workspaces& spaces = w().workspaces();
        QVERIFY(open_part());
        QCOMPARE(spaces.current(), Workspace::prepare);
        QVERIFY(w().layers().shown(ViewLayer::stock) && !w().layers().quantity_box()->isVisible());
        shot(w(), QStringLiteral("workspace-prepare"));
        // Nothing to play back yet: said in its place.
        QTest::mouseClick(spaces.button(Workspace::simulate), Qt::LeftButton);
        auto* nothing = w().findChild<QLabel*>(QStringLiteral("nothing_to_play"));
        QVERIFY(nothing->isVisible());
        shot(w(), QStringLiteral("workspace-simulate-empty"));
        QTest::keyClick(&w(), Qt::Key_F5);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(spaces.current(), Workspace::plan);
        QVERIFY(w().layers().shown(ViewLayer::cuts) && !w().layers().shown(ViewLayer::stock));
        QVERIFY(w().layers().quantity_box()->isVisible() && !nothing->isVisible());
        QTest::keyClick(&w(), Qt::Key_F7);
        QCOMPARE(spaces.current(), Workspace::prepare);
        QVERIFY(!w().layers().shown(ViewLayer::cuts) && !w().viewport().scene().visible(Layer::cl));
        // The path of an operation that is chosen is seen.
        w().tree().select({TreeNode::Kind::part, 0});
        QCOMPARE(spaces.current(), Workspace::prepare);
        w().tree().select({TreeNode::Kind::operation, 0});
        QCOMPARE(spaces.current(), Workspace::plan);
        QTest::keyClick(&w(), Qt::Key_F9);
        QCOMPARE(spaces.current(), Workspace::verify);
        QVERIFY(w().findChild<QWidget*>(QStringLiteral("verification"))->isVisible());
        QTest::keyClick(&w(), Qt::Key_F10);
        QVERIFY(w().verification().bar()->isVisible() && !nothing->isVisible());
        QVERIFY(action(w(), "see_simulate")->isChecked() && !action(w(), "see_plan")->isChecked());
        shot(w(), QStringLiteral("workspace-simulate"));
        // One row below the view, but where one plays back.
        spaces.enter(Workspace::plan);
        for (const QSize size : {QSize(1280, 800), QSize(800, 600)}) {
            w().resize(size);
            QTest::qWait(60);
            QVERIFY2(spaces.height() < 2 * w().layers().quantity_box()->height(),
                     qPrintable(QString::number(spaces.height())));
        }
    }

    /// A part that was fitted beside a small legend makes room for the larger one of another workspace; one
    /// that was turned by hand stays.
    void a_larger_legend_finds_room() {
        w().resize(800, 600);
        QVERIFY(open_and_plan());
        w().verify();
        QVERIFY(wait_until_settled(w()));
        Workspaces& spaces = w().workspaces();
        ui::Viewport& view = w().viewport();
        w().message_bar().dismiss();
        for (const bool turned : {false, true}) {
            spaces.enter(Workspace::prepare);
            QVERIFY(wait_until_settled(w()));
            w().layers().set_shown(ViewLayer::stock, false);
            view.fit();
            QVERIFY(wait_until_settled(w()));
            if (turned) view.roll(0);
            QVERIFY(!view.scene().legend_lies_over());
            spaces.enter(Workspace::verify);
            QVERIFY(view.scene().legend_lies_over());
            QVERIFY(wait_until_settled(w()));
            QCOMPARE(view.scene().legend_lies_over(), turned);
            shot(w(), QStringLiteral("view-legend-%1").arg(int(turned)));
        }
        spaces.enter(Workspace::prepare);
        w().layers().set_shown(ViewLayer::stock, true);
    }

    /// The part that is fitted keeps clear of the cube, in a small view too.
    void the_cube_stands_beside_the_part() {
        QVERIFY(open_part());
        ui::Viewport& view = w().viewport();
        for (const QSize& size : {QSize(800, 600), QSize(1280, 800)}) {
            w().resize(size);
            QVERIFY(wait_until_settled(w()));
            for (const StandardView from : {StandardView::iso, StandardView::top, StandardView::front}) {
                view.set_view(from);
                view.fit();
                QVERIFY(wait_until_settled(w()));
                const ui::ViewCube* cube = view.view_cube();
                if (cube->isHidden()) continue; // no room for it
                const QRectF at(cube->geometry());
                shot(w(), QStringLiteral("view-cube-%1-%2").arg(size.width()).arg(int(from)));
                QVERIFY2(!view.scene().camera().shadow_meets(view.scene().bounds(),
                                                             {at.left(), at.top(), at.right(), at.bottom()},
                                                             view.devicePixelRatioF()),
                         view_name(from).data());
            }
        }
    }

    /// What comes into a small tree when all is planned does not push the chosen operation out of it.
    void a_small_tree_keeps_the_chosen_operation_in_sight() {
        QVERIFY(open_part());
        w().document().change(QStringLiteral("Twice"), [](Project& p) {
            p.tools.front().diameter *= 2;
            p.tools.front().corner_radius *= 2;
            p.tools.front().shank_diameter *= 2;
            p.operations.front()->common().tolerance = 0.03 * mm_per_inch;
            while (p.tools.size() < 12) {
                p.tools.push_back(p.tools.back());
                ++p.tools.back().number;
            }
        });
        w().document().add_operation("finish3");
        w().tree().select({TreeNode::Kind::operation, 1});
        QTreeWidget* tree = w().tree().tree();
        w().resize(1280, 700);
        QVERIFY(wait_until_settled(w()));
        const auto in_sight = [&] {
            return tree->viewport()->rect().contains(tree->visualItemRect(tree->currentItem()));
        };
        tree->scrollToItem(tree->currentItem());
        QVERIFY(in_sight());
        QVERIFY(tree->verticalScrollBar()->maximum() > 0);
        const int before = tree->verticalScrollBar()->value();
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().all_planned());
        QVERIFY(in_sight());
        QVERIFY(tree->verticalScrollBar()->value() > before);
    }

    void window_state_is_kept() {
        w().resize(1010, 707);
        w().findChild<QWidget*>(QStringLiteral("log_dock"))->hide();
        w().layers().set_shown(ViewLayer::stock, false);
        w().workspaces().enter(Workspace::plan);
        w().layers().set_shown(ViewLayer::rapids, false);
        QTest::qWait(50);
        w().close();
        window_ = std::make_unique<MainWindow>();
        window_->show();
        QVERIFY(activate(*window_));
        QCOMPARE(window_->size(), QSize(1010, 707));
        QVERIFY(!window_->findChild<QWidget*>(QStringLiteral("log_dock"))->isVisible());
        QVERIFY(!window_->layers().shown(ViewLayer::stock));
        QVERIFY(!window_->viewport().scene().visible(Layer::stock));
        window_->layers().set_shown(ViewLayer::stock, true);
        window_->workspaces().enter(Workspace::plan);
        QVERIFY(!window_->layers().shown(ViewLayer::rapids));
        QVERIFY(window_->layers().shown(ViewLayer::cuts));
        window_->layers().set_shown(ViewLayer::rapids, true);
        window_->workspaces().keep_layers();
        ui::settings::set_window({}, {});
    }

    void themes_and_sizes() {
        QVERIFY(open_and_plan());
        const QImage light = shot(w(), QStringLiteral("window-light"));
        action(w(), "theme_dark")->trigger();
        const QImage dark = shot(w(), QStringLiteral("window-dark"));
        QVERIFY(qGray(dark.pixel(dark.width() - 20, dark.height() / 2)) + 80
                < qGray(light.pixel(light.width() - 20, light.height() / 2)));
        QCOMPARE(ui::settings::theme(), ui::Theme::dark);
        w().tree().select({TreeNode::Kind::tool, 0});
        w().tree().edit_action()->trigger();
        shot(*w().findChild<ui::ToolDialog*>(), QStringLiteral("dialog-tool-dark"));
        w().findChild<ui::ToolDialog*>()->reject();
        w().tree().select({TreeNode::Kind::operation, 0});
        w().resize(800, 600);
        shot(w(), QStringLiteral("window-dark-small"));
        QCOMPARE(w().size(), QSize(800, 600));
        QVERIFY(w().viewport().width() >= 250);
        QVERIFY(w().viewport().height() >= 200);
        action(w(), "theme_light")->trigger();
        shot(w(), QStringLiteral("window-light-small"));
    }

    void long_names_do_not_break_the_layout() {
        const QString folder = scratch_folder(QStringLiteral("long"));
        const QString name =
            QStringLiteral("a_very_long_file_name_of_a_part_that_somebody_exported_").repeated(3);
        w().open_file(write_mesh(folder, name + QStringLiteral(".stl")), LengthUnit::inch);
        QVERIFY(wait_until_settled(w()));
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "name",
              QStringLiteral("Finish the upper side with the half inch ball, second setting, slowly")
                  .repeated(2));
        w().resize(800, 600);
        QCOMPARE(w().size(), QSize(800, 600));
        QVERIFY(w().windowTitle().size() < 100);
        shot(w(), QStringLiteral("window-long-names"));
        w().tree().select({TreeNode::Kind::part, 0});
        shot(w(), QStringLiteral("window-long-names-part"));
        QVERIFY(w().viewport().width() >= 250);
    }
};
FACETMILL_TEST(TestWindowView)

#include "test_window_view.moc"
