// The configuration-space room in the window: it comes with a planned 5-axis operation, follows the picked
// point, steps with the arrow keys, and tries postures.
#include "tests/screenshot/window_support.h"
#include "ui/cspace_desk.h"
#include "ui/cspace_view.h"
#include "ui/elided_label.h"
#include "ui/project_tree.h"
#include "ui/viewport.h"

#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QTest>
#include <QToolButton>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowCSpace : public QObject, public WindowFixture {
    Q_OBJECT

    CSpaceDesk& room() { return w().cspace(); }
    QDockWidget* dock() { return w().findChild<QDockWidget*>(QStringLiteral("cspace_dock")); }
    QString heading() { return room().panel()->heading()->text(); }

    /// A coarse convex part with a coarse 5-axis operation in the place of the default one, planned.
    bool plan_five_axes() {
        if (!open_part()) return false;
        w().document().add_operation("finish5");
        w().document().remove_operation(0);
        w().document().change(QStringLiteral("Coarse"), [](Project& p) {
            p.machine = "tarus-tpi-2000";
            p.operations[0]->common().tolerance = 0.03 * mm_per_inch;
            p.operations[0]->set("grid_degrees", ParameterValue(radians(9)));
            p.operations[0]->set("normal_limit", ParameterValue(radians(20)));
            p.operations[0]->set("posture", ParameterValue(std::string("cm2")));
        });
        w().plan();
        return wait_until_settled(w()) && w().document().state(0) == OperationState::planned;
    }

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
        const auto record = w().document().result(0)->path.five_axis;
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
