// Rapids of upright tools between pieces of an operation: as low as part and stock allow, and no lower. The
// verifier, which knows nothing of how they were planned, finds nothing in them, and does find rapids at the
// same places that do not rise.
#include "core/base/parallel.h"
#include "core/link/link.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/support/path_checker.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double clearance = 5, top = 12;

/// A level floor at z = 0 in stock of which roughing took all but a pillar, at most; what the part itself has
/// in the middle may rise out of its stock.
struct Scene {
    Mesh part = box(Vec3(-40, -30, -5), Vec3(40, 30, 0));
    double stock_top = top;
    bool pillar = false; ///< of stock, round the middle
    Tool tool = ball_tool(6);
};

bool beside_pillar(double x, double y) {
    return std::abs(x) < 10 && std::abs(y) < 10;
}

/// Roughing along X with a flat end of 8 that keeps out of the pillar: half of its lines on each side of it.
ToolMotions roughing(const Scene& scene) {
    ToolMotions m;
    const auto to = [&](MotionKind kind, double x, double y, double z) {
        m.motions.push_back({kind, {Vec3(x, y, z), Vec3::UnitZ()}, no_index, no_index});
    };
    const auto line = [&](double x0, double x1, double y) {
        to(MotionKind::rapid, x0, y, 30);
        to(MotionKind::approach, x0, y, 0);
        to(MotionKind::cut, x1, y, 0);
        to(MotionKind::retract, x1, y, 30);
    };
    for (double y = -34; y <= 34; y += 4)
        if (scene.pillar && beside_pillar(0, y)) {
            line(-46, -10, y);
            line(10, 46, y);
        } else {
            line(-46, 46, y);
        }
    return m;
}

PlanContext scene_context(const Scene& scene) {
    PlanContext context = test::context_of(scene.part, scene.tool);
    context.stock.box = {Vec3(-42, -32, -5), Vec3(42, 32, scene.stock_top)};
    context.stock_box = context.stock.box;
    auto cuts = std::make_shared<EarlierCuts>();
    cuts->cutter = flat_tool(8).cutter();
    const ToolMotions rough = roughing(scene);
    for (std::size_t i = 1; i < rough.motions.size(); ++i)
        if (rough.motions[i].kind != MotionKind::rapid)
            cuts->motions.push_back({rough.motions[i - 1].to.tip, rough.motions[i].to.tip});
    context.earlier = {cuts};
    return context;
}

/// Short passes on the floor, to and fro over the middle.
StrategyResult passes(double y) {
    StrategyResult path;
    for (const double x : {-25.0, 25.0, -20.0, 20.0}) {
        Pass p;
        for (const double along : {-2.0, 2.0}) {
            p.cl.push_back({Vec3(x, y + along, 0), Vec3::UnitZ()});
            p.cc.push_back({Vec3(x, y + along, 0), Vec3::UnitZ()});
        }
        path.passes.push_back(p);
    }
    return path;
}

LinkOptions link_options() {
    LinkOptions options;
    options.clearance = clearance;
    options.link_distance = 2;
    return options;
}

/// Rapids that touch something.
std::size_t touches(const Scene& scene, const PlanContext& context, const ToolMotions& motions) {
    Tool rougher = flat_tool(8);
    const std::vector<VerifyProgram> programs{
        {"Rough", VerifyTool(rougher), std::make_shared<ToolMotions>(roughing(scene)), std::nullopt},
        {"Finish", VerifyTool(scene.tool), std::make_shared<ToolMotions>(motions), std::nullopt}};
    VerifySettings settings;
    settings.resolution = 0.5;
    settings.sample_spacing = 0.5;
    settings.tolerance = 0.1;
    settings.gouge_limit = 0.01;
    const Verification v = verify(*context.part, context.stock, programs, settings, Progress());
    return std::size_t(std::ranges::count_if(v.collisions, [](const Collision& c) {
        return c.kind == Collision::Kind::rapid && c.at.program == 1;
    }));
}

/// The lowest and the highest level rapid between passes.
std::pair<double, double> levels(const ToolMotions& m) {
    double low = infinity, high = -infinity;
    for (std::size_t i = 2; i < m.motions.size(); ++i) {
        const Vec3 a = m.motions[i - 1].to.tip, b = m.motions[i].to.tip;
        if (m.motions[i].kind != MotionKind::rapid || a.head<2>() == b.head<2>()) continue;
        low = std::min(low, b.z());
        high = std::max(high, b.z());
    }
    return {low, high};
}

