#include "app/cli_project.h"

#include "core/base/error.h"
#include "core/base/parameter.h"
#include "core/job/posting.h"
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

OptionInfo set_option() {
    return {.name = "--set",
            .value = "NAME.key=value",
            .help = "sets a parameter of an operation, of the part (part.smoothing=0.02) or of programs "
                    "(post=grbl), for this run, in the project's units",
            .repeated = true};
}

Project asked_project(const Arguments& arguments) {
    Project project = load_project(arguments.operand(0));
    for (const std::string& setting : arguments.values("--set"))
        apply_setting(project, setting);
    return project;
}

OptionInfo large_option() {
    return {.name = "--yes-large",
            .help = "begins jobs of more than 20 million points, 4 GB or 4 hours by their estimate"};
}

namespace {

void tell_size(const WorkEstimate& estimate, const std::string& remedy, const Arguments& arguments,
               Session& session) {
    if (estimate.large() && !arguments.has("--yes-large"))
        throw Error(ErrorCode::limit_exceeded, estimate.what, "would take " + estimate.text(),
                    remedy + ", or give --yes-large");
    if (estimate.notable()) session.say(estimate.what + " takes " + estimate.text());
}

} // namespace

void tell_work(VerifySettings& settings, const Arguments& arguments, Session& session) {
    settings.before_work = [&](const VerifyWork& work) {
        tell_size(estimate_of(work), "choose a coarser --resolution", arguments, session);
    };
    settings.cannot_verify = [&](const std::string& why) {
        session.say("nothing can be verified, only faults found: " + why);
    };
}

namespace {

PlanWatch plan_watch(const Arguments& arguments, Session& session) {
    return {[&](const WorkEstimate& estimate) {
                tell_size(estimate, "choose a larger tolerance or step-over", arguments, session);
            },
            [&](const OperationResult& o) {
                session.say("operation '" + printable(o.name) + "' has nothing to do: " + o.nothing_to_do);
            }};
}

/// What `work` throws, with the project's file before the place.
template <class Work>
auto within_project(const Project& project, const Arguments& arguments, const Work& work) {
    try {
        return work();
    } catch (const Error& e) {
        // The messages of part and stock name their files.
        const auto names = [&](const std::filesystem::path& mesh) {
            return !mesh.empty() && e.where().starts_with(printable(mesh.string(), 400));
        };
        const bool named = names(project.part_path()) || names(project.stock_path());
        throw named ? e : e.within(printable(arguments.operand(0), 400));
    }
}

} // namespace

std::shared_ptr<const PlanResult> plan_project(Planner& planner, const Project& project,
                                               const std::string& only_operation, const Arguments& arguments,
                                               Session& session, const Progress& progress) {
    return within_project(project, arguments, [&] {
        return checked_planning(plan_watch(arguments, session))(planner, project, only_operation, progress);
    });
}

std::vector<SetupPlan> plan_all(SetupPlanners& planners, const Project& project,
                                const std::string& only_operation, const Arguments& arguments,
                                Session& session, const Progress& progress) {
    return within_project(project, arguments, [&] {
        return plan_setups(project, only_operation, planners, progress,
                           checked_planning(plan_watch(arguments, session)));
    });
}

PlannedJob plan_whole(SetupPlanners& planners, const Project& project, const std::string& only_operation,
                      const Arguments& arguments, Session& session, const Progress& progress) {
    return within_project(project, arguments, [&] {
        return plan_job(project, only_operation, planners, plan_watch(arguments, session), Reach::within,
                        progress);
    });
}

OptionInfo setup_option() {
    return {
        .name = "--setup", .value = "NAME", .help = "the setup that is meant, where the project has several"};
}

Project asked_setup(const Arguments& arguments, const Project& project, bool needed) {
    if (arguments.has("--setup"))
        return view_of_setup(project, find_setup(project, arguments.value("--setup")));
    if (setup_count(project) == 1) return project;
    if (needed) {
        std::string names;
        for (std::size_t i = 0; i < setup_count(project); ++i)
            names += (i > 0 ? ", " : "") + printable(setup_at(project, i).name);
        throw Error(ErrorCode::usage, "--setup",
                    "the project has several setups, and programs are those of one", "name one of: " + names);
    }
    return view_of_setup(project, setup_of_operation(project, arguments.value("--op")));
}

Planner& ready_planner(SetupPlanners& planners, const Project& project, const Arguments& arguments,
                       Session& session, const Progress& progress) {
    Planner& planner = planners.at(chosen_setup(project));
    planner.carry(within_project(project, arguments, [&] {
        return stock_before(project, planners, progress, checked_planning(plan_watch(arguments, session)));
    }));
    return planner;
}

OptionInfo nc_option() {
    return {.name = "--nc",
            .value = "FILE[,FILE]",
            .help = "reads these programs of a control back, in order, instead of a plan",
            .repeated = true};
}

OptionInfo post_option() {
    return {.name = "--post",
            .value = "NAME",
            .help = "the control they are for, by name or file (default: the project's)"};
}

std::vector<std::filesystem::path> posted_files(const Arguments& arguments) {
    std::vector<std::filesystem::path> files;
    for (const std::string& value : arguments.values("--nc"))
        for (const std::string& name : listed_names(value))
            files.emplace_back(name);
    if (!files.empty() && (arguments.has("--op") || arguments.has("--cl")))
        throw Error(ErrorCode::usage, "--nc", "posted programs are taken instead of a plan or CL files",
                    "give --nc alone");
    if (files.empty() && arguments.has("--post"))
        throw Error(ErrorCode::usage, "--post", "there is no program for it to read", "give --nc FILE");
    return files;
}

Post asked_post(const Arguments& arguments, const Project& project) {
    const std::string name = arguments.has("--post") ? arguments.value("--post") : project.programs.post;
    if (name.empty())
        throw Error(ErrorCode::usage, "--nc", "neither the project nor the command names a post",
                    "give --post NAME, or `post` in the project");
    return project_post(project, name);
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
