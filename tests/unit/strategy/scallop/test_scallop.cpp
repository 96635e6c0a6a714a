// Constant scallop against closed forms, and against balls swept along the path point by point: how high the
// crests between its passes are, everywhere.
#include "core/strategy/scallop/field_distances.h"
#include "core/strategy/scallop/middle_lines.h"
#include "core/strategy/scallop/scallop.h"
#include "core/strategy/scallop/scallop_field.h"
#include "tests/property/shapes.h"
#include "tests/support/any_threads.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/naive_finish.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

ScallopSettings scallop_settings(double tolerance) {
    ScallopSettings s;
    s.tolerance = tolerance;
    return s;
}

using From = ScallopSettings::From;

/// A line across the middle that comes from outside of the part.
const PlanCurve across{{Vec2(-20, -6), Vec2(-3, 0), Vec2(4, 1), Vec2(8, 7)}, false};

StrategyResult planned_on(const Mesh& mesh, const ScallopSettings& settings, const Tool& tool,
                          const PlanCurve& curve = across) {
    PlanContext context = context_of(mesh, tool);
    if (settings.from == From::curve) context.curves = {{"Line", {curve}}};
    return Scallop(settings).plan(context, Progress());
}

double distance_from(const PlanCurve& curve, const Vec2& p) {
    double nearest = infinity;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const Vec2 a = curve.points[i - 1], d = curve.points[i] - a;
        nearest =
            std::min(nearest, (p - a - std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm());
    }
    return nearest;
}

/// What a ball leaves over points of the part: their distance from where its middle goes, less its radius.
class BallSweep {
public:
    BallSweep(const StrategyResult& path, double radius) : radius_(radius) {
        std::vector<Box3> boxes;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 1; i < pass.cl.size(); ++i) {
                const Vec3 up(0, 0, radius);
                pieces_.push_back({pass.cl[i - 1].tip + up, pass.cl[i].tip + up});
                boxes.emplace_back();
                boxes.back().add(pieces_.back()[0]);
                boxes.back().add(pieces_.back()[1]);
            }
        tree_ = BoxTree(boxes, Progress());
    }
    double left_over(const Vec3& p) const {
        double near2 = infinity;
        tree_.nearest(p, near2, [&](std::size_t i) {
            const auto& [a, b] = pieces_[i];
            const double t =
                std::clamp((p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-30), 0.0, 1.0);
            near2 = std::min(near2, (a + t * (b - a) - p).squaredNorm());
        });
        return std::max(0.0, std::sqrt(near2) - radius_);
    }

private:
    std::vector<std::array<Vec3, 2>> pieces_;
    BoxTree tree_;
    double radius_;
};

/// Heights of the crests: for places of a square all over a surface the highest within `reach`.
template <class Height>
std::vector<double> crests(const Height& height, double half, double reach, const BallSweep& sweep) {
    const double spacing = 0.12 * reach;
    const int n = int(2 * half / spacing), window = int(reach / spacing);
    std::vector<double> left(std::size_t(n) * std::size_t(n)), all;
    const auto at = [&](int i, int j) -> double& {
        return left[std::size_t(i) * std::size_t(n) + std::size_t(j)];
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = -half + i * spacing, y = -half + j * spacing;
            at(i, j) = sweep.left_over(Vec3(x, y, height(x, y)));
        }
    for (int i = window; i + window < n; i += 2)
        for (int j = window; j + window < n; j += 2) {
            double most = 0;
            for (int a = i - window; a <= i + window; ++a)
                for (int b = j - window; b <= j + window; ++b)
                    most = std::max(most, at(a, b));
            all.push_back(most);
        }
    std::sort(all.begin(), all.end());
    return all;
}

double hill(double x, double y) {
    return 5 * std::exp(-(x * x + y * y) / 40) + 0.8 * std::sin(0.5 * x) * std::cos(0.4 * y);
}
double saddle(double x, double y) {
    return 0.03 * (x * x - y * y);
}

