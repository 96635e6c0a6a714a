// Steep and shallow against what is known of a part, and against a naive check: who cuts which slopes, that
// both together leave no more than the tolerance, and that nothing is gouged.
#include "core/strategy/steep_shallow/steep_shallow.h"
#include "core/strategy/surface/slope_facets.h"
#include "tests/property/shapes.h"
#include "tests/support/any_threads.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/naive_finish.h"
#include "tests/support/test_runner.h"
#include "tests/support/told.h"
#include "tests/support/trials.h"

#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

SteepShallowSettings divided_at(double degrees, double overlap = 5) {
    SteepShallowSettings s;
    s.tolerance = 0.1;
    s.divide = radians(degrees);
    s.overlap = radians(overlap);
    return s;
}

StrategyResult planned_on(const Mesh& mesh, const SteepShallowSettings& settings, const Tool& tool) {
    return SteepShallow(settings).plan(context_of(mesh, tool), Progress());
}

double slope_of(const Vec3& normal) {
    return std::acos(std::clamp(normal.z(), -1.0, 1.0));
}

/// The passes of one course alone.
StrategyResult course(const StrategyResult& path, bool levels) {
    StrategyResult own = path;
    std::erase_if(own.passes, [&](const Pass& p) { return (p.layer >= 0) != levels; });
    return own;
}

} // namespace

class TestSteepShallow : public QObject {
    Q_OBJECT
private slots:
    void it_is_described() {
        const auto op = make_operation("steep_shallow");
        std::set<std::string> keys;
        for (const ParameterInfo* p : op->parameters()) {
            keys.insert(p->key);
            QVERIFY2(!p->label.empty() && !p->help.empty(), p->key.c_str());
            QVERIFY2(op->get(p->key) == p->default_value, p->key.c_str());
        }
        for (const char* key :
             {"tolerance", "divide", "overlap", "stepdown", "stepover", "boundary", "avoid"})
            QVERIFY2(keys.count(key) == 1, key);
        QVERIFY(op->three_axis() && op->reads_stock() && op->linking() == Linking::upright);
        QCOMPARE(code_of([&] { op->set("divide", 2.0); }), std::string("out_of_range"));
    }

    /// On a dome, whose slope grows from the top down: levels below the divide's circle, passes above it.
    void each_cuts_its_slopes() {
        const Mesh mesh = dome(12, trials(60, 2));
        const StrategyResult path = planned_on(mesh, divided_at(45), ball_tool(6));
        const Pass* last_level = nullptr;
        std::size_t levels = 0, parallel = 0;
        double least = infinity, most = 0;
        for (const Pass& pass : path.passes) {
            if (pass.layer >= 0) {
                ++levels;
                last_level = &pass;
                QVERIFY2(parallel == 0, "levels come first");
                for (const CutterContact& c : pass.cc)
                    least = std::min(least, slope_of(c.normal));
            } else {
                ++parallel;
                // Passes go on to the border of the last facet, where the cutter rolls over its edge.
                for (const CutterContact& c : pass.cc)
                    most = std::max(most, slope_of(c.normal));
            }
        }
        QVERIFY(levels > 5 && parallel > 5 && last_level);
        QVERIFY2(least > radians(37) && least < radians(46), qPrintable(QString::number(least * 180 / pi)));
        QVERIFY2(most < radians(55) && most > radians(47), qPrintable(QString::number(most * 180 / pi)));
        QVERIFY(!tells(path, "all is cut"));
    }

    /// What lies within the overlap each course cuts to the tolerance by itself.
    void both_cut_the_overlap() {
        const Mesh mesh = dome(12, trials(60, 2));
        const Tool tool = ball_tool(6);
        const StrategyResult path = planned_on(mesh, divided_at(45, 10), tool);
        for (const bool levels : {true, false}) {
            const Naive naive = naive_check(mesh, course(path, levels), tool, 0.1, [&](const PartSample& s) {
                return std::abs(slope_of(s.normal) - radians(45)) < radians(6);
            });
            QVERIFY(naive.judged > 100);
            QVERIFY2(naive.high == 0, qPrintable(QString("%1 of %2").arg(naive.high).arg(naive.judged)));
        }
        // Without overlap neither does.
        const StrategyResult bare = planned_on(mesh, divided_at(45, 0), tool);
        const Naive naive = naive_check(mesh, course(bare, true), tool, 0.1, [&](const PartSample& s) {
            return std::abs(slope_of(s.normal) - radians(39)) < radians(2);
        });
        QVERIFY(naive.judged > 20 && naive.high > naive.judged / 2);
    }

