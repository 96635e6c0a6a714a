// The divide of steep and shallow in the window: seen as a colour, moved by form and handle.
#include "tests/screenshot/window_support.h"
#include "ui/controllers.h"
#include "ui/divide_bar.h"
#include "ui/elided_label.h"
#include "ui/project_tree.h"
#include "ui/theme.h"
#include "ui/viewport.h"

#include <QSlider>
#include <QStyle>
#include <QTest>
#include <QUndoStack>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using namespace facetmill::ui;

class TestWindowDivide : public QObject, public WindowFixture {
    Q_OBJECT

    DivideBar* bar() { return w().findChild<DivideBar*>(QStringLiteral("divide_bar")); }
    double divide() { return std::get<double>(w().document().operation(1).get("divide")) * 180 / pi; }
    bool add_operation() {
        if (!open_part()) return false;
        w().document().add_operation("steep_shallow");
        w().tree().select({TreeNode::Kind::operation, 1});
        return wait_until_settled(w());
    }
    /// Where the handle is for so many degrees.
    QPoint handle(int degrees) {
        QSlider& slider = *bar()->slider();
        const int length = slider.style()->pixelMetric(QStyle::PM_SliderLength, nullptr, &slider);
        const int along = QStyle::sliderPositionFromValue(slider.minimum(), slider.maximum(), degrees,
                                                          slider.width() - length);
        return {along + length / 2, slider.height() / 2};
    }
    QString readout() { return bar()->readout()->text(); }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void the_divide_is_seen_and_dragged() {
        QVERIFY(add_operation());
        QCOMPARE(w().document().operation(1).kind(), std::string_view("steep_shallow"));
        QVERIFY(bar()->isVisible());
        QCOMPARE(bar()->slider()->value(), 40);
        QVERIFY2(readout().contains(QStringLiteral("40°")), qPrintable(readout()));
        const QImage before = view_picture(w());
        shot(w(), QStringLiteral("divide-40"));
        // Held, the view follows; let go, it is one step of the history.
        const int steps = w().document().undo_stack().count();
        QTest::mousePress(bar()->slider(), Qt::LeftButton, {}, handle(40));
        for (const int degrees : {35, 25, 12})
            QTest::mouseMove(bar()->slider(), handle(degrees));
        QVERIFY(bar()->slider()->isSliderDown());
        QVERIFY(wait_until_settled(w()));
        const int to = bar()->slider()->value();
        QVERIFY2(std::abs(to - 12) <= 1, qPrintable(readout()));
        QVERIFY2(readout().contains(QStringLiteral("%1°").arg(to)), qPrintable(readout()));
        const QImage dragged = view_picture(w());
        QVERIFY(changed_pixels(before, dragged) > 2000);
        QCOMPARE(w().document().undo_stack().count(), steps);
        QTest::mouseRelease(bar()->slider(), Qt::LeftButton, {}, handle(12));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(w().document().undo_stack().count(), steps + 1);
        QVERIFY(std::abs(divide() - to) < 1e-9);
        shot(w(), QStringLiteral("divide-low"));
        // The form says the same, and the other way round.
        enter(w(), "divide", QStringLiteral("60"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(bar()->slider()->value(), 60);
        QVERIFY2(readout().contains(QStringLiteral("60°")), qPrintable(readout()));
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(bar()->slider()->value(), to);
        QVERIFY(changed_pixels(dragged, view_picture(w())) < 200);
        w().document().undo_stack().undo();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(std::abs(divide() - 40) < 1e-9);
        QVERIFY(changed_pixels(before, view_picture(w())) < 200);
        w().document().undo_stack().redo();
        QVERIFY(wait_until_settled(w()));
        // A key is a step as well.
        QTest::keyClick(bar()->slider(), Qt::Key_Right);
        QVERIFY(wait_until_settled(w()));
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(divide() - to - 1) < 1e-9, patience_ms);
        // Elsewhere it is gone.
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!bar()->isVisible());
        QVERIFY(changed_pixels(dragged, view_picture(w())) > 2000);
    }

    /// The sides keep to the operation's boundary, which they stand for.
    void the_divide_keeps_to_the_boundary() {
        QVERIFY(add_operation());
        const QImage everywhere = view_picture(w());
        w().document().change(QStringLiteral("Boundary"), [](Project& p) {
            Boundary level;
            level.name = "Level";
            level.kind = Boundary::Kind::slope;
            level.slope = {0, radians(12)};
            p.boundaries = {level};
            p.operations.at(1)->set("boundary", std::string("Level"));
        });
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(everywhere, view_picture(w())) > 2000);
        shot(w(), QStringLiteral("divide-boundary"));
    }

    void it_fits_a_small_dark_window() {
        QVERIFY(add_operation());
        const QImage light = view_picture(w());
        w().set_theme(Theme::dark);
        w().resize(800, 600);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(changed_pixels(light, view_picture(w())) > 2000);
        QVERIFY(bar()->isVisible() && bar()->slider()->width() >= 80);
        QVERIFY(w().rect().contains(QRect(bar()->mapTo(&w(), QPoint()), bar()->size())));
        shot(w(), QStringLiteral("divide-dark"));
        w().set_theme(Theme::light);
    }
};

FACETMILL_TEST(TestWindowDivide)
#include "test_window_divide.moc"
