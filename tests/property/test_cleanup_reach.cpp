// Clean-up beyond what an upright tool reaches in valleys: inclined where its holder needs it, around contact
// points that an operation of five axes left, and around material that the verification finds.
#include "core/base/turn.h"
#include "core/job/planner.h"
#include "core/job/program_files.h"
#include "core/job/report.h"
#include "core/job/verification.h"
#include "core/link/link.h"
#include "core/mesh/mesh_io.h"
#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/plan/stock_bottom.h"
#include "core/strategy/tilt/axis_tilt.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/support/error_code.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTemporaryDir>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double reach_tau = 0.1;

/// A floor and a tall wall that leans back by `draft`, their crease along X at the origin.
Mesh tall_wall(double draft) {
    const double high = 30;
    const std::vector<Vec2> corner{{-30, 0}, {0, 0}, {high * std::tan(draft), high}, {25, high}};
    std::vector<Vec2> line{corner.front()};
    for (std::size_t i = 1; i < corner.size(); ++i)
        for (int k = 1; k <= 12; ++k)
            line.push_back(corner[i - 1] + (k / 12.0) * (corner[i] - corner[i - 1]));
    Mesh m;
    const int columns = 16;
    for (const Vec2& p : line)
        for (int i = 0; i <= columns; ++i)
            m.vertices.emplace_back(-16 + 32.0 * i / columns, p.x(), p.y());
    const auto at = [&](int i, int j) { return Index(j * (columns + 1) + i); };
    for (int j = 0; j + 1 < int(line.size()); ++j)
        for (int i = 0; i < columns; ++i) {
            m.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            m.facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return m;
}

/// A plane with a dimple at the origin, whose bottom has a radius of 2.67 mm.
Mesh dimpled() {
    return height_field([](double x, double y) { return -3 * std::exp(-(x * x + y * y) / 16); },
                        Vec2(-20, -16), Vec2(20, 16), 120, 96);
}

/// A closed frustum on z = 0, 12 mm high, with walls of a slope in degrees.
Mesh frustum(double slope) {
    const double high = 12, in = high / std::tan(radians(slope));
    Mesh m;
    for (const double z : {0.0, high})
        for (const Vec2& c : {Vec2(-20, -14), Vec2(20, -14), Vec2(20, 14), Vec2(-20, 14)}) {
            const double less = z > 0 ? in : 0;
            m.vertices.emplace_back(c.x() - std::copysign(less, c.x()), c.y() - std::copysign(less, c.y()),
                                    z);
        }
    m.facets = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
    for (Index k = 0; k < 4; ++k) {
        const Index l = (k + 1) % 4;
        m.facets.push_back({k, l, l + 4});
        m.facets.push_back({k, l + 4, k + 4});
    }
    return m;
}

/// Short, with a holder that no wall leaves room for.
Tool short_tool() {
    Tool t = ball_tool(4);
    t.number = 2;
    t.flute_length = 12;
    t.shank_length = 6;
    t.holder = {{24, 30}};
    return t;
}

Verification judged(const Mesh& mesh, const std::vector<VerifyProgram>& programs, double gouge_limit) {
    StockSolid stock;
    stock.box = mesh.box();
    stock.box.hi.z() += 1;
    VerifySettings v;
    v.resolution = 0.5;
    v.sample_spacing = 0.5;
    v.motion_bound = 0.01;
    v.tolerance = reach_tau;
    v.gouge_limit = gouge_limit;
    return verify(mesh, stock, programs, v, Progress());
}

VerifyProgram program_of(const Operation& op, const StrategyResult& path, const PlanContext& context) {
    return {op.common().name,
            VerifyTool(context.tool),
            std::make_shared<ToolMotions>(link_operation(op, path, context, Progress())),
            {}};
}

/// A project on disk over a part.
class Workplace {
    QTemporaryDir dir_;

public:
    Project project;

    explicit Workplace(const Mesh& part) {
        const std::filesystem::path folder(dir_.path().toStdString());
        save_stl(part, folder / "part.stl", LengthUnit::mm, {});
        project.path = folder / "p.facetmill";
        project.part.file = "part.stl";
        project.unit = project.part.unit = LengthUnit::mm;
        for (const double diameter : {12.0, 4.0, 5.0}) {
            Tool t = ball_tool(diameter);
            t.number = long(project.tools.size()) + 1;
            t.name = "Ball " + std::to_string(int(diameter));
            project.tools.push_back(t);
        }
    }
    Operation& add(const char* kind, const char* name, long tool) {
        auto o = make_operation(kind);
        o->common().name = name;
        o->common().tool = tool;
        o->common().tolerance = reach_tau;
        project.operations.push_back(std::move(o));
        return *project.operations.back();
    }
};

} // namespace

