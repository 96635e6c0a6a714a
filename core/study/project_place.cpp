#include "core/study/project_place.h"

#include "core/base/parameter.h"
#include "core/base/parameter_json.h"
#include "core/strategy/plan/operation.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace facetmill {

namespace {

/// ".key" or "[which]" of a path.
struct PathStep {
    std::string text;
    bool element = false;
};

[[noreturn]] void bad_path(const std::string& path, const std::string& what) {
    throw Error(ErrorCode::unknown_key, printable(path, 200), what,
                "write a place of the project's file, as operations[Finish].tolerance");
}

/// The end of "[...]" whose bracket is at `open`; names may have brackets in them.
std::size_t closing_bracket(const std::string& path, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < path.size(); ++i) {
        if (path[i] == '[') ++depth;
        if (path[i] == ']' && --depth == 0) return i;
    }
    bad_path(path, "a bracket is not closed");
}

std::vector<PathStep> steps_of(const std::string& path) {
    std::vector<PathStep> steps;
    for (std::size_t i = 0; i < path.size();) {
        if (path[i] == '[') {
            const std::size_t end = closing_bracket(path, i);
            steps.push_back({path.substr(i + 1, end - i - 1), true});
            i = end + 1;
            continue;
        }
        if (path[i] == '.') {
            if (steps.empty()) bad_path(path, "it begins with a point");
            ++i;
        } else if (!steps.empty()) {
            bad_path(path, "there is no point behind a bracket");
        }
        const std::size_t end = std::min(path.find_first_of(".[", i), path.size());
        steps.push_back({path.substr(i, end - i), false});
        if (steps.back().text.empty()) bad_path(path, "a name is missing");
        i = end;
    }
    if (steps.empty()) bad_path(path, "it is empty");
    return steps;
}

std::optional<std::size_t> place_number(const std::string& text) {
    constexpr std::size_t longest = 6;
    if (text.empty() || text.size() > longest || text.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    return std::stoul(text);
}

/// By name; tools by their number as well, all others by their place.
std::optional<std::size_t> find_element(const Json& list, const std::string& which) {
    const auto number = place_number(which);
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!list[i].is_object()) continue;
        if (list[i].contains("number") && number && list[i]["number"] == *number) return i;
        if (list[i].contains("name") && list[i]["name"] == which) return i;
    }
    const bool tools = !list.empty() && list[0].is_object() && list[0].contains("number");
    if (number && *number < list.size() && !tools) return number;
    return std::nullopt;
}

std::string element_names(const Json& list) {
    std::string names;
    for (const Json& one : list) {
        if (!one.is_object()) continue;
        std::string name;
        if (one.contains("number"))
            name = one["number"].dump();
        else if (one.contains("name") && one["name"].is_string())
            name = one["name"].get<std::string>();
        names += (names.empty() ? "" : ", ") + printable(name);
    }
    return names.empty() ? "none" : names;
}

/// The setup that a path without one is in.
Json& setup_of_path(Json& project, const std::vector<PathStep>& steps, const std::string& path) {
    Json& setups = project["setups"];
    if (setups.size() == 1) return setups[0];
    Json* found = nullptr;
    if (steps.size() > 1 && steps[0].text == "operations" && steps[1].element && !place_number(steps[1].text))
        for (Json& setup : setups)
            if (find_element(setup["operations"], steps[1].text)) {
                if (found) bad_path(path, "two setups have such an operation: name the setup");
                found = &setup;
            }
    if (!found)
        throw Error(ErrorCode::missing_reference, printable(path, 200), "the project has several setups",
                    "write setups[NAME]. before it; setups there are: " + element_names(setups));
    return *found;
}

void put_in_order(Json& operations, const Json& names, const std::string& path) {
    Json ordered = Json::array();
    std::vector<bool> used(operations.size(), false);
    for (const Json& name : names) {
        if (!name.is_string()) bad_path(path, "an order of operations is a list of their names");
        const auto i = find_element(operations, name.get<std::string>());
        if (!i || used[*i])
            throw Error(ErrorCode::missing_reference, printable(path, 200),
                        "'" + printable(name.get<std::string>()) + "' is no operation, or stands twice",
                        "name each once: " + element_names(operations));
        used[*i] = true;
        ordered.push_back(operations[*i]);
    }
    if (ordered.size() != operations.size())
        throw Error(ErrorCode::missing_reference, printable(path, 200), "an order leaves operations out",
                    "name each once: " + element_names(operations));
    operations = std::move(ordered);
}

/// What the other kind reads as it stands stays.
void set_kind(Json& operation, const Json& kind, const std::string& path) {
    if (!kind.is_string()) strict::wrong_type(printable(path, 200), kind, "a kind of operation");
    std::unique_ptr<Operation> other;
    try {
        other = make_operation(kind.get<std::string>());
    } catch (const Error& e) {
        throw Error(e.code(), printable(path, 200), e.message(), e.remedy());
    }
    Json changed = Json::object();
    changed["kind"] = kind;
    for (auto it = operation.begin(); it != operation.end(); ++it) {
        if (it.key() == "kind" || !other->has(it.key())) continue;
        try {
            // Whichever unit: what is a length in one is one in the other.
            (void)read_value(it.value(), other->parameter(it.key()), it.key(), LengthUnit::mm);
        } catch (const Error&) {
            continue;
        }
        changed[it.key()] = it.value();
    }
    operation = std::move(changed);
}

} // namespace

void set_at(Json& project, const std::string& path, const Json& value) {
    const std::vector<PathStep> steps = steps_of(path);
    Json* at = &project;
    if (project.contains("setups") && !project.contains(steps[0].text))
        at = &setup_of_path(project, steps, path);
    std::string above; // the key that the place is in
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const bool last = i + 1 == steps.size();
        const PathStep& step = steps[i];
        if (step.element) {
            if (!at->is_array()) bad_path(path, "'" + printable(above) + "' is no list");
            const auto found = find_element(*at, step.text);
            if (!found)
                throw Error(ErrorCode::missing_reference, printable(path, 200),
                            "'" + printable(above) + "' has no '" + printable(step.text) + "'",
                            "there are: " + element_names(*at));
            at = &(*at)[*found];
            continue;
        }
        if (!at->is_object()) bad_path(path, "'" + printable(above) + "' has no keys");
        if (last && step.text == "kind" && above == "operations") return set_kind(*at, value, path);
        if (!last && !at->contains(step.text)) {
            std::string keys;
            for (auto it = at->begin(); it != at->end(); ++it)
                keys += (keys.empty() ? "" : ", ") + it.key();
            bad_path(path, "there is no '" + printable(step.text) + "'; there are " + keys);
        }
        above = step.text;
        at = &(*at)[step.text];
    }
    if (above == "operations" && at->is_array() && value.is_array()) return put_in_order(*at, value, path);
    *at = value;
}

} // namespace facetmill
