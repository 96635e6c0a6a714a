// Clean-up over parts whose valleys are known: all are found, nothing else is, on clean meshes and on noisy
// ones; what stays is what the smaller cutter cannot reach; nothing is cut into. Judged by the verifier and
// by a search over places of the cutter, which share no code with the planner.
#include "core/base/parallel.h"
#include "core/gouge/axial_lift.h"
#include "core/link/link.h"
#include "core/mesh/sample.h"
#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/surface/point_grid.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/property/valley_parts.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/path_numbers.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <map>
#include <tuple>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double tau = 0.05;

PlanContext cleanup_context(const Mesh& mesh, const Tool& tool, const Tool& previous) {
    PlanContext c = context_of(mesh, tool);
    c.further_tools = {previous};
    c.stock_box.hi.z() += 1; // as it is judged
    return c;
}

CleanupSettings cleanup_settings() {
    CleanupSettings s;
    s.tolerance = tau;
    s.tool = 2;
    return s;
}

std::vector<std::vector<Vec3>> centers(const StrategyResult& path) {
    std::vector<std::vector<Vec3>> all;
    for (const Strip& s : path.strips)
        all.insert(all.end(), s.centers.begin(), s.centers.end());
    return all;
}

/// What a ball with vertical axis could still take away: by all places that it may take without cutting into
/// the part, on a lattice and, about the best of these, between.
class BallPlaces {
public:
    BallPlaces(const AxialLift& lift, double r, const Box3& box) : lift_(lift), r_(r), cell_(0.05 * r) {
        lo_ = box.lo.head<2>() - Vec2::Constant(r);
        const Vec2 size = box.hi.head<2>() - box.lo.head<2>() + Vec2::Constant(2 * r);
        columns_ = long(size.x() / cell_) + 1;
        rows_ = long(size.y() / cell_) + 1;
        z_.resize(std::size_t(columns_ * rows_));
        std::vector<Vec2> all;
        for (long j = 0; j < rows_; ++j)
            for (long i = 0; i < columns_; ++i)
                all.push_back(place(i, j));
        lift_.tip_z(all, z_, Progress());
    }

    /// How deep in the ball the stretch from p to q lies where it lies deepest: what stands along it the
    /// cutter could remove with so much to spare. Not above 0: it cannot remove it.
    double deepest(const Vec3& p, const Vec3& q) const {
        constexpr double accuracy = 0.002; // of the radius: a tenth of the tolerance that is asked for
        std::array<std::pair<double, Vec2>, 4> best;
        best.fill({-infinity, Vec2::Zero()});
        const Vec2 from = p.head<2>().cwiseMin(q.head<2>()) - Vec2::Constant(r_) - lo_,
                   to = p.head<2>().cwiseMax(q.head<2>()) + Vec2::Constant(r_) - lo_;
        const long i0 = std::max(0l, long(from.x() / cell_)), j0 = std::max(0l, long(from.y() / cell_)),
                   i1 = std::min(columns_ - 1, long(to.x() / cell_) + 1),
                   j1 = std::min(rows_ - 1, long(to.y() / cell_) + 1);
        for (long j = j0; j <= j1; ++j)
            for (long i = i0; i <= i1; ++i) {
                const double d = depth(p, q, place(i, j), z_[std::size_t(j * columns_ + i)]);
                if (d <= best.back().first) continue;
                best.back() = {d, place(i, j)};
                for (std::size_t k = best.size() - 1; k > 0 && best[k].first > best[k - 1].first; --k)
                    std::swap(best[k], best[k - 1]);
            }
        double most = -infinity;
        LiftHint hint;
        for (auto [d, at] : best) {
            if (!(d > -r_)) continue;
            for (double step = cell_; step > accuracy * r_;) {
                const Vec2 middle = at;
                bool better = false;
                for (int k = 0; k < 8; ++k) {
                    const double angle = 2 * pi * k / 8;
                    const Vec2 there = middle + step * Vec2(std::cos(angle), std::sin(angle));
                    const double e = depth(p, q, there, lift_.tip_z(there.x(), there.y(), hint));
                    if (!(e > d)) continue;
                    d = e;
                    at = there;
                    better = true;
                }
                if (!better) step *= 0.5;
            }
            most = std::max(most, d);
        }
        return most;
    }

private:
    Vec2 place(long i, long j) const { return lo_ + cell_ * Vec2(double(i), double(j)); }

