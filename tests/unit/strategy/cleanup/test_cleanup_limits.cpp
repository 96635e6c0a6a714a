// The constants by which clean-up keeps clear of the part and sees what is left, at half and at double: at
// half nothing is worse; at double it stays within what the constants promise, and beyond that the checks see
// it.
#include "core/strategy/cleanup/body_clearance.h"
#include "core/strategy/cleanup/pass_clearing.h"
#include "tests/support/test_runner.h"
#include "tests/unit/strategy/cleanup/cutter_over.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

QString told(double share, double found) {
    return QString("at %1: %2").arg(share).arg(found);
}

} // namespace

class TestCleanupLimits : public QObject {
    Q_OBJECT
private slots:
    /// Straight moves over waves, from tip to tip far apart.
    void moves_keep_clear_of_the_part() {
        const Mesh part =
            height_field([](double x, double y) { return 0.4 * std::sin(1.3 * x) * std::cos(y); },
                         Vec2(-15, -10), Vec2(15, 10), 120, 80);
        const CutterOver ball(part, ball_tool(4));
        const AxialLift& lift = ball.lift;
        StripCutting with = ball.cutting();
        std::vector<Pass> passes;
        for (int line = -4; line <= 4; ++line) {
            Pass pass;
            for (double x = -13; x <= 13; x += 2.6) {
                const AxialContact c = lift.contact(x, 1.7 * line + 0.1 * x);
                const Vec3 tip(x, 1.7 * line + 0.1 * x, c.tip_z);
                pass.cl.push_back({tip, Vec3::UnitZ()});
                pass.cc.push_back(
                    {c.point, ball.cover.contact_normal(c.point - tip).value_or(Vec3::UnitZ())});
            }
            passes.push_back(pass);
        }
        const auto deepest = [&](double share) {
            std::vector<Pass> cleared = passes;
            clear_passes(with, cleared, Progress(), {share});
            double most = 0;
            for (const Pass& pass : cleared)
                for (std::size_t i = 1; i < pass.cl.size(); ++i) {
                    const Vec3 &a = pass.cl[i - 1].tip, &b = pass.cl[i].tip;
                    const int parts = 2 + int((b - a).norm() / 0.003);
                    for (int k = 1; k < parts; ++k) {
                        const Vec3 tip = a + double(k) / parts * (b - a);
                        most = std::max(most, lift.tip_z(tip.x(), tip.y()) - tip.z());
                    }
                }
            return most;
        };
        const double usual = Clearing().dip_share;
        for (const auto& [factor, allowed] : {std::pair(0.5, 1.0), {1.0, 1.0}, {2.0, 2.0}}) {
            const double most = deepest(factor * usual);
            qInfo("%s", qPrintable(told(factor, most)));
            QVERIFY2(most <= allowed * with.chord, qPrintable(told(factor, most)));
        }
        QVERIFY(deepest(4 * usual) > with.chord);
    }

    /// A tall thin post beside a long straight move: the ball passes it, the holder above it does not, and at
    /// both ends of the move the holder is free.
    void holders_are_looked_at_between_points() {
        const auto post = [](double x, double y) {
            return 40 * std::max(0.0, 1 - std::abs(x) - std::abs(y - 6));
        };
        Tool tool = ball_tool(4);
        tool.flute_length = 10;
        tool.shank_diameter = 4;
        tool.shank_length = 10;
        tool.holder = {{20, 20}};
        const Mesh part = height_field(post, Vec2(-40, -12), Vec2(40, 12), 160, 48);
        PlanContext context = context_of(part, tool);
        context.further_tools = {tool};
        const CleanupSettings settings;
        const CleanupJob job(settings, context, Progress());
        Pass pass;
        for (const double x : {-38.0, -30.0, 30.0, 38.0}) {
            pass.cl.push_back({Vec3(x, 0, 0), Vec3::UnitZ()});
            pass.cc.push_back({Vec3(x, 0, 0), Vec3::UnitZ()});
        }
        const ClearedPasses beside = with_clear_body(job, {pass}, Progress());
        QCOMPARE(beside.held, 60.0);
        QCOMPARE(beside.held_by, ToolBody::holder);
        QCOMPARE(beside.passes.size(), std::size_t(2));
        for (const Pass& kept : beside.passes)
            QCOMPARE(kept.cl.size(), std::size_t(2));
        for (CutterLocation& l : pass.cl)
            l.tip.y() = -8; // far enough from the post
        const ClearedPasses past = with_clear_body(job, {pass}, Progress());
        QCOMPARE(past.held, 0.0);
        QCOMPARE(past.passes.size(), std::size_t(1));
    }

    /// Grooves in which a ball leaves little more than the tolerance, each turned another way.
    void narrow_valleys_are_seen() {
        const double r = 5, tolerance = 0.05;
        const double slope = std::tan(std::acos(r / (r + 1.3 * tolerance)));
        for (const double turn : {0.0, 0.3, 1.1}) {
            Mesh part = height_field([&](double, double y) { return slope * std::abs(y); }, Vec2(-20, -20),
                                     Vec2(20, 20), 80, 80);
            for (Vec3& v : part.vertices)
                v = Vec3(std::cos(turn) * v.x() - std::sin(turn) * v.y(),
                         std::sin(turn) * v.x() + std::cos(turn) * v.y(), v.z());
            const CutterOver ball(part, ball_tool(2 * r));
            ValleyInput in = ball.valleys(tolerance);
            const double usual = in.sample_share;
            const auto length = [&](double share) {
                in.sample_share = share;
                double sum = 0;
                for (const ValleyCurve& c : find_valleys(in, Progress()).curves)
                    for (std::size_t i = 1; i < c.points.size(); ++i)
                        sum += (c.points[i].center - c.points[i - 1].center).norm();
                return sum;
            };
            for (const double factor : {0.5, 1.0, 2.0}) {
                const double found = length(factor * usual);
                qInfo("turned by %g, %s", turn, qPrintable(told(factor, found)));
                QVERIFY2(found > 32, qPrintable(told(factor, found)));
            }
        }
    }
};

FACETMILL_TEST(TestCleanupLimits)
#include "test_cleanup_limits.moc"
