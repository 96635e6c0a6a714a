// Roughing of the samples from a box: ball D 1 in with a tolerance of 0.4 in (Lu, table 5-1), flat end D 0.5
// in with layers of 0.1 in; the allowance kept by contact and by a surface offset vertex by vertex (Lu
// 3.4.3). What the verifier finds beside what is stated. Then one part of a million facets.
//
//     bench_rough [RESOLUTION]      of the verifier, mm; default: 1.5
#include "core/gouge/axial_lift.h"
#include "core/gouge/tool_lift.h"
#include "core/link/motion.h"
#include "core/mesh/geometry.h"
#include "core/mesh/sample.h"
#include "core/output/motion_time.h"
#include "core/strategy/rough.h"
#include "core/verify/verify.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

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

/// The most that was found left at places where the cutter can touch the surface of the allowance.
double within_reach(const Verification& v, const PlanContext& context, double allowance, double stated) {
    const CutterProfile profile(context.tool.cutter());
    const AxialLift lift(context.contact, profile, allowance);
    const DeviationSurface& s = *v.surface;
    double most = 0;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        if (s.flags[i] != 0 || s.deviation[i] <= most) continue;
        const Vec3 p(s.points[i][0], s.points[i][1], s.points[i][2]);
        const Vec3 n(s.normals[i][0], s.normals[i][1], s.normals[i][2]);
        if (n.z() <= 0.02) continue;
        const Vec3 tip = tip_at_contact(profile, p + allowance * n, n, Vec3(0, 0, 1));
        if (tip.z() < context.part_box.lo.z()) continue;
        if (lift.tip_z(tip.x(), tip.y()) > tip.z() + 0.05 * stated) continue;
        most = s.deviation[i];
    }
    return most;
}

void row(const char* name, const PlanContext& context, bool ball, RoughSettings::Offset offset,
         double resolution) {
    const Rough op = the_operation(ball, offset);
    const auto start = std::chrono::steady_clock::now();
    const StrategyResult path = op.plan(context, Progress());
    ClProgram program;
    program.motions = link_operation(op, path, context, Progress());
    const double seconds = seconds_since(start);
    program.feed_mm_per_min = 100 * inch;
    const MotionTotals totals = motion_totals(program, Machine());
    const double all = totals.cut_length + totals.rapid_length;
    std::printf("%-8s %-5s %-8s %6zu %6zu %8.0f %5.1f %% %7.3f", name, ball ? "ball" : "flat",
                offset == RoughSettings::Offset::contact ? "contact" : "vertices", path.layers.size(),
                path.passes.size(), totals.cut_length / inch,
                100 * (totals.rapid_length + program.motions.air_length) / all, path.cusp_max / inch);
    if (resolution > 0) {
        VerifySettings v;
        v.resolution = v.sample_spacing = resolution;
        v.allowance = op.common().allowance;
        v.tolerance = path.cusp_max;
        v.gouge_limit = 1e-3 * inch;
        StockSolid stock;
        stock.box = context.stock_box;
        const VerifyProgram one{
            "R", VerifyTool(context.tool), std::make_shared<ToolMotions>(program.motions), {}};
        const Verification judged = verify(*context.part, stock, {&one, 1}, v, Progress());
        std::printf(" %8.5f %7.3f %7.3f %7.3f %5zu", judged.figures.gouge_max / inch,
                    judged.figures.excess_p99 / inch, judged.figures.excess_max / inch,
                    within_reach(judged, context, op.common().allowance, path.cusp_max) / inch,
                    judged.collisions.size());
    } else {
        std::printf(" %38s", "");
    }
    std::printf(" %6.2f\n", seconds);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const double resolution = argc > 1 ? std::atof(argv[1]) : 1.5;
    if (!(resolution > 0)) {
        std::fprintf(stderr, "usage: bench_rough [RESOLUTION]\n");
        return 2;
    }
    std::printf("lengths in inches; stated: remaining height above the allowance; gouge, p99, max: found\n");
    std::printf("part     tool  offset   layers passes   length air+rapid stated    gouge     p99     max  "
                "hits   plan s\n");
    using Offset = RoughSettings::Offset;
    for (const char* name : {"pillar", "shell", "complex"})
        for (const bool ball : {true, false})
            for (const Offset offset : {Offset::contact, Offset::vertices})
                row(name, context_of(make_sample(name, default_sample_tolerance, Progress()), the_tool(ball)),
                    ball, offset, resolution);
    const auto fine = make_sample("pillar", 0.000035 * inch, Progress());
    std::printf("pillar with %zu facets\n", fine->facet_count());
    for (const bool ball : {true, false})
        row("pillar", context_of(fine, the_tool(ball)), ball, Offset::contact, 0);
}
