// Our own library files: every member of a ToolLibrary by its name.
#include "core/base/parameter_json.h"
#include "core/tools/formats.h"

namespace facetmill {

namespace {

constexpr long version = 1;
constexpr const char* version_key = "facetmill_tools";

Json number_json(double value, const std::string& key) {
    return json_number(value, key);
}

Json outline_json(const std::vector<HolderCone>& outline, double per) {
    Json list = Json::array();
    for (const HolderCone& c : outline)
        list.push_back({{"length", number_json(c.length / per, "length")},
                        {"lower_diameter", number_json(c.lower_diameter / per, "lower_diameter")},
                        {"upper_diameter", number_json(c.upper_diameter / per, "upper_diameter")}});
    return list;
}

Json holder_json(const ToolHolder& holder, double per) {
    return {{"name", holder.name},
            {"vendor", holder.vendor},
            {"product_id", holder.product_id},
            {"outline", outline_json(holder.outline, per)}};
}

ToolHolder read_holder(LooseObject object, LengthUnit unit) {
    ToolHolder holder{object.text("name"), object.text("vendor"), object.text("product_id"), {}};
    for (LooseObject cone : object.objects("outline"))
        holder.outline.push_back({cone.length("length", unit).value_or(0),
                                  cone.length("lower_diameter", unit).value_or(0),
                                  cone.length("upper_diameter", unit).value_or(0)});
    return holder;
}

} // namespace

ReadLibrary read_own(const Json& json, const std::string& name) {
    LooseObject file(json);
    if (const double found = file.number(version_key).value_or(0); found > double(version))
        throw Error(ErrorCode::unsupported_format, name, "is a tool library of a newer Facetmill",
                    "use a newer Facetmill, or export it anew");
    ReadLibrary read;
    read.library.name = file.text("name");
    read.library.unit = parse_length_unit(file.text("units"), "units");
    const LengthUnit unit = read.library.unit;
    const Json& tools =
        strict::expect_list(strict::require(json, "", "tools", "give the library's tools"), "tools");
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const std::string place = strict::element("tools", i);
        strict::expect_object(tools[i], place);
        LibraryTool t;
        const std::vector<std::string> own = {"overall_length", "material", "vendor",
                                              "product_id",     "comment",  "held_by"};
        ParameterView<Tool> view(t.tool, tool_parameters());
        read_parameters(tools[i], place, view, unit, own);
        LooseObject object(tools[i], place);
        t.overall_length = object.length("overall_length", unit).value_or(0);
        t.material = object.text("material");
        t.vendor = object.text("vendor");
        t.product_id = object.text("product_id");
        t.comment = object.text("comment");
        if (object.has("held_by")) t.holder = read_holder(object.object("held_by"), unit);
        check_tool(t.tool);
        read.library.tools.push_back(std::move(t));
    }
    for (const LooseObject& holder : file.objects("holders"))
        read.library.holders.push_back(read_holder(holder, unit));
    return read;
}

std::string write_own(const ToolLibrary& library) {
    const double per = mm_per(library.unit);
    Json file;
    file[version_key] = version;
    file["name"] = library.name;
    file["units"] = std::string(unit_name(library.unit));
    file["tools"] = Json::array();
    for (std::size_t i = 0; i < library.tools.size(); ++i) {
        const LibraryTool& t = library.tools[i];
        Json one;
        Tool tool = t.tool;
        write_parameters(one, strict::element("tools", i), ParameterView<Tool>(tool, tool_parameters()),
                         library.unit);
        one["overall_length"] = number_json(t.overall_length / per, "overall_length");
        one["material"] = t.material;
        one["vendor"] = t.vendor;
        one["product_id"] = t.product_id;
        one["comment"] = t.comment;
        one["held_by"] = holder_json(t.holder, per);
        file["tools"].push_back(std::move(one));
    }
    file["holders"] = Json::array();
    for (const ToolHolder& h : library.holders)
        file["holders"].push_back(holder_json(h, per));
    return json_file(file);
}

} // namespace facetmill
