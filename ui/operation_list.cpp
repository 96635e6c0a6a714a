#include "ui/operation_list.h"

#include "core/job/copied_operations.h"
#include "ui/operation_menu.h"
#include "ui/text.h"
#include "ui/worded.h"

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

std::string first_name_of(const std::string& kind) {
    const std::string label = utf8(operation_label(kind));
    return label.substr(0, label.find_first_of(",("));
}

void name_operations(Project& project) {
    for (auto& operation : project.operations)
        operation->common().name.clear();
    for (auto& operation : project.operations)
        operation->common().name =
            free_operation_name(project, first_name_of(std::string(operation->kind())));
}

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

void duplicate_operation(Document& document, std::size_t operation) {
    std::vector<std::unique_ptr<Operation>> one;
    one.push_back(document.operation(operation).clone());
    one.front()->common().name = document.free_operation_name(one.front()->common().name);
    document.add_operations(Document::tr("Duplicate operation"), operation + 1, std::move(one), {});
}

void move_operation(Document& document, std::size_t operation, int by) {
    const auto to = std::ptrdiff_t(operation) + by;
    if (to < 0 || to >= std::ptrdiff_t(document.operation_count())) return;
    place_operation(document, operation, chosen_setup(document.project()),
                    std::size_t(to) + (by > 0 ? 1 : 0));
}

void switch_operation(Document& document, std::size_t operation, bool off) {
    if (document.is_off(operation) == off) return;
    document.change(off ? Document::tr("Switch off operation") : Document::tr("Switch on operation"),
                    [&](Project& p) { p.operations.at(operation)->common().off = off; });
}

bool place_operation(Document& document, std::size_t operation, std::size_t setup, std::size_t at) {
    const std::size_t from = chosen_setup(document.project());
    if (setup == from && (at == operation || at == operation + 1)) return false;
    document.change_setups(Document::tr("Move operation"), from, [&](auto& setups, auto& ids) {
        auto moved = std::move(setups.at(from).operations.at(operation));
        const int id = ids[from][operation];
        const auto erase = [operation](auto& list) { list.erase(list.begin() + std::ptrdiff_t(operation)); };
        erase(setups[from].operations);
        erase(ids[from]);
        if (setup == from && at > operation) --at;
        auto& there = setups.at(setup).operations;
        const auto place = std::ptrdiff_t(std::min(at, there.size()));
        there.insert(there.begin() + place, std::move(moved));
        ids[setup].insert(ids[setup].begin() + place, id);
    });
    return true;
}

Pasted paste_operations(Document& document, std::string_view copied, std::optional<std::size_t> after) {
    PastedOperations pasted = pasted_operations(copied, document.project());
    Pasted result;
    for (const std::string& remark : pasted.remarks)
        result.remarks << sentence(worded(remark)) + QChar('.');
    result.place = after ? std::min(*after + 1, document.operation_count()) : document.operation_count();
    document.add_operations(Document::tr("Paste operation"), result.place, std::move(pasted.operations),
                            pasted.tools);
    return result;
}

} // namespace facetmill::ui