    void both_together_cut_everything_data() {
        QTest::addColumn<int>("part");
        QTest::addColumn<int>("tool");
        QTest::addColumn<double>("divide");
        QTest::addColumn<bool>("scallop");
        // Both planners have checked tests of their own: under a sanitizer a row for each part, and one of
        // both.
        const int every = under_sanitizer ? 4 : 2;
        for (int p = 0; p < 3; ++p)
            for (int t = 0; t < 4; ++t)
                for (const bool scallop : {false, true})
                    if (all_cases
                        || (scallop ? p == t && (!under_sanitizer || p == 1) : (p + t) % every == 0))
                        QTest::addRow("%d %s%s", p, tools_of_every_shape()[std::size_t(t)].name,
                                      scallop ? " scallop" : "")
                            << p << t << 25.0 + 10 * ((p + t) % 4) << scallop;
    }
    void both_together_cut_everything() {
        QFETCH(int, part);
        QFETCH(int, tool);
        QFETCH(double, divide);
        QFETCH(bool, scallop);
        const auto hills = [](double x, double y) { return 4 * std::sin(0.25 * x) * std::cos(0.2 * y); };
        const auto tent = [](double x, double y) { return 9 - std::max(std::abs(x), 0.3 * std::abs(y)); };
        const Mesh mesh = part == 0   ? dome(12, 30)
                          : part == 1 ? height_field(hills, Vec2(-14, -10), Vec2(14, 10), 56, 40)
                                      : height_field(tent, Vec2(-10, -10), Vec2(10, 10), 40, 40);
        const Tool cutter = tools_of_every_shape()[std::size_t(tool)].tool;
        SteepShallowSettings settings = divided_at(divide);
        if (scallop) settings.shallow_by = SteepShallowSettings::Shallow::scallop;
        const StrategyResult path = planned_on(mesh, settings, cutter);
        const BruteCutter brute(cutter.cutter());
        const double foot = 0.3 + double(brute.height(double(brute.radius())));
        const Naive naive = naive_check(mesh, path, cutter, 0.1, [&](const PartSample& s) {
            if (part == 0) return s.p.z() > std::min(foot + double(brute.radius()), 7.0);
            // Hollows keep a fillet of a wide cutter; the hills' tops do not.
            return s.normal.z() > 0.05 && (part == 2 || s.p.z() > 1.5) && std::abs(s.p.x()) < 9
                   && std::abs(s.p.y()) < 9;
        });
        QCOMPARE(naive.gouged, std::size_t(0));
        QVERIFY(naive.judged > 100);
        QVERIFY2(double(naive.high) <= 0.01 * double(naive.judged),
                 qPrintable(QString("%1 of %2; %3")
                                .arg(naive.high)
                                .arg(naive.judged)
                                .arg(path.warnings.empty() ? "" : path.warnings.front().c_str())));
    }

    void where_only_one_has_something_that_is_said() {
        const Mesh flat =
            height_field([](double x, double) { return 0.1 * x; }, Vec2(-9, -9), Vec2(9, 9), 9, 9);
        const StrategyResult passes = planned_on(flat, divided_at(45), ball_tool(6));
        QVERIFY(tells(passes, "all is cut by passes side by side: nothing of the part"));
        QVERIFY(std::none_of(passes.passes.begin(), passes.passes.end(),
                             [](const Pass& p) { return p.layer >= 0; }));
        const StrategyResult levels = planned_on(cone_of(10, 15, 90), divided_at(30), ball_tool(6));
        QVERIFY(tells(levels, "all is cut by levels: nothing is less steep"));
        QVERIFY(std::all_of(levels.passes.begin(), levels.passes.end(),
                            [](const Pass& p) { return p.layer >= 0; }));
        // Both warn where a step of one's own leaves too much.
        SteepShallowSettings coarse = divided_at(45);
        coarse.stepdown = {2.0, ""};
        coarse.stepover = {3.0, ""};
        const StrategyResult rough = planned_on(dome(12, 24), coarse, ball_tool(6));
        QVERIFY(tells(rough, "the step-down of 2 mm leaves") && tells(rough, "the step-over of 3 mm leaves"));
        QVERIFY(rough.cusp_max > 0.3);
    }

    /// Facets face up, down, or stand; undersides of a solid are on neither side.
    void slopes_are_those_the_tool_meets() {
        const Mesh cone = cone_of(10, 15, 12);
        const std::vector<double> slopes = facet_slopes(cone, false, Mat3::Identity(), {});
        for (std::size_t f = 0; f < slopes.size(); ++f)
            QVERIFY(f % 2 == 1 ? slopes[f] > 3.1
                               : std::abs(slopes[f] - slope_of(cone.facet_normal(f))) < 1e-9);
        const SlopePiece piece = piece_between(context_of(cone, ball_tool(6)), {0, radians(50)}, {});
        QVERIFY(!piece.mesh && piece.area == 0 && piece.shallower == 0 && piece.all > 500);
        const SlopePiece all = piece_between(context_of(cone, ball_tool(6)), {radians(50), radians(90)}, {});
        QCOMPARE(all.mesh->facet_count(), std::size_t(12));
        QVERIFY(std::abs(all.area - all.all) < 1e-9);
    }

    void threads_change_nothing_and_it_can_be_cancelled() {
        const Mesh mesh = mixed();
        SteepShallowSettings settings = divided_at(40);
        if (under_sanitizer) settings.tolerance = 0.5;
        QVERIFY(same_with_any_threads([&] { return planned_on(mesh, settings, bull_tool(8, 2)); }));
        for (const double at : {0.1, 0.6, 0.9}) {
            Job job;
            const SteepShallow op(settings);
            QVERIFY(cancelled_at(job, at,
                                 [&](const Progress& p) { op.plan(context_of(mesh, ball_tool(8)), p); }));
        }
    }
};

FACETMILL_TEST(TestSteepShallow)
#include "test_steep_shallow.moc"
