// The part of the surface on which a cutter leaves more than the tolerance, divided among the valleys it
// belongs to. Millimetres, part coordinates.
//
// What a cutter leaves over a place of the part is the distance of the place from all places the cutter may
// take. Where it cannot touch, the nearest is one that touches twice (valley.h): no other reaches deeper
// between the two. So the band of a valley lies between the touched points, and ends where the distance falls
// to the tolerance.
#pragma once

#include "core/strategy/cleanup/valley.h"

#include <array>
#include <vector>

namespace facetmill {

struct RestBand {
    int curve = -1;                        ///< of Valleys::curves; -1: a hollow without a valley
    std::vector<std::array<Vec3, 3>> band; ///< cut along its boundaries; oriented as the part's facets
    std::vector<std::vector<Vec3>> boundaries;
    double area = 0, depth = 0;   ///< depth: the most that is left
    double length = 0, width = 0; ///< along the centre, the largest across it
    /// Per point of the curve: how far the band reaches to the left and to the right of the centre, across
    /// curve and fitted vector.
    std::vector<std::array<double, 2>> reach;
    /// The same up the flanks: distance from the centre, across the curve.
    std::vector<std::array<double, 2>> flank;
};

/// One band a curve, in their order, then hollows by area. Curves whose band is empty are left out. Throws
/// Cancelled within 100 ms. The same bits for every thread count.
std::vector<RestBand> rest_bands(const ValleyInput& input, const Valleys& valleys, const Progress& progress);

/// Unit vectors along a curve at its points, towards its end; zero where it has no length.
std::vector<Vec3> tangents(const ValleyCurve& curve);
/// To the left of a curve, across it and its fitted vector; unit.
Vec3 left_of(const Vec3& tangent, const Vec3& up);

} // namespace facetmill
