// The surface along many parallel drive planes: the course of the contact points, and the lines on either
// side of a pass that it has to clear. Slices of slice.h, of the side of the surface that a tool can come to,
// and kept for those who ask again.
//
// Which side: of a closed mesh the outside, of an open one (a sheet, wound either way) the upper. Places that
// face down, or stand upright to within tolerance::vertical_normal_z, end a line; so does the place where a
// line would turn back into itself.
#pragma once

#include "core/strategy/surface/slice.h"
#include "core/strategy/surface/up_side.h"

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace facetmill {

/// A connected course over the surface in one drive plane; normals are unit, towards the tool.
struct SurfaceLine {
    std::vector<SlicePoint> points; ///< at least two, running towards growing u between their ends
    std::vector<double> arc;        ///< length along the line up to each point, mm
    /// The surface goes on before the first point, after the last: a round (PassMap::period) was cut there.
    std::array<bool, 2> goes_on{};

    double length() const { return arc.back(); }
    /// Point, normal and u at a length along the line; beyond its ends it goes on straight.
    SlicePoint at(double s) const;
    /// Unit direction of the line there.
    Vec3 direction(double s) const;
};

/// The part of a line between two u; without points where it has none there. `cut_short`: what `goes_on` is
/// of the part.
SurfaceLine part_of_line(const SurfaceLine& line, double u0, double u1, std::array<bool, 2>& cut_short);

/// Distance of p from the segment a b, mm.
double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b);

/// One slice, thinned, so that lines can be looked at near a place.
class SurfaceSlice {
public:
    struct Options {
        double deviation = 0.001; ///< points may be left out as long as the line stays this near, mm
        double longest = 1;       ///< pieces are no longer than this, mm
        double extension = 0;     ///< open ends are continued straight by this, mm
        double steepest_u = 1;    ///< the most that u changes by along any way, mm per mm
        double period = 0;        ///< of u (PassMap)
        double overlap = 0;       ///< lines that go round go on by so much after it, mm, or by a round
        bool as_wound = false;    ///< normals are those of the winding, and lines end at none of them
    };

    SurfaceSlice(std::vector<SurfaceLine> lines, const Options& options);

    /// The piece of the line that passes `p` nearest, within `reach` of it: its points raised by `raise`.
    /// False where no line comes as near as `reach`: the surface does not go on there.
    bool near(const Vec3& p, const Vec3& normal, double u, double reach, double raise,
              std::vector<Vec3>& raised) const;

    bool empty() const { return chains_.empty(); }
    /// True where the surface itself has a line at some u0 <= u <= u1.
    bool covers(double u0, double u1) const;
    /// Ends of the lines before they were continued: their u, and whether the line begins there.
    struct End {
        Vec3 point;
        double u = 0;
        bool first = false;
    };
    const std::vector<End>& ends() const { return ends_; }

private:
    using Chain = std::vector<SlicePoint>;
    struct Reference {
        double u;
        std::uint32_t chain, place;
    };
    double steepest_u_;
    std::vector<Chain> chains_;
    std::vector<Reference> by_u_;
    std::vector<End> ends_;
    std::vector<std::array<double, 2>> ranges_;
};

/// Lines of drive planes on a lattice: plane k lies at lo() + k * spacing(). Safe from many threads at once.
class SurfaceLines {
public:
    /// `mesh` and `geometry` must outlive this. `back`, a rotation, is applied to points and normals of all
    /// lines: for a mesh that was turned so that one of its sides faces up. `map`, which must outlive this,
    /// stands for the planes where there is one; what is said of these holds for its lines of equal v.
    SurfaceLines(const Mesh& mesh, const MeshGeometry& geometry, const DriveFrame& frame, double spacing,
                 const SurfaceSlice::Options& options, const Progress& progress,
                 const Mat3& back = Mat3::Identity(), const PassMap* map = nullptr);

    double lo() const { return slicer_.lo(); }
    double hi() const { return slicer_.hi(); }
    double spacing() const { return spacing_; }
    double v(long plane) const { return lo() + double(plane) * spacing_; }
    /// The plane at or next beyond v, away from `from`.
    long beyond(double v, double from) const;

    /// Lines in the plane v, in all detail, in the order of their smallest u.
    std::vector<SurfaceLine> lines(double v) const;
    /// The slice of plane k, kept until `forget`.
    std::shared_ptr<const SurfaceSlice> slice(long plane) const;
    /// Slices of planes below k are asked for no more.
    void forget(long below);

private:
    /// The same, where they are cut in a round `before` and `after` mm longer.
    std::vector<SurfaceLine> lines(double v, double before, double after) const;

    MeshSlicer slicer_;
    double spacing_;
    SurfaceSlice::Options options_;
    UpSide up_;
    Mat3 back_;
    bool turned_;
    mutable std::mutex mutex_;
    mutable std::map<long, std::shared_ptr<const SurfaceSlice>> slices_;
};

} // namespace facetmill
