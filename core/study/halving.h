// Which candidates of a study are looked at more closely, and which of them wins: a function of what is known
// of them and of nothing else, so that it does not matter who found it out, when, and in which order.
//
// All are planned. What does not meet a limit then is out; of the rest the better share is judged coarsely,
// and of those that pass the better share as `facetmill-cli simulate` judges. Where none of these passes but
// the project as it stands, the next ones come, twice as many each time, until one does or there is none left
// that could do better than it. A coarse look leaves it open whether percentiles, shares and loads near their
// limits meet them. Better is what fewer others
// surpass in all that is wanted: the first front, then the next (Deb et al. 2002), in each by the first thing
// wanted. What is wanted and not known before a verdict is stood for by the planned cusp.
#pragma once

#include "core/study/study.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

/// What one look at a candidate came to.
struct RungResult {
    Measures measures;
    bool passed = false; ///< planned and within reach; from `coarse` on also verified
    std::string why;     ///< where it has not passed
    bool operator==(const RungResult&) const = default;
};

struct CandidateState {
    bool usable = true; ///< false: there is no such project, or it is that of a candidate before
    std::array<std::optional<RungResult>, 3> rungs;
    /// The closest look; nothing where there was none.
    std::optional<Rung> closest() const;
    /// What that came to, null where there was none.
    const RungResult* last() const;
    const std::optional<RungResult>& at(Rung rung) const { return rungs[std::size_t(rung)]; }
};

struct StudyTask {
    std::size_t candidate = 0;
    Rung rung = Rung::estimate;
    bool operator==(const StudyTask&) const = default;
};

/// A limit with its number.
struct SetLimit {
    Measure measure = Measure::machining_time;
    double most = 0;
};

struct StudyDecision {
    /// What was asked for on the way, and no more: looks that are known besides, as after a candidate was
    /// lost for a while, change nothing.
    std::vector<CandidateState> seen;
    std::vector<StudyTask> missing; ///< what has to be known before more can be said; empty: all is said
    std::vector<SetLimit> limits;
    std::optional<std::size_t> winner;
    std::vector<std::size_t> front;     ///< those that no other surpasses in all that is wanted, by the first
    std::optional<std::size_t> nearest; ///< to the limits, where there is no winner
};

/// The first candidate is the project as it stands. Throws Error(missing_reference) where a limit is what
/// that comes to, and it has not been verified.
StudyDecision decide(const Study& study, const std::vector<CandidateState>& candidates);

/// The limits that the result of a look at `rung` does not meet, of those that it tells something of:
/// "excess_max is 0.003, at most 0.002"; empty where it meets them, or may do so.
std::string missed_limits(const RungResult& result, Rung rung, const std::vector<SetLimit>& limits);

} // namespace facetmill
