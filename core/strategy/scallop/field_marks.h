// Marked places of a field: those of what is high, and what lies round them.
#pragma once

#include "core/strategy/scallop/scallop_field.h"

namespace facetmill {

/// 1 for the places of each connected piece above `level` that comes above `top` somewhere.
std::vector<char> pieces_above(const ScallopField& field, const std::vector<double>& values, double level,
                               double top);
/// The connected pieces of what is marked, over corners too.
std::vector<std::vector<std::size_t>> connected(const ScallopField& field, const std::vector<char>& marks);
/// The marked places and those that lie about so many steps beside them, of what is cut.
std::vector<char> grown(const ScallopField& field, const std::vector<char>& marks, double steps,
                        const Progress& progress);

} // namespace facetmill
