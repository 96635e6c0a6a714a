// The operation as its users see it: parameters, passes, figures, refusals.
#include "core/mesh/sample.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/finish3/overlooked_lines.h"
#include "core/strategy/finish3/travel_choice.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/surface/drive_frame.h"
#include "tests/property/shapes.h"
#include "tests/support/dirty_scan.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

StrategyResult planned(const Mesh& mesh, const Finish3Settings& settings, const Tool& tool = ball_tool(6)) {
    return Finish3(settings).plan(context_of(mesh, tool), Progress());
}

const Mesh& level() {
    static const Mesh mesh =
        height_field([](double, double) { return 3.0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3);
    return mesh;
}

/// How far p is from what a ball, and above it the cutter's side, sweeps from one tip to the other.
double left_by_ball(const Vec3& p, const Vec3& from, const Vec3& to, double radius) {
    const Vec3 d = to - from, q = p - from - Vec3(0, 0, radius);
    const auto share = [](double part, double whole) {
        return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0;
    };
    double least = infinity;
    // The nearest place to the ball's centres, to their verticals, and where one turns into the other.
    for (const double t :
         {share(q.dot(d), d.squaredNorm()), share(q.head<2>().dot(d.head<2>()), d.head<2>().squaredNorm()),
          share(q.z() * d.z(), d.z() * d.z())}) {
        Vec3 off = q - t * d;
        off.z() = std::min(off.z(), 0.0);
        least = std::min(least, off.norm() - radius);
    }
    return least;
}

} // namespace

class TestFinish3 : public QObject {
    Q_OBJECT
private slots:
    /// However much may be left, no more than the limit is gouged unless that is asked for.
    void chord_tolerance_by_itself_is_limited() {
        for (const double tolerance : {0.02, 0.1, 0.2, 0.75, 5.0}) {
            Finish3Settings s;
            s.tolerance = tolerance;
            QCOMPARE(planned(level(), s).chord_tolerance, std::min(tolerance / 20, 0.01));
            s.chord_tolerance = {0.3 * tolerance, ""};
            QCOMPARE(planned(level(), s).chord_tolerance, 0.3 * tolerance);
        }
    }

    /// A sphere hangs over below its equator, and lines reach past it, since they serve the places beside
    /// them too. The tool does not fall there: it ends beside the equator, which it touches with its side.
    void passes_end_where_the_tool_leaves_the_part() {
        const Mesh sphere = ringed_sphere(25, 12);
        for (const double degrees : {0.0, 30.0, 90.0}) {
            Finish3Settings s;
            s.tolerance = under_sanitizer ? 0.2 : 0.05;
            s.direction = {degrees * pi / 180, ""};
            double lowest = infinity;
            for (const Pass& p : planned(sphere, s).passes)
                for (const CutterLocation& c : p.cl)
                    lowest = std::min(lowest, c.tip.z());
            QVERIFY2(lowest > -3.05 && lowest < -2, std::to_string(lowest).c_str());
        }
    }

    /// Along an upright wall the tool goes down to the wall's foot, and clears it with its side.
    void passes_go_down_along_upright_walls() {
        Mesh part = box(Vec3(-20, -15, 0), Vec3(20, 15, 8));
        for (Vec3& p : part.vertices)
            if (p.z() > 4) p.z() = 70 + 3 * p.x(); // so steep that the lines reach past the low wall
        part = turned(part, 0.3);
        Finish3Settings s;
        s.tolerance = 0.05;
        double lowest = infinity;
        for (const Pass& p : planned(part, s).passes)
            for (const CutterLocation& c : p.cl)
                lowest = std::min(lowest, c.tip.z());
        QVERIFY2(std::abs(lowest) < 1e-9, std::to_string(lowest).c_str());
    }

