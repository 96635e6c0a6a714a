// Why surface stays uncut: a judge that says "uncut" has to say whether more motions, another tool or another
// stock would mend it. Internal to this room.
#pragma once

#include "core/verify/deviation.h"

#include <vector>

namespace facetmill {

/// Fills in `uncut` and `uncut_share`: of the samples that have no flag but `bare` or `hidden`, those that
/// are bare, or on which more than twice the tolerance stands. Without a tolerance none are.
///
/// A tool fits where its cutter, in touch with the surface (grown by the allowance) along one of the axes
/// nearest to its normal, has no sample deeper inside than twice the tolerance, and shank and holder have
/// none. Some thousand samples are asked; each stands for those about it.
void find_uncut_reasons(Verification& verification, const SurfaceSamples& samples, const Probed& probed,
                        std::span<const VerifyProgram> programs, const std::vector<Vec3>& axes,
                        const Progress& progress);

} // namespace facetmill
