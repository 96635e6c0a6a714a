// Every registered three-axis operation with every cutter shape over parts with known answers: judged by the
// path checker, which shares no code with the planner.
#include "core/base/parallel.h"
#include "core/link/link.h"
#include "core/mesh/sample.h"
#include "tests/property/shapes.h"
#include "tests/support/cancel_at.h"
#include "tests/support/naive_finish.h"
#include "tests/support/path_checker.h"
#include "tests/support/path_numbers.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <algorithm>
#include <cstring>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::unique_ptr<Operation> operation(const std::string& kind, double tolerance) {
    auto op = make_operation(kind);
    op->common().tolerance = tolerance;
    return op;
}

ToolMotions linked(const StrategyResult& path, const PlanContext& context, const Operation& op) {
    return link_three_axis(path, context, op.common().allowance,
                           default_link_options(path, context, op.common()), Progress());
}

std::vector<TipLine> tips(const ToolMotions& motions) {
    TipLine line;
    for (const Motion& m : motions.motions)
        line.push_back(m.to.tip);
    return {line};
}

/// Those that cut the part to their tolerance, whatever stands. What takes a stock down by layers states what
/// it leaves, and is judged by that in test_rough_shapes; what cuts only what another tool left, in
/// test_cleanup; what leaves shallow surface to others, in test_waterline; and what goes along walls by
/// levels as well, in test_steep_shallow: there a chord beside the rim of a wall is as deep by the normal of
/// the floor above as the wall is high. Passes along curves have tests of their own.
std::vector<std::string> three_axis_kinds() {
    const std::set<std::string> others{"waterline", "steep_shallow", "pencil", "along_curve",
                                       "radial",    "spiral",        "morph"};
    std::vector<std::string> kinds;
    for (const OperationKind& k : operation_kinds())
        if (const auto op = k.make();
            op->linking() == Linking::upright && op->further_tools().empty() && !others.contains(k.kind))
            kinds.push_back(k.kind);
    return kinds;
}

/// Passes that follow the part are the same whatever the direction: one is tried.
bool has_no_direction(const std::string& kind) {
    return kind == "scallop";
}

} // namespace

