// Wang's table 1 on a sample: a ball everywhere, a flat end by CM2 without a limit of the lead, global-local
// CM2. Flat end D 25.4, rework ball D 6.35, scallop 0.05 mm, machining tolerance 0.03 mm, feed 1000 mm/min.
// Wang's ball has D 25.4 as well, and what it cannot enter is neglected; a row with the rework ball stands
// beside it.
//
//     bench_strategies [PART [LEAD_LIMIT [MACHINE [ROWS [RESOLUTION [DIRECTION]]]]]]
//
// PART is a sample, or "body": a body shell of the size and proportions of Wang's part B. LEAD_LIMIT in
// degrees; ROWS some of "b" (ball 25.4), "s" (ball 6.35), "f" (flat), "g" (global-local), "c" (the same with
// the lead limit kept in any case), "l" (least possible); RESOLUTION of the verifier in mm, 0: not verified;
// DIRECTION auto, x or y. Default: shell 8 trunnion-ac bsfg 0 auto.
#include "core/job/planner.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "core/mesh/sample_tessellate.h"
#include "core/strategy/finish3/finish3.h"
#include "core/strategy/global_local/global_local.h"
#include "tests/bench/least_time.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

using namespace facetmill;

namespace {

constexpr double scallop = 0.05, chord = 0.03, feed = 1000;
/// Of the sample: its facets are to be no part of what is measured.
constexpr double mesh_tolerance = 0.004;

Tool tool(long number, double diameter, bool ball) {
    Tool t;
    t.number = number;
    t.name = ball ? "Ball" : "Flat";
    t.diameter = t.shank_diameter = diameter;
    t.corner_radius = ball ? 0.5 * diameter : 0;
    t.flute_length = 110; // longer than a block about any of the parts is deep: nothing was roughed before
    t.shank_length = 30;
    return t;
}

template <class Settings>
void share(Settings& s, long number, double stays) {
    s.name = "Row";
    s.tool = number;
    s.tolerance = stays;
    s.feed = feed;
    s.chord_tolerance = {0.4 * stays, ""};
}

/// A quarter-scale car body, 1000 by 450 mm, gently round, with six scoops that make up 3 % of it: walls of
/// 45 degrees, tightest radius about 4 mm, which the rework ball fits and the flat end does not.
Mesh body() {
    constexpr double length = 1000, width = 450, long_radius = 2500, cross_radius = 640;
    constexpr double half_length = 30, half_width = 18, depth = 6, floor = 0.4;
    const PatchFunction patch = [=](double x, double y) {
        double z = -(x - 0.5 * length) * (x - 0.5 * length) / (2 * long_radius)
                   - (y - 0.5 * width) * (y - 0.5 * width) / (2 * cross_radius);
        for (const double at : {210.0, 500.0, 790.0})
            for (const double beside : {105.0, 345.0}) {
                const double away = std::hypot((x - at) / half_length, (y - beside) / half_width);
                const double w = std::clamp((1 - away) / (1 - floor), 0.0, 1.0);
                z -= depth * w * w * w * (10 + w * (6 * w - 15));
            }
        return Vec3(x, y, z);
    };
    PatchGrid grid;
    for (int i = 0; i <= 80; ++i)
        grid.a.push_back(length * i / 80);
    for (int i = 0; i <= 36; ++i)
        grid.b.push_back(width * i / 36);
    return tessellate_patch(patch, grid, 2 * mesh_tolerance, "body", Progress());
}

/// What the tool travels at feed: along passes, between them on the surface, and down and up.
std::array<double, 3> metres_by_kind(const ToolMotions& program) {
    std::array<double, 3> metres{};
    const auto& all = program.motions;
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (all[i].kind == MotionKind::rapid) continue;
        const std::size_t kind = all[i].kind == MotionKind::cut ? 0 : all[i].kind == MotionKind::link ? 1 : 2;
        metres[kind] += (all[i].to.tip - all[i - 1].to.tip).norm() / 1000;
    }
    return metres;
}

} // namespace

