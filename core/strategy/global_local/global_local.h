// Global-local CM2 (Wang): one main path over the whole part whose lead is capped at alpha_M, so that
// its strips stay wide, and a rework path with a smaller tool where that is not enough.
//
//  1. The assumed previous path and its screening by alpha_M (assumed_path.h) give the uncut places, these
//     the rework regions on the part's surface (find_regions.h).
//  2. The main path is that of five-axis finishing (finish5.h) over the part without the uncut places, with
//     leads from 0 to alpha_M and partial passes where strips are narrow; those that the rework tool cuts as
//     well are left to it. No pass may cut into any place of the whole part.
//  3. What the main path really clears is looked at pose by pose (coverage.h). Places that it leaves, at
//     slanted ends of passes for example, join the regions.
//  4. The rework path covers the regions with their outward offset: a ball with vertical axis along parallel
//     planes (finish3.h), or a smaller flat or bull-nosed cutter by CM2. It has a tool and a program of its
//     own.
//
// What neither path clears is left to clean-up and said.
//
// Capping the lead need not pay: where the main tool reaches nearly everything, what limits its strips may be
// the part's roundness, and rework only adds to it. So passes all over the part with leads up to the assumed
// limit are planned too, with regions where those leave something, and the plan that takes less time is the
// one given.
#pragma once

#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/global_local/rework_plan.h"

namespace facetmill {

struct GlobalLocalSettings : Finish5Settings {
    enum class ReworkCutting { ball, cm2 };

    GlobalLocalSettings() {
        name = "Global-local";
        tolerance = 0.05;
    }
    double lead_limit = radians(8);          ///< alpha_M
    double assumed_lead_limit = radians(45); ///< the assumed previous path's
    /// Where leads up to the assumed limit take less time all over the part, rework of what they leave
    /// included, they are used instead.
    bool raise_lead_limit = true;
    double rework_offset = 2; ///< mm
    long rework_tool = 0;     ///< 0: none, the regions are left to other operations
    ReworkCutting rework_cutting = ReworkCutting::ball;
    /// F of Wang (10), (11), and the rework path's travel; auto: the main path's.
    NumberOrWord machining_direction{0, "auto"};
    std::array<double, 3> view_direction{0, 0, 1}; ///< V of (10), (11)
    std::vector<RegionEdit> region_edits;
    std::vector<BoundaryDrag> boundary_drags;
};

const ParameterTable<GlobalLocalSettings>& global_local_parameters();

/// Whether passes all over the part with leads up to the assumed limit are planned too. Not without a rework
/// tool, as nobody knows what rework takes then, nor for regions that somebody has edited.
bool may_raise_lead_limit(const GlobalLocalSettings& settings);

class GlobalLocal : public OperationWith<GlobalLocalSettings, global_local_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "global_local"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<GlobalLocal>(settings_); }
    bool keeps_axis() const override { return false; }
    double holder_clearance() const override { return settings_.holder_clearance; }
    bool accelerations() const override { return settings_.accelerations; }
    std::vector<long> further_tools() const override {
        if (settings_.rework_tool == 0) return {};
        return {settings_.rework_tool};
    }
    void renumber_tool(long from, long to) override {
        Operation::renumber_tool(from, to);
        if (settings_.rework_tool == from) settings_.rework_tool = to;
    }
    const GlobalLocalSettings* rework() const override { return &settings_; }

    /// Throws what Finish5::plan does; Error(out_of_range) as find_regions does, and for a rework tool that
    /// does not suit the cutting; Error(empty_result) where the lead limit leaves next to nothing to the main
    /// path.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