/// The field of a ball of 6 mm that leaves cusps of 0.05 mm.
struct FieldOfBall {
    FieldOfBall(const Mesh& mesh, double spacing, double beyond)
        : context(context_of(mesh, ball_tool(6))), tell(context.contact, cover, mesh.facet_count(), 0),
          field(lift, tell, steps, mesh.box(),
                {.steepest = radians(70), .beyond = beyond, .spacing = spacing}, {}) {}

    PlanContext context;
    CutterProfile profile{context.tool.cutter()};
    CutterCover cover{profile, 0.01};
    AxialLift lift{context.contact, profile, 0};
    TouchTeller tell;
    ScallopSteps steps{cover, 0.05, {}};
    ScallopField field;
};

} // namespace

class TestScallop : public QObject {
    Q_OBJECT
private slots:
    void it_is_described() {
        const auto op = make_operation("scallop");
        std::set<std::string> keys;
        for (const ParameterInfo* p : op->parameters()) {
            keys.insert(p->key);
            QVERIFY2(!p->label.empty() && !p->help.empty(), p->key.c_str());
            QVERIFY2(op->get(p->key) == p->default_value, p->key.c_str());
        }
        for (const char* key : {"tolerance", "from", "place", "slope_limit", "stepover", "boundary", "avoid"})
            QVERIFY2(keys.count(key) == 1, key);
        QVERIFY(op->three_axis() && op->reads_stock() && op->linking() == Linking::upright);
    }

    /// A ball leaves r - sqrt(r^2 - d^2/4) whichever way; the rim of a flat end, drawn down a slope, a tilted
    /// circle.
    void steps_are_closed_forms() {
        constexpr double cusp = 0.05;
        const CutterProfile ball(AptCutter::ball(6, 50)), flat(AptCutter::flat(6, 50));
        const CutterCover round(ball, 0), sharp(flat, 0);
        const ScallopSteps by_ball(round, cusp, {}), by_flat(sharp, cusp, {});
        const double apart = 2 * std::sqrt(2 * 3 * cusp - cusp * cusp);
        for (double slope = 0; slope < radians(75); slope += radians(5)) {
            QVERIFY(std::abs(by_ball.down(slope).apart - apart) < 2e-3 * apart);
            QVERIFY(std::abs(by_ball.across(slope).apart - apart) < 2e-3 * apart);
            QVERIFY(std::abs(by_ball.across(slope).power - 0.5) < 0.02);
            if (slope < radians(14)) continue;
            const double deep = cusp / std::sin(slope), side = 2 * std::sqrt(2 * 3 * deep - deep * deep);
            QVERIFY2(
                std::abs(by_flat.across(slope).apart - side) < 0.02 * side,
                qPrintable(QString("%1: %2 for %3").arg(slope).arg(by_flat.across(slope).apart).arg(side)));
            QVERIFY(by_flat.down(slope).power > 0.9);
        }
    }

    /// On a tilted plane steps are lengths over it, whichever way.
    void distances_on_a_plane_are_lengths() {
        const Mesh plane =
            height_field([](double x, double) { return 0.7 * x; }, Vec2(-12, -12), Vec2(12, 12), 6, 6);
        const FieldOfBall on(plane, 0.3, 4);
        const ScallopField& field = on.field;
        const std::size_t middle = field.nearest(Vec3::Zero());
        const std::vector<double> d = field_distances(field.grid(), {{middle, 0}}, {});
        const double step = on.steps.down(0).apart;
        int looked = 0;
        for (std::size_t i = 0; i < field.size(); ++i) {
            const Vec2 by = field.place(i) - field.place(middle);
            if (!field.cut(i) || by.norm() < 3 || by.cwiseAbs().maxCoeff() > 7) continue;
            const double length = std::hypot(std::hypot(by.x(), by.y()), 0.7 * by.x());
            QVERIFY2(std::abs(d[i] * step - length) < 0.03 * length,
                     qPrintable(QString("%1 for %2").arg(d[i] * step).arg(length)));
            ++looked;
        }
        QVERIFY(looked > 500);
    }

