#include "core/job/plan_remarks.h"

#include "core/link/shank_in_stock.h"

#include <algorithm>

namespace facetmill {

namespace {

/// A clean-up cuts what its previous tool could not; what nobody cut with that stays.
void look_for_previous_tool(OperationResult& result, const Project& project, const Operation& operation) {
    if (!operation.has("previous_tool") || project.stock.kind == StockSpec::Kind::rest) return;
    const long previous = std::get<long>(operation.get("previous_tool"));
    for (const Operation* o : operations_on(project)) {
        if (o->common().tool == previous) return;
        if (o->has("rework_tool") && std::get<long>(o->get("rework_tool")) == previous) return;
        if (o->common().name == operation.common().name) break;
    }
    result.motion_warnings.push_back("no operation before it cuts with tool " + std::to_string(previous)
                                     + ", its previous tool: what that would have cut stays");
}

/// Operations with an upright tool leave out what shank or holder would meet; others are told. Of a part that
/// turns only raw material is known, so that nothing may have been turned before.
void look_for_shank_in_stock(OperationResult& result, const Project& project, const Operation& operation,
                             const PlanContext& context, const Progress& progress) {
    if (operation.purpose() != Purpose::finishing || operation.linking() == Linking::upright) return;
    ShankInStock touched;
    if (const LatheCommon* lathe = operation.turning()) {
        const auto turns = [](const auto& o) { return o->turning() != nullptr; };
        const std::vector<const Operation*> on = operations_on(project);
        const auto first = std::find_if(on.begin(), on.end(), turns);
        if (first != on.end() && (*first)->common().name != operation.common().name) return;
        touched = shank_in_stock(result.program.motions, *lathe, context, progress);
    } else {
        touched = shank_in_stock(result.program.motions, context, progress);
    }
    if (std::string warning = shank_in_stock_warning(touched, context); !warning.empty())
        result.motion_warnings.push_back(std::move(warning));
}

} // namespace

void tell_what_stands(OperationResult& result, const Project& project, const Operation& operation,
                      const PlanContext& context, const Progress& progress) {
    look_for_shank_in_stock(result, project, operation, context, progress);
    look_for_previous_tool(result, project, operation);
}

} // namespace facetmill
