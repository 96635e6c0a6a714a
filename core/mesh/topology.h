// Half-edge connectivity of a mesh through OpenMesh, where the mesh allows it.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <memory>
#include <vector>

namespace facetmill {

struct TopologyTraits : OpenMesh::DefaultTraitsDouble {
    VertexAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::None);
    EdgeAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::None);
};
using HalfedgeMesh = OpenMesh::TriMesh_ArrayKernelT<TopologyTraits>;

/// Face i of `mesh` is facet `facet_of[i]` of the source, with its corners in the same order. Facets that no
/// half-edge structure can hold are not in it and are counted: in the order of the source, a facet that would
/// be the second one to run along an edge in the same direction (third facet on an edge, facet wound against
/// its neighbour, duplicate), and a facet that names a vertex twice.
///
/// Where the facets at a vertex form several fans, the first one (by facet) keeps the vertex and every other
/// one gets a vertex of its own at the same place, behind all others: vertex i is source vertex
/// `vertex_of[i]`, and i itself below the source's vertex count. Source vertices without facets are isolated
/// vertices.
struct Topology {
    HalfedgeMesh mesh;
    std::vector<Index> facet_of;
    std::vector<Index> vertex_of;
    std::size_t left_out = 0;
};

/// Linear in the number of facets, whatever the valence of vertices. Throws Error(limit_exceeded) for more
/// than 300 million facets.
std::shared_ptr<const Topology> build_topology(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
