#include "core/job/project.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/usual_value.h"
#include "core/job/project_inputs.h"
#include "core/job/usual_tools.h"
#include "core/mesh/mesh_format.h"
#include "core/output/post/post.h"
#include "core/strategy/plan/shared_parameters.h"
#include "core/strategy/surface/boundary_region.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

fs::path from_project(const fs::path& project, const fs::path& file) {
    return file.is_absolute() ? file : project.parent_path() / file;
}

} // namespace

fs::path Project::part_path() const {
    return from_project(path, part.file);
}

MeshReading Project::part_reading() const {
    constexpr double share = 0.1, finest = 5e-4, coarsest = 1; // mm
    MeshReading reading = part.reading();
    const MeshFormat* format = mesh_format_named(part.file);
    if (!format || !format->has_surfaces || part.chord_tolerance.is_number()) return reading;
    double tolerance = infinity;
    for (const Operation* operation : all_operations(*this))
        tolerance = std::min(tolerance, operation->common().tolerance);
    if (tolerance < infinity) reading.chord = std::clamp(share * tolerance, finest, coarsest);
    return reading;
}

std::vector<RepairStep> Project::part_recipe() const {
    return located_recipe(part.repair, path.parent_path());
}

fs::path Project::stock_path() const {
    return stock.kind == StockSpec::Kind::mesh ? from_project(path, stock.file) : fs::path();
}

fs::path Project::fixture_path(const Fixture& fixture) const {
    return fixture.kind == Fixture::Kind::mesh ? from_project(path, fixture.file) : fs::path();
}

const Boundary& Project::boundary_of(const std::string& wanted) const {
    std::vector<std::string> names;
    std::string list;
    for (const Boundary& b : boundaries) {
        if (b.name == wanted) return b;
        names.push_back(b.name);
        list += (names.size() > 1 ? ", " : "") + printable(b.name);
    }
    const std::string near = nearest_name(wanted, names);
    throw Error(ErrorCode::missing_reference, "boundaries",
                "there is no boundary '" + printable(wanted) + "'",
                names.empty()  ? "make one, or leave the name empty"
                : near.empty() ? "boundaries there are: " + list
                               : "did you mean '" + printable(near) + "'?");
}

PartSpec Project::placed_part() const {
    const SetupFrame frame = frame_of(place);
    if (frame.is_identity()) return part;
    PartSpec placed = part;
    const Placement all = moved(turned(placement_of(part), frame.turn, Vec3::Zero()), frame.move);
    placed.rotate = all.rotate;
    placed.translate = all.translate;
    return placed;
}

fs::path Project::machine_path() const {
    return from_project(path, machine);
}

fs::path Project::post_path() const {
    return from_project(path, programs.post);
}

std::string file_stamp(const fs::path& path) {
    std::error_code ec;
    const fs::path real = fs::weakly_canonical(path, ec);
    std::string text = ec ? path.string() : real.string();
    const auto time = fs::last_write_time(path, ec);
    text += "|" + std::to_string(ec ? 0 : time.time_since_epoch().count());
    const auto size = fs::file_size(path, ec);
    return text + "|" + std::to_string(ec ? 0 : size);
}

Machine project_machine(const Project& project) {
    return is_machine_file(project.machine) ? load_machine(project.machine_path())
                                            : find_machine(project.machine);
}

namespace {

const Tool& tool_by_number(const std::vector<Tool>& tools, long number, const std::string& place) {
    if (const Tool* tool = find_tool(tools, number)) return *tool;
    std::string known;
    for (const Tool& t : tools)
        known += (known.empty() ? "" : ", ") + std::to_string(t.number);
    throw Error(ErrorCode::missing_reference, place, "there is no tool " + std::to_string(number),
                known.empty() ? "the project has no tools: add one" : "tools there are: " + known);
}

std::string place_of(const Operation& operation) {
    return "operation '" + printable(operation.common().name) + "'";
}

} // namespace

