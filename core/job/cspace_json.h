// One contact point's configuration space as `facetmill-cli cspace` writes it.
#pragma once

#include "core/base/units.h"
#include "core/strategy/five_axis/five_axis_study.h"

#include <string>

namespace facetmill {

/// Lengths in `unit`, angles in degrees: point, frame, `lead_deg`, `yaw_deg`, `delta_bottom`, `delta_top` and
/// `blocked` ([lambda][omega]; null where a surface is not finite), the causes' meanings, and the postures of
/// the three methods.
std::string cspace_json(const FiveAxisStudy& study, const FiveAxisStudy::Point& point, LengthUnit unit);

/// The same as a table with a line per posture:
/// lead_deg,yaw_deg,delta_bottom_UNIT,delta_top_UNIT,blocked. Values that are not finite are empty.
std::string cspace_csv(const FiveAxisStudy::Point& point, LengthUnit unit);

} // namespace facetmill
