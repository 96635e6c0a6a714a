// The cutter as the passes of any course move it, endless upward: for what they leave (uncut.h). Millimetres,
// part coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/finish3/uncut.h"
#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/point_grid.h"

#include <map>
#include <span>
#include <vector>

namespace facetmill {

class LevelSweep : public SweptPasses {
public:
    /// `profile` has to live as long as this.
    LevelSweep(std::span<const Pass> passes, const CutterProfile& profile, const Progress& progress);

    double lowest(const Vec3& q, const Vec3& hint, double enough) const override;

private:
    struct Piece {
        Vec3 a, b;
    };
    void add(const Vec3& a, const Vec3& b);
    /// Exact where it is below `enough`.
    double over(const Piece& piece, const Vec3& q, double enough) const;
    std::pair<long, long> tile(const Vec2& p) const;

    const CutterProfile& profile_;
    double radius_;
    std::vector<Piece> pieces_;
    PointGrid middles_;
    std::map<std::pair<long, long>, std::vector<std::uint32_t>> tiles_; ///< lowest pieces first
};

/// Passes of any course, and those left out for shank and holder.
struct SweptCourses {
    std::span<const Pass> passes, left_out;
};
/// What they leave by more than the cusp that is allowed. `input` has the facets, the cutter and its lift,
/// the allowance and the lowest tip; the rest is put in here.
UncutReport uncut_by_levels(UncutInput input, const PlanContext& context, const SweptCourses& courses,
                            const CutterProfile& profile, double cusp_allowed, const Progress& progress);

} // namespace facetmill