const Tool& Project::tool_of(const Operation& operation) const {
    return tool_by_number(tools, operation.common().tool, place_of(operation));
}

std::vector<Tool> Project::further_tools_of(const Operation& operation) const {
    std::vector<Tool> further;
    for (const long number : operation.further_tools())
        further.push_back(tool_by_number(tools, number, place_of(operation)));
    return further;
}

std::optional<AptCutter> Project::cutter_of(const Boundary& boundary) const {
    if (boundary.kind != Boundary::Kind::rest) return std::nullopt;
    return tool_by_number(tools, boundary.tool, boundary_place(boundary.name)).cutter();
}

void keep_referenced(const Project& project, const fs::path& output) {
    for (std::size_t i = 0; i < setup_count(project); ++i)
        for (const ProjectInput& input : project_inputs(view_of_setup(project, i)))
            refuse_to_overwrite(input.path, output);
}

void keep_inputs(const Project& project, const fs::path& output) {
    if (!project.path.empty()) refuse_to_overwrite(project.path, output);
    keep_referenced(project, output);
}

void move_project(Project& project, const fs::path& path) {
    const auto folder = [](const fs::path& p) { return fs::absolute(p).lexically_normal().parent_path(); };
    const bool is_new = project.path.empty(); // its relative files wait for a folder to be relative to
    const auto moved = [&](const fs::path& file) {
        if (file.empty() || !(is_new ? file.is_absolute() : folder(project.path) != folder(path)))
            return file.string();
        const fs::path target = fs::absolute(from_project(project.path, file)).lexically_normal();
        const fs::path relative = target.lexically_relative(folder(path));
        const bool below = !relative.empty() && *relative.begin() != "..";
        return (below || (file.is_relative() && !relative.empty()) ? relative : target).generic_string();
    };
    project.part.file = moved(project.part.file);
    for (std::size_t i = 0; i < setup_count(project); ++i) {
        Setup& setup = setup_at(project, i);
        setup.stock.file = moved(setup.stock.file);
        for (Fixture& fixture : setup.fixtures)
            fixture.file = moved(fixture.file);
        if (is_machine_file(setup.machine)) setup.machine = moved(setup.machine);
        if (is_post_file(setup.programs.post)) setup.programs.post = moved(setup.programs.post);
    }
    project.path = path;
}

