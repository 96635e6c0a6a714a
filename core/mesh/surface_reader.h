// STEP and IGES files: their surfaces are tessellated by a program of its own (core/mesh/tessellated.h),
// which is found beside the running one or in the installation's libexec folder, and where the environment's
// FACETMILL_STEP says. Internal to the room.
#pragma once

#include "core/mesh/mesh_reader.h"

namespace facetmill::detail {

struct SurfaceLimits {
    double memory_mb = 4096;     ///< that the program may take
    double silent_seconds = 600; ///< it is given up when nothing has been heard of it for so long
};

/// `format`: "step" or "iges". Throws Error(not_found) without that program, Error(internal) where it crashed
/// or fell silent, what it says itself, and Cancelled, within 100 ms.
TriangleSoup read_surfaces(const MeshSource& source, const std::string& format, const SurfaceLimits& limits,
                           const Progress& progress);

} // namespace facetmill::detail
