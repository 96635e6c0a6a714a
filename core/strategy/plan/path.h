// What a strategy makes: passes of cutter contacts and cutter locations. Millimetres, part coordinates.
#pragma once

#include "core/base/vec.h"
#include "core/setup/motion.h"
#include "core/strategy/plan/strip.h"

#include <array>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace facetmill {

struct FiveAxisRecord; // five_axis_record.h
struct CleanupRecord;  // cleanup.h
struct ReworkPlan;     // rework_plan.h

/// One uninterrupted cut along one drive plane; cl[i] cuts cc[i].
struct Pass {
    int drive = 0;     ///< number of the drive plane, from 0
    double offset = 0; ///< its distance from the origin along the step-over direction
    std::vector<CutterContact> cc;
    std::vector<CutterLocation> cl;
    int layer = -1; ///< number of the layer or level from the top, else -1
    /// Roughing: the descent into the material that ends at the first CL; nothing stands above its first
    /// location or, without entry, above the first CL. Finishing: how high a link has to be, over the first.
    std::vector<CutterLocation> entry;
    /// The tool comes to it from the clearance height, however near the pass before ends: something stands
    /// beside the way along the surface. Finishing with three axes only.
    bool from_above = false;
};

/// Where a cutter that comes in across the turning axis cannot go (lathe_reach.h). Angles are those of
/// TurnedPath, radians, and begin within the first turn; lengths along the axis, mm.
struct UnreachedRegion {
    enum class Why { narrow, covered, shaft, core, held };
    Why why = Why::narrow;
    double area = 0; ///< mm^2 of the part's surface
    double angle_from = 0, angle_to = 0, from = 0, to = 0;
    double distance = 0; ///< how far from what the allowance leaves the cutter stays at most, mm
};
/// "narrow", "covered", "shaft", "core", "held".
const char* unreached_name(UnreachedRegion::Why why);

/// Rough's own: the layers it cut, from the top.
struct RoughPath {
    std::vector<double> layers; ///< tip heights, mm
    double stock_cell = 0;      ///< size of the cells of the stock it planned with, mm
    double depth_max = 0;       ///< of the layers that were planned, mm
};

/// Leads that the tool takes, radians; none where the range is empty.
struct LeadRange {
    double lead_min = infinity, lead_max = -infinity;
    bool any() const { return lead_min <= lead_max; }
};

/// A path whose tool axis is chosen for every contact point (finish5.h).
struct TiltedPath : LeadRange {
    /// Wall seconds: contact points and step-over, bottom and top surfaces of the configuration spaces,
    /// choosing and joining postures.
    std::array<double, 4> stage_seconds{};
    std::shared_ptr<const FiveAxisRecord> record; ///< every contact point and its choice
};

/// The main path of global-local CM2 (global_local.h). Its rework regions are the result's strips.
struct GlobalLocalPath : TiltedPath {
    std::shared_ptr<const ReworkPlan>
        rework; ///< how they were found, and the path of the tool that cuts them
};

/// Clean-up's own; leads only where it may incline the tool.
struct CleanupPath : LeadRange {
    std::shared_ptr<const CleanupRecord> record; ///< how the previous tool stands along the strips
};

/// A path on a part that turns about an axis (lathe-mill), and what it is measured in. Angle 0 is at `zero`,
/// angles turn it by the right hand about the axis; lengths along the axis count from its point.
struct TurnedPath {
    TurningAxis axis;
    Vec3 zero = Vec3::UnitZ(); ///< unit vector across the axis
    double part_radius = 0;    ///< largest distance of the part from the axis
    double stock_radius = 0;   ///< of the stock
    double from = 0, to = 0;   ///< places along the axis that the path begins and ends at
    double side_feed_max = 0;  ///< largest advance in a turn, mm; lengthwise lines: the largest angle
    std::size_t at_core = 0;   ///< CL points where nothing but the core radius holds the tool
    double surface_area = 0;   ///< surface searched for places that the cutter cannot go to, mm^2
    std::vector<UnreachedRegion> unreached; ///< the largest first; looked for by finishing
    std::vector<double> layers; ///< roughing: distances of the tip from the axis, from the outermost
};

/// What a strategy makes: what every kind of operation has, and `detail`, which only one kind fills.
struct StrategyResult {
    std::vector<Pass> passes; ///< in machining order, already turned (zigzag or one way)
    int drive_planes = 0;     ///< what reports call "passes"
    double stepover_min = 0, stepover_max = 0;
    double direction = 0;         ///< angle of travel from X, radians
    std::string direction_reason; ///< why, where it was chosen among several; else empty
    double cusp_max = 0; ///< largest cusp to expect where the cutter can go, chord tolerance included; mm
    double chord_tolerance = 0; ///< how far moves may run beside the exact path; 0: the strategy has none; mm
    std::size_t cleanup_points = 0;     ///< CC points left for clean-up
    std::vector<CutterContact> cleanup; ///< those points, where the strategy knows them
    std::vector<Strip> strips;          ///< regions that the operation found, also those switched off
    std::vector<std::string> warnings;
    std::variant<std::monostate, RoughPath, TiltedPath, GlobalLocalPath, CleanupPath, TurnedPath> detail;

    /// The detail as a T, or what of it is a T: `as<TiltedPath>()` also sees global-local CM2, and
    /// `as<LeadRange>()` whatever knows its leads. Null where there is none.
    template <class T>
    const T* as() const {
        return std::visit(
            [](const auto& kind) -> const T* {
                if constexpr (std::is_base_of_v<T, std::decay_t<decltype(kind)>>)
                    return &kind;
                else
                    return nullptr;
            },
            detail);
    }
    /// What the posture of every contact point was chosen from; null where the tool axis is not chosen.
    std::shared_ptr<const FiveAxisRecord> five_axis() const {
        const auto* tilted = as<TiltedPath>();
        return tilted ? tilted->record : nullptr;
    }
};

} // namespace facetmill
