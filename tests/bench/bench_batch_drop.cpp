// Lifts a second of a cutter lowered at many points at once: the C++ side of tests/bench/batch_drop, which
// asks Python for the same.
//
//     bench_batch_drop SAMPLE DIAMETER SIDE ROUNDS      SIDE x SIDE points over the part; the best round
//     counts
#include "core/base/error.h"
#include "core/gouge/axial_lift.h"
#include "core/mesh/sample.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace facetmill;

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: bench_batch_drop SAMPLE DIAMETER SIDE ROUNDS\n");
        return 2;
    }
    try {
        const double diameter = std::atof(argv[2]);
        const int side = std::atoi(argv[3]), rounds = std::atoi(argv[4]);
        const MeshPtr part = make_sample(argv[1], default_sample_tolerance, {});
        const AxialLift lift(std::make_shared<const ContactIndex>(part, Progress()),
                             CutterProfile(AptCutter::ball(diameter, unlimited_height)));
        const Box3 box = part->box();
        std::vector<Vec2> points;
        for (int i = 0; i < side * side; ++i)
            points.emplace_back(box.lo.x() + (box.hi.x() - box.lo.x()) * (i % side) / (side - 1.0),
                                box.lo.y() + (box.hi.y() - box.lo.y()) * int(i / side) / (side - 1.0));
        double best = infinity;
        for (int r = 0; r < rounds; ++r) {
            std::vector<double> heights(points.size());
            const auto from = std::chrono::steady_clock::now();
            lift.tip_z(points, heights, {});
            best = std::min(best,
                            std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count());
        }
        std::printf("%.0f\n", double(points.size()) / best);
    } catch (const Error& e) {
        std::fprintf(stderr, "bench_batch_drop: %s\n", e.what());
        return 1;
    }
    return 0;
}
