// What the judge says of the whole: verified, failed or not to be judged, on jobs whose answer is known, also
// where the mesh is dirty.
#include "core/setup/kinematics.h"
#include "core/setup/machine.h"
#include "core/verify/verify.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

StockSolid stock_of(const Box3& box) {
    StockSolid stock;
    stock.box = box;
    return stock;
}

/// Lines along X over a rectangle, at one height, `step` apart, with an end 2 mm beyond it.
VerifyProgram lines(const Tool& tool, const Vec2& lo, const Vec2& hi, double z, double step) {
    auto motions = std::make_shared<ToolMotions>();
    const auto to = [&](MotionKind kind, const Vec3& tip) {
        motions->motions.push_back({kind, {tip, Vec3::UnitZ()}, no_index, no_index});
    };
    to(MotionKind::rapid, Vec3(lo.x() - 20, lo.y(), z + 40));
    bool back = false;
    for (double y = lo.y(); y <= hi.y() + 1e-9; y += step, back = !back) {
        const double from = back ? hi.x() + 2 : lo.x() - 2, end = back ? lo.x() - 2 : hi.x() + 2;
        to(MotionKind::cut, Vec3(from, y, z));
        to(MotionKind::cut, Vec3(end, y, z));
    }
    return {"Lines", VerifyTool(tool), motions, std::nullopt};
}

VerifySettings asked(double tolerance = 0.05) {
    VerifySettings s;
    s.resolution = s.sample_spacing = 0.5;
    s.tolerance = tolerance;
    s.gouge_limit = 0.005;
    return s;
}

Verification judged(const Mesh& part, const StockSolid& stock, const VerifyProgram& program,
                    const VerifySettings& settings = asked()) {
    return verify(part, stock, {&program, 1}, settings, Progress());
}

const UncutReason* reason(const Verification& v, UncutReason::Why why) {
    for (const UncutReason& r : v.uncut)
        if (r.why == why) return &r;
    return nullptr;
}

/// What has this outline (y, z) over 60 mm along X, closed; its ends as these quads.
Mesh prism(const std::vector<Vec2>& outline, const std::vector<std::array<Index, 4>>& ends) {
    Mesh mesh;
    const auto n = Index(outline.size());
    for (double x : {-30.0, 30.0})
        for (const Vec2& p : outline)
            mesh.vertices.push_back(Vec3(x, p.x(), p.y()));
    for (Index i = 0; i < n; ++i) {
        const Index j = (i + 1) % n;
        mesh.facets.push_back({i, i + n, j});
        mesh.facets.push_back({j, i + n, j + n});
    }
    for (const auto& quad : ends) {
        mesh.facets.push_back({quad[0], quad[1], quad[2]});
        mesh.facets.push_back({quad[0], quad[2], quad[3]});
        mesh.facets.push_back({quad[0] + n, quad[2] + n, quad[1] + n});
        mesh.facets.push_back({quad[0] + n, quad[3] + n, quad[2] + n});
    }
    return mesh;
}

/// A block with a groove along X of width `wide` and depth `deep` in its top.
Mesh grooved(double wide, double deep) {
    const double w = 0.5 * wide;
    return prism({{-20, -10}, {20, -10}, {20, 0}, {w, 0}, {w, -deep}, {-w, -deep}, {-w, 0}, {-20, 0}},
                 {{0, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 3, 4}});
}

} // namespace

