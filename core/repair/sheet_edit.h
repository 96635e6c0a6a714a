// A mesh in half-edges, to take edges away from and turn them. Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/topology.h"

#include <memory>
#include <vector>

namespace facetmill::detail {

/// The manifold sheets of a mesh (topology.h). Vertices where sheets, or several fans, meet are held: they
/// neither move nor go, so that what is in no sheet fits as before.
class SheetEdit {
public:
    using Vertex = OpenMesh::VertexHandle;
    using Edge = OpenMesh::EdgeHandle;
    using Halfedge = OpenMesh::HalfedgeHandle;
    using Face = OpenMesh::FaceHandle;

    /// The mesh must outlive this.
    SheetEdit(const Mesh& mesh, const Progress& progress);

    HalfedgeMesh& half() { return half_; }
    const HalfedgeMesh& half() const { return half_; }
    Vec3 place(Vertex v) const {
        const auto& p = half_.point(v);
        return {p[0], p[1], p[2]};
    }
    void set_place(Vertex v, const Vec3& p) { half_.set_point(v, {p.x(), p.y(), p.z()}); }
    bool is_held(Vertex v) const { return held_[std::size_t(v.idx())]; }
    void hold(Index source_vertex) { held_[source_vertex] = 1; }
    Index source_facet(Face f) const { return topology_->facet_of[std::size_t(f.idx())]; }
    std::size_t left_out() const { return topology_->left_out; }
    std::array<Vertex, 3> corners(Face f) const;

    /// The mesh as it is now: facets in the order of the source, unchanged ones with their corners as they
    /// were; vertices in theirs.
    std::shared_ptr<Mesh> mesh(const Progress& progress) const;

private:
    const Mesh& source_;
    std::shared_ptr<const Topology> topology_;
    HalfedgeMesh half_;
    std::vector<char> held_;
};

} // namespace facetmill::detail
