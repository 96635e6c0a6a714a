#include "app/cli_project.h"

#include "core/base/error.h"
#include "core/job/work_estimate.h"

#include <charconv>
#include <system_error>

namespace facetmill::cli {

void check_folder(const std::filesystem::path& folder) {
    std::error_code ec;
    if (std::filesystem::exists(folder, ec) && !std::filesystem::is_directory(folder, ec))
        throw Error(ErrorCode::unwritable, printable(folder.string(), 400), "is not a folder",
                    "name a folder to write to");
}

OptionInfo large_option() {
    return {.name = "--yes-large",
            .help = "begins jobs of more than 20 million points, 4 GB or 4 hours by their estimate"};
}

namespace {

void tell_size(const WorkEstimate& estimate, const Arguments& arguments, Session& session) {
    if (estimate.large() && !arguments.has("--yes-large"))
        throw Error(ErrorCode::limit_exceeded, estimate.what, "would take " + estimate.text(),
                    "choose a larger tolerance or step-over, or give --yes-large");
    if (estimate.notable()) session.say(estimate.what + " takes " + estimate.text());
}

} // namespace

std::shared_ptr<const PlanResult> plan_project(Planner& planner, const Project& project,
                                               const std::string& only_operation, const Arguments& arguments,
                                               Session& session, const Progress& progress) {
    try {
        check_project(project);
        const auto part = planner.prepare(project, progress.part(0, 0.05));
        for (const WorkEstimate& estimate : estimate_plan(project, *part, only_operation))
            tell_size(estimate, arguments, session);
        auto plan = planner.plan(project, only_operation, progress.part(0.05, 1));
        plan->check_programs();
        for (const auto& o : plan->idle)
            session.say("operation '" + printable(o->name) + "' has nothing to do: " + o->nothing_to_do);
        return plan;
    } catch (const Error& e) {
        // The messages of part and stock name their files.
        const auto names = [&](const std::filesystem::path& mesh) {
            return !mesh.empty() && e.where().starts_with(printable(mesh.string(), 400));
        };
        const bool named = names(project.part_path()) || names(project.stock_path());
        throw named ? e : e.within(printable(arguments.operand(0), 400));
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
