// A study's work for the window: what a job's thread does, and how it tells on the way. No widgets.
#pragma once

#include "core/base/progress.h"
#include "core/study/local_workers.h"
#include "core/study/slurm.h"
#include "ui/study_figures.h"

#include <array>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace facetmill::ui {

/// The program that works on candidates, facetmill-cli: what FACETMILL_CLI in the environment names, or where
/// programs of ours are. Throws Error(not_found).
std::filesystem::path study_program_file();
/// What folders call it (program_identity), the same as it does itself. Throws likewise.
std::string study_program();

/// Where candidates are worked on.
struct StudyPlace {
    enum class Where { here, slurm, ssh };
    Where where = Where::here;
    std::string host;        ///< ssh: as that knows it
    std::size_t workers = 1; ///< at once
};

/// How far a run is.
struct StudyStand {
    std::array<std::size_t, all_rungs.size()> done{}, expected{}; ///< looks, by rung
    double seconds_left = -1;                                     ///< below 0: not known yet
};

/// What the thread of a run tells the window's: the newest alone.
class StudyNews {
public:
    struct Told {
        StudyLookPtr look;
        StudyStand stand;
    };
    void tell(Told told);
    /// What was told since the last time.
    std::optional<Told> take();

private:
    std::mutex mutex_;
    std::optional<Told> told_;
};

/// A file beside the project for a study's text: the one that has it already, or one that is not there yet.
/// Throws what InputFile does.
std::filesystem::path free_study_file(const std::filesystem::path& project, const std::string& content);
/// The folder of a study: as it is where it is one, unless `make`, else made from the study's file. Throws
/// what StudyFolder does.
std::shared_ptr<const StudyFolder> open_study_folder(const std::filesystem::path& file,
                                                     const std::filesystem::path& folder, bool make);

/// What the folder knows. Throws what look_at_study does.
StudyLookPtr look_into(std::shared_ptr<const StudyFolder> folder, const Progress& progress);
/// Works on the study to its end with processes here or on a host, and writes what it came to. Throws what
/// run_study, write_study and workers_by_ssh do.
StudyLookPtr carry_out(std::shared_ptr<const StudyFolder> folder, const StudyPlace& place, StudyNews& news,
                       const Progress& progress);
/// Hands what is missing to Slurm; nothing is handed over where nothing is missing. Throws what
/// go_on_with_slurm does.
std::optional<SlurmStep> hand_over(const StudyFolder& folder, std::size_t workers, const Progress& progress);

} // namespace facetmill::ui
