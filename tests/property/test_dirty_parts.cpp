// Planners, verifier and the naive check over meshes that were made dirty at random: facets flipped, doubled,
// loosened, folded back on themselves and drawn out to needles. Whatever one of the two judges finds, the
// other confirms.
#include "core/job/planner.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "tests/support/naive_check.h"
#include "tests/support/part_meshes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double dirty_tolerance = 0.2;

/// A closed block with a wavy top and a valley.
Mesh block() {
    const auto top = [](double x, double y) {
        return 1.2 * std::sin(0.4 * x) * std::cos(0.3 * y) - 3 * std::exp(-0.6 * (x - 2) * (x - 2));
    };
    constexpr int nx = 20, ny = 10;
    Mesh mesh = height_field(top, Vec2(-9, -7), Vec2(9, 7), nx, ny);
    // Walls down to a level bottom.
    std::vector<Index> rim;
    for (int i = 0; i < nx; ++i)
        rim.push_back(Index(i));
    for (int j = 0; j < ny; ++j)
        rim.push_back(Index(j * (nx + 1) + nx));
    for (int i = nx; i > 0; --i)
        rim.push_back(Index(ny * (nx + 1) + i));
    for (int j = ny; j > 0; --j)
        rim.push_back(Index(j * (nx + 1)));
    const auto n = Index(rim.size()), first = Index(mesh.vertices.size());
    for (const Index v : rim)
        mesh.vertices.emplace_back(mesh.vertices[v].x(), mesh.vertices[v].y(), -8);
    const auto middle = Index(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, -8);
    for (Index i = 0; i < n; ++i) {
        const Index j = (i + 1) % n;
        mesh.facets.push_back({rim[i], first + i, first + j});
        mesh.facets.push_back({rim[i], first + j, rim[j]});
        mesh.facets.push_back({middle, first + j, first + i});
    }
    return mesh;
}

Mesh dirtied(const Mesh& clean, Random& rng) {
    Mesh dirty;
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto at = Index(dirty.vertices.size());
        for (const Vec3& v : {a, b, c})
            dirty.vertices.push_back(v);
        dirty.facets.push_back({at, at + 1, at + 2});
    };
    for (std::size_t f = 0; f < clean.facet_count(); ++f) {
        const Vec3 &a = clean.corner(f, 0), &b = clean.corner(f, 1), &c = clean.corner(f, 2);
        const bool turn = whole(rng, 0, 4) == 0;
        turn ? add(a, c, b) : add(a, b, c);
        const int more = whole(rng, 0, 40);
        if (more == 0) add(a, b, c);                        // doubled
        if (more == 1) add(a, c, b);                        // folded back
        if (more == 2) add(a, b, a + 0.5 * (b - a));        // a needle without area
        if (more == 3) add(a, b, c + Vec3(1e-5, 0, -1e-5)); // loose
    }
    return dirty;
}

struct DirtyWork { // what is judged
    std::shared_ptr<const PreparedPart> part;
    StockSolid stock;
    std::vector<VerifyProgram> programs;
    VerifySettings settings;
};

DirtyWork planned(const Mesh& mesh, const std::string& machine, const std::vector<std::string>& kinds) {
    QTemporaryDir dir;
    const std::filesystem::path folder(dir.path().toStdString());
    save_stl(mesh, folder / "part.stl", LengthUnit::mm, {});
    Project project;
    project.path = folder / "p.facetmill";
    project.part.file = "part.stl";
    project.machine = machine;
    project.stock.margin = {0.5, 0.5, 1};
    long number = 0;
    for (const double diameter : {4.0, 2.0}) {
        Tool tool = ball_tool(diameter);
        tool.number = ++number;
        tool.name = "Ball " + std::to_string(number);
        tool.flute_length = 12;
        tool.shank_diameter = diameter;
        project.tools.push_back(tool);
    }
    for (const std::string& kind : kinds) {
        auto op = make_operation(kind);
        op->common().name = kind;
        op->common().tolerance = dirty_tolerance;
        if (kind == "cleanup") {
            op->common().tool = 2;
            op->set("previous_tool", 1L);
        }
        project.operations.push_back(std::move(op));
    }
    Planner planner;
    const auto plan = planner.plan(project, {}, Progress());
    DirtyWork job{plan->part, plan->stock, verify_programs(project, plan),
                  verify_settings(project, plan.get())};
    // Five axes take some ten times as long.
    job.settings.resolution = job.settings.sample_spacing = kinds.front() == "finish5" ? 0.8 : 0.35;
    return job;
}

