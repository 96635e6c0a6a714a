#include "core/base/parameter.h"

#include "core/base/parameter_json.h"
#include "core/base/text.h"

#include <cmath>
#include <numeric>

namespace facetmill {

namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const auto& w : words)
        text += (text.empty() ? "" : ", ") + w;
    return text;
}

std::string with_unit(double core_value, const ParameterInfo& info, LengthUnit unit) {
    const std::string_view u = edge_unit_name(info.quantity, unit);
    return format_number(core_value / info.scale(unit)) + (u.empty() ? "" : " ") + std::string(u);
}

/// A bound that is no round number of inches, as 1000 mm are none, by three digits within the range. What is
/// the same number in mm, a count or an angle for example, stays as it is.
double round_bound(double core_value, bool upper, const ParameterInfo& info, LengthUnit unit) {
    constexpr double digits = 100, same = 1e-9;
    const double bound = core_value / info.scale(unit);
    if (info.scale(unit) == info.scale(LengthUnit::mm) || bound == 0 || !std::isfinite(bound))
        return core_value;
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(bound)) + same)) / digits;
    const double steps = bound / step;
    if (std::abs(steps - std::round(steps)) < same * std::abs(steps)) return core_value;
    return (upper ? std::floor(steps) : std::ceil(steps)) * step * info.scale(unit);
}

void check_number(double v, const ParameterInfo& info, LengthUnit unit) {
    if (!std::isfinite(v))
        throw Error(ErrorCode::out_of_range, info.key, "the value is not a finite number", "enter a number");
    const bool low = info.open_minimum ? v <= info.minimum : v < info.minimum;
    if (low || v > info.maximum)
        throw Error(ErrorCode::out_of_range, info.key,
                    "the value " + with_unit(v, info, unit) + " is out of range",
                    "allowed: " + info.range_text(unit));
}

[[noreturn]] void other_type(const ParameterInfo& info) {
    std::string expected;
    switch (info.kind) {
    case ParameterKind::number:
        expected = "a number";
        break;
    case ParameterKind::number_or_word:
        expected = "a number or one of: " + joined(info.words);
        break;
    case ParameterKind::integer:
        expected = "a whole number";
        break;
    case ParameterKind::boolean:
        expected = "true or false";
        break;
    case ParameterKind::choice:
        expected = "one of: " + joined(info.words);
        break;
    case ParameterKind::text:
        expected = "text";
        break;
    case ParameterKind::names:
        expected = "names, separated by commas";
        break;
    case ParameterKind::records:
        expected = "a list";
        break;
    case ParameterKind::pair:
        expected = "two numbers";
        break;
    case ParameterKind::triple:
        expected = "three numbers";
        break;
    }
    throw Error(ErrorCode::wrong_type, info.key, "the value has the wrong type", "expected " + expected);
}

void check_word(const std::string& word, const ParameterInfo& info) {
    if (std::find(info.words.begin(), info.words.end(), word) == info.words.end())
        throw Error(ErrorCode::out_of_range, info.key, "unknown value '" + printable(word) + "'",
                    (info.kind == ParameterKind::number_or_word ? "use a number or one of: " : "use one of: ")
                        + joined(info.words));
}

template <std::size_t N>
std::array<double, N> parse_numbers(std::string_view text, const ParameterInfo& info, double factor) {
    text = trimmed(text);
    if (text.size() >= 2 && text.front() == '[' && text.back() == ']') text = text.substr(1, text.size() - 2);
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) {
        const std::size_t comma = text.find(',');
        if ((comma == std::string_view::npos) != (i + 1 == N)) other_type(info);
        if (!parse_number(trimmed(text.substr(0, comma)), numbers[i])) other_type(info);
        numbers[i] *= factor;
        if (i + 1 < N) text.remove_prefix(comma + 1);
    }
    return numbers;
}

