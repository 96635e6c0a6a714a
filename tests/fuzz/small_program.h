// A program of a few motions, for targets that post and read back.
#pragma once

#include "core/output/post/nc_reader.h"
#include "core/output/post/post_writer.h"
#include "tests/fuzz/fuzz.h"

namespace facetmill::fuzz {

inline const Machine& machine_for(bool tilted) {
    return find_machine(tilted ? "trunnion-ac" : "generic-3-axis");
}

inline const Vec3 part_origin(0, 0, 100);

inline NcSetup nc_setup(bool tilted) {
    NcSetup setup;
    setup.machine = machine_for(tilted);
    setup.part_origin = part_origin;
    setup.tip_tolerance = setup.axis_tolerance = 0.02;
    for (const long tool : {1, 2})
        setup.tools[tool] = {"Ball", AptCutter::ball(6, 30), 100};
    return setup;
}

inline ClProgram small_program(bool tilted, bool changes_tools) {
    ClProgram program;
    for (const long tool : {1, 2}) {
        if (tool > 1 && !changes_tools) break;
        auto section = std::make_shared<ClSection>();
        section->operation_name = "Finish";
        section->tool_number = tool;
        section->tool_name = "Ball";
        section->cutter = AptCutter::ball(6, 30);
        section->gauge_length = 100;
        section->multi_axis = tilted;
        constexpr int steps = 6;
        for (int i = 0; i <= steps; ++i) {
            const double t = double(i) / steps, lean = tilted ? 0.4 * t : 0;
            const Vec3 tip(10 * std::cos(t), 10 * std::sin(t), i == 0 || i == steps ? 20 : 1);
            section->motions.motions.push_back({i == 0 || i == steps ? MotionKind::rapid : MotionKind::cut,
                                                {tip, Vec3(std::sin(lean), 0, std::cos(lean))},
                                                no_index,
                                                no_index});
        }
        program.sections.push_back(std::move(section));
    }
    return program;
}

inline std::string posted(const Post& post, bool tilted) {
    PostSetup setup;
    setup.machine = machine_for(tilted);
    setup.part_origin = part_origin;
    setup.arcs = post.arcs != Post::Arcs::none;
    setup.keep_clear = {Vec3(-20, -20, -10), Vec3(20, 20, 2)};
    return post_program(small_program(tilted, post.changes_tools), post, setup, Progress()).text;
}

inline void check_program(const NcProgram& program) {
    if (program.sections.size() != program.lines.size() || program.sections.size() != program.joints.size())
        found("sections without lines or joints");
    for (std::size_t i = 0; i < program.sections.size(); ++i) {
        check_motions(program.sections[i]->motions.motions);
        if (program.lines[i].size() != program.sections[i]->motions.motions.size())
            found("motions without lines");
    }
    if (!(program.seconds >= 0)) found("a time that is no number");
}

} // namespace facetmill::fuzz
