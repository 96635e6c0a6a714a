// What clean-up is made of: rays against every facet, distances from cutters, what stays between two passes,
// what a cutter leaves in a crease.
#include "core/mesh/mesh_io.h"
#include "core/mesh/outward.h"
#include "core/strategy/cleanup/border_touch.h"
#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/cleanup/cut_tree.h"
#include "core/strategy/cleanup/rest_band.h"
#include "core/strategy/cleanup/ridge.h"
#include "core/strategy/cleanup/standing.h"
#include "core/strategy/cleanup/strip_passes.h"
#include "core/strategy/cleanup/touch_up.h"
#include "core/strategy/cleanup/working_passes.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/surface/point_grid.h"
#include "tests/support/error_code.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/unit/strategy/cleanup/cutter_over.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A level crease of 90 degrees, what a ball of 10 leaves in it, and a ball of 4 to clean it up.
struct Crease {
    static constexpr double tolerance = 0.05;
    const Mesh part =
        height_field([](double, double y) { return std::abs(y); }, Vec2(-20, -15), Vec2(20, 15), 40, 30);
    const CutterOver before{part, ball_tool(10)}, ball{part, ball_tool(4)};
    const ValleyInput in = before.valleys(tolerance);
    const Valleys valleys = find_valleys(in, Progress());
    const std::vector<RestBand> bands = rest_bands(in, valleys, Progress());
};

} // namespace

class TestCleanupParts : public QObject {
    Q_OBJECT
private slots:
    /// Curves that came to a ring of steps went round it until they had 200 000 points.
    void curves_end_where_they_come_back() {
        MeshPtr scan =
            load_mesh(data_path("data/valleys/ring-of-steps.stl"), LengthUnit::mm, Progress()).mesh;
        scan = wound_outward(scan, outward_sides(*scan, Progress()));
        const CutterOver before(*scan, ball_tool(6));
        ValleyInput in = before.valleys(0.05);
        in.ripple = 0.5;
        std::size_t points = 0;
        for (const ValleyCurve& curve : find_valleys(in, Progress()).curves)
            points += curve.points.size();
        qInfo("%zu points", points);
        QVERIFY(points > 10 && points < 1000);
    }

    void rays_meet_what_all_facets_say() {
        const auto mesh = soup(400, 30, 5);
        const FacetGrid grid(*mesh, Progress());
        Random rng(3);
        int hits = 0;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 from(uniform(rng, -5, 35), uniform(rng, -5, 35), uniform(rng, -5, 15));
            Vec3 route(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
            if (i % 3 == 0) route = Vec3(0, 0, i % 2 ? 1 : -1);
            if (i % 7 == 0) route.y() = 0;
            if (route.norm() < 1e-3) continue;
            route.normalize();
            double least = 25;
            for (std::size_t f = 0; f < mesh->facet_count(); ++f) {
                const Vec3 cross = mesh->facet_cross(f);
                const double slope = cross.dot(route);
                if (std::abs(slope) < 1e-9) continue;
                const double t = cross.dot(mesh->corner(f, 0) - from) / slope;
                if (t < 0 || t >= least) continue;
                const Vec3 p = from + t * route;
                bool inside = true;
                for (int k = 0; k < 3; ++k)
                    inside = inside
                             && (mesh->corner(f, (k + 1) % 3) - mesh->corner(f, k))
                                        .cross(p - mesh->corner(f, k))
                                        .dot(cross)
                                    >= 0;
                if (inside) least = t;
            }
            const auto hit = grid.first_hit(from, route, 25);
            QCOMPARE(hit.has_value(), least < 25);
            if (!hit) continue;
            ++hits;
            QVERIFY(std::abs(hit->distance - least) < 1e-7);
        }
        QVERIFY(hits > 300);
    }

