#include "core/study/study.h"

#include "core/base/parameter.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

using namespace strict;

namespace {

constexpr std::size_t max_orders = 5040; // of seven operations

const std::vector<std::string> study_keys = {"study",  "project", "tools", "vary",   "want",
                                             "limits", "samples", "seed",  "halving"};

double number_at(const Json& value, const std::string& place) {
    if (!value.is_number()) wrong_type(place, value, "a number");
    return value.get<double>();
}

std::size_t count_at(const Json& value, const std::string& place, double least) {
    const double v = number_at(value, place);
    constexpr double most = 1e9;
    if (!(v >= least && v <= most) || v != std::floor(v))
        throw Error(ErrorCode::out_of_range, place, "'" + value.dump() + "' is no such count",
                    "write a whole number from " + format_number(least));
    return std::size_t(v);
}

double share_at(const Json& value, const std::string& place) {
    const double v = number_at(value, place);
    if (!(v > 0 && v <= 1))
        throw Error(ErrorCode::out_of_range, place, "'" + value.dump() + "' is no share",
                    "write a number above 0, at most 1");
    return v;
}

void check_keys(const Json& object, const std::string& place, const std::vector<std::string>& known) {
    expect_object(object, place);
    for (auto it = object.begin(); it != object.end(); ++it)
        if (std::find(known.begin(), known.end(), it.key()) == known.end())
            unknown_key(it.key(), place, known);
}

std::string label_of(const Json& value) {
    return printable(value.is_string() ? value.get<std::string>() : value.dump(), 60);
}

/// The operations of the setup that has most of them, in every order.
Json all_orders(const Project& project, const std::string& place) {
    std::vector<std::string> names;
    if (setup_count(project) > 1)
        throw Error(ErrorCode::missing_reference, place, "the project has several setups",
                    "write the orders of operations out, with the setup in the path");
    for (const auto& o : project.operations)
        names.push_back(o->common().name);
    std::vector<std::size_t> order(names.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    Json all = Json::array();
    do {
        Json one = Json::array();
        for (const std::size_t i : order)
            one.push_back(names[i]);
        all.push_back(std::move(one));
        if (all.size() > max_orders)
            throw Error(ErrorCode::limit_exceeded, place,
                        std::to_string(names.size()) + " operations have too many orders",
                        "write out those that are meant");
    } while (std::next_permutation(order.begin(), order.end()));
    return all;
}

/// What a word in the place of a list of values stands for.
Json values_named(const Json& word, const std::string& place, const Project& project,
                  const std::vector<Json>& tools) {
    const std::string name = read_text(word, place);
    if (name == "orders") return all_orders(project, place);
    if (name != "tools")
        throw Error(ErrorCode::out_of_range, place, "'" + printable(name) + "' stands for no values",
                    "write a list, \"tools\" or \"orders\"");
    Json numbers = Json::array();
    for (const Tool& t : project.tools)
        numbers.push_back(t.number);
    for (const Json& tool : tools)
        if (tool.contains("number")) numbers.push_back(tool["number"]);
    return numbers;
}

Json evenly_spaced(const Json& object, const std::string& place) {
    const double from = number_at(object["from"], member(place, "from"));
    const double to =
        number_at(require(object, place, "to", "write where the values end"), member(place, "to"));
    const std::size_t steps = count_at(require(object, place, "steps", "write how many values there are"),
                                       member(place, "steps"), 2);
    if (steps > Study::max_candidates)
        throw Error(ErrorCode::out_of_range, member(place, "steps"), "these are too many values",
                    "write at most " + std::to_string(Study::max_candidates));
    Json values = Json::array();
    for (std::size_t i = 0; i < steps; ++i) {
        const double t = double(i) / double(steps - 1);
        // At twelve digits, so that 0.1 to 0.3 has a 0.2 in it.
        values.push_back(json_number(std::stod(format_number(from + (to - from) * t, 12)), place));
    }
    return values;
}

StudyVariation read_choices(const Json& object, const std::string& place) {
    check_keys(object, place, {"name", "choices"});
    StudyVariation variation;
    variation.name = read_text(require(object, place, "name", "name what varies"), member(place, "name"));
    const Json& choices = expect_list(object["choices"], member(place, "choices"));
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const std::string at = element(member(place, "choices"), i);
        expect_object(choices[i], at);
        StudyChoice choice;
        for (auto it = choices[i].begin(); it != choices[i].end(); ++it) {
            if (it.key() == "label") {
                choice.label = read_text(it.value(), member(at, "label"));
                continue;
            }
            choice.values.emplace_back(it.key(), it.value());
        }
        if (choice.label.empty())
            for (const auto& [path, value] : choice.values)
                choice.label += (choice.label.empty() ? "" : ", ") + label_of(value);
        if (choice.label.empty()) choice.label = "as it stands";
        variation.choices.push_back(std::move(choice));
    }
    return variation;
}

StudyVariation read_variation(const Json& object, const std::string& place, const Project& project,
                              const std::vector<Json>& tools) {
    expect_object(object, place);
    if (object.contains("choices")) return read_choices(object, place);
    check_keys(object, place, {"name", "path", "values", "from", "to", "steps"});
    StudyVariation variation;
    const std::string path = read_text(require(object, place, "path",
                                               "write the place in the project that varies, as "
                                               "\"operations[Finish].tolerance\""),
                                       member(place, "path"));
    variation.name = object.contains("name") ? read_text(object["name"], member(place, "name")) : path;
    const bool range = object.contains("from");
    if (range == object.contains("values"))
        throw Error(ErrorCode::missing_key, place, "there are no values, or two kinds of them",
                    "write \"values\", or \"from\", \"to\" and \"steps\"");
    Json values;
    if (range)
        values = evenly_spaced(object, place);
    else if (object["values"].is_string())
        values = values_named(object["values"], member(place, "values"), project, tools);
    else
        values = expect_list(object["values"], member(place, "values"));
    for (const Json& value : values)
        variation.choices.push_back({label_of(value), {{path, value}}});
    return variation;
}

StudyLimit read_limit(const std::string& key, const Json& value, const std::string& place) {
    StudyLimit limit;
    limit.measure = measure_named(key, place);
    if (value.is_number()) {
        limit.most = value.get<double>();
        return limit;
    }
    limit.project = true;
    limit.most = 1;
    if (value.is_string() && value.get<std::string>() == "project") return limit;
    if (value.is_object()) {
        check_keys(value, place, {"project_times"});
        limit.most = number_at(require(value, place, "project_times", "write how many times the project's"),
                               member(place, "project_times"));
        return limit;
    }
    wrong_type(place, value, "a number, \"project\" or { \"project_times\": 1.1 }");
}

Json study_object(std::string_view json) {
    Json file = parse_strict_json(json, "");
    check_keys(file, "", study_keys);
    if (count_at(require(file, "", "study", "write \"study\": 1"), "study", 1) > 1)
        throw Error(ErrorCode::newer_version, "study", "a newer Facetmill wrote this study",
                    "use the newer program");
    return file;
}

Study read_study(const Json& file, const Project& project) {
    Study study;
    study.project = read_text(require(file, "", "project", "name the project's file"), "project");
    if (file.contains("tools"))
        for (const Json& tool : expect_list(file["tools"], "tools"))
            study.tools.push_back(tool);
    if (file.contains("vary")) {
        const Json& vary = expect_list(file["vary"], "vary");
        for (std::size_t i = 0; i < vary.size(); ++i) {
            study.vary.push_back(read_variation(vary[i], element("vary", i), project, study.tools));
            if (study.vary.back().choices.empty())
                throw Error(ErrorCode::missing_key, element("vary", i), "there is no value to try",
                            "list at least one");
        }
    }
    const bool varies = std::any_of(study.vary.begin(), study.vary.end(),
                                    [](const StudyVariation& v) { return v.choices.size() > 1; });
    if (!varies)
        throw Error(ErrorCode::missing_key, "vary", "nothing may vary",
                    "list at least one place of the project with two values");
    const Json& want =
        expect_list(require(file, "", "want", "list what is wanted, as [\"machining_time\"]"), "want");
    for (std::size_t i = 0; i < want.size(); ++i)
        study.want.push_back(measure_named(read_text(want[i], element("want", i)), element("want", i)));
    if (study.want.empty())
        throw Error(ErrorCode::missing_key, "want", "nothing is wanted", "list at least \"machining_time\"");
    if (file.contains("limits")) {
        expect_object(file["limits"], "limits");
        for (auto it = file["limits"].begin(); it != file["limits"].end(); ++it)
            study.limits.push_back(read_limit(it.key(), it.value(), member("limits", it.key())));
    }
    if (file.contains("samples")) study.samples = count_at(file["samples"], "samples", 1);
    if (file.contains("seed")) study.seed = count_at(file["seed"], "seed", 0);
    if (file.contains("halving")) {
        check_keys(file["halving"], "halving", {"coarse", "fine"});
        if (file["halving"].contains("coarse"))
            study.coarse = share_at(file["halving"]["coarse"], "halving.coarse");
        if (file["halving"].contains("fine")) study.fine = share_at(file["halving"]["fine"], "halving.fine");
    }
    if (study.fine > study.coarse) study.coarse = study.fine;
    return study;
}

} // namespace

Study parse_study(std::string_view json, const std::string& name, const Project& project) {
    try {
        return read_study(study_object(json), project);
    } catch (const Error& e) {
        throw e.within(name);
    }
}

std::string study_project(std::string_view json, const std::string& name) {
    try {
        return read_text(require(study_object(json), "", "project", "name the project's file"), "project");
    } catch (const Error& e) {
        throw e.within(name);
    }
}

} // namespace facetmill
