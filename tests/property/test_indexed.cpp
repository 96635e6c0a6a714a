// Operations that keep another tool axis than +Z: each is the same as an upright one on a part that is
// turned, its tool stays off what holds the stock, and operations of several axes know what the others have
// cut. Judges are the verifier, the naive check, and points below the stock that know nothing of planners.
#include "core/job/axis_view.h"
#include "core/job/chain_verification.h"
#include "core/job/planner.h"
#include "core/job/setup_plan.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "tests/property/held_job.h"
#include "tests/support/error_code.h"
#include "tests/support/naive_check.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <map>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr const char* kept_kinds[] = {"rough", "finish3", "cleanup", "waterline", "steep_shallow", "scallop"};

/// A round body with bumps and hollows all over, which stands on its lowest point.
Mesh bumpy_body() {
    Mesh mesh;
    constexpr int around = 40, rings = 24;
    const auto place = [](double polar, double turn) {
        const double r = 9 + 1.2 * std::sin(3 * turn) * std::sin(polar) + 0.9 * std::cos(4 * polar);
        return Vec3(
            Vec3(1.3 * std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar))
            * r);
    };
    mesh.vertices.push_back(place(0, 0));
    for (int i = 1; i < rings; ++i)
        for (int k = 0; k < around; ++k)
            mesh.vertices.push_back(place(pi * i / rings, 2 * pi * k / around));
    mesh.vertices.push_back(place(pi, 0));
    const auto at = [&](int i, int k) { return Index(1 + (i - 1) * around + (k + around) % around); };
    const auto last = Index(mesh.vertices.size() - 1);
    for (int k = 0; k < around; ++k) {
        mesh.facets.push_back({0, at(1, k), at(1, k + 1)});
        mesh.facets.push_back({last, at(rings - 1, k + 1), at(rings - 1, k)});
        for (int i = 1; i + 1 < rings; ++i) {
            mesh.facets.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.facets.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return mesh;
}

/// A block of 60 x 50 x 40 mm on z = 0 with a bowl in each of its six sides.
Mesh six_bowls() {
    Mesh mesh;
    const Vec3 size(60, 50, 40);
    constexpr int n = 20;
    std::map<std::array<long, 3>, Index> known;
    const auto vertex = [&](const Vec3& p) {
        const auto [at, fresh] =
            known.try_emplace({std::lround(p.x() * 1e6), std::lround(p.y() * 1e6), std::lround(p.z() * 1e6)},
                              Index(mesh.vertices.size()));
        if (fresh) mesh.vertices.push_back(p);
        return at->second;
    };
    const auto place = [&](int axis, int side, int i, int j) {
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
        Vec3 p;
        p[a] = size[a] * (double(i) / n - 0.5);
        p[b] = size[b] * (double(j) / n - 0.5);
        const double r = Vec2(p[a], p[b]).norm() / (0.4 * std::min(size[a], size[b]));
        p[axis] = side * (0.5 * size[axis] - (r < 1 ? 6 * std::pow(1 - r * r, 2) : 0));
        return Vec3(p + Vec3(0, 0, 0.5 * size.z()));
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    std::array<Index, 4> q{
                        vertex(place(axis, side, i, j)), vertex(place(axis, side, i + 1, j)),
                        vertex(place(axis, side, i + 1, j + 1)), vertex(place(axis, side, i, j + 1))};
                    if (side < 0) std::swap(q[1], q[3]);
                    mesh.facets.push_back({q[0], q[1], q[2]});
                    mesh.facets.push_back({q[0], q[2], q[3]});
                }
    return mesh;
}

/// From above and along X in one clamping, from below and along Y in the next, the last side upright in a
/// third.
constexpr const char* six_sides = R"({ "facetmill": 2, "units": "mm", "part": { "file": "six.stl" },
    "tools": [ { "number": 1, "diameter": 10, "flute_length": 45, "shank_length": 20, "holder": [{ "diameter": 30, "length": 40 }] },
               { "number": 2, "diameter": 8, "corner_radius": 4, "flute_length": 45, "shank_length": 30 } ],
    "setups": [
      { "name": "Top", "machine": "trunnion-ac", "stock": { "kind": "box", "margin": [2, 2, 2] },
        "boundaries": [ { "name": "Face", "kind": "slope", "slope": [0, 60] } ],
        "operations": [
          { "kind": "rough", "name": "Rough top", "tool": 1, "tolerance": 1, "allowance": 0.4, "depth": 5 },
          { "kind": "rough", "name": "Rough right", "tool": 1, "tolerance": 1, "allowance": 0.4, "depth": 5, "tool_axis": [1, 0, 0], "below_bottom": 4 },
          { "kind": "rough", "name": "Rough left", "tool": 1, "tolerance": 1, "allowance": 0.4, "depth": 5, "tool_axis": [-1, 0, 0], "below_bottom": 4 },
          { "kind": "finish3", "name": "Top face", "tool": 2, "tolerance": 0.15, "boundary": "Face" },
          { "kind": "finish3", "name": "Right face", "tool": 2, "tolerance": 0.15, "boundary": "Face", "tool_axis": [1, 0, 0], "below_bottom": 4 },
          { "kind": "finish3", "name": "Left face", "tool": 2, "tolerance": 0.15, "boundary": "Face", "tool_axis": [-1, 0, 0], "below_bottom": 4 } ] },
      { "name": "Bottom", "machine": "trunnion-ac", "place": { "rotate": [180, 0, 0], "translate": [0, 0, 40] }, "stock": { "kind": "rest" },
        "boundaries": [ { "name": "Face", "kind": "slope", "slope": [0, 60] } ],
        "operations": [
          { "kind": "rough", "name": "Rough bottom", "tool": 1, "tolerance": 1, "allowance": 0.4, "depth": 5 },
          { "kind": "rough", "name": "Rough rear", "tool": 1, "tolerance": 1, "allowance": 0.4, "depth": 5, "tool_axis": [0, -1, 0], "below_bottom": 4 },
          { "kind": "finish3", "name": "Bottom face", "tool": 2, "tolerance": 0.15, "boundary": "Face" },
          { "kind": "finish3", "name": "Rear face", "tool": 2, "tolerance": 0.15, "boundary": "Face", "tool_axis": [0, -1, 0], "below_bottom": 4 } ] },
      { "name": "Front", "machine": "generic-3-axis", "place": { "rotate": [-90, 0, 0], "translate": [0, 0, 25] }, "stock": { "kind": "rest" },
        "operations": [
          { "kind": "rough", "name": "Rough front", "tool": 1, "tolerance": 1, "allowance": 0.4, "depth": 5 },
          { "kind": "finish3", "name": "Front face", "tool": 2, "tolerance": 0.15 } ] } ] })";

