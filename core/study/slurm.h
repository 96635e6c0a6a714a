// A study on a cluster: Slurm begins its workers, on machines that see the study's folder. Nothing of ours
// goes on meanwhile: a step, which is all that is missing at a time, is a job array, and a job that begins
// when the array has ended, however that was, looks at what was found and hands over the next step, or writes
// the result.
#pragma once

#include "core/study/study_run.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

struct SlurmSettings {
    std::filesystem::path program; ///< this one, where the machines have it
    std::size_t workers = 0;       ///< at once; 0: as many as Slurm begins
    std::size_t threads = 1;       ///< of each
    double patience = 0;           ///< s: how long another run may still have the folder
};

struct SlurmStep {
    std::size_t number = 1;
    std::string array, gather; ///< the numbers of their jobs
};

/// A program that the environment's PATH leads to; empty where there is none.
std::filesystem::path program_on_path(const std::string& name);

/// Forgets the steps before: what was lost is asked for again.
void begin_slurm(const StudyFolder& folder);
/// What three steps asked for and no worker has done, by key.
std::map<std::string, std::string> lost_by_slurm(const StudyFolder& folder);
/// Writes a step's list, its array's script and that of the job after it into the folder `slurm`, and hands
/// them over. A worker is given several looks where there are more than a job array may have. Throws
/// Error(not_found) where there is no sbatch, Error(internal) with what it said where it refuses.
SlurmStep hand_to_slurm(const StudyFolder& folder, const std::vector<StudyWork>& work,
                        const SlurmSettings& settings, const Progress& progress);

struct SlurmRun {
    StudyOutcome outcome;
    std::optional<SlurmStep> step; ///< what was handed over; nothing: all is said
};

/// Looks at what is there, and hands over what is missing. Throws what look_at_study and hand_to_slurm do,
/// Error(unwritable) where another run works in the folder.
SlurmRun go_on_with_slurm(const StudyFolder& folder, const SlurmSettings& settings, const Progress& progress);

/// A word as a shell reads it.
std::string shell_word(const std::string& text);

} // namespace facetmill
