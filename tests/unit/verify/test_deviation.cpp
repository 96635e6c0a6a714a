// What is left against the part, where the answer is known: cusps, planted gouges, spheres and cylinders, an
// axis that swings about the tip, shanks and holders in walls.
#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/mesh/sample.h"
#include "core/verify/deviation.h"
#include "core/verify/probes.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <map>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

struct Path {
    std::shared_ptr<ToolMotions> motions = std::make_shared<ToolMotions>();
    Path& to(const Vec3& tip, const Vec3& axis = Vec3::UnitZ(), MotionKind kind = MotionKind::cut) {
        motions->motions.push_back(
            {motions->motions.empty() ? MotionKind::rapid : kind, {tip, axis}, no_index, no_index});
        return *this;
    }
    Path& rapid(const Vec3& tip) { return to(tip, Vec3::UnitZ(), MotionKind::rapid); }
    VerifyProgram with(const AptCutter& cutter) const { return {"Path", VerifyTool(cutter), motions, {}}; }
    VerifyProgram with(const Tool& tool) const { return {"Path", VerifyTool(tool), motions, {}}; }
};

StockSolid block(const Box3& box) {
    StockSolid stock;
    stock.box = box;
    return stock;
}

StockSolid block_over(const Mesh& part, double margin) {
    Box3 box = part.box();
    box.lo.array() -= margin;
    box.hi.array() += margin;
    return block(box);
}

struct Outcome {
    SurfaceSamples samples;
    Probed probed;
    Verification verification;
};

bool says(const Verification& v, const std::string& words) {
    return std::any_of(v.remarks.begin(), v.remarks.end(), [&](auto& r) { return r.find(words) < r.size(); });
}

Outcome probe(const Mesh& part, const StockSolid& stock, const std::vector<VerifyProgram>& programs,
              double spacing, double allowance = 0, double tolerance = 0.05) {
    Outcome o;
    double radius = 0;
    for (const auto& p : programs)
        radius = std::max(radius, p.tool.cutter.max_radius());
    o.samples = sample_surface(part, spacing, 1'000'000, Progress());
    const MeshSight sight(part, Progress());
    flag_samples(o.samples, part, sight, radius, cutting_axes(programs, Progress()), Progress());
    o.verification.used.tolerance = tolerance;
    o.verification.used.gouge_limit = 1e-4;
    o.probed =
        probe_samples(o.samples, sight, stock, programs, {allowance, 1e-4, 2 * tolerance, 1e-4}, Progress());
    o.verification.program_gouges.assign(programs.size(), 0);
    fill_figures(o.verification, o.samples, o.probed, radius, Progress());
    return o;
}

Mesh plane(const Vec2& lo, const Vec2& hi, int cells = 1) {
    return height_field([](double, double) { return 0.0; }, lo, hi, cells, cells);
}

/// Parallel passes along x over the plane z = 0, `step` apart, tip at height z.
Path passes(double x, double y, double step, double z, int pieces) {
    Path path;
    double sign = -1;
    path.to(Vec3(-x, -y, z + 30));
    for (double at = -y; at <= y + 1e-9; at += step) {
        for (int i = 0; i <= pieces; ++i)
            path.to(Vec3(sign * x * (1 - 2.0 * i / pieces), at, z));
        sign = -sign;
    }
    return path;
}

Vec3 random_unit(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// All motions, one by one, cut finely where the axis turns.
std::vector<StraightMove> all_moves(const VerifyProgram& program, double reach, double bound) {
    const auto& motions = program.motions->motions;
    std::vector<StraightMove> moves;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (motions[i].kind == MotionKind::rapid) continue;
        straight_moves(motions[i > 0 ? i - 1 : 0].to, motions[i].to, program.turning, 0, 1, reach, bound,
                       moves);
    }
    return moves;
}

/// Whether the line p + t n may meet a box.
bool meets(const Box3& box, const Vec3& p, const Vec3& n) {
    constexpr double slack = 1e-6;
    double from = -infinity, to = infinity;
    for (int k = 0; k < 3; ++k) {
        const double a = box.lo[k] - slack - p[k], b = box.hi[k] + slack - p[k];
        if (n[k] == 0) {
            if (a > 0 || b < 0) return false;
        } else {
            from = std::max(from, std::min(a / n[k], b / n[k]));
            to = std::min(to, std::max(a / n[k], b / n[k]));
        }
    }
    return from <= to;
}

/// `boxes`: of the moves; a line that misses one is asked no further.
double lowest_of_all(const std::vector<StraightMove>& moves, const std::vector<Box3>& boxes,
                     const TurnedBody& body, const Vec3& p, const Vec3& n, double value) {
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < moves.size(); ++i)
        if (meets(boxes[i], p, n)) stretches.push_back(SweepRays(body, moves[i], n)(p));
    for (bool again = true; again;) {
        again = false;
        for (const Stretch& s : stretches) {
            if (s.empty() || s.lo >= value || s.hi < std::min(value, 0.0)) continue;
            value = s.lo;
            again = value < 0;
        }
    }
    return value;
}

} // namespace

