// Valleys that a cutter cannot enter: the places where, moved over the part with a vertical axis, it touches
// twice at once (Lu 3.6.1, strips of type (b); of type (a) too, where the surface between the two is round).
// Millimetres, part coordinates.
//
// The tip of a cutter that touches twice runs along a curve. On one side of the curve, seen from above, one
// flank holds the cutter up, on the other side the other flank, so the touched point jumps; halving finds the
// jump to rounding. Nothing is asked of facets, edges or normals: facets of a finely tessellated hollow,
// noise and ripple make jumps too, but what stays under the cutter there is less than the tolerance.
//
//  1. rest_samples.h: the surface is sampled. Material is left where the cutter, as near to touching
//     a sample as the part lets it come, stays farther from it than the tolerance.
//  2. pencil_probe.h: from such samples the tip is moved away from the flank that holds it up, until
//     the other one does.
//  3. valley_trace.h: from there the curve is followed in even steps: the jump is looked for on an arc
//     around the last point. The arc shrinks with the valley's slope, so that valleys between steep
//     walls are followed like level ones. The curve ends at the part's border, where the valley has
//     become as round as the cutter, and where a third flank comes in.
//  4. valley_runs.h: the centre of the valley is where a ray from between the two touched points,
//     through the gap, meets the part. Stretches along which nothing is left are taken out.
//  5. valley_nodes.h: ends that a third flank made are joined in corners.
#pragma once

#include "core/gouge/axial_lift.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/surface/facet_grid.h"
#include "core/strategy/surface/up_side.h"

#include <array>
#include <vector>

namespace facetmill {

/// A cutter that touches the part at two places.
struct PencilPoint {
    Vec3 tip = Vec3::Zero();
    std::array<Vec3, 2> touch{};  ///< touched points left and right of the curve, seen along it
    std::array<Vec3, 2> normal{}; ///< the part's normals there, unit, towards the cutter
    Vec3 up = Vec3::UnitZ();      ///< the valley's fitted vector: out of it, midway between the flanks, unit
    Vec3 from = Vec3::Zero();     ///< a place within the cutter, above the centre
    Vec3 center = Vec3::Zero();   ///< the valley's centre, on the part
    double gap = 0;               ///< distance from the centre to the cutter
    bool on_part = false;         ///< false: beyond the part's border, where there is no centre
};

struct ValleyCurve {
    std::vector<PencilPoint> points;
    bool closed = false;             ///< then the first point is not repeated
    std::array<int, 2> node{-1, -1}; ///< numbers in Valleys::nodes of the corners at its ends; -1: none
};

/// A place of the part where the cutter leaves more than the tolerance.
struct RestSample {
    Vec3 point, normal;
    Vec3 tip;       ///< tip of the cutter that comes nearest to touching the point
    double gap = 0; ///< distance from the point to that cutter: at least this is left
};

class Standing; // standing.h
class TipGrid;  // tip_grid.h

struct ValleyInput {
    const Mesh* mesh = nullptr;
    const FacetGrid* grid = nullptr;
    const UpSide* side = nullptr;
    const AxialLift* lift = nullptr; ///< lift of the cutter
    const CutterCover* cover = nullptr;
    const Standing* standing = nullptr; ///< what stands before the cutter comes; null: everything
    const TipGrid* tips = nullptr;      ///< of the cutter; null: none
    double tolerance = 0.05;            ///< thickness of material that may be left
    /// Samples are this share of sqrt(2 R tolerance) apart, the half width of what a ball of radius R touches
    /// within the tolerance: several lie across every valley that leaves more.
    double sample_share = 0.7;
    double ripple = 0.5; ///< shorter valleys are left out, shorter interruptions are bridged
};

struct Valleys {
    std::vector<RestSample> samples;
    std::vector<ValleyCurve> curves;
    /// A place at which the cutter touches twice, with the curve it belongs to; -1: nothing is left there.
    struct Tip {
        Vec3 tip;
        int curve = -1;
    };
    std::vector<Tip> tips;
    std::vector<Vec3> nodes; ///< corners in which curves meet: their centres, on the part
    double step = 0;         ///< typical distance between the points of a curve
};

Valleys find_valleys(const ValleyInput& input, const Progress& progress);

/// Says of every tip which curve it belongs to: the one with a tip nearest to it, within a step.
void own_tips(Valleys& valleys);

} // namespace facetmill
