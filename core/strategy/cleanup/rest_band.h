// The part of the surface on which a cutter leaves more than the tolerance, divided among the valleys it
// belongs to. Millimetres, part coordinates.
//
// What a cutter leaves over a place of the part is the distance from there to the cutter, in the nearest
// position that it can take. Where it cannot touch the place, that is one in which it touches twice
// (valley.h): no other reaches deeper between the two flanks. So the band of a valley lies between the
// touched points, and ends where the distance falls to the tolerance.
//
//  1. rest_facets.h    facets are divided finely where something may be left
//  2. rest_gaps.h      at their corners: how much, and by which valley
//  3. rest_owners.h    facets are shared out among valleys and hollows
//  4. band_outlines.h  bands are cut out along the tolerance, and where two valleys meet
//  5. band_reach.h     how far they reach to either side
#pragma once

#include "core/strategy/cleanup/valley.h"

#include <array>
#include <vector>

namespace facetmill {

/// How much is left is asked up to so many tolerances: where more stands, it matters little to where a band
/// ends.
inline constexpr double asked_tolerances = 4;

struct RestBand {
    int curve = -1;                         ///< index in Valleys::curves; -1: a hollow without a valley
    std::vector<std::array<Vec3, 3>> band;  ///< triangles, cut along the boundaries, oriented as the part's
    std::vector<std::array<float, 3>> left; ///< how much is left at the corners of each triangle
    std::vector<std::vector<Vec3>> boundaries;
    /// Corners, not in the band, of the facets that it was cut out of, and the part's normals there, unit,
    /// towards the tool: where the band ends is not known better than to such a facet.
    std::vector<std::array<Vec3, 2>> beside;
    double area = 0;
    double depth = 0;             ///< the most that is left
    double length = 0, width = 0; ///< length of the centre, largest width across it
    /// Per point of the curve: how far the band reaches to the left and to the right of the centre, across
    /// curve and fitted vector.
    std::vector<std::array<double, 2>> reach;
    /// Per point of the curve: how far it reaches up the flanks, left and right: distance from the centre
    /// across the curve.
    std::vector<std::array<double, 2>> flank;
};

/// One band a curve, in their order, then hollows by area, the largest first. Curves whose band is empty are
/// left out.
std::vector<RestBand> rest_bands(const ValleyInput& input, const Valleys& valleys, const Progress& progress);

/// Unit vectors along a curve at its points, towards its end; zero where it has no length.
std::vector<Vec3> tangents(const ValleyCurve& curve);
/// To the left of a curve, across it and its fitted vector; unit.
Vec3 left_of(const Vec3& tangent, const Vec3& up);

} // namespace facetmill
