// What the scan room's panel shows of a survey, a recipe and what was tried.
#pragma once

#include "ui/scan_panel.h"
#include "ui/scan_study.h"

#include <vector>

namespace facetmill::ui {

/// The lines of the survey, with pieces and holes by themselves as far as `listed_parts` goes. `after`: what
/// the recipe made of the mesh; null where that is not known.
std::vector<ScanPanel::Line> survey_rows(const ScannedMesh& scan, const ScannedMesh* after,
                                         const std::vector<RepairStep>& recipe, LengthUnit unit);
inline constexpr std::size_t listed_parts = 500;

/// "10 × 8 × 2 mm · watertight"; `scaled`: the part is not as large as its file says.
QString scan_size(const ScannedMesh& scan, bool scaled, LengthUnit unit);
/// A step of the recipe: why it failed (empty: it did not), what it came to when it was tried, or when the
/// part was read; null where it was not.
ScanPanel::Step step_row(const RepairStep& step, const QString& failure, const TriedStepPtr& tried,
                         const StepReport* read, LengthUnit unit);
/// What a step of the recipe is for, and how much it takes by what the survey says.
QString step_remark(const ScannedMesh& scan, const std::vector<RepairStep>& recipe, std::size_t i);
/// What a recipe that was tried to its end comes to in all.
QString trial_summary(const ScanTrial& trial, LengthUnit unit);

} // namespace facetmill::ui
