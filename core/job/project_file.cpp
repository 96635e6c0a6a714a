// The project file: reading with every key checked, and writing what reads back the same.
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/base/tolerances.h"
#include "core/job/project.h"
#include "core/job/project_migrate.h"
#include "core/strategy/five_axis/manual_posture.h"
#include "core/strategy/surface/region_edit.h"

#include <algorithm>

namespace facetmill {

using namespace strict;

namespace {

LengthUnit read_unit(const Json& value, const std::string& place) {
    return parse_length_unit(read_text(value, place), place);
}

/// In core units. A limit that is not a round number in the file's unit was rounded when it was written: what
/// is beyond the limit by no more than that is the limit.
double read_number(const Json& value, const ParameterInfo& info, LengthUnit unit) {
    const double v = value.get<double>() * info.scale(unit);
    for (double limit : {info.minimum, info.maximum})
        if (std::abs(v - limit) <= tolerance::written_number * std::abs(limit)) return limit;
    return v;
}

template <std::size_t N>
std::array<double, N> read_numbers(const Json& value, const ParameterInfo& info, const std::string& place,
                                   LengthUnit unit) {
    const std::string expected = "a list of " + std::to_string(N) + " numbers";
    if (!value.is_array()) wrong_type(place, value, expected);
    if (value.size() != N)
        throw Error(ErrorCode::wrong_type, place, "the list has " + std::to_string(value.size()) + " values",
                    "expected " + expected);
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) {
        if (!value[i].is_number()) wrong_type(element(place, i), value[i], "a number");
        numbers[i] = read_number(value[i], info, unit);
    }
    return numbers;
}

ParameterValue read_value(const Json& value, const ParameterInfo& info, const std::string& place,
                          LengthUnit unit) {
    switch (info.kind) {
    case ParameterKind::number:
        if (!value.is_number()) wrong_type(place, value, "a number");
        return read_number(value, info, unit);
    case ParameterKind::number_or_word:
        if (value.is_number()) return read_number(value, info, unit);
        if (!value.is_string()) wrong_type(place, value, "a number or a word");
        return read_text(value, place);
    case ParameterKind::integer: {
        if (!value.is_number()) wrong_type(place, value, "a whole number");
        const double d = value.get<double>();
        if (d != std::floor(d) || std::abs(d) > 9e15)
            throw Error(ErrorCode::wrong_type, place, "the value is not a whole number",
                        "expected a whole number");
        return long(d);
    }
    case ParameterKind::boolean:
        if (!value.is_boolean()) wrong_type(place, value, "true or false");
        return value.get<bool>();
    case ParameterKind::choice:
    case ParameterKind::text:
        return read_text(value, place);
    case ParameterKind::pair:
        return read_numbers<2>(value, info, place, unit);
    case ParameterKind::triple:
        return read_numbers<3>(value, info, place, unit);
    }
    throw Error(ErrorCode::internal, place, "unknown kind of parameter", "report this");
}

/// Reads every member of `object` that is not in `own` into the parameter of its name.
void read_parameters(const Json& object, const std::string& place, Parameterized& target, LengthUnit unit,
                     const std::vector<std::string>& own) {
    expect_object(object, place);
    const auto parameters = target.parameters();
    for (auto it = object.begin(); it != object.end(); ++it) {
        const std::string& key = it.key();
        const auto found = std::find_if(parameters.begin(), parameters.end(),
                                        [&](const ParameterInfo* p) { return p->key == key; });
        if (std::find(own.begin(), own.end(), key) != own.end()) continue;
        if (found == parameters.end()) {
            std::vector<std::string> known = own;
            for (const auto* p : parameters)
                known.push_back(p->key);
            unknown_key(key, place, known);
        }
        const std::string at = member(place, key);
        const ParameterValue value = read_value(*it, **found, at, unit);
        try {
            (*found)->check(value, unit);
            target.set(key, value);
        } catch (const Error& e) {
            throw Error(e.code(), at, e.message(), e.remedy());
        }
    }
}

Tool read_tool(const Json& object, const std::string& place, LengthUnit unit) {
    expect_object(object, place);
    Tool tool;
    ParameterView<Tool> view(tool, tool_parameters());
    require(object, place, "number", "give the tool a number");
    require(object, place, "diameter", "give the tool's diameter");
    read_parameters(object, place, view, unit, {"holder"});
    if (!object.contains("shank_diameter")) tool.shank_diameter = tool.diameter;
    if (object.contains("holder")) {
        const std::string at = member(place, "holder");
        const Json& sections = expect_list(object["holder"], at);
        for (std::size_t i = 0; i < sections.size(); ++i) {
            HolderSection section;
            ParameterView<HolderSection> section_view(section, holder_parameters());
            expect_object(sections[i], element(at, i));
            require(sections[i], element(at, i), "diameter", "give the section's diameter");
            require(sections[i], element(at, i), "length", "give the section's length");
            read_parameters(sections[i], element(at, i), section_view, unit, {});
            tool.holder.push_back(section);
        }
    }
    return tool;
}

/// A list of small structs beside an operation's parameters; of each the keys `required` must be there. Empty
/// where the operation has no such list.
template <class Struct>
std::vector<Struct> read_structs(const Json& operation, const std::string& place, const std::string& key,
                                 const ParameterTable<Struct>& table,
                                 const std::vector<std::array<const char*, 2>>& required, LengthUnit unit) {
    std::vector<Struct> all;
    if (!operation.contains(key)) return all;
    const std::string at = member(place, key);
    const Json& list = expect_list(operation[key], at);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string here = element(at, i);
        expect_object(list[i], here);
        for (const auto& [name, remedy] : required)
            require(list[i], here, name, remedy);
        Struct one;
        ParameterView<Struct> view(one, table);
        read_parameters(list[i], here, view, unit, {});
        all.push_back(one);
    }
    return all;
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
    require(object, place, "tool", "give the number of a tool");
    std::vector<std::string> own{"kind"};
    if (auto* by_hand = dynamic_cast<TakesManualPostures*>(operation.get())) {
        own.push_back(TakesManualPostures::file_key);
        by_hand->set_manual_postures(read_structs(object, place, own.back(), manual_posture_parameters(),
                                                  {{"point", "give the place on the part"},
                                                   {"lead", "give the inclination"},
                                                   {"yaw", "give the yaw"}},
                                                  unit));
    }
    if (auto* edited = dynamic_cast<TakesRegionEdits*>(operation.get())) {
        own.push_back(TakesRegionEdits::edits_key);
        edited->set_region_edits(read_structs(object, place, own.back(), region_edit_parameters(),
                                              {{"place", "give a place in the region"}}, unit));
        own.push_back(TakesRegionEdits::drags_key);
        edited->set_boundary_drags(read_structs(
            object, place, own.back(), boundary_drag_parameters(),
            {{"from", "give the boundary's place"}, {"to", "give the place it moves to"}}, unit));
    }
    read_parameters(object, place, *operation, unit, own);
    return operation;
}

