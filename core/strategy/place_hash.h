// Numbers by places: which are near to a point. Millimetres.
#pragma once

#include "core/base/vec.h"
#include "core/mesh/mesh.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace facetmill {

class PlaceHash {
public:
    explicit PlaceHash(double cell) : cell_(cell) {}

    void add(const Vec3& at, Index number) { cells_[key(cell_of(at))].push_back(number); }
    /// False, and nothing is added, where the cell already holds something.
    bool add_first(const Vec3& at, Index number) {
        auto& cell = cells_[key(cell_of(at))];
        if (!cell.empty()) return false;
        cell.push_back(number);
        return true;
    }
    /// visit(number) for all within `radius` of `at`, and maybe others, in the order of cells.
    template <class Visit>
    void near(const Vec3& at, double radius, Visit&& visit) const {
        near_until(at, radius, [&](Index number) {
            visit(number);
            return false;
        });
    }
    /// The same, until visit returns true.
    template <class Visit>
    void near_until(const Vec3& at, double radius, Visit&& visit) const {
        const Cell lo = cell_of(at - Vec3::Constant(radius)), hi = cell_of(at + Vec3::Constant(radius));
        for (std::int64_t x = lo[0]; x <= hi[0]; ++x)
            for (std::int64_t y = lo[1]; y <= hi[1]; ++y)
                for (std::int64_t z = lo[2]; z <= hi[2]; ++z)
                    if (const auto cell = cells_.find(key({x, y, z})); cell != cells_.end())
                        for (const Index number : cell->second)
                            if (visit(number)) return;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    Cell cell_of(const Vec3& p) const {
        return {std::int64_t(std::floor(p.x() / cell_)), std::int64_t(std::floor(p.y() / cell_)),
                std::int64_t(std::floor(p.z() / cell_))};
    }
    /// Cells that share a key are visited together: "maybe others".
    static std::uint64_t key(const Cell& c) {
        std::uint64_t h = 0;
        for (const std::int64_t v : c)
            h = (h ^ std::uint64_t(v)) * 0x9E3779B97F4A7C15ull + (h >> 29);
        return h;
    }
    double cell_;
    std::unordered_map<std::uint64_t, std::vector<Index>> cells_;
};

} // namespace facetmill
