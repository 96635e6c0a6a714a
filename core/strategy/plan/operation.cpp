#include "core/strategy/plan/operation.h"

namespace facetmill {

namespace {

std::vector<OperationKind>& registry() {
    static std::vector<OperationKind> kinds;
    return kinds;
}

} // namespace

OperationRegistration::OperationRegistration(std::string kind, std::string label,
                                             std::function<std::unique_ptr<Operation>()> make) {
    auto& kinds = registry();
    const auto place =
        std::lower_bound(kinds.begin(), kinds.end(), kind,
                         [](const OperationKind& k, const std::string& name) { return k.kind < name; });
    kinds.insert(place, {std::move(kind), std::move(label), std::move(make)});
}

const std::vector<OperationKind>& operation_kinds() {
    return registry();
}

std::unique_ptr<Operation> make_operation(std::string_view kind) {
    std::vector<std::string> names;
    for (const OperationKind& k : registry()) {
        if (k.kind == kind) return k.make();
        names.push_back(k.kind);
    }
    std::string known;
    for (const auto& name : names)
        known += (known.empty() ? "" : ", ") + name;
    const std::string nearest = nearest_name(std::string(kind), names);
    throw Error(ErrorCode::out_of_range, "kind",
                "unknown operation '" + printable(kind) + "'"
                    + (nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?"),
                "use one of: " + known);
}

Vec3 Operation::tool_axis() const {
    const auto& [x, y, z] = common().tool_axis;
    if (x == 0 && y == 0 && z > 0) return Vec3::UnitZ();
    return Vec3(x, y, z).normalized();
}

std::vector<std::string> Operation::curve_names() const {
    std::vector<std::string> names;
    for (const std::string& key : curve_keys())
        names.push_back(std::get<std::string>(get(key)));
    return names;
}

void Operation::rename_boundary(const std::string& from, const std::string& to) {
    for (std::string* name : {&common().boundary, &common().avoid})
        if (*name == from) *name = to;
    for (const std::string& key : curve_keys())
        if (std::get<std::string>(get(key)) == from) set(key, to);
}

bool Operation::is_indexed() const {
    return keeps_axis() && tool_axis() != Vec3::UnitZ();
}

LayerPreview Operation::preview_layers(const PlanContext&, const Progress&) const {
    throw Error(ErrorCode::internal, common().name, "the operation has no preview of layers", "report this");
}

void check_plannable(const PlanContext& context, const OperationCommon& settings) {
    if (!context.part || context.part->facets.empty())
        throw Error(ErrorCode::empty_result, settings.name, "the part has no facets", "choose another part");
    if (!(settings.tolerance > 0))
        throw Error(ErrorCode::out_of_range, "tolerance", "the tolerance is not above 0",
                    "enter a length above 0");
}

} // namespace facetmill