int main(int argc, char** argv) {
    const std::string part = argc > 1 ? argv[1] : "shell", machine = argc > 3 ? argv[3] : "trunnion-ac",
                      rows = argc > 4 ? argv[4] : "bsfg";
    const double lead = radians(argc > 2 ? std::atof(argv[2]) : 8),
                 resolution = argc > 5 ? std::atof(argv[5]) : 0;
    const std::string direction = argc > 6 ? argv[6] : "auto";
    const auto file = std::filesystem::temp_directory_path() / ("bench_strategies_" + part + ".stl");
    save_stl(part == "body" ? body() : *make_sample(part, mesh_tolerance, Progress()), file.string(),
             LengthUnit::mm, {});

    Project project;
    project.part.file = file.string();
    project.part.unit = LengthUnit::mm;
    project.machine = machine;
    project.tools = {tool(1, 25.4, false), tool(2, 6.35, true), tool(3, 25.4, true)};
    Planner planner;
    std::printf("%-14s %6s %9s %8s %9s %8s %8s %8s %7s %7s\n", part.c_str(), "passes", "length m", "cut m",
                "links m", "up/dn m", "time s", "step mm", "area %", "plan s");
    const auto row = [&](const char* name, std::unique_ptr<Operation> operation) {
        operation->common().direction = {0, direction};
        project.operations.clear();
        project.operations.push_back(std::move(operation));
        const auto start = std::chrono::steady_clock::now();
        std::shared_ptr<const PlanResult> plan;
        try {
            plan = planner.plan(project, "", Progress());
        } catch (const Error& e) {
            std::printf("%-14s %s\n", name, e.what());
            return;
        }
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        double total = 0;
        for (std::size_t i = 0; i < plan->operations.size(); ++i) {
            const OperationResult& o = *plan->operations[i];
            total += o.totals.time_seconds;
            double share = 100;
            const auto* global_local = plan->operations[0]->path.as<GlobalLocalPath>();
            if (const auto rework = global_local ? global_local->rework : nullptr)
                share = 100
                        * (i == 0 ? 1 - rework->regions.uncut_area / rework->part_area
                                  : rework->regions.area / rework->part_area);
            const auto metres = metres_by_kind(o.program.motions);
            std::printf("%-14s %6d %9.2f %8.2f %8.2f %8.2f %8.0f %8.2f %7.1f %7.1f\n",
                        i == 0 ? name : "  rework", o.path.drive_planes, o.totals.cut_length / 1000,
                        metres[0], metres[1], metres[2], o.totals.time_seconds, o.path.stepover_max, share,
                        seconds);
            for (const std::string& w : o.warnings())
                std::printf("    %s\n", w.c_str());
        }
        if (plan->operations.size() > 1) std::printf("%-14s %51.0f\n", "  together", total);
        std::fflush(stdout);
        if (resolution > 0) {
            VerifySettings s = verify_settings(project, plan.get());
            s.resolution = resolution;
            s.sample_spacing = resolution;
            const auto programs = verify_programs(project, plan);
            const Verification v = verify(*plan->part->mesh, plan->stock, programs, s, Progress());
            std::printf(
                "    verified: gouge %.4f of %.4f, excess p99 %.4f p99.9 %.4f max %.4f, over %.3f %%, "
                "uncut %.3f %%, collisions %zu\n",
                v.figures.gouge_max, v.used.gouge_limit, v.figures.excess_p99, v.figures.excess_p999,
                v.figures.excess_max, 100 * v.figures.over_fraction, 100 * v.figures.uncut_fraction,
                v.collisions.size());
            std::fflush(stdout);
        }
    };
    // Of scallop and machining tolerance together, the latter for the chords.
    const double stays = scallop + chord;
    for (const char r : rows) {
        if (r == 'b' || r == 's') {
            Finish3Settings s;
            share(s, r == 'b' ? 3 : 2, stays);
            row(r == 'b' ? "ball 25.4" : "ball 6.35", std::make_unique<Finish3>(s));
        } else if (r == 'f') {
            Finish5Settings s;
            share(s, 1, stays);
            s.lead_limits = {0, radians(89)};
            s.posture = Finish5Settings::PostureChoice::cm2;
            row("flat CM2", std::make_unique<Finish5>(s));
        } else if (r == 'g' || r == 'c') {
            GlobalLocalSettings s;
            share(s, 1, stays);
            s.lead_limit = lead;
            s.raise_lead_limit = r == 'g';
            s.assumed_lead_limit = radians(89); // as the row beside it
            s.rework_tool = 2;
            s.rework_offset = 0.5; // what must be cut lies within a region without it
            s.posture = Finish5Settings::PostureChoice::cm2;
            row("global-local", std::make_unique<GlobalLocal>(s));
        } else if (r == 'l') {
            Finish5Settings s;
            share(s, 1, stays);
            s.lead_limits = {0, radians(45)};
            s.posture = Finish5Settings::PostureChoice::cm2;
            project.operations.clear();
            project.operations.push_back(std::make_unique<Finish5>(s));
            const auto prepared = planner.prepare(project, Progress());
            PlanContext context = preview_context(project, 0, *prepared, {});
            context.geometry = prepared->geometry;
            context.contact = std::make_shared<ContactIndex>(prepared->mesh, Progress());
            const LeastTime least = least_time(context, s, 6.35, Progress());
            std::printf(
                "%-14s %51.0f   the ball cuts %.1f %% in %.0f s; travel along %.0f degrees %.0f s; the ball "
                "alone %.0f s\n",
                "least possible", least.seconds, 100 * least.ball_area / least.area, least.ball_seconds,
                degrees(least.direction), least.straight_seconds, least.ball_alone_seconds);
            std::fflush(stdout);
        }
    }
    std::filesystem::remove(file);
}
