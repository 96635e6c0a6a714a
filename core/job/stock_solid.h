// The raw material of a project as a solid round its part.
#pragma once

#include "core/setup/stock.h"
#include "core/verify/program.h"

#include <array>
#include <string>
#include <vector>

namespace facetmill {

struct PreparedPart; // planner.h

/// The largest distances of a mesh's points from the lines through the middle of `box` along x, y, z.
std::array<double, 3> reach_about_middle(const Mesh& mesh, const Box3& box);

/// Its box is empty where the part's is, or where `part` has no stock mesh and a mesh is asked for.
StockSolid stock_solid(const StockSpec& stock, const PreparedPart& part);

/// One sentence each: where a solid is too small for the part. Boxes never are. Of a mesh only its box is
/// asked; what it does not reach of the part's surface the verification tells.
std::vector<std::string> stock_warnings(const StockSpec& stock, const PreparedPart& part, LengthUnit unit);

} // namespace facetmill
