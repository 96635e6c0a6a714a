// Global-local CM2 over random shells: main and rework path together, judged by the verifier, which shares no
// code with the planner.
#include "core/base/parallel.h"
#include "core/link/link.h"
#include "core/strategy/global_local/global_local.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/path_numbers.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Tool with_wide_holder(Tool tool) {
    tool.number = 2;
    tool.flute_length = 25;
    tool.shank_length = 25;
    tool.holder = {{25, 20}};
    return tool;
}

/// Gently domed, with dents of random place, size and depth.
Mesh shell(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double lo, double hi) {
        return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    struct Dent {
        double x, y, rx, ry, depth;
    };
    std::vector<Dent> dents;
    for (int i = 0; i < 3; ++i)
        dents.push_back({between(-14, 14), between(-9, 9), between(4, 7), between(4, 7), between(0.8, 2.0)});
    const double dome_x = between(0, 0.006), dome_y = between(0, 0.006);
    return height_field(
        [=](double x, double y) {
            double z = -dome_x * x * x - dome_y * y * y;
            for (const Dent& d : dents)
                z -= d.depth * std::exp(-std::pow((x - d.x) / d.rx, 2) - std::pow((y - d.y) / d.ry, 2));
            return z;
        },
        Vec2(-20, -14), Vec2(20, 14), 80, 56);
}

PlanContext context_for(const Mesh& mesh, const Tool& tool, const Tool& rework) {
    PlanContext c = context_of(mesh, tool);
    c.machine = find_machine("tarus-tpi-2000");
    c.stock_box.hi.z() += 2;
    c.further_tools = {rework};
    return c;
}

GlobalLocalSettings global_local_settings() {
    GlobalLocalSettings s;
    s.tolerance = 0.08;
    s.lead_limit = radians(6);
    s.raise_lead_limit = false;
    s.rework_offset = 1;
    s.rework_tool = 2;
    s.direction = {0, "x"};
    s.posture = Finish5Settings::PostureChoice::cm2;
    return s;
}

const ReworkPlan& rework_of(const StrategyResult& path) {
    return *path.as<GlobalLocalPath>()->rework;
}

/// Both programs, one after the other.
Verification judged(const PlanContext& context, const GlobalLocal& op, const StrategyResult& path) {
    VerifySettings s;
    s.resolution = 0.6;
    s.sample_spacing = 0.3;
    s.tolerance = op.common().tolerance;
    s.gouge_limit = path.chord_tolerance;
    StockSolid stock;
    stock.box = context.stock_box;
    const auto link = [&](const StrategyResult& one, const PlanContext& c, bool three_axis) {
        const LinkOptions options = default_link_options(one, c, op.common());
        return std::make_shared<ToolMotions>(
            three_axis ? link_three_axis(one, c, op.common().allowance, options, Progress())
                       : link_five_axis(one, c, {op.common().allowance, 0, 0}, options, Progress()));
    };
    std::vector<VerifyProgram> programs{{"main", VerifyTool(context.tool), link(path, context, false), {}}};
    const ReworkPlan& rework = rework_of(path);
    if (!rework.path.passes.empty()) {
        PlanContext c = context;
        c.tool = rework.tool;
        programs.push_back({"rework", VerifyTool(c.tool), link(rework.path, c, rework.three_axis), {}});
    }
    return verify(*context.part, stock, programs, s, Progress());
}

std::vector<double> both_numbers(const StrategyResult& path) {
    std::vector<double> all = path_numbers(path);
    const std::vector<double> rework = path_numbers(rework_of(path).path);
    all.insert(all.end(), rework.begin(), rework.end());
    return all;
}

/// Contacts keep the limit. Between two of them a motion may be divided, and the normal turns as the surface
/// does.
const double between_contacts = radians(0.2);

double largest_lead(const StrategyResult& path) {
    double most = 0;
    for (const Pass& pass : path.passes)
        for (std::size_t i = 0; i < pass.cl.size(); ++i)
            most = std::max(most, std::acos(std::clamp(pass.cl[i].axis.dot(pass.cc[i].normal), -1.0, 1.0)));
    return most;
}

} // namespace

