#include "core/mesh/refine.h"

#include "core/base/error.h"
#include "core/base/plane_geometry.h"
#include "core/mesh/index_pair.h"
#include "core/mesh/topology.h"
#include "core/mesh/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace facetmill {

namespace {

constexpr std::size_t facets_per_check = 20000;

/// New vertices on edges, one per edge.
class EdgeVertices {
public:
    explicit EdgeVertices(DerivedMesh& to) : to_(to) {}

    Index find(Index a, Index b) const {
        const auto it = made_.find(pair_of(a, b));
        return it == made_.end() ? no_index : it->second;
    }
    /// At (1 - t) a + t b; the first call for an edge decides.
    Index make(Index a, Index b, double t) {
        const auto [it, is_new] = made_.try_emplace(pair_of(a, b), Index(to_.mesh.vertices.size()));
        if (is_new) {
            to_.mesh.vertices.push_back((1 - t) * to_.mesh.vertices[a] + t * to_.mesh.vertices[b]);
            to_.added.push_back({a, b, t});
        }
        return it->second;
    }

private:
    DerivedMesh& to_;
    std::unordered_map<std::uint64_t, Index> made_;
};

DerivedMesh copy_of(const Mesh& mesh) {
    DerivedMesh d;
    d.mesh = mesh;
    d.kept = mesh.vertices.size();
    d.facet_of.resize(mesh.facets.size());
    std::iota(d.facet_of.begin(), d.facet_of.end(), Index(0));
    return d;
}

/// A facet with new vertices on some of its edges (m[k] between corner k and k + 1, or no_index) as facets.
void split(const Mesh& mesh, const Facet& f, const std::array<Index, 3>& m, std::vector<Facet>& out) {
    const auto has = [&](int k) { return m[std::size_t(k % 3)] != no_index; };
    const int count = has(0) + has(1) + has(2);
    const auto corner = [&](int k) { return f[std::size_t(k % 3)]; };
    const auto middle = [&](int k) { return m[std::size_t(k % 3)]; };
    if (count == 0) {
        out.push_back(f);
    } else if (count == 1) {
        const int k = has(0) ? 0 : has(1) ? 1 : 2;
        out.push_back({corner(k), middle(k), corner(k + 2)});
        out.push_back({middle(k), corner(k + 1), corner(k + 2)});
    } else if (count == 2) {
        const int k = !has(0) ? 1 : !has(1) ? 2 : 0; // edges k and k + 1 are divided, around corner k + 1
        out.push_back({middle(k), corner(k + 1), middle(k + 1)});
        // The rest has four corners: along its shorter diagonal.
        const Index a = corner(k), b = middle(k), c = middle(k + 1), d = corner(k + 2);
        const auto gap = [&](Index p, Index q) {
            return (mesh.vertices[p] - mesh.vertices[q]).squaredNorm();
        };
        if (gap(a, c) <= gap(b, d)) {
            out.push_back({a, b, c});
            out.push_back({a, c, d});
        } else {
            out.push_back({a, b, d});
            out.push_back({b, c, d});
        }
    } else {
        for (int k = 0; k < 3; ++k)
            out.push_back({corner(k), middle(k), middle(k + 2)});
        out.push_back({m[0], m[1], m[2]});
    }
}

} // namespace

DerivedMesh refined(const Mesh& mesh, const std::function<bool(const std::array<Vec3, 3>&)>& wanted,
                    double longest, std::size_t max_facets, const Progress& progress) {
    DerivedMesh d = copy_of(mesh);
    const double square = longest * longest;
    std::vector<Facet> facets;
    std::vector<Index> facet_of;
    while (true) {
        EdgeVertices middles(d);
        for (std::size_t f = 0; f < d.mesh.facets.size(); ++f) {
            if (f % facets_per_check == 0) progress.check();
            const Facet& at = d.mesh.facets[f];
            const std::array<Vec3, 3> p{d.mesh.corner(f, 0), d.mesh.corner(f, 1), d.mesh.corner(f, 2)};
            std::array<bool, 3> is_long;
            for (std::size_t k = 0; k < 3; ++k)
                is_long[k] = (p[(k + 1) % 3] - p[k]).squaredNorm() > square && at[k] != at[(k + 1) % 3];
            if (!is_long[0] && !is_long[1] && !is_long[2]) continue;
            progress.check(); // what is wanted may take a millisecond to say
            if (!wanted(p)) continue;
            for (std::size_t k = 0; k < 3; ++k)
                if (is_long[k]) middles.make(at[k], at[(k + 1) % 3], 0.5);
        }
        facets.clear();
        facet_of.clear();
        for (std::size_t f = 0; f < d.mesh.facets.size(); ++f) {
            if (f % facets_per_check == 0) progress.check();
            const Facet& at = d.mesh.facets[f];
            split(d.mesh, at,
                  {middles.find(at[0], at[1]), middles.find(at[1], at[2]), middles.find(at[2], at[0])},
                  facets);
            facet_of.resize(facets.size(), d.facet_of[f]);
        }
        if (facets.size() == d.mesh.facets.size()) return d;
        if (facets.size() > max_facets)
            throw Error(ErrorCode::limit_exceeded, "part",
                        "its regions ask for more than " + std::to_string(max_facets) + " facets",
                        "check the part's units, or take larger tools");
        d.mesh.facets.swap(facets);
        d.facet_of.swap(facet_of);
    }
}

