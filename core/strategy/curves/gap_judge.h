// What two neighbouring passes along curves leave between them, asked at places between. Millimetres, part
// coordinates.
#pragma once

#include "core/strategy/curves/curve_job.h"
#include "core/strategy/waterline/level_sweep.h"

namespace facetmill {

/// Two places that lie opposite each other on neighbouring lines.
struct AcrossGap {
    Vec2 a, b;
};

class GapJudge {
public:
    explicit GapJudge(const CurveJob& job) : job_(job) {}

    /// Where more than CurveJob::gap_cusp stays between the places of a pair, when the cutter has gone along
    /// `swept`: 1 or 0 for each. Places that no tip in between could cut do not count.
    std::vector<char> high(std::span<const AcrossGap> gap, const SweptPasses& swept,
                           const Progress& progress) const;
    /// How far apart places along a line are looked at.
    double spacing() const { return look_share * job_.radius(); }

private:
    static constexpr double look_share = 0.15;
    bool is_high(const Vec2& tip, const SweptPasses& swept, LiftHint& hint) const;

    const CurveJob& job_;
};

} // namespace facetmill
