// Roughing on parts with known answers: layers, walls, islands, entries, what earlier operations left, and
// what cannot be planned.
#include "core/strategy/rough/rough.h"
#include "core/strategy/rough/rough_check.h"
#include "core/strategy/rough/rough_entry.h"
#include "core/strategy/rough/rough_remaining.h"
#include "core/strategy/surface/stock_before.h"
#include "tests/property/shapes.h"
#include "tests/support/error_code.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A sheet over 80 x 60 at z = 10 with a pocket of 50 x 30 down to 0, round the origin; an island of 10 x 10
/// in it, as high as the rim, if asked for.
Mesh pocket(bool island = false) {
    std::vector<double> x{-40, -25, 25, 40}, y{-30, -15, 15, 30};
    if (island) {
        x = {-40, -25, -5, 5, 25, 40};
        y = {-30, -15, -5, 5, 15, 30};
    }
    const auto low = [&](double u, double v) {
        return std::abs(u) < 25 && std::abs(v) < 15 && !(island && std::abs(u) < 5 && std::abs(v) < 5);
    };
    Mesh m;
    const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        const auto n = Index(m.vertices.size());
        m.vertices.insert(m.vertices.end(), {a, b, c, d});
        m.facets.push_back({n, n + 1, n + 2});
        m.facets.push_back({n, n + 2, n + 3});
    };
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            const double z = low(0.5 * (x[i] + x[i + 1]), 0.5 * (y[j] + y[j + 1])) ? 0 : 10;
            quad(Vec3(x[i], y[j], z), Vec3(x[i + 1], y[j], z), Vec3(x[i + 1], y[j + 1], z),
                 Vec3(x[i], y[j + 1], z));
            const double right =
                i + 2 < x.size() ? (low(0.5 * (x[i + 1] + x[i + 2]), 0.5 * (y[j] + y[j + 1])) ? 0 : 10) : z;
            if (right != z)
                quad(Vec3(x[i + 1], y[j], 0), Vec3(x[i + 1], y[j + 1], 0), Vec3(x[i + 1], y[j + 1], 10),
                     Vec3(x[i + 1], y[j], 10));
            const double above =
                j + 2 < y.size() ? (low(0.5 * (x[i] + x[i + 1]), 0.5 * (y[j + 1] + y[j + 2])) ? 0 : 10) : z;
            if (above != z)
                quad(Vec3(x[i], y[j + 1], 0), Vec3(x[i + 1], y[j + 1], 0), Vec3(x[i + 1], y[j + 1], 10),
                     Vec3(x[i], y[j + 1], 10));
        }
    return m;
}

RoughSettings settings(double depth) {
    RoughSettings s;
    s.depth = {depth, {}};
    s.allowance = 0.5;
    s.tolerance = 4;
    s.direction = {0, "x"};
    return s;
}

PlanContext context(const Mesh& mesh, const Tool& tool, double top = 0) {
    PlanContext c = context_of(mesh, tool);
    c.stock_box.hi.z() += top;
    return c;
}

template <class Visit>
void each_move(const StrategyResult& r, Visit&& visit) {
    for (const Pass& p : r.passes) {
        for (std::size_t i = 1; i < p.entry.size(); ++i)
            visit(p.entry[i - 1].tip, p.entry[i].tip);
        for (std::size_t i = 1; i < p.cl.size(); ++i)
            visit(p.cl[i - 1].tip, p.cl[i].tip);
    }
}

std::shared_ptr<const EarlierCuts> cuts_of(const StrategyResult& r, const Tool& tool) {
    auto cuts = std::make_shared<EarlierCuts>();
    cuts->cutter = tool.cutter();
    each_move(r, [&](const Vec3& a, const Vec3& b) { cuts->motions.push_back({a, b}); });
    return cuts;
}

bool warns(const StrategyResult& r, const char* of) {
    return std::any_of(r.warnings.begin(), r.warnings.end(),
                       [&](const std::string& w) { return w.find(of) != std::string::npos; });
}

} // namespace

