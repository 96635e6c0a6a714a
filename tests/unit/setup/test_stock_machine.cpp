// Stock boxes and machines.
#include "core/setup/machine.h"
#include "core/setup/stock.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;

class TestStockMachine : public QObject {
    Q_OBJECT
private slots:

    void stock_grows_sideways_and_up() {
        Box3 part;
        part.add(Vec3(-1, 2, 3));
        part.add(Vec3(10, 20, 30));
        StockSpec spec;
        QVERIFY(stock_box(spec, part).lo == part.lo && stock_box(spec, part).hi == part.hi);
        spec.margin = {1, 2, 4};
        const Box3 box = stock_box(spec, part);
        QVERIFY(box.lo == Vec3(-2, 0, 3)); // the bottom is the part's
        QVERIFY(box.hi == Vec3(11, 22, 34));
        QVERIFY(stock_box(spec, Box3()).empty());
    }

    void margins_are_checked() {
        StockSpec spec;
        ParameterView<StockSpec> view(spec, stock_parameters());
        view.set("margin", view.parameter("margin").parse("1, 0, 2", LengthUnit::inch));
        QCOMPARE(spec.margin[2], 50.8);
        QVERIFY_THROWS_EXCEPTION(Error, view.set("margin", std::array<double, 3>{0, -1, 0}));
        QVERIFY_THROWS_EXCEPTION(Error, view.set("kind", std::string("cylinder")));
        QCOMPARE(spec.margin[0], 25.4);
    }

    void machines_are_found_by_name() {
        QVERIFY(machines().size() >= 2);
        for (const Machine& m : machines()) {
            QCOMPARE(find_machine(m.name).label, m.label);
            QVERIFY((m.rapid_mm_per_s.array() > 0).all());
        }
        // Lu 3.5.5.2.
        QVERIFY(find_machine("tarus-tpi-2000").rapid_mm_per_s == Vec3(170, 180, 240));
        try {
            find_machine("taurus");
            QFAIL("an unknown machine was found");
        } catch (const Error& e) {
            QCOMPARE(e.code(), ErrorCode::missing_reference);
            QVERIFY(std::string(e.what()).find("tarus-tpi-2000") != std::string::npos);
        }
    }
};

FACETMILL_TEST(TestStockMachine)
#include "test_stock_machine.moc"
