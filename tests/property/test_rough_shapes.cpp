// Roughing with every cutter shape over every part with known answers: the allowance stays, no more stays
// than is stated, nothing collides. Judged by the path checker and by the verifier, which share no code with
// the planner.
#include "core/base/parallel.h"
#include "core/gouge/axial_lift.h"
#include "core/link/link.h"
#include "core/mesh/sample.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/rough/rough.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/support/cancel_at.h"
#include "tests/support/part_meshes.h"
#include "tests/support/path_checker.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cstring>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// The cone cuts over all its length here: flutes as long as the part is high, and no shank above them.
std::vector<ShapedTool> cutters() {
    std::vector<ShapedTool> tools = tools_of_every_shape();
    tools.back().tool.flute_length = 30;
    tools.back().tool.shank_diameter = 0;
    return tools;
}

/// What the verifier says of a roughing with its links, on the context's stock.
Verification judged_rough(const RoughSettings& settings, const Mesh& part, const Tool& tool,
                          const PlanContext& context, double resolution) {
    const Rough op(settings);
    const VerifyProgram program{
        "R",
        VerifyTool(tool),
        std::make_shared<ToolMotions>(link_operation(op, op.plan(context, Progress()), context, Progress())),
        {}};
    VerifySettings v;
    v.resolution = v.sample_spacing = resolution;
    v.allowance = settings.allowance;
    v.gouge_limit = 1e-3;
    return verify(part, context.stock, {&program, 1}, v, Progress());
}

/// A closed block round the z axis with rounded upright edges: `half` wide to either side.
Mesh rounded_block(const Vec2& half, double radius, double low, double high) {
    constexpr int pieces = 12; // of each edge
    Mesh mesh;
    for (int corner = 0; corner < 4; ++corner)
        for (int i = 0; i <= pieces; ++i) {
            const double angle = 0.5 * pi * (corner + double(i) / pieces);
            const double side_x = corner == 0 || corner == 3 ? 1 : -1, side_y = corner < 2 ? 1 : -1;
            for (const double z : {low, high})
                mesh.vertices.emplace_back(side_x * (half.x() - radius) + radius * std::cos(angle),
                                           side_y * (half.y() - radius) + radius * std::sin(angle), z);
        }
    const auto n = Index(mesh.vertices.size());
    for (Index i = 0; i < n; i += 2) {
        const Index next = (i + 2) % n;
        mesh.facets.push_back({i, next, next + 1});
        mesh.facets.push_back({i, next + 1, i + 1});
        if (i > 0 && next > 0) {
            mesh.facets.push_back({0, next, i});
            mesh.facets.push_back({1, i + 1, next + 1});
        }
    }
    return mesh;
}

PlanContext raised(const Mesh& mesh, const Tool& tool) {
    PlanContext c = context_of(mesh, tool);
    c.stock_box.lo -= Vec3(3, 3, 0);
    c.stock_box.hi += Vec3(3, 3, 4);
    return c;
}

/// The motions at feed, which cut.
std::vector<TipLine> cuts(const ToolMotions& motions) {
    std::vector<TipLine> lines(1);
    for (const Motion& m : motions.motions) {
        if (m.kind == MotionKind::rapid && lines.back().size() > 1) lines.emplace_back();
        if (m.kind == MotionKind::rapid) lines.back().clear();
        lines.back().push_back(m.to.tip);
    }
    if (lines.back().size() < 2) lines.pop_back();
    return lines;
}

std::vector<double> numbers(const StrategyResult& r, const ToolMotions& m) {
    std::vector<double> all = r.as<RoughPath>()->layers;
    all.insert(all.end(), {r.cusp_max, r.stepover_min, double(r.passes.size()), m.air_length});
    for (const Motion& motion : m.motions) {
        all.push_back(double(int(motion.kind)));
        all.insert(all.end(), motion.to.tip.data(), motion.to.tip.data() + 3);
    }
    return all;
}

