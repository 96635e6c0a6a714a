// The fixtures of a setup as bodies in their places, and what tools keep off with them.
#pragma once

#include "core/base/progress.h"
#include "core/job/project.h"
#include "core/setup/fixture.h"

#include <string>
#include <vector>

namespace facetmill {

struct PreparedPart; // planner.h

/// Another text where any of them is another body, stands elsewhere, or is to be kept off farther. Empty
/// without fixtures.
std::string fixtures_key(const Project& project);
/// Those of the chosen setup. Throws what load_solid does; Error(limit_exceeded) for a mesh of too many
/// facets. The place names the fixture.
std::vector<FixtureSolid> load_fixtures(const Project& project, const Progress& progress);
/// One sentence for each box or cylinder that stands in the part, by 27 places all over it; of meshes nothing
/// is told.
std::vector<std::string> fixture_warnings(const Project& project, const PreparedPart& part,
                                          const Progress& progress);
/// One mesh of the part's facets, first and in their order, and of the fixtures grown by their clearance: all
/// that tools keep off.
MeshPtr with_fixtures(const Mesh& part, const std::vector<FixtureSolid>& fixtures);
/// The grown fixtures alone.
MeshPtr grown_fixtures(const std::vector<FixtureSolid>& fixtures);

} // namespace facetmill
