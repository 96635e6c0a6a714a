// How much work a plan is, told before it begins: orders of magnitude, from the part's size and the settings
// alone.
#pragma once

#include "core/job/planner.h"
#include "core/verify/verify.h"

#include <string>
#include <vector>

namespace facetmill {

struct WorkEstimate {
    std::string what; ///< "operation 'Finish'"
    double points = 0, bytes = 0, seconds = 0;

    /// More than a computer of these days does without a word: whoever asked may have slipped by some zeros.
    bool large() const;
    /// Worth a line before the work.
    bool notable() const;
    /// "about 1200 million points, 350 GB, 7 h".
    std::string text() const;
};

/// For every operation, or for the one named. The project has been checked (check_project).
std::vector<WorkEstimate> estimate_plan(const Project& project, const PreparedPart& part,
                                        const std::string& only_operation);

/// The same for a verification, from what it tells before it begins (VerifySettings::before_work).
WorkEstimate estimate_of(const VerifyWork& work);

/// How many places a verification compares that are `spacing` (mm) apart.
double estimate_places(const PreparedPart& part, double spacing);

} // namespace facetmill
