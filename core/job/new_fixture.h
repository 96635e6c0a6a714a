// Fixtures to begin with, fitted to the stock: what a user then moves and resizes.
#pragma once

#include "core/base/progress.h"
#include "core/job/project.h"
#include "core/mesh/mesh.h"

#include <vector>

namespace facetmill {

enum class NewFixture {
    vice,     ///< two jaws along X, in front of and behind the stock
    clamp,    ///< a strap that reaches over the stock from its low end along X
    plate,    ///< under the stock, larger than it
    box,      ///< beside the stock
    cylinder, ///< a bolt beside the stock
    tabs,     ///< new_tabs, as many as usual
};

/// Fixtures round a stock that has this box, with names that the chosen setup has not; sizes are round
/// numbers of the project's unit. None where the part has no places for tabs (new_tabs).
std::vector<Fixture> new_fixtures(const Project& project, NewFixture what, const Mesh& part,
                                  const Box3& stock);
/// How many tabs a part gets.
inline constexpr std::size_t usual_tabs = 4;
/// Tabs round a part that is cut out of its stock: at its bottom, across its outline there, where that is
/// straight and nothing of the part is opposite; far from one another. Longer than the largest tool of the
/// setup's milling operations is wide, so that they reach over the groove that it cuts. Fewer than asked for,
/// or none, where the outline has no such places.
std::vector<Fixture> new_tabs(const Project& project, const Mesh& part, const Box3& stock, std::size_t count,
                              const Progress& progress);
/// "Clamp", or "Clamp 2" where a fixture of the chosen setup has that name.
std::string free_fixture_name(const Project& project, const std::string& wish);

} // namespace facetmill