namespace {

void check_values(const Parameterized& values, const std::string& place, LengthUnit unit) {
    for (const ParameterInfo* info : values.parameters()) {
        try {
            info->check(values.get(info->key), unit);
        } catch (const Error& e) {
            throw Error(e.code(), place + "." + e.where(), e.message(), e.remedy());
        }
    }
}

template <class Struct>
void check_struct(const Struct& values, const ParameterTable<Struct>& table, const std::string& place,
                  LengthUnit unit) {
    Struct copy = values;
    check_values(ParameterView<Struct>(copy, table), place, unit);
}

std::string at(const char* list, std::size_t i) {
    return list + ("[" + std::to_string(i) + "]");
}

/// `what`: part, stock or fixture; `place`: part, stock or fixtures[0].
void check_mesh_file(const std::string& file, const std::string& what, const std::string& place) {
    const std::string formats = what == "part" ? mesh_format_names(" or ") : solid_format_names(" or ");
    if (file.empty())
        throw Error(ErrorCode::missing_key, place + ".file", "the " + what + " has no file",
                    "name an " + formats + " file");
    std::string extension = fs::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (extension == ".facetmill")
        throw Error(ErrorCode::unsupported_format, place + ".file",
                    "a project cannot be the " + what + " of a project", "name an " + formats + " file");
}

void check_part(const Project& p) {
    check_struct(p.part, part_parameters(), "part", p.unit);
    check_mesh_file(p.part.file, "part", "part");
    check_recipe(p.part.repair, "part.repair");
}

void check_stock(const Project& p) {
    check_struct(p.stock, stock_parameters(), "stock", p.unit);
    if (p.stock.kind == StockSpec::Kind::mesh) check_mesh_file(p.stock.file, "stock", "stock");
    if (p.stock.kind == StockSpec::Kind::rest && chosen_setup(p) == 0)
        throw Error(ErrorCode::missing_reference, "stock.kind",
                    "no setup comes before the first, so there is no rest of its stock",
                    "give the stock of the first setup as box, cylinder or mesh");
}

void check_fixtures(const Project& p) {
    for (std::size_t i = 0; i < p.fixtures.size(); ++i) {
        const Fixture& fixture = p.fixtures[i];
        const std::string place = at("fixtures", i);
        check_struct(fixture, fixture_parameters(), place, p.unit);
        if (fixture.name.find_first_not_of(' ') == std::string::npos)
            throw Error(ErrorCode::out_of_range, place + ".name", "the name is empty",
                        "give the fixture a name");
        if (fixture.kind == Fixture::Kind::mesh) check_mesh_file(fixture.file, "fixture", place);
        for (std::size_t k = 0; k < i; ++k)
            if (p.fixtures[k].name == fixture.name)
                throw Error(ErrorCode::out_of_range, place + ".name",
                            "the name '" + printable(fixture.name) + "' occurs twice",
                            "give every fixture its own name");
    }
}

void check_boundaries(const Project& p) {
    for (std::size_t i = 0; i < p.boundaries.size(); ++i) {
        const Boundary& boundary = p.boundaries[i];
        const std::string place = at("boundaries", i);
        check_struct(boundary, boundary_parameters(), place, p.unit);
        if (boundary.name.find_first_not_of(' ') == std::string::npos)
            throw Error(ErrorCode::out_of_range, place + ".name", "the name is empty",
                        "give the boundary a name");
        if (boundary.kind == Boundary::Kind::curve && boundary.curve.size() < 3)
            throw Error(ErrorCode::out_of_range, place + ".curve", "a closed curve has three corners or more",
                        "draw the curve on the part, or list its corners");
        try {
            p.cutter_of(boundary);
        } catch (const Error& e) {
            throw Error(e.code(), place + ".tool", e.message(), e.remedy());
        }
        for (std::size_t k = 0; k < i; ++k)
            if (p.boundaries[k].name == boundary.name)
                throw Error(ErrorCode::out_of_range, place + ".name",
                            "the name '" + printable(boundary.name) + "' occurs twice",
                            "give every boundary its own name");
    }
}

/// What an operation says of boundaries.
void check_bounds_of(const Operation& operation, const Project& p, const std::string& place) {
    const auto check = [&](const std::string& name, const char* key) {
        try {
            if (!name.empty()) p.boundary_of(name);
        } catch (const Error& e) {
            throw Error(e.code(), place + "." + key, e.message(), e.remedy());
        }
    };
    check(operation.common().boundary, "boundary");
    check(operation.common().avoid, "avoid");
    const std::vector<std::string> keys = operation.curve_keys(), names = operation.curve_names();
    for (std::size_t i = 0; i < keys.size(); ++i)
        check(names[i], keys[i].c_str());
    if (operation.turning() && !(operation.common().boundary.empty() && operation.common().avoid.empty()))
        throw Error(ErrorCode::out_of_range,
                    place + (operation.common().boundary.empty() ? ".avoid" : ".boundary"),
                    "an operation on a part that turns knows no boundaries", "leave it out");
}

void check_axis_of(const Operation& operation, const std::string& place) {
    const std::array<double, 3>& axis = operation.common().tool_axis;
    if (axis == OperationCommon().tool_axis) return;
    if (axis == std::array<double, 3>{0, 0, 0})
        throw Error(ErrorCode::out_of_range, place + ".tool_axis", "the tool axis has no direction",
                    "give a direction from the tip to the spindle, upright is 0, 0, 1");
    if (!operation.keeps_axis())
        throw Error(ErrorCode::out_of_range, place + ".tool_axis",
                    "the operation tilts the tool as it goes and keeps no axis",
                    operation.has("tilt_limit")
                        ? "leave the tool axis upright (0, 0, 1), or set the tilt limit to 0"
                        : "leave the tool axis upright (0, 0, 1)");
}

void check_tools(const Project& p) {
    for (std::size_t i = 0; i < p.tools.size(); ++i) {
        const Tool& tool = p.tools[i];
        const std::string place = at("tools", i);
        check_struct(tool, tool_parameters(), place, p.unit);
        try {
            check_tool(tool);
        } catch (const Error& e) {
            throw Error(e.code(), place + (e.where().empty() ? "" : "." + e.where()), e.message(),
                        e.remedy());
        }
        for (std::size_t k = 0; k < i; ++k)
            if (p.tools[k].number == tool.number)
                throw Error(ErrorCode::out_of_range, place + ".number",
                            "the tool number " + std::to_string(tool.number) + " occurs twice",
                            "give every tool its own number");
    }
}

void check_operations(const Project& p) {
    const std::vector<const Operation*> all = all_operations(p);
    for (std::size_t i = 0; i < p.operations.size(); ++i) {
        const Operation& operation = *p.operations[i];
        const std::string place = at("operations", i);
        const std::string& name = operation.common().name;
        check_values(operation, place, p.unit);
        if (name.find_first_not_of(' ') == std::string::npos)
            throw Error(ErrorCode::out_of_range, place + ".name", "the name is empty",
                        "give the operation a name");
        for (const Operation* earlier : all) {
            if (earlier == &operation) break; // those after it ask for themselves
            if (earlier->common().name == name)
                throw Error(ErrorCode::out_of_range, place + ".name",
                            "the name '" + printable(name) + "' occurs twice",
                            "give every operation its own name");
        }
        try {
            p.tool_of(operation);
        } catch (const Error& e) {
            throw Error(e.code(), place + ".tool", e.message(), e.remedy());
        }
        check_axis_of(operation, place);
        check_bounds_of(operation, p, place);
        try {
            p.further_tools_of(operation);
        } catch (const Error& e) {
            throw Error(e.code(), place, e.message(), e.remedy());
        }
    }
}

void check_programs(const Project& p) {
    ProgramSpec copy = p.programs;
    const ParameterView<ProgramSpec> view(copy, program_parameters());
    for (const ParameterInfo* info : view.parameters())
        info->check(view.get(info->key), p.unit);
    // Its file is read when programs are written.
    if (!copy.post.empty() && !is_post_file(copy.post)) find_post(copy.post);
}

/// All that is said of the setup that the project is the view on.
void check_setup(const Project& p) {
    check_struct(p.place, place_parameters(), "place", p.unit);
    if (p.name.find_first_not_of(' ') == std::string::npos)
        throw Error(ErrorCode::out_of_range, "name", "the name is empty", "give the setup a name");
    check_text(p.name, "name");
    for (const Setup& earlier : p.before)
        if (earlier.name == p.name)
            throw Error(ErrorCode::out_of_range, "name",
                        "the setup's name '" + printable(p.name) + "' occurs twice",
                        "give every setup its own name");
    check_stock(p);
    check_fixtures(p);
    check_boundaries(p);
    check_programs(p);
    // Until the project has a place, nobody knows where a relative file is.
    if (!is_machine_file(p.machine) || !p.path.empty()) project_machine(p);
    check_operations(p);
}

} // namespace