/// A profile across X, as (y, z), drawn along it; `rise` is its slope along X.
Mesh drawn(const std::vector<Vec2>& profile, double rise) {
    constexpr int pieces = 12;
    constexpr double half = 24;
    Mesh m;
    const auto row = Index(profile.size());
    for (int i = 0; i <= pieces; ++i)
        for (const Vec2& p : profile) {
            const double x = half * (2.0 * i / pieces - 1);
            m.vertices.push_back(Vec3(x, p.x(), p.y() + rise * x));
        }
    for (Index i = 0; i < Index(pieces); ++i)
        for (Index k = 0; k + 1 < row; ++k) {
            const Index a = i * row + k, b = a + row;
            m.facets.push_back({a, b, b + 1});
            m.facets.push_back({a, b + 1, a + 1});
        }
    return m;
}

/// The most that was found left where the cutter, come down on the part and its allowance, stands no farther
/// from the place than `near`; and how many places those were. Told by the lift over many tips round the one
/// that would touch: what the tool cannot reach, from wherever it comes, does not count.
std::pair<double, std::size_t> left_within_reach(const Verification& v, const PlanContext& context,
                                                 double allowance, double near) {
    const CutterProfile profile(context.tool.cutter());
    const CutterCover cover(profile, 1e-3);
    const AxialLift lift(context.contact, profile, allowance);
    const DeviationSurface& s = *v.surface;
    double most = 0;
    std::size_t places = 0;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        const Vec3 n(s.normals[i][0], s.normals[i][1], s.normals[i][2]);
        if (s.flags[i] != 0 || n.z() <= 0.02) continue;
        const Vec3 p = Vec3(s.points[i][0], s.points[i][1], s.points[i][2]) + allowance * n;
        const Vec3 touching = p + cover.tip_offset(n);
        if (touching.z() < context.part_box.lo.z()) continue;
        double away = infinity;
        for (int k = 0; k <= 16 && away > near; ++k) {
            const double turn = 2 * pi * k / 8, out = k == 0 ? 0 : k <= 8 ? near : 3 * near;
            const double x = touching.x() + out * std::cos(turn), y = touching.y() + out * std::sin(turn);
            away = std::min(away, cover.ray_entry(p, n, Vec3(x, y, lift.tip_z(x, y)), 100));
        }
        if (away > near) continue;
        ++places;
        most = std::max(most, double(s.deviation[i]));
    }
    return {most, places};
}

/// A roughing path cut into its box of stock and compared with the part.
Verification verified(const Rough& op, const StrategyResult& path, const PlanContext& context,
                      const Mesh& part, double allowance, double resolution, double spacing) {
    VerifySettings v;
    v.resolution = resolution;
    v.sample_spacing = spacing;
    v.allowance = allowance;
    v.gouge_limit = 1e-3;
    StockSolid stock;
    stock.box = context.stock_box;
    const auto motions = std::make_shared<ToolMotions>(link_operation(op, path, context, Progress()));
    const VerifyProgram program{"R", VerifyTool(context.tool), motions, {}};
    return verify(part, stock, {&program, 1}, v, Progress());
}

} // namespace

