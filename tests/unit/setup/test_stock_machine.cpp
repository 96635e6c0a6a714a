// Stock boxes and machines.
#include "core/setup/machine.h"
#include "core/setup/stock.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <set>

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
        QVERIFY_THROWS_EXCEPTION(Error, view.set("kind", std::string("ball")));
        QVERIFY_THROWS_EXCEPTION(Error, view.set("diameter", 0.0));
        QVERIFY_THROWS_EXCEPTION(Error, view.set("diameter", std::string("round")));
        QCOMPARE(spec.margin[0], 25.4);
    }

    void every_kind_has_its_keys() {
        // Every key belongs to some kind, and every kind knows its own name.
        std::set<std::string> all;
        for (const auto kind : {StockSpec::Kind::box, StockSpec::Kind::cylinder, StockSpec::Kind::mesh}) {
            StockSpec spec;
            ParameterView<StockSpec>(spec, stock_parameters()).set("kind", stock_kind_name(kind));
            QVERIFY(spec.kind == kind);
            for (const std::string& key : stock_keys(kind)) {
                QVERIFY(stock_parameters().find(key));
                all.insert(key);
            }
        }
        QCOMPARE(all.size(), stock_parameters().entries().size());
    }

    void cylinders_stand_round_the_part() {
        Box3 part;
        part.add(Vec3(-1, 2, 3));
        part.add(Vec3(9, 26, 33));
        const std::array<double, 3> reach{19, 16, 13}; // of the box's corners about x, y, z at most
        StockSpec spec;
        spec.kind = StockSpec::Kind::cylinder;
        spec.margin = {1, 2, 4};
        StockCylinder c = stock_cylinder(spec, part, reach);
        QCOMPARE(c.axis, 2);
        QCOMPARE(c.radius, 15.0); // 13 and the larger of 1 and 2
        QCOMPARE(c.needed, 13.0);
        QVERIFY(c.box.lo == Vec3(4 - 15, 14 - 15, 3)); // the bottom is the part's
        QVERIFY(c.box.hi == Vec3(4 + 15, 14 + 15, 37));
        spec.axis = StockSpec::Axis::x;
        c = stock_cylinder(spec, part, reach);
        QCOMPARE(c.radius, 23.0);
        QVERIFY(c.box.lo == Vec3(-2, 14 - 23, 18 - 23));
        QVERIFY(c.box.hi == Vec3(10, 14 + 23, 18 + 23));
        spec.axis = StockSpec::Axis::y;
        spec.diameter = {20, {}};
        c = stock_cylinder(spec, part, reach);
        QCOMPARE(c.axis, 1);
        QCOMPARE(c.radius, 10.0);
        QCOMPARE(c.needed, 16.0);
        QVERIFY(c.box.lo == Vec3(4 - 10, 0, 18 - 10));
        QVERIFY(c.box.hi == Vec3(4 + 10, 28, 18 + 10));
        QVERIFY(stock_cylinder(spec, Box3(), reach).box.empty());
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
