// Lifts along any vector, of any convex cutter about any axis: held against the reference on single facets of
// every degenerate family, and on whole meshes through the index.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_lift.h"
#include "tests/property/vector_cases.h"
#include "tests/property/vector_check.h"
#include "tests/support/reference_lift.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cstring>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A wavy field with shared vertices: most contacts lie on its edges and in its facets.
std::shared_ptr<Mesh> waves(int n, double size) {
    return field(n, size, [](double x, double y) { return 6 * std::sin(0.3 * x) * std::cos(0.2 * y); });
}

Posture random_posture(Random& rng, double size) {
    Posture p;
    p.tip = Vec3(uniform(rng, 0, size), uniform(rng, 0, size), uniform(rng, -0.2, 0.6) * size);
    p.axis = random_unit(rng);
    switch (whole(rng, 0, 4)) {
    case 0:
        p.direction = p.axis;
        break;
    case 1:
        p.direction = p.axis.cross(random_unit(rng)).normalized();
        break;
    default:
        p.direction = random_unit(rng);
    }
    return p;
}

struct Tools {
    AptCutter cutter;
    std::vector<BodySection> sections;
    std::vector<ReferenceBody> bodies() const {
        std::vector<ReferenceBody> all{ReferenceBody(cutter)};
        for (const BodySection& s : sections)
            all.emplace_back(AptCutter::flat(2 * s.radius, s.to - s.from), s.from);
        return all;
    }
};

Tools random_tool(Random& rng, int kind) {
    Tools t;
    t.cutter = random_cutter(rng, kind, uniform(rng, 3, 9));
    if (kind % 2) {
        const double top = CutterProfile(t.cutter).height();
        t.sections = {{0.4 * t.cutter.d, top, top + 12}, {1.5 * t.cutter.d, top + 12, top + 20}};
    }
    return t;
}

/// Rounding, as in tolerance::touch_roundings but with room for the reference's own postures.
constexpr double mesh_digit = 64 * 2.2e-16 * 150;

ErrorCode code_of(const std::function<void()>& f) {
    try {
        f();
    } catch (const Error& e) {
        return e.code();
    }
    return ErrorCode::usage;
}

} // namespace

