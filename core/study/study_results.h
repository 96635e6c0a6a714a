// What a study came to, as files: study.json, and all candidates as a table for people and one for programs.
#pragma once

#include "core/base/progress.h"
#include "core/study/study_run.h"

#include <functional>
#include <string>

namespace facetmill {

/// What became of a candidate: one that could win has none of the reasons of `why_no_winner`.
enum class CandidateStanding {
    winner,
    front,    ///< no other surpasses it in all that is wanted
    verified, ///< as finely as `facetmill-cli simulate`, and meets the limits
    behind,   ///< others were looked at more closely
    out,
};
/// "winner", "front", ...
std::string_view standing_name(CandidateStanding standing);
CandidateStanding standing_of(const StudyOutcome& outcome, std::size_t candidate);
/// Why it is not among those that could win; empty where it could.
std::string why_no_winner(const StudyOutcome& outcome, std::size_t candidate);
/// The looks at a candidate: those at the first one with the same project.
const CandidateState& state_of(const StudyOutcome& outcome, std::size_t candidate);

/// Lengths in the project's units. No times of day and no durations of work: the same study gives the same
/// bytes, by however many it was worked on.
std::string study_json(const StudyFolder& folder, const StudyOutcome& outcome);
/// The winner, the front and the project as it stands.
std::string study_summary(const StudyFolder& folder, const StudyOutcome& outcome);
std::string study_markdown(const StudyFolder& folder, const StudyOutcome& outcome);
std::string study_csv(const StudyFolder& folder, const StudyOutcome& outcome);

/// All three into the folder: all of them or none. `before` as in write_plan. Throws Error(unwritable).
void write_study(const StudyFolder& folder, const StudyOutcome& outcome,
                 const std::function<void()>& before = {});

/// Throws Error(empty_result) where no candidate meets the limits: which comes nearest, and what it misses.
void check_winner(const StudyFolder& folder, const StudyOutcome& outcome);

/// Writes the project of a candidate, with its files named from where it is written. Throws
/// Error(out_of_range) where there is no such candidate, Error(empty_result) where it has not been verified,
/// what save_project throws.
void adopt_candidate(const StudyOutcome& outcome, std::size_t candidate, const std::filesystem::path& file);

} // namespace facetmill
