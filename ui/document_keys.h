// What results depend on, as text: equal texts, and what was read or planned is current.
#pragma once

#include "core/job/project.h"

#include <cstddef>
#include <string>

namespace facetmill::ui {

/// Files as they are on disk, units and placements: what the meshes of part and stock depend on; where the
/// stock is a rest, all that it comes from.
std::string part_key(const Project& project);
/// Everything that says how programs are posted, the files of post and machine as they are on disk. Empty
/// without a post.
std::string posting_key(const Project& project);
/// Everything the result of operation `i` depends on; the files of part, stock and machine as they are on
/// disk.
std::string fingerprint(const Project& project, std::size_t i);

} // namespace facetmill::ui
