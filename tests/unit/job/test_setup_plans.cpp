// Setups planned one after the other and judged as one: a block with a hollow in each of its six sides, of
// which three setups see three.
#include "core/job/program_files.h"
#include "core/job/report.h"
#include "core/job/setup_plan.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/setup/machine.h"
#include "core/verify/axis_courses.h"
#include "core/verify/stock_surface.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/job/block_job.h"

#include <QTest>

#include <cmath>
#include <map>

using namespace facetmill;
using test::BlockJob;

namespace {

const Vec3 block_size = test::HollowedBlock::size();

double hollow_volume() {
    return test::HollowedBlock::hollow_volume();
}

double volume_of(const Mesh& mesh) {
    double six = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        six += mesh.corner(f, 0).dot(mesh.corner(f, 1).cross(mesh.corner(f, 2)));
    return six / 6;
}

bool is_closed(const Mesh& mesh) {
    std::map<std::pair<Index, Index>, int> sides;
    for (const Facet& f : mesh.facets)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = f[k], b = f[(k + 1) % 3];
            sides[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    return std::all_of(sides.begin(), sides.end(), [](const auto& s) { return s.second == 0; });
}

/// The block without so many hollows: what stands on it are cusps, within the tolerance on the sides that
/// were cut.
bool as_expected(const StockModel& stock, int hollows) {
    const double excess = stock.volume() - block_size.prod() + hollows * hollow_volume();
    constexpr double tolerance = 0.05, cut = 40 * 30 + 40 * 30 + 30 * 24;
    return excess > -0.02 * hollow_volume() && excess < 0.67 * tolerance * cut;
}

/// All setups planned, once for all tests.
const std::vector<SetupPlan>& planned_block() {
    static BlockJob job;
    static SetupPlanners planners;
    static const std::vector<SetupPlan> setups = plan_setups(job.project, {}, planners, {});
    return setups;
}

} // namespace

class TestSetupPlans : public QObject {
    Q_OBJECT
private slots:

    void each_begins_with_what_the_one_before_left() {
        const std::vector<SetupPlan>& setups = planned_block();
        QCOMPARE(setups.size(), std::size_t(3));
        const double block = block_size.prod();
        QVERIFY(setups[0].plan->stock.kind == StockSolid::Kind::box);
        for (std::size_t i : {1u, 2u}) {
            const StockSolid& stock = setups[i].plan->stock;
            QVERIFY(stock.kind == StockSolid::Kind::mesh);
            QVERIFY(is_closed(*stock.mesh));
            // The layer on top is gone, and a hollow more each time; what cusps and the lattice's edges are,
            // and that is little, is left or gone beside.
            const double expected = block - double(i) * hollow_volume();
            QVERIFY2(std::abs(volume_of(*stock.mesh) - expected) < 0.01 * hollow_volume() + 0.004 * block,
                     qPrintable(QString::number(volume_of(*stock.mesh) - expected)));
        }
        // It lies about the part, however that lies in the setup.
        QVERIFY((setups[1].plan->part->box.size() - block_size).norm() < 1e-4);
        QVERIFY((setups[2].plan->part->box.size() - Vec3(24, 30, 40)).norm() < 1e-4);
        for (const SetupPlan& setup : setups)
            QVERIFY((setup.plan->part->box.lo).norm() < 1e-4);
        QVERIFY((setups[2].plan->stock.box.hi - Vec3(24, 30, 40)).norm() < 0.01);
    }

