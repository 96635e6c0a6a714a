// What the judge says of the whole: verified, failed or not to be judged, on jobs whose answer is known, also
// where the mesh is dirty.
#include "core/setup/kinematics.h"
#include "core/setup/machine.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/verify/verdict_cases.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

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

    /// A wall along the tool axis has no pass of its own. What stands on it is told, as is that nothing of
    /// that counts; beneath a roof it is no wall that a tool passes.
    void what_stands_on_upright_walls_is_told() {
        Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 2;
        stock.box.lo.x() -= 3;
        const Verification v = judged(part, stock, lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6));
        QCOMPARE(int(v.verdict()), int(Verdict::verified));
        QCOMPARE(v.uncut_share, 0.0);
        const UncutReason* wall = reason(v, UncutReason::Why::upright);
        QVERIFY(wall && !wall->counts());
        QVERIFY2(std::abs(wall->area - 300) < 30, qPrintable(QString::number(wall->area)));
        QVERIFY(std::abs(wall->excess_max - 3) < 1e-6 && wall->place.x() < -19.99);
        const auto told = [](const Verification& of, const std::string& area, const std::string& height) {
            return std::any_of(of.remarks.begin(), of.remarks.end(), [&](const std::string& remark) {
                return remark.find("Upright walls") == 0
                       && remark.find(area + " of them") != std::string::npos
                       && remark.find("up to " + height + ",") != std::string::npos;
            });
        };
        QVERIFY(told(v, format_number(wall->area, 3) + " mm²", "3 mm"));
        VerifySettings inches = asked();
        inches.unit = LengthUnit::inch;
        const Verification the_same =
            judged(part, stock, lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6), inches);
        QVERIFY(told(the_same, format_number(wall->area / (25.4 * 25.4), 3) + " in²", "0.118 in"));
        const Mesh roof = box(Vec3(-26, -15, 6), Vec3(26, 15, 8));
        const auto first = Index(part.vertices.size());
        part.vertices.insert(part.vertices.end(), roof.vertices.begin(), roof.vertices.end());
        for (const Facet& f : roof.facets)
            part.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
        stock.box.hi.z() = 8;
        const Verification under =
            judged(part, stock, lines(flat_tool(8), Vec2(-26, -15), Vec2(26, 15), 8, 6));
        QVERIFY(!reason(under, UncutReason::Why::upright));
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
                && v.not_judged.find("a resolution and a spacing of at most 2 mm") != std::string::npos);
        coarse.unit = LengthUnit::inch;
        QVERIFY(judged(part, stock, good, coarse).not_judged.find("of at most 0.0787 in")
                != std::string::npos);
        const VerifyProgram deep = lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), -1, 6);
        QCOMPARE(int(judged(part, stock, deep, coarse).verdict()), int(Verdict::failed));
    }

    /// Whoever waits for a verdict is told before the stock is cut that there can be none.
    void what_cannot_be_verified_is_told_first() {
        const Mesh part = box(Vec3(-20, -15, -10), Vec3(20, 15, 0));
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 2;
        const VerifyProgram program = lines(flat_tool(8), Vec2(-20, -15), Vec2(20, 15), 0, 6);
        const auto told_of = [&](VerifySettings s) {
            std::vector<std::string> told;
            s.cannot_verify = [&](const std::string& why) { told.push_back(why); };
            const Verification v = judged(part, stock, program, s);
            return std::pair(told, v.not_judged);
        };
        QVERIFY(told_of(asked()).first.empty());
        VerifySettings coarse = asked(), few = asked(), lax = asked();
        coarse.resolution = 6;
        few.max_samples = 4;
        lax.gouge_limit = 4;
        for (const VerifySettings& s : {coarse, few, lax}) {
            const auto [told, why] = told_of(s);
            QVERIFY2(told.size() == 1 && told.front() == why && !why.empty(), why.c_str());
        }
        // What it throws ends it before anything is cut.
        struct Enough {};
        bool cut = false;
        coarse.cannot_verify = [](const std::string&) { throw Enough(); };
        try {
            judged(part, stock, program, coarse);
            cut = true;
        } catch (const Enough&) {
        }
        QVERIFY(!cut);
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
