#include "core/strategy/curves/gap_judge.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <array>

namespace facetmill {

namespace {

/// Where between two lines, from one to the other.
constexpr std::array<double, 5> rows{0.5, 0.25, 0.75, 0.125, 0.875};

} // namespace

bool GapJudge::is_high(const Vec2& at, const SweptPasses& swept, LiftHint& hint) const {
    const AxialContact touched = job_.lift.contact(at.x(), at.y(), hint);
    if (touched.facet == no_index || touched.tip_z < job_.domain.lowest_tip()) return false;
    const Vec3 tip(at.x(), at.y(), touched.tip_z);
    const CutterContact c = job_.contact_of(touched, tip);
    if (c.normal.z() < tolerance::vertical_normal_z) return false;
    const Vec3 over = c.point + (job_.allowance + job_.gap_cusp()) * c.normal;
    return swept.lowest(over, tip, over.z()) > over.z() && job_.in_domain(at, 0);
}

std::vector<char> GapJudge::high(std::span<const AcrossGap> gap, const SweptPasses& swept,
                                 const Progress& progress) const {
    std::vector<char> high(gap.size(), 0);
    constexpr std::size_t block = 64;
    parallel_blocks(gap.size(), block, progress.part(0, 0), [&](std::size_t begin, std::size_t end) {
        LiftHint hint;
        for (std::size_t i = begin; i < end; ++i)
            high[i] = std::any_of(rows.begin(), rows.end(), [&](double row) {
                return is_high(gap[i].a + row * (gap[i].b - gap[i].a), swept, hint);
            });
    });
    return high;
}

} // namespace facetmill
