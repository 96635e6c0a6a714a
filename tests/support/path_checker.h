// Checks a 3-axis tool path against the part, independently of the planner and of the contact kernel: it
// knows the mesh, the cutter's profile and the tip's positions, nothing else.
//
// The part is sampled. Through every sample p with facet normal n runs a line p + t n; the cutter, moved
// along every straight piece of the path, is entered by the line at some t; the smallest over all pieces is
// what is left standing above p: negative is a gouge. The moved cutter is exact (no positions are
// interpolated); the only error is that of sampling: between samples gouges and cusps can be larger by at
// most `resolution`.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"

#include <functional>
#include <span>
#include <vector>

namespace facetmill::test {

/// Tips joined by straight moves.
using TipLine = std::vector<Vec3>;

struct PathCheckOptions {
    double spacing = 0.5; ///< of samples, mm
    double allowance = 0; ///< stock that is to stay along the normal
    double border = 0; ///< samples nearer to the border of the upward surface (seen from above) have no cusp
    double lowest_normal = 0.02; ///< facets with a smaller n.z are checked for gouges only
    bool either_side = true;     ///< facets with downward normals count with the opposite one
    double reach = 1; ///< what is left is looked for up to this height; beyond it a sample is uncut
    std::function<bool(const Vec3& point)> no_cusp; ///< samples that no cutter of this kind can reach
};

struct PathCheckResult {
    std::size_t samples = 0, cusp_samples = 0;
    double gouge_max = 0; ///< >= 0
    Vec3 gouge_at = Vec3::Zero();
    double cusp_max = 0, cusp_p999 = 0, cusp_p50 = 0; ///< over the area away from the border
    Vec3 cusp_at = Vec3::Zero();
    double uncut_fraction = 0; ///< of the area, border included: more than `reach` is left
    Vec3 uncut_at = Vec3::Zero();
    double resolution = 0; ///< by which sampling may miss the largest cusp
};

PathCheckResult check_path(const Mesh& part, const AptCutter& cutter, std::span<const TipLine> path,
                           const PathCheckOptions& options);

} // namespace facetmill::test
