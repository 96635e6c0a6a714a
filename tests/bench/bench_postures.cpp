// The load of a configuration space: all postures (inclination 0 to 45 degrees, yaw -45 to 45 degrees, 3
// degree grid: 496) at contact points of the `complex` sample, flat end D 0.5 in with shank and holder. For
// every posture the lift of the whole tool; and whether it is blocked above a limit of lift. Against the
// plain method: every facet within the tool's reach tested for every posture.
//
//     bench_postures [POINTS]      default: 10000
#include "core/base/parallel.h"
#include "core/gouge/tool_lift.h"
#include "core/mesh/sample.h"
#include "tests/bench/posture_load.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace facetmill;
using namespace facetmill::bench;

namespace {

/// Postures in the frame of a contact point: leaning by `inclination` from the normal, turned by `yaw` about
/// it.
std::vector<ToolPose> postures(const CutterProfile& cutter, const Vec3& point, const Vec3& normal) {
    const Vec3 feed = Vec3(Vec3::UnitX() - normal.x() * normal).normalized(), across = normal.cross(feed);
    std::vector<ToolPose> poses;
    for (int yaw = -45; yaw <= 45; yaw += 3)
        for (int tilt = 0; tilt <= 45; tilt += 3) {
            const double lean =
                radians(yaw % 2 ? 45 - tilt : tilt); // to and fro: neighbours follow each other
            const Vec3 to = std::cos(radians(yaw)) * feed + std::sin(radians(yaw)) * across;
            const Vec3 axis = (std::cos(lean) * normal + std::sin(lean) * to).normalized();
            poses.push_back({tip_at_contact(cutter, point, normal, axis), axis});
        }
    return poses;
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t wanted = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000;
    if (wanted == 0) {
        std::fprintf(stderr, "usage: bench_postures [POINTS]\n");
        return 2;
    }
    const auto mesh = make_sample("complex", default_sample_tolerance, Progress());
    const Tool tool = the_tool();
    const ToolLift lift(std::make_shared<ContactIndex>(mesh, Progress()), tool);
    const CutterProfile cutter(tool.cutter());
    std::printf("complex: %zu facets; %zu contact points\n", mesh->facet_count(), wanted);
    std::vector<std::vector<ToolPose>> all(wanted);
    for (std::size_t i = 0; i < wanted; ++i) {
        const auto [point, normal] = contact_point(*mesh, i, wanted);
        all[i] = postures(cutter, point, normal);
    }
    const std::size_t count = all[0].size();

    set_thread_count(1);
    double checksum = 0;
    std::vector<double> lifts(count);
    double start = cpu_now();
    for (const auto& poses : all) {
        lift.lift(poses, lifts, Progress());
        checksum += *std::max_element(lifts.begin(), lifts.end());
    }
    const double full = double(wanted * count) / (cpu_now() - start);
    std::size_t blocked = 0;
    constexpr double max_lift = 0.1;
    start = cpu_now();
    for (const auto& poses : all) {
        ToolLift::Hint hint;
        for (const ToolPose& pose : poses)
            blocked += lift.is_deeper(pose, max_lift, hint);
    }
    const double tested = double(wanted * count) / (cpu_now() - start);

    const PlainTool plain_tool(tool);
    const std::size_t samples = std::max<std::size_t>(20, 4'000'000 / mesh->facet_count());
    double worst = 0;
    start = cpu_now();
    std::vector<std::pair<const ToolPose*, double>> plain(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        const auto& poses = all[(2 * i + 1) * wanted / (2 * samples)];
        plain[i].first = &poses[i * 37 % count];
        plain[i].second = plain_tool.lift(*mesh, *plain[i].first);
    }
    const double plain_rate = double(samples) / (cpu_now() - start);
    for (const auto& [pose, value] : plain) {
        const double got = lift.lift(*pose);
        if (got != value) worst = std::max(worst, std::abs(got - value));
    }
    std::printf("postures a point: %zu; blocked above a lift of %.1f mm: %.1f %%\n", count, max_lift,
                100 * double(blocked) / double(wanted * count));
    std::printf("%-28s %14s %10s\n", "", "postures/s*", "ratio");
    std::printf("%-28s %14.0f %10s\n", "plain method", plain_rate, "1");
    std::printf("%-28s %14.0f %10.0f\n", "lift of the whole tool", full, full / plain_rate);
    std::printf("%-28s %14.0f %10.0f\n", "blocked or free", tested, tested / plain_rate);
    std::printf("worst difference %.2e mm; checksum %.9g\n* one thread, by processor time\n", worst,
                checksum);
}
