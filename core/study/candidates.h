// The candidates of a study: the project as it stands, and every combination of what may vary, or some.
#pragma once

#include "core/base/progress.h"
#include "core/study/study.h"

#include <memory>
#include <string>
#include <vector>

namespace facetmill {

struct Candidate {
    std::vector<std::size_t> chosen;        ///< of each variation; empty: the project as it stands
    std::shared_ptr<const Project> project; ///< null where it is none
    std::string impossible;                 ///< why not
    bool usable() const { return project != nullptr; }
};

/// First the project as it stands, then the combinations, in the order of the study with the last variation
/// changing soonest; of `samples` as many that are chosen by `seed`, in the same order. Tools of the study
/// that a candidate does not use are left out of it. Throws Error(limit_exceeded) where these are too many,
/// and the error of a value which no combination can have, with its place in the study.
std::vector<Candidate> study_candidates(const Study& study, const Project& project, const Progress& progress);

/// The numbers 0 to `total` - 1, or `count` of them, ascending: the same for the same seed.
std::vector<std::uint64_t> chosen_numbers(std::uint64_t total, std::size_t count, std::uint64_t seed);

/// "direction y, tool 2".
std::string candidate_text(const Study& study, const Candidate& candidate);

} // namespace facetmill
