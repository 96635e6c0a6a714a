// Free postures between the nodes of a coarse grid: in wells about a random axis, which leave a tool a few
// degrees of room.
#include "core/cspace/between_nodes.h"
#include "core/cspace/choose.h"

#include "tests/support/test_runner.h"
#include "tests/unit/cspace/cspace_cases.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A ring of walls about an axis through the centre of a ball of 10 that stands on a level floor.
Mesh well_about(const Vec3& axis, double radius, double depth) {
    constexpr int sides = 16;
    Mesh mesh = level_plane(3);
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    const auto at = [&](int k) -> Vec3 {
        const double angle = 2 * pi * k / sides;
        return Vec3(0, 0, 5) + radius * (std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int k = 0; k < sides; ++k)
        add_quad(mesh, at(k), at(k + 1), at(k + 1) + depth * axis, at(k) + depth * axis);
    return mesh;
}

std::size_t free_nodes(const CSpace& space) {
    return std::size_t(std::count(space.block.begin(), space.block.end(), PostureBlock::free));
}

} // namespace

class TestBetweenNodes : public QObject {
    Q_OBJECT
private slots:
    void what_a_coarse_grid_misses_is_found() {
        const auto curves = beside(0.3, 0.1);
        Random rng(11);
        int cases = 0, found_cases = 0, hopeless = 0;
        for (int i = 0; i < 300; ++i) {
            const double lean = radians(uniform(rng, 0, 40)), turn = uniform(rng, -pi, pi);
            const Vec3 axis(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean));
            // The walls end 20 over the ball's centre and leave it up to 6 degrees to every side.
            Bench bench(well_about(axis, uniform(rng, 5.0, 7.2), 20), tool_of(10, 5, 40, 10, 5, 10));
            bench.grid = PostureGrid::make(0, radians(60), -pi, pi, radians(16));
            const CSpaceBuilder builder(bench.input);
            const ContactFrame frame;
            const CSpace coarse = builder.build(frame, curves);
            if (free_nodes(coarse) > 0) continue;
            const auto found = free_between_nodes(builder, coarse, curves);
            QVERIFY(found.size() <= 4);
            for (const PostureValue& p : found) {
                const auto reason = builder.reason(frame, p.lead, p.yaw, curves);
                QCOMPARE(int(reason.block), int(PostureBlock::free));
                QVERIFY(p.delta >= reason.bottom - 1e-9 && p.delta <= reason.top);
            }
            // By a grid that is asked everywhere.
            const PostureGrid fine = PostureGrid::make(0, radians(60), -pi, pi, radians(2));
            CSpaceInput input = bench.input;
            input.grid = &fine;
            const std::size_t room = free_nodes(CSpaceBuilder(input).build(frame, curves));
            if (room == 0) {
                hopeless += found.empty() ? 1 : 0;
                continue;
            }
            if (room < 6) continue; // hardly any
            ++cases;
            found_cases += found.empty() ? 0 : 1;
        }
        QVERIFY2(cases >= 60, qPrintable(QString::number(cases)));
        QVERIFY2(found_cases >= 0.9 * cases, qPrintable(QString("%1 of %2").arg(found_cases).arg(cases)));
        QVERIFY2(hopeless > 0, qPrintable(QString::number(hopeless)));
    }

    /// A grid as fine as usual has all axes that would be looked at.
    void a_fine_grid_is_not_searched() {
        Bench bench(well_about(Vec3(0.1, 0.05, 1).normalized(), 5.5, 20), tool_of(10, 5, 40, 10, 5, 10));
        bench.grid = PostureGrid::make(0, radians(60), -pi, pi, radians(3));
        const CSpaceBuilder builder(bench.input);
        const auto curves = beside(0.3, 0.1);
        CSpace space = builder.build(ContactFrame(), curves);
        std::fill(space.block.begin(), space.block.end(), PostureBlock::global);
        QVERIFY(free_between_nodes(builder, space, curves).empty());
    }

    /// The global choice takes them, in a pass with points that have free nodes as well.
    void the_global_choice_takes_them() {
        const Vec3 axis = Vec3(std::sin(radians(8)), 0, std::cos(radians(8)));
        Bench bench(well_about(axis, 6.4, 20), tool_of(10, 5, 40, 10, 5, 10));
        bench.grid = PostureGrid::make(0, radians(60), -pi, pi, radians(16));
        const CSpaceBuilder builder(bench.input);
        const auto curves = beside(0.3, 0.1);
        const ContactFrame frame;
        const CSpace space = builder.build(frame, curves);
        QCOMPARE(free_nodes(space), std::size_t(0));
        PassPoint point;
        point.frame = frame;
        point.space = &space;
        point.curves = &curves;
        ChooseInput input;
        input.builder = &builder;
        const std::vector<PassPoint> without{point, point};
        for (const ChosenPosture& c : choose_global(without, input, Progress()))
            QVERIFY(!c.free);
        point.between = free_between_nodes(builder, space, curves);
        QVERIFY(!point.between.empty());
        const std::vector<PassPoint> with{point, point};
        for (const ChosenPosture& c : choose_global(with, input, Progress())) {
            QVERIFY(c.free);
            const auto reason = builder.reason(frame, c.posture.lead, c.posture.yaw, curves);
            QCOMPARE(int(reason.block), int(PostureBlock::free));
        }
    }
};

FACETMILL_TEST(TestBetweenNodes)
#include "test_between_nodes.moc"
