// The project file: reading with every key checked, and writing what reads back the same.
#include "core/base/archive.h"
#include "core/base/file.h"
#include "core/base/parameter_json.h"
#include "core/base/text.h"
#include "core/job/packed_project.h"
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

/// What says nothing of this kind was meant for another one.
void check_kind_keys(const Json& object, const std::string& place, const std::string& what,
                     const std::string& kind, const std::vector<std::string>& keys) {
    for (auto it = object.begin(); it != object.end(); ++it) {
        if (std::find(keys.begin(), keys.end(), it.key()) != keys.end()) continue;
        std::string list;
        for (const auto& k : keys)
            list += (list.empty() ? "" : ", ") + k;
        throw Error(ErrorCode::unknown_key, member(place, it.key()),
                    "a " + what + " of kind '" + kind + "' has no such key", "known keys: " + list);
    }
}

Fixture read_fixture(const Json& object, const std::string& place, LengthUnit unit) {
    Fixture fixture;
    fixture.unit = unit;
    ParameterView<Fixture> view(fixture, fixture_parameters());
    read_parameters(object, place, view, unit);
    check_kind_keys(object, place, "fixture", fixture_kind_name(fixture.kind), fixture_keys(fixture.kind));
    if (fixture.kind == Fixture::Kind::mesh) require(object, place, "file", "name the fixture's mesh file");
    return fixture;
}

Boundary read_boundary(const Json& object, const std::string& place, LengthUnit unit) {
    Boundary boundary;
    ParameterView<Boundary> view(boundary, boundary_parameters());
    read_parameters(object, place, view, unit);
    check_kind_keys(object, place, "boundary", boundary_kind_name(boundary.kind),
                    boundary_keys(boundary.kind));
    return boundary;
}

void read_stock(const Json& object, const std::string& place, StockSpec& stock, LengthUnit unit) {
    stock.unit = unit;
    ParameterView<StockSpec> view(stock, stock_parameters());
    read_parameters(object, place, view, unit);
    check_kind_keys(object, place, "stock", stock_kind_name(stock.kind), stock_keys(stock.kind));
    if (stock.kind == StockSpec::Kind::mesh) require(object, place, "file", "name the stock's mesh file");
}

/// Members of a setup, which in a file of version 1 are those of the file.
const std::vector<std::string> setup_members = {"stock", "fixtures", "boundaries", "machine", "operations"};

/// `own`: keys of `object` that say something else. Machine and programs stay as they are where it says
/// nothing of them.
void read_setup(const Json& object, const std::string& place, std::vector<std::string> own, Setup& setup,
                LengthUnit unit) {
    const auto at = [&](const char* key) { return member(place, key); };
    setup.stock.unit = unit;
    if (object.contains("stock")) read_stock(object["stock"], at("stock"), setup.stock, unit);
    if (object.contains("fixtures")) {
        const Json& fixtures = expect_list(object["fixtures"], at("fixtures"));
        for (std::size_t i = 0; i < fixtures.size(); ++i)
            setup.fixtures.push_back(read_fixture(fixtures[i], element(at("fixtures"), i), unit));
    }
    if (object.contains("boundaries")) {
        const Json& boundaries = expect_list(object["boundaries"], at("boundaries"));
        for (std::size_t i = 0; i < boundaries.size(); ++i)
            setup.boundaries.push_back(read_boundary(boundaries[i], element(at("boundaries"), i), unit));
    }
    ParameterView<ProgramSpec> programs(setup.programs, program_parameters());
    own.insert(own.end(), setup_members.begin(), setup_members.end());
    read_parameters(object, place, programs, unit, own);
    if (object.contains("machine")) setup.machine = read_text(object["machine"], at("machine"));
    if (!object.contains("operations")) return;
    const Json& operations = expect_list(object["operations"], at("operations"));
    for (std::size_t i = 0; i < operations.size(); ++i)
        setup.operations.push_back(read_operation(operations[i], element(at("operations"), i), unit));
}

/// The setups of a file of version 2. What it says of machine and programs itself holds for those that say
/// nothing of them.
void read_setups(const Json& file, const std::vector<std::string>& shared, Project& project) {
    std::vector<std::string> known = shared;
    known.insert(known.end(), {"setups", "machine"});
    Setup usual;
    ParameterView<ProgramSpec> programs(usual.programs, program_parameters());
    read_parameters(file, "", programs, project.unit, known);
    if (file.contains("machine")) usual.machine = read_text(file["machine"], "machine");
    const Json& setups = expect_list(require(file, "", "setups", "list at least one setup"), "setups");
    if (setups.empty())
        throw Error(ErrorCode::missing_key, "setups", "the project has no setup", "list at least one setup");
    for (std::size_t i = 0; i < setups.size(); ++i) {
        const std::string place = element("setups", i);
        expect_object(setups[i], place);
        Setup setup = usual;
        setup.name = usual_setup_name(i);
        if (i > 0) setup.stock.kind = StockSpec::Kind::rest;
        if (setups[i].contains("name")) setup.name = read_text(setups[i]["name"], member(place, "name"));
        if (setups[i].contains("place")) {
            ParameterView<SetupPlace> held(setup.place, place_parameters());
            read_parameters(setups[i]["place"], member(place, "place"), held, project.unit);
        }
        if (setups[i].contains("stock")) setup.stock = {};
        read_setup(setups[i], place, {"name", "place"}, setup, project.unit);
        if (i == 0)
            static_cast<Setup&>(project) = std::move(setup);
        else
            project.after.push_back(std::move(setup));
    }
}

