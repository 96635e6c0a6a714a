// Finishing of turned parts of about 100 000 facets over 40 mm with Jasra's 3620 points a turn and a side
// feed of 0.1 mm, and the same with steps and feeds left to the program; roughing by two passes; balls, a
// bull-nose and a flat end. Two threads.
//
//     bench_lathe [THREADS] [PART]
#include "core/base/parallel.h"
#include "core/link/link.h"
#include "core/mesh/sample.h"
#include "core/strategy/lathe/lathe_finish.h"
#include "core/strategy/lathe/lathe_rough.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace facetmill;

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

PlanContext context_of(std::shared_ptr<const Mesh> mesh, double diameter, double corner_radius) {
    PlanContext c;
    c.part = mesh;
    c.contact = std::make_shared<ContactIndex>(mesh, Progress());
    c.part_box = c.stock_box = mesh->box();
    double radius = 0;
    for (const Vec3& v : mesh->vertices)
        radius = std::max(radius, std::hypot(v.y(), v.z()));
    c.stock.kind = StockSolid::Kind::cylinder;
    c.stock.axis = 0;
    c.stock.radius = radius + 2;
    for (const int k : {1, 2}) {
        c.stock_box.lo[k] = -c.stock.radius;
        c.stock_box.hi[k] = c.stock.radius;
    }
    c.stock.box = c.stock_box;
    c.tool.diameter = c.tool.shank_diameter = diameter;
    c.tool.corner_radius = corner_radius;
    c.tool.flute_length = 40;
    c.tool.holder = {{40, 40}};
    c.machine = find_machine("lathe-mill");
    return c;
}

void run(const char* name, const Operation& op, const PlanContext& context) {
    auto start = std::chrono::steady_clock::now();
    const StrategyResult path = op.plan(context, Progress());
    const double planning = seconds_since(start);
    std::size_t points = 0;
    for (const Pass& p : path.passes)
        points += p.cl.size();
    start = std::chrono::steady_clock::now();
    const ToolMotions motions = link_operation(op, path, context, Progress());
    std::printf(
        "  %-34s %8.2f s   link %6.2f s   %5d turns   %9zu CL   %6.1f a turn   feed %.4f to %.4f mm\n", name,
        planning, seconds_since(start), path.drive_planes, points,
        double(points) / std::max(path.drive_planes, 1), path.stepover_min, path.stepover_max);
    for (const std::string& w : path.warnings)
        std::printf("      %s\n", w.c_str());
}

/// The sample at the tolerance that gives about this many facets.
std::shared_ptr<const Mesh> with_facets(const char* name, std::size_t facets) {
    double tolerance = default_sample_tolerance;
    auto mesh = make_sample(name, tolerance, Progress());
    for (int i = 0; i < 12 && mesh->facet_count() < facets; ++i) {
        tolerance *= std::min(0.8, double(mesh->facet_count()) / double(facets));
        mesh = make_sample(name, tolerance, Progress());
    }
    return mesh;
}

} // namespace

int main(int argc, char** argv) {
    set_thread_count(argc > 1 ? std::atoi(argv[1]) : 2);
    struct Shape {
        const char* name;
        double diameter, corner_radius;
    };
    for (const std::string name : {"twisted-prism", "extruded-pattern", "swept-pattern"}) {
        if (argc > 2 && name != argv[2]) continue;
        const auto part = with_facets(name.c_str(), 100'000);
        for (const Shape& shape : {Shape{"ball", 3.175, 1.5875}, Shape{"ball", 12.7, 6.35},
                                   Shape{"bull", 12.7, 2}, Shape{"flat", 6.35, 0}}) {
            const PlanContext context = context_of(part, shape.diameter, shape.corner_radius);
            std::printf("%s, %zu facets, %s D %g\n", name.c_str(), part->facet_count(), shape.name,
                        shape.diameter);
            std::fflush(stdout);
            LatheFinishSettings s;
            s.start = {5, ""};
            s.stop = {45, ""};
            s.tolerance = 0.05;
            s.points_per_turn = {3620, ""};
            s.side_feed = {0.1, ""};
            run("3620 points, 0.1 mm", LatheFinish(s), context);
            s.points_per_turn = {0, "auto"};
            s.side_feed = {0, "adaptive"};
            run("adaptive, tolerance 0.05", LatheFinish(s), context);
            LatheRoughSettings r;
            r.start = s.start;
            r.stop = s.stop;
            r.depth_of_cut = 4;
            r.tolerance = 0.5;
            run("rough", LatheRough(r), context);
        }
    }
    return 0;
}
