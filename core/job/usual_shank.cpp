#include "core/job/usual_shank.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

double usual_shank_length(const Tool& tool, double part_height, LengthUnit unit) {
    const double step = (unit == LengthUnit::inch ? 0.05 : 1) * mm_per(unit);
    const ParameterInfo& info = tool_parameters().find("shank_length")->info;
    return std::clamp(std::max(4 * tool.diameter, std::ceil(part_height / step - 1e-9) * step), info.minimum,
                      info.maximum);
}

void follow_part_height(Project& project, double before, double after) {
    for (Tool& tool : project.tools) {
        const double usual = usual_shank_length(tool, before, project.unit);
        if (std::abs(tool.shank_length - usual) <= tolerance::figure_rounding * usual)
            tool.shank_length = usual_shank_length(tool, after, project.unit);
    }
}

} // namespace facetmill
