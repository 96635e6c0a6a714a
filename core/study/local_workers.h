// Candidates worked on by processes: on this machine, or on another one that sees the same folder.
#pragma once

#include "core/study/study_run.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace facetmill {

/// A worker prints one line where it fails: { "error": { "code", "where", "what", "remedy" } }.
std::string worker_error_line(const Error& error);

struct StudyWorkers {
    std::size_t count = 1; ///< at once
    std::filesystem::path program;
    /// The words after the program's name for a look at a candidate.
    std::function<std::vector<std::string>(const StudyWork&)> arguments;
    /// True where a worker that ended with this status and said nothing was ended from without; throws where
    /// that tells something of them all; may be empty.
    std::function<bool(int status)> judge_status = nullptr;
    /// Told of each look that is over, also where it was lost; may be empty.
    std::function<void(const StudyWork&)> ended = nullptr;
};

/// Processes of `program`, which is facetmill-cli, on this machine, `count` at once, with so many threads
/// each.
StudyWorkers own_workers(const StudyFolder& folder, const std::filesystem::path& program, std::size_t count,
                         std::size_t threads);

/// One that was ended from without is asked again, five times in all; one that crashed once more. What it is
/// asked next for is another process, so that a crash costs its candidate alone. Throws the error of a worker
/// that speaks of more than its candidate: of the disk, of the folder, of another version; and where a worker
/// cannot be started.
StudyEngine work_by_processes(const StudyWorkers& workers);

} // namespace facetmill