class IndexedJob {
    QTemporaryDir dir_;

public:
    Project project;

    IndexedJob() {
        const std::filesystem::path folder(dir_.path().toStdString());
        save_stl(bumpy_body(), folder / "part.stl", LengthUnit::mm, {});
        project.path = folder / "p.facetmill";
        project.part.file = "part.stl";
        project.machine = "trunnion-ac";
        project.tools = {holding(ball_tool(4), 1), holding(ball_tool(8), 2)};
        for (Tool& tool : project.tools)
            tool.flute_length = 30;
    }
    Operation& add(const std::string& kind, const Vec3& axis, long tool = 1) {
        auto op = make_operation(kind);
        op->common().name = kind + std::to_string(project.operations.size());
        op->common().tolerance = 0.2;
        op->common().tool = tool;
        op->common().tool_axis = {axis.x(), axis.y(), axis.z()};
        if (kind == "cleanup") op->set("previous_tool", 2L);
        if (kind == "rough") op->set("depth", 2.0);
        project.operations.push_back(std::move(op));
        return *project.operations.back();
    }
    std::shared_ptr<const PlanResult> plan() const { return Planner().plan(project, {}, {}); }
};

std::vector<NaiveProgram> naive_programs(const Project& project, const PlanResult& plan) {
    std::vector<NaiveProgram> all;
    for (const auto& o : plan.operations) {
        const Tool& tool = *find_tool(project.tools, o->program.tool_number);
        const double shank = tool.flute_length + tool.shank_length;
        all.push_back({o->program.cutter,
                       o->program.motions.motions,
                       {{0.5 * tool.shank_diameter, tool.flute_length, shank},
                        {0.5 * tool.holder[0].diameter, shank, shank + tool.holder[0].length}},
                       {}});
    }
    return all;
}

/// Points a little below the plane that the stock stands on, all over where it stands and 5 mm beside.
std::vector<Vec3> points_below(const Box3& stock) {
    std::vector<Vec3> points;
    constexpr double step = 0.7, beside = 5, below = 0.02;
    for (double x = stock.lo.x() - beside; x <= stock.hi.x() + beside; x += step)
        for (double y = stock.lo.y() - beside; y <= stock.hi.y() + beside; y += step)
            points.emplace_back(x, y, stock.lo.z() - below);
    return points;
}

