#include "core/strategy/tilt/thinner_tool.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace facetmill {

ToolLift thinner_tool(const ContactIndexPtr& contact, Tool tool, const ToolClearance& clearance,
                      double chord) {
    const double thinner = 2 * std::max(chord, tolerance::contact_distance);
    tool.shank_diameter = std::max(tool.shank_diameter - thinner, 0.5 * tool.shank_diameter);
    for (HolderSection& s : tool.holder)
        s.diameter = std::max(s.diameter - thinner, 0.5 * s.diameter);
    return {contact, tool, clearance};
}

} // namespace facetmill