class TestDeviation : public QObject {
    Q_OBJECT
private slots:
    void planes_support_the_body() {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> share(0, 1);
        for (const AptCutter& apt :
             {AptCutter::ball(10, 30), AptCutter::flat(8, 20), AptCutter::bull(12, 3, 25),
              AptCutter::cone(10, 0.5), AptCutter::tapered_ball(2, 0.2, 30),
              AptCutter::from_shape(10, 2, 0.2, -0.1, 15)}) {
            const CutterProfile cutter(apt);
            const BodySupport support(cutter);
            const TurnedBody body(cutter);
            for (int i = 0; i < 2000; ++i) {
                const Vec3 axis = random_unit(random), x = 40 * share(random) * random_unit(random);
                const auto plane = support.nearest(x, axis);
                QVERIFY(std::abs(plane.normal.norm() - 1) < 1e-12);
                const Mat3 frame = to_tool_frame(axis);
                if (plane.inside < -1e-6) {
                    // The body begins where the plane is, and not before.
                    const Vec3 on = x + plane.inside * plane.normal, middle = support.middle() * axis;
                    const Vec3 in = on + 1e-6 * (middle - on);
                    const Vec3 beside =
                        middle + 0.3 * axis.unitOrthogonal(); // not just through a pointed tip
                    const Stretch s = body.along(frame * in, frame * (beside - in));
                    if (on.norm() > 1e-3) QVERIFY(s.lo < 1e-6 && s.hi > 0);
                    QVERIFY(
                        body.along(frame * (on + 1e-6 * plane.normal), frame * plane.normal.unitOrthogonal())
                            .empty());
                } else if (plane.inside > 1e-6) {
                    const Stretch s = body.along(frame * x, frame * random_unit(random));
                    QVERIFY(s.lo < 0 && s.hi > 0);
                }
            }
        }
    }

