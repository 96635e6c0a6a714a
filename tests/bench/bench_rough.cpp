// Roughing of the samples from a box: ball D 1 in with a tolerance of 0.4 in (Lu, table 5-1), flat end D 0.5
// in with layers of 0.1 in; the allowance kept by contact and by a surface offset vertex by vertex (Lu
// 3.4.3); the flat end after the ball ("rest"). What the verifier finds beside what is stated. Then one part
// of more than a million facets.
//
//     bench_rough [RESOLUTION [PART...]]      of the verifier, mm, 0: none; default: 1.5. Parts: pillar,
//                                             shell, complex, fine; default: all
#include "core/gouge/axial_lift.h"
#include "core/link/link.h"
#include "core/mesh/geometry.h"
#include "core/mesh/sample.h"
#include "core/output/motion_time.h"
#include "core/strategy/rough/rough.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/verify/verify.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

using namespace facetmill;

namespace {

constexpr double inch = mm_per_inch;

Tool the_tool(bool ball) {
    Tool t;
    t.diameter = t.shank_diameter = (ball ? 1 : 0.5) * inch;
    t.corner_radius = ball ? 0.5 * t.diameter : 0;
    t.flute_length = (ball ? 4 : 3) * inch;
    t.shank_length = 3 * inch;
    t.holder = {{2.5 * inch, 3 * inch}};
    return t;
}

PlanContext context_of(std::shared_ptr<const Mesh> mesh, const Tool& tool) {
    PlanContext c;
    c.part = mesh;
    c.geometry = compute_geometry(*mesh, Progress());
    c.contact = std::make_shared<ContactIndex>(mesh, Progress());
    c.part_box = c.stock_box = mesh->box();
    c.stock_box.lo -= 0.5 * inch * Vec3(1, 1, 0);
    c.stock_box.hi += inch * Vec3(0.5, 0.5, 0.25);
    c.tool = tool;
    c.unit = LengthUnit::inch;
    return c;
}

Rough the_operation(bool ball, RoughSettings::Offset offset) {
    RoughSettings s;
    s.tolerance = (ball ? 0.4 : 0.2) * inch;
    if (!ball) s.depth = {0.1 * inch, {}};
    s.allowance = 0.05 * inch;
    s.clearance = 0.1 * inch;
    s.offset = offset;
    return Rough(s);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The most that was found left where the cutter, come down on the part and its allowance over the place
/// that would touch or a little beside it, stands no farther away than a twentieth of what is stated.
double within_reach(const Verification& v, const PlanContext& context, double allowance, double stated) {
    const CutterProfile profile(context.tool.cutter());
    const CutterCover cover(profile, 1e-3);
    const AxialLift lift(context.contact, profile, allowance);
    const DeviationSurface& s = *v.surface;
    const double near = 0.05 * stated;
    double most = 0;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        if (s.flags[i] != 0 || s.deviation[i] <= most) continue;
        const Vec3 n(s.normals[i][0], s.normals[i][1], s.normals[i][2]);
        if (n.z() <= 0.02) continue;
        const Vec3 p = Vec3(s.points[i][0], s.points[i][1], s.points[i][2]) + allowance * n;
        const Vec3 touching = p + cover.tip_offset(n);
        if (touching.z() < context.part_box.lo.z()) continue;
        double away = infinity;
        for (int k = 0; k <= 8 && away > near; ++k) {
            const double turn = 2 * pi * k / 8, out = k == 0 ? 0 : near;
            const double x = touching.x() + out * std::cos(turn), y = touching.y() + out * std::sin(turn);
            away =
                std::min(away, cover.ray_entry(p, n, Vec3(x, y, lift.tip_z(x, y)), 4 * profile.max_radius()));
        }
        if (away <= near) most = s.deviation[i];
    }
    return most;
}

/// Gives what it cut.
ClSection row(const char* name, const PlanContext& context, bool ball, RoughSettings::Offset offset,
              double resolution, const ClSection* before = nullptr) {
    const Rough op = the_operation(ball, offset);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t busy = std::clock();
    const StrategyResult path = op.plan(context, Progress());
    ClSection program;
    program.cutter = context.tool.cutter();
    program.motions = link_operation(op, path, context, Progress());
    const double seconds = seconds_since(start), cpu = double(std::clock() - busy) / CLOCKS_PER_SEC;
    program.feed_mm_per_min = 100 * inch;
    const MotionTotals totals = motion_totals(program, Machine());
    const double all = totals.cut_length + totals.rapid_length;
    std::printf("%-8s %-5s %-8s %6zu %6zu %8.0f %5.1f %5.1f %% %7.3f", name,
                before ? "rest"
                : ball ? "ball"
                       : "flat",
                offset == RoughSettings::Offset::contact ? "contact" : "vertices",
                path.as<RoughPath>()->layers.size(), path.passes.size(), totals.cut_length / inch,
                100 * program.motions.air_length / all, 100 * totals.rapid_length / all,
                path.cusp_max / inch);
    std::vector<Collision> hits;
    if (resolution > 0) {
        VerifySettings v;
        v.resolution = v.sample_spacing = resolution;
        v.allowance = op.common().allowance;
        v.tolerance = path.cusp_max;
        v.gouge_limit = 1e-3 * inch;
        StockSolid stock;
        stock.box = context.stock_box;
        std::vector<VerifyProgram> programs;
        if (before)
            programs.push_back(
                {"B", VerifyTool(the_tool(true)), std::make_shared<ToolMotions>(before->motions), {}});
        programs.push_back(
            {"R", VerifyTool(context.tool), std::make_shared<ToolMotions>(program.motions), {}});
        const Verification judged = verify(*context.part, stock, programs, v, Progress());
        std::printf(" %8.5f %7.3f %7.3f %7.3f %5zu", judged.figures.gouge_max / inch,
                    judged.figures.excess_p99 / inch, judged.figures.excess_max / inch,
                    within_reach(judged, context, op.common().allowance, path.cusp_max) / inch,
                    judged.collisions.size());
        hits = judged.collisions;
    } else {
        std::printf(" %38s", "");
    }
    std::printf(" %6.2f %6.2f\n", seconds, cpu);
    for (const Collision& hit : hits)
        std::printf("    %s in %s: %.4f at (%.3f, %.3f, %.3f)\n",
                    hit.kind == Collision::Kind::rapid    ? "rapid"
                    : hit.kind == Collision::Kind::holder ? "holder"
                                                          : "shank",
                    hit.with_part ? "part" : "stock", hit.depth / inch, hit.place.x() / inch,
                    hit.place.y() / inch, hit.place.z() / inch);
    for (const std::string& warning : path.warnings)
        std::printf("    %s\n", warning.c_str());
    std::fflush(stdout);
    return program;
}

void rows(const char* name, double resolution) {
    using Offset = RoughSettings::Offset;
    const std::shared_ptr<const Mesh> mesh = make_sample(name, default_sample_tolerance, Progress());
    const PlanContext ball = context_of(mesh, the_tool(true));
    PlanContext flat = context_of(mesh, the_tool(false));
    const ClSection first = row(name, ball, true, Offset::contact, resolution);
    row(name, ball, true, Offset::vertices, resolution);
    row(name, flat, false, Offset::contact, resolution);
    row(name, flat, false, Offset::vertices, resolution);
    auto cuts = std::make_shared<EarlierCuts>();
    cuts->cutter = first.cutter;
    const auto& motions = first.motions.motions;
    for (std::size_t i = 1; i < motions.size(); ++i)
        if (motions[i].kind != MotionKind::rapid)
            cuts->motions.push_back({motions[i - 1].to.tip, motions[i].to.tip});
    flat.earlier.push_back(cuts);
    row(name, flat, false, Offset::contact, resolution, &first);
}

} // namespace

int main(int argc, char** argv) {
    const double resolution = argc > 1 ? std::atof(argv[1]) : 1.5;
    if (!(resolution >= 0)) {
        std::fprintf(stderr, "usage: bench_rough [RESOLUTION [PART...]]\n");
        return 2;
    }
    const auto wanted = [&](const char* name) {
        return argc <= 2
               || std::any_of(argv + 2, argv + argc, [&](const char* a) { return !std::strcmp(a, name); });
    };
    std::printf(
        "lengths in inches; stated: remaining height above the allowance; gouge, p99, max, max within the "
        "tool's reach: found; plan: with its links, by the clock and of all processors\n");
    std::printf("part     tool  offset   layers passes   length   air rapid    stated    gouge     p99     "
                "max   reach "
                " hits   plan s  cpu s\n");
    for (const char* name : {"pillar", "shell", "complex"})
        if (wanted(name)) rows(name, resolution);
    if (!wanted("fine")) return 0;
    const auto fine = make_sample("pillar", 0.000035 * inch, Progress());
    std::printf("pillar with %zu facets\n", fine->facet_count());
    for (const bool ball : {true, false})
        row("pillar", context_of(fine, the_tool(ball)), ball, RoughSettings::Offset::contact, 0);
}
