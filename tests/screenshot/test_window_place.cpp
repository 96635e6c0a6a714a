// How the part lies: faces from a list and by clicks, turns, edges, mirrors, moves; each is one step of the
// history and stands in the project.
#include "core/mesh/mesh_io.h"
#include "core/setup/lying.h"
#include "tests/screenshot/window_support.h"
#include "ui/axis_dialog.h"
#include "ui/controllers.h"
#include "ui/layer_bar.h"
#include "ui/message_bar.h"
#include "ui/operation_list.h"
#include "ui/parameter_form.h"
#include "ui/place_controller.h"
#include "ui/project_files.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/report_view.h"
#include "ui/setup_list.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>
#include <utility>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A tray of 60 x 40 x 20 mm, open above, lying on a long side and crooked: made of five blocks.
QString write_tray(const QString& path) {
    Mesh tray;
    const auto block = [&](const Vec3& lo, const Vec3& hi) {
        const auto first = Index(tray.vertices.size());
        for (int c = 0; c < 8; ++c)
            tray.vertices.emplace_back(c & 1 ? hi.x() : lo.x(), c & 2 ? hi.y() : lo.y(),
                                       c & 4 ? hi.z() : lo.z());
        for (const Facet& f :
             {Facet{0, 2, 1}, Facet{1, 2, 3}, Facet{4, 5, 6}, Facet{5, 7, 6}, Facet{0, 1, 4}, Facet{1, 5, 4},
              Facet{2, 6, 3}, Facet{3, 6, 7}, Facet{0, 4, 2}, Facet{2, 4, 6}, Facet{1, 3, 5}, Facet{3, 7, 5}})
            tray.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
    };
    block(Vec3(0, 0, 0), Vec3(60, 40, 4));
    block(Vec3(0, 0, 4), Vec3(6, 40, 20));
    block(Vec3(54, 0, 4), Vec3(60, 40, 20));
    block(Vec3(6, 0, 4), Vec3(54, 6, 20));
    block(Vec3(6, 34, 4), Vec3(54, 40, 20));
    const Mat3 turn = Eigen::AngleAxisd(radians(25), Vec3::UnitZ()) * quarter_turn(0, 1);
    for (Vec3& v : tray.vertices)
        v = turn * v + Vec3(10, 20, 30);
    save_stl(tray, path.toStdString(), LengthUnit::mm, {});
    return path;
}

} // namespace

class TestWindowPlace : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() {
        QVERIFY(show_window());
        w().open_file(write_tray(scratch_folder(QStringLiteral("place")) + QStringLiteral("/tray.stl")),
                      LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
    }
    void cleanup() { close_window(); }

    /// All facets are walked for that.
    void laying_is_worked_out_aside() {
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        for (const char* name : {"place_square", "place_principal"}) {
            w().document().change(QStringLiteral("Turn"), [](Project& p) {
                p.part.rotate = {0, 0, radians(20)};
            });
            QVERIFY(wait_until_settled(w()));
            const int steps = w().document().undo_stack().count();
            auto* lay = w().findChild<QAbstractButton*>(QLatin1String(name));
            lay->click();
            QCOMPARE(w().document().undo_stack().count(), steps);
            QVERIFY(w().busy());
            lay->click(); // done after it, and nothing is left to be turned
            QVERIFY(wait_until_settled(w()));
            QCOMPARE(w().document().undo_stack().count(), steps + 1);
            QVERIFY(w().document().part_is_current());
        }
    }

