// The constants by which plans and links keep clear of the part, at half and at double, judged by the
// verifier, which shares no code with the planners: at half nothing is worse; at double it stays within what
// the constants promise, and where they are far off the verifier sees it.
#include "core/link/link.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/lathe/lathe_finish.h"
#include "core/strategy/rough/rough.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/property/turned_part.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// What the verifier says of a plan.
struct Judged {
    double gouge = 0, excess = 0, uncut = 0; ///< mm, mm, share of the area
    std::size_t rapids = 0, bodies = 0;      ///< collisions: in rapids; of shank and holder
    double stated = 0, length = 0;           ///< largest cusp that the plan states; of motions, mm

    QString text(double factor) const {
        return QString("at %1: gouge %2, excess %3 of %4, uncut %5, %6 rapids and %7 bodies, %8 mm")
            .arg(factor)
            .arg(gouge)
            .arg(excess)
            .arg(stated)
            .arg(uncut)
            .arg(rapids)
            .arg(bodies)
            .arg(length);
    }
};

Judged judged(const PlanContext& context, const StrategyResult& path, const ToolMotions& motions,
              double allowance, double spacing, double bound = 0) {
    StockSolid stock = context.stock;
    if (stock.kind == StockSolid::Kind::box) stock.box = context.stock_box;
    VerifySettings s;
    s.resolution = 0.5;
    s.sample_spacing = spacing;
    s.motion_bound = bound;
    s.allowance = allowance;
    s.tolerance = path.cusp_max;
    // Probes keep off sharp edges by twice this: what is no gouge beside them is none on them.
    s.gouge_limit = 2 * path.chord_tolerance;
    const VerifyProgram program{"P", VerifyTool(context.tool), std::make_shared<ToolMotions>(motions),
                                motions.turning};
    const Verification v = verify(*context.part, stock, {&program, 1}, s, Progress());
    Judged j;
    j.gouge = std::max(v.figures.gouge_max, v.border.gouge_max);
    j.excess = v.figures.excess_max;
    j.uncut = v.figures.uncut_fraction;
    j.stated = path.cusp_max;
    for (const Collision& c : v.collisions)
        ++(c.kind == Collision::Kind::rapid ? j.rapids : j.bodies);
    for (std::size_t i = 1; i < motions.motions.size(); ++i)
        j.length += (motions.motions[i].to.tip - motions.motions[i - 1].to.tip).norm();
    return j;
}

Judged judged(const Operation& op, const PlanContext& context, double spacing = 0.3) {
    const StrategyResult path = op.plan(context, Progress());
    return judged(context, path, link_operation(op, path, context, Progress()), op.common().allowance,
                  spacing);
}

Mesh waves(double high, int columns = 60, const Vec2& corner = Vec2(9, 7)) {
    return height_field(
        [high](double x, double y) { return high * std::sin(0.7 * x + 0.2 * y) * std::cos(0.6 * y); },
        -corner, corner, columns, columns * 3 / 4);
}

/// Waves in stock 2 mm higher, on a machine of five axes.
PlanContext five_axis_waves(const Tool& tool) {
    PlanContext context = context_of(waves(0.5, 20, Vec2(5, 3.5)), tool);
    context.machine = find_machine("tarus-tpi-2000");
    context.stock_box.hi.z() += 2;
    return context;
}

/// Round hollows of a radius along X, each as wide as twice `half`, and level between.
Mesh hollows(double radius, double half) {
    const auto high = [=](double, double y) {
        const double off = std::min(std::abs(std::remainder(y, 5)), half);
        return -std::sqrt(radius * radius - off * off);
    };
    return height_field(high, Vec2(-5, -7.5), Vec2(5, 7.5), 4, 150);
}

/// A closed part along X whose radius changes with angle and place.
Mesh lobes() {
    return turned_part(72, 16, 8, [](double a, double x) { return 8 + 0.6 * std::cos(3 * a + 0.25 * x); });
}

PlanContext turning(const Mesh& part, const Tool& tool) {
    PlanContext c = context_of(part, tool);
    c.machine = find_machine("lathe-mill");
    c.stock.kind = StockSolid::Kind::cylinder;
    c.stock.axis = 0;
    c.stock.radius = 10;
    c.stock_box = {Vec3(0, -10, -10), Vec3(part.box().hi.x(), 10, 10)};
    c.stock.box = c.stock_box;
    return c;
}