void check_project(const Project& project) {
    check_part(project);
    check_struct(project.limits, verify_limit_parameters(), "verification", project.unit);
    check_tools(project);
    const std::size_t n = setup_count(project);
    if (n == 1) return check_setup(project);
    for (std::size_t i = 0; i < n; ++i) {
        try {
            check_setup(view_of_setup(project, i));
        } catch (const Error& e) {
            const std::string setup = at("setups", i);
            throw Error(e.code(), e.where().empty() ? setup : setup + "." + e.where(), e.message(),
                        e.remedy());
        }
    }
}

namespace {

/// "NAME.key=value" in its parts.
struct SettingParts {
    std::optional<std::string_view> name;
    std::string_view key;
    std::optional<std::string_view> value; ///< nothing where there is no '='
};

/// `name`: that of an operation, whose length is known; a name may hold '.' and '='. Otherwise the key begins
/// behind the last '.' before '='.
SettingParts setting_parts(std::string_view setting, std::optional<std::size_t> name = {}) {
    const std::size_t equal = setting.find('=', name.value_or(0));
    const std::string_view left = setting.substr(0, equal);
    const std::size_t dot = name.value_or(left.rfind('.'));
    SettingParts parts;
    if (dot != std::string_view::npos) parts.name = left.substr(0, dot);
    parts.key = dot == std::string_view::npos ? left : left.substr(dot + 1);
    if (equal != std::string_view::npos) parts.value = setting.substr(equal + 1);
    return parts;
}

/// "post=grbl" for all setups, "Top.wcs=G55" for one; false where it names nothing of programs.
bool apply_to_programs(Project& project, const SettingParts& parts, const std::string& shown) {
    const std::string key(parts.key);
    if (!parts.value || !program_parameters().find(key)) return false;
    bool found = false;
    for (std::size_t i = 0; i < setup_count(project); ++i) {
        Setup& setup = setup_at(project, i);
        if (parts.name && setup.name != *parts.name) continue;
        found = true;
        ParameterView<ProgramSpec> programs(setup.programs, program_parameters());
        try {
            programs.set(key, programs.parameter(key).parse(*parts.value, project.unit));
        } catch (const Error& e) {
            throw Error(e.code(), shown, e.message(), e.remedy());
        }
    }
    return found;
}

/// "part.smoothing=0.02"; false where it names nothing of the part.
bool apply_to_part(Project& project, const SettingParts& parts, const std::string& shown) {
    const std::string key(parts.key);
    if (!parts.value || parts.name != "part" || !part_parameters().find(key)) return false;
    ParameterView<PartSpec> part(project.part, part_parameters());
    try {
        part.set(key, part.parameter(key).parse(*parts.value, project.unit));
    } catch (const Error& e) {
        throw Error(e.code(), shown, e.message(), e.remedy());
    }
    return true;
}

} // namespace