    /// The radius less the distance of the stretch from the half line up from the ball's middle.
    double depth(const Vec3& p, const Vec3& q, const Vec2& at, double z) const {
        if (!(z > -infinity)) return -infinity;
        const Vec3 a = p - Vec3(at.x(), at.y(), z + r_), d = q - p;
        const auto from_line = [&](double t) {
            const Vec3 x = a + std::clamp(t, 0.0, 1.0) * d;
            return x.z() >= 0 ? x.head<2>().norm() : x.norm();
        };
        const double square = d.squaredNorm(), level = d.head<2>().squaredNorm();
        double least = std::min(from_line(0), from_line(1));
        // Nearest to the middle, and to the line through it.
        if (square > 0) least = std::min(least, from_line(-a.dot(d) / square));
        if (level > 0) least = std::min(least, from_line(-a.head<2>().dot(d.head<2>()) / level));
        return r_ - least;
    }

    const AxialLift& lift_;
    double r_, cell_;
    Vec2 lo_;
    long columns_ = 0, rows_ = 0;
    std::vector<double> z_;
};

/// Under a sanitizer the smallest says enough.
const std::vector<ValleyPart>& parts() {
    static const std::vector<ValleyPart> all =
        under_sanitizer ? std::vector<ValleyPart>{corner_part()}
                        : std::vector{mould_part(), corner_part(), ring_part(), pillar_part(), gap_part()};
    return all;
}

/// A part of the list planned once, for all tests that look at the same plan.
struct PlannedPart {
    PlanContext context;
    Cleanup op;
    StrategyResult path;
};
const PlannedPart& planned(int part, bool noisy, bool along_z) {
    static std::map<std::tuple<int, bool, bool>, PlannedPart> known;
    PlannedPart& p = known[{part, noisy, along_z}];
    if (p.context.part) return p;
    const ValleyPart& v = parts()[std::size_t(part)];
    // Long enough for a full block.
    Tool tool = ball_tool(v.diameter);
    tool.flute_length = std::max(tool.flute_length, v.mesh.box().size().z() + 20);
    p.context = cleanup_context(noisy ? scanned(v.mesh, 0.4 * v.diameter, 0.01, 7) : v.mesh, tool,
                                ball_tool(v.previous));
    CleanupSettings s = cleanup_settings();
    if (along_z) s.lift = CleanupSettings::Lift::z;
    p.op = Cleanup(s);
    p.path = p.op.plan(p.context, Progress());
    return p;
}

} // namespace

class TestCleanup : public QObject {
    Q_OBJECT
private slots:
    void every_valley_is_found_and_nothing_else_data() {
        QTest::addColumn<int>("part");
        QTest::addColumn<bool>("noisy");
        const auto& all = parts();
        for (int i = 0; i < int(all.size()); ++i)
            for (const bool noisy : {false, true})
                if (all_cases || noisy == (i % 3 == 1))
                    QTest::addRow("%s%s", all[std::size_t(i)].name.c_str(), noisy ? " noisy" : "")
                        << i << noisy;
    }

    /// At least 99 % of the length of known valleys lie beside a centre, at most 1 % of the length of centres
    /// lies beside none.
    void every_valley_is_found_and_nothing_else() {
        QFETCH(int, part);
        QFETCH(bool, noisy);
        const ValleyPart& known = parts()[std::size_t(part)];
        const StrategyResult& path = planned(part, noisy, false).path;
        const auto found = centers(path);
        const double beside = noisy ? known.beside_noisy : known.beside;
        std::size_t missed = 0, wrong = 0;
        double worst = 0;
        const auto places = places_along(known.valleys, 0.2);
        Vec3 miss = Vec3::Zero(), stray = Vec3::Zero();
        for (const Vec3& p : places)
            if (const double d = distance_to(found, p); d > beside) {
                ++missed;
                if (d > worst) miss = p;
                worst = std::max(worst, d);
            }
        const auto center_places = places_along(found, 0.2);
        for (const Vec3& p : center_places)
            if (distance_to(known.valleys, p) > beside) {
                ++wrong;
                stray = p;
            }
        const QString figures = QString("%1 of %2 missed, by up to %3 at (%4, %5, %6); %7 of %8 wrong, at "
                                        "(%9, %10, %11); %12 strips")
                                    .arg(missed)
                                    .arg(places.size())
                                    .arg(worst)
                                    .arg(miss.x())
                                    .arg(miss.y())
                                    .arg(miss.z())
                                    .arg(wrong)
                                    .arg(center_places.size())
                                    .arg(stray.x())
                                    .arg(stray.y())
                                    .arg(stray.z())
                                    .arg(path.strips.size());
        qInfo("%s", qPrintable(figures));
        QVERIFY2(double(missed) <= 0.01 * double(places.size()), qPrintable(figures));
        QVERIFY2(double(wrong) <= 0.01 * double(center_places.size()), qPrintable(figures));
    }

