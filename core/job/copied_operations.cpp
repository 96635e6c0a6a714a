#include "core/job/copied_operations.h"

#include "core/base/text.h"
#include "core/job/asked_operations.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

std::string whole_path(const std::filesystem::path& path) {
    std::error_code failed;
    const auto whole = std::filesystem::absolute(path, failed);
    return (failed ? path : whole.lexically_normal()).string();
}

/// But for the number, and for what a length loses on its way through another unit.
bool is_same_tool(const Tool& a, const Tool& b) {
    const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-9 * std::max(1.0, std::abs(x)); };
    for (double Tool::*value :
         {&Tool::diameter, &Tool::corner_radius, &Tool::bottom_angle, &Tool::taper_angle, &Tool::flute_length,
          &Tool::shank_diameter, &Tool::shank_length})
        if (!near(a.*value, b.*value)) return false;
    return a.name == b.name
           && std::equal(a.holder.begin(), a.holder.end(), b.holder.begin(), b.holder.end(),
                         [&](const HolderSection& s, const HolderSection& t) {
                             return near(s.diameter, t.diameter) && near(s.length, t.length);
                         });
}

class Pasting {
public:
    Pasting(const Project& from, const Project& to) : from_(from), to_(to), tools_(to.tools) {
        same_part_ = whole_path(from.part_path()) == whole_path(to.part_path());
        for (const auto& o : all_operations(to))
            names_.push_back(o->common().name);
    }

    PastedOperations run() {
        for (const auto& o : from_.operations)
            add(*o);
        return std::move(pasted_);
    }

private:
    void add(const Operation& copied) {
        auto operation = copied.clone();
        OperationCommon& common = operation->common();
        common.name = free_name(common.name, [&](const std::string& name) {
            return std::find(names_.begin(), names_.end(), name) != names_.end();
        });
        names_.push_back(common.name);
        take_tools(*operation);
        for (std::string OperationCommon::*where : {&OperationCommon::boundary, &OperationCommon::avoid})
            take_boundary(common.name, common.*where);
        take_curves(*operation);
        if (!same_part_) leave_places(*operation);
        pasted_.operations.push_back(std::move(operation));
    }

    /// In two steps, as a new number may be an old one of another tool.
    void take_tools(Operation& operation) {
        constexpr long aside = largest_tool_number + 1;
        std::vector<long> numbers = tools_of(operation);
        std::sort(numbers.begin(), numbers.end());
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
        for (const long number : numbers)
            operation.renumber_tool(number, aside + number);
        for (const long number : numbers)
            operation.renumber_tool(aside + number, number_there(number));
    }

    long number_there(long number) {
        const Tool* own = find_tool(from_.tools, number);
        if (!own) return number; // a tool that is named and asked for nothing
        for (const Tool& t : tools_)
            if (is_same_tool(*own, t)) return t.number;
        Tool tool = *own;
        if (find_tool(tools_, number)) tool.number = free_tool_number(tools_);
        tools_.push_back(tool);
        pasted_.tools.push_back(tool);
        return tool.number;
    }

    void take_boundary(const std::string& operation, std::string& name) {
        if (name.empty()) return;
        const auto& there = to_.boundaries;
        if (std::any_of(there.begin(), there.end(), [&](const Boundary& b) { return b.name == name; }))
            return;
        pasted_.remarks.push_back("'" + printable(operation) + "' was bounded by '" + printable(name)
                                  + "', which this setup does not have: it cuts everywhere now");
        name.clear();
    }

    void take_curves(Operation& operation) {
        const auto& there = to_.boundaries;
        for (const std::string& name : operation.curve_names()) {
            if (name.empty()
                || std::any_of(there.begin(), there.end(), [&](const Boundary& b) { return b.name == name; }))
                continue;
            pasted_.remarks.push_back("'" + printable(operation.common().name) + "' followed '"
                                      + printable(name)
                                      + "', which this setup does not have: it follows the outline now");
            for (const std::string& key : operation.curve_keys())
                operation.set(key, std::string());
            return;
        }
    }

    void leave_places(Operation& operation) {
        for (const ParameterInfo* info : forget_places(operation))
            pasted_.remarks.push_back("'" + printable(operation.common().name) + "': '" + info->label
                                      + "' belongs to places of another part and was left behind");
    }

    const Project &from_, &to_;
    std::vector<Tool> tools_;
    std::vector<std::string> names_;
    bool same_part_ = false;
    PastedOperations pasted_;
};

} // namespace

std::string copied_operation(const Project& project, std::size_t operation) {
    Project alone;
    alone.unit = project.unit;
    alone.part.file = whole_path(project.part_path());
    alone.part.unit = project.unit;
    alone.machine = is_machine_file(project.machine) ? whole_path(project.machine_path()) : project.machine;
    alone.operations.push_back(project.operations.at(operation)->clone());
    const std::vector<long> numbers = tools_of(*alone.operations.front());
    for (const Tool& t : project.tools)
        if (std::find(numbers.begin(), numbers.end(), t.number) != numbers.end()) alone.tools.push_back(t);
    const OperationCommon& common = alone.operations.front()->common();
    const std::vector<std::string> curves = alone.operations.front()->curve_names();
    for (const Boundary& b : project.boundaries)
        if (b.name == common.boundary || b.name == common.avoid
            || std::find(curves.begin(), curves.end(), b.name) != curves.end())
            alone.boundaries.push_back(b);
    return project_to_json(alone);
}

bool may_be_operations(std::string_view text) {
    return text.find("\"facetmill\"") != std::string_view::npos
           && text.find("\"operations\"") != std::string_view::npos;
}

PastedOperations pasted_operations(std::string_view text, const Project& project) {
    return pasted_operations(parse_project(text, "clipboard"), project);
}

PastedOperations pasted_operations(const Project& from, const Project& project) {
    return Pasting(from, project).run();
}

} // namespace facetmill
