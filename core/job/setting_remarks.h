// What of an operation's settings planning would refuse, or what would leave walls, as far as the project
// alone tells it: said while it is entered, not after minutes of planning.
#pragma once

#include "core/job/project.h"

#include <cstddef>
#include <string>
#include <vector>

namespace facetmill {

struct SettingRemark {
    std::string key; ///< of the operation's parameter; empty: the operation as it is, on this machine
    std::string message;
};

/// None for settings that are right, and for a tool or machine that is not there. `operation` is a place in
/// the project.
std::vector<SettingRemark> setting_remarks(const Project& project, std::size_t operation);

} // namespace facetmill
