// How far two surfaces lie apart, measured and not assumed. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/mesh.h"

#include <array>
#include <vector>

namespace facetmill {

/// A surface that distances are taken to.
class DeviationIndex {
public:
    /// A place, and the nearest one of the surface.
    struct Place {
        Vec3 at = Vec3::Zero(), nearest = Vec3::Zero();
        double distance = infinity;
        Index facet = no_index;
    };

    /// The mesh must outlive this, and have a facet. `reach`: places are mostly nearer than this; they are
    /// found sooner then.
    DeviationIndex(const Mesh& mesh, const Progress& progress, double reach = infinity);

    /// `hint`: a facet that may be the nearest.
    Place place(const Vec3& p, Index hint = no_index) const;
    Index nearest_facet(const Vec3& p) const { return place(p).facet; }
    /// Whether a place of the surface is no farther than the square root of `bound2`. Sooner than `place`.
    bool is_within(const Vec3& p, double bound2) const;

    /// How far the triangle lies from the surface at most, to `accuracy`, where that is more than `floor`;
    /// else any number up to `floor`. The triangle of the places that are nearest to its corners lies off the
    /// surface by no more than the facets there are inclined to it; the triangle is halved until that is
    /// little, and until it is no larger than the facets of the surface.
    double farthest(const Place& a, const Place& b, const Place& c, double floor, double accuracy) const;

private:
    double bend(const std::array<Place, 3>& corners, double longest) const;
    double squared(const Vec3& p, Index f) const;

    const Mesh& mesh_;
    double reach2_;
    std::vector<Vec3> normals_; ///< per facet, unit; zero: it has none
    BoxTree tree_;
    double grain_ = 0; ///< mm: mean length of edges
};

struct SurfaceDeviation {
    double forward = 0;  ///< how far a place of the first surface is from the second
    double backward = 0; ///< and of the second from the first
    double largest() const { return forward > backward ? forward : backward; }
};

/// To `accuracy` (> 0). Facets that both meshes have are
/// not looked at. Both must have a facet. Seconds for a million facets. The same bits with any number of
/// threads.
SurfaceDeviation surface_deviation(const Mesh& first, const Mesh& second, double accuracy,
                                   const Progress& progress);

/// The facets of a mesh, numbers ascending, with a place that is farther than `bound` from the surface;
/// `deviation` gets how far, as above. Facets of `same` are not looked at, where it has any.
std::vector<Index> facets_beyond(const Mesh& mesh, const DeviationIndex& surface, double bound,
                                 double accuracy, const std::vector<char>& same, double& deviation,
                                 const Progress& progress);

/// For each facet of `mesh` whether `other` has one with the same corners, whatever their order.
std::vector<char> facets_in_both(const Mesh& mesh, const Mesh& other, const Progress& progress);

} // namespace facetmill
