// A million blocks for a control, written and read back.
#include "tests/unit/output/posted_parts.h"

#include <chrono>
#include <cstdio>

using namespace facetmill;
using namespace facetmill::test;

namespace {

template <class Work>
double seconds_of(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

int main() {
    ClSection section = plain_section("Long", 1, false);
    section.motions.clearance_z = 12;
    add_motion(section, MotionKind::rapid, Vec3(0, 0, 12));
    for (int i = 0; i < 1'000'000; ++i)
        add_motion(section, MotionKind::cut,
                   Vec3(0.05 * (i % 1000), 0.1 * (i / 1000), 3 * std::sin(0.0123 * i)));
    const ClProgram program = joined_program({section});
    const PostSetup setup = setup_for(program, "generic-3-axis");
    std::printf("%-16s %10s %10s %10s\n", "post", "blocks", "written, s", "read, s");
    for (const Post& post : posts()) {
        PostedProgram posted;
        NcProgram read;
        const double writing = seconds_of([&] { posted = post_program(program, post, setup, {}); });
        const double reading_back =
            seconds_of([&] { read = read_nc(posted.text, "p", post, reading(program, setup), {}); });
        std::printf("%-16s %10zu %10.2f %10.2f\n", post.name.c_str(), posted.blocks, writing, reading_back);
    }
}