class TestCleanupReach : public QObject {
    Q_OBJECT
private slots:
    /// The place that a cutter touches stays where it is when the axis turns about it.
    void an_inclined_cutter_touches_the_same_place() {
        Random rng(5);
        for (const ShapedTool& shaped : tools_of_every_shape()) {
            const CutterProfile cutter(shaped.tool.cutter());
            for (int i = 0; i < 200; ++i) {
                const double slope = uniform(rng, 0, radians(35)), route = uniform(rng, 0, 2 * pi),
                             tilt = uniform(rng, 0, radians(35)), turn = uniform(rng, 0, 2 * pi);
                const Vec3 n(std::sin(slope) * std::cos(route), std::sin(slope) * std::sin(route),
                             std::cos(slope));
                const Vec3 axis(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                                std::cos(tilt));
                const Vec3 p(uniform(rng, -9, 9), uniform(rng, -9, 9), uniform(rng, -9, 9));
                CutterLocation turned;
                QVERIFY(turned_about_contact(cutter, {p, n}, tip_at_contact(cutter, p, n, Vec3::UnitZ()),
                                             axis, turned));
                // Against points of the cutter: none is below the plane, one touches it.
                double least = infinity;
                const Eigen::Quaterniond q = turn_between(Vec3::UnitZ(), axis);
                for (const ProfilePiece& piece : cutter.pieces())
                    for (int k = 0; k <= 60; ++k) {
                        Vec2 at = piece.from + (k / 60.0) * (piece.to - piece.from);
                        if (piece.kind == ProfilePiece::Kind::arc)
                            at = piece.center + piece.radius * (at - piece.center).normalized();
                        for (int a = 0; a < 180; ++a) {
                            const Vec3 local(at.x() * std::cos(2 * pi * a / 180),
                                             at.x() * std::sin(2 * pi * a / 180), at.y());
                            least = std::min(least, n.dot(turned.tip + q * local - p));
                        }
                    }
                QVERIFY2(least > -1e-9 && least < 0.01,
                         qPrintable(QString("%1 %2").arg(shaped.name).arg(least)));
            }
        }
    }

    void a_tall_wall_is_cleaned_by_an_inclined_tool() {
        const Mesh mesh = tall_wall(radians(10));
        Tool before = ball_tool(12);
        PlanContext context = context_of(mesh, short_tool());
        context.machine = find_machine("tarus-tpi-2000");
        context.further_tools = {before};
        CleanupSettings s;
        s.tool = 2;
        s.tolerance = reach_tau;
        QCOMPARE(code_of([&] { Cleanup(s).plan(context, Progress()); }), std::string("empty_result"));
        try {
            Cleanup(s).plan(context, Progress());
        } catch (const Error& e) {
            QVERIFY2(e.message().find("holder") != std::string::npos, e.what());
        }
        s.tilt_limit = radians(40);
        const Cleanup op(s);
        QVERIFY(!op.three_axis());
        const StrategyResult path = op.plan(context, Progress());
        for (const auto& w : path.warnings)
            qInfo("%s", w.c_str());
        QVERIFY(path.as<LeadRange>()->lead_max > radians(5)
                && path.as<LeadRange>()->lead_max <= radians(40) + 1e-9);
        double turned = 0;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 0; i < pass.cl.size(); ++i) {
                QVERIFY(std::acos(std::min(pass.cl[i].axis.z(), 1.0)) <= radians(40) + 1e-9);
                if (i > 0) turned = std::max(turned, (pass.cl[i].axis - pass.cl[i - 1].axis).norm());
            }
        QVERIFY2(turned < radians(41), qPrintable(QString::number(degrees(turned))));

