#include "core/study/slurm.h"

#include "core/base/child_process.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <thread>

#include <unistd.h>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

/// What Slurm allows unless it is told otherwise (MaxArraySize) is one more.
constexpr std::size_t max_array = 1000;
constexpr std::size_t max_steps_asked = 3;
constexpr int read_wait = 20; // ms

fs::path slurm_folder(const StudyFolder& folder) {
    return fs::absolute(folder.path()) / "slurm";
}

fs::path list_of_step(const fs::path& in, std::size_t step) {
    return in / ("step-" + std::to_string(step) + ".tasks");
}

std::size_t steps_so_far(const fs::path& in) {
    std::size_t n = 0;
    std::error_code ec;
    while (fs::exists(list_of_step(in, n + 1), ec))
        ++n;
    return n;
}

void write_slurm_file(const fs::path& path, const std::string& text) {
    OutputFile out(path);
    out.write(text);
    out.commit();
}

/// The lines of what a program said, for a message.
std::string in_one_line(const std::string& said) {
    constexpr std::size_t longest = 400;
    std::istringstream lines(said);
    std::string all;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) all += (all.empty() ? "" : "; ") + line;
    return printable(all, longest);
}

/// What sbatch prints with --parsable: "123" or "123;cluster". It asks long where nothing answers it.
std::string job_number(const std::vector<std::string>& words, const Progress& progress) {
    const fs::path sbatch = program_on_path("sbatch");
    if (sbatch.empty())
        throw Error(ErrorCode::not_found, "sbatch", "Slurm is not here",
                    "install its commands (Debian: slurm-client), or let this machine do the work");
    std::string command = "exec " + shell_word(sbatch.string());
    for (const std::string& word : words)
        command += " " + shell_word(word);
    MemoryFile nothing("facetmill-study");
    ChildProcess process("/bin/sh", {"-c", command + " 2>&1"}, nothing, nothing);
    std::string said;
    while (process.read(said, read_wait))
        progress.check();
    const int status = process.wait();
    std::string number = said.substr(0, said.find_first_of(";\n"));
    if (status != 0 || number.empty() || number.find_first_not_of("0123456789") != std::string::npos)
        throw Error(ErrorCode::internal, "sbatch", "it does not take the job: " + in_one_line(said),
                    "see whether Slurm runs: sinfo");
    return number;
}

} // namespace

std::string shell_word(const std::string& text) {
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

fs::path program_on_path(const std::string& name) {
    const char* const path = std::getenv("PATH"); // NOLINT(concurrency-mt-unsafe): nothing sets it
    std::istringstream folders(path ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        fs::path file = fs::path(folder) / name;
        std::error_code ec;
        if (fs::is_regular_file(file, ec) && ::access(file.c_str(), X_OK) == 0) return file;
    }
    return {};
}

void begin_slurm(const StudyFolder& folder) {
    const fs::path in = slurm_folder(folder);
    // From the last on: those that stay where one cannot be removed are the first, as they are counted.
    for (std::size_t n = steps_so_far(in); n > 0; --n)
        fs::remove(list_of_step(in, n));
}

std::map<std::string, std::string> lost_by_slurm(const StudyFolder& folder) {
    const fs::path in = slurm_folder(folder);
    std::map<std::pair<std::string, std::string>, std::size_t> asked;
    for (std::size_t n = steps_so_far(in); n > 0; --n) {
        const InputFile file(list_of_step(in, n));
        std::istringstream lines{std::string(file.bytes())};
        for (std::string key, rung; lines >> key >> rung;)
            ++asked[{key, rung}];
    }
    std::map<std::string, std::string> lost;
    for (const auto& [look, times] : asked)
        if (times >= max_steps_asked && !folder.result(look.first, rung_named(look.second, "step")))
            lost[look.first] = std::to_string(times) + " jobs of Slurm ended without a result";
    return lost;
}

SlurmStep hand_to_slurm(const StudyFolder& folder, const std::vector<StudyWork>& work,
                        const SlurmSettings& settings, const Progress& progress) {
    const fs::path in = slurm_folder(folder);
    fs::create_directories(in);
    SlurmStep step;
    step.number = steps_so_far(in) + 1;
    const fs::path list = list_of_step(in, step.number);
    const std::string name = "step-" + std::to_string(step.number);
    const std::size_t jobs = std::min(work.size(), max_array);
    const std::string study = fs::absolute(folder.path()).string(), program = settings.program.string();
    const std::string threads = std::to_string(settings.threads);
    // A look that fails leaves the others of its job be; what it says stands in the job's log.
    const fs::path array = in / (name + ".sh"), gather = in / (name + "-gather.sh");
    write_slurm_file(
        array, "#!/bin/sh\n# Looks at candidates of a study: those of this job's lines of the list.\nsed -n "
               "\"${SLURM_ARRAY_TASK_ID}~"
                   + std::to_string(jobs) + "p\" " + shell_word(list.string())
                   + " | while read -r key rung; do\n    " + shell_word(program) + " study work "
                   + shell_word(study) + " --candidate \"$key\" --rung \"$rung\" --threads " + threads
                   + " </dev/null\ndone\n");
    write_slurm_file(
        gather, "#!/bin/sh\n# Looks at what a step has found, and hands over the next.\nexec "
                    + shell_word(program) + " study gather " + shell_word(study) + " --threads " + threads
                    + (settings.workers > 0 ? " --workers " + std::to_string(settings.workers) : "") + "\n");
    std::string lines;
    for (const StudyWork& w : work)
        lines += w.key + " " + std::string(rung_name(w.rung)) + "\n";
    write_slurm_file(list, lines);
    try {
        const std::string logs = (in / name).string();
        const std::string at_once = settings.workers > 0 ? "%" + std::to_string(settings.workers) : "";
        step.array = job_number({"--parsable", "--job-name=facetmill-study", "--requeue",
                                 "--array=1-" + std::to_string(jobs) + at_once, "--cpus-per-task=" + threads,
                                 "--output=" + logs + "-%a.log", "--open-mode=append", array.string()},
                                progress);
        step.gather = job_number({"--parsable", "--job-name=facetmill-gather", "--requeue",
                                  "--kill-on-invalid-dep=no", "--dependency=afterany:" + step.array,
                                  "--output=" + logs + "-gather.log", "--open-mode=append", gather.string()},
                                 progress);
    } catch (...) {
        std::error_code ec;
        fs::remove(list, ec); // it was not asked for: a job that began meanwhile finds nothing to do
        throw;
    }
    return step;
}

namespace {

/// Who handed a step over may still have the folder when the job after it begins.
detail::FileLock lock_patiently(const StudyFolder& folder, double seconds, const Progress& progress) {
    constexpr auto pause = std::chrono::milliseconds(20);
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    for (;;) {
        try {
            return lock_study(folder);
        } catch (const Error& e) {
            if (e.code() != ErrorCode::unwritable || std::chrono::steady_clock::now() >= end) throw;
        }
        progress.check();
        std::this_thread::sleep_for(pause);
    }
}

} // namespace

SlurmRun go_on_with_slurm(const StudyFolder& folder, const SlurmSettings& settings,
                          const Progress& progress) {
    const detail::FileLock lock = lock_patiently(folder, settings.patience, progress);
    SlurmRun run{look_at_study(folder, lost_by_slurm(folder), progress), std::nullopt};
    if (!run.outcome.decision.missing.empty())
        run.step = hand_to_slurm(folder, missing_work(folder, run.outcome), settings, progress);
    return run;
}

} // namespace facetmill
