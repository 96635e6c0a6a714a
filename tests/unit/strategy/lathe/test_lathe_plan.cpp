// Plans on a turning part: points a turn, exact CL points, roughing passes, what is said and what is refused.
#include "core/mesh/sample.h"
#include "core/strategy/lathe/lathe_field.h"
#include "core/strategy/lathe/lathe_finish.h"
#include "core/strategy/lathe/lathe_rough.h"
#include "tests/property/shapes.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

PlanContext turning(const Mesh& part, const Tool& tool, double stock_radius = 0) {
    PlanContext c = context_of(part, tool);
    c.machine = find_machine("lathe-mill");
    c.stock.kind = StockSolid::Kind::cylinder;
    c.stock.axis = 0;
    double radius = stock_radius;
    if (radius == 0)
        for (const Vec3& v : part.vertices)
            radius = std::max(radius, std::hypot(v.y(), v.z()));
    c.stock.radius = radius;
    c.stock_box = c.part_box;
    for (const int k : {1, 2}) {
        c.stock_box.lo[k] = -radius;
        c.stock_box.hi[k] = radius;
    }
    c.stock.box = c.stock_box;
    return c;
}

Mesh sample(const char* name, double tolerance = 0.05) {
    return *make_sample(name, tolerance, Progress());
}

bool warned(const StrategyResult& path, const char* what) {
    for (const std::string& w : path.warnings)
        if (w.find(what) != std::string::npos) return true;
    return false;
}

/// Distance of a tip from the turning axis X.
double away(const CutterLocation& c) {
    return std::hypot(c.tip.y(), c.tip.z());
}

} // namespace

