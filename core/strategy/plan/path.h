// What a strategy makes: passes of cutter contacts and cutter locations. Millimetres, part coordinates.
#pragma once

#include "core/base/vec.h"
#include "core/setup/motion.h"
#include "core/strategy/plan/strip.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
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
    int layer = -1; ///< of roughing, from the top
    /// Of roughing: the way down into the material, a ramp or a helix that ends at the first CL. Above its
    /// first place, or without one above the first CL, nothing stands.
    std::vector<CutterLocation> entry;
};

/// Where a cutter that comes in across the turning axis cannot go (lathe_reach.h). Angles as of TurnedPath,
/// radians, from within the first turn; lengths along the axis, mm.
struct UnreachedRegion {
    enum class Why { narrow, covered, shaft, core, held };
    Why why = Why::narrow;
    double area = 0; ///< mm^2 of the part's surface
    double angle_from = 0, angle_to = 0, from = 0, to = 0;
    double distance = 0; ///< how far from what the allowance leaves the cutter stays at most, mm
};
/// "narrow", "covered", "shaft", "core", "held".
const char* unreached_name(UnreachedRegion::Why why);

/// Of a part that turns about an axis (lathe-mill): what its path is measured in. Angle 0 is at `zero`,
/// angles turn it by the right hand about the axis; lengths along the axis count from its point.
struct TurnedPath {
    TurningAxis axis;
    Vec3 zero = Vec3::UnitZ(); ///< unit vector across the axis
    double part_radius = 0;    ///< largest distance of the part from the axis
    double stock_radius = 0;   ///< of the stock
    double from = 0, to = 0;   ///< places along the axis that the path begins and ends at
    double side_feed_max = 0;  ///< largest advance in a turn, mm; of lengthwise lines the largest angle
    std::size_t at_core = 0;   ///< CL points where nothing but the core radius holds the tool
    double surface_area = 0;   ///< of what was looked at for places that the cutter cannot go to, mm^2
    std::vector<UnreachedRegion> unreached; ///< the largest first; looked for by finishing
};

struct StrategyResult {
    std::vector<Pass> passes; ///< in machining order, already turned (zigzag or one way)
    int drive_planes = 0;     ///< what reports call "passes"
    double stepover_min = 0, stepover_max = 0;
    double direction = 0; ///< angle of travel from X, radians
    double cusp_max = 0;  ///< largest cusp to expect where the cutter can go, chord tolerance included; mm
    double chord_tolerance = 0; ///< how far moves may run beside the exact path; 0: the strategy has none; mm
    std::size_t cleanup_points = 0;     ///< CC points left for clean-up
    std::vector<CutterContact> cleanup; ///< those points, where the strategy knows them
    /// Of a 5-axis strategy, wall seconds: contact points and step-over, bottom and top surfaces of the
    /// configuration spaces, choosing and joining postures.
    std::array<double, 4> stage_seconds{};
    double lead_min = infinity, lead_max = -infinity; ///< inclinations used, radians; 5-axis only
    std::shared_ptr<const FiveAxisRecord> five_axis;  ///< of every contact point; 5-axis only
    std::size_t rework_regions = 0;                   ///< regions left for a rework operation
    /// How they were found, and the path of the tool that cuts them.
    std::shared_ptr<const ReworkPlan> rework;
    std::vector<Strip> strips; ///< regions that the operation found, also those switched off
    std::shared_ptr<const CleanupRecord> cleanup_record; ///< of clean-up: how the previous tool stands
    std::vector<double> layers;       ///< of roughing: tip heights of the layers that are cut, from the top
    double stock_cell = 0;            ///< of roughing: size of the cells of the stock it planned with, mm
    std::optional<TurnedPath> turned; ///< of a turning part only
    std::vector<std::string> warnings;
};

} // namespace facetmill