    void distances_are_those_to_the_nearest_point_of_the_cutter() {
        Random rng(4);
        for (const ShapedTool& t : tools_of_every_shape()) {
            const CutterProfile profile(t.tool.cutter());
            const CutterCover cover(profile, 0.001);
            for (int i = 0; i < 60; ++i) {
                const Vec3 p(uniform(rng, -8, 8), uniform(rng, -8, 8), uniform(rng, -4, 9));
                const double rho = std::hypot(p.x(), p.y());
                double least = infinity;
                for (double r = 0; r <= profile.max_radius(); r += 0.002) {
                    // On the surface, and straight above it.
                    const double z = profile.height_at(std::min(r, profile.max_radius()));
                    least = std::min(least, std::hypot(rho - r, p.z() - std::max(z, p.z())));
                    least = std::min(least, std::hypot(rho - r, p.z() - z));
                }
                const double found = cover.distance(p);
                QVERIFY2(found <= least + 1e-9 && found >= least - 0.01,
                         qPrintable(QString("%1 %2 %3").arg(t.name).arg(found).arg(least)));
            }
        }
    }

    /// Against the lower of two outlines of points of the cutter, level and on a slope.
    /// Against all motions, one after the other, in small steps.
    void the_nearest_of_many_motions_is_found() {
        Random rng(11);
        for (const ShapedTool& t : tools_of_every_shape()) {
            const CutterCover cover(CutterProfile(t.tool.cutter()), 0.001);
            std::vector<CutTree::Motion> motions;
            for (int i = 0; i < 200; ++i) {
                const Vec3 a(uniform(rng, 0, 60), uniform(rng, 0, 60), uniform(rng, 0, 20));
                const Vec3 d(uniform(rng, -6, 6), uniform(rng, -6, 6), uniform(rng, -6, 6));
                motions.push_back({a, i % 4 == 0 ? a : Vec3(a + d)});
            }
            const double accuracy = 0.001;
            const CutTree tree(cover, motions, accuracy, Progress());
            int far = 0;
            std::uint32_t hint = CutTree::no_motion; // of the place before
            for (int i = 0; i < 200; ++i) {
                const Vec3 p(uniform(rng, -5, 65), uniform(rng, -5, 65), uniform(rng, -10, 20));
                double least = infinity;
                std::size_t near = 0;
                for (const auto& [a, b] : motions) {
                    double by_this = infinity;
                    for (int k = 0; k <= 200; ++k)
                        by_this = std::min(by_this, cover.distance(p - a - k / 200.0 * (b - a)));
                    least = std::min(least, by_this);
                    near += by_this < 2.5;
                }
                double by_any = infinity;
                for (std::size_t m = 0; m < motions.size(); ++m)
                    by_any = std::min(by_any, tree.distance(p, m));
                QCOMPARE(tree.nearest(p, 0), by_any);
                // A place of the motion is within half a step of one that was asked.
                QVERIFY(std::abs(tree.nearest(p, 0) - least) <= 0.03);
                QVERIFY(tree.nearest(p, 1) <= std::max(1.0, least + accuracy));
                QCOMPARE(tree.nearest(p, 0, infinity, hint), tree.nearest(p, 0));
                QCOMPARE(tree.distance(p, hint), tree.nearest(p, 0));
                far += least > 2.6;
                if (least > 2.6) QCOMPARE(tree.nearest(p, 0, 2.5), infinity);
                std::size_t used = 0;
                bool own = true;
                tree.nearer(p, 2.53, [&](std::size_t m, double d) {
                    own = own && d == tree.distance(p, m);
                    ++used;
                    return 2.53;
                });
                QVERIFY(own && used >= near);
            }
            QVERIFY(far > 20);
        }
        QCOMPARE(CutTree(CutterCover(CutterProfile(ball_tool(6).cutter()), 0.001), {}, 0.001, Progress())
                     .nearest(Vec3::Zero(), 0),
                 infinity);
    }

