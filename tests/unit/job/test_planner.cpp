// The planner: what did not change is reused, and what is reused equals a fresh plan. Outputs appear together
// or not at all.
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/job/planner.h"
#include "core/job/program_files.h"
#include "core/job/report.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/mesh/sample.h"
#include "core/output/apt.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

using namespace facetmill;
using facetmill::test::cancelled_at;
using facetmill::test::code_of;
namespace fs = std::filesystem;

namespace {

/// A wavy sheet of n x n squares, `size` mm wide.
Mesh wavy_sheet(int n, double size, double height) {
    Mesh m;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double u = double(i) / n, v = double(j) / n;
            m.vertices.emplace_back(size * u, size * v, height * std::sin(4 * u) * std::cos(3 * v));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto at = [&](int a, int b) { return Index((j + b) * (n + 1) + i + a); };
            m.facets.push_back({at(0, 0), at(1, 0), at(1, 1)});
            m.facets.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
    return m;
}

Mesh block(const Vec3& lo, const Vec3& hi) {
    Mesh m;
    for (int c = 0; c < 8; ++c)
        m.vertices.emplace_back(c & 1 ? hi.x() : lo.x(), c & 2 ? hi.y() : lo.y(), c & 4 ? hi.z() : lo.z());
    m.facets = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return m;
}

class Workplace {
    QTemporaryDir dir_;

public:
    /// With a sheet of `size` (mm) as part.
    explicit Workplace(double size = 10) : folder(dir_.path().toStdString()), size_(size) {
        write_part(1.0);
        project.path = folder / "p.facetmill";
        project.part.file = "part.stl";
        Tool ball;
        ball.number = 1;
        ball.name = "Ball 6";
        ball.corner_radius = 3;
        Tool flat;
        flat.number = 2;
        flat.name = "Bull 8";
        flat.diameter = flat.shank_diameter = 8;
        flat.corner_radius = 1;
        project.tools = {ball, flat};
        for (const char* name : {"First", "Second"}) {
            auto o = make_operation("finish3");
            o->common().name = name;
            o->common().tool = 1;
            o->common().tolerance = 0.2;
            o->set("stepover", 1.0); // the planner is on trial here, not the adaptive step-over
            project.operations.push_back(std::move(o));
        }
        project.operations[1]->common().direction = {0, "y"};
    }
    void write_part(double height) {
        save_stl(wavy_sheet(6, size_, height), folder / "part.stl", LengthUnit::mm, {});
    }

