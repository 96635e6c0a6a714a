// Clean-up of the samples after a ball: what is found against the known valleys, clean and as a scan would
// give it; how long it takes, up to a million facets. `index` is the contact index of the part, made once
// for all operations; `plan` all of the operation, `cpu` of all threads together.
//
//     bench_cleanup                  the table
//     bench_cleanup PART TOLERANCE   mould, pillar or gap alone, tessellated to a chord tolerance in mm
#include "core/mesh/geometry.h"
#include "core/mesh/sample.h"
#include "core/strategy/cleanup/cleanup.h"
#include "tests/property/shapes.h"
#include "tests/property/valley_parts.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

using namespace facetmill;
using namespace facetmill::test;

namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void row(const std::string& name, const ValleyPart& part, const Mesh& mesh, double beside) {
    const double first = now();
    PlanContext context = context_of(mesh, ball_tool(part.diameter));
    const double indexed = now();
    context.further_tools = {ball_tool(part.previous)};
    CleanupSettings s;
    s.tolerance = 0.05;
    s.tool = 2;
    const std::clock_t cpu = std::clock();
    const StrategyResult path = Cleanup(s).plan(context, Progress());
    const double seconds = now() - indexed, used = double(std::clock() - cpu) / CLOCKS_PER_SEC;
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
    const auto share = [&](const auto& of, const auto& in) {
        std::size_t near = 0;
        const auto places = places_along(of, 0.2);
        for (const Vec3& p : places)
            near += distance_to(in, p) <= beside;
        return 100.0 * double(near) / double(std::max<std::size_t>(places.size(), 1));
    };
    std::printf("%-14s %8zu %6zu %8.1f %8.1f %6zu %8.1f %7.2f %7.2f %7.4f %7.2f %7.2f %7.2f\n", name.c_str(),
                mesh.facet_count(), path.strips.size(), length, area, path.passes.size(), cut,
                share(part.valleys, found), 100 - share(found, part.valleys), path.cusp_max, indexed - first,
                seconds, used);
    for (const auto& w : path.warnings)
        std::printf("    %s\n", w.c_str());
    std::fflush(stdout);
}

void fine(const std::string& name, const ValleyPart& part, double tolerance) {
    row(name + " fine", part, *make_sample(name, tolerance, Progress()), part.beside);
}

} // namespace

int main(int argc, char** argv) {
    std::printf("%-14s %8s %6s %8s %8s %6s %8s %7s %7s %7s %7s %7s %7s\n", "part", "facets", "strips",
                "length", "area", "passes", "cut", "found %", "false %", "cusp", "index s", "plan s",
                "cpu s");
    const ValleyPart mould = mould_part(), pillar = pillar_part(), gap = gap_part();
    if (argc == 3) {
        const std::string name = argv[1];
        fine(name, name == "pillar" ? pillar : name == "gap" ? gap : mould, std::atof(argv[2]));
        return 0;
    }
    for (const ValleyPart* part : {&mould, &pillar, &gap}) {
        row(part->name, *part, part->mesh, part->beside);
        row(part->name + " noisy", *part, scanned(part->mesh, 1.6, 0.01, 7), part->beside_noisy);
    }
    // A million facets each.
    fine("mould", mould, 0.007);
    fine("pillar", pillar, 0.0016);
}
