#include "core/job/asked_operations.h"

#include <algorithm>

namespace facetmill {

std::vector<AskedOperation> asked_operations(const Project& project,
                                             const std::function<bool(std::size_t)>& wanted) {
    std::vector<AskedOperation> asked;
    for (std::size_t i = 0; i < project.operations.size(); ++i)
        if (const bool wants = wanted(i); !project.operations[i]->common().off)
            asked.push_back({project.operations[i].get(), wants});
    bool leaves = false, read = false;
    for (auto a = asked.rbegin(); a != asked.rend(); ++a) {
        a->leaves = leaves && a->operation->keeps_axis();
        a->read = read;
        leaves = leaves || (a->operation->links_read_stock() && a->needed());
        read = read || (a->operation->reads_left().any() && a->needed());
    }
    std::erase_if(asked, [](const AskedOperation& a) { return !a.needed(); });
    return asked;
}

std::string task_text(const std::string& operation, std::size_t i, std::size_t n) {
    return n == 1 ? operation : operation + " (" + std::to_string(i + 1) + " of " + std::to_string(n) + ")";
}

std::vector<long> tools_of(const Operation& operation) {
    std::vector<long> numbers = operation.further_tools();
    numbers.insert(numbers.begin(), operation.common().tool);
    return numbers;
}

std::vector<long> tools_of(const Setup& setup) {
    std::vector<long> numbers;
    for (const auto& o : setup.operations) {
        const std::vector<long> its = tools_of(*o);
        numbers.insert(numbers.end(), its.begin(), its.end());
    }
    return numbers;
}

std::vector<const ParameterInfo*> forget_places(Operation& operation) {
    std::vector<const ParameterInfo*> held;
    for (const ParameterInfo* info : operation.parameters())
        if (info->kind == ParameterKind::records && operation.get(info->key) != info->empty_list()) {
            operation.set(info->key, info->empty_list());
            held.push_back(info);
        }
    return held;
}

void refuse_operation(const std::string& name, const std::vector<std::string>& names) {
    const std::string near = nearest_name(name, names);
    throw Error(ErrorCode::missing_reference, "operations", "there is no operation '" + printable(name) + "'",
                near.empty() ? "check the name" : "did you mean '" + printable(near) + "'?");
}

void refuse_to_plan(const Setup& setup, const std::string& name) {
    if (setup.operations.empty())
        throw Error(ErrorCode::missing_key, "operations", "the project has no operations",
                    "add an operation");
    std::vector<std::string> names;
    for (const auto& o : setup.operations)
        names.push_back(o->common().name);
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
        refuse_operation(name, names);
    throw Error(
        ErrorCode::missing_reference, name.empty() ? "operations" : "operation '" + printable(name) + "'",
        name.empty() ? "all of them are switched off" : "it is switched off", "switch it on (off: false)");
}

} // namespace facetmill
