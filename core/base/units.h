// Units at the edges of the program. Inside, lengths are millimetres and angles radians.
#pragma once

#include <string>
#include <string_view>

namespace facetmill {

enum class LengthUnit { mm, inch };

inline constexpr double mm_per_inch = 25.4;

inline constexpr double mm_per(LengthUnit unit) {
    return unit == LengthUnit::inch ? mm_per_inch : 1.0;
}
/// "mm" or "in".
std::string_view unit_name(LengthUnit unit);
/// From "mm" or "in" (also "inch", "inches", "millimetre(s)"); throws Error(out_of_range) that names `where`.
LengthUnit parse_length_unit(std::string_view text, const std::string& where);

/// What a number measures: decides its unit in files and forms.
enum class Quantity { none, length, area, angle, feed, rotation, ratio, count, time };

/// Factor from the unit of the edge (project length unit, degrees, length/min, rpm, s) to the core's unit
/// (mm, radians, mm/min, rpm, s): core = edge * factor.
double core_per_edge(Quantity quantity, LengthUnit unit);
/// Name of the edge's unit for labels: "mm", "in", "°", "mm/min", "in/min", "rpm", "s", "".
std::string_view edge_unit_name(Quantity quantity, LengthUnit unit);

/// Shortest decimal text that reads back to within `digits` significant digits; never an exponent for
/// ordinary sizes,
/// '.' as decimal point whatever the locale.
std::string format_number(double value, int digits = 6);

/// A length of `mm` as a message shows it in `unit`: "1.143 mm", "0.045 in".
std::string length_text(double mm, LengthUnit unit, int digits = 4);

/// "0.4 s", "12 s", "3 min 20 s", "1 h 05 min"; a dash for what is no duration.
std::string duration_text(double seconds);

/// Strict decimal number over the whole text ('.' only, no hexadecimal, no inf or nan, locale independent).
bool parse_number(std::string_view text, double& value);

} // namespace facetmill
