#include "core/base/units.h"

#include "core/base/error.h"
#include "core/base/vec.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace facetmill {

std::string_view unit_name(LengthUnit unit) {
    return unit_names().at(std::size_t(unit));
}

const std::vector<std::string>& unit_names() {
    static const std::vector<std::string> names{"mm", "in", "cm", "m", "ft"};
    return names;
}

LengthUnit parse_length_unit(std::string_view text, const std::string& where) {
    if (text == "mm" || text == "millimetre" || text == "millimetres") return LengthUnit::mm;
    if (text == "in" || text == "inch" || text == "inches") return LengthUnit::inch;
    throw Error(ErrorCode::out_of_range, where, "unknown unit '" + printable(text) + "'", "use mm or in");
}

LengthUnit parse_mesh_unit(std::string_view text, const std::string& where) {
    for (const LengthUnit unit : mesh_units)
        if (text == unit_name(unit)) return unit;
    try {
        return parse_length_unit(text, where);
    } catch (const Error& e) {
        throw Error(e.code(), where, e.message(), "use mm, cm, m, in or ft");
    }
}

double core_per_edge(Quantity quantity, LengthUnit unit) {
    switch (quantity) {
    case Quantity::length:
    case Quantity::feed:
        return mm_per(unit);
    case Quantity::area:
        return mm_per(unit) * mm_per(unit);
    case Quantity::angle:
        return pi / 180.0;
    default:
        return 1.0;
    }
}

std::string_view edge_unit_name(Quantity quantity, LengthUnit unit) {
    static constexpr std::array<std::string_view, 5> areas{"mm²", "in²", "cm²", "m²", "ft²"},
        feeds{"mm/min", "in/min", "cm/min", "m/min", "ft/min"};
    switch (quantity) {
    case Quantity::length:
        return unit_name(unit);
    case Quantity::area:
        return areas.at(std::size_t(unit));
    case Quantity::angle:
        return "°";
    case Quantity::feed:
        return feeds.at(std::size_t(unit));
    case Quantity::rotation:
        return "rpm";
    case Quantity::time:
        return "s";
    case Quantity::none:
    case Quantity::ratio:
    case Quantity::count:
        return "";
    }
    return "";
}

double round_down(double v) {
    const double power = std::pow(10.0, std::floor(std::log10(v) + 1e-9));
    for (double step : {5.0, 2.0})
        if (v >= step * power * (1 - 1e-9)) return step * power;
    return power;
}

std::string format_number(double value, int digits) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (value == 0.0) return "0";
    const double magnitude = std::abs(value);
    const int before = int(std::floor(std::log10(magnitude))) + 1;
    char buffer[64];
    if (before > 15 || before < -8) {
        const auto r =
            std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, digits - 1);
        return std::string(buffer, r.ptr);
    }
    const int decimals = std::max(0, digits - before);
    const auto r = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
    std::string text(buffer, r.ptr);
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0')
            text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string area_text(double mm2, LengthUnit unit, int digits) {
    return format_number(mm2 / core_per_edge(Quantity::area, unit), digits) + " "
           + std::string(edge_unit_name(Quantity::area, unit));
}

std::string length_text(double mm, LengthUnit unit, int digits) {
    // What is less was not measured, and is nothing that a machine could do.
    const double least = unit == LengthUnit::mm ? 1e-4 : 1e-5, nothing = 1e-9;
    const double value = mm / mm_per(unit);
    const std::string name = " " + std::string(unit_name(unit));
    if (std::abs(value) < nothing) return "0" + name;
    if (std::abs(value) < least) return (value > 0 ? "< " : "> -") + format_number(least) + name;
    return format_number(value, digits) + name;
}

std::string duration_text(double seconds) {
    if (!std::isfinite(seconds) || seconds < 0) return "\u2013";
    if (seconds < 9.95) {
        char digits[8];
        const auto end =
            std::to_chars(digits, digits + sizeof digits, seconds, std::chars_format::fixed, 1).ptr;
        return std::string(digits, end) + " s";
    }
    const auto whole = std::llround(seconds);
    const auto two = [](long long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string(whole / 60) + " min " + two(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + two(whole % 3600 / 60) + " min";
}

bool parse_number(std::string_view text, double& value) {
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
        if (!text.empty() && text.front() == '-') return false;
    }
    if (text.empty()) return false;
    const char c = text.front() == '-' && text.size() > 1 ? text[1] : text.front();
    if (!(c == '.' || (c >= '0' && c <= '9'))) return false; // keeps "inf" and "nan" out
    double parsed = 0.0;
    const auto r = std::from_chars(text.data(), text.data() + text.size(), parsed);
    if (r.ec != std::errc() || r.ptr != text.data() + text.size() || !std::isfinite(parsed)) return false;
    value = parsed;
    return true;
}

} // namespace facetmill
