// The tolerances of the contact kernels, in plain numbers: the kernels share no inline code
// (contact_blocks.h). tolerances.h refers here.
#pragma once

namespace facetmill::kernel {

/// Where a plane touches the cutter is known to this many roundings, times the condition of the facet; nearer
/// to an edge of the facet, that edge is asked too.
inline constexpr double contact_roundings = 64;
/// The projected area of a facet is zero where this many roundings of the products that make it could be all
/// there is.
inline constexpr double area_roundings = 8;
/// Bounds in single precision are widened by this share of the lengths in them: above all rounding.
inline constexpr double float_noise = 4e-7;
/// Support lines of a lower surface, for bounds, are no steeper.
inline constexpr double steepest_tangent = 6;
/// The same for bounds in double precision.
inline constexpr double double_noise = 1e-13;
/// Coordinate (mm) of facets that are none: beyond any reach, and its square still a float.
inline constexpr double nowhere = 1e15;
/// Places whose distance from the axis is this near, as a share, to the cutter's radius are on its rim.
inline constexpr double rim_share = 1e-4;
/// Roofs over the children of a node are no steeper.
inline constexpr double steepest_roof = 3;

} // namespace facetmill::kernel
