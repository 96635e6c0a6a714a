// Fixtures at random places: every kind of operation keeps its tool, shank and holder off them in cuts, links
// and rapids, and the verifier finds a tool in them where there is one. The judge of both is a list of points
// on the clamp's sides and a list of poses, which know nothing of planners and verifier.
#include "core/job/planner.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "core/verify/fixture_touch.h"
#include "tests/property/held_job.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double kept = 1; // mm, of all clamps

/// A clamp that reaches over the part, or stands beside it.
Fixture random_clamp(Random& rng, bool turns) {
    Fixture f;
    f.name = "Clamp";
    f.clearance = kept;
    f.kind = whole(rng, 0, 1) == 0 ? Fixture::Kind::box : Fixture::Kind::cylinder;
    f.size = {uniform(rng, 3, 9), uniform(rng, 3, 9), uniform(rng, 4, 9)};
    f.diameter = uniform(rng, 3, 8);
    f.height = uniform(rng, 4, 9);
    f.rotate[2] = uniform(rng, -pi, pi);
    if (turns) {
        f.rotate = {uniform(rng, -pi, pi), 0, 0};
        const Vec3 out = rotation_of(f.rotate) * Vec3(0, 0, uniform(rng, 7.5, 9));
        f.translate = {uniform(rng, 2, 22), out.y(), out.z()};
    } else
        f.translate = {uniform(rng, -15, 15), uniform(rng, -11, 11), uniform(rng, -3, 1)};
    return f;
}

/// Points on the sides of a clamp that is larger by `by`, half a millimetre apart.
std::vector<Vec3> points_on(const Fixture& f, double by) {
    std::vector<Vec3> points;
    const Mat3 turn = rotation_of(f.rotate);
    const Vec3 move(f.translate[0], f.translate[1], f.translate[2]);
    const bool round = f.kind == Fixture::Kind::cylinder;
    const double x = round ? 0.5 * f.diameter + by : 0.5 * f.size[0] + by,
                 y = round ? x : 0.5 * f.size[1] + by, top = (round ? f.height : f.size[2]) + by;
    constexpr double step = 0.5;
    const auto n = [](double length) { return std::max(2, int(std::ceil(length / step))); };
    const int nx = n(2 * x), ny = n(2 * y), nz = n(top + by);
    for (int i = 0; i <= nx; ++i)
        for (int j = 0; j <= ny; ++j)
            for (int k = 0; k <= nz; ++k) {
                const bool on = i == 0 || j == 0 || k == 0 || i == nx || j == ny || k == nz;
                const Vec3 p(-x + 2 * x * i / nx, -y + 2 * y * j / ny, -by + (top + by) * k / nz);
                if (round) {
                    // A grid over the ends, and a ring of points at every height.
                    if ((k == 0 || k == nz) && p.head<2>().norm() <= x) points.push_back(turn * p + move);
                } else if (on)
                    points.push_back(turn * p + move);
            }
    for (int k = 0; round && k <= nz; ++k)
        for (int a = 0; a < 4 * nx; ++a) {
            const double angle = 2 * pi * a / (4 * nx);
            points.push_back(turn * Vec3(x * std::cos(angle), x * std::sin(angle), -by + (top + by) * k / nz)
                             + move);
        }
    return points;
}

double deepest_of(const PlanResult& plan, const Project& project, const Fixture& clamp, double by) {
    double most = 0;
    const std::vector<Vec3> points = points_on(clamp, by);
    for (const auto& o : plan.operations)
        most = std::max(most, deepest(o->program, *find_tool(project.tools, o->program.tool_number), points));
    return most;
}

double deepest_found(const std::vector<VerifyProgram>& programs) {
    double most = 0;
    for (const Collision& c : fixture_touches(programs, 1e-3, {}))
        most = std::max(most, c.depth);
    return most;
}

/// Random clamps for each kind of operation: one, or as many as FACETMILL_FIXTURES says.
int clamps_per_kind() {
    bool is_number = false;
    const int asked = qEnvironmentVariableIntValue("FACETMILL_FIXTURES", &is_number);
    return is_number ? asked : 1;
}

} // namespace

