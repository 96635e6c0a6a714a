// A region of the part's surface that another operation or a smaller tool is to cut: rework regions (Wang
// 2005), strips of clean-up (Lu 3.6). Millimetres, part coordinates.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

enum class StripKind : std::uint8_t {
    rework,     ///< the lead angle would have to be above the limit
    sharp,      ///< contact normals change too fast (Lu 3.125), type (a)
    valley,     ///< the cutter touches at two places, type (b)
    no_posture, ///< contact points without a free posture
    rest,       ///< material that the verification found
    foot,       ///< the previous cutter would go below the bottom of the stock
};

struct Strip {
    StripKind kind = StripKind::rework;
    std::string name;    ///< unique within the operation, and kept between plans where the strip is the same
    std::string reason;  ///< one line for the user
    long tool = 0;       ///< number of the tool that cuts it; 0: none yet
    bool enabled = true; ///< false: the user switched it off, it is not cut
    /// What it covers of the surface, cut along its boundaries; oriented as the part's facets.
    std::vector<std::array<Vec3, 3>> band;
    std::vector<std::vector<Vec3>> boundaries; ///< closed curves on the surface, first point not repeated
    std::vector<std::vector<Vec3>> centers;    ///< curves along valleys; a closed one ends where it began
    double area = 0;                           ///< of the band, mm^2
    double length = 0, width = 0;              ///< along the centre and the largest across it; 0: unknown; mm
};

/// The strip a point of the part's surface lies on; none where it lies on none. The part's size (mm, its
/// box's diagonal) says how near counts.
std::optional<std::size_t> strip_at(const Vec3& p, std::span<const Strip* const> strips, double part_size);

} // namespace facetmill
