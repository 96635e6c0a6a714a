// How the view is seen: perspective, two buttons at once, what lies over it, pictures of operations.
#include "core/strategy/plan/operation.h"
#include "tests/screenshot/window_support.h"
#include "ui/help_pages.h"
#include "ui/message_bar.h"
#include "ui/operation_menu.h"
#include "ui/project_tree.h"
#include "ui/settings.h"
#include "ui/settings_file.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/view_cube.h"
#include "ui/viewport.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

class TestWindowSight : public QObject, private WindowFixture {
    Q_OBJECT

    Vec2 pixel(const Vec3& p) { return w().viewport().scene().camera().display_of(p); }
    void move_to(QPoint to, Qt::MouseButtons held) {
        QMouseEvent event(QEvent::MouseMove, to, w().viewport().mapToGlobal(to), Qt::NoButton, held, {});
        QApplication::sendEvent(&w().viewport(), &event);
    }
    void button(QEvent::Type type, Qt::MouseButton which, Qt::MouseButtons held, QPoint at) {
        QMouseEvent event(type, at, w().viewport().mapToGlobal(at), which, held, {});
        QApplication::sendEvent(&w().viewport(), &event);
    }

private slots:
    void init() {
        ui::SettingsFile::own().clear();
        QVERIFY(show_window());
    }
    void cleanup() { close_window(); }
    void cleanupTestCase() { ui::SettingsFile::own().clear(); }

    /// A face is shown from where it is seen well; the part that lies on it then, from where one looked
    /// before. A view that was turned meanwhile stays.
    void a_laid_part_is_seen_from_where_it_was() {
        QVERIFY(open_part());
        ui::Viewport& view = w().viewport();
        action(w(), "place")->trigger();
        QVERIFY(wait_until_settled(w()));
        auto* faces = w().findChild<QTreeWidget*>(QStringLiteral("place_faces"));
        auto* lay = w().findChild<QAbstractButton*>(QStringLiteral("place_lay"));
        const auto choose = [&](int row) {
            faces->setCurrentItem(faces->topLevelItem(row));
            QVERIFY(wait_until_settled(w()));
        };
        for (const bool lies_so : {false, true}) {
            view.set_view(StandardView::iso);
            const Vec3 before = view.sight();
            choose(lies_so ? 1 : 0);
            choose(lies_so ? 0 : 1);
            choose(0);
            QVERIFY2((view.sight() - before).norm() > 0.1, qPrintable(QString::number(view.sight().z())));
            lay->click();
            QVERIFY(wait_until_settled(w()));
            QVERIFY((view.sight() - before).norm() < 1e-6);
        }
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        choose(0);
        view.set_view(StandardView::top);
        lay->click();
        QVERIFY(wait_until_settled(w()));
        QVERIFY((view.sight() + Vec3::UnitZ()).norm() < 1e-6);
    }

