// Fixtures to begin with, fitted to the stock: what a user then moves and resizes.
#pragma once

#include "core/job/project.h"

#include <vector>

namespace facetmill {

enum class NewFixture {
    vice,     ///< two jaws along X, in front of and behind the stock
    clamp,    ///< a strap that reaches over the stock from its low end along X
    plate,    ///< under the stock, larger than it
    box,      ///< beside the stock
    cylinder, ///< a bolt beside the stock
};

/// One or two fixtures round a stock that has this box, with names that the chosen setup has not; sizes are
/// round numbers of the project's unit.
std::vector<Fixture> new_fixtures(const Project& project, NewFixture what, const Box3& stock);
/// "Clamp", or "Clamp 2" where a fixture of the chosen setup has that name.
std::string free_fixture_name(const Project& project, const std::string& wish);

} // namespace facetmill
