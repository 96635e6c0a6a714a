// Described parameters in JSON: project files, and lists on the command line. Lengths are in the file's unit.
#pragma once

#include "core/base/parameter.h"
#include "core/base/strict_json.h"

#include <string>
#include <vector>

namespace facetmill {

/// Reads every member of `object` into the parameter of its name, but for those of the keys `own`, which the
/// caller reads. `place` is the way to the object; errors name it, and what there is to do. Throws
/// Error(wrong_type, out_of_range, unknown_key, missing_key).
void read_parameters(const Json& object, const std::string& place, Parameterized& target, LengthUnit unit,
                     const std::vector<std::string>& own = {});
/// Checks types, of records also keys and values. Throws likewise.
ParameterValue read_value(const Json& value, const ParameterInfo& info, const std::string& place,
                          LengthUnit unit);

/// What reads back as the same value. Throws Error(out_of_range) for a number that is not finite.
Json write_value(const ParameterValue& value, const ParameterInfo& info, const std::string& place,
                 LengthUnit unit);
void write_parameter(Json& object, const std::string& place, const Parameterized& source,
                     const ParameterInfo& info, LengthUnit unit);
/// All of them; a list without records only where its description says so.
void write_parameters(Json& object, const std::string& place, const Parameterized& source, LengthUnit unit);

} // namespace facetmill