void check_records(const ParameterRecords& records, const ParameterInfo& info, LengthUnit unit) {
    for (std::size_t i = 0; i < records.all.size(); ++i) {
        const auto& values = records.all[i];
        const std::string place = strict::element(info.key, i);
        if (values.size() != info.record.size())
            throw Error(ErrorCode::wrong_type, place,
                        "the record has " + std::to_string(values.size()) + " values",
                        "give it " + std::to_string(info.record.size()));
        for (std::size_t k = 0; k < values.size(); ++k) {
            try {
                info.record[k]->check(values[k], unit);
            } catch (const Error& e) {
                throw Error(e.code(), strict::member(place, e.where()), e.message(), e.remedy());
            }
        }
    }
}

} // namespace

bool ParameterRecords::operator==(const ParameterRecords& other) const {
    return all == other.all;
}

void ParameterInfo::check(const ParameterValue& value, LengthUnit unit) const {
    switch (kind) {
    case ParameterKind::number:
        if (!std::holds_alternative<double>(value)) other_type(*this);
        check_number(std::get<double>(value), *this, unit);
        return;
    case ParameterKind::number_or_word:
        if (const auto* d = std::get_if<double>(&value))
            check_number(*d, *this, unit);
        else if (const auto* s = std::get_if<std::string>(&value))
            check_word(*s, *this);
        else
            other_type(*this);
        return;
    case ParameterKind::integer:
        if (!std::holds_alternative<long>(value)) other_type(*this);
        check_number(double(std::get<long>(value)), *this, unit);
        return;
    case ParameterKind::boolean:
        if (!std::holds_alternative<bool>(value)) other_type(*this);
        return;
    case ParameterKind::choice:
        if (!std::holds_alternative<std::string>(value)) other_type(*this);
        check_word(std::get<std::string>(value), *this);
        return;
    case ParameterKind::text:
    case ParameterKind::names:
        if (!std::holds_alternative<std::string>(value)) other_type(*this);
        check_text(std::get<std::string>(value), key);
        return;
    case ParameterKind::pair: {
        const auto* p = std::get_if<std::array<double, 2>>(&value);
        if (!p) other_type(*this);
        for (double v : *p)
            check_number(v, *this, unit);
        if (ordered && !((*p)[0] < (*p)[1]))
            throw Error(ErrorCode::out_of_range, key,
                        "the limits " + value_text(value, unit) + " are reversed or equal",
                        "the first must be below the second");
        return;
    }
    case ParameterKind::triple: {
        const auto* p = std::get_if<std::array<double, 3>>(&value);
        if (!p) other_type(*this);
        for (double v : *p)
            check_number(v, *this, unit);
        return;
    }
    case ParameterKind::records:
        if (!std::holds_alternative<ParameterRecords>(value)) other_type(*this);
        check_records(std::get<ParameterRecords>(value), *this, unit);
        return;
    }
}

std::string ParameterInfo::range_text(LengthUnit unit) const {
    const bool low = std::isfinite(minimum), high = std::isfinite(maximum);
    if (!low && !high) return {};
    const double least = round_bound(minimum, false, *this, unit),
                 most = round_bound(maximum, true, *this, unit);
    if (low && high && !open_minimum)
        return format_number(least / scale(unit)) + " to " + with_unit(most, *this, unit);
    if (low && high)
        return "above " + with_unit(least, *this, unit) + " and at most " + with_unit(most, *this, unit);
    if (high) return "at most " + with_unit(most, *this, unit);
    return std::string(open_minimum ? "above " : "at least ") + with_unit(least, *this, unit);
}

std::string ParameterInfo::value_text(const ParameterValue& value, LengthUnit unit) const {
    const auto number = [&](double v) { return format_number(v / scale(unit), 12); };
    if (const auto* d = std::get_if<double>(&value)) return number(*d);
    if (const auto* i = std::get_if<long>(&value)) return std::to_string(*i);
    if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
    if (const auto* s = std::get_if<std::string>(&value)) return *s;
    if (const auto* p = std::get_if<std::array<double, 2>>(&value))
        return number((*p)[0]) + ", " + number((*p)[1]);
    if (std::holds_alternative<ParameterRecords>(value)) return write_value(value, *this, key, unit).dump();
    const auto& t = std::get<std::array<double, 3>>(value);
    return number(t[0]) + ", " + number(t[1]) + ", " + number(t[2]);
}

