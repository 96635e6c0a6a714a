// A body as a scanner gives it: noise, holes, loose pieces, and whatever else goes wrong.
#pragma once

#include "core/mesh/mesh.h"
#include "tests/support/random_meshes.h"

#include <cmath>
#include <vector>

namespace facetmill::test {

/// A sphere of `rings` circles with 2 `rings` vertices each, and its two poles.
inline Mesh ringed_sphere(int rings, double radius, const Vec3& center = Vec3::Zero()) {
    Mesh mesh;
    const int around = 2 * rings;
    for (int j = 1; j <= rings; ++j)
        for (int i = 0; i < around; ++i) {
            const double u = 2 * pi * i / around, v = pi * j / (rings + 1);
            mesh.vertices.push_back(
                center + radius * Vec3(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v)));
        }
    const Index top = Index(mesh.vertices.size()), bottom = top + 1;
    mesh.vertices.push_back(center + Vec3(0, 0, radius));
    mesh.vertices.push_back(center - Vec3(0, 0, radius));
    for (int i = 0; i < around; ++i) {
        const int next = (i + 1) % around;
        mesh.facets.push_back({top, Index(i), Index(next)});
        for (int j = 0; j + 1 < rings; ++j) {
            const Index a = Index(j * around + i), b = Index(j * around + next), c = a + Index(around),
                        d = b + Index(around);
            mesh.facets.push_back({a, c, d});
            mesh.facets.push_back({a, d, b});
        }
        const Index last = Index((rings - 1) * around);
        mesh.facets.push_back({bottom, last + Index(next), last + Index(i)});
    }
    return mesh;
}

struct DirtyScan {
    Mesh mesh;
    std::vector<Vec3> clean; ///< where its first vertices are without noise
    std::size_t holes = 0;   ///< that were cut
};

/// A body about 50 mm in radius with waves of some millimetres, about 4 rings^2 facets. Every vertex is moved
/// along its ray by up to `noise`; holes of up to 2.5 mm in radius lie apart from each other; pieces of up to
/// 2 mm float around it.
inline DirtyScan dirty_scan(int rings, double noise, int holes, int pieces, std::uint64_t seed) {
    Random rng(seed);
    DirtyScan scan;
    scan.mesh = ringed_sphere(rings, 1);
    for (Vec3& p : scan.mesh.vertices) {
        const double r = 50
                         * (1 + 0.1 * std::sin(3 * p.x() + 1) * std::cos(4 * p.y())
                            + 0.04 * std::sin(9 * p.z()) * std::sin(7 * p.x()));
        scan.clean.push_back(r * p);
        p *= r + uniform(rng, -noise, noise);
    }
    const auto direction = [&] {
        Vec3 d;
        do {
            d = Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
        } while (d.norm() > 1 || d.norm() < 0.1);
        return Vec3(d.normalized());
    };
    std::vector<std::pair<Vec3, double>> cut; // middle, cosine of the angle
    for (int tries = 0; int(cut.size()) < holes && tries < 100 * holes; ++tries) {
        const Vec3 d = direction();
        bool apart = std::abs(d.z()) < 0.95;
        for (const auto& [other, angle] : cut)
            apart = apart && d.dot(other) < std::cos(0.12);
        if (apart) cut.emplace_back(d, std::cos(uniform(rng, 0.015, 0.05)));
    }
    scan.holes = cut.size();
    std::erase_if(scan.mesh.facets, [&](const Facet& f) {
        const Vec3 at = (scan.clean[f[0]] + scan.clean[f[1]] + scan.clean[f[2]]).normalized();
        for (const auto& [d, angle] : cut)
            if (at.dot(d) > angle) return true;
        return false;
    });
    for (int i = 0; i < pieces; ++i)
        append_mesh(scan.mesh, ringed_sphere(4, uniform(rng, 0.1, 1), uniform(rng, 65, 75) * direction()));
    return scan;
}

} // namespace facetmill::test
