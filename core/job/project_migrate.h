// Project files of older versions: one step per version, applied in order until the file is of one that is
// read.
#pragma once

#include "core/base/strict_json.h"

namespace facetmill {

/// Brings `file` (an object) to a version that is read, which it returns: `single_setup_version` or a newer
/// one. Throws Error(missing_key, wrong_type, out_of_range,
/// newer_version) whose place is "facetmill".
long migrate_project(Json& file);

} // namespace facetmill
