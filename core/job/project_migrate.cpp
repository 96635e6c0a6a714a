#include "core/job/project_migrate.h"

#include "core/job/project.h"

#include <array>

namespace facetmill {

namespace {

/// Renames a member and keeps its place. Where both names stand, the old one stays and is refused as unknown
/// later.
void rename_key(Json& object, const std::string& from, const std::string& to) {
    if (!object.is_object() || !object.contains(from) || object.contains(to)) return;
    Json renamed = Json::object();
    for (auto it = object.begin(); it != object.end(); ++it)
        renamed[it.key() == from ? to : it.key()] = std::move(*it);
    object = std::move(renamed);
}

template <class Change>
void for_each_member(Json& file, const char* list, Change&& change) {
    if (!file.contains(list) || !file[list].is_array()) return;
    for (Json& member : file[list])
        change(member);
}

/// Version 0, the drafts before the first release: `unit` for `units`, `type` for an operation's `kind`,
/// `step` for its `stepover`, `radius` for a tool's `corner_radius`.
void from_0(Json& file) {
    rename_key(file, "unit", "units");
    if (file.contains("part")) rename_key(file["part"], "unit", "units");
    for_each_member(file, "tools", [](Json& tool) { rename_key(tool, "radius", "corner_radius"); });
    for_each_member(file, "operations", [](Json& operation) {
        rename_key(operation, "type", "kind");
        rename_key(operation, "step", "stepover");
    });
}

/// steps[v] makes version v + 1 of version v. A file of one setup stays one: it is read as it is, so that
/// messages name the places that it has.
constexpr std::array<void (*)(Json&), std::size_t(single_setup_version)> steps = {from_0};

} // namespace

long migrate_project(Json& file) {
    const std::string key = "facetmill";
    if (!file.contains(key))
        throw Error(ErrorCode::missing_key, key, "the version of the project file is missing",
                    "add \"facetmill\": " + std::to_string(single_setup_version)
                        + "; is this a project file?");
    const Json& version = file[key];
    if (!version.is_number_integer())
        throw Error(ErrorCode::wrong_type, key, "the version is not a whole number",
                    "write " + std::to_string(single_setup_version));
    const auto read = version.is_number_unsigned()
                          ? long(std::min<std::uint64_t>(version.get<std::uint64_t>(), 1000000))
                          : version.get<long>();
    if (read < 0)
        throw Error(ErrorCode::out_of_range, key, "the version is negative",
                    "write " + std::to_string(single_setup_version));
    if (read > project_version)
        throw Error(ErrorCode::newer_version, key,
                    "the file has version " + std::to_string(read) + ", this program reads up to "
                        + std::to_string(project_version),
                    "use a newer Facetmill");
    for (long v = read; v < single_setup_version; ++v)
        steps[std::size_t(v)](file);
    const long reached = std::max(read, single_setup_version);
    file[key] = reached;
    return reached;
}

} // namespace facetmill
