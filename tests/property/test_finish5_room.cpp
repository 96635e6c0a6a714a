// Finishing with five axes where there is little room: channels that only axes between the nodes of a coarse
// grid fit into, leads between its nodes that clear the widest strips, and the foot of a wall close over the
// bottom of the stock.
#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/low_passes.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/plan/stock_bottom.h"
#include "tests/property/five_axis_plan.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

void add_plate(Mesh& mesh, const Vec3& at, const Vec3& along, const Vec3& across) {
    const auto first = Index(mesh.vertices.size());
    for (const Vec3& p : {at, Vec3(at + along), Vec3(at + along + across), Vec3(at + across)})
        mesh.vertices.push_back(p);
    mesh.facets.push_back({first, first + 1, first + 2});
    mesh.facets.push_back({first, first + 2, first + 3});
}

/// A floor along X between two walls that lean by `lean` to +Y.
Mesh leaning_channel(double width, double depth, double lean) {
    const double half = 0.5 * width, length = 24;
    const Vec3 up = depth * Vec3(0, std::sin(lean), std::cos(lean)), along(length, 0, 0);
    Mesh mesh;
    add_plate(mesh, Vec3(-0.5 * length, -half, 0), along, Vec3(0, width, 0));
    add_plate(mesh, Vec3(-0.5 * length, -half, 0), up, along);
    add_plate(mesh, Vec3(-0.5 * length, half, 0), along, up);
    return mesh;
}

double nearest_centre(const std::vector<Vec3>& centres, const Vec3& p) {
    double least = infinity;
    for (const Vec3& c : centres)
        least = std::min(least, (c - p).norm());
    return least;
}

} // namespace

