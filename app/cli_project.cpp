#include "app/cli_project.h"

#include "core/base/error.h"

#include <system_error>

namespace facetmill::cli {

void check_folder(const std::filesystem::path& folder) {
    std::error_code ec;
    if (std::filesystem::exists(folder, ec) && !std::filesystem::is_directory(folder, ec))
        throw Error(ErrorCode::unwritable, printable(folder.string(), 400), "is not a folder",
                    "name a folder to write to");
}

std::shared_ptr<const PlanResult> plan_project(Planner& planner, const Project& project,
                                               const std::string& file, const std::string& only_operation,
                                               const Progress& progress) {
    try {
        return planner.plan(project, only_operation, progress);
    } catch (const Error& e) {
        // The part's own messages name their file.
        const bool named = e.where().starts_with(printable(project.part_path().string(), 400));
        throw named ? e : e.within(printable(file, 400));
    }
}

} // namespace facetmill::cli