    void ridges_are_those_of_the_cutters_outline() {
        for (const ShapedTool& t : tools_of_every_shape()) {
            const CutterProfile profile(t.tool.cutter());
            for (const double slope : {0.0, 0.6})
                for (const double width : {0.2, 0.7, 1.5}) {
                    const Vec3 travel(0, 1, 0), across(std::cos(slope), 0, std::sin(slope)),
                        up(-std::sin(slope), 0, std::cos(slope));
                    // Heights above the plane that both touch, over places across the travel.
                    std::vector<double> low(4001, infinity);
                    const auto cell = [](double x) { return int(std::lround(x * 200)) + 2000; };
                    double touch = infinity;
                    for (double r = 0; r <= profile.max_radius(); r += 0.0025)
                        for (int k = -400; k <= 400; ++k) {
                            const double x = r * k / 400;
                            const Vec3 p(x, 0, profile.height_at(r));
                            const int c = cell(p.dot(across));
                            if (c >= 0 && c <= 4000)
                                low[std::size_t(c)] = std::min(low[std::size_t(c)], p.dot(up));
                            touch = std::min(touch, p.dot(up));
                        }
                    // The shaft above the largest radius.
                    for (double z = 0; z < 4; z += 0.0025)
                        for (const double x : {-profile.max_radius(), profile.max_radius()}) {
                            const Vec3 p(x, 0, profile.height_at(profile.max_radius()) + z);
                            const int c = cell(p.dot(across));
                            if (c >= 0 && c <= 4000)
                                low[std::size_t(c)] = std::min(low[std::size_t(c)], p.dot(up));
                        }
                    double expected = 0;
                    const int shift = int(std::lround(width * 200));
                    // Between the places where each of them touches.
                    int first = -1, last = -1;
                    for (int c = 0; c <= 4000; ++c)
                        if (low[std::size_t(c)] < touch + 1e-4) {
                            if (first < 0) first = c;
                            last = c;
                        }
                    for (int c = last; c <= first + shift; ++c)
                        expected =
                            std::max(expected, std::min(low[std::size_t(c)],
                                                        c >= shift ? low[std::size_t(c - shift)] : infinity)
                                                   - touch);
                    const double found = ridge(profile, width * across, travel);
                    QVERIFY2(std::abs(found - expected) < 0.02 + 0.05 * expected,
                             qPrintable(QString("%1 slope %2 width %3: %4, expected %5")
                                            .arg(t.name)
                                            .arg(slope)
                                            .arg(width)
                                            .arg(found)
                                            .arg(expected)));
                }
        }
    }

    /// Only on the border, and only with a normal that the surface has not there.
    void a_cutter_rolls_over_the_border_of_a_sheet_alone() {
        const Mesh sheet =
            height_field([](double, double) { return 0.0; }, Vec2(-10, -10), Vec2(10, 10), 10, 10);
        const Mesh solid = box(Vec3(-10, -10, -5), Vec3(10, 10, 0));
        const FacetGrid grid(sheet, Progress()), solid_grid(solid, Progress());
        const UpSide side(sheet, Progress()), solid_side(solid, Progress());
        const Vec3 up = Vec3::UnitZ(), out = Vec3(std::sin(0.3), 0, std::cos(0.3));
        for (const Vec3& touch : {Vec3(10, 1, 0), Vec3(10, 2, 0), Vec3(10, 10, 0)}) {
            QVERIFY(rolls_over_border(sheet, grid, side, touch, out));
            QVERIFY(!rolls_over_border(sheet, grid, side, touch, up));
            QVERIFY(!rolls_over_border(solid, solid_grid, solid_side, touch, out));
        }
        // On an edge, at a vertex and within a facet.
        for (const Vec3& touch : {Vec3(4, 1, 0), Vec3(4, 2, 0), Vec3(4.7, 2.1, 0)})
            QVERIFY(!rolls_over_border(sheet, grid, side, touch, out));
    }

    /// A crease of 90 degrees, its valley level: a ball of radius R touches R away from it along both flanks,
    /// and leaves R (sqrt 2 - 1) in it.
    void a_crease_has_the_band_that_geometry_says() {
        const Crease crease;
        const auto& valleys = crease.valleys;
        const auto& bands = crease.bands;
        QCOMPARE(valleys.curves.size(), std::size_t(1));
        for (const PencilPoint& p : valleys.curves[0].points) {
            if (std::abs(p.center.x()) > 14) continue; // the ends
            QVERIFY(std::hypot(p.center.y(), p.center.z()) < 1e-4);
            QVERIFY(std::abs(p.gap - 5 * (std::sqrt(2.0) - 1)) < 1e-4);
            QVERIFY((p.up - Vec3::UnitZ()).norm() < 1e-4);
        }
        QCOMPARE(bands.size(), std::size_t(1));
        QCOMPARE(bands[0].boundaries.size(), std::size_t(1));
        // The distance is the tolerance at s from the point that is touched: sqrt(R^2 + s^2) = R + tolerance.
        const double half = 5 - std::sqrt(5.05 * 5.05 - 25.0);
        QVERIFY2(std::abs(bands[0].width - 2 * half) < 0.1, qPrintable(QString::number(bands[0].width)));
        QVERIFY(std::abs(bands[0].area / bands[0].length / (2 * half) - 1) < 0.05);
    }

