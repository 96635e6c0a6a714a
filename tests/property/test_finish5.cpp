// Finishing with five axes over parts with known answers: judged by brute force over all facets and by the
// verifier, which share no code with the planner.
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/base/turn.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/five_axis/tilted_stepover.h"
#include "tests/property/five_axis_plan.h"
#include "tests/support/brute_lift.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Choice = Finish5Settings::PostureChoice;

const Vec2 sheet_low(-12, -8), sheet_high(12, 8);

Mesh sheet(const std::string& name) {
    const auto field = [](const auto& f, int nx, int ny) {
        return height_field(f, sheet_low, sheet_high, nx, ny);
    };
    if (name == "plane") return field([](double x, double) { return 0.1 * x; }, 2, 2);
    if (name == "cap")
        return field([](double x, double y) { return std::sqrt(900 - x * x - y * y); }, 16, 12);
    if (name == "valley") return field([](double x, double) { return -std::sqrt(900 - x * x); }, 24, 2);
    if (name == "bend") // level, round and hollow along the travel, steep
        return field(
            [](double x, double) {
                const double radius = 9, slope = radians(55);
                const double end = radius * std::sin(slope);
                if (x <= -3) return 0.0;
                if (x - -3 <= end) return radius - std::sqrt(radius * radius - (x + 3) * (x + 3));
                return radius * (1 - std::cos(slope)) + (x + 3 - end) * std::tan(slope);
            },
            120, 2);
    return field([](double x, double y) { return 0.01 * (x * x - y * y); }, 16, 12);
}

Finish5Settings settings(double tolerance, Choice choice = Choice::global) {
    Finish5Settings s;
    s.tolerance = tolerance;
    s.direction = {0, "x"};
    s.posture = choice;
    return s;
}

/// Deepest that the cutter is in the part, along its axis, over every facet near it.
double deepest_in(const BruteCutter& cutter, const Mesh& part, const CutterLocation& at) {
    const Mat3 turn = turn_between(at.axis, Vec3::UnitZ()).toRotationMatrix();
    double most = -infinity;
    for (const auto& facet : part.facets) {
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = turn * (part.vertices[facet[k]] - at.tip);
        // Below the tip it cannot be cut.
        if (std::max({p[0].z(), p[1].z(), p[2].z()}) < most) continue;
        const Vec3 middle = (p[0] + p[1] + p[2]) / 3;
        double reach = double(cutter.radius());
        for (const Vec3& corner : p)
            reach = std::max(reach, double(cutter.radius())
                                        + std::hypot(corner.x() - middle.x(), corner.y() - middle.y()));
        if (std::hypot(middle.x(), middle.y()) > reach) continue;
        most = std::max(most, brute_lift(cutter, p[0], p[1], p[2], 0, 0));
    }
    return most;
}

/// As machines with tool centre point control move: the tip straight, the axis in one plane.
CutterLocation on_route(const CutterLocation& a, const CutterLocation& b, double t) {
    const double angle = std::acos(std::clamp(a.axis.dot(b.axis), -1.0, 1.0));
    CutterLocation at{a.tip + t * (b.tip - a.tip), a.axis};
    const Vec3 across = a.axis.cross(b.axis);
    if (across.norm() > 1e-12) at.axis = Eigen::AngleAxisd(t * angle, across.normalized()) * a.axis;
    return at;
}

/// What passes travel that all go from end to end of the part, as far apart as the narrowest of their strips
/// allows.
double travelled_all_along(const PlanContext& context, const Finish5Settings& settings) {
    const FiveAxisField field(context, settings, Progress());
    const TiltedStepOver stepover(field);
    double sum = 0;
    EstimatedPass pass = stepover.next(nullptr, 1, 1, Progress()).pass;
    while (true) {
        for (const SurfaceLine& line : pass.lines)
            sum += line.length();
        if (stepover.reaches_border(pass)) return sum;
        pass = stepover.next(&pass, -pass.travel, 1, Progress()).pass;
    }
}

} // namespace