void read_stock(const Json& object, StockSpec& stock, LengthUnit unit) {
    stock.unit = unit;
    ParameterView<StockSpec> view(stock, stock_parameters());
    read_parameters(object, "stock", view, unit, {});
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
    static const std::vector<std::string> known = {"facetmill", "units", "part",      "stock",
                                                   "machine",   "tools", "operations"};
    for (auto it = file.begin(); it != file.end(); ++it)
        if (std::find(known.begin(), known.end(), it.key()) == known.end()) unknown_key(it.key(), "", known);
    Project project;
    const LengthUnit unit = project.unit =
        read_unit(require(file, "", "units", "write \"mm\" or \"in\""), "units");

    const Json& part = require(file, "", "part", "name the part's file");
    expect_object(part, "part");
    require(part, "part", "file", "name the part's file");
    project.part.unit = unit;
    ParameterView<PartSpec> part_view(project.part, part_parameters());
    read_parameters(part, "part", part_view, unit, {});
    project.stock.unit = unit;
    if (file.contains("stock")) read_stock(file["stock"], project.stock, unit);
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

Json write_value(const ParameterValue& value, const ParameterInfo& info, const std::string& place,
                 LengthUnit unit) {
    const auto number = [&](double v) { return json_number(v / info.scale(unit), place); };
    const auto numbers = [&](const auto& list) {
        Json array = Json::array();
        for (double v : list)
            array.push_back(number(v));
        return array;
    };
    if (const auto* d = std::get_if<double>(&value)) return number(*d);
    if (const auto* i = std::get_if<long>(&value)) return *i;
    if (const auto* b = std::get_if<bool>(&value)) return *b;
    if (const auto* s = std::get_if<std::string>(&value)) return *s;
    if (const auto* p = std::get_if<std::array<double, 2>>(&value)) return numbers(*p);
    return numbers(std::get<std::array<double, 3>>(value));
}

void write_parameter(Json& object, const std::string& place, const Parameterized& source,
                     const ParameterInfo& info, LengthUnit unit) {
    object[info.key] = write_value(source.get(info.key), info, member(place, info.key), unit);
}

void write_parameters(Json& object, const std::string& place, const Parameterized& source, LengthUnit unit) {
    for (const ParameterInfo* info : source.parameters())
        write_parameter(object, place, source, *info, unit);
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
    file["machine"] = project.machine;
    file["tools"] = Json::array();
    for (std::size_t i = 0; i < project.tools.size(); ++i) {
        const Tool& tool = project.tools[i];
        const std::string place = element("tools", i);
        Json object = write_struct(tool, tool_parameters(), place, unit);
        object["holder"] = Json::array();
        for (std::size_t k = 0; k < tool.holder.size(); ++k)
            object["holder"].push_back(
                write_struct(tool.holder[k], holder_parameters(), element(member(place, "holder"), k), unit));
        file["tools"].push_back(std::move(object));
    }
    file["operations"] = Json::array();
    for (std::size_t i = 0; i < project.operations.size(); ++i) {
        Json object = Json::object();
        object["kind"] = std::string(project.operations[i]->kind());
        const std::string place = element("operations", i);
        write_parameters(object, place, *project.operations[i], unit);
        const auto write_list = [&](const char* key, const auto& list, const auto& table) {
            if (list.empty()) return;
            object[key] = Json::array();
            for (std::size_t k = 0; k < list.size(); ++k)
                object[key].push_back(write_struct(list[k], table, element(member(place, key), k), unit));
        };
        const Operation* const o = project.operations[i].get();
        if (const auto* by_hand = dynamic_cast<const TakesManualPostures*>(o))
            write_list(TakesManualPostures::file_key, by_hand->manual_postures(),
                       manual_posture_parameters());
        if (const auto* edited = dynamic_cast<const TakesRegionEdits*>(o)) {
            write_list(TakesRegionEdits::edits_key, edited->region_edits(), region_edit_parameters());
            write_list(TakesRegionEdits::drags_key, edited->boundary_drags(), boundary_drag_parameters());
        }
        file["operations"].push_back(std::move(object));
    }
    return pretty_json(file);
}

void save_project(const Project& project, const std::filesystem::path& path) {
    Project moved = project;
    move_project(moved, path);
    const std::string text = project_to_json(moved);
    OutputFile file(path);
    file.write(text);
    file.commit();
}

} // namespace facetmill
