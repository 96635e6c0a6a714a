#include "core/base/parameter_json.h"

#include "core/base/text.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

using namespace strict;

namespace {

/// In core units. A limit that is not a round number in the file's unit was rounded when it was written: what
/// is beyond the limit by no more than that is the limit.
double read_number(const Json& value, const ParameterInfo& info, LengthUnit unit) {
    const double v = value.get<double>() * info.scale(unit);
    for (double limit : {info.minimum, info.maximum})
        if (std::isfinite(limit) && std::abs(v - limit) <= tolerance::written_number * std::abs(limit))
            return limit;
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

/// Hands the checked value of every member of `object` to `take`, with its place among `described`. Keys of
/// `own` are passed over.
template <class Take>
void read_members(const Json& object, const std::string& place,
                  const std::vector<const ParameterInfo*>& described, LengthUnit unit,
                  const std::vector<std::string>& own, const Take& take) {
    expect_object(object, place);
    for (const ParameterInfo* info : described)
        if (!info->required.empty()) require(object, place, info->key, info->required);
    for (auto it = object.begin(); it != object.end(); ++it) {
        const std::string& key = it.key();
        if (std::find(own.begin(), own.end(), key) != own.end()) continue;
        const auto found = std::find_if(described.begin(), described.end(),
                                        [&](const ParameterInfo* p) { return p->key == key; });
        if (found == described.end()) {
            std::vector<std::string> known = own;
            for (const ParameterInfo* p : described)
                known.push_back(p->key);
            unknown_key(key, place, known);
        }
        const std::string at = member(place, key);
        const ParameterValue value = read_value(*it, **found, at, unit);
        try {
            (*found)->check(value, unit);
            take(std::size_t(found - described.begin()), value);
        } catch (const Error& e) {
            throw Error(e.code(), at, e.message(), e.remedy());
        }
    }
}

std::vector<ParameterValue> read_record(const Json& object,
                                        const std::vector<const ParameterInfo*>& described,
                                        const std::string& place, LengthUnit unit) {
    std::vector<ParameterValue> values;
    for (const ParameterInfo* info : described)
        values.push_back(info->default_value);
    read_members(object, place, described, unit, {},
                 [&](std::size_t k, const ParameterValue& value) { values[k] = value; });
    return values;
}

} // namespace

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
    case ParameterKind::names:
        return read_text(value, place);
    case ParameterKind::pair:
        return read_numbers<2>(value, info, place, unit);
    case ParameterKind::triple:
        return read_numbers<3>(value, info, place, unit);
    case ParameterKind::records: {
        ParameterRecords records;
        const Json& list = expect_list(value, place);
        for (std::size_t i = 0; i < list.size(); ++i)
            records.all.push_back(read_record(list[i], info.record, element(place, i), unit));
        return records;
    }
    }
    throw Error(ErrorCode::internal, place, "unknown kind of parameter", "report this");
}

void read_parameters(const Json& object, const std::string& place, Parameterized& target, LengthUnit unit,
                     const std::vector<std::string>& own) {
    const auto described = target.parameters();
    read_members(object, place, described, unit, own,
                 [&](std::size_t k, const ParameterValue& value) { target.set(described[k]->key, value); });
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
    if (const auto* s = std::get_if<std::string>(&value)) {
        check_text(*s, place); // what is written can be read again
        return *s;
    }
    if (const auto* p = std::get_if<std::array<double, 2>>(&value)) return numbers(*p);
    if (const auto* t = std::get_if<std::array<double, 3>>(&value)) return numbers(*t);
    Json list = Json::array();
    for (const auto& record : std::get<ParameterRecords>(value).all) {
        const std::string here = element(place, list.size());
        Json object = Json::object();
        for (std::size_t k = 0; k < info.record.size(); ++k) {
            const ParameterInfo& field = *info.record[k];
            if (field.default_unwritten && record.at(k) == field.default_value) continue;
            object[field.key] = write_value(record.at(k), field, member(here, field.key), unit);
        }
        list.push_back(std::move(object));
    }
    return list;
}

void write_parameter(Json& object, const std::string& place, const Parameterized& source,
                     const ParameterInfo& info, LengthUnit unit) {
    if (info.default_unwritten && source.get(info.key) == info.default_value) return;
    Json value = write_value(source.get(info.key), info, member(place, info.key), unit);
    if (info.kind == ParameterKind::records && value.empty() && !info.written_empty) return;
    object[info.key] = std::move(value);
}

void write_parameters(Json& object, const std::string& place, const Parameterized& source, LengthUnit unit) {
    for (const ParameterInfo* info : source.parameters())
        write_parameter(object, place, source, *info, unit);
}

} // namespace facetmill