class TestVerdict : public QObject {
    Q_OBJECT
private slots:
    void a_finished_block() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 2;
        const Verification v = judged(part, stock, lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6));
        QCOMPARE(int(v.verdict()), int(Verdict::verified));
        QCOMPARE(v.uncut_share, 0.0);
        QVERIFY(v.uncut.empty());
        QVERIFY(v.figures.gouge_max < 1e-9);
    }

    /// What the stock would need is known before anything is cut. The advice leads to a resolution that fits,
    /// of a stock of few tiles not always at once.
    void a_stock_beyond_the_memory_is_refused_before_cutting() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid block = stock_of(part.box());
        block.box.hi.z() = 2;
        StockSolid cast = block;
        cast.kind = StockSolid::Kind::mesh;
        cast.mesh = std::make_shared<const Mesh>(box(block.box.lo, block.box.hi));
        const VerifyProgram program = lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6);
        for (const StockSolid& stock : {block, cast}) {
            VerifySettings s = asked();
            s.resolution = 0.1;
            s.max_stock_bytes = 1'200'000; // more than either needs at 0.2 mm, less than at 0.1
            std::string message;
            int refused = 0;
            while (code_of([&] { judged(part, stock, program, s); }, &message) == "limit_exceeded") {
                const auto advice = message.find("use at least ");
                QVERIFY2(message.find(" mm needs about") != std::string::npos && advice != std::string::npos,
                         message.c_str());
                const double better = std::stod(message.substr(advice + 13));
                QVERIFY2(better > s.resolution && better < 0.2, message.c_str());
                s.resolution = better;
                ++refused;
            }
            QVERIFY2(refused >= 1 && refused <= 3, qPrintable(QString::number(refused)));
        }
    }

    void work_is_told_before_it_begins() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 2;
        const VerifyProgram program = lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6);
        std::vector<VerifyWork> told;
        VerifySettings s = asked();
        s.before_work = [&](const VerifyWork& work) { told.push_back(work); };
        for (const double resolution : {0.4, 0.2}) {
            s.resolution = s.sample_spacing = resolution;
            const Verification v = judged(part, stock, program, s);
            // Of orders of magnitude: the places are those that are compared.
            QVERIFY(told.back().places > 0.3 * double(v.figures.samples));
            QVERIFY(told.back().places < 10 * double(v.figures.samples));
        }
        // Four times as many rays and places.
        QCOMPARE(told.size(), std::size_t(2));
        QVERIFY(std::abs(told[1].rays_asked / told[0].rays_asked - 4) < 1e-6);
        QVERIFY(std::abs(told[1].places / told[0].places - 4) < 1e-6);
        QVERIFY(told[1].seconds > told[0].seconds && told[1].seconds < 60);
        QVERIFY(told[1].bytes > told[0].bytes);
        s.before_work = [](const VerifyWork&) { throw Error(ErrorCode::limit_exceeded, "work", "", ""); };
        QCOMPARE(code_of([&] { judged(part, stock, program, s); }), "limit_exceeded");
    }

    /// A stock that is cut for those who plan on it is coarser where cutting it would take long, and what is
    /// left is the same to its spacing.
    void what_is_left_is_known_more_coarsely_where_that_takes_long() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 2;
        const VerifyProgram program = lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6);
        VerifySettings s = asked();
        s.resolution = 0;
        const auto fine = stock_after(stock, {&program, 1}, s, Progress());
        QVERIFY(std::abs(fine->lattice().spacing.maxCoeff() - 0.2) < 0.02);
        s.usual_rays_asked = 1000;
        const auto coarse = stock_after(stock, {&program, 1}, s, Progress());
        QVERIFY(std::abs(coarse->lattice().spacing.maxCoeff() - 0.5) < 0.05); // an eighth of the radius
        QVERIFY(std::abs(coarse->volume() - fine->volume()) < 0.01 * fine->volume());
        s.resolution = 0.2; // what is asked for stays
        QVERIFY(std::abs(stock_after(stock, {&program, 1}, s, Progress())->lattice().spacing.maxCoeff() - 0.2)
                < 0.02);
    }

    /// A channel half a millimetre deep over the rim of a block is a gouge of that depth: how long a probe on
    /// its wall runs along it says nothing.
    void depth_is_penetration() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        for (const Tool& tool : {flat_tool(8), ball_tool(8), bull_tool(8, 1)}) {
            const Verification v =
                judged(part, stock_of(part.box()), lines(tool, Vec2(-20, 0), Vec2(20, 0), -0.5, 1));
            QCOMPARE(int(v.verdict()), int(Verdict::failed));
            QVERIFY2(std::abs(v.figures.gouge_max - 0.5) < 0.01,
                     qPrintable(QString::number(v.figures.gouge_max)));
            QCOMPARE(v.program_gouges[0], v.figures.gouge_max);
            QVERIFY(std::abs(v.gouges.front().deviation + v.figures.gouge_max) < 1e-12);
        }
    }

    /// Flipping, doubling and loosening facets changes nothing of what a path does to them.
    void dirty_facets_change_nothing() {
        const Mesh clean = dome(12, 10);
        StockSolid stock = stock_of(clean.box());
        stock.box.hi.z() += 1;
        std::mt19937 random(4);
        for (const double z : {12.0, 11.7}) { // on the top of the dome, and into it
            const VerifyProgram program = lines(ball_tool(6), Vec2(-12, 0), Vec2(12, 0), z, 1);
            const Verification right = judged(clean, stock, program);
            QCOMPARE(right.gouged(), z < 12);
            for (int round = 0; round < trials(8, 8); ++round) {
                Mesh dirty;
                std::size_t turned_ones = 0;
                for (std::size_t f = 0; f < clean.facet_count(); ++f)
                    for (std::size_t copies = 1 + (random() % 5 == 0); copies > 0; --copies) {
                        const auto at = Index(dirty.vertices.size());
                        for (int k = 0; k < 3; ++k)
                            dirty.vertices.push_back(clean.corner(f, k));
                        const bool turn = random() % 3 == 0;
                        turned_ones += turn;
                        dirty.facets.push_back(turn ? Facet{at, at + 2, at + 1} : Facet{at, at + 1, at + 2});
                    }
                QVERIFY(turned_ones > 10);
                const Verification v = judged(dirty, stock, program);
                QCOMPARE(v.gouged(), right.gouged());
                const auto deepest = [](const Verification& w) {
                    return std::max(w.figures.gouge_max, w.border.gouge_max);
                };
                QVERIFY(std::abs(deepest(v) - deepest(right)) < 0.02);
            }
        }
    }

    void a_tool_too_large_for_the_hollows() {
        const Mesh part = grooved(6, 5);
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 1;
        // Over the top a flat end of 12 mm leaves the whole groove; one of 5 mm would fit.
        const VerifyProgram large = lines(flat_tool(12), Vec2(-30, -20), Vec2(30, 20), 0, 8);
        Verification v = judged(part, stock, large);
        QCOMPARE(int(v.verdict()), int(Verdict::failed));
        QVERIFY(!v.gouged() && v.collisions.empty());
        const UncutReason* no_tool = reason(v, UncutReason::Why::no_tool);
        QVERIFY(no_tool);
        // At its open ends the tool's rim could stand on the groove's floor.
        const UncutReason* ends = reason(v, UncutReason::Why::not_cut);
        QVERIFY(!ends || ends->area < 0.1 * no_tool->area);
        QVERIFY2(std::abs(no_tool->area - 6 * 60) < 60, qPrintable(QString::number(no_tool->area)));
        // The groove's middle is 3 mm from its walls.
        QVERIFY(std::abs(no_tool->excess_max - 3) < 0.1);
        QVERIFY(std::abs(v.uncut_share - 0.15) < 0.03);
        // With as much allowed it passes.
        VerifySettings lax = asked();
        lax.uncut_limit = 0.2;
        QCOMPARE(int(judged(part, stock, large, lax).verdict()), int(Verdict::verified));
        const VerifyProgram small = lines(flat_tool(5), Vec2(-30, -20), Vec2(30, 20), 0, 4);
        v = judged(part, stock, small);
        QCOMPARE(int(v.verdict()), int(Verdict::failed));
        QVERIFY(reason(v, UncutReason::Why::not_cut) && !reason(v, UncutReason::Why::no_tool));
    }

    /// The tool of roughing would fit, and roughing is not there to finish.
    void a_tool_that_only_roughs_is_no_help() {
        const Mesh part = grooved(6, 5);
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 1;
        std::array<VerifyProgram, 2> programs{lines(flat_tool(5), Vec2(-30, -20), Vec2(30, 20), 0.5, 4),
                                              lines(flat_tool(12), Vec2(-30, -20), Vec2(30, 20), 0, 8)};
        programs[0].name = "Rough";
        programs[1].name = "Finish";
        const double over = 2 * asked().tolerance;
        programs[0].leaves = 0.9 * over;
        const Verification finishing = verify(part, stock, programs, asked(), Progress());
        QVERIFY(reason(finishing, UncutReason::Why::not_cut));
        QVERIFY(!reason(finishing, UncutReason::Why::no_operation));
        programs[0].leaves = 1.1 * over;
        const Verification v = verify(part, stock, programs, asked(), Progress());
        const UncutReason* nobody = reason(v, UncutReason::Why::no_operation);
        QVERIFY(nobody && nobody->counts());
        QCOMPARE(nobody->program, programs[0].name);
        QVERIFY2(std::abs(nobody->area - 6 * 60) < 60, qPrintable(QString::number(nobody->area)));
        QCOMPARE(v.uncut_share, finishing.uncut_share);
        // Where the finishing tool fits it is what does not go there, whatever roughing could.
        const UncutReason* ends = reason(v, UncutReason::Why::not_cut);
        QVERIFY(!ends || ends->program == programs[1].name);
    }

    /// In a slot that nobody cuts what stands on a wall ends at the other one, however long the block is.
    void what_stands_ends_at_the_part() {
        const Mesh part = grooved(6, 5);
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 1;
        const Verification v = judged(part, stock, lines(flat_tool(12), Vec2(-30, -20), Vec2(30, 20), 0, 8));
        const DeviationSurface& s = *v.surface;
        std::size_t on_walls = 0;
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            if (std::abs(s.normals[i][1]) < 0.9f || std::abs(s.points[i][1]) > 4 || s.points[i][2] > -0.01f)
                continue;
            ++on_walls;
            // The middle of the slot is farthest from the part: from walls, floor and rims.
            const double expected = std::min(3.0, 5.0 + double(s.points[i][2]));
            QVERIFY2(std::abs(double(s.deviation[i]) - std::max(expected, 0.1)) < 0.2,
                     qPrintable(QString::number(double(s.deviation[i]))));
        }
        QVERIFY(on_walls > 100);
    }

    /// What stands on a wall is as high as the wall over the floor at its foot, but no farther from the part
    /// than it is thick. A fin on the open floor is as far as it is high, however thin.
    void excess_is_a_distance_from_the_part() {
        const Mesh part = test::step(0, 10); // low where y > 0
        StockSolid stock = stock_of(part.box());
        stock.box.lo.z() -= 1;
        const auto highest = [&](double from, double fin) {
            // One row at the wall, one before the fin and one beyond it.
            std::vector<VerifyProgram> rows;
            for (const double y : {from + 4, 6.01 - 0.5 * fin, 13.99 + 0.5 * fin})
                rows.push_back(lines(flat_tool(8), Vec2(-20, y), Vec2(20, y), 0, 1));
            VerifySettings s = asked();
            s.sample_spacing = under_sanitizer ? 0.4 : 0.1;
            const Verification v = verify(part, stock, rows, s, Progress());
            double excess = 0;
            const DeviationSurface& surface = *v.surface;
            for (std::size_t i = 0; i < surface.points.size(); ++i)
                if (surface.points[i][2] < 1e-3f && surface.normals[i][2] > 0.9f
                    && std::abs(surface.points[i][0]) < 10 && surface.points[i][1] < 14)
                    excess = std::max(excess, double(surface.deviation[i]));
            return excess;
        };
        QVERIFY(highest(0, 0) < 1e-6);
        const double thin = highest(0.025, 0), thick = highest(0.4, 0);
        QVERIFY2(thin > 0 && thin <= 0.05, qPrintable(QString::number(thin)));
        // What is beyond the limit is told to a thirtieth.
        QVERIFY2(thick > 0.3 && thick <= 0.4 * (1 + 1.0 / 30), qPrintable(QString::number(thick)));
        const double fin = highest(0, 0.17);
        QVERIFY2(fin > 8, qPrintable(QString::number(fin)));
    }

    void a_stock_smaller_than_the_part() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid stock = stock_of(part.box());
        stock.box.hi = Vec3(10, 15, 2);
        const Verification v = judged(part, stock, lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6));
        QCOMPARE(int(v.verdict()), int(Verdict::failed));
        const UncutReason* outside = reason(v, UncutReason::Why::outside_stock);
        QVERIFY(outside && std::abs(outside->area - 300) < 60);
    }

    /// Under a roof nothing is asked for, and that is told.
    void what_no_axis_sees_is_told() {
        Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        const Mesh roof = box(Vec3(-5, -5, 6), Vec3(5, 5, 8));
        const auto first = Index(part.vertices.size());
        part.vertices.insert(part.vertices.end(), roof.vertices.begin(), roof.vertices.end());
        for (const Facet& f : roof.facets)
            part.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
        StockSolid stock = stock_of(part.box());
        VerifyProgram around = lines(flat_tool(4), Vec2(-20, -15), Vec2(20, -7.001), 0, 2);
        const VerifyProgram other = lines(flat_tool(4), Vec2(-20, 7.001), Vec2(20, 15), 0, 2);
        const std::array<VerifyProgram, 2> both{around, other};
        const Verification v = verify(part, stock, both, asked(), Progress());
        const UncutReason* hidden = reason(v, UncutReason::Why::not_seen);
        QVERIFY(hidden && std::abs(hidden->area - 100) < 25);
        QVERIFY(!hidden->counts());
    }

    /// What is left because the holder would touch a wall has its own reason, whatever a tool for roughing
    /// could do there.
    void what_the_holder_keeps_off() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-10, 0}, {-10, 30}, {-20, 30}},
                                {{0, 1, 2, 3}, {0, 3, 4, 5}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 31;
        Tool tool = flat_tool(4);
        tool.flute_length = 10;
        tool.shank_diameter = 4;
        tool.shank_length = 5;
        tool.holder = {{20, 20}};
        const Vec2 lo(-30, 1), hi(30, 20);
        const VerifyProgram finish = lines(tool, lo, hi, 0, 2);
        const Verification v = judged(part, stock, finish);
        const UncutReason* held = reason(v, UncutReason::Why::held);
        QVERIFY(held && held->counts());
        // With the holder at the wall the cutter comes within 8 mm of it.
        QVERIFY2(std::abs(held->area - 8 * 60) < 60, qPrintable(QString::number(held->area)));
        const VerifyProgram rough = lines(flat_tool(6), lo, hi, 0.5, 2);
        const std::array<VerifyProgram, 2> both{rough, finish};
        const Verification w = verify(part, stock, both, asked(), Progress());
        QVERIFY(reason(w, UncutReason::Why::held) && reason(w, UncutReason::Why::held)->area == held->area);
        Tool longer = tool;
        longer.shank_length = 40;
        const Verification x = judged(part, stock, lines(longer, lo, hi, 0, 2));
        QVERIFY(reason(x, UncutReason::Why::not_cut) && !reason(x, UncutReason::Why::held));
    }

    /// A clean-up is there for what the cutter before it cannot enter: where that one fits, what keeps its
    /// operation off is the reason, though the smaller tool could go there; in a groove that it does not
    /// enter the smaller one is what does not go there.
    void what_is_not_for_the_smaller_tool() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-10, 0}, {-10, 30}, {-20, 30}},
                                {{0, 1, 2, 3}, {0, 3, 4, 5}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 31;
        Tool tool = flat_tool(4);
        tool.flute_length = 10;
        tool.shank_diameter = 4;
        tool.shank_length = 5;
        tool.holder = {{20, 20}};
        Tool small = flat_tool(2);
        small.flute_length = 40;
        std::array<VerifyProgram, 2> programs{lines(tool, Vec2(-30, 1), Vec2(30, 20), 0, 2),
                                              lines(small, Vec2(-30, 18), Vec2(30, 20), 0, 1)};
        programs[0].name = "Finish";
        programs[1].name = "Clean-up";
        const Verification all = verify(part, stock, programs, asked(), Progress());
        const UncutReason* not_cut = reason(all, UncutReason::Why::not_cut);
        QVERIFY(not_cut && not_cut->program == programs[1].name && !reason(all, UncutReason::Why::held));
        programs[1].beyond = tool.cutter();
        const Verification v = verify(part, stock, programs, asked(), Progress());
        const UncutReason* held = reason(v, UncutReason::Why::held);
        QVERIFY(held && held->program == programs[0].name);
        QVERIFY2(std::abs(held->area - 8 * 60) < 60, qPrintable(QString::number(held->area)));
        QCOMPARE(v.uncut_share, all.uncut_share);

        const Mesh groove = grooved(6, 5);
        StockSolid block = stock_of(groove.box());
        block.box.hi.z() = 1;
        std::array<VerifyProgram, 2> over{lines(flat_tool(12), Vec2(-30, -20), Vec2(30, 20), 0, 8),
                                          lines(flat_tool(5), Vec2(-30, -20), Vec2(30, 20), 0, 4)};
        over[0].name = "Finish";
        over[1].name = "Clean-up";
        over[1].beyond = flat_tool(12).cutter();
        const Verification w = verify(groove, block, over, asked(), Progress());
        const UncutReason* floor = reason(w, UncutReason::Why::not_cut);
        QVERIFY(floor && floor->program == over[1].name && floor->area > 5 * 60);
    }

    /// A tool whose flutes are shorter than what stands of the stock about a slot does not go deeper, though
    /// it fits; nothing of the part is in its shank's way.
    void what_the_stock_keeps_off() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 12;
        Tool tool = flat_tool(4);
        tool.flute_length = 5;
        tool.shank_diameter = 4;
        tool.shank_length = 40;
        // Of a floor of 40 x 60 a half is open, on the other one all of the 12 mm stands.
        const Vec2 lo(-30, 0.5), hi(-2, 12);
        Tool longer = tool;
        longer.flute_length = 20;
        std::array<VerifyProgram, 2> programs{lines(longer, lo, hi, 0, 2), lines(tool, lo, hi, 0, 2)};
        programs[0].name = "Long";
        programs[1].name = "Short";
        const Verification v = verify(part, stock, programs, asked(), Progress());
        const UncutReason* beside = reason(v, UncutReason::Why::stock);
        QVERIFY(beside && beside->counts());
        QCOMPARE(beside->program, programs[1].name);
        // A tool with long flutes has no such reason.
        const Verification w = judged(part, stock, programs[0]);
        QVERIFY(reason(w, UncutReason::Why::not_cut) && !reason(w, UncutReason::Why::stock));
        QVERIFY2(std::abs(w.uncut_share - v.uncut_share) < 0.02,
                 qPrintable(QString("%1 and %2").arg(w.uncut_share).arg(v.uncut_share)));
    }

    /// What stands in the end is in no shank's way, but what stood when the program began was: it is told,
    /// unless the tool went into it all the same.
    void what_the_stock_kept_off() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 12;
        Tool tool = flat_tool(4), longer = tool;
        tool.flute_length = 5;
        tool.shank_diameter = 4;
        tool.shank_length = 40;
        longer.flute_length = 20;
        const auto finish = [&](double z) {
            VerifyProgram p = lines(tool, Vec2(-30, -20), Vec2(30, -18), z, 2);
            p.name = "Finish";
            return p;
        };
        VerifyProgram rough = lines(longer, Vec2(-30, -20), Vec2(30, 20), 0.5, 2);
        rough.name = "Rough";
        rough.leaves = 0.6;
        const auto judge = [&](const VerifyProgram& first, const VerifyProgram& second) {
            const std::array<VerifyProgram, 2> programs{first, second};
            return verify(part, stock, programs, asked(), Progress());
        };
        const Verification before = judge(finish(8), rough);
        QVERIFY(before.collisions.empty());
        const UncutReason *beside = reason(before, UncutReason::Why::stock),
                          *free = reason(before, UncutReason::Why::not_cut);
        QVERIFY(beside && beside->counts() && beside->program == "Finish");
        // From beside the block the tool comes to its rim.
        QVERIFY2(!free || free->area < 0.05 * beside->area,
                 qPrintable(QString("%1 and %2").arg(free ? free->area : 0).arg(beside->area)));
        const Verification after = judge(rough, finish(8));
        QVERIFY(reason(after, UncutReason::Why::not_cut) && !reason(after, UncutReason::Why::stock));
        const Verification through = judge(finish(4), rough);
        QVERIFY(!through.collisions.empty());
        QVERIFY(reason(through, UncutReason::Why::not_cut) && !reason(through, UncutReason::Why::stock));
    }

    /// A shank that rubs less deep in what stands than a cutter may go into the part is no collision.
    void a_shank_may_rub_as_deep_as_the_gouge_limit() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 12;
        Tool slot = flat_tool(4), wide_above = slot;
        slot.flute_length = 20;
        wide_above.flute_length = 5;
        wide_above.shank_length = 40;
        const auto collisions = [&](double rub, double gouge_limit) {
            wide_above.shank_diameter = 4 + 2 * rub;
            const std::array<VerifyProgram, 2> programs{lines(slot, Vec2(-30, 0), Vec2(30, 0), 2, 1),
                                                        lines(wide_above, Vec2(-30, 0), Vec2(30, 0), 2, 1)};
            VerifySettings s = asked();
            s.resolution = 0.2;
            s.gouge_limit = gouge_limit;
            return verify(part, stock, programs, s, Progress()).collisions;
        };
        QVERIFY(collisions(0.0045, 0.005).empty());
        QVERIFY(!collisions(0.0045, 0.001).empty());
        const auto deep = collisions(0.02, 0.005);
        QVERIFY(!deep.empty() && deep[0].kind == Collision::Kind::shank);
        QVERIFY2(std::abs(deep[0].depth - 0.02) < 1e-4, qPrintable(QString::number(deep[0].depth)));
        // However much may be missing of the part, a hundredth of a millimetre is one.
        QVERIFY(!collisions(0.02, 0.1).empty());
    }

    /// A ball that is kept above the bottom of the stock leaves the lower end of a steep side, which it would
    /// cut from farther down; when it goes down there itself that is no reason.
    void what_the_bottom_keeps_off() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {12, 10}, {-12, 10}}, {{0, 1, 2, 3}});
        const StockSolid stock = stock_of(part.box());
        Tool ball = ball_tool(8);
        ball.flute_length = 40;
        // At height z over the bottom the side is at y = 20 - 0.4 z; the ball touches it from the outside.
        const auto along_sides = [&](double lowest) {
            VerifyProgram p{"Ball", VerifyTool(ball), nullptr, {}};
            auto motions = std::make_shared<ToolMotions>();
            const Vec2 out = Vec2(1, 0.4).normalized(); // (y, z)
            for (double z = 0; z <= 20; z += 0.5)
                for (const double side : {-1.0, 1.0}) {
                    const double y = 20 - 0.4 * z + 4 * out.x(), tip = z - 10 + 4 * out.y() - 4;
                    if (tip < lowest) continue;
                    for (const MotionKind kind : {MotionKind::rapid, MotionKind::cut})
                        motions->motions.push_back(
                            {kind,
                             {Vec3(kind == MotionKind::rapid ? -40 : 40, side * y, tip), Vec3::UnitZ()},
                             no_index,
                             no_index});
                }
            p.motions = motions;
            return p;
        };
        const Verification kept = judged(part, stock, along_sides(-10));
        const UncutReason* low = reason(kept, UncutReason::Why::below_bottom);
        QVERIFY(low && low->counts() && low->program == "Ball");
        QVERIFY(low->place.z() < -6);
        const Verification down = judged(part, stock, along_sides(-14));
        QVERIFY(!reason(down, UncutReason::Why::below_bottom));
        QVERIFY(down.uncut_share < kept.uncut_share);
    }

    /// The same with axes that lean to this side and that in turn: tips lie elsewhere, the ball goes by.
    void what_leaning_passes_too_far_apart_leave() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 4;
        Tool ball = ball_tool(6);
        ball.flute_length = 40;
        VerifyProgram leaning{"Leaning", VerifyTool(ball), nullptr, {}};
        auto motions = std::make_shared<ToolMotions>();
        const double lean = radians(50);
        double side = 1;
        for (double y = -20; y <= 20; y += 4, side = -side) {
            const Vec3 axis(0, side * std::sin(lean), std::cos(lean));
            const auto to = [&](MotionKind kind, const Vec3& middle) {
                motions->motions.push_back({kind, {middle - 3 * axis, axis}, no_index, no_index});
            };
            to(MotionKind::rapid, Vec3(-40, y, 40));
            to(MotionKind::cut, Vec3(-40, y, 3));
            to(MotionKind::cut, Vec3(40, y, 3));
            to(MotionKind::rapid, Vec3(40, y, 40));
        }
        leaning.motions = motions;
        const Verification v = judged(part, stock, leaning);
        QVERIFY(!v.gouged());
        const UncutReason* apart = reason(v, UncutReason::Why::passes_apart);
        QVERIFY(apart && apart->counts() && apart->excess_max > 0.6);
        const UncutReason* not_cut = reason(v, UncutReason::Why::not_cut);
        QVERIFY2(!not_cut || not_cut->area < 0.02 * apart->area,
                 qPrintable(QString::number(not_cut ? not_cut->area : 0)));
    }

    /// Between two passes a ball leaves a cusp that it could cut; where it never goes it leaves all.
    void what_passes_too_far_apart_leave() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 8;
        Tool ball = ball_tool(6);
        ball.flute_length = 40;
        // Cusps of .7 mm between them, and all of the other half.
        VerifyProgram half = lines(ball, Vec2(-30, -20), Vec2(30, 0), 0, 4);
        const Verification v = judged(part, stock, half);
        const UncutReason *apart = reason(v, UncutReason::Why::passes_apart),
                          *not_cut = reason(v, UncutReason::Why::not_cut);
        QVERIFY(apart && apart->counts() && apart->program == half.name && not_cut);
        // A place that is asked stands for those about it.
        QVERIFY2(
            apart->excess_max > 0.6 && apart->place.y() < 4,
            qPrintable(
                QString("%1 at %2, %3").arg(apart->excess_max).arg(apart->place.x()).arg(apart->place.y())));
        QVERIFY2(std::abs(not_cut->area - 17 * 60) < 60 && not_cut->place.y() > 2.5,
                 qPrintable(QString::number(not_cut->area)));
        // What a pass high above left was not left by one that goes by.
        const Verification high = judged(part, stock, lines(ball, Vec2(-30, -20), Vec2(30, 20), 4, 0.5));
        QVERIFY(!reason(high, UncutReason::Why::passes_apart) && reason(high, UncutReason::Why::not_cut));
        // Along a steep side that is higher than the ball is wide one goes above and one below.
        const Mesh side = prism({{-10, -20}, {10, -20}, {6, 0}, {-6, 0}}, {{0, 1, 2, 3}});
        const auto along = [&](std::vector<Vec2> tips) {
            VerifyProgram p{"Along", VerifyTool(ball), nullptr, {}};
            auto motions = std::make_shared<ToolMotions>();
            for (const Vec2& tip : tips)
                for (const MotionKind kind : {MotionKind::rapid, MotionKind::cut})
                    motions->motions.push_back(
                        {kind,
                         {Vec3(kind == MotionKind::rapid ? -40 : 40, tip.x(), tip.y()), Vec3::UnitZ()},
                         no_index,
                         no_index});
            p.motions = motions;
            return p;
        };
        const StockSolid over = stock_of(side.box());
        const Verification both = judged(side, over, along({{8.95, -2.41}, {11.35, -14.41}})),
                           one = judged(side, over, along({{8.95, -2.41}}));
        const UncutReason *between = reason(both, UncutReason::Why::passes_apart),
                          *some = reason(one, UncutReason::Why::passes_apart);
        QVERIFY(between && between->area > (some ? some->area : 0) + 60);
        // Nor is roughing that leaves as much on purpose at fault.
        half.leaves = 2 * 2 * asked().tolerance;
        QVERIFY(!reason(judged(part, stock, half), UncutReason::Why::passes_apart));
    }

    /// Beside an upright wall a ball leaves what the flat end before it could cut: the reason names that one.
    void whose_tool_would_fit() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-10, 0}, {-10, 6}, {-20, 6}},
                                {{0, 1, 2, 3}, {0, 3, 4, 5}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 7;
        Tool flat = flat_tool(6), ball = ball_tool(6);
        flat.flute_length = ball.flute_length = 20;
        std::array<VerifyProgram, 3> programs{lines(flat, Vec2(-30, -6.5), Vec2(30, 20), 0.1, 2),
                                              lines(flat, Vec2(-30, -24), Vec2(30, -10), 6, 2),
                                              lines(ball, Vec2(-30, -7), Vec2(30, 20), 0, 0.5)};
        programs[0].name = "Rough";
        programs[1].name = "Top";
        programs[2].name = "Finish";
        const Verification v = verify(part, stock, programs, asked(), Progress());
        QVERIFY(!v.gouged());
        QCOMPARE(v.uncut.size(), std::size_t(1));
        QCOMPARE(int(v.uncut.front().why), int(UncutReason::Why::not_cut));
        QCOMPARE(v.uncut.front().program, programs[1].name);
        // Half a millimetre between where the flat end went and the wall.
        QVERIFY2(std::abs(v.uncut.front().area - 0.5 * 60) < 8,
                 qPrintable(QString::number(v.uncut.front().area)));
    }

    /// Looked at too coarsely, nothing is verified; what is found all the same stands.
    void a_coarse_look_judges_nothing() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 2;
        VerifySettings coarse = asked();
        coarse.resolution = coarse.sample_spacing = 6;
        const VerifyProgram good = lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6);
        const Verification v = judged(part, stock, good, coarse);
        QCOMPARE(int(v.verdict()), int(Verdict::not_judged));
        QVERIFY(!v.passed() && v.not_judged_share == 1
                && v.not_judged.find("resolution") != std::string::npos);
        const VerifyProgram deep = lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), -1, 6);
        QCOMPARE(int(judged(part, stock, deep, coarse).verdict()), int(Verdict::failed));
    }

    /// Rays farther apart than the stock is long see nothing of it: that is refused, with what would do.
    void a_resolution_beyond_the_stock_is_refused() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        for (const double resolution : {50.0, 1e9, 1e300}) {
            VerifySettings coarse = asked();
            coarse.resolution = resolution;
            try {
                judged(part, stock_of(part.box()), lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6),
                       coarse);
                QFAIL("taken");
            } catch (const Error& e) {
                QCOMPARE(e.code(), ErrorCode::out_of_range);
                QVERIFY2(e.where() == "resolution" && e.remedy().find("2 mm") != std::string::npos, e.what());
            }
        }
    }

    /// A plate full of small holes is near open borders everywhere: that nothing counts there verifies
    /// nothing.
    void much_left_near_borders_is_not_verified() {
        Mesh part = height_field([](double, double) { return 0.0; }, Vec2(-30, -30), Vec2(30, 30), 60, 60);
        std::size_t f = 0;
        std::erase_if(part.facets, [&](const Facet&) { return f++ % 180 == 7; });
        StockSolid stock = stock_of({Vec3(-30, -30, -5), Vec3(30, 30, 2)});
        const Verification corner =
            judged(part, stock, lines(flat_tool(12), Vec2(-30, 20), Vec2(30, 30), 0, 8));
        QVERIFY(!corner.passed());
        QVERIFY(corner.not_judged.find("open borders") != std::string::npos);
        const Verification all =
            judged(part, stock, lines(flat_tool(12), Vec2(-30, -30), Vec2(30, 30), 0, 8));
        QVERIFY2(all.verdict() != Verdict::failed && all.border.uncut_fraction == 0, all.not_judged.c_str());
    }

    /// How finely has to be looked is a matter of a taper's end, not of its upper rim.
    void a_taper_is_looked_at_by_its_end() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 2;
        VerifySettings coarse = asked();
        coarse.resolution = coarse.sample_spacing = 3;
        const VerifyProgram flat = lines(flat_tool(12), Vec2(-20, -15), Vec2(20, 15), 0, 6);
        VerifyProgram taper = lines(flat_tool(12), Vec2(0.7, 0.7), Vec2(0.7, 0.7), 0, 6);
        taper.tool = VerifyTool(AptCutter::tapered_ball(0.5, radians(10), 60));
        const std::array<VerifyProgram, 2> both{flat, taper};
        QCOMPARE(int(verify(part, stock, {&flat, 1}, coarse, Progress()).verdict()), int(Verdict::verified));
        QCOMPARE(int(verify(part, stock, both, coarse, Progress()).verdict()), int(Verdict::not_judged));
    }

    /// Nothing lies deeper in a cutter than its radius: such a limit forbids nothing.
    void a_limit_that_nothing_exceeds_judges_nothing() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        VerifySettings lax = asked();
        lax.gouge_limit = 4;
        const Verification v =
            judged(part, stock_of(part.box()), lines(flat_tool(8), Vec2(-20, 0), Vec2(20, 0), -10, 1), lax);
        QCOMPARE(int(v.verdict()), int(Verdict::not_judged));
        QVERIFY(v.figures.gouge_max > 3.9);
    }

    /// A flush stock ends where the part does, not where the part with its allowance would.
    void an_allowance_on_a_flush_stock() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        VerifySettings s = asked();
        s.allowance = 0.3;
        const Verification v =
            judged(part, stock_of(part.box()), lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0.3, 6), s);
        QCOMPARE(int(v.verdict()), int(Verdict::verified));
        QVERIFY(!reason(v, UncutReason::Why::outside_stock));
    }

    /// A post beside a tool that turns about its tip: the great circle passes it by, the joints of the
    /// machine bring the tool into it. What does it is named.
    void a_gouge_that_only_the_joints_make() {
        const auto machine = std::make_shared<const Machine>(find_machine("trunnion-ac"));
        const double lean = radians(45), place = radians(50), half = std::sqrt(0.5);
        const Vec3 top = 20 * Vec3(std::sin(place) * half, std::sin(place) * half, std::cos(place));
        const Mesh part = box(top - Vec3(0.5, 0.5, 5), top + Vec3(0.5, 0.5, 0));
        auto motions = std::make_shared<ToolMotions>();
        for (const Vec3& axis :
             {Vec3(std::sin(lean), 0, std::cos(lean)), Vec3(0, std::sin(lean), std::cos(lean))})
            motions->motions.push_back({MotionKind::cut, {Vec3::Zero(), axis}, no_index, no_index});
        VerifyProgram program{"Turn", VerifyTool(AptCutter::flat(4, 40)), motions, std::nullopt};
        StockSolid stock = stock_of(part.box());
        stock.box.lo.array() -= 3;
        QVERIFY(!judged(part, stock, program).gouged());
        program.machine = machine;
        const Verification v = judged(part, stock, program);
        QCOMPARE(int(v.verdict()), int(Verdict::failed));
        QVERIFY(v.gouged() && v.gouges.front().by.course == AxisCourse::joint_linear);
    }

    /// A degree over the end of the table's travel: a program that turns over there goes through a post, the
    /// course that a machine would take does not. What the program says counts.
    void joints_that_a_program_tells() {
        const auto machine = std::make_shared<const Machine>(find_machine("trunnion-ac"));
        const Vec3 top(0, 0, 20);
        const Mesh part = box(top - Vec3(0.5, 0.5, 5), top + Vec3(0.5, 0.5, 0));
        auto motions = std::make_shared<ToolMotions>();
        VerifyProgram program{"Lean", VerifyTool(AptCutter::flat(4, 40)), motions, std::nullopt};
        program.machine = machine;
        const Kinematics kinematics(*machine, 0, Vec3::Zero());
        auto told = std::make_shared<std::vector<Joints>>();
        for (const double lean : {0.5, 0.52, 0.55}) {
            const Vec3 axis(0, -std::sin(lean), std::cos(lean));
            motions->motions.push_back({MotionKind::cut, {Vec3::Zero(), axis}, no_index, no_index});
            const auto held = kinematics.inverse({Vec3::Zero(), axis}, {});
            for (int k = 0; k < held.count; ++k)
                if ((held.at[std::size_t(k)].rotary[0] > 0) == (lean < 0.53))
                    told->push_back(held.at[std::size_t(k)]);
        }
        QCOMPARE(told->size(), std::size_t(3));
        StockSolid stock = stock_of(part.box());
        stock.box.lo.array() -= 3;
        QVERIFY(!judged(part, stock, program).gouged());
        program.joints = told;
        QVERIFY(judged(part, stock, program).gouged());
    }

    /// A program that begins on the surface does not begin inside.
    void a_start_on_the_surface() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        VerifyProgram program = lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6);
        auto motions = std::make_shared<ToolMotions>(*program.motions);
        motions->motions.front().to.tip = Vec3(3.3, 4.4, 0);
        program.motions = motions;
        StockSolid stock = stock_of(part.box());
        const Verification v = judged(part, stock, program);
        QCOMPARE(int(v.verdict()), int(Verdict::verified));
    }

    /// Motions that begin within the part and stay there meet none of its surface.
    void a_start_inside() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 10));
        auto motions = std::make_shared<ToolMotions>();
        for (double x : {-3.0, 3.0})
            motions->motions.push_back({MotionKind::cut, {Vec3(x, 0, 0), Vec3::UnitZ()}, no_index, no_index});
        const VerifyProgram program{"Inside", VerifyTool(AptCutter::flat(2, 3)), motions, std::nullopt};
        const Verification v = judged(part, stock_of(part.box()), program);
        QCOMPARE(int(v.verdict()), int(Verdict::failed));
        QVERIFY(v.gouged() && v.gouges.front().by.program == 0 && v.figures.gouge_max > 9);
    }
};

FACETMILL_TEST(TestVerdict)
#include "test_verdict.moc"
