// What the tests of the scan room ask of a mesh.
#pragma once

#include "core/mesh/mesh_report.h"
#include "core/mesh/triangle_distance.h"
#include "core/repair/repair.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace facetmill::test {

inline MeshReport report_of_mesh(const Mesh& mesh) {
    MeshReport report;
    analyse_mesh(mesh, report, {});
    return report;
}

inline Repaired repaired(const Mesh& mesh, const std::vector<RepairStep>& recipe) {
    return run_recipe(std::make_shared<Mesh>(mesh), recipe, {});
}

/// A facet as three places, the first one first: the same for the same bits, whatever the numbers.
using Places = std::array<std::array<double, 3>, 3>;
inline Places places_of(const Mesh& mesh, std::size_t f) {
    Places p;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
            p[std::size_t(k)][std::size_t(i)] = mesh.corner(f, k)[i];
    return p;
}
inline std::multiset<Places> all_places(const Mesh& mesh) {
    std::multiset<Places> all;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        all.insert(places_of(mesh, f));
    return all;
}

/// Whether every facet of `part` stands in `whole` with the same bits, and in the same order.
inline bool stands_in_order(const Mesh& part, const Mesh& whole) {
    std::size_t at = 0;
    for (std::size_t f = 0; f < part.facet_count(); ++f) {
        while (at < whole.facet_count() && places_of(whole, at) != places_of(part, f))
            ++at;
        if (at++ == whole.facet_count()) return false;
    }
    return true;
}

/// Distance from every facet: no index, no bound.
inline double brute_distance(const Vec3& p, const Mesh& mesh) {
    double least = infinity;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        least = std::min(least, squared_distance(p, mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)));
    return std::sqrt(least);
}
/// The largest over corners, middles of sides and middles of facets.
inline double brute_deviation(const Mesh& from, const Mesh& to) {
    double most = 0;
    for (std::size_t f = 0; f < from.facet_count(); ++f) {
        const Vec3 &a = from.corner(f, 0), &b = from.corner(f, 1), &c = from.corner(f, 2);
        for (const Vec3& p :
             {a, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2), Vec3((a + b + c) / 3)})
            most = std::max(most, brute_distance(p, to));
    }
    return most;
}

inline bool equal_meshes(const Mesh& a, const Mesh& b) {
    return a.facets == b.facets && a.vertices == b.vertices;
}

} // namespace facetmill::test
