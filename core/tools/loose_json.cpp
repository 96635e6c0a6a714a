#include "core/tools/loose_json.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/vec.h"
#include "core/setup/tool.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace facetmill {

namespace {

constexpr std::size_t longest_text = 1000;
constexpr double max_counted = 1e6;

const Json& nothing() {
    static const Json empty = Json::object();
    return empty;
}

/// "1/4", "0.25", "1 1/4": the value and what stands behind it.
struct Measured {
    double value;
    std::string unit;
};
std::optional<Measured> measured(std::string_view text) {
    const std::string all(trimmed(text));
    const std::size_t end = std::min(all.find_first_not_of("0123456789+-.eE/ "), all.size());
    std::string figures(trimmed(std::string_view(all).substr(0, end)));
    // An exponent's letter and the first one of a unit look alike.
    std::string unit(trimmed(std::string_view(all).substr(end)));
    while (!figures.empty() && (figures.back() == 'e' || figures.back() == 'E')) {
        unit.insert(unit.begin(), figures.back());
        figures = std::string(trimmed(figures.substr(0, figures.size() - 1)));
    }
    double whole = 0;
    if (const std::size_t slash = figures.find('/'); slash != std::string::npos) {
        double above = 0, below = 0;
        std::string first = figures.substr(0, slash);
        if (const std::size_t gap = first.rfind(' '); gap != std::string::npos) {
            if (!parse_number(trimmed(first.substr(0, gap)), whole)) return std::nullopt;
            first = first.substr(gap + 1);
        }
        if (!parse_number(trimmed(first), above) || !parse_number(trimmed(figures.substr(slash + 1)), below)
            || below == 0)
            return std::nullopt;
        return Measured{whole + above / below, unit};
    }
    if (!parse_number(figures, whole)) return std::nullopt;
    return Measured{whole, unit};
}

std::optional<Measured> measured(const Json* value, const std::string& place) {
    if (!value || value->is_null()) return std::nullopt;
    if (value->is_number()) return Measured{value->get<double>(), {}};
    if (!value->is_string()) strict::wrong_type(place, *value, "a number");
    const std::string& text = value->get_ref<const std::string&>();
    if (trimmed(text).empty()) return std::nullopt;
    const auto read = measured(text);
    if (!read) strict::wrong_type(place, *value, "a number");
    return read;
}

bool says_nothing(const Json& value) {
    if (value.is_null() || value.empty()) return true;
    if (value.is_boolean()) return !value.get<bool>();
    if (value.is_number()) return value.get<double>() == 0;
    if (value.is_string()) return value.get_ref<const std::string&>().empty();
    return std::all_of(value.begin(), value.end(), [](const Json& v) { return says_nothing(v); });
}

} // namespace

LooseObject::LooseObject(const Json& object, std::string place)
    : object_(object.is_object() ? &object : &nothing()), place_(std::move(place)) {}

const Json* LooseObject::find(const std::string& key) const {
    const auto at = object_->find(key);
    return at == object_->end() ? nullptr : &*at;
}

const Json* LooseObject::take(const std::string& key) {
    taken_.insert(key);
    return find(key);
}

std::string LooseObject::place_of(const std::string& key) const {
    return strict::member(place_, key);
}

std::optional<double> LooseObject::length(const std::string& key, LengthUnit unit) {
    const auto read = measured(take(key), place_of(key));
    if (!read) return std::nullopt;
    if (read->unit == "\"") return read->value * mm_per_inch;
    if (read->unit == "µm" || read->unit == "μm" || read->unit == "um") return read->value * 1e-3;
    return read->value * mm_per(read->unit.empty() ? unit : parse_mesh_unit(read->unit, place_of(key)));
}

std::optional<double> LooseObject::angle(const std::string& key) {
    const auto read = measured(take(key), place_of(key));
    if (!read) return std::nullopt;
    return read->unit == "rad" ? read->value : radians(read->value);
}

std::optional<double> LooseObject::number(const std::string& key) {
    const auto read = measured(take(key), place_of(key));
    return read ? std::optional(read->value) : std::nullopt;
}

long LooseObject::count(const std::string& key) {
    return long(std::clamp(number(key).value_or(0), 0.0, max_counted));
}

long LooseObject::tool_number(const std::string& key, long otherwise) {
    return as_tool_number(number(key).value_or(double(otherwise)));
}

long as_tool_number(double number) {
    return long(std::clamp(number, 1.0, double(largest_tool_number)));
}

std::string LooseObject::text(const std::string& key) {
    const Json* value = take(key);
    if (!value || value->is_null() || value->is_structured()) return {};
    if (value->is_string()) return printable(value->get_ref<const std::string&>(), longest_text);
    return value->dump();
}

LooseObject LooseObject::object(const std::string& key) {
    const Json* value = take(key);
    return LooseObject(value ? *value : nothing(), place_of(key));
}

std::vector<LooseObject> LooseObject::objects(const std::string& key) {
    std::vector<LooseObject> all;
    const Json* value = take(key);
    if (value && value->is_array())
        for (std::size_t i = 0; i < value->size(); ++i)
            all.emplace_back((*value)[i], strict::element(place_of(key), i));
    return all;
}

void LooseObject::drop(std::initializer_list<const char*> keys) {
    taken_.insert(keys.begin(), keys.end());
}

std::vector<std::string> LooseObject::left() const {
    std::vector<std::string> keys;
    for (auto it = object_->begin(); it != object_->end(); ++it)
        if (!taken_.contains(it.key()) && !says_nothing(*it)) keys.push_back(place_of(it.key()));
    return keys;
}

} // namespace facetmill
