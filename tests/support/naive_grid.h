// Facets in cubes: the one help that the naive check allows itself. Nearest facets, and whether a line meets
// any.
#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace facetmill::test {

class NaiveFacets {
public:
    explicit NaiveFacets(const Mesh& mesh);
    /// False where a facet is nearer to p than r.
    bool farther_than(const Vec3& p, double r) const;
    /// True where the line from p along d, from `start` on, meets no facet.
    bool open(const Vec3& p, const Vec3& d, double start) const;

private:
    std::size_t cell(const std::array<int, 3>& at) const {
        return (std::size_t(at[2]) * std::size_t(n_[1]) + std::size_t(at[1])) * std::size_t(n_[0])
               + std::size_t(at[0]);
    }
    int column(double v, int k) const {
        return std::clamp(int(std::floor((v - box_.lo[k]) / size_)), 0, n_[std::size_t(k)] - 1);
    }
    const Mesh& mesh_;
    Box3 box_;
    double size_ = 1;
    std::array<int, 3> n_{1, 1, 1};
    std::vector<std::vector<std::uint32_t>> cells_;
};

} // namespace facetmill::test
