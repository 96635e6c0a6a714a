// The contact points of passes whose ball was inclined afterwards, as finish5 remembers its own: with them
// the configuration space of each can be built again and shown (five_axis_study.h). A ball has no strip to
// hold there: what it clears does not depend on how it leans. Millimetres, radians, part coordinates.
#pragma once

#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/tilt/tilted_passes.h"

#include <memory>
#include <span>

namespace facetmill {

std::shared_ptr<const FiveAxisRecord> tilted_record(std::span<const Pass> passes,
                                                    const OperationCommon& settings,
                                                    const PlanContext& context, const TiltOptions& options,
                                                    const Progress& progress);

} // namespace facetmill
