// Material removal: a finish path of the `concave` sample (3-axis, ball D 0.5 in), and a made-up 5-axis path
// of turning axes over the `complex` sample (flat end D 0.5 in), on a stock of rays a twentieth of the
// cutter's radius apart. The ratio says how many times faster than the machine at 100 in/min.
//
//     bench_verify [THREADS [CL POINTS OF THE 5-AXIS PATH]]
#include "core/base/parallel.h"
#include "core/gouge/axial_lift.h"
#include "core/gouge/tool_lift.h"
#include "core/job/project.h"
#include "core/link/link.h"
#include "core/mesh/geometry.h"
#include "core/mesh/sample.h"
#include "core/verify/removal.h"
#include "tests/bench/cpu_time.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace facetmill;

namespace {

constexpr double inch = 25.4, feed = 100 * inch / 60; // mm/s

Tool the_tool(double corner_radius) {
    Tool tool;
    tool.diameter = 0.5 * inch;
    tool.corner_radius = corner_radius;
    tool.flute_length = 1.5 * inch;
    tool.shank_diameter = 0.5 * inch;
    tool.shank_length = 2 * inch;
    tool.holder = {{2 * inch, 3 * inch}};
    return tool;
}

StockSolid stock_round(const Box3& part) {
    StockSolid solid;
    solid.box = part;
    solid.box.lo -= Vec3(0.1, 0.1, 0) * inch;
    solid.box.hi += Vec3(0.1, 0.1, 0.1) * inch;
    return solid;
}

std::shared_ptr<const ToolMotions> finish(const MeshPtr& part) {
    PlanContext context;
    context.part = part;
    context.geometry = compute_geometry(*part, Progress());
    context.contact = std::make_shared<ContactIndex>(part, Progress());
    context.part_box = part->box();
    context.stock_box = stock_round(context.part_box).box;
    context.tool = the_tool(0.25 * inch);
    const auto operation = make_operation("finish3");
    operation->common().tolerance = 0.002 * inch;
    const StrategyResult path = operation->plan(context, Progress());
    return std::make_shared<ToolMotions>(link_three_axis(
        path, context, 0, default_link_options(path, context, operation->common()), Progress()));
}

/// Rows over the part, the tool leaning this way and that by up to 20 degrees, lifted so that it does not cut
/// in.
std::shared_ptr<const ToolMotions> swaying(const MeshPtr& part, std::size_t points) {
    const Tool tool = the_tool(0);
    const ToolLift lift(std::make_shared<ContactIndex>(part, Progress()), tool);
    const Box3 box = part->box();
    const auto rows = std::size_t(std::sqrt(double(points) / 4)), columns = points / rows;
    auto motions = std::make_shared<ToolMotions>();
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c) {
            const double u = double(r % 2 ? columns - 1 - c : c) / double(columns - 1),
                         v = double(r) / double(rows - 1);
            const double lean = radians(20) * std::sin(15 * u + 3 * v), turn = 6 * u;
            const Vec3 axis(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean));
            Vec3 tip = box.lo + Vec3(u, v, 0).cwiseProduct(box.size());
            tip += lift.lift({tip, axis}) * axis;
            motions->motions.push_back(
                {motions->motions.empty() ? MotionKind::rapid : MotionKind::cut, {tip, axis}});
        }
    return motions;
}

