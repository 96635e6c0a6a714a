// Parametric sample parts, tessellated adaptively to a chord tolerance.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/mesh.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct SampleKind {
    std::string name, label, help;
    LengthUnit natural_unit = LengthUnit::inch; ///< the unit its source gives it in
    bool turned = false;                        ///< made to turn about the X axis
};

/// concave, convex, complex (Lu, Appendix A), pillar, gap, shell (stand-ins), mould, square-prism, cylinder,
/// twisted-prism (Jasra), extruded-pattern, swept-pattern (stand-ins for his patterns).
const std::vector<SampleKind>& sample_kinds();

inline constexpr double default_sample_tolerance = 0.002 * 25.4; ///< mm

/// Throws Error(out_of_range) for an unknown name or a tolerance that is not positive, not finite, or so
/// small that the mesh would have more than 20 million facets.
std::shared_ptr<const Mesh> make_sample(std::string_view name, double chord_tolerance_mm,
                                        const Progress& progress);

} // namespace facetmill
