// Tabs: a part that is cut out of its stock stays in it where they are, and comes loose where they are not.
#include "core/job/fixtures.h"
#include "core/job/new_fixture.h"
#include "core/job/planner.h"
#include "core/job/setup_sheet.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/refine.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A plate of 60 x 40 x 8 mm out of one of 100 x 80 x 8, in a groove round it down to the table.
class PlateJob {
public:
    PlateJob() {
        const std::filesystem::path root(dir_.path().toStdString());
        save_stl(box(Vec3(0, 0, 0), Vec3(60, 40, 8)), root / "plate.stl", LengthUnit::mm, {});
        project = parse_project(R"({ "facetmill": 2, "units": "mm", "part": { "file": "plate.stl" },
          "tools": [ { "number": 1, "diameter": 6, "flute_length": 20, "shank_length": 30 } ],
          "setups": [ { "name": "One", "stock": { "kind": "box", "margin": [20, 20, 0] },
            "boundaries": [ { "name": "Groove", "kind": "silhouette", "offset": 6.5 } ],
            "operations": [ { "kind": "rough", "name": "Cut out", "tool": 1, "tolerance": 0.1, "allowance": 0,
                              "depth": 2, "boundary": "Groove", "contain": "tool" } ] } ] })",
                                "plate.facetmill");
        project.path = root / "plate.facetmill";
    }
    Project project;

private:
    QTemporaryDir dir_;
};

Fixture tab_at(const char* name, double x, double y, double turn, Fixture::TabShape shape) {
    Fixture tab;
    tab.name = name;
    tab.kind = Fixture::Kind::tab;
    tab.size = {14, 6, 2};
    tab.shape = shape;
    tab.rotate[2] = radians(turn);
    tab.translate = {x, y, 0};
    return tab;
}

/// The deepest that a cutter comes into a body, seen by places of the body's surface: some thousand of them,
/// against the cutter at places along its cuts.
double cut_into(const PlanResult& plan, const Mesh& body) {
    double deepest = 0;
    for (const auto& program : plan.operations) {
        const double radius = 3; // of the flat end
        const auto& motions = program->program.motions.motions;
        for (std::size_t i = 1; i < motions.size(); ++i) {
            const Vec3 from = motions[i - 1].to.tip, step = motions[i].to.tip - from;
            const int n = std::max(1, int(step.norm() / 0.25));
            for (int k = 0; k <= n; ++k) {
                const Vec3 tip = from + step * (double(k) / n);
                for (const Vec3& p : body.vertices) {
                    const double inside = radius - Vec2(p.x() - tip.x(), p.y() - tip.y()).norm();
                    if (p.z() > tip.z()) deepest = std::max(deepest, std::min(inside, p.z() - tip.z()));
                }
            }
        }
    }
    return deepest;
}

/// There is material on the upright ray that is nearest to a place, at its height.
bool stands(const StockModel& stock, const Vec3& p) {
    const StockLattice& lattice = stock.lattice();
    const auto node = [&](int k) {
        return int(std::lround((p[k] - lattice.origin[k]) / lattice.spacing[k]));
    };
    for (const auto& [from, to] : stock.stretches(2, node(0), node(1)))
        if (p.z() > from && p.z() < to) return true;
    return false;
}

} // namespace

class TestTabs : public QObject {
    Q_OBJECT