    /// By menu and key; picked, zoomed and fitted as it is seen; kept for the next start.
    void perspective() {
        QVERIFY(open_part());
        ui::Viewport& view = w().viewport();
        view.set_view(StandardView::iso);
        const QImage parallel = view_picture(w());
        QAction* toggle = action(w(), "perspective");
        QVERIFY(!toggle->isChecked());
        QVERIFY(activate(w()));
        QTest::keyClick(&w(), Qt::Key_P, Qt::ShiftModifier);
        QVERIFY(toggle->isChecked() && ui::settings::perspective());
        QVERIFY(view.scene().camera().perspective());
        QVERIFY(changed_pixels(parallel, view_picture(w())) > 500);
        shot(w(), QStringLiteral("sight-perspective"));
        // All of the part is in the window, and a click meets it where it is drawn.
        const Box3 box = w().document().part()->box;
        for (const double x : {box.lo.x(), box.hi.x()})
            for (const double y : {box.lo.y(), box.hi.y()}) {
                const Vec2 p = pixel({x, y, box.hi.z()});
                QVERIFY(p.x() >= 0 && p.y() >= 0 && p.x() <= view.width() && p.y() <= view.height());
            }
        const Mesh& mesh = *w().document().part()->mesh;
        const Vec3 place = mesh.corner(5 * 48 + 10, 0);
        QSignalSpy picked(&view, &ui::Viewport::part_picked);
        const Vec2 at = pixel(place);
        QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(int(at.x()), int(at.y())));
        QCOMPARE(picked.count(), 1);
        QVERIFY((picked[0][0].value<PartPick>().point - place).norm() < 0.05 * box.diagonal());
        // The wheel keeps what is under the pointer, whatever its depth.
        const QPoint pointer(int(at.x()), int(at.y()));
        const auto under = view.scene().part().pick(pointer.x(), pointer.y());
        QVERIFY(under);
        QWheelEvent wheel(QPointF(pointer), view.mapToGlobal(QPointF(pointer)), {}, QPoint(0, 480),
                          Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &wheel);
        QVERIFY((pixel(under->point) - Vec2(pointer.x(), pointer.y())).norm() < 1e-6);
        // So does a drag that moves.
        QTest::mousePress(&view, Qt::MiddleButton, {}, pointer);
        for (int i = 1; i <= 4; ++i)
            move_to(pointer + QPoint(10, 5) * i, Qt::MiddleButton);
        QTest::mouseRelease(&view, Qt::MiddleButton, {}, pointer + QPoint(40, 20));
        QVERIFY((pixel(under->point) - Vec2(pointer.x() + 40, pointer.y() + 20)).norm() < 1.5);
        // The cube and the keys turn it as before.
        view.set_view(StandardView::iso);
        const auto top = view.view_cube()->face_center(StandardView::top);
        QVERIFY(top);
        QTest::mouseClick(view.view_cube(), Qt::LeftButton, {}, top->toPoint());
        QVERIFY((view.sight() - Vec3(0, 0, -1)).norm() < 1e-9);
        close_window();
        QVERIFY(show_window());
        QVERIFY(w().viewport().scene().camera().perspective());
        QVERIFY(action(w(), "perspective")->isChecked());
        action(w(), "perspective")->trigger();
        QVERIFY(!w().viewport().scene().camera().perspective() && !ui::settings::perspective());
    }

    /// The wheel pressed moves, a second button with it turns, whichever is pressed first; one let go, the
    /// other goes on; and no click comes of it.
    void two_buttons_turn_as_in_freecad() {
        QVERIFY(open_part());
        ui::Viewport& view = w().viewport();
        view.set_navigation({ui::NavigationStyle::freecad, ui::Orbit::trackball});
        QSignalSpy picked(&view, &ui::Viewport::part_picked), missed(&view, &ui::Viewport::nothing_picked),
            menu(&view, &ui::Viewport::menu_requested);
        const Qt::MouseButton middle = Qt::MiddleButton;
        for (const Qt::MouseButton other : {Qt::LeftButton, Qt::RightButton})
            for (const bool middle_first : {true, false}) {
                view.set_view(StandardView::iso);
                const QPoint at = view.rect().center();
                const Vec3 sight = view.sight();
                const Qt::MouseButton first = middle_first ? middle : other,
                                      second = middle_first ? other : middle;
                button(QEvent::MouseButtonPress, first, first, at);
                if (middle_first) {
                    move_to(at + QPoint(20, 0), first);
                    QVERIFY((view.sight() - sight).norm() < 1e-9);
                }
                button(QEvent::MouseButtonPress, second, first | second, at + QPoint(20, 0));
                for (int i = 1; i <= 4; ++i)
                    move_to(at + QPoint(20 + 10 * i, 5 * i), first | second);
                const Vec3 turned = view.sight();
                QVERIFY2((turned - sight).norm() > 0.1,
                         qPrintable(QStringLiteral("%1 %2").arg(int(other)).arg(middle_first)));
                button(QEvent::MouseButtonRelease, other, middle, at + QPoint(60, 20));
                const Vec2 before = pixel(Vec3::Zero());
                for (int i = 1; i <= 4; ++i)
                    move_to(at + QPoint(60 + 10 * i, 20), middle);
                QVERIFY((view.sight() - turned).norm() < 1e-9); // it moves again
                QVERIFY((pixel(Vec3::Zero()) - before).norm() > 20);
                button(QEvent::MouseButtonRelease, middle, {}, at + QPoint(100, 20));
                move_to(at, {});
            }
        QCOMPARE(picked.count() + missed.count() + menu.count(), 0);
        view.set_navigation({});
    }

    void messages_leave_title_and_legend_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("usual") << QSize(1280, 800);
        QTest::newRow("small") << QSize(800, 600);
    }
    /// A message covers neither what the colours mean nor what the part is; the cube makes room.
    void messages_leave_title_and_legend() {
        QFETCH(QSize, size);
        QVERIFY(open_and_plan());
        w().resize(size);
        QApplication::processEvents();
        ui::Viewport& view = w().viewport();
        const QImage before = view_picture(w());
        const bool cube = view.view_cube()->isVisible();
        w().message_bar().show_message(ui::MessageBar::Kind::warning,
                                       QStringLiteral("The verification is out of date: verify again."));
        QTest::qWait(30);
        const QRect bar = w().message_bar().geometry();
        QVERIFY(view.rect().contains(bar));
        QVERIFY2(bar.top() > view.height() / 2, qPrintable(QString::number(bar.top())));
        QCOMPARE(view.view_cube()->isVisible(), cube);
        if (cube) QVERIFY(!view.view_cube()->geometry().intersects(bar));
        // The part stays where it is; axes and scale stand above the message.
        constexpr int axes_height = 110;
        const QRect above(0, 0, before.width(), bar.top() - axes_height);
        const QImage after = view_picture(w());
        QCOMPARE(changed_pixels(before.copy(above), after.copy(above)), 0);
        QVERIFY(changed_pixels(before, after) > 100);
        shot(w(), QStringLiteral("sight-message-%1").arg(size.width()));
        w().message_bar().dismiss();
        QTest::qWait(30);
        QCOMPARE(view.view_cube()->isVisible(), cube);
        QCOMPARE(changed_pixels(before, view_picture(w())), 0);
    }

    /// Every kind of operation has a drawing and a line of words, in both palettes.
    void operations_have_pictures() {
        QVERIFY(open_part());
        for (const OperationKind& kind : operation_kinds()) {
            QVERIFY2(!ui::operation_words(kind.kind).isEmpty(), kind.kind.c_str());
            const QString name = QStringLiteral("operation_") + ui::text(kind.kind);
            const QImage light = ui::help_drawing(name, ui::light_palette(), 144, 1),
                         dark = ui::help_drawing(name, ui::dark_palette(), 144, 1);
            QVERIFY2(!light.isNull() && light != dark, kind.kind.c_str());
            const QPixmap wide = ui::operation_picture(kind.kind).pixmap(QSize(72, 72)),
                          small = ui::operation_picture(kind.kind).pixmap(QSize(16, 16));
            QVERIFY(wide.width() >= 72 && wide.height() < wide.width());
            QCOMPARE(small.size(), QSize(16, 16));
        }
        auto* add = w().tree().findChild<QToolButton*>(QStringLiteral("add"));
        for (QMenu* menu : {w().tree().add_operation_menu(), add->menu()})
            for (const ui::Theme theme : {ui::Theme::light, ui::Theme::dark}) {
                w().set_theme(theme);
                menu->popup(w().mapToGlobal(QPoint(100, 40)));
                QTest::qWait(30);
                const int height =
                    menu->actionGeometry(menu->actions().at(int(operation_kinds().size()) - 1)).height();
                shot(*menu, QStringLiteral("sight-operations-%1-%2")
                                .arg(menu == add->menu() ? QStringLiteral("add") : QStringLiteral("menu"))
                                .arg(ui::theme_name(theme)));
                // In machining order, and in one column of a small screen.
                QCOMPARE(menu->actions().front()->text(), QStringLiteral("Rough"));
                if (menu != add->menu())
                    QVERIFY2(height * int(operation_kinds().size()) < 590,
                             qPrintable(QString::number(height)));
                const QAction* last = menu->actions().back();
                const int sign = menu->actionGeometry(const_cast<QAction*>(last)).height();
                menu->close();
                QVERIFY2(height > 38, qPrintable(QString::number(height)));
                // Signs beside them are as small as elsewhere.
                if (menu == add->menu()) QVERIFY2(sign < 30, qPrintable(QString::number(sign)));
            }
        w().set_theme(ui::Theme::system);
    }
};

FACETMILL_TEST(TestWindowSight)
#include "test_window_sight.moc"