    void judged_as_one_only_what_no_setup_sees_is_left() {
        const std::vector<SetupPlan>& setups = planned_block();
        const auto chains = stock_chains(setups);
        QCOMPARE(chains.size(), std::size_t(1));
        const auto programs = planned_programs(chains[0]);
        const ChainPrograms all = chain_programs(chains[0], programs);
        QCOMPARE(all.programs.size(), std::size_t(3));
        QVERIFY(all.programs[1].motions->motions.front().to.axis == Vec3(0, 0, -1));
        QVERIFY(all.programs[2].motions->motions.front().to.axis == Vec3(1, 0, 0));
        VerifySettings settings = chain_settings(chains[0]);
        settings.resolution = test::under_sanitizer ? 0.4 : 0.25;
        const Verification v =
            verify(*setups[0].plan->part->mesh, setups[0].plan->stock, all.programs, settings, {});
        QVERIFY2(v.passed(),
                 qPrintable(QString::fromStdString(findings_line(setups[0].project, all.programs, v))));
        double seen = 0, not_seen = 0;
        for (const UncutReason& r : v.uncut)
            (r.counts() ? seen : not_seen) += r.area;
        QCOMPARE(seen, 0.0);
        // Three hollows: from three sides nobody comes. Their rims are less deep than twice the tolerance.
        const double rim = std::sqrt(1 - std::sqrt(2 * 0.05 / test::HollowedBlock::depth));
        const double area = 3 * pi * std::pow(rim * test::HollowedBlock::radius, 2);
        QVERIFY2(not_seen > 0.4 * area && not_seen < 1.2 * area,
                 qPrintable(QString::number(not_seen / area)));
        // What is left by volume, which no probe has a say in.
        QVERIFY2(as_expected(*v.stock, 3), qPrintable(QString::number(v.stock->volume())));
    }

    /// The same without the second setup, and with one that is told to lie otherwise than it was planned for.
    void what_is_missing_or_turned_is_found() {
        const std::vector<SetupPlan>& setups = planned_block();
        const auto judged = [&](const std::vector<SetupPlan>& some) {
            const auto programs = planned_programs(some);
            const ChainPrograms all = chain_programs(some, programs);
            VerifySettings settings = chain_settings(some);
            settings.resolution = test::under_sanitizer ? 0.4 : 0.25;
            return verify(*setups[0].plan->part->mesh, setups[0].plan->stock, all.programs, settings, {});
        };
        const Verification two = judged({setups[0], setups[2]});
        QVERIFY2(as_expected(*two.stock, 2), qPrintable(QString::number(two.stock->volume())));
        std::vector<SetupPlan> wrong = setups;
        wrong[1].project.place.translate[2] = 23; // too low: the tool does not get there
        QVERIFY(judged(wrong).left_uncut());
        wrong[1].project.place.translate[2] = 25;
        const Verification v = judged(wrong);
        QVERIFY(v.gouged());
        QVERIFY(v.program_gouges[1] > 0.9 && v.program_gouges[0] < 0.01);
    }

    void one_operation_needs_the_setups_before_it() {
        BlockJob job;
        SetupPlanners planners;
        std::vector<std::string> planned;
        const auto plans = plan_setups(
            job.project, "Finish below", planners, {},
            [&](Planner& planner, const Project& view, const std::string& only, const Progress& progress) {
                planned.push_back(view.name + ":" + only);
                return planner.plan(view, only, progress);
            });
        QVERIFY((planned == std::vector<std::string>{"Top:", "Bottom:Finish below"}));
        QVERIFY(!plans[0].asked && plans[1].asked);
        // Once more: nothing is planned anew, and the stock carried on is the same, not one cut again.
        const PlannerWork work = planners.at(1).work();
        const auto carried = planners.at(1).carried();
        plan_setups(job.project, "Finish below", planners, {});
        QVERIFY(planners.at(1).work() == work);
        QVERIFY(carried && planners.at(1).carried() == carried);
        // A change before it changes what it begins with.
        apply_setting(job.project, "Finish.allowance=0.5");
        plan_setups(job.project, "Finish below", planners, {});
        QVERIFY(!(planners.at(1).work() == work));
        QVERIFY(planners.at(1).carried() != carried);
        try {
            plan_setups(job.project, "Finish belo", planners, {});
            QFAIL("it was planned");
        } catch (const Error& e) {
            QCOMPARE(std::string(code_name(e.code())), std::string("missing_reference"));
            QCOMPARE(e.remedy(), std::string("did you mean 'Finish below'?"));
        }
    }