class TestLathePlan : public QObject {
    Q_OBJECT
private slots:
    void points_per_turn_are_kept() {
        const Mesh part = sample("square-prism");
        LatheFinishSettings s;
        s.points_per_turn = {720, ""};
        s.side_feed = {4, ""};
        s.tolerance = 1;
        s.chord_tolerance = {0.01, ""};
        const PlanContext context = turning(part, ball_tool(12.7));
        const StrategyResult path = LatheFinish(s).plan(context, Progress());
        // One ring in place, ten turns over 40 mm, one in place.
        QCOMPARE(path.drive_planes, 12);
        const LatheField field(s, context, 0, Progress());
        LatheField::Hint hint;
        std::size_t even = 0, all = 0;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 0; i < pass.cl.size(); ++i) {
                const CutterLocation& c = pass.cl[i];
                QVERIFY(std::abs(c.axis.x()) < 1e-15);
                const double angle = std::atan2(-c.axis.y(), c.axis.z());
                // Exact, at the places between, too.
                QVERIFY(std::abs(away(c) - field.u({angle, c.tip.x()}, hint)) < 1e-9);
                const double step = angle / (2 * pi / 720);
                even += std::abs(step - std::round(step)) < 1e-6;
                ++all;
            }
        QVERIFY2(even >= 12 * 720 && all < 2 * even, qPrintable(QString("%1 of %2").arg(even).arg(all)));
        QVERIFY(path.as<TurnedPath>() && path.as<TurnedPath>()->from == 0 && path.as<TurnedPath>()->to == 40);
        // Of a level prism a side feed of 4 with r = 6.35 leaves 0.323, plus what motions may be off.
        QVERIFY2(std::abs(path.cusp_max - (0.3232 + path.chord_tolerance)) < 0.02,
                 qPrintable(QString::number(path.cusp_max)));
    }

    void passes_follow_each_other() {
        const Mesh part = sample("twisted-prism");
        for (const auto pattern :
             {LatheCommon::Pattern::helix, LatheCommon::Pattern::rings, LatheCommon::Pattern::lengthwise}) {
            LatheFinishSettings s;
            s.pattern = pattern;
            s.tolerance = 0.3;
            const StrategyResult path = LatheFinish(s).plan(turning(part, ball_tool(8)), Progress());
            QVERIFY(path.drive_planes > 8);
            QVERIFY(path.warnings.empty());
            QCOMPARE(std::size_t(path.drive_planes), path.passes.size());
            for (std::size_t i = 1; i < path.passes.size(); ++i) {
                QCOMPARE(path.passes[i].cl.front().tip, path.passes[i - 1].cl.back().tip);
                QCOMPARE(path.passes[i].cl.size(), path.passes[i].cc.size());
            }
            // Contacts are on the part: no farther out than its corners, no nearer than its sides.
            for (const Pass& pass : path.passes)
                for (std::size_t i = 0; i < pass.cc.size(); ++i) {
                    const double r = std::hypot(pass.cc[i].point.y(), pass.cc[i].point.z());
                    QVERIFY(r >= 22.4 && r <= 22.5 * std::sqrt(2.0) + 1e-6);
                    QVERIFY(std::abs(pass.cc[i].normal.norm() - 1) < 1e-9);
                    // A ball touches where its centre lies along the normal.
                    const Vec3 center = pass.cl[i].tip + 4 * pass.cl[i].axis;
                    QVERIFY(std::abs((center - pass.cc[i].point).norm() - 4) < 1e-6);
                }
        }
    }

    void roughing_goes_in_by_the_depth_of_cut() {
        const Mesh part = sample("square-prism");
        LatheRoughSettings s;
        s.depth_of_cut = 3;
        s.finishing_allowance = 2; // Jasra's
        s.side_feed = {3, ""};
        s.tolerance = 1;
        const PlanContext context = turning(part, ball_tool(12.7), 40);
        const StrategyResult path = LatheRough(s).plan(context, Progress());
        // From 40 to 25 + 2.
        QCOMPARE(path.as<TurnedPath>()->layers.size(), std::size_t(5));
        QVERIFY(std::abs(path.as<TurnedPath>()->layers.front() - 37) < 0.01);
        QVERIFY(std::abs(path.as<TurnedPath>()->layers.back() - 27) < 0.01);
        const LatheField field(s, context, 2, Progress());
        LatheField::Hint hint;
        int layer = 0;
        for (const Pass& pass : path.passes) {
            QVERIFY(pass.layer == layer || pass.layer == layer + 1);
            layer = pass.layer;
            for (const auto& route : {pass.entry, pass.cl})
                for (const CutterLocation& c : route) {
                    const double angle = std::atan2(-c.axis.y(), c.axis.z());
                    // U_selected or U_file, the outer one, and never into the allowance.
                    const double file = field.u({angle, c.tip.x()}, hint);
                    QVERIFY(away(c) >= file - path.chord_tolerance);
                    QVERIFY(away(c) >= path.as<TurnedPath>()->layers[std::size_t(layer)] - 1e-9);
                    if (&route == &pass.cl)
                        QVERIFY(away(c) <= std::max(file, path.as<TurnedPath>()->layers[std::size_t(layer)])
                                               + path.chord_tolerance);
                }
        }
        QCOMPARE(layer, 4);
        // The first passes go round in one go and begin with a ramp; where only the flats are left, pieces
        // beside the corners are air and are not cut.
        QCOMPARE(
            std::count_if(path.passes.begin(), path.passes.end(), [](const Pass& p) { return p.layer == 0; }),
            std::ptrdiff_t(1));
        const Pass& first = path.passes.front();
        QVERIFY(first.entry.size() > 100);
        QVERIFY(std::abs(away(first.entry.front()) - 40) < 0.01);
        QVERIFY((first.entry.back().tip - first.cl.front().tip).norm() < 1e-9);
        double most = 0, least = infinity;
        for (const Pass& p : path.passes)
            if (p.layer == 4)
                for (const CutterLocation& c : p.cl) {
                    most = std::max(most, away(c));
                    least = std::min(least, away(c));
                }
        QVERIFY2(most < 31, qPrintable(QString::number(most)));
        QVERIFY(std::abs(least - 27) < 0.05);
    }

    void roughing_leaves_air_out() {
        // Square stock round a square prism: everywhere 4 mm stand.
        const Mesh part = sample("square-prism");
        PlanContext context = turning(part, ball_tool(12.7));
        context.stock = {};
        context.stock.box = context.stock_box = {Vec3(0, -29, -29), Vec3(40, 29, 29)};
        LatheRoughSettings s;
        s.depth_of_cut = 2;
        s.side_feed = {3, ""};
        s.tolerance = 1;
        const StrategyResult square = LatheRough(s).plan(context, Progress());
        // In the corners' way only: the first pass is in many pieces.
        const auto pieces = std::count_if(square.passes.begin(), square.passes.end(),
                                          [](const Pass& p) { return p.layer == 0; });
        QVERIFY2(pieces > 20, qPrintable(QString::number(pieces)));
        // The same as a mesh.
        context.stock.kind = StockSolid::Kind::mesh;
        context.stock.mesh = std::make_shared<Mesh>(box(Vec3(0, -29, -29), Vec3(40, 29, 29)));
        const StrategyResult mesh = LatheRough(s).plan(context, Progress());
        QCOMPARE(mesh.passes.size(), square.passes.size());
        QCOMPARE(mesh.as<TurnedPath>()->layers, square.as<TurnedPath>()->layers);
        double length[2] = {0, 0};
        for (const StrategyResult* path : {&square})
            for (const Pass& p : path->passes)
                for (std::size_t i = 1; i < p.cl.size(); ++i)
                    length[0] += (p.cl[i].tip - p.cl[i - 1].tip).norm();
        const StrategyResult round =
            LatheRough(s).plan(turning(part, ball_tool(12.7), 29 * std::sqrt(2.0)), Progress());
        for (const Pass& p : round.passes)
            for (std::size_t i = 1; i < p.cl.size(); ++i)
                length[1] += (p.cl[i].tip - p.cl[i - 1].tip).norm();
        QVERIFY2(length[0] < 0.8 * length[1], qPrintable(QString("%1 %2").arg(length[0]).arg(length[1])));
    }

    void odd_roughing_is_said() {
        const Mesh part = sample("square-prism");
        const PlanContext context = turning(part, ball_tool(12.7), 40);
        LatheRoughSettings s;
        s.tolerance = 1;
        s.side_feed = {3, ""};
        s.depth_of_cut = 100;
        const StrategyResult path = LatheRough(s).plan(context, Progress());
        QCOMPARE(path.as<TurnedPath>()->layers.size(), std::size_t(1));
        QVERIFY(warned(path, "one pass"));
        s.finishing_allowance = 50;
        std::string said;
        QCOMPARE(code_of([&] { LatheRough(s).plan(context, Progress()); }, &said),
                 std::string("empty_result"));
        QVERIFY2(said.find("allowance") != std::string::npos, said.c_str());
        s.finishing_allowance = 0.5;
        s.depth_of_cut = 1e-4;
        QCOMPARE(code_of([&] { LatheRough(s).plan(context, Progress()); }), std::string("limit_exceeded"));
    }

    void what_is_odd_is_said() {
        const Mesh part = sample("square-prism");
        LatheFinishSettings s;
        s.tolerance = 0.5;
        s.side_feed = {3, ""};
        PlanContext context = turning(part, ball_tool(8));
        QVERIFY(LatheFinish(s).plan(context, Progress()).warnings.empty());
        context.machine = find_machine("generic-3-axis");
        QVERIFY(warned(LatheFinish(s).plan(context, Progress()), "lathe-mill"));
        context.machine = find_machine("generic-4-axis-a");
        QVERIFY(LatheFinish(s).plan(context, Progress()).warnings.empty());
        s.direction = {0, "y"};
        QVERIFY(warned(LatheFinish(s).plan(context, Progress()), "direction"));
        s.direction = {0, "auto"};
        s.side_feed = {20, ""};
        QVERIFY(warned(LatheFinish(s).plan(context, Progress()), "side feed"));
        s.side_feed = {3, ""};
        // A part off the axis.
        Mesh moved = part;
        for (Vec3& v : moved.vertices)
            v += Vec3(0, 10, 0);
        context = turning(moved, ball_tool(8));
        QVERIFY(warned(LatheFinish(s).plan(context, Progress()), "off the turning axis"));
        // A stock that does not hold it.
        context = turning(part, ball_tool(8), 30);
        QVERIFY(warned(LatheFinish(s).plan(context, Progress()), "does not hold the part"));
        // A slot through it.
        Mesh slotted = box(Vec3(0, -20, -20), Vec3(10, 20, 20));
        const Mesh other = box(Vec3(30, -20, -20), Vec3(40, 20, 20));
        for (const Facet& f : other.facets)
            slotted.facets.push_back({f[0] + 8, f[1] + 8, f[2] + 8});
        slotted.vertices.insert(slotted.vertices.end(), other.vertices.begin(), other.vertices.end());
        context = turning(slotted, ball_tool(8));
        const StrategyResult guarded = LatheFinish(s).plan(context, Progress());
        QVERIFY(warned(guarded, "core radius") && guarded.as<TurnedPath>()->at_core > 0);
    }

    void bad_input_is_refused_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("code");
        const auto add = [](const char* key, const char* value, const char* code) {
            QTest::addRow("%s %s", key, value) << key << value << code;
        };
        add("side_feed", "0", "out_of_range");
        add("side_feed", "-1", "out_of_range");
        add("points_per_turn", "2", "out_of_range");
        add("depth_of_cut", "0", "out_of_range");
        add("finishing_allowance", "-1", "out_of_range");
        add("axis", "w", "out_of_range");
        add("tilt", "85", "out_of_range");
        add("core_radius", "nan", "out_of_range");
        add("chuck", "-1, 20", "out_of_range");
    }
    void bad_input_is_refused() {
        QFETCH(QString, key);
        QFETCH(QString, value);
        QFETCH(QString, code);
        const auto op = make_operation("lathe_rough");
        const std::string k = key.toStdString();
        std::string said;
        const std::string got = code_of(
            [&] {
                const ParameterInfo& info = op->parameter(k);
                op->set(k, info.parse(value.toStdString(), LengthUnit::mm));
            },
            &said);
        QVERIFY2(got == code.toStdString() || (value == "nan" && got != "none"), got.c_str());
        QVERIFY2(said.find(k) != std::string::npos, said.c_str());
    }

    void bad_plans_are_refused() {
        const Mesh part = sample("square-prism");
        const PlanContext context = turning(part, ball_tool(8));
        const auto refused = [&](auto&& change) {
            LatheFinishSettings s;
            s.tolerance = 0.5;
            s.side_feed = {under_sanitizer ? 20.0 : 3.0, ""};
            change(s);
            return code_of([&] { LatheFinish(s).plan(context, Progress()); });
        };
        using S = LatheFinishSettings;
        const std::string none = "none", range = "out_of_range", empty = "empty_result",
                          limit = "limit_exceeded";
        QCOMPARE(refused([](S&) {}), none);
        QCOMPARE(refused([](S& s) {
                     s.axis = LatheCommon::Axis::points;
                     s.axis_from = s.axis_to = {1, 2, 3};
                 }),
                 range);
        QCOMPARE(refused([](S& s) {
                     s.axis = LatheCommon::Axis::points;
                     s.axis_from = {0, 60, 0};
                     s.axis_to = {40, 60, 0};
                 }),
                 range);
        QCOMPARE(refused([](S& s) { s.points_per_turn = {100.5, ""}; }), range);
        QCOMPARE(refused([](S& s) {
                     s.start = {30, ""};
                     s.stop = {20, ""};
                 }),
                 range);
        QCOMPARE(refused([](S& s) { s.start = {200, ""}; }), range);
        QCOMPARE(refused([](S& s) { s.chuck = {10, 0}; }), range);
        QCOMPARE(refused([](S& s) { s.side_feed = {1e-6, ""}; }), limit);
        QCOMPARE(refused([](S& s) { s.core_radius = 500; }), empty);
        QCOMPARE(refused([](S& s) { s.tolerance = 0; }), range);
    }
};

FACETMILL_TEST(TestLathePlan)
#include "test_lathe_plan.moc"
