// Why surface stays uncut: a judge that says "uncut" has to say whether more motions, another tool or another
// stock would mend it. Internal to this room.
#pragma once

#include "core/verify/deviation.h"

#include <vector>

namespace facetmill {

/// The stock as each program begins with it, in their order; those at the end may be missing. Copies share
/// what no program has cut.
using StocksBefore = std::vector<std::shared_ptr<const StockModel>>;

/// Fills in `uncut` and `uncut_share`: of the samples that have no flag but `bare` or `hidden`, those that
/// are bare, or on which more than twice the tolerance stands. Without a tolerance none are.
///
/// The last tool whose cutter fits is asked for shank and holder: those of roughing are no help to finishing.
/// A cutter fits where it, along one of the axes of its program nearest to the normal, can stand so that less
/// than twice the tolerance is left on the sample (of the part grown by the allowance), and no other sample
/// lies deeper in it than the gouge limit; shank and holder likewise. Where these would stand in
/// what is left of the stock, or in what the program began with and its tool kept out of, that is the reason;
/// likewise where the cutter would be lower than the bottom of
/// the stock and than its program goes anywhere. Where the motion that left what stands goes by, with a tool
/// that fits there, no farther away than its radius, or an upright tool that fits goes by above and below,
/// passes lie too far apart. Where it does nearer to a
/// fixture than the clearance, the fixture is the reason. Tools of operations that leave more than counts as
/// uncut are asked last, and are no more than a hint. Where a program is not asked to cut there, and no other
/// that is has a tool for it, its boundary. Some thousand samples are asked; each stands for those about it.
void find_uncut_reasons(Verification& verification, const SurfaceSamples& samples, const Probed& probed,
                        const StocksBefore& before, std::span<const VerifyProgram> programs,
                        const Progress& progress);

} // namespace facetmill