    /// Whole passes over a crease are taken away: as little is left as with them.
    void what_passes_leave_is_touched_up() {
        const double tolerance = Crease::tolerance;
        const Crease crease;
        const auto& valleys = crease.valleys;
        const auto& bands = crease.bands;
        const CutterOver& ball = crease.ball;
        QCOMPARE(bands.size(), std::size_t(1));
        StripCutting with = ball.cutting();
        with.cusp = tolerance;
        // The most that is left of the band beyond what the ball must leave in the crease: R (1 / cos 45 - 1)
        // there, and from the place at which it touches on nothing.
        const double r = 2;
        const auto max_left = [&](const std::vector<Pass>& passes) {
            PointGrid tips(r);
            for (const Pass& pass : passes)
                for (std::size_t i = 1; i < pass.cl.size(); ++i)
                    for (int k = 0; k <= 4; ++k)
                        tips.add(pass.cl[i - 1].tip + k / 4.0 * (pass.cl[i].tip - pass.cl[i - 1].tip));
            double most = 0;
            for (const auto& t : bands[0].band) {
                const Vec3 p = (t[0] + t[1] + t[2]) / 3;
                if (std::abs(p.x()) > 4) continue;
                double left = infinity;
                tips.near(p, 1.5 * r, [&](std::size_t i) {
                    left = std::min(left, ball.cover.distance(p - tips.points()[i]));
                });
                const double up = std::sqrt(2.0) * std::abs(p.y());
                most = std::max(most, left - (up < r ? std::hypot(r, r - up) - r : 0));
            }
            return most;
        };
        const StripCut whole = cut_valley(with, valleys.curves[0], bands[0], Progress());
        QVERIFY(whole.passes.size() > 5);
        QVERIFY(max_left(whole.passes) <= 1.05 * tolerance);
        // Samples half and twice as far apart as usual see the same, though other places become points of
        // passes, between which moves are held off the part by another little.
        for (const auto& [first, factor] :
             {std::pair(0, 1.0), {1, 1.0}, {2, 1.0}, {0, 0.5}, {1, 2.0}, {2, 2.0}}) {
            StripCut cut;
            for (std::size_t i = 0; i < whole.passes.size(); ++i)
                if (int(i % 3) != first) cut.passes.push_back(whole.passes[i]);
            QVERIFY2(max_left(cut.passes) > 1.5 * tolerance, qPrintable(QString::number(first)));
            const BandCut band{&bands[0], &cut};
            TouchUpSampling sampling;
            sampling.sample_share *= factor;
            sampling.stand_share *= factor;
            touch_up(with, {&band, 1}, Progress(), sampling);
            const double left = max_left(cut.passes);
            QVERIFY2(
                left <= tolerance + (factor == 1 ? 1 : 2) * with.chord,
                qPrintable(QString("without %1, sampling times %2: %3").arg(first).arg(factor).arg(left)));
            for (const Pass& pass : cut.passes)
                for (const CutterLocation& c : pass.cl)
                    QVERIFY(c.tip.z() >= ball.lift.tip_z(c.tip.x(), c.tip.y()) - 1e-9);
        }
    }