/// The same with its level rapids at z, if they are higher.
ToolMotions lowered(ToolMotions m, double z) {
    for (std::size_t i = 1; i + 1 < m.motions.size(); ++i)
        if (m.motions[i].kind == MotionKind::rapid)
            m.motions[i].to.tip.z() = std::min(m.motions[i].to.tip.z(), z);
    return m;
}

void check(const Scene& scene, double y, double at_least, double at_most) {
    const PlanContext context = scene_context(scene);
    const ToolMotions m = link_three_axis(passes(y), context, 0, link_options(), Progress());
    const auto [low, high] = levels(m);
    QVERIFY2(
        low >= at_least && high <= at_most,
        qPrintable(QString("%1 to %2 instead of %3 to %4").arg(low).arg(high).arg(at_least).arg(at_most)));
    QCOMPARE(touches(scene, context, m), std::size_t(0));
    // Up and down stay where they were: only the level rapids are too low.
    if (at_least > clearance) QVERIFY(touches(scene, context, lowered(m, clearance)) > 0);
}

} // namespace

class TestLowRapids : public QObject {
    Q_OBJECT
private slots:
    void over_a_floor_that_is_roughed_they_run_low() { check({}, 0, clearance, clearance + 0.5); }

    void what_roughing_left_is_in_the_way() {
        Scene scene;
        scene.pillar = true;
        check(scene, 0, top + clearance - 0.5, top + clearance);
        // Beside it there is nothing.
        check(scene, 20, clearance, clearance + 0.5);
    }

    /// A post of the part, which stands out of its stock.
    void the_part_is_in_the_way() {
        Scene scene;
        scene.stock_top = 1;
        scene.part =
            height_field([](double x, double y) { return std::abs(x) < 4 && std::abs(y) < 4 ? 8.0 : 0.0; },
                         Vec2(-40, -30), Vec2(40, 30), 80, 60);
        check(scene, 0, 8 + clearance - 0.1, 8 + clearance);
        check(scene, 20, clearance, clearance + 0.5);
    }

    /// The cutter passes beside the pillar, what holds it would not.
    void shank_and_holder_ask_too() {
        for (const bool holder : {false, true}) {
            Scene scene;
            scene.pillar = true;
            scene.tool.flute_length = 4;
            scene.tool.shank_diameter = holder ? 6 : 16;
            scene.tool.shank_length = holder ? 2 : 40;
            if (holder) scene.tool.holder = {{16, 40}};
            const double base = scene.tool.flute_length + (holder ? scene.tool.shank_length : 0);
            check(scene, 13, top - base + clearance - 0.1, top - base + clearance + 0.1);
        }
    }

    /// A pass along a wall: a little away from it, where it is fed as in a cut, the tool need not go over it.
    void a_wall_beside_a_pass_is_left_sideways() {
        Scene scene;
        scene.part = height_field([](double x, double) { return std::abs(x) > 28.02 ? 20.0 : 0.0; },
                                  Vec2(-40, -30), Vec2(40, 30), 1600, 4);
        const PlanContext context = scene_context(scene);
        const ToolMotions m = link_three_axis(passes(0), context, 0, link_options(), Progress());
        QVERIFY(levels(m).second < clearance + 0.5);
        std::size_t sideways = 0;
        for (std::size_t i = 1; i < m.motions.size(); ++i)
            sideways += m.motions[i].kind == MotionKind::cut && m.motions[i].pass == no_index;
        QVERIFY(sideways > 0);
        PathCheckOptions options;
        options.spacing = 0.2;
        TipLine line;
        for (const Motion& motion : m.motions)
            line.push_back(motion.to.tip);
        const std::vector<TipLine> tips{line};
        QVERIFY(check_path(scene.part, scene.tool.cutter(), tips, options).gouge_max <= 0.002);
    }

    void threads_do_not_change_them() {
        Scene scene;
        scene.pillar = true;
        std::vector<std::vector<double>> runs;
        for (const int threads : {1, 4}) {
            set_thread_count(threads);
            const ToolMotions m =
                link_three_axis(passes(0), scene_context(scene), 0, link_options(), Progress());
            std::vector<double> numbers;
            for (const Motion& motion : m.motions)
                numbers.insert(numbers.end(), motion.to.tip.begin(), motion.to.tip.end());
            runs.push_back(std::move(numbers));
        }
        set_thread_count(0);
        QCOMPARE(runs[0].size(), runs[1].size());
        QVERIFY(std::memcmp(runs[0].data(), runs[1].data(), runs[0].size() * sizeof(double)) == 0);
    }
};

FACETMILL_TEST(TestLowRapids)
#include "test_low_rapids.moc"
