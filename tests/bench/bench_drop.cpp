// Rate of axial lifts: ball, flat, bull and cone D 6 on a grid over height fields of 250 x 250 mm with
// jittered vertices, with 1 and 2 threads, against our own scalar search from before the kernels used vectors
// (scalar/) and against a plain scan over all facets (Lu 3.1); build time and memory of the index. All points
// are compared with the scalar search, some with the brute-force reference.
//
//     bench_drop [GRID [FACETS ...]]      default: 500 20000 1000000
#include "core/base/parallel.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/axial_lift.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/median.h"
#include "tests/bench/scalar/axial_elements.h"
#include "tests/bench/scalar/axial_lift.h"
#include "tests/support/brute_lift.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

using namespace facetmill;

namespace {

constexpr double size = 250;

std::shared_ptr<const Mesh> height_field(std::size_t facets) {
    const auto n = std::size_t(std::lround(std::sqrt(double(facets) / 2)));
    std::mt19937_64 rng(1);
    std::uniform_real_distribution<double> jitter(-0.3, 0.3);
    const auto mesh = std::make_shared<Mesh>();
    mesh->vertices.reserve((n + 1) * (n + 1));
    for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i) {
            const double x = size * (double(i) + jitter(rng)) / double(n),
                         y = size * (double(j) + jitter(rng)) / double(n);
            mesh->vertices.emplace_back(
                x, y, 10 * std::sin(0.11 * x) * std::cos(0.07 * y) + 2 * std::sin(0.5 * x + 0.3 * y));
        }
    mesh->facets.reserve(2 * n * n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const Index a = Index(j * (n + 1) + i), b = a + 1, c = a + Index(n) + 1, d = c + 1;
            mesh->facets.push_back({a, b, d});
            mesh->facets.push_back({a, d, c});
        }
    return mesh;
}

/// Processor time of the whole program: for one thread, what the wall clock would show on an idle machine.
template <class Call>
double cpu_seconds(Call&& call) {
    const double start = bench::cpu_now();
    call();
    return bench::cpu_now() - start;
}

template <class Call>
double seconds(Call&& call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Every corner, edge and facet of the mesh, one after another.
double scan(const Mesh& mesh, const scalar::LowerSurface& surface, const Vec2& at) {
    using namespace scalar;
    double best = -infinity;
    for (const Facet& f : mesh.facets) {
        Vec3 p[3];
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = mesh.vertices[f[k]] - Vec3(at.x(), at.y(), 0);
        for (std::size_t k = 0; k < 3; ++k)
            best = std::max(
                {best, vertex_lift(surface, p[k]).tip_z, edge_lift(surface, p[k], p[(k + 1) % 3]).tip_z});
        best = std::max(best, facet_lift(surface, p[0], p[1], p[2]).tip_z);
    }
    return best;
}

void run(std::size_t facets, std::size_t grid) {
    const auto mesh = height_field(facets);
    double build[2];
    ContactIndexPtr index;
    for (int threads = 1; threads <= 2; ++threads) {
        set_thread_count(threads);
        build[threads - 1] = seconds([&] { index = std::make_shared<ContactIndex>(mesh, Progress()); });
    }
    std::printf("\n%zu facets: index built in %.3f s (1 thread), %.3f s (2 threads), %.1f bytes a facet\n",
                mesh->facet_count(), build[0], build[1],
                double(index->memory()) / double(mesh->facet_count()));
    const auto scalar_index = std::make_shared<scalar::ContactIndex>(mesh, Progress());
    std::printf("%-6s %14s %14s %8s %14s %8s %14s %10s %12s\n", "cutter", "1 thread /s*", "2 threads /s",
                "ratio", "scalar /s", "speed-up", "plain scan /s", "speed-up", "worst mm");
    std::vector<Vec2> points;
    for (std::size_t j = 0; j < grid; ++j)
        for (std::size_t i = 0; i < grid; ++i)
            points.emplace_back(size * double(i) / double(grid - 1), size * double(j) / double(grid - 1));
    std::vector<double> heights(points.size());

    const std::pair<const char*, AptCutter> cutters[] = {{"ball", AptCutter::ball(6, 50)},
                                                         {"flat", AptCutter::flat(6, 50)},
                                                         {"bull", AptCutter::bull(6, 1, 50)},
                                                         {"cone", AptCutter::cone(6, radians(45))}};
    for (const auto& [name, apt] : cutters) {
        const AxialLift lift(index, CutterProfile(apt));
        lift.tip_z(std::span(points).first(points.size() / 10), std::span(heights).first(points.size() / 10),
                   Progress());
        // One and two threads by turns: what else the machine does falls on both.
        constexpr std::size_t turns = 5;
        std::vector<double> wall[2], cpu[2];
        for (std::size_t turn = 0; turn < turns; ++turn)
            for (const int threads : {1, 2}) {
                set_thread_count(threads);
                wall[threads - 1].push_back(seconds([&] {
                    cpu[threads - 1].push_back(cpu_seconds([&] { lift.tip_z(points, heights, Progress()); }));
                }));
            }
        const double rate = double(points.size()) / bench::median(cpu[0]);
        std::vector<double> before(points.size());
        set_thread_count(1);
        const scalar::AxialLift scalar_lift(scalar_index, CutterProfile(apt));
        const double scalar_rate =
            double(points.size()) / cpu_seconds([&] { scalar_lift.tip_z(points, before, Progress()); });
        double worst = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (before[i] != heights[i]) worst = std::max(worst, std::abs(before[i] - heights[i]));
        const scalar::LowerSurface surface{CutterProfile(apt)};
        const std::size_t scanned = std::max<std::size_t>(2, 1'000'000 / mesh->facet_count());
        const auto compare = [&](std::size_t count, auto&& height_at) {
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t i = (2 * k + 1) * points.size() / (2 * count);
                const double other = height_at(points[i]);
                if (other != heights[i]) worst = std::max(worst, std::abs(other - heights[i]));
            }
        };
        const double scan_rate = double(scanned) / cpu_seconds([&] {
                                     compare(scanned, [&](const Vec2& p) { return scan(*mesh, surface, p); });
                                 });
        const test::BruteCutter brute(apt);
        compare(300'000'000 / (mesh->facet_count() + 1'000'000),
                [&](const Vec2& p) { return test::brute_lift(brute, *mesh, p.x(), p.y()); });
        std::printf("%-6s %14.0f %14.0f %8.2f %14.0f %8.1f %14.2f %10.0f %12.2e\n", name, rate,
                    double(points.size()) / bench::median(wall[1]),
                    bench::median(wall[0]) / bench::median(wall[1]), scalar_rate, rate / scalar_rate,
                    scan_rate, rate / scan_rate, worst);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t grid = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 500;
    std::vector<std::size_t> sizes;
    for (int i = 2; i < argc; ++i)
        sizes.push_back(std::strtoull(argv[i], nullptr, 10));
    if (sizes.empty()) sizes = {20'000, 1'000'000};
    if (grid < 2 || std::min_element(sizes.begin(), sizes.end())[0] < 2) {
        std::fprintf(stderr, "usage: bench_drop [GRID [FACETS ...]], each at least 2\n");
        return 2;
    }
    std::printf("kernel: %s\n", axial_kernels().name);
    for (const std::size_t facets : sizes)
        run(facets, grid);
    std::printf("\n* by processor time; so are the scalar search and the plain scan. 2 threads: by the "
                "clock, ratio of\n"
                "clock times, meaningful on an idle machine only. Medians of five runs each, by turns.\n");
}