void apply_setting(Project& project, std::string_view setting) {
    const std::string shown = "--set " + printable(setting, 120);
    const auto usage = [&](const std::string& what) {
        throw Error(ErrorCode::usage, shown, what, "write NAME.key=value, as in Finish.tolerance=0.01");
    };
    // A name may hold '.' and '=': the longest name that fits counts.
    Operation* operation = nullptr;
    std::size_t length = 0;
    std::vector<std::string> names;
    const std::vector<Operation*> all = all_operations(project);
    for (std::size_t i = 0; i < all.size(); ++i) {
        Operation* o = all[i];
        names.push_back(o->common().name);
        for (const std::string& name : {o->common().name, std::to_string(i + 1)}) {
            const bool fits =
                setting.size() > name.size() && setting.starts_with(name) && setting[name.size()] == '.';
            // A name beats a place of the same length.
            if (fits && (name.size() > length || (name.size() == length && name == o->common().name))) {
                operation = o;
                length = name.size();
            }
        }
    }
    const SettingParts parts = operation ? setting_parts(setting, length) : setting_parts(setting);
    if (!operation && (apply_to_programs(project, parts, shown) || apply_to_part(project, parts, shown)))
        return;
    if (!parts.value) usage("there is no '='");
    if (!operation) {
        if (!parts.name || parts.name->empty()) usage("there is no operation name before the key");
        const std::string name(*parts.name), near = nearest_name(name, names);
        std::string list;
        for (const auto& n : names)
            list += (list.empty() ? "" : ", ") + printable(n);
        throw Error(ErrorCode::missing_reference, shown, "there is no operation '" + printable(name) + "'",
                    near.empty() ? "operations there are: " + list
                                 : "did you mean '" + printable(near) + "'?");
    }
    const std::string key(parts.key);
    if (key.empty()) usage("there is no key before '='");
    try {
        operation->set(key, operation->parameter(key).parse(*parts.value, project.unit));
    } catch (const Error& e) {
        throw Error(e.code(), shown, e.message(), e.remedy());
    }
}