    void it_is_registered() {
        const auto& kinds = operation_kinds();
        QVERIFY(
            std::is_sorted(kinds.begin(), kinds.end(),
                           [](const OperationKind& a, const OperationKind& b) { return a.kind < b.kind; }));
        const auto op = make_operation("finish3");
        QCOMPARE(op->kind(), std::string_view("finish3"));
        QVERIFY(op->three_axis());
        std::string message;
        QCOMPARE(code_of([] { make_operation("finish33"); }, &message), std::string("out_of_range"));
        QVERIFY(message.find("did you mean 'finish3'") != std::string::npos);
    }

    void parameters_are_described_and_checked() {
        auto op = make_operation("finish3");
        std::set<std::string> keys;
        for (const ParameterInfo* p : op->parameters()) {
            keys.insert(p->key);
            QVERIFY2(!p->label.empty() && !p->help.empty(), p->key.c_str());
            QVERIFY2(op->get(p->key) == p->default_value, p->key.c_str());
            op->set(p->key, p->default_value);
        }
        for (const char* key :
             {"name", "tool", "tolerance", "allowance", "feed", "spindle", "clearance", "direction",
              "stepover", "topology", "pattern", "chord_tolerance", "normal_limit"})
            QVERIFY2(keys.count(key) == 1, key);
        op->set("stepover", 0.7);
        QCOMPARE(std::get<double>(op->get("stepover")), 0.7);
        QCOMPARE(std::get<double>(op->clone()->get("stepover")), 0.7);
        for (const auto& [key, value] :
             std::vector<std::pair<std::string, ParameterValue>>{{"stepover", 0.0},
                                                                 {"stepover", std::string("wide")},
                                                                 {"tolerance", 0.0},
                                                                 {"tolerance", -1.0},
                                                                 {"tolerance", std::nan("")},
                                                                 {"topology", std::string("spiral")},
                                                                 {"pattern", std::string("x")},
                                                                 {"normal_limit", 0.0},
                                                                 {"chord_tolerance", infinity},
                                                                 {"direction", std::string("z")}})
            QCOMPARE(code_of([&] { op->set(key, value); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { op->set("step_over", 1.0); }), std::string("unknown_key"));
    }

    void a_constant_step_is_kept() {
        Finish3Settings s;
        s.stepover = {1.5, ""};
        s.direction = {0, "x"};
        const StrategyResult r = planned(level(), s);
        QCOMPARE(r.drive_planes, 20);
        QCOMPARE(r.passes.size(), std::size_t(20));
        for (std::size_t i = 0; i < r.passes.size(); ++i) {
            QCOMPARE(r.passes[i].drive, int(i));
            QVERIFY(std::abs(r.passes[i].offset - (-14.25 + 1.5 * double(i))) < 1e-6);
            // Zigzag, straight, from border to border, nothing between two points needed.
            const auto& cl = r.passes[i].cl;
            QCOMPARE(cl.size(), std::size_t(2));
            const double from = i % 2 == 0 ? -20 : 20;
            QVERIFY((cl.front().tip - Vec3(from, r.passes[i].offset, 3)).norm() < 1e-5);
            QVERIFY((cl.back().tip - Vec3(-from, r.passes[i].offset, 3)).norm() < 1e-5);
            QCOMPARE(cl.front().axis, Vec3(0, 0, 1));
        }
        QCOMPARE(r.stepover_min, 1.5);
        QCOMPARE(r.stepover_max, 1.5);
        const double cusp = 3 - std::sqrt(9 - 0.75 * 0.75);
        const double chord = 0.05 * s.tolerance; // which a level path does not use
        QVERIFY2(std::abs(r.cusp_max - chord - cusp) < 0.01 * cusp, qPrintable(QString::number(r.cusp_max)));
        QCOMPARE(r.warnings.size(), std::size_t(1)); // more than the tolerance of 0.05
        QVERIFY(r.warnings[0].find("step-over") != std::string::npos);

        s.pattern = Finish3Settings::Pattern::oneway;
        s.stepover = {1, ""};
        const StrategyResult one = planned(level(), s);
        QVERIFY(one.warnings.empty());
        for (const Pass& p : one.passes)
            QVERIFY(p.cl.front().tip.x() < p.cl.back().tip.x());
    }

    void both_flanks_of_a_crease_are_cut_data() {
        QTest::addColumn<double>("slope");
        QTest::addColumn<double>("direction");
        QTest::addColumn<double>("moved");
        for (const double slope : {80, 50, 25}) {
            // The first pass lies elsewhere to the crease.
            for (const double moved : {0.0, 0.3, 0.6, 0.9, 1.2})
                QTest::addRow("%g degrees, moved by %g", slope, moved) << radians(slope) << 0.0 << moved;
            for (const double direction : {20, 35, 60, 90})
                QTest::addRow("%g degrees, passes at %g", slope, direction)
                    << radians(slope) << radians(direction) << 0.0;
        }
    }

    /// A floor and a wall that meet in a crease along x. Where the ball that touches both would leave up to a
    /// quarter of the tolerance, the passes leave no more than that and the tolerance, though no tip touches
    /// there.
    void both_flanks_of_a_crease_are_cut() {
        QFETCH(double, slope);
        QFETCH(double, direction);
        QFETCH(double, moved);
        const double tau = 0.1, r = 6, rise = std::tan(slope);
        const Mesh crease = height_field([&](double, double y) { return std::max(0.0, rise * y); },
                                         Vec2(-14, -14 - moved), Vec2(14, 14 + moved), 4, 2);
        Finish3Settings settings;
        settings.tolerance = tau;
        settings.direction = {direction, ""};
        const StrategyResult path = planned(crease, settings, ball_tool(2 * r));
        const Vec3 wall(0, std::cos(slope), std::sin(slope)); // up it
        // Distance of the contacts of the ball that touches both from the crease.
        const double seat = r * std::tan(0.5 * slope);
        const double inside = std::sqrt((r + 0.25 * tau) * (r + 0.25 * tau) - r * r);
        const auto left = [&](const Vec3& p) {
            double least = infinity;
            for (const Pass& pass : path.passes)
                for (std::size_t i = 1; i < pass.cl.size(); ++i) {
                    const Vec3 from = pass.cl[i - 1].tip + Vec3(0, 0, r),
                               route = pass.cl[i].tip - pass.cl[i - 1].tip;
                    const double t = route.squaredNorm() > 0
                                         ? std::clamp((p - from).dot(route) / route.squaredNorm(), 0.0, 1.0)
                                         : 0;
                    least = std::min(least, (p - from - t * route).norm() - r);
                }
            return least;
        };
        double worst = 0;
        Vec3 at = Vec3::Zero();
        for (int i = -40; i <= 40; ++i)
            for (int k = 0; k <= 40; ++k) {
                const double away = seat - inside + 0.1 * k, x = 0.1 * i;
                for (const Vec3& flank : {Vec3(0, -1, 0), wall}) {
                    const Vec3 p = Vec3(x, 0, 0) + away * flank;
                    // Of the ball that touches both, farther in.
                    const double least = std::hypot(r, std::max(seat - away, 0.0)) - r;
                    if (const double e = left(p) - least; e > worst) {
                        worst = e;
                        at = p;
                    }
                }
            }
        const QString figures = QString("%1 at (%2, %3, %4); %5 planes, expected %6")
                                    .arg(worst)
                                    .arg(at.x())
                                    .arg(at.y())
                                    .arg(at.z())
                                    .arg(path.drive_planes)
                                    .arg(path.cusp_max);
        qInfo("%s", qPrintable(figures));
        QVERIFY2(worst > 0.3 * tau && worst <= 1.02 * tau, qPrintable(figures));
    }

    void any_direction_covers_the_part() {
        Finish3Settings s;
        for (const double angle : {0.3, -1.0, 2.5}) {
            s.direction = {angle, ""};
            const StrategyResult r = planned(level(), s);
            QCOMPARE(r.direction, angle);
            const DriveFrame frame(angle);
            double lo = infinity, hi = -infinity;
            for (const Vec3& v : level().vertices) {
                lo = std::min(lo, frame.v(v));
                hi = std::max(hi, frame.v(v));
            }
            QVERIFY(r.passes.front().offset - lo < 1.1 && hi - r.passes.back().offset < 1.1);
            for (const Pass& p : r.passes)
                for (const CutterLocation& c : p.cl)
                    QVERIFY(std::abs(frame.v(c.tip) - p.offset) < 1e-9);
        }
    }

    void an_adaptive_step_needs_fewer_passes_than_a_constant_one() {
        // Level on one side, steep on the other.
        const Mesh m = height_field([](double, double y) { return y < 0 ? 0 : 0.06 * y * y; }, Vec2(-10, -20),
                                    Vec2(10, 20), 4, 160);
        Finish3Settings s;
        s.direction = {0, "x"};
        const StrategyResult adaptive = planned(m, s);
        QVERIFY(adaptive.cusp_max <= s.tolerance);
        QVERIFY(adaptive.stepover_min < 0.7 * adaptive.stepover_max);
        // As many planes at a constant distance leave more than the tolerance.
        const double range = adaptive.passes.back().offset - adaptive.passes.front().offset;
        s.stepover = {range / (adaptive.drive_planes - 1), ""};
        QVERIFY(planned(m, s).cusp_max > 1.2 * s.tolerance);
        // A constant step that keeps the tolerance makes many more.
        s.stepover = {adaptive.stepover_min, ""};
        QVERIFY(planned(m, s).drive_planes > 1.3 * adaptive.drive_planes);
    }

    /// A block on a plate, with upright walls across the passes and along them: no line of the plan is closer
    /// to the next for them, and nothing is passed more often than the step over the plate asks for.
    void upright_walls_thin_no_passes_data() {
        QTest::addColumn<double>("high");
        QTest::newRow("no higher than the ball's radius") << 2.5;
        QTest::newRow("higher") << 9.5;
    }
    void upright_walls_thin_no_passes() {
        QFETCH(double, high);
        const Vec3 half(25, 20, 5);
        Mesh part = box(-half, Vec3(half.x(), half.y(), 0));
        const Mesh block = box(Vec3(-10, -7, -1), Vec3(12, 8, high));
        const auto first = Index(part.vertices.size());
        part.vertices.insert(part.vertices.end(), block.vertices.begin(), block.vertices.end());
        for (const auto& f : block.facets)
            part.facets.push_back({first + f[0], first + f[1], first + f[2]});
        Finish3Settings s;
        s.direction = {0, "x"};
        const StrategyResult r = planned(part, s);
        double length = 0;
        for (const Pass& p : r.passes)
            for (std::size_t i = 1; i < p.cl.size(); ++i)
                length += (p.cl[i].tip - p.cl[i - 1].tip).norm();
        const double level = 2 * std::sqrt(2 * 3 * s.tolerance - s.tolerance * s.tolerance),
                     once = (2 * half.x() + 2 * high) * 2 * half.y() / level;
        QVERIFY2(length < 1.25 * once, qPrintable(QString("%1 of %2").arg(length).arg(once)));
        QVERIFY2(r.cusp_max <= s.tolerance, qPrintable(QString::number(r.cusp_max)));
    }

    /// A side that is nearly upright and runs nearly along the passes is cut by no row of places between two
    /// lines over much of its length: hardly anywhere on it does more stay than counts as uncut. (A third of
    /// it did, by up to nine millimetres, where rows alone were asked.)
    void sides_nearly_along_the_passes_are_cut() {
        Finish3Settings s;
        s.direction = {0, "x"};
        s.tolerance = 0.05;
        const double height = 30, half = 9, length = 12, radius = 3;
        for (const double draft : {0.1, 0.2, 0.6})
            for (const double turn : {0.7, 2.0, 5.0}) {
                Mesh part = box(Vec3(-length, -half, 0), Vec3(length, half, height));
                const double lean = std::tan(radians(draft));
                for (Vec3& v : part.vertices)
                    v.y() -= std::copysign(v.z() * lean, v.y());
                part = turned(part, radians(turn));
                const StrategyResult r = planned(part, s, ball_tool(2 * radius));
                double most = 0;
                int places = 0, uncut = 0;
                for (const double side : {-1.0, 1.0})
                    for (double x = 0.5 - length; x < length - 0.4; x += 0.9)
                        // Lower down only a tip below the bottom of the stock would do it.
                        for (double z = radius + 0.3; z < height - 0.9; z += 1.4) {
                            const Vec3 on(x, side * (half - z * lean), z);
                            const Vec3 p = Eigen::AngleAxisd(radians(turn), Vec3::UnitZ()) * on;
                            double least = infinity;
                            for (const Pass& pass : r.passes)
                                for (std::size_t i = 1; i < pass.cl.size(); ++i)
                                    least = std::min(
                                        least, left_by_ball(p, pass.cl[i - 1].tip, pass.cl[i].tip, radius));
                            most = std::max(most, least);
                            ++places;
                            uncut += least > 2 * s.tolerance;
                        }
                QVERIFY2(uncut < 0.01 * places && most < 3 * s.tolerance,
                         qPrintable(QString("draft %1 turned by %2: %3 on %4")
                                        .arg(draft)
                                        .arg(turn)
                                        .arg(most)
                                        .arg(uncut)));
            }
    }

    /// Each tip has a line within half of its width that goes past it, and lines do not lie closer than
    /// asked.
    void overlooked_tips_get_lines() {
        std::mt19937_64 rng(31);
        std::uniform_real_distribution<double> at(0, 20), wide(0.1, 2);
        for (int trial = 0; trial < 20; ++trial) {
            std::vector<OverlookedTip> tips;
            for (int k = 0; k < 60; ++k)
                tips.push_back({at(rng), at(rng), wide(rng)});
            const double join = 3;
            const std::vector<PlannedLine> lines = overlooked_lines(tips, join);
            QVERIFY(lines.size() <= tips.size());
            for (const OverlookedTip& tip : tips)
                QVERIFY(std::any_of(lines.begin(), lines.end(), [&](const PlannedLine& l) {
                    return std::abs(l.v - tip.v) <= 0.5 * tip.width && l.within->lo <= tip.u
                           && tip.u <= l.within->hi;
                }));
            for (std::size_t k = 1; k < lines.size(); ++k)
                QVERIFY(lines[k].v > lines[k - 1].v
                        || (lines[k].v == lines[k - 1].v
                            && lines[k].within->lo - lines[k - 1].within->hi > join));
        }
        // Along one line, one after another.
        QCOMPARE(overlooked_lines({{0, 1, 0.5}, {2, 1.2, 0.5}, {4, 1.4, 0.5}, {9, 1.1, 0.5}}, 3).size(),
                 std::size_t(2));
        QVERIFY(overlooked_lines({}, 3).empty());
    }

    void contacts_are_on_the_part_and_normals_turn_slowly() {
        const Mesh m = height_field([](double x, double y) { return std::sqrt(900 - x * x - y * y); },
                                    Vec2(-15, -10), Vec2(15, 10), 60, 40);
        Finish3Settings s;
        s.normal_limit = radians(2);
        const StrategyResult r = planned(m, s);
        const CutterCover cover(CutterProfile(ball_tool(6).cutter()), 0.001);
        std::size_t turns = 0;
        for (const Pass& p : r.passes) {
            QCOMPARE(p.cc.size(), p.cl.size());
            for (std::size_t i = 0; i < p.cc.size(); ++i) {
                const CutterContact& c = p.cc[i];
                QVERIFY(std::abs(c.point.norm() - 30) < 0.02);
                QVERIFY((c.point + cover.tip_offset(c.normal) - p.cl[i].tip).norm() < 0.01);
                if (i == 0) continue;
                ++turns;
                QVERIFY(std::acos(std::min(1.0, c.normal.dot(p.cc[i - 1].normal)))
                        <= radians(2) + radians(1.5));
            }
        }
        QVERIFY(turns > 100);
    }

    void a_hole_splits_passes() {
        const Mesh m =
            only(height_field([](double, double) { return 0.0; }, Vec2(-20, -15), Vec2(20, 15), 40, 30),
                 [](const Vec3& p) { return std::hypot(p.x(), p.y()) > 6; });
        Finish3Settings s;
        s.stepover = {1, ""};
        const StrategyResult r = planned(m, s);
        QVERIFY(r.passes.size() > std::size_t(r.drive_planes));
        // One side of it is cut after the other: the tool crosses it once or twice, not in every plane.
        int crossings = 0;
        for (std::size_t i = 0; i + 1 < r.passes.size(); ++i)
            if ((r.passes[i].cl.back().tip - r.passes[i + 1].cl.front().tip).norm() > 4) ++crossings;
        QVERIFY2(crossings <= 3, qPrintable(QString::number(crossings)));
    }

    void tessellation_tolerances_are_taken_off() {
        Finish3Settings s;
        PlanContext context = context_of(level(), ball_tool(6));
        const StrategyResult plain = Finish3(s).plan(context, Progress());
        context.tessellation_tolerance = {0.01, 0.02};
        const StrategyResult safe = Finish3(s).plan(context, Progress());
        // Lifted by the inner tolerance, and only what both leave of the tolerance for cusps.
        QVERIFY(std::abs(safe.passes[0].cl[0].tip.z() - plain.passes[0].cl[0].tip.z() - 0.02) < 1e-6);
        QVERIFY(safe.cusp_max <= 0.02);
        QVERIFY(safe.drive_planes > plain.drive_planes);
        context.tessellation_tolerance = {0.03, 0.03};
        std::string message;
        QCOMPARE(code_of([&] { Finish3(s).plan(context, Progress()); }, &message),
                 std::string("out_of_range"));
        QVERIFY(message.find("tessellation") != std::string::npos);
    }

    void nothing_to_cut_is_an_error_with_a_reason() {
        Mesh wall;
        wall.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 0, 10), Vec3(0, 0, 10)};
        wall.facets = {{0, 1, 2}, {0, 2, 3}};
        std::string message;
        QCOMPARE(code_of([&] { planned(wall, {}); }, &message), std::string("empty_result"));
        QVERIFY(message.find("upright") != std::string::npos);
        // A part a thousand times larger than the tool is for: told at once.
        Mesh huge = level();
        for (Vec3& v : huge.vertices)
            v *= 25000;
        QCOMPARE(code_of([&] { planned(huge, {}); }, &message), std::string("limit_exceeded"));
        QVERIFY(message.find("units") != std::string::npos);
        Finish3Settings s;
        s.stepover = {1e-5, ""};
        QCOMPARE(code_of([&] { planned(level(), s); }), std::string("limit_exceeded"));
    }

    void steep_places_and_short_tools_are_reported() {
        Tool tool = ball_tool(6);
        tool.flute_length = 4;
        tool.shank_diameter = 12;
        tool.shank_length = 30;
        const auto has = [](const StrategyResult& r, const char* word) {
            for (const auto& w : r.warnings)
                if (w.find(word) != std::string::npos) return true;
            return false;
        };
        Finish3Settings s;
        s.stepover = {2, ""};
        QVERIFY(has(planned(step(0, 12), s, tool), "shank"));
        QVERIFY(!has(planned(step(0, 3), s, tool), "shank"));
        QVERIFY(!has(planned(step(0, 12), s, ball_tool(6)), "shank"));
        tool.shank_diameter = 6;
        tool.holder = {{40, 20}};
        tool.shank_length = 2;
        QVERIFY(has(planned(step(0, 12), s, tool), "holder"));
    }

    /// A strip whose normals change less along it, but which needs partial passes all along there: across it
    /// the tool travels less, and "auto" finds that.
    void auto_takes_the_shorter_direction() {
        const Mesh pillar = *make_sample("pillar", under_sanitizer ? 0.4 : 0.1, Progress());
        const auto length = [](const StrategyResult& r) {
            double sum = 0;
            for (const Pass& p : r.passes)
                for (std::size_t i = 1; i < p.cl.size(); ++i)
                    sum += (p.cl[i].tip - p.cl[i - 1].tip).norm();
            return sum;
        };
        Finish3Settings s;
        s.tolerance = under_sanitizer ? 1.5 : 0.5;
        const StrategyResult chosen = planned(pillar, s, ball_tool(12.7));
        s.direction = {0, "x"};
        const StrategyResult x = planned(pillar, s, ball_tool(12.7));
        s.direction = {0, "y"};
        const StrategyResult y = planned(pillar, s, ball_tool(12.7));
        QVERIFY(x.direction_reason.empty() && y.direction_reason.empty());
        QVERIFY(length(y) < 0.9 * length(x));
        QVERIFY(chosen.direction == y.direction && length(chosen) == length(y));
        QVERIFY(chosen.direction_reason.starts_with("x: ")
                && chosen.direction_reason.find("; y: ") != std::string::npos);
    }

    /// Travel and what stays, mm and shares, as parts from elsewhere have them along X and Y: nothing left is
    /// worth several times the travel, a little less of much that stays anyway is not.
    void what_stays_is_weighed_against_travel() {
        struct Part {
            const char* name;
            PlannedTravel x, y;
            bool along_x;
        };
        for (const Part& part : {Part{"pillar", {69, 0.03}, {243, 0}, false},
                                 Part{"bracket", {40205, 0.13}, {15688, 0.14}, false},
                                 Part{"fan disk", {10205, 0}, {7564, 0.011}, true},
                                 Part{"flange", {10062, 0.0021}, {15073, 0}, false},
                                 Part{"rocker arm", {21100, 0.004}, {15200, 0.014}, true},
                                 Part{"car body", {26327, 0.0026}, {30325, 0.0071}, true},
                                 Part{"level", {1000, 0.001}, {700, 0.0011}, false}}) {
            QVERIFY2(is_better(part.x, part.y) == part.along_x, part.name);
            QVERIFY2(is_better(part.y, part.x) == !part.along_x, part.name);
        }
        // About as good, or nothing at all: neither, so that the direction of the normals' change stays.
        const PlannedTravel once{25607, 0.0033}, again{25852, 0.0032}, none{0, 0};
        QVERIFY(!is_better(once, again) && !is_better(again, once) && !is_better(none, none));
    }

    /// A deep groove hardly wider than ball and shank: across it no piece of a pass is long enough to be
    /// kept, along it passes are. The planes by which a direction is chosen first miss it, and neither
    /// direction travels much less than the other.
    void auto_counts_what_shank_and_holder_keep_passes_from() {
        const auto part = [](double x, double y) {
            const double off = std::abs(x), radius = 3.2;
            return off > radius + 0.05 || y < 3 || y > 17
                       ? 12.0
                       : -std::sqrt(std::max(0.0, radius * radius - off * off));
        };
        Mesh mesh = height_field(part, Vec2(-8, -70), Vec2(8, 70), 160, 70);
        for (Vec3& v : mesh.vertices) // fine at the groove alone
            if (const double beside = std::abs(v.x()) - 4; beside > 0)
                v.x() = std::copysign(4 + 9 * beside, v.x());
        Tool tool = ball_tool(6);
        tool.flute_length = 4;
        tool.shank_diameter = 6.06;
        tool.shank_length = 30;
        Finish3Settings s;
        const auto in_groove = [](const StrategyResult& r) {
            double sum = 0;
            for (const Pass& p : r.passes)
                for (std::size_t i = 1; i < p.cl.size(); ++i)
                    if (std::max(p.cl[i].tip.z(), p.cl[i - 1].tip.z()) < 0)
                        sum += (p.cl[i].tip - p.cl[i - 1].tip).norm();
            return sum;
        };
        const StrategyResult chosen = planned(mesh, s, tool);
        QVERIFY2(chosen.direction > 1 && in_groove(chosen) > 10, chosen.direction_reason.c_str());
        QVERIFY(chosen.direction_reason.starts_with("x: "));
        s.direction = {0, "x"};
        QCOMPARE(in_groove(planned(mesh, s, tool)), 0.0);
        // With a shank that goes in everywhere there is no reason to turn.
        s.direction = {0, "auto"};
        QCOMPARE(planned(mesh, s, ball_tool(6)).direction, 0.0);
    }

    /// A stock smaller than the part: nothing is passed where there is none, or the part stands above it.
    void what_passes_the_stock_by_is_left_out() {
        PlanContext context = context_of(level(), ball_tool(6));
        Finish3Settings s;
        s.stepover = {1.5, ""};
        s.direction = {0, "x"};
        const auto length = [](const StrategyResult& r) {
            double sum = 0;
            for (const Pass& p : r.passes)
                for (std::size_t i = 1; i < p.cl.size(); ++i)
                    sum += (p.cl[i].tip - p.cl[i - 1].tip).norm();
            return sum;
        };
        const double whole = length(Finish3(s).plan(context, Progress()));
        context.stock_box.hi.x() = -10; // of -20 to 20
        const StrategyResult side = Finish3(s).plan(context, Progress());
        QVERIFY(std::abs(length(side) / whole - (10 + 3.5) / 40.0) < 0.03); // out by a radius
        for (const Pass& p : side.passes)
            for (const CutterLocation& c : p.cl)
                QVERIFY(c.tip.x() < -10 + 6.5);
        context.stock_box = Box3{Vec3(-20, -15, 0), Vec3(20, 15, 2.5)}; // the part is level at 3
        QCOMPARE(code_of([&] { Finish3(s).plan(context, Progress()); }), std::string("empty_result"));
    }

    /// What an earlier cut has cleared to within the tolerance is left out, and nothing else.
    void the_rest_is_cut_where_it_stands() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.stock_box.hi.z() += 2;
        Finish3Settings s;
        s.stepover = {1.5, ""};
        s.direction = {0, "x"};
        const StrategyResult whole = Finish3(s).plan(context, Progress());
        s.rest_only = true;
        QVERIFY(Finish3(s).reads_stock());
        const StrategyResult all = Finish3(s).plan(context, Progress());
        QCOMPARE(all.passes.size(), whole.passes.size());
        // A flat end clears x < 4 to the surface.
        auto cuts = std::make_shared<EarlierCuts>();
        cuts->cutter = AptCutter::flat(10, 40);
        const double z = whole.passes[0].cl[0].tip.z();
        for (double y = -20; y <= 20; y += 4)
            cuts->motions.push_back({Vec3(-30, y, z), Vec3(-1, y, z)});
        context.earlier = {cuts};
        const StrategyResult rest = Finish3(s).plan(context, Progress());
        QCOMPARE(rest.passes.size(), whole.passes.size());
        for (const Pass& p : rest.passes) {
            double lo = infinity, hi = -infinity;
            for (const CutterLocation& c : p.cl) {
                lo = std::min(lo, c.tip.x());
                hi = std::max(hi, c.tip.x());
                QVERIFY(std::abs(c.tip.z() - z) < 1e-6);
            }
            QCOMPARE(p.cc.size(), p.cl.size());
            // In by a radius before the first material, and to the end.
            QVERIFY2(lo > -4.5 && lo < 1.5, qPrintable(QString::number(lo)));
            QVERIFY(hi > 19);
        }
        for (double y = -20; y <= 20; y += 4)
            cuts->motions.push_back({Vec3(-1, y, z), Vec3(30, y, z)});
        QCOMPARE(code_of([&] { Finish3(s).plan(context, Progress()); }), std::string("empty_result"));
    }

    void a_solid_is_passed_once() {
        Finish3Settings s;
        s.stepover = {1.5, ""};
        s.direction = {0, "x"};
        const Mesh solid = box(Vec3(-20, -15, 0), Vec3(20, 15, 3));
        const StrategyResult r = planned(solid, s);
        QCOMPARE(r.passes.size(), std::size_t(20));
        for (const Pass& p : r.passes)
            for (const CutterLocation& c : p.cl)
                QVERIFY(std::abs(c.tip.z() - 3) < 1e-6);
    }
};

FACETMILL_TEST(TestFinish3)
#include "test_finish3.moc"
