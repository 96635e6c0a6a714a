// Random numbers and the meshes that several tests of the contact kernel use.
#pragma once

#include "core/mesh/mesh.h"

#include <cmath>
#include <functional>
#include <memory>
#include <random>

namespace facetmill::test {

using Random = std::mt19937_64;

inline double uniform(Random& rng, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(rng);
}
inline int whole(Random& rng, int lo, int hi) {
    return std::uniform_int_distribution<int>(lo, hi)(rng);
}

/// The graph of z over a square from the origin, 2 n^2 facets; every vertex is moved along X and Y by up to
/// `jitter` of the grid's step.
inline std::shared_ptr<Mesh> field(int n, double size, const std::function<double(double, double)>& z,
                                   double jitter = 0, std::uint64_t seed = 1) {
    Random rng(seed);
    const auto mesh = std::make_shared<Mesh>();
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = size * (i + jitter * uniform(rng, -1, 1)) / n;
            const double y = size * (j + jitter * uniform(rng, -1, 1)) / n;
            mesh->vertices.push_back(Vec3(x, y, z(x, y)));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = Index(j * (n + 1) + i), b = a + 1, c = a + Index(n) + 1, d = c + 1;
            mesh->facets.push_back({a, b, d});
            mesh->facets.push_back({a, d, c});
        }
    return mesh;
}

/// Facets of all sizes anywhere, a fifth of them needles.
inline std::shared_ptr<Mesh> soup(int facets, double size, std::uint64_t seed) {
    Random rng(seed);
    const auto mesh = std::make_shared<Mesh>();
    for (int f = 0; f < facets; ++f) {
        const Vec3 at(uniform(rng, 0, size), uniform(rng, 0, size), uniform(rng, 0, 0.3 * size));
        const double extent = size * std::exp(uniform(rng, -4, -1));
        for (int k = 0; k < 3; ++k)
            mesh->vertices.push_back(
                at + extent * Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)));
        if (f % 5 == 0)
            mesh->vertices.back() =
                mesh->vertices[mesh->vertices.size() - 2] + Vec3(1e-7, 1e-6, 1e-8) * uniform(rng, 0, 1);
        const Index v = Index(3 * f);
        mesh->facets.push_back({v, v + 1, v + 2});
    }
    return mesh;
}

/// Strips of two facets each at 37 degrees across a square from the origin; every `upright`th is an upright
/// wall (0: none).
inline std::shared_ptr<Mesh> needles_askew(int strips, double size, int upright = 0) {
    const double c = 0.8, s = 0.6;
    const auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i <= strips; ++i) {
        const int row = upright > 0 ? i - i / upright : i;
        const double v = size * (double(row) / strips - 0.5),
                     z = 3 * std::sin(0.3 * v) + (upright > 0 ? i / upright % 3 : 0);
        for (const double u : {-0.5 * size, 0.5 * size})
            mesh->vertices.emplace_back(0.5 * size + c * u - s * v, 0.5 * size + s * u + c * v, z);
    }
    for (int i = 0; i < strips; ++i) {
        const Index a = Index(2 * i);
        mesh->facets.push_back({a, a + 1, a + 3});
        mesh->facets.push_back({a, a + 3, a + 2});
    }
    return mesh;
}

} // namespace facetmill::test