    /// Every band is one piece without holes, or a ring round a closed valley: where two meet, neither has
    /// islands in the other.
    void bands_are_whole() {
        for (int i = 0; i < int(parts().size()); ++i) {
            if (!all_cases && i % 3 == 1) continue; // only the noisy ones are planned
            for (const Strip& strip : planned(i, false, false).path.strips) {
                if (strip.kind == StripKind::foot) continue; // has no curve
                const auto& center = strip.centers.at(0);
                const bool closed = (center.front() - center.back()).norm() < 1e-9;
                QVERIFY2(strip.boundaries.size() == (closed ? 2 : 1),
                         qPrintable(QString("%1, %2: %3 boundaries")
                                        .arg(parts()[std::size_t(i)].name.c_str(), strip.name.c_str())
                                        .arg(strip.boundaries.size())));
            }
        }
    }

    void only_what_no_cutter_reaches_stays_data() {
        QTest::addColumn<int>("part");
        QTest::addColumn<bool>("noisy");
        QTest::addColumn<bool>("along_z");
        const auto& all = parts();
        for (int i = 0; i < int(all.size()); ++i) {
            const std::string& name = all[std::size_t(i)].name;
            // Every run tries each part in one of the ways.
            const auto asked = [&](int way) { return all_cases || i % 3 == way; };
            const bool large = name == "mould" || name == "pillar";
            if (asked(0) || (large && asked(2))) QTest::addRow("%s", name.c_str()) << i << false << false;
            if (asked(1)) QTest::addRow("%s noisy", name.c_str()) << i << true << false;
            if (asked(2) && !large) QTest::addRow("%s along z", name.c_str()) << i << false << true;
        }
    }

    /// From a full block: of what stands over any sample of the bands the cutter could remove nothing with
    /// more than the tolerance to spare, wherever it stood. Where it can touch, that is what stands there;
    /// where it cannot, it is how much more stands than the least that it must leave. Noise is part of the
    /// surface. Not one sample may be over.
    void only_what_no_cutter_reaches_stays() {
        QFETCH(int, part);
        QFETCH(bool, noisy);
        QFETCH(bool, along_z);
        const auto& [context, op, path] = planned(part, noisy, along_z);
        const Mesh& mesh = *context.part;
        const Tool& tool = context.tool;
        for (const auto& w : path.warnings)
            qInfo("%s", w.c_str());
        StockSolid stock;
        stock.box = mesh.box();
        stock.box.hi.z() += 1;
        const VerifyProgram program{
            "C",
            VerifyTool(tool),
            std::make_shared<ToolMotions>(link_operation(op, path, context, Progress())),
            {}};
        VerifySettings v;
        v.resolution = 1;
        const std::string& name = parts()[std::size_t(part)].name;
        v.sample_spacing = name == "pillar" || name == "mould" ? 1.2 : 0.8; // large ones
        v.tolerance = tau;
        v.gouge_limit = path.chord_tolerance;
        const Verification judged = verify(mesh, stock, {&program, 1}, v, Progress());
        QVERIFY2(!judged.gouged(),
                 qPrintable(QString("%1 %2").arg(judged.figures.gouge_max).arg(judged.border.gouge_max)));
        QVERIFY(judged.collisions.empty());

        PointGrid band(0.5);
        std::vector<Vec3> band_normals;
        for (const Strip& strip : path.strips)
            for (const auto& t : strip.band) {
                const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
                for (const Vec3& c : t) {
                    band.add(c);
                    band_normals.push_back(n);
                }
            }
        const AxialLift lift(context.contact, CutterProfile(tool.cutter()));
        const DeviationSurface& d = *judged.surface;
        std::size_t in_band = 0;
        std::vector<std::size_t> asked;
        for (std::size_t i = 0; i < d.points.size(); ++i) {
            if ((d.flags[i] & ~DeviationSurface::away) != 0) continue;
            const Vec3 p(d.points[i][0], d.points[i][1], d.points[i][2]);
            const Vec3 n(d.normals[i][0], d.normals[i][1], d.normals[i][2]);
            // What faces another way is another surface: the top beside a band that ends at its edge.
            if (!band.near_until(p, 0.25, [&](std::size_t c) {
                    return (band.points()[c] - p).norm() < 0.25 && std::abs(band_normals[c].dot(n)) > 0.5;
                }))
                continue;
            ++in_band;
            if (d.deviation[i] > tau) asked.push_back(i);
        }
        // A probe in a crease may run along the wall beside it: beyond a radius what it meets is another
        // place.
        const double radius = 0.5 * tool.diameter;
        const BallPlaces places(lift, radius, mesh.box());
        std::vector<double> spare(asked.size());
        parallel_for(asked.size(), 1, Progress(), [&](std::size_t k) {
            const auto &p = d.points[asked[k]], &n = d.normals[asked[k]];
            const Vec3 point(p[0], p[1], p[2]), normal(n[0], n[1], n[2]);
            spare[k] =
                places.deepest(point, point + std::min(double(d.deviation[asked[k]]), radius) * normal);
        });
        // Beside a band, where the previous ball leaves no more than the tolerance, it need not be cut again.
        if (std::any_of(spare.begin(), spare.end(), [](double s) { return s > tau; })) {
            const Tool& previous = context.further_tools.front();
            const AxialLift before(context.contact, CutterProfile(previous.cutter()));
            const BallPlaces by_previous(before, 0.5 * previous.diameter, mesh.box());
            for (std::size_t k = 0; k < asked.size(); ++k) {
                const auto& p = d.points[asked[k]];
                const Vec3 point(p[0], p[1], p[2]);
                if (spare[k] > tau) spare[k] = std::min(spare[k], -by_previous.deepest(point, point));
            }
        }
        std::size_t over = 0;
        double most = 0;
        Vec3 where = Vec3::Zero(), facing = Vec3::Zero();
        for (std::size_t k = 0; k < asked.size(); ++k) {
            over += spare[k] > tau;
            if (spare[k] <= most) continue;
            most = spare[k];
            const auto &p = d.points[asked[k]], &n = d.normals[asked[k]];
            where = Vec3(p[0], p[1], p[2]);
            facing = Vec3(n[0], n[1], n[2]);
        }
        const QString figures =
            QString("%1 of %2 on the bands over, by up to %3 at (%4, %5, %6), normal z %9; expected %7; "
                    "%8 passes")
                .arg(over)
                .arg(in_band)
                .arg(most)
                .arg(where.x())
                .arg(where.y())
                .arg(where.z())
                .arg(path.cusp_max)
                .arg(path.passes.size())
                .arg(facing.z());
        qInfo("%s", qPrintable(figures));
        QVERIFY2(in_band > 300, qPrintable(figures));
        QVERIFY2(over == 0, qPrintable(figures));
    }

