// A tool inclined along one pass: clear of the part between locations, the middle of a ball on its way, the
// axis within what the machine holds.
#include "core/gouge/axial_lift.h"
#include "core/strategy/five_axis/even_motion.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/tilt/axis_tilt.h"
#include "tests/property/shapes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A floor and a tall wall that leans back and winds along X.
Mesh winding_wall() {
    const double high = 30, back = high * std::tan(radians(10));
    const std::vector<Vec2> profile{{-30, 0},     {-8, 0},   {0, 0}, {0.2 * back, 0.2 * high},
                                    {back, high}, {30, high}};
    Mesh m;
    const int columns = 160;
    for (const Vec2& p : profile)
        for (int i = 0; i <= columns; ++i) {
            const double x = -16 + 32.0 * i / columns;
            m.vertices.emplace_back(x, p.x() + 2 * std::sin(x / 3), p.y());
        }
    const auto at = [&](int i, int j) { return Index(j * (columns + 1) + i); };
    for (int j = 0; j + 1 < int(profile.size()); ++j)
        for (int i = 0; i < columns; ++i) {
            m.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            m.facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return m;
}

QString told(double share, double found) {
    return QString("at %1: %2").arg(share).arg(found);
}

/// A ball whose holder would touch the wall, and a pass along its foot.
struct AlongWall {
    Mesh part = winding_wall();
    Tool tool;
    PlanContext context;
    Pass pass;
    std::optional<ToolLift> whole;
    TiltInput input;

    AlongWall() {
        tool = ball_tool(4);
        tool.flute_length = 12;
        tool.shank_length = 6;
        tool.holder = {{24, 30}};
        context = context_of(part, tool);
        whole.emplace(context.contact, tool, ToolClearance{0, 0, 0});
        const CutterProfile profile(tool.cutter());
        const AxialLift lift(context.contact, profile);
        const CutterCover cover(profile, 0.001);
        for (double x = -12; x <= 12; x += 1.5) {
            const double y = 2 * std::sin(x / 3) - 1.8;
            const AxialContact c = lift.contact(x, y);
            const Vec3 tip(x, y, c.tip_z);
            pass.cl.push_back({tip, Vec3::UnitZ()});
            pass.cc.push_back({c.point, cover.contact_normal(c.point - tip).value_or(Vec3::UnitZ())});
        }
        input.whole = &*whole;
        input.limit = radians(50);
        input.chord = 0.005;
        input.raise = 0.1;
    }
    AlongWall(const AlongWall&) = delete;
    AlongWall& operator=(const AlongWall&) = delete;
};

} // namespace

class TestAxisTilt : public QObject {
    Q_OBJECT
private slots:
    /// The constant by which motions are looked at, at half and at double: at half nothing is worse; at
    /// double it stays within what it promises, and beyond that the check sees it.
    void inclined_motions_keep_clear_of_the_part() {
        AlongWall job;
        const auto deepest = [&](double share, double& length) {
            job.input.looked_share = share;
            double most = 0;
            length = 0;
            ToolLift::Hint hint;
            for (const Pass& p : tilted_where_held(job.input, job.pass, Progress()).passes)
                for (std::size_t i = 1; i < p.cl.size(); ++i) {
                    length += (p.cl[i].tip - p.cl[i - 1].tip).norm();
                    for (int k = 0; k <= 100; ++k) {
                        const CutterLocation at = location_on_route(p.cl[i - 1], p.cl[i], k / 100.0);
                        most = std::max(most, job.whole->lift({at.tip, at.axis}, hint));
                    }
                }
            return most;
        };
        const double usual = TiltInput().looked_share;
        double length = 0;
        for (const auto& [factor, allowed] : {std::pair(0.5, 1.0), {1.0, 1.0}, {2.0, 1.5}}) {
            const double most = deepest(factor * usual, length);
            qInfo("%s, %g mm", qPrintable(told(factor, most)), length);
            QVERIFY2(most <= allowed * job.input.chord, qPrintable(told(factor, most)));
            QVERIFY(length > 15);
        }
    }