class TestContactKernel : public QObject {
    Q_OBJECT
private slots:
    // Ten thousand at a time, to see which.
    void single_facets_data() {
        QTest::addColumn<int>("part");
        for (int part = 0; part < 10; ++part)
            QTest::addRow("%d", part) << part;
    }
    void single_facets() {
        QFETCH(int, part);
        const std::uint64_t begin = std::uint64_t(part) * 10'000;
        const VectorCheck check = check_vector_cases(begin, begin + 10'000, 16, 500);
        QVERIFY2(check.first_failure.isEmpty(), qPrintable(check.first_failure));
        QVERIFY(check.worst <= tolerance::lift_accuracy);
        QVERIFY(check.touched > 7'500);
        QVERIFY2(check.borderline < 200, qPrintable(QString::number(check.borderline)));
        QVERIFY(check.compared >= 600 && check.maximised >= 20);
    }

    // A unit ball, a cylinder, a cone and a torus against one point, edge and plane, by hand.
    void known_lifts() {
        const auto lift = [](const AptCutter& cutter, const Vec3& axis, const Vec3& direction, const Vec3& a,
                             const Vec3& b, const Vec3& c) {
            const auto mesh = std::make_shared<Mesh>();
            mesh->vertices = {a, b, c};
            mesh->facets = {{0, 1, 2}};
            const VectorLift lifts(std::make_shared<ContactIndex>(mesh, Progress()), CutterProfile(cutter));
            return lifts.contact({Vec3(0, 0, 0), axis, direction});
        };
        using Feature = VectorContact::Feature;
        const AptCutter ball = AptCutter::ball(2, 10), flat = AptCutter::flat(2, 10),
                        cone = AptCutter::cone(2, 0.25 * pi), bull = AptCutter::bull(4, 1, 10);
        const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
        const auto same = [](const VectorContact& got, double wanted, Feature feature) {
            const bool equal = std::abs(got.lift - wanted) <= 1e-12 && got.feature == feature;
            if (!equal) qWarning() << got.lift << wanted << int(got.feature);
            return equal;
        };
        const Vec3 corner(5, 0, 1);
        // The ball's centre is 1 above its tip; from +x it stops when its back, at -1, is at the point.
        QVERIFY(same(lift(ball, z, x, corner, corner, corner), 6, Feature::vertex));
        QVERIFY(same(lift(ball, z, x, Vec3(5, -3, 1), Vec3(5, 3, 1), Vec3(4, 0, 1)), 6, Feature::edge));
        QVERIFY(same(lift(ball, z, x, Vec3(5, -3, -3), Vec3(5, 3, -3), Vec3(5, 0, 5)), 6, Feature::facet));
        // A wall that leans 45 degrees over: the centre is sqrt(2) from it along x.
        QVERIFY(same(lift(ball, z, x, Vec3(0, -9, 5), Vec3(0, 9, 5), Vec3(9, 0, -4)), 4 + std::sqrt(2),
                     Feature::facet));
        // The flat end's rim under a level edge across, and over one below its bottom: no contact.
        QVERIFY(same(lift(flat, z, x, Vec3(5, -3, 0), Vec3(5, 3, 0), Vec3(4, 0, -1)), 6, Feature::edge));
        QCOMPARE(lift(flat, z, x, Vec3(5, -3, -1e-9), Vec3(5, 3, -1e-9), Vec3(4, 0, -1)).lift, -infinity);
        // The tool lies along x and comes down on a point with its side, on a ridge along it all the same.
        QVERIFY(same(lift(flat, x, z, Vec3(5, 0, 3), Vec3(5, 0, 3), Vec3(5, 0, 3)), 4, Feature::vertex));
        QVERIFY(same(lift(flat, x, z, Vec3(-5, 0, 3), Vec3(25, 0, 3), Vec3(5, 1, 0)), 4, Feature::edge));
        // Pulled back out of a slot: the highest top that the tool would run into on its way.
        QVERIFY(same(lift(flat, z, Vec3(-z), Vec3(0, 0, 3), Vec3(0.5, 0, 3), Vec3(0, 0.5, 2)), 8,
                     Feature::vertex));
        // A cone of 45 degrees: at height 0.5 it is 0.5 wide.
        QVERIFY(
            same(lift(cone, z, x, Vec3(5, 0, 0.5), Vec3(5, 0, 0.5), Vec3(5, 0, 0.5)), 5.5, Feature::vertex));
        QVERIFY(same(lift(cone, z, z, Vec3(0, -3, 2), Vec3(0, 3, 2), Vec3(0, 0, 1)), 2, Feature::edge));
        // A bull nose against a vertical edge, and sideways over a level edge at half the corner's height.
        QVERIFY(same(lift(bull, z, y, Vec3(0, 5, -3), Vec3(0, 5, 30), Vec3(0, 3, 1)), 7, Feature::edge));
        QVERIFY(same(lift(bull, z, y, Vec3(-3, 5, 0.5), Vec3(3, 5, 0.5), Vec3(0, 3, 0)), 6 + std::sqrt(0.75),
                     Feature::edge));
    }

    // An edge from rim to rim across the flat end, its ends out by next to nothing: all of it touches but
    // they, and no other point of it stands out.
    void edge_across_the_flat() {
        Random rng(15);
        for (int i = 0; i < 3000; ++i) {
            const double r = uniform(rng, 0.5, 8), from = uniform(rng, 0, 2 * pi),
                         to = from + uniform(rng, 0.3, 3);
            Posture posture;
            posture.tip = i % 2 ? Vec3(Vec3::Zero()) : Vec3(uniform(rng, -9, 9), uniform(rng, -9, 9), 1);
            // Straight up, aslant, and nearly along the flat, where the place along the edge is known the
            // least.
            const double up = i % 3 == 2 ? std::pow(10.0, uniform(rng, -4, -1)) : 1, aside = i % 3 ? 1 : 0;
            posture.direction =
                Vec3(aside * uniform(rng, -1, 1), aside * uniform(rng, -1, 1), up).normalized();
            const auto rim = [&](double angle, double out) {
                const double rho = r * (1 + out);
                return Vec3(posture.tip + 5 * posture.direction
                            + Vec3(rho * std::cos(angle), rho * std::sin(angle), 0));
            };
            const double out_by = std::pow(10.0, uniform(rng, -16, -11));
            const auto mesh = std::make_shared<Mesh>();
            mesh->vertices = {rim(from, out_by), rim(to, out_by),
                              rim(0.5 * (from + to), 0.5) - Vec3(0, 0, 3)};
            mesh->facets = {{0, 1, 2}};
            const VectorLift lift(std::make_shared<ContactIndex>(mesh, Progress()),
                                  CutterProfile(AptCutter::flat(2 * r, 20)));
            const double got = lift.lift(posture);
            QVERIFY2(std::abs(got - 5) <= tolerance::lift_accuracy,
                     qPrintable(QString::number(got, 'g', 17)));
        }
    }

    // Straight up, a lift along the vector is that along the axis.
    void agrees_with_axial_lifts() {
        Random rng(3);
        double worst = 0;
        for (const auto& mesh : {soup(300, 60, 5), waves(24, 60)}) {
            const auto index = std::make_shared<ContactIndex>(mesh, Progress());
            for (int kind = 0; kind < 14; ++kind) {
                const CutterProfile profile(random_cutter(rng, kind, uniform(rng, 2, 12)));
                const double allowance = kind % 3 ? 0 : 0.3;
                const AxialLift axial(index, profile, allowance);
                const VectorLift lift(index, profile, {}, allowance);
                for (int i = 0; i < 150; ++i) {
                    const Vec3 tip(uniform(rng, 0, 60), uniform(rng, 0, 60), uniform(rng, -30, 30));
                    const double wanted = axial.tip_z(tip.x(), tip.y());
                    const double got = tip.z() + lift.lift({tip, Vec3::UnitZ(), Vec3::UnitZ()});
                    if (wanted == got) continue;
                    worst = std::max(worst, std::abs(got - wanted));
                    // At the rim rounding decides; there the next place decides the same way for both.
                    QVERIFY2(
                        std::abs(got - wanted) <= tolerance::lift_accuracy,
                        qPrintable(
                            QString("%1: %2 %3").arg(kind).arg(got, 0, 'g', 17).arg(wanted, 0, 'g', 17)));
                }
            }
        }
        qInfo() << "largest difference from axial lifts" << worst;
    }

    // Whole meshes through the index against every facet, with shank and holder.
    void whole_meshes() {
        Random rng(7);
        int touched = 0, bodies_seen[3] = {0, 0, 0};
        for (const auto& mesh : {soup(120, 60, 5), waves(14, 60)}) {
            const auto index = std::make_shared<ContactIndex>(mesh, Progress());
            for (int kind = 0; kind < 14; ++kind) {
                const Tools tool = random_tool(rng, kind);
                const VectorLift lift(index, CutterProfile(tool.cutter), tool.sections);
                const auto bodies = tool.bodies();
                for (int i = 0; i < 25; ++i) {
                    const Posture posture = random_posture(rng, 60);
                    const ReferencePosture reference(posture.tip, posture.axis, posture.direction);
                    const VectorContact got = lift.contact(posture);
                    QCOMPARE(lift.lift(posture), got.lift);
                    Real wanted = no_lift, lowest = no_lift;
                    for (const ReferenceBody& body : bodies)
                        wanted = std::max(wanted, reference_bound(body, reference, *mesh));
                    if (!(Real(got.lift) == wanted
                          || std::abs(Real(got.lift) - wanted) <= tolerance::lift_accuracy)) {
                        Real highest = no_lift;
                        for (const ReferenceBody& body : bodies) {
                            lowest = std::max(lowest, reference_bound(body, reference, *mesh, -mesh_digit));
                            highest = std::max(highest, reference_bound(body, reference, *mesh, mesh_digit));
                        }
                        QVERIFY2(got.lift >= lowest - tolerance::lift_accuracy
                                     && got.lift <= highest + tolerance::lift_accuracy,
                                 qPrintable(QString("%1 %2: %3 %4")
                                                .arg(kind)
                                                .arg(i)
                                                .arg(got.lift, 0, 'g', 17)
                                                .arg(double(wanted), 0, 'g', 17)));
                    }
                    if (got.lift == -infinity) {
                        QCOMPARE(got.facet, no_index);
                        continue;
                    }
                    ++touched;
                    ++bodies_seen[got.body];
                    const ReferenceFacet facet{mesh->corner(got.facet, 0), mesh->corner(got.facet, 1),
                                               mesh->corner(got.facet, 2)};
                    const Witness w = witness(bodies[got.body], reference, facet, got.point, got.lift);
                    QVERIFY(w.from_facet <= mesh_digit && w.from_body <= mesh_digit);
                }
            }
        }
        QVERIFY(touched > 500 && bodies_seen[0] > 50 && bodies_seen[1] > 5 && bodies_seen[2] > 50);
    }

    // Grown by an allowance: the reference's body grown by as much.
    void keeps_an_allowance() {
        Random rng(9);
        const auto mesh = soup(60, 60, 6);
        const auto index = std::make_shared<ContactIndex>(mesh, Progress());
        for (int kind = 0; kind < 14; ++kind) {
            const Tools tool = random_tool(rng, kind);
            const double allowance = uniform(rng, 0.01, 2);
            const VectorLift lift(index, CutterProfile(tool.cutter), tool.sections, allowance);
            for (int i = 0; i < 10; ++i) {
                const Posture posture = random_posture(rng, 60);
                const ReferencePosture reference(posture.tip, posture.axis, posture.direction);
                const double got = lift.lift(posture);
                Real lowest = no_lift, highest = no_lift;
                for (const ReferenceBody& body : tool.bodies()) {
                    lowest =
                        std::max(lowest, reference_bound(body, reference, *mesh, allowance - mesh_digit));
                    highest =
                        std::max(highest, reference_bound(body, reference, *mesh, allowance + mesh_digit));
                }
                QVERIFY2(got >= lowest - tolerance::lift_accuracy
                             && got <= highest + tolerance::lift_accuracy,
                         qPrintable(QString("%1 %2: %3 %4").arg(kind).arg(i).arg(got).arg(double(lowest))));
            }
        }
        QCOMPARE(code_of([&] { VectorLift(index, CutterProfile(AptCutter::ball(6, 50)), {}, -0.1); }),
                 ErrorCode::out_of_range);
    }

    void same_bits_in_any_batch() {
        Random rng(11);
        const auto index = std::make_shared<ContactIndex>(waves(60, 60), Progress());
        const Tools tool = random_tool(rng, 9);
        const VectorLift lift(index, CutterProfile(tool.cutter), tool.sections);
        std::vector<Posture> postures;
        for (int i = 0; i < 1500; ++i) {
            postures.push_back(random_posture(rng, 60));
            if (i % 3) { // a neighbour: an orientation shared, a small step
                postures.back() = postures[postures.size() - 2];
                postures.back().tip.x() += 0.1;
            }
        }
        std::vector<double> one_by_one, batch(postures.size());
        for (const Posture& p : postures)
            one_by_one.push_back(lift.lift(p));
        const int threads = thread_count();
        for (const int n : {1, 2, 3}) {
            set_thread_count(n);
            std::fill(batch.begin(), batch.end(), 0);
            lift.lift(postures, batch, Progress());
            QCOMPARE(std::memcmp(batch.data(), one_by_one.data(), batch.size() * sizeof(double)), 0);
        }
        set_thread_count(threads);
        Job job;
        job.cancel();
        QVERIFY_THROWS_EXCEPTION(Cancelled, lift.lift(postures, batch, Progress(job)));
        batch.pop_back();
        QCOMPARE(code_of([&] { lift.lift(postures, batch, Progress()); }), ErrorCode::internal);
    }

    void no_posture_no_contact() {
        const CutterProfile ball(AptCutter::ball(6, 50));
        const VectorLift empty(std::make_shared<ContactIndex>(std::make_shared<Mesh>(), Progress()), ball);
        QCOMPARE(empty.lift(Posture{}), -infinity);
        const auto index = std::make_shared<ContactIndex>(waves(6, 60), Progress());
        const VectorLift lift(index, ball);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(std::isfinite(lift.lift({Vec3(30, 30, 0)})));
        QCOMPARE(lift.lift({Vec3(300, 30, 0)}), -infinity);
        for (const Posture& p :
             {Posture{Vec3(nan, 0, 0)}, Posture{Vec3(0, 0, infinity)},
              Posture{Vec3(30, 30, 0), Vec3(0, 0, 2)}, Posture{Vec3(30, 30, 0), Vec3(0, 0, nan)},
              Posture{Vec3(30, 30, 0), Vec3::UnitZ(), Vec3::Zero()}}) {
            QVERIFY(std::isnan(lift.lift(p)));
            QVERIFY(std::isnan(lift.contact(p).lift));
            QCOMPARE(lift.contact(p).facet, no_index);
        }
        const auto refuse = [&](const BodySection& section) {
            return code_of([&] { VectorLift(index, ball, {&section, 1}); });
        };
        QCOMPARE(refuse({0, 1, 2}), ErrorCode::out_of_range);
        QCOMPARE(refuse({1, 2, 2}), ErrorCode::out_of_range);
        QCOMPARE(refuse({1, nan, 2}), ErrorCode::out_of_range);
    }
};

FACETMILL_TEST(TestContactKernel)
#include "test_contact_kernel.moc"
