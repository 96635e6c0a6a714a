// The configuration spaces of contact points of the `complex` sample, flat end D 0.5 in with shank and
// holder: 496 postures each (inclination 0 to 45 degrees, yaw -45 to 45 degrees, 3 degree grid), with three
// strip boundaries. Processor time of the bottom (S2) and of the top (S1); and of the bottom by the plain
// method: every facet within the tool's reach, tested for every posture.
//
//     bench_cspace [POINTS]      default: 10000
#include "core/base/parallel.h"
#include "core/cspace/cspace.h"
#include "core/gouge/axial_lift.h"
#include "core/mesh/sample.h"
#include "tests/bench/median.h"
#include "tests/bench/posture_load.h"

#include <cstdio>
#include <cstdlib>

using namespace facetmill;
using namespace facetmill::bench;

int main(int argc, char** argv) {
    const std::size_t wanted = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000;
    if (wanted == 0) {
        std::fprintf(stderr, "usage: bench_cspace [POINTS]\n");
        return 2;
    }
    constexpr double tolerance_mm = 0.004 * 25.4, spacing = 0.8;
    constexpr int half_points = 10;
    const auto mesh = make_sample("complex", default_sample_tolerance, Progress());
    const auto index = std::make_shared<ContactIndex>(mesh, Progress());
    const Tool tool = the_tool();
    const ToolLift lift(index, tool);
    const PostureGrid grid = PostureGrid::make(0, radians(45), radians(-45), radians(45), radians(3));
    const CSpaceBuilder builder({.lift = &lift, .grid = &grid, .local_radius = tool.diameter});

    // Strip boundaries: on the part beside the contact point, raised by the tolerance.
    const AxialLift heights(index, CutterProfile(AptCutter::flat(1e-6, 1)));
    std::vector<ContactFrame> frames;
    std::vector<std::vector<RaisedCurve>> curves(wanted);
    for (std::size_t i = 0; i < wanted; ++i) {
        const auto [point, normal] = contact_point(*mesh, i, wanted);
        frames.push_back(ContactFrame::at(point, normal, Vec3::UnitX()));
        for (const double side : {-1.5, 1.5, 2.5}) {
            RaisedCurve curve;
            for (int k = -half_points; k <= half_points; ++k) {
                const double x = point.x() + spacing * k, y = point.y() + side, z = heights.tip_z(x, y);
                if (z > -infinity) curve.push_back(Vec3(x, y, z) + tolerance_mm * normal);
            }
            if (!curve.empty()) curves[i].push_back(std::move(curve));
        }
    }

    set_thread_count(1);
    // The build and the plain method by turns: what else the machine does falls on both.
    constexpr std::size_t turns = 5;
    CSpaceInput quick_input = builder.input();
    quick_input.bottom_everywhere = false;
    const CSpaceBuilder quick_builder(quick_input);
    const PlainTool plain(tool);
    const std::size_t samples = std::max<std::size_t>(20, 4'000'000 / mesh->facet_count());
    const double postures = double(wanted * grid.size());
    std::vector<CSpace> spaces;
    std::vector<double> bottom, top, all, quick_bottom, plain_bottom;
    double worst = 0;
    for (std::size_t turn = 0; turn < turns; ++turn) {
        CSpaceBuilder::Stages stages, quick;
        const double start = cpu_now();
        spaces = builder.build(frames, curves, Progress(), &stages);
        all.push_back(cpu_now() - start);
        bottom.push_back(stages.bottom);
        top.push_back(stages.top);
        quick_builder.build(frames, curves, Progress(), &quick);
        quick_bottom.push_back(quick.bottom);
        double spent = 0;
        for (std::size_t i = turn; i < samples * turns; i += turns) {
            const std::size_t point = (2 * i + 1) * wanted / (2 * samples * turns),
                              node = i * 37 % grid.size();
            const ToolPose pose =
                posture_pose(lift.cutter(), frames[point],
                             {grid.lead[node / grid.yaw.size()], grid.yaw[node % grid.yaw.size()], 0});
            const double before = cpu_now();
            const double want = std::max(0.0, plain.lift(*mesh, pose));
            spent += cpu_now() - before;
            worst = std::max(worst, std::abs(want - spaces[point].bottom[node]));
        }
        plain_bottom.push_back(spent * postures / double(samples));
    }

    std::size_t count[7] = {};
    for (const CSpace& space : spaces)
        for (const PostureBlock block : space.block)
            ++count[std::size_t(block)];

    std::printf("complex: %zu facets; %zu contact points, %zu postures each\n", mesh->facet_count(), wanted,
                grid.size());
    for (std::size_t b = 0; b < 7; ++b)
        std::printf("%s %.1f %%  ", posture_block_name(PostureBlock(b)), 100 * double(count[b]) / postures);
    std::printf("\n%-28s %12s %14s %8s\n", "", "seconds*", "postures/s", "ratio");
    const auto row = [&](const char* name, double seconds, double ratio) {
        std::printf("%-28s %12.2f %14.0f %8.2f\n", name, seconds, postures / seconds, ratio);
    };
    const double s2 = median(bottom), plain_seconds = median(plain_bottom);
    row("bottom (S2), plain method", plain_seconds, plain_seconds / s2);
    row("bottom (S2)", s2, 1);
    row("bottom where top >= 0", median(quick_bottom), median(quick_bottom) / s2);
    row("top (S1)", median(top), median(top) / s2);
    row("all", median(all), median(all) / s2);
    std::printf("worst difference %.2e mm\n* one thread, by processor time; medians of five runs, those of "
                "the plain method with %zu postures each\n",
                worst, samples);
}
