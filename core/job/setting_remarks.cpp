#include "core/job/setting_remarks.h"

#include "core/setup/kinematics.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/tilt/axis_tilt.h"

namespace facetmill {

namespace {

class Remarks {
public:
    Remarks(const Project& project, const Operation& operation)
        : project_(project), operation_(operation), text_{project.unit} {}

    std::vector<SettingRemark> run() {
        if (const Tool* tool = find_tool(project_.tools, operation_.common().tool)) {
            lengths(*tool);
            further_tools(*tool);
            tilting(*tool);
        }
        machine();
        return std::move(remarks_);
    }

private:
    void add(const char* key, std::string message) { remarks_.push_back({key, std::move(message)}); }

    /// The number of a parameter that may also be a word; 0 where it is one, or there is none.
    double number(const char* key) const {
        if (!operation_.has(key)) return 0;
        const ParameterValue value = operation_.get(key);
        const auto* n = std::get_if<double>(&value);
        return n ? *n : 0;
    }

    void lengths(const Tool& tool) {
        if (number("stepover") > tool.diameter)
            add("stepover", "Wider than the tool, whose diameter is " + text_(tool.diameter)
                                + ": walls would stay between the passes");
        if (number("depth") > tool.flute_length)
            add("depth", "Longer than the tool's flutes, which are " + text_(tool.flute_length));
        if (number("depth_of_cut") > tool.flute_length)
            add("depth_of_cut", "Longer than the tool's flutes, which are " + text_(tool.flute_length));
        if (operation_.common().tolerance > 0.5 * tool.diameter)
            add("tolerance", "More than the tool's radius, which is " + text_(0.5 * tool.diameter));
    }

    void tilting(const Tool& tool) {
        if (operation_.purpose() == Purpose::cleaning || !(number("tilt_limit") > 0)) return;
        if (ball_radius(CutterProfile(tool.cutter())) == 0)
            add("tilt_limit", "The tool has no ball end, and only a ball cuts the same however it leans");
        else if (number("depth") > 0)
            add("tilt_limit", "A tool that cuts into the part is not inclined: the depth is above 0");
    }

    void further_tools(const Tool& tool) {
        for (const char* key : {"previous_tool", "rework_tool"}) {
            if (!operation_.has(key)) continue;
            const bool cleans = operation_.purpose() == Purpose::cleaning;
            const Tool* other = find_tool(project_.tools, std::get<long>(operation_.get(key)));
            if (!other) continue;
            if (other == &tool)
                add(key, cleans ? "The operation's own tool: it cannot clean up what it leaves itself"
                                : "The operation's own tool: it cannot rework what it leaves itself");
            else if (const auto& small = cleans ? tool : *other, &large = cleans ? *other : tool;
                     small.diameter >= large.diameter && small.corner_radius >= large.corner_radius)
                add(key, "No larger than the tool that is to come in after it: " + large.name + " and "
                             + small.name);
        }
    }

    void machine() {
        std::size_t rotary = 0;
        try {
            rotary = project_machine(project_).rotary.size();
        } catch (const Error&) {
            return; // that is told where the machine is chosen
        }
        if (operation_.turning() && rotary == 0)
            add("", "The machine has no rotary axis that turns the part: choose a lathe-mill.");
        else if (operation_.is_indexed())
            indexed();
        else if (!operation_.turning() && !operation_.keeps_axis() && rotary < 2)
            add("", "The operation inclines the tool in five axes; the machine has "
                        + std::string(rotary == 0 ? "no rotary axis" : "one rotary axis")
                        + ": choose one with two.");
    }

    void indexed() {
        const Vec3 axis = operation_.tool_axis();
        if (!Kinematics(project_machine(project_), 0, Vec3::Zero()).inverse({Vec3::Zero(), axis}, {}).count)
            add("tool_axis", "The machine cannot hold this axis: choose one whose rotary axes can");
    }

    const Project& project_;
    const Operation& operation_;
    PlanText text_;
    std::vector<SettingRemark> remarks_;
};

} // namespace

std::vector<SettingRemark> setting_remarks(const Project& project, std::size_t operation) {
    return Remarks(project, *project.operations.at(operation)).run();
}

} // namespace facetmill
