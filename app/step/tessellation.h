// Surfaces to facets: neighbours share their vertices bit by bit, and what the facets miss of the surfaces is
// measured.
#pragma once

#include "app/step/surface_file.h"

#include <array>
#include <cstdint>
#include <vector>

namespace facetmill::step {

struct Tessellation {
    std::vector<std::array<double, 3>> vertices; ///< mm
    std::vector<std::array<std::uint32_t, 3>> facets;
    std::vector<std::uint32_t> face_of; ///< number of the face in the file, for each facet
    /// How far the surfaces lie outside and inside the facets, at most (mm); of loose faces both are the
    /// larger.
    double out = 0, in = 0;
    double chord = 0; ///< what the mesher was asked for in the end, mm
    std::size_t missing_faces = 0;
};

/// Tessellates to a chord (mm) and an angle (radians) between neighbouring normals. Where the facets turn out
/// to miss more than `chord` it is done again more finely, once. Throws Error(limit_exceeded,
/// no_facets).
Tessellation tessellate(const SurfaceFile& file, double chord, double angle, StepProgress& progress);

} // namespace facetmill::step