    void crests_are_as_high_everywhere_data() {
        QTest::addColumn<int>("surface");
        QTest::addColumn<int>("from");
        QTest::addColumn<double>("noise");
        QTest::addColumn<bool>("spiral");
        if (!under_sanitizer) { // what the others do holds what these do, and passes from a curve are below
            QTest::newRow("hill from a curve") << 0 << int(From::curve) << 0.0 << false;
            QTest::newRow("hill") << 0 << int(From::border) << 0.0 << false;
            QTest::newRow("hill from a place") << 0 << int(From::place) << 0.0 << false;
            QTest::newRow("saddle") << 1 << int(From::border) << 0.0 << false;
        }
        QTest::newRow("noisy hill") << 0 << int(From::border) << 0.002 << false;
        QTest::newRow("spiral on a hill") << 0 << int(From::place) << 0.0 << true;
    }
    void crests_are_as_high_everywhere() {
        QFETCH(int, surface);
        QFETCH(int, from);
        QFETCH(double, noise);
        QFETCH(bool, spiral);
        const auto height = surface == 0 ? hill : saddle;
        Random rng(9);
        const Mesh mesh =
            height_field([&](double x, double y) { return height(x, y) + uniform(rng, -noise, noise); },
                         Vec2(-11, -11), Vec2(11, 11), 88, 88);
        ScallopSettings s = scallop_settings(0.05);
        s.spiral = spiral;
        s.from = From(from);
        s.place = {0, 0, 5};
        const Tool tool = ball_tool(6);
        const StrategyResult path = planned_on(mesh, s, tool);
        QVERIFY(path.passes.size() > 5);
        // The longest pass of a spiral has turns enough for most of the surface; a ring goes round it once.
        double longest = 0;
        for (const Pass& pass : path.passes)
            longest = std::max(longest, arc_lengths(pass).back());
        QVERIFY2((longest > 200) == spiral, qPrintable(QString::number(longest)));
        const BallSweep sweep(path, 3);
        const std::vector<double> high = crests(height, 9, 0.7, sweep);
        const double p50 = high[high.size() / 2], p99 = high[high.size() * 99 / 100];
        std::vector<double> all;
        for (double x = -9; x < 9; x += 0.09)
            for (double y = -9; y < 9; y += 0.09)
                all.push_back(sweep.left_over(Vec3(x, y, height(x, y))));
        std::sort(all.begin(), all.end());
        const double p999 = all[all.size() * 999 / 1000];
        const QString text = QString("crests: p50 %1, p99 %2, most %3; places: p99.9 %4; %5 passes")
                                 .arg(p50)
                                 .arg(p99)
                                 .arg(high.back())
                                 .arg(p999)
                                 .arg(path.passes.size());
        QVERIFY2(p99 <= 1.3 * p50, qPrintable(text));
        QVERIFY2(p50 > 0.85 * 0.05, qPrintable(text));
        QVERIFY2(p999 <= 1.05 * 0.05, qPrintable(text));
        const Naive naive = naive_check(mesh, path, tool, 0.05, [](const PartSample&) { return false; });
        QCOMPARE(naive.gouged, std::size_t(0));
    }

    /// Passes lie on a curve and beside it; what of it lies off the part is passed over.
    void passes_begin_at_a_curve() {
        const Mesh mesh = height_field(hill, Vec2(-11, -11), Vec2(11, 11), 44, 44);
        ScallopSettings s = scallop_settings(0.1);
        s.from = From::curve;
        const StrategyResult path = planned_on(mesh, s, ball_tool(6));
        double on_curve = 0;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 1; i < pass.cl.size(); ++i) {
                const Vec2 a = pass.cl[i - 1].tip.head<2>(), b = pass.cl[i].tip.head<2>();
                if (distance_from(across, a) < 0.02 && distance_from(across, b) < 0.02)
                    on_curve += (b - a).norm();
            }
        // From the rim, or as far beside it as the cutter still touches.
        double length = 0;
        for (std::size_t i = 1; i < across.points.size(); ++i)
            length += (across.points[i] - across.points[i - 1]).norm();
        QVERIFY2(on_curve > length - 12 && on_curve < length - 8, qPrintable(QString::number(on_curve)));

