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
/// Share of a sample's chord tolerance that its facets may use up at the lattice points where they are judged; the rest
/// covers the points between.
inline constexpr double sample_share = 0.95;

} // namespace facetmill::tolerance