    /// Passes beside the band, over what is finished, are left out, and of those along it what runs on over
    /// the part beyond it.
    void passes_that_take_nothing_away_are_left_out() {
        const Crease crease;
        const auto& valleys = crease.valleys;
        const auto& bands = crease.bands;
        const CutterOver& ball = crease.ball;
        QCOMPARE(bands.size(), std::size_t(1));
        QCOMPARE(bands[0].left.size(), bands[0].band.size());
        StripCutting with = ball.cutting();
        with.max_points = 100;
        QCOMPARE(code_of([&] { cut_valley(with, valleys.curves[0], bands[0], Progress()); }),
                 std::string("limit_exceeded"));
        with = ball.cutting();
        const StripCut cut = cut_valley(with, valleys.curves[0], bands[0], Progress());
        StripCut more = cut;
        for (Pass pass : cut.passes) {
            for (CutterLocation& c : pass.cl)
                c.tip += Vec3(0, 9, 9);
            more.passes.push_back(pass);
        }
        const auto kept = [&](const RestBand& band) {
            StripCut some = more;
            const BandCut only{&band, &some};
            keep_working(with, {&only, 1}, Progress());
            return some.passes;
        };
        const auto whole = kept(bands[0]);
        QVERIFY(!whole.empty() && whole.size() <= cut.passes.size());
        for (const Pass& pass : whole) {
            QVERIFY(pass.cl.size() > 1 && pass.cl.size() == pass.cc.size());
            for (const CutterLocation& c : pass.cl)
                QVERIFY2(std::abs(c.tip.y()) < 5, qPrintable(QString::number(c.tip.y())));
        }
        // Of a band whose other half is finished, passes over that half are shorter.
        RestBand half = bands[0];
        half.band.clear();
        half.left.clear();
        half.beside.clear();
        for (std::size_t i = 0; i < bands[0].band.size(); ++i)
            if (bands[0].band[i][0].x() > 0) {
                half.band.push_back(bands[0].band[i]);
                half.left.push_back(bands[0].left[i]);
            }
        for (const Pass& pass : kept(half))
            for (const CutterLocation& c : pass.cl)
                QVERIFY2(c.tip.x() > -3, qPrintable(QString::number(c.tip.x())));
    }

    /// Passes that run over each other, as beside a crooked valley, and lines across them: about as much is
    /// kept as of one set, and it cuts the whole band.
    void of_passes_over_each_other_one_set_is_kept() {
        const Crease crease;
        const auto& valleys = crease.valleys;
        const auto& bands = crease.bands;
        const CutterOver& ball = crease.ball;
        QCOMPARE(bands.size(), std::size_t(1));
        const StripCutting with = ball.cutting();
        const StripCut one = cut_valley(with, valleys.curves[0], bands[0], Progress());
        const auto kept = [&](const StripCut& cut) {
            StripCut some = cut;
            const BandCut only{&bands[0], &some};
            keep_working(with, {&only, 1}, Progress());
            return some.passes;
        };
        const auto length = [](const std::vector<Pass>& passes) {
            double sum = 0;
            for (const Pass& pass : passes)
                for (std::size_t i = 1; i < pass.cl.size(); ++i)
                    sum += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
            return sum;
        };
        StripCut many = one;
        for (int k = 1; k <= 9; ++k)
            for (Pass pass : one.passes) {
                // Hardly less deep, and one in three the other way.
                for (CutterLocation& c : pass.cl)
                    c.tip.z() += 0.005 * with.cusp * k;
                if (k % 3 == 0) {
                    std::reverse(pass.cl.begin(), pass.cl.end());
                    std::reverse(pass.cc.begin(), pass.cc.end());
                }
                many.passes.push_back(pass);
            }
        const double alone = length(kept(one));
        QVERIFY(length(many.passes) > 9 * alone);
        const double of_many = length(kept(many));
        QVERIFY2(of_many < 1.1 * alone, qPrintable(QString("%1 of %2").arg(of_many).arg(alone)));
        for (double x = -19; x < 19; x += 0.2) {
            Pass across = one.passes.front();
            across.cl.clear();
            across.cc.clear();
            for (double y = -6; y <= 6; y += 0.2) {
                const double z = ball.lift.tip_z(x, y);
                across.cl.push_back({Vec3(x, y, z), Vec3::UnitZ()});
                across.cc.push_back({Vec3(x, y, z), Vec3::UnitZ()});
            }
            many.passes.push_back(across);
        }
        // A place that one of the lines cuts best of all is left to them.
        const auto chosen = kept(many);
        QVERIFY2(length(chosen) < 0.3 * length(many.passes), qPrintable(QString::number(length(chosen))));
        // Every place in the middle of the band that the first set cuts is cut.
        const auto left = [&](const std::vector<Pass>& passes, const Vec3& p) {
            double least = infinity;
            for (const Pass& pass : passes)
                for (std::size_t i = 1; i < pass.cl.size(); ++i)
                    for (int k = 0; k <= 4; ++k)
                        least = std::min(
                            least, ball.cover.distance(p - pass.cl[i - 1].tip
                                                       - k / 4.0 * (pass.cl[i].tip - pass.cl[i - 1].tip)));
            return least;
        };
        int asked = 0;
        for (const auto& t : bands[0].band) {
            const Vec3 p = (t[0] + t[1] + t[2]) / 3;
            if (std::abs(p.x()) > 4 || ++asked % 7 != 0) continue;
            QVERIFY(left(chosen, p) <= std::max(left(one.passes, p), with.cusp) + 0.3 * with.cusp);
        }
        QVERIFY(asked > 100);
    }