    /// It goes straight from place to place of the pass, with the axis turning, as closely as a quarter of
    /// the chord tolerance, but for what it is drawn out.
    void the_middle_of_a_ball_stays_on_its_way() {
        AlongWall job;
        job.input.raise = 0.002;
        const TiltedPass tilted = tilted_where_held(job.input, job.pass, Progress());
        QVERIFY(tilted.largest > radians(10) && !tilted.passes.empty());
        QCOMPARE(tilted.kept.size(), tilted.passes.size());
        double farthest = 0;
        for (const Pass& p : tilted.passes)
            for (std::size_t i = 1; i < p.cl.size(); ++i)
                for (int k = 0; k <= 8; ++k) {
                    const CutterLocation at = location_on_route(p.cl[i - 1], p.cl[i], k / 8.0);
                    const Vec3 middle = at.tip + 2 * at.axis;
                    double nearest = infinity;
                    for (std::size_t n = 1; n < job.pass.cl.size(); ++n) {
                        const Vec3 a = job.pass.cl[n - 1].tip + 2 * Vec3::UnitZ(),
                                   b = job.pass.cl[n].tip + 2 * Vec3::UnitZ();
                        const double along =
                            std::clamp((middle - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                        nearest = std::min(nearest, (middle - a - along * (b - a)).norm());
                    }
                    farthest = std::max(farthest, nearest);
                }
        QVERIFY2(farthest <= job.input.raise + 0.25 * job.input.chord + 1e-9,
                 qPrintable(QString::number(farthest)));
    }

    void what_is_kept_names_its_range() {
        AlongWall job;
        job.input.limit = radians(12); // too little in places
        const TiltedPass tilted = tilted_where_held(job.input, job.pass, Progress());
        QCOMPARE(tilted.kept.size(), tilted.passes.size());
        const auto on_pass = [&](double at) {
            for (std::size_t k = 1; k < job.pass.cl.size(); ++k) {
                const Vec3 &a = job.pass.cl[k - 1].tip, &b = job.pass.cl[k].tip;
                if (at <= (b - a).norm() + 1e-9 || k + 1 == job.pass.cl.size())
                    return Vec3(a + at / (b - a).norm() * (b - a));
                at -= (b - a).norm();
            }
            return Vec3(Vec3::Zero());
        };
        for (std::size_t i = 0; i < tilted.kept.size(); ++i) {
            const Interval& range = tilted.kept[i];
            const Vec3 up(0, 0, 2);
            const CutterLocation &begin = tilted.passes[i].cl.front(), &end = tilted.passes[i].cl.back();
            QVERIFY((begin.tip + 2 * begin.axis - on_pass(range.lo) - up).norm() <= job.input.raise + 1e-9);
            QVERIFY((end.tip + 2 * end.axis - on_pass(range.hi) - up).norm() <= job.input.raise + 1e-9);
        }
        job.input.limit = radians(50);
        Pass away = job.pass; // beside nothing
        for (CutterLocation& c : away.cl)
            c.tip.z() += 100;
        const TiltedPass whole = tilted_where_held(job.input, away, Progress());
        QVERIFY(whole.kept.size() == 1 && whole.kept[0].lo == 0 && whole.kept[0].hi > 24);
        QCOMPARE(whole.largest, 0.0);
    }

    /// A pass of two places, both free, past a post that only the holder meets.
    void holders_are_seen_between_places() {
        AlongWall job;
        const Mesh part = height_field(
            [](double x, double y) { return 40 * std::max(0.0, 1 - std::abs(x) - std::abs(y - 6)); },
            Vec2(-30, -12), Vec2(30, 12), 240, 96);
        const PlanContext context = context_of(part, job.tool);
        const ToolLift whole(context.contact, job.tool, {0, 0, 0});
        job.input.whole = &whole;
        job.input.look_step = body_step(job.tool, job.input.chord);
        Pass straight = job.pass;
        straight.cl = {{{-28, 0, 0}, Vec3::UnitZ()}, {{28, 0, 0}, Vec3::UnitZ()}};
        straight.cc = {{{-28, 0, 0}, Vec3::UnitZ()}, {{28, 0, 0}, Vec3::UnitZ()}};
        const TiltedPass tilted = tilted_where_held(job.input, straight, Progress());
        QVERIFY(tilted.largest > radians(5) && tilted.lost < 1);
        ToolLift::Hint hint;
        for (const Pass& p : tilted.passes) {
            // Where the axis stays upright nothing is put in.
            QVERIFY(p.cl.size() < 60);
            for (std::size_t i = 1; i < p.cl.size(); ++i)
                for (int k = 0; k <= 20; ++k) {
                    const CutterLocation at = location_on_route(p.cl[i - 1], p.cl[i], k / 20.0);
                    QVERIFY(whole.lift({at.tip, at.axis}, hint) <= job.input.chord);
                }
        }
    }

    /// Joints of a machine hold every axis, and turn between two as was looked at.
    void the_machine_holds_every_axis() {
        AlongWall job;
        const double gauge = gauge_length(job.tool);
        const Machine& trunnion = find_machine("trunnion-ac");
        const Kinematics machine(trunnion, gauge, default_part_origin(trunnion, job.part.box()));
        job.input.machine = &machine;
        const TiltedPass tilted = tilted_where_held(job.input, job.pass, Progress());
        QVERIFY(tilted.largest > radians(10));
        const EvenMotion motion(machine, 2, 0.25 * job.input.chord + 1e-9);
        for (const Pass& p : tilted.passes)
            for (std::size_t i = 0; i < p.cl.size(); ++i) {
                QVERIFY(machine.reaches({p.cl[i].tip, p.cl[i].axis}));
                if (i > 0) QVERIFY(motion.even(p.cl[i - 1], p.cl[i]));
            }
        const Machine& upright = find_machine("generic-3-axis");
        const Kinematics three(upright, gauge, default_part_origin(upright, job.part.box()));
        job.input.machine = &three;
        QCOMPARE(tilted_where_held(job.input, job.pass, Progress()).largest, 0.0);
    }
};

FACETMILL_TEST(TestAxisTilt)
#include "test_axis_tilt.moc"
