// The boxes of a mesh's facets, as a tree of boxes wants them.
#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace facetmill {

inline std::vector<Box3> facet_boxes(const Mesh& mesh) {
    std::vector<Box3> boxes(mesh.facet_count());
    for (std::size_t f = 0; f < boxes.size(); ++f)
        for (int k = 0; k < 3; ++k)
            boxes[f].add(mesh.corner(f, k));
    return boxes;
}

} // namespace facetmill