class TestRough : public QObject {
    Q_OBJECT
private slots:
    /// Layers, walls and floor of a pocket: the tips fill the pocket less radius and allowance, and no more.
    void a_pocket_is_cleared() {
        const Tool tool = flat_tool(6);
        const PlanContext c = context(pocket(), tool, 0.5);
        const StrategyResult r = Rough(settings(2.5)).plan(c, Progress());
        const double m = r.chord_tolerance;
        // 10.5 + margin is a level place and the floor another; four layers between them.
        QCOMPARE(r.as<RoughPath>()->layers.size(), std::size_t(4));
        QVERIFY(r.as<RoughPath>()->layers.back() > 0.5 + m
                && r.as<RoughPath>()->layers.back() < 0.5 + m + 1e-5);
        Box3 box;
        each_move(r, [&](const Vec3& a, const Vec3& b) {
            box.add(a);
            box.add(b);
        });
        const double wide = 25 - 3 - 0.5, high = 15 - 3 - 0.5;
        for (const auto& [is, exact] : {std::pair(box.lo.x(), -wide), std::pair(-box.hi.x(), -wide),
                                        std::pair(box.lo.y(), -high), std::pair(-box.hi.y(), -high)}) {
            QVERIFY2(is >= exact, qPrintable(QString::number(is - exact)));
            QVERIFY2(is <= exact + 3 * m, qPrintable(QString::number(is - exact)));
        }
        QVERIFY(box.lo.z() >= 0.5 && box.lo.z() <= 0.5 + 2 * m);
        QVERIFY(r.cusp_max < 0.1); // a flat end over levels and walls
        QVERIFY(r.passes.size() < 20);
    }

    /// Nothing goes into full material more steeply than asked for.
    void pockets_are_entered_by_ramps() {
        for (const Tool& tool : {flat_tool(6), ball_tool(6), bull_tool(8, 2)}) {
            const PlanContext c = context(pocket(), tool, 0.5);
            RoughSettings s = settings(2.5);
            for (const double degree : {2.0, 10.0}) {
                s.ramp_angle = radians(degree);
                const StrategyResult r = Rough(s).plan(c, Progress());
                const StockCutter cutter{CutterProfile(tool.cutter())};
                StockField field = stock_before(c, r.as<RoughPath>()->stock_cell, Progress());
                int ramps = 0;
                for (const Pass& p : r.passes) {
                    const Vec3 start = p.entry.empty() ? p.cl.front().tip : p.entry.front().tip;
                    // Above its first place nothing stands.
                    QVERIFY(field.stand_height(cutter, start.head<2>(), start.head<2>())
                            <= start.z() + 0.02 * tool.diameter);
                    ramps += !p.entry.empty();
                    const auto cut = [&](const Vec3& a, const Vec3& b) {
                        const double run = (b - a).head<2>().norm();
                        QVERIFY(b.z() <= a.z());
                        QVERIFY(a.z() - b.z() <= run * std::tan(s.ramp_angle) * (1 + 1e-6) + 1e-9);
                        field.cut(cutter, a, b);
                    };
                    for (std::size_t i = 1; i < p.entry.size(); ++i)
                        cut(p.entry[i - 1].tip, p.entry[i].tip);
                    if (!p.entry.empty()) QVERIFY((p.entry.back().tip - p.cl.front().tip).norm() < 1e-9);
                    for (std::size_t i = 1; i < p.cl.size(); ++i)
                        cut(p.cl[i - 1].tip, p.cl[i].tip);
                }
                QVERIFY(ramps >= int(r.as<RoughPath>()->layers.size()));
            }
            s.entry = RoughSettings::Entry::plunge;
            for (const Pass& p : Rough(s).plan(c, Progress()).passes)
                QVERIFY(p.entry.empty());
            s.entry = RoughSettings::Entry::helix;
            bool helix = false;
            for (const Pass& p : Rough(s).plan(c, Progress()).passes)
                helix = helix || p.entry.size() > 24;
            QVERIFY(helix);
        }
    }