    void what_cannot_be_is_told() {
        BlockJob job;
        const std::filesystem::path root = job.project.path.parent_path();
        save_stl(test::HollowedBlock::mesh(), root / "rest.stl", LengthUnit::mm, {});
        const auto told = [&](const std::function<void(Project&)>& change) {
            Project p = job.project;
            change(p);
            SetupPlanners planners;
            try {
                plan_setups(p, {}, planners, {});
            } catch (const Error& e) {
                return QString::fromStdString(std::string(code_name(e.code())) + " " + e.where());
            }
            return QStringLiteral("none");
        };
        // Far from the part, and so from the stock of the setup before.
        QCOMPARE(told([](Project& p) {
                     StockSpec& stock = setup_at(p, 1).stock;
                     stock.kind = StockSpec::Kind::mesh;
                     stock.file = "rest.stl";
                     stock.translate = {0, 0, 200};
                     p.after.pop_back();
                 }),
                 QStringLiteral("out_of_range setup 'Bottom': stock"));
        QCOMPARE(told([](Project& p) { setup_at(p, 1).operations.clear(); }),
                 QStringLiteral("missing_key setup 'Bottom': operations"));
        Project alone = view_of_setup(job.project, 1);
        Planner planner;
        try {
            planner.plan(alone, {}, {});
            QFAIL("it was planned without its stock");
        } catch (const Error& e) {
            QCOMPARE(e.where(), std::string("stock"));
        }
    }

    /// The machine's rotary axes turn the tool in its own coordinates, wherever the setup's are told.
    void joints_are_those_of_the_setups_machine() {
        auto motions = std::make_shared<ToolMotions>();
        for (int i = 0; i <= 8; ++i) {
            const double lean = 0.1 + 0.12 * i, turn = 0.9 * i;
            motions->motions.push_back(
                {i == 0 ? MotionKind::rapid : MotionKind::cut,
                 {Vec3(3 * i, i, 5),
                  Vec3(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean))}});
        }
        const auto machine = std::make_shared<const Machine>(find_machine("trunnion-ac"));
        const VerifyProgram own{"5 axes", VerifyTool(test::ball_tool(6)), motions, std::nullopt, {}, machine};
        const SetupFrame frame = frame_of({{pi / 2, 0.3, -1}, {10, -20, 5}});
        const VerifyProgram moved = moved_program(own, frame);
        const AxisCourses there(own, {}), here(moved, {});
        int compared = 0;
        for (Index i = 1; i < motions->motions.size(); ++i)
            for (const AxisCourse course : AxisCourses::others) {
                QCOMPARE(here.differs(i, course), there.differs(i, course));
                if (!there.differs(i, course)) continue;
                ++compared;
                const CutterLocation a = there.at(i, course, 0.4), b = here.at(i, course, 0.4);
                QVERIFY((b.tip - frame(a.tip)).norm() < 1e-9);
                QVERIFY((b.axis - frame.turn * a.axis).norm() < 1e-9);
            }
        QVERIFY(compared > 8); // under both courses
    }

    /// The third goes on with what the first left; whoever goes on with stock of a setup's own needs that.
    void a_setup_with_nothing_on_is_left_out() {
        BlockJob job;
        setup_at(job.project, 1).operations[0]->common().off = true;
        SetupPlanners planners;
        const std::vector<SetupPlan> setups = plan_setups(job.project, {}, planners, {});
        QCOMPARE(setups.size(), std::size_t(2));
        QCOMPARE(setups[1].project.name, setup_at(job.project, 2).name);
        const double expected = block_size.prod() - hollow_volume();
        QVERIFY(std::abs(volume_of(*setups[1].plan->stock.mesh) - expected)
                < 0.01 * hollow_volume() + 0.004 * block_size.prod());
        setup_at(job.project, 0).operations[0]->common().off = true;
        try {
            plan_setups(job.project, {}, planners, {});
            QFAIL("planned");
        } catch (const Error& e) {
            QVERIFY2(std::string(e.what()).find("switched off") != std::string::npos, e.what());
        }
    }

    void cancelled_it_ends() {
        BlockJob job;
        SetupPlanners planners;
        Job running;
        running.cancel();
        QVERIFY_EXCEPTION_THROWN(plan_setups(job.project, {}, planners, Progress(running)), Cancelled);
    }
};

FACETMILL_TEST(TestSetupPlans)
#include "test_setup_plans.moc"