/// The path of an indexed operation and that of an upright one in a setup that is turned accordingly.
void compare_paths(const IndexedJob& asked, const IndexedJob& turned, const Vec3& axis) {
    const auto a = asked.plan(), b = turned.plan();
    const OperationResult &one = *a->operations.at(0), &other = *b->operations.at(0);
    QVERIFY(one.program.multi_axis && !other.program.multi_axis);
    const Mat3 turn = turn_upright(axis);
    QVERIFY(one.path.passes.size() > 1);
    QCOMPARE(one.path.passes.size(), other.path.passes.size());
    double apart = 0;
    for (std::size_t p = 0; p < one.path.passes.size(); ++p) {
        const std::vector<CutterLocation>&cl = one.path.passes[p].cl, &upright = other.path.passes[p].cl;
        QCOMPARE(cl.size(), upright.size());
        for (std::size_t i = 0; i < cl.size(); ++i) {
            apart = std::max(apart, (turn * cl[i].tip - upright[i].tip).norm());
            QVERIFY((cl[i].axis - axis).norm() < 1e-15);
        }
    }
    QVERIFY2(apart < 1e-5, qPrintable(QString("%1 mm").arg(apart)));
    QCOMPARE(one.program.motions.motions.size(), other.program.motions.motions.size());
}

Vec3 random_axis(Random& rng) {
    const double height = uniform(rng, -0.2, 0.95), angle = uniform(rng, -pi, pi),
                 across = std::sqrt(1 - height * height);
    return {across * std::cos(angle), across * std::sin(angle), height};
}

/// Random axes for each kind of operation: one, or as many as FACETMILL_INDEXED says.
int axes_per_kind() {
    bool is_number = false;
    const int asked = qEnvironmentVariableIntValue("FACETMILL_INDEXED", &is_number);
    return is_number ? asked : 1;
}

} // namespace

class TestIndexed : public QObject {
    Q_OBJECT

private slots:
    void axes_are_turned_upright() {
        Random rng(5);
        for (int trial = 0; trial < 1000; ++trial) {
            Vec3 axis = random_axis(rng);
            if (trial < 6) axis = (trial % 2 == 0 ? 1 : -1) * Vec3(Vec3::Unit(trial / 2));
            const Mat3 turn = turn_upright(axis);
            QVERIFY((turn * axis - Vec3::UnitZ()).norm() < 1e-12);
            QVERIFY((turn * turn.transpose() - Mat3::Identity()).norm() < 1e-12 && turn.determinant() > 0);
            // No longer than it has to be.
            const double angle = std::acos(std::clamp(0.5 * (turn.trace() - 1), -1.0, 1.0));
            QVERIFY(std::abs(angle - std::acos(std::clamp(axis.z(), -1.0, 1.0))) < 1e-6);
        }
    }

