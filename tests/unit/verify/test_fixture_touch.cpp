// Tools in fixtures: depths that are known, of every body, in cuts and rapids, and none where there is none.
#include "core/verify/fixture_touch.h"
#include "core/verify/verify.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A block of 20 x 20 x 20 with its top at z = 0.
std::shared_ptr<const std::vector<FixtureSolid>> block() {
    auto mesh = std::make_shared<Mesh>(box(Vec3(-10, -10, -20), Vec3(10, 10, 0)));
    return std::make_shared<const std::vector<FixtureSolid>>(
        std::vector<FixtureSolid>{{"Block", mesh, nullptr, 1}});
}

Tool long_tool() {
    Tool tool = ball_tool(6);
    tool.flute_length = 10;
    tool.shank_diameter = 6;
    tool.shank_length = 10;
    tool.holder = {{20, 20}};
    return tool;
}

std::vector<Collision> touches(const std::vector<Motion>& motions) {
    auto path = std::make_shared<ToolMotions>();
    path->motions = motions;
    std::vector<VerifyProgram> programs{{"Test", VerifyTool(long_tool()), path, std::nullopt}};
    programs[0].fixtures = block();
    return fixture_touches(programs, 1e-4, {});
}

Motion to(MotionKind kind, double x, double y, double z, const Vec3& axis = Vec3::UnitZ()) {
    return {kind, {Vec3(x, y, z), axis}, no_index, no_index};
}

} // namespace

