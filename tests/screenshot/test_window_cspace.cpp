// The configuration-space room in the window: it comes with a planned 5-axis operation, follows the picked
// point, steps with the arrow keys, and tries postures.
#include "tests/screenshot/window_support.h"
#include "ui/cspace_controller.h"
#include "ui/cspace_panel.h"
#include "ui/cspace_view.h"
#include "ui/elided_label.h"
#include "ui/project_tree.h"
#include "ui/viewport.h"

#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QToolButton>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowCSpace : public QObject, public WindowFixture {
    Q_OBJECT

    CSpaceController& room() { return w().cspace(); }
    QDockWidget* dock() { return w().findChild<QDockWidget*>(QStringLiteral("cspace_dock")); }
    QString heading() { return room().panel()->heading()->text(); }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void empty_without_five_axes() {
        QVERIFY(!room().point());
        QVERIFY(open_and_plan());
        QVERIFY(!room().point());
        QVERIFY(!room().shown());
        QVERIFY(!room().panel()->findChild<QToolButton*>(QStringLiteral("cspace_next"))->isEnabled());
        dock()->show();
        dock()->raise();
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("cspace-none"));
    }

    void a_plan_brings_the_room_and_keys_step() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        QVERIFY(room().point().has_value());
        QVERIFY(dock()->isVisible());
        QVERIFY(room().active());
        QVERIFY(room().shown());
        QCOMPARE(room().shown()->index, *room().point());
        QVERIFY(w().viewport().scene().has(Layer::tool));
        shot(w(), QStringLiteral("cspace-room"));

        // Along the pass from the window, as from the room.
        const std::size_t first = *room().point();
        const QString was = heading();
        QTest::keyClick(&w(), Qt::Key_Right);
        QCOMPARE(*room().point(), first + 1);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(room().shown()->index, first + 1);
        QVERIFY(heading() != was);
        const QImage before = view_picture(w());
        QTest::keyClick(room().panel()->view(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(*room().point(), first + 11);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(before, view_picture(w())) > 50); // the tool went along
        QTest::keyClick(&w(), Qt::Key_Left);
        QCOMPARE(*room().point(), first + 10);

        // The next pass is another line of the record; its study replaces the one under way.
        const auto record = w().document().result(0)->path.five_axis();
        const int pass = record->line_of(*room().point()).drive;
        QTest::keyClick(&w(), Qt::Key_Down);
        QTest::keyClick(&w(), Qt::Key_Down);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(record->line_of(*room().point()).drive != pass);
        QCOMPARE(room().shown()->index, *room().point());
        QTest::keyClick(&w(), Qt::Key_Up);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(record->line_of(*room().point()).drive != pass);

        // The ends of the path hold.
        for (int i = 0; i < 3; ++i)
            room().step(-int(room().point_count()), 0);
        QCOMPARE(*room().point(), std::size_t(0));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(room().shown()->index, std::size_t(0));
    }

    void postures_are_tried_and_put_back() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        room().step(room().point_count() > 40 ? 20 : 5, 0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(room().shown() && room().shown()->planned.free);
        const QImage planned = view_picture(w());
        room().try_posture({radians(30), radians(-20), 0});
        QVERIFY(room().tried());
        QVERIFY(room().tried()->delta >= 0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(planned, view_picture(w())) > 200);
        QVERIFY(room().panel()->readout()->text().contains(QStringLiteral("lead 30.0")));
        shot(w(), QStringLiteral("cspace-tried"));
        QTest::mouseClick(room().panel()->back(), Qt::LeftButton);
        QVERIFY(!room().tried());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(planned, view_picture(w())) < 20);

        // Dragging the marker of the planned posture into the room.
        CSpaceView* view = room().panel()->view();
        const Vec2 at = view->scene().display_of(room().shown()->planned.posture) / view->devicePixelRatioF();
        const QPoint from(int(at.x()), int(at.y())), to = from + QPoint(30, -12);
        QTest::mousePress(view, Qt::LeftButton, {}, from);
        QTest::mouseMove(view, from + QPoint(10, -5));
        QTest::mouseMove(view, to);
        QTest::mouseRelease(view, Qt::LeftButton, {}, to);
        QVERIFY(room().tried());
    }

    void postures_are_kept_for_a_point() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        CSpacePanel* panel = room().panel();
        room().step(20, 0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(room().shown() && room().shown()->planned.free);
        QVERIFY(!panel->keep()->isEnabled() && !panel->remove()->isEnabled());
        QVERIFY(panel->kept()->isHidden());
        const std::size_t point = *room().point();
        const Vec3 place = room().shown()->place.surface;
        const PostureValue planned = room().shown()->planned.posture;

        // One that is not free cannot be kept, one that is can.
        room().try_posture({radians(44), radians(44), 0});
        const PostureValue wish{planned.lead + radians(2), radians(7), 0};
        room().try_posture(wish);
        QVERIFY2(panel->keep()->isEnabled(), qPrintable(panel->keep()->toolTip()));
        shot(w(), QStringLiteral("cspace-keep"));
        QTest::mouseClick(panel->keep(), Qt::LeftButton);
        QCOMPARE(w().document().state(0), OperationState::stale);
        QVERIFY(room().kept().has_value());
        QCOMPARE(room().kept()->lead, wish.lead);
        QCOMPARE(room().kept()->yaw, wish.yaw);
        QVERIFY(
            (Vec3(room().kept()->point[0], room().kept()->point[1], room().kept()->point[2]) - place).norm()
            == 0);
        QVERIFY(panel->remove()->isEnabled());
        QVERIFY(!panel->kept()->isHidden());
        QCOMPARE(panel->kept()->text(), QStringLiteral("Kept: 1"));
        // Kept again it is another one, not a second.
        room().try_posture({planned.lead + radians(3), radians(7), 0});
        QTest::mouseClick(panel->keep(), Qt::LeftButton);
        QCOMPARE(panel->kept()->text(), QStringLiteral("Kept: 1"));
        QTest::keyClick(&w(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(room().kept()->lead, wish.lead);

        // Planned again, the point stands as kept.
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        const auto record = w().document().result(0)->path.five_axis();
        QVERIFY(record->points[point].choice.free);
        QCOMPARE(record->points[point].choice.posture.lead, wish.lead);
        QCOMPARE(record->points[point].choice.posture.yaw, wish.yaw);

        // The list leads there.
        QVERIFY(*room().point() != point);
        QVERIFY(!panel->remove()->isEnabled());
        QMenu* menu = panel->kept()->menu();
        QVERIFY(menu);
        QCOMPARE(menu->actions().size(), qsizetype(1));
        menu->actions().front()->trigger();
        QCOMPARE(*room().point(), point);
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(panel->readout()->text().startsWith(QStringLiteral("Planned as kept")),
                 qPrintable(panel->readout()->text()));
        shot(w(), QStringLiteral("cspace-kept"));

        // Saved and read again it is there; removed it is gone.
        const QString path = scratch_folder(QStringLiteral("kept")) + QStringLiteral("/p.facetmill");
        QVERIFY(w().files().save_to(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"manual_postures\""));
        QTest::mouseClick(panel->remove(), Qt::LeftButton);
        QVERIFY(!room().kept());
        QVERIFY(panel->kept()->isHidden());
        QCOMPARE(w().document().state(0), OperationState::stale);
        // Another operation of the kind starts without them, a copy with them.
        QTest::keyClick(&w(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(room().kept().has_value());
        w().document().add_operation("finish5");
        w().document().duplicate_operation(0);
        const auto kept = [&](std::size_t i) {
            return manual_posture_list.of(w().document().operation(i)).size();
        };
        QCOMPARE(kept(0), std::size_t(1));
        QCOMPARE(kept(1), std::size_t(1));
        QCOMPARE(kept(2), std::size_t(0));
    }

    void exports() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        const QString folder = scratch_folder(QStringLiteral("cspace"));
        QVERIFY(room().save_picture(folder + QStringLiteral("/room.png")));
        const QImage picture(folder + QStringLiteral("/room.png"));
        QCOMPARE(picture.size(), QSize(1200, 900));
        QVERIFY(room().save_table(folder + QStringLiteral("/room.csv")));
        QFile file(folder + QStringLiteral("/room.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto lines = file.readAll().trimmed().split('\n');
        QCOMPARE(std::size_t(lines.size()), room().shown()->space.block.size() + 1);
        QCOMPARE(lines.front(), QByteArray("lambda_deg,omega_deg,delta_bottom_in,delta_top_in,blocked"));
        QVERIFY(!room().save_picture(folder + QStringLiteral("/no/room.png")));
        QVERIFY(!w().last_failure().isEmpty());
    }

    void a_small_window() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        w().set_theme(Theme::dark);
        w().resize(800, 600);
        QVERIFY(wait_until_settled(w()));
        dock()->raise();
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("cspace-small"));
        QVERIFY(w().width() <= 800);
        QVERIFY(room().panel()->view()->height() >= 100);
        w().set_theme(Theme::light);
    }
};

FACETMILL_TEST(TestWindowCSpace)
#include "test_window_cspace.moc"
