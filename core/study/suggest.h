// Suggestions: which finishing operation serves a part best, with the tools of its project. What is wanted is
// little time and little left, on all of the part that is to be finished; who is surpassed in both by another
// is none of the best.
//
// Every candidate is previewed (previewed.h), in a fraction of a second. Where planning them all is no long
// wait, which the previews tell, they are planned and judged as candidates of a study are (evaluation.h), the
// quickest half of them coarsely; else only the best of the previews are, as many as the wait allows. Where
// that is not even as many as are suggested, as on most scans, the previews decide.
#pragma once

#include "core/base/progress.h"
#include "core/job/new_operation.h"
#include "core/job/planner.h"
#include "core/job/unroughed_stock.h"
#include "core/study/halving.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

struct Suggestion {
    std::shared_ptr<const Operation> operation; ///< as new_operation makes it, with a name of its kind
    std::string tool;                           ///< "T2 Ball 6 mm"
    double seconds = 0;                         ///< of the operation alone
    /// What comes of the project with it in place of its finishing operations. Of a previewed one
    /// `uncut_share` and whether it leaves no more than others do.
    RungResult result;
    bool previewed = false; ///< neither planned nor judged
    /// What planning and judging it takes of a processor, about, by its preview.
    double planning_seconds = 0;
};

/// What is known of the part that candidates were asked for.
struct SuggestedPart {
    double steep_share = 0; ///< of what faces up, by area, is steeper than `steep`
    double steep = radians(40);
    double allowed = 0; ///< tolerance of the candidates, mm
};

struct Suggestions {
    std::vector<Suggestion> best; ///< at most three, the first to be preferred
    /// Where the part stands too deep in its stock for any of them: a roughing that goes before each, as
    /// new_operation makes it; none where nothing is in their way.
    std::optional<NewOperation> rough;
    UnroughedStock unroughed;  ///< why, for the first tool that was looked at
    std::size_t looked_at = 0; ///< candidates
    SuggestedPart part;
    /// Candidates that cannot be: the operation's name, and why.
    std::vector<std::pair<std::string, std::string>> refused;
};

/// Operations that a suggestion may be, of the project's shown setup, with all that new_operation gives them:
/// every finishing kind that its machine can run and that needs no curve, with the tool that a new operation
/// has and with the largest round-nosed one.
std::vector<std::shared_ptr<const Operation>> suggestable(const Project& project);

/// For the shown setup. The project's roughing goes before each candidate, or a new one where it has none and
/// needs one; its other operations are left out.
/// Throws what `evaluate` does; Error(empty_result) where no candidate passes, with the reason of the first.
Suggestions suggest(const Project& project, const PreparedPart& part, const Progress& progress);

} // namespace facetmill