DividedMesh divided(const Mesh& mesh, std::span<const double> value) {
    if (value.size() != mesh.vertices.size())
        throw Error(ErrorCode::internal, "mesh", "a field has another number of values than vertices",
                    "report this");
    DividedMesh result;
    DerivedMesh& d = result.derived;
    d = copy_of(mesh);
    d.mesh.facets.clear();
    d.facet_of.clear();
    EdgeVertices crossings(d);
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const Facet& at = mesh.facets[f];
        std::array<bool, 3> in;
        for (std::size_t k = 0; k < 3; ++k)
            in[k] = value[at[k]] < 0;
        const auto add = [&](const Facet& facet, bool inside) {
            d.mesh.facets.push_back(facet);
            d.facet_of.push_back(Index(f));
            result.inside.push_back(inside);
        };
        if (in[0] == in[1] && in[1] == in[2]) {
            add(at, in[0]);
            continue;
        }
        // The corner that is alone on its side.
        const std::size_t k = in[1] == in[2] ? 0 : in[0] == in[2] ? 1 : 2;
        const Index a = at[k], b = at[(k + 1) % 3], c = at[(k + 2) % 3];
        const auto crossing = [&](Index p, Index q) {
            if (p > q) std::swap(p, q); // the same bits from both sides
            return crossings.make(p, q, value[p] / (value[p] - value[q]));
        };
        const Index ab = crossing(a, b), ac = crossing(a, c);
        add({a, ab, ac}, in[k]);
        const auto gap = [&](Index p, Index q) {
            return (d.mesh.vertices[p] - d.mesh.vertices[q]).squaredNorm();
        };
        if (gap(ab, c) <= gap(b, ac)) {
            add({ab, b, c}, !in[k]);
            add({ab, c, ac}, !in[k]);
        } else {
            add({ab, b, ac}, !in[k]);
            add({b, c, ac}, !in[k]);
        }
    }
    return result;
}

PartOfMesh part_of(const Mesh& mesh, std::span<const Index> facets) {
    PartOfMesh part;
    std::vector<Index> number(mesh.vertices.size(), no_index);
    part.mesh.facets.reserve(facets.size());
    for (const Index f : facets) {
        Facet facet;
        for (std::size_t k = 0; k < 3; ++k) {
            const Index v = mesh.facets[f][k];
            if (number[v] == no_index) {
                number[v] = Index(part.vertex_of.size());
                part.vertex_of.push_back(v);
                part.mesh.vertices.push_back(mesh.vertices[v]);
            }
            facet[k] = number[v];
        }
        part.mesh.facets.push_back(facet);
    }
    return part;
}

std::vector<std::size_t> connected_pieces(const Mesh& mesh, std::span<const Index> facets,
                                          std::size_t& count) {
    std::vector<std::size_t> parent(facets.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&](std::size_t i) {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    };
    std::unordered_map<std::uint64_t, std::size_t> first;
    first.reserve(3 * facets.size() / 2);
    for (std::size_t i = 0; i < facets.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const Facet& f = mesh.facets[facets[i]];
            const auto [it, is_new] = first.try_emplace(pair_of(f[k], f[(k + 1) % 3]), i);
            if (is_new) continue;
            const std::size_t a = root(i), b = root(it->second);
            parent[std::max(a, b)] = std::min(a, b);
        }
    std::vector<std::size_t> piece(facets.size());
    count = 0;
    for (std::size_t i = 0; i < facets.size(); ++i)
        piece[i] = parent[i] == i ? count++ : piece[root(i)];
    return piece;
}