class TestThreeAxis : public QObject {
    Q_OBJECT
private slots:
    void shapes_are_cut_to_tolerance_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("cutter");
        const auto parts = shapes();
        const auto tools = tools_of_every_shape();
        // Every run has a fifth: each shape under some cutters, by the other kinds under others.
        std::size_t turn = 0;
        for (const std::string& kind : three_axis_kinds()) {
            for (std::size_t s = 0; s < parts.size(); ++s)
                for (std::size_t c = 0; c < tools.size(); ++c)
                    if (all_cases || (s + c + turn) % 5 == 0)
                        QTest::addRow("%s %s %s", kind.c_str(), parts[s].name.c_str(), tools[c].name)
                            << QString::fromStdString(kind) << int(s) << int(c);
            ++turn;
        }
    }

    void shapes_are_cut_to_tolerance() {
        QFETCH(QString, kind);
        QFETCH(int, shape);
        QFETCH(int, cutter);
        const Shape part = shapes()[std::size_t(shape)];
        const Tool tool = tools_of_every_shape()[std::size_t(cutter)].tool;
        // Sharp rims leave so much that they are judged at a wider tolerance, to keep the number of passes
        // down.
        const double tolerance = tool.corner_radius < 1 ? 0.15 : 0.05, chord = tolerance / 20;
        const auto op = operation(kind.toStdString(), tolerance);
        const PlanContext context = context_of(part.mesh, tool);
        const StrategyResult path = op->plan(context, Progress());
        PathCheckOptions options;
        // Constant scallop goes to the limit everywhere: more samples, for what is one in a thousand.
        const bool scallop = kind == "scallop";
        options.spacing = scallop ? 0.35 : 0.7;
        options.border = 0.5 * tool.diameter;
        options.no_cusp = [&](const Vec3& p) { return part.out_of_reach(p, tool); };
        const PathCheckResult result =
            check_path(part.mesh, tool.cutter(), tips(linked(path, context, *op)), options);
        QVERIFY(result.samples > 1000);
        // Where a cutter rolls over the rim of a sheet a chord is as deep by the normal as the rim falls.
        if (scallop)
            QCOMPARE(
                naive_check(part.mesh, path, tool, tolerance, [](const PartSample&) { return false; }).gouged,
                std::size_t(0));
        else
            QVERIFY2(result.gouge_max <= chord, qPrintable(QString::number(result.gouge_max)));
        const double share = scallop ? 1.05 : 1.02;
        QVERIFY2(result.cusp_p999 <= share * tolerance, qPrintable(QString::number(result.cusp_p999)));
        QCOMPARE(result.uncut_fraction, 0.0);
    }

    void a_benchmark_surface_is_cut_to_tolerance_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"concave", "convex", "complex"})
            QTest::newRow(name) << name;
    }

    /// Lu's surfaces, ball of 0.5 in, at five times the tolerance of 0.002 in that they are checked at by
    /// hand.
    void a_benchmark_surface_is_cut_to_tolerance() {
        QFETCH(QString, name);
        const double inch = 25.4, tolerance = 0.01 * inch;
        const auto part = make_sample(name.toStdString(), default_sample_tolerance, Progress());
        const Tool tool = ball_tool(0.5 * inch);
        const PlanContext context = context_of(*part, tool);
        for (const std::string& kind : three_axis_kinds()) {
            const auto op = operation(kind, tolerance);
            PathCheckOptions options;
            options.spacing = 2.5;
            options.border = 0.25 * inch;
            options.reach = 2;
            const PathCheckResult result = check_path(
                *part, tool.cutter(), tips(linked(op->plan(context, Progress()), context, *op)), options);
            QVERIFY(result.cusp_samples > 5000);
            QVERIFY2(result.gouge_max <= 0.05 * tolerance, qPrintable(QString::number(result.gouge_max)));
            const double share = kind == "scallop" ? 1.05 : 1.02;
            QVERIFY2(result.cusp_p999 <= share * tolerance,
                     qPrintable(QString("%1: %2").arg(kind.c_str()).arg(result.cusp_p999)));
            QCOMPARE(result.uncut_fraction, 0.0);
        }
    }

    /// At a convex edge the tip goes a long way while its contact stands still.
    void sharp_edges_are_cut_to_tolerance() {
        for (const double slope : {0.5, 1.5}) {
            const Mesh part =
                height_field([=](double, double y) { return -slope * std::max(std::abs(y) - 5, 0.0); },
                             Vec2(-20, -15), Vec2(20, 15), 4, 30);
            for (const double angle : {0.0, slope - 0.1})
                for (const Tool& tool : {ball_tool(6), bull_tool(6, 1.5)}) {
                    // Every run has half: each slope under both, level and turned.
                    if (!all_cases && (tool.corner_radius > 2) != ((slope < 1) == (angle == 0))) continue;
                    const Mesh turned_part = turned(part, angle);
                    const PlanContext context = context_of(turned_part, tool);
                    for (const std::string& kind : three_axis_kinds()) {
                        const auto op = operation(kind, 0.05);
                        op->common().direction = {0, "x"};
                        PathCheckOptions options;
                        options.spacing = 0.25;
                        options.border = 3;
                        const PathCheckResult result =
                            check_path(turned_part, tool.cutter(),
                                       tips(linked(op->plan(context, Progress()), context, *op)), options);
                        // Constant scallop is held to all but one in a thousand of the places; along sharp
                        // edges, which are much of this part, more of them are higher.
                        const bool scallop = kind == "scallop";
                        const double high = scallop ? result.cusp_p999 : result.cusp_max;
                        QVERIFY2(high <= (scallop ? 0.06 : 0.055),
                                 qPrintable(QString("%1: %2").arg(kind.c_str()).arg(high)));
                        QVERIFY(result.cusp_samples > 8000);
                    }
                }
        }
    }

    /// Slanted and curved borders are met by every pass at another place; nothing stays between their ends.
    void borders_are_cut_to_tolerance() {
        const auto inside = [](double x, double y) { return x * x / 400 + y * y / 200 < 1; };
        const auto f = [](double x, double y) { return 0.02 * (x * x - y * y) + 0.3 * y; };
        const Mesh oval = only(height_field(f, Vec2(-20, -15), Vec2(20, 15), 80, 60),
                               [&](const Vec3& p) { return inside(p.x(), p.y()); });
        // Slightly slanted, and ever narrower passes towards the steep side.
        Mesh slanted = height_field([](double, double y) { return y < 0 ? 0 : 0.06 * y * y; }, Vec2(-20, -15),
                                    Vec2(20, 15), 20, 60);
        for (Vec3& v : slanted.vertices)
            v.y() += 0.06 * v.x() + 0.01 * v.x() * v.x();
        for (const Mesh& part : {oval, slanted, turned(slanted, pi), turned(slanted, 0.3)})
            for (const char* direction : {"x", "y"}) {
                const Tool tool = ball_tool(6);
                const PlanContext context = context_of(part, tool);
                for (const std::string& kind : three_axis_kinds()) {
                    if (has_no_direction(kind) && *direction == 'y') continue;
                    const auto op = operation(kind, 0.05);
                    op->common().direction = {0, direction};
                    PathCheckOptions options;
                    options.spacing = 0.3;
                    const PathCheckResult result =
                        check_path(part, tool.cutter(),
                                   tips(linked(op->plan(context, Progress()), context, *op)), options);
                    QVERIFY(result.cusp_samples > 8000);
                    const bool scallop = kind == "scallop";
                    const double high = scallop ? result.cusp_p999 : result.cusp_max;
                    QVERIFY2(high <= (scallop ? 0.0525 : 0.052),
                             qPrintable(QString("%1: %2").arg(kind.c_str()).arg(high)));
                    QVERIFY2(result.gouge_max <= 0.0025, qPrintable(QString::number(result.gouge_max)));
                    QCOMPARE(result.uncut_fraction, 0.0);
                }
            }
    }

    /// What the planner expects of a constant step is what the checker finds, steep places and borders
    /// included.
    void the_expected_cusp_is_the_real_one() {
        const auto concave = make_sample("concave", default_sample_tolerance, Progress());
        const Mesh flank = height_field([](double, double y) { return y < 0 ? 0 : 0.08 * y * y; },
                                        Vec2(-20, -15), Vec2(20, 15), 20, 90);
        const Mesh cap = shapes()[2].mesh;
        const Mesh edges = height_field([](double, double y) { return -std::max(std::abs(y) - 5, 0.0); },
                                        Vec2(-20, -15), Vec2(20, 15), 4, 30);
        struct Case {
            const Mesh& part;
            double diameter, step;
        };
        for (const auto& [part, diameter, step] :
             {Case{flank, 6, 0.8}, Case{cap, 6, 1.0}, Case{edges, 6, 1.9}, Case{*concave, 12.7, 1.143}})
            for (const char* direction : {"x", "y"}) {
                if (diameter > 6 && *direction == 'y') continue; // the large one once
                const Tool tool = ball_tool(diameter);
                const PlanContext context = context_of(part, tool);
                const auto op = operation("finish3", 0.05);
                op->common().direction = {0, direction};
                op->set("stepover", step);
                const StrategyResult path = op->plan(context, Progress());
                PathCheckOptions options;
                options.spacing = 0.5 * step;
                options.reach = 2;
                const PathCheckResult result =
                    check_path(part, tool.cutter(), tips(linked(path, context, *op)), options);
                const QString figures = QString("expected %1, found %2 of %3 %4")
                                            .arg(path.cusp_max)
                                            .arg(result.cusp_max)
                                            .arg(step)
                                            .arg(direction);
                QVERIFY2(path.cusp_max >= 0.97 * result.cusp_max, qPrintable(figures));
                // As a bound it holds the chord tolerance too, which a path need not use.
                QVERIFY2(path.cusp_max <= 1.2 * result.cusp_max + 0.0025, qPrintable(figures));
            }
    }

    void threads_do_not_change_a_bit() {
        const PlanContext context = context_of(mixed(), ball_tool(5));
        for (const std::string& kind : three_axis_kinds()) {
            const auto op = operation(kind, 0.05);
            set_thread_count(1);
            const StrategyResult one = op->plan(context, Progress());
            const ToolMotions one_linked = linked(one, context, *op);
            set_thread_count(0);
            const StrategyResult many = op->plan(context, Progress());
            const auto a = path_numbers(one), b = path_numbers(many);
            QVERIFY(a.size() > 1000);
            QCOMPARE(a.size(), b.size());
            QVERIFY(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
            const auto p = tips(one_linked), q = tips(linked(many, context, *op));
            QVERIFY(p == q);
        }
    }

    void cancelling_anywhere_leaves_nothing() {
        const PlanContext context = context_of(mixed(), ball_tool(5));
        for (const std::string& kind : three_axis_kinds()) {
            const auto op = operation(kind, 0.05);
            const auto reference = path_numbers(op->plan(context, Progress()));
            for (int point = 0; point < 10; ++point) {
                Job job;
                const double at = 0.1 * point;
                QVERIFY2(cancelled_at(job, at, [&](const Progress& p) { op->plan(context, p); }),
                         qPrintable(QString::number(at)));
            }
            // The operation and what it shares are as before.
            QVERIFY(path_numbers(op->plan(context, Progress())) == reference);
        }
    }

    void allowance_stays_on() {
        const Shape part = shapes()[2]; // cap
        const Tool tool = bull_tool(6, 1.5);
        PlanContext context = context_of(part.mesh, tool);
        // Stock over the allowance: where there is none nothing is cut.
        context.stock_box.hi.z() += 1;
        context.stock.box = context.stock_box;
        for (const std::string& kind : three_axis_kinds()) {
            const auto op = operation(kind, 0.05);
            op->common().allowance = 0.3;
            PathCheckOptions options;
            options.spacing = 0.5;
            options.border = 4;
            options.allowance = 0.3;
            const auto path = tips(linked(op->plan(context, Progress()), context, *op));
            PathCheckResult result = check_path(part.mesh, tool.cutter(), path, options);
            QVERIFY2(result.gouge_max <= 0.0025, qPrintable(QString::number(result.gouge_max)));
            const bool scallop = kind == "scallop";
            const double high = scallop ? result.cusp_p999 : result.cusp_max;
            QVERIFY2(high <= (scallop ? 0.0525 : 0.052),
                     qPrintable(QString("%1: %2").arg(kind.c_str()).arg(high)));
            // and it is there: nothing is nearer to the part itself.
            options.allowance = 0;
            result = check_path(part.mesh, tool.cutter(), path, options);
            QVERIFY(result.cusp_p50 >= 0.299);
        }
    }

    void edges_of_steep_walls_are_kept_data() {
        QTest::addColumn<double>("corner");
        QTest::addColumn<double>("tolerance");
        for (const auto& [corner, tolerance] : {std::pair(6.0, 0.1), {6.0, 0.3}, {2.0, 0.1}})
            QTest::addRow("corner radius %g, tolerance %g", corner, tolerance) << corner << tolerance;
    }

    /// A pocket and a boss with walls of three degrees of draft: the tip comes over an edge, goes down a wall
    /// and on over a floor within a fraction of a millimetre, and where passes graze a wall, down part of it.
    /// How deep an edge comes into the cutter is measured here, at the cutter's nearest place.
    void edges_of_steep_walls_are_kept() {
        QFETCH(double, corner);
        QFETCH(double, tolerance);
        const double radius = 6;
        const auto part = make_sample("mould", 0.1, Progress());
        const Tool tool = bull_tool(2 * radius, corner);
        const PlanContext context = context_of(*part, tool);
        // The opening of the pocket and the top of the boss: lo and hi in x and y, height.
        const std::array<std::array<double, 5>, 2> rims{{{-40, -30, 40, 30, 0}, {-8, -12, 20, 4, -8}}};
        const auto depth = [&](const Vec3& tip) {
            double deepest = -infinity;
            for (const auto& [x0, y0, x1, y1, z] : rims) {
                const double h = z - tip.z();
                if (h <= 0) continue;
                // Of a level rim the place nearest to the axis is the deepest.
                const double x = std::clamp(tip.x(), x0, x1), y = std::clamp(tip.y(), y0, y1);
                double rho = std::hypot(x - tip.x(), y - tip.y());
                if (rho == 0) rho = std::min({tip.x() - x0, x1 - tip.x(), tip.y() - y0, y1 - tip.y()});
                const double in = radius - corner;
                deepest = std::max(deepest, rho > in && h < corner ? corner - std::hypot(rho - in, corner - h)
                                                                   : std::min(h, radius - rho));
            }
            return deepest;
        };
        for (const std::string& kind : three_axis_kinds())
            for (const char* direction : {"x", "y"}) {
                if (has_no_direction(kind) && *direction == 'y') continue;
                const auto op = operation(kind, tolerance);
                op->common().direction = {0, direction};
                const TipLine line = tips(linked(op->plan(context, Progress()), context, *op)).front();
                double deepest = -infinity;
                for (std::size_t i = 1; i < line.size(); ++i)
                    for (int k = 0; k <= 32; ++k)
                        deepest = std::max(deepest, depth(line[i - 1] + k / 32.0 * (line[i] - line[i - 1])));
                QVERIFY2(deepest > -1e-3 && deepest <= tolerance / 20, qPrintable(QString::number(deepest)));
            }
    }

    /// A steep cone on a level part: the passes over the part lie as far apart as without it, those that it
    /// asks for are partial, and all of it is cut to the tolerance.
    void one_steep_spot_does_not_thin_whole_passes() {
        const Vec2 lo(-25, -10), hi(25, 10);
        const auto cone = [](double x, double y) { return std::max(0.0, 6 - 2.5 * std::hypot(x - 8, y)); };
        const Mesh part = height_field(cone, lo, hi, 100, 40);
        const Mesh level = height_field([](double, double) { return 0.0; }, lo, hi, 2, 2);
        for (const Tool& tool : {ball_tool(6), bull_tool(8, 2)}) {
            const auto op = operation("finish3", 0.05);
            op->common().direction = {0, "x"};
            const PlanContext context = context_of(part, tool);
            const StrategyResult without = op->plan(context_of(level, tool), Progress());
            const StrategyResult path = op->plan(context, Progress());
            QVERIFY2(path.drive_planes <= 1.2 * without.drive_planes + 2,
                     qPrintable(QString("%1, %2").arg(path.drive_planes).arg(without.drive_planes)));
            QVERIFY(path.passes.size() > std::size_t(path.drive_planes) + 5);
            PathCheckOptions options;
            options.spacing = 0.3;
            options.border = 3;
            // Beside the foot of the cone no tool of this size comes to.
            options.no_cusp = [&](const Vec3& p) {
                return std::abs(std::hypot(p.x() - 8, p.y()) - 2.4) < 2.2;
            };
            const PathCheckResult result =
                check_path(part, tool.cutter(), tips(linked(path, context, *op)), options);
            QVERIFY(result.cusp_samples > 5000);
            QVERIFY2(result.gouge_max <= 0.0025, qPrintable(QString::number(result.gouge_max)));
            QVERIFY2(result.cusp_max <= 0.052, qPrintable(QString::number(result.cusp_max)));
        }
    }

    /// A wide holder beside a step, and a shank thicker than the cutter: passes and links keep both out of
    /// the part, what they leave is said, and the length that is said to reach it does.
    void shank_and_holder_keep_out() {
        const Mesh part = turned(step(0, 12), 0.3);
        for (const bool thick_shank : {false, true})
            for (const double clearance : {0.0, 1.0}) {
                Tool tool = ball_tool(6);
                tool.flute_length = thick_shank ? 5 : 8;
                tool.shank_diameter = thick_shank ? 10 : 5;
                tool.shank_length = 1;
                tool.holder = {{14, 40}};
                const PlanContext context = context_of(part, tool);
                const auto op = operation("finish3", 0.1);
                op->set("stepover", 1.5);
                op->set("holder_clearance", clearance);
                const StrategyResult path = op->plan(context, Progress());
                QVERIFY(std::ranges::any_of(path.warnings, [&](const std::string& w) {
                    return w.find(thick_shank ? "flutes of " : "a stick-out of ") != std::string::npos;
                }));
                LinkOptions options = default_link_options(path, context, op->common());
                options.holder_clearance = op->holder_clearance();
                options.link_distance = 100; // over the surface wherever it may
                const TipLine line = tips(link_three_axis(path, context, 0, options, Progress())).front();
                ToolClearance kept;
                kept.shank = kept.holder = clearance;
                // Straight moves run beside the exact path by the chord tolerance at most, on a steep wall
                // too, where the lift along the axis is any multiple of that: so the ball is smaller by it.
                Tool above = tool;
                above.diameter -= 2 * options.chord_tolerance;
                above.corner_radius -= options.chord_tolerance;
                const ToolLift lift(context.contact, above, kept);
                ToolLift::Hint hint;
                double low = infinity;
                for (std::size_t i = 1; i < line.size(); ++i)
                    for (int k = 0; k <= 16; ++k) {
                        const Vec3 tip = line[i - 1] + k / 16.0 * (line[i] - line[i - 1]);
                        low = std::min(low, tip.z());
                        const Vec3 end = tip + options.chord_tolerance * Vec3::UnitZ();
                        QVERIFY(!lift.is_deeper({end, Vec3(0, 0, 1)}, 0.0005, hint));
                    }
                QVERIFY(low < 0.01); // where there is room, it is cut
                // A tool as long as is said to reach it needs nothing.
                tool.flute_length = 12 + clearance + 0.1;
                const StrategyResult all = op->plan(context_of(part, tool), Progress());
                QVERIFY(std::ranges::none_of(all.warnings, [](const std::string& w) {
                    return w.find("left out") != std::string::npos;
                }));
            }
    }

    void an_upright_wall_is_cut_to_tolerance() {
        for (const double angle : {0.0, 0.4, 0.5 * pi}) {
            const Mesh part = turned(step(0, 8), angle);
            const Tool tool = ball_tool(5);
            const PlanContext context = context_of(part, tool);
            for (const std::string& kind : three_axis_kinds()) {
                const auto op = operation(kind, 0.05);
                op->common().direction = {0, "x"};
                PathCheckOptions options;
                options.spacing = 0.3;
                options.border = 5;
                options.lowest_normal = -1; // the wall too
                // Only the wall is judged, above the corner that the ball cannot fill.
                options.no_cusp = [&](const Vec3& p) {
                    const Vec3 q = Eigen::AngleAxisd(-angle, Vec3::UnitZ()) * p;
                    return std::abs(q.y()) > 1e-6 || q.z() < 2.5 || q.z() > 8 - 1e-6 || std::abs(q.x()) > 14;
                };
                options.border = 0;
                const StrategyResult path = op->plan(context, Progress());
                const PathCheckResult result =
                    check_path(part, tool.cutter(), tips(linked(path, context, *op)), options);
                QVERIFY(result.cusp_samples > 500);
                QVERIFY2(result.gouge_max <= 0.0025, qPrintable(QString::number(result.gouge_max)));
                if (kind == "scallop") // its slope limit leaves walls to others, and says so
                    QVERIFY(std::ranges::any_of(path.warnings, [](const std::string& w) {
                        return w.find("steeper than the slope limit") != std::string::npos;
                    }));
                else
                    QVERIFY2(result.cusp_max <= 0.052, qPrintable(QString::number(result.cusp_max)));
            }
        }
    }
};

FACETMILL_TEST(TestThreeAxis)
#include "test_three_axis.moc"