    void an_axis_is_a_turned_setup_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<int>("side");
        for (const char* kind : {"rough", "finish3"})
            for (int side = 0; side < 4; ++side)
                if (all_cases || (*kind == 'r') == (side % 3 == 0))
                    QTest::addRow("%s %d", kind, side) << QString(kind) << side;
    }

    /// Quarter turns have no rounding, but sums of normals have another order: the same path, whichever way
    /// it was asked for.
    void an_axis_is_a_turned_setup() {
        QFETCH(QString, kind);
        QFETCH(int, side);
        const Vec3 axis = (side % 2 == 0 ? 1 : -1) * Vec3(Vec3::Unit(side / 2));
        IndexedJob asked, turned;
        asked.add(kind.toStdString(), axis).common().below_bottom = 1000;
        turned.add(kind.toStdString(), Vec3::UnitZ()).common().below_bottom = 1000;
        const Mat3 turn = turn_upright(axis);
        turned.project.place.rotate = angles_of(turn);
        compare_paths(asked, turned, axis);
    }

    void any_axis_is_verified_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : kept_kinds)
            QTest::newRow(kind) << QString(kind);
    }

    /// The tool comes to the part from any side, after roughing from above: neither judge finds it in the
    /// part, nor shank or holder in the stock, nor anything of it below the stock.
    void any_axis_is_verified() {
        QFETCH(QString, kind);
        Random rng(70 + std::uint64_t(kind.size()));
        int planned = 0;
        for (int trial = 0; trial < axes_per_kind(); ++trial) {
            const Vec3 axis = random_axis(rng);
            IndexedJob job;
            job.project.stock.margin = {1, 1, 1};
            job.add("rough", Vec3::UnitZ(), 2);
            if (kind == "cleanup") job.add("finish3", axis, 2);
            job.add(kind.toStdString(), axis);
            std::shared_ptr<const PlanResult> plan;
            try {
                plan = job.plan();
            } catch (const Error& e) {
                QVERIFY2(e.code() == ErrorCode::empty_result, e.what());
                continue;
            }
            ++planned;
            const auto at = [&](const std::string& what) {
                return QByteArray::fromStdString(what + ", axis " + format_number(axis.x(), 4) + ", "
                                                 + format_number(axis.y(), 4) + ", "
                                                 + format_number(axis.z(), 4));
            };
            const std::vector<VerifyProgram> programs = verify_programs(job.project, plan);
            VerifySettings settings = verify_settings(job.project, plan.get());
            settings.sample_spacing = settings.resolution = 0.5;
            const Verification v = verify(*plan->part->mesh, plan->stock, programs, settings, {});
            QVERIFY2(!v.gouged() && v.collisions.empty(), at(findings_line(job.project, programs, v)));
            const NaiveResult naive =
                naive_check(*plan->part->mesh, naive_programs(job.project, *plan),
                            {.spacing = 1.5, .tolerance = 0.2, .stock = plan->stock.box, .pose_share = 0.2});
            QVERIFY2(naive.gouge_max <= v.used.gouge_limit,
                     at("naive gouge " + format_number(naive.gouge_max, 4)));
            QVERIFY2(naive.touch_max == 0, at("naive touch " + format_number(naive.touch_max, 4)));
            const std::vector<Vec3> below = points_below(plan->stock.box);
            for (const auto& o : plan->operations) {
                const double depth =
                    deepest(o->program, *find_tool(job.project.tools, o->program.tool_number), below);
                QVERIFY2(o->program.motions.motions.empty() || depth < 0.02,
                         at(o->name + " is below the stock by " + format_number(depth, 4)));
            }
        }
        QVERIFY(planned > 0);
    }

    /// What another axis has cut is not cut again.
    void the_stock_is_known_from_every_side() {
        IndexedJob alone, after;
        for (IndexedJob* job : {&alone, &after}) {
            job->project.stock.margin = {3, 3, 3};
            if (job == &after) {
                job->add("rough", Vec3::UnitZ());
                job->add("rough", Vec3::UnitX());
            }
            job->add("rough", -Vec3::UnitY());
        }
        const double whole = alone.plan()->operations.back()->totals.cut_length,
                     left = after.plan()->operations.back()->totals.cut_length;
        QVERIFY2(left < 0.8 * whole, qPrintable(QString("%1 of %2 mm").arg(left).arg(whole)));
    }

    /// A part with something on all of its sides comes out whole of three clampings; without the last of them
    /// the side that is left is no axis's to see, and is named.
    void six_sides_in_three_setups() {
        QTemporaryDir dir;
        const std::filesystem::path folder(dir.path().toStdString());
        save_stl(six_bowls(), folder / "six.stl", LengthUnit::mm, {});
        Project project = parse_project(six_sides, "six");
        project.path = folder / "six.facetmill";
        const auto judge = [](const std::vector<SetupPlan>& setups) {
            for (const SetupPlan& setup : setups)
                setup.plan->check_reach();
            const std::span<const SetupPlan> chain = stock_chains(setups).at(0);
            VerifySettings settings = chain_settings(chain);
            settings.resolution = settings.sample_spacing = all_cases ? 0.5 : 0.8;
            return judge_chain(chain, planned_programs(chain), settings, {}).result;
        };
        const auto unseen = [](const Verification& v) {
            double area = 0;
            for (const UncutReason& r : v.uncut)
                if (r.why == UncutReason::Why::not_seen) area += r.area;
            return area;
        };
        SetupPlanners planners;
        std::vector<SetupPlan> setups = plan_setups(project, {}, planners, {});
        QCOMPARE(setups.size(), std::size_t(3));
        const auto whole = judge(setups);
        QVERIFY2(whole->passed(), qPrintable(QString("uncut %1, gouge %2, collisions %3")
                                                 .arg(whole->uncut_share)
                                                 .arg(whole->figures.gouge_max)
                                                 .arg(whole->collisions.size())));
        QVERIFY2(unseen(*whole) < 1, qPrintable(QString::number(unseen(*whole))));
        setups.pop_back();
        QVERIFY(unseen(*judge(setups)) > 400); // the bowl, of 1810 mm^2 with its rim
    }

    void what_is_known_is_not_planned_again() {
        IndexedJob job;
        job.add("rough", Vec3::UnitZ());
        job.add("rough", Vec3(1, 0, 1));
        job.add("finish3", Vec3(1, 0, 1));
        Planner planner;
        const auto first = planner.plan(job.project, {}, {});
        const PlannerWork work = planner.work();
        job.project.operations[1]->common().feed = 700;
        const auto second = planner.plan(job.project, {}, {});
        QCOMPARE(planner.work().strategies, work.strategies);
        QCOMPARE(planner.work().links, work.links);
        // Another clearance links again, by the path as it was planned; no digit is another than in a fresh
        // plan.
        job.project.operations[2]->common().clearance = 8;
        const auto third = planner.plan(job.project, {}, {}), fresh = job.plan();
        const auto& a = third->operations[2]->program.motions.motions;
        const auto& b = fresh->operations[2]->program.motions.motions;
        QCOMPARE(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i)
            QVERIFY(a[i].to.tip == b[i].to.tip && a[i].to.axis == b[i].to.axis);
        // Planned by itself it is the same, since what those before it cut is asked of them.
        const auto one = Planner().plan(job.project, job.project.operations[2]->common().name, {});
        QCOMPARE(one->operations.at(0)->program.motions.motions.size(), b.size());
    }

    void boundaries_are_seen_along_the_axis_data() {
        QTest::addColumn<int>("kind");
        for (const auto kind : {Boundary::Kind::slope, Boundary::Kind::curve, Boundary::Kind::silhouette})
            QTest::newRow(boundary_kind_name(kind).c_str()) << int(kind);
    }

    /// Slopes, curves and outlines are those that the tool sees.
    void boundaries_are_seen_along_the_axis() {
        QFETCH(int, kind);
        const Vec3 axis = Vec3::UnitX();
        const Mat3 turn = turn_upright(axis);
        IndexedJob asked, turned;
        turned.project.place.rotate = angles_of(turn);
        Boundary boundary;
        boundary.name = "Here";
        boundary.kind = Boundary::Kind(kind);
        boundary.slope = {0, radians(35)};
        boundary.offset = kind == int(Boundary::Kind::silhouette) ? -3 : 0;
        const Vec3 corners[] = {{0, -5, 3}, {0, 4, 2}, {0, 2, 9}};
        for (const Vec3& at : corners)
            boundary.curve.push_back({{at.x(), at.y(), at.z()}});
        asked.project.boundaries.push_back(boundary);
        for (int k = 0; k < 3; ++k) {
            const Vec3 at = turn * corners[k];
            boundary.curve[std::size_t(k)].at = {at.x(), at.y(), at.z()};
        }
        turned.project.boundaries.push_back(boundary);
        asked.add("finish3", axis).common().below_bottom = 1000;
        turned.add("finish3", Vec3::UnitZ()).common().below_bottom = 1000;
        for (IndexedJob* job : {&asked, &turned})
            job->project.operations[0]->common().boundary = "Here";
        compare_paths(asked, turned, axis);
    }

    void axes_that_cannot_be_are_refused() {
        IndexedJob job;
        Operation& op = job.add("cleanup", Vec3::Zero());
        QCOMPARE(code_of([&] { check_project(job.project); }), std::string("out_of_range"));
        op.common().tool_axis = {0, 0, 2};
        check_project(job.project);
        QVERIFY(op.three_axis());
        op.common().tool_axis = {1, 0, 0};
        check_project(job.project);
        op.set("tilt_limit", radians(20.0));
        QCOMPARE(code_of([&] { check_project(job.project); }), std::string("out_of_range"));
        // A machine without rotary axes holds no other axis than its own.
        IndexedJob upright;
        upright.add("finish3", Vec3(1, 0, 1));
        upright.project.machine = "generic-3-axis";
        const auto plan = upright.plan();
        QCOMPARE(code_of([&] { plan->check_reach(); }), std::string("limit_exceeded"));
    }

    void files_keep_the_axis() {
        IndexedJob job;
        job.add("finish3", Vec3(1, 0, 1));
        job.add("finish3", Vec3::UnitZ());
        const std::string text = project_to_json(job.project);
        QCOMPARE(text.find("tool_axis"), text.rfind("tool_axis"));
        const Project read = parse_project(text, "p");
        QVERIFY(read.operations[0]->common().tool_axis == (std::array<double, 3>{1, 0, 1}));
        QCOMPARE(project_to_json(read), text);
    }
};

FACETMILL_TEST(TestIndexed)
#include "test_indexed.moc"