        std::string message;
        const PlanCurve off{{Vec2(-40, -60), Vec2(-30, 0)}, false};
        QCOMPARE(code_of([&] { planned_on(mesh, s, ball_tool(6), off); }, &message),
                 std::string("out_of_range"));
        QVERIFY2(message.find("Line") != std::string::npos, message.c_str());

        // A closed one is gone round, unless it is to end at its last corner.
        const PlanCurve ring{{Vec2(-5, -5), Vec2(5, -5), Vec2(5, 5), Vec2(-5, 5)}, true};
        const auto along_last = [&] {
            double most = 0;
            for (const Pass& pass : planned_on(mesh, s, ball_tool(6), ring).passes)
                for (const CutterLocation& c : pass.cl)
                    if (std::abs(c.tip.x() + 5) < 0.02)
                        most = std::max(most, std::abs(5 - std::abs(c.tip.y())));
            return most;
        };
        QVERIFY(along_last() > 4);
        s.open = true;
        QVERIFY(along_last() < 1);
    }

    /// In the corners of squares within each other the cutter goes out and back: hardly any line more than
    /// the squares, and hardly longer.
    void corners_are_reached_from_the_lines() {
        const Mesh plane =
            height_field([](double, double) { return 0.0; }, Vec2(-11, -11), Vec2(11, 11), 4, 4);
        const StrategyResult path = planned_on(plane, scallop_settings(0.05), ball_tool(6));
        double length = 0;
        for (const Pass& pass : path.passes)
            length += arc_lengths(pass).back();
        const double step = 2 * std::sqrt(2 * 3 * 0.05), squares = 22 / (2 * step);
        QVERIFY2(double(path.passes.size()) < squares + 6, qPrintable(QString::number(path.passes.size())));
        QVERIFY2(length < 1.25 * 22 * 22 / step, qPrintable(QString::number(length)));
        const BallSweep sweep(path, 3);
        std::vector<double> all;
        for (double x = -10.9; x < 11; x += 0.1)
            for (double y = -10.9; y < 11; y += 0.1)
                all.push_back(sweep.left_over(Vec3(x, y, 0)));
        std::sort(all.begin(), all.end());
        QVERIFY2(all[all.size() * 999 / 1000] <= 1.05 * 0.05 && all.back() < 1.2 * 0.05,
                 qPrintable(QString("%1, %2").arg(all[all.size() * 999 / 1000]).arg(all.back())));
    }

    /// Sheets that go through each other, with facets twice and a hole, under cutters of every shape.
    void meshes_may_be_broken() {
        Mesh mesh = height_field(hill, Vec2(-8, -8), Vec2(8, 8), 32, 32);
        const Mesh other = height_field([](double x, double y) { return 1.5 + 0.2 * x - 0.1 * y; },
                                        Vec2(-8, -8), Vec2(8, 8), 5, 5);
        const auto first = Index(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const auto& f : other.facets) {
            mesh.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
            mesh.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
        }
        mesh.facets.erase(mesh.facets.begin() + 700, mesh.facets.begin() + 760);
        for (const Tool& tool : {ball_tool(6), bull_tool(6, 1), flat_tool(5)}) {
            if (under_sanitizer && tool.corner_radius != 1) continue; // balls and flat ends have other parts
            const double tolerance = tool.corner_radius > 0 ? 0.1 : 0.3;
            const StrategyResult path = planned_on(mesh, scallop_settings(tolerance), tool);
            const Naive naive =
                naive_check(mesh, path, tool, tolerance, [](const PartSample&) { return false; });
            QCOMPARE(naive.gouged, std::size_t(0));
            // Wherever a tip touches something less steep than the limit, so much is cut away over it.
            const PlanContext context = context_of(mesh, tool);
            const CutterProfile profile(context.tool.cutter());
            const CutterCover cover(profile, 0.01);
            const AxialLift lift(context.contact, profile, 0);
            const TouchTeller tell(context.contact, cover, mesh.facet_count(), 0);
            const BruteCutter cutter(tool.cutter());
            const std::vector<Vec3> tips = tips_of(path, 0.1);
            const TipTree tree(tips, double(cutter.radius()));
            int looked = 0, high = 0;
            const double apart = under_sanitizer ? 0.27 : 0.09;
            for (double x = -8; x < 8; x += apart)
                for (double y = -8; y < 8; y += apart) {
                    const TipTouch touch = tell(Vec2(x, y), lift.contact(x, y));
                    if (!touch.any || !touch.surface || touch.slope() > radians(65)) continue;
                    const Vec3 over = touch.point + 1.1 * tolerance * touch.normal;
                    ++looked;
                    high += !tree.any(over, [&](const Vec3& tip) { return holds(cutter, tip, over, 0); });
                }
            // Sharp rims leave more on small facets; that is said, and is little.
            const bool named =
                std::any_of(path.warnings.begin(), path.warnings.end(), [](const std::string& w) {
                    return w.find("leave more than expected") != std::string::npos;
                });
            QVERIFY2(
                looked > trials(20000) && (high <= looked / 1000 || (named && high <= looked / 200)),
                qPrintable(
                    QString("%1 of %2 under a corner of %3").arg(high).arg(looked).arg(tool.corner_radius)));
        }
    }

    /// What is wide becomes a line in its middle: a bar, a ring, a spot.
    void middles_are_lines() {
        const Mesh plane = height_field([](double, double) { return 0.0; }, Vec2(-9, -9), Vec2(9, 9), 4, 4);
        const FieldOfBall on(plane, 0.2, 1);
        const ScallopField& field = on.field;
        std::vector<char> marks(field.size(), 0);
        std::vector<double> heights(field.size(), 0);
        const std::size_t top = field.nearest(Vec3(-6.4, -6.2, 0));
        heights[top] = 1;
        for (std::size_t i = 0; i < field.size(); ++i) {
            const Vec2 p = field.place(i);
            const bool bar = std::abs(p.x()) < 6 && std::abs(p.y() - 7) < 0.7;
            const bool ring = std::abs(p.norm() - 4) < 0.7;
            const bool spot = (p - Vec2(-6.5, -6.5)).norm() < 0.7;
            marks[i] = bar || ring || spot;
        }
        const auto lines = middle_lines(field, heights, marks, 2, {});
        QCOMPARE(lines.size(), std::size_t(3));
        std::size_t closed = 0, bars = 0, spots = 0;
        for (const FieldContour& line : lines) {
            closed += line.closed;
            double length = 0;
            for (std::size_t i = 1; i < line.places.size(); ++i)
                length += (line.places[i] - line.places[i - 1]).norm();
            for (const Vec2& p : line.places) {
                if (line.closed) QVERIFY(std::abs(p.norm() - 4) < 0.3);
                if (!line.closed && length > 2) QVERIFY(std::abs(p.y() - 7) < 0.3);
            }
            if (!line.closed && length > 9 && length < 12.5) ++bars;
            if (!line.closed && length < 1 && (line.places[1] - field.place(top)).norm() < 1e-9) ++spots;
        }
        QVERIFY(closed == 1 && bars == 1 && spots == 1);
    }

    /// A sheet is not cut beyond its rim, where the cutter would only roll over the edge; over an edge
    /// between two faces it is.
    void outer_edges_are_left_inner_ones_rolled_over() {
        const Mesh roof =
            height_field([](double x, double) { return -std::abs(x); }, Vec2(-9, -9), Vec2(9, 9), 2, 2);
        const StrategyResult path = planned_on(roof, scallop_settings(0.05), ball_tool(6));
        double rolled = 0, beyond = 0;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 0; i < pass.cl.size(); ++i) {
                const Vec3& tip = pass.cl[i].tip;
                if (std::abs(pass.cc[i].point.x()) < 0.01) rolled = std::max(rolled, pass.cc[i].normal.z());
                QVERIFY2(tip.z() > -10.6, "beside the part");
                // A tip that cuts the last of a face at 45 degrees stands 3 sin 45 outside of it.
                beyond = std::max(
                    beyond, std::max(std::abs(tip.x()) - 9 - 3 * std::sqrt(0.5), std::abs(tip.y()) - 9));
            }
        QVERIFY2(rolled > 0.9, qPrintable(QString::number(rolled)));
        // (what is nearly as steep as the face counts as it)
        QVERIFY2(beyond < 0.7, qPrintable(QString::number(beyond)));
    }

    /// Along a wall, whichever way it runs over the grid, a flat end cuts the floor up to it.
    void feet_of_walls_are_cut() {
        for (const double turn : {0.4, 0.0, 0.5 * pi}) {
            if (under_sanitizer && turn != 0.4) continue;
            const Mesh mesh = turned(step(0, 5), turn);
            const StrategyResult path = planned_on(mesh, scallop_settings(0.15), flat_tool(6));
            const BruteCutter cutter(flat_tool(6).cutter());
            const std::vector<Vec3> tips = tips_of(path, 0.02);
            const TipTree tree(tips, 3);
            for (const std::string& w : path.warnings)
                QVERIFY2(w.find("stays uncut") == std::string::npos, w.c_str());
            int high = 0;
            QString where;
            for (double along = -17; along < 17; along += 0.11)
                for (const double beside : {0.05, 0.2, 1.0, 2.9}) {
                    const Vec3 p = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * Vec3(along, beside, 1e-3);
                    if (tree.any(p, [&](const Vec3& tip) { return holds(cutter, tip, p, 0); })) continue;
                    ++high;
                    where += QString(" %1 %2,").arg(along).arg(beside);
                }
            QVERIFY2(high == 0, qPrintable(QString("turned by %1:").arg(turn) + where));
        }
    }

    /// Beside the part the flank of a tapered cutter touches its rim, and cuts nothing.
    void a_taper_does_not_go_down_beside_the_part() {
        const Mesh plane =
            height_field([](double, double) { return 3.0; }, Vec2(-15, -10), Vec2(15, 10), 4, 3);
        for (const Pass& pass :
             planned_on(plane, scallop_settings(0.15), tools_of_every_shape()[3].tool).passes)
            for (const CutterLocation& c : pass.cl)
                QVERIFY2(std::abs(c.tip.z() - 3) < 1e-6, qPrintable(QString::number(c.tip.z())));
    }

    /// The place is one of the setup, whichever way the tool comes.
    void a_place_is_the_setups() {
        const Mesh mesh = height_field(hill, Vec2(-11, -11), Vec2(11, 11), 22, 22);
        ScallopSettings s = scallop_settings(0.1);
        s.from = From::place;
        s.place = {0, 5, 0};
        PlanContext context = context_of(mesh, ball_tool(6));
        // The view's X is the setup's Y.
        context.to_setup << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        double nearest = infinity;
        for (const Pass& pass : Scallop(s).plan(context, Progress()).passes) {
            Box3 box;
            for (const CutterLocation& c : pass.cl)
                box.add(c.tip);
            if (box.size().head<2>().norm() < 4)
                nearest = std::min(nearest, (box.center().head<2>() - Vec2(5, 0)).norm());
        }
        QVERIFY2(nearest < 2, qPrintable(QString::number(nearest)));
    }

    void what_cannot_be_is_refused() {
        std::string message;
        ScallopSettings s = scallop_settings(0.05);
        QCOMPARE(code_of([&] { planned_on(cone_of(10, 40, 90), s, ball_tool(6)); }, &message),
                 std::string("empty_result"));
        QVERIFY2(message.find("70 degrees") != std::string::npos, message.c_str());
        s.stepover = {1e-7, ""};
        QCOMPARE(code_of([&] { planned_on(dome(12, 24), s, ball_tool(6)); }), std::string("limit_exceeded"));
    }

    void threads_change_nothing_and_it_can_be_cancelled() {
        const Mesh mesh = mixed();
        const ScallopSettings settings = scallop_settings(under_sanitizer ? 0.5 : 0.1);
        QVERIFY(same_with_any_threads([&] { return planned_on(mesh, settings, bull_tool(8, 2)); }));
        for (const double at : {0.1, 0.4, 0.7}) {
            Job job;
            const Scallop op(settings);
            QVERIFY(cancelled_at(job, at,
                                 [&](const Progress& p) { op.plan(context_of(mesh, ball_tool(8)), p); }));
        }
    }
};

FACETMILL_TEST(TestScallop)
#include "test_scallop.moc"