namespace {

/// As near to `v` as the parameter allows.
double allowed(double v, const ParameterInfo& info) {
    return std::clamp(v, info.minimum, info.maximum);
}

} // namespace

double starting_feed(LengthUnit unit) {
    return unit == LengthUnit::inch ? 40 * mm_per(LengthUnit::inch) : OperationCommon().feed;
}

Project default_project(const fs::path& part_file, LengthUnit part_unit, const Box3& part_box) {
    const LengthUnit unit = project_unit(part_unit);
    const double per = mm_per(unit);
    const Vec3 size = part_box.size();
    const double diagonal = std::max(size.norm() / per, 1e-3);

    Project p;
    p.unit = unit;
    p.part.file = fs::absolute(part_file).lexically_normal().generic_string();
    p.part.unit = p.stock.unit = part_unit;
    const double margin = allowed(round_down(diagonal / 40) * per, stock_parameters().find("margin")->info);
    p.stock.margin = {margin, margin, margin};

    const Tool tool = usual_finishing_tool(size, unit);
    p.tools.push_back(tool);

    auto operation = make_operation("finish3");
    take_usual_values(*operation, unit);
    OperationCommon& common = operation->common();
    common.name = "Finish";
    common.tool = tool.number;
    common.tolerance = usual_tolerance(tool, size, unit);
    common.feed = starting_feed(unit);
    common.spindle = 6000;
    // Less than that is no clearance for the hand that sets the zero.
    const double least = unit == LengthUnit::inch ? 0.05 : 1;
    common.clearance =
        allowed(std::max(round_down(diagonal / 25), least) * per, operation->parameter("clearance"));
    p.operations.push_back(std::move(operation));
    return p;
}

Project default_turned_project(const fs::path& part_file, LengthUnit unit, const Box3& part_box) {
    Project p = default_project(part_file, unit, part_box);
    const OperationCommon finish = p.operations.front()->common();
    p.machine = "lathe-mill";
    p.stock.kind = StockSpec::Kind::cylinder;
    p.stock.axis = StockSpec::Axis::x;
    p.stock.margin[0] = 0; // it is held at its ends
    p.operations.clear();
    const auto add = [&](const char* kind, const char* name, double tolerance) -> Operation& {
        auto operation = make_operation(kind);
        take_usual_values(*operation, p.unit);
        OperationCommon& common = operation->common();
        common.name = name;
        common.tool = finish.tool;
        common.tolerance = tolerance;
        common.feed = finish.feed;
        common.spindle = finish.spindle;
        common.clearance = finish.clearance;
        return *p.operations.emplace_back(std::move(operation));
    };
    Operation& rough = add("lathe_rough", "Rough", 10 * finish.tolerance);
    const double diameter = p.tools.front().diameter;
    const auto rounded = [&](double length) { // a share of a size in mm is round, of 3/16 in it is not
        const double per = mm_per(p.unit);
        return p.unit == LengthUnit::inch ? round_to_digit(length / per) * per : length;
    };
    rough.set("depth_of_cut", rounded(diameter / 4));
    rough.set("finishing_allowance", rounded(diameter / 20));
    add("lathe_finish", "Finish", finish.tolerance);
    return p;
}

} // namespace facetmill
