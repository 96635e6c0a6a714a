// A plan with five axes over a part with a known answer: tools, machine, links, and the judgement of a
// verifier that shares no code with the planner.
#pragma once

#include "core/link/link.h"
#include "core/strategy/five_axis/finish5.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/support/path_numbers.h"

#include <memory>
#include <string>
#include <vector>

namespace facetmill::test {

inline Tool with_holder(Tool tool) {
    tool.flute_length = 15;
    tool.shank_length = 15;
    tool.holder = {{20, 20}};
    return tool;
}

inline Tool cutter(const std::string& name) {
    if (name == "flat") return with_holder(flat_tool(6));
    if (name == "bull") return with_holder(bull_tool(6, 1));
    if (name == "ball") return with_holder(ball_tool(6));
    Tool tapered = bull_tool(6, 1);
    tapered.taper_angle = radians(10);
    tapered = with_holder(tapered);
    tapered.flute_length = 6;
    tapered.shank_diameter = 6;
    return tapered;
}

inline PlanContext five_axis_context(const Mesh& mesh, const Tool& tool) {
    PlanContext c = context_of(mesh, tool);
    c.machine = find_machine("tarus-tpi-2000");
    c.stock_box.hi.z() += 2;
    return c;
}

inline ToolMotions linked(const StrategyResult& path, const PlanContext& context, const Finish5& op) {
    return link_five_axis(path, context,
                          {op.common().allowance, op.holder_clearance(), op.holder_clearance()},
                          default_link_options(path, context, op.common()), Progress());
}

/// Those of the path, and of its leads.
inline std::vector<double> numbers(const StrategyResult& path) {
    std::vector<double> all = path_numbers(path);
    const auto leads = path.as<LeadRange>();
    all.insert(all.end(), {leads->lead_min, leads->lead_max});
    return all;
}

inline Verification judged(const Mesh& part, const PlanContext& context, const ToolMotions& motions,
                           double tolerance, double chord) {
    VerifySettings s;
    s.resolution = 0.6;
    s.sample_spacing = 0.3;
    s.tolerance = tolerance;
    s.gouge_limit = chord;
    StockSolid stock;
    stock.box = context.stock_box;
    const VerifyProgram program{"F", VerifyTool(context.tool), std::make_shared<ToolMotions>(motions), {}};
    return verify(part, stock, {&program, 1}, s, Progress());
}

} // namespace facetmill::test
