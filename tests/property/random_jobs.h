// Random jobs: dirty meshes of several forms, and projects whose every parameter may have any value of its
// range. A seed stands for one job, on every machine.
#pragma once

#include "core/job/project.h"

#include <cstdint>
#include <filesystem>

namespace facetmill::test {

/// Writes the part beside the project, into `folder`. Whether the project is valid is for check_project to
/// say.
Project random_job(std::uint64_t seed, const std::filesystem::path& folder);

} // namespace facetmill::test
