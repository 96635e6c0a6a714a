// How far what is left deviates from the part: probes at all samples, and their figures.
#pragma once

#include "core/verify/deviation_surface.h"
#include "core/verify/verify.h"

#include <map>
#include <tuple>

namespace facetmill {

/// What the probes found.
struct Probed {
    std::vector<double> deviation; ///< per sample, mm, as in DeviationSurface
    std::vector<MotionPlace> by;   ///< per sample: the motion that cut deepest there; unknown where none did
    std::vector<double> program_gouges; ///< the deepest gouge of each program, >= 0
    /// Shanks, holders and rapids in the part: at each sample the motion that goes deepest, and of those with
    /// the same motion and kind the deepest.
    std::vector<Collision> collisions;
};

/// Places of points in the order of a curve that fills space (Morton's), so that neighbours come one after
/// the other.
std::vector<std::uint32_t> neighbors_together(const std::vector<Vec3>& points, const Progress& progress);

/// What the probes hold against what is left.
struct ProbeAims {
    double allowance = 0;   ///< mm
    double gouge_limit = 0; ///< mm
    double far = infinity;  ///< mm; what stands higher counts only as far as it is away from all of the part
    double bound = 1e-4;    ///< mm; where axes turn
    double short_by = 0;    ///< mm; surface is bare where the stock ends more than this below it
};

/// How deep (mm) shank, holder and what moves in a rapid may come into part or stock and only touch it: as
/// deep as a cutter may, but never less nor more than measuring tells apart.
double collision_limit(double gouge_limit);

/// Probes the samples of the part grown by the allowance, and sets the flag `bare` of those that the stock
/// does not reach. Where axes turn, the probes are exact to the bound. What is missing by less than the gouge
/// limit is no collision. What stands higher than `far` on a sample is measured by StandingMaterial.
Probed probe_samples(SurfaceSamples& samples, const MeshSight& sight, const StockSolid& stock,
                     std::span<const VerifyProgram> programs, const ProbeAims& aims,
                     const Progress& progress);

/// Fills in figures, `program_gouges` (one per program), border, bands, gouges and excess. The extremes are
/// at least `apart` (mm) from each other.
void fill_figures(Verification& verification, const SurfaceSamples& samples, const Probed& probed,
                  double apart, const Progress& progress);

} // namespace facetmill