    void the_tree_misses_nothing_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("fixed axis") << 0;
        QTest::newRow("tilted axes") << 1;
        QTest::newRow("turning axis") << 2;
        QTest::newRow("turning part") << 3;
    }
    void the_tree_misses_nothing() {
        QFETCH(int, kind);
        std::mt19937 random(7 + unsigned(kind));
        std::uniform_real_distribution<double> share(-1, 1);
        const std::vector<AptCutter> cutters = {AptCutter::ball(6, 20), AptCutter::flat(8, 15),
                                                AptCutter::bull(10, 2, 20),
                                                AptCutter::tapered_ball(1.5, 0.15, 18)};
        const double bound = kind >= 2 ? 1e-4 : 1e-9;
        int cut = 0;
        for (std::size_t c = 0; c < cutters.size(); ++c) {
            Path path;
            Vec3 tip(0, 0, 0), axis = Vec3::UnitZ();
            for (int i = 0; i < (kind >= 2 ? 24 : 60); ++i) {
                tip = (tip + 6 * Vec3(share(random), share(random), 0.3 * share(random)))
                          .cwiseMax(-15.0)
                          .cwiseMin(15.0);
                if (kind == 1 && i % 7 == 0) {
                    path.rapid(tip);
                    axis = (Vec3::UnitZ() + 0.7 * random_unit(random)).normalized();
                    path.motions->motions.back().to.axis = axis;
                    continue;
                }
                if (kind == 2) axis = (axis + 0.1 * random_unit(random)).normalized();
                if (kind == 3) {
                    const Eigen::AngleAxisd turn(0.3 + 0.2 * share(random), Vec3::UnitX());
                    axis = turn * axis;
                    tip = Vec3(tip.x(), 0, 0) + (12 + share(random)) * axis;
                }
                path.to(tip, axis, i % 9 == 8 && kind != 3 ? MotionKind::rapid : MotionKind::cut);
            }
            VerifyProgram program = path.with(cutters[c]);
            if (kind == 3) program.turning = TurningAxis{};
            const TurnedBody body(program.tool.cutter);
            const auto moves = all_moves(program, body.reach(), kind >= 2 ? 1e-3 : 1e-9);
            std::vector<Box3> boxes;
            for (const StraightMove& m : moves)
                boxes.push_back(m.box(body));
            const MotionProbes probes(
                body, BodySupport(program.tool.cutter),
                std::make_shared<const MotionTree>(
                    program, [](MotionKind k) { return k != MotionKind::rapid; }, Progress()),
                bound);
            for (int i = 0; i < trials(kind >= 2 ? 30 : 500); ++i) {
                const Vec3 p = 18 * Vec3(share(random), share(random), 0.4 * share(random));
                const Vec3 n = i % 3 == 0 ? Vec3(Vec3::UnitZ()) : random_unit(random);
                const double start = 5 + 4 * share(random);
                const double expected = lowest_of_all(moves, boxes, body, p, n, start);
                for (Index hint : {no_index, Index(5), Index(20)}) {
                    double value = start;
                    for (bool again = true; again;) {
                        LineProbe probe{value, no_index};
                        again = probes.lower(p, n, hint, probe) && probe.value < 0;
                        value = std::min(value, probe.value);
                    }
                    // Where the line grazes, an error of the pose counts manyfold.
                    const double allowed = kind >= 2 ? 0.02 : 1e-7;
                    QVERIFY2(std::abs(value - expected) <= allowed,
                             qPrintable(QString("cutter %1 line %2: %3, expected %4")
                                            .arg(c)
                                            .arg(i)
                                            .arg(value, 0, 'g', 12)
                                            .arg(expected, 0, 'g', 12)));
                }
                cut += expected < start;
            }
        }
        QVERIFY(cut > trials(kind >= 2 ? 10 : 400)); // lines that meet nothing show little
    }

    void cusps_between_ball_passes() {
        const double r = 5, w = 2;
        const Mesh part = plane(Vec2(-20, -15), Vec2(20, 15));
        const Outcome o = probe(part, block_over(part, 3),
                                {passes(22, 18, w, 0, 37).with(AptCutter::ball(2 * r, 30))}, 0.1);
        for (std::size_t i = 0; i < o.samples.points.size(); ++i) {
            const double y = o.samples.points[i].y(), d = std::abs(y - w * std::round(y / w));
            QVERIFY(std::abs(o.probed.deviation[i] - (r - std::sqrt(r * r - d * d))) < 1e-9);
        }
        const DeviationFigures& f = o.verification.figures;
        const double cusp = r - std::sqrt(r * r - w * w / 4);
        const auto at = [&](double share) { return r - std::sqrt(r * r - share * share * w * w / 4); };
        QVERIFY(f.samples > 20000);
        QVERIFY(std::abs(f.area - 30 * 20) < 30); // without the border, a cutter's radius wide
        QVERIFY(f.gouge_max < 1e-9);
        QVERIFY(f.excess_max <= cusp + 1e-9 && f.excess_max > 0.9999 * cusp);
        QVERIFY(std::abs(f.excess_p50 - at(0.5)) < 0.06 * cusp);
        QVERIFY(std::abs(f.excess_p95 - at(0.95)) < 0.06 * cusp);
        QVERIFY(std::abs(f.excess_p99 - at(0.99)) < 0.04 * cusp);
        QVERIFY(o.verification.gouges.empty());
        // All of the tolerance: what is over it is a known share of the plane.
        const double tolerance = at(0.5);
        const Outcome judged =
            probe(part, block_over(part, 3), {passes(22, 18, w, 0, 1).with(AptCutter::ball(2 * r, 30))}, 0.1,
                  0, tolerance);
        QVERIFY(std::abs(judged.verification.figures.over_fraction - 0.5) < 0.06);
        QVERIFY(std::abs(judged.verification.figures.uncut_fraction - (1 - 0.5 * std::sqrt(2))) < 0.06);
        QCOMPARE(judged.verification.excess.size(), std::size_t(10));
        for (const DeviationExtreme& e : judged.verification.excess)
            QVERIFY(e.by.known() && e.deviation > tolerance);
    }

    void a_tilted_flat_end_leaves_its_bottom() {
        // Tilted about x by lambda against the travel along y, the lowest point of the rim is on the plane;
        // seen along y the rim is an ellipse with half axes R and R sin(lambda).
        const double r = 6, lead = radians(8), w = 3;
        const Mesh part = plane(Vec2(-15, -15), Vec2(15, 15));
        const Vec3 axis(0, std::sin(lead), std::cos(lead));
        Path path;
        path.to(Vec3(0, 0, 50), axis);
        for (double x = -21; x <= 21; x += w) {
            path.to(Vec3(x, 30, 40), axis, MotionKind::rapid);
            path.to(Vec3(x, 30, r * std::sin(lead)), axis, MotionKind::rapid);
            path.to(Vec3(x, -30, r * std::sin(lead)), axis);
        }
        const Outcome o = probe(part, block_over(part, 2), {path.with(AptCutter::flat(2 * r, 40))}, 0.2);
        for (std::size_t i = 0; i < o.samples.points.size(); ++i) {
            const double x = o.samples.points[i].x(), d = std::abs(x - w * std::round(x / w));
            const double expected = std::sin(lead) * (r - std::sqrt(r * r - d * d));
            QVERIFY(std::abs(o.probed.deviation[i] - expected) < 1e-9);
        }
        QVERIFY(o.verification.figures.excess_max > 0.02);
        QVERIFY(std::abs(o.verification.bands[0].figures.area - o.verification.figures.area) < 1e-6);
    }

    /// Every CL with an axis of its own, as five-axis paths have: a flat end leads by lambda, which grows
    /// along each pass, over a plane that is tilted itself.
    void a_flat_end_that_leads_leaves_the_known_cusp() {
        const double r = 6, w = 3, reach = 28;
        const Mesh part = height_field([](double x, double y) { return 0.4 * x + 0.2 * y; }, Vec2(-15, -15),
                                       Vec2(15, 15), 1, 1);
        const Vec3 n = Vec3(-0.4, -0.2, 1).normalized();
        const Vec3 t = (Vec3(0.6, 0.8, 0) - Vec3(0.6, 0.8, 0).dot(n) * n).normalized(), c = n.cross(t);
        const auto lead_at = [&](double s) { return radians(10 + 4 * s / reach); };
        // The lowest point of the rim, ahead of the tip, is on the plane at s t + across c.
        const auto location = [&](double s, double across) {
            const double lead = lead_at(s);
            const Vec3 axis = std::cos(lead) * n + std::sin(lead) * t;
            const Vec3 ahead = std::cos(lead) * t - std::sin(lead) * n;
            return CutterLocation{Vec3(s * t + across * c - r * ahead), axis};
        };
        Path path;
        const CutterLocation first = location(-reach, -reach);
        path.to(first.tip + 60 * n, first.axis);
        std::size_t axes = 0;
        for (double across = -27; across <= 27; across += w) {
            const CutterLocation start = location(-reach, across), end = location(reach, across);
            path.to(start.tip + 60 * n, start.axis, MotionKind::rapid);
            for (double s = -reach; s <= reach + 1e-9; s += 0.5, ++axes) {
                const CutterLocation l = location(s, across);
                path.to(l.tip, l.axis);
            }
            path.to(end.tip + 60 * n, end.axis, MotionKind::rapid);
        }
        QVERIFY(axes > 2000);
        const Outcome o = probe(part, block_over(part, 2), {path.with(AptCutter::flat(2 * r, 80))}, 0.35);
        double largest = 0;
        for (std::size_t i = 0; i < o.samples.points.size(); ++i) {
            const double s = o.samples.points[i].dot(t), across = o.samples.points[i].dot(c);
            const double d = std::abs(across - w * std::round(across / w));
            // The rim beside the middle of the pass comes later by what it is behind its lowest point.
            const double sag = r - std::sqrt(r * r - d * d);
            const double expected = std::sin(lead_at(s + std::cos(lead_at(s)) * sag)) * sag;
            QVERIFY2(std::abs(o.probed.deviation[i] - expected) < 1.5e-4,
                     qPrintable(QString("%1 %2: %3, expected %4")
                                    .arg(s)
                                    .arg(d)
                                    .arg(o.probed.deviation[i])
                                    .arg(expected)));
            largest = std::max(largest, expected);
        }
        QVERIFY(largest > 0.03);
        QVERIFY(o.samples.points.size() > 3000);
        const auto& f = o.verification.figures;
        QVERIFY(std::max(f.gouge_max, o.verification.border.gouge_max) < 1.5e-4);
        QVERIFY(f.area + o.verification.border.area > 0.999 * 900 / n.z()); // none of it is away
    }

    /// Both CL points of a motion touch the plane, and between them the rim dips below it, because the tip
    /// goes straight while the axis swings.
    void a_gouge_between_two_cl_points_of_a_swing() {
        const double r = 5, angle = pi / 3;
        const Mesh part = plane(Vec2(-12, -12), Vec2(12, 12));
        const auto leaning = [](double by) { return Vec3(std::sin(by), 0, std::cos(by)); };
        const auto swing = [&](int pieces) {
            Path path;
            path.to(Vec3(-8, 0, 30)).to(Vec3(-8, 0, 0)).to(Vec3(-4, 0, 0));
            for (int i = 1; i <= pieces; ++i) {
                const double by = angle * i / pieces;
                path.to(Vec3(-4 + 4.0 * i / pieces, 0, r * std::sin(by)), leaning(by));
            }
            path.to(Vec3(0, 0, 40), leaning(angle), MotionKind::rapid);
            return probe(part, block_over(part, 2), {path.with(AptCutter::flat(2 * r, 80))}, 0.1);
        };
        // At a share s of the swing, leaning by a, the rim is at s r sin(angle) - r sin(a); of the plane's
        // points the deepest is as far from the end as from the side. Along the chord the axis leans more at
        // first.
        double depth = 0;
        for (double s = 0; s <= 1; s += 1e-4)
            for (const double a : {s * angle, std::atan2(s * std::sin(angle), 1 - s + s * std::cos(angle))})
                depth =
                    std::max(depth, r * (std::sin(a) - s * std::sin(angle)) / (std::sin(a) + std::cos(a)));
        QVERIFY(depth > 0.2);
        const Outcome o = swing(1);
        const double found = -o.verification.gouges.at(0).deviation;
        QVERIFY2(found < depth + 2e-4 && found > depth - 0.01, qPrintable(QString::number(found - depth)));
        QCOMPARE(o.verification.gouges[0].by, (MotionPlace{0, 3, AxisCourse::normalized_linear}));
        // In small steps the same swing stays where it should: the dip goes down with their square.
        const Outcome fine = swing(60);
        QVERIFY(std::max(fine.verification.figures.gouge_max, fine.verification.border.gouge_max) < 4e-4);
    }

    /// A flat end that is flush with a level facet, or too deep by less than what counts, has not gouged the
    /// walls below its edges.
    void a_flush_flat_end_spares_the_walls() {
        Mesh part = plane(Vec2(-20, -15), Vec2(20, 15));
        // Walls all round, and a chamfer in place of one edge.
        const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
            const Index at = Index(part.vertices.size());
            part.vertices.insert(part.vertices.end(), {a, b, c, d});
            part.facets.push_back({at, at + 1, at + 2});
            part.facets.push_back({at, at + 2, at + 3});
        };
        quad({-20, -15, -8}, {20, -15, -8}, {20, -15, 0}, {-20, -15, 0});
        quad({20, -15, -8}, {20, 15, -8}, {20, 15, 0}, {20, -15, 0});
        quad({20, 15, 0}, {20, 19, -4}, {-20, 19, -4}, {-20, 15, 0});
        std::map<std::array<double, 3>, Index> seen;
        Mesh welded;
        for (const Facet& f : part.facets) {
            Facet g;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& v = part.vertices[f[k]];
                const auto [at, fresh] = seen.try_emplace({v.x(), v.y(), v.z()}, Index(seen.size()));
                if (fresh) welded.vertices.push_back(v);
                g[k] = at->second;
            }
            welded.facets.push_back(g);
        }
        StockSolid stock = block_over(welded, 2);
        VerifySettings settings;
        settings.resolution = 0.5;
        settings.tolerance = 0.05;
        settings.gouge_limit = 0.0025;
        for (const double deep : {0.0, 1e-9, 1e-6, 1e-4, 2e-3, 0.0024, 0.0035}) {
            Path path = passes(30, 25, 3, -deep, 4);
            const std::vector<VerifyProgram> programs = {path.with(AptCutter::flat(10, 40))};
            const Verification v = verify(welded, stock, programs, settings, Progress());
            QVERIFY2(v.gouged() == (deep > settings.gouge_limit), qPrintable(QString::number(deep)));
            const double found = std::max(v.figures.gouge_max, v.border.gouge_max);
            QVERIFY2(std::abs(found - deep) < 1e-6, qPrintable(QString("%1: %2").arg(deep).arg(found)));
        }
    }

    void how_far_probes_are_apart_is_said() {
        const Mesh part = plane(Vec2(-20, -20), Vec2(20, 20));
        const std::vector<VerifyProgram> programs = {passes(24, 24, 1, 0, 1).with(AptCutter::ball(8, 20))};
        VerifySettings settings;
        settings.resolution = 0.5;
        const auto run = [&] { return verify(part, block_over(part, 1), programs, settings, Progress()); };
        const Verification plain = run();
        QCOMPARE(plain.used.sample_spacing, 0.5);
        QVERIFY(plain.used.max_samples >= plain.surface->points.size());
        const auto said = [](auto& v) {
            return says(v, length_text(v.used.sample_spacing, LengthUnit::mm, 3) + " apart");
        };
        QVERIFY(!said(plain));
        settings.max_samples = 1000;
        const Verification limited = run();
        QVERIFY(limited.surface->points.size() <= 1000);
        QVERIFY(limited.used.sample_spacing > 1.0);
        QVERIFY(said(limited));
        settings.max_samples = 0;
        settings.sample_spacing = 0.25;
        const Verification dense = run();
        QCOMPARE(dense.used.sample_spacing, 0.25);
        QVERIFY(dense.surface->points.size() > 3 * plain.surface->points.size());
    }

    void a_verdict_has_as_many_places_as_it_takes() {
        const Mesh part = plane(Vec2(-20, -20), Vec2(20, 20));
        const std::vector<VerifyProgram> programs = {passes(24, 24, 1, 0, 1).with(AptCutter::ball(8, 20))};
        VerifySettings settings;
        settings.resolution = 0.5;
        const auto with = [&](std::size_t most) {
            settings.max_samples = most;
            return verify(part, block_over(part, 1), programs, settings, Progress());
        };
        // Half a radius apart is near enough, which takes some four hundred places.
        const Verification enough = with(200), more = with(1000), never = with(40);
        QVERIFY2(enough.not_judged.empty(), enough.not_judged.c_str());
        QVERIFY(enough.surface->points.size() > 200 && enough.surface->points.size() <= 800);
        QCOMPARE(enough.used.sample_spacing, 2.0);
        QVERIFY(more.not_judged.empty() && more.surface->points.size() <= 1000
                && more.used.sample_spacing < 2);
        QVERIFY(!never.not_judged.empty() && never.used.sample_spacing > 2);
    }

    void a_part_that_is_all_border_is_said() {
        const std::vector<VerifyProgram> programs = {passes(24, 24, 1, 0, 1).with(AptCutter::ball(16, 20))};
        for (const auto& [size, all_border] : {std::pair(7.0, true), std::pair(20.0, false)}) {
            const Mesh part = plane(Vec2(-size, -size), Vec2(size, size));
            const auto v = verify(part, block_over(part, 1), programs, {.resolution = 0.5}, Progress());
            QCOMPARE(v.figures.samples == 0, all_border);
            QCOMPARE(says(v, "the whole part"), all_border);
        }
    }

    void planted_gouges_are_found_with_their_motion() {
        const double r = 4;
        const Mesh part = plane(Vec2(-20, -20), Vec2(20, 20), 40); // vertices at whole places
        Path path = passes(22, 22, 1, 0, 44);
        std::vector<std::pair<std::size_t, double>> planted = {
            {200, 0.25}, {700, 0.031}, {1201, 0.004}, {1502, 0.1}};
        for (const auto& [at, depth] : planted)
            path.motions->motions[at].to.tip.z() -= depth;
        const Outcome o = probe(part, block_over(part, 5), {path.with(AptCutter::ball(2 * r, 20))}, 0.5);
        std::sort(planted.begin(), planted.end(), [](auto& a, auto& b) { return a.second > b.second; });
        QCOMPARE(o.verification.gouges.size(), planted.size());
        for (std::size_t i = 0; i < planted.size(); ++i) {
            const DeviationExtreme& e = o.verification.gouges[i];
            const Vec3& tip = path.motions->motions[planted[i].first].to.tip;
            QVERIFY(std::abs(-e.deviation - planted[i].second) < 1e-6);
            QVERIFY((e.point - Vec3(tip.x(), tip.y(), 0)).norm() < 1e-9);
            QCOMPARE(e.by, (MotionPlace{0, planted[i].first}));
        }
        QVERIFY(std::abs(std::max(o.verification.figures.gouge_max, o.verification.border.gouge_max) - 0.25)
                < 1e-6);
    }

    void allowance_is_part_of_the_design() {
        const Mesh part = plane(Vec2(-10, -10), Vec2(10, 10));
        const std::vector<VerifyProgram> programs = {passes(14, 14, 1, 0.3, 1).with(AptCutter::flat(8, 20))};
        const Outcome o = probe(part, block_over(part, 2), programs, 1, 0.3);
        for (double d : o.probed.deviation)
            QVERIFY(std::abs(d) < 1e-9);
        const Outcome bare = probe(part, block_over(part, 2), programs, 1, 0);
        for (double d : bare.probed.deviation)
            QVERIFY(std::abs(d - 0.3) < 1e-9);
    }

    void sphere_by_a_ball() {
        // The ball's centre on spirals about a sphere: on the pass nothing is left; parallel circles leave a
        // known cusp.
        const double radius = 12, r = 3;
        const Mesh part = dome(radius, 37);
        Path path;
        path.to(Vec3(0, 0, 40));
        const int rings = 60, around = 720;
        for (int k = 0; k <= rings; ++k) {
            const double polar = 0.5 * pi * k / rings, out = (radius + r) * std::sin(polar);
            for (int i = 0; i <= around; ++i) {
                const double a = 2 * pi * i / around;
                path.to(Vec3(out * std::cos(a), out * std::sin(a), (radius + r) * std::cos(polar) - r));
            }
        }
        const Outcome o = probe(part, block_over(part, 2), {path.with(AptCutter::ball(2 * r, 30))}, 1);
        const double step = 0.25 * pi / rings, chord = (radius + r) * (1 - std::cos(pi / around));
        // Half way between two passes: from the sphere's centre to where two balls meet.
        const double far =
            (radius + r) * std::cos(step) - std::sqrt(r * r - std::pow((radius + r) * std::sin(step), 2));
        const double cusp = far - radius;
        double most = 0;
        std::size_t tops = 0;
        for (std::size_t i = 0; i < o.samples.points.size(); ++i) {
            const Vec3& p = o.samples.points[i];
            // The mesh's vertices are on the sphere, its facets are not.
            if (p.z() < 0.5 || std::abs(p.norm() - radius) > 1e-9
                || o.samples.normals[i].dot(p) < 0.9999 * radius)
                continue;
            if (p.x() > 0 && std::abs(p.y()) < 0.5) continue; // there the path goes on to the next ring
            ++tops;
            most = std::max(most, o.probed.deviation[i]);
            QVERIFY(o.probed.deviation[i] > -2 * chord - 1e-5);
        }
        QVERIFY(tops > 1000);
        QVERIFY2(most < 1.05 * cusp + 1e-4 && most > 0,
                 qPrintable(QString("%1, cusp %2").arg(most).arg(cusp)));
    }

    void cylinder_by_a_turning_part() {
        // A roller of radius 10 along x, milled by a flat end that stays radial while the part turns: the
        // middle of its bottom runs on the roller, but the rim does not reach below.
        const double radius = 10;
        Mesh part;
        const int around = 90, along = 20;
        for (int i = 0; i <= along; ++i)
            for (int k = 0; k < around; ++k)
                part.vertices.push_back(Vec3(-10 + 20.0 * i / along, radius * std::cos(2 * pi * k / around),
                                             radius * std::sin(2 * pi * k / around)));
        for (Index i = 0; i < Index(along); ++i)
            for (Index k = 0; k < Index(around); ++k) {
                const Index a = i * around + k, b = i * around + (k + 1) % around;
                part.facets.push_back({a, b, b + around});
                part.facets.push_back({a, b + around, a + around});
            }
        if (part.facet_normal(0).dot(part.corner(0, 0)) < 0)
            for (Facet& f : part.facets)
                std::swap(f[1], f[2]);
        Path path;
        const int turns = 24, per_turn = 12; // 30 degrees a motion
        for (int i = 0; i <= turns * per_turn; ++i) {
            const double a = 2 * pi * i / per_turn;
            const Vec3 out(0, std::cos(a), std::sin(a));
            path.to(Vec3(-12 + 24.0 * i / (turns * per_turn), 0, 0) + radius * out, out);
        }
        VerifyProgram program = path.with(AptCutter::flat(4, 30));
        program.turning = TurningAxis{};
        StockSolid stock = block_over(part, 2);
        stock.kind = StockSolid::Kind::cylinder;
        stock.axis = 0;
        stock.radius = 12;
        const Outcome o = probe(part, stock, {program}, 3);
        std::size_t seen = 0;
        for (std::size_t i = 0; i < o.samples.points.size(); ++i) {
            if (std::abs(o.samples.points[i].x()) > 8) continue;
            ++seen;
            // To the bound; never below, for the bottom is tangent.
            QVERIFY2(std::abs(o.probed.deviation[i]) < 1.5e-4,
                     qPrintable(QString::number(o.probed.deviation[i])));
        }
        QVERIFY(seen > 1000);
        // On straight chords the same path would cut deep.
        program.turning.reset();
        const Outcome chords = probe(part, stock, {program}, 3);
        QVERIFY(chords.verification.figures.gouge_max + chords.verification.border.gouge_max > 0.3);
    }

    void a_swing_about_the_tip() {
        // A flat end stands on its tip and leans from -20 to 20 degrees about y: the rim goes down by R
        // sin(angle) at its two ends. How deep a point of the plane comes to lie inside is known at each
        // lean.
        const double r = 5, lean = radians(20);
        const Mesh part = plane(Vec2(-8, -8), Vec2(8, 8), 16);
        Path path;
        path.to(Vec3(0, 0, 0), Vec3(-std::sin(lean), 0, std::cos(lean)));
        path.to(Vec3(0, 0, 0), Vec3(std::sin(lean), 0, std::cos(lean)));
        const Outcome o = probe(part, block_over(part, 6), {path.with(AptCutter::flat(2 * r, 30))}, 1);
        std::size_t cut = 0;
        for (std::size_t i = 0; i < o.samples.points.size(); ++i) {
            const Vec3& p = o.samples.points[i];
            const double x = std::abs(p.x()), y = p.y();
            if (y * y > r * r - 0.1 || x > std::sqrt(r * r - y * y)) continue;
            // In the leaning tool the point is x sin(a) above its end, and x cos(a) off the middle along x.
            double expected = 0;
            for (double a = 0; a <= lean; a += 1e-5)
                expected = std::min(expected, -std::min(x * std::sin(a), r - std::hypot(x * std::cos(a), y)));
            ++cut;
            QVERIFY2(std::abs(o.probed.deviation[i] - expected) < 4e-4,
                     qPrintable(QString("%1 %2: %3, expected %4")
                                    .arg(p.x())
                                    .arg(p.y())
                                    .arg(o.probed.deviation[i])
                                    .arg(expected)));
        }
        QVERIFY(cut > 60);
    }

    void behind_a_thin_wall() {
        // A plate 1 thick, cut from below: nothing is missing on top as long as the cut does not come
        // through.
        const Mesh part = box(Vec3(-10, -10, -1), Vec3(10, 10, 0));
        Path path;
        const Vec3 down(0, 0, -1);
        path.to(Vec3(-20, 0, -0.4), down).to(Vec3(20, 0, -0.4), down);
        const StockSolid stock = block(part.box());
        const Outcome o = probe(part, stock, {path.with(AptCutter::flat(6, 10))}, 1);
        double top = 0, bottom = 0;
        for (std::size_t i = 0; i < o.samples.points.size(); ++i) {
            if (o.samples.normals[i].z() > 0.9) top = std::min(top, o.probed.deviation[i]);
            if (o.samples.normals[i].z() < -0.9) bottom = std::min(bottom, o.probed.deviation[i]);
        }
        QCOMPARE(top, 0.0);
        QVERIFY(std::abs(bottom + 0.6) < 1e-9);
        // From both sides: cut 0.7 from above and 0.6 from below is through, and neither goes deeper for it.
        Path above;
        above.to(Vec3(-20, 0, -0.7)).to(Vec3(20, 0, -0.7));
        const Outcome through =
            probe(part, stock, {above.with(AptCutter::flat(6, 10)), path.with(AptCutter::flat(6, 10))}, 1);
        double deepest = 0;
        for (std::size_t i = 0; i < through.samples.points.size(); ++i)
            if (through.samples.normals[i].z() > 0.9)
                deepest = std::min(deepest, through.probed.deviation[i]);
        QVERIFY(std::abs(deepest + 0.7) < 1e-9);
    }

    void borders_and_walls_are_flagged() {
        const Mesh part = step(-5, 0);
        const Outcome o =
            probe(part, block_over(part, 1), {passes(22, 18, 1, 0, 1).with(AptCutter::ball(6, 30))}, 0.5);
        for (std::size_t i = 0; i < o.samples.points.size(); ++i) {
            const Vec3& p = o.samples.points[i];
            const Box3 box = part.box();
            const double edge =
                std::min((p - box.lo).head<2>().minCoeff(), (box.hi - p).head<2>().minCoeff());
            if (std::abs(edge - 3) > 1e-6 && std::abs(o.samples.normals[i].z()) > 0.9)
                QCOMPARE((o.samples.flags[i] & DeviationSurface::border) != 0, edge < 3);
            QCOMPARE((o.samples.flags[i] & DeviationSurface::away) != 0,
                     std::abs(o.samples.normals[i].z()) < 0.5);
        }
    }

    void stock_that_does_not_reach_is_not_judged() {
        const Mesh part = plane(Vec2(-20, -20), Vec2(20, 20));
        Box3 half = part.box();
        half.lo.z() = -5;
        half.hi = Vec3(0, 20, 5);
        const Outcome o =
            probe(part, block(half), {passes(25, 25, 0.5, 0, 1).with(AptCutter::flat(4, 10))}, 1);
        for (std::size_t i = 0; i < o.samples.points.size(); ++i)
            QCOMPARE((o.samples.flags[i] & DeviationSurface::bare) != 0, o.samples.points[i].x() > 1e-6);
    }

    void lines_leave_every_kind_of_stock() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> share(-1, 1);
        StockSolid as_box = block({Vec3(-10, -8, -6), Vec3(10, 8, 6)}), as_mesh = as_box;
        as_mesh.kind = StockSolid::Kind::mesh;
        as_mesh.mesh = std::make_shared<Mesh>(box(as_box.box.lo, as_box.box.hi));
        StockSolid inside_out = as_mesh; // wound the other way
        inside_out.mesh = std::make_shared<Mesh>(box(as_box.box.hi, as_box.box.lo));
        StockSolid round = as_box;
        round.kind = StockSolid::Kind::cylinder;
        round.axis = 0;
        round.radius = 5;
        const StockExit by_box(as_box, Progress()), by_mesh(as_mesh, Progress()), by_round(round, Progress()),
            by_turned(inside_out, Progress());
        for (int i = 0; i < 5000; ++i) {
            const Vec3 p = 13 * Vec3(share(random), share(random), share(random)), n = random_unit(random);
            const double a = by_box(p, n), b = by_mesh(p, n), c = by_round(p, n);
            QVERIFY(std::abs(std::max(a, -1.0) - std::max(b, -1.0)) < 1e-9);
            QCOMPARE(by_turned(p, n), b);
            const bool in = std::abs(p.x()) <= 10 && std::hypot(p.y(), p.z()) <= 5;
            QCOMPARE(c >= 0, in);
            if (!in) continue;
            const Vec3 q = p + c * n;
            QVERIFY(std::abs(std::abs(q.x()) - 10) < 1e-9 || std::abs(std::hypot(q.y(), q.z()) - 5) < 1e-9);
        }
    }

    void shank_and_holder_in_a_wall() {
        const Mesh part = step(-30, 0); // a wall 30 high along y = 0, low where y > 0
        Tool tool = ball_tool(6);
        tool.flute_length = 10;
        tool.shank_diameter = 5;
        tool.shank_length = 12;
        tool.holder = {{20, 30}};
        // At y = 7 the holder (radius 10, from 22 up) stands 3 in the wall; the shank (radius 2.5) is clear.
        Path path;
        path.to(Vec3(-25, 7, 20)).to(Vec3(-10, 7, -30)).to(Vec3(10, 7, -30)).to(Vec3(10, 7, 20));
        Outcome o = probe(part, block_over(part, 2), {path.with(tool)}, 0.5);
        QVERIFY(!o.probed.collisions.empty());
        double holder = 0;
        for (const Collision& c : o.probed.collisions) {
            QVERIFY(c.with_part && c.at.program == 0);
            QCOMPARE(int(c.kind), int(Collision::Kind::holder));
            holder = std::max(holder, c.depth);
        }
        // Into the wall by 3: that it is 8 below the wall's top says nothing of the depth.
        QVERIFY(std::abs(holder - 3) < 1e-6);
        // A thicker shank, at y = 2.4: 0.1 in the wall.
        tool.holder.clear();
        Path near;
        near.to(Vec3(0, 2.4, 40)).to(Vec3(0, 2.4, -20));
        o = probe(part, block_over(part, 2), {near.with(tool)}, 0.5);
        QCOMPARE(o.probed.collisions.size(), std::size_t(1));
        QCOMPARE(int(o.probed.collisions[0].kind), int(Collision::Kind::shank));
        QCOMPARE(o.probed.collisions[0].at, (MotionPlace{0, 1}));
        // A rapid through the upper level, 2 deep.
        Path fast;
        fast.to(Vec3(-30, -5, 20)).to(Vec3(-30, -5, -2)).rapid(Vec3(30, -5, -2)).to(Vec3(30, -5, 20));
        o = probe(part, block_over(part, 2), {fast.with(tool)}, 0.5);
        QCOMPARE(o.probed.collisions.size(), std::size_t(1));
        QCOMPARE(int(o.probed.collisions[0].kind), int(Collision::Kind::rapid));
        QCOMPARE(o.probed.collisions[0].at, (MotionPlace{0, 2}));
        QVERIFY(std::abs(o.probed.collisions[0].depth - 2) < 1e-3);
    }

    void threads_do_not_matter_and_cancel_is_heard() {
        const Mesh part = *make_sample("concave", 0.2, Progress());
        const Box3 box = part.box();
        Path path;
        path.to(Vec3(box.lo.x(), box.lo.y(), box.hi.z() + 20));
        std::mt19937 random(5);
        std::uniform_real_distribution<double> share(0, 1);
        Vec3 tip = box.center();
        for (int i = 0; i < 600; ++i) {
            tip += 4 * Vec3(share(random) - 0.5, share(random) - 0.5, 0.2 * share(random) - 0.1);
            tip = tip.cwiseMax(box.lo).cwiseMin(box.hi);
            path.to(tip, (Vec3::UnitZ() + 0.05 * random_unit(random)).normalized());
        }
        const std::vector<VerifyProgram> programs = {path.with(AptCutter::ball(12, 40))};
        const int before = thread_count();
        set_thread_count(1);
        const Outcome one = probe(part, block_over(part, 5), programs, 5);
        set_thread_count(2);
        const Outcome two = probe(part, block_over(part, 5), programs, 5);
        set_thread_count(before);
        QVERIFY(one.probed.deviation == two.probed.deviation);
        QVERIFY(one.probed.by == two.probed.by);
        QVERIFY(one.samples.flags == two.samples.flags);
        Job job;
        job.cancel();
        SurfaceSamples samples = one.samples;
        const MeshSight sight(part, Progress());
        QVERIFY_THROWS_EXCEPTION(
            Cancelled, probe_samples(samples, sight, block_over(part, 5), programs, {}, Progress(job)));
    }
};

FACETMILL_TEST(TestDeviation)
#include "test_deviation.moc"
