// facetmill-cli study: which settings of a project serve best, each of them planned and verified.
#include "app/cli_commands.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/base/parallel.h"
#include "core/study/local_workers.h"
#include "core/study/slurm.h"
#include "core/study/ssh_workers.h"
#include "core/study/study_results.h"
#include "core/study/study_run.h"
#include "facetmill_version.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <thread>

#include <csignal>
#include <sys/prctl.h>

namespace facetmill::cli {

namespace {

namespace fs = std::filesystem;

std::string study_program() {
    return program_identity("facetmill-cli " FACETMILL_VERSION);
}

std::size_t count_of(const Arguments& arguments, const char* option, std::size_t fallback) {
    constexpr double most = 4096;
    const double n = arguments.number(option, double(fallback));
    if (n != std::floor(n) || n < 1 || n > most)
        throw Error(ErrorCode::usage, option, "'" + printable(arguments.value(option)) + "' is no such count",
                    "write a whole number from 1");
    return std::size_t(n);
}

/// Processes of this program on this machine, or on one that sees the folder and has this program.
StudyWorkers study_workers(const StudyFolder& folder, const Arguments& arguments) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t count = count_of(arguments, "--workers", cores);
    const std::size_t threads = count_of(arguments, "--threads", std::max<std::size_t>(1, cores / count));
    return own_workers(folder, fs::read_symlink("/proc/self/exe"), count, threads);
}

void conclude(const StudyFolder& folder, const StudyOutcome& outcome, Session& session) {
    write_study(folder, outcome, [&] { session.print(study_summary(folder, outcome)); });
    if (!outcome.lost.empty())
        session.say(std::to_string(outcome.lost.size()) + " candidates were lost ("
                    + outcome.lost.begin()->second + "): study resume asks for them again");
    check_winner(folder, outcome);
}

void go_on_by_slurm(const StudyFolder& folder, const Arguments& arguments, Session& session,
                    double patience) {
    SlurmSettings settings;
    settings.patience = patience;
    settings.program = fs::read_symlink("/proc/self/exe");
    settings.threads = count_of(arguments, "--threads", 1);
    if (arguments.has("--workers")) settings.workers = count_of(arguments, "--workers", 1);
    const SlurmRun run = go_on_with_slurm(folder, settings, session.progress());
    if (!run.step) return conclude(folder, run.outcome, session);
    session.print(pretty_json(Json{{"folder", printable(folder.path().string(), 400)},
                                   {"step", run.step->number},
                                   {"looks", run.outcome.decision.missing.size()},
                                   {"array_job", run.step->array},
                                   {"gather_job", run.step->gather}}));
}

void carry_out(const StudyFolder& folder, const Arguments& arguments, Session& session) {
    const std::string on = arguments.value("--on", "local");
    if (on == "slurm") {
        begin_slurm(folder);
        return go_on_by_slurm(folder, arguments, session, 0);
    }
    constexpr std::string_view ssh = "ssh:";
    if (on != "local" && !on.starts_with(ssh))
        throw Error(ErrorCode::usage, "--on", "'" + printable(on) + "' is no place to work",
                    "give local, slurm or ssh:HOST");
    StudyWorkers workers = study_workers(folder, arguments);
    if (on != "local")
        workers = workers_by_ssh(workers, on.substr(ssh.size()), arguments.value("--remote-program", ""));
    conclude(folder, run_study(folder, work_by_processes(workers), session.progress()), session);
}

void run_begin(const Arguments& arguments, Session& session) {
    const fs::path file = arguments.operand(1);
    const fs::path folder = arguments.has("-o") ? fs::path(arguments.value("-o")) : usual_study_folder(file);
    check_folder(folder);
    carry_out(StudyFolder::make(folder, file, study_program()), arguments, session);
}

void run_resume(const Arguments& arguments, Session& session) {
    carry_out(StudyFolder(arguments.operand(1), study_program()), arguments, session);
}

void run_show(const Arguments& arguments, Session& session) {
    const StudyFolder folder(arguments.operand(1), study_program());
    const StudyOutcome outcome = look_at_study(folder, {}, session.progress());
    session.print(study_json(folder, outcome));
}

void run_adopt(const Arguments& arguments, Session& session) {
    const StudyFolder folder(arguments.operand(1), study_program());
    if (!arguments.has("-o"))
        throw Error(ErrorCode::usage, "-o", "is missing", "name the project's file to write");
    const StudyOutcome outcome = look_at_study(folder, {}, session.progress());
    std::size_t number = 0;
    if (arguments.has("--candidate")) {
        constexpr double most = 1e9;
        const double n = arguments.number("--candidate", 0);
        if (n != std::floor(n) || n < 0 || n > most)
            throw Error(ErrorCode::usage, "--candidate", "is no number of a candidate", "see table.md");
        number = std::size_t(n);
    } else {
        if (!outcome.decision.missing.empty())
            throw Error(ErrorCode::missing_reference, printable(folder.path().string(), 400),
                        "the study is not at its end: there is no winner yet",
                        "run study resume, or name a --candidate");
        check_winner(folder, outcome);
        number = *outcome.decision.winner;
    }
    adopt_candidate(outcome, number, arguments.value("-o"));
    session.print(pretty_json(Json{{"file", printable(arguments.value("-o"), 400)},
                                   {"candidate", number},
                                   {"choice", candidate_text(folder.study(), outcome.candidates[number])}}));
}

/// One look at one candidate, for a run that reads what is printed where it fails.
void run_work(const Arguments& arguments, Session& session) {
    if (arguments.has("--ends-with-parent")) ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    use_threads(arguments);
    try {
        const StudyFolder folder(arguments.operand(1), study_program());
        work_on(folder, arguments.value("--candidate"),
                rung_named(arguments.value("--rung", "fine"), "--rung"), session.progress());
    } catch (const Error& e) {
        session.print(worker_error_line(e));
        throw;
    }
}

void run_study_command(const Arguments& arguments, Session& session) {
    const std::string& what = arguments.operand(0);
    if (what == "run") return run_begin(arguments, session);
    if (what == "resume") return run_resume(arguments, session);
    if (what == "show") return run_show(arguments, session);
    if (what == "adopt") return run_adopt(arguments, session);
    if (what == "work") return run_work(arguments, session);
    constexpr double gather_patience = 60; // s: who handed the step over may be slow to let go of the folder
    if (what == "gather")
        return go_on_by_slurm(StudyFolder(arguments.operand(1), study_program()), arguments, session,
                              gather_patience);
    throw Error(ErrorCode::usage, "study", "'" + printable(what) + "' is nothing that is done with a study",
                "give run and a study, or resume, show or adopt and its folder");
}

} // namespace

