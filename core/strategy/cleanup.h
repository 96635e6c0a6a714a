// Clean-up (Lu 3.6): what a previous cutter could not enter is found on the mesh and cut with a smaller one,
// along valleys, with a vertical tool axis.
//
// Lu finds strips of type (a) where normals of neighbouring contact points turn by more than a limit per
// length (3.125), and of type (b) at single points; both from the contact points of a 3-axis path. On a
// faceted, noisy mesh normals turn sharply everywhere. Here the previous cutter itself is asked where it
// touches twice (valley.h) and how much it leaves there (rest_band.h): that is the same for creases and for
// fillets, and for any cutter. The limit of 3.125 is a curvature; where it is given, a ball of that curvature
// is asked in the same way, and what it finds beyond the previous cutter's strips are strips of type (a).
//
// Strips are cut by strip_passes.h. What the smaller cutter cannot reach, and what its shank or holder keeps
// it from, is measured and reported.
#pragma once

#include "core/strategy/operation.h"

namespace facetmill {

struct CleanupSettings : OperationCommon {
    enum class Lift { strip, z };
    enum class Pattern { zigzag, oneway };

    CleanupSettings() { name = "Clean-up"; }
    long previous_tool = 1;
    NumberOrWord normal_change_limit{0, "auto"}; ///< radians per mm; auto: what the previous tool asks for
    Lift lift = Lift::strip;
    NumberOrWord overlap{0, "auto"};        ///< mm; auto: half the cutter's radius
    NumberOrWord smallest_strip{0, "auto"}; ///< mm; auto: the cutter's radius
    Pattern pattern = Pattern::zigzag;
    std::string switched_off; ///< names of strips that are not cut, separated by commas
};

const ParameterTable<CleanupSettings>& cleanup_parameters();

/// How the previous tool stood along the strips: for looking at it.
struct CleanupRecord {
    struct Touch {
        Vec3 center, tip;            ///< the valley's centre on the part; the previous tool's tip
        std::array<Vec3, 2> touch{}; ///< where it touches
        double gap = 0;              ///< from the centre to the tool
    };
    Tool previous;
    std::vector<Touch> touches;

    /// The one whose centre is nearest; null where there is none.
    const Touch* nearest(const Vec3& place) const;
};

class Cleanup : public OperationWith<CleanupSettings, cleanup_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "cleanup"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Cleanup>(settings_); }
    bool three_axis() const override { return true; }
    std::vector<long> further_tools() const override { return {settings_.previous_tool}; }

    /// `strips` are all that were found. `cusp_max`: the most that stays where the cutter can go.
    ///
    /// Throws Error(missing_reference) where the previous tool is not given, Error(out_of_range) where
    /// tessellation tolerances use up the tolerance or a cutter is impossible, Error(empty_result) where the
    /// previous cutter leaves nothing above the tolerance.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
