// Project files of older versions: one step per version, applied in order until the file is of today's.
#pragma once

#include "core/base/strict_json.h"

namespace facetmill {

/// Brings `file` (an object) to `project_version`. Throws Error(missing_key, wrong_type, out_of_range,
/// newer_version) whose place is "facetmill".
void migrate_project(Json& file);

} // namespace facetmill
