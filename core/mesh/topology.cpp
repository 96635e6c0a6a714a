#include "core/mesh/topology.h"

#include "core/mesh/edge_table.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Facets, vertices or corners between two looks at whether the job was cancelled: about a millisecond.
constexpr std::size_t items_per_check = 20'000;
/// OpenMesh numbers half-edges with int, two for each of up to three edges a facet.
constexpr std::size_t facet_limit = 300'000'000;

Index next_side(Index side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

bool names_vertex_twice(const Facet& f) {
    return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
}

/// Calls body(i) for i in [0, n), checking for cancellation and reporting progress per block.
template <class Body>
void for_each_checked(std::size_t n, const Progress& progress, Body&& body) {
    for (std::size_t i = 0; i < n; ++i) {
        if (i % items_per_check == 0) progress.set(double(i) / double(n));
        body(i);
    }
}

/// For each side, the number of its edge.
struct Edges {
    std::vector<Index> of_side;
    std::size_t count = 0;
};

Edges number_edges(const Mesh& mesh, const Progress& progress) {
    const EdgeTable table(mesh, progress.part(0.0, 0.6));
    Edges edges;
    edges.of_side.resize(3 * mesh.facet_count());
    for_each_checked(table.vertex_count(), progress.part(0.6, 1.0), [&](std::size_t v) {
        table.for_edges(v, [&](Index, std::span<const EdgeSide> sides) {
            for (const EdgeSide& s : sides)
                edges.of_side[s.side] = Index(edges.count);
            ++edges.count;
        });
    });
    return edges;
}

class TopologyBuilder {
public:
    TopologyBuilder(const Mesh& mesh, const Progress& progress)
        : mesh_(mesh), progress_(progress), edges_(number_edges(mesh, progress.part(0.0, 0.4))),
          users_(edges_.count) {}

    std::shared_ptr<const Topology> build() {
        choose_facets();
        find_fans();
        add_facets();
        close_borders();
        progress_.set(1.0);
        return std::move(topology_);
    }

private:
    /// The sides of an edge that are in: the one that runs to the higher vertex, the one to the lower.
    struct Users {
        Index up = no_index, down = no_index;
    };

    Index& user(std::size_t side) {
        Users& u = users_[edges_.of_side[side]];
        return side_start(mesh_, side) < side_end(mesh_, side) ? u.up : u.down;
    }
    Index opposite(Index side) const {
        const Users& u = users_[edges_.of_side[side]];
        return u.up == side ? u.down : u.up;
    }

    /// Which facets fit: each direction of each edge belongs to one facet only.
    void choose_facets() {
        const std::size_t n = mesh_.facet_count();
        topology_->facet_of.reserve(n);
        for_each_checked(n, progress_.part(0.4, 0.5), [&](std::size_t f) {
            const std::size_t s = 3 * f;
            if (names_vertex_twice(mesh_.facets[f]) || user(s) != no_index || user(s + 1) != no_index
                || user(s + 2) != no_index) {
                ++topology_->left_out;
                return;
            }
            for (std::size_t k = 0; k < 3; ++k)
                user(s + k) = Index(s + k);
            topology_->facet_of.push_back(Index(f));
        });
    }

    /// Turns round each vertex from every corner that no fan reached yet, and numbers the vertices of the
    /// fans.
    void find_fans() {
        auto& vertex_of = topology_->vertex_of;
        vertex_of.resize(mesh_.vertices.size());
        for (std::size_t v = 0; v < vertex_of.size(); ++v)
            vertex_of[v] = Index(v);
        vertex_at_corner_.assign(3 * mesh_.facet_count(), no_index);
        std::vector<char> taken(mesh_.vertices.size(), 0);
        for_each_checked(3 * topology_->facet_of.size(), progress_.part(0.5, 0.7), [&](std::size_t i) {
            const Index corner = 3 * topology_->facet_of[i / 3] + Index(i % 3);
            if (vertex_at_corner_[corner] != no_index) return;
            Index v = side_start(mesh_, corner);
            if (taken[v]) {
                vertex_of.push_back(v);
                v = Index(vertex_of.size() - 1);
            } else {
                taken[v] = 1;
            }
            number_fan(corner, v);
        });
    }

    /// Gives vertex v to all corners of a fan: one way until a border or the start; from a border the other
    /// way as well.
    void number_fan(Index corner, Index v) {
        Index c = corner;
        do {
            vertex_at_corner_[c] = v;
            c = opposite(next_side(next_side(c))); // across the side that ends at the vertex
        } while (c != no_index && c != corner);
        if (c == corner) return;
        for (Index across = opposite(corner); across != no_index; across = opposite(c)) {
            c = next_side(across);
            vertex_at_corner_[c] = v;
        }
    }

    /// The structure itself, linked directly: OpenMesh's add_face searches all edges of a vertex for each
    /// facet, and drops facets with a message on stderr where its order of insertion does not suit it.
    void add_facets() {
        HalfedgeMesh& half = topology_->mesh;
        half.reserve(topology_->vertex_of.size(), edges_.count, topology_->facet_of.size());
        for (const Index v : topology_->vertex_of) {
            const Vec3& p = mesh_.vertices[v];
            half.add_vertex({p.x(), p.y(), p.z()});
        }
        std::vector<OpenMesh::HalfedgeHandle> halfedge_of(edges_.count);
        for_each_checked(topology_->facet_of.size(), progress_.part(0.7, 0.95), [&](std::size_t i) {
            const Index s = 3 * topology_->facet_of[i];
            const OpenMesh::FaceHandle face = half.new_face();
            std::array<OpenMesh::HalfedgeHandle, 3> h;
            for (Index k = 0; k < 3; ++k) {
                OpenMesh::HalfedgeHandle& stored = halfedge_of[edges_.of_side[s + k]];
                if (stored.is_valid()) {
                    h[k] = half.opposite_halfedge_handle(stored);
                } else {
                    const OpenMesh::VertexHandle from{int(vertex_at_corner_[s + k])};
                    const OpenMesh::VertexHandle to{int(vertex_at_corner_[next_side(s + k)])};
                    stored = h[k] = half.new_edge(from, to);
                }
            }
            for (std::size_t k = 0; k < 3; ++k) {
                half.set_next_halfedge_handle(h[k], h[(k + 1) % 3]);
                half.set_face_handle(h[k], face);
                half.set_halfedge_handle(half.from_vertex_handle(h[k]), h[k]);
            }
            // Loops over a face begin at the end of its half-edge: corner 0.
            half.set_halfedge_handle(face, h[2]);
        });
    }

    /// Links the half-edges of borders. Every border vertex has one fan, so one border half-edge leaves it;
    /// it is the one that OpenMesh wants stored there.
    void close_borders() {
        HalfedgeMesh& half = topology_->mesh;
        for (const OpenMesh::HalfedgeHandle h : half.halfedges())
            if (half.is_boundary(h)) half.set_halfedge_handle(half.from_vertex_handle(h), h);
        for (const OpenMesh::HalfedgeHandle h : half.halfedges())
            if (half.is_boundary(h))
                half.set_next_halfedge_handle(h, half.halfedge_handle(half.to_vertex_handle(h)));
    }

    const Mesh& mesh_;
    const Progress& progress_;
    std::shared_ptr<Topology> topology_ = std::make_shared<Topology>();
    Edges edges_;
    std::vector<Users> users_;            ///< per edge
    std::vector<Index> vertex_at_corner_; ///< corner 3 f + k starts side 3 f + k
};

} // namespace

std::shared_ptr<const Topology> build_topology(const Mesh& mesh, const Progress& progress) {
    const std::size_t n = mesh.facet_count();
    if (n > facet_limit)
        throw Error(ErrorCode::limit_exceeded, "mesh",
                    std::to_string(n) + " facets are too many for connectivity",
                    "use a mesh of at most " + std::to_string(facet_limit / 1'000'000) + " million facets");
    return TopologyBuilder(mesh, progress).build();
}

} // namespace facetmill
