#include "ui/operation_list.h"

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr const char* axis_key = "tool_axis";

bool has_axis(const Operation& operation) {
    const auto keys = operation.parameters();
    return std::any_of(keys.begin(), keys.end(),
                       [](const ParameterInfo* info) { return info->key == axis_key; });
}

} // namespace

bool has_tool_axis(const Document& document, std::size_t operation) {
    return operation < document.operation_count() && has_axis(document.operation(operation));
}

void set_tool_axis(Document& document, std::size_t operation, const Vec3& axis) {
    const std::array<double, 3> value{axis.x(), axis.y(), axis.z()};
    if (document.operation(operation).get(axis_key) == ParameterValue(value)) return;
    document.change(Document::tr("Tool axis by angles"),
                    [&](Project& p) { p.operations.at(operation)->set(axis_key, value); });
}

std::size_t share_tool_axis(Document& document, std::size_t operation) {
    const ParameterValue axis = document.operation(operation).get(axis_key);
    std::size_t others = 0;
    for (const auto& o : document.project().operations)
        others += has_axis(*o) && o->get(axis_key) != axis ? 1 : 0;
    if (others == 0) return 0;
    document.change(Document::tr("Same tool axis for all operations"), [&](Project& p) {
        for (auto& o : p.operations)
            if (has_axis(*o)) o->set(axis_key, axis);
    });
    return others;
}

} // namespace facetmill::ui
