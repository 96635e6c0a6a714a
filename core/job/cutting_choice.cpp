#include "core/job/cutting_choice.h"

#include "core/job/project.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Feeds that went through a file's unit, or through a form's digits, are the same again.
constexpr double same_share = 1e-6;

bool same(double a, double b) {
    return std::abs(a - b) <= same_share * std::max(std::abs(a), std::abs(b));
}

void set_if_said(Operation& operation, const char* key, double value) {
    if (!(value > 0) || !operation.has(key)) return;
    try {
        operation.set(key, value);
    } catch (const Error&) {
        // No operation may have it: what there is stays.
    }
}

bool runs_as_it_began(const Operation& operation) {
    const double feed = operation.common().feed;
    return (same(feed, starting_feed(LengthUnit::mm)) || same(feed, starting_feed(LengthUnit::inch)))
           && operation.get("spindle") == operation.parameter("spindle").default_value;
}

} // namespace

double cutting_feed(const Tool& tool, const CuttingData& data) {
    return data.feed > 0 ? data.feed : data.spindle * double(tool.flutes) * data.chip_load;
}

bool is_complete(const Tool& tool, const CuttingData& data) {
    return data.spindle > 0 && cutting_feed(tool, data) > 0;
}

const CuttingData* cutting_for(const Tool& tool, const std::string& material) {
    const auto found = std::find_if(tool.cutting.begin(), tool.cutting.end(), [&](const CuttingData& data) {
        return is_complete(tool, data) && (material.empty() || data.material == material);
    });
    return found != tool.cutting.end() ? &*found : nullptr;
}

void run_by(Operation& operation, const Tool& tool, const CuttingData& data) {
    set_if_said(operation, "spindle", data.spindle);
    set_if_said(operation, "feed", cutting_feed(tool, data));
    // Where nobody says how fast it plunges, it does so as by default, not as in the material before.
    operation.set("ramp_feed", operation.parameter("ramp_feed").default_value);
    set_if_said(operation, "ramp_feed", data.plunge_feed);
    if (operation.purpose() != Purpose::roughing) return;
    set_if_said(operation, operation.turning() ? "depth_of_cut" : "depth", data.depth);
    set_if_said(operation, "stepover", data.stepover);
}

const CuttingData* runs_by(const Operation& operation, const Tool& tool) {
    const auto found = std::find_if(tool.cutting.begin(), tool.cutting.end(), [&](const CuttingData& data) {
        return is_complete(tool, data) && same(operation.common().spindle, data.spindle)
               && same(operation.common().feed, cutting_feed(tool, data));
    });
    return found != tool.cutting.end() ? &*found : nullptr;
}

void change_tool(Operation& operation, const std::vector<Tool>& tools, long number) {
    const Tool* before = find_tool(tools, operation.common().tool);
    const CuttingData* ran_by = before ? runs_by(operation, *before) : nullptr;
    const bool follows = ran_by || runs_as_it_began(operation);
    operation.set("tool", number);
    const Tool* tool = find_tool(tools, number);
    if (!tool || !follows) return;
    if (const CuttingData* data = cutting_for(*tool, ran_by ? ran_by->material : std::string()))
        run_by(operation, *tool, *data);
}

} // namespace facetmill