    static Verification judged(const Project& project, std::shared_ptr<const PlanResult>& plan) {
        Planner planner;
        plan = planner.plan(project, {}, {});
        const auto programs = verify_programs(project, plan);
        return verify(*plan->part->mesh, plan->stock, programs, verify_settings(project, plan.get()), {});
    }

private slots:
    void a_part_stays_in_its_stock() {
        PlateJob job;
        std::shared_ptr<const PlanResult> plan;
        const Verification free = judged(job.project, plan);
        QVERIFY(free.passed());
        QVERIFY(free.loose && free.loose->part_is_free);
        using Shape = Fixture::TabShape;
        job.project.fixtures = {tab_at("Left", -5, 20, 180, Shape::rectangular),
                                tab_at("Right", 65, 20, 0, Shape::triangular)};
        check_project(job.project);
        const Verification held = judged(job.project, plan);
        QVERIFY(held.passed()); // to touch one is no collision
        QVERIFY(!held.loose);
        QVERIFY(plan->stock_warnings.empty());
        for (const FixtureSolid& tab : *plan->part->fixtures) {
            QVERIFY(tab.tab && tab.clearance == 0);
            const double deep =
                cut_into(*plan, refined(*tab.mesh, [](const auto&) { return true; }, 0.8, 100'000, {}).mesh);
            QVERIFY2(deep < 0.11, qPrintable(QString::number(deep))); // the tolerance
            // It stands: the middle of its upper edge is in the stock that is left.
            const Box3 box = tab.mesh->box();
            QVERIFY(stands(*held.stock, box.center() + Vec3(0, 0, 0.3 * box.size().z())));
            QVERIFY(!stands(*free.stock, box.center()));
        }
        // One is enough to hold it.
        job.project.fixtures.pop_back();
        QVERIFY(!judged(job.project, plan).loose);
        // The sheet tells of it.
        const auto programs = verify_programs(job.project, plan);
        const std::string sheet = setup_sheet(job.project, *plan, programs, held, {});
        QVERIFY(sheet.find("rectangular tab, ") != std::string::npos);
        QVERIFY(sheet.find("left standing") != std::string::npos);
    }

    /// What a tab hides is named, and is no other reason's: a flank that a ball could finish.
    void what_stays_uncut_is_named() {
        PlateJob job;
        Mesh part = box(Vec3(0, 0, 0), Vec3(60, 40, 8));
        for (Vec3& p : part.vertices)
            if (p.z() > 1) p = Vec3(30 + 0.8 * (p.x() - 30), 20 + 0.8 * (p.y() - 20), p.z()); // sloping sides
        save_stl(part, job.project.part_path(), LengthUnit::mm, {});
        job.project.tools[0].corner_radius = 3;
        job.project.limits.uncut_limit = 1;
        job.project.fixtures = {tab_at("Right", 63, 20, 0, Fixture::TabShape::rectangular)}; // from x = 56
        std::shared_ptr<const PlanResult> plan;
        const Verification v = judged(job.project, plan);
        const auto tab = std::find_if(v.uncut.begin(), v.uncut.end(),
                                      [](const UncutReason& r) { return r.why == UncutReason::Why::tab; });
        QVERIFY(tab != v.uncut.end());
        // Over the tab's width and a tool's beside it, as high as the tab.
        QVERIFY2(tab->area > 2 && tab->area < 40, qPrintable(QString::number(tab->area)));
        QVERIFY(std::none_of(v.uncut.begin(), v.uncut.end(),
                             [](const UncutReason& r) { return r.why == UncutReason::Why::fixture; }));
        QVERIFY(uncut_reason_text(*tab).find("tab") != std::string::npos);
    }

    /// On the outline at the bottom, across it, with nothing of the part before them; far from one another.
    void new_ones_stand_round_the_part() {
        PlateJob job;
        Planner planner;
        const auto part = planner.prepare(job.project, {});
        Box3 stock = part->box;
        stock.lo -= Vec3(20, 20, 0);
        stock.hi += Vec3(20, 20, 0);
        const std::vector<Fixture> tabs = new_tabs(job.project, *part->mesh, stock, 4, {});
        QCOMPARE(tabs.size(), std::size_t(4));
        std::set<std::string> names;
        for (const Fixture& tab : tabs) {
            names.insert(tab.name);
            QVERIFY(tab.kind == Fixture::Kind::tab);
            QVERIFY(tab.size[0] > 6 && tab.translate[2] == 0); // longer than the tool is wide
            const Mesh mesh = fixture_mesh(tab);
            int inside = 0, outside = 0; // its bottom's corners: two in the part
            for (const Vec3& p : mesh.vertices)
                if (p.z() < 0.1) {
                    const bool in = p.x() > 0 && p.x() < 60 && p.y() > 0 && p.y() < 40;
                    ++(in ? inside : outside);
                }
            QCOMPARE(inside, 2);
            QCOMPARE(outside, 2);
        }
        QCOMPARE(names.size(), std::size_t(4));
        for (const Fixture& a : tabs)
            for (const Fixture& b : tabs)
                if (&a != &b)
                    QVERIFY(std::hypot(a.translate[0] - b.translate[0], a.translate[1] - b.translate[1])
                            > 25);
        job.project.fixtures = tabs;
        check_project(job.project);
        std::shared_ptr<const PlanResult> plan;
        const Verification v = judged(job.project, plan);
        QVERIFY(v.passed() && !v.loose);
        // A file keeps them as they are.
        const Project again = parse_project(project_to_json(job.project), "again");
        QCOMPARE(project_to_json(again), project_to_json(job.project));
    }

    /// A narrow slot has no room for one, and a sheet without a bottom has its outline from above.
    void places_are_looked_for_with_care() {
        PlateJob job;
        // A comb: slots of 4 mm from one side, in which no tab may stand.
        Mesh comb;
        append_mesh(comb, box(Vec3(0, 0, 0), Vec3(60, 10, 8)));
        for (int k = 0; k < 6; ++k)
            append_mesh(comb, box(Vec3(10.0 * k, 9, 0), Vec3(10.0 * k + 6, 60, 8)));
        const std::vector<Fixture> tabs = new_tabs(job.project, comb, comb.box(), 6, {});
        QVERIFY(tabs.size() == 6);
        for (const Fixture& tab : tabs) {
            const Vec3 out(std::cos(tab.rotate[2]), std::sin(tab.rotate[2]), 0);
            const Vec3 tip = Vec3(tab.translate[0], tab.translate[1], 1) + 0.5 * tab.size[0] * out;
            QVERIFY(tip.x() < 0 || tip.x() > 56 || tip.y() < 0 || tip.y() > 60);
        }
        const Mesh sheet = [] { // open below
            Mesh all = box(Vec3(0, 0, 0), Vec3(60, 40, 8)), open = all;
            open.facets.clear();
            for (std::size_t f = 0; f < all.facet_count(); ++f)
                if (all.facet_normal(f).z() > -0.5) open.facets.push_back(all.facets[f]);
            return open;
        }();
        QCOMPARE(new_tabs(job.project, sheet, sheet.box(), 4, {}).size(), std::size_t(4));
        QVERIFY(new_tabs(job.project, Mesh(), Box3(), 4, {}).empty());
    }
};

FACETMILL_TEST(TestTabs)
#include "test_tabs.moc"
