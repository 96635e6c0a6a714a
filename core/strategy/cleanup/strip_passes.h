// Passes of clean-up over a band of rest material (Lu 3.6.2): one along the valley, then parallel ones to
// either side, as many as the band asks for. Millimetres, part coordinates, axis +Z.
//
// A cutter is placed so that it would touch the plane across the valley's fitted vector at a place of the
// centre, or beside it; then it is lifted along that vector until it cuts nothing (3.126-3.188, VectorLift),
// so that along the centre it touches both flanks, and beside it the flank there. What lifts it are the
// facets near by that face along the vector: those that face the other way it leaves behind. A lift along Z
// over the whole part then says whether the tip really is free, with all that stands above it.
//
// With `along_z` the cutter is placed touching both flanks, or the flank at its place beside the centre, and
// is lifted along Z alone (Lu Fig. 5-7 b).
#pragma once

#include "core/strategy/cleanup/rest_band.h"
#include "core/strategy/plan/path.h"

namespace facetmill {

struct StripCutting {
    MeshPtr mesh;
    const FacetGrid* grid = nullptr;
    const UpSide* side = nullptr;
    const AxialLift* lift = nullptr; ///< of the cutter, with the allowance
    const CutterCover* cover = nullptr;
    double allowance = 0;
    double cusp = 0.05, chord = 0.0025; ///< what may be left between passes; how far moves may run beside
    double overlap = 1; ///< passes go on for this long where more is left to cut than they need
    bool along_z = false;
    bool one_way = false;
};

/// The part and the cutter, for what it can reach.
ValleyInput reach_of(const StripCutting& with);

struct StripCut {
    std::vector<Pass> passes; ///< in machining order; `offset` is that from the centre, left positive
    double stepover_min = infinity, stepover_max = 0;
    double cusp_max = 0; ///< expected between neighbouring passes
    double blocked = 0;  ///< length of passes left out: the cutter cannot stand there
};

/// Along a valley. Throws Cancelled within 100 ms; the same bits for every thread count.
StripCut cut_valley(const StripCutting& with, const ValleyCurve& curve, const RestBand& band,
                    const Progress& progress);
/// A hollow without a valley: level lines over it, as deep as the cutter goes.
StripCut cut_hollow(const StripCutting& with, const RestBand& band, const Progress& progress);

/// What stays between two cutters whose tips are `apart`, that both touch a plane along it and are moved
/// across it, along the unit vector `travel`; mm.
double ridge(const CutterProfile& profile, const Vec3& apart, const Vec3& travel);

} // namespace facetmill
