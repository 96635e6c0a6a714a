// Lines of sight past a mesh.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/mesh.h"

#include <functional>

namespace facetmill {

/// Rays against all facets of a mesh, whichever way these are wound.
class MeshSight {
public:
    /// The mesh must outlive this.
    MeshSight(const Mesh& mesh, const Progress& progress);
    /// How far it is from p along d to the first facet, from 1e-7 of the mesh's extent on: a ray from a point
    /// of a facet leaves that facet and its doubles behind. Infinity where there is none up to `most`. d is a
    /// unit vector.
    double first_hit(const Vec3& p, const Vec3& d, double most = infinity) const;
    /// Whether first_hit is infinite, told by the first facet that is found on the ray.
    bool is_free(const Vec3& p, const Vec3& d) const;

    /// How far p is from the nearest facet; `most` where that is farther. What it is beyond `least` may be
    /// told by 1/share too large, which spares most of the search where many facets are about as near.
    double distance(const Vec3& p, double most, double share = 1, double least = 0) const;
    /// The facets whose boxes come within `r` of p + t d, t in [0, length], and maybe some more.
    void each_near(const Vec3& p, const Vec3& d, double length, double r,
                   const std::function<void(std::size_t facet)>& visit) const;
    const Mesh& mesh() const { return mesh_; }

private:
    const Mesh& mesh_;
    BoxTree tree_;
    double start_ = 0; ///< mm
};

/// Rays that go out into the open, or not, where a known number of them is asked for. Where these are few for
/// so large a mesh, and its facets lie about where those before them in the file do, they stay in the file's
/// order: a tree over all of them would take longer than the rays.
class OpenSight {
public:
    /// The mesh must outlive this.
    OpenSight(const Mesh& mesh, std::size_t rays, const Progress& progress);
    /// True where nothing of the mesh lies on the ray from p along d, a unit vector, from as far on as
    /// MeshSight looks.
    bool is_free(const Vec3& p, const Vec3& d) const;

private:
    const Mesh& mesh_;
    std::size_t together_ = 1; ///< facets that share a box
    BoxTree tree_;
    double start_ = 0; ///< mm
};

} // namespace facetmill