constexpr double factors[] = {0.5, 1, 2};

/// All of them, or those without which a test would show nothing.
std::vector<double> tried(std::vector<double> all, std::vector<double> least) {
    return all_cases ? std::move(all) : std::move(least);
}

} // namespace

class TestPlanLimits : public QObject {
    Q_OBJECT
private slots:
    /// Tips keep the margin from the exact surface, and between the places looked at they dip by less: no
    /// size of it gouges, and what is stated to stay has it.
    void roughing_keeps_its_margin() {
        PlanContext context = context_of(waves(0.5), ball_tool(4));
        context.stock_box.hi.z() += 2;
        RoughSettings s;
        s.allowance = 0.2;
        s.tolerance = 0.8;
        const double usual = s.margin_share;
        for (const double factor : factors) {
            s.margin_share = factor * usual;
            const Judged j = judged(Rough(s), context, 0.5);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.gouge <= 1e-6 && j.rapids + j.bodies == 0, qPrintable(j.text(factor)));
            QVERIFY2(j.excess <= j.stated, qPrintable(j.text(factor)));
        }
    }

    /// What stands is known from cell to cell: what must not be touched is never below a cell's top, however
    /// large they are, and work that lies between their centres is done with its neighbours.
    void roughing_knows_its_stock() {
        PlanContext context = context_of(waves(0.5), ball_tool(4));
        context.stock_box.hi.z() += 2;
        RoughSettings s;
        s.allowance = 0.2;
        s.tolerance = 0.8;
        const double usual = s.cell_share;
        for (const double factor : {0.5, 1.0, 2.0, 16.0}) {
            s.cell_share = factor * usual;
            const Judged j = judged(Rough(s), context, 0.5);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.gouge <= 1e-6 && j.rapids + j.bodies == 0, qPrintable(j.text(factor)));
            QVERIFY2(j.excess <= j.stated, qPrintable(j.text(factor)));
        }
    }

    /// Step-overs rest on cusps looked at from place to place.
    void finishing_finds_its_highest_cusps() {
        const PlanContext context = context_of(waves(0.35, 90), ball_tool(4));
        Finish3Settings s;
        s.tolerance = 0.03;
        const double usual = s.look.share;
        for (const double factor : factors) {
            s.look.share = factor * usual;
            const Judged j = judged(Finish3(s), context, 0.1);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.uncut == 0 && j.excess <= (factor > 1 ? 1.1 : 1.03) * s.tolerance,
                     qPrintable(j.text(factor)));
            QVERIFY2(j.gouge <= s.tolerance / 20, qPrintable(j.text(factor)));
        }
        s.look.share = 32 * usual;
        const Judged j = judged(Finish3(s), context, 0.1);
        qInfo("%s", qPrintable(j.text(32)));
        QVERIFY2(j.excess > 1.1 * s.tolerance, qPrintable(j.text(32)));
    }

    void finishing_sees_jumps_and_edges_data() {
        QTest::addColumn<bool>("jumps");
        QTest::newRow("where the contact jumps") << true;
        QTest::newRow("beside edges") << false;
    }

    /// Hollows hardly wider than the ball, whose rims are edges, cut along and aslant.
    void finishing_sees_jumps_and_edges() {
        QFETCH(bool, jumps);
        const PlanContext context = context_of(hollows(2.2, 2), ball_tool(4));
        Finish3Settings s;
        s.tolerance = 0.03;
        double& gap = jumps ? s.look.jump_gap : s.look.edge_gap;
        const double usual = gap;
        // Aslant contacts jump at every hollow, along a line ends beside edges.
        s.direction = {jumps ? radians(35) : 0, ""};
        double finest = 0, shortest = 0;
        for (const double factor : tried({0.5, 1, 2, 64}, {0.5, 64})) {
            gap = factor * usual;
            const Judged j = judged(Finish3(s), context, 0.05);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.uncut == 0 && j.gouge <= s.tolerance / 20, qPrintable(j.text(factor)));
            QVERIFY2(j.excess <= std::max(1.1 * s.tolerance, factor < 64 ? 0 : j.stated),
                     qPrintable(j.text(factor)));
            if (factor == 0.5) finest = j.excess, shortest = j.length;
            if (factor < 64) continue;
            // Far off it shows, in what is left or in lines through what the plan finds it passes by.
            QVERIFY2(jumps ? j.excess > 1.03 * finest : j.length > 1.03 * shortest,
                     qPrintable(j.text(factor)));
        }
    }

    void five_axes_keep_within_the_chord_tolerance_data() {
        QTest::addColumn<bool>("motions");
        QTest::newRow("share of motions") << true;
        QTest::newRow("room to the top") << false;
    }

    void five_axes_keep_within_the_chord_tolerance() {
        QFETCH(bool, motions);
        const PlanContext context = five_axis_waves(bull_tool(4, 1));
        Finish5Settings s;
        s.tolerance = 0.1;
        s.direction = {0, "x"};
        double& share = motions ? s.motion_share : s.room_chords;
        const double usual = share, chord = s.tolerance / 20;
        for (const double factor : tried({0.5, 1, 2, 4}, {1, 4})) {
            share = factor * usual;
            const Judged j = judged(Finish5(s), context, 0.2);
            qInfo("%s", qPrintable(j.text(factor)));
            // Twice the share of motions may be more than the whole chord tolerance; four times is seen to
            // be.
            const bool may_exceed = motions && factor > 1;
            QVERIFY2(j.gouge <= (may_exceed ? 0.75 * factor : 1) * chord, qPrintable(j.text(factor)));
            QVERIFY2(!(motions && factor == 4) || j.gouge > chord, qPrintable(j.text(factor)));
            QVERIFY2(j.excess <= 1.03 * s.tolerance && j.rapids + j.bodies == 0, qPrintable(j.text(factor)));
        }
    }

    /// Strips are as wide as the lines beside a pass say, however far apart they are.
    void five_axes_leave_no_more_than_the_tolerance() {
        const PlanContext context = five_axis_waves(bull_tool(4, 1));
        Finish5Settings s;
        s.tolerance = 0.05;
        s.direction = {0, "x"};
        const double usual = s.strip_look_share;
        double shortest = infinity;
        for (const double factor : tried({0.5, 1, 2, 12}, {1, 12})) {
            s.strip_look_share = factor * usual;
            const Judged j = judged(Finish5(s), context, 0.2);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.gouge <= s.tolerance / 20 && j.rapids + j.bodies == 0, qPrintable(j.text(factor)));
            QVERIFY2(j.uncut == 0 && j.excess <= 1.06 * s.tolerance, qPrintable(j.text(factor)));
            // Far off, strips are taken for narrow ones: what it costs is time.
            QVERIFY2(factor < 12 || j.length > 3 * shortest, qPrintable(j.text(factor)));
            shortest = std::min(shortest, j.length);
        }
    }

    /// In a hollow along the travel a flat end could bridge its own line from pose to pose: it does not,
    /// however much of the line is looked at.
    void five_axes_hold_their_own_line() {
        PlanContext context =
            context_of(height_field([](double x, double) { return 12 - std::sqrt(144 - x * x); },
                                    Vec2(-7, -5), Vec2(7, 5), 56, 10),
                       flat_tool(4));
        context.machine = find_machine("tarus-tpi-2000");
        context.stock_box.hi.z() += 2;
        Finish5Settings s;
        s.tolerance = 0.05;
        s.direction = {0, "x"};
        const double usual = s.own_reach;
        for (const double factor : tried({0.5, 1, 2, 16}, {1, 16})) {
            s.own_reach = factor * usual;
            const Judged j = judged(Finish5(s), context, 0.2);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.gouge <= s.tolerance / 20 && j.rapids + j.bodies == 0, qPrintable(j.text(factor)));
            QVERIFY2(j.uncut == 0 && j.excess <= j.stated, qPrintable(j.text(factor)));
        }
    }

    /// The chord tolerance is shared out: at half a fifth of it is not used, at double two fifths more are.
    void turning_keeps_within_the_chord_tolerance() {
        const PlanContext context = turning(lobes(), ball_tool(6));
        LatheFinishSettings s;
        s.tolerance = 0.1;
        const double usual = s.look_share, chord = s.tolerance / 20;
        for (const double factor : tried({0.5, 1, 2}, {1, 2})) {
            s.look_share = factor * usual;
            const Judged j = judged(LatheFinish(s), context, 0.3);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.gouge <= (factor > 1 ? 1.4 : 1) * chord, qPrintable(j.text(factor)));
            QVERIFY2(j.excess <= 1.03 * s.tolerance && j.rapids + j.bodies == 0, qPrintable(j.text(factor)));
        }
    }

    /// Side feeds aim at nine tenths of what may stand, since the angles between those looked at leave more.
    void turning_aims_below_its_tolerance() {
        const PlanContext context = turning(lobes(), ball_tool(6));
        LatheFinishSettings s;
        s.tolerance = 0.1;
        const double usual = s.aimed_share;
        double least = infinity;
        for (const double factor : tried({0.5, 1, 2}, {0.5, 2})) {
            s.aimed_share = factor * usual;
            const Judged j = judged(LatheFinish(s), context, 0.15);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.excess <= std::max(1.03, 1.03 * factor) * s.tolerance && j.gouge <= s.tolerance / 20,
                     qPrintable(j.text(factor)));
            if (factor > 1)
                QVERIFY2(j.excess > 1.03 * s.tolerance, qPrintable(j.text(factor))); // and is seen
            least = std::min(least, j.excess);
        }
        QVERIFY(least < 0.7 * s.tolerance);
    }

    /// Passes on waves, joined from ridge to ridge.
    void five_axis_links_keep_within_the_chord_tolerance() {
        const PlanContext context = five_axis_waves(flat_tool(4));
        Finish5Settings s;
        s.tolerance = 0.1;
        s.direction = {0, "x"};
        s.pattern = Finish5Settings::Pattern::oneway;
        const Finish5 op(s);
        const StrategyResult path = op.plan(context, Progress());
        LinkOptions options = default_link_options(path, context, op.common());
        options.link_distance = 40; // all on the surface
        const double usual = options.motion_share;
        for (const double factor : tried({0.5, 1, 2}, {1})) {
            options.motion_share = factor * usual;
            const ToolMotions motions = link_five_axis(path, context, {}, options, Progress());
            QVERIFY(std::count_if(motions.motions.begin(), motions.motions.end(),
                                  [](const Motion& m) { return m.kind == MotionKind::link; })
                    > 5);
            const Judged j = judged(context, path, motions, 0, 0.2);
            qInfo("%s", qPrintable(j.text(factor)));
            QVERIFY2(j.gouge <= (factor > 1 ? 1.5 : 1) * options.chord_tolerance && j.rapids + j.bodies == 0,
                     qPrintable(j.text(factor)));
        }
        // Where it is far off, the verifier sees it.
        options.motion_share = 16 * usual;
        const Judged j =
            judged(context, path, link_five_axis(path, context, {}, options, Progress()), 0, 0.2);
        qInfo("%s", qPrintable(j.text(16)));
        QVERIFY2(j.gouge > options.chord_tolerance, qPrintable(j.text(16)));
    }

    /// Rapids round the part stay out, also where the tip runs on the chord of the arc.
    void rapids_about_the_axis_stay_clear() {
        const PlanContext context = turning(lobes(), ball_tool(6));
        LatheFinishSettings s;
        s.tolerance = 0.3;
        s.pattern = LatheCommon::Pattern::lengthwise;
        s.start = {2, ""}; // lines end over the stock
        s.stop = {6, ""};
        const LatheFinish op(s);
        StrategyResult path = op.plan(context, Progress());
        // Every second line from the other side of the part: long rapids between them.
        std::vector<Pass> mixed;
        const std::size_t n = path.passes.size();
        for (std::size_t i = 0; i < n; ++i)
            mixed.push_back(path.passes[(i % 2) * (n / 2) + i / 2]);
        path.passes = std::move(mixed);
        LinkOptions options = default_link_options(path, context, op.common());
        options.clearance = 0.3;
        const double usual = options.rapid_chord_share;
        const auto collisions = [&](double factor) {
            options.rapid_chord_share = factor * usual;
            ToolMotions motions = link_lathe(path, context, s, options, Progress());
            motions.turning.reset(); // the tip runs on chords
            const Judged j = judged(context, path, motions, 0, 0.6, 0.02);
            qInfo("%s", qPrintable(j.text(factor)));
            return j.rapids;
        };
        for (const double factor : tried({0.5, 1, 2}, {1}))
            QCOMPARE(collisions(factor), std::size_t(0));
        QVERIFY(collisions(16) > 0);
    }
};

FACETMILL_TEST(TestPlanLimits)
#include "test_plan_limits.moc"
