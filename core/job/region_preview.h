// Rework regions of an operation without planning it: for dialogs that show what a change would bring. Keeps
// the assumed previous path between calls as long as nothing it depends on changes.
#pragma once

#include "core/job/planner.h"
#include "core/strategy/global_local/find_regions.h"
#include "core/strategy/global_local/tool_advice.h"

#include <memory>
#include <string>

namespace facetmill {

class RegionPreview {
public:
    struct Result {
        FoundRegions found;
        ToolAdvice advice;
        bool followed = false; ///< the assumed path was followed anew
    };

    /// Operation `place` of the project has to be of kind global_local, and `part` the project's. Not to be
    /// called from two threads at once. Throws what check_project and find_regions throw, Error(internal) for
    /// another kind, Cancelled; what was kept stays good then.
    Result find(const Project& project, std::size_t place, const PreparedPart& part,
                const Progress& progress);

private:
    ContactIndexPtr index_;
    std::string key_;
    std::shared_ptr<const RegionSource> source_;
};

} // namespace facetmill
