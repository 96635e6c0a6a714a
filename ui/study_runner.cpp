#include "ui/study_runner.h"

#include "core/base/child_process.h"
#include "core/base/file.h"
#include "core/study/ssh_workers.h"
#include "facetmill_version.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace facetmill::ui {

namespace fs = std::filesystem;

namespace {

using StudyClock = std::chrono::steady_clock;

/// Between two pictures of what is known.
constexpr auto study_news_pause = std::chrono::milliseconds(300);

/// How much longer a look takes than planning, until it is known: as `core/study/evaluation.cpp` looks.
constexpr std::array<double, all_rungs.size()> usual_weight = {1, 2, 5};

/// Keeps count of the looks of a run, and tells them.
class StudyTeller {
public:
    StudyTeller(StudyLook look, StudyNews& news) : look_(std::move(look)), news_(news) {
        for (std::size_t i = 0; i < look_.outcome.keys.size(); ++i)
            if (look_.outcome.states[i].usable) place_[look_.outcome.keys[i]] = i;
        tell();
    }

    void begin_round() { last_ = StudyClock::now(); }

    void ended(const StudyWork& work) {
        const auto now = StudyClock::now();
        seconds_[std::size_t(work.rung)] += std::chrono::duration<double>(now - last_).count();
        ++counted_[std::size_t(work.rung)];
        last_ = now;
        if (const auto at = place_.find(work.key); at != place_.end())
            look_.outcome.states[at->second].rungs[std::size_t(work.rung)] =
                look_.folder->result(work.key, work.rung);
        if (now - told_ < study_news_pause) return;
        tell();
    }

private:
    void tell() {
        told_ = StudyClock::now();
        auto look = std::make_shared<StudyLook>(look_);
        look->outcome.decision = decide(look_.folder->study(), look_.outcome.states);
        news_.tell({std::move(look), stand()});
    }

    StudyStand stand() const {
        StudyStand stand;
        std::size_t usable = 0;
        for (const CandidateState& state : look_.outcome.states) {
            if (!state.usable) continue;
            ++usable;
            for (std::size_t r = 0; r < all_rungs.size(); ++r)
                if (state.rungs[r]) ++stand.done[r];
        }
        const Study& study = look_.folder->study();
        const std::array<double, all_rungs.size()> shares = {1, study.coarse, study.fine};
        for (std::size_t r = 0; r < all_rungs.size(); ++r)
            stand.expected[r] = std::max(stand.done[r], std::size_t(std::ceil(shares[r] * double(usable))));
        stand.seconds_left = seconds_left(stand);
        return stand;
    }

    /// From what looks took until now, all workers together; those that were not made yet from the others.
    double seconds_left(const StudyStand& stand) const {
        double weights = 0, seconds = 0;
        for (std::size_t r = 0; r < all_rungs.size(); ++r) {
            weights += usual_weight[r] * double(counted_[r]);
            seconds += seconds_[r];
        }
        if (weights <= 0) return -1;
        double left = 0;
        for (std::size_t r = 0; r < all_rungs.size(); ++r) {
            const double each =
                counted_[r] > 0 ? seconds_[r] / double(counted_[r]) : usual_weight[r] * seconds / weights;
            left += each * double(stand.expected[r] - stand.done[r]);
        }
        return left;
    }

    StudyLook look_;
    StudyNews& news_;
    std::map<std::string, std::size_t> place_; ///< of candidates, by key
    std::array<double, all_rungs.size()> seconds_{};
    std::array<std::size_t, all_rungs.size()> counted_{};
    StudyClock::time_point last_ = StudyClock::now(), told_ = last_;
};

} // namespace

fs::path study_program_file() {
    std::vector<fs::path> places = program_places("facetmill-cli");
    if (const char* named = std::getenv("FACETMILL_CLI"); named && *named) places = {named};
    std::error_code ec;
    for (const fs::path& place : places)
        if (fs::is_regular_file(place, ec)) return place;
    throw Error(ErrorCode::not_found, "facetmill-cli",
                "the program that works on studies, facetmill-cli, is not here", "install all of Facetmill");
}

std::string study_program() {
    return program_identity("facetmill-cli " FACETMILL_VERSION, study_program_file());
}

void StudyNews::tell(Told told) {
    const std::lock_guard lock(mutex_);
    told_ = std::move(told);
}

std::optional<StudyNews::Told> StudyNews::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(told_, std::nullopt);
}

fs::path free_study_file(const fs::path& project, const std::string& content) {
    std::string stem = project.stem().string();
    for (int n = 1;; ++n) {
        const std::string name = stem + (n == 1 ? "" : "-" + std::to_string(n)) + ".study.json";
        const fs::path file = project.parent_path() / name;
        std::error_code ec;
        if (!fs::exists(file, ec)) return file;
        if (std::string(InputFile(file).bytes()) == content) return file;
    }
}

std::shared_ptr<const StudyFolder> open_study_folder(const fs::path& file, const fs::path& folder,
                                                     bool make) {
    const std::string program = study_program();
    const fs::path place = folder.empty() ? usual_study_folder(file) : folder;
    std::error_code ec;
    if (!file.empty() && (make || !fs::exists(place / "request.json", ec)))
        return std::make_shared<StudyFolder>(StudyFolder::make(place, file, program));
    return std::make_shared<StudyFolder>(place, program);
}

StudyLookPtr look_into(std::shared_ptr<const StudyFolder> folder, const Progress& progress) {
    auto look = std::make_shared<StudyLook>();
    look->outcome = look_at_study(*folder, {}, progress);
    look->folder = std::move(folder);
    return look;
}

StudyLookPtr carry_out(std::shared_ptr<const StudyFolder> folder, const StudyPlace& place, StudyNews& news,
                       const Progress& progress) {
    const StudyLookPtr known = look_into(folder, progress.part(0, 0.02));
    StudyTeller teller(*known, news);
    const std::size_t cores = std::max<std::size_t>(1, std::thread::hardware_concurrency());
    StudyWorkers workers = own_workers(*folder, study_program_file(), place.workers,
                                       std::max<std::size_t>(1, cores / place.workers));
    if (place.where == StudyPlace::Where::ssh) workers = workers_by_ssh(workers, place.host, {});
    workers.ended = [&](const StudyWork& work) { teller.ended(work); };
    const StudyEngine engine = work_by_processes(workers);
    auto look = std::make_shared<StudyLook>();
    look->outcome = run_study(
        *folder,
        [&](const StudyFolder& f, const std::vector<StudyWork>& work, const Progress& p) {
            teller.begin_round();
            return engine(f, work, p);
        },
        progress.part(0.02, 1));
    write_study(*folder, look->outcome);
    look->folder = std::move(folder);
    return look;
}

std::optional<SlurmStep> hand_over(const StudyFolder& folder, std::size_t workers, const Progress& progress) {
    begin_slurm(folder);
    SlurmSettings settings;
    settings.program = study_program_file();
    settings.workers = workers;
    const SlurmRun run = go_on_with_slurm(folder, settings, progress);
    if (!run.step) write_study(folder, run.outcome);
    return run.step;
}

} // namespace facetmill::ui
