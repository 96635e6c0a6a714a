// Parts for turning whose surface is given in closed form.
#pragma once

#include "core/mesh/mesh.h"

#include <cmath>

namespace facetmill::test {

/// A closed part along X whose radius is given by angle (0 at +Y) and place, from x = 0 to `length`.
template <class Radius>
Mesh turned_part(int around, int along, double length, Radius radius) {
    Mesh m;
    for (int i = 0; i <= along; ++i)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * pi * k / around, x = length * i / along, r = radius(angle, x);
            m.vertices.emplace_back(x, r * std::cos(angle), r * std::sin(angle));
        }
    const auto at = [&](int i, int k) { return Index(i * around + k % around); };
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < around; ++k) {
            m.facets.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
            m.facets.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
        }
    const auto low = Index(m.vertices.size()), high = low + 1;
    m.vertices.emplace_back(0, 0, 0);
    m.vertices.emplace_back(length, 0, 0);
    for (int k = 0; k < around; ++k) {
        m.facets.push_back({low, at(0, k + 1), at(0, k)});
        m.facets.push_back({high, at(along, k), at(along, k + 1)});
    }
    return m;
}

} // namespace facetmill::test