class TestGlobalLocal : public QObject {
    Q_OBJECT
private slots:
    void random_shells_are_cut_whole_data() {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<bool>("ball");
        for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
            if (under_sanitizer && seed > 1) break;
            QTest::addRow("ball %u", seed) << seed << true;
        }
        if (!under_sanitizer) QTest::addRow("cm2 1") << 1u << false;
    }
    void random_shells_are_cut_whole() {
        QFETCH(unsigned, seed);
        QFETCH(bool, ball);
        const Mesh part = shell(seed);
        const PlanContext context = context_for(part, with_wide_holder(flat_tool(10)),
                                                with_wide_holder(ball ? ball_tool(3) : flat_tool(2)));
        GlobalLocalSettings s = global_local_settings();
        if (!ball) s.rework_cutting = GlobalLocalSettings::ReworkCutting::cm2;
        const GlobalLocal op(s);
        const StrategyResult path = op.plan(context, Progress());
        for (const std::string& w : path.warnings)
            qInfo("%s", w.c_str());
        QVERIFY(path.as<GlobalLocalPath>() && rework_of(path).regions.regions.size() > 0);
        QCOMPARE(path.strips.size(), rework_of(path).regions.regions.size());
        QVERIFY(!rework_of(path).path.passes.empty());
        QVERIFY2(largest_lead(path) <= s.lead_limit + between_contacts,
                 qPrintable(QString::number(largest_lead(path))));
        for (const Strip& strip : path.strips) {
            QVERIFY(strip.enabled && strip.tool == 2 && strip.area > 0 && !strip.boundaries.empty());
            QVERIFY(!strip.band.empty() && !strip.reason.empty());
        }
        // Not all of the part: the main path has its share.
        QVERIFY(rework_of(path).regions.area < 0.8 * rework_of(path).part_area);

        const Verification v = judged(context, op, path);
        QVERIFY(v.figures.samples > 3000);
        QVERIFY2(!v.gouged(), qPrintable(QString::number(std::max(v.figures.gouge_max, v.border.gouge_max))));
        QVERIFY(v.collisions.empty());
        QCOMPARE(v.figures.uncut_fraction, 0.0);
        QVERIFY2(v.figures.excess_p999 <= 1.1 * s.tolerance,
                 qPrintable(QString::number(v.figures.excess_p999)));
        // What is over the tolerance was said.
        for (const DeviationExtreme& e : v.excess) {
            bool told = e.deviation <= 1.1 * s.tolerance;
            for (const CutterContact& c : path.cleanup)
                told |= (c.point - e.point).norm() <= 1.5;
            QVERIFY2(told, qPrintable(QString::number(e.deviation)));
        }
    }

    void what_no_place_needs_is_not_reworked() {
        const Mesh part = height_field([](double x, double y) { return -0.004 * (x * x + y * y); },
                                       Vec2(-15, -10), Vec2(15, 10), 30, 20);
        const PlanContext context =
            context_for(part, with_wide_holder(flat_tool(8)), with_wide_holder(ball_tool(3)));
        const GlobalLocal op(global_local_settings());
        const StrategyResult path = op.plan(context, Progress());
        QCOMPARE(rework_of(path).regions.regions.size(), std::size_t(0));
        QVERIFY(rework_of(path).path.passes.empty());
        QVERIFY(!path.warnings.empty() && path.warnings[0].find("nothing to rework") != std::string::npos);
        QCOMPARE(judged(context, op, path).figures.uncut_fraction, 0.0);
    }

    /// A shallow dent: passes all over it with larger leads are over sooner than passes with small ones and a
    /// small ball in the dent. What is asked for by an edit of a region is kept.
    void a_larger_lead_is_taken_where_it_takes_less_time() {
        const Mesh part = height_field(
            [](double x, double y) {
                return -0.8 * std::exp(-0.02 * (x * x + y * y)) - 0.003 * (x * x + y * y);
            },
            Vec2(-20, -14), Vec2(20, 14), 80, 56);
        const PlanContext context =
            context_for(part, with_wide_holder(flat_tool(10)), with_wide_holder(ball_tool(2)));
        GlobalLocalSettings s = global_local_settings();
        s.lead_limit = radians(1);
        const auto length = [](const StrategyResult& plan) {
            double sum = 0;
            for (const StrategyResult* path : {&plan, &rework_of(plan).path})
                for (const Pass& pass : path->passes)
                    for (std::size_t i = 1; i < pass.cl.size(); ++i)
                        sum += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
            return sum;
        };
        const StrategyResult kept = GlobalLocal(s).plan(context, Progress());
        QVERIFY2(rework_of(kept).regions.regions.size() > 0
                     && largest_lead(kept) <= s.lead_limit + between_contacts,
                 qPrintable(QString("%1 %2")
                                .arg(rework_of(kept).regions.regions.size())
                                .arg(degrees(largest_lead(kept)))));
        s.raise_lead_limit = true;
        const GlobalLocal op(s);
        const StrategyResult raised = op.plan(context, Progress());
        QVERIFY2(length(raised) < length(kept),
                 qPrintable(QString("%1 %2").arg(length(raised)).arg(length(kept))));
        QVERIFY(largest_lead(raised) > s.lead_limit);
        QVERIFY2(raised.warnings[0].find("raised to 45") != std::string::npos, raised.warnings[0].c_str());
        const Verification v = judged(context, op, raised);
        QVERIFY(!v.gouged() && v.collisions.empty());
        QCOMPARE(v.figures.uncut_fraction, 0.0);

        const Vec3& place = rework_of(kept).regions.regions[0].place;
        s.region_edits.push_back({{place.x(), place.y(), place.z()}, true, 1});
        const StrategyResult edited = GlobalLocal(s).plan(context, Progress());
        QVERIFY(rework_of(edited).regions.regions.size() > 0
                && largest_lead(edited) <= s.lead_limit + between_contacts);
    }

    /// Regions that are switched off, or have no tool, are not cut, and that is said.
    void what_is_switched_off_stays() {
        const Mesh part = shell(1);
        const PlanContext context =
            context_for(part, with_wide_holder(flat_tool(10)), with_wide_holder(ball_tool(3)));
        GlobalLocalSettings s = global_local_settings();
        s.rework_tool = 0;
        const StrategyResult none = GlobalLocal(s).plan(context, Progress());
        QVERIFY(rework_of(none).path.passes.empty() && rework_of(none).regions.regions.size() > 0
                && none.cleanup_points > 0);
        QVERIFY(none.warnings[0].find("choose a rework tool") != std::string::npos);
        s.rework_tool = 2;
        for (const ReworkRegion& r : rework_of(none).regions.regions)
            s.region_edits.push_back({{r.place.x(), r.place.y(), r.place.z()}, false, 0});
        const StrategyResult off = GlobalLocal(s).plan(context, Progress());
        QVERIFY(rework_of(off).path.passes.empty());
        QCOMPARE(off.cleanup_points, none.cleanup_points);
        QVERIFY(off.warnings[0].find("switched off") != std::string::npos);
        for (const Strip& strip : off.strips)
            QVERIFY(!strip.enabled);
    }

    void the_same_bits_with_any_number_of_threads() {
        const Mesh part = shell(2);
        const PlanContext context =
            context_for(part, with_wide_holder(flat_tool(10)), with_wide_holder(ball_tool(3)));
        GlobalLocalSettings s = global_local_settings();
        s.tolerance = 0.15;
        const GlobalLocal op(s);
        set_thread_count(1);
        const auto one = both_numbers(op.plan(context, Progress()));
        set_thread_count(2);
        const auto two = both_numbers(op.plan(context, Progress()));
        set_thread_count(0);
        QVERIFY(one.size() > 1000);
        QVERIFY(one == two);
    }

    void a_cancelled_plan_ends_without_a_trace() {
        const Mesh part = shell(2);
        const PlanContext context =
            context_for(part, with_wide_holder(flat_tool(10)), with_wide_holder(ball_tool(3)));
        for (const double when : {0.0, 0.05, 0.3, 0.7, 0.8}) {
            Job job;
            QVERIFY2(cancelled_at(
                         job, when,
                         [&](const Progress& p) { GlobalLocal(global_local_settings()).plan(context, p); }),
                     qPrintable(QString::number(when)));
        }
    }

    void what_cannot_be_cut_is_an_error_data() {
        QTest::addColumn<int>("number");
        for (int i = 0; i < 5; ++i)
            QTest::addRow("%d", i) << i;
    }
    void what_cannot_be_cut_is_an_error() {
        QFETCH(int, number);
        PlanContext context =
            context_for(shell(1), with_wide_holder(flat_tool(10)), with_wide_holder(ball_tool(3)));
        GlobalLocalSettings s = global_local_settings();
        std::string said, expected = "out_of_range", about;
        switch (number) {
        case 0:
            context.further_tools[0] = flat_tool(3);
            about = "no ball";
            break;
        case 1:
            s.rework_cutting = GlobalLocalSettings::ReworkCutting::cm2;
            about = "is a ball";
            break;
        case 2:
            s.lead_limit = radians(46);
            about = "lead_limit";
            break;
        case 3:
            s.rework_offset = 100;
            about = "rework_offset";
            break;
        default:
            // A hollow everywhere narrower than the tool.
            context = context_for(height_field([](double x, double y) { return 0.1 * (x * x + y * y); },
                                               Vec2(-8, -8), Vec2(8, 8), 32, 32),
                                  with_wide_holder(flat_tool(10)), with_wide_holder(ball_tool(3)));
            expected = "empty_result";
            about = "smaller tool";
        }
        QCOMPARE(code_of([&] { GlobalLocal(s).plan(context, Progress()); }, &said), expected);
        QVERIFY2(said.find(about) != std::string::npos, said.c_str());
    }
};

FACETMILL_TEST(TestGlobalLocal)
#include "test_global_local.moc"
