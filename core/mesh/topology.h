// Half-edge connectivity of a mesh through OpenMesh, where the mesh allows it.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <memory>

namespace facetmill {

struct TopologyTraits : OpenMesh::DefaultTraitsDouble {
    VertexAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::None);
    EdgeAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::None);
};
using HalfedgeMesh = OpenMesh::TriMesh_ArrayKernelT<TopologyTraits>;

/// Face i of `mesh` is facet `facet_of[i]` of the source; facets that no half-edge structure can hold (third facet on an
/// edge, a second fan at a vertex ...) are not in it and are counted.
struct Topology {
    HalfedgeMesh mesh;
    std::vector<Index> facet_of;
    std::size_t left_out = 0;
};

/// Cancellation per 20 000 facets.
std::shared_ptr<const Topology> build_topology(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
