// The lower surface of a cutter as the kernels want it: plain data (see lower_surface.h, which fills it).
#pragma once

namespace facetmill {

/// More pieces than any cutter has, grown by an allowance: tables have this size.
inline constexpr int max_surface_pieces = 8;

/// A line or an arc of g over rho0 <= rho <= rho1.
struct SurfacePiece {
    double rho0, rho1;     ///< distances from the axis
    double slope0, slope1; ///< dg/drho at the ends; +inf where the arc is vertical
    double z0;             ///< line: g(rho0)
    double e, f, r;        ///< arc: centre and radius; r = 0 for a line
};

/// The same in single precision, with the heights of both ends: for bounds only.
struct RoughPiece {
    float rho0 = 0, z0 = 0, rho1 = 0;
    float slope0 = 0, slope1 = 0;
    float e = 0, f = 0, r = 0, per_r = 0; ///< the last: 1 / r, 0 for a line
};

/// Surfaces for which bounds are simpler: one arc about a point of the axis; one level line.
enum class SurfaceShape { any, ball, flat };

struct SurfaceTable {
    SurfaceShape shape = SurfaceShape::any;
    SurfacePiece piece[max_surface_pieces] = {};
    RoughPiece rough[max_surface_pieces] = {};
    int count = 0;
    double max_radius = 0;
    float rim_height = 0; ///< g(max_radius)
    /// A steep support line, in doubles: g(rho) >= outer_at0 + outer_slope rho for every rho; it touches g
    /// near max_radius.
    double outer_at0 = 0, outer_slope = 0;
    /// About where a plane touches whose normal makes an angle with this sine with the axis: at the axis up
    /// to guess_level, else at guess_e + guess_r * sine. Only for choosing where bounds are good.
    float guess_e = 0, guess_r = 0, guess_level = 0;
};

} // namespace facetmill
