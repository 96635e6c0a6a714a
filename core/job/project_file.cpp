// The project file: reading with every key checked, and writing what reads back the same.
#include "core/base/file.h"
#include "core/base/parameter_json.h"
#include "core/base/text.h"
#include "core/job/project.h"
#include "core/job/project_migrate.h"

#include <algorithm>

namespace facetmill {

using namespace strict;

namespace {

LengthUnit read_unit(const Json& value, const std::string& place) {
    return parse_length_unit(read_text(value, place), place);
}

Tool read_tool(const Json& object, const std::string& place, LengthUnit unit) {
    Tool tool;
    ParameterView<Tool> view(tool, tool_parameters());
    read_parameters(object, place, view, unit);
    if (!object.contains("shank_diameter")) tool.shank_diameter = tool.diameter;
    return tool;
}

std::unique_ptr<Operation> read_operation(const Json& object, const std::string& place, LengthUnit unit) {
    expect_object(object, place);
    const std::string at = member(place, "kind");
    const std::string kind = read_text(require(object, place, "kind", "name the kind of operation"), at);
    std::unique_ptr<Operation> operation;
    try {
        operation = make_operation(kind);
    } catch (const Error& e) {
        throw Error(e.code(), at, e.message(), e.remedy());
    }
    read_parameters(object, place, *operation, unit, {"kind"});
    return operation;
}

void read_stock(const Json& object, StockSpec& stock, LengthUnit unit) {
    stock.unit = unit;
    ParameterView<StockSpec> view(stock, stock_parameters());
    read_parameters(object, "stock", view, unit);
    // What says nothing of this kind was meant for another one.
    const std::vector<std::string>& keys = stock_keys(stock.kind);
    for (auto it = object.begin(); it != object.end(); ++it) {
        if (std::find(keys.begin(), keys.end(), it.key()) != keys.end()) continue;
        std::string list;
        for (const auto& k : keys)
            list += (list.empty() ? "" : ", ") + k;
        throw Error(ErrorCode::unknown_key, member("stock", it.key()),
                    "a stock of kind '" + stock_kind_name(stock.kind) + "' has no such key",
                    "known keys: " + list);
    }
    if (stock.kind == StockSpec::Kind::mesh) require(object, "stock", "file", "name the stock's mesh file");
}

Project read_project(Json file) {
    if (!file.is_object()) wrong_type("", file, "an object with the key \"facetmill\"");
    migrate_project(file);
    std::vector<std::string> known = {"facetmill", "units", "part",       "stock",
                                      "machine",   "tools", "operations", "verification"};
    const std::size_t others = known.size();
    for (const ParameterInfo* info : program_parameters().infos())
        known.push_back(info->key);
    for (auto it = file.begin(); it != file.end(); ++it)
        if (std::find(known.begin(), known.end(), it.key()) == known.end()) unknown_key(it.key(), "", known);
    Project project;
    const LengthUnit unit = project.unit =
        read_unit(require(file, "", "units", "write \"mm\" or \"in\""), "units");

    const Json& part = require(file, "", "part", "name the part's file");
    project.part.unit = unit;
    ParameterView<PartSpec> part_view(project.part, part_parameters());
    read_parameters(part, "part", part_view, unit);
    project.stock.unit = unit;
    if (file.contains("stock")) read_stock(file["stock"], project.stock, unit);
    if (file.contains("verification")) {
        ParameterView<VerifyLimits> limits(project.limits, verify_limit_parameters());
        read_parameters(file["verification"], "verification", limits, unit);
    }
    ParameterView<ProgramSpec> programs(project.programs, program_parameters());
    known.resize(others);
    read_parameters(file, "", programs, unit, known);
    if (file.contains("machine")) project.machine = read_text(file["machine"], "machine");
    if (file.contains("tools")) {
        const Json& tools = expect_list(file["tools"], "tools");
        for (std::size_t i = 0; i < tools.size(); ++i)
            project.tools.push_back(read_tool(tools[i], element("tools", i), unit));
    }
    if (file.contains("operations")) {
        const Json& operations = expect_list(file["operations"], "operations");
        for (std::size_t i = 0; i < operations.size(); ++i)
            project.operations.push_back(read_operation(operations[i], element("operations", i), unit));
    }
    check_project(project);
    return project;
}

template <class Struct>
Json write_struct(const Struct& values, const ParameterTable<Struct>& table, const std::string& place,
                  LengthUnit unit) {
    Json object = Json::object();
    Struct copy = values; // a view can set, too
    write_parameters(object, place, ParameterView<Struct>(copy, table), unit);
    return object;
}

} // namespace

Project parse_project(std::string_view json, const std::string& name) {
    Json file = parse_strict_json(json, name);
    try {
        return read_project(std::move(file));
    } catch (const Error& e) {
        throw e.within(name);
    }
}

Project load_project(const std::filesystem::path& path) {
    const InputFile file(path);
    Project project = parse_project(file.bytes(), printable(path.string(), 400));
    project.path = path;
    return project;
}

std::string project_to_json(const Project& project) {
    const LengthUnit unit = project.unit;
    Json file = Json::object();
    file["facetmill"] = project_version;
    file["units"] = std::string(unit_name(unit));
    file["part"] = write_struct(project.part, part_parameters(), "part", unit);
    file["stock"] = Json::object();
    StockSpec stock = project.stock;
    const ParameterView<StockSpec> view(stock, stock_parameters());
    for (const std::string& key : stock_keys(stock.kind))
        write_parameter(file["stock"], "stock", view, view.parameter(key), unit);
    check_text(project.machine, "machine");
    file["machine"] = project.machine;
    ProgramSpec spec = project.programs;
    const ParameterView<ProgramSpec> programs(spec, program_parameters());
    ProgramSpec usual;
    const ParameterView<ProgramSpec> defaults(usual, program_parameters());
    for (const ParameterInfo* info : programs.parameters())
        if (programs.get(info->key) != defaults.get(info->key))
            write_parameter(file, "", programs, *info, unit);
    file["verification"] = write_struct(project.limits, verify_limit_parameters(), "verification", unit);
    file["tools"] = Json::array();
    for (std::size_t i = 0; i < project.tools.size(); ++i)
        file["tools"].push_back(write_struct(project.tools[i], tool_parameters(), element("tools", i), unit));
    file["operations"] = Json::array();
    for (std::size_t i = 0; i < project.operations.size(); ++i) {
        Json object = Json::object();
        object["kind"] = std::string(project.operations[i]->kind());
        write_parameters(object, element("operations", i), *project.operations[i], unit);
        file["operations"].push_back(std::move(object));
    }
    return pretty_json(file);
}

void save_project(const Project& project, const std::filesystem::path& path) {
    Project moved = project;
    move_project(moved, path);
    const std::string text = project_to_json(moved);
    keep_referenced(project, path);
    OutputFile file(path);
    file.write(text);
    file.commit();
}

} // namespace facetmill
