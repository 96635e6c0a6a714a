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
    /// True where nothing of the mesh lies on the ray from p along d, from 1e-7 of the mesh's extent on: a
    /// ray from a point of a facet leaves that facet and its doubles behind. d is a unit vector.
    bool is_free(const Vec3& p, const Vec3& d) const;

    /// How far it is along such a ray to the first facet; infinity where there is none up to `most`.
    double first_hit(const Vec3& p, const Vec3& d, double most = infinity) const;

    /// How far p is from the nearest facet; `most` where that is farther. What it is beyond `least` may be
    /// told by 1/share too large, which spares most of the search where many facets are about as near.
    double distance(const Vec3& p, double most, double share = 1, double least = 0) const;
    /// The facets whose boxes come within `r` of p + t d, t in [0, length], and maybe some more.
    void each_near(const Vec3& p, const Vec3& d, double length, double r,
                   const std::function<void(std::size_t facet)>& visit) const;
    const Mesh& mesh() const { return mesh_; }

private:
    double hit(std::size_t facet, const Vec3& p, const Vec3& d) const;

    const Mesh& mesh_;
    BoxTree tree_;
    double start_ = 0; ///< mm
};

} // namespace facetmill
