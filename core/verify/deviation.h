// How far what is left deviates from the part: probes at all samples, and their figures.
#pragma once

#include "core/verify/deviation_surface.h"
#include "core/verify/verify.h"

#include <map>
#include <tuple>

namespace facetmill {

struct Probed {
    std::vector<double> deviation; ///< one per sample
    std::vector<MotionPlace> by;
    std::vector<Collision>
        collisions; ///< of shanks, holders and rapids with the part: the motion that goes deepest at a
                    ///< sample, and of those with the same motion and kind the deepest
};

/// Probes all samples, of the part grown by `allowance`; sets the flag `bare`. Where axes turn, exact to
/// `bound`. Cancellation within 20 ms.
Probed probe_samples(SurfaceSamples& samples, const StockSolid& stock,
                     std::span<const VerifyProgram> programs, double allowance, double gouge_limit,
                     double bound, const Progress& progress);

/// Fills in figures, `program_gouges` (as long as there are programs), border, bands, gouges and excess;
/// `apart`: least distance of extremes.
void fill_figures(Verification& verification, const SurfaceSamples& samples, const Probed& probed,
                  double apart, const Progress& progress);

} // namespace facetmill
