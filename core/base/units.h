// Units at the edges of the program. Inside, lengths are millimetres and angles radians.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// Projects, forms and programs are in mm or inch; the numbers of a mesh file may be in any of them.
enum class LengthUnit { mm, inch, cm, m, ft };

/// In the order in which one is asked to choose.
inline constexpr std::array mesh_units{LengthUnit::mm, LengthUnit::cm, LengthUnit::m, LengthUnit::inch,
                                       LengthUnit::ft};

inline constexpr double mm_per_inch = 25.4;

inline constexpr double mm_per(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::inch:
        return mm_per_inch;
    case LengthUnit::cm:
        return 10;
    case LengthUnit::m:
        return 1000;
    case LengthUnit::ft:
        return 12 * mm_per_inch;
    case LengthUnit::mm:
        break;
    }
    return 1.0;
}
/// "mm", "in", "cm", "m" or "ft".
std::string_view unit_name(LengthUnit unit);
/// Names of all of them, in the order of the enumerators.
const std::vector<std::string>& unit_names();
/// The unit of a project around a mesh whose numbers are in `unit`: inches for inches and feet, else mm.
inline constexpr LengthUnit project_unit(LengthUnit unit) {
    return unit == LengthUnit::inch || unit == LengthUnit::ft ? LengthUnit::inch : LengthUnit::mm;
}
/// From "mm" or "in" (also "inch", "inches", "millimetre(s)"); throws Error(out_of_range) that names `where`.
LengthUnit parse_length_unit(std::string_view text, const std::string& where);
/// The same from the name of any unit, for the numbers of a mesh file.
LengthUnit parse_mesh_unit(std::string_view text, const std::string& where);

/// What a number measures: decides its unit in files and forms.
enum class Quantity { none, length, area, angle, feed, rotation, ratio, count, time };

/// Factor from the unit of the edge (project length unit, degrees, length/min, rpm, s) to the core's unit
/// (mm, radians, mm/min, rpm, s): core = edge * factor.
double core_per_edge(Quantity quantity, LengthUnit unit);
/// Name of the edge's unit for labels: "mm", "in", "°", "mm/min", "in/min", "rpm", "s", "".
std::string_view edge_unit_name(Quantity quantity, LengthUnit unit);

/// Largest of 1, 2, 5 times a power of ten that is not above v > 0.
double round_down(double v);

/// Shortest decimal text that reads back to within `digits` significant digits; never an exponent for
/// ordinary sizes,
/// '.' as decimal point whatever the locale.
std::string format_number(double value, int digits = 6);

/// A length of `mm` as a message shows it in `unit`: "1.143 mm", "0.045 in".
std::string length_text(double mm, LengthUnit unit, int digits = 4);
/// The same of an area: "1.143 mm²", "0.045 in²".
std::string area_text(double mm2, LengthUnit unit, int digits = 4);

/// "0.4 s", "12 s", "3 min 20 s", "1 h 05 min"; a dash for what is no duration.
std::string duration_text(double seconds);

/// Strict decimal number over the whole text ('.' only, no hexadecimal, no inf or nan, locale independent).
bool parse_number(std::string_view text, double& value);

} // namespace facetmill
