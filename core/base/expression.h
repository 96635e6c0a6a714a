// Arithmetic as people type it into a field: "25.4/2", "1 1/4 in", "3 mm + 1/8 in", "= stock.x / 2".
#pragma once

#include "core/base/units.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// Lengths that a project knows by name, mm.
struct NamedLength {
    std::string name; ///< "stock.x"
    double value = 0;
};
using NamedLengths = std::vector<NamedLength>;

/// The value of an expression in the core's unit of `quantity` (mm, radians, mm/min ...). Numbers, + - * /,
/// brackets, fractions behind a whole number ("1 1/4"), units behind a product ("1/4 in", "3 mm * 2"), names;
/// an equals sign before it changes nothing. What has no unit and is no multiple of a named length counts in
/// the unit that the field has in a project of `unit`. Throws Error(wrong_type) that says what is wrong at
/// what place, with `where` for its place.
double evaluate(std::string_view text, Quantity quantity, LengthUnit unit, const NamedLengths& names,
                const std::string& where);

} // namespace facetmill
