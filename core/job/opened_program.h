// A program from a file, shown, played back and verified in place of a plan.
#pragma once

#include "core/job/planner.h"
#include "core/output/post/post.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facetmill {

struct OpenedProgram {
    std::string name; ///< of the file, "a.apt", or "a.apt and 2 more"
    std::vector<std::filesystem::path> files;
    std::vector<VerifyProgram> programs; ///< in machining order
    /// One for each: its section of the file and what it takes. Their paths are empty.
    std::vector<std::shared_ptr<const OperationResult>> operations;
    std::vector<Tool> tools; ///< one for each, to be shown: the project's, or what the file's cutter is
    std::vector<std::string> ignored; ///< statements that were read over
    std::vector<std::string> remarks; ///< one sentence each: what is not known of shanks and holders
};

/// Reads CL files that run one after the other. Throws what read_verify_programs does (verification.h).
OpenedProgram open_program(const Project& project, const std::vector<std::filesystem::path>& files,
                           const Progress& progress);
/// The same for programs of a control, as it runs them. Throws what read_posted does (posting.h).
OpenedProgram open_posted(const Project& project, const PreparedPart& part, const Post& post,
                          const std::vector<std::filesystem::path>& files, const Progress& progress);

} // namespace facetmill