class TestFinish5Room : public QObject {
    Q_OBJECT
private slots:
    /// Walls 14 mm high and 7.6 mm apart leave the ball axes about 8 degrees from Z; the grid has 0 and 15.
    void axes_between_the_nodes_of_a_coarse_grid_are_found() {
        const Mesh part = leaning_channel(7.6, 14, radians(8));
        const PlanContext context = five_axis_context(part, ball_tool(6));
        Finish5Settings s;
        s.tolerance = 0.1;
        s.direction = {0, "x"};
        s.sides = Finish5Settings::Sides::top;
        s.grid_step = radians(16);
        // To the left alone, or an axis that leans along the channel would do.
        s.yaw_limits = {radians(80), radians(100)};
        s.pattern = Finish5Settings::Pattern::oneway;
        s.stepover = {0.5, ""};
        const Finish5 op(s);
        const StrategyResult path = op.plan(context, Progress());
        // In the middle of the floor, where the walls leave the ball room, every contact has a posture.
        std::size_t in_channel = 0;
        for (const FiveAxisRecord::Point& p : path.five_axis()->points) {
            if (std::abs(p.place.surface.y()) > 0.5 || p.place.surface.z() > 1e-6) continue;
            ++in_channel;
            QVERIFY(p.choice.free);
        }
        QVERIFY2(in_channel > 10, qPrintable(QString::number(in_channel)));
        std::vector<Vec3> centres;
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl)
                centres.push_back(c.tip + 3 * c.axis);
        for (double x = -10; x <= 10; x += 0.5)
            QVERIFY2(nearest_centre(centres, Vec3(x, 0, 0)) < 3.2, qPrintable(QString::number(x)));
        const Verification v = judged(part, context, linked(path, context, op), 0.1, path.chord_tolerance);
        QVERIFY(!v.gouged());
    }

    /// Along a trough of 40 mm a flat end of 6 mm clears most with a lead of 4.3 degrees. The grid has 0,
    /// with which it cuts the sides, and 8.
    void strips_as_wide_as_a_lead_between_two_nodes_clears_are_cut_whole() {
        const Mesh part = height_field([](double, double y) { return 40 - std::sqrt(1600 - y * y); },
                                       Vec2(-10, -8), Vec2(10, 8), 10, 96);
        const PlanContext context = five_axis_context(part, cutter("flat"));
        Finish5Settings s;
        s.tolerance = 0.05;
        s.direction = {0, "x"};
        s.sides = Finish5Settings::Sides::top;
        s.grid_step = radians(8);
        s.lead_limits = {0, radians(40)};
        s.yaw_limits = {0, 0};
        const Finish5 op(s);
        const StrategyResult path = op.plan(context, Progress());
        QCOMPARE(path.cleanup_points, std::size_t(0));
        QVERIFY(path.stepover_max > 2.5);
        const Verification v =
            judged(part, context, linked(path, context, op), s.tolerance, path.chord_tolerance);
        QVERIFY(!v.gouged());
        QVERIFY2(v.figures.excess_p999 <= 1.05 * s.tolerance,
                 qPrintable(QString::number(v.figures.excess_p999)));
        QCOMPARE(v.figures.uncut_fraction, 0.0);
    }

    /// Square to an upright wall the tool clears a strip as wide as its flat, and would be level with the
    /// ground there: strips are as wide as axes clear them that stay over it.
    void walls_are_cut_whole_by_axes_that_stay_over_the_ground() {
        const Mesh part = facetmill::test::box(Vec3(-8, -2, 0), Vec3(8, 2, 12));
        PlanContext context = five_axis_context(part, cutter("bull"));
        context.machine = find_machine("trunnion-ac");
        Finish5Settings s;
        s.tolerance = 0.1;
        s.grid_step = radians(4);
        const StrategyResult path = Finish5(s).plan(context, Progress());
        const std::size_t points = path.five_axis()->points.size();
        QVERIFY(points > 200);
        QVERIFY2(50 * path.cleanup_points <= points,
                 qPrintable(QString("%1 of %2").arg(path.cleanup_points).arg(points)));
    }

    /// An upright plate whose foot is half a radius over the bottom of the stock: a ball that touches it
    /// lower than a radius over that bottom would be below it.
    void walls_are_cut_down_to_where_the_lowest_ball_leaves_little() {
        const Box3 box{Vec3(-8, -2, 0), Vec3(8, 2, 12)};
        const Mesh part = facetmill::test::box(box.lo, box.hi);
        PlanContext context = five_axis_context(part, with_holder(ball_tool(6)));
        context.machine = find_machine("trunnion-ac");
        const double bottom = -1.5;
        context.stock_box.lo.z() = bottom;
        Finish5Settings s;
        s.tolerance = 0.3;
        s.grid_step = radians(6);
        const Finish5 op(s);
        StrategyResult path = op.plan(context, Progress());
        raise_low_passes(path, context, op.common(), op.holder_clearance());
        keep_above_bottom(path, context, op.common());
        std::vector<Vec3> centres;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 1; i < pass.cl.size(); ++i)
                for (int k = 0; k <= 8; ++k) {
                    const CutterLocation at = location_on_route(pass.cl[i - 1], pass.cl[i], k / 8.0);
                    centres.push_back(at.tip + 3 * at.axis);
                    const Vec3 nearest = centres.back().cwiseMax(box.lo).cwiseMin(box.hi);
                    QVERIFY((centres.back() - nearest).norm() >= 3 - path.chord_tolerance);
                    QVERIFY(centres.back().z() - 3 >= bottom - path.chord_tolerance);
                }
        // The lowest ball that touches the wall, its centre 1.5 mm over the foot.
        const double level = bottom + 3;
        for (const double side : {-1.0, 1.0})
            for (double x = -7; x <= 7; x += 0.5)
                for (double z = 0.1; z < 11; z += 0.2) {
                    const double leaves = std::hypot(3.0, std::max(0.0, level - z)) - 3;
                    QVERIFY2(nearest_centre(centres, Vec3(x, 2 * side, z)) <= 3 + leaves + 1.05 * s.tolerance,
                             qPrintable(QString("%1 %2 %3").arg(x).arg(side).arg(z)));
                }
        QVERIFY(std::any_of(path.warnings.begin(), path.warnings.end(), [](const std::string& w) {
            return w.starts_with("the leaning cutter is kept from going below");
        }));
        const Verification v =
            judged(part, context, linked(path, context, op), s.tolerance, path.chord_tolerance);
        QVERIFY(!v.gouged());
    }
};

FACETMILL_TEST(TestFinish5Room)
#include "test_finish5_room.moc"
