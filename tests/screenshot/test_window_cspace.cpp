// The configuration space in the window: it comes with a planned 5-axis operation, follows the picked
// point, steps with the arrow keys, and tries postures.
#include "tests/screenshot/window_support.h"
#include "ui/cspace_controller.h"
#include "ui/cspace_panel.h"
#include "ui/cspace_view.h"
#include "ui/elided_label.h"
#include "ui/language.h"
#include "ui/operation_list.h"
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

    CSpaceController& cspace() { return w().cspace(); }
    QDockWidget* dock() { return w().findChild<QDockWidget*>(QStringLiteral("cspace_dock")); }
    QString heading() { return cspace().panel()->heading()->text(); }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void empty_without_five_axes() {
        QVERIFY(!cspace().point());
        QVERIFY(open_and_plan());
        QVERIFY(!cspace().point());
        QVERIFY(!cspace().shown());
        QVERIFY(!cspace().panel()->findChild<QToolButton*>(QStringLiteral("cspace_next"))->isEnabled());
        dock()->show();
        dock()->raise();
        QVERIFY(wait_until_settled(w()));
        shot(w(), QStringLiteral("cspace-none"));
    }

    void a_plan_brings_the_space_and_keys_step() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        QVERIFY(cspace().point().has_value());
        QVERIFY(dock()->isVisible());
        QVERIFY(cspace().active());
        QVERIFY(cspace().shown());
        QCOMPARE(cspace().shown()->index, *cspace().point());
        QVERIFY(w().viewport().scene().has(Layer::tool));
        shot(w(), QStringLiteral("cspace-view"));

        // Along the pass from the window, as from the view.
        const std::size_t first = *cspace().point();
        const QString was = heading();
        QTest::keyClick(&w(), Qt::Key_Right);
        QCOMPARE(*cspace().point(), first + 1);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(cspace().shown()->index, first + 1);
        QVERIFY(heading() != was);
        const QImage before = view_picture(w());
        QTest::keyClick(cspace().panel()->view(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(*cspace().point(), first + 11);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(before, view_picture(w())) > 50); // the tool went along
        QTest::keyClick(&w(), Qt::Key_Left);
        QCOMPARE(*cspace().point(), first + 10);

        // The next pass is another line of the record; its study replaces the one under way.
        const auto record = w().document().result(0)->path.five_axis();
        const int pass = record->line_of(*cspace().point()).drive;
        QTest::keyClick(&w(), Qt::Key_Down);
        QTest::keyClick(&w(), Qt::Key_Down);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(record->line_of(*cspace().point()).drive != pass);
        QCOMPARE(cspace().shown()->index, *cspace().point());
        QTest::keyClick(&w(), Qt::Key_Up);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(record->line_of(*cspace().point()).drive != pass);

        // The ends of the path hold.
        for (int i = 0; i < 3; ++i)
            cspace().step(-int(cspace().point_count()), 0);
        QCOMPARE(*cspace().point(), std::size_t(0));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(cspace().shown()->index, std::size_t(0));
    }

    void postures_are_tried_and_put_back() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        cspace().step(cspace().point_count() > 40 ? 20 : 5, 0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(cspace().shown() && cspace().shown()->planned.free);
        const QImage planned = view_picture(w());
        cspace().try_posture({radians(30), radians(-20), 0});
        QVERIFY(cspace().tried());
        QVERIFY(cspace().tried()->delta >= 0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(planned, view_picture(w())) > 200);
        QVERIFY(cspace().panel()->readout()->text().contains(QStringLiteral("lead 30.0")));
        shot(w(), QStringLiteral("cspace-tried"));
        QTest::mouseClick(cspace().panel()->back(), Qt::LeftButton);
        QVERIFY(!cspace().tried());
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(planned, view_picture(w())) < 20);

        // Dragging the marker of the planned posture into the view.
        CSpaceView* view = cspace().panel()->view();
        const Vec2 at =
            view->scene().display_of(cspace().shown()->planned.posture) / view->devicePixelRatioF();
        const QPoint from(int(at.x()), int(at.y())), to = from + QPoint(30, -12);
        QTest::mousePress(view, Qt::LeftButton, {}, from);
        QTest::mouseMove(view, from + QPoint(10, -5));
        QTest::mouseMove(view, to);
        QTest::mouseRelease(view, Qt::LeftButton, {}, to);
        QVERIFY(cspace().tried());
    }

    void postures_are_kept_for_a_point() {
        QVERIFY2(plan_five_axes(), qPrintable(w().last_failure()));
        CSpacePanel* panel = cspace().panel();
        cspace().step(20, 0);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(cspace().shown() && cspace().shown()->planned.free);
        QVERIFY(!panel->keep()->isEnabled() && !panel->remove()->isEnabled());
        QVERIFY(panel->kept()->isHidden());
        const std::size_t point = *cspace().point();
        const Vec3 place = cspace().shown()->place.surface;
        const PostureValue planned = cspace().shown()->planned.posture;

        // One that is not free cannot be kept, one that is can.
        cspace().try_posture({radians(44), radians(44), 0});
        const PostureValue wish{planned.lead + radians(2), radians(7), 0};
        cspace().try_posture(wish);
        QVERIFY2(panel->keep()->isEnabled(), qPrintable(panel->keep()->toolTip()));
        shot(w(), QStringLiteral("cspace-keep"));
        QTest::mouseClick(panel->keep(), Qt::LeftButton);
        QCOMPARE(w().document().state(0), OperationState::stale);
        QVERIFY(cspace().kept().has_value());
        QCOMPARE(cspace().kept()->lead, wish.lead);
        QCOMPARE(cspace().kept()->yaw, wish.yaw);
        QVERIFY(
            (Vec3(cspace().kept()->point[0], cspace().kept()->point[1], cspace().kept()->point[2]) - place)
                .norm()
            == 0);
        QVERIFY(panel->remove()->isEnabled());
        QVERIFY(!panel->kept()->isHidden());
        QCOMPARE(panel->kept()->text(), QStringLiteral("Kept: 1"));
        // Kept again it is another one, not a second.
        cspace().try_posture({planned.lead + radians(3), radians(7), 0});
        QTest::mouseClick(panel->keep(), Qt::LeftButton);
        QCOMPARE(panel->kept()->text(), QStringLiteral("Kept: 1"));
        QTest::keyClick(&w(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(cspace().kept()->lead, wish.lead);

        // Planned again, the point stands as kept.
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().state(0), OperationState::planned);
        const auto record = w().document().result(0)->path.five_axis();
        QVERIFY(record->points[point].choice.free);
        QCOMPARE(record->points[point].choice.posture.lead, wish.lead);
        QCOMPARE(record->points[point].choice.posture.yaw, wish.yaw);

        // The list leads there.
        QVERIFY(*cspace().point() != point);
        QVERIFY(!panel->remove()->isEnabled());
        QMenu* menu = panel->kept()->menu();
        QVERIFY(menu);
        QCOMPARE(menu->actions().size(), qsizetype(1));
        menu->actions().front()->trigger();
        QCOMPARE(*cspace().point(), point);
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
        QVERIFY(!cspace().kept());
        QVERIFY(panel->kept()->isHidden());
        QCOMPARE(w().document().state(0), OperationState::stale);
        // Another operation of the kind starts without them, a copy with them.
        QTest::keyClick(&w(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(cspace().kept().has_value());
        w().document().add_operation("finish5");
        ui::duplicate_operation(w().document(), 0);
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
        cspace().save_picture(folder + QStringLiteral("/cspace.png"));
        cspace().save_table(folder + QStringLiteral("/cspace.csv"));
        QVERIFY(wait_until_settled(w()));
        const QImage picture(folder + QStringLiteral("/cspace.png"));
        QCOMPARE(picture.size(), QSize(1200, 900));
        QFile file(folder + QStringLiteral("/cspace.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto lines = file.readAll().trimmed().split('\n');
        QCOMPARE(std::size_t(lines.size()), cspace().shown()->space.block.size() + 1);
        QCOMPARE(lines.front(), QByteArray("lambda_deg,omega_deg,delta_bottom_in,delta_top_in,blocked"));
        QVERIFY(w().last_failure().isEmpty());
        cspace().save_picture(folder + QStringLiteral("/no/cspace.png"));
        QVERIFY(wait_until_settled(w()));
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
        QVERIFY(cspace().panel()->view()->height() >= 100);
        // All of the legend is in the language of the window, also what postures have in common.
        ui::speak(QStringLiteral("fr"));
        w().set_theme(Theme::light);
        QString legend;
        for (const QLabel* label : cspace().panel()->findChildren<QLabel*>())
            legend += label->text() + QChar('\n');
        QVERIFY2(legend.contains(QStringLiteral("Choisi")) && !legend.contains(QStringLiteral("planned")),
                 qPrintable(legend));
        ui::speak(QStringLiteral("en"));
    }
};

FACETMILL_TEST(TestWindowCSpace)
#include "test_window_cspace.moc"