    /// What is asked while a turn is worked out or the part read anew is done after it, but not what was
    /// picked of the part as it lay.
    void turns_follow_one_another() {
        auto& undo = w().document().undo_stack();
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        const int steps = undo.count();
        const auto click = [&](const char* name) {
            w().findChild<QAbstractButton*>(QLatin1String(name))->click();
        };
        click("place_turn_x");
        click("place_turn_z");
        click("place_mirror_x");
        QCOMPARE(undo.count(), steps);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(undo.count(), steps + 3);
        QCOMPARE(undo.text(steps), QStringLiteral("Turn part about X"));
        QCOMPARE(undo.text(steps + 1), QStringLiteral("Turn part about Z"));
        QCOMPARE(undo.text(steps + 2), QStringLiteral("Mirror part in X"));
        list()->setCurrentItem(list()->topLevelItem(0));
        QVERIFY(wait_until_settled(w()));
        click("place_turn_z");
        click("place_lay");
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("still being turned")),
                 qPrintable(w().message_bar().message()));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(undo.count(), steps + 4);
        // Cancelled with the one before.
        click("place_turn_x");
        click("place_turn_y");
        QVERIFY(QTest::qWaitFor([&] { return undo.count() == steps + 5; }, patience_ms));
        w().cancel();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(undo.count(), steps + 5);
    }

    /// Whatever has become of the part meanwhile: what was worked out is of the part as it lay.
    void laying_of_what_has_changed_is_dropped() {
        auto& d = w().document();
        auto* square = w().findChild<QAbstractButton*>(QStringLiteral("place_square"));
        const auto turn = [&](double degrees) {
            d.change(QStringLiteral("Turn"), [&](Project& p) { p.part.rotate = {0, 0, radians(degrees)}; });
        };
        action(w(), "place")->trigger();
        turn(20);
        QVERIFY(wait_until_settled(w()));
        square->click();
        turn(10);
        const Placement turned = placement_of(d.project().part);
        const int steps = d.undo_stack().count();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(placement_of(d.project().part) == turned);
        QCOMPARE(d.undo_stack().count(), steps);
        // Undone, another setup that lies alike, and none.
        square->click();
        d.undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(d.undo_stack().index(), steps - 1);
        QVERIFY(d.undo_stack().canRedo());
        square->click();
        ui::add_setup(d, ui::NewSetup::as_it_lies);
        const auto places = [&] { return std::pair(setup_at(d.project(), 0).place, d.project().place); };
        const auto were = places();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(places() == were);
        square->click();
        QVERIFY(w().busy());
        d.clear();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!d.has_part());
    }

    void a_face_from_the_list() {
        QVERIFY(!action(w(), "place")->icon().isNull());
        QVERIFY(!dock()->isVisible());
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(dock()->isVisible());
        QVERIFY(list()->topLevelItemCount() > 3);
        QVERIFY(!button("place_lay"));
        QVERIFY(label("place_extents").contains(QStringLiteral("30")));
        QVERIFY(w().report().toPlainText().contains(QStringLiteral("From")));
        const QImage before = view_picture(w());
        shot(w(), QStringLiteral("place-list"));
        // Shown in the view before it is done; nothing has changed yet.
        list()->setCurrentItem(list()->topLevelItem(0));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().viewport().scene().support().shown());
        QVERIFY(changed_pixels(before, view_picture(w())) > 500);
        QVERIFY(!w().document().undo_stack().canUndo());
        shot(w(), QStringLiteral("place-preview"));
        press("place_lay");
        QVERIFY(!w().viewport().scene().support().shown());
        QVERIFY(lies(Vec3(60, 40, 20), false));
        // A part that lies across its stock is told of.
        QVERIFY2(w().message_bar().message().contains(QStringLiteral("across its stock")),
                 qPrintable(w().message_bar().message()));
        QCOMPARE(w().document().undo_stack().count(), 1);
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Lay part on face"));
        // That goes with it, by whatever button it is squared up.
        press("place_square");
        QVERIFY(lies(Vec3(60, 40, 20)));
        QVERIFY2(!w().message_bar().message().contains(QStringLiteral("across its stock")),
                 qPrintable(w().message_bar().message()));
        shot(w(), QStringLiteral("place-laid"));
        // The list is that of the part as it lies now.
        QCOMPARE(list()->topLevelItem(0)->text(ui::PlacePanel::height_column), QStringLiteral("20"));
        // It stands in the project, and comes back with it.
        const QString file = scratch_folder(QStringLiteral("placed")) + QStringLiteral("/tray.facetmill");
        Project saved = w().document().project();
        save_project(saved, file.toStdString());
        const Box3 again = Planner().prepare(load_project(file.toStdString()), {})->box;
        QVERIFY((again.size() - Vec3(60, 40, 20)).norm() < 1e-4);
        // Largest first is another order of them, and the view follows the part back, too.
        auto* order = w().findChild<QComboBox*>(QStringLiteral("place_order"));
        order->setCurrentIndex(1);
        emit order->activated(1);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(list()->topLevelItemCount() > 3);
        action(w(), "undo")->trigger();
        action(w(), "undo")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().project().part.rotate == (std::array<double, 3>{0, 0, 0}));
        QVERIFY(!w().document().undo_stack().canUndo());
    }

    /// The shank that a new project's tool has is as long as the part is high: as it lies, not as it was
    /// opened.
    void shanks_follow_the_height_of_the_part() {
        const auto shank = [&] { return w().document().project().tools.front().shank_length; };
        QCOMPARE(shank(), 40.0);
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        list()->setCurrentItem(list()->topLevelItem(0));
        press("place_lay");
        QVERIFY(lies(Vec3(60, 40, 20), false));
        QCOMPARE(w().document().project().tools.front().diameter, 6.0);
        QCOMPARE(shank(), 24.0); // four times that; past the part would be 21
        // One step, which undo takes back whole.
        action(w(), "undo")->trigger();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(shank(), 40.0);
        // The form says how far it is out, and how far it has to be; what a user wrote stays.
        w().document().change(QStringLiteral("Shank"), [](Project& p) { p.tools.front().shank_length = 33; });
        w().tree().select({ui::TreeNode::Kind::tool, 0});
        QVERIFY(wait_until_settled(w()));
        const Project& project = w().document().project();
        const double out = 33 + project.tools.front().flute_length, needed = 40 + project.stock.margin[2];
        const QString said = label("properties_hint");
        QVERIFY2(said.simplified().contains(
                     QStringLiteral("Stick-out: %1 mm; the part needs %2 mm").arg(out).arg(needed)),
                 qPrintable(said));
        list()->setCurrentItem(list()->topLevelItem(0));
        press("place_lay");
        QVERIFY(lies(Vec3(60, 40, 20), false));
        QCOMPARE(shank(), 33.0);
    }

    /// The mark of a picked point is one of the part as it lies: it goes when the part turns, however that is
    /// done, and does not come back with it.
    void the_mark_of_a_picked_point_goes_with_a_turn() {
        Scene& scene = w().viewport().scene();
        const auto pick = [&] {
            QVERIFY(!scene.has(Layer::marker));
            const Vec2 p = scene.camera().display_of(w().document().part()->box.center());
            QTest::mouseClick(&w().viewport(), Qt::LeftButton, {},
                              (QPointF(p.x(), p.y()) / w().viewport().devicePixelRatioF()).toPoint());
            QVERIFY(scene.has(Layer::marker));
        };
        pick();
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        press("place_turn_z");
        QVERIFY(!scene.has(Layer::marker));
        pick();
        action(w(), "undo")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!scene.has(Layer::marker));
        pick();
        w().tree().select({ui::TreeNode::Kind::part, 0});
        enter(w(), "rotate2", QStringLiteral("30"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!scene.has(Layer::marker));
        // What turns nothing leaves it.
        pick();
        w().tree().select({ui::TreeNode::Kind::operation, 0});
        enter(w(), "feed", QStringLiteral("321"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(scene.has(Layer::marker));
    }

    /// Laid while the view still flies to the face: the flight does not go on to where that was.
    void a_double_click_lays_and_fits() {
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(shows_all(w().viewport()));
        w().viewport().scene().camera().zoom_at(200, 200, 8);
        QVERIFY(!shows_all(w().viewport()));
        const QPoint row = list()->visualItemRect(list()->topLevelItem(1)).center();
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, row);
        QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, row);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Lay part on face"));
        QTest::qWait(300); // as long as a flight takes
        QVERIFY(shows_all(w().viewport()));
    }

    /// In a dialog that begins with the axis that there is; what it leaves as it was is no step.
    void the_tool_axis_of_an_operation_is_told_by_angles() {
        const auto axis = [&] {
            const auto& a = first_operation(w()).tool_axis;
            return Vec3(a[0], a[1], a[2]);
        };
        const auto ask = [&](double had_tilt, double had_towards, double tilt, double towards,
                             bool leave = false) {
            ui::ask_tool_axis(w().document(), 0, &w());
            auto* dialog = w().findChild<QDialog*>(QStringLiteral("axis_dialog"));
            auto* tilt_field = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("axis_tilt"));
            auto* towards_field = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("axis_towards"));
            QCOMPARE(tilt_field->value(), had_tilt);
            QCOMPARE(towards_field->value(), had_towards);
            QCOMPARE(towards_field->isEnabled(), had_tilt > 0);
            QTest::keyClicks(tilt_field, QString::number(tilt)); // it is selected
            QTest::keyClick(tilt_field, Qt::Key_Tab);
            towards_field->setFocus();
            towards_field->selectAll();
            QTest::keyClicks(towards_field, QString::number(towards));
            if (!leave) shot(*dialog, QStringLiteral("axis-angles"));
            QTest::keyClick(dialog, leave ? Qt::Key_Escape : Qt::Key_Return);
            QTRY_VERIFY_WITH_TIMEOUT(!w().findChild<QDialog*>(QStringLiteral("axis_dialog")), patience_ms);
        };
        QUndoStack& history = w().document().undo_stack();
        const int steps = history.count();
        ask(0, 0, 0, 0);
        QCOMPARE(history.count(), steps);
        ask(0, 0, 90, -90);
        QVERIFY(axis() == Vec3(0, -1, 0));
        QCOMPARE(history.undoText(), QStringLiteral("Tool axis by angles"));
        ask(90, -90, 45, 30, true);
        QVERIFY(axis() == Vec3(0, -1, 0));
        ask(90, -90, 45, 30);
        const double flat = std::sqrt(0.5);
        QVERIFY((axis() - Vec3(flat * std::sqrt(0.75), 0.5 * flat, flat)).norm() < 2e-9);
        ask(45, 30, 45, 30);
        QCOMPARE(history.count(), steps + 2);
    }

    /// Upright on a face, or along the view: one step of the history each.
    void the_tool_axis_of_an_operation_is_picked() {
        w().tree().select({ui::TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        auto* pick = w().properties().form()->findChild<QToolButton*>(QStringLiteral("pick_tool_axis"));
        QVERIFY(pick && pick->isVisible());
        ui::Viewport& viewport = w().viewport();
        const auto click = [&](const Vec3& p, Qt::KeyboardModifiers modifiers) {
            const Vec2 pixel = viewport.scene().camera().display_of(p) / viewport.devicePixelRatioF();
            QTest::mouseClick(&viewport, Qt::LeftButton, modifiers,
                              QPoint(int(std::lround(pixel.x())), int(std::lround(pixel.y()))));
        };
        const auto axis = [&] { return first_operation(w()).tool_axis; };
        viewport.set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        QTest::mouseClick(pick, Qt::LeftButton);
        QVERIFY(pick->isChecked() && w().message_bar().message().contains(QStringLiteral("face")));
        shot(w(), QStringLiteral("axis-face"));
        QTest::keyClick(&viewport, Qt::Key_Escape);
        QVERIFY(!pick->isChecked() && w().message_bar().message().isEmpty());
        // The middle of the bottom of the tray, which stands upright and crooked.
        const Vec3 seen = viewport.scene().camera().toward_eye();
        QVERIFY((seen - Vec3::UnitZ()).norm() < 1e-6);
        QTest::mouseClick(pick, Qt::LeftButton);
        click(part().center(), Qt::ControlModifier);
        QVERIFY(axis() == (std::array<double, 3>{0, 0, 1}));
        viewport.set_view(StandardView::front);
        QVERIFY(wait_until_settled(w()));
        QTest::mouseClick(pick, Qt::LeftButton);
        click(part().center(), Qt::NoModifier);
        QVERIFY(wait_until_settled(w()));
        const Vec3 face(std::sin(radians(25.0)), -std::cos(radians(25.0)), 0);
        QVERIFY2((Vec3(axis()[0], axis()[1], axis()[2]) - face).norm() < 1e-5,
                 qPrintable(QString("%1 %2 %3").arg(axis()[0]).arg(axis()[1]).arg(axis()[2])));
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Pick tool axis"));
        // The machine that is set has no rotary axes, which the form says beside the field.
        QVERIFY(error_under(w(), "tool_axis").contains(QStringLiteral("machine")));
        // The others of the setup get it by one step; those that turn the tool by themselves have none.
        w().document().add_operation("rough");
        w().document().add_operation("finish5");
        const std::size_t count = w().document().operation_count();
        std::vector<std::size_t> with;
        for (std::size_t i = 0; i < count; ++i)
            if (ui::has_tool_axis(w().document(), i)) with.push_back(i);
        QVERIFY(count == 3 && with.size() == 2);
        const std::size_t source = with.back();
        w().document().change(QStringLiteral("Upright"), [&](Project& p) {
            p.operations[with.front()]->set("tool_axis", std::array<double, 3>{0, 0, 1});
        });
        QVERIFY(w().document().operation(source).is_indexed());
        QCOMPARE(ui::share_tool_axis(w().document(), source), std::size_t(1));
        for (std::size_t i = 0; i < count; ++i)
            if (ui::has_tool_axis(w().document(), i))
                QVERIFY((w().document().operation(i).tool_axis() - face).norm() < 1e-5);
        QCOMPARE(ui::share_tool_axis(w().document(), source), std::size_t(0)); // no step
        for (int k = 0; k < 5; ++k) // that, upright, two operations, the axis
            w().document().undo_stack().undo();
        QVERIFY(axis() == (std::array<double, 3>{0, 0, 1}));
    }

    void quarter_turns_moves_and_mirrors() {
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        press("place_square");
        QVERIFY(lies(Vec3(60, 20, 40)));
        press("place_back_x");
        QVERIFY(lies(Vec3(60, 40, 20)));
        press("place_turn_z");
        QVERIFY(lies(Vec3(40, 60, 20)));
        press("place_turn_y");
        QVERIFY(lies(Vec3(20, 60, 40)));
        press("place_centre");
        QVERIFY(lies(Vec3(20, 60, 40)));
        QVERIFY(part().center().head<2>().norm() < 1e-6);
        QCOMPARE(w().document().undo_stack().count(), 5);
        press("place_mirror_x");
        QVERIFY(lies(Vec3(20, 60, 40)));
        QVERIFY(w().document().project().part.mirror != Mirror::none);
        press("place_mirror_x");
        QVERIFY(w().document().project().part.mirror == Mirror::none);
        QCOMPARE(w().document().undo_stack().count(), 7);
        // What is so already is no step.
        press("place_drop");
        QCOMPARE(w().document().undo_stack().count(), 7);
        QVERIFY(w().message_bar().message().contains(QStringLiteral("already")));
    }

    void a_face_and_an_edge_by_clicks() {
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        press("place_pick_face");
        QVERIFY(w().message_bar().message().contains(QStringLiteral("flat face")));
        QCOMPARE(w().viewport().cursor().shape(), Qt::CrossCursor);
        shot(w(), QStringLiteral("place-picking"));
        // Beside the part; Esc leaves it.
        QTest::mouseClick(&w().viewport(), Qt::LeftButton, {}, QPoint(4, w().viewport().height() / 2));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("beside the part")));
        QTest::keyClick(&w(), Qt::Key_Escape);
        QVERIFY(w().viewport().cursor().shape() != Qt::CrossCursor);
        QVERIFY(!tool_button("place_pick_face")->isChecked());
        // The back, which is upright now.
        const Vec3 back = Eigen::AngleAxisd(radians(25), Vec3::UnitZ()) * Vec3(30, 0, 20) + Vec3(10, 20, 30);
        w().viewport().set_view(StandardView::rear);
        QVERIFY(wait_until_settled(w()));
        press("place_pick_face");
        if (!click_at(back)) {
            w().viewport().set_view(StandardView::front);
            QVERIFY(wait_until_settled(w()));
            QVERIFY(click_at(back));
        }
        QVERIFY(lies(Vec3(60, 40, 20), false));
        QCOMPARE(w().document().undo_stack().count(), 1);
        w().viewport().set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        // Beside the middle of the outer edge of the rim, whichever way the part has turned.
        press("place_pick_edge");
        const Mesh& mesh = *w().document().part()->mesh;
        const Vec3 a = mesh.vertices[0], b = mesh.vertices[1], middle = part().center();
        Vec3 beside = 0.5 * (a + b);
        beside.z() = part().hi.z();
        beside += 3 * Vec3(middle.x() - beside.x(), middle.y() - beside.y(), 0).normalized();
        QVERIFY(click_at(beside));
        QVERIFY(lies(part().size().x() > 50 ? Vec3(60, 40, 20) : Vec3(40, 60, 20)));
        QCOMPARE(w().document().undo_stack().count(), 2);
        shot(w(), QStringLiteral("place-edge"));
    }

    void three_points_and_a_small_window() {
        w().resize(800, 600);
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(tool_button("place_pick_points")->isVisible());
        shot(w(), QStringLiteral("place-small"));
        press("place_square");
        press("place_back_x");
        QVERIFY(lies(Vec3(60, 40, 20)));
        w().viewport().set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        press("place_pick_points");
        const Box3 box = part();
        const bool up = w().document().part()->mesh->vertices[0].z() < 1; // the open side
        const double in = 3;
        for (const Vec2& p : {Vec2(box.lo.x() + in, box.lo.y() + in), Vec2(box.hi.x() - in, box.lo.y() + in),
                              Vec2(box.lo.x() + in, box.hi.y() - in)})
            QVERIFY(click_at(Vec3(p.x(), p.y(), box.hi.z())));
        QVERIFY(lies(Vec3(60, 40, 20)));
        QVERIFY((w().document().part()->mesh->vertices[0].z() < 1) != up); // it was turned over
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Lay part on three points"));
        shot(w(), QStringLiteral("place-small-over"));
    }

    void the_work_zero() {
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        auto& zero = w().viewport().scene().zero();
        QVERIFY(zero.mark() && zero.mark()->point == Vec3(0, 0, 0));
        w().document().change(QStringLiteral("Control"), [](Project& p) { p.programs.post = "linuxcnc"; });
        QCOMPARE(label("zero_text"), QStringLiteral("G54 in the part's origin"));
        const QImage before = view_picture(w());
        // The corner of the stock's top, low X and low Y; one step.
        const int steps = w().document().undo_stack().count();
        press("zero_0");
        QCOMPARE(w().document().undo_stack().count(), steps + 1);
        QVERIFY(w().document().project().programs.zero_from == ProgramSpec::ZeroFrom::stock);
        const double margin = w().document().project().stock.margin[2];
        QVERIFY(std::abs(zero.mark()->point.z() - part().hi.z() - margin) < 1e-9);
        QVERIFY(std::abs(zero.mark()->point.x() - part().lo.x() + w().document().project().stock.margin[0])
                < 1e-9);
        QVERIFY(tool_button("zero_0")->isChecked());
        QVERIFY2(label("zero_text").contains(QStringLiteral("stock's top, low X, low Y")),
                 qPrintable(label("zero_text")));
        QVERIFY(changed_pixels(before, view_picture(w())) > 100);
        w().layers().set_shown(ui::ViewLayer::stock, true);
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("zero-stock"));
        // It goes with the stock, and comes to the part's middle.
        w().document().change(QStringLiteral("Margin"), [](Project& p) { p.stock.margin[2] += 5; });
        QVERIFY(std::abs(zero.mark()->point.z() - part().hi.z() - margin - 5) < 1e-9);
        auto* of = w().findChild<QComboBox*>(QStringLiteral("zero_of"));
        of->setCurrentIndex(1);
        emit of->activated(1);
        auto* level = w().findChild<QComboBox*>(QStringLiteral("zero_level"));
        level->setCurrentIndex(2);
        emit level->activated(2);
        QVERIFY((zero.mark()->point - part().lo).norm() < 1e-9);
        press("zero_4");
        QVERIFY((zero.mark()->point.head<2>() - part().center().head<2>()).norm() < 1e-9);
        // A corner of the part, clicked roughly.
        w().layers().set_shown(ui::ViewLayer::stock, false);
        w().viewport().set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        const Mesh& mesh = *w().document().part()->mesh;
        Vec3 corner = mesh.vertices[0];
        for (const Vec3& v : mesh.vertices)
            if (v.z() > part().hi.z() - 1e-6
                && v.x() + v.y() < corner.x() + corner.y() + (corner.z() < v.z() - 1 ? 1e9 : 0))
                corner = v;
        press("zero_pick");
        const Vec3 toward = part().center() - corner;
        QVERIFY(click_at(corner + Vec3(toward.x(), toward.y(), 0).normalized() * 0.6));
        QVERIFY2((zero.mark()->point - corner).norm() < 1,
                 qPrintable(QString::number((zero.mark()->point - corner).norm())));
        QVERIFY(w().document().project().programs.zero_from == ProgramSpec::ZeroFrom::origin);
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Set work zero"));
        press("zero_origin");
        QCOMPARE(zero.mark()->point, Vec3(0, 0, 0));
        QVERIFY(!tool_button("zero_4")->isChecked());
        dock()->hide();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!zero.mark());
    }

    void principal_axes_and_typed_values() {
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        press("place_principal");
        QVERIFY((part().size() - Vec3(60, 40, 20)).norm() < 1e-4);
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Lay part by its principal axes"));
        auto* kind = w().findChild<QComboBox*>(QStringLiteral("place_value_kind"));
        auto* value = w().findChild<QDoubleSpinBox*>(QStringLiteral("place_value"));
        const auto choose = [&](int which) {
            kind->setCurrentIndex(which);
            emit kind->activated(which);
        };
        choose(2); // about Z
        const Vec3 middle = part().center();
        value->setFocus();
        value->selectAll();
        QTest::keyClicks(value, QStringLiteral("30"));
        QTest::keyClick(value, Qt::Key_Return);
        QVERIFY(wait_until_settled(w()));
        const double c = std::cos(radians(30)), s = std::sin(radians(30));
        QVERIFY((part().size() - Vec3(60 * c + 40 * s, 60 * s + 40 * c, 20)).norm() < 1e-4);
        QVERIFY((part().center() - middle).norm() < 1e-4);
        value->setValue(-30);
        press("place_value_apply");
        QVERIFY((part().size() - Vec3(60, 40, 20)).norm() < 1e-4);
        choose(5); // along Z
        value->setValue(12.5);
        press("place_value_apply");
        QVERIFY((part().center() - middle - Vec3(0, 0, 12.5)).norm() < 1e-4);
        const Vec3 low(part().center().x(), part().center().y(), part().lo.z());
        choose(6);
        value->setValue(1.5);
        press("place_value_apply");
        QVERIFY((part().size() - Vec3(90, 60, 30)).norm() < 1e-4);
        QVERIFY((Vec3(part().center().x(), part().center().y(), part().lo.z()) - low).norm() < 1e-4);
        QCOMPARE(w().document().project().part.scale, 1.5);
        QVERIFY(label("place_size").contains(QStringLiteral("scaled by 1.5")));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("90")));
        shot(w(), QStringLiteral("place-scaled"));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY((part().size() - Vec3(60, 40, 20)).norm() < 1e-4);
        QVERIFY(!label("place_size").contains(QStringLiteral("scaled")));
        choose(0);
        value->setValue(0);
        const int count = w().document().undo_stack().index();
        press("place_value_apply");
        QCOMPARE(w().document().undo_stack().index(), count);
        QVERIFY(w().message_bar().message().contains(QStringLiteral("so already")));
    }

    /// Into a hole, beside it, and where there is none.
    void the_zero_comes_to_a_hole() {
        // A plate of 40 x 30 x 8 with a hole of Ø 12 about (25, 14).
        Mesh plate;
        constexpr Index sides = 64;
        for (const double z : {0.0, 8.0})
            for (Index k = 0; k < sides; ++k) {
                const double angle = 2 * pi * (k + 0.5) / sides, c = std::cos(angle), s = std::sin(angle);
                plate.vertices.emplace_back(25 + 6 * c, 14 + 6 * s, z);
                // Out to the border, in the same direction.
                const double x = c > 0 ? (40 - 25) / c : -25 / c, y = s > 0 ? (30 - 14) / s : -14 / s;
                plate.vertices.emplace_back(25 + std::min(x, y) * c, 14 + std::min(x, y) * s, z);
            }
        for (Index k = 0; k < sides; ++k) {
            const Index a = 2 * k, b = 2 * ((k + 1) % sides), up = 2 * sides;
            for (const Facet& f :
                 {Facet{a, b, b + 1}, Facet{a, b + 1, a + 1}, Facet{a + up, b + up + 1, b + up},
                  Facet{a + up, a + up + 1, b + up + 1}, Facet{a, a + up, b + up}, Facet{a, b + up, b},
                  Facet{a + 1, b + 1, b + up + 1}, Facet{a + 1, b + up + 1, a + up + 1}})
                plate.facets.push_back(f);
        }
        const QString file = scratch_folder(QStringLiteral("hole")) + QStringLiteral("/plate.stl");
        save_stl(plate, file.toStdString(), LengthUnit::mm, {});
        QVERIFY(w().files().save_to(file + QStringLiteral(".facetmill"))); // or it asks
        w().open_file(file, LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        const auto zero = [&] {
            const auto& z = w().document().project().programs.zero;
            return Vec3(z[0], z[1], z[2]);
        };
        for (const Vec3& at : {Vec3(25, 20, 6), Vec3(25 + 4.6 * std::sqrt(2), 14 + 4.6 * std::sqrt(2), 8)}) {
            press("zero_hole");
            QVERIFY(tool_button("zero_hole")->isChecked());
            QVERIFY(click_at(at));
            QVERIFY(wait_until_settled(w()));
            QVERIFY2((zero() - Vec3(25, 14, 8)).norm() < 1e-4, qPrintable(w().message_bar().message()));
            QVERIFY(w().document().project().programs.zero_from == ProgramSpec::ZeroFrom::origin);
            QVERIFY(w().message_bar().message().contains(QStringLiteral("hole of Ø 12")));
            QVERIFY(!tool_button("zero_hole")->isChecked());
            shot(w(), QStringLiteral("place-hole"));
            w().document().undo_stack().undo();
            QVERIFY(wait_until_settled(w()));
            QCOMPARE(zero(), Vec3(0, 0, 0));
        }
        press("zero_hole");
        QVERIFY(click_at(Vec3(20, 0, 3))); // the plate's side
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(zero(), Vec3(0, 0, 0));
        QVERIFY(w().message_bar().message().contains(QStringLiteral("round")));
    }

    /// By rings and arrows: drawn as it will be while it is dragged, one step when it is let go.
    /// They would lie over what the other one is about.
    void rings_go_behind_another_panel() {
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        w().viewport().set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        auto& viewport = w().viewport();
        ui::PlaceGizmo& gizmo = *w().controllers().place().gizmo();
        for (const char* front : {"place_dock", "verification_dock", "place_dock"}) {
            auto* dock = w().findChild<QDockWidget*>(QLatin1String(front));
            dock->show();
            dock->raise();
            QTest::qWait(80);
            const QPoint ring = gizmo.place_of(ui::PlaceChange::turn, 2, 0.1).toPoint();
            QTest::mousePress(&viewport, Qt::LeftButton, {}, ring);
            const bool taken = gizmo.dragging();
            QTest::mouseRelease(&viewport, Qt::LeftButton, {}, ring);
            QVERIFY2(taken == (QLatin1String(front) == QLatin1String("place_dock")), front);
        }
    }

    void rings_and_arrows_are_dragged() {
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        press("place_principal");
        w().viewport().set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        auto& viewport = w().viewport();
        ui::PlaceGizmo& gizmo = *w().controllers().place().gizmo();
        const auto drag = [&](const QPointF& from, const QPointF& to, Qt::KeyboardModifiers keys) {
            QTest::mousePress(&viewport, Qt::LeftButton, keys, from.toPoint());
            QTest::mouseMove(&viewport, ((from + to) / 2).toPoint());
            QMouseEvent move(QEvent::MouseMove, QPointF(to.toPoint()), viewport.mapToGlobal(to.toPoint()),
                             Qt::NoButton, Qt::LeftButton, keys);
            QApplication::sendEvent(&viewport, &move);
        };
        const auto release = [&](const QPointF& at, Qt::KeyboardModifiers keys) {
            QTest::mouseRelease(&viewport, Qt::LeftButton, keys, at.toPoint());
            return wait_until_settled(w());
        };
        using Change = ui::PlaceChange;
        const auto ring = [&](double share) { return gizmo.place_of(Change::turn, 2, share); };
        const int count = w().document().undo_stack().index();
        const Vec3 middle = part().center();
        const QImage before = view_picture(w());
        drag(ring(0.1), ring(0.2), Qt::ShiftModifier);
        QVERIFY(gizmo.dragging());
        // The part itself is seen turned; while the button is down the window does not settle.
        QTRY_VERIFY_WITH_TIMEOUT(changed_pixels(before, view_picture(w())) > 500, patience_ms);
        shot(w(), QStringLiteral("place-ring"));
        auto* value = w().findChild<QDoubleSpinBox*>(QStringLiteral("place_value"));
        QCOMPARE(value->value(), 35.0); // 36 in round steps
        QCOMPARE(w().document().undo_stack().index(), count);
        QVERIFY(release(ring(0.2), Qt::ShiftModifier));
        QCOMPARE(w().document().undo_stack().index(), count + 1);
        const double c = std::cos(radians(35)), s = std::sin(radians(35));
        QVERIFY2((part().size() - Vec3(60 * c + 40 * s, 60 * s + 40 * c, 20)).norm() < 1e-3,
                 qPrintable(QString::number(part().size().x())));
        QVERIFY((part().center() - middle).norm() < 1e-3);
        QVERIFY(w().viewport().scene().part().pick(0, 0) == std::nullopt);
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        // Esc puts it back.
        drag(ring(0.1), ring(0.3), {});
        QVERIFY(gizmo.dragging());
        QTest::keyClick(&viewport, Qt::Key_Escape);
        QVERIFY(!gizmo.dragging());
        QVERIFY(release(ring(0.3), {}));
        QCOMPARE(w().document().undo_stack().index(), count);
        QVERIFY((part().size() - Vec3(60, 40, 20)).norm() < 1e-4);
        // An arrow, seen from the side; more than half a turn of a ring that is seen from there.
        w().viewport().set_view(StandardView::front);
        QVERIFY(wait_until_settled(w()));
        const QPointF tip = gizmo.place_of(Change::move, 2);
        const double mm_per_point = viewport.scene().camera().pixel_size() * viewport.devicePixelRatioF();
        drag(tip - QPointF(0, -4), tip - QPointF(0, 36), Qt::ShiftModifier);
        QVERIFY(gizmo.dragging());
        QVERIFY(release(tip - QPointF(0, 36), Qt::ShiftModifier));
        const double up = part().center().z() - middle.z();
        QVERIFY2(std::abs(up - std::round(40 * mm_per_point)) < 1e-3 && up > 1,
                 qPrintable(QString::number(up)));
        QCOMPARE(w().document().undo_stack().undoText(), QStringLiteral("Move part along Z"));
        // A press beside them turns the view as ever, and without the panel there are none.
        const Vec3 sight = viewport.sight();
        drag(QPointF(30, 30), QPointF(60, 60), {});
        QVERIFY(!gizmo.dragging());
        QVERIFY(release(QPointF(60, 60), {}));
        QVERIFY((viewport.sight() - sight).norm() > 0.01);
        dock()->hide();
        QVERIFY(wait_until_settled(w()));
        viewport.set_view(StandardView::top);
        QVERIFY(wait_until_settled(w()));
        drag(ring(0.1), ring(0.2), {});
        QVERIFY(!gizmo.dragging());
        QVERIFY(release(ring(0.2), {}));
    }

private:
    QDockWidget* dock() { return w().findChild<QDockWidget*>(QStringLiteral("place_dock")); }
    QTreeWidget* list() { return w().findChild<QTreeWidget*>(QStringLiteral("place_faces")); }
    QToolButton* tool_button(const char* name) { return w().findChild<QToolButton*>(QLatin1String(name)); }
    bool button(const char* name) { return w().findChild<QPushButton*>(QLatin1String(name))->isEnabled(); }
    QString label(const char* name) { return w().findChild<QLabel*>(QLatin1String(name))->text(); }
    Box3 part() { return w().document().part()->box; }
    void press(const char* name) {
        w().findChild<QAbstractButton*>(QLatin1String(name))->click();
        QVERIFY(wait_until_settled(w()));
    }
    /// The part is read anew, has the size, and its lowest point Z 0; the view has it whole.
    bool lies(const Vec3& size, bool straight = true) {
        if (!w().document().part_is_current()) return false;
        const Box3 box = part();
        const Scene& scene = w().viewport().scene();
        for (const Vec3& corner : {box.lo, box.hi}) {
            const Vec2 at = scene.camera().display_of(corner) / w().viewport().devicePixelRatioF();
            if (at.x() < 0 || at.y() < 0 || at.x() > w().viewport().width()
                || at.y() > w().viewport().height())
                return false;
        }
        return std::abs(box.size().z() - size.z()) < 1e-4 && (!straight || (box.size() - size).norm() < 1e-4)
               && (w().document().project().part.rotate == std::array<double, 3>{0, 0, 0}
                   || std::abs(box.lo.z()) < 1e-6 || !straight);
    }
    /// False where the place is not what is seen there.
    bool click_at(const Vec3& p) {
        auto& viewport = w().viewport();
        const Vec2 pixel = viewport.scene().camera().display_of(p);
        const auto seen = viewport.scene().part().pick(pixel.x(), pixel.y());
        if (!seen || (seen->point - p).norm() > 1) return false;
        const Vec2 at = pixel / viewport.devicePixelRatioF();
        QTest::mouseClick(&viewport, Qt::LeftButton, {},
                          QPoint(int(std::lround(at.x())), int(std::lround(at.y()))));
        return wait_until_settled(w());
    }
};

FACETMILL_TEST(TestWindowPlace)
#include "test_window_place.moc"
