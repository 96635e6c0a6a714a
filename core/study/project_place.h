// Places of a project's file, and other values there. "machine", "stock.margin", "tools[2].diameter" (of the
// tool with that number), "operations[Finish].tolerance" or "operations[1].tolerance" (from 0, as in
// messages), "setups[Top].operations[Finish].direction". What a setup has may be named without it where the
// project has one, and an operation where one setup alone has that name.
#pragma once

#include "core/base/strict_json.h"

#include <string>

namespace facetmill {

/// Puts a value at a place of a project as project_to_json has it. At the place of a list of operations a
/// list of their names puts them into this order. Another `kind` of an operation keeps what that kind has as
/// well, and has the usual values of the rest. Only the way to the place is checked: parse_project checks the
/// value. Throws Error(unknown_key, missing_reference, wrong_type) whose place is `path`.
void set_at(Json& project, const std::string& path, const Json& value);

} // namespace facetmill
