// A million single facets against the reference. Cases are other ones than those of the default run.
#include "core/base/tolerances.h"
#include "tests/property/vector_check.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill::test;

class TestContactKernelSlow : public QObject {
    Q_OBJECT
private slots:
    void single_facets_data() {
        QTest::addColumn<int>("part");
        for (int part = 1; part <= 10; ++part)
            QTest::addRow("%d", part) << part;
    }
    void single_facets() {
        QFETCH(int, part);
        const std::uint64_t begin = std::uint64_t(part) * 100'000;
        const VectorCheck check = check_vector_cases(begin, begin + 100'000, 16, 1000);
        QVERIFY2(check.first_failure.isEmpty(), qPrintable(check.first_failure));
        QVERIFY(check.worst <= facetmill::tolerance::lift_accuracy);
        QVERIFY(check.touched > 75'000);
        QVERIFY(check.borderline < 2'000);
    }
};

FACETMILL_TEST(TestContactKernelSlow)
#include "test_contact_kernel_slow.moc"
