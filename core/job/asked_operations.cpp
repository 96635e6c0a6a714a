#include "core/job/asked_operations.h"

namespace facetmill {

std::vector<AskedOperation> asked_operations(const Project& project,
                                             const std::function<bool(std::size_t)>& wanted) {
    std::vector<AskedOperation> asked;
    for (std::size_t i = 0; i < project.operations.size(); ++i)
        asked.push_back({project.operations[i].get(), wanted(i)});
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

void refuse_operation(const std::string& name, const std::vector<std::string>& names) {
    const std::string near = nearest_name(name, names);
    throw Error(ErrorCode::missing_reference, "operations", "there is no operation '" + printable(name) + "'",
                near.empty() ? "check the name" : "did you mean '" + printable(near) + "'?");
}

} // namespace facetmill
