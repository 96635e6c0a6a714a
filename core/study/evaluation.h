// One look at a candidate of a study: planned, and judged.
#pragma once

#include "core/base/progress.h"
#include "core/job/chain_verification.h"
#include "core/job/project.h"
#include "core/study/halving.h"
#include "core/study/measure.h"

#include <functional>
#include <memory>
#include <vector>

namespace facetmill {

/// Plans a candidate and, from `coarse` on, has it judged with the tolerance, allowance, gouge and uncut
/// limit of `base`, the project as it stands. What a candidate cannot do is a result that has not passed;
/// thrown is what says nothing of it: Error(not_found, unreadable, is_directory, unwritable, internal).
RungResult evaluate(const Project& candidate, const Project& base, Rung rung, const Progress& progress);

/// A candidate looked at finely, with all that the look came to.
struct SeenCandidate {
    RungResult result;
    std::vector<SetupPlan> setups;   ///< none where it cannot be planned
    std::vector<JudgedChain> chains; ///< of `setups`; none where it cannot be judged
};

/// The same look as `evaluate` at `fine`. `planned` is told of the setups before they are judged, and may be
/// empty; `max_samples` as VerifySettings has it. Throws likewise.
std::shared_ptr<const SeenCandidate>
see_candidate(const Project& candidate, const Project& base, std::size_t max_samples,
              const std::function<void(const std::vector<SetupPlan>&)>& planned, const Progress& progress);

/// Text that is another one where candidates would be judged otherwise: what `base` asks, and how closely
/// rungs look.
std::string judging_key(const Project& base);

} // namespace facetmill