std::string ParameterInfo::count_text(const ParameterValue& value) const {
    const auto* list = std::get_if<ParameterRecords>(&value);
    const std::size_t n = list ? list->all.size() : listed_names(std::get<std::string>(value)).size();
    return n == 0 ? "none" : std::to_string(n) + " " + nouns[n == 1 ? 0 : 1];
}

ParameterValue ParameterInfo::empty_list() const {
    if (kind == ParameterKind::names) return std::string();
    return ParameterRecords();
}

ParameterValue ParameterInfo::parse(std::string_view text, LengthUnit unit) const {
    ParameterValue value;
    const std::string_view t = trimmed(text);
    double d = 0.0;
    switch (kind) {
    case ParameterKind::number:
        if (!parse_number(t, d)) other_type(*this);
        value = d * scale(unit);
        break;
    case ParameterKind::number_or_word:
        if (parse_number(t, d))
            value = d * scale(unit);
        else
            value = std::string(t);
        break;
    case ParameterKind::integer:
        if (!parse_number(t, d) || d != std::floor(d) || std::abs(d) > 9e15) other_type(*this);
        value = long(d);
        break;
    case ParameterKind::boolean:
        if (t != "true" && t != "false") other_type(*this);
        value = t == "true";
        break;
    case ParameterKind::choice:
        value = std::string(t);
        break;
    case ParameterKind::text:
    case ParameterKind::names:
        value = std::string(text);
        break;
    case ParameterKind::records:
        value = read_value(parse_strict_json(t, key), *this, key, unit);
        break;
    case ParameterKind::pair:
        value = parse_numbers<2>(t, *this, scale(unit));
        break;
    case ParameterKind::triple:
        value = parse_numbers<3>(t, *this, scale(unit));
        break;
    }
    check(value, unit);
    return value;
}

const ParameterInfo& Parameterized::parameter(std::string_view key) const {
    const auto all = parameters();
    for (const auto* p : all)
        if (p->key == key) return *p;
    throw_unknown_key(key, all);
}

bool Parameterized::has(std::string_view key) const {
    const auto all = parameters();
    return std::any_of(all.begin(), all.end(), [&](const ParameterInfo* p) { return p->key == key; });
}

void throw_unknown_key(std::string_view key, const std::vector<const ParameterInfo*>& known) {
    std::vector<std::string> names;
    for (const auto* p : known)
        names.push_back(p->key);
    const std::string near = nearest_name(key, names);
    throw Error(ErrorCode::unknown_key, printable(key), "unknown key",
                near.empty() ? "known keys: " + joined(names) : "did you mean '" + near + "'?");
}

std::vector<std::string> listed_names(const std::string& list) {
    std::vector<std::string> names;
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min(list.find(',', at), list.size());
        const std::size_t first = list.find_first_not_of(' ', at);
        if (first < end) names.push_back(list.substr(first, list.find_last_not_of(' ', end - 1) + 1 - first));
        at = end + 1;
    }
    return names;
}

std::string nearest_name(std::string_view mistyped, const std::vector<std::string>& known) {
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(2, mistyped.size() / 3) + 1;
    if (mistyped.size() > 100) return best;
    // Cut short: "tol" means tolerance, not tool.
    const auto begins = [&](const std::string& name) {
        return mistyped.size() >= 3 && name.starts_with(mistyped);
    };
    if (std::count_if(known.begin(), known.end(), begins) == 1)
        return *std::find_if(known.begin(), known.end(), begins);
    for (const auto& name : known) {
        // Levenshtein distance, one row at a time.
        std::vector<std::size_t> row(name.size() + 1);
        std::iota(row.begin(), row.end(), std::size_t(0));
        for (std::size_t i = 1; i <= mistyped.size(); ++i) {
            std::size_t diagonal = row[0];
            row[0] = i;
            for (std::size_t j = 1; j <= name.size(); ++j) {
                const std::size_t substitute = diagonal + (mistyped[i - 1] != name[j - 1]);
                diagonal = row[j];
                row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
            }
        }
        if (row.back() < best_distance) {
            best_distance = row.back();
            best = name;
        }
    }
    return best;
}

} // namespace facetmill