class TestFixtures : public QObject {
    Q_OBJECT

private slots:
    void every_kind_keeps_off_data() {
        QTest::addColumn<int>("which");
        for (int i = 0; i < int(std::size(held_cases)); ++i)
            QTest::newRow(held_cases[i].kind) << i;
    }

    /// The path made without the clamp tells whether the verifier sees what the points see; the path made
    /// with it must keep nine tenths of the clearance.
    void every_kind_keeps_off() {
        QFETCH(int, which);
        const HeldCase& c = held_cases[which];
        HeldJob job(c);
        const auto without = job.plan();
        Random rng(40 + std::uint64_t(which));
        int planned = 0, in_the_way = 0;
        // A few valleys are seldom in a clamp's way.
        const int enough = clamps_per_kind(), most = 10 * enough;
        for (int trial = 0; trial < enough || ((planned == 0 || in_the_way == 0) && trial < most); ++trial) {
            const Fixture clamp = random_clamp(rng, c.turns);
            job.project.fixtures = {clamp};
            const auto prepared = Planner().prepare(job.project, {});
            std::vector<VerifyProgram> programs = verify_programs(job.project, without);
            stand_fixtures(programs, *prepared);
            const double seen = deepest_of(*without, job.project, clamp, 0), found = deepest_found(programs);
            in_the_way += seen > 0.1;
            const QString at = QString("trial %1: points %2, verifier %3").arg(trial).arg(seen).arg(found);
            QVERIFY2(found > seen - 0.1 && found < seen + 0.6, qPrintable(at));
            std::shared_ptr<const PlanResult> with;
            try {
                with = job.plan();
            } catch (const Error& e) {
                QVERIFY2(e.code() == ErrorCode::empty_result, e.what());
                continue;
            }
            ++planned;
            const double near = deepest_of(*with, job.project, clamp, 0.85 * kept),
                         told = deepest_found(verify_programs(job.project, with));
            QVERIFY2(near == 0 && told == 0,
                     qPrintable(QString("trial %1: %2 in the clearance, %3 in the clamp")
                                    .arg(trial)
                                    .arg(near)
                                    .arg(told)));
        }
        QVERIFY(planned > 0 && in_the_way > 0);
    }

    /// What finishing leaves out for a clamp stands beside its other passes, in a cavity deeper than the
    /// flutes are long: the shank keeps out of that, too.
    void what_is_left_for_a_clamp_keeps_the_shank_out() {
        QTemporaryDir dir;
        const std::filesystem::path folder(dir.path().toStdString());
        save_stl(*make_sample("mould", 0.05, {}), folder / "mould.stl", LengthUnit::mm, {});
        Project project = parse_project(R"({ "facetmill": 2, "units": "mm", "part": { "file": "mould.stl" },
            "tools": [ { "number": 1, "diameter": 10, "flute_length": 40 },
                       { "number": 2, "diameter": 8, "corner_radius": 4, "flute_length": 6, "shank_length": 40 } ],
            "setups": [ { "name": "Top", "stock": { "kind": "box", "margin": [2, 2, 1] },
              "fixtures": [ { "name": "Clamp", "kind": "box", "size": [20, 15, 12], "translate": [-45, 0, 0] },
                            { "name": "Bolt", "kind": "cylinder", "diameter": 12, "height": 20, "translate": [35, 30, 0] } ],
              "operations": [ { "kind": "rough", "name": "Rough", "tool": 1, "tolerance": 1, "allowance": 0.8 },
                              { "kind": "finish3", "name": "Finish", "tool": 2, "tolerance": 0.3 } ] } ] })",
                                        "mould");
        project.path = folder / "mould.facetmill";
        const auto plan = Planner().plan(project, {}, {});
        VerifySettings settings = verify_settings(project, plan.get());
        settings.resolution = 0.5;
        const Verification v =
            verify(*plan->part->mesh, plan->stock, verify_programs(project, plan), settings, {});
        QVERIFY2(v.collisions.empty(), findings_line(project, verify_programs(project, plan), v).c_str());
        QVERIFY(std::any_of(v.uncut.begin(), v.uncut.end(),
                            [](const UncutReason& r) { return r.why == UncutReason::Why::fixture; }));
    }
};

FACETMILL_TEST(TestFixtures)
#include "test_fixtures.moc"