Command study_command() {
    return {
        .name = "study",
        .operands = {"run|resume|show|adopt|work|gather", "STUDY|FOLDER"},
        .summary = "Plans and verifies candidates of a project's settings, and finds the best of them.",
        .help =
            "run STUDY works on a study (a JSON file: core/study/README.md) in a folder, NAME.study beside "
            "it\n"
            "or -o. resume FOLDER goes on after whatever ended that; what was found is found. show FOLDER\n"
            "prints what is known so far. adopt FOLDER -o PROJECT writes the project of the winner, or of\n"
            "--candidate. The folder gets study.json, table.md and table.csv; the winner, the front and the\n"
            "project as it stands are printed. Exit status 1 where no candidate meets the limits: the\n"
            "nearest is named. --on slurm hands candidates to a cluster as job arrays, and ends; show tells\n"
            "how far it is. --on ssh:HOST begins workers there. All see the folder under the same name.\n"
            "work FOLDER --candidate KEY --rung R looks at one candidate, gather FOLDER hands over the next\n"
            "ones: what these begin.",
        .options =
            {{.name = "-o",
              .value = "PLACE",
              .help = "run: the folder to work in; adopt: the project's file to write"},
             {.name = "--on",
              .value = "WHERE",
              .help = "run, resume: local (the default), slurm or ssh:HOST"},
             {.name = "--workers",
              .value = "N",
              .help = "run, resume: processes at once; results do not depend on it (default: all cores)"},
             {.name = "--candidate", .value = "K", .help = "adopt: its number in table.md; work: its key"},
             {.name = "--rung", .value = "R", .help = "work: estimate, coarse or fine (default)"},
             {.name = "--ends-with-parent", .help = "work: ends when the process that began it ends"},
             {.name = "--remote-program",
              .value = "PROGRAM",
              .help = "this program on the host of ssh:HOST (default: the same place)"},
             threads_option()},
        .run = run_study_command};
}

} // namespace facetmill::cli