struct Verdicts {
    Verification verifier;
    NaiveResult naive;
    double ours() const { return std::max(verifier.figures.gouge_max, verifier.border.gouge_max); }
};

Verdicts judged(const DirtyWork& job) {
    std::vector<NaiveProgram> naive;
    for (const VerifyProgram& p : job.programs)
        naive.push_back({p.tool.cutter.cutter(), p.motions->motions});
    NaiveOptions options;
    options.spacing = job.settings.sample_spacing;
    options.tolerance = dirty_tolerance;
    options.stock = job.stock.box;
    options.pose_share = 0.1;
    return {verify(*job.part->mesh, job.stock, job.programs, job.settings, Progress()),
            naive_check(*job.part->mesh, naive, options)};
}

/// The same programs, each motion at feed deeper by this.
void lower(DirtyWork& job, double depth) {
    for (VerifyProgram& p : job.programs) {
        auto motions = std::make_shared<ToolMotions>(*p.motions);
        for (Motion& m : motions->motions)
            if (m.kind != MotionKind::rapid) m.to.tip -= depth * m.to.axis;
        p.motions = motions;
    }
}

} // namespace

class TestDirtyParts : public QObject {
    Q_OBJECT
private slots:
    /// The naive check itself: known gouges and shares.
    void the_naive_check_finds_what_is_there() {
        const Mesh part = box(Vec3(-10, -6, -5), Vec3(10, 6, 0));
        NaiveProgram program{AptCutter::flat(4, 20), {}};
        const auto to = [&](MotionKind kind, double x, double y, double z) {
            program.motions.push_back({kind, {Vec3(x, y, z), Vec3::UnitZ()}, no_index, no_index});
        };
        to(MotionKind::rapid, -14, -6, 5);
        for (double y = -6; y <= 2; y += 2) { // up to y = 4 of 6
            to(MotionKind::cut, -14, y, 0);
            to(MotionKind::cut, 14, y, 0);
            to(MotionKind::rapid, 14, y, 5);
            to(MotionKind::rapid, -14, y + 2, 5);
        }
        NaiveOptions options;
        options.spacing = 0.2;
        options.stock = {Vec3(-10, -6, -5), Vec3(10, 6, 1)};
        NaiveResult r = naive_check(part, {&program, 1}, options);
        QVERIFY(r.gouge_max < 1e-9);
        QVERIFY(std::abs(r.area_to_cut - 240) < 1e-6);
        QVERIFY2(std::abs(r.uncut_share() - 2.0 / 12) < 0.02, qPrintable(QString::number(r.uncut_share())));
        QVERIFY(std::abs(r.feed_length - 5 * 28 - 4 * 5 - 0) < 30);
        // Of each row of 28 mm what is farther than 2.5 mm from the block is in the air.
        QVERIFY2(r.air_length > 5 * 2 && r.air_length < 5 * 12, qPrintable(QString::number(r.air_length)));
        to(MotionKind::cut, -14, -3, -0.3);
        to(MotionKind::cut, 0, -3, -0.3);
        r = naive_check(part, {&program, 1}, options);
        QVERIFY2(std::abs(r.gouge_max - 0.3) < 1e-6, qPrintable(QString::number(r.gouge_max)));
    }

    /// A shank above the step that its cutter leaves, then below the top of it.
    void the_naive_check_finds_shanks_in_stock() {
        const Mesh part = box(Vec3(-10, -6, -8), Vec3(10, 6, -5));
        NaiveProgram program{AptCutter::flat(4, 3), {}, {{3, 3, 10}}};
        const auto to = [&](MotionKind kind, double x, double y, double z) {
            program.motions.push_back({kind, {Vec3(x, y, z), Vec3::UnitZ()}, no_index, no_index});
        };
        to(MotionKind::rapid, -14, 0, 5);
        to(MotionKind::cut, -14, 0, -3); // flutes as deep as the step
        to(MotionKind::cut, 14, 0, -3);
        NaiveOptions options;
        options.spacing = 0.5;
        options.stock = {Vec3(-10, -6, -8), Vec3(10, 6, 0)};
        NaiveResult r = naive_check(part, {&program, 1}, options);
        QVERIFY2(r.touch_max == 0, qPrintable(QString::number(r.touch_max)));
        for (Motion& m : program.motions)
            m.to.tip.z() -= 1.5; // now the shank's end is 1.5 below the top, which no flute reaches
        r = naive_check(part, {&program, 1}, options);
        QVERIFY2(r.touch_max > 1 && r.touch_max < 1.5 + 1e-9, qPrintable(QString::number(r.touch_max)));
        QCOMPARE(r.touch_motion, std::size_t(2));
    }

