// What all phases of a clean-up plan read: part, cutter and budgets. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/cleanup/standing.h"
#include "core/strategy/cleanup/strip_passes.h"
#include "core/strategy/plan/plan_text.h"

namespace facetmill {

struct CleanupJob {
    CleanupJob(const CleanupSettings& asked, const PlanContext& given, const Progress& progress);

    /// As passes are planned with it.
    StripCutting cutting() const;
    /// For a cutter that is asked what it leaves.
    ValleyInput asking(const AxialLift& other, const CutterCover& its_cover) const;

    const CleanupSettings& settings;
    const PlanContext& context;
    PlanText text;
    double cusp, chord; ///< what may stay; how far moves may run into the part
    double allowance;   ///< with what tessellation may have moved the part
    CutterProfile profile;
    CutterCover cover;
    AxialLift lift; ///< with the allowance
    FacetGrid grid;
    UpSide side;
    Standing standing;
    double radius, ripple, overlap;
};

} // namespace facetmill