void run(const char* name, const MeshPtr& part, const Tool& tool,
         std::shared_ptr<const ToolMotions> motions) {
    double length = 0;
    for (std::size_t i = 1; i < motions->motions.size(); ++i)
        length += (motions->motions[i].to.tip - motions->motions[i - 1].to.tip).norm();
    const double resolution = tool.diameter / 40;
    const StockSolid solid = stock_round(part->box());
    const std::vector<VerifyProgram> programs{{name, VerifyTool(tool), motions, std::nullopt}};
    for (bool watch : {false, true}) {
        StockModel stock(solid, StockLattice::over(solid.box, resolution), Progress());
        MaterialRemoval removal(programs, 0.5 * resolution, 0.02 * resolution);
        const double cpu = bench::cpu_now();
        const auto start = std::chrono::steady_clock::now();
        removal.cut(stock, 0, 0, motions->motions.size(), 1, watch, Progress());
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::printf("%-10s %8zu motions %9.0f mm  rays %8zu  %s: %6.2f s wall %6.2f s cpu  machine/ours "
                    "%7.1f  %5.1f MB  "
                    "collisions %zu\n",
                    name, motions->motions.size(), length, stock.lattice().rays(),
                    watch ? "watched" : "cut only", seconds, bench::cpu_now() - cpu, length / feed / seconds,
                    double(stock.bytes()) / 1e6, removal.collisions().size());
    }
}

/// Known shapes, cut on finer and finer lattices.
void convergence() {
    const StockSolid solid = [] {
        StockSolid box;
        box.box.add(Vec3(-10, -10, 0));
        box.box.add(Vec3(10, 10, 10));
        return box;
    }();
    const auto cut = [&](const AptCutter& cutter, const std::vector<CutterLocation>& at, double resolution) {
        auto motions = std::make_shared<ToolMotions>();
        for (const CutterLocation& l : at)
            motions->motions.push_back({motions->motions.empty() ? MotionKind::rapid : MotionKind::cut, l});
        const std::vector<VerifyProgram> programs{{"Test", VerifyTool(cutter), motions, std::nullopt}};
        StockModel stock(solid, StockLattice::over(solid.box, resolution), Progress());
        MaterialRemoval(programs, 0.5 * resolution, 0).cut(stock, 0, 0, at.size(), 1, false, Progress());
        return stock;
    };
    std::printf(
        "resolution   ball hole: volume   tilted hole: volume   ball rows: highest cusp (exact %.5f)\n",
        4 - std::sqrt(16 - 1.15 * 1.15));
    for (double resolution : {1.0, 0.5, 0.25, 0.125}) {
        const Vec3 up = Vec3::UnitZ(), lean = Vec3(0.6, 0, 0.8);
        const double ball =
            4000
            - cut(AptCutter::ball(8, 30), {{{0.1, 0.2, 20}, up}, {{0.1, 0.2, 4}, up}}, resolution).volume();
        // A leaning flat end that goes right through: cylinder of radius 3 between two planes.
        const double tilted =
            4000
            - cut(AptCutter::flat(6, 60),
                  {{Vec3(0, 0, 5) + 30 * lean, lean}, {Vec3(0, 0, 5) - 20 * lean, lean}}, resolution)
                  .volume();
        std::vector<CutterLocation> rows;
        for (int k = -6; k <= 6; ++k)
            for (double x : {-15.0, 15.0})
                rows.push_back({{k % 2 ? x : -x, 2.3 * k + 0.3, 6}, up});
        const StockModel level = cut(AptCutter::ball(8, 30), rows, resolution);
        double highest = 0;
        for (int j = 0; j < level.lattice().nodes[1]; ++j)
            highest = std::max(highest, level.stretches(2, level.lattice().nodes[0] / 2, j).back()[1] - 6);
        std::printf("%7.3f mm   %17.4f%%   %19.4f%%   %12.5f\n", resolution,
                    100 * (ball / (pi * 16 * 2 + 2.0 / 3 * pi * 64) - 1),
                    100 * (tilted / (pi * 9 * 10 / 0.8) - 1), highest);
    }
}

} // namespace

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    if (argc > 1) set_thread_count(std::atoi(argv[1]));
    const std::size_t turning = argc > 2 ? std::size_t(std::atoi(argv[2])) : 100'000;
    convergence();
    const MeshPtr concave = make_sample("concave", default_sample_tolerance, Progress());
    run("concave", concave, the_tool(0.25 * inch), finish(concave));
    const MeshPtr complex = make_sample("complex", default_sample_tolerance, Progress());
    run("complex", complex, the_tool(0), swaying(complex, turning));
}