    /// Half a turn about a round part in one motion: its surface is kept, where a straight one would cut it.
    void the_naive_check_turns_parts() {
        const Mesh part = box(Vec3(-10, -1, -1), Vec3(10, 1, 1));
        NaiveProgram program{AptCutter::flat(4, 20), {}, {}, TurningAxis{}};
        const double r = std::sqrt(2.0);
        program.motions.push_back({MotionKind::rapid, {Vec3(0, 0, r), Vec3::UnitZ()}, no_index, no_index});
        program.motions.push_back({MotionKind::cut,
                                   {Vec3(4, -0.95 * r, -std::sqrt(1 - 0.95 * 0.95) * r),
                                    Vec3(0, -0.95, -std::sqrt(1 - 0.95 * 0.95))},
                                   no_index,
                                   no_index});
        NaiveOptions options;
        options.spacing = 0.2;
        options.stock = {Vec3(-10, -2, -2), Vec3(10, 2, 2)};
        options.round_axis = 0;
        options.stock_radius = 2;
        NaiveResult checked = naive_check(part, {&program, 1}, options);
        QVERIFY2(checked.gouge_max < 1e-9, qPrintable(QString::number(checked.gouge_max)));
        QVERIFY2(checked.feed_length > 4.5, qPrintable(QString::number(checked.feed_length)));
        program.turning.reset();
        checked = naive_check(part, {&program, 1}, options);
        QVERIFY2(checked.gouge_max > 0.3, qPrintable(QString::number(checked.gouge_max)));
    }

    void judges_agree_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QStringList>("kinds");
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("rounds");
        QTest::newRow("3 axes") << "generic-3-axis" << QStringList{"rough", "finish3"} << 0 << 3;
        QTest::newRow("clean-up") << "generic-3-axis" << QStringList{"finish3", "cleanup"} << 1 << 2;
        QTest::newRow("5 axes") << "trunnion-ac" << QStringList{"finish5"} << 1 << 2;
    }
    void judges_agree() {
        QFETCH(QString, machine);
        QFETCH(QStringList, kinds);
        QFETCH(int, first);
        QFETCH(int, rounds);
        std::vector<std::string> names;
        for (const QString& kind : kinds)
            names.push_back(kind.toStdString());
        Random rng(11);
        const Mesh clean = block();
        for (int round = first; round < rounds; ++round) {
            const Mesh mesh = round == 0 ? clean : dirtied(clean, rng);
            DirtyWork job = planned(mesh, machine.toStdString(), names);
            const Verdicts as_planned = judged(job);
            const double limit = as_planned.verifier.used.gouge_limit;
            const auto text = [&](const Verdicts& v) {
                return qPrintable(QString("round %1: gouge %2, naive %3, limit %4; uncut %5, naive %6")
                                      .arg(round)
                                      .arg(v.ours())
                                      .arg(v.naive.gouge_max)
                                      .arg(limit)
                                      .arg(v.verifier.uncut_share)
                                      .arg(v.naive.uncut_share()));
            };
            // What is planned is right, whatever the facets' order and sides; both say so.
            QVERIFY2(as_planned.ours() <= limit && as_planned.naive.gouge_max <= limit, text(as_planned));
            // Of a dirty mesh little is far from open borders, and a sample weighs more.
            constexpr double alike = 0.04;
            QVERIFY2(std::abs(as_planned.verifier.uncut_share - as_planned.naive.uncut_share()) < alike,
                     text(as_planned));
            // What is not, is found by both, as deep.
            lower(job, 0.1);
            const Verdicts low = judged(job);
            QVERIFY2(low.ours() > 0.08 && std::abs(low.ours() - low.naive.gouge_max) < 0.02, text(low));
            QVERIFY2(std::abs(low.verifier.uncut_share - low.naive.uncut_share()) < alike, text(low));
        }
    }
};

FACETMILL_TEST(TestDirtyParts)
#include "test_dirty_parts.moc"
