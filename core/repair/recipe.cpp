#include "core/repair/recipe.h"

#include "core/base/file.h"
#include "core/base/parameter_json.h"
#include "core/base/strict_json.h"

#include <algorithm>

namespace facetmill {

namespace {

using Kind = RepairStep::Kind;

constexpr double largest_size = 1e6;
constexpr double largest_bound = 1e3;

ParameterInfo step_length(const char* key, const char* label, const char* help) {
    return {.key = key,
            .label = label,
            .help = help,
            .kind = ParameterKind::number,
            .quantity = Quantity::length,
            .minimum = 0,
            .maximum = largest_size,
            .stage = Stage::mesh,
            .default_unwritten = true};
}

ParameterInfo step_count(const char* key, const char* label, const char* help) {
    return {.key = key,
            .label = label,
            .help = help,
            .kind = ParameterKind::integer,
            .quantity = Quantity::count,
            .minimum = 0,
            .maximum = 4e9,
            .stage = Stage::mesh,
            .default_unwritten = true};
}

void add_amounts(ParameterTable<RepairStep>& t) {
    t.add(&RepairStep::size,
          step_length("size", "Size",
                      "pieces: those whose box has a smaller diagonal go. holes: those of "
                      "at most this diameter are filled, 0: all. crossings: as holes. fins: as pieces. "
                      "join: how far two scans of one surface may lie apart, 0: three "
                      "mean edges."));
    t.add(&RepairStep::facets,
          step_count("facets", "Facets",
                     "pieces: those with fewer facets go. decimate: ends when so few are left."));
    ParameterInfo area = step_length("area", "Area", "pieces: those with less area go.");
    area.quantity = Quantity::area;
    t.add(&RepairStep::area, area);
    t.add(&RepairStep::keep, step_count("keep", "Keep", "pieces: only so many with the largest areas stay."));
    t.add_choice(&RepairStep::fill,
                 {.key = "fill",
                  .label = "Fill",
                  .help = "holes, hole: smooth goes on as the surface around bends; flat takes "
                          "the least area. hole: left stays open whatever later steps say.",
                  .words = {"smooth", "flat", "left"},
                  .stage = Stage::mesh,
                  .default_unwritten = true});
    ParameterInfo bound =
        step_length("bound", "Bound",
                    "needles, smooth, decimate: no place of the surface moves farther. join: nor does the "
                    "other scan, which is laid on this one; 0: it stays where it is.");
    bound.maximum = largest_bound;
    t.add(&RepairStep::bound, bound);
}

void add_shapes(ParameterTable<RepairStep>& t) {
    t.add(&RepairStep::angle, {.key = "angle",
                               .label = "Feature angle",
                               .help = "smooth: edges that bend by more are features and stay sharp.",
                               .quantity = Quantity::angle,
                               .minimum = radians(1),
                               .maximum = pi,
                               .stage = Stage::mesh,
                               .default_unwritten = true});
    t.add(&RepairStep::share, {.key = "share",
                               .label = "Share",
                               .help = "decimate: ends when this share of the facets is left. 0 goes as far "
                                       "as the bound allows.",
                               .quantity = Quantity::ratio,
                               .minimum = 0,
                               .maximum = 1,
                               .stage = Stage::mesh,
                               .default_unwritten = true});
    t.add(&RepairStep::normal, {.key = "normal",
                                .label = "Normal",
                                .help = "cut: the plane's direction; what lies on this side of it goes.",
                                .kind = ParameterKind::triple,
                                .minimum = -1e6,
                                .maximum = 1e6,
                                .stage = Stage::mesh,
                                .default_unwritten = true});
    ParameterInfo offset =
        step_length("offset", "Offset", "cut: the plane's distance from the file's origin along the normal.");
    offset.minimum = -largest_size;
    t.add(&RepairStep::offset, offset);
    t.add(&RepairStep::close, {.key = "close",
                               .label = "Close",
                               .help = "cut: closes the section with facets in the plane.",
                               .kind = ParameterKind::boolean,
                               .stage = Stage::mesh,
                               .default_unwritten = true});
    ParameterInfo thickness = step_length("thickness", "Thickness",
                                          "thicken: how far behind the sheet its back lies; in front of it "
                                          "below 0.");
    thickness.minimum = -largest_bound;
    thickness.maximum = largest_bound;
    t.add(&RepairStep::thickness, thickness);
    ParameterInfo at =
        step_length("at", "Middle",
                    "hole: where the hole is: the one whose middle is nearest, no farther than "
                    "half its diameter.");
    at.kind = ParameterKind::triple;
    at.minimum = -largest_size;
    t.add(&RepairStep::at, at);
    t.add(&RepairStep::file, {.key = "file",
                              .label = "File",
                              .help = "join: the file of the scan that is joined on, in the unit and the "
                                      "coordinates of this one.",
                              .kind = ParameterKind::text,
                              .stage = Stage::mesh,
                              .default_unwritten = true});
}

[[noreturn]] void refuse(const std::string& place, ErrorCode code, const std::string& key,
                         const std::string& what, const std::string& remedy) {
    throw Error(code, place + (key.empty() ? "" : "." + key), what, remedy);
}

void check_step(RepairStep step, const std::string& place) {
    const ParameterView<RepairStep> view(step, repair_step_parameters());
    const std::string& kind = repair_kind_name(step.kind);
    const auto& keys = repair_keys(step.kind);
    for (const ParameterInfo* info : view.parameters()) {
        const ParameterValue value = view.get(info->key);
        info->check(value);
        const bool reads = info->key == "kind" || info->key == "off"
                           || std::find(keys.begin(), keys.end(), info->key) != keys.end();
        if (!reads && value != info->default_value)
            refuse(place, ErrorCode::out_of_range, info->key, "a step of kind " + kind + " does not read it",
                   "leave it out");
    }
    const auto need = [&](bool there, const char* key, const std::string& remedy) {
        if (!there) refuse(place, ErrorCode::missing_key, key, "is needed by a step of kind " + kind, remedy);
    };
    switch (step.kind) {
    case Kind::pieces:
        if (step.size == 0 && step.facets == 0 && step.area == 0 && step.keep == 0)
            refuse(place, ErrorCode::missing_key, "", "the step says no limit for pieces",
                   "give size, facets, area or keep");
        break;
    case Kind::needles:
    case Kind::smooth:
    case Kind::decimate:
        need(step.bound > 0, "bound", "say how far the surface may move");
        break;
    case Kind::cut:
        need(Vec3(step.normal[0], step.normal[1], step.normal[2]).norm() > 0, "normal",
             "say the plane's direction");
        break;
    case Kind::thicken:
        need(step.thickness != 0, "thickness", "say how thick the sheet becomes");
        break;
    case Kind::crossings:
        need(step.size > 0, "size", "say how large a place may be made anew");
        break;
    case Kind::fins:
        need(step.size > 0, "size", "say how large a sheet may be that goes");
        break;
    case Kind::join:
        need(!step.file.empty(), "file", "name the other scan's file");
        break;
    case Kind::turn:
    case Kind::holes:
    case Kind::hole:
        break;
    }
    if (step.fill == RepairStep::Fill::left && step.kind != Kind::hole)
        refuse(place, ErrorCode::out_of_range, "fill", "only a step of kind hole leaves a hole open",
               "write smooth or flat");
}

} // namespace

const ParameterTable<RepairStep>& repair_step_parameters() {
    static const auto table = [] {
        ParameterTable<RepairStep> t;
        t.add_choice(&RepairStep::kind,
                     {.key = "kind",
                      .label = "Kind",
                      .help = "What the step does: takes small pieces away, turns facets "
                              "to agree, takes needles away, fills holes, smooths noise, "
                              "decimates, cuts by a plane, thickens a sheet, makes anew "
                              "where the surface crosses itself, joins another scan on, takes sheets "
                              "away that hang on the surface and end in the open, fills one hole or "
                              "leaves it open.",
                      .words = {"pieces", "turn", "needles", "holes", "smooth", "decimate", "cut", "thicken",
                                "crossings", "join", "fins", "hole"},
                      .stage = Stage::mesh,
                      .required = "say what the step does"});
        add_amounts(t);
        add_shapes(t);
        t.add(&RepairStep::off, {.key = "off",
                                 .label = "Off",
                                 .help = "The step stays in the recipe and is left out.",
                                 .kind = ParameterKind::boolean,
                                 .stage = Stage::mesh,
                                 .default_unwritten = true});
        return t;
    }();
    return table;
}

const std::string& repair_kind_name(Kind kind) {
    return repair_step_parameters().find("kind")->info.words.at(std::size_t(kind));
}

const std::vector<std::string>& repair_keys(Kind kind) {
    static const std::vector<std::string> of_kind[] = {{"size", "facets", "area", "keep"},
                                                       {},
                                                       {"bound"},
                                                       {"size", "fill"},
                                                       {"bound", "angle"},
                                                       {"bound", "share", "facets"},
                                                       {"normal", "offset", "close"},
                                                       {"thickness"},
                                                       {"size", "fill"},
                                                       {"file", "size", "bound"},
                                                       {"size"},
                                                       {"at", "fill"}};
    return of_kind[std::size_t(kind)];
}

void check_recipe(const std::vector<RepairStep>& recipe, const std::string& place) {
    for (std::size_t i = 0; i < recipe.size(); ++i)
        check_step(recipe[i], strict::element(place, i));
}

std::vector<RepairStep> located_recipe(std::vector<RepairStep> recipe, const std::filesystem::path& folder) {
    for (RepairStep& step : recipe)
        if (!step.file.empty()) step.file = (folder / step.file).string(); // an absolute one stays
    return recipe;
}

std::vector<RepairStep> load_recipe(const std::filesystem::path& path) {
    const InputFile file(path);
    const std::string name = printable(path.string(), 400);
    const Json json = parse_strict_json(file.bytes(), name);
    try {
        strict::expect_object(json, "");
        for (const auto& [key, value] : json.items())
            if (key != "units" && key != repair_list.key)
                strict::unknown_key(key, key, {"units", repair_list.key});
        LengthUnit unit = LengthUnit::mm;
        if (json.contains("units"))
            unit = parse_length_unit(strict::read_text(json["units"], "units"), "units");
        const Json& list = strict::require(json, "", repair_list.key, "list the steps");
        ParameterInfo info{
            .key = repair_list.key, .kind = ParameterKind::records, .nouns = {"step", "steps"}};
        info.record = repair_step_parameters().infos();
        const ParameterValue value = read_value(list, info, repair_list.key, unit);
        std::vector<RepairStep> recipe = repair_list.structs(std::get<ParameterRecords>(value));
        check_recipe(recipe, repair_list.key);
        return located_recipe(std::move(recipe), path.parent_path());
    } catch (const Error& e) {
        throw e.within(name);
    }
}

} // namespace facetmill
