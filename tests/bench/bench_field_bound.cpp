// What passes along any field of directions could save over parallel ones: the lengths that are least
// possible (tests/bench/least_length) beside those of the paths that five-axis finishing plans along X and Y.
//
//     bench_field_bound PART [DIAMETER [CORNER [TOLERANCE [POSTURE [SIZE]]]]]
//
// PART is a sample, or a mesh file, which is scaled to SIZE mm (default 200) across its longest side.
// Default: a flat end D 25.4, tolerance 0.08 mm, posture cm2 (or global, which tries yaws as well).
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "core/setup/machine.h"
#include "tests/bench/least_length.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

using namespace facetmill;

namespace {

/// Of a sample: its facets are to be no part of what is measured.
constexpr double mesh_tolerance = 0.01;

double number(int argc, char** argv, int i, double otherwise) {
    return argc > i ? std::atof(argv[i]) : otherwise;
}

} // namespace

int main(int argc, char** argv) {
    const std::string part = argc > 1 ? argv[1] : "";
    const double diameter = number(argc, argv, 2, 25.4), corner = number(argc, argv, 3, 0),
                 tolerance = number(argc, argv, 4, 0.08), size = number(argc, argv, 6, 200);
    const std::string posture = argc > 5 ? argv[5] : "cm2";
    if (part.empty() || !(diameter > 0 && corner >= 0 && tolerance > 0 && size > 0)) {
        std::fprintf(stderr,
                     "usage: bench_field_bound PART [DIAMETER [CORNER [TOLERANCE [POSTURE [SIZE]]]]]\n");
        return 2;
    }
    MeshPtr mesh;
    if (std::filesystem::exists(part)) {
        Mesh read = *load_mesh(part, MeshReading{}, Progress()).mesh;
        const double scale = size / read.box().size().maxCoeff();
        for (Vec3& p : read.vertices)
            p *= scale;
        mesh = std::make_shared<const Mesh>(std::move(read));
    } else {
        mesh = make_sample(part, mesh_tolerance, Progress());
    }
    PlanContext context;
    context.part = mesh;
    context.contact = std::make_shared<ContactIndex>(mesh, Progress());
    context.part_box = context.stock_box = mesh->box();
    context.machine = find_machine("trunnion-ac");
    context.tool.diameter = context.tool.shank_diameter = diameter;
    context.tool.corner_radius = corner;
    context.tool.flute_length = 110; // nothing was roughed before
    context.tool.shank_length = 30;
    Finish5Settings s;
    s.name = "Row";
    s.tolerance = tolerance;
    s.chord_tolerance = {0.4 * tolerance, ""};
    s.lead_limits = {0, radians(89)};
    s.sides = Finish5Settings::Sides::top;
    if (posture == "cm2") s.posture = Finish5Settings::PostureChoice::cm2;

    double best = infinity;
    for (const char* direction : {"x", "y"}) {
        s.direction = {0, direction};
        const StrategyResult path = Finish5(s).plan(context, Progress());
        double cut = 0;
        for (const Pass& pass : path.passes)
            for (std::size_t i = 1; i < pass.cl.size(); ++i)
                cut += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
        std::printf("%s along %s: %.2f m\n", part.c_str(), direction, cut / 1000);
        std::fflush(stdout);
        best = std::min(best, cut);
    }
    const auto start = std::chrono::steady_clock::now();
    const LeastLength least = least_length(context, s, Progress());
    const auto row = [&](const char* what, double length) {
        std::printf("    %-36s %8.2f m, the path is %.2f times as long\n", what, length / 1000,
                    best / length);
    };
    std::printf("    %.0f mm² that some posture serves\n", least.area);
    row("any direction, near places count", least.near);
    row("any direction", least.free);
    row("any direction, steady spread", least.steady);
    std::printf("    one direction, at %.0f degrees:\n", degrees(least.straight_direction));
    row("one direction", least.straight);
    row("one direction, steady spread", least.straight_steady);
    std::printf("    %.1f s\n",
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}
