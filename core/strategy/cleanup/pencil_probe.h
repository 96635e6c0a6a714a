// The cutter let down on the part, and the jump of the touched point from one flank of a valley to the other.
// Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/valley.h"

#include <optional>

namespace facetmill {

/// The cutter let down at a place.
struct CutterTouch {
    bool valid = false; ///< false: it meets nothing
    Vec3 tip, point, normal;
    Vec3 feature; ///< the touched point from the tip, in radii
};

class PencilProbe {
public:
    explicit PencilProbe(const ValleyInput& input) : in_(input), radius_(input.cover->radius()) {}

    double radius() const { return radius_; }

    /// Touched points on the same flank move by no more than this between two steps, in radii.
    static constexpr double max_move = 0.45;

    /// The hint is that of places close by.
    CutterTouch touch_at(const Vec2& at, LiftHint& hint) const;

    /// The cutter that touches twice, between two places beside each other where it touches different flanks.
    PencilPoint pencil(const CutterTouch& left, const CutterTouch& right) const;

    /// How far the touched points have moved under the cutter from one place to another, in radii.
    double moved(const PencilPoint& a, const PencilPoint& b) const;

    /// The jump between the touches `a` at `lo` and `b` at `hi`, found by halving that stretch; nothing where
    /// both touch the same flank or the part ends between them. `at` gives the touch at a parameter.
    template <class At>
    std::optional<std::array<CutterTouch, 2>> jump(At&& at, double lo, double hi, CutterTouch a,
                                                   CutterTouch b, int halvings) const {
        if (same_flank(a, b)) return std::nullopt;
        for (int i = 0; i < halvings; ++i) {
            const double mid = 0.5 * (lo + hi);
            const CutterTouch t = at(mid);
            if (!t.valid) return std::nullopt;
            if (apart(t, a) <= apart(t, b)) {
                a = t;
                lo = mid;
            } else {
                b = t;
                hi = mid;
            }
            if (same_flank(a, b)) return std::nullopt;
        }
        return std::array{a, b};
    }

private:
    static double apart(const CutterTouch& a, const CutterTouch& b) { return (a.feature - b.feature).norm(); }
    static bool same_flank(const CutterTouch& a, const CutterTouch& b);
    Vec3 feature(const PencilPoint& p, std::size_t side) const { return (p.touch[side] - p.tip) / radius_; }

    const ValleyInput& in_;
    double radius_;
};

/// The same place of a curve that is followed the other way: left and right change sides.
PencilPoint turned_round(PencilPoint p);

/// A place on a valley, about: good enough to say whether the valley is known.
struct PencilSeed {
    PencilPoint about;
    Vec2 from, ahead; ///< where the tip was a stride before, and where it went, unit
};

/// Places on valleys, from the samples where the cutter leaves something: its tip is moved away from the
/// flank that holds it up until another one does.
std::vector<PencilSeed> pencil_seeds(const ValleyInput& input, const std::vector<RestSample>& samples,
                                     const Progress& progress);
/// The place to rounding; nothing where it turns out to be none.
std::optional<PencilPoint> pencil_at(const PencilProbe& probe, const PencilSeed& seed);

} // namespace facetmill
