// Every tolerance of the program, by name. Code outside this file compares against these, never against a
// literal. Numbers only: the contact kernels, compiled for several instruction sets, include it. Lengths in
// mm unless the name says otherwise.
#pragma once

namespace facetmill::tolerance {

/// Coordinates beyond this are refused (overflow of squared lengths, nonsense units).
inline constexpr double largest_coordinate = 1e7;
/// A part whose largest extent is below this is refused.
inline constexpr double smallest_extent = 1e-6;
/// What axial lifts promise against the exact answer, for parts of about 100 mm.
inline constexpr double lift_accuracy = 1e-9;
/// Rounding of a coordinate that went through a mesh file's 32-bit floats, relative to its size.
inline constexpr double coordinate_rounding = 1.2e-7;
/// A sum of vectors below this share of the sum of their lengths has no direction.
inline constexpr double vanishing_sum = 1e-12;
/// A pivot below this, in a matrix with unit diagonal, makes a least-squares fit ambiguous.
inline constexpr double fit_pivot = 1e-9;
/// Share of a sample's chord tolerance that its facets may use up at the lattice points where they are
/// judged; the rest covers the points between.
inline constexpr double sample_share = 0.95;

/// Coordinates of a CL program beyond this are refused, written and read: the part's own limit, stock and
/// clearance.
inline constexpr double largest_program_coordinate = 1e8;
/// Length of a tool axis in a CL program may differ from 1 by this when written.
inline constexpr double unit_axis = 1e-6;
/// Share of the last digit that a CL file carries: heights this little above a digit are that digit, not the
/// next.
inline constexpr double cl_digit_noise = 1e-2;

/// A mesh file whose largest extent lies outside these (mm) is most likely in another unit.
inline constexpr double suspect_small_extent = 1.0;
inline constexpr double suspect_large_extent = 1e4;
/// Coordinates stored as 32-bit floats that are further apart than this (mm) are reported as coarse.
inline constexpr double coarse_float_step = 0.01;
/// Relative error of a facet's area that the rounding of its corners to 32-bit floats may cause: below it the
/// direction of its normal is noise.
inline constexpr double float_noise = 1e-6;
/// A closed mesh whose volume is below this share of area times diagonal encloses nothing.
inline constexpr double flat_volume = 1e-9;

/// Facets whose unit normal has a smaller z than this count as vertical: a 3-axis cutter passes them, but
/// they ask for no pass of their own.
inline constexpr double vertical_normal_z = 1e-3;
/// Where the unit normal of a touched facet has a larger z than this, a cutter with a flat bottom stands on
/// its bottom: all places of it touch alike.
inline constexpr double level_normal_z = 0.98;
/// Tool axes with a smaller z are not planned: the tool could not be drawn out of the part along them.
inline constexpr double lowest_axis_z = 0.15;
/// Radians: directions closer than this are the same.
inline constexpr double level_angle = 1e-6;
/// To this (mm) the entry of a line into a cutter is found where no closed form is used.
inline constexpr double ray_accuracy = 1e-7;
/// Farther (mm) than this from the cutter, a contact point is one of a cutter grown by an allowance.
inline constexpr double contact_distance = 1e-6;

/// Angles (radians) and, as a share of the cutter's size, lengths of a cutter's profile that differ by less
/// are equal: a few times the rounding of their computation.
inline constexpr double cutter_angle = 1e-12;
/// Share of the cutter's size by which rounded values may miss tangency and still mean it.
inline constexpr double cutter_tangency = 1e-5;
/// Share of the diameter, and radians, by which a tool may differ from a named shape and keep its name.
inline constexpr double same_shape = 1e-3;
/// No tool is longer or wider (mm), and none has an angle nearer to 90° than the difference (radians).
inline constexpr double largest_tool = 1e4;
inline constexpr double steepest_tool_angle = 1.5707963267948966 - 1e-3;
/// Radii (mm) of cutters below this are refused: no tool, and near the rounding of coordinates.
inline constexpr double smallest_cutter = 1e-9;
/// Where a plane touches the cutter is known to this many roundings, times the condition of the facet; nearer
/// to an edge of the facet, that edge is asked too.
inline constexpr double contact_roundings = 64;
/// The projected area of a facet is zero, and an edge is no valley, where this many roundings of the products
/// that make it could be all there is.
inline constexpr double area_roundings = 8;
inline constexpr double valley_roundings = 64;
/// Bounds that let the index skip a block are widened by this share of the lengths in them, in double and in
/// single precision: above all rounding.
inline constexpr double bound_slack = 1e-13;
inline constexpr double float_slack = 4e-7;
/// Roofs over parts of the mesh, and support lines of a cutter, that give such bounds are no steeper.
inline constexpr double steepest_roof = 3;
inline constexpr double steepest_tangent = 6;
/// Bounds for many places at once trust the plane of a facet to say where it touches when its slope is known
/// to this, is no steeper than this, and positions are known to this share of the facet's height. Cutters are
/// followed up to a slope, edges up to a slope.
inline constexpr double trusted_slope = 0.05, steepest_trusted = 1e3, trusted_height = 0.01;
inline constexpr double steepest_followed = 12, steepest_edge = 100;
/// Places whose distance from the axis is this near, as a share, to the cutter's radius are on its rim.
inline constexpr double rim_share = 1e-4;
/// Coordinate (mm) of facets that are none: beyond any reach, and its square still a float.
inline constexpr double nowhere = 1e15;
/// Diameter (mm) of the cutter that stands for a line when the height of the mesh at one place is asked for.
inline constexpr double needle_diameter = 1e-6;
/// Area vectors of facets whose sum is below this share of their lengths make a closed surface.
inline constexpr double closed_sum = 1e-6;
/// Share by which what stays above a path, measured, may exceed what is allowed before it counts as left
/// uncut: more than the estimate's own error, and a tessellated hollow's.
inline constexpr double uncut_margin = 0.1;
/// The smallest step-over, as a share of the one on a level plane: steeper places than it can serve are
/// reported.
inline constexpr double smallest_step_share = 0.01;
/// Chord tolerances of a path are at least this (mm).
inline constexpr double smallest_chord = 1e-6;
/// A chord tolerance that nobody has set is this share of the machining tolerance, and at most this (mm): it
/// is what a path may gouge, and a part that may keep high cusps may not be gouged more for it.
inline constexpr double auto_chord_share = 0.05, largest_auto_chord = 0.01;
/// Points of a slice closer than this share of the part's diagonal say nothing about how the normal changes.
inline constexpr double vanishing_step = 1e-6;
/// Average changes of normals that differ by less than this share are alike.
inline constexpr double like_normal_change = 0.01;
/// How far (mm) inside a border the places lie that stand for it.
inline constexpr double border_inset = 1e-3;
/// Relative: a number in a project file this near to a limit of its parameter is the limit.
inline constexpr double written_number = 1e-14;
/// Lifts along a vector. Roundings of the coordinates that two elements may be apart and still touch.
inline constexpr double touch_roundings = 8;
/// A facet's plane is trusted to say where, as a share of the facet, it touches to this; else its edges and
/// corners are asked as well.
inline constexpr double plane_trust = 1e-3;
/// Sine of the angle between a facet and the vector below which the facet counts as seen edge-on: its edges
/// and corners are asked as well.
inline constexpr double edge_on = 1e-6;

/// Two figures that differ by less than this share differ by their rounding: one exceeds no limit by that.
inline constexpr double figure_rounding = 1e-9;
/// Points of a route that lie this near, as a share of the tool's size, to the straight line between their
/// neighbours are on it.
inline constexpr double route_rounding = 1e-9;
/// Square of the sine of the angle to the vertical below which a line runs straight up.
inline constexpr double upright_sine_square = 1e-24;
/// Sine or cosine of a direction of travel below which it means a coordinate axis: the rounding of multiples
/// of 90 degrees.
inline constexpr double axis_rounding = 1e-15;

/// Verification. Share of a tool's size within which a line that meets two parts of its surface at their
/// joint meets both; and below which a motion, or the sine of its angle to a line, is none.
inline constexpr double sweep_roundings = 1e-11;
inline constexpr double parallel_sine = 1e-8;
/// Share of a grid's step by which its limits may miss a whole number of steps.
inline constexpr double grid_rounding = 1e-9;
/// Below this a part of a unit vector, or an angle, is rounding.
inline constexpr double unit_rounding = 1e-14;
/// The square of a step of Newton's method that is less than this (of an angle) is rounding.
inline constexpr double last_newton_step = 1e-8;
/// How far inside the faces of the stock the outermost rays are, as a share of their spacing.
inline constexpr double lattice_inset = 1e-3;
/// Corners of the stock.s surface keep this share of a cell.s edge away from its ends: no triangle vanishes.
inline constexpr double edge_margin = 5e-4;
/// Share of its terms below which a negative discriminant is 0.
inline constexpr double grazing_roundings = 1e-14;
/// Share of the outline's width below which a piece of it is no piece.
inline constexpr double vanishing_outline = 1e-13;
/// Two ends of stretches on a line that differ by less (mm) are the same.
inline constexpr double probe_rounding = 1e-9;
/// Shank, holder or rapid reaching less deep (mm) into part or stock only touch it. A shank as wide as its
/// cutter slides along walls that passes above it cut: both are off by what arcs and decimals of a control
/// do.
inline constexpr double collision_depth = 3e-3;
/// And from here on it is a collision, mm, whatever may be missing of the part.
inline constexpr double max_collision_depth = 0.01;

} // namespace facetmill::tolerance
