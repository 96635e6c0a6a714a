// A study carried out: by whoever works on its candidates.
#pragma once

#include "core/base/file_lock.h"
#include "core/base/progress.h"
#include "core/study/study_folder.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace facetmill {

/// A look at a candidate, as those know it who work on it.
struct StudyWork {
    std::string key;
    Rung rung = Rung::estimate;
    bool operator==(const StudyWork&) const = default;
};

/// Works on all of them: what they come to is in the folder then, and of those that got lost why, by key.
/// Throws Error where none of them can be worked on (a full disk).
using StudyEngine = std::function<std::map<std::string, std::string>(
    const StudyFolder& folder, const std::vector<StudyWork>& work, const Progress& progress)>;

/// What a study came to.
struct StudyOutcome {
    std::vector<Candidate> candidates;
    std::vector<std::string> keys;           ///< of each; empty where it is not possible
    std::vector<std::size_t> same;           ///< the first candidate with the same project; of most itself
    std::vector<CandidateState> states;      ///< StudyDecision::seen
    std::map<std::string, std::string> lost; ///< by key
    StudyDecision decision;                  ///< with what is missing, where there is anything
};

/// The folder of a study, for one run alone. Throws Error(unwritable) where another run has it.
detail::FileLock lock_study(const StudyFolder& folder);

/// What the folder knows, without working on anything. `lost`: what is not to be asked again, and why.
StudyOutcome look_at_study(const StudyFolder& folder, const std::map<std::string, std::string>& lost,
                           const Progress& progress);

/// Has an engine work until nothing is missing. Throws what it and look_at_study do; Error(unwritable) where
/// another run works in the folder.
StudyOutcome run_study(const StudyFolder& folder, const StudyEngine& engine, const Progress& progress);

/// What is missing, with the projects of its candidates written. Throws Error(unwritable).
std::vector<StudyWork> missing_work(const StudyFolder& folder, const StudyOutcome& outcome);

/// Works in this process, one candidate after the other.
StudyEngine work_here();

} // namespace facetmill
