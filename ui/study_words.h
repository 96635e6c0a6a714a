// The words of studies (core/study) as the window says them: measures, how closely was looked, what became of
// a candidate.
#pragma once

#include "core/base/units.h"
#include "core/study/study_results.h"

#include <QString>

namespace facetmill::ui {

/// "Largest excess".
QString measure_label(Measure measure);
/// The same with its unit, for heads of tables and axes: "Largest excess (in)".
QString measure_head(Measure measure, LengthUnit unit);
/// "0.0021", "26 min 26 s", "0.1 %": a value as studies have it, lengths without their unit.
QString measure_text(Measure measure, double value);
/// What is typed for a limit of a measure: times are minutes. Factor from there to what studies have.
double measure_typed(Measure measure);

/// "planned", "judged coarsely", "judged finely".
QString rung_label(Rung rung);
QString standing_label(CandidateStanding standing);

} // namespace facetmill::ui
