// The lower surface of a cutter as the kernels want it: plain data (see lower_surface.h, which fills it).
#pragma once

namespace facetmill {

inline constexpr int most_surface_pieces = 8, surface_tangents = 16;

/// A line or an arc of g over rho0 <= rho <= rho1.
struct SurfacePiece {
    double rho0, rho1;     ///< distances from the axis
    double slope0, slope1; ///< dg/drho at the ends; +inf where the arc is vertical
    double z0;             ///< line: g(rho0)
    double e, f, r;        ///< arc: centre and radius; r = 0 for a line
};

struct SurfaceTable {
    SurfacePiece piece[most_surface_pieces] = {};
    int count = 0;
    double max_radius = 0;
    /// g(rho) >= tangent_at0[i] + tangent_slope[i] rho for every rho, each i; near
    /// rho = (i + 0.5) max_radius / surface_tangents the two are close.
    alignas(32) float tangent_at0[surface_tangents] = {};
    alignas(32) float tangent_slope[surface_tangents] = {};
    /// At max_radius, where g ends and any steeper line is below it: its height and slope.
    bool has_rim = false; ///< the slope there is no steeper than lines may be
    float rim_height = 0, rim_slope = 0;
    /// A steep support line, in doubles: g(rho) >= outer_at0 + outer_slope rho for every rho; it touches g
    /// near max_radius.
    double outer_at0 = 0, outer_slope = 0;
    /// About where a plane touches whose normal makes an angle with this sine with the axis: at the axis up
    /// to guess_level, else at guess_e + guess_r * sine. Only for choosing where bounds are good.
    float guess_e = 0, guess_r = 0, guess_level = 0;
};

} // namespace facetmill