        const PlanContext first = context_of(mesh, before);
        Finish3Settings f;
        f.tolerance = reach_tau;
        const Finish3 finish(f);
        const std::vector<VerifyProgram> programs{program_of(finish, finish.plan(first, Progress()), first),
                                                  program_of(op, path, context)};
        const Verification v = judged(mesh, programs, path.chord_tolerance);
        QVERIFY2(!v.gouged(), qPrintable(QString("%1 %2").arg(v.figures.gouge_max).arg(v.border.gouge_max)));
        for (const Collision& c : v.collisions)
            QVERIFY2(c.at.program != 1, "the inclined tool meets something");
        // Beside the crease, as far as the large ball comes to touch: R / tan 50 degrees and a little.
        const DeviationSurface& d = *v.surface;
        std::size_t asked = 0;
        double most = 0;
        Vec3 where = Vec3::Zero();
        for (std::size_t i = 0; i < d.points.size(); ++i) {
            const Vec3 p(d.points[i][0], d.points[i][1], d.points[i][2]);
            const double away = std::hypot(p.y(), p.z());
            if ((d.flags[i] & ~DeviationSurface::away) != 0 || std::abs(p.x()) > 12 || away < 1.8 || away > 6
                || p.z() > 6)
                continue;
            ++asked;
            if (double(d.deviation[i]) > most) {
                most = double(d.deviation[i]);
                where = p;
            }
        }
        const QString figures = QString("%1 samples, at most %2 at (%3, %4, %5); tilt %6")
                                    .arg(asked)
                                    .arg(most)
                                    .arg(where.x())
                                    .arg(where.y())
                                    .arg(where.z())
                                    .arg(degrees(path.as<LeadRange>()->lead_max));
        qInfo("%s", qPrintable(figures));
        QVERIFY2(asked > 200 && most <= reach_tau, qPrintable(figures));
    }

    /// Hollows as deep as twice the flutes, in a block that nobody roughed: passes come in such an order that
    /// the shank meets nothing of what stands there. Longer flutes, which need not ask, go another way, on
    /// which this shank would.
    void the_shank_stays_out_of_stock_in_a_deep_hollow_data() {
        QTest::addColumn<bool>("round");
        QTest::newRow("hole") << true;
        QTest::newRow("slot") << false;
    }
    void the_shank_stays_out_of_stock_in_a_deep_hollow() {
        QFETCH(bool, round);
        const auto height = [&](double x, double y) {
            const double over = round ? std::hypot(x, y) - 4 : std::abs(y) - 2.6;
            return std::clamp(20 * over, -10.0, 0.0);
        };
        const Vec2 half = round ? Vec2(7, 7) : Vec2(10, 5);
        const Mesh part = height_field(height, -half, half, round ? 80 : 20, round ? 80 : 100);
        Tool tool = short_tool();
        tool.flute_length = 5;
        tool.shank_length = 30;
        PlanContext context = context_of(part, tool);
        context.further_tools = {ball_tool(12)};
        context.stock_box.hi.z() += 1;
        context.stock.box = context.stock_box; // as it is judged
        CleanupSettings s;
        s.tool = 2;
        s.tolerance = reach_tau;
        const Cleanup op(s);
        const auto collisions = [&](const StrategyResult& path) {
            return judged(part, {program_of(op, path, context)}, path.chord_tolerance).collisions.size();
        };
        const auto lowest = [](const StrategyResult& path) {
            double z = infinity;
            for (const Pass& pass : path.passes)
                for (const CutterLocation& c : pass.cl)
                    z = std::min(z, c.tip.z());
            return z;
        };
        const StrategyResult path = op.plan(context, Progress());
        QCOMPARE(collisions(path), std::size_t(0));
        QVERIFY2(lowest(path) < -9.9, qPrintable(QString::number(lowest(path))));
        context.tool.flute_length = 20;
        const StrategyResult unasked = op.plan(context, Progress());
        QVERIFY2(lowest(unasked) < -9.9, qPrintable(QString::number(lowest(unasked))));
        context.tool.flute_length = 5; // as it is judged
        const std::size_t touches = collisions(unasked);
        QVERIFY2(touches > 20, qPrintable(QString::number(touches)));
    }

    /// A ball went along a wall that is higher than the flutes and left a skin on it. The shank of a smaller
    /// one, as thick as its cutter, would rub there: it cleans the wall's foot a little away from a skin of
    /// half the tolerance, cuts a thick one from above first, and its shank meets nothing.
    void beside_a_skin_on_a_wall_its_foot_is_cut_data() {
        QTest::addColumn<double>("skin");
        QTest::newRow("thin") << 0.5 * reach_tau;
        QTest::newRow("thick") << 10 * reach_tau;
    }
    void beside_a_skin_on_a_wall_its_foot_is_cut() {
        QFETCH(const double, skin);
        const Mesh part = tall_wall(0);
        Tool tool = short_tool();
        tool.holder.clear();
        tool.shank_length = 40;
        PlanContext context = context_of(part, tool);
        context.further_tools = {ball_tool(12)};
        context.stock_box.hi.z() += 1;
        context.stock.box = context.stock_box; // as it is judged
        std::vector<VerifyProgram> programs;
        const auto went = [&](Tool by, std::initializer_list<double> ys) {
            by.flute_length = 40;
            auto earlier = std::make_shared<EarlierCuts>();
            earlier->cutter = by.cutter();
            auto motions = std::make_shared<ToolMotions>();
            for (const double y : ys) {
                const Vec3 a(-24, y, 0), b(24, y, 0), over(0, 0, 40);
                earlier->motions.push_back({a, b});
                for (const auto& [kind, tip] :
                     {std::pair(MotionKind::rapid, Vec3(a + over)), std::pair(MotionKind::approach, a),
                      std::pair(MotionKind::cut, b), std::pair(MotionKind::retract, Vec3(b + over))})
                    motions->motions.push_back({kind, {tip, Vec3::UnitZ()}});
            }
            context.earlier.push_back(earlier);
            programs.push_back({"Before", VerifyTool(by), motions, {}});
        };
        went(flat_tool(8), {-34, -26, -18, -10.1});
        went(ball_tool(12), {-6 - skin});
        CleanupSettings s;
        s.tool = 2;
        s.tolerance = reach_tau;
        const Cleanup op(s);
        const StrategyResult path = op.plan(context, Progress());
        double along = 0;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 1; i < pass.cl.size(); ++i) {
                const Vec3 &a = pass.cl[i - 1].tip, &b = pass.cl[i].tip;
                if (std::min(a.y(), b.y()) > -2.5 && std::max(a.z(), b.z()) < reach_tau)
                    along += std::abs(b.x() - a.x());
            }
        QVERIFY2(along > 25, qPrintable(QString::number(along)));
        programs.push_back(program_of(op, path, context));
        const Verification v = judged(part, programs, path.chord_tolerance);
        QVERIFY(!v.gouged());
        QCOMPARE(v.collisions.size(), std::size_t(0));
    }

    /// On a leaning wall that goes down to the bottom of the stock a ball kept above it touches nothing below
    /// R (1 - n.z): a smaller one goes down to its own, and there only. On a wall that is all but upright
    /// once round at the bottom does it.
    void the_foot_of_a_wall_is_cut_as_low_as_the_ball_goes_data() {
        QTest::addColumn<double>("slope");
        QTest::addColumn<bool>("one_level");
        QTest::newRow("leaning") << 75.0 << false;
        QTest::newRow("all but upright") << 89.8 << true;
    }
    void the_foot_of_a_wall_is_cut_as_low_as_the_ball_goes() {
        QFETCH(const double, slope);
        QFETCH(const bool, one_level);
        const Mesh part = frustum(slope);
        PlanContext context = context_of(part, ball_tool(12));
        context.stock_box.lo -= Vec3(3, 3, 0);
        context.stock_box.hi += Vec3(3, 3, 1);
        context.stock.box = context.stock_box;
        Finish3Settings finish;
        finish.tool = 1;
        finish.tolerance = reach_tau;
        const Finish3 before(finish);
        CleanupSettings s;
        s.tool = 2;
        s.tolerance = reach_tau;
        const Cleanup op(s);
        StrategyResult finished = before.plan(context, Progress());
        std::vector<VerifyProgram> programs;
        // Clean-up after finishing over this stock: finishing as the planner keeps it above the bottom.
        const auto cleaned_up = [&](PlanContext after) {
            StrategyResult path = finished;
            keep_above_bottom(path, after, finish);
            programs = {program_of(before, path, after)};
            auto earlier = std::make_shared<EarlierCuts>();
            earlier->cutter = after.tool.cutter();
            const auto& motions = programs[0].motions->motions;
            for (std::size_t i = 1; i < motions.size(); ++i)
                if (motions[i].kind != MotionKind::rapid)
                    earlier->motions.push_back({motions[i - 1].to.tip, motions[i].to.tip});
            after.earlier.push_back(earlier);
            after.further_tools = {after.tool};
            after.tool = ball_tool(4);
            after.tool.number = 2;
            StrategyResult clean = op.plan(after, Progress());
            keep_above_bottom(clean, after, s);
            programs.push_back(program_of(op, clean, after));
            return clean;
        };
        // Where the stock goes on below, the large ball has been everywhere.
        PlanContext lower = context;
        lower.stock_box.lo.z() -= 20;
        lower.stock.box = lower.stock_box;
        QCOMPARE(code_of([&] { cleaned_up(lower); }), std::string("empty_result"));
        const StrategyResult path = cleaned_up(context);
        QVERIFY(!path.strips.empty() && !path.passes.empty());
        for (const Strip& strip : path.strips)
            QVERIFY(strip.kind == StripKind::foot);
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl)
                QVERIFY2(c.tip.z() >= 0 && c.tip.z() < 11, qPrintable(QString::number(c.tip.z())));
        double length = 0, climbs = 0;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 1; i < pass.cl.size(); ++i) {
                const Vec3 way = pass.cl[i].tip - pass.cl[i - 1].tip;
                length += way.norm();
                if (pass.cl[i].tip.z() < 0.5) climbs += std::abs(way.z());
            }
        const double round = 2 * (40 + 28) + 2 * pi * 2;
        if (one_level)
            QVERIFY2(length < 1.1 * round && climbs < 0.1 * round,
                     qPrintable(QString("%1 %2").arg(length).arg(climbs)));
        const double touched = 2 * (1 - std::cos(radians(slope)));
        const auto most_left = [&] {
            StockSolid stock;
            stock.box = context.stock_box;
            VerifySettings v;
            v.resolution = v.sample_spacing = 0.3;
            v.motion_bound = 0.01;
            v.tolerance = reach_tau;
            v.gouge_limit = path.chord_tolerance;
            const Verification judge = verify(part, stock, programs, v, Progress());
            double most = judge.gouged() ? infinity : 0;
            for (std::size_t i = 0; i < judge.surface->points.size(); ++i)
                if (const double z = judge.surface->points[i][2]; z > touched + 0.05 && z < 11.9)
                    most = std::max(most, double(judge.surface->deviation[i]));
            return most;
        };
        const double cleaned = most_left();
        programs.pop_back();
        const double alone = most_left();
        QVERIFY2(alone > 5 * reach_tau && cleaned <= 1.05 * reach_tau,
                 qPrintable(QString("%1 %2").arg(alone).arg(cleaned)));
    }

    /// Around places on a dish that every tool fits into.
    void places_that_were_left_are_cut() {
        const Mesh dish = height_field([](double x, double y) { return 0.01 * (x * x + y * y); },
                                       Vec2(-20, -16), Vec2(20, 16), 40, 32);
        PlanContext context = context_of(dish, ball_tool(4));
        context.further_tools = {ball_tool(12)};
        auto left = std::make_shared<EarlierLeft>();
        for (int i = -4; i <= 4; ++i)
            for (int k = -4; k <= 4; ++k) {
                const double x = 8 + i, y = -5 + k;
                left->points.push_back(
                    {Vec3(x, y, 0.01 * (x * x + y * y)), Vec3(-0.02 * x, -0.02 * y, 1).normalized(), 0});
            }
        CleanupSettings s;
        s.tool = 2;
        s.tolerance = reach_tau;
        context.left = left;
        QCOMPARE(code_of([&] { Cleanup(s).plan(context, Progress()); }), std::string("empty_result"));
        s.left_points = true;
        const Cleanup op(s);
        const StrategyResult path = op.plan(context, Progress());
        QCOMPARE(path.strips.size(), std::size_t(1));
        QVERIFY(path.strips[0].kind == StripKind::no_posture);
        QVERIFY2(path.strips[0].reason.find("81 contact points") != std::string::npos,
                 path.strips[0].reason.c_str());
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl)
                QVERIFY(std::abs(c.tip.x() - 8) < 9 && std::abs(c.tip.y() + 5) < 9);
        const Verification v = judged(dish, {program_of(op, path, context)}, path.chord_tolerance);
        QVERIFY(!v.gouged());
        const DeviationSurface& d = *v.surface;
        std::size_t asked = 0;
        double most = 0;
        for (std::size_t i = 0; i < d.points.size(); ++i) {
            const Vec3 p(d.points[i][0], d.points[i][1], d.points[i][2]);
            if (std::abs(p.x() - 8) > 4 || std::abs(p.y() + 5) > 4) continue;
            ++asked;
            most = std::max(most, double(d.deviation[i]));
        }
        QVERIFY2(asked > 100 && most <= reach_tau, qPrintable(QString("%1 %2").arg(asked).arg(most)));
        // Switched off it is not cut.
        s.switched_off = path.strips[0].name;
        QCOMPARE(code_of([&] { Cleanup(s).plan(context, Progress()); }), std::string("empty_result"));
    }

    /// A large ball cannot enter the dimple; no previous tool says so, the verification does.
    void material_that_was_left_is_found_and_cut() {
        Workplace w(dimpled());
        w.add("finish3", "Finish", 1);
        Operation& op = w.add("cleanup", "Clean-up", 2);
        op.set("previous_tool", ParameterValue(3l));
        Planner planner;
        // Nothing to do for it is no fault of the job: finishing has its program, and the report says why.
        const auto idle = planner.plan(w.project, "", Progress());
        QCOMPARE(idle->operations.size(), std::size_t(1));
        QCOMPARE(idle->idle.size(), std::size_t(1));
        QVERIFY(idle->idle[0]->nothing_to_do.find("leaves nowhere more than") != std::string::npos);
        QVERIFY(programs_of(idle->idle[0]).empty());
        QVERIFY(report_json(w.project, *idle).find("\"nothing_to_do\": \"tool 3") != std::string::npos);
        QTemporaryDir folder;
        QCOMPARE(write_plan(w.project, *idle, folder.path().toStdString(), Progress()).size(),
                 std::size_t(2));
        const auto only = planner.plan(w.project, "Clean-up", Progress());
        QCOMPARE(only->idle, idle->idle); // planned once
        QCOMPARE(code_of([&] { write_plan(w.project, *only, folder.path().toStdString(), Progress()); }),
                 std::string("empty_result"));
        op.set("rest_material", ParameterValue(true));
        const auto plan = planner.plan(w.project, "", Progress());
        QCOMPARE(plan->operations.size(), std::size_t(2));
        const StrategyResult& path = plan->operations[1]->path;
        QCOMPARE(path.strips.size(), std::size_t(1));
        QVERIFY(path.strips[0].kind == StripKind::rest);
        for (const auto& t : path.strips[0].band)
            for (const Vec3& p : t)
                QVERIFY(p.head<2>().norm() < 10);
        const auto max_left = [&](std::size_t count) {
            auto some = std::make_shared<PlanResult>(*plan);
            some->operations.resize(count);
            const Verification v = judged(*plan->part->mesh, verify_programs(w.project, some), 0.01);
            return v.gouged() ? infinity : v.figures.excess_max;
        };
        const double before = max_left(1), after = max_left(2);
        QVERIFY2(before > 5 * reach_tau && after <= 1.05 * reach_tau,
                 qPrintable(QString("%1 %2").arg(before).arg(after)));
        // Alone it is the same; planned again nothing is done; what is before it matters.
        const auto alone = Planner().plan(w.project, "Clean-up", Progress());
        QCOMPARE(alone->operations.size(), std::size_t(1));
        QCOMPARE(alone->operations[0]->cl_points, plan->operations[1]->cl_points);
        const PlannerWork work = planner.work();
        planner.plan(w.project, "", Progress());
        QVERIFY(planner.work() == work);
        w.project.operations[0]->common().tolerance = 0.5 * reach_tau;
        planner.plan(w.project, "", Progress());
        QCOMPARE(planner.work().strategies, work.strategies + 2);
    }

    /// Points of a 5-axis path that have no free posture.
    void contact_points_without_a_posture_are_cut() {
        Workplace w(dimpled());
        w.project.machine = "tarus-tpi-2000";
        Tool flat = flat_tool(8);
        flat.number = 4;
        w.project.tools.push_back(flat);
        Operation& five = w.add("finish5", "Five axes", 4);
        five.set("grid_degrees", ParameterValue(radians(9)));
        five.set("normal_limit", ParameterValue(radians(20)));
        five.set("posture", ParameterValue(std::string("cm2")));
        Operation& op = w.add("cleanup", "Clean-up", 2);
        op.set("previous_tool", ParameterValue(3l));
        op.set("left_points", ParameterValue(true));
        const auto plan = Planner().plan(w.project, "", Progress());
        const auto& left = plan->operations[0]->path.cleanup;
        QVERIFY(left.size() > 3);
        const StrategyResult& path = plan->operations[1]->path;
        QVERIFY(!path.strips.empty() && !path.passes.empty());
        for (const Strip& strip : path.strips)
            QVERIFY(strip.kind == StripKind::no_posture);
        // Every one of them is near to a strip.
        for (const CutterContact& c : left) {
            double least = infinity;
            for (const Strip& strip : path.strips)
                for (const auto& t : strip.band)
                    for (const Vec3& p : t)
                        least = std::min(least, (p - c.point).norm());
            QVERIFY2(least < 1, qPrintable(QString("%1 at (%2, %3, %4), normal z %5, %6 strips")
                                               .arg(least)
                                               .arg(c.point.x())
                                               .arg(c.point.y())
                                               .arg(c.point.z())
                                               .arg(c.normal.z())
                                               .arg(path.strips.size())));
        }
    }
};

FACETMILL_TEST(TestCleanupReach)
#include "test_cleanup_reach.moc"
