#include "app/cli_project.h"

#include "core/base/error.h"
#include "core/base/file.h"

#include <charconv>
#include <system_error>

namespace facetmill::cli {

void check_folder(const std::filesystem::path& folder) {
    std::error_code ec;
    if (std::filesystem::exists(folder, ec) && !std::filesystem::is_directory(folder, ec))
        throw Error(ErrorCode::unwritable, printable(folder.string(), 400), "is not a folder",
                    "name a folder to write to");
}

void keep_inputs(const Project& project, const std::string& file, const std::filesystem::path& output) {
    refuse_to_overwrite(file, output);
    refuse_to_overwrite(project.part_path(), output);
    if (!project.stock_path().empty()) refuse_to_overwrite(project.stock_path(), output);
}

std::shared_ptr<const PlanResult> plan_project(Planner& planner, const Project& project,
                                               const std::string& file, const std::string& only_operation,
                                               const Progress& progress) {
    try {
        return planner.plan(project, only_operation, progress);
    } catch (const Error& e) {
        // The messages of part and stock name their files.
        const auto names = [&](const std::filesystem::path& mesh) {
            return !mesh.empty() && e.where().starts_with(printable(mesh.string(), 400));
        };
        const bool named = names(project.part_path()) || names(project.stock_path());
        throw named ? e : e.within(printable(file, 400));
    }
}

std::size_t point_number(const std::string& text) {
    std::size_t number = 0;
    const auto r = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || r.ec != std::errc() || r.ptr != text.data() + text.size())
        throw Error(ErrorCode::usage, "--point", "'" + printable(text, 40) + "' is not a number of a point",
                    "give a whole number from 0");
    return number;
}

} // namespace facetmill::cli
