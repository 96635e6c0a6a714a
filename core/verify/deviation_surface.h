// The places of the part's surface at which it is compared with what is left.
#pragma once

#include "core/mesh/sight.h"
#include "core/verify/verify.h"

#include <vector>

namespace facetmill {

/// Points and unit normals on the part's facets, each standing for some area, joined by triangles.
struct SurfaceSamples {
    std::vector<Vec3> points, normals;
    std::vector<Vec3> places;    ///< where lines start: the points, moved off sharp edges by `edge_inset`
    std::vector<double> weights; ///< mm^2: a third of the triangles round the point; they add up to the area
    std::vector<std::uint8_t> flags;   ///< DeviationSurface::Flag
    std::vector<std::uint8_t> upright; ///< 1: `away`, and along an axis that passes it: a wall, no underside
    std::vector<double> slopes;        ///< angle between normal and nearest tool axis, radians
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<Index, 2>> open_edges; ///< the part's edges with one facet, as vertices of it
    double spacing = 0;                           ///< the spacing that was used, mm
};

/// Samples the facets of a part. Along edges neighbours are no farther apart than `spacing` (mm), or half of
/// it where the surface curves; none are farther than twice that. Facets that need no dividing keep the
/// mesh's vertices, shared, with normals by angle; divided ones, and those at creases, have points of their
/// own with the facet's normal, so that neither side of a crease is judged across it. Where the points would
/// be more than `most`, `spacing` grows; the mesh's own vertices are never thinned out. Facets without area
/// have no points.
///
/// A line from a sharp edge along the normal would run in the plane of the facet beyond it, within the skin
/// that a path leaves there. So lines start `edge_inset` from the edges of facets at creases and at open
/// borders, or a quarter of the facet's height where that is less.
SurfaceSamples sample_surface(const Mesh& part, double spacing, std::size_t most, const Progress& progress,
                              double edge_inset = 0);

/// The axes of all motions that cut, merged within about 2 degrees, and more where they are many. Unit, in
/// the order in which they come.
std::vector<Vec3> cutting_axes(std::span<const VerifyProgram> programs, const Progress& progress);
/// The same, but of programs that look along one axis alone (VerifyProgram::seen_along) that one.
std::vector<Vec3> looking_axes(std::span<const VerifyProgram> programs, const Progress& progress);

/// Sets the slopes, and the flags `border` (nearer than `cutter_radius` to an edge with one facet), `away`
/// (steeper than any of `axes` reaches) and `hidden` (faces some of `axes`, and the part is in the way of
/// them all), and which of those that are away are `upright`, with nothing of the part above beside them.
void flag_samples(SurfaceSamples& samples, const Mesh& part, const MeshSight& sight, double cutter_radius,
                  const std::vector<Vec3>& axes, const Progress& progress);

/// Says where lines that run from the part outward leave the stock.
class StockExit {
public:
    StockExit(const StockSolid& stock, const Progress& progress);
    ~StockExit();
    /// The t >= 0 at which the line p + t n first leaves the stock; below 0 where p is not in it.
    double operator()(const Vec3& p, const Vec3& n) const;

private:
    struct Facets;
    double of_box(const Vec3& p, const Vec3& n) const;
    double of_cylinder(const Vec3& p, const Vec3& n) const;
    double of_mesh(const Vec3& p, const Vec3& n) const;
    StockSolid stock_;
    std::unique_ptr<const Facets> facets_;
};

} // namespace facetmill
