// Curvature-matched machining (CM2): the lead at which the cutter's footprint is as wide as the part lets it
// be (Wang 3-6; Jensen and Anderson's method for flat ends). The cutter leans along the feed (yaw 0) and
// touches with a circle of its surface of radius rho about the axis; across the feed its surface then curves
// by (Meusnier)
//
//     kappa = sin(lead) / rho(lead)
//
//   touches with                rho              matched where
//   rim of a flat end           R                sin(lead) = kappa R
//   corner circle (e, r)        e + r sin(lead)  sin(lead) = kappa e / (1 - kappa r)
//   ball                        r sin(lead)      kappa = 1 / r, whatever the lead
//
// Sign: kappa > 0 where the part is hollow, as the cutter is round. Less lead than that and the cutter gouges
// beside the contact; more, and its strip is narrower than it need be. Where the part is level or round
// across the feed (kappa <= 0) the smallest lead is best.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/geometry.h"

#include <span>

namespace facetmill {

/// Curvature across the feed (1/mm, > 0) of the cutter's surface where it touches a plane from which its axis
/// leans by 0 <= lead < pi/2; +inf where it touches with its tip.
double cutter_curvature_across(const CutterProfile& cutter, double lead);

/// The smallest lead within the limits (radians, 0 <= lo <= hi < pi/2) at which the cutter curves across the
/// feed at least as much as a part with this hollowness (1/mm); `hi` where none does. Leads at which the
/// cutter would stand on its tip or the bottom's cone are passed over, as far as the limits let: there is
/// nothing to match. Where the cutter would touch above its flutes the lead is the same, and the
/// configuration space says so. A kappa that is not a number is taken for that of a plane.
double cm2_lead(const CutterProfile& cutter, double kappa, double lead_lo, double lead_hi);

/// Normal curvature in a tangent direction, by Euler's formula with signs: k1 cos^2 + k2 sin^2 (Wang 5 prints
/// absolute values). `direction` of any length above 0; its component across the vertex normal counts. Sign
/// as in VertexCurvature: > 0 where the part is round. The mean curvature where the principal directions are
/// not known, NaN where the curvature is.
double normal_curvature(const VertexCurvature& at, const Vec3& direction);

/// Hollowness (-normal curvature) of the part at a point of a facet, its edges and corners included: the mean
/// of the corners', weighted by where the point lies. Corners without curvature (borders) do not count; 0
/// where none has one.
double hollowness(const Mesh& mesh, std::span<const VertexCurvature> curvatures, Index facet,
                  const Vec3& point, const Vec3& direction);

} // namespace facetmill