class TestFixtureTouch : public QObject {
    Q_OBJECT
private slots:
    void a_ball_over_the_top() {
        using K = MotionKind;
        QVERIFY(touches({to(K::rapid, -40, 0, 0.01), to(K::cut, 40, 0, 0.01)}).empty());
        auto found = touches({to(K::rapid, -40, 0, -0.5), to(K::cut, 40, 0, -0.5)});
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found[0].kind == Collision::Kind::cutter);
        QCOMPARE(found[0].at, (MotionPlace{0, 1}));
        QCOMPARE(found[0].fixture, std::string("Block"));
        QVERIFY(!found[0].with_part);
        QVERIFY2(std::abs(found[0].depth - 0.5) < 0.02, qPrintable(QString::number(found[0].depth)));
        found = touches({to(K::rapid, -40, 0, -0.5), to(K::rapid, 40, 0, -0.5)});
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found[0].kind == Collision::Kind::rapid);
    }
    void shank_and_holder_beside_it() {
        using K = MotionKind;
        // Down beside the wall at x = 10: the cutter has a radius of 3, the holder one of 10 from 20 up.
        QVERIFY(touches({to(K::rapid, 13.01, 0, 30), to(K::cut, 13.01, 0, -19.9)}).empty());
        auto found = touches({to(K::rapid, 13.01, 0, 30), to(K::cut, 13.01, 0, -21)});
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found[0].kind == Collision::Kind::holder);
        QVERIFY2(std::abs(found[0].depth - 1) < 0.02, qPrintable(QString::number(found[0].depth)));
        found = touches({to(K::rapid, 12.9, 0, 30), to(K::cut, 12.9, 0, -19)});
        QCOMPARE(found.size(), std::size_t(2));
        QVERIFY(found[0].kind == Collision::Kind::shank && found[1].kind == Collision::Kind::cutter);
        for (const Collision& c : found)
            QVERIFY2(std::abs(c.depth - 0.1) < 0.01, qPrintable(QString::number(c.depth)));
    }
    /// The holder swings into the block where the tool only turns.
    void a_turn_is_followed() {
        using K = MotionKind;
        const Vec3 leaning(-std::sin(radians(60)), 0, std::cos(radians(60)));
        QVERIFY(touches({to(K::rapid, 24, 0, -5), to(K::cut, 24, 0, -5)}).empty());
        const auto found = touches({to(K::rapid, 24, 0, -5), to(K::cut, 24, 0, -5, leaning)});
        QVERIFY(!found.empty());
        QVERIFY(std::any_of(found.begin(), found.end(),
                            [](const Collision& c) { return c.kind == Collision::Kind::holder; }));
    }
    /// Small tips in a large plate: wherever they dip in they are found, as deep as they are.
    void a_fine_tip_in_a_large_plate() {
        using K = MotionKind;
        Tool tool = ball_tool(1);
        tool.taper_angle = radians(10);
        tool.flute_length = 8;
        tool.shank_length = 0;
        const auto plate = std::make_shared<const std::vector<FixtureSolid>>(std::vector<FixtureSolid>{
            {"Plate", std::make_shared<Mesh>(box(Vec3(-300, -200, -20), Vec3(300, 200, 0))), nullptr, 1}});
        for (int k = 0; k < 20; ++k) {
            const double x = 283.7 * std::sin(1.3 * k), y = 191.1 * std::cos(2.1 * k);
            auto path = std::make_shared<ToolMotions>();
            path->motions = {to(K::rapid, x, y, 5), to(K::cut, x, y, -0.1), to(K::cut, x, y, 5)};
            std::vector<VerifyProgram> programs{{"Test", VerifyTool(tool), path, std::nullopt}};
            programs[0].fixtures = plate;
            const auto found = fixture_touches(programs, 1e-4, {});
            QCOMPARE(found.size(), std::size_t(1));
            QVERIFY2(std::abs(found[0].depth - 0.1) < 0.01, qPrintable(QString::number(found[0].depth)));
            path->motions[1].to.tip.z() = 0.001;
            QVERIFY(fixture_touches(programs, 1e-4, {}).empty());
        }
    }
    void a_program_that_begins_inside() {
        using K = MotionKind;
        auto path = std::make_shared<ToolMotions>();
        path->motions = {to(K::cut, 0, 0, -50), to(K::cut, 1, 0, -50)};
        Tool tool = ball_tool(6);
        tool.flute_length = 5;
        tool.shank_length = 0;
        std::vector<VerifyProgram> programs{{"Test", VerifyTool(tool), path, std::nullopt}};
        // Whichever way its mesh is wound.
        for (const bool inward : {false, true}) {
            auto big = std::make_shared<Mesh>(box(Vec3(-100, -100, -100), Vec3(100, 100, 0)));
            for (Facet& f : big->facets)
                if (inward) std::swap(f[1], f[2]);
            programs[0].fixtures = std::make_shared<const std::vector<FixtureSolid>>(
                std::vector<FixtureSolid>{{"Big", big, nullptr, 1}});
            const auto found = fixture_touches(programs, 1e-4, {});
            QCOMPARE(found.size(), std::size_t(1));
            QCOMPARE(found[0].at, (MotionPlace{0, 0}));
            QVERIFY(found[0].kind == Collision::Kind::cutter);
        }
    }
    void the_verdict_fails_for_it() {
        using K = MotionKind;
        const Mesh part = box(Vec3(-40, -20, -30), Vec3(-20, 20, -5));
        auto path = std::make_shared<ToolMotions>();
        path->motions = {to(K::rapid, -30, 0, 5), to(K::cut, -25, 0, 0.5), to(K::rapid, -25, 0, 5),
                         to(K::rapid, 0, 0, 5), to(K::rapid, 0, 0, -0.3)};
        std::vector<VerifyProgram> programs{{"Test", VerifyTool(long_tool()), path, std::nullopt}};
        StockSolid stock;
        stock.box = Box3{Vec3(-40, -20, -30), Vec3(-20, 20, 1)};
        VerifySettings settings;
        settings.resolution = settings.sample_spacing = 1;
        settings.gouge_limit = 0.1;
        Verification v = verify(part, stock, programs, settings, {});
        QVERIFY(v.collisions.empty() && v.verdict() != Verdict::failed);
        programs[0].fixtures = block();
        v = verify(part, stock, programs, settings, {});
        QCOMPARE(v.collisions.size(), std::size_t(1));
        QCOMPARE(v.collisions[0].fixture, std::string("Block"));
        QVERIFY(v.verdict() == Verdict::failed);
    }
};

FACETMILL_TEST(TestFixtureTouch)
#include "test_fixture_touch.moc"
