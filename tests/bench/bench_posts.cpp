// A million blocks for a control, written and read back: of three axes, and of five on a trunnion. Seconds of
// the processor.
#include "tests/unit/output/posted_parts.h"

#include <cstdio>
#include <ctime>

using namespace facetmill;
using namespace facetmill::test;

namespace {

template <class Work>
double seconds_of(Work&& work) {
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

ClSection long_section(bool leans) {
    ClSection section = plain_section("Long", 1, leans);
    section.motions.clearance_z = 12;
    const auto axis = [&](int i) {
        return leans ? Vec3(0.2 + 0.1 * std::sin(1e-4 * i), 0.2 * std::cos(1.3e-4 * i), 1) : Vec3(0, 0, 1);
    };
    add_motion(section, MotionKind::rapid, Vec3(0, 0, 12), axis(0));
    for (int i = 0; i < 1'000'000; ++i)
        add_motion(section, MotionKind::cut,
                   Vec3(0.05 * (i % 1000), 0.1 * (i / 1000), 3 * std::sin(0.0123 * i)), axis(i));
    return section;
}

void table(bool leans) {
    const ClProgram program = joined_program({long_section(leans)});
    const PostSetup setup = setup_for(program, leans ? "trunnion-ac" : "generic-3-axis");
    std::printf("%-18s %10s %10s %10s\n", leans ? "five axes" : "three axes", "blocks", "written, s",
                "read, s");
    for (const Post& post : posts()) {
        if (leans && post.multi_axis == Post::MultiAxis::none) continue;
        PostedProgram posted;
        NcProgram read;
        const double writing = seconds_of([&] { posted = post_program(program, post, setup, {}); });
        const double reading_back =
            seconds_of([&] { read = read_nc(posted.text, "p", post, reading(program, setup), {}); });
        std::printf("%-18s %10zu %10.2f %10.2f\n", post.name.c_str(), posted.blocks, writing, reading_back);
        std::fflush(stdout);
    }
}

} // namespace

int main() {
    table(false);
    table(true);
}
