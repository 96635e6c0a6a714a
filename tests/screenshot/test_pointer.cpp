// Drags, clicks and a resting pointer, as all views that are dragged understand them.
#include "tests/support/test_runner.h"
#include "ui/pointer.h"

#include <QList>
#include <QTest>

using namespace facetmill::ui;

namespace {

enum class Drag { none, turn };

QMouseEvent moved_to(double x, double y, Qt::MouseButtons held = Qt::LeftButton) {
    return QMouseEvent(QEvent::MouseMove, QPointF(x, y), QPointF(x, y), Qt::NoButton, held, Qt::NoModifier);
}

} // namespace

class TestPointer : public QObject {
    Q_OBJECT
private slots:
    void a_click_does_not_drag() {
        PointerDrag<Drag> drag{click_slack};
        QVERIFY(!drag);
        drag.begin(Drag::turn, {10, 10});
        QVERIFY(!drag.travel(moved_to(12, 12)));
        QVERIFY(drag && !drag.moved());
        QCOMPARE(drag.end(), Drag::turn);
        QVERIFY(!drag);
        QVERIFY(!drag.moved());
    }

    void a_drag_tells_every_stretch_once() {
        PointerDrag<Drag> drag{click_slack};
        drag.begin(Drag::turn, {10, 10});
        QVERIFY(!drag.travel(moved_to(12, 10)));
        QCOMPARE(drag.travel(moved_to(16, 10)), QPointF(6, 0)); // the slack is made up for
        QCOMPARE(drag.travel(moved_to(15, 12)), QPointF(-1, 2));
        QCOMPARE(drag.travel(moved_to(10, 10)), QPointF(-5, -2)); // back at the press it is still a drag
        QVERIFY(drag.moved());
        QCOMPARE(drag.press(), QPointF(10, 10));
        drag.end();
        QVERIFY(!drag.travel(moved_to(30, 30)));
        drag.begin(Drag::turn, {0, 0});
        QVERIFY(!drag.moved());
    }

    void without_slack_it_moves_at_once() {
        PointerDrag<Drag> drag{0};
        drag.begin(Drag::turn, {10, 10});
        QCOMPARE(drag.travel(moved_to(10.5, 10)), QPointF(0.5, 0));
    }

    void a_release_that_went_elsewhere_ends_it() {
        PointerDrag<Drag> drag{0};
        drag.begin(Drag::turn, {10, 10});
        QVERIFY(!drag.travel(moved_to(40, 40, Qt::NoButton)));
        QVERIFY(!drag);
        QCOMPARE(drag.end(), Drag::none);
    }

    void a_resting_pointer_is_told_once() {
        QList<QPointF> told;
        PointerRest rest{[&](const QPointF& at) { told << at; }};
        rest.moved({1, 1});
        rest.moved({2, 2});
        QTRY_COMPARE_WITH_TIMEOUT(told, QList<QPointF>{QPointF(2, 2)}, facetmill::test::patience_ms);
        rest.moved({3, 3});
        rest.stop();
        QTest::qWait(150);
        QCOMPARE(told.size(), 1);
    }
};

FACETMILL_TEST(TestPointer)
#include "test_pointer.moc"
