// A million single facets against the reference. Cases are other ones than those of the default run.
#include "tests/support/test_runner.h"
#include "tests/unit/gouge/lift_check.h"

#include <QTest>

using namespace facetmill::test;

class TestAxialLiftSlow : public QObject {
    Q_OBJECT
private slots:
    void single_facets_data() {
        QTest::addColumn<int>("part");
        for (int part = 10; part < 110; ++part)
            QTest::addRow("%d", part) << part;
    }
    void single_facets() {
        QFETCH(int, part);
        const std::uint64_t begin = std::uint64_t(part) * 10'000;
        const LiftCheck check = check_lift_cases(begin, begin + 10'000);
        QVERIFY2(check.first_failure.isEmpty(), qPrintable(check.first_failure));
        QVERIFY(check.touched > 8'000);
    }
};

FACETMILL_TEST(TestAxialLiftSlow)
#include "test_axial_lift_slow.moc"
