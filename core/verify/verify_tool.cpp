#include "core/verify/program.h"

namespace facetmill {

VerifyTool::VerifyTool(const Tool& tool) : cutter(tool.cutter()) {
    double z = cutter.height();
    const auto add = [&](ToolSection::Part part, double diameter, double length) {
        if (diameter > 0 && length > 0) sections.push_back({part, 0.5 * diameter, z, z + length});
        z += std::max(length, 0.0);
    };
    add(ToolSection::Part::shank, tool.shank_diameter, tool.shank_length);
    for (const HolderSection& s : tool.holder)
        add(ToolSection::Part::holder, s.diameter, s.length);
}

} // namespace facetmill
