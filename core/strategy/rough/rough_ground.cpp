#include "core/strategy/rough/rough_ground.h"

#include "core/base/parallel.h"
#include "core/strategy/rough/rough_floor.h"

#include <cmath>

namespace facetmill {

namespace {

/// Lines of a layer, at most: more come from a part in another unit.
constexpr double max_lines = 1e5;
/// Less than is stated, by this share, may stay beside floors, for the cutter itself may be kept as far from
/// there.
constexpr double kept_away_share = 0.05;

} // namespace

RoughGround::RoughGround(const RoughReach& reach, const DriveFrame& frame, const RoughMeasures& measures,
                         const RoughHeights& heights, const StockField& field, const Progress& progress)
    : divisions_(std::size_t(heights.divisions)) {
    const Box3& box = field.box();
    // In (u, v), and beyond the stock as far as the tool can still cut it or come in from.
    Vec2 lo(infinity, infinity), hi(-infinity, -infinity);
    for (int k = 0; k < 4; ++k) {
        const Vec3 corner(k & 1 ? box.hi.x() : box.lo.x(), k & 2 ? box.hi.y() : box.lo.y(), 0);
        const Vec2 p(frame.u(corner), frame.v(corner));
        lo = lo.cwiseMin(p);
        hi = hi.cwiseMax(p);
    }
    const double out = measures.profile.max_radius() + 2 * field.cell() + 2 * reach.spacing();
    const double n = std::max(1.0, std::ceil((hi.y() - lo.y()) / measures.stepover));
    if (n * heights.divisions > max_lines)
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "more than " + format_number(max_lines) + " lines a layer are asked for",
                    "choose a larger step-over or tolerance");
    grid_.emplace(reach, frame, lo.array() - out, hi.array() + out, progress.part(0, 0.45));
    const FloorJudge judge(measures.profile, heights.layers.heights, box.hi.z(),
                           (1 - kept_away_share) * heights.expected, measures.min_work);
    valleys_ = find_valleys(
        reach, *grid_, heights.low, field.highest(), heights.layers.depth_max,
        [&](const FloorPlace& place) { return judge.too_high(place); }, progress.part(0.45, 0.6));
    // Centred, with half a step to the borders, and one more line outside on either side, for what a sloping
    // side of the part leaves there.
    const double step =
        n > 1 || hi.y() - lo.y() > measures.stepover ? (hi.y() - lo.y()) / n : measures.stepover;
    const double first = 0.5 * (lo.y() + hi.y()) - 0.5 * (n - 1) * step;
    const auto count = std::size_t(n + 2) * divisions_;
    std::vector<std::optional<ReachLine>> lines(count);
    parallel_for(count, 1, progress.part(0.6, 1), [&](std::size_t i) {
        const double v = first + (double(i) / heights.divisions - 1) * step;
        lines[i].emplace(reach, frame, v, lo.x() - out, hi.x() + out);
    });
    for (auto& line : lines)
        lines_.push_back(std::move(*line));
    start_ = frame.xy(lo.x(), first);
}

} // namespace facetmill