std::vector<std::vector<Vec3>> border_loops(const Mesh& mesh) {
    const auto topology = build_topology(mesh, Progress());
    const HalfedgeMesh& half = topology->mesh;
    std::vector<bool> seen(half.n_halfedges(), false);
    std::vector<std::vector<Vec3>> loops;
    // Half-edges without a facet run against the facets' winding, so their loops are gone back along.
    for (const OpenMesh::FaceHandle face : half.faces()) {
        OpenMesh::HalfedgeHandle side = half.halfedge_handle(face); // the one that ends at corner 0
        for (std::size_t k = 0; k < 3; ++k) {
            side = half.next_halfedge_handle(side);
            const OpenMesh::HalfedgeHandle first = half.opposite_halfedge_handle(side);
            if (!half.is_boundary(first) || seen[std::size_t(first.idx())]) continue;
            std::vector<Vec3> loop;
            for (OpenMesh::HalfedgeHandle at = first; !seen[std::size_t(at.idx())];
                 at = half.prev_halfedge_handle(at)) {
                seen[std::size_t(at.idx())] = true;
                loop.push_back(
                    mesh.vertices[topology->vertex_of[std::size_t(half.to_vertex_handle(at).idx())]]);
            }
            loops.push_back(std::move(loop));
        }
    }
    return loops;
}

std::optional<LoopSide> nearest_side(const std::vector<std::vector<Vec3>>& loops, const Vec3& p) {
    std::optional<LoopSide> nearest;
    double least = infinity;
    for (std::size_t l = 0; l < loops.size(); ++l)
        for (std::size_t i = 0; i < loops[l].size(); ++i)
            if (const double d = squared_distance(p, loops[l][i], loops[l][(i + 1) % loops[l].size()]);
                d < least) {
                least = d;
                nearest = {l, i};
            }
    return nearest;
}

std::vector<Vec3> carried_normals(const DerivedMesh& derived, std::span<const Vec3> source) {
    std::vector<Vec3> normals(source.begin(), source.end());
    normals.reserve(source.size() + derived.added.size());
    for (const Between& v : derived.added)
        normals.push_back(edge_normal(normals[v.a], normals[v.b], v.t));
    return normals;
}

std::vector<VertexCurvature> carried_curvatures(const DerivedMesh& derived,
                                                std::span<const VertexCurvature> source,
                                                std::span<const Vec3> normals) {
    std::vector<VertexCurvature> all(source.begin(), source.end());
    all.reserve(source.size() + derived.added.size());
    const auto shape = [](const VertexCurvature& c) -> Mat3 {
        return c.k1 * c.direction1 * c.direction1.transpose()
               + c.k2 * c.direction2 * c.direction2.transpose();
    };
    for (std::size_t i = 0; i < derived.added.size(); ++i) {
        const Between& v = derived.added[i];
        const VertexCurvature &a = all[v.a], &b = all[v.b];
        if (!std::isfinite(a.k1) || !std::isfinite(b.k1) || a.direction1.isZero() || b.direction1.isZero()) {
            all.push_back(!std::isfinite(a.k1) ? b : !std::isfinite(b.k1) ? a : v.t < 0.5 ? a : b);
            continue;
        }
        VertexCurvature c;
        c.mean = (1 - v.t) * a.mean + v.t * b.mean;
        c.gauss = (1 - v.t) * a.gauss + v.t * b.gauss;
        const Vec3& n = normals[derived.kept + i];
        Vec3 x = n.cross(std::abs(n.x()) < 0.5 ? Vec3::UnitX() : Vec3::UnitY());
        if (!(x.norm() > 0)) {
            all.push_back(v.t < 0.5 ? a : b);
            continue;
        }
        x.normalize();
        const Vec3 y = n.cross(x);
        const Mat3 s = (1 - v.t) * shape(a) + v.t * shape(b);
        const PrincipalForm principal = principal_form(x.dot(s * x), x.dot(s * y), y.dot(s * y));
        c.k1 = principal.high;
        c.k2 = principal.low;
        c.direction1 = std::cos(principal.angle) * x + std::sin(principal.angle) * y;
        c.direction2 = n.cross(c.direction1);
        all.push_back(c);
    }
    return all;
}

} // namespace facetmill