Project read_project(Json file) {
    if (!file.is_object()) wrong_type("", file, "an object with the key \"facetmill\"");
    const bool several = migrate_project(file) > single_setup_version;
    const std::vector<std::string> shared = {"facetmill", "units", "part", "tools", "verification"};
    std::vector<std::string> known = shared;
    if (several)
        known.insert(known.end(), {"setups", "machine"});
    else
        known.insert(known.end(), setup_members.begin(), setup_members.end());
    for (const std::string key : {"stock", "fixtures", "boundaries", "operations"})
        if (several && file.contains(key))
            throw Error(ErrorCode::unknown_key, key, "in a file of version 2 every setup has its own",
                        "put it into one of \"setups\"");
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
    if (file.contains("verification")) {
        ParameterView<VerifyLimits> limits(project.limits, verify_limit_parameters());
        read_parameters(file["verification"], "verification", limits, unit);
    }
    if (file.contains("tools")) {
        const Json& tools = expect_list(file["tools"], "tools");
        for (std::size_t i = 0; i < tools.size(); ++i)
            project.tools.push_back(read_tool(tools[i], element("tools", i), unit));
    }
    if (several)
        read_setups(file, shared, project);
    else
        read_setup(file, "", shared, project, unit);
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
    if (is_archive(file.bytes())) return load_packed(file);
    Project project = parse_project(file.bytes(), printable(path.string(), 400));
    project.path = path;
    return project;
}

namespace {

/// A list of things of several kinds, each with the keys of its kind.
template <class Struct, class KeysOf>
Json write_kinds(std::vector<Struct> things, const ParameterTable<Struct>& table, const KeysOf& keys_of,
                 const std::string& place, LengthUnit unit) {
    Json list = Json::array();
    for (Struct& thing : things) {
        const ParameterView<Struct> view(thing, table);
        Json object = Json::object();
        for (const std::string& key : keys_of(thing.kind))
            write_parameter(object, element(place, list.size()), view, view.parameter(key), unit);
        list.push_back(std::move(object));
    }
    return list;
}

void write_machining(Json& to, const Setup& setup, const std::string& place, LengthUnit unit) {
    const auto at = [&](const char* key) { return member(place, key); };
    to["stock"] = Json::object();
    StockSpec stock = setup.stock;
    const ParameterView<StockSpec> view(stock, stock_parameters());
    for (const std::string& key : stock_keys(stock.kind))
        write_parameter(to["stock"], at("stock"), view, view.parameter(key), unit);
    if (!setup.fixtures.empty())
        to["fixtures"] =
            write_kinds(setup.fixtures, fixture_parameters(), fixture_keys, at("fixtures"), unit);
    if (!setup.boundaries.empty())
        to["boundaries"] =
            write_kinds(setup.boundaries, boundary_parameters(), boundary_keys, at("boundaries"), unit);
    check_text(setup.machine, at("machine"));
    to["machine"] = setup.machine;
    ProgramSpec spec = setup.programs;
    const ParameterView<ProgramSpec> programs(spec, program_parameters());
    ProgramSpec usual;
    const ParameterView<ProgramSpec> defaults(usual, program_parameters());
    for (const ParameterInfo* info : programs.parameters())
        if (programs.get(info->key) != defaults.get(info->key))
            write_parameter(to, place, programs, *info, unit);
}

void write_operations(Json& to, const Setup& setup, const std::string& place, LengthUnit unit) {
    to["operations"] = Json::array();
    for (std::size_t i = 0; i < setup.operations.size(); ++i) {
        Json object = Json::object();
        object["kind"] = std::string(setup.operations[i]->kind());
        write_parameters(object, element(member(place, "operations"), i), *setup.operations[i], unit);
        to["operations"].push_back(std::move(object));
    }
}

/// What a file of version 1 has no words for.
bool needs_setups(const Project& project) {
    return setup_count(project) > 1 || project.name != usual_setup_name(0) || project.place != SetupPlace()
           || !project.fixtures.empty() || !project.boundaries.empty();
}

} // namespace

std::string project_to_json(const Project& project) {
    const LengthUnit unit = project.unit;
    const bool several = needs_setups(project);
    Json file = Json::object();
    file["facetmill"] = several ? project_version : single_setup_version;
    file["units"] = std::string(unit_name(unit));
    file["part"] = write_struct(project.part, part_parameters(), "part", unit);
    if (!several) write_machining(file, project, "", unit);
    file["verification"] = write_struct(project.limits, verify_limit_parameters(), "verification", unit);
    file["tools"] = Json::array();
    for (std::size_t i = 0; i < project.tools.size(); ++i)
        file["tools"].push_back(write_struct(project.tools[i], tool_parameters(), element("tools", i), unit));
    if (!several) {
        write_operations(file, project, "", unit);
        return pretty_json(file);
    }
    file["setups"] = Json::array();
    for (std::size_t i = 0; i < setup_count(project); ++i) {
        const Setup& setup = setup_at(project, i);
        const std::string place = element("setups", i);
        Json object = Json::object();
        check_text(setup.name, member(place, "name"));
        object["name"] = setup.name;
        object["place"] = write_struct(setup.place, place_parameters(), member(place, "place"), unit);
        write_machining(object, setup, place, unit);
        write_operations(object, setup, place, unit);
        file["setups"].push_back(std::move(object));
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
