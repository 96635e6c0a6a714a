// The round wall of a hole or a boss that a facet belongs to, or the round rim of the flat face that it lies
// in. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace facetmill {

struct RoundFace {
    Vec3 center = Vec3::Zero(); ///< on the axis, at its end that is told first
    Vec3 axis = Vec3::UnitZ();  ///< unit, out of that end
    double radius = 0;          ///< of the circle through the corners, by least squares
    double depth = 0;           ///< of the wall along the axis; 0: a rim
    double uneven = 0;          ///< the largest distance of a corner from that circle or cylinder
    double around = 0;          ///< radians of the circle that it covers
    bool hole = true;           ///< else a boss
    std::vector<Index> facets;  ///< of the wall; of a rim those of the flat face
};

/// `near`: the place that is meant, which chooses among the rims of a face, and of a level axis its end; of
/// others the upper one is told. A wall is what hangs together with the facet, turns by less than 50 degrees
/// from facet to facet and faces across one axis, as of an octagon and everything rounder; it must be round
/// to two hundredths of its radius by root mean square, over a third of a circle at least. Throws
/// Error(out_of_range) where there is no such wall or rim; linear in the number of facets.
RoundFace round_face(const Mesh& mesh, Index facet, const Vec3& near, const Progress& progress);

} // namespace facetmill
