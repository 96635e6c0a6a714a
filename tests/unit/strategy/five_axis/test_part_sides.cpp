// Which places an axis comes to, by which leads, and what is said to be in the way elsewhere: on plates whose
// faces lean by a known angle.
#include "core/strategy/five_axis/part_sides.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const Vec3 plate_size(24, 16, 2);

/// A plate round a place, of which one face looks up at `angle` (degrees) from Z and the other down.
Mesh leaning_plate(double angle, const Vec3& at) {
    Mesh plate = box(-0.5 * plate_size, 0.5 * plate_size);
    const Eigen::AngleAxisd turn(radians(angle), Vec3::UnitX());
    for (Vec3& p : plate.vertices)
        p = turn * p + at;
    return plate;
}

Mesh joined(Mesh a, const Mesh& b) {
    const auto first = Index(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& facet : b.facets)
        a.facets.push_back({facet[0] + first, facet[1] + first, facet[2] + first});
    return a;
}

Tool long_ball(double holder_diameter, double shank_length) {
    Tool tool = ball_tool(4);
    tool.flute_length = 10;
    tool.shank_diameter = 4;
    tool.shank_length = shank_length;
    tool.holder = {{holder_diameter, 20}};
    return tool;
}

PartSides sides_of(const Mesh& part, const Tool& tool, const Finish5Settings& settings) {
    PlanContext context = context_of(part, tool);
    context.machine = find_machine("trunnion-ac");
    return find_sides(context, settings, Progress());
}

Finish5Settings fine() {
    Finish5Settings s;
    s.tolerance = 0.1;
    return s;
}

double blocked(const PartSides& sides, ReachBlock block) {
    double sum = 0;
    for (const UnreachedPiece& piece : sides.unreached)
        sum += piece.by_block[std::size_t(block)];
    return sum;
}

double wide(const PartSides& sides) {
    double sum = 0;
    for (const SidePiece& piece : sides.pieces)
        if (piece.lead_limits[1] > radians(45)) sum += piece.area;
    return sum;
}

const double face = plate_size.x() * plate_size.y(), rim = plate_size.x() * plate_size.z();

bool alike(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

} // namespace

class TestPartSides : public QObject {
    Q_OBJECT

private slots:
    /// The underside looks down at 140 degrees from Z, and the lower rim at 130; axes lean to 81, so that
    /// they ask for leads from 59 and 49 on.
    void an_underside_asks_for_wide_leads() {
        const Mesh part = leaning_plate(40, Vec3(0, 0, 10));
        const Tool tool = long_ball(10, 60);
        Finish5Settings s = fine();
        const PartSides all = sides_of(part, tool, s);
        QVERIFY(!all.top_only);
        QVERIFY(alike(wide(all), face + rim));
        QCOMPARE(all.unreached_area, 0.0);
        for (const SidePiece& piece : all.pieces) {
            if (piece.lead_limits[1] <= radians(45)) {
                QCOMPARE(piece.lead_limits, s.lead_limits);
                continue;
            }
            QCOMPARE(piece.lead_limits[1], s.reach_lead);
            QVERIFY(piece.lead_limits[0] > 0 && piece.lead_limits[0] <= s.lead_limits[1]);
        }
        // Without them it is left, and why is said.
        s.reach_lead = 0;
        const PartSides narrow = sides_of(part, tool, s);
        QCOMPARE(wide(narrow), 0.0);
        QVERIFY(alike(narrow.unreached_area, face + rim));
        QVERIFY(alike(blocked(narrow, ReachBlock::below), face + rim));
    }

    /// A sheet whose edge turns under by 140 degrees, 4 mm wide: too little to cut it side by side, and said.
    void an_edge_that_turns_under_is_told() {
        const double down = 4 * std::sin(radians(40)), in = 4 * std::cos(radians(40));
        Mesh sheet;
        sheet.vertices = {Vec3(0, 0, 10),   Vec3(100, 0, 10),       Vec3(100, 100, 10),
                          Vec3(0, 100, 10), Vec3(0, in, 10 - down), Vec3(100, in, 10 - down)};
        sheet.facets = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 1}};
        const PartSides sides = sides_of(sheet, long_ball(10, 60), fine());
        QVERIFY(sides.top_only);
        QVERIFY2(alike(sides.far_area, 400), qPrintable(QString::number(sides.far_area)));
        QVERIFY(sides.far_place.z() < 10);
        Finish5Settings wide_limits = fine();
        wide_limits.lead_limits[1] = radians(85);
        const PartSides whole = sides_of(sheet, long_ball(10, 60), wide_limits);
        QVERIFY(!whole.top_only && whole.unreached_area == 0);
        sheet.facets.resize(2);
        QCOMPARE(sides_of(sheet, long_ball(10, 60), fine()).far_area, 0.0);
    }

    /// Between two plates 2 mm apart, one over the other, a ball of 4 mm has no room; 12 mm apart it has.
    void a_blade_behind_another_is_reached_where_there_is_room() {
        const Vec3 normal(0, -std::sin(radians(40)), std::cos(radians(40)));
        const auto two = [&](double apart) {
            return joined(leaning_plate(40, Vec3(0, 0, 10)),
                          leaning_plate(40, Vec3(0, 0, 10) + (plate_size.z() + apart) * normal));
        };
        const Tool tool = long_ball(10, 60);
        const PartSides close = sides_of(two(2), tool, fine());
        QVERIFY(alike(blocked(close, ReachBlock::cutter), 2 * face));
        QVERIFY(alike(close.unreached_area, 2 * face));
        const PartSides apart = sides_of(two(12), tool, fine());
        QCOMPARE(apart.unreached_area, 0.0);
    }

    void holder_and_machine_are_told_from_the_part() {
        const Mesh part = leaning_plate(40, Vec3(0, 0, 10));
        const PartSides held = sides_of(part, long_ball(60, 1), fine());
        QVERIFY(held.unreached_area > 0.2 * face);
        QVERIFY(alike(blocked(held, ReachBlock::holder), held.unreached_area));
        // A head that leans by 30 degrees at most; the part has room for more.
        PlanContext context = context_of(part, long_ball(10, 60));
        context.machine = find_machine("trunnion-ac");
        context.machine.rotary[0].travel = {radians(-30), radians(30)};
        const PartSides stiff = find_sides(context, fine(), Progress());
        QVERIFY(alike(blocked(stiff, ReachBlock::machine), face + rim));
    }
};

FACETMILL_TEST(TestPartSides)
#include "test_part_sides.moc"