class TestFinish5 : public QObject {
    Q_OBJECT
private slots:
    void shapes_are_cut_to_tolerance_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<QString>("tool");
        QTest::addColumn<int>("choice");
        const char* const methods[] = {"cm2", "local", "global"};
        QTest::addRow("bend flat global") << "bend"
                                          << "flat" << 2;
        int nth = 0;
        for (const char* shape : {"plane", "cap", "valley", "saddle"}) {
            ++nth;
            for (const char* tool : {"flat", "bull", "ball", "tapered"}) {
                ++nth;
                for (int choice = 0; choice < 3; ++choice) {
                    // Global everywhere, or with every second pair; the others with one shape per cutter.
                    if (choice == 2 && !all_cases && nth % 2 != 0) continue;
                    if (choice != 2 && !((*tool == 'f' && *shape == 's') || (*tool == 'b' && *shape == 'c')))
                        continue;
                    if (under_sanitizer && *shape != 's') continue;
                    QTest::addRow("%s %s %s", shape, tool, methods[choice]) << shape << tool << choice;
                }
            }
        }
    }

    void shapes_are_cut_to_tolerance() {
        QFETCH(QString, shape);
        QFETCH(QString, tool);
        QFETCH(int, choice);
        const Mesh part = sheet(shape.toStdString());
        const PlanContext context = five_axis_context(part, cutter(tool.toStdString()));
        const double tolerance = 0.1, chord = tolerance / 20;
        const Finish5 op(settings(tolerance, Choice(choice)));
        const StrategyResult path = op.plan(context, Progress());
        QVERIFY(path.drive_planes >= 3);
        QVERIFY(path.cusp_max > 0 && path.cusp_max <= tolerance * (1 + 1e-9));
        QCOMPARE(path.chord_tolerance, chord);
        QCOMPARE(path.cleanup_points, path.cleanup.size());
        // Local choices may part at a turn.
        QVERIFY2(path.cleanup_points <= (choice == 1 ? 3u : 0u),
                 qPrintable(QString::number(path.cleanup_points)));

        // Within the limits: what stands between neighbours too.
        const Finish5Settings& s = op.settings();
        QVERIFY(path.as<LeadRange>()->lead_min >= s.lead_limits[0]
                && path.as<LeadRange>()->lead_max <= s.lead_limits[1]);
        for (const Pass& pass : path.passes) {
            QCOMPARE(pass.cc.size(), pass.cl.size());
            for (std::size_t i = 0; i < pass.cl.size(); ++i) {
                QVERIFY(std::abs(pass.cl[i].axis.norm() - 1) < 1e-12);
                const double lead = std::acos(std::clamp(pass.cl[i].axis.dot(pass.cc[i].normal), -1.0, 1.0));
                QVERIFY(lead <= s.lead_limits[1] + 1e-6);
                if (i == 0) continue;
                const double turn =
                    std::acos(std::clamp(pass.cl[i].axis.dot(pass.cl[i - 1].axis), -1.0, 1.0));
                QVERIFY2(turn <= s.turn_limit + 1e-6, qPrintable(QString::number(degrees(turn))));
            }
        }

        // Brute force, at locations and at seven places between.
        const BruteCutter brute(context.tool.cutter());
        const int every = under_sanitizer ? 490 : 49;
        int count = 0;
        const auto clear = [&](const CutterLocation& at) {
            if (++count % every != 0) return true;
            const double depth = deepest_in(brute, part, at);
            if (depth <= chord) return true;
            qWarning("gouge of %g", depth);
            return false;
        };
        const ToolMotions motions = linked(path, context, op);
        for (std::size_t i = 1; i < motions.motions.size(); ++i)
            for (int k = 1; k <= 8; ++k)
                QVERIFY(clear(on_route(motions.motions[i - 1].to, motions.motions[i].to, k / 8.0)));
        QVERIFY(count > 300);

        // Rapids end clear of part and stock, and turn the axis little at once.
        for (std::size_t i = 0; i < motions.motions.size(); ++i) {
            if (motions.motions[i].kind != MotionKind::rapid) continue;
            const CutterLocation& to = motions.motions[i].to;
            Box3 both = context.stock_box;
            both.add(context.part_box);
            QVERIFY((to.tip - to.tip.cwiseMax(both.lo).cwiseMin(both.hi)).norm()
                    > std::min(op.common().clearance, 0.25 * context.tool.diameter) - 1e-9);
            if (i > 0) QVERIFY(to.axis.dot(motions.motions[i - 1].to.axis) > std::cos(radians(5.001)));
        }

        const Verification v = judged(part, context, motions, tolerance, chord);
        QVERIFY(v.figures.samples > 500);
        QVERIFY2(!v.gouged(), qPrintable(QString::number(std::max(v.figures.gouge_max, v.border.gouge_max))));
        if (shape != "bend") QVERIFY(v.collisions.empty()); // there the shank stands in a block never roughed
        // What a pose holds is checked at contact points and half-way between them.
        QVERIFY2(v.figures.excess_p999 <= 1.1 * tolerance,
                 qPrintable(QString::number(v.figures.excess_p999)));
        QCOMPARE(v.figures.uncut_fraction, 0.0);
        QVERIFY2(v.border.uncut_fraction < 2e-4, qPrintable(QString::number(v.border.uncut_fraction)));
        QVERIFY2(v.border.excess_p999 <= 1.1 * tolerance, qPrintable(QString::number(v.border.excess_p999)));
    }

    /// A twisted sheet rises on one side before the contact point and on the other behind it. A flat end that
    /// leans to the side that falls clears a wider strip than one that leans along the travel far enough to
    /// pass over the side that rises: postures that may lean so have the step-over that this allows.
    void free_postures_make_wide_strips() {
        const Mesh part =
            height_field([](double x, double y) { return 0.02 * x * y; }, sheet_low, sheet_high, 48, 32);
        const PlanContext context = five_axis_context(part, cutter("flat"));
        const double tolerance = 0.02;
        const int with_cm2 = Finish5(settings(tolerance, Choice::cm2)).plan(context, Progress()).drive_planes;
        Finish5Settings s = settings(tolerance);
        s.yaw_limits = {0, 0};
        const int straight = Finish5(s).plan(context, Progress()).drive_planes;
        for (const Choice choice : {Choice::local, Choice::global}) {
            const Finish5 op(settings(tolerance, choice));
            const StrategyResult path = op.plan(context, Progress());
            // Passes with CM2 do not answer for what lies beyond their ends.
            QVERIFY2(path.drive_planes < 0.9 * straight && path.drive_planes <= with_cm2,
                     qPrintable(QString("%1 passes, yaw 0 %2, CM2 %3")
                                    .arg(path.drive_planes)
                                    .arg(straight)
                                    .arg(with_cm2)));
            QCOMPARE(path.cleanup_points, std::size_t(0));
            const Verification v =
                judged(part, context, linked(path, context, op), tolerance, path.chord_tolerance);
            QVERIFY(!v.gouged() && v.collisions.empty());
            QVERIFY2(v.figures.excess_p999 <= 1.05 * tolerance,
                     qPrintable(QString::number(v.figures.excess_p999)));
            QCOMPARE(v.figures.uncut_fraction, 0.0);
        }
    }

    /// Where the border slants every pass ends elsewhere than its neighbours. That is no place the step-over
    /// has to mind: nothing of the part lies between.
    void slanted_borders_ask_for_no_closer_passes() {
        const Mesh straight = height_field([](double, double) { return 0.0; }, sheet_low, sheet_high, 24, 16);
        Mesh slanted = straight;
        for (Vec3& p : slanted.vertices)
            p.x() *= 1 + 0.015 * p.y();
        for (const Choice choice : {Choice::cm2, Choice::global}) {
            const Finish5 op(settings(0.1, choice));
            const int planes = op.plan(five_axis_context(straight, cutter("flat")), Progress()).drive_planes;
            const PlanContext context = five_axis_context(slanted, cutter("flat"));
            const StrategyResult path = op.plan(context, Progress());
            QCOMPARE(path.drive_planes, planes);
            QCOMPARE(path.cleanup_points, std::size_t(0));
            const Verification v =
                judged(slanted, context, linked(path, context, op), 0.1, path.chord_tolerance);
            QVERIFY(!v.gouged() && v.collisions.empty());
            for (const DeviationFigures& f : {v.figures, v.border})
                QVERIFY2(f.excess_p999 <= 1.05 * 0.1, qPrintable(QString::number(f.excess_p999)));
        }
    }

    /// A hump on a plain: its strips are narrow, those of the plain beside it wide. It is cut by partial
    /// passes, to the same tolerance as by passes all along the part and with less travel; a piece of a part
    /// as well.
    void partial_passes_stand_where_strips_are_narrow() {
        const Mesh part = height_field(
            [](double x, double y) { return 1.5 * std::exp(-(std::pow(x + 50, 2) + y * y) / 20); },
            Vec2(-70, -10), Vec2(50, 10), 240, 40);
        const PlanContext context = five_axis_context(part, cutter("flat"));
        const double tolerance = 0.05;
        const Finish5 op(settings(tolerance, Choice::cm2));
        const auto travelled = [](const StrategyResult& path) {
            double sum = 0;
            for (const Pass& p : path.passes)
                for (std::size_t i = 1; i < p.cl.size(); ++i)
                    sum += (p.cl[i].tip - p.cl[i - 1].tip).norm();
            return sum;
        };
        const double all_along = travelled_all_along(context, op.settings());
        const StrategyResult partial = finish_piece(op.settings(), context, Progress());
        for (const StrategyResult& path : {op.plan(context, Progress()), partial}) {
            QVERIFY2(travelled(path) < 0.8 * all_along,
                     qPrintable(QString("%1 of %2").arg(travelled(path)).arg(all_along)));
            const Verification v =
                judged(part, context, linked(path, context, op), tolerance, path.chord_tolerance);
            QVERIFY(!v.gouged() && v.collisions.empty());
            QCOMPARE(v.figures.uncut_fraction, 0.0);
            QVERIFY2(v.figures.excess_p999 <= 1.1 * tolerance,
                     qPrintable(QString::number(v.figures.excess_p999)));
        }
        // Every strip is narrower than that: nothing but the first pass is asked for, and much stays.
        const StrategyResult left = finish_piece(op.settings(), context, Progress(), 100);
        QVERIFY(travelled(left) < 0.8 * travelled(partial));
        QVERIFY(judged(part, context, linked(left, context, op), tolerance, left.chord_tolerance)
                    .figures.excess_p99
                > tolerance);
    }

    /// Two sheets, a gap wider than the tool between them: along the travel, and across it.
    void every_piece_of_the_part_is_cut() {
        const Mesh whole =
            height_field([](double x, double) { return 0.1 * x; }, Vec2(-20, -15), Vec2(20, 15), 40, 30);
        const Mesh apart = only(whole, [](const Vec3& p) { return std::abs(p.y()) > 6; });
        const Mesh slotted = only(whole, [](const Vec3& p) { return std::abs(p.y() - 1.3) > 1; });
        const Mesh holed = only(whole, [](const Vec3& p) { return std::hypot(p.x(), p.y()) > 6; });
        for (const auto& [part, direction] : {std::pair(&apart, "x"), std::pair(&apart, "y"),
                                              std::pair(&slotted, "x"), std::pair(&holed, "x")}) {
            if (!all_cases && (part == &holed || (part == &apart && *direction == 'y'))) continue;
            const PlanContext context = five_axis_context(*part, cutter("flat"));
            Finish5Settings s = settings(0.1);
            s.direction = {0, direction};
            const Finish5 op(s);
            const StrategyResult path = op.plan(context, Progress());
            const Verification v =
                judged(*part, context, linked(path, context, op), s.tolerance, path.chord_tolerance);
            QVERIFY(!v.gouged() && v.collisions.empty());
            for (const DeviationFigures& f : {v.figures, v.border})
                QVERIFY2(f.excess_p999 <= 1.05 * s.tolerance,
                         qPrintable(QString("%1 travelling along %2").arg(f.excess_p999).arg(direction)));
            for (const DeviationExtreme& e : v.excess) {
                if (e.deviation <= 1.05 * s.tolerance) continue;
                bool told = false;
                for (const CutterContact& c : path.cleanup)
                    told |= (c.point - e.point).norm() <= 0.5 * context.tool.diameter;
                QVERIFY2(told, qPrintable(QString::number(e.deviation)));
            }
        }
    }

    /// A place that no posture serves ends neither the pass nor the part.
    void a_wall_in_the_way_does_not_end_the_part() {
        const PlanContext context = five_axis_context(box(Vec3(-12, -8, 0), Vec3(12, 8, 5)), cutter("ball"));
        Finish5Settings s = settings(0.1);
        s.lead_limits = {0, radians(80)};
        s.sides = Finish5Settings::Sides::top;
        const Finish5 op(s);
        const StrategyResult path = op.plan(context, Progress());
        const Verification v =
            judged(*context.part, context, linked(path, context, op), s.tolerance, path.chord_tolerance);
        QVERIFY(!v.gouged());
        // The rims and walls of the box are left to clean-up, and so said.
        for (const DeviationExtreme& e : v.excess) {
            bool told = e.normal.z() < 0.9 || e.deviation <= 1.1 * s.tolerance;
            for (const CutterContact& c : path.cleanup)
                told |= (c.point - e.point).norm() <= 0.5 * context.tool.diameter;
            QVERIFY2(told, qPrintable(QString::number(e.deviation)));
        }
        // The top's middle is cut on either side of the rims that no posture serves.
        QVERIFY(path.drive_planes > 3 && path.passes.size() > 3 && path.cleanup_points > 0);
    }

    void the_same_bits_with_any_number_of_threads() {
        const Mesh part = sheet("saddle");
        for (const Choice choice : {Choice::cm2, Choice::local, Choice::global}) {
            const PlanContext context =
                five_axis_context(part, cutter(choice == Choice::cm2 ? "bull" : "flat"));
            const Finish5 op(settings(0.1, choice));
            set_thread_count(1);
            const auto one = numbers(op.plan(context, Progress()));
            set_thread_count(2);
            const auto two = numbers(op.plan(context, Progress()));
            set_thread_count(0);
            QVERIFY(one.size() > 1000);
            QCOMPARE(two, one);
        }
    }

    void winding_does_not_matter() {
        Mesh part = sheet("saddle");
        const PlanContext up = five_axis_context(part, cutter("bull"));
        for (auto& facet : part.facets)
            std::swap(facet[1], facet[2]);
        const PlanContext down = five_axis_context(part, cutter("bull"));
        const Finish5 op(settings(0.1));
        const StrategyResult a = op.plan(up, Progress()), b = op.plan(down, Progress());
        QCOMPARE(a.drive_planes, b.drive_planes);
        QCOMPARE(b.cleanup_points, std::size_t(0));
        for (const Pass& pass : b.passes)
            for (const CutterContact& c : pass.cc)
                QVERIFY(c.normal.z() > 0.5);
    }

    void a_cancelled_plan_ends_without_a_trace() {
        const Mesh part = sheet("saddle");
        const PlanContext context = five_axis_context(part, cutter("bull"));
        for (const Choice choice : {Choice::cm2, Choice::local, Choice::global})
            for (const double when : {0.0, 0.03, 0.2, 0.6, 0.95}) {
                Job job;
                const Finish5 op(settings(0.05, choice));
                const bool cancelled =
                    cancelled_at(job, when, [&](const Progress& p) { op.plan(context, p); });
                if (when < 0.9) QVERIFY2(cancelled, qPrintable(QString::number(when)));
            }
    }

    void a_constant_step_over_is_kept() {
        const Mesh part = sheet("cap");
        const PlanContext context = five_axis_context(part, cutter("bull"));
        Finish5Settings s = settings(0.1);
        s.stepover = {1.5, ""};
        for (const auto pattern : {Finish5Settings::Pattern::zigzag, Finish5Settings::Pattern::oneway}) {
            s.pattern = pattern;
            const StrategyResult path = Finish5(s).plan(context, Progress());
            QCOMPARE(path.drive_planes, 11); // 16 mm
            QCOMPARE(path.stepover_min, 1.5);
            QCOMPARE(path.stepover_max, 1.5);
            for (const Pass& pass : path.passes) {
                const double along = pass.cl.back().tip.x() - pass.cl.front().tip.x();
                const bool back = pattern == Finish5Settings::Pattern::zigzag && pass.drive % 2 == 1;
                QVERIFY(back ? along < 0 : along > 0);
            }
        }
    }

    /// Strips that are wider than a ball clears to tolerance: half of each is cut, or what lies under the
    /// pass, and the rest is told.
    void strips_that_no_posture_clears_are_cut_under_the_pass_data() {
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("cleared"); ///< of the step, to either side
        QTest::newRow("as wide as the ball clears") << 1.2 << 0.5;
        QTest::newRow("half") << 2.4 << 0.25;
        QTest::newRow("under the pass") << 5.0 << 0.0;
    }
    void strips_that_no_posture_clears_are_cut_under_the_pass() {
        QFETCH(double, step);
        QFETCH(double, cleared);
        const Mesh part = sheet("plane");
        const PlanContext context = five_axis_context(part, cutter("ball"));
        Finish5Settings s = settings(0.1);
        s.stepover = {step, ""};
        const StrategyResult path = Finish5(s).plan(context, Progress());
        const auto record = path.as<TiltedPath>()->record;
        const std::size_t narrowed = cleared < 0.5 ? record->points.size() : 0;
        QCOMPARE(path.cleanup_points, narrowed);
        const bool told = std::any_of(path.warnings.begin(), path.warnings.end(), [](const std::string& w) {
            return w.find("no posture clears the whole strip") != std::string::npos;
        });
        QCOMPARE(told, narrowed > 0);
        // What is said to be cleared is, by the ball's centre over the plane.
        const Vec3 normal = Vec3(-0.1, 0, 1).normalized();
        std::size_t locations = 0;
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl) {
                ++locations;
                const Vec3 centre = c.tip + 3 * c.axis;
                const double over = normal.dot(centre - part.vertices.front());
                QVERIFY(over > 3 - 1e-6);
                const double aside = cleared * step + std::abs(centre.y() - pass.offset);
                QVERIFY2(std::hypot(over, aside) < 3 + s.tolerance, qPrintable(QString::number(aside)));
            }
        // Places beyond the part, where the tool runs out, have nothing under the pass.
        std::size_t on_part = 0;
        for (const FiveAxisRecord::Point& p : record->points)
            if (std::abs(p.place.surface.x()) < sheet_high.x()) {
                ++on_part;
                QVERIFY(p.choice.free);
            }
        QVERIFY2(on_part > 50 && locations >= on_part, qPrintable(QString::number(locations)));
    }

    /// Grids and limits of every width: neighbours stay together, or the pass is parted.
    void axes_turn_within_the_limit() {
        const Mesh part = sheet("saddle");
        const PlanContext context = five_axis_context(part, cutter("flat"));
        for (const auto& [limit, grid] : {std::pair(2.0, 3.0), std::pair(8.0, 15.0)})
            for (const Choice choice : {Choice::cm2, Choice::local, Choice::global}) {
                Finish5Settings s = settings(0.1, choice);
                s.turn_limit = radians(limit);
                s.grid_step = radians(grid);
                const StrategyResult path = Finish5(s).plan(context, Progress());
                double most = 0;
                for (const Pass& pass : path.passes)
                    for (std::size_t i = 1; i < pass.cl.size(); ++i)
                        most = std::max(
                            most, std::acos(std::clamp(pass.cl[i].axis.dot(pass.cl[i - 1].axis), -1.0, 1.0)));
                QVERIFY2(most <= s.turn_limit + 1e-6,
                         qPrintable(QString("%1 of %2").arg(degrees(most)).arg(limit)));
            }
    }

    /// The rim comes down towards the open border of a plate and leaves it: deepest at the border, and clear
    /// of everything right behind it.
    void a_rim_that_leaves_a_border_is_looked_at_closely() {
        const Mesh plate =
            height_field([](double, double) { return 0.0; }, Vec2(-40, -20), Vec2(0, 20), 4, 4);
        const Tool tool = flat_tool(12.7);
        const PlanContext context = context_of(plate, tool);
        const ToolLift lift(context.contact, tool);
        const double radius = lift.cutter().max_radius(), chord = 0.01, limit = 0.6 * chord;
        std::mt19937 engine(77);
        const auto uniform = [&](double lo, double hi) {
            return std::uniform_real_distribution(lo, hi)(engine);
        };
        ToolLift::Hint hint;
        int cuts = 0, clear = 0;
        for (int trial = 0; trial < trials(400); ++trial) {
            const double lean = radians(uniform(1, 20)), slope = uniform(0.02, 0.5),
                         at_border = uniform(-0.05, 0.03), from = -uniform(1, 12),
                         beyond = uniform(0.001, 0.3), y = uniform(-5, 5);
            const Vec3 axis(-std::sin(lean), 0, std::cos(lean));
            const auto with_rim_at = [&](double x) {
                return CutterLocation{Vec3(x, y, at_border - slope * x)
                                          + radius * Vec3(std::cos(lean), 0, std::sin(lean)),
                                      axis};
            };
            const CutterLocation a = with_rim_at(from), b = with_rim_at(beyond);
            double most = -infinity;
            const double leaves = from / (from - beyond);
            for (int k = 1; k < 2000; ++k)
                for (const double t : {k / 2000.0, leaves * (1 - 1e-7 * k * k)}) {
                    const CutterLocation at = on_route(a, b, t);
                    if (t > 0 && t < 1) most = std::max(most, lift.lift({at.tip, at.axis}));
                }
            const bool kept = keeps_clear_between(lift, a, b, looking_step(radius, chord), limit, hint);
            QVERIFY2(kept ? most <= 1.5 * limit : most > limit,
                     qPrintable(QString("trial %1: %2, deepest %3").arg(trial).arg(kept).arg(most)));
            ++(kept ? clear : cuts);
        }
        QVERIFY(cuts > trials(50) && clear > trials(50));
    }

    void a_plate_is_cut_side_by_side_data() {
        QTest::addColumn<double>("lean");
        QTest::newRow("upright") << 0.0;
        QTest::newRow("leaning") << 50.0;
    }
    /// A plate that stands upright: nothing of it but its upper rim is seen from above. Or one that leans, so
    /// that one face looks down at 140 degrees, where leads within the limits lie below the ground. Cut side
    /// by side the ball comes to every place that an axis reaches, judged by the ball's centre alone.
    void a_plate_is_cut_side_by_side() {
        QFETCH(double, lean);
        const Box3 box{Vec3(-8, -2, 0), Vec3(8, 2, 12)};
        const Mat3 turn = Eigen::AngleAxisd(radians(lean), Vec3::UnitX()).toRotationMatrix();
        Mesh part = facetmill::test::box(box.lo, box.hi);
        for (Vec3& p : part.vertices)
            p = turn * p;
        PlanContext context = five_axis_context(part, with_holder(ball_tool(6)));
        context.machine = find_machine("trunnion-ac");
        Finish5Settings s = settings(0.3);
        s.direction = {0, "auto"};
        const Finish5 op(s);
        const StrategyResult path = op.plan(context, Progress());
        std::vector<Vec3> centres; // where the plate stands upright
        for (const Pass& pass : path.passes)
            for (std::size_t i = 0; i < pass.cl.size(); ++i) {
                QVERIFY(pass.cl[i].axis.z() >= tolerance::lowest_axis_z * (1 - 1e-9));
                for (int k = 0; i > 0 && k <= 8; ++k) {
                    const CutterLocation at = on_route(pass.cl[i - 1], pass.cl[i], k / 8.0);
                    centres.push_back(turn.transpose() * (at.tip + 3 * at.axis));
                    const Vec3 nearest = centres.back().cwiseMax(box.lo).cwiseMin(box.hi);
                    QVERIFY((centres.back() - nearest).norm() >= 3 - path.chord_tolerance);
                }
            }
        const auto nearest_centre = [&](const Vec3& p) {
            double least = infinity;
            for (const Vec3& c : centres)
                least = std::min(least, (c - p).norm());
            return least;
        };
        const Vec3 size = box.size();
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {0.0, 1.0}) {
                if (lean == 0 && axis == 2 && side == 0) continue; // it stands on it
                for (double a = 0.05; a < 1; a += 0.15)
                    for (double b = 0.05; b < 1; b += 0.15) {
                        Vec3 share(a, a, a);
                        share[(axis + 1) % 3] = b;
                        share[axis] = side;
                        const Vec3 p = box.lo + share.cwiseProduct(size);
                        QVERIFY2(nearest_centre(p) <= 3 + 1.05 * s.tolerance,
                                 qPrintable(QString("%1 %2 %3").arg(p.x()).arg(p.y()).arg(p.z())));
                    }
            }
        QCOMPARE(std::count_if(path.warnings.begin(), path.warnings.end(),
                               [](const std::string& w) {
                                   return w.starts_with("cannot be reached: 64 mm²")
                                          && w.find("faces down") != std::string::npos;
                               }),
                 lean == 0 ? 1 : 0);
        const Verification v =
            judged(part, context, linked(path, context, op), s.tolerance, path.chord_tolerance);
        QVERIFY(!v.gouged());
        // Every contact point can be studied again in the view in which it was planned.
        const auto record = path.five_axis();
        QVERIFY(record->pieces.size() >= 5);
        const std::size_t last = record->points.size() - 1;
        const FiveAxisStudy study(record, Progress());
        const FiveAxisStudy::Point point = study.point(last, Progress());
        QVERIFY(point.planned.free && point.chosen[2].free);
        QCOMPARE(study.reason(point, point.planned.posture.lead, point.planned.posture.yaw).block,
                 PostureBlock::free);
    }

    /// From above alone the walls stay; a part that has none is planned as it always was.
    void from_above_if_asked_or_if_there_is_no_other_side() {
        const Mesh plate = facetmill::test::box(Vec3(-8, -2, 0), Vec3(8, 2, 12));
        PlanContext context = five_axis_context(plate, with_holder(ball_tool(6)));
        context.machine = find_machine("trunnion-ac");
        Finish5Settings s = settings(0.3, Choice::cm2);
        s.sides = Finish5Settings::Sides::top;
        for (const Pass& pass : Finish5(s).plan(context, Progress()).passes)
            for (const CutterContact& c : pass.cc)
                QVERIFY(c.point.z() > 5);
        const PlanContext field = five_axis_context(sheet("bend"), cutter("ball"));
        const StrategyResult top = Finish5(s).plan(field, Progress());
        s.sides = Finish5Settings::Sides::automatic;
        QCOMPARE(numbers(Finish5(s).plan(field, Progress())), numbers(top));
    }

    void no_tool_lies_down() {
        const Mesh part = sheet("cap");
        const PlanContext context = five_axis_context(part, ball_tool(6));
        for (const Choice choice : {Choice::cm2, Choice::local, Choice::global}) {
            Finish5Settings s = settings(0.2, choice);
            s.lead_limits = {radians(70), radians(85)};
            s.yaw_limits = {radians(-90), radians(90)};
            const Finish5 op(s);
            const StrategyResult path = op.plan(context, Progress());
            for (const Pass& pass : path.passes)
                for (const CutterLocation& c : pass.cl)
                    QVERIFY(c.axis.z() >= tolerance::lowest_axis_z * (1 - 1e-9));
            QVERIFY(!linked(path, context, op).motions.empty());
        }
    }

    void what_cannot_be_cut_is_an_error_data() {
        QTest::addColumn<int>("number");
        for (int i = 0; i < 6; ++i)
            QTest::addRow("%d", i) << i;
    }
    void what_cannot_be_cut_is_an_error() {
        QFETCH(int, number);
        PlanContext context = five_axis_context(sheet("saddle"), cutter("flat"));
        Finish5Settings s = settings(0.1);
        std::string said, expected = "out_of_range", about;
        switch (number) {
        case 0:
            std::swap(s.lead_limits[0], s.lead_limits[1]);
            about = "lead_limits";
            break;
        case 1:
            std::swap(s.yaw_limits[0], s.yaw_limits[1]);
            about = "yaw_limits";
            break;
        case 2:
            s.grid_step = 0;
            about = "grid_degrees";
            break;
        case 3:
            s.tolerance = 0;
            about = "tolerance";
            break;
        case 4:
            context.machine = find_machine("generic-3-axis");
            expected = "empty_result";
            about = "machine";
            break;
        default:
            s.holder_clearance = 500;
            expected = "empty_result";
            about = "would hit the part";
        }
        QCOMPARE(code_of([&] { Finish5(s).plan(context, Progress()); }, &said), expected);
        QVERIFY2(said.find(about) != std::string::npos, said.c_str());
    }
};

FACETMILL_TEST(TestFinish5)
#include "test_finish5.moc"