class TestRoughShapes : public QObject {
    Q_OBJECT
private slots:
    void shapes_keep_their_allowance_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("cutter");
        QTest::addColumn<bool>("by_tolerance");
        const auto parts = shapes();
        const auto tools = cutters();
        for (std::size_t s = 0; s < parts.size(); ++s)
            for (std::size_t c = 0; c < tools.size(); ++c) {
                if (!all_cases && (s + c / 2) % 2 != 0)
                    continue; // every shape, every cutter, half of the pairs
                const bool by_tolerance = (s + c) % 2 == 0;
                QTest::addRow("%s %s %s", parts[s].name.c_str(), tools[c].name,
                              by_tolerance ? "tolerance" : "depth")
                    << int(s) << int(c) << by_tolerance;
            }
    }

    void shapes_keep_their_allowance() {
        QFETCH(int, shape);
        QFETCH(int, cutter);
        QFETCH(bool, by_tolerance);
        const Shape part = shapes()[std::size_t(shape)];
        const Tool tool = cutters()[std::size_t(cutter)].tool;
        RoughSettings s;
        s.allowance = 0.4;
        s.tolerance = by_tolerance ? 1.2 : 6;
        if (!by_tolerance) s.depth = {1.5, {}};
        const Rough op(s);
        const PlanContext context = raised(part.mesh, tool);
        const StrategyResult path = op.plan(context, Progress());
        if (by_tolerance)
            QVERIFY2(path.cusp_max <= s.tolerance * (1 + 1e-9), qPrintable(QString::number(path.cusp_max)));
        const ToolMotions motions = link_operation(op, path, context, Progress());

        PathCheckOptions options;
        options.spacing = 2.2;
        options.border = 0.5 * tool.diameter;
        options.allowance = s.allowance;
        options.reach = 8;
        options.no_cusp = [&](const Vec3& p) {
            // What only tips below the lowest layer would touch, and what is steeper than a height tells.
            // The allowance keeps the tool a little farther from walls.
            for (const Vec3& beside :
                 {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
                if (part.out_of_reach(p + beside, tool)) return true;
            return p.z() < context.part_box.lo.z() + 0.5 * tool.diameter;
        };
        const PathCheckResult result = check_path(part.mesh, tool.cutter(), cuts(motions), options);
        QVERIFY(result.samples > 150);
        QVERIFY2(result.gouge_max <= 1e-6, qPrintable(QString::number(result.gouge_max)));
        if (result.cusp_samples > 0)
            QVERIFY2(result.cusp_max <= path.cusp_max,
                     qPrintable(QString("%1 stated, %2 found").arg(path.cusp_max).arg(result.cusp_max)));

        if (cutter > 1 || shape % 2 != 0) return; // the verifier takes its time
        VerifySettings v;
        v.resolution = 0.6;
        v.sample_spacing = 1;
        v.allowance = s.allowance;
        v.tolerance = path.cusp_max;
        v.gouge_limit = 1e-3;
        StockSolid stock;
        stock.box = context.stock_box;
        const VerifyProgram program{"R", VerifyTool(tool), std::make_shared<ToolMotions>(motions), {}};
        const Verification judged = verify(part.mesh, stock, {&program, 1}, v, Progress());
        QVERIFY2(!judged.gouged(), qPrintable(QString::number(judged.figures.gouge_max)));
        QVERIFY2(judged.collisions.empty(),
                 qPrintable(QString("%1, first kind %2 depth %3")
                                .arg(judged.collisions.size())
                                .arg(judged.collisions.empty() ? -1 : int(judged.collisions[0].kind))
                                .arg(judged.collisions.empty() ? 0 : judged.collisions[0].depth)));
    }

    void narrow_valleys_are_cut_data() {
        QTest::addColumn<int>("valley");
        QTest::addColumn<double>("corner");
        QTest::addColumn<double>("turn");
        const char* const names[] = {"slot", "rising slot", "vee"};
        const auto add = [&](int valley, double corner, double turn) {
            QTest::addRow("%s, corner radius %g, turned by %g", names[valley], corner, turn)
                << valley << corner << turn;
        };
        add(0, 1, 0.35);
        add(1, 0, 0);
        add(2, 0, 0.35);
        add(2, 3, 0);
        if (!all_cases) return;
        for (const double corner : {1.0, 3.0})
            for (const double turn : {0.0, 0.35}) {
                if (corner == 3 || turn == 0) add(0, corner, turn);
                if (corner == 1 || turn != 0) add(2, corner, turn);
            }
        add(0, 0, 0.35);
        add(1, 0, 0.35);
        add(2, 0, 0);
    }

    /// A valley that is hardly wider than the tool, or as narrow as it comes at its floor: between the nodes
    /// of a layer's grid there may be room for it where at no node there is.
    void narrow_valleys_are_cut() {
        QFETCH(int, valley);
        QFETCH(double, corner);
        QFETCH(double, turn);
        const double diameter = 6, allowance = 0.3;
        const Tool tool = bull_tool(diameter, corner);
        const double half = 0.5 * diameter + allowance + 0.06, lean = std::tan(radians(4));
        const std::vector<Vec2> slot{{-16, 0},   {-half - 9 * lean, 0}, {-half, -9},
                                     {half, -9}, {half + 9 * lean, 0},  {16, 0}};
        const std::vector<Vec2> vee{{-16, 0}, {-5, 0}, {0, -20}, {5, 0}, {16, 0}};
        const Mesh part = turned(drawn(valley == 2 ? vee : slot, valley == 1 ? 0.1 : 0), turn);
        RoughSettings s;
        s.allowance = allowance;
        s.tolerance = 5;
        s.depth = {1.3, {}};
        const Rough op(s);
        const PlanContext context = raised(part, tool);
        const StrategyResult path = op.plan(context, Progress());
        const Verification judged = verified(op, path, context, part, allowance, 0.5, 0.4);
        QVERIFY2(judged.passed(), qPrintable(QString("gouge %1, %2 collisions")
                                                 .arg(judged.figures.gouge_max)
                                                 .arg(judged.collisions.size())));
        const auto [left, places] = left_within_reach(judged, context, allowance, 0.02);
        QVERIFY2(places > 2000, qPrintable(QString::number(places)));
        QVERIFY2(
            left <= path.cusp_max,
            qPrintable(QString("%1 stated, %2 found in %3 places").arg(path.cusp_max).arg(left).arg(places)));
        // And what is stated is no more than layers of this depth leave: the valley is not just given up.
        QVERIFY2(path.cusp_max < 3, qPrintable(QString::number(path.cusp_max)));
    }

    void floors_between_layers_are_cut_data() {
        QTest::addColumn<int>("floor");
        QTest::addColumn<double>("turn");
        const char* const names[] = {"foot of a wall", "foot over a falling floor", "dish"};
        for (int floor = 0; floor < 3; ++floor)
            for (const double turn : {0.0, 0.4})
                if (all_cases || (turn == 0) == (floor == 1))
                    QTest::addRow("%s, turned by %g", names[floor], turn) << floor << turn;
    }

    /// Where a floor lies between two layers neither reaches it, and beside it, along the normal of what
    /// rises there, more stands than the layers are apart.
    void floors_between_layers_are_cut() {
        QFETCH(int, floor);
        QFETCH(double, turn);
        constexpr double diameter = 6, allowance = 0.3, depth = 1.3;
        const Tool tool = flat_tool(diameter);
        const std::vector<Vec2> foot{{-16, 10}, {-11, 0}, {16, floor == 0 ? 0 : -4.0}};
        // The tool spans its bottom, .06 deep, and stands a little above a layer there; the groove beside it
        // makes the lowest layer.
        const auto dish = [&](double x, double y) {
            return x > 12 ? 0.365 - 3 * depth + 0.06 * (x - 12.5) : (x * x + y * y) / 150;
        };
        const Mesh part = floor < 2 ? turned(drawn(foot, 0.13), turn)
                                    : turned(height_field(dish, Vec2(-20, -20), Vec2(28, 20), 96, 80), turn);
        RoughSettings s;
        s.allowance = allowance;
        s.tolerance = 5;
        s.depth = {depth, {}};
        const Rough op(s);
        PlanContext context = raised(part, tool);
        if (floor == 2) context.stock_box.hi.z() = context.part_box.lo.z() + 8 * depth;
        const StrategyResult path = op.plan(context, Progress());
        const Verification judged = verified(op, path, context, part, allowance, 1, 0.3);
        QVERIFY2(judged.passed(), qPrintable(QString("gouge %1, %2 collisions")
                                                 .arg(judged.figures.gouge_max)
                                                 .arg(judged.collisions.size())));
        const auto [left, places] = left_within_reach(judged, context, allowance, 0.05 * path.cusp_max);
        QVERIFY2(places > 2000, qPrintable(QString::number(places)));
        QVERIFY2(
            left <= path.cusp_max,
            qPrintable(QString("%1 stated, %2 found in %3 places").arg(path.cusp_max).arg(left).arg(places)));
        QVERIFY2(path.cusp_max < 1.05 * depth, qPrintable(QString::number(path.cusp_max)));
    }

    /// Flutes shorter than the part is high are no fault where the shank runs along walls as the cutter does;
    /// a holder that keeps the tool away from a wall is.
    void a_short_tool_is_told_of_where_it_matters() {
        RoughSettings s;
        s.allowance = 0.4;
        s.tolerance = 6;
        s.depth = {2, {}};
        for (const bool holder : {false, true}) {
            Tool tool = flat_tool(6);
            tool.flute_length = 10;
            tool.shank_length = holder ? 4 : 40;
            if (holder) tool.holder = {{30, 40}};
            const StrategyResult path = Rough(s).plan(raised(step(0, 18), tool), Progress());
            const bool told =
                std::any_of(path.warnings.begin(), path.warnings.end(), [](const std::string& warning) {
                    return warning.find("the tool is short") != std::string::npos;
                });
            QCOMPARE(told, holder);
        }
    }

    /// A wall whose outline changes half way up: layers above and below go round other corners to it. The
    /// shank slides by below, as thick as its flutes, and meets no step that one of them left.
    void the_shank_slides_by_other_layers() {
        Mesh part = rounded_block(Vec2(20, 15), 9, 0, 8);
        const Mesh tower = rounded_block(Vec2(9, 15), 4, 0, 40);
        const auto first = Index(part.vertices.size());
        part.vertices.insert(part.vertices.end(), tower.vertices.begin(), tower.vertices.end());
        for (const auto& f : tower.facets)
            part.facets.push_back({first + f[0], first + f[1], first + f[2]});
        Tool tool = flat_tool(12);
        tool.flute_length = 18;
        tool.shank_length = 40;
        tool.shank_diameter = tool.diameter;
        RoughSettings s;
        s.allowance = 0.4;
        s.tolerance = 6;
        s.depth = {2, {}};
        PlanContext context = context_of(part, tool);
        context.stock_box.lo -= Vec3(3, 3, 0);
        context.stock_box.hi += Vec3(3, 3, 2);
        context.stock.box = context.stock_box;
        const Verification judged = judged_rough(s, part, tool, context, 0.1);
        QVERIFY(!judged.gouged());
        const double deepest = judged.collisions.empty() ? 0 : judged.collisions.front().depth;
        QVERIFY2(
            judged.collisions.empty(),
            qPrintable(QString("%1 collisions, the first %2").arg(judged.collisions.size()).arg(deepest)));
    }

    /// A ball or a taper with short flutes is slimmer, a layer higher, than where its shank begins: what it
    /// leaves there is in the way of a shank a little slimmer, as wide, or a little wider than its top.
    void the_shank_meets_no_cusps_of_layers() {
        const Mesh part = rounded_block(Vec2(3, 3), 1, 0, 10);
        for (const double taper : {0.0, 0.023})
            for (const double wider : {-0.11, -0.03, 0.0, 0.06})
                for (const bool stated : {true, false}) {
                    if (!all_cases && stated != ((wider < 0) == (taper > 0))) continue;
                    Tool tool = ball_tool(6);
                    tool.taper_angle = taper;
                    tool.flute_length = 4.5;
                    const double top = 2 * CutterProfile(tool.cutter()).max_radius();
                    tool.shank_diameter = top + wider;
                    tool.shank_length = 40;
                    RoughSettings s;
                    s.allowance = 0.4;
                    s.tolerance = 1;
                    if (stated) s.depth = {2.25, {}};
                    PlanContext context = context_of(part, tool);
                    context.stock_box.lo -= Vec3(3, 3, 0);
                    context.stock_box.hi += Vec3(3, 3, 1);
                    context.stock.box = context.stock_box;
                    const Verification judged = judged_rough(s, part, tool, context, 0.2);
                    QVERIFY(!judged.gouged());
                    const double deepest = judged.collisions.empty() ? 0 : judged.collisions.front().depth;
                    QVERIFY2(judged.collisions.empty(),
                             qPrintable(QString("taper %1, shank %2 wider, depth %3: %4 collisions, the "
                                                "first %5")
                                            .arg(taper)
                                            .arg(wider)
                                            .arg(stated)
                                            .arg(judged.collisions.size())
                                            .arg(deepest)));
                }
    }

    /// A larger ball leaves a skin on the upright ends of a sheet, thinner than is worth a cut: the shank of
    /// the next tool, as thick as its flutes, comes by there.
    void the_shank_meets_no_skin_that_was_left() {
        const auto ramp = [](double x, double) { return 15 + 0.75 * x; };
        const Mesh part = height_field(ramp, Vec2(-20, -9), Vec2(20, 9), 80, 36);
        Tool ball = ball_tool(30), flat = flat_tool(6);
        ball.flute_length = 45;
        flat.flute_length = flat.shank_length = 14;
        flat.shank_diameter = flat.diameter;
        RoughSettings s;
        s.allowance = 0.4;
        s.tolerance = 6;
        s.depth = {1, {}};
        const Rough op(s);
        const auto room = [](PlanContext c) {
            c.stock_box.lo -= Vec3(10, 10, 0);
            c.stock_box.hi += Vec3(10, 10, 2);
            return c;
        };
        const PlanContext first = room(context_of(part, ball));
        PlanContext second = room(context_of(part, flat));
        const auto before =
            std::make_shared<ToolMotions>(link_operation(op, op.plan(first, Progress()), first, Progress()));
        auto earlier = std::make_shared<EarlierCuts>();
        earlier->cutter = ball.cutter();
        for (std::size_t i = 1; i < before->motions.size(); ++i)
            if (before->motions[i].kind != MotionKind::rapid)
                earlier->motions.push_back({before->motions[i - 1].to.tip, before->motions[i].to.tip});
        second.earlier = {earlier};
        const auto after = std::make_shared<ToolMotions>(
            link_operation(op, op.plan(second, Progress()), second, Progress()));
        VerifySettings v;
        v.resolution = v.sample_spacing = 0.4;
        v.allowance = s.allowance;
        v.gouge_limit = 1e-3;
        StockSolid stock;
        stock.box = first.stock_box;
        const VerifyProgram programs[] = {{"B", VerifyTool(ball), before, {}},
                                          {"F", VerifyTool(flat), after, {}}};
        const Verification judged = verify(part, stock, programs, v, Progress());
        QVERIFY2(judged.passed(), qPrintable(QString("gouge %1, %2 collisions")
                                                 .arg(judged.figures.gouge_max)
                                                 .arg(judged.collisions.size())));
    }

    /// Flutes shorter than a wall that roughing left a skin on: the ball cuts that skin strip by strip, its
    /// shank meets none of it, and most of the wall is cut all the same.
    void the_shank_of_finishing_meets_no_skin() {
        const Mesh part = turned(step(0, 16), 0.3);
        Tool flat = flat_tool(6), ball = ball_tool(6);
        flat.flute_length = 30;
        ball.flute_length = 8;
        ball.shank_diameter = 6;
        ball.shank_length = 40;
        RoughSettings r;
        r.allowance = 0.3;
        r.tolerance = 4;
        r.depth = {2, {}};
        Finish3Settings f;
        f.tolerance = 0.1;
        f.stepover = {0.8, ""};
        f.direction = {0, "x"};
        const auto known = [&](const Tool& tool) {
            PlanContext c = raised(part, tool);
            c.stock.box = c.stock_box;
            return c;
        };
        const PlanContext first = known(flat);
        PlanContext second = known(ball);
        const Rough rough(r);
        const Finish3 finish(f);
        const auto before = std::make_shared<ToolMotions>(
            link_operation(rough, rough.plan(first, Progress()), first, Progress()));
        auto earlier = std::make_shared<EarlierCuts>();
        earlier->cutter = flat.cutter();
        earlier->no_nearer = r.allowance;
        for (std::size_t i = 1; i < before->motions.size(); ++i)
            if (before->motions[i].kind != MotionKind::rapid)
                earlier->motions.push_back({before->motions[i - 1].to.tip, before->motions[i].to.tip});
        second.earlier = {earlier};
        const auto cut_of = [&](const PlanContext& context) {
            return std::make_shared<ToolMotions>(
                link_operation(finish, finish.plan(context, Progress()), context, Progress()));
        };
        VerifySettings v;
        v.resolution = v.sample_spacing = 0.5;
        v.tolerance = f.tolerance;
        v.gouge_limit = 0.01;
        const auto judged = [&](const std::shared_ptr<ToolMotions>& after) {
            const VerifyProgram programs[] = {{"R", VerifyTool(flat), before, {}},
                                              {"F", VerifyTool(ball), after, {}}};
            return verify(part, first.stock, programs, v, Progress());
        };
        const Verification kept = judged(cut_of(second));
        QVERIFY2(kept.collisions.empty(), qPrintable(QString::number(kept.collisions.size())));
        QVERIFY(!kept.gouged());
        // One that does not know the stock runs into the skin, and cuts hardly more.
        PlanContext unknowing = context_of(part, ball);
        unknowing.stock_box = second.stock_box;
        const Verification blind = judged(cut_of(unknowing));
        QVERIFY(!blind.collisions.empty());
        QVERIFY2(
            kept.figures.over_fraction <= blind.figures.over_fraction + 0.03,
            qPrintable(QString("%1, %2").arg(kept.figures.over_fraction).arg(blind.figures.over_fraction)));
    }

    /// Two pockets far apart: one is cut to its floor before the other is begun, and no pass comes before one
    /// that it was planned after nearby.
    void one_hollow_is_cut_after_the_other() {
        const auto pockets = [](double x, double y) {
            return std::abs(y) < 7 && std::abs(std::abs(x) - 28) < 9 ? -9.0 : 0.0;
        };
        const Mesh part = height_field(pockets, Vec2(-44, -14), Vec2(44, 14), 176, 56);
        const Tool tool = flat_tool(4);
        PlanContext context = context_of(part, tool);
        RoughSettings s;
        s.allowance = 0.2;
        s.tolerance = 5;
        s.depth = {1.5, {}};
        const Rough op(s);
        const StrategyResult path = op.plan(context, Progress());
        QVERIFY(path.passes.size() >= 12);
        int changes = 0;
        std::array<int, 2> deepest{-1, -1};
        for (std::size_t i = 0; i < path.passes.size(); ++i) {
            const Pass& pass = path.passes[i];
            const bool right = pass.cl.front().tip.x() > 0;
            if (i > 0 && right != (path.passes[i - 1].cl.front().tip.x() > 0)) ++changes;
            QVERIFY(pass.layer >= deepest[right]);
            deepest[right] = pass.layer;
        }
        QCOMPARE(changes, 1);
        QVERIFY(deepest[0] > 4 && deepest[0] == deepest[1]);
    }

    void threads_do_not_change_a_bit() {
        for (const char* word : {"from_tolerance", ""}) {
            RoughSettings s;
            s.tolerance = 1.5;
            s.depth = {*word ? 0.0 : 1.5, word};
            const Rough op(s);
            const PlanContext context = raised(mixed(), ball_tool(5));
            set_thread_count(1);
            const StrategyResult one = op.plan(context, Progress());
            const auto a = numbers(one, link_operation(op, one, context, Progress()));
            set_thread_count(0);
            const StrategyResult many = op.plan(context, Progress());
            const auto b = numbers(many, link_operation(op, many, context, Progress()));
            QVERIFY(a.size() > 500);
            QCOMPARE(a.size(), b.size());
            QVERIFY(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
        }
    }

    void cancelling_anywhere_leaves_nothing() {
        const PlanContext context = raised(mixed(), ball_tool(5));
        RoughSettings s;
        s.tolerance = 1.5;
        const Rough op(s);
        const StrategyResult whole = op.plan(context, Progress());
        const auto reference = numbers(whole, link_operation(op, whole, context, Progress()));
        for (int point = 0; point < 10; ++point) {
            Job job;
            const double at = 0.1 * point;
            QVERIFY2(cancelled_at(job, at, [&](const Progress& p) { op.plan(context, p); }),
                     qPrintable(QString::number(at)));
        }
        const StrategyResult again = op.plan(context, Progress());
        QVERIFY(numbers(again, link_operation(op, again, context, Progress())) == reference);
    }
};

FACETMILL_TEST(TestRoughShapes)
#include "test_rough_shapes.moc"
