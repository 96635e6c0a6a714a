// Points in space by cells of a grid: which ones are near a place. Millimetres.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace facetmill {

class PointGrid {
public:
    /// `cell` > 0: about the distance that is asked for.
    explicit PointGrid(double cell) : cell_(cell) {}
    PointGrid(std::vector<Vec3> points, double cell) : points_(std::move(points)), cell_(cell) {
        for (std::size_t i = 0; i < points_.size(); ++i)
            cells_[key(place(points_[i]))].push_back(std::uint32_t(i));
    }

    /// Numbers are given in the order of adding, from 0.
    void add(const Vec3& p) {
        cells_[key(place(p))].push_back(std::uint32_t(points_.size()));
        points_.push_back(p);
    }
    /// False, and nothing is added, where the cell already holds a point.
    bool add_first(const Vec3& p) {
        auto& cell = cells_[key(place(p))];
        if (!cell.empty()) return false;
        cell.push_back(std::uint32_t(points_.size()));
        points_.push_back(p);
        return true;
    }

    const std::vector<Vec3>& points() const { return points_; }
    bool empty() const { return points_.empty(); }

    /// use(number) for every point within `reach` of p, and for some that are farther. The order does not
    /// depend on anything but the points and what is asked.
    template <class Use>
    void near(const Vec3& p, double reach, Use&& use) const {
        near_until(p, reach, [&](std::size_t i) {
            use(i);
            return false;
        });
    }
    /// The same, until use(number) returns true. True when one did.
    template <class Use>
    bool near_until(const Vec3& p, double reach, Use&& use) const {
        const Cell lo = place(p - Vec3::Constant(reach)), hi = place(p + Vec3::Constant(reach));
        const double asked =
            double(hi[0] - lo[0] + 1) * double(hi[1] - lo[1] + 1) * double(hi[2] - lo[2] + 1);
        if (asked > double(points_.size())) {
            for (std::size_t i = 0; i < points_.size(); ++i)
                if (use(i)) return true;
            return false;
        }
        for (long x = lo[0]; x <= hi[0]; ++x)
            for (long y = lo[1]; y <= hi[1]; ++y)
                for (long z = lo[2]; z <= hi[2]; ++z)
                    if (const auto it = cells_.find(key({x, y, z})); it != cells_.end())
                        for (const std::uint32_t i : it->second)
                            if (use(std::size_t(i))) return true;
        return false;
    }

private:
    using Cell = std::array<long, 3>;
    Cell place(const Vec3& p) const {
        return {std::lround(std::floor(p.x() / cell_)), std::lround(std::floor(p.y() / cell_)),
                std::lround(std::floor(p.z() / cell_))};
    }
    static std::uint64_t key(const Cell& c) {
        constexpr std::uint64_t mask = (std::uint64_t(1) << 21) - 1;
        return ((std::uint64_t(c[0]) & mask) << 42) | ((std::uint64_t(c[1]) & mask) << 21)
               | (std::uint64_t(c[2]) & mask);
    }

    std::vector<Vec3> points_;
    double cell_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

} // namespace facetmill