    void a_tool_that_fits_everywhere_leaves_nothing() {
        const Mesh flat = height_field([](double x, double y) { return 0.01 * (x * x + y * y); },
                                       Vec2(-20, -15), Vec2(20, 15), 40, 30);
        const PlanContext context = cleanup_context(flat, ball_tool(4), ball_tool(12));
        QCOMPARE(code_of([&] { Cleanup(cleanup_settings()).plan(context, Progress()); }),
                 std::string("empty_result"));
        PlanContext without = context;
        without.further_tools.clear();
        QCOMPARE(code_of([&] { Cleanup(cleanup_settings()).plan(without, Progress()); }),
                 std::string("missing_reference"));
    }

    void threads_do_not_change_a_bit() {
        const ValleyPart known = corner_part();
        const PlanContext context = cleanup_context(known.mesh, ball_tool(4), ball_tool(12));
        set_thread_count(1);
        const auto one = path_numbers(Cleanup(cleanup_settings()).plan(context, Progress()));
        set_thread_count(0);
        const auto many = path_numbers(Cleanup(cleanup_settings()).plan(context, Progress()));
        QVERIFY(one == many);
    }

    void it_can_be_cancelled_at_any_time() {
        const ValleyPart known = corner_part();
        const PlanContext context = cleanup_context(known.mesh, ball_tool(4), ball_tool(12));
        for (int i = 0; i < 10; ++i) {
            Job job;
            QVERIFY(cancelled_at(job, 0.1 * i,
                                 [&](const Progress& p) { Cleanup(cleanup_settings()).plan(context, p); }));
        }
    }

    void every_cutter_shape_cleans_up() {
        const ValleyPart known = corner_part();
        for (const ShapedTool& shaped : tools_of_every_shape()) {
            if (under_sanitizer && shaped.tool.corner_radius < 1) continue; // ball and bull nose say enough
            const Tool previous = ball_tool(14);
            const Tool tool = shaped.tool;
            const PlanContext context = cleanup_context(known.mesh, tool, previous);
            // Sharp rims need so many passes that a wider tolerance says as much.
            CleanupSettings s = cleanup_settings();
            if (tool.corner_radius < 1) s.tolerance = 3 * tau;
            const Cleanup op(s);
            const StrategyResult path = op.plan(context, Progress());
            QVERIFY2(!path.passes.empty(), shaped.name);
            // No tip is below the lift.
            const AxialLift lift(context.contact, CutterProfile(tool.cutter()));
            for (const Motion& m : link_operation(op, path, context, Progress()).motions)
                QVERIFY2(m.to.tip.z() >= lift.tip_z(m.to.tip.x(), m.to.tip.y()) - 1e-6, shaped.name);
        }
    }
};

FACETMILL_TEST(TestCleanup)
#include "test_cleanup.moc"
