// Meshes of known shape for the tests of local geometry, connectivity and samples.
#pragma once

#include "core/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace facetmill::test {

/// Grid of (a_cells + 1) x (b_cells + 1) parameters in [0, 1]^2, closed in a and b where asked, put in place
/// by `point(a, b)`; outside where d/da x d/db points. `jitter` moves inner parameters by up to that share of
/// a cell, evenly spread random. `parameters` gets (a, b) per vertex.
template <class Point>
Mesh grid_mesh(int a_cells, int b_cells, bool a_closed, bool b_closed, double jitter, Point&& point,
               std::vector<Vec2>* parameters = nullptr) {
    std::mt19937 rng(5);
    const auto shift = [&](int i, int cells, bool closed) {
        const double r = jitter * (2.0 * double(rng()) / double(std::mt19937::max()) - 1.0);
        return (closed || (i > 0 && i < cells) ? i + r : double(i)) / cells;
    };
    Mesh mesh;
    const int columns = a_closed ? a_cells : a_cells + 1, rows = b_closed ? b_cells : b_cells + 1;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const double a = shift(i, a_cells, a_closed), b = shift(j, b_cells, b_closed);
            mesh.vertices.push_back(point(a, b));
            if (parameters) parameters->push_back({a, b});
        }
    const auto id = [&](int i, int j) { return Index((j % rows) * columns + i % columns); };
    for (int j = 0; j < b_cells; ++j)
        for (int i = 0; i < a_cells; ++i) {
            mesh.facets.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            mesh.facets.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    return mesh;
}

/// Octahedron halved `levels` times and pushed out to the sphere.
inline Mesh sphere_mesh(double radius, int levels) {
    Mesh mesh;
    for (const Vec3& p :
         {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        mesh.vertices.push_back(radius * p);
    mesh.facets = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<Index, Index>, Index> middles;
        const auto middle = [&](Index a, Index b) {
            const auto [it, fresh] = middles.try_emplace(std::minmax(a, b), Index(mesh.vertices.size()));
            if (fresh) mesh.vertices.push_back(radius * (mesh.vertices[a] + mesh.vertices[b]).normalized());
            return it->second;
        };
        std::vector<Facet> finer;
        for (const auto& [a, b, c] : mesh.facets) {
            const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.facets = std::move(finer);
    }
    return mesh;
}

/// Cube with corners 0 and `size`, two facets a side, moved by `at`.
inline Mesh cube_mesh(double size = 1.0, const Vec3& at = Vec3::Zero()) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(at + size * Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
    mesh.facets = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// Both meshes in one; vertices at equal places become one.
inline Mesh welded(const Mesh& a, const Mesh& b) {
    Mesh mesh = a;
    std::vector<Index> place;
    for (const Vec3& p : b.vertices) {
        const auto it = std::find(mesh.vertices.begin(), mesh.vertices.end(), p);
        place.push_back(Index(it - mesh.vertices.begin()));
        if (it == mesh.vertices.end()) mesh.vertices.push_back(p);
    }
    for (const auto& [i, j, k] : b.facets)
        mesh.facets.push_back({place[i], place[j], place[k]});
    return mesh;
}

} // namespace facetmill::test
