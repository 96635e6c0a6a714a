// The makers behind make_sample. Each throws Error(out_of_range) when the tolerance (mm) asks for too many
// facets.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <string_view>

namespace facetmill::sample {

/// "concave", "convex" or "complex": open sheets, outside up.
Mesh lu(std::string_view name, double tolerance, const Progress& progress);

/// Stand-ins for parts whose data was never published, with the same features: open sheets, outside up,
/// inches.
Mesh pillar(double tolerance, const Progress& progress);
Mesh gap(double tolerance, const Progress& progress);
Mesh shell(double tolerance, const Progress& progress);

/// A pocket with drafted walls, sharp inner corners and a boss: an open sheet, outside up. sample_mould.h
/// knows its valleys.
Mesh mould(double tolerance);

/// Jasra's turned parts: closed, turning about the X axis, the first end at x = 0.
Mesh square_prism();
Mesh cylinder(double tolerance);
Mesh twisted_prism(double tolerance, const Progress& progress);
/// Cylinders with raised patterns, as Jasra's figure 4.14.
Mesh extruded_pattern(double tolerance, const Progress& progress);
Mesh swept_pattern(double tolerance, const Progress& progress);

} // namespace facetmill::sample
