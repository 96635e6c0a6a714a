// The raw material as a solid, in place. Millimetres, part coordinates. Planners and the verifier each make
// their own model of it.
#pragma once

#include "core/base/vec.h"
#include "core/mesh/mesh.h"

#include <cstdint>

namespace facetmill {

struct StockSolid {
    enum class Kind : std::uint8_t { box, cylinder, mesh };
    Kind kind = Kind::box;
    Box3 box;          ///< of all kinds: nothing is outside
    int axis = 2;      ///< cylinder: along this coordinate axis, about the box's middle, over its length
    double radius = 0; ///< cylinder
    MeshPtr mesh;      ///< closed; what is inside by the count of crossings
    double edge_loss =
        0; ///< sharp edges of the mesh may be cut off by this, mm: it is a stock as it was simulated
};

} // namespace facetmill
