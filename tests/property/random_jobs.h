// Random jobs: dirty meshes of several forms, and projects whose every parameter may have any value of its
// range. A seed stands for one job, on every machine.
#pragma once

#include "core/job/project.h"

#include <cstdint>
#include <filesystem>

namespace facetmill::test {

/// Writes the part beside the project, into `folder`. Whether the project is valid is for check_project to
/// say. `stamp` becomes another number where the seed stands for another job than it did: one more number was
/// drawn, or another kind of operation.
Project random_job(std::uint64_t seed, const std::filesystem::path& folder, std::uint64_t* stamp = nullptr);

} // namespace facetmill::test
