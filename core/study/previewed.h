// What a finishing operation would come to, by the preview of its passes (core/job/preview_job.h): to choose
// by where planning all that may be chosen takes longer than anyone waits. Millimetres.
#pragma once

#include "core/job/preview_job.h"

namespace facetmill {

struct PreviewedOperation {
    /// Machining: passes and links at feed, the rest in rapids; within a factor of 2.5.
    double seconds = 0;
    /// What, of the part seen along the tool axis, its passes leave by more than the tolerance and what a
    /// cell of the grid cannot tell, at least what lies beyond its limits of slope; 0 for operations that
    /// turn the part.
    double uncut_share = 0;
    double planning_seconds = 0; ///< of a processor, about: planning it and judging the plan coarsely
};

/// Previews operation `i` of the project's shown setup. Throws what PassPreviewer::preview does.
PreviewedOperation previewed_operation(PassPreviewer& previewer, const Project& project, std::size_t i,
                                       const PreparedPart& part, const Progress& progress);

} // namespace facetmill
