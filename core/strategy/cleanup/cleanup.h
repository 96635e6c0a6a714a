// Clean-up (Lu 3.6): what a previous cutter could not enter is found on the mesh and cut with a smaller one,
// along valleys, with a vertical tool axis where that can be.
//
// Lu finds strips of type (a) where normals of neighbouring contact points turn by more than a limit per
// length (3.125), and of type (b) at single points; both from the contact points of a 3-axis path. On a
// faceted, noisy mesh normals turn sharply everywhere. Here the previous cutter itself is asked where it
// touches twice (valley.h) and how much it leaves there (rest_band.h): that is the same for creases and for
// fillets, and for any cutter. The limit of 3.125 is a curvature; where it is given, a ball of that
// curvature is asked too, and what it finds beyond the previous cutter's strips are strips of type (a).
//
// strip_passes.h cuts the strips of valleys, touch_up.h what they leave. On request there are also strips
// around contact points that a five-axis operation left without a posture, and around material that the
// verification finds after the operations before (left_strip.h).
//
// Where shank or holder would touch an upright tool, the axis is inclined until they are free, up to a limit
// (axis_tilt.h); the program is then one of five axes. What the smaller cutter cannot reach, and what its
// shank or holder keeps it from, is measured and reported (uncut_strips.h).
#pragma once

#include "core/strategy/plan/operation.h"

#include <span>

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
    bool left_points = false;   ///< strips also around contact points that operations before left
    bool rest_material = false; ///< strips also around material that the verification finds after them
    double tilt_limit = 0;    ///< largest inclination of the axis where shank or holder would touch, radians
    std::string switched_off; ///< names of strips that are not cut, separated by commas
};

/// The key of CleanupSettings::switched_off.
inline constexpr const char* switched_off_key = "switched_off";

const ParameterTable<CleanupSettings>& cleanup_parameters();

/// How the previous tool stood along the strips, for showing it.
struct CleanupRecord {
    struct Touch {
        std::size_t strip = 0; ///< index in StrategyResult::strips
        Vec3 center,
            tip;                     ///< the valley's centre on the part; the previous tool's tip
        std::array<Vec3, 2> touch{}; ///< where it touches
        double gap = 0;              ///< distance from the centre to the tool
    };
    Tool previous;
    std::vector<Touch> touches; ///< strip by strip, in order along each

    /// The touches of one strip; none where the tool does not touch twice along it.
    std::span<const Touch> of(std::size_t strip) const;
};

/// Is a strip of this name in the list of CleanupSettings::switched_off?
bool is_switched_off(const std::string& list, const std::string& name);
/// The list with the name in it (`on` false) or without it.
std::string with_switched(const std::string& list, const std::string& name, bool on);

class Cleanup : public OperationWith<CleanupSettings, cleanup_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "cleanup"; }
    Purpose purpose() const override { return Purpose::cleaning; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Cleanup>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    std::vector<long> further_tools() const override { return {settings_.previous_tool}; }
    void renumber_tool(long from, long to) override {
        Operation::renumber_tool(from, to);
        if (settings_.previous_tool == from) settings_.previous_tool = to;
    }
    bool reads_stock() const override { return true; }
    ReadsLeft reads_left() const override { return {settings_.left_points, settings_.rest_material}; }

    /// The result's strips are all that were found, its cusp_max is the most that stays where the cutter can
    /// go.
    ///
    /// Throws Error(missing_reference) where the previous tool is not given, Error(out_of_range) where
    /// tessellation tolerances use up the tolerance or a cutter is impossible, Error(empty_result) where the
    /// previous cutter leaves nothing above the tolerance, or the operations before have cut it.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