    void open_sides_are_entered_from_outside() {
        const Tool tool = flat_tool(6);
        PlanContext c = context(box(Vec3(-10, -10, 0), Vec3(10, 10, 8)), tool);
        c.stock_box.lo -= Vec3(8, 8, 0);
        c.stock_box.hi += Vec3(8, 8, 2);
        const StrategyResult r = Rough(settings(3)).plan(c, Progress());
        int outside = 0;
        for (const Pass& p : r.passes)
            outside += p.entry.empty();
        QCOMPARE(outside, int(r.passes.size()));
        QCOMPARE(r.as<RoughPath>()->layers.back(), 0.0);
        QVERIFY(r.warnings.empty());
    }

    /// Layers as deep as was asked for stand on a slope as steps: a figure, and nothing to warn of.
    void steps_of_a_stated_depth_are_no_warning() {
        const Mesh slope =
            height_field([](double x, double) { return 0.5 * x; }, Vec2(-15, -10), Vec2(15, 10), 30, 20);
        PlanContext c = context(slope, flat_tool(6), 1);
        c.stock_box.lo -= Vec3(8, 8, 0);
        c.stock_box.hi += Vec3(8, 8, 0);
        RoughSettings s = settings(3);
        s.tolerance = 0.2;
        const StrategyResult r = Rough(s).plan(c, Progress());
        QVERIFY(r.cusp_max > 1 && r.cusp_max < 4);
        QVERIFY2(r.warnings.empty(), r.warnings.empty() ? "" : r.warnings.front().c_str());
    }

    /// The island keeps its allowance all round, and the pocket is cleared on all its sides.
    void islands_are_gone_round() {
        const Tool tool = flat_tool(6);
        const PlanContext c = context(pocket(true), tool, 0.5);
        for (const double angle : {0.0, 0.5 * pi, 0.6}) {
            RoughSettings s = settings(2.5);
            s.direction = {angle, {}};
            const StrategyResult r = Rough(s).plan(c, Progress());
            double nearest = infinity;
            each_move(r, [&](const Vec3& a, const Vec3& b) {
                for (int i = 0; i <= 200; ++i) {
                    const Vec3 p = a + (i / 200.0) * (b - a);
                    const Vec2 d = p.head<2>().cwiseAbs() - Vec2(5, 5);
                    nearest = std::min(nearest, d.cwiseMax(0.0).norm());
                }
            });
            QVERIFY2(nearest >= 3.5, qPrintable(QString::number(nearest - 3.5)));
            QVERIFY(nearest <= 3.5 + 3 * r.chord_tolerance);
            // Nothing stands where the tool could go.
            const StockCutter cutter{CutterProfile(tool.cutter())};
            StockField field = stock_before(c, r.as<RoughPath>()->stock_cell, Progress());
            each_move(r, [&](const Vec3& from, const Vec3& to) { field.cut(cutter, from, to); });
            for (int row = 0; row < field.rows(); ++row)
                for (int column = 0; column < field.columns(); ++column) {
                    const Vec2 p = field.center(column, row).cwiseAbs();
                    const bool clear = p.x() < 24.3 && p.y() < 14.3 && (p.x() > 5.7 || p.y() > 5.7);
                    const bool corner = p.x() > 21.4 && p.y() > 11.4; // rounder than the tool
                    if (clear && !corner)
                        QVERIFY2(
                            field.middle(column, row) < 0.51 + 0.02,
                            qPrintable(
                                QString("%1 %2 %3").arg(p.x()).arg(p.y()).arg(field.middle(column, row))));
                }
        }
    }

    /// From one side of an island to the other the tool goes up and over, where all between is cut: at feed
    /// that takes several times as long.
    void long_ways_without_work_are_left_to_rapids() {
        const Tool tool = flat_tool(6);
        const PlanContext c = context(pocket(true), tool, 0.5);
        const StockCutter cutter{CutterProfile(tool.cutter())};
        for (const double angle : {0.0, 0.5 * pi, 0.6}) {
            RoughSettings s = settings(2.5);
            s.direction = {angle, {}};
            const StrategyResult r = Rough(s).plan(c, Progress());
            StockField field = stock_before(c, r.as<RoughPath>()->stock_cell, Progress());
            double longest = 0;
            for (const Pass& p : r.passes) {
                for (std::size_t i = 1; i < p.entry.size(); ++i)
                    field.cut(cutter, p.entry[i - 1].tip, p.entry[i].tip);
                double idle = 0;
                for (std::size_t i = 1; i < p.cl.size(); ++i) {
                    const Vec3 &a = p.cl[i - 1].tip, &b = p.cl[i].tip;
                    idle = field.has_work(cutter, a, b, 0.01) ? 0 : idle + (b - a).norm();
                    longest = std::max(longest, idle);
                    field.cut(cutter, a, b);
                }
            }
            QVERIFY2(longest <= 2.5 * tool.diameter, qPrintable(QString::number(longest)));
        }
    }