    /// What was cut once is not cut again, what was cut in part is cut to the end, and what lies outside the
    /// raw material is not cut at all.
    void what_operations_before_have_cut_is_left_out() {
        const Mesh part =
            height_field([](double, double y) { return std::abs(y); }, Vec2(-20, -15), Vec2(20, 15), 40, 30);
        PlanContext context = context_of(part, ball_tool(4));
        context.further_tools = {ball_tool(10)};
        context.stock_box.hi.z() += 1;
        CleanupSettings settings;
        settings.tool = 2;
        const StrategyResult all = Cleanup(settings).plan(context, Progress());
        const auto cuts = [&](double from) {
            auto earlier = std::make_shared<EarlierCuts>();
            earlier->cutter = context.tool.cutter();
            for (const Pass& pass : all.passes)
                for (std::size_t i = 1; i < pass.cl.size(); ++i)
                    if (pass.cl[i].tip.x() >= from)
                        earlier->motions.push_back({pass.cl[i - 1].tip, pass.cl[i].tip});
            return earlier;
        };
        context.earlier = {cuts(0)};
        const StrategyResult rest = Cleanup(settings).plan(context, Progress());
        double length = 0;
        for (const Pass& pass : rest.passes)
            for (std::size_t i = 1; i < pass.cl.size(); ++i) {
                length += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
                QVERIFY2(pass.cl[i].tip.x() < 4, qPrintable(QString::number(pass.cl[i].tip.x())));
            }
        QVERIFY2(length > 15, qPrintable(QString::number(length)));
        PlanContext small = context;
        small.earlier.clear();
        small.stock_box.hi.x() = -10;
        for (const Pass& pass : Cleanup(settings).plan(small, Progress()).passes)
            for (const CutterLocation& c : pass.cl)
                QVERIFY2(c.tip.x() < -4, qPrintable(QString::number(c.tip.x())));
        context.earlier = {cuts(-infinity)};
        QCOMPARE(code_of([&] { Cleanup(settings).plan(context, Progress()); }), std::string("empty_result"));
    }

    /// Passes near to each other are joined along the surface: an arc up stands where the tool is lifted
    /// alone.
    void leads_stand_where_the_tool_is_lifted() {
        const Mesh part =
            height_field([](double, double y) { return std::abs(y); }, Vec2(-20, -15), Vec2(20, 15), 40, 30);
        PlanContext context = context_of(part, ball_tool(4));
        context.further_tools = {ball_tool(10)};
        CleanupSettings settings;
        settings.tool = 2;
        const StrategyResult all = Cleanup(settings).plan(context, Progress());
        const AxialLift lift(context.contact, CutterProfile(context.tool.cutter()));
        const auto over = [&](const CutterLocation& c) {
            return c.tip.z() - lift.tip_z(c.tip.x(), c.tip.y());
        };
        const double linked = surface_link_distance(all.stepover_max, 4);
        int joined = 0;
        for (std::size_t i = 1; i < all.passes.size(); ++i) {
            const CutterLocation &end = all.passes[i - 1].cl.back(), &start = all.passes[i].cl.front();
            const bool near = (start.tip - end.tip).head<2>().norm() <= linked;
            joined += near;
            for (const CutterLocation& c : {end, start})
                QVERIFY2(near ? over(c) < 0.3 : over(c) > 0.5, qPrintable(QString::number(over(c))));
        }
        QVERIFY(joined > 3);
        QVERIFY(over(all.passes.front().cl.front()) > 0.5 && over(all.passes.back().cl.back()) > 0.5);
    }

