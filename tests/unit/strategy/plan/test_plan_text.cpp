// What plans say: lengths, places and shares in the unit of the project.
#include "core/strategy/plan/plan_text.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;

class TestPlanText : public QObject {
    Q_OBJECT
private slots:
    void lengths_and_places() {
        const PlanText mm{LengthUnit::mm}, inch{LengthUnit::inch};
        QCOMPARE(mm(1.143), std::string("1.143 mm"));
        QCOMPARE(inch(1.143), std::string("0.045 in"));
        QCOMPARE(mm(Vec3(1, -2.5, 25.4)), std::string("(1, -2.5, 25.4) mm"));
        QCOMPARE(inch(Vec3(25.4, -50.8, 0)), std::string("(1, -2, 0) in"));
    }

    /// What is there is never told as nothing.
    void shares() {
        QCOMPARE(share_text(1, 4), std::string("25 %"));
        QCOMPARE(share_text(3, 3), std::string("100 %"));
        QCOMPARE(share_text(1, 1e9), std::string("0.001 %"));
    }
};

FACETMILL_TEST(TestPlanText)
#include "test_plan_text.moc"