    void what_is_cut_already_is_air() {
        const Tool tool = flat_tool(6);
        PlanContext c = context(pocket(), tool, 0.5);
        const StrategyResult first = Rough(settings(2.5)).plan(c, Progress());
        c.earlier = {cuts_of(first, tool)};
        std::string message;
        QCOMPARE(code_of([&] { Rough(settings(2.5)).plan(c, Progress()); }, &message),
                 std::string("empty_result"));
        // Finer layers and a smaller allowance find what is left, and enter where it is cut.
        RoughSettings s = settings(2.5);
        s.allowance = 0.1;
        const StrategyResult again = Rough(s).plan(c, Progress());
        double is = 0, fresh = 0;
        each_move(again, [&](const Vec3& a, const Vec3& b) { is += (b - a).norm(); });
        c.earlier.clear();
        each_move(Rough(s).plan(c, Progress()),
                  [&](const Vec3& a, const Vec3& b) { fresh += (b - a).norm(); });
        QVERIFY2(is < 0.7 * fresh, qPrintable(QString("%1 %2").arg(is).arg(fresh)));
    }

    /// Where an earlier operation left nothing to cut between two levels, there are no layers, and passes are
    /// numbered by those that there are.
    void layers_are_those_that_are_cut() {
        const Tool tool = flat_tool(6);
        PlanContext c = context(step(0, 8), tool, 2); // a wall at y = 0, low beyond it
        auto earlier = std::make_shared<EarlierCuts>();
        earlier->cutter = tool.cutter();
        for (double y = 3.513; y < 20; y += 2.5)
            earlier->motions.push_back({Vec3(-25, y, 3), Vec3(25, y, 3)});
        c.earlier = {earlier};
        const StrategyResult r = Rough(settings(1)).plan(c, Progress());
        for (const Pass& p : r.passes) {
            QVERIFY(p.layer >= 0 && std::size_t(p.layer) < r.as<RoughPath>()->layers.size());
            for (const CutterLocation& l : p.cl)
                QCOMPARE(l.tip.z(), r.as<RoughPath>()->layers[std::size_t(p.layer)]);
        }
        QVERIFY(std::any_of(r.as<RoughPath>()->layers.begin(), r.as<RoughPath>()->layers.end(),
                            [](double z) { return z > 8; }));
        QVERIFY(std::any_of(r.as<RoughPath>()->layers.begin(), r.as<RoughPath>()->layers.end(),
                            [](double z) { return z < 3; }));
        QVERIFY(std::none_of(r.as<RoughPath>()->layers.begin(), r.as<RoughPath>()->layers.end(),
                             [](double z) { return z > 3 && z < 8; }));
    }

    void oneway_lines_all_run_one_way() {
        const Tool tool = ball_tool(6);
        PlanContext c = context(
            height_field([](double x, double) { return 0.1 * x; }, Vec2(-20, -15), Vec2(20, 15), 8, 6), tool,
            5);
        RoughSettings s = settings(2);
        s.pattern = RoughSettings::Pattern::oneway;
        s.tolerance = 9;
        const StrategyResult r = Rough(s).plan(c, Progress());
        int lines = 0;
        for (const Pass& p : r.passes) {
            if (p.drive < 0) continue;
            ++lines;
            QVERIFY(p.cl.back().tip.x() > p.cl.front().tip.x());
            for (const CutterLocation& l : p.cl)
                QCOMPARE(l.tip.y(), p.cl.front().tip.y());
        }
        QVERIFY(lines > 10);
    }

