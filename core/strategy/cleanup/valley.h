// Valleys that a cutter cannot enter: where, moved over the part with a vertical axis, it touches at two
// places at once (Lu 3.6.1, strips of type (b); of type (a) too, where the surface between the two is round).
// Millimetres, part coordinates.
//
// The tip of a cutter that touches twice runs along a curve. On one side of it, seen from above, the cutter
// is held up by one flank, on the other by the other flank, so the touched point jumps; the jump is found by
// halving, to rounding. Nothing is asked of facets, edges or normals: facets of a finely tessellated hollow,
// noise and ripple make jumps too, but what stays under the cutter there is less than the tolerance.
//
// 1. The surface is sampled. Where the cutter, as near to touching the sample as the part lets it, stays
//    farther from it than the tolerance, material is left.
// 2. From such samples the tip is moved away from the flank that holds it up, until the other one does.
// 3. From there the curve is followed in even steps: the jump is looked for on an arc around the last point.
// Its
//    step seen from above shrinks with the valley's slope, so that valleys between steep walls are followed
//    like level ones. It ends at the part's border, where the valley has become as round as the cutter, and
//    where a third flank comes in: there ends are joined to a node.
// 4. The centre of the valley is where a ray from between the two touched points, through the gap, meets the
//    part.
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
    std::array<Vec3, 2> touch{};  ///< on the left and on the right, along the curve
    std::array<Vec3, 2> normal{}; ///< there, unit, away from the part
    Vec3 up = Vec3::UnitZ();    ///< the valley's fitted vector: out of it, unit, in the middle of both flanks
    Vec3 from = Vec3::Zero();   ///< a place within the cutter, above the centre
    Vec3 center = Vec3::Zero(); ///< on the part
    double gap = 0;             ///< from the centre to the cutter
    bool on_part = false;       ///< false: beyond the part's border, there is no centre
};

struct ValleyCurve {
    std::vector<PencilPoint> points;
    bool closed = false;             ///< then the first point is not repeated
    std::array<int, 2> node{-1, -1}; ///< in which its first and last point end
};

/// A place of the part where the cutter leaves more than the tolerance.
struct RestSample {
    Vec3 point, normal;
    Vec3 tip;       ///< of the cutter that comes nearest to touching there
    double gap = 0; ///< distance of the two; at least what it leaves
    double area = 0;
};

struct ValleyInput {
    const Mesh* mesh = nullptr;
    const FacetGrid* grid = nullptr;
    const UpSide* side = nullptr;
    const AxialLift* lift = nullptr; ///< of the cutter, without allowance
    const CutterCover* cover = nullptr;
    double tolerance = 0.05; ///< what may be left
    double ripple = 0.5;     ///< shorter valleys are left out, shorter interruptions are bridged
};

struct Valleys {
    std::vector<RestSample> samples;
    std::vector<ValleyCurve> curves;
    /// All places at which the cutter touches twice, also those along which nothing is left, with the curve
    /// that they belong to, or -1.
    struct Tip {
        Vec3 tip;
        int curve = -1;
    };
    std::vector<Tip> tips;
    std::vector<Vec3> nodes; ///< centres of the places where curves meet, on the part
    double step = 0;         ///< between points of a curve, about
};

/// Throws Cancelled within 100 ms. The same bits for every thread count.
Valleys find_valleys(const ValleyInput& input, const Progress& progress);

} // namespace facetmill
