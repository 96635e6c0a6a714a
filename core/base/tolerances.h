// Every tolerance of the program, by name. Code outside this file compares against these, never against a literal.
// Lengths in mm unless the name says otherwise.
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
/// Share of a sample's chord tolerance that its facets may use up at the lattice points where they are judged; the rest
/// covers the points between.
inline constexpr double sample_share = 0.95;

/// Coordinates of a CL program beyond this are refused, written and read: the part's own limit, stock and clearance.
inline constexpr double largest_program_coordinate = 1e8;
/// Length of a tool axis in a CL program may differ from 1 by this when written.
inline constexpr double unit_axis = 1e-6;
/// Of the last digit a CL file carries: heights this little above a digit are that digit, not the next.
inline constexpr double cl_digit_noise = 1e-2;

/// A mesh file whose largest extent lies outside these (mm) is most likely in another unit.
inline constexpr double suspect_small_extent = 1.0;
inline constexpr double suspect_large_extent = 1e4;
/// Coordinates stored as 32-bit floats that are further apart than this (mm) are reported as coarse.
inline constexpr double coarse_float_step = 0.01;
/// Relative error of a facet's area that the rounding of its corners to 32-bit floats may cause: below it the direction of
/// its normal is noise.
inline constexpr double float_noise = 1e-6;
/// A closed mesh whose volume is below this share of area times diagonal encloses nothing.
inline constexpr double flat_volume = 1e-9;

} // namespace facetmill::tolerance