    void holders_keep_from_what_stands() {
        Tool tool = flat_tool(6);
        tool.flute_length = 6;
        tool.shank_length = 1;
        tool.holder = {{30, 20}};
        const PlanContext c = context(pocket(), tool, 0.5);
        const StrategyResult r = Rough(settings(2.5)).plan(c, Progress());
        QVERIFY(warns(r, "holder"));
        // The holder's face is 7 above the tip, the rim at 10: no tip below 3.
        each_move(r, [&](const Vec3&, const Vec3& b) { QVERIFY(b.z() >= 3); });
        QVERIFY(!r.passes.empty());
    }

    void vertex_offsets_are_compared_and_reported() {
        // Normals at the rim and foot of walls lean: the walls move by less than the allowance.
        const Tool tool = flat_tool(6);
        const PlanContext c = context(step(0, 8), tool, 2);
        RoughSettings s = settings(2.5);
        s.allowance = 1;
        const StrategyResult exact = Rough(s).plan(c, Progress());
        QVERIFY(!warns(exact, "offset by vertices"));
        s.offset = RoughSettings::Offset::vertices;
        const StrategyResult crude = Rough(s).plan(c, Progress());
        QVERIFY(warns(crude, "offset by vertices"));
        // The part itself is kept, however its facets lie.
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const PlanContext dirty = context(*soup(40, 20, seed), tool, 5);
            const StrategyResult any = Rough(s).plan(dirty, Progress());
            const AxialLift part(dirty.contact, CutterProfile(tool.cutter()));
            const double in = deepest_in_allowance(part, any.passes, 0.05, Progress()).depth;
            QVERIFY2(in <= 1e-9, qPrintable(QString("%1 mm in the part of seed %2").arg(in).arg(seed)));
        }
        // A plane has no such place.
        const PlanContext plane = context(
            height_field([](double, double) { return 0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3), tool, 5);
        QVERIFY(!warns(Rough(s).plan(plane, Progress()), "offset by vertices"));
    }

    /// At the foot of a dome that stands on the bottom of the stock, a ball would have to go below it.
    void what_the_bottom_of_the_stock_keeps_the_tool_from_is_told() {
        RoughSettings s = settings(2);
        s.depth = {0, "from_tolerance"};
        s.tolerance = 0.5;
        PlanContext c = context(dome(10, 16), ball_tool(10), 3);
        c.stock_box.lo.head<2>().array() -= 5;
        c.stock_box.hi.head<2>().array() += 5;
        const StrategyResult ball = Rough(s).plan(c, Progress());
        QVERIFY2(warns(ball, "would have to be lower"), qPrintable(QString::number(ball.warnings.size())));
        c.tool = flat_tool(6);
        QVERIFY(!warns(Rough(s).plan(c, Progress()), "would have to be lower"));
    }

    /// What the form shows is what the plan does.
    void the_preview_has_the_layers_of_the_plan() {
        const Tool tool = flat_tool(6);
        const PlanContext c = context(pocket(true), tool, 3.3);
        RoughSettings s = settings(2);
        LayerPreview preview = Rough(s).preview_layers(c, Progress());
        StrategyResult r = Rough(s).plan(c, Progress());
        // All of them but the floor at the part's lowest place, where the layer above has left the allowance.
        QVERIFY(preview.heights.size() == r.as<RoughPath>()->layers.size() + 1
                && preview.heights.back() == 0);
        QVERIFY(std::equal(r.as<RoughPath>()->layers.begin(), r.as<RoughPath>()->layers.end(),
                           preview.heights.begin()));
        QVERIFY(std::abs(preview.remaining - r.cusp_max) < 1e-9);
        QVERIFY(preview.depth_max <= 2 + 1e-9 && preview.depth_min > 0);
        QVERIFY(std::abs(preview.stock.hi.z() - c.stock_box.hi.z()) < 1e-6);
        // Over what an operation before has left.
        PlanContext later = c;
        later.earlier.push_back(cuts_of(r, tool));
        RoughSettings finer = settings(1);
        finer.allowance = 0.1;
        preview = Rough(finer).preview_layers(later, Progress());
        r = Rough(finer).plan(later, Progress());
        for (const double z : r.as<RoughPath>()->layers)
            QVERIFY(std::find(preview.heights.begin(), preview.heights.end(), z) != preview.heights.end());
        s.stepover = {6.1, {}};
        QCOMPARE(code_of([&] { Rough(s).preview_layers(c, Progress()); }), std::string("out_of_range"));
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(Rough(settings(2)).preview_layers(c, Progress(job)), Cancelled);
    }

