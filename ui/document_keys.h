// What results depend on, as text: equal texts, and what was read or planned is current.
#pragma once

#include "core/job/project.h"

#include <cstddef>
#include <string>

namespace facetmill::ui {

// `file_text` says what a file is (core/job/project.h): as it is on disk, or by its content.

/// Files, units and placements: what the meshes of part and stock depend on; where the
/// stock is a rest, all that it comes from.
std::string part_key(const Project& project);
/// Everything that says how programs are posted, with the files of post and machine. Empty without a post.
std::string posting_key(const Project& project, const FileText& file_text = file_stamp);
/// Everything the result of operation `i` depends on, with the files of part, stock and machine.
std::string fingerprint(const Project& project, std::size_t i, const FileText& file_text = file_stamp);
/// Everything that the verdict on the first `operations` operations depends on.
std::string verdict_source(const Project& project, std::size_t operations, const FileText& file_text);

} // namespace facetmill::ui
