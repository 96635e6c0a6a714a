// Clean-up of the samples after a ball: what is found against the known valleys of the mould, clean and as a
// scan would give it; how long it takes, up to a million facets.
//
//     bench_cleanup [CHORD_TOLERANCE]      of the largest mould, mm; default: 0.0042, a million facets
#include "core/mesh/geometry.h"
#include "core/mesh/sample.h"
#include "core/strategy/cleanup.h"
#include "tests/property/shapes.h"
#include "tests/property/valley_parts.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace facetmill;
using namespace facetmill::test;

namespace {

void row(const char* name, const Mesh& mesh, const std::vector<std::vector<Vec3>>& valleys, double previous,
         double diameter, double beside) {
    PlanContext context = context_of(mesh, ball_tool(diameter));
    context.further_tools = {ball_tool(previous)};
    CleanupSettings s;
    s.tolerance = 0.05;
    s.tool = 2;
    const auto start = std::chrono::steady_clock::now();
    const StrategyResult path = Cleanup(s).plan(context, Progress());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::vector<std::vector<Vec3>> found;
    double area = 0, length = 0, cut = 0;
    for (const Strip& strip : path.strips) {
        found.insert(found.end(), strip.centers.begin(), strip.centers.end());
        area += strip.area;
        length += strip.length;
    }
    for (const Pass& pass : path.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            cut += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
    std::printf("%-12s %8zu %6zu %8.1f %8.1f %6zu %8.1f", name, mesh.facet_count(), path.strips.size(),
                length, area, path.passes.size(), cut);
    const auto share = [&](const auto& of, const auto& in) {
        std::size_t near = 0;
        const auto places = places_along(of, 0.2);
        for (const Vec3& p : places)
            near += distance_to(in, p) <= beside;
        return 100.0 * double(near) / double(std::max<std::size_t>(places.size(), 1));
    };
    if (!valleys.empty())
        std::printf(" %7.2f %7.2f", share(valleys, found), 100 - share(found, valleys));
    else
        std::printf(" %15s", "");
    std::printf(" %7.4f %7.2f\n", path.cusp_max, seconds);
    for (const auto& w : path.warnings)
        std::printf("    %s\n", w.c_str());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const double finest = argc > 1 ? std::atof(argv[1]) : 0.0042;
    std::printf("%-12s %8s %6s %8s %8s %6s %8s %7s %7s %7s %7s\n", "part", "facets", "strips", "length",
                "area", "passes", "cut", "found %", "false %", "cusp", "s");
    const ValleyPart mould = mould_part();
    row("mould", mould.mesh, mould.valleys, 12, 4, 0.15);
    row("mould noisy", scanned(mould.mesh, 1.6, 0.01, 7), mould.valleys, 12, 4, 0.3);
    row("gap", *make_sample("gap", default_sample_tolerance, Progress()), {}, 25.4, 6, 0.15);
    row("pillar", *make_sample("pillar", default_sample_tolerance, Progress()), {}, 25.4, 8, 0.15);
    row("mould fine", *make_sample("mould", finest, Progress()), mould.valleys, 12, 4, 0.15);
}