    /// What hangs over its wide end would be met by the neck, the shank and rapids.
    void undercut_tools_are_refused() {
        for (const double taper : {-5.0, -45.0}) {
            Tool dovetail = flat_tool(6);
            dovetail.taper_angle = radians(taper);
            dovetail.flute_length = 2;
            const PlanContext c = context(pocket(), dovetail, 0.5);
            std::string message;
            QCOMPARE(code_of([&] { Rough(settings(1)).plan(c, Progress()); }, &message),
                     std::string("out_of_range"));
            QVERIFY(message.starts_with("tool: "));
        }
        Tool tapered = flat_tool(6);
        tapered.taper_angle = radians(5);
        tapered.flute_length = 4;
        Rough(settings(1)).plan(context(pocket(), tapered, 0.5), Progress());
    }

    void bad_values_are_refused() {
        const Tool tool = flat_tool(6);
        const PlanContext c = context(pocket(), tool, 0.5);
        const auto code = [&](const RoughSettings& s, const PlanContext& with) {
            std::string message;
            const std::string word = code_of([&] { Rough(s).plan(with, Progress()); }, &message);
            return word + ": " + message;
        };
        QVERIFY(code(settings(0), c).starts_with("out_of_range: depth"));
        QVERIFY(code(settings(61), c).find("flutes") != std::string::npos);
        RoughSettings s = settings(2);
        s.stepover = {6.1, {}};
        QVERIFY(code(s, c).starts_with("out_of_range: stepover"));
        s = settings(2);
        s.allowance = 50;
        QVERIFY(code(s, c).starts_with("empty_result"));
        // A stock that ends below the part.
        PlanContext below = c;
        below.stock_box.lo.z() = -20;
        below.stock_box.hi.z() = -5;
        QVERIFY(code(settings(2), below).find("stock ends") != std::string::npos);
        // Wider than the pocket: nothing to be had, and from a higher stock only what is above.
        QVERIFY(code(settings(2), context(pocket(), flat_tool(40), 0.5)).starts_with("empty_result"));
        const StrategyResult above = Rough(settings(2)).plan(context(pocket(), flat_tool(40), 6), Progress());
        QVERIFY(warns(above, "too large for hollows"));
        // A ball cannot leave almost nothing.
        s = settings(2);
        s.depth = {0, "from_tolerance"};
        s.tolerance = 1e-5;
        QVERIFY(code(s, context(pocket(), ball_tool(6), 0.5)).starts_with("out_of_range: tolerance"));
    }

    /// A pocket hardly wider than the tool: no ramp, no helix.
    void narrow_places_are_left_out_or_plunged_into() {
        const Mesh narrow = height_field(
            [](double x, double y) { return std::abs(x) < 3.6 && std::abs(y) < 3.6 ? 0.0 : 10.0; },
            Vec2(-10, -10), Vec2(10, 10), 80, 80);
        const PlanContext c = context(narrow, flat_tool(6), 4);
        const StrategyResult r = Rough(settings(2)).plan(c, Progress());
        QVERIFY(warns(r, "no room to enter"));
        RoughSettings s = settings(2);
        s.entry = RoughSettings::Entry::plunge;
        const StrategyResult plunged = Rough(s).plan(c, Progress());
        QVERIFY(!warns(plunged, "no room to enter"));
        QVERIFY(plunged.as<RoughPath>()->layers.size() > r.as<RoughPath>()->layers.size());
    }
};

FACETMILL_TEST(TestRough)
#include "test_rough.moc"
