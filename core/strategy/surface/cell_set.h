// Cells of a grid in space: has one been met before? Takes a tenth of the room that a PointGrid takes.
// Millimetres.
#pragma once

#include "core/base/vec.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace facetmill {

class CellSet {
public:
    explicit CellSet(double cell) : cell_(cell), slots_(16, 0) {}

    /// True where no point was in this one's cell before.
    bool add_first(const Vec3& p) {
        if (2 * (count_ + 1) > slots_.size()) grow();
        if (!put(key(p))) return false;
        ++count_;
        return true;
    }

private:
    /// Never 0, which stands for an empty slot.
    std::uint64_t key(const Vec3& p) const {
        constexpr std::uint64_t mask = (std::uint64_t(1) << 21) - 1;
        const auto place = [&](double x) {
            return std::uint64_t(std::int64_t(std::floor(x / cell_))) & mask;
        };
        return (std::uint64_t(1) << 63) | (place(p.x()) << 42) | (place(p.y()) << 21) | place(p.z());
    }
    bool put(std::uint64_t key) {
        std::uint64_t h = key * 0x9E3779B97F4A7C15u; // so that neighbours are far apart
        for (std::uint64_t at = (h ^ (h >> 32)) & (slots_.size() - 1);; at = (at + 1) & (slots_.size() - 1)) {
            if (slots_[at] == key) return false;
            if (slots_[at] != 0) continue;
            slots_[at] = key;
            return true;
        }
    }
    void grow() {
        std::vector<std::uint64_t> old(2 * slots_.size(), 0);
        old.swap(slots_);
        for (const std::uint64_t k : old)
            if (k != 0) put(k);
    }

    double cell_;
    std::vector<std::uint64_t> slots_; ///< a power of two, half of them empty at least
    std::size_t count_ = 0;
};

} // namespace facetmill
