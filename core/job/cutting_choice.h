// Feeds and speeds that an operation takes over from its tool.
#pragma once

#include "core/setup/tool.h"
#include "core/strategy/plan/operation.h"

#include <string>
#include <vector>

namespace facetmill {

/// Feed of cuts, mm/min: as it is said, else spindle times flutes times chip load; 0 where that is unsaid,
/// too.
double cutting_feed(const Tool& tool, const CuttingData& data);
/// They say spindle and feed: an operation can run by them.
bool is_complete(const Tool& tool, const CuttingData& data);
/// The data for this material, or the first where none is named, of those that are complete; null where none
/// is.
const CuttingData* cutting_for(const Tool& tool, const std::string& material = {});

/// Spindle, feed and ramp feed of an operation, of roughing also depth and step-over, as far as they are
/// said. Whatever no operation may have is left as it is.
void run_by(Operation& operation, const Tool& tool, const CuttingData& data);
/// The data of its tool that an operation runs by; null where it runs by none.
const CuttingData* runs_by(const Operation& operation, const Tool& tool);

/// Another tool for an operation. Where it ran by data of the one before, or as operations of its kind begin,
/// it runs by those of the new one, for the same material; where that has none for it, feeds stay as they
/// are. Throws Error(out_of_range) for a number that no tool may have.
void change_tool(Operation& operation, const std::vector<Tool>& tools, long number);

} // namespace facetmill