    /// A ball of radius 2 that went along X at a height of 0.3; raw material up to 3, and to 10 to the sides.
    void what_stands_is_what_was_not_come_near_to() {
        PlanContext context;
        context.stock.box.add(Vec3(-10, -10, -1));
        context.stock.box.add(Vec3(10, 10, 3));
        const auto earlier = std::make_shared<EarlierCuts>();
        earlier->cutter = AptCutter::ball(4, 20);
        earlier->motions.push_back({Vec3(-5, 0, 0.3), Vec3(5, 0, 0.3)});
        const double enough = 0.05;
        const Vec3 up = Vec3::UnitZ();
        const AptCutter other = AptCutter::ball(6, 20);
        const Standing all(context, other, enough, 0, Progress());
        QCOMPARE(all.raw_over(Vec3::Zero(), up), 3.0);
        QVERIFY(std::abs(all.raw_over(Vec3(0, 9, 0), Vec3::UnitY()) - 1) < 1e-9);
        QCOMPARE(all.raw_over(Vec3(0, 11, 0), up), 0.0);
        QCOMPARE(all.uncut(Vec3::Zero(), 3), 3.0);
        context.earlier = {earlier};
        const Standing standing(context, other, enough, 0, Progress());
        QVERIFY(std::abs(standing.uncut(Vec3::Zero(), 3) - 0.3) < 0.02 * enough);
        QVERIFY(std::abs(standing.uncut(Vec3(0, 2, 0), 3) - (std::hypot(2, 2.3) - 2)) < 0.02 * enough);
        QVERIFY(standing.uncut(Vec3(0, 0, 1), 2) <= enough);
        QCOMPARE(standing.uncut(Vec3(0, 8, 0), 3), 3.0);
        QVERIFY(standing.stands(Vec3::Zero(), 3, 0.28) && !standing.stands(Vec3::Zero(), 3, 0.32));
        QVERIFY(!standing.stands(Vec3::Zero(), 0.2, 0.25) && standing.stands(Vec3(0, 8, 0), 3, 2));
        // What an allowance says is not asked of the motions.
        auto held_off = std::make_shared<EarlierCuts>(*earlier);
        held_off->no_nearer = 0.5;
        context.earlier = {held_off};
        QVERIFY(Standing(context, other, enough, 0, Progress()).stands(Vec3::Zero(), 3, 0.45));
        QVERIFY(!Standing(context, other, enough, 0.1, Progress()).stands(Vec3::Zero(), 3, 0.45));
        // Of a cutter that is asked about itself nothing more is asked.
        QCOMPARE(Standing(context, earlier->cutter, enough, 0, Progress()).uncut(Vec3::Zero(), 3), 3.0);
    }

    /// As Lu has it: a fillet of radius 4 turns by 1/4 per mm. A previous ball of radius 3 fits into it.
    void the_limit_of_normal_change_finds_fillets_that_the_previous_tool_fits() {
        const auto fillet = [](double, double y) {
            const double r = 4, d = std::abs(y), end = r * std::sin(radians(50));
            return d < end ? r - std::sqrt(r * r - d * d)
                           : r - r * std::cos(radians(50)) + (d - end) * std::tan(radians(50));
        };
        const Mesh part = height_field(fillet, Vec2(-20, -12), Vec2(20, 12), 40, 240);
        PlanContext context = context_of(part, ball_tool(4));
        context.further_tools = {ball_tool(6)};
        CleanupSettings s;
        s.tool = 2;
        bool refused = false;
        try {
            Cleanup(s).plan(context, Progress());
        } catch (const Error& e) {
            refused = e.code() == ErrorCode::empty_result;
        }
        QVERIFY(refused);
        s.normal_change_limit = {0.2, {}};
        const StrategyResult path = Cleanup(s).plan(context, Progress());
        QCOMPARE(path.strips.size(), std::size_t(1));
        QVERIFY(path.strips[0].kind == StripKind::sharp);
        s.normal_change_limit = {0.3, {}};
        refused = false;
        try {
            Cleanup(s).plan(context, Progress());
        } catch (const Error& e) {
            refused = e.code() == ErrorCode::empty_result;
        }
        QVERIFY(refused);
    }
};

FACETMILL_TEST(TestCleanupParts)
#include "test_cleanup_parts.moc"
