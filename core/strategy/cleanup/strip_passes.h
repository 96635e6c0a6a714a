// Passes of clean-up over a band of rest material (Lu 3.6.2): one along the valley, then parallel ones to
// either side, as many as the band asks for. Millimetres, part coordinates, axis +Z.
//
// A cutter is placed so that it would touch the plane across the valley's fitted vector at a place of the
// centre, or beside it. Then it is lifted along that vector until it cuts nothing (3.126-3.188, VectorLift),
// so that along the centre it touches both flanks, and beside it the flank there. Only facets near by that
// face along the vector lift it: the others face the other way and lie behind it. A lift along Z over the
// whole part then says whether the tip really is free, with all that stands above it.
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
    const AxialLift* lift = nullptr; ///< lift of the cutter, with the allowance
    const CutterCover* cover = nullptr;
    const TipGrid* tips = nullptr;      ///< of the cutter with the allowance, about bands; null: none
    const Standing* standing = nullptr; ///< what stands before the cutter comes; null: everything
    double allowance = 0;
    double cusp = 0.05;    ///< what may be left between passes
    double chord = 0.0025; ///< how far moves between points may run into the part
    double overlap = 1;    ///< how far passes go on over their ends and over the border of the band
    bool along_z = false;  ///< the cutter is lifted along Z, not along the fitted vector
    bool one_way = false;  ///< all passes run the same way
    /// Most points of the passes along one valley: more come from a tolerance that no step-over of the tool
    /// can keep.
    std::size_t max_points = 500'000;
};

/// Part and cutter as the search for what the cutter can reach takes them.
ValleyInput reach_of(const StripCutting& with);

struct StripCut {
    std::vector<Pass> passes; ///< in machining order; Pass::offset counts from the centre, left positive
    double stepover_min = infinity, stepover_max = 0;
    double cusp_max = 0; ///< what is expected to stay between neighbouring passes
    double blocked = 0;  ///< length of passes left out because the cutter cannot stand there
};

/// A band and what has been cut of it.
struct BandCut {
    const RestBand* band = nullptr;
    StripCut* cut = nullptr;
};

/// Passes along a valley.
StripCut cut_valley(const StripCutting& with, const ValleyCurve& curve, const RestBand& band,
                    const Progress& progress);
/// Passes over a hollow without a valley: parallel lines over it, as deep as the cutter goes.
StripCut cut_hollow(const StripCutting& with, const RestBand& band, const Progress& progress);

} // namespace facetmill