    fs::path folder;
    Project project;

private:
    double size_;
};

std::string apt_of(const OperationResult& o) {
    QTemporaryDir dir;
    const fs::path path = fs::path(dir.path().toStdString()) / "p.apt";
    OutputFile file(path);
    ClProgram program;
    program.sections.push_back(std::make_shared<const ClSection>(o.program));
    write_apt(program, file, {});
    file.commit();
    return std::string(InputFile(path).bytes());
}

/// All that a plan says, but for the seconds it took.
std::string text_of(const Project& project, const PlanResult& plan) {
    Json report = Json::parse(report_json(project, plan));
    for (auto& o : report["operations"])
        o["seconds_planning"] = 0;
    std::string text = report.dump();
    for (const auto& o : plan.operations)
        text += apt_of(*o);
    return text;
}

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& e : fs::directory_iterator(folder))
        names.push_back(e.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

class TestPlanner : public QObject {
    Q_OBJECT
private slots:
    /// An operation that asks what stands is planned again when what is before it moves, and not for a feed.
    void roughing_sees_what_operations_before_it_left() {
        Workplace w;
        w.project.stock.margin = {2, 2, 4};
        for (std::size_t i = 0; i < 2; ++i) {
            auto o = make_operation("rough");
            o->common().name = i == 0 ? "First" : "Second";
            o->common().tool = i == 0 ? 2 : 1;
            o->common().allowance = 0.2;
            o->common().tolerance = 3;
            o->set("depth", 1.0);
            w.project.operations[i] = std::move(o);
        }
        Planner planner;
        const auto both = planner.plan(w.project, "", {});
        QCOMPARE(both->operations.size(), std::size_t(2));
        QCOMPARE(planner.work().strategies, 2);
        // Alone it is the same, since the one before it is planned as well.
        Planner fresh;
        const auto alone = fresh.plan(w.project, "Second", {});
        QCOMPARE(alone->operations.size(), std::size_t(1));
        QCOMPARE(fresh.work().strategies, 2);
        QVERIFY(apt_of(*alone->operations[0]) == apt_of(*both->operations[1]));
        // Without one before it there is more to do.
        Project lone = w.project;
        lone.operations.erase(lone.operations.begin());
        const auto more = Planner().plan(lone, "", {});
        QVERIFY(more->operations[0]->totals.cut_length > both->operations[1]->totals.cut_length);

        w.project.operations[0]->common().feed = 777;
        QCOMPARE(planner.plan(w.project, "", {})->operations.size(), std::size_t(2));
        QCOMPARE(planner.work().strategies, 2);
        w.project.operations[0]->set("depth", 1.5);
        const auto changed = planner.plan(w.project, "", {});
        QCOMPARE(planner.work().strategies, 4);
        const auto anew = Planner().plan(w.project, "", {});
        QVERIFY(text_of(w.project, *changed) == text_of(w.project, *anew));
        const Json report = Json::parse(report_json(w.project, *anew));
        for (const char* key : {"layers", "remaining_height", "air_length"})
            QVERIFY(report["operations"][0][key].is_number());
    }

    /// As if it were not there, and as before when it is on again.
    void what_is_switched_off_is_left_out() {
        Workplace w;
        Planner planner;
        const auto both = planner.plan(w.project, "", {});
        w.project.operations[0]->common().off = true;
        const auto one = planner.plan(w.project, "", {});
        QCOMPARE(one->operations.size(), std::size_t(1));
        Project lone = w.project;
        lone.operations.erase(lone.operations.begin());
        QVERIFY(apt_of(*one->operations[0]) == apt_of(*Planner().plan(lone, "", {})->operations[0]));
        QCOMPARE(program_file_name(w.project, *one, 0), std::string("02-Second.apt"));
        const auto names = program_file_names(w.project);
        QVERIFY(std::none_of(names.begin(), names.end(),
                             [](const std::string& n) { return n.starts_with("01"); }));
        const auto refused = [&](const std::string& name) {
            try {
                planner.plan(w.project, name, {});
            } catch (const Error& e) {
                return std::string(e.what());
            }
            return std::string();
        };
        QVERIFY(refused("First").find("operation 'First': it is switched off") == 0);
        QVERIFY(refused("Fist").find("did you mean 'First'?") != std::string::npos);
        const std::string text = project_to_json(w.project);
        QVERIFY(text.find("\"off\": true") != std::string::npos);
        QCOMPARE(project_to_json(parse_project(text, "p")), text);
        w.project.operations[1]->common().off = true;
        QVERIFY(refused("").find("all of them are switched off") != std::string::npos);
        for (auto& o : w.project.operations)
            o->common().off = false;
        QVERIFY(project_to_json(w.project).find("\"off\"") == std::string::npos);
        const auto again = planner.plan(w.project, "", {});
        QVERIFY(text_of(w.project, *again) == text_of(w.project, *both));
    }

    void rapids_clear_every_kind_of_stock() {
        Workplace w;
        w.project.operations.resize(1);
        w.project.operations[0]->common().clearance = 2;
        const Box3 part = load_mesh(w.folder / "part.stl", LengthUnit::mm, {}).mesh->box();
        save_stl(block(Vec3(-3, -2, -9), Vec3(14, 12, 7)), w.folder / "raw.stl", LengthUnit::mm, {});
        StockSpec box, round, lying, cast;
        box.margin = {1, 1, 4};
        round.kind = lying.kind = StockSpec::Kind::cylinder;
        round.margin = {1, 1, 5};
        lying.axis = StockSpec::Axis::x;
        lying.diameter = {30, {}};
        cast.kind = StockSpec::Kind::mesh;
        cast.file = "raw.stl";
        cast.translate = {0, 0, 0.5};
        const double middle = part.center().z();
        const std::pair<StockSpec, double> tops[] = {
            {box, part.hi.z() + 4}, {round, part.hi.z() + 5}, {lying, middle + 15}, {cast, 7.5}};
        Planner planner;
        for (const auto& [stock, top] : tops) {
            w.project.stock = stock;
            const auto plan = planner.plan(w.project, "", {});
            QVERIFY(std::abs(plan->stock.box.hi.z() - top) < 1e-9);
            double rapids = -infinity;
            for (const Motion& m : plan->operations[0]->program.motions.motions)
                if (m.kind == MotionKind::rapid) rapids = std::max(rapids, m.to.tip.z());
            QVERIFY2(std::abs(rapids - (top + 2)) < 1e-6, stock_kind_name(stock.kind).c_str());
            QVERIFY(plan->stock_warnings.empty());
            const Json report = Json::parse(report_json(w.project, *plan));
            QCOMPARE(report["stock"]["kind"].get<std::string>(), stock_kind_name(stock.kind));
            QVERIFY(report["stock"]["warnings"].empty());
        }
        QCOMPARE(planner.work().loads, 1); // the part; its index serves for all
        QCOMPARE(planner.work().indexes, 1);
    }

    void a_round_stock_holds_its_part() {
        // Of diameter `auto` no point of the part is outside, and some point is on its side.
        Workplace w;
        w.project.operations.resize(1);
        w.project.stock.kind = StockSpec::Kind::cylinder;
        Planner planner;
        const auto part = planner.prepare(w.project, {});
        for (const auto axis : {StockSpec::Axis::x, StockSpec::Axis::y, StockSpec::Axis::z}) {
            w.project.stock.axis = axis;
            const StockSolid solid = stock_solid(w.project.stock, *part);
            QCOMPARE(solid.axis, int(axis));
            double farthest = 0;
            for (const Vec3& p : part->mesh->vertices) {
                Vec3 q = p - solid.box.center();
                q[solid.axis] = 0;
                farthest = std::max(farthest, q.norm());
            }
            QVERIFY(std::abs(farthest - solid.radius) < 1e-12);
            QVERIFY(stock_warnings(w.project.stock, *part, LengthUnit::mm).empty());
            // One that is too small is told, and plans all the same.
            w.project.stock.diameter = {1.8 * solid.radius, {}};
            const auto warnings = stock_warnings(w.project.stock, *part, LengthUnit::mm);
            QCOMPARE(warnings.size(), std::size_t(1));
            QVERIFY(warnings[0].find("does not hold the part") != std::string::npos);
            w.project.stock.diameter = {0, "auto"};
        }
        w.project.stock.diameter = {4, {}};
        const auto plan = planner.plan(w.project, "", {});
        const Json report = Json::parse(report_json(w.project, *plan));
        QCOMPARE(report["stock"]["warnings"].size(), std::size_t(1));
    }

    void a_mesh_that_is_no_stock_is_refused() {
        Workplace w;
        w.project.operations.resize(1);
        w.project.stock.kind = StockSpec::Kind::mesh;
        w.project.stock.file = "raw.stl";
        Planner planner;
        const auto plan = [&] { planner.plan(w.project, "", {}); };
        QCOMPARE(code_of(plan), std::string("not_found"));
        Mesh raw = block(Vec3(-1, -1, -3), Vec3(11, 11, 5));
        raw.facets.pop_back();
        save_stl(raw, w.folder / "raw.stl", LengthUnit::mm, {});
        QCOMPARE(code_of(plan), std::string("out_of_range"));
        try {
            plan();
        } catch (const Error& e) {
            QVERIFY(e.where().find("raw.stl") != std::string::npos);
            QVERIFY(e.message().find("not closed: 3 open edges") != std::string::npos);
        }
        // A sheet seen from both sides is closed and holds nothing.
        Mesh sheet;
        sheet.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0)};
        sheet.facets = {{0, 1, 2}, {0, 2, 1}};
        save_stl(sheet, w.folder / "raw.stl", LengthUnit::mm, {});
        QCOMPARE(code_of(plan), std::string("out_of_range"));
        // As soon as the file is good, so is the plan; and the part was read once.
        save_stl(block(Vec3(-1, -1, -3), Vec3(11, 11, 5)), w.folder / "raw.stl", LengthUnit::mm, {});
        const auto good = planner.plan(w.project, "", {});
        QVERIFY(good->stock_warnings.empty());
        QCOMPARE(planner.work().loads, 1);
        // In another place it does not hold the part; the path depends on where it is.
        w.project.stock.translate = {5, 0, 2};
        const auto moved = planner.plan(w.project, "", {});
        QCOMPARE(moved->stock_warnings.size(), std::size_t(1));
        QCOMPARE(planner.work().strategies, 2);
        w.project.stock.translate = {2e6, 0, 0};
        QCOMPARE(code_of(plan), std::string("out_of_range"));
        w.project.stock.translate = {1e6, 0, 0};
        w.project.stock.unit = LengthUnit::inch;
        save_stl(block(Vec3(0, 0, 0), Vec3(5e5, 5e5, 5e5)), w.folder / "raw.stl", LengthUnit::mm, {});
        QCOMPARE(code_of(plan), std::string("coordinate_range"));
    }

    /// However large the chord tolerance asked for, links climb over what stands between two passes.
    void a_large_chord_tolerance_does_not_cut_through_ribs() {
        Workplace w;
        Mesh ribs; // across the ends of the passes, 3 mm high, between every two of them
        const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
            const Index at = Index(ribs.vertices.size());
            ribs.vertices.insert(ribs.vertices.end(), {a, b, c, d});
            ribs.facets.push_back({at, at + 1, at + 2});
            ribs.facets.push_back({at, at + 2, at + 3});
        };
        quad({0, 0, 0}, {20, 0, 0}, {20, 16, 0}, {0, 16, 0});
        for (double y : {4.0, 8.0, 12.0})
            quad({16, y - 0.3, 3}, {20, y - 0.3, 3}, {20, y + 0.3, 3}, {16, y + 0.3, 3});
        save_stl(ribs, w.folder / "part.stl", LengthUnit::mm, {});
        w.project.tools[0].diameter = w.project.tools[0].shank_diameter = 1.5;
        w.project.tools[0].corner_radius = 0.75;
        w.project.operations.resize(1);
        Operation& op = *w.project.operations[0];
        op.common().tolerance = 0.05;
        op.common().direction = {0, "x"};
        op.set("stepover", 4.0);
        op.set("chord_tolerance", 20.0);
        Planner planner;
        const auto plan = planner.plan(w.project, "", Progress());
        const auto& motions = plan->operations[0]->program.motions.motions;
        int crossed = 0;
        for (std::size_t i = 1; i < motions.size(); ++i) {
            const Vec3 &a = motions[i - 1].to.tip, &b = motions[i].to.tip;
            for (double y : {4.0, 8.0, 12.0}) {
                if ((a.y() < y) == (b.y() < y) || std::max(a.x(), b.x()) < 16.5) continue;
                const double z = a.z() + (b.z() - a.z()) * (y - a.y()) / (b.y() - a.y());
                QVERIFY2(z >= 3 - 0.025, qPrintable(QString::number(z)));
                ++crossed;
            }
        }
        QVERIFY(crossed > 0);
    }

    /// Links of a tilted tool ask what was roughed before; its path does not.
    void tilted_links_see_what_was_roughed() {
        Workplace w;
        w.project.stock.margin = {2, 2, 15};
        w.project.machine = "trunnion-ac";
        auto rough = make_operation("rough");
        rough->common().name = "First";
        rough->common().tool = 2;
        rough->common().allowance = 0.2;
        rough->common().tolerance = 3;
        rough->set("depth", 2.0);
        w.project.operations[0] = std::move(rough);
        auto finish = make_operation("finish5");
        finish->common().name = "Second";
        finish->common().tolerance = 0.5;
        finish->set("stepover", 1.5);
        finish->set("posture", std::string("cm2"));
        w.project.operations[1] = std::move(finish);
        const auto approach = [](const OperationResult& o) {
            double length = 0;
            const auto& m = o.program.motions.motions;
            for (std::size_t i = 1; i < m.size(); ++i)
                if (m[i].kind == MotionKind::approach) length += (m[i].to.tip - m[i - 1].to.tip).norm();
            return length;
        };
        Planner planner;
        const auto both = planner.plan(w.project, "", {});
        const PlannerWork before = planner.work();
        w.project.operations[0]->set("depth", 2.5);
        planner.plan(w.project, "", {});
        QCOMPARE(planner.work().strategies - before.strategies, 1);
        QCOMPARE(planner.work().links - before.links, 2);
        Project lone = w.project;
        lone.operations.erase(lone.operations.begin());
        const auto alone = planner.plan(lone, "", {});
        QVERIFY(approach(*alone->operations[0]) > approach(*both->operations[1]) + 8);
    }

    void only_what_changed_runs_again() {
        Workplace w(6); // planned some fifty times
        Planner planner;
        Project& p = w.project;
        std::shared_ptr<const PlanResult> plan;
        const auto work_of = [&](const std::string& only = {}) {
            const PlannerWork before = planner.work();
            plan = planner.plan(p, only, {});
            const PlannerWork& now = planner.work();
            // Whatever was reused, the result is that of a planner that knows nothing. Under a sanitizer,
            // which has seen all of it by then, it is not planned twice.
            if (!test::under_sanitizer) {
                Planner fresh;
                const auto anew = fresh.plan(p, only, {});
                if (text_of(p, *plan) != text_of(p, *anew)) qFatal("a reused plan differs from a fresh one");
            }
            return PlannerWork{now.loads - before.loads,     now.placements - before.placements,
                               now.indexes - before.indexes, now.strategies - before.strategies,
                               now.links - before.links,     now.programs - before.programs};
        };
        using W = PlannerWork;
        QVERIFY((work_of() == W{1, 1, 1, 2, 2, 2}));
        const auto first = plan;
        QVERIFY((work_of() == W{}));
        QCOMPARE(plan->operations[0], first->operations[0]); // the very same
        QCOMPARE(plan->part, first->part);

        p.operations[0]->common().feed = 777;
        QVERIFY((work_of() == W{0, 0, 0, 0, 0, 1}));
        QVERIFY(apt_of(*plan->operations[0]).find("FEDRAT/777.") != std::string::npos);
        QCOMPARE(plan->operations[0]->seconds_planning, first->operations[0]->seconds_planning);
        p.tools[0].name = "Another name";
        QVERIFY((work_of() == W{0, 0, 0, 0, 0, 2}));
        p.operations[0]->common().name = "Renamed";
        QVERIFY((work_of() == W{0, 0, 0, 0, 0, 1}));
        p.operations[1]->common().clearance = 9;
        QVERIFY((work_of() == W{0, 0, 0, 0, 1, 1}));
        p.operations[1]->common().tolerance = 0.18;
        QVERIFY((work_of() == W{0, 0, 0, 1, 1, 1}));
        p.operations[1]->common().tool = 2;
        QVERIFY((work_of() == W{0, 0, 0, 1, 1, 1}));
        p.tools[1].diameter = 7.5;
        QVERIFY((work_of() == W{0, 0, 0, 1, 1, 1}));
        p.tools[1].holder.push_back({30, 40});
        QVERIFY((work_of() == W{0, 0, 0, 1, 1, 1}));
        p.unit = LengthUnit::inch; // warnings speak in it
        QVERIFY((work_of() == W{0, 0, 0, 2, 2, 2}));
        p.stock.margin = {1, 1, 1};
        QVERIFY((work_of() == W{0, 0, 0, 2, 2, 2}));
        p.part.tessellation_tolerance = {0.005, 0.005};
        QVERIFY((work_of() == W{0, 0, 0, 2, 2, 2}));
        p.machine = "tarus-tpi-2000";
        QVERIFY((work_of() == W{0, 0, 0, 2, 2, 2}));
        p.part.translate = {0, 0, 5};
        QVERIFY((work_of() == W{0, 1, 1, 2, 2, 2}));
        p.part.unit = LengthUnit::inch;
        p.part.translate = {0, 0, 0};
        for (auto& o : p.operations)
            o->set("stepover", 25.0);
        QVERIFY((work_of() == W{1, 1, 1, 2, 2, 2}));
        w.write_part(0.5);
        QVERIFY((work_of() == W{1, 1, 1, 2, 2, 2}));
        // One operation alone does not forget the other.
        p.operations[1]->common().tolerance = 0.25;
        QVERIFY((work_of("Second") == W{0, 0, 0, 1, 1, 1}));
        QCOMPARE(plan->operations.size(), std::size_t(1));
        QVERIFY((work_of() == W{}));
        std::swap(p.operations[0], p.operations[1]);
        QVERIFY((work_of() == W{0, 0, 0, 2, 2, 2})); // each asks what the one before it left
        QVERIFY((work_of() == W{}));
    }

    void placement_turns_about_fixed_axes() {
        Workplace w;
        w.project.part.rotate = {pi / 2, 0, pi / 2}; // X, then Z
        w.project.part.translate = {100, 200, 300};
        Planner planner;
        const auto part = planner.prepare(w.project, {});
        Planner plain;
        w.project.part.rotate = w.project.part.translate = {0, 0, 0};
        const auto before = plain.prepare(w.project, {});
        for (std::size_t i = 0; i < before->mesh->vertices.size(); ++i) {
            const Vec3& v = before->mesh->vertices[i];
            // About X: (x, -z, y). About Z: (z, x, y).
            QVERIFY((part->mesh->vertices[i] - Vec3(v.z() + 100, v.x() + 200, v.y() + 300)).norm() < 1e-12);
        }
        QVERIFY((part->box.lo - part->mesh->box().lo).norm() == 0);
    }

    /// Unit, scale, mirror, rotate, translate, in this order; outside stays outside.
    void placement_scales_and_mirrors_before_it_turns() {
        Workplace w;
        save_stl(block(Vec3(1, 2, 3), Vec3(2, 4, 6)), w.folder / "part.stl", LengthUnit::mm, {});
        Planner planner;
        w.project.part.unit = LengthUnit::cm;
        w.project.part.scale = 0.5;
        w.project.part.mirror = Mirror::y;
        w.project.part.rotate = {0, 0, pi / 2};
        w.project.part.translate = {100, 0, 0};
        const auto part = planner.prepare(w.project, {});
        QVERIFY((part->box.lo - Vec3(110, 5, 15)).norm() < 1e-9);
        QVERIFY((part->box.hi - Vec3(120, 10, 30)).norm() < 1e-9);
        double volume = 0;
        for (std::size_t f = 0; f < part->mesh->facet_count(); ++f)
            volume += part->mesh->facet_cross(f).dot(part->mesh->corner(f, 0)) / 6;
        QVERIFY(std::abs(volume - 750) < 1e-6);
        QCOMPARE(part->turned_facets, std::size_t(0));
        const auto told = [](const PreparedPart& p, const char* word) {
            return std::count(p.report.warnings.begin(), p.report.warnings.end(), word);
        };
        QCOMPARE(told(*part, "scaled"), 1);
        // Every one of them is a part of its own.
        w.project.part.scale = 1e4;
        QCOMPARE(told(*planner.prepare(w.project, {}), "unit_suspect"), 1);
        w.project.part.scale = 1;
        const auto unscaled = planner.prepare(w.project, {});
        QCOMPARE(told(*unscaled, "scaled"), 0);
        QVERIFY((unscaled->box.size() - Vec3(20, 10, 30)).norm() < 1e-9);
        w.project.part.mirror = Mirror::none;
        QVERIFY((planner.prepare(w.project, {})->box.lo - Vec3(60, 10, 30)).norm() < 1e-9);
        QCOMPARE(planner.work().loads, 1);
    }

    /// Of an open surface someone may know better which side is outside; a closed body keeps its own.
    void flip_takes_the_other_side_of_open_surfaces() {
        Workplace w;
        w.project.part.flip = true;
        Planner planner;
        const auto sheet = planner.prepare(w.project, {});
        QVERIFY(sheet->mesh->facet_normal(0).z() < 0);
        w.project.part.flip = false;
        QVERIFY(planner.prepare(w.project, {})->mesh->facet_normal(0).z() > 0);
        const Mesh body = block(Vec3(0, 0, 0), Vec3(1, 2, 3));
        save_stl(body, w.folder / "part.stl", LengthUnit::mm, {});
        w.project.part.flip = true;
        const auto closed = planner.prepare(w.project, {});
        QCOMPARE(closed->turned_facets, std::size_t(0));
        QVERIFY(closed->mesh->facet_normal(0).z() < 0 && closed->mesh->facet_normal(2).z() > 0);
    }

    void cancelling_leaves_a_good_cache() {
        Workplace w;
        Planner fresh;
        const std::string wanted = text_of(w.project, *fresh.plan(w.project, {}, {}));
        Planner planner;
        int cancelled = 0;
        for (int tenth = 0; tenth < 10; ++tenth) {
            Job job;
            cancelled +=
                cancelled_at(job, tenth / 10.0, [&](const Progress& p) { planner.plan(w.project, {}, p); });
        }
        QVERIFY(cancelled > 0);
        QCOMPARE(text_of(w.project, *planner.plan(w.project, {}, {})), wanted);
    }

    void what_is_missing_is_named() {
        Workplace w;
        Planner planner;
        const auto code = [&](const std::function<void(Project&)>& change, const std::string& only = {}) {
            Project p = w.project;
            change(p);
            return code_of([&] { planner.plan(p, only, {}); });
        };
        QCOMPARE(code([](Project& p) { p.part.file = "none.stl"; }), std::string("not_found"));
        QCOMPARE(code([](Project& p) { p.part.file = "."; }), std::string("is_directory"));
        QCOMPARE(code([](Project& p) { p.operations.clear(); }), std::string("missing_key"));
        QCOMPARE(code([](Project&) {}, "Third"), std::string("missing_reference"));
        QCOMPARE(code([](Project& p) { p.operations[0]->common().tool = 9; }),
                 std::string("missing_reference"));
        QCOMPARE(code([](Project& p) { p.machine = "none"; }), std::string("missing_reference"));
        QCOMPARE(code([](Project& p) { p.part.translate = {9.9e5, 0, 0}; }), std::string("none"));
        try {
            Project p = w.project;
            p.operations[1]->common().tolerance = 1e-7;
            p.operations[1]->set("stepover", 1e-7); // more passes than anyone wants
            planner.plan(p, {}, {});
        } catch (const Error& e) {
            QVERIFY2(std::string(e.what()).starts_with("operation 'Second'"), e.what());
        }
        QCOMPARE(code([](Project&) {}), std::string("none"));
    }

    void the_place_of_an_error_names_the_operation_once() {
        Workplace w;
        Mesh wall; // nothing of it can be cut from above
        wall.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 0, 10)};
        wall.facets.push_back({0, 1, 2});
        save_stl(wall, w.folder / "part.stl", LengthUnit::mm, {});
        for (const std::string& name : {std::string("First"), std::string(100, 'n')}) {
            w.project.operations[0]->common().name = name;
            Planner planner;
            try {
                planner.plan(w.project, name, {});
                QFAIL("no error");
            } catch (const Error& e) {
                QCOMPARE(e.where(), "operation '" + printable(name) + "'");
            }
        }
    }

    void the_report_is_in_project_units() {
        Workplace w;
        w.project.operations[1]->common().tolerance = 0.02; // less than the step-over leaves: a warning
        Planner planner;
        const Json mm = Json::parse(report_json(w.project, *planner.plan(w.project, {}, {})));
        QVERIFY(!mm["operations"][1]["warnings"].empty());
        w.project.unit = LengthUnit::inch;
        const auto plan = planner.plan(w.project, {}, {});
        const Json in = Json::parse(report_json(w.project, *plan));
        QCOMPARE(in["units"].get<std::string>(), std::string("in"));
        for (std::size_t i = 0; i < 2; ++i) {
            const Json &a = mm["operations"][i], &b = in["operations"][i];
            for (const char* key : {"stepover_min", "stepover_max", "cut_length", "rapid_length", "cusp_max"})
                QVERIFY2(std::abs(a[key].get<double>() - 25.4 * b[key].get<double>())
                             < 1e-9 * a[key].get<double>() + 1e-12,
                         key);
            for (const char* key :
                 {"time_seconds", "passes", "cc_points", "cl_points", "cleanup_points", "rework_regions"})
                QCOMPARE(a[key].get<double>(), b[key].get<double>());
            QVERIFY(a["passes"].get<int>() > 3);
            QVERIFY(a["cut_length"].get<double>() > 50);
            QVERIFY(a["cusp_max"].get<double>() > 0 && a["cusp_max"].get<double>() < 0.2);
            QVERIFY(a["warnings"].is_array());
            QCOMPARE(a["warnings"].size(), b["warnings"].size());
            for (const Json& said : b["warnings"])
                QVERIFY2(said.get<std::string>().find(" mm") == std::string::npos,
                         said.get<std::string>().c_str());
            QVERIFY(a["seconds_planning"].get<double>() >= 0);
            const auto& o = *plan->operations[i];
            std::size_t cl = 0;
            for (const Pass& pass : o.path.passes)
                cl += pass.cl.size();
            QCOMPARE(a["cl_points"].get<std::size_t>(), cl);
            QCOMPARE(a["name"].get<std::string>(), o.name);
            QCOMPARE(a["turn_max_degrees"].get<double>(), 0.0);
        }
    }

    void ramps_and_links_have_feeds_of_their_own() {
        Workplace w;
        w.project.operations.resize(1);
        OperationCommon& common = w.project.operations[0]->common();
        common.feed = 600;
        Planner planner;
        std::shared_ptr<const PlanResult> plan;
        const auto feeds = [&] {
            plan = planner.plan(w.project, "", {});
            const ClSection& program = plan->operations[0]->program;
            std::map<MotionKind, std::set<double>> found;
            for (std::size_t i = 0; i < program.motions.motions.size(); ++i)
                if (const MotionKind kind = program.motions.motions[i].kind; kind != MotionKind::rapid)
                    found[kind].insert(program.feed(i));
            return found;
        };
        using Feeds = std::map<MotionKind, std::set<double>>;
        Feeds expected{{MotionKind::approach, {300}},
                       {MotionKind::cut, {600}},
                       {MotionKind::link, {600}},
                       {MotionKind::retract, {600}}};
        QVERIFY(feeds() == expected);
        const double seconds = plan->operations[0]->totals.time_seconds;
        common.ramp_feed = {200, {}};
        common.link_feed = {1500, {}};
        expected[MotionKind::approach] = {200};
        expected[MotionKind::link] = expected[MotionKind::retract] = {1500};
        const int links = planner.work().links;
        QVERIFY(feeds() == expected);
        QCOMPARE(planner.work().links, links); // the path is the same
        QVERIFY(plan->operations[0]->totals.time_seconds < seconds);
        const std::string apt = apt_of(*plan->operations[0]);
        for (const char* feed :
             {"FEDRAT/200.000000,MMPM", "FEDRAT/600.000000,MMPM", "FEDRAT/1500.000000,MMPM"})
            QVERIFY2(apt.find(feed) != std::string::npos, feed);
        common.ramp_feed = common.link_feed = {600, {}};
        feeds();
        QVERIFY(plan->operations[0]->program.motion_feeds.empty());
    }

    /// The same operation again meets hardly anything.
    void feed_in_the_air_is_reported() {
        Workplace w;
        w.project.operations[1]->common().direction = w.project.operations[0]->common().direction = {0, "x"};
        w.project.stock.margin = {2, 2, 3};
        Planner planner;
        const auto plan = planner.plan(w.project, "", {});
        const std::vector<double> air = feed_in_air(w.project, plan, {});
        QCOMPARE(air.size(), std::size_t(2));
        const double first = plan->operations[0]->totals.cut_length;
        QVERIFY(air[0] >= 0 && air[0] < 0.4 * first && air[1] > 0.9 * first);
        const Json report = Json::parse(report_json(w.project, *plan, air));
        QCOMPARE(report["operations"][1]["feed_in_air_length"].get<double>(), air[1]);
        QVERIFY(!Json::parse(report_json(w.project, *plan))["operations"][1].contains("feed_in_air_length"));
    }

    /// A ball touches the lower border of a roof from below it.
    void nothing_goes_below_the_stock_unless_asked() {
        Workplace w;
        Mesh roof;
        roof.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 10, 0), Vec3(0, 10, 0), Vec3(5, 5, 6)};
        roof.facets = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
        save_stl(roof, w.folder / "part.stl", LengthUnit::mm, {});
        w.project.operations.resize(1);
        Planner planner;
        const auto lowest = [&] {
            double z = infinity;
            for (const Motion& m : planner.plan(w.project, "", {})->operations[0]->program.motions.motions)
                z = std::min(z, m.to.tip.z());
            return z;
        };
        QCOMPARE(lowest(), 0.0);
        w.project.operations[0]->common().below_bottom = 0.75;
        QCOMPARE(lowest(), -0.75);
    }

    /// The path can be looked at; there is no program of it.
    void a_path_beyond_the_travel_is_no_program() {
        Workplace w;
        w.project.operations.resize(1);
        w.project.machine = "own.json";
        const auto machine = [&](const char* travel) {
            std::ofstream file(w.folder / "own.json");
            file << R"({"facetmill_machine":1,"label":"Own","description":"","units":"mm","axes":[)"
                 << R"({"name":"X","kind":"linear","travel":)" << travel << R"(,"speed":100},)"
                 << R"({"name":"Y","kind":"linear","speed":100},{"name":"Z","kind":"linear","speed":100}]})";
        };
        machine("[-4, 4]");
        Planner planner;
        const auto plan = planner.plan(w.project, "", {});
        try {
            write_plan(w.project, *plan, w.folder / "out", {});
            QFAIL("a program was written");
        } catch (const Error& e) {
            QCOMPARE(e.code(), ErrorCode::limit_exceeded);
            QCOMPARE(e.where(), std::string("operation 'First'"));
            for (const char* said : {"X ends 2", "too early", "with the tip at (", "Own cannot make"})
                QVERIFY2(e.message().find(said) != std::string::npos, e.what());
        }
        QVERIFY(!fs::exists(w.folder / "out"));
        machine("[-40, 40]");
        write_plan(w.project, *planner.plan(w.project, "", {}), w.folder / "out", {});
        QVERIFY(fs::exists(w.folder / "out" / "01-First.apt"));
    }

    void names_become_file_names() {
        QCOMPARE(program_file_name(1, "Finish"), std::string("01-Finish.apt"));
        QCOMPARE(program_file_name(12, "a/b\\c:d*e"), std::string("12-a-b-c-d-e.apt"));
        QCOMPARE(program_file_name(3, "../../etc/passwd"), std::string("03-..-..-etc-passwd.apt"));
        QCOMPARE(program_file_name(3, "-rf ~"), std::string("03-rf.apt"));
        QCOMPARE(program_file_name(4, "\xD7\xA9"), std::string("04-operation.apt"));
        QCOMPARE(program_file_name(5, "caf\xC3\xA9 2"), std::string("05-cafe-2.apt"));
        QCOMPARE(program_file_name(100, std::string(500, 'x')).size(), std::size_t(68));
    }

    void outputs_appear_together() {
        Workplace w;
        Planner planner;
        const auto plan = planner.plan(w.project, {}, {});
        const fs::path out = w.folder / "deep" / "out";
        const auto paths = write_plan(w.project, *plan, out, {});
        const std::vector<std::string> names = {"01-First.apt", "02-Second.apt", "report.json"};
        QCOMPARE(files_in(out), names);
        QCOMPARE(paths.size(), std::size_t(3));
        QCOMPARE(std::string(InputFile(out / "report.json").bytes()), report_json(w.project, *plan));
        const AptReadResult back = read_apt(out / "02-Second.apt", LengthUnit::mm, {});
        QCOMPARE(back.program.sections.at(0)->operation_name, std::string("Second"));
        QCOMPARE(back.program.sections.at(0)->motions.motions.size(),
                 plan->operations[1]->program.motions.motions.size());
        const std::string bytes(InputFile(out / "01-First.apt").bytes());

        // A part of a project keeps its place in the name.
        const auto second = planner.plan(w.project, "Second", {});
        write_plan(w.project, *second, w.folder / "second", {});
        QCOMPARE(files_in(w.folder / "second"), (std::vector<std::string>{"02-Second.apt", "report.json"}));

        // Something in the way of one: none is changed, nothing is left.
        w.project.operations[0]->common().feed = 1;
        const auto slow = planner.plan(w.project, {}, {});
        fs::remove(out / "report.json");
        fs::create_directories(out / "report.json" / "x");
        QCOMPARE(code_of([&] { write_plan(w.project, *slow, out, {}); }), std::string("unwritable"));
        QCOMPARE(files_in(out), names);
        QCOMPARE(std::string(InputFile(out / "01-First.apt").bytes()), bytes);

        Job job;
        job.cancel();
        QCOMPARE(code_of([&] { write_plan(w.project, *slow, w.folder / "new" / "er", Progress(job)); }),
                 std::string("cancelled"));
        QVERIFY(!fs::exists(w.folder / "new"));
        std::ofstream(w.folder / "file") << "x";
        QCOMPARE(code_of([&] { write_plan(w.project, *slow, w.folder / "file", {}); }),
                 std::string("unwritable"));
    }
};

FACETMILL_TEST(TestPlanner)
#include "test_planner.moc"
